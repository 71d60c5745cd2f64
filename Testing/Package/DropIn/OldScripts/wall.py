# SPDX-License-Identifier: BSD-3-Clause
"""A tilted wall in its best-fitting plane: found by the filter, or requested and given as a transform."""

import vtkmodules.vtkFiltersCore
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import VTK_BEST_FITTING_PLANE

points = vtkPoints()
points.SetDataTypeToDouble()
for i in range(9):
    for j in range(6):
        across, up = i + 0.1 * (j % 3), j + 0.07 * (i % 4)
        points.InsertNextPoint(2 * across - up, across + 2 * up, 3 * up + 0.5 * across)
wall = vtkPolyData()
wall.SetPoints(points)

delaunay = vtkmodules.vtkFiltersCore.vtkDelaunay2D()
delaunay.SetInputDataObject(wall)
delaunay.SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE)
delaunay.SetOffset(20)
delaunay.Update()
surface = vtkPolyData()
surface.ShallowCopy(delaunay.GetOutput())

again = vtkmodules.vtkFiltersCore.vtkDelaunay2D()
again.SetInputDataObject(wall)
again.SetProjectionPlaneMode(1)
again.SetTransform(again.ComputeBestFittingPlane(wall))
again.SetOffset(20)
again.Update()
expected = {"points": 54, "polys": surface.GetNumberOfPolys(), "lines": 0, "verts": 0}
checks = [surface.GetNumberOfPolys() >= 80, again.GetOutput().GetNumberOfPolys() == surface.GetNumberOfPolys()]
