// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRanks_h
#define vtkAHDRanks_h

#include "Engine/Distribute/BlockRoute.h"
#include "Pipeline/vtkAHDContext.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <new>
#include <vector>

/**
 * The ranks of a controller, as the engine's transport between blocks: block k is rank k. All
 * functions but the counts are collective.
 *
 * All ranks agree on a failure before any waits for data that will not come: all common work is
 * done in Execute(), and each collective begins with an agreement. Failures of the controller are
 * not handled: MPI ends the program then.
 */
class vtkAHDRanks : public ahd::PairTransport
{
public:
  /// Holds the controller.
  explicit vtkAHDRanks(vtkMultiProcessController* controller);

  std::size_t GetOwn() const { return this->Own; }
  std::size_t GetCount() const { return this->Count; }

  /// Executes the common work of all ranks. Returns the same on all: Ok, or the failure of a rank.
  /// `work` communicates only through this object, and may throw vtkAHDStop and std::bad_alloc
  /// anywhere, on one rank or on all: the others learn of it at their next agreement, at
  /// the latest in the end. Nothing may throw between two of these calls, since the others wait for
  /// a rank that does not reach the second. They do not nest.
  template <typename Work>
  ahd::Status Execute(const Work& work)
  {
    ahd::Status own = ahd::Status::Ok;
    this->Agreed = ahd::Status::Ok;
    try
    {
      work();
    }
    catch (const vtkAHDStop& stop)
    {
      own = stop.Reason;
    }
    catch (const std::bad_alloc&)
    {
      own = ahd::Status::OutOfMemory;
    }
    return this->Agreed != ahd::Status::Ok ? this->Agreed : this->agree(own);
  }

  /// @pre if it is not Ok, all ranks end their work: see Execute().
  ahd::Status agree(ahd::Status own) override;
  /// Is it true on any rank? Throws vtkAHDStop on all if one fails.
  bool IsAny(bool own);
  /// The largest of all ranks. Throws likewise.
  int FindMost(int own);
  ahd::Status gather(const ahd::BlockBytes& own, std::vector<ahd::BlockBytes>& all) override;
  ahd::Status exchange(
    std::vector<ahd::BlockMessage>& out, std::vector<ahd::BlockMessage>& in) override;
  void swap(std::size_t partner, const void* out, std::size_t outBytes, void* in,
    std::size_t inBytes) override;

  /// Executes each rank's own work, and throws vtkAHDStop on all if one fails. `work` may
  /// throw vtkAHDStop and std::bad_alloc, and must not communicate.
  template <typename Work>
  void Together(const vtkAHDContext& context, const Work& work)
  {
    context.Check(this->agree(Try(context, work)));
  }

  /// The results of make() of all ranks, on each rank. Throws vtkAHDStop on all ranks if one
  /// fails; `make` may throw as above, and must not communicate.
  template <typename Make>
  auto Share(const vtkAHDContext& context, const Make& make)
  {
    std::vector<decltype(make())> all;
    const auto makeOwn = [&](auto& own) { return Try(context, [&] { own = make(); }); };
    context.Check(ahd::share(*this, makeOwn, all));
    return all;
  }

  /// Sends to[k] to rank k, and returns the vectors received from each; empty ones are not
  /// sent. make(to) fills one for each rank; throws as above.
  template <typename T, typename Make>
  std::vector<std::vector<T>> Exchange(const vtkAHDContext& context, const Make& make)
  {
    std::vector<std::vector<T>> from;
    const auto makeAll = [&](std::vector<std::vector<T>>& to)
    {
      return Try(context,
        [&]
        {
          to.resize(this->Count);
          make(to);
        });
    };
    context.Check(ahd::exchange(*this, makeAll, from));
    return from;
  }

private:
  template <typename Work>
  static ahd::Status Try(const vtkAHDContext& context, const Work& work)
  {
    try
    {
      context.StopIfAborted();
      work();
      return ahd::Status::Ok;
    }
    catch (const vtkAHDStop& stop)
    {
      return stop.Reason;
    }
    catch (const std::bad_alloc&)
    {
      return ahd::Status::OutOfMemory;
    }
  }

  int Reduce(int own);
  template <typename Work>
  void ForPartners(const Work& work);

  const vtkSmartPointer<vtkMultiProcessController> Controller;
  const std::size_t Own;
  const std::size_t Count;
  ahd::Status Agreed = ahd::Status::Ok; // the last agreement
};

#endif
