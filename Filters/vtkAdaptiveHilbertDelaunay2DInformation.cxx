// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAdaptiveHilbertDelaunay2D answers the pipeline before it executes: pieces, what its ports
// give, and, where there are several ranks, whether any of them has to execute.
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDOutputCache.h"
#include "Pipeline/vtkAHDPieces.h"
#include "Pipeline/vtkAHDSay.h"
#include "Ranks/vtkAHDRankUpdates.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstddef>
#include <new>

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "vtkMultiProcessController.h"
#endif

int vtkAdaptiveHilbertDelaunay2D::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs, int requestFromOutputPort,
  vtkMTimeType* mtime)
{
  const int result = this->Superclass::ComputePipelineMTime(
    request, inputs, outputs, requestFromOutputPort, mtime);
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  if (this->IsDistributed())
  {
    *mtime = this->Updates->FindMTime(this->Controller, this, *mtime, inputs, outputs);
  }
#endif
  return result;
}

int vtkAdaptiveHilbertDelaunay2D::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestInformation(request, inputs, outputs);
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  if (this->IsDistributed())
  {
    vtkAHDRankUpdates::ShareTimes(this->Controller, this, outputs);
  }
#endif
  return result;
}

/// Across ranks, points of others would come twice with ghost levels. In one process all is needed
/// whatever piece of the output is wanted: surfaces of pieces do not join.
int vtkAdaptiveHilbertDelaunay2D::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  for (int port = 0; port < 2 && this->IsDistributed(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      inputs[port]->GetInformationObject(i)->Set(
        vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  for (int port = 0; port < 2 && vtkAHDIsOnlyProcess(this->Controller); ++port)
  {
    vtkAHDAskForAll(inputs[port]);
  }
  return result;
}

/// In one process the first piece of an output has all of it, and the others nothing. Is there
/// nothing to be made, as others than the first are wanted?
bool vtkAdaptiveHilbertDelaunay2D::IsEmptyPiece(vtkInformationVector* outputs) const
{
  const bool isMade[] = { true, this->GenerateInsertionCurve || this->GenerateBoxes,
    this->GenerateVoronoi };
  bool isEmpty = vtkAHDIsOnlyProcess(this->Controller);
  for (int port = 0; port < 3; ++port)
  {
    isEmpty = isEmpty && (!isMade[port] || vtkAHDIsLaterPiece(outputs->GetInformationObject(port)));
  }
  return isEmpty;
}

/// Empties those outputs of which another piece than the first is wanted, but for their arrays:
/// writers of pieces say by the last one which there are.
void vtkAdaptiveHilbertDelaunay2D::KeepFirstPieces(vtkInformationVector* outputs) const
{
  for (int port = 0; port < 3 && vtkAHDIsOnlyProcess(this->Controller); ++port)
  {
    vtkInformation* const info = outputs->GetInformationObject(port);
    vtkPolyData* const output = vtkPolyData::GetData(info);
    if (output && vtkAHDIsLaterPiece(info))
    {
      this->Cache->GiveEmpty(static_cast<std::size_t>(port), output);
    }
  }
}

/// What ports take and give is asked for anew when it is needed next.
void vtkAdaptiveHilbertDelaunay2D::DescribePortsAnew()
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    this->GetInputPortInformation(port)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->GetOutputPortInformation(port)->Remove(vtkAlgorithm::PORT_REQUIREMENTS_FILLED());
  }
}

int vtkAdaptiveHilbertDelaunay2D::FillOutputPortInformation(int port, vtkInformation* info)
{
  const int result = this->Superclass::FillOutputPortInformation(port, info);
  if (this->IsDistributed() && !this->MergeBlocks)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // as MakeOutputs() makes them
  }
  return result;
}

/// What VTK keeps of a request takes memory, too.
vtkTypeBool vtkAdaptiveHilbertDelaunay2D::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  try
  {
    if (this->IsDistributed() && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
    {
      this->MakeOutputs(vtkDataObject::GetData(inputs[0]), outputs);
      return 1;
    }
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  catch (const std::bad_alloc&)
  {
    vtkAHDSayOutOfMemory("vtkAdaptiveHilbertDelaunay2D",
      [&]
      {
        this->Modified(); // or VTK takes the outputs for those of the last execution
        for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
        {
          if (vtkDataObject* const output = vtkDataObject::GetData(outputs, port))
          {
            output->Initialize();
          }
        }
        this->EndWithoutMemory(vtkAHDDataSets());
      });
    return 0;
  }
}
