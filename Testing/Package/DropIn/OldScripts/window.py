# SPDX-License-Identifier: BSD-3-Clause
"""A sheet of 8 x 8 points with a window of 3 x 2 squares: its border clockwise, so it is cut out."""

from vtkmodules.vtkCommonCore import vtkIdList, vtkMinimalStandardRandomSequence, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay2D

numbers = vtkMinimalStandardRandomSequence()
numbers.SetSeed(1)
points = vtkPoints()
for y in range(8):
    for x in range(8):
        points.InsertNextPoint(x, y, numbers.GetNextRangeValue(0, 1))
        numbers.Next()
sheet = vtkPolyData()
sheet.SetPoints(points)

border = [(2, 2), (3, 2), (4, 2), (4, 3), (4, 4), (4, 5), (3, 5), (2, 5), (2, 4), (2, 3)]
loop = vtkIdList()
for row, column in border:
    loop.InsertNextId(8 * row + column)
loops = vtkCellArray()
loops.InsertNextCell(loop)
window = vtkPolyData()
window.SetPoints(points)
window.SetPolys(loops)

delaunay = vtkDelaunay2D()
delaunay.SetInputData(sheet)
delaunay.SetSourceData(window)
delaunay.Update()
surface = delaunay.GetOutput()
expected = {"points": 64, "polys": 2 * (7 * 7 - 3 * 2), "lines": 0, "verts": 0}
checks = [delaunay.GetSource() is window]
