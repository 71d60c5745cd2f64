# SPDX-License-Identifier: BSD-3-Clause
"""Half a sphere that stands upright: turned by a transform for the triangulation, output unchanged."""

import math

import vtkmodules.all as vtk

points = vtk.vtkPoints()
for ring in range(1, 9):
    angle = ring * math.pi / 18
    for step in range(5 * ring):
        turn = 2 * math.pi * (step + 0.31 * ring) / (5 * ring)
        radius = math.sin(angle)
        points.InsertNextPoint(radius * math.cos(turn), math.cos(angle), radius * math.sin(turn))
points.InsertNextPoint(0, 1, 0)
shell = vtk.vtkPolyData()
shell.SetPoints(points)

turned = vtk.vtkTransform()
turned.RotateX(90)
delaunay = vtk.vtkDelaunay2D()
delaunay.SetInputData(shell)
delaunay.SetTransform(turned)
delaunay.BoundingTriangulationOff()
delaunay.SetTolerance(0.001)
delaunay.SetAlpha(0.0)
delaunay.Update()
surface = delaunay.GetOutput()
expected = {"points": 181, "polys": 2 * 181 - 2 - 40, "lines": 0, "verts": 0}
checks = [delaunay.GetTransform() is turned, max(abs(bound) for bound in surface.GetBounds()) <= 1]
