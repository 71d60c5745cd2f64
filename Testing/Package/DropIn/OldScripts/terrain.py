# SPDX-License-Identifier: BSD-3-Clause
"""A terrain over a jittered lattice, with its progress shown, on the way to a mapper."""

import random

import vtk

numbers = random.Random(5)
points = vtk.vtkPoints()
heights = vtk.vtkFloatArray()
heights.SetName("height")
for i in range(30):
    for j in range(30):
        height = numbers.uniform(0, 4)
        points.InsertNextPoint(i + numbers.uniform(0, 0.3), j + numbers.uniform(0, 0.3), height)
        heights.InsertNextValue(height)
for x, y in ((-30, -30), (60, -31), (61, 60), (-31, 59)):
    points.InsertNextPoint(x, y, 0)
    heights.InsertNextValue(0)

cloud = vtk.vtkPolyData()
cloud.SetPoints(points)
cloud.GetPointData().SetScalars(heights)

delaunay = vtk.vtkDelaunay2D()
delaunay.SetInputData(cloud)
steps = []
delaunay.AddObserver(vtk.vtkCommand.ProgressEvent, lambda filter, event: steps.append(filter.GetProgress()))

normals = vtk.vtkPolyDataNormals()
normals.SetInputConnection(delaunay.GetOutputPort())
normals.Update()
surface = delaunay.GetOutput()
expected = {"points": 904, "polys": 2 * 904 - 2 - 4, "lines": 0, "verts": 0}
checks = [
    len(steps) > 0,
    steps == sorted(steps),
    surface.GetPointData().GetScalars().GetName() == "height",
    surface.GetPoints().GetDataType() == vtk.VTK_FLOAT,
    normals.GetOutput().GetNumberOfPolys() == 1802,
]
