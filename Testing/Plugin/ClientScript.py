# SPDX-License-Identifier: BSD-3-Clause
"""The client of RunClientServer.py: the data and the filter are on the server.

    ClientScript.py PORT
"""

import paraview.simple
from paraview import servermanager
from paraview.simple import *

from pluginsupport import *

PORT = int(sys.argv[1])


def load_plugin():
    """Loads the plugin on both sides, unless the environment did; returns the filter's constructor."""
    names = vars(paraview.simple)
    if "PV_PLUGIN_CONFIG_FILE" not in os.environ:
        LoadPlugin(PLUGIN, remote=True, ns=names)
        LoadPlugin(PLUGIN, remote=False, ns=names)
    check("AdaptiveHilbertDelaunay2D" in names, "the plugin is not loaded on client and server")
    return names["AdaptiveHilbertDelaunay2D"]


def check_measures(surface):
    found = measures(surface)
    check_equal(found["NumberOfPointsInserted"], 393, "points inserted on the server")
    check_equal(found["NumberOfDuplicates"], 7, "duplicates found on the server")
    check(found["NP"] >= 1.0, "NP from the server is %r" % found["NP"])


Connect("localhost", PORT)
constructor = load_plugin()
# Without pieces in the file, the first rank reads all of it.
reader = XMLPolyDataReader(FileName=[write_vtp("hill.vtp", hill_points(400, 7))])
surface = constructor(Input=reader, CountWork=1)
check_measures(surface)
check_equal(surface.GetDataInformation().GetNumberOfPoints(), 400, "points on the server")

expected = fingerprint(surface)
set_properties(surface, InsertionOrder="Multi-grid", Nmax=5, GenerateFate=1)
surface.UpdatePipeline()
check(surface.PointData["Fate"], "the setting GenerateFate did not reach the server")
check_equal(fingerprint(surface), expected, "triangles after the settings were changed")

set_properties(surface, InsertionLimit=100, GenerateInsertionCurve=1, GenerateBoxes=1)
found = measures(surface)
check_equal(found["NumberOfPointsInserted"], 100, "points inserted on the server, with a limit")
check_equal(found["NumberOfPointsBeyondLimit"], 293, "points beyond the limit on the server")
order = servermanager.Fetch(surface, idx=1)
check_equal(order.GetNumberOfLines(), 1, "curves that came from the server")
check_equal(order.GetNumberOfPoints(), 100 + 4 * order.GetNumberOfPolys(), "points that came from the server")
# Constraints, read on the server too: only a ring around the middle of the hill is kept.
shore = XMLPolyDataReader(FileName=[write_vtp("shore.vtp", ring(1.0), loops=[range(8)])])
set_properties(surface, Source=shore, InsertionLimit=0)
found = measures(surface)
check_equal(found["NumberOfConstraintEdges"], 8, "constraint edges on the server")
check_equal(found["NumberOfPointsInserted"], 393 + 8, "points on the server, with those of the source")
surface.Source = None
check_equal(fingerprint(surface), expected, "triangles without the source")

# A transform, which is an object of its own on the server: the hill seen from the side.
surface.Transform = "Transform"
surface.Transform.Rotate = [-90, 0, 0]
check(fingerprint(surface) != expected, "the transform did not reach the server")
surface.Transform = "None"
check_equal(fingerprint(surface), expected, "triangles without the transform")
# One surface over all ranks of the server: the first has read all points, each owns some.
set_properties(surface, CountWork=0, GenerateInsertionCurve=0, GenerateBoxes=0, DistributePoints=1)
surface.UpdatePipeline()
joined = servermanager.Fetch(surface)
names = joined.GetPointData().GetArray("GlobalPointIds")
found = set()
for i in range(joined.GetPolys().GetNumberOfCells()):
    corners = cell_ids(joined.GetPolys(), i)
    found.add(frozenset(names.GetValue(k) if names else k for k in corners))
set_properties(surface, DistributePoints=0)
check(found == {frozenset(corners) for corners in triangles(surface)}, "triangles of all ranks together differ")
check_equal(measures(surface)["NumberOfTriangles"], len(found), "number of triangles")
check(surface.SMProxy.GetSession().IsA("vtkSMSessionClient"), "the session is not remote")

# A raster: the settings of its triangulation are an object of their own on the server, too.
if servermanager.ActiveConnection.GetNumberOfDataPartitions() == 1:
    interpolation = vars(paraview.simple)["AdaptiveHilbertInterpolation2D"]
    raster = interpolation(Input=reader, RasterSize="Cell Size", CellSize=[0.1, 0.1])
    raster.UpdatePipeline()
    before = raster.NumberOfValidPlaces
    check(0 < before < raster.NumberOfPlaces, "places with a value on the server: %d" % before)
    raster.MaximumEdgeLength = 0.3
    raster.UpdatePipeline()
    check(0 < raster.NumberOfValidPlaces < before, "the settings of the triangulation did not reach the server")
    line = Line(Point1=[-2, 0, 0], Point2=[2, 0, 0], Resolution=7)
    set_properties(raster, MaximumEdgeLength=0, Source=shore, Places=line)
    raster.UpdatePipeline()
    check_equal((raster.NumberOfPlaces, raster.NumberOfValidPlaces), (8, 4), "places of a line on the server")
