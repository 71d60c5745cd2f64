// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDContext_h
#define vtkAHDContext_h

#include "Engine/Core/Context.h"
#include "Engine/Core/Threads.h"
#include "Engine/Prepare/Prepare.h"
#include "Engine/Result.h"
#include "Pipeline/vtkAHDOutputMemory.h"
#include "Pipeline/vtkAHDProgress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

/// The reason why an execution ends. Thrown within this layer, and caught where it began.
struct vtkAHDStop
{
  ahd::Status Reason;
  ahd::BadCell Cell = {};        ///< where the reason is BadCells
  const char* CellsOf = nullptr; ///< the name of these cells, if known
};

/// The progress, threads and output memory of one Update(). Borrows all of them.
class vtkAHDContext
{
public:
  vtkAHDContext(vtkAHDProgress& progress, ahd::Threads& threads, vtkAHDOutputMemory& memory)
    : Progress(progress)
    , Untimed(progress)
    , Threads(threads)
    , Memory(memory)
  {
  }

  /// For the engine.
  operator ahd::Context() const { return { &this->Progress, &this->Threads }; }
  /// The same for work outside of phases, whose time is not counted.
  ahd::Context WithoutPhases() const { return { &this->Untimed, &this->Threads }; }

  vtkAHDOutputMemory& GetOutputMemory() const { return this->Memory; }

  vtkAHDProgress& GetProgress() const { return this->Progress; }

  /// A VTK array for an output, of `count` numbers, one component, not initialised. Throws
  /// std::bad_alloc.
  template <typename Array>
  vtkSmartPointer<Array> NewArray(vtkIdType count) const
  {
    return this->Memory.NewArray<Array>(count);
  }

  /// The stages of the execution (see ahd::RunProgress), and the beginning of the next one.
  void SetStages(const std::vector<double>& weights) const { this->Progress.setStages(weights); }
  void NextStage() const { this->Progress.nextStage(); }

  /// Threads that have shared work so far, the calling one included.
  unsigned GetThreadsUsed() const { return this->Threads.used(); }

  /// Throws vtkAHDStop unless Ok. Ends the time of the engine's last phase.
  void Check(ahd::Status status) const
  {
    this->Progress.finishPhase();
    if (status != ahd::Status::Ok)
    {
      throw vtkAHDStop{ status };
    }
  }

  /// Has an abort been requested?
  bool IsAborted() const { return !this->Progress.goesOn(); }

  /// Throws vtkAHDStop if an abort has been requested.
  void StopIfAborted() const
  {
    if (this->IsAborted())
    {
      throw vtkAHDStop{ ahd::Status::Cancelled };
    }
  }

  /// Calls work(begin, end) for pieces of [0, count), each from a multiple of 2^14 on, on all
  /// threads if it pays, and checks for an abort on the calling thread between its pieces. Throws
  /// vtkAHDStop on an abort. `work` throws nothing.
  template <typename Work>
  void ForRange(std::size_t count, const Work& work) const
  {
    if (!this->TryRange(count, work))
    {
      throw vtkAHDStop{ ahd::Status::Cancelled };
    }
  }

  /// The same, but returns false on an abort: then some pieces are missing.
  template <typename Work>
  bool TryRange(std::size_t count, const Work& work) const
  {
    constexpr std::size_t kPiece = std::size_t(1) << 14;
    constexpr std::size_t kLeastShared = std::size_t(1) << 18; // less work is not worth sharing
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> aborted{ false };
    const auto ask = [&]
    {
      if (this->IsAborted())
      {
        aborted = true;
      }
    };
    const auto piece = [&](std::size_t i)
    {
      if (std::this_thread::get_id() == caller)
      {
        ask();
      }
      if (!aborted.load(std::memory_order_relaxed))
      {
        work(i * kPiece, std::min(count, (i + 1) * kPiece));
      }
    };
    const std::size_t pieces = (count + kPiece - 1) / kPiece;
    if (count >= kLeastShared)
    {
      this->Threads.run(pieces, piece, ask);
      return !aborted;
    }
    for (std::size_t i = 0; i < pieces && !aborted; ++i)
    {
      piece(i);
    }
    return !aborted;
  }

private:
  /// Checks for an abort, without a phase.
  struct Asking : ahd::Progress
  {
    explicit Asking(vtkAHDProgress& progress)
      : Of(progress)
    {
    }
    bool advance(ahd::Phase, double) override { return this->Of.goesOn(); }
    bool take(std::size_t bytes) override { return this->Of.take(bytes); }
    void giveBack(std::size_t bytes) override { this->Of.giveBack(bytes); }

    vtkAHDProgress& Of;
  };

  vtkAHDProgress& Progress;
  mutable Asking Untimed;
  ahd::Threads& Threads;
  vtkAHDOutputMemory& Memory;
};

#endif
