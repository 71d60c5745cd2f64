# SPDX-License-Identifier: BSD-3-Clause
"""The interpolation in ParaView: menu, panel, names and defaults; rasters, places, constraints; states."""

import math
import re

from paraview import servermanager, smstate
from paraview.simple import *

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())
proxy = AdaptiveHilbertInterpolation2D(Input=Sphere())
sm = proxy.SMProxy
OF_TRIANGULATION = EXPOSED + ["Transform"]


def plane_points(count=300):
    """Points of z = 1 + 2 x - 3 y in [-2, 2], the corners among them."""
    corners = [(x, y) for x in (-2.0, 2.0) for y in (-2.0, 2.0)]
    return [(x, y, 1 + 2 * x - 3 * y) for x, y in corners + [point[:2] for point in hill_points(count, 0)]]


def reader(name, points, **cells):
    return XMLPolyDataReader(FileName=[write_vtp(name, points, **cells)])


def values(source, name="Elevation"):
    """An array of the points, a list of its tuples, and the points."""
    data = servermanager.Fetch(source)
    array = data.GetPointData().GetArray(name)
    check(array, "there is no array %s" % name)
    tuples = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
    return [t[0] if len(t) == 1 else t for t in tuples], [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


def check_plane(source, what, where=lambda x, y: True):
    """Every value is that of the plane, and there is one exactly where there should be."""
    found, places = values(source)
    mask, _ = values(source, "vtkValidPointMask")
    for value, valid, (x, y, *_) in zip(found, mask, places):
        check_equal(bool(valid), where(x, y), "%s: is there a value at (%r, %r)" % (what, x, y))
        right = abs(value - (1 + 2 * x - 3 * y)) < 1e-12 if valid else math.isnan(value)
        check(right, "%s: %r at (%r, %r)" % (what, value, x, y))


def cells(raster):
    """How many cells, along x and y."""
    extent = servermanager.Fetch(raster).GetExtent()
    return extent[1] - extent[0] + 1, extent[3] - extent[2] + 1


def raster_measures(of):
    """The measures of the last run, as ParaView shows them: the update itself must fetch them."""
    of.UpdatePipeline()
    return {name: getattr(of, name) for name in RASTER_MEASURES}


# --- Its menu, panel and names ---------------------------------------------------------------------


def test_menu():
    check_equal(sm.GetXMLLabel(), "Adaptive Hilbert Interpolation 2D", "label of the filter")
    check_equal(sm.GetVTKClassName(), class_in_paraview("AdaptiveHilbertInterpolation2D"), "class of the filter")
    menu = sm.GetHints().FindNestedElementByName("ShowInMenu")
    check_equal(menu.GetAttribute("category"), "Adaptive Hilbert", "category in the Filters menu")


def test_properties_are_complete_and_named_as_in_the_class():
    expected = set(RASTER_SETTINGS + RASTER_MEASURES + TEXTS + OF_TRIANGULATION + ["Input", "Places", "Source"])
    found = properties(sm)
    check_equal(set(found), expected, "properties of the filter")
    for name, item in found.items():
        check_equal(item.GetXMLLabel().replace(" ", ""), name, "label of %s, without spaces" % name)
        check(hasattr(proxy, name), "paraview.simple does not know the property " + name)
    for name in RASTER_MEASURES:
        check(found[name].GetInformationOnly(), name + " can be changed, but is a measure")


def test_everything_is_documented_and_shown():
    documentation = sm.GetDocumentation()
    for text in (documentation.GetShortHelp(), documentation.GetLongHelp(), documentation.GetDescription()):
        check(len(text or "") > 80, "help of the filter is missing")
    in_groups = set()
    for i in range(sm.GetNumberOfPropertyGroups()):
        group = sm.GetPropertyGroup(i)
        in_groups |= {group.GetProperty(k).GetXMLName() for k in range(group.GetNumberOfProperties())}
    without = {"Input", "Places", "Method", *RASTER_MEASURES, *TEXTS}
    check_equal(set(properties(sm)) - in_groups, without, "properties under no heading")
    for name, item in properties(sm).items():
        text = item.GetDocumentation().GetDescription() if item.GetDocumentation() else ""
        check(len(text) > 30 and text.rstrip().endswith("."), "documentation of %s: %r" % (name, text))
        check(item.GetPanelVisibility() in ("default", "advanced"), name + " is not in the panel")


def test_what_is_shown_when():
    """The widgets of a raster are there without places, those of a cell size with one, and so on."""
    shown_by = {}
    for name, item in properties(sm).items():
        hints = item.GetHints()
        for i in range(hints.GetNumberOfNestedElements() if hints else 0):
            rule = hints.GetNestedElement(i)
            if rule.GetAttribute("mode") == "visibility":
                shown_by.setdefault(name, set()).add(rule.GetAttribute("property"))
    for name in ("RasterSize", "Dimensions", "CellSize", "AlignToCellSize", "UseBounds", "Bounds", "OutputType"):
        check("Places" in shown_by.get(name, ()), name + " is shown with places, too")
    for name in ("Dimensions", "CellSize", "AlignToCellSize"):
        check("RasterSize" in shown_by[name], name + " is shown with either Raster Size")
    check("UseBounds" in shown_by["Bounds"], "Bounds are shown without Use Bounds")
    for name in ("SourceMode", "SourceHeights", "ClosedLines", "FillRule", "CrossingMode"):
        check("Source" in shown_by.get(name, ()), name + " is shown without a source")
    known = set(properties(sm))
    check_equal(set().union(*shown_by.values()) - known, set(), "rules about properties that are not here")


def test_choices():
    expected = {
        "Method": ["Linear", "Natural Neighbor", "Laplace", "Nearest"],
        "RasterSize": ["Dimensions", "Cell Size"],
        "OutputType": ["Image", "Surface"],
        "Outside": ["No Value", "Nearest Vertex", "Boundary"],
    }
    for name, texts in expected.items():
        check_equal(choices(sm, name), dict(enumerate(texts)), "choices of " + name)
    # those of the triangulation are looked at by TestServerManager.py
    check_equal(with_choices(sm) - set(OF_TRIANGULATION), set(expected), "properties with choices")


def test_inputs():
    for name in ("Places", "Source"):
        item = sm.GetProperty(name)
        check(item.GetHints().FindNestedElementByName("Optional"), "creating the filter asks for " + name)
        check_equal(item.GetNumberOfProxies(), 0, name + " at the beginning")
    for other, place, line in ((Sphere(), 1, 1), (Wavelet(), 1, 0), (UnstructuredCellTypes(), 1, 0)):
        other.UpdatePipeline()
        for name, accepted in (("Places", place), ("Source", line)):
            domain = sm.GetProperty(name).FindDomain("vtkSMDataTypeDomain")
            is_one = bool(domain.IsInDomain(other.SMProxy, 0))
            check_equal(is_one, bool(accepted), "may %s be %s" % (other.SMProxy.GetXMLName(), name))


def of_class(name):
    try:
        import adaptivehilbertdelaunay

        return getattr(adaptivehilbertdelaunay, name)()
    except (ImportError, AttributeError):
        check(os.environ.get("AHD_EXPECT_PYTHON") != "1", "the package has no " + name)
        return None


def test_defaults_are_those_of_the_class():
    fresh = of_class("vtkAdaptiveHilbertInterpolation2D")
    if fresh is None:
        return
    strings = {"HeightArrayName", "ValidPointMaskArrayName"}
    untouched = AdaptiveHilbertInterpolation2D(Input=Sphere())
    for name in RASTER_SETTINGS + RASTER_MEASURES:
        # the property's default: some were suggested for the points since
        untouched.SMProxy.GetProperty(name).ResetToXMLDefaults()
        given = servermanager.vtkSMPropertyHelper(untouched.SMProxy, name)
        told = TABLE["interpolation"]["settings"].get(name, {}).get("panel_default", getattr(fresh, "Get" + name)())
        if name in strings:
            check_equal(given.GetAsString(), told, "default of " + name)
        else:
            numbers = [given.GetAsDouble(i) for i in range(given.GetNumberOfElements())]
            told = list(told) if isinstance(told, (tuple, list)) else [told]
            check_equal(numbers, [float(number) for number in told], "default of " + name)
    of_vtk = next(kind for kind in type(fresh).__mro__[1:] if not kind.__name__.startswith("vtkAdaptiveHilbert"))
    setters = {m[3:] for m in dir(type(fresh)) if m.startswith("Set") and not hasattr(of_vtk, m)}
    setters = {m for m in setters if not re.search("To[A-Z]", m) or m in RASTER_SETTINGS}  # choices: SetXToY
    others = {"Triangulation", "PlacesData", "PlacesConnection", "SourceData", "SourceConnection", "Controller"}
    # NoValue is NaN by default, which ParaView cannot write
    check_equal(setters - others, set(RASTER_SETTINGS) | {"NoValue"}, "settings of the class")


def test_settings_of_the_triangulation_are_those_of_the_other_filter():
    other = AdaptiveHilbertDelaunay2D(Input=Sphere())
    untouched = AdaptiveHilbertInterpolation2D(Input=Sphere())
    for name in EXPOSED:
        check_equal(getattr(untouched, name), getattr(other, name), "default of " + name)
        ours, theirs = (of.GetProperty(name).GetPanelVisibility() for of in (sm, other.SMProxy))
        check(ours in (theirs, "advanced"), "%s is %s here, and %s there" % (name, ours, theirs))


# --- Its results ----------------------------------------------------------------------------------


def test_a_raster():
    raster = AdaptiveHilbertInterpolation2D(Input=reader("plane.vtp", plane_points()), Dimensions=[8, 4])
    found = raster_measures(raster)
    counts = {"NumberOfPlaces": 32, "NumberOfValidPlaces": 32, "NumberOfPlacesOutside": 0}
    check_equal({name: found[name] for name in counts}, counts, "counts of the raster")
    check_equal(found["NumberOfTriangulations"], 1, "triangulations")
    check_plane(raster, "a raster")
    data = servermanager.Fetch(raster)
    check_equal(data.GetClassName(), "vtkImageData", "type of the output")
    check_equal((data.GetOrigin()[:2], data.GetSpacing()[:2]), ((-1.75, -1.5), (0.5, 1.0)), "cells of the raster")
    check(raster.PointData["Height"], "the point array Height was not interpolated")
    for method in ("Natural Neighbor", "Laplace"):
        raster.Method = method
        raster.UpdatePipeline()
        check_plane(raster, method)
    check_equal(raster.NumberOfTriangulations, 1, "triangulations after a change of the method")
    raster.RasterSize, raster.CellSize, raster.AlignToCellSize = "Cell Size", [0.7, 0.7], 1
    raster.UpdatePipeline()
    data = servermanager.Fetch(raster)
    border = [data.GetOrigin()[axis] / 0.7 - 0.5 for axis in (0, 1)]
    check(all(abs(b - round(b)) < 1e-12 for b in border), "borders at %r cell sizes" % border)
    check_equal(cells(raster), (6, 6), "cells of 0.7 from -2.1 to 2.1")
    raster.UseBounds, raster.Bounds, raster.AlignToCellSize = 1, [0, 1.4, -1, 0.4], 0
    raster.UpdatePipeline()
    check_equal(cells(raster), (2, 2), "cells of the area")
    check_equal(raster.NumberOfTriangulations, 1, "triangulations after changes of the raster")


def test_a_surface():
    raster = AdaptiveHilbertInterpolation2D(Input=reader("plane.vtp", plane_points()), OutputType="Surface")
    raster.Dimensions = [5, 7]
    heights, places = values(raster)
    check_equal(servermanager.Fetch(raster).GetClassName(), "vtkStructuredGrid", "type of the output")
    check_equal([p[2] for p in places], heights, "z of the points")


def test_places_without_a_value_are_hidden():
    """A raster of a triangle: cells beside it are not drawn, and not in the range of colours."""
    points = reader("triangle.vtp", [(0, 0, 1), (4, 0, 2), (0, 4, 3)])
    raster = AdaptiveHilbertInterpolation2D(Input=points, CellSize=[1, 1])
    mask, marks = values(raster, "vtkValidPointMask")[0], values(raster, "vtkGhostType")[0]
    check_equal(marks, [0 if valid else 2 for valid in mask], "hidden points")
    check_equal(sum(mask), 10, "cells with a value")
    surface = ExtractSurface(Input=raster)
    surface.UpdatePipeline()
    check_equal(surface.GetDataInformation().GetNumberOfCells(), 3, "squares between four centres that are drawn")
    raster.Outside = "Nearest Vertex"
    raster.UpdatePipeline()
    check(not raster.PointData["vtkGhostType"], "places with a value are hidden")


def test_settings_of_the_triangulation_have_a_say():
    """A change of them alone runs the filter anew."""
    points = reader("far.vtp", plane_points() + [(9.0, 9.0, -8.0)])
    raster = AdaptiveHilbertInterpolation2D(Input=points, Dimensions=[11, 11])
    raster.UpdatePipeline()
    before = raster.NumberOfValidPlaces
    raster.MaximumEdgeLength = 3.0
    raster.UpdatePipeline()
    check(0 < raster.NumberOfValidPlaces < before, "%d valid places, %d before" % (raster.NumberOfValidPlaces, before))
    check_equal(raster.NumberOfTriangulations, 2, "triangulations")
    raster.Outside = "Nearest Vertex"
    raster.UpdatePipeline()
    heights, _ = values(raster)
    check(not any(math.isnan(h) for h in heights), "places without a value, with Nearest Vertex")


def test_places():
    points = reader("plane.vtp", plane_points())
    line = Line(Point1=[-3, 1, 0], Point2=[1, 1, 7], Resolution=8)
    profile = AdaptiveHilbertInterpolation2D(Input=points, Places=line)
    check_equal(raster_measures(profile)["NumberOfPlacesOutside"], 2, "places outside")
    check_plane(profile, "a profile", lambda x, y: x >= -2)
    check_equal(profile.GetDataInformation().GetDataSetTypeAsString(), "vtkPolyData", "type of the output")
    check_equal(profile.GetDataInformation().GetBounds()[4:], (0.0, 7.0), "heights of the line")
    profile.Places = None
    profile.UpdatePipeline()
    check_equal(profile.GetDataInformation().GetDataSetTypeAsString(), "vtkImageData", "type without places")


def test_a_surface_as_input():
    """Its own triangles count: none where it has none, whatever the settings here."""
    if IS_PYTHON:
        return  # there its points are triangulated anew
    points = reader("far.vtp", plane_points() + [(9.0, 9.0, -8.0)])
    surface = AdaptiveHilbertDelaunay2D(Input=points, MaximumEdgeLength=3.0)
    raster = AdaptiveHilbertInterpolation2D(Input=surface, Dimensions=[11, 11])
    check_plane(raster, "a raster of a surface", lambda x, y: x < 2 and y < 2)
    raster.Input = points
    raster.MaximumEdgeLength = 3.0
    check_plane(raster, "a raster of its points", lambda x, y: x < 2 and y < 2)
    check(raster_measures(raster)["NumberOfValidPlaces"] > 9, "hardly a place on the surface")


def test_constraints():
    """The corners of the square lie outside of the ring, which bounds the surface."""
    ring_points = [(x, y, 1 + 2 * x - 3 * y) for x, y, _ in ring(1.0, 4)]
    source = reader("ring.vtp", ring_points, loops=[range(4)])
    raster = AdaptiveHilbertInterpolation2D(Input=reader("plane.vtp", plane_points()), Source=source)
    set_properties(raster, Dimensions=[9, 9])
    check_plane(raster, "inside a ring", lambda x, y: abs(x) + abs(y) < 1)
    raster.Source = None
    raster.UpdatePipeline()
    check_equal(raster.NumberOfValidPlaces, 81, "valid places without the ring")


def test_what_is_shown_is_what_is_used():
    shown = {"NumberOfThreads": {5000: 1024}, "MaximumEdgeLength": {-1.0: 0.0}, "CellSize": {(-1.0, 3.0): (0.0, 3.0)},
             "Dimensions": {(1, 9): (1, 9), (9, -4): (9, 0)}}  # fmt: skip
    for name, pairs in shown.items():
        for given, kept in pairs.items():
            for made in (AdaptiveHilbertInterpolation2D(Input=Sphere(), **{name: given}), proxy):
                setattr(made, name, given)
                found = getattr(made, name)
                found = tuple(found) if isinstance(given, tuple) else found
                check_equal(found, kept, "%s, as %r was given" % (name, given))


def test_a_raster_is_suggested():
    """Unless set, the area is suggested from the points."""
    points = reader("plane.vtp", plane_points())
    points.UpdatePipeline()
    raster = AdaptiveHilbertInterpolation2D(Input=points)
    check_equal(list(raster.Bounds), [-2.0, 2.0, -2.0, 2.0], "the area that is suggested")
    given = AdaptiveHilbertInterpolation2D(Input=points, UseBounds=1)
    check_equal(list(given.Bounds), [0, 1, 0, 1], "what is used is not replaced")


def test_cells_are_squares_unless_set():
    """Chosen from the points; in scripts that set their number or size alone, these."""
    points = reader("tall.vtp", [(x, 3 * y, z) for x, y, z in plane_points()])
    raster = AdaptiveHilbertInterpolation2D(Input=points)
    check_equal((raster.RasterSize, cells(raster)), ("Cell Size", (200, 600)), "cells of 0.02")
    before = AdaptiveHilbertInterpolation2D(Input=points, Dimensions=[7, 9])
    raster.Dimensions = [7, 9]
    for made in (before, raster):
        check_equal((made.RasterSize, cells(made)), ("Dimensions", (7, 9)), "with dimensions")
    raster.RasterSize = "Cell Size"
    check_equal(cells(raster), (200, 600), "cells as at first")
    raster.CellSize = [1, 1]
    check_equal(cells(raster), (4, 12), "cells of 1")
    raster.Dimensions = [8, 9]
    check_equal((raster.RasterSize, cells(raster)), ("Cell Size", (4, 12)), "with both")
    raster.RasterSize = "Dimensions"
    check_equal(cells(raster), (8, 9), "with both, by dimensions")


def test_circles_are_refused():
    """However long; and nothing else is."""
    raster, other = AdaptiveHilbertInterpolation2D(Input=Sphere()), Line()
    for name in ("Places", "Source"):
        for made in (raster, Clip(Input=raster), Calculator(Input=Clip(Input=raster))):
            setattr(raster, name, other)
            check(getattr(raster, name).SMProxy is other.SMProxy, "%s that are no circle were not taken" % name)
            setattr(raster, name, made)
            check(getattr(raster, name) is None, "%s made of the raster were taken" % name)
        raster.UpdatePipeline()
        check(raster.GetDataInformation().GetNumberOfPoints() > 0, "without %s there is no raster" % name)
    sphere = Sphere()
    raster = AdaptiveHilbertInterpolation2D(Input=sphere, Dimensions=[8, 8])
    before = str(values(raster))  # some are NaN
    for own in (Clip(Input=raster), raster):
        raster.Input = own
        check(raster.Input is None, "an input made of the raster was taken")
        raster.Input = sphere
        check_equal(str(values(raster)), before, "the raster after that")


def test_states():
    of_triangulation = [name for name in OF_TRIANGULATION if name in TABLE["delaunay"]["settings"]]
    settings = {**others("interpolation", RASTER_SETTINGS), **others("delaunay", of_triangulation)}
    ResetSession()
    points = XMLPolyDataReader(registrationName="points", FileName=[write_vtp("plane.vtp", plane_points())])
    line = Line(registrationName="line")
    sized = {"RasterSize": "Cell Size", "CellSize": [0.5, 0.25], "UseBounds": 1, "Bounds": [-1.0, 1.0, -1.5, 1.0]}
    AdaptiveHilbertInterpolation2D(registrationName="raster", Input=points, **sized)
    AdaptiveHilbertInterpolation2D(registrationName="others", Input=points, **settings)
    AdaptiveHilbertInterpolation2D(registrationName="profile", Input=points, Places=line).UpdatePipeline()
    SaveState(scratch("raster.pvsm"))
    script = smstate.get_state(filter=smstate.supported_proxies())
    for how in ("XML", "Python"):
        ResetSession()
        check(not FindSource("raster"), "ResetSession left the filter behind, so this test would prove nothing")
        LoadState(scratch("raster.pvsm")) if how == "XML" else exec(compile(script, "state", "exec"), {})
        raster, profile = FindSource("raster"), FindSource("profile")
        for name, value in settings.items():
            found = getattr(FindSource("others"), name)
            check_equal(list(found) if isinstance(value, list) else found, value, "%s state: %s" % (how, name))
        check_equal(profile.Places.SMProxy.GetXMLName(), line.SMProxy.GetXMLName(), how + " state: the places")
        raster.UpdatePipeline()
        check_equal(cells(raster), (4, 10), how + " state: the raster")


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
