# SPDX-License-Identifier: BSD-3-Clause
"""Inputs and settings that ranks have to tell apart, or must not; damage and aborts on one rank.

    mpiexec -n RANKS pvbatch --sym RanksInputs.py

Sources that differ in one thing are those of each rank; the same source is one, however its arrays lie in memory.
"""

import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from vtkmodules.vtkCommonCore import vtkPoints, vtkSOADataArrayTemplate, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes
from vtkmodules.vtkCommonTransforms import vtkCylindricalTransform, vtkSphericalTransform, vtkTransform

import RanksSample
from RanksCompare import (
    RANK, RANKS, WANTED, Said, appended, attempt, check, compare, finish, make_filter, make_input, make_source,
    on_all_ranks, run, try_failure,
)
from RanksSample import make_sampler
from rankcases import COORDINATES, EVERYTHING, pieces, ring, uniform

IS_LAST = RANK == RANKS - 1
SOME = pieces(uniform(300), RANKS)


def apart(array):
    """The same values, with the components in memory of their own."""
    made = vtkSOADataArrayTemplate["float64"]()
    made.SetName(array.GetName())
    made.SetNumberOfComponents(array.GetNumberOfComponents())
    made.SetNumberOfTuples(array.GetNumberOfTuples())
    for i in range(array.GetNumberOfTuples()):
        made.SetTuple(i, array.GetTuple(i))
    for c in range(array.GetNumberOfComponents()):
        made.SetComponentName(c, array.GetComponentName(c) or "")
    return made


def with_places_apart(data):
    points = vtkPoints()
    points.SetData(apart(data.GetPoints().GetData()))
    data.SetPoints(points)
    return data


# ------------------------------------------------------------------------------------------ inputs


def try_arrays_apart():
    """Arrays and places of an input whose components lie in memory of their own."""

    def prepare(algorithm):
        data = make_input(SOME[RANK])
        data.GetPointData().AddArray(apart(data.GetPointData().GetArray("Triple")))
        algorithm.SetInputData(with_places_apart(data))

    found = on_all_ranks("apart", lambda: run(SOME[RANK], EVERYTHING, prepare=prepare))
    if found:
        compare(found, run(appended(SOME, EVERYTHING), EVERYTHING, distribute=False))


CORNERS = ring(0.8, 9)
ONE = (CORNERS, [[0, 1, 2, 3], [4, 5, 6]], [])
SOURCES = {  # of the last rank, beside ONE
    "the same": ONE,
    "another place": ([(0.5, 0.0, 0.25)] + CORNERS[1:], *ONE[1:]),
    "another height": ([(*CORNERS[0][:2], 0.5)] + CORNERS[1:], *ONE[1:]),
    "other points of lines": (CORNERS, [[0, 1, 2, 3], [4, 5, 7]], []),
    "other lines of the same points": (CORNERS, [[0, 1, 2], [3, 4, 5, 6]], []),
    "polygons": (CORNERS, [], ONE[1]),
}


def try_sources(name):
    """ONE on all, and another on the last."""
    made = pieces(uniform(300), RANKS)
    for rank, piece in enumerate(made):
        piece.source = SOURCES[name] if rank == RANKS - 1 else ONE

    def prepare(algorithm):
        if IS_LAST:
            algorithm.SetSourceData(with_places_apart(make_source(made[RANK].source)))

    found = on_all_ranks("sources", lambda: run(made[RANK], COORDINATES, prepare=prepare))
    if found:
        expected = run(appended(made, COORDINATES), COORDINATES, distribute=False)
        count = len(CORNERS) * (1 if name == "the same" else RANKS)
        check(expected["counts"]["NumberOfAddedPoints"] == count, "added points: %r" % expected["counts"])
        compare(found, expected)


# ---------------------------------------------------------------------------------------- settings


def turned(degrees):
    turn = vtkTransform()
    turn.RotateX(degrees)
    return turn


