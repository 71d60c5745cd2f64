// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SampleTestSupport_h
#define ahd_SampleTestSupport_h

#include "FilterTestSupport.h"

#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace ahdtest
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A filter whose messages are kept instead of printed.
struct WatchedInterpolation
{
  WatchedInterpolation()
  {
    this->Said->Watch(this->Filter);
    this->PipelineSaid->Watch(this->Filter->GetExecutive());
  }
  vtkAdaptiveHilbertInterpolation2D* operator->() { return this->Filter; }

  vtkNew<vtkAdaptiveHilbertInterpolation2D> Filter;
  vtkNew<Messages> Said;
  vtkNew<Messages> PipelineSaid;
};

/// A linear function of x and y, of size 1 about the middle.
inline double planeAt(double x, double y)
{
  return 1.0 + 2.0 * x - 3.0 * y;
}

/// Points with these x, y and the linear function as z.
inline std::vector<Xyz> onPlane(std::vector<Xyz> points)
{
  for (Xyz& p : points)
  {
    p[2] = planeAt(p[0], p[1]);
  }
  return points;
}

inline vtkDataArray* arrayOf(vtkDataSet* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

/// The numbers of an array; empty if there is none.
inline std::vector<double> numbersOf(vtkDataSet* data, const char* name)
{
  std::vector<double> numbers;
  vtkDataArray* array = arrayOf(data, name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      numbers.push_back(array->GetComponent(i, c));
    }
  }
  return numbers;
}

/// Adds an array with value(i) for point i.
template <typename Array>
void addArray(vtkPolyData* cloud, const char* name, const std::function<double(vtkIdType)>& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(cloud->GetNumberOfPoints());
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    array->SetComponent(i, 0, value(i));
  }
  cloud->GetPointData()->AddArray(array);
}

/// Hills with an array, and a duplicate with another height.
inline vtkSmartPointer<vtkPolyData> hills(std::size_t count = 1500)
{
  std::vector<Xyz> points = scatteredPoints(count, 21);
  for (Xyz& p : points)
  {
    p[2] = 0.1 * std::sin(12 * p[0]) * p[1];
  }
  points.push_back(points[7]);
  points.back()[2] += 0.5;
  auto cloud = makeCloud(points);
  addArray<vtkDoubleArray>(cloud, "a", [](vtkIdType i) { return double(i % 13); });
  return cloud;
}

/// How far the heights are from the linear function at places with a value, at most; NaN if one has
/// none.
inline double farthestFromPlane(vtkDataSet* data)
{
  double farthest = 0.0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (arrayOf(data, "vtkValidPointMask")->GetComponent(i, 0) != 0.0)
    {
      const double off = std::abs(
        arrayOf(data, "Elevation")->GetComponent(i, 0) - planeAt(p[0], p[1]));
      farthest = off <= farthest ? farthest : off;
    }
  }
  return farthest;
}

} // namespace ahdtest

#endif
