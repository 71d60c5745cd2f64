# SPDX-License-Identifier: BSD-3-Clause
"""The filter in ParaView: its place in the menu, the names and documentation of its properties, and that their defaults
are those of the C++ class."""

import re

from paraview.simple import *
from paraview import servermanager
from paraview.modules.vtkRemotingServerManager import vtkSMPropertyHelper
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())
proxy = AdaptiveHilbertDelaunay2D(Input=Sphere())
sm = proxy.SMProxy


#: The filters of the menu that are outputs of the class: label, output, and name in Python.
MENU = {
    "Delaunay2DAdaptiveHilbert": ("Delaunay 2D (Adaptive Hilbert)", "Surface"),
    "VoronoiAdaptiveHilbert": ("Voronoi Cells 2D (Adaptive Hilbert)", "Voronoi"),
    "InsertionOrderAdaptiveHilbert": ("Insertion Order 2D (Adaptive Hilbert)", "Insertion order"),
}


def made(label, **settings):
    """A filter by its label, as in a script."""
    return globals()[re.sub(r"\W", "", label)](**settings)


def test_menu():
    """A filter for each output, found beside Delaunay 2D; and one with all, for states and scripts, in no menu."""
    check_equal(sm.GetXMLLabel(), "Adaptive Hilbert Delaunay 2D", "label of the filter with all outputs")
    check_equal(sm.GetVTKClassName(), class_in_paraview("AdaptiveHilbertDelaunay2D"), "class of the filter")
    check(sm.GetHints().FindNestedElementByName("ReaderFactory"), "the filter with all outputs is in the menu, too")
    for name, (label, output) in MENU.items():
        one = made(label, Input=Sphere()).SMProxy
        check_equal((one.GetXMLName(), one.GetXMLLabel()), (name, label), "name and label")
        menu = one.GetHints().FindNestedElementByName("ShowInMenu")
        check_equal(menu.GetAttribute("category"), "Adaptive Hilbert", "category in the Filters menu")
        check_icon(menu.GetAttribute("icon"), label)
        check_equal((one.GetNumberOfOutputPorts(), one.GetOutputPortName(0)), (1, output), "outputs of " + label)


def check_icon(path, label):
    """A file beside the plugin in Python, a resource of the compiled one, whose folder of icons has it."""
    folder = pathlib.Path(__file__).resolve().parents[2] / "Plugin" / "Icons"
    check(path.endswith(".svg") and (folder / os.path.basename(path)).exists(), label + " has no icon")
    check(os.path.exists(path) if IS_PYTHON else path.startswith(":/AdaptiveHilbertDelaunay/"), "icon " + path)
    check(os.path.basename(path) in (folder / "icons.qrc").read_text(encoding="utf-8"), path + " is no resource")


def test_filters_of_outputs():
    """Each has what that output of the class has, with the measures, and nothing where there is no input any more."""
    points = XMLPolyDataReader(FileName=[write_vtp("outputs.vtp", hill_points())])
    settings = {"GenerateInsertionCurve": 1, "GenerateBoxes": 1, "InsertionOrder": "Multi-grid"}
    whole = AdaptiveHilbertDelaunay2D(Input=points, GenerateVoronoi=1, VoronoiClip="Bounds", **settings)
    given = {"Voronoi": {"VoronoiClip": "Bounds"}, "Insertion order": {**settings, "GenerateInsertionCurve": 1}}
    cells = {"Surface": measures(whole)["NumberOfTriangles"], "Voronoi": 393, "Insertion order": 65}
    for label, output in MENU.values():
        one = made(label, Input=points, **given.get(output, {}))
        port = {"Surface": 0, "Insertion order": 1, "Voronoi": 2}[output]
        for what in (one, OutputPort(whole, port)):
            what.UpdatePipeline()
        found, expected = (
            of.GetClientSideObject().GetOutputDataObject(k) for of, k in ((one, 0), (whole, port)))
        check_equal(found.GetNumberOfCells(), cells[output], "cells of " + label)
        check(contents(found) == contents(expected), label + " differs from that output of the class")
        check(Show(one), "ParaView does not show " + label)
        check_equal((one.NumberOfDuplicates, one.Measures), (7, whole.Measures), "measures of " + label)
    check_equal(rows_of_panel(made("Voronoi Cells 2D (Adaptive Hilbert)", Input=points).SMProxy),
                ["Measures", "VoronoiClip"], "rows of the panel")


