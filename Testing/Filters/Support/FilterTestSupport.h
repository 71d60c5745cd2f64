// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FilterTestSupport_h
#define ahd_FilterTestSupport_h

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace ahdtest
{

using Xyz = std::array<double, 3>;
using Triangle = std::array<vtkIdType, 3>;

/// `count` points with whole coordinates from 0 to `side` - 1 and z = 0, the same ones each time.
inline std::vector<Xyz> latticePoints(std::size_t count, int side, unsigned seed = 1)
{
  std::mt19937 random(seed); // its sequence is fixed by the standard
  std::vector<Xyz> points(count);
  for (Xyz& p : points)
  {
    p = { double(random() % unsigned(side)), double(random() % unsigned(side)), 0.0 };
  }
  return points;
}

/// `count` points with x and y from [0, 1), no two alike, and z = 0; the same ones each time.
inline std::vector<Xyz> scatteredPoints(std::size_t count, unsigned seed = 1)
{
  std::mt19937_64 random(seed); // its sequence is fixed by the standard
  std::vector<Xyz> points(count);
  for (Xyz& p : points)
  {
    const double x = double(random() >> 11) * 0x1p-53;
    p = { x, double(random() >> 11) * 0x1p-53, 0.0 };
  }
  return points;
}

/// Points as vtkPoints of any type of number (VTK_FLOAT, VTK_DOUBLE, VTK_INT, ...).
inline vtkSmartPointer<vtkPoints> makePoints(const std::vector<Xyz>& xyz, int type = VTK_DOUBLE)
{
  auto points = vtkSmartPointer<vtkPoints>::Take(vtkPoints::New(type));
  points->SetNumberOfPoints(static_cast<vtkIdType>(xyz.size()));
  for (std::size_t i = 0; i < xyz.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), xyz[i].data());
  }
  return points;
}

/// A vtkPolyData of points and no cells.
inline vtkSmartPointer<vtkPolyData> makeCloud(const std::vector<Xyz>& xyz, int type = VTK_DOUBLE)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(makePoints(xyz, type));
  return cloud;
}

/// The triangles in the order of the output, read through VTK's own interface.
inline std::vector<Triangle> trianglesOf(vtkPolyData* surface)
{
  std::vector<Triangle> triangles;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(cell, size, ids);
    triangles.push_back(size == 3 ? Triangle{ ids[0], ids[1], ids[2] } : Triangle{ -1, -1, -1 });
  }
  return triangles;
}

/// The values of an array of ids; empty if there is no such array.
inline std::vector<vtkIdType> idsOf(vtkFieldData* data, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
  return array ? std::vector<vtkIdType>(
                   array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues())
               : std::vector<vtkIdType>();
}

/// The triangles of `xyz` with default settings.
inline std::vector<Triangle> triangulate(const std::vector<Xyz>& xyz, int type = VTK_DOUBLE)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(xyz, type));
  filter->Update();
  return trianglesOf(filter->GetOutput());
}

/// Records the warnings and errors of the filter it watches, and their numbers.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }

  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::WarningEvent, this);
    object->AddObserver(vtkCommand::ErrorEvent, this);
  }

  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    auto& list = event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings;
    list.emplace_back(static_cast<const char*>(text));
  }

  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;
};

/// A filter whose messages are kept instead of printed.
struct WatchedFilter
{
  WatchedFilter()
  {
    this->Said->Watch(this->Filter);
    this->PipelineSaid->Watch(this->Filter->GetExecutive());
  }
  vtkAdaptiveHilbertDelaunay2D* operator->() { return this->Filter; }

  vtkNew<vtkAdaptiveHilbertDelaunay2D> Filter;
  vtkNew<Messages> Said;
  vtkNew<Messages> PipelineSaid; // VTK's own "Algorithm ... returned failure"
};

} // namespace ahdtest

#endif
