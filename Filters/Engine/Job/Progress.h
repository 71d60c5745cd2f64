// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobProgress_h
#define ahd_JobProgress_h

#include "RunProgress.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Hears what is being done, and how much of it all is. Non-zero cancels.
using ProgressCallback = std::int32_t (*)(void* user, std::int32_t phase, double fraction);

/// What a job tells its caller and asks it for: the callback hears of phases, too, and may cancel;
/// so may another thread.
class JobProgress : public RunProgress
{
public:
  using RunProgress::RunProgress;

  void setCallback(ProgressCallback callback, void* user);

  /// A run begins, of stages with these weights.
  void beginRun(const std::vector<double>& weights);
  /// Work apart from the run begins, of stages with these weights: what is told is how much of it
  /// is done, until its end.
  void beginApart(const std::vector<double>& weights);
  void endApart();
  /// A call begins: nobody has cancelled it yet, but by cancel().
  void beginCall();
  /// It is over, and with it the time of the last phase. `wasCancelled`: it did what cancel()
  /// asked.
  void endCall(bool wasCancelled);

  /// The next phase is the last of its stage.
  void expectLastPhase() { stages_.expectLastPhase(); }
  /// All is done: the callback hears of it if it has not. False if it, or cancel(), cancels.
  bool finish();

  void beginPhase(Phase phase) override;

  /// From any thread.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

protected:
  bool isCancelled() const override
  {
    return stopped_ || cancelled_.load(std::memory_order_relaxed);
  }
  void tell(double done, Phase phase) override;

private:
  ProgressCallback callback_ = nullptr;
  void* user_ = nullptr;
  Stages stagesOfRun_; ///< during work apart from it, and what was done
  double doneOfRun_ = 0.0;
  bool stopped_ = false; ///< by the callback
  std::atomic<bool> cancelled_{ false };
};

} // namespace ahd

#endif
