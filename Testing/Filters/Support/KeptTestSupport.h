// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_KeptTestSupport_h
#define ahd_KeptTestSupport_h

#include "FilterTestSupport.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"

namespace ahdtest
{

inline void addData(vtkPointSet* cloud, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("data");
  array->SetNumberOfValues(cloud->GetNumberOfPoints());
  array->FillValue(value);
  cloud->GetPointData()->AddArray(array);
}

inline double dataOf(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetPointData()->GetArray("data");
  return array ? array->GetComponent(surface->GetNumberOfPoints() - 1, 0) : -1;
}

/// Passes on the data object that it is given.
class Relay : public vtkPolyDataAlgorithm
{
public:
  static Relay* New() { VTK_STANDARD_NEW_BODY(Relay); }
  vtkTypeMacro(Relay, vtkPolyDataAlgorithm);

  void Send(vtkPolyData* data)
  {
    this->Data = data;
    this->Modified();
  }

protected:
  Relay() { this->SetNumberOfInputPorts(0); }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkPolyData::GetData(outputs, 0)->ShallowCopy(this->Data);
    return 1;
  }

private:
  vtkSmartPointer<vtkPolyData> Data;
};

/// A filter behind a relay.
struct Line
{
  Line() { this->Filter->SetInputConnection(this->Points->GetOutputPort()); }

  /// Was it triangulated anew for this input?
  bool Runs(vtkPolyData* input)
  {
    this->Points->Send(input);
    return this->Runs();
  }

  bool Runs()
  {
    const int before = this->Filter->GetNumberOfTriangulations();
    this->Filter->Update();
    return this->Filter->GetNumberOfTriangulations() > before;
  }

  /// Is it triangulated twice for this input, the second time to be kept?
  bool RunsTwice(vtkPolyData* input) { return this->Runs(input) && this->Runs(input); }

  vtkPolyData* Surface() { return this->Filter->GetOutput(); }

  vtkNew<Relay> Points;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> Filter;
};

} // namespace ahdtest

#endif
