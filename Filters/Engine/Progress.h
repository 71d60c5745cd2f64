// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Progress_h
#define ahd_Progress_h

#include <cstddef>

namespace ahd
{

/// What the engine is doing. Phases come in this order, each at most once per run; a run that has
/// nothing to do in a phase may skip it.
enum class Phase
{
  Read,   ///< look at every point once: finite? bounds?
  Sort,   ///< canonical rank of the points, duplicates, insertion order
  Insert, ///< insert point after point
  Extract, ///< number and sort the triangles for output
  Fates    ///< write what became of each point
};

/// How the engine talks to its caller while it works. The engine reads no clock: who wants the time
/// of a phase takes it in beginPhase().
class Progress
{
public:
  virtual ~Progress() = default;

  /// The phase begins now. Called from the thread that called the engine.
  virtual void beginPhase(Phase) {}

  /// The phase is done to this fraction (0 to 1, never falling within a phase).
  /// Return false to cancel: the engine then stops at once and reports Status::Cancelled.
  /// Asked at least once per kStepsPerAsking bounded steps of work.
  virtual bool advance(Phase, double fraction) = 0;
};

/// Upper limit on the number of bounded steps (a point read, a key sorted, a triangle walked, a
/// triangle removed) between two calls of Progress::advance.
constexpr std::size_t kStepsPerAsking = std::size_t(1) << 14;

/// Counts steps of one phase and asks the Progress when a batch of them is full.
class Ticker
{
public:
  /// `progress` may be null (nobody to ask). `total` is the number of units of work the fraction
  /// refers to; 0 means unknown (the fraction stays 0).
  Ticker(Progress* progress, Phase phase, std::size_t total)
    : progress_(progress)
    , phase_(phase)
    , total_(total)
  {
    if (progress_)
    {
      progress_->beginPhase(phase_);
    }
  }

  /// `steps` more steps were taken. Returns false if the work is to be cancelled.
  /// REQUIRES: steps <= kStepsPerAsking / 2.
  bool step(std::size_t steps = 1)
  {
    pending_ += steps;
    return pending_ < kStepsPerAsking / 2 || ask();
  }

  /// `units` more units of work are finished (moves the fraction; asks nothing).
  void finished(std::size_t units) { done_ += units; }

  /// Asks now. Returns false if the work is to be cancelled.
  bool ask()
  {
    pending_ = 0;
    return !progress_ || progress_->advance(phase_, fraction());
  }

private:
  double fraction() const
  {
    return total_ == 0 ? 0.0 : done_ >= total_ ? 1.0 : double(done_) / double(total_);
  }

  Progress* progress_;
  Phase phase_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t pending_ = 0;
};

} // namespace ahd

#endif
