// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Progress_h
#define ahd_Progress_h

#include <atomic>
#include <cstddef>
#include <new>

namespace ahd
{

class Executor;

/// What the engine is doing. Phases come in this order, each at most once per run, but for Extract
/// and Outputs, which each call of that kind begins (so they may come before Constrain, too), and
/// Read, Sort and Insert, which simplify() begins before; a run that has nothing to do in a phase
/// may skip it.
enum class Phase
{
  Merge,     ///< prepare(): copy points, move them into their plane, merge those near each other
  Split,     ///< prepare(): read the constraints, find their crossings and split them there
  Read,      ///< look at every point once: finite? bounds?
  Sort,      ///< canonical rank of the points, duplicates, insertion order
  Insert,    ///< insert point after point
  Constrain, ///< make the constraints edges, and drop what is outside
  Extract,   ///< number and sort the triangles for output
  Outputs    ///< make tables, and write what became of each point, orders, cell data, the Voronoi
             ///< diagram
};
constexpr std::size_t kPhases = std::size_t(Phase::Outputs) + 1;

/// The engine's reports to its caller during a run. The engine reads no clock: a caller that times
/// phases does so in beginPhase(). If these functions change the rounding mode, it is restored.
class Progress
{
public:
  virtual ~Progress() = default;

  /// The phase begins now. Called from the thread that called the engine.
  virtual void beginPhase(Phase) {}

  /// The phase is done to this fraction (0 to 1, never falling within a phase).
  /// Return false to cancel: the engine then stops at once and reports Status::Cancelled.
  /// Called only from the thread that called the engine, even when others work for it, at least
  /// once per kStepsPerAsking bounded steps of that thread's work.
  virtual bool advance(Phase, double fraction) = 0;

  /// Requests bytes beyond the estimate, where the need shows only during the work, before they are
  /// allocated. Return false to refuse them: the engine then reports Status::OutOfMemory, and gives
  /// them back. Called from any thread that works.
  virtual bool take(std::size_t bytes)
  {
    static_cast<void>(bytes);
    return true;
  }
  /// Returns bytes that take() requested.
  virtual void giveBack(std::size_t bytes) { static_cast<void>(bytes); }
};

/// Upper limit on the number of bounded steps (a point read, a key sorted, a triangle walked, a
/// triangle removed) between two calls of Progress::advance.
constexpr std::size_t kStepsPerAsking = std::size_t(1) << 14;

/// Reports one phase to the caller: counts steps, polls the Progress once per batch of them, and
/// holds the executor. Tasks that run in parallel have one each, made from the phase's (Tasks.h):
/// the one on the caller's own thread polls, the others check whether the phase was cancelled.
class Ticker
{
public:
  /// `progress` may be null (no reports, no cancelling), and so may `executor` (this thread does it
  /// all). `total` is the number of units of work the fraction refers to; 0 means unknown (the
  /// fraction stays 0).
  Ticker(Progress* progress, Phase phase, std::size_t total, Executor* executor = nullptr);

  /// The ticker of a task of this phase; it hands out no threads.
  explicit Ticker(Ticker* phase)
    : progress_(phase->progress_)
    , phase_(phase->phase_)
    , total_(phase->total_)
    , parent_(phase)
  {
  }
  ~Ticker() { flush(); }
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

  /// `steps` more steps were taken. Returns false if the work is cancelled.
  /// @pre steps <= kStepsPerAsking / 2.
  bool step(std::size_t steps = 1)
  {
    pending_ += steps;
    return pending_ < kStepsPerAsking / 2 || ask();
  }

  /// `units` more units of work are finished (moves the fraction; does not poll).
  void finished(std::size_t units) { done_ += units; }

  /// Polls now. Returns false if the work is cancelled.
  /// Not inline: in the loops that call step() it is rare, and would take their registers.
  bool ask();

  /// Tasks of this phase, and only they, stop at their next poll.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  /// Is the phase cancelled?
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  /// Requests memory beyond the estimate (Progress::take()). Throws std::bad_alloc if it is
  /// refused; it must be given back even so.
  void take(std::size_t bytes)
  {
    if (progress_ && !progress_->take(bytes))
    {
      throw std::bad_alloc();
    }
  }
  void giveBack(std::size_t bytes)
  {
    if (progress_)
    {
      progress_->giveBack(bytes);
    }
  }

  /// The threads lent to this phase; null if none.
  Executor* executor() const { return executor_; }

private:
  bool askCaller();

  double fraction() const
  {
    const std::size_t done = done_ + doneByTasks_.load(std::memory_order_relaxed);
    return total_ == 0 ? 0.0 : done >= total_ ? 1.0 : double(done) / double(total_);
  }

  void flush()
  {
    if (parent_)
    {
      parent_->doneByTasks_.fetch_add(done_, std::memory_order_relaxed);
      done_ = 0;
    }
  }

  /// An address that differs between threads.
  static const void* thisThread()
  {
    static thread_local char mark;
    return &mark;
  }
  bool onThisThread() const { return thread_ == thisThread(); }

  Progress* progress_;
  Phase phase_;
  std::size_t total_;
  Executor* executor_ = nullptr;
  Ticker* parent_ = nullptr;
  const void* thread_ = thisThread(); ///< the thread that made it
  std::size_t done_ = 0;
  std::size_t pending_ = 0;
  std::atomic<std::size_t> doneByTasks_{ 0 };
  std::atomic<bool> cancelled_{ false };
};

} // namespace ahd

#endif
