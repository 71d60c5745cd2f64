# SPDX-License-Identifier: BSD-3-Clause
"""A state file, XML or Python, brings the pipeline and its settings back."""

import re

from paraview.simple import *
from paraview import smstate

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())

INSERTION = {
    "InsertionOrder": "Multi-grid",
    "Nmax": 123,
    "ControlPoints": "First level",
    "GeneRotation": 0,
    "CountWork": 1,
    "GeneratePointStatus": 1,
    "InsertionLimit": 200,
    "GenerateInsertionRank": 1,
    "GenerateInsertionCurve": 1,
    "GenerateBoxes": 1,
    "MemoryLimit": 4000000,
    "NumberOfThreads": 3,
    "ReuseLimit": 1000,
}
# They do nothing and are not in the panel; ParaView's Python states leave such properties out.
NOTHING = {"RandomPointInsertion", "UseHilbertSorter"}


OTHERS = others("delaunay", [name for name in SETTINGS if name not in {*INSERTION, *NOTHING}])


def build():
    """The hill stopped halfway, the hill with a hole, and a filter with all other settings changed. Returns
    the triangles of the first two."""
    hill = XMLPolyDataReader(registrationName="hill", FileName=[write_vtp("state.vtp", hill_points())])
    hole = write_vtp("hole.vtp", ring(1.0, clockwise=True), loops=[range(8)])
    hole = XMLPolyDataReader(registrationName="hole", FileName=[hole])
    surface = AdaptiveHilbertDelaunay2D(registrationName="surface", Input=hill, **INSERTION)
    # A filter on the second output, so that the state must name the port.
    Outline(registrationName="outline", Input=OutputPort(surface, 1)).UpdatePipeline()
    crater = AdaptiveHilbertDelaunay2D(registrationName="crater", Input=hill, Source=hole)
    others = AdaptiveHilbertDelaunay2D(registrationName="others", Input=hill, **OTHERS)
    others.Transform = "Transform"
    others.Transform.Rotate = [-90, 0, 10]
    return fingerprint(surface), fingerprint(crater)


def check_settings(name, values, how):
    proxy = FindSource(name)
    check(proxy, "%s: the filter %s is not there" % (how, name))
    check_equal(proxy.SMProxy.GetXMLName(), "AdaptiveHilbertDelaunay2D", how + ": the filter's type")
    check_equal(proxy.Input.SMProxy.GetXMLName(), "XMLPolyDataReader", how + ": the filter's input")
    for key, value in values.items():
        check_equal(getattr(proxy, key), value, "%s: %s" % (how, key))
    return proxy


def check_restored(expected, how):
    surface = check_settings("surface", INSERTION, how)
    check(surface.Source is None, how + ": there is a source that nobody set")
    check_equal(fingerprint(surface), expected[0], how + ": the triangles")
    found = measures(surface)
    check_equal(found["NumberOfDuplicates"], 7, how + ": duplicates")
    check_equal(found["NumberOfPointsBeyondLimit"], 193, how + ": points beyond the limit")
    outline = FindSource("outline")
    check_equal(outline.Input.Port, 1, how + ": the output the outline is of")
    check(surface[1].GetDataInformation().GetNumberOfCells() > 1, how + ": no boxes in the second output")
    crater = check_settings("crater", {"SourceMode": "Coordinates"}, how)
    check_equal(os.path.basename(crater.Source.FileName[0]), "hole.vtp", how + ": the source")
    check_equal(fingerprint(crater), expected[1], how + ": the triangles of the surface with a hole")
    others = check_settings("others", OTHERS, how)
    check_equal(list(others.Transform.Rotate), [-90, 0, 10], how + ": the rotation")


