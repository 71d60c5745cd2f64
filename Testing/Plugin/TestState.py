# SPDX-License-Identifier: BSD-3-Clause
"""A state file, XML or Python, brings the pipeline and its settings back."""

from paraview.simple import *
from paraview import servermanager, smstate

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())

CHANGED = {
    "InsertionOrder": "Multi-grid",
    "Nmax": 123,
    "ControlPoints": "First level",
    "GeneRotation": 0,
    "CountWork": 1,
    "GenerateFate": 1,
    "InsertionLimit": 200,
    "GenerateInsertionRank": 1,
    "GenerateInsertionCurve": 1,
    "GenerateBoxes": 1,
    "MemoryLimit": 4000000,
    "NumberOfThreads": 3,
    "ReuseLimit": 1000,
}
check_equal(set(CHANGED), set(SETTINGS), "settings this test changes")


def build():
    reader = XMLPolyDataReader(registrationName="hill", FileName=[write_vtp("state.vtp", hill_points())])
    surface = AdaptiveHilbertDelaunay2D(registrationName="surface", Input=reader, **CHANGED)
    # A filter on the second output, so that the state has to say which.
    Outline(registrationName="outline", Input=OutputPort(surface, 1)).UpdatePipeline()
    return fingerprint(surface)


def check_restored(expected, how):
    surface = FindSource("surface")
    check(surface, how + ": the filter is not there")
    check_equal(surface.SMProxy.GetXMLName(), "AdaptiveHilbertDelaunay2D", how + ": the filter's type")
    check_equal(surface.Input.SMProxy.GetXMLName(), "XMLPolyDataReader", how + ": the filter's input")
    for name, value in CHANGED.items():
        check_equal(getattr(surface, name), value, "%s: %s" % (how, name))
    check_equal(fingerprint(surface), expected, how + ": the triangles")
    found = measures(surface)
    check_equal(found["NumberOfDuplicates"], 7, how + ": duplicates")
    check_equal(found["NumberOfPointsBeyondLimit"], 193, how + ": points beyond the limit")
    outline = FindSource("outline")
    check_equal(outline.Input.Port, 1, how + ": the output the outline is of")
    check(surface[1].GetDataInformation().GetNumberOfCells() > 1, how + ": no boxes in the second output")


expected = build()
SaveState(scratch("state.pvsm"))
python_state = smstate.get_state(filter=smstate.supported_proxies())
with open(scratch("state.py"), "w") as file:
    file.write(python_state)

ResetSession()
check(not FindSource("surface"), "ResetSession left the filter behind, so this test would prove nothing")
LoadState(scratch("state.pvsm"))
check_restored(expected, "XML state")

ResetSession()
exec(compile(python_state, scratch("state.py"), "exec"), {})
check_restored(expected, "Python state")
print("passed: state")
