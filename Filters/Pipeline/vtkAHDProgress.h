// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDProgress_h
#define vtkAHDProgress_h

#include "Engine/Job/RunProgress.h"

class vtkAlgorithm;

/**
 * The progress of an execution for a VTK filter: reports to vtkAlgorithm::UpdateProgress, and
 * cancels on an abort. Observers may be slow, so they are called no more often than
 * ahd::RunProgress reports; they can draw and abort.
 */
class vtkAHDProgress : public ahd::RunProgress
{
public:
  explicit vtkAHDProgress(vtkAlgorithm* filter, ahd::Clock clock = ahd::steadySeconds);

protected:
  bool isCancelled() const override;
  void tell(double done, ahd::Phase phase) override;

private:
  vtkAlgorithm* const Filter;
};

#endif
