// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRanks_h
#define vtkAHDRanks_h

#include "Engine/Distribute/BlockTransport.h"
#include "Pipeline/vtkAHDContext.h"
#include "vtkType.h"

#include <cstddef>
#include <new>
#include <vector>

class vtkMultiProcessController;

/**
 * The ranks of a controller, as the engine's transport between blocks: block k is rank k. All
 * functions but the counts are collective.
 *
 * What fails on one rank is agreed on by all before any waits for what will not come. A controller
 * that cannot send is not dealt with: MPI ends the program then.
 */
class vtkAHDRanks : public ahd::BlockTransport
{
public:
  /// Borrows it.
  explicit vtkAHDRanks(vtkMultiProcessController* controller);

  std::size_t GetOwn() const { return this->Own; }
  std::size_t GetCount() const { return this->Count; }

  ahd::Status agree(ahd::Status own) override;
  ahd::Status gather(const ahd::BlockBytes& own, std::vector<ahd::BlockBytes>& all) override;
  ahd::Status exchange(
    std::vector<ahd::BlockMessage>& out, std::vector<ahd::BlockMessage>& in) override;

  /// Does one rank's own work on each, and throws vtkAHDStop on all if one cannot go on. `work` may
  /// throw vtkAHDStop and std::bad_alloc, and is not to communicate.
  template <typename Work>
  void Together(const vtkAHDContext& context, const Work& work)
  {
    context.Check(this->agree(Try(context, work)));
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

  std::size_t GetPartner(std::size_t round) const;
  void ExchangeSizes(
    const std::vector<const ahd::BlockBytes*>& to, std::vector<vtkTypeUInt64>& sizes);
  void Swap(std::size_t partner, const ahd::BlockBytes* out, ahd::BlockBytes* in);
  void Send(std::size_t rank, const ahd::BlockBytes& bytes);
  void Receive(std::size_t rank, ahd::BlockBytes& bytes);

  vtkMultiProcessController* const Controller;
  const std::size_t Own;
  const std::size_t Count;
};

#endif
