// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPieces_h
#define vtkAHDPieces_h

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "vtkMultiProcessController.h"
#endif

class vtkMultiProcessController;

/// Is this the only process? `own`: the filter's controller; may be null.
inline bool vtkAHDIsOnlyProcess(vtkMultiProcessController* own)
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  vtkMultiProcessController* const all = vtkMultiProcessController::GetGlobalController();
  return (!own || own->GetNumberOfProcesses() < 2) && (!all || all->GetNumberOfProcesses() < 2);
#else
  static_cast<void>(own);
  return true;
#endif
}

/// Requests the whole of these inputs, whichever piece of the output is requested.
inline void vtkAHDAskForAll(vtkInformationVector* inputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* const info = inputs->GetInformationObject(i);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (info->Has(Pipeline::WHOLE_EXTENT()))
    {
      info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
}

/// Is a piece other than the first requested of this output?
inline bool vtkAHDIsLaterPiece(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return output->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0;
}

#endif
