# SPDX-License-Identifier: BSD-3-Clause
"""Coastline and soundings: a surface that ends at the shore, with islands as holes and a channel that is
not cut to pieces, in ParaView's Python.

    pvpython coastline.py <AdaptiveHilbertDelaunay.so> <soundings.csv> <coastline.vtp> <picture.png>

The table needs columns x, y and elevation; the coastline is polygonal data: polygons for the shores
(counterclockwise around the water, clockwise around islands), lines for what is to be edges
(Data/Bay has both). The picture shows the soundings by themselves, and with the coastline.
"""

import os
import sys

from paraview.simple import *

if len(sys.argv) != 5:
    sys.exit("usage: pvpython coastline.py <AdaptiveHilbertDelaunay.so> <soundings.csv> <coastline.vtp> <picture.png>")
plugin, table, coastline, picture = sys.argv[1:]

LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())

rows = CSVReader(FileName=[table])
soundings = TableToPoints(Input=rows, XColumn="x", YColumn="y", ZColumn="elevation", KeepAllDataArrays=1)
shores = XMLPolyDataReader(FileName=[coastline])

# The coastline has points of its own: they are added to the soundings, with their elevation. (With
# SourceMode="Point ids", its points would stand for the soundings of the same ids.)
alone = AdaptiveHilbertDelaunay2D(Input=soundings)
bay = AdaptiveHilbertDelaunay2D(
    Input=soundings, Source=shores, SourceMode="Coordinates", FillRule="Orientation")  # fmt: skip
for surface in (alone, bay):
    surface.UpdatePipeline()

# Was any of it left out? Where lines cross, CrossingMode="Split" would keep both.
for name in (
    "NumberOfTriangles",
    "NumberOfAddedPoints",
    "NumberOfConstraintEdges",
    "NumberOfCrossings",
    "NumberOfBentConstraints",
    "NumberOfConstraintsLeftOut",
    "NumberOfUnfilledLoops",
):
    print(name, bay.GetPropertyValue(name))


# The picture: two views side by side, from above.
def show(surface, title):
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [0.94, 0.91, 0.84]  # land
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    display = Show(surface, view)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.25, 0.4, 0.5]
    ColorBy(display, ("POINTS", "elevation"))
    lines = Show(shores, view)
    lines.SetRepresentationType("Wireframe")
    lines.ColorArrayName = ["POINTS", ""]  # one colour
    lines.AmbientColor = lines.DiffuseColor = [0.55, 0.2, 0.1]
    lines.LineWidth = 2
    moved = "Translation" if "Translation" in lines.ListProperties() else "Position"  # before ParaView 5.13
    setattr(lines, moved, [0, 0, 100])  # above the surface, to be seen
    text = Show(Text(Text=title), view)
    text.Color = [0.2, 0.15, 0.1]
    text.FontSize = 15
    view.CameraFocalPoint = [2600, 2130, 0]
    view.CameraPosition = [2600, 2130, 10000]
    view.CameraParallelScale = 2250
    return view


layout = CreateLayout("Bay")
layout.SplitHorizontal(0, 0.5)
left = show(alone, "Soundings alone")
right = show(bay, "With the coastline as Source")
AssignViewToLayout(left, layout, 1)
AssignViewToLayout(right, layout, 2)
colors = GetColorTransferFunction("elevation")
colors.ApplyPreset("Linear Blue (8_31f)", True)
colors.InvertTransferFunction()  # deep water dark
SaveScreenshot(picture, layout, ImageResolution=[1400, 580])
