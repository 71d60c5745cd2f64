# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertQualityMesh2D on ranks, compiled and in Python: one error on each with DistributePoints; without, a
mesh of each rank's own points, that of one process, and one warning of the first.

    mpiexec -n RANKS pvbatch --sym RanksQuality.py
"""

import sys

from adaptivehilbertdelaunay import vtkAdaptiveHilbertQualityMesh2D
from adaptivehilbertdelaunay._vtk import python_class
from vtkmodules.vtkCommonCore import VTK_STRING, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
failures = []


def check(found, expected, what):
    if found != expected:
        failures.append("%s: %s, not %s" % (what, found, expected))


def square():
    """Of a size of its own on each rank; nothing on the last."""
    points, side = vtkPoints(), 1.0 + RANK
    for x, y in ((0, 0), (side, 0), (side, side), (0, side), (side / 3, side / 7)) if RANK < RANKS - 1 else ():
        points.InsertNextPoint(x, y, 0)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


for kind in (vtkAdaptiveHilbertQualityMesh2D, python_class(name="vtkAdaptiveHilbertQualityMesh2D")):
    for distributes in (1, 0):
        said = {"ErrorEvent": [], "WarningEvent": []}
        made = kind()
        for event, texts in said.items():
            def keep(_caller, _event, text, texts=texts):
                texts.append(text)

            keep.CallDataType = VTK_STRING
            made.AddObserver(event, keep)
        made.GetTriangulation().SetDistributePoints(distributes)
        made.SetMinimumAngle(30)
        made.SetInputData(square())
        made.Update()
        made.SetMinimumAngle(28)
        made.Update()
        errors, warnings = said["ErrorEvent"], said["WarningEvent"]
        refused = "A quality mesh is made of the points of one rank, and there are %d ranks." % RANKS
        check([refused in text for text in errors], [True, True] * distributes, "errors")
        check(["each refines its own points only" in text for text in warnings],
              [True] * (RANK == 0 and not distributes), "warnings")
        cells = made.GetOutput(0).GetNumberOfCells()
        check(cells > 4, RANK < RANKS - 1 and not distributes, "%d triangles" % cells)

for text in failures:
    print("rank %d: %s" % (RANK, text[:2000]))
print("passed" if not failures else "failed", "on rank", RANK)
if failures:
    sys.exit(1)
