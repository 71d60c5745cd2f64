// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankUpdates_h
#define vtkAHDRankUpdates_h

#include "vtkTimeStamp.h"
#include "vtkType.h"

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

/**
 * Whether a filter has to execute, agreed on by all ranks. VTK's pipeline decides that on each rank
 * by itself, from times of modification: where one rank's input alone has changed, the others
 * would have nothing to do, and that one would wait for them.
 *
 * The one thing that every Update() does on every rank, whichever filter behind is updated and
 * whether or not anything has changed, is to ask for the time at which the pipeline was modified.
 * The answer is given here: a time that is new on all ranks or on none.
 */
class vtkAHDRankUpdates
{
public:
  /// What vtkAlgorithm::ComputePipelineMTime() is to answer, from `mtime`, that of the filter
  /// alone, and all before it. Collective.
  vtkMTimeType FindMTime(vtkMultiProcessController* controller, vtkAlgorithm* filter,
    vtkMTimeType mtime, vtkInformationVector** inputs, vtkInformationVector* outputs);

  /// Has all ranks announce the times of all, so that they execute for the same ones: a rank whose
  /// input has none would not. Collective; to be called in RequestInformation().
  static void ShareTimes(
    vtkMultiProcessController* controller, vtkAlgorithm* filter, vtkInformationVector* outputs);

  /// What was modified until this, on this rank, is no reason to execute: it was while the filter
  /// did so.
  void Settle() { this->Settled.Modified(); }

private:
  vtkTimeStamp Settled;  // this rank's pipeline
  vtkTimeStamp Modified; // the pipeline of any rank
};

#endif
