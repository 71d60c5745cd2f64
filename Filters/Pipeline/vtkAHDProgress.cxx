// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDProgress.h"

#include "Engine/Core/FloatingPoint.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <chrono>

namespace
{
constexpr double kStep = 0.01;          // of the whole
constexpr double kSilence = 1.0 / 12.0; // seconds, at most
}

vtkAHDProgress::vtkAHDProgress(vtkAlgorithm* filter, Clock clock)
  : Filter(filter)
  , Now(clock)
  , ToldAt(clock())
{
}

double vtkAHDProgress::SteadyClock()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void vtkAHDProgress::SetStages(const std::vector<double>& weights)
{
  this->Stages.set(weights);
  this->StagesBegun.clear();
  this->StagesBegun.reserve(weights.size());
}

void vtkAHDProgress::NextStage()
{
  const std::size_t begun = this->StagesBegun.size();
  if (begun < this->Stages.count() && begun < this->StagesBegun.capacity())
  {
    this->StagesBegun.push_back(this->Now());
  }
  this->MoveTo(this->Stages.next());
}

bool vtkAHDProgress::IsAborted() const
{
#if AHD_VTK_HAS_CHECK_ABORT
  return this->Filter->CheckAbort();
#else
  return this->Filter->GetAbortExecute() != 0;
#endif
}

void vtkAHDProgress::Tell(double whole)
{
  const ahd::ScopedFloatingPoint whateverObserversSet;
  this->Shown = whole;
  this->Filter->UpdateProgress(whole);
  this->ToldAt = this->Now(); // observers take time
}

void vtkAHDProgress::MoveTo(double whole)
{
  if (whole >= this->Shown + kStep && !this->IsAborted())
  {
    this->Tell(whole);
  }
}

bool vtkAHDProgress::MustAbort()
{
  if (this->Now() - this->ToldAt >= kSilence && !this->IsAborted())
  {
    this->Tell(this->Shown);
  }
  return this->IsAborted();
}

void vtkAHDProgress::beginPhase(ahd::Phase phase)
{
  this->Finish();
  this->Current = phase;
  this->Begun = this->Now();
  this->InPhase = true;
  this->Stages.beginPhase(phase);
}

bool vtkAHDProgress::advance(ahd::Phase, double fraction)
{
  this->MoveTo(this->Stages.whole(fraction));
  return !this->MustAbort();
}

void vtkAHDProgress::Finish()
{
  if (this->InPhase)
  {
    this->Seconds[std::size_t(this->Current)] += this->Now() - this->Begun;
    this->InPhase = false;
  }
}
