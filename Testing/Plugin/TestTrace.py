# SPDX-License-Identifier: BSD-3-Clause
"""The Python trace of a session has the filter and the changes, and runs by itself."""

import re

from paraview.simple import *
from paraview import smtrace

from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())
path = write_vtp("trace.vtp", hill_points())
shore_path = write_vtp("shore.vtp", ring(1.0), loops=[range(8)])

smtrace.start_trace()
reader = XMLPolyDataReader(registrationName="hill", FileName=[path])
surface = AdaptiveHilbertDelaunay2D(registrationName="surface", Input=reader, Nmax=77)
outline = Outline(registrationName="outline", Input=OutputPort(surface, 1))
shore = XMLPolyDataReader(registrationName="shore", FileName=[shore_path])
bounded = AdaptiveHilbertDelaunay2D(registrationName="bounded", Input=reader, Source=shore)
surface.UpdatePipeline()
# Like the Apply button: traces changes between here ...
modified = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": surface.SMProxy})
surface.InsertionOrder = "Regular grid"
surface.GeneratePointStatus = 1
surface.NumberOfThreads = 3
surface.ReuseLimit = 0
surface.InsertionLimit = 150
surface.GenerateBoxes = 1
surface.Source = shore
# ... and here.
modified.finalize()
modified = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": bounded.SMProxy})
set_properties(bounded, FillRule="Orientation", ClosedLines="Loops", Alpha=1.5, GenerateVoronoi=1)
bounded.Transform = "Transform"
bounded.Transform.Rotate = [0, 0, 30]
modified.finalize()
trace = smtrace.stop_trace()
print(trace)

# ParaView 6.1 writes surface.Set(\n    Source=shore, ... for surface.Source = shore.
assigned = re.sub(r"\.Set\(\s*", ".", re.sub(r"\s*=\s*", "=", trace))
for piece in (
    "AdaptiveHilbertDelaunay2D(",
    "Nmax = 77",
    "InsertionOrder = 'Regular grid'",
    "GeneratePointStatus = 1",
    "NumberOfThreads = 3",
    "ReuseLimit = 0",
    "InsertionLimit = 150",
    "GenerateBoxes = 1",
    "Input=OutputPort(",
    "Source=shore",
    "surface.Source = shore",
    "FillRule = 'Orientation'",
    "ClosedLines = 'Loops'",
    "Alpha = 1.5",
    "GenerateVoronoi = 1",
    "Transform = 'Transform'",
    "Transform.Rotate = [0.0, 0.0, 30.0]",
):
    check(piece.replace(" = ", "=") in assigned, "%r is not in the trace" % piece)
check("ControlPoints" not in trace, "the trace sets ControlPoints, which nobody changed")

expected = fingerprint(surface)
replay = scratch("trace.py")
with open(replay, "w") as file:
    file.write(trace)
    file.write(
        "\nfrom pluginsupport import fingerprint\n"
        "surface = FindSource('surface')\n"
        "print('replayed', fingerprint(surface), surface.Nmax, int(surface.GeneratePointStatus),\n"
        "      surface.InsertionOrder,\n"
        "    surface.NumberOfThreads, surface.ReuseLimit, surface.InsertionLimit,\n"
        "    int(surface.GenerateBoxes), FindSource('outline').Input.Port)\n"
    )
status, printed = run([os.environ["AHD_PVPYTHON"], "--dr", replay], PV_PLUGIN_CONFIG_FILE=PLUGIN_CONF)
check_equal(status, 0, "exit status of the replayed trace")
line = "replayed %s 77 1 'Regular grid' 3 0 150 1 1" % expected
check(line in printed, "the replayed trace did not print %r" % line)
print("passed: trace")
