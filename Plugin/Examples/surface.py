# SPDX-License-Identifier: BSD-3-Clause
"""A table of soundings to a surface and a picture of it, in ParaView's Python.

    pvpython surface.py <AdaptiveHilbertDelaunay.so> <table.csv> <picture.png>

The table needs columns x, y and elevation in one unit (Data/survey.csv has them, in metres).
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
points = TableToPoints(Input=rows, XColumn="x", YColumn="y", ZColumn="elevation")
points.KeepAllDataArrays = 1  # the columns come along as point data, through the filter as well

surface = AdaptiveHilbertDelaunay2D(Input=points)
surface.UpdatePipeline()

# What the filter found out stands in its information properties ...
surface.UpdatePropertyInformation()
for name in ("NumberOfTriangles", "NumberOfDuplicates", "NumberOfRejectedPoints", "InsertSeconds"):
    print(name, surface.GetPropertyValue(name))

# ... and the surface is like any other: here coloured by elevation and drawn.
view = CreateView("RenderView")
view.ViewSize = [900, 600]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
display = Show(surface, view)
display.Scale = [1, 1, 4]  # four times too high
ColorBy(display, ("POINTS", "elevation"))
viridis = "Viridis" if GetParaViewVersion() >= (6, 1) else "Viridis (matplotlib)"
GetColorTransferFunction("elevation").ApplyPreset(viridis, True)
view.CameraPosition = [-20000, -85000, 110000]
view.CameraFocalPoint = [40000, 26000, -9000]
view.CameraViewUp = [0, 0, 1]
view.ResetCamera(True)
SaveScreenshot(picture, view)
