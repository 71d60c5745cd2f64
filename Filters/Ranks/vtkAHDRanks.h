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
 * What fails on one rank is agreed on by all before any waits for what will not come: all that
 * ranks do together is done in Execute(), and each collective begins with an agreement. A
 * controller that cannot send is not dealt with: MPI ends the program then.
 */
class vtkAHDRanks : public ahd::PairTransport
{
public:
  /// Holds it.
  explicit vtkAHDRanks(vtkMultiProcessController* controller);

  std::size_t GetOwn() const { return this->Own; }
  std::size_t GetCount() const { return this->Count; }

  /// Does what all ranks do together. Returns the same on all: Ok, or why a rank could not go on.
  /// `work` communicates, through this object alone, and may throw vtkAHDStop and std::bad_alloc
  /// wherever it is, on one rank or on all: those that go on hear of it where they agree next, at
  /// the latest in the end. Between two of these calls nothing throws: who does not come to the
  /// second is waited for. They do not nest.
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
    const ahd::Status status = this->Agreed != ahd::Status::Ok ? this->Agreed : this->agree(own);
    this->Agreed = ahd::Status::Ok;
    return status;
  }

  /// REQUIRES: where that is not Ok, all ranks end the work that they are in: see Execute().
  ahd::Status agree(ahd::Status own) override;
  /// Is it so on a rank? Throws vtkAHDStop on all if one cannot go on.
  bool IsAny(bool own);
  /// The largest of all. Throws as well.
  int FindMost(int own);
  ahd::Status gather(const ahd::BlockBytes& own, std::vector<ahd::BlockBytes>& all) override;
  ahd::Status exchange(
    std::vector<ahd::BlockMessage>& out, std::vector<ahd::BlockMessage>& in) override;
  void swap(std::size_t partner, const void* out, std::size_t outBytes, void* in,
    std::size_t inBytes) override;

  /// Does one rank's own work on each, and throws vtkAHDStop on all if one cannot go on. `work` may
  /// throw vtkAHDStop and std::bad_alloc, and is not to communicate.
  template <typename Work>
  void Together(const vtkAHDContext& context, const Work& work)
  {
    context.Check(this->agree(Try(context, work)));
  }

  /// What make() returns on each rank, known to all. Throws vtkAHDStop on all ranks if one cannot
  /// go on; `make` may throw as above, and is not to communicate.
  template <typename Make>
  auto Share(const vtkAHDContext& context, const Make& make)
  {
    std::vector<decltype(make())> all;
    const auto makeOwn = [&](auto& own) { return Try(context, [&] { own = make(); }); };
    context.Check(ahd::share(*this, makeOwn, all));
    return all;
  }

  /// Sends to[k] to rank k, and returns what has come from each: vectors, of which none is sent
  /// that is empty. make(to) fills one for each rank; throws as above.
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
  void Send(std::size_t rank, const void* from, std::size_t bytes);
  void Receive(std::size_t rank, void* to, std::size_t bytes);

  const vtkSmartPointer<vtkMultiProcessController> Controller;
  const std::size_t Own;
  const std::size_t Count;
  ahd::Status Agreed = ahd::Status::Ok; // what all have said last
};

#endif
