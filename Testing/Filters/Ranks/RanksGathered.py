# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints with settings that ranks have no method for: one rank has the output of one alone, byte for byte.

    mpiexec -n RANKS pvbatch --sym RanksGathered.py
"""

import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import RanksCompare
from RanksCompare import (
    COUNTS, RANK, RANKS, WANTED, appended, attempt, check, finish, make_filter, make_input, on_all_ranks, read, Said,
    try_failure,
)
from rankcases import PARTIAL, Piece, gathered_cases, pieces, uniform

MEANS = ["NP", "NR"]
OF_THE_RUN = ["MemoryEstimate", "SortSeconds", "NumberOfThreadsUsed"]
SAID_ONCE = " is computed on one rank: rank "


def values_of(array):
    value = array.GetValue if hasattr(array, "GetValue") else array.GetTuple1
    return [repr(value(i)) for i in range(array.GetNumberOfValues())]


def arrays_of(data):
    return {array.GetName(): (array.GetDataType(), array.GetNumberOfComponents(), array.GetComponentName(1),
                              values_of(array))
            for array in (data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays()))}


def contents(out):
    """All of a data set as plain values; counts in its field data excepted."""
    cells = []
    for kind in (out.GetVerts(), out.GetLines(), out.GetPolys()):
        cells.append((values_of(kind.GetOffsetsArray()), values_of(kind.GetConnectivityArray())))
    points = out.GetPoints()
    fields = arrays_of(out.GetFieldData())
    values = values_of(points.GetData()) if points else []
    return {
        "points": (points.GetDataType() if values else None, values) if points else None,
        "type": points.GetDataType() if points else None,
        "cells": cells,
        "point data": arrays_of(out.GetPointData()),
        "cell data": arrays_of(out.GetCellData()),
        "crossings": fields.get("Crossings"),
        "fields": fields,
    }


def run(piece, settings, distribute=True, prepare=None):
    algorithm = make_filter(piece, settings, distribute)
    said = Said(algorithm)
    if prepare:
        prepare(algorithm)
    algorithm.Update()
    found = read(algorithm, said)
    found["measures"] = {name: getattr(algorithm, "Get" + name)() for name in COUNTS + MEANS + OF_THE_RUN}
    found["ports"] = [contents(algorithm.GetOutputDataObject(port)) for port in range(3)]
    return found


def without_ids(port):
    """Takes the global ids away, and checks that they number all from 0 on."""
    for data, name in (("point data", "GlobalPointIds"), ("cell data", "GlobalCellIds")):
        ids = port[data].pop(name)[-1]
        check(ids == [repr(i) for i in range(len(ids))], name)
    return port


def shape_of(arrays):
    return {name: array[:-1] for name, array in arrays.items()}


def compare_whole(found, expected, host):
    """One rank has the outputs of `expected`, the others have the same arrays with nothing in them."""
    check(not any(part["errors"] for part in found), "errors: %r" % [part["errors"] for part in found])
    own = found[host]["ports"]
    for other in found[:host] + found[host + 1:]:
        for port, (ours, theirs) in enumerate(zip(own, other["ports"])):
            check(not (theirs["points"] or (None, []))[1], "points on another rank, port %d" % port)
            check(ours["type"] == theirs["type"], "type of points on another rank, port %d" % port)
            check(not any(ids for _, ids in theirs["cells"]), "cells on another rank, port %d" % port)
            for data in ("point data", "cell data"):
                check(shape_of(ours[data]) == shape_of(theirs[data]), "%s of port %d: %r, not %r" % (
                    data, port, shape_of(theirs[data]), shape_of(ours[data])))
            check(ours["fields"] == theirs["fields"], "field data of port %d" % port)
        check(other["measures"] == found[host]["measures"], "measures: %r, not %r" % (
            other["measures"], found[host]["measures"]))
    if own[0]["points"]:
        without_ids(own[0])
    for port, (ours, alone) in enumerate(zip(own, expected["ports"])):
        for part in set(alone) - {"type"}:
            check(ours[part] == alone[part], "%s of port %d: %r, not %r" % (part, port, ours[part], alone[part]))
    check(found[host]["counts"] == expected["counts"], "counts")
    for name in MEANS:
        check(found[host]["measures"][name] == expected["measures"][name], name)
    check(not any(part["warnings"] for part in found[1:]), "other ranks warn too")


def as_given(found):
    """An id as its rank had it: see appended_id()."""
    return "the first is %d " % int(found[1])


def try_case(made, settings, setting):
    settings = dict(settings)
    found = on_all_ranks("gathered", lambda: run(made[RANK], settings))
    if RANK:
        return
    expected = run(appended(made, settings), settings, distribute=False)
    compare_whole(found, expected, 0)
    said = found[0]["warnings"]
    check(said and said[-1].startswith(setting) and SAID_ONCE + "0 of %d" % RANKS in said[-1], "said: %r" % said)
    told = [re.sub(r"the first is 100(\d{5}) ", as_given, text) for text in expected["warnings"]
            if "each triangulates its own points" not in text]
    if "Extra" in made[-1].arrays:
        check(said.pop(-2).endswith(PARTIAL), "the arrays that not all have: %r" % said)
    check(said[:-1] == told, "warnings: %r, not %r" % (said, told))


def try_hosts(limit, is_first):
    """Rank 0 gathers all if its limit permits, though others may take more; else another one does."""
    made = pieces(uniform(1500), RANKS)
    settings = {"GenerateVoronoi": True}
    found = on_all_ranks("host", lambda: run(made[RANK], dict(settings, MemoryLimit=10 ** 6 if RANK else limit)))
    if RANK:
        return
    hosts = [rank for rank, part in enumerate(found) if part["names"]]
    check(len(hosts) == 1 and (hosts[0] == 0) == is_first, "ranks that put something out: %r" % hosts)
    said = found[0]["warnings"]
    check(len(said) == 1 and SAID_ONCE + "%d of" % hosts[0] in said[0], "said: %r" % said)
    found[0]["warnings"] = []
    compare_whole(found, run(appended(made, settings), settings, distribute=False), hosts[0])


def try_unfit_marks():
    """The message about one rank, reported by the first."""
    made = pieces(uniform(100), RANKS)
    made[-1].arrays["vtkGhostType"] = ("float", [1.0] * len(made[-1].points))
    found = on_all_ranks("marks", lambda: run(made[RANK], {"GenerateVoronoi": True}))
    if found:
        check("vtkGhostType does not have one value" in found[0]["warnings"][0], "said: %r" % found[0]["warnings"])
        check(found[0]["measures"]["NumberOfPointsInserted"] == 100, "points were left out")


def try_again():
    """It is reported once for each filter, and earlier outputs are gone."""
    made = pieces(uniform(200), RANKS)
    algorithm = make_filter(made[RANK], {"InsertionLimit": 50}, True)
    said = Said(algorithm)

    def steps():
        counts = []
        for limit in (50, 60, 0):
            algorithm.SetInsertionLimit(limit)
            algorithm.Update()
            counts.append((algorithm.GetNumberOfPointsInserted(), algorithm.GetOutput().GetNumberOfPoints() > 0))
        return counts, said.warnings

    for rank, (counts, warnings) in enumerate(on_all_ranks("again", steps) or ()):
        check([count for count, _ in counts] == [50, 60, 200], "counts: %r" % counts)
        check([has for _, has in counts] == [rank == 0, rank == 0, True], "rank %d has points: %r" % (rank, counts))
        check(len(warnings) == (rank == 0), "rank %d warns: %r" % (rank, warnings))


def failures():
    """name -> (the action of each rank, words of the one error on each; None: no error)"""
    some = pieces(uniform(3000), RANKS)
    last = RANK == RANKS - 1

    def abort_at(rank, progress):
        def watch(caller, _):
            if caller.GetProgress() >= progress:
                caller.SetAbortExecute(1)

        def prepare(algorithm):
            if RANK == rank:
                algorithm.AddObserver("ProgressEvent", watch)
        return prepare

    def with_(prepare=None, **settings):
        return lambda: RanksCompare.run(some[RANK], settings, prepare=prepare)

    return {
        "a polygon without an area": (with_(GenerateVoronoi=True, VoronoiClip=2), "VoronoiPolygon has no area"),
        "a limit on all": (with_(GenerateVoronoi=True, MemoryLimit=400), "GenerateVoronoi is computed on one rank"),
        "the limit's figure": (with_(Alpha=0.1, MemoryLimit=400), "MemoryLimit allows 409 KB"),
        "a limit where it is sent": (with_(GenerateNeighbors=True, MemoryLimit=int(last)),
                                     "Sending them there may take"),
        "too many boxes": (with_(GenerateBoxes=True, Nmax=1, MemoryLimit=3000),
                           "of memory, but MemoryLimit allows 3.07 MB"),
        "abort at the beginning": (with_(abort_at(RANKS - 1, 0.0), GenerateVoronoi=True, Tolerance=0.01), None),
        "abort in the middle": (with_(abort_at(0, 0.4), GenerateVoronoi=True), None),
        "different orders": (with_(InsertionLimit=20, Nmax=50 + int(last)), "Nmax is not the same"),
    }


def try_no_points(settings):
    """Where no rank has a point, the arrays of the input come out as on one; a rank with no arrays does not count."""
    given = Piece([])
    given.arrays = {"Text": ("text", []), "Float": ("float", []), "Long": ("long", [])}
    expected = arrays_of(make_input(given).GetPointData()), "Float", []

    def run_empty():
        algorithm = make_filter(given if RANK < RANKS - 1 else Piece([]), settings, True)
        said = Said(algorithm)
        algorithm.Update()
        data = algorithm.GetOutput().GetPointData()
        return arrays_of(data), data.GetScalars() and data.GetScalars().GetName(), said.errors

    for arrays, scalars, errors in on_all_ranks("no points", run_empty) or ():
        found = {name: array for name, array in arrays.items() if name not in ("vtkGhostType", "GlobalPointIds")}
        check((found, scalars, errors) == expected, "%r, %r, %r" % (found, scalars, errors))


for name, (made, settings, setting) in gathered_cases(RANKS).items():
    if WANTED in name:
        attempt(name, try_case, made, settings, setting)
for name, (work, words) in failures().items():
    if WANTED in name:
        attempt(name, try_failure, name, work, words)
for name, work in (("other host", (try_hosts, 600, False)), ("first host", (try_hosts, 10 ** 5, True)),
                   ("again", (try_again,)), ("unfit marks", (try_unfit_marks,)), ("no points", (try_no_points, {})),
                   ("no points, gathered", (try_no_points, {"GenerateVoronoi": True}))):
    if WANTED in name:
        attempt(name, *work)
finish()
