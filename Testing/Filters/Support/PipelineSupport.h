// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PipelineSupport_h
#define ahd_PipelineSupport_h

#include "SampleTestSupport.h"

#include "vtkDataObject.h"
#include "vtkImageAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ahdtest
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

inline vtkSmartPointer<vtkPolyData> cloud(std::size_t count = 1000, double size = 1.0)
{
  std::vector<Xyz> points = scatteredPoints(count, 17);
  for (Xyz& p : points)
  {
    p = { p[0] * size, p[1] * size, std::sin(5 * p[0]) };
  }
  return makeCloud(points);
}

/// An image filter like VTK's own: it makes its output by the announced geometry.
class Behind : public vtkImageAlgorithm
{
public:
  static Behind* New() { VTK_STANDARD_NEW_BODY(Behind); }
  vtkTypeMacro(Behind, vtkImageAlgorithm);
  int Executed = 0;
  bool HadAll = true;       ///< each time, all requested cells
  bool HadItsPlace = false; ///< the last time, announced origin and spacing

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->Executed;
    vtkInformation* const info = outputs->GetInformationObject(0);
    auto* output = vtkImageData::GetData(info);
    auto* input = vtkImageData::GetData(inputs[0]);
    this->AllocateOutputData(output, info, info->Get(Pipeline::UPDATE_EXTENT()));
    int wanted[6], there[6];
    output->GetExtent(wanted);
    input->GetExtent(there);
    bool isThere = true;
    for (int k = 0; k < 6; k += 2)
    {
      isThere = isThere &&
        (wanted[k] > wanted[k + 1] || (there[k] <= wanted[k] && wanted[k + 1] <= there[k + 1]));
    }
    this->HadAll = this->HadAll && isThere &&
      output->GetScalarType() ==
        (input->GetPointData()->GetScalars() ? input->GetPointData()->GetScalars()->GetDataType()
                                             : output->GetScalarType());
    this->HadItsPlace = input->GetNumberOfPoints() == 0 ||
      (std::equal(output->GetOrigin(), output->GetOrigin() + 3, input->GetOrigin()) &&
        std::equal(output->GetSpacing(), output->GetSpacing() + 3, input->GetSpacing()));
    return 1;
  }
};

/// Points that differ at each time.
class Moving : public vtkPolyDataAlgorithm
{
public:
  static Moving* New() { VTK_STANDARD_NEW_BODY(Moving); }
  vtkTypeMacro(Moving, vtkPolyDataAlgorithm);
  double EmptyAt = -1.0; ///< the time at which there are no points
  double Begin = 0.0;    ///< where they begin, times the time

protected:
  Moving() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[] = { 0.0, 1.0, 2.0 }, range[] = { 0.0, 2.0 };
    outputs->GetInformationObject(0)->Set(Pipeline::TIME_STEPS(), times, 3);
    outputs->GetInformationObject(0)->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* const info = outputs->GetInformationObject(0);
    const double time = info->Has(Pipeline::UPDATE_TIME_STEP())
      ? info->Get(Pipeline::UPDATE_TIME_STEP())
      : 0.0;
    auto* output = vtkPolyData::GetData(outputs);
    if (time != this->EmptyAt)
    {
      output->ShallowCopy(cloud(1000, 1.0 + time));
      vtkPoints* const points = output->GetPoints();
      for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
      {
        double p[3];
        points->GetPoint(i, p);
        points->SetPoint(i, p[0] + this->Begin * time, p[1], p[2]);
      }
    }
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};

} // namespace ahdtest

#endif
