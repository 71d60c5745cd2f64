# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the help's "Source Heights": spots and contours with heights, and a road without, as one source.

    pvpython mixed.py <AdaptiveHilbertDelaunay.so> <picture.png>

Run by hand where the picture is to be drawn anew; it stands beside index.html.
"""

import sys

from paraview.simple import *

plugin, picture = sys.argv[1:]

LoadPlugin(plugin, remote=False, ns=globals())

SPOTS = """
import math, random
from vtkmodules.vtkCommonCore import vtkPoints
points = vtkPoints()
points.SetDataTypeToDouble()
dealt = random.Random(3)
for _ in range(90):
    x, y = dealt.uniform(0, 100), dealt.uniform(0, 100)
    points.InsertNextPoint(x, y, 50 * math.exp(-((x - 50) ** 2 + (y - 50) ** 2) / 800))
output.SetPoints(points)
"""

LINES = """
import math
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
points, lines = vtkPoints(), vtkCellArray()
points.SetDataTypeToDouble()
for level in (10, 20, 30, 40):
    radius = math.sqrt(-800 * math.log(level / 50))
    lines.InsertNextCell(61)
    first = points.GetNumberOfPoints()
    for k in range(60):
        turn = 2 * math.pi * k / 60
        points.InsertNextPoint(50 + radius * math.cos(turn), 50 + radius * math.sin(turn), level)
    for k in range(61):
        lines.InsertCellPoint(first + k % 60)
road = [(12, 20), (36, 44), (62, 40), (88, 72)]
lines.InsertNextCell(len(road))
for x, y in road:
    lines.InsertCellPoint(points.InsertNextPoint(x, y, 0))
output.SetPoints(points)
output.SetLines(lines)
"""

spots = ProgrammableSource(OutputDataSetType="vtkPolyData", Script=SPOTS)
lines = ProgrammableSource(OutputDataSetType="vtkPolyData", Script=LINES)
GREY, RED = [0.75, 0.83, 0.88], [0.8, 0.25, 0.15]


def edges(surface):
    """The edges of the surface that are of the source, with places of their own."""
    return ProgrammableFilter(Input=surface, OutputDataSetType="vtkPolyData", Script="""
from vtkmodules.vtkCommonDataModel import vtkCellArray
given = self.GetInputDataObject(0, 0)
sides, lines = given.GetCellData().GetArray("ConstraintEdges"), vtkCellArray()
output.SetPoints(given.GetPoints())
for cell in range(given.GetNumberOfCells()):
    ids = given.GetCell(cell).GetPointIds()
    for side in range(3):
        if int(sides.GetValue(cell)) >> side & 1:
            lines.InsertNextCell(2)
            lines.InsertCellPoint(ids.GetId(side))
            lines.InsertCellPoint(ids.GetId((side + 1) % 3))
output.SetPolys(vtkCellArray())
output.SetLines(lines)
""")


def show(heights, **more):
    """A view from the side of the surface with these heights of the source."""
    surface = AdaptiveHilbertDelaunay2D(
        Input=spots, Source=lines, SourceHeights=heights, CrossingMode="Split", GenerateConstraintEdges=1, **more)
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    display = Show(surface, view)
    display.SetRepresentationType("Surface")
    display.ColorArrayName = ["POINTS", ""]  # one colour
    display.AmbientColor = display.DiffuseColor = GREY
    drawn = Show(edges(surface), view)
    drawn.SetRepresentationType("Wireframe")
    drawn.ColorArrayName = ["POINTS", ""]
    drawn.AmbientColor = drawn.DiffuseColor = RED
    drawn.LineWidth = 2.5
    text = Show(Text(Text="Source Heights: " + heights), view)
    text.Color = [0.15, 0.15, 0.15]
    text.FontSize = 15
    view.CameraFocalPoint = [50, 48, 14]
    view.CameraPosition = [75, -60, 110]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 36
    return view


layout = CreateLayout("Mixed")
layout.SplitHorizontal(0, 0.333)
layout.SplitHorizontal(2, 0.5)
AssignViewToLayout(show("Own"), layout, 1)
AssignViewToLayout(show("From Surface"), layout, 5)
AssignViewToLayout(show("Mixed", ZeroIsMissing=1), layout, 6)
SaveScreenshot(picture, layout, ImageResolution=[1500, 460])