def test_states():
    expected = build()
    SaveState(scratch("state.pvsm"))
    python_state = smstate.get_state(filter=smstate.supported_proxies())
    check("GenerateFate" not in python_state, "the Python state has the old name of GeneratePointStatus too")
    with open(scratch("state.py"), "w") as file:
        file.write(python_state)

    ResetSession()
    check(not FindSource("surface"), "ResetSession left the filter behind, so this test would prove nothing")
    LoadState(scratch("state.pvsm"))
    check_restored(expected, "XML state")

    ResetSession()
    exec(compile(python_state, scratch("state.py"), "exec"), {})
    check_restored(expected, "Python state")


def test_a_state_with_the_old_name():
    """States had GenerateFate before it was called GeneratePointStatus."""
    ResetSession()
    expected = build()
    SaveState(scratch("names.pvsm"))
    with open(scratch("names.pvsm")) as file:
        state = file.read()
    old, found = re.subn(r'<Property name="GeneratePointStatus".*?</Property>', "", state, flags=re.DOTALL)
    check_equal(found, 3, "filters in the state")
    with open(scratch("before.pvsm"), "w") as file:
        file.write(old)
    ResetSession()
    LoadState(scratch("before.pvsm"))
    check_restored(expected, "a state with the old name")
    check(FindSource("surface").PointData["Fate"], "the old name in a state switched nothing on")


def test_dimensions_that_are_not_used():
    """They were given once, and then chosen cells after all."""
    ResetSession()
    reader = XMLPolyDataReader(FileName=[write_vtp("dimensions.vtp", [(0, 0, 0), (4, 0, 1), (0, 6, 2)])])
    raster = AdaptiveHilbertInterpolation2D(registrationName="raster", Input=reader, Dimensions=[7, 9])
    for wanted in ("Dimensions", "Cell Size"):
        raster.RasterSize = wanted
        SaveState(scratch("dimensions.pvsm"))
        ResetSession()
        LoadState(scratch("dimensions.pvsm"))
        raster = FindSource("raster")
        check_equal((raster.RasterSize, list(raster.Dimensions)), (wanted, [7, 9]), "the raster of the state")


def test_a_state_with_delaunay_2d():
    """A state of ParaView's own filter, with nothing changed in it but the filter's name."""
    ResetSession()
    hill = XMLPolyDataReader(registrationName="hill", FileName=[write_vtp("old.vtp", hill_points())])
    old = Delaunay2D(registrationName="old", Input=hill)
    values = {"ProjectionPlaneMode": "Best-Fitting Plane", "Alpha": 5.0, "Tolerance": 0.02, "Offset": 1.25}
    set_properties(old, BoundingTriangulation=1, **values)
    Delaunay2D(registrationName="untouched", Input=hill)
    SaveState(scratch("old.pvsm"))
    python_state = smstate.get_state(filter=smstate.supported_proxies())
    with open(scratch("old.pvsm")) as file:
        state = file.read()
    check_equal(state.count('type="Delaunay2D"'), 2, "filters in the state")
    with open(scratch("new.pvsm"), "w") as file:
        file.write(state.replace('type="Delaunay2D"', 'type="AdaptiveHilbertDelaunay2D"'))

    def check_loaded(how, tolerance):
        check_settings("old", dict(values, BoundingTriangulation=1), how)
        # An XML state holds the old default of 1e-5, a Python state nothing.
        check_settings("untouched", {"ProjectionPlaneMode": "XY Plane", "Alpha": 0.0, "Tolerance": tolerance}, how)
        found = measures(FindSource("untouched"))
        check_equal(found["NumberOfPointsInserted"], 393, how + ": points inserted")

    ResetSession()
    LoadState(scratch("new.pvsm"))
    check_loaded("Delaunay 2D's XML state", 1e-5)
    ResetSession()
    edited = python_state.replace("Delaunay2D(", "AdaptiveHilbertDelaunay2D(")
    exec(compile(edited, scratch("new.py"), "exec"), {"AdaptiveHilbertDelaunay2D": AdaptiveHilbertDelaunay2D})
    check_loaded("Delaunay 2D's Python state", 0.0)


test_states()
test_dimensions_that_are_not_used()
test_a_state_with_the_old_name()
test_a_state_with_delaunay_2d()
print("passed: state")
