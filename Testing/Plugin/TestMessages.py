# SPDX-License-Identifier: BSD-3-Clause
"""Warnings and errors of the filter reach ParaView's user, once per run, and name their cause.

    TestMessages.py          runs each case in a pvpython of its own and reads what that prints
    TestMessages.py CASE     one case
"""

import math

from paraview.simple import *

from pluginsupport import *


def collinear():
    return {"points": [(float(i), 2.0 * i, 0.0) for i in range(9)]}


def rejected():
    return {"points": hill_points(60, 0) + [(math.nan, 0.0, 0.0), (0.0, -math.inf, 0.0)]}


def height():
    return {"points": hill_points(60, 0) + [(5.0, 5.0, math.nan)]}


def memory():
    return {"points": hill_points(4000, 0), "MemoryLimit": 1}


def duplicates():
    return {"points": hill_points(60, 9)}


# Case: what must be printed, as pieces of one message. None: nothing at all.
EXPECTED = {
    collinear: ["no triangle", "collinear", "9"],
    rejected: ["2 of 62 points", "NaN or infinite", "60"],
    height: ["1 of 61 points", "z"],
    memory: ["4000 points", "KiB", "MemoryLimit"],
    duplicates: None,
}


def run_case(name):
    LoadPlugin(PLUGIN, remote=False, ns=globals())
    case = globals()[name]()
    reader = XMLPolyDataReader(FileName=[write_vtp(name + ".vtp", case.pop("points"))])
    surface = AdaptiveHilbertDelaunay2D(Input=reader, **case)
    surface.UpdatePipeline()


def messages(printed):
    """The filter's own messages. (VTK's pipeline adds one of its own when a filter fails.)"""
    return [line for line in printed.splitlines() if "| vtkAdaptiveHilbertDelaunay2D (0x" in line]


def check_case(case, pieces):
    name = case.__name__
    status, printed = run([os.environ["AHD_PVPYTHON"], "--dr", os.path.abspath(__file__), name])
    check_equal(status, 0, "exit status of the case " + name)
    found = messages(printed)
    if pieces is None:
        check_equal(found, [], "messages in the case " + name)
        return
    check_equal(len(found), 1, "number of messages in the case %s" % name)
    for piece in pieces:
        check(piece in found[0], "%s: %r is not in the message %r" % (name, piece, found[0]))


if len(sys.argv) > 1:
    run_case(sys.argv[1])
else:
    for case, pieces in EXPECTED.items():
        check_case(case, pieces)
        print("passed:", case.__name__)
