// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDProgress_h
#define vtkAHDProgress_h

#include "Engine/Core/Progress.h"

#include <array>
#include <chrono>

class vtkAlgorithm;

/**
 * The engine's Progress for a VTK filter: reports to vtkAlgorithm::UpdateProgress, cancels when the
 * filter is to abort, and takes the time of each phase.
 */
class vtkAHDProgress : public ahd::Progress
{
public:
  explicit vtkAHDProgress(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

  void beginPhase(ahd::Phase phase) override;
  bool advance(ahd::Phase phase, double fraction) override;

  /// Is the filter to abort?
  bool MustAbort() const;

  /// Ends the last phase. Time after this belongs to none.
  void Finish();

  /// Wall-clock seconds from the beginning of a phase to that of the next.
  double GetSeconds(ahd::Phase phase) const { return this->Seconds[std::size_t(phase)]; }

private:
  using Clock = std::chrono::steady_clock;

  vtkAlgorithm* Filter;
  double Shown = 0.0;                            // what the filter was told last
  std::array<double, ahd::kPhases> Seconds = {}; // of each phase
  bool InPhase = false;
  ahd::Phase Current = ahd::Phase::Read;
  Clock::time_point Begun;
};

#endif
