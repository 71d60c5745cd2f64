# SPDX-License-Identifier: BSD-3-Clause
"""The source of points in ParaView: in the menu, in a pipeline with the filter, in state files."""

from paraview.simple import *
from paraview import servermanager, smstate

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())

DISTRIBUTIONS = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed", "Lattice"]
SETTINGS = {"Distribution": "Mixed", "NumberOfPoints": 1234, "Seed": -7, "HillHeight": 0.25, "Scale": 10.0,
            "OutputPointsPrecision": "Single"}  # fmt: skip


def coordinates(source):
    """The coordinates of a source's points, as bytes."""
    return bytes(memoryview(servermanager.Fetch(source).GetPoints().GetData()))


def test_menu_and_help():
    sm = PlanarPointSource().SMProxy
    check_equal(sm.GetXMLGroup(), "sources", "group of the source")
    check_equal(sm.GetXMLLabel(), "Planar Point Source", "label of the source")
    check_equal(sm.GetVTKClassName(), class_in_paraview("PlanarPointSource"), "class of the source")
    menu = sm.GetHints().FindNestedElementByName("ShowInMenu")
    check_equal(menu.GetAttribute("category"), "Adaptive Hilbert", "category in the Sources menu")
    help_texts = sm.GetDocumentation()
    check(len(help_texts.GetShortHelp() or "") > 40, "short help of the source is missing")
    check(len(help_texts.GetLongHelp() or "") > 80, "long help of the source is missing")
    for name in DISTRIBUTIONS:
        check("**%s**" % name in help_texts.GetDescription(), "the help does not say what %s is" % name)


def test_properties():
    """One name in C++, Python and ParaView; all documented; the defaults are those of the class."""
    source = PlanarPointSource()
    check_equal(set(source.ListProperties()), set(SETTINGS), "properties of the source")
    for name in SETTINGS:
        item = source.SMProxy.GetProperty(name)
        check_equal(item.GetXMLLabel().replace(" ", ""), name, "label of %s, without spaces" % name)
        text = item.GetDocumentation().GetDescription()
        check(len(text) > 30 and text.rstrip().endswith("."), "the property %s is not documented" % name)
        check(item.GetPanelVisibility() in ("default", "advanced"), name + " is not in the panel")
    check_equal(list(source.GetProperty("Distribution").Available), DISTRIBUTIONS, "choices of Distribution")
    numbers = source.SMProxy.GetProperty("NumberOfPoints").FindDomain("vtkSMIntRangeDomain")
    check(numbers.GetMinimumExists(0), "NumberOfPoints has no minimum")
    check_equal(numbers.GetMinimum(0), 0, "minimum of NumberOfPoints")
    check(not numbers.GetMaximumExists(0), "a maximum would make a slider of NumberOfPoints")
    if os.environ.get("AHD_EXPECT_PYTHON") == "1":
        from adaptivehilbertdelaunay import vtkPlanarPointSource

        for name in SETTINGS:
            shown = servermanager.vtkSMPropertyHelper(source.SMProxy, name).GetAsDouble()
            told = {"HillHeight": 0.1}.get(name, getattr(vtkPlanarPointSource(), "Get" + name)())
            check_equal(shown, told, "default of " + name)


def test_points_are_visible():
    source = PlanarPointSource(NumberOfPoints=100)
    source.UpdatePipeline()
    information = source.GetDataInformation()
    check_equal(information.GetNumberOfPoints(), 100, "points")
    check_equal(information.GetNumberOfCells(), 1, "cells")
    source.NumberOfPoints = 0
    source.UpdatePipeline()
    check_equal(source.GetDataInformation().GetNumberOfPoints(), 0, "points of none")


def test_hills():
    """There at once, so that a surface and a raster of them have heights; off, all is in the plane."""
    source = PlanarPointSource(NumberOfPoints=500)
    raster = AdaptiveHilbertInterpolation2D(Input=source)
    raster.UpdatePipeline()
    low, high = raster.PointData["Elevation"].GetRange(0)
    check(0.0 <= low < 0.02 and 0.08 < high <= 0.1, "heights of the raster: %r to %r" % (low, high))
    source.HillHeight = 0
    source.UpdatePipeline()
    check_equal(source.GetDataInformation().GetBounds()[4:], (0.0, 0.0), "z without hills")


def test_distributions_differ_and_seeds_matter():
    made = set()
    for name in DISTRIBUTIONS:
        source = PlanarPointSource(Distribution=name, NumberOfPoints=50)
        first = coordinates(source)
        source.Seed = 2
        made |= {first, coordinates(source)}
        same = coordinates(source) == first
        check_equal(same, name == "Lattice", name + ": are the points of two seeds the same")
        source.Seed = 1
        check(coordinates(source) == first, name + ": other points when run again")
    check_equal(len(made), 2 * len(DISTRIBUTIONS) - 1, "different sets of points")


def test_into_the_filter():
    """2 v - 2 - h triangles, where h of v points lie on the boundary."""
    source = PlanarPointSource(NumberOfPoints=2500)
    surface = AdaptiveHilbertDelaunay2D(Input=source)
    edges = FeatureEdges(Input=surface, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
    for name in DISTRIBUTIONS:
        source.Distribution = name
        found = measures(surface)
        check_equal(found["NumberOfPointsInserted"], 2500, name + ": points inserted")
        edges.UpdatePipeline()
        boundary = edges.GetDataInformation().GetNumberOfCells()
        check(boundary >= 3, name + ": no boundary")
        check_equal(found["NumberOfTriangles"], 2 * 2500 - 2 - boundary, name + ": triangles")
    check_equal(boundary, 4 * 49, "Lattice: points on the boundary")


def test_state():
    PlanarPointSource(registrationName="points", **SETTINGS)
    expected = coordinates(FindSource("points"))
    SaveState(scratch("source.pvsm"))
    python_state = smstate.get_state(filter=smstate.supported_proxies())
    restore = {
        "XML state": lambda: LoadState(scratch("source.pvsm")),
        "Python state": lambda: exec(compile(python_state, "state", "exec"), {}),
    }
    for how, load in restore.items():
        ResetSession()
        check(not FindSource("points"), "ResetSession left the source behind: this test would prove nothing")
        load()
        source = FindSource("points")
        check(source, how + ": the source is not there")
        for name, value in SETTINGS.items():
            check_equal(getattr(source, name), value, "%s: %s" % (how, name))
        check(coordinates(source) == expected, how + ": other points")


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
