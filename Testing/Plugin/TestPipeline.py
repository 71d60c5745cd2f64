# SPDX-License-Identifier: BSD-3-Clause
"""The filter in a ParaView pipeline, in one process (pvpython, pvbatch)."""

import math

from paraview.simple import *
from paraview import servermanager

from pluginsupport import *

if os.environ.get("AHD_LOAD") == "config":
    # PV_PLUGIN_CONFIG_FILE is set: the filter is available without a line of code.
    check("AdaptiveHilbertDelaunay2D" in globals(), "PV_PLUGIN_CONFIG_FILE did not load the plugin")
else:
    check("AdaptiveHilbertDelaunay2D" not in globals(), "the filter is there before the plugin is loaded")
    LoadPlugin(PLUGIN, remote=False, ns=globals())


def test_lattice():
    """21 x 21 points of a square: 2v - 2 - h triangles with v = 441 and h = 80."""
    surface = AdaptiveHilbertDelaunay2D(Input=Plane(XResolution=20, YResolution=20))
    found = measures(surface)
    check_equal(found["NumberOfTriangles"], 2 * 441 - 2 - 80, "triangles of the lattice")
    check_equal(found["NumberOfPointsInserted"], 441, "points of the lattice")
    information = surface.GetDataInformation()
    check_equal(information.GetNumberOfCells(), 800, "cells in the data information")
    check_equal(information.GetNumberOfPoints(), 441, "points in the data information")
    check_equal(information.GetDataSetTypeAsString(), "vtkPolyData", "type of the output")


def test_table():
    """The steps of a user with a .csv."""
    table = CSVReader(FileName=[write_csv("hill.csv", hill_points(400, 7))])
    points = TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="z", KeepAllDataArrays=1)
    surface = AdaptiveHilbertDelaunay2D(Input=points)
    found = measures(surface)
    check_equal(found["NumberOfDuplicates"], 7, "duplicates")
    check_equal(found["NumberOfPointsInserted"], 393, "points inserted")
    check_equal(found["NumberOfTriangles"], len(triangles(surface)), "triangles")
    check(surface.PointData["z"], "the point array z is not passed on")


def test_measures():
    """Counts in the information properties and in the field data; work only on request."""
    points = hill_points(300, 5) + [(math.nan, 0.0, 0.0), (1.0, math.inf, 0.0)]
    reader = XMLPolyDataReader(FileName=[write_vtp("measures.vtp", points)])
    surface = AdaptiveHilbertDelaunay2D(Input=reader)
    found = measures(surface)
    check_equal(found["NumberOfRejectedPoints"], 2, "rejected points")
    check_equal(found["NumberOfDuplicates"], 5, "duplicates")
    check_equal(found["NumberOfPointsInserted"], 295, "points inserted")
    check_equal(found["NumberOfSkippedPoints"], 0, "skipped points")
    check_equal((found["NP"], found["NR"]), (-1.0, -1.0), "NP and NR without CountWork")
    for name in COUNTS:
        array = surface.FieldData[name]
        check(array, "no array %s in the field data" % name)
        check_equal(array.GetRange(0), (found[name], found[name]), "field data " + name)
    surface.CountWork = 1
    counted = measures(surface)
    check(counted["NP"] >= 1.0, "NP is %r, but at least one triangle is tested per point" % counted["NP"])
    check(counted["NR"] >= 1.0, "NR is %r, but at least one triangle is removed per point" % counted["NR"])
    for name in ("SortSeconds", "InsertSeconds", "OutputSeconds"):
        check(0.0 <= counted[name] < 60.0, "%s is %r" % (name, counted[name]))


def test_threads_do_not_change_the_triangles():
    """40 000 points are worth sharing, whatever the backend of vtkSMPTools."""
    surface = AdaptiveHilbertDelaunay2D(Input=Plane(XResolution=199, YResolution=199), NumberOfThreads=1)
    expected = fingerprint(surface)
    check_equal(measures(surface)["NumberOfThreadsUsed"], 1, "threads used of 1")
    for threads in (2, 4):
        surface.NumberOfThreads = threads
        check_equal(fingerprint(surface), expected, "triangles of %d threads" % threads)
        check_equal(measures(surface)["NumberOfThreadsUsed"], threads, "threads used of %d" % threads)
    surface.NumberOfThreads = 0
    surface.ReuseLimit = 0
    check_equal(fingerprint(surface), expected, "triangles with the default")
    check(measures(surface)["NumberOfThreadsUsed"] >= 1, "threads used by default")


