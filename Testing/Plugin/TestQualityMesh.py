# SPDX-License-Identifier: BSD-3-Clause
"""The quality mesh in ParaView: in the menu, its panel, both outputs, sizes by an array, what it refuses."""

from paraview import servermanager
from paraview.simple import *

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())

OWN = names_of("quality", "settings", lambda row: True)
MADE = names_of("quality", "measures", lambda row: True)
WITHIN = TABLE["quality"]["exposed"]


def reader(name, points, **cells):
    return XMLPolyDataReader(FileName=write_vtp(name, points, **cells))


def plate(**settings):
    """A ring of 16 corners with a hole of 8, and a line from the one to the other."""
    points = [(x, y, 1 + 2 * x - 3 * y) for x, y, _ in ring(2.0, 16) + ring(0.5, 8)]
    source = reader("plate.vtp", points, loops=[range(16), range(16, 24)], lines=[(0, 16)])
    given = reader("inside.vtp", [(0.0, 1.0, -2.0), (9.0, 9.0, 0.0)])
    return AdaptiveHilbertQualityMesh2D(Input=given, Source=source, SourceMode="Coordinates", **settings)


def data_of(made, port):
    made.UpdatePipeline()
    return servermanager.Fetch(made, idx=port)


def numbers(data, name):
    array = data.GetArray(name)
    return [array.GetTuple1(k) for k in range(array.GetNumberOfTuples())]


def test_menu_help_and_panel():
    made = AdaptiveHilbertQualityMesh2D(Input=Sphere())
    sm = made.SMProxy
    check_equal((sm.GetXMLGroup(), sm.GetXMLLabel()), ("filters", "Adaptive Hilbert Quality Mesh 2D"), "label")
    check_equal(sm.GetVTKClassName(), class_in_paraview("AdaptiveHilbertQualityMesh2D"), "class")
    menu = sm.GetHints().FindNestedElementByName("ShowInMenu")
    check_equal(menu.GetAttribute("category"), "Adaptive Hilbert", "menu")
    texts = list(TABLE["quality"]["texts"])
    check_equal(set(made.ListProperties()), set(OWN + MADE + WITHIN + texts + ["Input", "Source"]), "properties")
    defaults = made.MinimumAngle, made.SizeArrayName, made.MaximumNumberOfAddedPoints
    check_equal(defaults, (20.0, "None", -1), "defaults")
    rows = ["MaximumArea", "MaximumLength", "Measures", "MinimumAngle", "SizeArrayName", "Source"]
    check_equal(rows_of_panel(sm), rows, "rows of the panel")
    for name, item in properties(sm).items():
        text = item.GetDocumentation().GetDescription() if item.GetDocumentation() else ""
        check(len(text) > 30, "the property %s is not documented" % name)


def test_a_plate():
    made = plate(MinimumAngle=30, MaximumArea=0.05)
    mesh, segments = data_of(made, 0), data_of(made, 1)
    cells, points = mesh.GetCellData(), mesh.GetPointData()
    check(made.LeastAngle >= 30 - 1e-9, "an angle of %g" % made.LeastAngle)
    check_equal((made.NumberOfBadTriangles, set(numbers(cells, "BadReason"))), (0, {-1.0}), "bad triangles")
    check_equal(made.NumberOfTriangles, mesh.GetNumberOfCells(), "triangles")
    check_equal(mesh.GetNumberOfPoints(), 2 + 24 + made.NumberOfAddedPoints, "points")
    check("triangles" in made.Measures and "degrees" in made.Measures, "measures: %r" % made.Measures)
    ids = numbers(points, "OriginalPointIds")
    check_equal((ids[:2], set(ids[2:])), ([0.0, 1.0], {-1.0}), "ids")
    heights = numbers(points, "Height")
    for k in range(2, mesh.GetNumberOfPoints()):
        x, y, z = mesh.GetPoint(k)
        check(abs(z - (1 + 2 * x - 3 * y)) < 1e-12 and abs(heights[k] - z) < 1e-12, "height of point %d" % k)
    of, bounds = numbers(segments.GetCellData(), "SourceCell"), numbers(segments.GetCellData(), "IsBoundary")
    check_equal(set(zip(of, bounds)), {(0.0, 0.0), (1.0, 1.0), (2.0, 1.0)}, "segments")
    check_equal(segments.GetNumberOfPoints(), mesh.GetNumberOfPoints(), "points of the segments")


def test_a_size_array():
    coarse = plate(MinimumAngle=20)
    fine = Calculator(Input=reader("sized.vtp", [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]), ResultArrayName="Size",
                      Function="0.1 + 0.2*coordsX")
    made = AdaptiveHilbertQualityMesh2D(Input=fine)
    made.UpdatePipeline()
    check_equal(sorted(made.GetProperty("SizeArrayName").Available), ["Height", "None", "Size"], "arrays to choose")
    few = data_of(made, 0).GetNumberOfCells()
    made.SizeArrayName = "Size"
    many = data_of(made, 0).GetNumberOfCells()
    check(few == 2 and many > 200, "%d triangles without sizes, %d with" % (few, many))
    check(data_of(coarse, 0).GetNumberOfCells() > 24, "hardly a triangle")


def test_what_is_shown_is_what_is_used():
    shown = ("MinimumAngle", 50.0, 34.0), ("MaximumArea", -1.0, 0.0), ("NumberOfThreads", 5000, 1024)
    for name, given, kept in shown:
        made = AdaptiveHilbertQualityMesh2D(Input=Sphere(), **{name: given})
        check_equal(getattr(made, name), kept, name)


def test_a_state():
    """All settings, those of the triangulation too, and a filter behind the second output."""
    ResetSession()
    given = dict(others("quality", OWN), MaximumArea=0.5, SizeArrayName="Height", Tolerance=0.001, CrossingMode="Split")
    points = [(x, y, 1.0) for x, y, _ in ring(2.0)]  # heights that are sizes
    made = AdaptiveHilbertQualityMesh2D(registrationName="mesh", Input=reader("state.vtp", points), **given)
    behind = Threshold(registrationName="behind", Input=OutputPort(made, 1), Scalars=["CELLS", "IsBoundary"])
    behind.LowerThreshold = behind.UpperThreshold = 1
    behind.UpdatePipeline()
    cells = behind.GetDataInformation().GetNumberOfCells()
    check(cells >= 8, "%d edges" % cells)
    SaveState(scratch("mesh.pvsm"))
    ResetSession()
    LoadState(scratch("mesh.pvsm"))
    for name, value in given.items():
        check_equal(getattr(FindSource("mesh"), name), value, name)
    behind = FindSource("behind")
    behind.UpdatePipeline()
    check_equal(behind.GetDataInformation().GetNumberOfCells(), cells, "edges of the state")


def test_a_limit_on_points():
    made = plate(MinimumAngle=30, MaximumArea=0.01, MaximumNumberOfAddedPoints=10)
    reasons = numbers(data_of(made, 0).GetCellData(), "BadReason")
    check_equal((made.NumberOfAddedPoints, set(reasons)), (10, {-1.0, 1.0}), "added points and reasons")


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
