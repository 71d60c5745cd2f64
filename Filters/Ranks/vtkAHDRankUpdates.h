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
 * Decides for all ranks whether a filter executes. VTK's pipeline decides it on each rank
 * by itself, by times of modification: if only one rank's input has changed, the others
 * would not execute, and that one would wait for them.
 *
 * Every Update() on every rank, whichever downstream filter is updated and
 * whether or not anything has changed, requests the time at which the pipeline was modified.
 * It is computed here: a time that is new on all ranks or on none.
 */
class vtkAHDRankUpdates
{
public:
  /// The result of vtkAlgorithm::ComputePipelineMTime(), from `mtime`, that of the filter
  /// and all upstream ones. Collective.
  vtkMTimeType FindMTime(vtkMultiProcessController* controller, vtkAlgorithm* filter,
    vtkMTimeType mtime, vtkInformationVector** inputs, vtkInformationVector* outputs);

  /// Makes all ranks announce the times of all, so that they execute for the same ones; a rank
  /// whose input has no times would not. Collective; call it in RequestInformation().
  static void ShareTimes(
    vtkMultiProcessController* controller, vtkAlgorithm* filter, vtkInformationVector* outputs);

  /// Modifications on this rank until now are no reason to execute: they happened during the
  /// execution.
  void Settle() { this->Settled.Modified(); }

private:
  vtkTimeStamp Settled;  // this rank's pipeline
  vtkTimeStamp Modified; // the pipeline of any rank
};

#endif