def contents(data):
    """Cells, points and the names of arrays."""
    cells = [[data.GetCell(k).GetPointId(i) for i in range(data.GetCell(k).GetNumberOfPoints())]
             for k in range(data.GetNumberOfCells())]
    names = [[each.GetArrayName(k) for k in range(each.GetNumberOfArrays())]
             for each in (data.GetPointData(), data.GetCellData())]
    return cells, [data.GetPoint(k) for k in range(data.GetNumberOfPoints())], names


def test_properties_are_complete():
    expected = set(SETTINGS + MEASURES + TEXTS + ["Input", "Source", "Transform", "GenerateFate"] + HIDDEN)
    check_equal(set(properties(sm)), expected, "properties of the filter")
    for name in MEASURES + TEXTS:
        check(sm.GetProperty(name).GetInformationOnly(), name + " can be changed, but is a measure")


def test_names_are_the_same_everywhere():
    """paraview.simple derives the Python name from the label; it must be the name in C++."""
    for name, item in properties(sm).items():
        check_equal(item.GetXMLLabel().replace(" ", ""), name, "label of %s, without spaces" % name)
        check(hasattr(proxy, name) or name in HIDDEN, "paraview.simple does not know the property " + name)


def test_everything_is_documented():
    documentation = sm.GetDocumentation()
    check(len(documentation.GetShortHelp() or "") > 40, "short help of the filter is missing")
    check(len(documentation.GetLongHelp() or "") > 80, "long help of the filter is missing")
    check("When to change" in documentation.GetDescription(), "the help does not say when to change a setting")
    for name, item in properties(sm).items():
        text = item.GetDocumentation().GetDescription() if item.GetDocumentation() else ""
        check(len(text) > 30, "the property %s is not documented" % name)
        check(text.rstrip().endswith("."), "the documentation of %s stops in the middle: %r" % (name, text[-40:]))


def test_everything_is_in_the_panel():
    """information_only hides a property unless its visibility is set; only those without effect and the old name of one
    may be hidden."""
    for name, item in properties(sm).items():
        hidden = name in ["RandomPointInsertion", "UseHilbertSorter", "GenerateFate"] + HIDDEN
        check(
            item.GetPanelVisibility() in (("never",) if hidden else ("default", "advanced")),
            "%s has panel_visibility %r" % (name, item.GetPanelVisibility()),
        )


def test_the_panel_is_short():
    """What most users need, in one look; of constraints only the source."""
    surface = made("Delaunay 2D (Adaptive Hilbert)", Input=Sphere()).SMProxy
    check_equal(rows_of_panel(surface), [
        "Alpha", "DuplicatePolicy", "MaximumEdgeLength", "Measures", "ProjectionPlaneMode", "Source", "Tolerance"],
        "rows without a source")
    bounded = made("Delaunay 2D (Adaptive Hilbert)", Input=Sphere(), Source=Sphere())
    more = set(rows_of_panel(bounded.SMProxy)) - set(rows_of_panel(surface))
    check({"SourceMode", "SourceHeights", "ClosedLines", "FillRule", "CrossingMode"} <= more,
          "rows of a source: %r" % more)
    raster = rows_of_panel(AdaptiveHilbertInterpolation2D(Input=Sphere()).SMProxy)
    check(len(raster) <= 12 and "Method" in raster, "rows of the interpolation: %r" % raster)


def test_choices():
    expected = {
        "InsertionOrder": ["Adaptive Hilbert", "Multi-grid", "Regular grid", "As given"],
        "ControlPoints": ["Off", "First level", "Every level"],
        "SourceMode": ["Point ids", "Coordinates"],
        "CrossingMode": ["Leave out", "Split"],
        "FillRule": ["Orientation", "Even-odd"],
        "ClosedLines": ["Lines", "Loops"],
        "SourceHeights": ["Own", "From Surface", "Mixed"],
        "ProjectionPlaneMode": ["XY Plane", "Transform Plane", "Best-Fitting Plane"],
        "DuplicatePolicy": ["First", "Lowest z", "Highest z", "Mean z"],
        "VoronoiClip": ["Hull", "Bounds", "Polygon"],
        "Rim": ["Automatic", "Convex Hull", "Trimmed"],
    }
    for name, texts in expected.items():
        check_equal(choices(sm, name), dict(enumerate(texts)), "choices of " + name)
    check_equal(with_choices(sm), set(expected), "properties with choices")


