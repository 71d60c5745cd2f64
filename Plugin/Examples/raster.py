# SPDX-License-Identifier: BSD-3-Clause
"""Soundings and a coastline become a raster, a profile and a picture, in ParaView's Python.

    pvpython raster.py <AdaptiveHilbertDelaunay.so> <points.csv> <coastline.vtp> <out.vti> <out.png>

The soundings are a table with columns x, y and elevation; Data/Bay of the sources has such files.
"""

import os
import sys

from paraview import servermanager
from paraview.simple import *

if len(sys.argv) != 6:
    sys.exit("usage: pvpython raster.py <AdaptiveHilbertDelaunay.so> <points.csv> <coastline.vtp> <out.vti> <out.png>")
plugin, soundings, coastline, raster, picture = sys.argv[1:]
LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())

points = TableToPoints(Input=CSVReader(FileName=[soundings]), XColumn="x", YColumn="y", ZColumn="elevation")
shore = XMLPolyDataReader(FileName=[coastline])

# Cells of 10 metres, their borders at multiples of 10. The coastline bounds the water: on land there is no value.
depths = AdaptiveHilbertInterpolation2D(
    Input=points, Source=shore, RasterSize="Cell Size", CellSize=[10, 10], AlignToCellSize=1, Method="Natural Neighbor")
depths.UpdatePipeline()
print("%d cells, %d of them water" % (depths.NumberOfPlaces, depths.NumberOfValidPlaces))
SaveData(raster, proxy=depths, DataMode="Binary")

# A profile: another filter with the same points and coastline, and a line as its places.
xmin, xmax, ymin, ymax = points.GetDataInformation().GetBounds()[:4]
line = Line(Point1=[xmin, (ymin + ymax) / 2, 0], Point2=[xmax, (ymin + ymax) / 2, 0], Resolution=200)
profile = AdaptiveHilbertInterpolation2D(Input=points, Source=shore, Places=line)
data = servermanager.Fetch(profile)
heights, is_water = (data.GetPointData().GetArray(name) for name in ("Elevation", "vtkValidPointMask"))
depths_there = [heights.GetTuple1(i) for i in range(heights.GetNumberOfTuples()) if is_water.GetTuple1(i)]
print("across the bay: %d of 201 places are water, the deepest at %.2f m" % (len(depths_there), min(depths_there)))

view = CreateView("RenderView")
view.ViewSize = [900, 700]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
display = Show(depths, view)
display.SetRepresentationType("Surface")
ColorBy(display, ("POINTS", "Elevation"))
colours = GetColorTransferFunction("Elevation")
colours.ApplyPreset("Viridis" if GetParaViewVersion() >= (6, 1) else "Viridis (matplotlib)", True)
colours.NanOpacity = 0.0  # land, if it is drawn at all
view.CameraParallelProjection = 1
view.ResetCamera(True)
SaveScreenshot(picture, view)