def try_bent():
    """A transform that no matrix says."""
    prepare = lambda algorithm: algorithm.SetTransform(vtkCylindricalTransform())
    settings = dict(EVERYTHING, Rim=1)
    found = on_all_ranks("bent", lambda: run(SOME[RANK], settings, prepare=prepare))
    if found:
        expected = run(appended(SOME, settings), settings, distribute=False, prepare=prepare)
        check(expected["triangles"], "no triangle to compare")
        plain = run(appended(SOME, settings), settings, distribute=False)
        check(expected["triangles"] != plain["triangles"], "the transform has no effect")
        compare(found, expected)


def transform_failures():
    """Transforms of all but the last rank, and of the last."""
    pairs = {
        "matrices": (turned(30), turned(31)),
        "classes": (vtkCylindricalTransform(), vtkSphericalTransform()),
        "a matrix and none": (turned(30), vtkCylindricalTransform()),
    }
    for name, pair in pairs.items():
        prepare = lambda algorithm, pair=pair: algorithm.SetTransform(pair[IS_LAST])
        yield name, lambda prepare=prepare: run(SOME[RANK], {"Rim": 1}, prepare=prepare)


# --------------------------------------------------------------------------------- damage and aborts


def damaged():
    """Lines whose offsets go beyond their points."""
    data = make_source((CORNERS, [[0, 1, 2]], []))
    offsets, ids = vtkTypeInt64Array(), vtkTypeInt64Array()
    for offset in (0, 9):
        offsets.InsertNextValue(offset)
    for i in range(3):
        ids.InsertNextValue(i)
    data.GetLines().SetData(offsets, ids)
    return data


def make_kind(kind, settings):
    return make_filter(SOME[RANK], settings, True) if kind == "Delaunay" else make_sampler(
        SOME[RANK], settings, {}, True)


def observed(kind, settings, prepare):
    """The errors of an execution, and how many points are put out."""
    algorithm = make_kind(kind, settings)
    said = Said(algorithm)
    prepare(algorithm)
    algorithm.UpdatePiece(RANK, RANKS, 0)
    out = algorithm.GetOutputDataObject(0)
    return {"errors": said.errors, "points": out.GetNumberOfPoints()}


def check_refused(found, words):
    """Each rank says so, once, and none puts anything out."""
    for rank, part in enumerate(found or ()):
        check(len(part["errors"]) == 1 and words in part["errors"][0], "rank %d: %r" % (rank, part["errors"]))
        check(not part["points"], "rank %d puts something out" % rank)


def try_damaged(kind, settings):
    """A source that is damaged on one rank."""
    prepare = lambda algorithm: algorithm.SetSourceData(damaged() if IS_LAST else make_source(ONE))
    check_refused(on_all_ranks("damaged", lambda: observed(kind, settings, prepare)), " damaged")


class Aborting:
    """Aborts at a number of a progress event of one rank."""

    def __init__(self, at):
        self.at, self.heard = at, 0

    def __call__(self, algorithm):
        algorithm.AddObserver("ProgressEvent", self.hear)

    def hear(self, algorithm, _event):
        self.heard += 1
        if IS_LAST and self.heard == self.at:
            algorithm.SetAbortExecute(1)


def try_aborts(kind, settings):
    """At a progress event of one rank, all end with nothing and no error, or none does."""
    made = Aborting(0)

    def work(at):
        made.at, made.heard = at, 0
        return observed(kind, settings, made)

    aborted = 0
    for at in (1, 3, 6, 10):
        found = on_all_ranks("aborts", lambda: work(at)) or ()
        for rank, part in enumerate(found):
            check(not part["errors"], "event %d, rank %d: %r" % (at, rank, part["errors"]))
        empty = {part["points"] == 0 for part in found}
        check(len(empty) < 2, "event %d: points %r" % (at, [part["points"] for part in found]))
        aborted += empty == {True}
    check(RANK or aborted, "none is aborted")


# ------------------------------------------------------------------------------------- interpolation


def try_names(wishes, words):
    """Names that two arrays cannot have, or that VTK has."""
    check_refused(on_all_ranks("names", lambda: RanksSample.run(SOME[RANK], {}, wishes, None)), words)


