# SPDX-License-Identifier: BSD-3-Clause
"""Watch a triangulation grow: one picture for each number of inserted points, in ParaView's Python.

    pvpython insertion.py <AdaptiveHilbertDelaunay.so> [folder for the pictures]

Each shows the Delaunay triangulation of the points inserted so far, the boxes of the grid, and the
path from point to point. ffmpeg or the like makes a film of them.
"""

import os
import sys

from paraview.simple import *

if len(sys.argv) < 2:
    sys.exit("usage: pvpython insertion.py <AdaptiveHilbertDelaunay.so> [folder for the pictures]")
plugin = sys.argv[1]
folder = sys.argv[2] if len(sys.argv) > 2 else "."

LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())

points = PlanarPointSource(Distribution="Spiral", NumberOfPoints=2000)
surface = AdaptiveHilbertDelaunay2D(
    Input=points, ControlPoints="First level", GenerateBoxes=1, GenerateInsertionCurve=1)  # fmt: skip

# The second output has both: the boxes have the number of their divisions as level, the path -1.
boxes = Threshold(Input=OutputPort(surface, 1), Scalars=["CELLS", "Level"], LowerThreshold=0, UpperThreshold=99)
path = Threshold(Input=OutputPort(surface, 1), Scalars=["CELLS", "Level"], LowerThreshold=-1, UpperThreshold=-1)

view = CreateView("RenderView")
view.ViewSize = [800, 800]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0
view.CameraParallelProjection = 1
for source, kind, color, width in (
    (surface, "Wireframe", [0.4, 0.4, 0.4], 1),
    (boxes, "Wireframe", [0.75, 0.85, 0.95], 2),
    (path, "Wireframe", [0.85, 0.35, 0.0], 2),
):
    display = Show(source, view)
    display.Representation = kind
    display.ColorArrayName = ["POINTS", ""]  # one colour
    display.AmbientColor = display.DiffuseColor = color
    display.LineWidth = width

surface.InsertionLimit = 0  # all points: the camera is to see the whole
view.ResetCamera(True)
for limit in (20, 100, 400, 1000, 2000):
    surface.InsertionLimit = limit
    surface.UpdatePipeline()
    SaveScreenshot(os.path.join(folder, "insertion-%04d.png" % limit), view)
    print("%4d points: %4d triangles" % (limit, surface.NumberOfTriangles))
