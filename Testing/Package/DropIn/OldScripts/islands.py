# SPDX-License-Identifier: BSD-3-Clause
"""Alpha cuts the bridge between two islands, and leaves short edges as lines and a lone point as a vertex."""

from vtk import *  # noqa: F403 (as old scripts do)

points = vtkPoints()  # noqa: F405
for left in (0, 20):
    for i in range(4):
        for j in range(4):
            points.InsertNextPoint(left + i + 0.11 * (j % 2), j + 0.13 * (i % 2), 0)
points.InsertNextPoint(10, 10.5, 0)
points.InsertNextPoint(10, 11.5, 0)
points.InsertNextPoint(10, -9, 0)
islands = vtkPolyData()  # noqa: F405
islands.SetPoints(points)

delaunay = vtkDelaunay2D()  # noqa: F405
delaunay.SetInputData(islands)
delaunay.SetAlpha(1.0)
delaunay.Update()
surface = delaunay.GetOutput()
expected = {"points": 35, "polys": 2 * 18, "lines": 7, "verts": 1}
checks = []