def test_it_has_what_delaunay_2d_has():
    """Scripts and state files of ParaView's own filter mean the same here."""
    own = servermanager.ProxyManager().GetPrototypeProxy("filters", "Delaunay2D")
    iterator = own.NewPropertyIterator()
    iterator.Begin()
    names = set()
    while not iterator.IsAtEnd():
        name, theirs, ours = iterator.GetKey(), iterator.GetProperty(), sm.GetProperty(iterator.GetKey())
        names.add(name)
        check(ours, "Delaunay 2D has a property that is not there: " + name)
        check_equal(ours.GetClassName(), theirs.GetClassName(), "kind of property of " + name)
        check_equal(ours.GetAnimateable(), theirs.GetAnimateable(), "whether %s can be animated" % name)
        iterator.Next()
    check({"Alpha", "Tolerance", "Offset", "ProjectionPlaneMode"} <= names, "Delaunay 2D has only %r" % names)
    modes = choices(own, "ProjectionPlaneMode")
    check(modes.items() <= choices(sm, "ProjectionPlaneMode").items(), "planes of Delaunay 2D: %r" % modes)


def test_the_source_is_optional():
    source = sm.GetProperty("Source")
    check(source.GetHints().FindNestedElementByName("Optional"), "creating the filter asks for a source")
    check_equal(source.GetNumberOfProxies(), 0, "sources at the beginning")
    domain = source.FindDomain("vtkSMDataTypeDomain")
    for other, accepted in ((Sphere(), True), (Wavelet(), False), (UnstructuredCellTypes(), False)):
        other.UpdatePipeline()
        check_equal(bool(domain.IsInDomain(other.SMProxy, 0)), accepted, "is %s a source" % other.GetXMLName())


def test_the_transform_is_none_at_first():
    check_equal(proxy.Transform.GetXMLLabel(), "None", "Transform at the beginning")
    check(not proxy.Transform.GetVTKClassName(), "the Transform None is something")


def test_ranges():
    ranges = {"Nmax": 1, "InsertionLimit": 0, "MemoryLimit": 0, "NumberOfThreads": 0, "ReuseLimit": 0}
    for name, least in ranges.items():
        domain = sm.GetProperty(name).FindDomain("vtkSMIntRangeDomain")
        check(domain and domain.GetMinimumExists(0), name + " has no minimum")
        check_equal(domain.GetMinimum(0), least, "minimum of " + name)
    for name, least in {"Alpha": 0.0, "MaximumEdgeLength": 0.0, "Tolerance": 0.0, "Offset": 0.75}.items():
        domain = sm.GetProperty(name).FindDomain("vtkSMDoubleRangeDomain")
        check(domain and domain.GetMinimumExists(0), name + " has no minimum")
        check_equal(domain.GetMinimum(0), least, "minimum of " + name)
    tolerance = sm.GetProperty("Tolerance").FindDomain("vtkSMDoubleRangeDomain")
    check(tolerance.GetMaximumExists(0) and tolerance.GetMaximum(0) == 1.0, "Tolerance has no maximum")


def test_what_is_shown_is_what_is_used():
    """Numbers out of range become the nearest in it, as in the class."""
    shown = {
        "Nmax": {0: 1, -5: 1, 70: 70},
        "Tolerance": {5.0: 1.0, -1.0: 0.0, 0.5: 0.5},
        "Alpha": {-1.0: 0.0, 7.0: 7.0},
        "MaximumEdgeLength": {-1.0: 0.0},
        "Offset": {0.5: 0.75, 3.0: 3.0},
        "NumberOfThreads": {5000: 1024, -1: 0, 4: 4},
        "MemoryLimit": {-1: 0},
        "ReuseLimit": {-1: 0},
    }
    for name, values in shown.items():
        for given, kept in values.items():
            set_later = AdaptiveHilbertDelaunay2D(Input=Sphere())
            setattr(set_later, name, given)
            check_equal(getattr(set_later, name), kept, "%s, as %r was given" % (name, given))
            set_first = AdaptiveHilbertDelaunay2D(Input=Sphere(), **{name: given})
            check_equal(getattr(set_first, name), kept, "%s, as it was made with %r" % (name, given))
    updated = Sphere()
    updated.UpdatePipeline()
    for name in ("InsertionLimit", "MaximumNumberOfVertices"):
        check_equal(getattr(AdaptiveHilbertDelaunay2D(Input=updated), name), 0, name + ", which nobody set")
        for given in (0, 1, 2, 10**6):
            for points in (Sphere(), updated):
                limited = AdaptiveHilbertDelaunay2D(Input=points, **{name: given})
                check_equal(getattr(limited, name), given, name + ", which may be more than its slider shows")


def enumerations(item):
    """The names of the settings of a proxy that are chosen from a list, with the least and the largest value."""
    domains = {name: p.FindDomain("vtkSMEnumerationDomain") for name, p in properties(item).items()}
    values = {name: [d.GetEntryValue(i) for i in range(d.GetNumberOfEntries())] for name, d in domains.items() if d}
    return {name: (min(found), max(found)) for name, found in values.items() if found}


