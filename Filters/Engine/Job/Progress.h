// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobProgress_h
#define ahd_JobProgress_h

#include "../Core/AskedMemory.h"
#include "../Core/Progress.h"
#include "../Core/Stages.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Seconds from some beginning.
using Clock = double (*)();

/// Hears what is being done, and how much of it all is. Non-zero cancels.
using ProgressCallback = std::int32_t (*)(void* user, std::int32_t phase, double fraction);

/// What a job tells its caller and asks it for: the callback hears of phases, of each hundredth and
/// at least ten times a second, and may cancel; so may another thread. Takes the time of each
/// phase.
class JobProgress : public Progress
{
public:
  explicit JobProgress(Clock clock)
    : now(clock)
  {
  }

  const Clock now;

  void setCallback(ProgressCallback callback, void* user);

  /// A run begins, of stages with these weights.
  void beginRun(const std::vector<double>& weights);
  /// Work apart from the run begins, of stages with these weights: what is told is how much of it
  /// is done, until its end.
  void beginApart(const std::vector<double>& weights);
  void endApart();
  /// A call begins: nobody has cancelled it yet, but by cancel().
  void beginCall();
  /// It is over, and with it the time of the last phase. `isCancelled`: it did what cancel() asked.
  void endCall(bool isCancelled);
  /// Begins the stage of this number, from 1, unless it or a later one has begun.
  void reach(std::size_t stage);

  /// The next phase is the last of its stage.
  void expectLastPhase() { stages_.expectLastPhase(); }
  /// All is done: the callback hears of it if it has not. False if it, or cancel(), cancels.
  bool finish();

  void beginPhase(Phase phase) override;
  bool advance(Phase phase, double fraction) override;
  bool take(std::size_t bytes) override { return asked_.take(bytes); }
  void giveBack(std::size_t bytes) override { asked_.giveBack(bytes); }

  /// What is asked for beyond the estimate.
  AskedMemory& asked() { return asked_; }

  /// From any thread.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  /// Since the run began.
  double seconds(Phase phase) const { return seconds_[std::size_t(phase)]; }

private:
  void finishPhase();
  void tell();

  AskedMemory asked_;
  ProgressCallback callback_ = nullptr;
  void* user_ = nullptr;
  Stages stages_;
  Stages stagesOfRun_; ///< during work apart from it, and what was done
  double doneOfRun_ = 0.0;
  std::array<double, kPhases> seconds_ = {};
  bool inPhase_ = false;
  Phase phase_ = Phase::Merge;
  double begun_ = 0.0;   ///< the phase
  double done_ = 0.0;    ///< of the whole
  double told_ = 0.0;    ///< what the callback heard last,
  double toldAt_ = 0.0;  ///< and when
  bool stopped_ = false; ///< by the callback
  std::atomic<bool> cancelled_{ false };
};

} // namespace ahd

#endif
