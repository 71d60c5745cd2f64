# SPDX-License-Identifier: BSD-3-Clause
"""Does the order of insertion matter? One set of points, every order, in ParaView's batch Python.

    pvbatch orders.py <AdaptiveHilbertDelaunay.so> [number of points]

NP is the number of triangles visited to find the place of a point, NR the number replaced to put
it in, both on average: Su et al. compare the orders by these (Computers & Graphics 54, 2016). The
triangles are the same each time.
"""

import os
import sys

from paraview.simple import *

if len(sys.argv) < 2:
    sys.exit("usage: pvbatch orders.py <AdaptiveHilbertDelaunay.so> [number of points]")
plugin = sys.argv[1]
count = int(sys.argv[2]) if len(sys.argv) > 2 else 50000

LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())

# Points at random in the unit ball; the filter uses x and y.
points = PointSource(NumberOfPoints=count, Radius=1.0)

print("%-45s %8s %8s %10s %10s" % ("insertion order", "NP", "NR", "sort, s", "insert, s"))
for order, control, label in (
    ("Adaptive Hilbert", "Every level", "adaptive Hilbert, control points: every level"),
    ("Adaptive Hilbert", "First level", "adaptive Hilbert, control points: first level"),
    ("Adaptive Hilbert", "Off", "adaptive Hilbert, control points: off"),
    ("Multi-grid", "Off", "multi-grid (Lo 2013)"),
    ("Regular grid", "Off", "regular grid"),
):
    # Counting takes a little time itself: the seconds come from a run without it.
    surface = AdaptiveHilbertDelaunay2D(Input=points, InsertionOrder=order, ControlPoints=control)
    surface.UpdatePipeline()
    surface.UpdatePropertyInformation()
    seconds = [surface.GetPropertyValue(name) for name in ("SortSeconds", "InsertSeconds")]
    surface.CountWork = 1
    surface.UpdatePipeline()
    surface.UpdatePropertyInformation()
    measures = [surface.GetPropertyValue(name) for name in ("NP", "NR")]
    print("%-45s %8.2f %8.2f %10.4f %10.4f" % (label, *measures, *seconds))
    Delete(surface)
