// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDProgress_h
#define vtkAHDProgress_h

#include "Engine/Core/AskedMemory.h"
#include "Engine/Core/Progress.h"
#include "Engine/Core/Stages.h"

#include <array>
#include <vector>

class vtkAlgorithm;

/**
 * The engine's Progress for a VTK filter: reports to vtkAlgorithm::UpdateProgress, cancels when the
 * filter is to abort, and takes the time of each phase.
 *
 * An execution consists of stages (Engine/Core/Stages.h); the bar moves with each phase. Observers
 * hear of each hundredth, and where there is none for a twelfth of a second, of the same fraction
 * again: so that they can draw and abort. They may be slow, so they hear of no more.
 */
class vtkAHDProgress : public ahd::Progress
{
public:
  using Clock = double (*)(); ///< seconds, from any beginning

  explicit vtkAHDProgress(vtkAlgorithm* filter, Clock clock = SteadyClock);

  /// The stages to come, by their weights; those of weight 0 are passed over. Without, there is
  /// one.
  void SetStages(const std::vector<double>& weights);
  /// The next stage begins; after the last one, all is done.
  void NextStage();

  void beginPhase(ahd::Phase phase) override;
  bool advance(ahd::Phase phase, double fraction) override;
  bool take(std::size_t bytes) override { return this->Asked.take(bytes); }
  void giveBack(std::size_t bytes) override { this->Asked.giveBack(bytes); }

  /// What is asked for beyond the estimate.
  ahd::AskedMemory& GetAsked() { return this->Asked; }

  /// Is the filter to abort? Observers are told first that it is at work, if it is time to.
  bool MustAbort();

  /// Ends the last phase. Time after this belongs to none.
  void Finish();

  /// Wall-clock seconds from the beginning of a phase to that of the next.
  double GetSeconds(ahd::Phase phase) const { return this->Seconds[std::size_t(phase)]; }

  /// When each of the stages that were set began, by the clock.
  const std::vector<double>& GetStages() const { return this->StagesBegun; }

private:
  static double SteadyClock();
  bool IsAborted() const;
  void Tell(double whole);
  void MoveTo(double whole);

  ahd::AskedMemory Asked;
  vtkAlgorithm* const Filter;
  const Clock Now;
  ahd::Stages Stages;
  double Shown = 0.0;                            // what observers were told last
  double ToldAt = 0.0;                           // when
  std::array<double, ahd::kPhases> Seconds = {}; // of each phase
  std::vector<double> StagesBegun;
  bool InPhase = false;
  ahd::Phase Current = ahd::Phase::Read;
  double Begun = 0.0;
};

#endif
