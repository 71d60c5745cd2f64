// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ProgressWatch_h
#define ahd_ProgressWatch_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

#include <vector>

namespace ahdtest
{

/// Aborts a filter as ParaView's button does, where VTK has a method for that (from 9.3 on).
template <typename Algorithm>
auto askToAbort(Algorithm* filter, int) -> decltype(filter->SetAbortExecuteAndUpdateTime())
{
  filter->SetAbortExecuteAndUpdateTime();
}
template <typename Algorithm>
void askToAbort(Algorithm* filter, long)
{
  filter->SetAbortExecute(1);
}

/// Records a filter's progress, and aborts it at a given one.
class ProgressWatch : public vtkCommand
{
public:
  static ProgressWatch* New() { return new ProgressWatch; }

  void Execute(vtkObject* caller, unsigned long, void* amount) override
  {
    this->Seen.push_back(*static_cast<double*>(amount));
    if (this->Aborted)
    {
      ++this->SeenAfterAbort;
    }
    else if (this->Seen.back() >= this->AbortAt)
    {
      askToAbort(static_cast<vtkAlgorithm*>(caller), 0);
      this->Aborted = true;
    }
  }

  std::vector<double> Seen;
  double AbortAt = 2.0;
  bool Aborted = false;
  int SeenAfterAbort = 0;
};

} // namespace ahdtest

#endif
