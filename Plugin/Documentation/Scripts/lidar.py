# SPDX-License-Identifier: BSD-3-Clause
"""The picture of README.md: a piece of a lidar survey, its triangles coloured by height.

    pvpython lidar.py <AdaptiveHilbertDelaunay.so> <lidar.csv> <picture.png>

lidar.csv has the columns x, y, z in feet: the points of PDAL's test/data/las/autzen_trim.las (BSD). Run by hand
where the picture is to be drawn anew.
"""

import sys

from paraview.simple import *

plugin, points, picture = sys.argv[1:]

LoadPlugin(plugin, remote=False, ns=globals())

table = TableToPoints(Input=CSVReader(FileName=[points]), XColumn="x", YColumn="y", ZColumn="z")
surface = AdaptiveHilbertDelaunay2D(Input=table)
surface.UpdatePipeline()
print(surface.NumberOfTriangles, "triangles")

heights = Calculator(Input=surface, ResultArrayName="height", Function="coordsZ")
view = CreateView("RenderView")
view.ViewSize = [1200, 520]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0
display = Show(heights, view)
display.SetRepresentationType("Surface With Edges")
display.EdgeColor = [0.25, 0.33, 0.40]
display.LineWidth = 1.0
ColorBy(display, ("POINTS", "height"))
lut = GetColorTransferFunction("height")
# the river, its bank, trees and their tops
lut.RGBPoints = [406, 0.55, 0.71, 0.82, 413, 0.66, 0.79, 0.87, 416, 0.90, 0.85, 0.73, 425, 0.93, 0.89, 0.78,
                 430, 0.85, 0.86, 0.66, 436, 0.62, 0.76, 0.47, 455, 0.40, 0.64, 0.38, 480, 0.22, 0.48, 0.30]
display.SetScalarBarVisibility(view, False)
view.CameraFocalPoint = [636745, 849215, 418]
view.CameraPosition = [636690, 849070, 560]
view.CameraViewUp = [0, 0, 1]
view.CameraViewAngle = 34
SaveScreenshot(picture, view, ImageResolution=[1200, 520])
