# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints with a MemoryLimit: the one that a refusal names is enough to come further, one less is not.

    mpiexec -n 3 pvbatch --sym RanksMemory.py
"""

import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkParallelCore import vtkCommunicator

from adaptivehilbertdelaunay import vtkAdaptiveHilbertInterpolation2D
from RanksCompare import (
    CONTROLLER, RANK, RANKS, WANTED, Said, attempt, check, finish, make_filter, make_input, make_source,
    on_all_ranks,
)
from rankcases import EVERYTHING, appended, circle, pieces, uniform, with_sources

NAMED = re.compile(r"or set MemoryLimit to (\d+) or more \(KiB(, of each rank)?\)\.$")


def largest(number):
    """Of all ranks."""
    own, most = vtkIntArray(), vtkIntArray()
    own.InsertNextValue(number)
    most.InsertNextValue(number)
    CONTROLLER.AllReduce(own, most, vtkCommunicator.MAX_OP)
    return most.GetValue(0)


def execute(algorithm, said, limit, levels=0):
    """The error with this limit, empty if there is none; whether something is put out, on any rank; the estimate of
    a triangulation: an interpolation estimates once more, on each rank by itself."""
    of_values = hasattr(algorithm, "GetTriangulation")
    (algorithm.GetTriangulation() if of_values else algorithm).SetMemoryLimit(limit)
    algorithm.UpdatePiece(RANK, RANKS, levels)
    errors, said.errors[:] = list(said.errors), []
    points = largest(algorithm.GetOutputDataObject(0).GetNumberOfPoints())
    return "".join(errors), points > 0, None if of_values else largest(algorithm.GetMemoryEstimate())


def refusals(make, levels):
    """The refusals until a limit is enough, that limit, the estimate, and what is said with one less."""
    algorithm = make()
    said = Said(algorithm)
    found, limit = [], 1
    for _ in range(20):
        error, has_points, estimate = execute(algorithm, said, limit, levels)
        if not error:
            break
        found.append((error, has_points))
        named = NAMED.search(error)
        limit = largest(int(named[1]) if named else 0)
    less, *_ = execute(algorithm, said, limit - 1, levels)
    return {"refusals": found, "limit": limit, "has points": has_points, "estimate": estimate, "with less": less}


def try_limits(make, levels, kinds):
    """`kinds`: of the refusals, by their words. One comes again where another rank needs more."""
    for rank, part in enumerate(on_all_ranks("limits", lambda: refusals(make, levels)) or ()):
        texts = [text for text, _ in part["refusals"]]
        named = [NAMED.search(text) for text in texts]
        check(all(named), "rank %d: no limit is named in %r" % (rank, texts))
        of_each = [match[2] is not None for match in named]
        check(of_each == [not text.startswith("Rank ") for text in texts], "rank %d: whose limits: %r" % (rank, texts))
        limits = [int(match[1]) for match in named]
        check(limits == sorted(set(limits)), "rank %d: what is named is not enough: %r" % (rank, texts))
        check(not any(has_points for _, has_points in part["refusals"]), "points after a refusal on rank %d" % rank)
        check(part["has points"], "rank %d: nothing is put out" % rank)
        found = [next(kind for kind in KINDS if kind in text) for text in texts]
        runs = [kind for k, kind in enumerate(found) if [kind] != found[k - 1:k]]
        check(runs == kinds, "rank %d: %r" % (rank, texts))
        check(part["with less"], "rank %d: one less than %d is enough" % (rank, part["limit"]))
        check(part["estimate"] in (part["limit"], None), "rank %d: the estimate is %r, and %d is enough" % (
            rank, part["estimate"], part["limit"]))


def filter_of(made, **settings):
    return lambda: make_filter(made[RANK], settings, True)


def sampler_of(made, settings, **wishes):
    def make():
        sampler = vtkAdaptiveHilbertInterpolation2D()
        sampler.SetTriangulation(make_filter(made[RANK], settings, True))
        sampler.SetInputData(make_input(made[RANK]))
        if made[RANK].source:
            sampler.SetSourceData(make_source(made[RANK].source))
        for name, value in wishes.items():
            getattr(sampler, "Set" + name)(value)
        return sampler
    return make


def received(made):
    """KiB of the points of all and their arrays."""
    own = make_input(made[RANK])
    arrays = [own.GetPoints().GetData()] + [own.GetPointData().GetAbstractArray(k)
                                            for k in range(own.GetPointData().GetNumberOfArrays())]
    sizes = on_all_ranks("sizes", lambda: sum(array.GetActualMemorySize() for array in arrays))
    return sum(sizes or [])


def try_one_rank():
    """Where one rank does it all, what it receives is estimated beside what it does; lines are in it."""
    settings, found = {"GenerateVoronoi": True}, []

    def work():
        algorithm = make_filter(made[RANK], settings, True)
        algorithm.Update()
        return algorithm.GetMemoryEstimate()

    for made in (SOME, with_sources(pieces(uniform(3000), RANKS), 900)):
        estimates, all_points = on_all_ranks("one rank", work), received(made)
        if estimates:
            alone = make_filter(appended(made, settings), settings, False)
            alone.Update()
            beyond = estimates[0] - alone.GetMemoryEstimate()
            check(beyond >= all_points, "%d KiB more than alone, but %d are received" % (beyond, all_points))
            found.append((estimates[0], alone.GetMemoryEstimate()))
    if found:
        (plain, alone), (lines, alone_lines) = found
        check(lines - plain > 0.95 * (alone_lines - alone) > 0, "lines take %d KiB, alone %d" % (
            lines - plain, alone_lines - alone))


def first_named(make):
    """KiB, of each rank, that the first refusal asks for."""
    algorithm = make()
    error, *_ = execute(algorithm, Said(algorithm), 1)
    return largest(int(NAMED.search(error)[1]))


def try_messages():
    """Where each rank gathers all points, there are they, and the messages in which they come."""
    named, all_points = first_named(sampler_of(SOME, {"ProjectionPlaneMode": 2})), received(SOME)
    check(named >= 2 * all_points, "%d KiB are asked for, but %d are received" % (named, all_points))


def try_nearest():
    """What is nearest is found in a second triangulation, without the constraints."""
    made = with_sources(pieces(uniform(3000), RANKS), 4)
    linear, nearest = (refusals(sampler_of(made, {}, Method=method), 0)["limit"] for method in (0, 3))
    check(nearest > 1.2 * linear, "%d KiB, and %d with Linear" % (nearest, linear))


JOINED, AT_ONCE, GHOSTS, ONE, LOCAL, PLAIN = KINDS = (
    "which is to join some of the ", "which is to join the ", "ghost cells included", " is computed on one rank",
    " places from ", " may take ")
SOME = pieces(uniform(3000), RANKS)
CASES = {
    "plain": (filter_of(SOME, **EVERYTHING), 0, [PLAIN, JOINED]),
    "ghosts": (filter_of(SOME, **EVERYTHING), 2, [PLAIN, JOINED, GHOSTS]),
    "circle": (filter_of(pieces(circle(2000), RANKS)), 0, [PLAIN, AT_ONCE]),
    "one rank": (filter_of(SOME, GenerateVoronoi=True), 0, [ONE]),
    "values": (sampler_of(SOME, {}), 0, [PLAIN]),
    "values, all on each": (sampler_of(SOME, {"ProjectionPlaneMode": 2}), 0, [PLAIN, LOCAL]),
}
for name, arguments in CASES.items():
    if WANTED in name:
        attempt(name, try_limits, *arguments)
if WANTED in "one rank":
    attempt("what one rank receives", try_one_rank)
if WANTED in "values":
    attempt("messages", try_messages)
    attempt("nearest", try_nearest)
finish()
