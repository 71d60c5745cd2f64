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
constexpr double kReadEnd = 0.07;       // of a stage that triangulates
constexpr double kSortEnd = 0.20;
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
  double all = 0.0;
  for (const double weight : weights)
  {
    all += weight;
  }
  double sum = 0.0;
  this->StageEnds.assign(1, 0.0); // before the first
  for (const double weight : weights)
  {
    sum += weight;
    this->StageEnds.push_back(all > 0.0 ? sum / all : 1.0);
  }
  this->Stage = 0;
}

void vtkAHDProgress::NextStage()
{
  const double done = this->StageEnd(this->Stage);
  this->Stage = this->Stage + 1 < this->StageEnds.size() ? this->Stage + 1 : this->Stage;
  this->PhaseBegin = this->PhaseEnd = 0.0;
  this->MoveTo(done);
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

/// Reading, sorting and inserting take the parts of their stage that they take of the time. How
/// many other phases there will be in a stage is not known: each takes half of what is left.
void vtkAHDProgress::beginPhase(ahd::Phase phase)
{
  this->Finish();
  this->Current = phase;
  this->Begun = this->Now();
  this->InPhase = true;
  this->PhaseBegin = this->PhaseEnd;
  this->PhaseEnd = phase == ahd::Phase::Read ? kReadEnd
    : phase == ahd::Phase::Sort              ? kSortEnd
    : phase == ahd::Phase::Insert            ? 1.0
                                             : 0.5 * (this->PhaseBegin + 1.0);
}

bool vtkAHDProgress::advance(ahd::Phase, double fraction)
{
  const double inStage = this->PhaseBegin + fraction * (this->PhaseEnd - this->PhaseBegin);
  const double begin = this->Stage == 0 ? 0.0 : this->StageEnd(this->Stage - 1);
  const double whole = begin + inStage * (this->StageEnd(this->Stage) - begin);
  this->MoveTo(whole);
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