def try_few_cells():
    """A raster that is known late, with fewer cells than there are ranks: some have none."""
    found = on_all_ranks("few cells", lambda: RanksSample.counts_at_times(1, (1.0, 0.0)))
    for k, count in enumerate((4, 1)) if found else ():
        check([part[k][0] for part in found] == [count] * RANKS, "places: %r" % found)
        check(sum(part[k][1] for part in found) >= count, "points: %r" % found)


def try_scalars():
    """Before ranks execute, they say what the scalars will be like, as one rank alone does."""

    def on_ranks():
        sampler = make_sampler(SOME[RANK], {}, {}, True)
        found = []
        for name in ("Float", "Triple", "Byte"):
            for method in (sampler.LINEAR, sampler.NEAREST):
                sampler.GetInputDataObject(0, 0).GetPointData().SetActiveScalars(name)
                sampler.SetMethod(method)
                sampler.UpdateInformation()
                announced = vtkDataObject.GetActiveFieldInformation(
                    sampler.GetOutputInformation(0), vtkDataObject.FIELD_ASSOCIATION_POINTS,
                    vtkDataSetAttributes.SCALARS)
                said = [announced.Get(key()) for key in (
                    vtkDataObject.FIELD_ARRAY_TYPE, vtkDataObject.FIELD_NUMBER_OF_COMPONENTS)]
                sampler.UpdatePiece(RANK, RANKS, 0)
                made = sampler.GetOutput().GetPointData().GetScalars()
                found.append((said, made and [made.GetDataType(), made.GetNumberOfComponents()]))
        return found

    for found in on_all_ranks("scalars", on_ranks) or ():
        check(all(made in (None, said) for said, made in found), "what is announced, and made: %r" % found)
        check(any(made for _, made in found) and len({tuple(said) for said, _ in found}) > 2, "kinds: %r" % found)


def try_outside(settings):
    """No place is on the surface: where each rank has all of it, the message says of how many triangles."""
    wishes = {"UseBounds": True, "Bounds": (50, 51, 60, 61), "Dimensions": (3, 3)}
    found = on_all_ranks("outside", lambda: RanksSample.run(SOME[RANK], settings, wishes, None))
    if found:
        alone = RanksSample.run(appended(SOME, settings), settings, wishes, None, distribute=False)["warnings"][-1]
        check(" triangles. Places: " in alone, alone)
        of_all = alone if settings else re.sub(" of [0-9]+ triangles", "", alone)
        check(found[0]["warnings"][-1] == of_all, "%r, not %r" % (found[0]["warnings"], of_all))


check(RANKS > 1, "to be run on several ranks")
todo = {"arrays apart": (try_arrays_apart,), "bent": (try_bent,), "few cells": (try_few_cells,),
        "scalars": (try_scalars,), "outside": (try_outside, {}),
        "outside, all on each": (try_outside, {"ProjectionPlaneMode": 2})}
for name in SOURCES:
    todo["sources: " + name] = (try_sources, name)
for name, work in transform_failures():
    todo["transforms: " + name] = (try_failure, name, work, "Transform is not the same")
for kind in ("Delaunay", "interpolation"):
    for name, settings in {"": {}, ", fitted plane": {"ProjectionPlaneMode": 2},
                           ", one rank": {"CrossingMode": 1}}.items():
        todo["damaged: " + kind + name] = (try_damaged, kind, dict(settings, SourceMode=1))
        todo["aborts: " + kind + name] = (try_aborts, kind, settings)
ONE_FOR_TWO = {"HeightArrayName": "a", "ValidPointMaskArrayName": "a"}
todo["names: one for two"] = (try_names, ONE_FOR_TWO, "cannot have one name")
todo["names: VTK's"] = (try_names, {"HeightArrayName": "vtkGhostType"}, "by which VTK hides points")
for case, (what, *given) in todo.items():
    if WANTED in case:
        attempt(case, what, *given)
finish()