def number(made, name):
    return vtkSMPropertyHelper(made.SMProxy, name).GetAsInt()


def makers():
    return (lambda: AdaptiveHilbertDelaunay2D(Input=Sphere()), lambda: AdaptiveHilbertInterpolation2D(Input=Sphere()),
            PlanarPointSource)


def test_what_is_shown_of_lists_is_what_is_used():
    """Numbers without a meaning become the nearest with one, as in the classes."""
    for make, count in zip(makers(), (11, 4, 2)):
        lists = enumerations(make().SMProxy)
        check(len(lists) >= count, "%d lists, and there are %d" % (len(lists), count))
        for name, (least, most) in lists.items():
            for given, kept in ((99, most), (-7, least), (most, most)):
                made = make()
                setattr(made, name, given)
                check_equal(number(made, name), kept, "%s, as %d was given" % (name, given))
                engine = made.GetClientSideObject()
                if hasattr(engine, "Get" + name):
                    made.UpdateVTKObjects()
                    check_equal(getattr(engine, "Get" + name)(), kept, name + " in the class")


def test_what_is_shown_of_lists_in_a_state():
    ResetSession()
    made = AdaptiveHilbertDelaunay2D(registrationName="listed", Input=Sphere(), Rim=2, InsertionOrder=1)
    PlanarPointSource(registrationName="drawn", Distribution=3)
    made.UpdatePipeline()
    SaveState(scratch("lists.pvsm"))
    with open(scratch("lists.pvsm"), encoding="utf-8") as file:
        state = file.read()
    for name, value in (("Rim", 2), ("InsertionOrder", 1), ("Distribution", 3)):
        state, changed = re.subn(
            r'(<Property name="%s"[^>]*>\s*<Element index="0" value=)"%d"' % (name, value), r'\1"99"', state)
        check_equal(changed, 1, "places of %s in the state" % name)
    with open(scratch("lists.pvsm"), "w", encoding="utf-8") as file:
        file.write(state)
    ResetSession()
    LoadState(scratch("lists.pvsm"))
    listed, drawn = FindSource("listed"), FindSource("drawn")
    check_equal((number(listed, "Rim"), number(listed, "InsertionOrder"), number(drawn, "Distribution")), (2, 3, 6),
                "what the state says of lists")


def test_measures_are_texts():
    for name in MEASURES:
        check("visibility" in [one.GetAttribute("mode") for one in nested(sm.GetProperty(name).GetHints())],
              name + " is in the panel by itself, too")
    for name in TEXTS:
        hints = nested(sm.GetProperty(name).GetHints())
        check_equal([one.GetAttribute("type") for one in hints], ["multi_line", "GenericDecorator"], "hints of " + name)
        check_equal(hints[1].GetAttribute("mode"), "enabled_state", "what ends that %s can be edited" % name)
    points = XMLPolyDataReader(FileName=[write_vtp("texts.vtp", hill_points(3007))])
    surface = AdaptiveHilbertDelaunay2D(Input=points)
    check_equal(surface.Measures, "", "the text before a run")
    found = measures(surface)
    check_equal(surface.Measures, "{:,} triangles\n3,000 points in the surface\n7 duplicates left out".format(
        found["NumberOfTriangles"]), "the text")
    check("s to insert\n" in surface.Resources and surface.Resources.endswith(" KiB of memory at most"),
          "the text of resources: %r" % surface.Resources)


def test_units_are_beside_the_numbers():
    panel = {}
    for i in range(sm.GetNumberOfPropertyGroups()):
        group = sm.GetPropertyGroup(i)
        for k in range(group.GetNumberOfProperties()):
            panel[group.GetProperty(k).GetXMLName()] = group.GetXMLLabel()
    for name in ("MemoryLimit", "ReuseLimit"):
        check("KiB" in panel[name], "the heading above %s is %r" % (name, panel[name]))
    check("Threads" in panel["NumberOfThreads"], "the heading above NumberOfThreads")


def test_the_voronoi_diagram_does_not_cover_the_surface():
    views = [hint for hint in nested(sm.GetHints()) if hint.GetName() == "View"]
    check_equal([(v.GetAttribute("port"), v.GetAttribute("type")) for v in views], [("2", "None")], "views")


