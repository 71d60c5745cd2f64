// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates the points of a text file, three numbers a line, and writes the surface:
//   triangulate_xyz points.xyz surface.vtp
#include <vtkAdaptiveHilbertDelaunay2D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: triangulate_xyz points.xyz surface.vtp\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble(); // text has more digits than a float keeps
  std::ifstream file(argv[1]);
  double x, y, z;
  while (file >> x >> y >> z)
  {
    points->InsertNextPoint(x, y, z);
  }
  if (!file.eof())
  {
    std::cerr << argv[1] << ": three numbers a line expected, after " << points->GetNumberOfPoints()
              << " points there is something else\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkAdaptiveHilbertDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);

  vtkNew<vtkXMLPolyDataWriter> writer; // asks the filter for its surface
  writer->SetInputConnection(delaunay->GetOutputPort());
  writer->SetFileName(argv[2]);
  // VTK 9.2 cannot read what is the default, appended data, with newer versions of libexpat.
  writer->SetDataModeToBinary();
  if (!writer->Write())
  {
    return EXIT_FAILURE;
  }

  std::cout << points->GetNumberOfPoints() << " points, " << delaunay->GetNumberOfDuplicates()
            << " duplicates, " << delaunay->GetNumberOfTriangles() << " triangles in "
            << delaunay->GetSortSeconds() + delaunay->GetInsertSeconds() +
      delaunay->GetOutputSeconds()
            << " s\n";
  return EXIT_SUCCESS;
}
