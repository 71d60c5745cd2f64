# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints with filters behind it: across several ranks (pvbatch --sym) the same results as on one.

    mpiexec -n RANKS pvbatch --sym RanksSeam.py

Contours have no gaps, and no piece twice. The gradient at a point needs all triangles around it, and each corner of a
triangle needs it: so gradients show whether the layer of ghosts is complete.
"""

import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
SCRATCH = os.environ["AHD_SCRATCH"]
LEVELS = [-0.5, 0.0, 0.25]


def make_filter(points, distribute):
    made = vtkPoints()
    made.SetData(numpy_to_vtk(points))
    data = vtkPolyData()
    data.SetPoints(made)
    heights = numpy_to_vtk(numpy.ascontiguousarray(numpy.sin(3 * points[:, 0]) * numpy.cos(2 * points[:, 1])))
    heights.SetName("Height")
    data.GetPointData().SetScalars(heights)
    algorithm = vtkAdaptiveHilbertDelaunay2D()
    algorithm.SetDistributePoints(distribute)
    if not distribute:
        algorithm.SetController(None)
    algorithm.SetInputData(data)
    return algorithm


def contours_behind(algorithm, array, distribute):
    """The ends of all segments, the smaller one first; ghosts excepted."""
    contour = vtkContourFilter()
    contour.SetInputConnection(algorithm.GetOutputPort())
    contour.SetInputArrayToProcess(0, 0, 0, 0, array)
    for i, level in enumerate(LEVELS):
        contour.SetValue(i, level)
    contour.UpdatePiece(RANK if distribute else 0, RANKS if distribute else 1, 0)
    out = contour.GetOutput()
    ids = vtk_to_numpy(out.GetLines().GetConnectivityArray()).reshape(-1, 2)
    marks = out.GetCellData().GetArray("vtkGhostType")
    if marks:
        ids = ids[vtk_to_numpy(marks) == 0]
    if not len(ids):
        return numpy.empty((0, 6))
    ends = vtk_to_numpy(out.GetPoints().GetData()).astype(float)[ids]
    swaps = (ends[:, 0, 0] > ends[:, 1, 0]) | ((ends[:, 0, 0] == ends[:, 1, 0]) & (ends[:, 0, 1] > ends[:, 1, 1]))
    ends[swaps] = ends[swaps][:, ::-1]
    return ends.reshape(-1, 6)


def run(points, distribute):
    """Contours of the heights; global ids and gradients of all corners of own triangles."""
    algorithm = make_filter(points, distribute)
    of_heights = contours_behind(algorithm, "Height", distribute)
    gradient = vtkGradientFilter()
    gradient.SetInputConnection(algorithm.GetOutputPort())
    gradient.SetInputScalars(0, "Height")
    gradient.UpdatePiece(RANK if distribute else 0, RANKS if distribute else 1, 1 if distribute else 0)
    out = gradient.GetOutput()
    corners = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    marks = out.GetCellData().GetArray("vtkGhostType")
    if distribute:
        assert marks and vtk_to_numpy(marks).any(), "no ghosts"
        corners = corners[vtk_to_numpy(marks) == 0]
    used = numpy.unique(corners)
    values = vtk_to_numpy(out.GetPointData().GetArray("Gradients"))[used]
    names = out.GetPointData().GetGlobalIds()
    names = vtk_to_numpy(names)[used] if names else used
    return of_heights, numpy.column_stack([names.astype(float), values])


def compare_contours(found, expected):
    order = [rows[numpy.lexsort(rows.T[::-1])] for rows in (found, expected)]
    return found.shape == expected.shape and numpy.allclose(*order, rtol=0, atol=1e-9)


def compare_gradients(found, expected):
    """Each corner, on each rank that has it: the order in which triangles are added up may differ."""
    whole = numpy.full((len(points), expected.shape[1] - 1), numpy.nan)
    whole[expected[:, 0].astype(int)] = expected[:, 1:]
    is_same = numpy.allclose(found[:, 1:], whole[found[:, 0].astype(int)], rtol=0, atol=1e-9)
    return is_same and set(found[:, 0]) == set(expected[:, 0])


points = numpy.random.default_rng(5).uniform(-1, 1, (3000, 3))
cuts = [len(points) * k // RANKS for k in range(RANKS + 1)]
path = os.path.join(SCRATCH, "seam %d %d.npy")
for k, rows in enumerate(run(numpy.ascontiguousarray(points[cuts[RANK]:cuts[RANK + 1]]), True)):
    numpy.save(path % (RANK, k), rows)
CONTROLLER.Barrier()
if RANK == 0:
    expected = run(points, False)
    joined = [numpy.concatenate([numpy.load(path % (rank, k)) for rank in range(RANKS)]) for k in range(2)]
    for rank in range(RANKS):
        for k in range(2):
            os.remove(path % (rank, k))
    good = True
    for what, compare, found, wanted in zip(("contours", "gradients"), (compare_contours, compare_gradients), joined,
                                            expected):
        is_same = len(wanted) > 100 and compare(found, wanted)
        print("%s: %d, on one rank %d, %s" % (what, len(found), len(wanted), "equal" if is_same else "NOT EQUAL"))
        good = good and is_same
    if not good:
        sys.exit(1)
