# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints with many points: the triangles of several ranks (pvbatch --sym) hash to those of one.

    mpiexec -n RANKS pvbatch --sym RanksSurvey.py [FILE.csv | COUNT]

A file has x, y and z in its first columns, below a line of names; without one, so many random points. Each rank gets a
run of rows, wherever these lie. Prints the times, those of rank 0 and one thread.
"""

import hashlib
import os
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
SCRATCH = os.environ["AHD_SCRATCH"]


def read(what):
    if what.endswith(".csv"):
        return numpy.ascontiguousarray(numpy.genfromtxt(what, delimiter=",", skip_header=1)[:, :3])
    return numpy.random.default_rng(7).random((int(what), 3))


def run(points, distribute):
    """The triangles as triples of global ids, smallest first, sorted; how many points are here; and the time."""
    made = vtkPoints()
    made.SetData(numpy_to_vtk(points))
    data = vtkPolyData()
    data.SetPoints(made)
    algorithm = vtkAdaptiveHilbertDelaunay2D()
    algorithm.SetDistributePoints(distribute)
    algorithm.SetNumberOfThreads(1)
    algorithm.SetInputData(data)
    begun = time.perf_counter()
    algorithm.Update()
    took = time.perf_counter() - begun
    out = algorithm.GetOutput()
    triples = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    names = out.GetPointData().GetGlobalIds()
    triples = vtk_to_numpy(names)[triples] if names else triples.astype("int64")
    first = triples.argmin(axis=1)
    rows = numpy.arange(len(triples))
    turned = numpy.stack([triples[rows, (first + k) % 3] for k in range(3)], axis=1)
    return turned, out.GetNumberOfPoints(), took


def hash_of(triples):
    order = numpy.lexsort((triples[:, 2], triples[:, 1], triples[:, 0]))
    return hashlib.sha256(numpy.ascontiguousarray(triples[order]).tobytes()).hexdigest()


given = [word for word in sys.argv[1:] if word.endswith(".csv") or word.isdigit()]
points = read(given[-1] if given else "200000")
cuts = [len(points) * k // RANKS for k in range(RANKS + 1)]
own, count, took = run(numpy.ascontiguousarray(points[cuts[RANK]:cuts[RANK + 1]]), True)
print("rank %d: %d points, %d triangles, %.2f s" % (RANK, count, len(own), took), flush=True)
path = os.path.join(SCRATCH, "survey %d.npy")
numpy.save(path % RANK, own)
CONTROLLER.Barrier()
if RANK == 0:
    joined = numpy.concatenate([numpy.load(path % rank) for rank in range(RANKS)])
    for rank in range(RANKS):
        os.remove(path % rank)
    expected, _, alone = run(points, False)
    print("rank 0 alone: %d points, %d triangles, %.2f s" % (len(points), len(expected), alone), flush=True)
    found, wanted = hash_of(joined), hash_of(expected)
    print("%s, %s" % (found, "as of one rank" if found == wanted else "but one rank has " + wanted), flush=True)
    if found != wanted or len(expected) == 0:
        sys.exit(1)