def test_settings_do_not_change_the_triangles():
    reader = XMLPolyDataReader(FileName=[write_vtp("settings.vtp", hill_points(500, 3, seed=2))])
    surface = AdaptiveHilbertDelaunay2D(Input=reader)
    expected = fingerprint(surface)
    walked = set()
    for order in ("Adaptive Hilbert", "Multi-grid", "Regular grid", "As given"):
        for control in ("Off", "First level", "Every level"):
            for nmax, gene in ((1, 0), (50, 1)):
                set_properties(surface, InsertionOrder=order, ControlPoints=control)
                set_properties(surface, Nmax=nmax, GeneRotation=gene, CountWork=1)
                setting = "%s, control points %s, Nmax %d, gene rotation %d" % (order, control, nmax, gene)
                walked.add(measures(surface)["NP"])
                check_equal(fingerprint(surface), expected, "triangles with " + setting)
    check(len(walked) > 4, "the settings do not reach the filter: NP is one of %r" % walked)


def test_fate():
    points = hill_points(50, 2) + [(math.nan, 0.0, 0.0)]
    surface = AdaptiveHilbertDelaunay2D(Input=XMLPolyDataReader(FileName=[write_vtp("fate.vtp", points)]))
    surface.UpdatePipeline()
    check(not surface.PointData["Fate"], "there is a Fate array that nobody asked for")
    surface.GenerateFate = 1
    surface.UpdatePipeline()
    array = servermanager.Fetch(surface).GetPointData().GetArray("Fate")
    check(array, "GenerateFate is on, but there is no array Fate")
    fates = [int(array.GetTuple1(i)) for i in range(51)]
    check_equal(fates, list(range(48)) + [0, 1, -1], "fates")


def test_multiblock():
    """Each block by itself, in both outputs."""
    group = GroupDatasets(Input=[Plane(XResolution=3, YResolution=3), Plane(XResolution=2, YResolution=2)])
    surface = AdaptiveHilbertDelaunay2D(Input=group)
    surface.UpdatePipeline()
    information = surface.GetDataInformation()
    check(information.IsCompositeDataSet(), "a multiblock input does not give a multiblock output")
    check_equal(information.GetNumberOfCells(), 2 * 3 * 3 + 2 * 2 * 2, "triangles of both blocks")
    check_equal(surface[1].GetDataInformation().GetNumberOfPoints(), 0, "points of the second output")
    set_properties(surface, GenerateInsertionCurve=1, GenerateBoxes=1)
    surface.UpdatePipeline()
    order = surface[1].GetDataInformation()
    check(order.IsCompositeDataSet(), "a multiblock input does not give a multiblock second output")
    check_equal(order.GetNumberOfCells(), 2 * (1 + 1), "a curve and a box for each block")
    check_equal(order.GetNumberOfPoints(), 16 + 4 + 9 + 4, "points of the second output")


def test_second_output():
    """The order of insertion, in typical uses."""
    reader = XMLPolyDataReader(FileName=[write_vtp("order.vtp", hill_points(500, 3))])
    surface = AdaptiveHilbertDelaunay2D(Input=reader, InsertionLimit=200)
    surface.UpdatePipeline()
    unasked = surface[1].GetDataInformation()
    check_equal((unasked.GetNumberOfPoints(), unasked.GetNumberOfCells()), (0, 0), "second output, unasked")
    expected = fingerprint(surface)
    set_properties(surface, GenerateInsertionCurve=1, GenerateBoxes=1, GenerateInsertionRank=1)
    check_equal(fingerprint(surface), expected, "triangles beside the second output")
    check_equal(surface.PointData["InsertionRank"].GetRange(0), (-1.0, 496.0), "ranks in the surface")
    order = servermanager.Fetch(surface, idx=1)
    boxes = order.GetNumberOfPolys()
    check_equal(order.GetNumberOfLines(), 1, "curves")
    check(boxes > 15, "there are %d boxes" % boxes)
    check_equal(order.GetNumberOfPoints(), 200 + 4 * boxes, "points of the second output")
    counts, levels = (order.GetCellData().GetArray(name) for name in ("Count", "Level"))
    check_equal(counts.GetValue(0), 200, "points that the curve passes")
    check_equal(sum(counts.GetValue(i) for i in range(1, 1 + boxes)), 497, "points in the boxes")
    check_equal(levels.GetRange(), (-1.0, 1.0), "levels")
    low, high = order.GetBounds()[4:]
    heights = servermanager.Fetch(reader).GetBounds()[4:]
    check_equal(low, heights[0], "height of the boxes, below all points")
    check(high <= heights[1], "a point of the curve is too high")

    edges = Tube(Input=OutputPort(surface, 1), Radius=0.01)
    edges.UpdatePipeline()
    check(edges.GetDataInformation().GetNumberOfCells() > 0, "no tube along the curve")


