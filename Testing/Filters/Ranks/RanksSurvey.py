# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints with many points: the triangles of several ranks (pvbatch --sym) hash to those of one.

    mpiexec -n RANKS pvbatch --sym RanksSurvey.py [FILE.csv | COUNT]

A file has x, y and z in its first columns, below a line of names; without one, so many random points. Each rank gets a
run of rows, wherever these lie, with data that name the row. Prints the times, those of rank 0 and one thread, and the
memory at the peak.
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
failures = []


def read(what):
    if what.endswith(".csv"):
        return numpy.ascontiguousarray(numpy.genfromtxt(what, delimiter=",", skip_header=1)[:, :3])
    return numpy.random.default_rng(7).random((int(what), 3))


def memory(name):
    """A line of this process's status, in bytes."""
    with open("/proc/self/status") as file:
        return 1024 * int(next(line for line in file if line.startswith(name + ":")).split()[1])


def named(row):
    """Five numbers that name a row: more bytes than one of the usual widths has."""
    return row[:, None] * 8.0 + numpy.arange(5)


def check_data(output, rows):
    """The data of a point are those of its row."""
    data = output.GetPointData()
    for array, expected in (("Row", rows), ("Wide", named(rows))):
        found = vtk_to_numpy(data.GetArray(array))
        if not numpy.array_equal(found, expected):
            failures.append("%s is not that of the point" % array)


def check_memory(algorithm, before, count):
    """The estimate holds, and many points take little beyond the output."""
    taken = memory("VmHWM") - before
    beyond = (taken - 1024 * algorithm.GetOutput().GetActualMemorySize()) / count
    print("rank %d: %.0f bytes a point at the peak, output not counted" % (RANK, beyond), flush=True)
    if taken > 1024 * algorithm.GetMemoryEstimate():
        failures.append("%d bytes taken, %d KiB estimated" % (taken, algorithm.GetMemoryEstimate()))
    if count > 100000 and beyond > 200:
        failures.append("too much memory")


def run(points, distribute, first=0):
    """The triangles as triples of global ids, smallest first, sorted; how many points are here; and the time."""
    made = vtkPoints()
    made.SetData(numpy_to_vtk(points))
    data = vtkPolyData()
    data.SetPoints(made)
    rows = numpy.arange(first, first + len(points))
    for name, values in (("Row", rows), ("Wide", named(rows))):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    algorithm = vtkAdaptiveHilbertDelaunay2D()
    algorithm.SetDistributePoints(distribute)
    algorithm.SetNumberOfThreads(1)
    algorithm.SetInputData(data)
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")
    before, begun = memory("VmRSS"), time.perf_counter()
    algorithm.Update()
    took = time.perf_counter() - begun
    out = algorithm.GetOutput()
    triples = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    names = out.GetPointData().GetGlobalIds()
    if distribute:
        check_memory(algorithm, before, out.GetNumberOfPoints())
        check_data(out, vtk_to_numpy(names))
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
own, count, took = run(numpy.ascontiguousarray(points[cuts[RANK]:cuts[RANK + 1]]), True, cuts[RANK])
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
        failures.append("triangles")
if failures:
    print("rank %d failed: %s" % (RANK, ", ".join(failures)), flush=True)
    sys.exit(1)
