# SPDX-License-Identifier: BSD-3-Clause
"""A change on one rank alone (pvbatch --sym) makes all ranks execute, and nothing else does.

    mpiexec -n RANKS pvbatch --sym RanksUpdates.py

Each case changes something on the last rank, or on the others, and updates on all; then all have the results of new
filters. Where ranks did not agree, one would wait for the others: the test would not end. What a rank finds is kept to
the end of a case, for the same reason.
"""

import functools

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import (
    vtkAlgorithm, vtkStreamingDemandDrivenPipeline as Pipeline, vtkTrivialProducer,
)
from vtkmodules.vtkFiltersCore import vtkElevationFilter

from RanksCompare import (
    RANK, RANKS, WANTED, Said, attempt, check, finish, make_input, make_source, on_all_ranks,
)
from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D, vtkAdaptiveHilbertInterpolation2D
from rankcases import Piece, pieces, ring, uniform

IS_LAST = RANK == RANKS - 1
GIVEN = pieces(uniform(240), RANKS)[RANK]
OTHER = pieces(uniform(180, 9), RANKS)[RANK]


complaints = []


def note(condition, what):
    if not condition:
        complaints.append(what)


def case(work):
    """Runs it on all ranks; then rank 0 gets the findings of each."""

    @functools.wraps(work)
    def on_ranks(*arguments):
        def find():
            complaints.clear()
            work(*arguments)
            return list(complaints)

        for rank, found in enumerate(on_all_ranks("updates", find) or ()):
            check(not found, "rank %d: %r" % (rank, found))

    return on_ranks


class Chain:
    """A source, a filter on it, and a downstream filter, which is updated."""

    def __init__(self, kind, piece=GIVEN):
        self.data = make_input(piece)
        self.source = vtkTrivialProducer()
        self.source.SetOutput(self.data)
        self.filter = kind()
        triangulation = self.filter
        if kind is vtkAdaptiveHilbertInterpolation2D:
            triangulation = self.filter.GetTriangulation()
            self.filter.SetDimensions(20, 20)
        triangulation.SetDistributePoints(True)
        self.triangulation = triangulation
        self.filter.SetInputConnection(self.source.GetOutputPort())
        self.behind = vtkElevationFilter()
        self.behind.SetInputConnection(self.filter.GetOutputPort())
        self.said = Said(self.filter)

    def replace(self, piece):
        self.data.ShallowCopy(make_input(piece))
        self.data.Modified()


def what_is_put_out(algorithm):
    out = algorithm.GetOutputDataObject(0)
    if not hasattr(out, "GetPointData"):  # as the places were
        return out.GetClassName(), [], {}, 0
    data = out.GetPointData()
    arrays = [data.GetArray(k) for k in range(data.GetNumberOfArrays())]
    return (out.GetClassName(), [repr(out.GetPoint(i)) for i in range(out.GetNumberOfPoints())],
            {array.GetName(): [repr(array.GetTuple(i)) for i in range(array.GetNumberOfTuples())]
             for array in arrays if array}, out.GetNumberOfCells())


def update(algorithm):
    algorithm.UpdatePiece(RANK, RANKS, 0)


def expect(chain, executions, work, updated="filter", fresh=None):
    """Does `work`, updates on all, and compares with a chain that is made anew by fresh()."""
    before = chain.filter.GetNumberOfTriangulations()
    work()
    update(getattr(chain, updated))
    wanted = fresh()
    update(getattr(wanted, updated))
    done = chain.filter.GetNumberOfTriangulations() - before
    note(done == executions, "%d executions, not %d" % (done, executions))
    note(not chain.said.errors, "errors: %r" % chain.said.errors)
    note(what_is_put_out(getattr(chain, updated)) == what_is_put_out(getattr(wanted, updated)), "other outputs")


