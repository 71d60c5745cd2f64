# SPDX-License-Identifier: BSD-3-Clause
"""vtkPlanarSurfaceOutline over ranks: the first has the outline of the cells of all, the same as alone. A rank that
fails lets nobody wait; the class in Python refuses.

    mpiexec -n RANKS pvbatch --sym RanksOutline.py
"""

import sys

from adaptivehilbertdelaunay import vtkPlanarSurfaceOutline
from adaptivehilbertdelaunay._vtk import python_class
from vtkmodules.vtkCommonCore import VTK_STRING, vtkDoubleArray, vtkIdTypeArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
SIDE = 12
HOLES = {(2, 3), (3, 4), (7, 7), (7, 8), (10, 1), (0, 0)}
failures = []


def check(found, expected, what):
    if found != expected:
        failures.append("%s: %s, not %s" % (what, found, expected))


def squares(wanted, ghosts=()):
    """Unit squares with points of their own; those in `ghosts` are another rank's."""
    points, cells, marks, bands = vtkPoints(), vtkCellArray(), vtkUnsignedCharArray(), vtkDoubleArray()
    points.SetDataTypeToDouble()
    marks.SetName("vtkGhostType")
    bands.SetName("Band")
    for x, y in [*wanted, *ghosts]:
        cells.InsertNextCell(4)
        for corner in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)):
            cells.InsertCellPoint(points.InsertNextPoint(*corner, x - y))
        marks.InsertNextValue(int((x, y) in ghosts))
        bands.InsertNextValue(x // 5)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetCellData().AddArray(bands)
    if ghosts:
        data.GetCellData().AddArray(marks)
    return data


def contents(out):
    rings = []
    for k in range(out.GetNumberOfCells()):
        points = out.GetCell(k).GetPoints()
        rings.append([points.GetPoint(i) for i in range(points.GetNumberOfPoints())])
    cells = out.GetCellData()
    arrays = {cells.GetArrayName(i): [cells.GetArray(i).GetTuple1(k) for k in range(out.GetNumberOfCells())]
              for i in range(cells.GetNumberOfArrays())}
    return rings, arrays


def outline(data, kind=vtkPlanarSurfaceOutline, said=None, **settings):
    made = kind()
    if said is not None:
        def keep(_caller, _event, text):
            said.append(text)

        keep.CallDataType = VTK_STRING
        made.AddObserver("ErrorEvent", keep)
    made.SetInputData(data)
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    made.Update()
    return made


ALL = [(x, y) for x in range(SIDE) for y in range(SIDE) if (x, y) not in HOLES]
# The last rank has nothing of its own.
OWN = [ALL[k] for k in range(len(ALL)) if k % max(1, RANKS - 1) == RANK]
for settings in ({}, {"GroupArrayName": "Band"}):
    alone = contents(outline(squares(ALL), Controller=None, **settings).GetOutput())
    check(len(alone[0]) >= 4, True, "rings of all")
    for ghosts in ((), ALL[1:9]):
        others = [cell for cell in ghosts if cell not in OWN]
        made = outline(squares(OWN, others), **settings)
        found = contents(made.GetOutput())
        check(found, alone if RANK == 0 else ([], {}), "outline with %s, %d ghosts" % (settings, len(ghosts)))
    # One rank's input changes: all execute.
    if RANK == 1 % RANKS:
        made.SetInputData(squares(OWN[1:]))
    made.Update()
    less = [cell for cell in ALL if RANKS == 1 or cell != ALL[1 % max(1, RANKS - 1)]]
    if RANKS > 2 and RANK == 0:
        expected = contents(outline(squares(less), Controller=None, **settings).GetOutput())
        check(contents(made.GetOutput()), expected, "after a change of one rank")

said = []
refusing = outline(squares(OWN), python_class(name="vtkPlanarSurfaceOutline"), said)
check(contents(refusing.GetOutput()), ([], {}), "in Python")
check([("is on several ranks" in text) for text in said], [True], "error in Python")
bad, numbers, said = squares(OWN), vtkIdTypeArray(), []
if RANK == RANKS - 1:
    for offset in (0, 9):
        numbers.InsertNextValue(offset)
    ids = vtkIdTypeArray()
    ids.InsertNextValue(0)
    bad.GetPolys().SetData(numbers, ids)
check(contents(outline(bad, said=said).GetOutput()), ([], {}), "damaged cells on one rank")
check(len(said), int(RANK == RANKS - 1), "errors of it")

for text in failures:
    print("rank %d: %s" % (RANK, text[:2000]))
print("passed" if not failures else "failed", "on rank", RANK)
if failures:
    sys.exit(1)
