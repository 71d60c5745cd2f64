# SPDX-License-Identifier: BSD-3-Clause
"""Warnings and errors of the filter reach ParaView's user, once per run, and name their cause.

    TestMessages.py          runs the cases in a second pvpython and reads what that prints
    TestMessages.py cases    runs the cases
"""

import math
import re

from paraview.simple import *

from pluginsupport import *


def collinear():
    return {"points": [(float(i), 2.0 * i, 0.0) for i in range(9)]}


def wall():
    return {"points": [(float(i % 5), 2.0 * (i % 5), float(i // 5)) for i in range(25)]}


def volume():
    return {"points": [(float(i % 3), float(i // 3 % 3), float(i // 9)) for i in range(27)]}


def rejected():
    return {"points": hill_points(60, 0) + [(math.nan, 0.0, 0.0), (0.0, -math.inf, 0.0)]}


def height():
    return {"points": hill_points(60, 0) + [(5.0, 5.0, math.nan)]}


def limit():
    return {"points": hill_points(60, 0), "InsertionLimit": 2}


def limited():
    return {"points": hill_points(60, 0), "InsertionLimit": 30, "GenerateBoxes": 1}


def memory():
    return {"points": hill_points(4000, 0), "MemoryLimit": 1}


def duplicates():
    return {"points": hill_points(60, 9)}


# Case: what must be printed, as pieces of one message. Empty: nothing at all.
EXPECTED = {
    collinear: ["no triangle", "collinear", "9"],
    wall: ["no triangle", "not collinear in space", "Best-Fitting Plane"],
    volume: ["18 of 27 points", "Best-Fitting Plane"],
    rejected: ["2 of 62 points", "NaN or infinite", "60"],
    height: ["1 of 61 points", "z"],
    limit: ["no triangle", "InsertionLimit", "2 of 60"],
    limited: [],
    memory: ["4000 points", "KiB", "MemoryLimit"],
    duplicates: [],
}


# By the compiled class, or by the one in Python, in a line of its own.
SAID = re.compile(r"(^|\| )vtkAdaptiveHilbertDelaunay2D \(0x")


def run_cases():
    LoadPlugin(PLUGIN, remote=False, ns=globals())
    for make in EXPECTED:
        case = make()
        reader = XMLPolyDataReader(FileName=[write_vtp(make.__name__ + ".vtp", case.pop("points"))])
        print("case", make.__name__, file=sys.stderr, flush=True)
        AdaptiveHilbertDelaunay2D(Input=reader, **case).UpdatePipeline()
    print("case end", file=sys.stderr, flush=True)


def messages_by_case(printed):
    """The filter's own messages, and the message of VTK's pipeline about a failed filter, which would be a second one
    for one error."""
    found, case = {}, None
    for line in printed.splitlines():
        if line.startswith("case "):
            case = line[len("case ") :]
            found[case] = []
        elif SAID.search(line) or "returned failure for request" in line:
            found[case].append(line)
    return found


def check_messages():
    status, printed = run([os.environ["AHD_PVPYTHON"], "--dr", os.path.abspath(__file__), "cases"])
    check_equal(status, 0, "exit status of the cases")
    found = messages_by_case(printed)
    check_equal(found.pop("end"), [], "messages after the last case")
    check_equal(set(found), {case.__name__ for case in EXPECTED}, "cases that were run")
    for case, pieces in EXPECTED.items():
        own = found[case.__name__]
        check_equal(len(own), 1 if pieces else 0, "number of messages in the case " + case.__name__)
        for piece in pieces:
            check(piece in own[0], "%s: %r is not in the message %r" % (case.__name__, piece, own[0]))
        print("passed:", case.__name__)


if len(sys.argv) > 1:
    run_cases()
else:
    check_messages()