@case
def try_changes(kind, updated):
    """Points of one rank, of all but one, nothing, and once more."""
    chain = Chain(kind)
    update(getattr(chain, updated))
    expect(chain, 0, lambda: None, updated, lambda: Chain(kind))
    expect(chain, 1, lambda: IS_LAST and chain.replace(OTHER), updated,
           lambda: Chain(kind, OTHER if IS_LAST else GIVEN))
    expect(chain, 1, lambda: IS_LAST or chain.replace(OTHER), updated, lambda: Chain(kind, OTHER))
    for _ in range(3):
        expect(chain, 0, lambda: None, updated, lambda: Chain(kind, OTHER))
    expect(chain, 1, lambda: IS_LAST and chain.filter.Modified(), updated, lambda: Chain(kind, OTHER))
    # messages before there are data must not hide it
    expect(chain, 1, lambda: (IS_LAST and chain.replace(GIVEN), chain.filter.UpdateInformation()), updated,
           lambda: Chain(kind, GIVEN if IS_LAST else OTHER))


@case
def try_behind(kind):
    """Changes downstream of the filter do not affect the others."""
    chain = Chain(kind)
    update(chain.behind)
    before = chain.filter.GetNumberOfTriangulations()
    if IS_LAST:
        chain.behind.SetHighPoint(0, 0, 2)
    update(chain.behind)
    note(chain.filter.GetNumberOfTriangulations() == before, "it has executed")


@case
def try_inputs(kind):
    """An input that one rank gets, and loses; a source on one rank alone."""
    chain = Chain(kind)
    if IS_LAST:
        chain.filter.RemoveAllInputConnections(0)
    update(chain.filter)
    nothing = lambda: Chain(kind, Piece([]) if IS_LAST else GIVEN)
    expect(chain, 1, lambda: IS_LAST and chain.filter.SetInputConnection(chain.source.GetOutputPort()), "filter",
           lambda: Chain(kind))
    expect(chain, 1, lambda: IS_LAST and chain.filter.RemoveAllInputConnections(0), "filter", nothing)
    chain = Chain(kind)
    chain.triangulation.SetSourceModeToCoordinates()
    update(chain.filter)
    shore = make_source((ring(0.5, 8), [], [list(range(8))]))

    def with_shore():
        wanted = Chain(kind)
        wanted.triangulation.SetSourceModeToCoordinates()
        if IS_LAST:
            wanted.filter.SetSourceData(shore)
        return wanted

    expect(chain, 1, lambda: IS_LAST and chain.filter.SetSourceData(shore), "filter", with_shore)


@case
def try_released(kind):
    """An output that one rank has released is made anew by all, if any rank requests it."""
    chain = Chain(kind)
    update(chain.behind)
    expect(chain, 1, lambda: IS_LAST and chain.filter.GetOutputDataObject(0).ReleaseData(), "behind",
           lambda: Chain(kind))
    chain.filter.ReleaseDataFlagOn()  # on all: none executes, as none requests it
    expect(chain, 1, lambda: chain.filter.Modified(), "behind", lambda: Chain(kind))
    expect(chain, 0, lambda: None, "behind", lambda: Chain(kind))


