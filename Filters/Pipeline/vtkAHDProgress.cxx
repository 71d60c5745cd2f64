// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDProgress.h"

#include "vtkAlgorithm.h"

namespace
{
// Which part of the whole a phase takes, roughly as the time goes: from kBegin[phase] to
// kBegin[phase + 1]. Those that there are not are skipped.
constexpr double kBegin[] = { 0.0, 0.05, 0.1, 0.14, 0.27, 0.85, 0.93, 0.98, 1.0 };
static_assert(
  sizeof kBegin / sizeof *kBegin == ahd::kPhases + 1, "a beginning for each phase, and the end");

// The filter's observers may be slow (a GUI redraws its progress bar), so they hear of hundredths.
constexpr double kStep = 0.01;
}

bool vtkAHDProgress::MustAbort() const
{
#if AHD_VTK_HAS_CHECK_ABORT
  return this->Filter->CheckAbort();
#else
  return this->Filter->GetAbortExecute() != 0;
#endif
}

void vtkAHDProgress::beginPhase(ahd::Phase phase)
{
  this->Finish();
  this->Current = phase;
  this->Begun = Clock::now();
  this->InPhase = true;
}

bool vtkAHDProgress::advance(ahd::Phase phase, double fraction)
{
  const double* begin = kBegin + std::size_t(phase);
  const double whole = begin[0] + fraction * (begin[1] - begin[0]);
  if (whole >= this->Shown + kStep && !this->MustAbort())
  {
    this->Shown = whole;
    this->Filter->UpdateProgress(whole);
  }
  return !this->MustAbort();
}

void vtkAHDProgress::Finish()
{
  if (this->InPhase)
  {
    const std::chrono::duration<double> seconds = Clock::now() - this->Begun;
    this->Seconds[std::size_t(this->Current)] += seconds.count();
    this->InPhase = false;
  }
}
