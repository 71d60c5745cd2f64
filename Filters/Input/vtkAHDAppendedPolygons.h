// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDAppendedPolygons_h
#define vtkAHDAppendedPolygons_h

#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

/// The points and polygons of all parts, which are vtkPolyData, one after the other; with the first
/// array of their cells, one number each, as doubles: 0 for a part without. @pre polygons that are
/// not damaged, and no other cells
vtkSmartPointer<vtkPolyData> vtkAHDAppendPolygons(
  const std::vector<vtkSmartPointer<vtkDataObject>>& parts);

#endif