def test_the_limit_goes_up_to_the_number_of_points():
    """A range with both ends is shown as a slider, and is the default of animations."""
    reader = XMLPolyDataReader(FileName=[write_vtp("limit.vtp", hill_points(300))])
    limited = AdaptiveHilbertDelaunay2D(Input=reader)
    item = limited.SMProxy.GetProperty("InsertionLimit")
    domain = item.FindDomain("vtkSMIntRangeDomain")
    reader.UpdatePipeline()
    check_equal((domain.GetMinimum(0), domain.GetMaximum(0)), (3, 300), "range of InsertionLimit")
    check(domain.GetMinimumExists(0) and domain.GetMaximumExists(0), "the range of InsertionLimit is open")
    limited.Input = Plane(XResolution=1, YResolution=2)
    limited.UpdatePipeline()
    check_equal((domain.GetMinimum(0), domain.GetMaximum(0)), (3, 6), "range with another input")
    check_equal(limited.InsertionLimit, 0, "InsertionLimit, which the range must not change")
    check(item.GetAnimateable(), "InsertionLimit cannot be animated")


def test_generate_fate_is_the_old_name_of_generate_point_status():
    points = XMLPolyDataReader(FileName=[write_vtp("names.vtp", hill_points(30))])
    for first, second in (("GenerateFate", "GeneratePointStatus"), ("GeneratePointStatus", "GenerateFate")):
        surface = AdaptiveHilbertDelaunay2D(Input=points, **{first: 1})
        check_equal(getattr(surface, second), 1, "%s, as %s was given" % (second, first))
        surface.UpdatePipeline()
        check(surface.PointData["Fate"], "no point status, though %s was given" % first)
        setattr(surface, first, 0)
        check_equal(getattr(surface, second), 0, "%s, as %s was switched off" % (second, first))
        surface.UpdatePipeline()
        check(not surface.PointData["Fate"], "point status, though %s was switched off" % first)
        setattr(surface, second, 1)
        check_equal(getattr(surface, first), 1, "%s, as %s was switched on" % (first, second))
        surface.UpdatePipeline()
        check(surface.PointData["Fate"], "no point status, though %s was switched on" % second)


def test_outputs():
    check_equal(sm.GetNumberOfOutputPorts(), 3, "number of outputs")
    names = [sm.GetOutputPortName(i) for i in range(3)]
    check_equal(names, ["Surface", "Insertion order", "Voronoi"], "names of the outputs")


def vtk_class():
    """The C++ class, if its Python wrapping was built."""
    try:
        from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D
    except ImportError:
        return None
    return vtkAdaptiveHilbertDelaunay2D


def own_methods(cls, prefix):
    """The rest after the prefix of the names of methods that neither vtkPolyDataAlgorithm nor VTK's superclass in
    Python has, without choices (SetXToY)."""
    bases = [c for c in cls.__mro__ if c.__name__ == "VTKPythonAlgorithmBase"] + [vtkPolyDataAlgorithm]
    names = {m[len(prefix) :] for m in dir(cls) if m.startswith(prefix) and not any(hasattr(b, m) for b in bases)}
    return {n for n in names if not re.search(r"(To[A-Z]|MinValue$|MaxValue$)", n)}


def test_defaults_and_names_are_those_of_the_class():
    cls = vtk_class()
    if cls is None:
        check(not EXPECT_PYTHON, "the package adaptivehilbertdelaunay cannot be imported")
        return
    setters = set(SETTINGS + ["SourceData", "SourceConnection", "Transform", "Controller", "GenerateFate"])
    getters = set(SETTINGS + MEASURES + TEXTS + ["Source", "Transform", "Controller", "GenerateFate"])
    check_equal(own_methods(cls, "Set"), setters, "settings of the class")
    check_equal(own_methods(cls, "Get"), getters, "values of the class")
    fresh = cls()
    # VTK's default is the ids, for old programs; a source picked in the panel has coordinates.
    check_equal((proxy.SourceMode, fresh.GetSourceMode()), ("Coordinates", 0), "the defaults of SourceMode")
    # and vtkDelaunay2D's rule, where most outlines that people have run the other way
    check_equal((proxy.FillRule, fresh.GetFillRule()), ("Even-odd", 0), "the defaults of FillRule")
    # and a program that updates on one rank alone must not wait for the others
    check_equal((proxy.DistributePoints, fresh.GetDistributePoints()), (1, False), "the defaults of DistributePoints")
    for name in set(SETTINGS + MEASURES) - {"SourceMode", "FillRule", "DistributePoints"}:
        shown, given = servermanager.vtkSMPropertyHelper(sm, name), getattr(fresh, "Get" + name)()
        given = "None" if name.endswith("ArrayName") else given  # what the list of arrays has for none
        shown = shown.GetAsString() if isinstance(given, str) else shown.GetAsDouble()
        check_equal(shown, given if isinstance(given, str) else float(given), "default of " + name)


EXPECT_PYTHON = os.environ.get("AHD_EXPECT_PYTHON") == "1"

for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
