# SPDX-License-Identifier: BSD-3-Clause
"""A table of soundings to a surface and a picture of it, in ParaView's Python.

    pvpython surface.py <AdaptiveHilbertDelaunay.so> <table.csv> <picture.png>

The table needs columns lon, lat and elevation (Data/survey.csv has them).
"""

import os
import sys

from paraview.simple import *

if len(sys.argv) != 4:
    sys.exit("usage: pvpython surface.py <AdaptiveHilbertDelaunay.so> <table.csv> <picture.png>")
plugin, table, picture = sys.argv[1:]

# Makes AdaptiveHilbertDelaunay2D known here. With a remote server: once more with remote=True.
LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())

rows = CSVReader(FileName=[table])
points = TableToPoints(Input=rows, XColumn="lon", YColumn="lat", ZColumn="elevation")
points.KeepAllDataArrays = 1  # the columns come along as point data, through the filter as well

surface = AdaptiveHilbertDelaunay2D(Input=points)
surface.UpdatePipeline()

# What the filter found out stands in its information properties ...
surface.UpdatePropertyInformation()
for name in ("NumberOfTriangles", "NumberOfDuplicates", "NumberOfRejectedPoints", "InsertSeconds"):
    print(name, surface.GetPropertyValue(name))

# ... and the surface is like any other: here coloured by elevation and drawn. A degree is some
# 111 km, an elevation a metre: scaled alike, the relief would be a wall.
view = CreateView("RenderView")
view.ViewSize = [900, 600]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
display = Show(surface, view)
display.Scale = [0.77, 1, 4 / 111195]  # cos(40 degrees), 1, metres to degrees, four times too high
ColorBy(display, ("POINTS", "elevation"))
viridis = "Viridis" if GetParaViewVersion() >= (6, 1) else "Viridis (matplotlib)"
GetColorTransferFunction("elevation").ApplyPreset(viridis, True)
view.CameraPosition = [-15.6, 39.2, 1.0]
view.CameraFocalPoint = [-15.05, 40.2, -0.08]
view.CameraViewUp = [0, 0, 1]
view.ResetCamera(True)
SaveScreenshot(picture, view)
