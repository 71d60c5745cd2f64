// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates the points of a 10 x 10 lattice and says how many triangles there are.
#include <vtkAdaptiveHilbertDelaunay2D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <iostream>

int main()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 100; ++i)
  {
    points->InsertNextPoint(i % 10, i / 10, 0.1 * i);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);

  vtkNew<vtkAdaptiveHilbertDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();

  std::cout << delaunay->GetOutput()->GetNumberOfPolys() << " triangles\n";
  return delaunay->GetOutput()->GetNumberOfPolys() == 2 * 9 * 9 ? 0 : 1;
}
