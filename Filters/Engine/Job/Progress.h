// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobProgress_h
#define ahd_JobProgress_h

#include "RunProgress.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Called with the phase and the fraction of the whole that is done. Non-zero cancels.
using ProgressCallback = std::int32_t (*)(void* user, std::int32_t phase, double fraction);

/// The progress of a job: its callback gets phases, too, and may cancel, as may another
/// thread.
class JobProgress : public RunProgress
{
public:
  using RunProgress::RunProgress;

  void setCallback(ProgressCallback callback, void* user);

  /// A run begins, of stages with these weights.
  void beginRun(const std::vector<double>& weights);
  /// Work apart from the run begins, of stages with these weights: the fraction is that of this
  /// work until its end.
  void beginApart(const std::vector<double>& weights);
  void endApart();
  /// A call begins. It is not cancelled, except by an earlier cancel(). `delay`: seconds in which
  /// nothing is reported.
  void beginCall(double delay);
  /// The call, and the time of its last phase, ends. `wasCancelled`: by cancel().
  void endCall(bool wasCancelled);

  /// The next phase is the last of its stage.
  void expectLastPhase() { stages_.expectLastPhase(); }
  /// All is done: reports it, if not reported yet. False if the callback, or cancel(), cancels.
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
  Stages stagesOfRun_; ///< during work apart from it, and its fraction
  double doneOfRun_ = 0.0;
  bool stopped_ = false;     ///< by the callback
  double silentUntil_ = 0.0; ///< if there is a delay, else 0
  std::atomic<bool> cancelled_{ false };
};

} // namespace ahd

#endif
