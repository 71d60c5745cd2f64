// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RunProgress_h
#define ahd_RunProgress_h

#include "../Core/AskedMemory.h"
#include "../Core/Clock.h"
#include "../Core/Progress.h"
#include "../Core/Stages.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ahd
{

/// The stages of a run, in their order: these, which Run begins itself,
enum RunStage : std::size_t
{
  kPreparing = 1,
  kSimplifying,
  kTriangulating,
  kMakingVoronoi,
  kConstraining,
  // and what its caller writes afterwards.
  kWritingCells,
  kWritingArrays,
  kWritingVoronoi,
  kDrawingOrder
};

/// Reports the fraction of a run that is done: at each hundredth, and after a twelfth of
/// a second without one. Measures the time of each phase and stage.
///
/// A run consists of stages (Stages.h); the fraction moves with each phase.
class RunProgress : public Progress
{
public:
  explicit RunProgress(Clock clock = steadySeconds)
    : now(clock)
    , toldAt_(clock())
  {
  }

  const Clock now;

  /// The stages to come, by their weights; those of weight 0 are skipped. By default there is
  /// one.
  void setStages(const std::vector<double>& weights);
  /// The next stage begins; after the last one, all is done. Reports, if due.
  void nextStage();
  /// Begins the stage of this number, from 1, unless it or a later one has begun. Does not report:
  /// the next phase does.
  void reach(std::size_t stage);

  void beginPhase(Phase phase) override;
  bool advance(Phase phase, double fraction) override;
  bool take(std::size_t bytes) override { return asked_.take(bytes); }
  void giveBack(std::size_t bytes) override { asked_.giveBack(bytes); }

  /// Reports, if due. False on a cancel.
  bool goesOn();

  /// Ends the last phase. Time after this belongs to none.
  void finishPhase();

  /// The memory requested beyond the estimate.
  AskedMemory& asked() { return asked_; }

  /// Wall-clock seconds from the beginning of a phase to its end, or the beginning of the next.
  double seconds(Phase phase) const { return seconds_[std::size_t(phase)]; }
  const std::array<double, kPhases>& seconds() const { return seconds_; }

  /// The time at which each stage began.
  const std::vector<double>& stagesBegun() const { return stagesBegun_; }

protected:
  /// Has a cancel been requested?
  virtual bool isCancelled() const = 0;
  /// Called with the fraction done, from 0 to 1, and the current phase.
  virtual void tell(double done, Phase phase) = 0;

  void tellNow();

  Stages stages_;
  std::array<double, kPhases> seconds_ = {};
  double done_ = 0.0; ///< of the whole
  double told_ = 0.0; ///< last reported,
  double toldAt_;     ///< and when

private:
  void move();

  AskedMemory asked_;
  std::vector<double> stagesBegun_;
  bool inPhase_ = false;
  Phase phase_ = Phase::Merge;
  double begun_ = 0.0; ///< the phase
};

} // namespace ahd

#endif