def test_animation():
    """The steps of a user who animates the growing surface."""
    reader = XMLPolyDataReader(FileName=[write_vtp("animation.vtp", hill_points(60, 0))])
    surface = AdaptiveHilbertDelaunay2D(Input=reader, GenerateInsertionCurve=1)
    track = GetAnimationTrack("InsertionLimit", proxy=surface)
    ends = (0.0, [10.0]), (1.0, [60.0])
    track.KeyFrames = [CompositeKeyFrame(KeyTime=time, KeyValues=value) for time, value in ends]
    scene = GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = 6
    scene.GoToFirst()
    seen = []
    for _ in range(6):
        found = measures(surface)
        curve = surface[1].GetDataInformation()
        check_equal(curve.GetNumberOfPoints(), surface.InsertionLimit, "points of the curve")
        check_equal(found["NumberOfPointsInserted"], surface.InsertionLimit, "points inserted")
        seen.append((surface.InsertionLimit, found["NumberOfTriangles"]))
        scene.GoToNext()
    check_equal([limit for limit, _ in seen], [10, 20, 30, 40, 50, 60], "limits of the animation")
    check(all(a[1] < b[1] for a, b in zip(seen, seen[1:])), "the surface does not grow: %r" % seen)
    whole = AdaptiveHilbertDelaunay2D(Input=reader)
    check_equal(fingerprint(surface), fingerprint(whole), "the surface at the end")


def test_input_types():
    """Any point set is accepted; images, which have no points of their own, are not."""
    domain = AdaptiveHilbertDelaunay2D(Input=Sphere()).SMProxy.GetProperty("Input").FindDomain("vtkSMDataTypeDomain")
    for source, accepted in ((PointSource(), 1), (UnstructuredCellTypes(), 1), (Wavelet(), 0)):
        source.UpdatePipeline()
        check_equal(bool(domain.IsInDomain(source.SMProxy, 0)), bool(accepted), "is %s accepted" % source.GetXMLName())


def test_filters_behind_it():
    """The output works with usual downstream filters."""
    reader = XMLPolyDataReader(FileName=[write_vtp("behind.vtp", hill_points(600, 0, seed=3))])
    surface = AdaptiveHilbertDelaunay2D(Input=reader)
    contour = Contour(Input=surface, ContourBy=["POINTS", "Height"], Isosurfaces=[1.0])
    contour.UpdatePipeline()
    check(contour.GetDataInformation().GetNumberOfCells() > 10, "no contour line at half height")
    # its name since ParaView 6.0, and before
    normals = globals().get("SurfaceNormals") or globals()["GenerateSurfaceNormals"]
    normals = normals(Input=surface)
    normals.UpdatePipeline()
    low, high = normals.PointData["Normals"].GetRange(2)
    check(low > 0.0, "a normal looks down (z = %g): a triangle is not counterclockwise" % low)


def test_limit_is_refused():
    """MemoryLimit reaches the filter, and 1 KiB is not enough for 10 000 points."""
    surface = AdaptiveHilbertDelaunay2D(Input=Plane(XResolution=99, YResolution=99), MemoryLimit=1)
    check_equal(measures(surface)["NumberOfTriangles"], 0, "triangles within 1 KiB")
    surface.MemoryLimit = 0
    check_equal(measures(surface)["NumberOfTriangles"], 2 * 99 * 99, "triangles without a limit")


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
