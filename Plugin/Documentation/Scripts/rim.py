# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the help's "Coming from Delaunay 2D": the rim of a grid on a hilly slope, as the convex hull of
the best-fitting plane has it, and trimmed.

    pvpython rim.py <AdaptiveHilbertDelaunay.so> <picture.png>

Run by hand where the picture is to be drawn anew; it stands beside index.html.
"""

import sys

from paraview.simple import *

plugin, picture = sys.argv[1:]

LoadPlugin(plugin, remote=False, ns=globals())

GRID = """
import math
from vtkmodules.vtkCommonCore import vtkPoints
points = vtkPoints()
points.SetDataTypeToDouble()
for i in range(30):
    for k in range(30):
        points.InsertNextPoint(i, k, 0.5 * i + 2.2 * math.sin(0.33 * i + 1) * math.cos(0.33 * k + 0.6))
output.SetPoints(points)
"""

grid = ProgrammableSource(OutputDataSetType="vtkPolyData", Script=GRID)


def show(rim, title):
    """A view from the side of the surface with this rim."""
    surface = AdaptiveHilbertDelaunay2D(Input=grid, ProjectionPlaneMode="Best-Fitting Plane", Rim=rim)
    surface.UpdatePipeline()
    print(rim, surface.NumberOfTriangles, surface.NumberOfTrimmedTriangles)
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    display = Show(surface, view)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.25, 0.35, 0.45]
    display.ColorArrayName = ["POINTS", ""]  # one colour
    display.AmbientColor = display.DiffuseColor = [0.75, 0.83, 0.88]
    text = Show(Text(Text=title), view)
    text.Color = [0.15, 0.15, 0.15]
    text.FontSize = 15
    view.CameraFocalPoint = [13, 15, 7]
    view.CameraPosition = [40, -34, 30]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 34
    return view


layout = CreateLayout("Rim")
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(show("Convex Hull", "Rim: Convex Hull"), layout, 1)
AssignViewToLayout(show("Automatic", "Rim: Automatic (trimmed)"), layout, 2)
SaveScreenshot(picture, layout, ImageResolution=[1400, 480])