class Timed(VTKPythonAlgorithmBase):
    """Other points at each time."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

    def RequestInformation(self, _request, _inputs, outputs):
        outputs.GetInformationObject(0).Set(Pipeline.TIME_STEPS(), [0.0, 1.0], 2)
        outputs.GetInformationObject(0).Set(Pipeline.TIME_RANGE(), [0.0, 1.0], 2)
        outputs.GetInformationObject(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        later = info.Has(Pipeline.UPDATE_TIME_STEP()) and info.Get(Pipeline.UPDATE_TIME_STEP()) > 0.5
        vtkPolyData.GetData(info).ShallowCopy(make_input(OTHER if later else GIVEN))
        return 1


@case
def try_times(kind, has_input):
    """A rank whose input has no times, or that has no input, executes with the others."""
    chain = Chain(kind)
    timed = Timed()
    if not IS_LAST:
        chain.filter.SetInputConnection(timed.GetOutputPort())
    elif not has_input:
        chain.filter.RemoveAllInputConnections(0)
    last = GIVEN if has_input else Piece([])
    for time in (0.0, 1.0, 1.0, 0.0):
        chain.filter.UpdateTimeStep(time, RANK, RANKS, 0)
        wanted = Chain(kind, last if IS_LAST else OTHER if time else GIVEN)
        update(wanted.filter)
        note(what_is_put_out(chain.filter) == what_is_put_out(wanted.filter), "other outputs at %r" % time)
    note(chain.filter.GetNumberOfTriangulations() == 3, "%d executions" % chain.filter.GetNumberOfTriangulations())


@case
def try_ghosts():
    """Ranks with different numbers of layers requested have the same, and report it."""
    chain = Chain(vtkAdaptiveHilbertDelaunay2D)
    chain.filter.UpdatePiece(RANK, RANKS, 2 if IS_LAST else 0)
    chain.filter.UpdatePiece(RANK, RANKS, 1)
    chain.filter.UpdatePiece(RANK, RANKS, 2)
    note(chain.filter.GetNumberOfTriangulations() == 1, "%d executions" % chain.filter.GetNumberOfTriangulations())


@case
def try_settings(kind):
    """A setting of one rank alone is reported by all, once for each execution."""
    chain = Chain(kind)
    update(chain.filter)
    if IS_LAST:
        chain.triangulation.SetFillRule(1)
    update(chain.filter)
    note(len(chain.said.errors) == 1 and "FillRule is not the same" in chain.said.errors[0], chain.said.errors)
    chain.said.errors.clear()
    if IS_LAST:
        chain.triangulation.SetFillRule(0)
    update(chain.filter)
    note(not chain.said.errors and what_is_put_out(chain.filter)[1], "after it: %r" % chain.said.errors)


@case
def try_unfit(kind, port, data, words):
    """An invalid source, or invalid places, on one rank alone: all report it, and execute again once it is removed."""
    chain = Chain(kind)
    if IS_LAST:
        chain.filter.SetInputDataObject(port, data)
    elif port == 1 and kind is vtkAdaptiveHilbertInterpolation2D:
        chain.filter.SetPlacesData(make_input(GIVEN))
    update(chain.filter)
    note(any(words in error for error in chain.said.errors), "errors: %r" % chain.said.errors)
    note(not what_is_put_out(chain.filter)[1], "something is put out")
    chain.said.errors.clear()
    chain.filter.RemoveAllInputConnections(port)
    update(chain.filter)
    note(not chain.said.errors and what_is_put_out(chain.filter)[1], "after it: %r" % chain.said.errors)


KINDS = {"Delaunay": vtkAdaptiveHilbertDelaunay2D, "interpolation": vtkAdaptiveHilbertInterpolation2D}
check(RANKS > 1, "to be run on several ranks")
todo = {"ghosts": (try_ghosts,)}
for name, kind in KINDS.items():
    todo.update({
        name + ": changes": (try_changes, kind, "filter"),
        name + ": changes, pulled from behind": (try_changes, kind, "behind"),
        name + ": changes behind": (try_behind, kind),
        name + ": inputs": (try_inputs, kind),
        name + ": released": (try_released, kind),
        name + ": times": (try_times, kind, True),
        name + ": times without an input": (try_times, kind, False),
        name + ": settings": (try_settings, kind),
        name + ": no source": (try_unfit, kind, 1 + (name == "interpolation"), vtkUnstructuredGrid(),
                               "could not take its input"),
    })
todo["no places"] = (try_unfit, vtkAdaptiveHilbertInterpolation2D, 1, vtkTable(), "without blocks")
for case, (what, *given) in todo.items():
    if WANTED in case:
        attempt(case, what, *given)
finish()
