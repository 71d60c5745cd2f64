# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertInterpolation2D on several ranks (pvbatch --sym): the bytes of one rank, and failing together.

    mpiexec -n RANKS pvbatch --sym RanksSample.py

The inputs are those of RanksCompare.py and RanksGathered.py. Each rank answers for its piece of the raster, or for
places of its own.
"""

import math
import random

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkImagingCore import vtkImageShiftScale, vtkRTAnalyticSource

from RanksCompare import (
    RANK, RANKS, WANTED, Said, appended, attempt, check, finish, make_filter, make_input, make_source, on_all_ranks,
)
from adaptivehilbertdelaunay import vtkAdaptiveHilbertInterpolation2D
from rankcases import TABLE, WITHOUT_EFFECT, cases, counts_of, gathered_cases, lattice, other_values, pieces, uniform

COUNTS = counts_of("interpolation")
valued = []  # places, of each comparison
lacking = []  # the warnings about values that are missing, of each comparison
LINEAR, NATURAL, LAPLACE, NEAREST = range(4)
OUTPUTS = [name for name in TABLE["delaunay"]["settings"] if name.startswith("Generate")]
WITHOUT_EFFECT_HERE = WITHOUT_EFFECT + [({}, dict.fromkeys(OUTPUTS, True))]
# For each input: settings, and whether at places.
WISHES = [
    ({"Method": LINEAR, "GenerateGradients": True}, False),
    ({"Method": NATURAL, "RasterSize": 1, "CellSize": None}, False),
    ({"Method": NEAREST, "OutputType": 1}, False),
    ({"Method": LINEAR, "Outside": 1, "GenerateGradients": True}, True),
    ({"Method": LAPLACE, "Outside": 2}, True),
    ({"Method": NEAREST}, True),
]


def make_places(made, rank):
    """Places of one rank: points of all, what lies between them and beyond."""
    draw = random.Random(rank)
    points = [point for piece in made for point in piece.points] or [(0.0, 0.0, 0.0)]
    places = vtkPoints()
    places.SetDataTypeToDouble()
    for _ in range(40 if rank != 1 else 0):  # one rank has none
        a, b = draw.choice(points), draw.choice(points)
        places.InsertNextPoint(a)
        places.InsertNextPoint(*((p + q) / 2 for p, q in zip(a, b)))
        places.InsertNextPoint(*(1.5 * p - 0.5 * q for p, q in zip(a, b)))
    data = vtkPolyData()
    data.SetPoints(places)
    return data


def cells_for(made):
    """A size of cells of which not many cover the points."""
    points = [point for piece in made for point in piece.points + (piece.source[0] if piece.source else [])
              if all(map(math.isfinite, point))] or [(0, 0, 0)]
    length = max(max(axis) - min(axis) for axis in zip(*points)) or 1.0
    return length / 17, length / 23


def make_sampler(piece, settings, wishes, distribute):
    triangulation = make_filter(piece, settings, distribute)
    sampler = vtkAdaptiveHilbertInterpolation2D()
    sampler.SetTriangulation(triangulation)
    sampler.SetDimensions(37, 29)
    for name, value in wishes.items():
        if isinstance(value, tuple):
            getattr(sampler, "Set" + name)(*value)
        else:
            getattr(sampler, "Set" + name)(value)
    sampler.SetInputData(make_input(piece))
    if piece.source:
        sampler.SetSourceData(make_source(piece.source, piece.source_arrays))
    return sampler


def read(sampler, said):
    out = sampler.GetOutputDataObject(0)
    data = out.GetPointData()
    count = out.GetNumberOfPoints()
    arrays = {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        arrays[array.GetName()] = (array.GetDataTypeAsString(), [repr(array.GetTuple(i)) for i in range(count)])
    is_image = isinstance(out, vtkImageData)
    return {
        "class": out.GetClassName(),
        "extent": out.GetExtent() if hasattr(out, "GetExtent") else None,
        "geometry": (out.GetOrigin(), out.GetSpacing()) if is_image else None,
        "points": [repr(out.GetPoint(i)) for i in range(count)],
        "arrays": arrays,
        "scalars": data.GetScalars().GetName() if data.GetScalars() else None,
        "counts": {name: getattr(sampler, "Get" + name)() for name in COUNTS},
        "errors": said.errors,
        "warnings": said.warnings,
    }


def run(piece, settings, wishes, places, distribute=True, prepare=None):
    sampler = make_sampler(piece, settings, wishes, distribute)
    if places:
        sampler.SetPlacesData(places)
    said = Said(sampler)
    if prepare:
        prepare(sampler)
    if distribute:
        sampler.UpdatePiece(RANK, RANKS, 0)
    else:
        sampler.Update()
    return read(sampler, said)


def numbers_of(part, whole):
    """Of each point of a piece of a raster its number in the whole one."""
    x0, x1, y0, y1 = part["extent"][:4]
    columns = whole["extent"][1] - whole["extent"][0] + 1
    return [y * columns + x for y in range(y0, y1 + 1) for x in range(x0, x1 + 1)]


def compare(found, expected):
    check(not any(part["errors"] for part in found), "errors: %r" % [part["errors"] for part in found])
    check(not expected["errors"], "errors of one rank: %r" % expected["errors"])
    check(not any(part["warnings"] for part in found[1:]), "other ranks warn too")
    told = [[text for text in part["warnings"] if "values at places" in text]
            for part in (found[0], expected)]
    check(told[0] == told[1], "what is missing: %r, not %r" % tuple(told))
    lacking.extend(told[1])
    seen, first = set(), 0
    for part in found:
        check(part["class"] == expected["class"], part["class"])
        check(part["counts"] == expected["counts"], "counts: %r, not %r" % (part["counts"], expected["counts"]))
        check(not part["points"] or part["geometry"] == expected["geometry"], "geometry: %r, not %r" % (
            part["geometry"], expected["geometry"]))
        check(not part["points"] or part["scalars"] == expected["scalars"], "scalars: %r" % part["scalars"])
        if part["extent"] is None or not part["points"]:
            numbers = range(first, first + len(part["points"]))
            first += len(part["points"])
        else:
            numbers = numbers_of(part, expected)
        seen.update(numbers)
        check(not part["points"] or set(part["arrays"]) == set(expected["arrays"]), "arrays: %r, not %r" % (
            sorted(part["arrays"]), sorted(expected["arrays"])))
        check(part["points"] == [expected["points"][k] for k in numbers], "points")
        for name, (kind, values) in part["arrays"].items() if part["points"] else ():
            check(kind == expected["arrays"][name][0], "%s is a %s" % (name, kind))
            wanted = expected["arrays"][name][1]
            other = [(k, value, wanted[k]) for k, value in zip(numbers, values) if value != wanted[k]]
            check(not other, "%s at %d places, the first (number, found, expected): %r" % (name, len(other), other[:1]))
    check(len(seen) == len(expected["points"]), "%d places of %d" % (len(seen), len(expected["points"])))


def whole_places(made):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for rank in range(RANKS):
        own = make_places(made, rank)
        for i in range(own.GetNumberOfPoints()):
            points.InsertNextPoint(own.GetPoint(i))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def try_case(number, made, settings):
    """With two of the wishes, in turn."""
    settings = {name: value for name, value in settings.items() if not name.startswith("Generate")}
    if settings.pop("turn", False):
        for piece in made:
            piece.source[2][0].reverse()
    all_wishes = [(dict(wishes, **({"CellSize": cells_for(made)} if "CellSize" in wishes else {})), at_places)
                  for wishes, at_places in (WISHES[number % 3], WISHES[3 + number // 3 % 3])]

    def on_ranks():
        return [run(made[RANK], settings, wishes, make_places(made, RANK) if at_places else None)
                for wishes, at_places in all_wishes]

    found = on_all_ranks("sample", on_ranks)
    if RANK:
        return
    whole = appended(made, settings)
    for k, (wishes, at_places) in enumerate(all_wishes):
        expected = run(whole, settings, wishes, whole_places(made) if at_places else None, distribute=False)
        try:
            compare([part[k] for part in found], expected)
        except AssertionError as error:
            raise AssertionError("%r: %s" % (wishes, error)) from error
        valued.append(expected["counts"]["NumberOfValidPlaces"])


def try_failure(work, words):
    """All report the same one error, and no output."""
    found = on_all_ranks("failure", work)
    for rank, part in enumerate(found or ()):
        check(not part["points"], "rank %d puts something out" % rank)
        check(not any(part["counts"].values()), "rank %d counts" % rank)
        check(len(part["errors"]) == (words is not None), "rank %d says %r" % (rank, part["errors"]))
        check(words is None or words in part["errors"][0], "rank %d: %r" % (rank, part["errors"]))
        check(part["errors"] == found[0]["errors"], "rank %d says something else than rank 0" % rank)


def failures_together():
    some = pieces(uniform(300), RANKS)
    last = RANK == RANKS - 1

    def abort(sampler):
        if last:
            sampler.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
            sampler.SetAbortExecute(1)

    def with_(wishes, prepare=None, places=None, **settings):
        return lambda: run(some[RANK], settings, wishes, places, prepare=prepare)

    return {
        **{name: (with_({name: other} if last else {}),
                  ("A name of an array" if isinstance(other, str) else name) + " is not the same")
           for name, other, _ in other_values("interpolation")},
        **{name: (with_({}, **needed, **({name: other} if last else {})), name + " is not the same")
           for name, other, needed in other_values("delaunay") if not {name, *needed} & set(OUTPUTS)},
        "places on some": (with_({}, places=make_places(some, 0) if last else None), "whether there are places"),
        "a limit on memory": (with_({}, MemoryLimit=1), "MemoryLimit allows 1.02 KB"),
        "a limit on one rank": (with_({}, MemoryLimit=int(last)), "may take"),
        "a limit on memory for places": (with_({"Dimensions": (9000, 9000)}, MemoryLimit=100000),
                                         "MemoryLimit of Triangulation allows 102 MB"),
        "bounds that are none": (with_({"Bounds": (1, 0, 0, 1), "UseBounds": True}), "Bounds are"),
        "different sizes": (with_({"RasterSize": int(last), "CellSize": (0.1, 0.1)}), "RasterSize is not the same"),
        "different planes": (with_({"RasterSize": 1, "CellSize": (0.1, 0.1)}, ProjectionPlaneMode=2 * int(last)),
                             "ProjectionPlaneMode is not the same"),
        "abort": (with_({}, prepare=abort), None),
        "abort by cell size": (with_({"RasterSize": 1, "CellSize": (0.1, 0.1)}, prepare=abort), None),
    }


def try_without_effect():
    """Differing settings without effect do not stop ranks; those that add outputs to a triangulation have none here."""
    made, last = pieces(uniform(300), RANKS), RANK == RANKS - 1

    def on_ranks():
        return [run(made[RANK], dict(settings, **(other if last else {})), {}, None)
                for settings, other in WITHOUT_EFFECT_HERE]

    found = on_all_ranks("without effect", on_ranks)
    for k, (settings, _) in enumerate(WITHOUT_EFFECT_HERE if found else ()):
        compare([part[k] for part in found], run(appended(made, settings), settings, {}, None, distribute=False))


def try_again(raster):
    """Earlier outputs are replaced, ghost cells are overlaps, and an abort does not persist."""
    made = pieces(lattice(800, 20), RANKS)
    sampler = make_sampler(made[RANK], {}, raster, True)
    said = Said(sampler)

    def again():
        sampler.UpdatePiece(RANK, RANKS, 1)
        first = read(sampler, said)
        if RANK == RANKS - 1:
            sampler.SetAbortExecute(1)
        sampler.SetMethod(NATURAL)
        sampler.UpdatePiece(RANK, RANKS, 0)
        check(sampler.GetOutput().GetNumberOfPoints() == 0, "an output after an abort")
        sampler.SetAbortExecute(0)
        sampler.UpdatePiece(RANK, RANKS, 0)
        return first, read(sampler, said)

    found = on_all_ranks("again", again)
    if found:
        whole = appended(made, {})
        with_ghosts = [part[0] for part in found]
        for part in with_ghosts:  # beside hidden points, which one rank has too, VTK marks the overlap
            kind, marks = part["arrays"]["vtkGhostType"]
            part["arrays"]["vtkGhostType"] = kind, [{"(1.0,)": "(0.0,)", "(3.0,)": "(2.0,)"}.get(m, m) for m in marks]
        compare(with_ghosts, run(whole, {}, raster, None, distribute=False))
        compare([part[1] for part in found], run(whole, {}, dict(raster, Method=NATURAL), None, distribute=False))


def try_other_inputs():
    """A rank without an input, or with one that has no points of its own, takes part."""
    made = pieces(uniform(300), RANKS)

    def on_ranks(other):
        sampler = make_sampler(made[0], {}, {}, True)
        if RANK:
            sampler.SetInputDataObject(0, other)
        said = Said(sampler)
        sampler.UpdatePiece(RANK, RANKS, 0)
        return read(sampler, said)

    for other in (None, vtkImageData()):
        found = on_all_ranks("other inputs", lambda: on_ranks(other))
        if found:
            for part in found:
                part["warnings"] = []  # that an image has no points of its own
            compare(found, run(made[0], {}, {}, None, distribute=False))


class Growing(VTKPythonAlgorithmBase):
    """Points of a square that is larger at time 1."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

    def RequestInformation(self, _request, _inputs, outputs):
        outputs.GetInformationObject(0).Set(Pipeline.TIME_STEPS(), [0.0, 1.0], 2)
        outputs.GetInformationObject(0).Set(Pipeline.TIME_RANGE(), [0.0, 1.0], 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(Pipeline.UPDATE_TIME_STEP()) if info.Has(Pipeline.UPDATE_TIME_STEP()) else 0.0
        vtkPolyData.GetData(info).ShallowCopy(square(1 + time))
        return 1


def square(side):
    points = vtkPoints()
    for k in range(4):
        points.InsertNextPoint(side * (k % 2), side * (k // 2), RANK)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def raster_of(side):
    sampler = vtkAdaptiveHilbertInterpolation2D()
    sampler.GetTriangulation().SetDistributePoints(True)
    sampler.SetInputData(square(side))
    sampler.SetDimensions(20, 30)
    return sampler


def counts_at_times(cell, times):
    """Of points that grow, with cells of this size: the places of all ranks and the points of this one's piece."""
    sampler = raster_of(1)
    sampler.SetRasterSize(1)
    sampler.SetCellSize(cell, cell)
    source = Growing()
    sampler.SetInputConnection(source.GetOutputPort())
    counts = []
    for time in times:
        sampler.UpdateTimeStep(time, RANK, RANKS, 0)
        counts.append((sampler.GetNumberOfPlaces(), sampler.GetOutput().GetNumberOfPoints()))
    return counts


def try_time():
    """Another time has another raster: its pieces are output."""
    for counts in on_all_ranks("time", lambda: counts_at_times(0.125, (0.0, 1.0, 0.0))) or ():
        check([places for places, _ in counts] == [64, 256, 64], "places: %r" % counts)
        check(all(points > 0 for _, points in counts), "whether some are here: %r" % counts)


def try_chosen_cells():
    """Their size goes by the points of all: for those of one rank it would be 0.005."""

    def on_ranks():
        data, points = vtkPolyData(), vtkPoints()
        points.SetNumberOfPoints(80000 // RANKS)
        points.GetData().Fill(RANK)
        data.SetPoints(points)
        sampler = raster_of(1)
        sampler.SetInputData(data)
        sampler.SetDimensions(0, 0)
        sampler.UseBoundsOn()
        sampler.SetBounds(0, 1, 0, 0.7)
        sampler.UpdatePiece(RANK, RANKS, 0)
        info = sampler.GetOutputInformation(0)
        return info.Get(Pipeline.WHOLE_EXTENT()), info.Get(vtkDataObject.SPACING()), sampler.GetNumberOfPlaces()

    for found in on_all_ranks("chosen cells", on_ranks) or ():
        check(found == ((0, 499, 0, 349, 0, 0), (0.002, 0.002, 1.0), 500 * 350), "chosen cells: %r" % (found,))


def try_images_behind():
    """Filters for images get the geometry, and do not run after an error."""

    def on_ranks():
        sampler = raster_of(2)
        behind = vtkImageShiftScale()
        behind.SetInputConnection(sampler.GetOutputPort())
        behind.UpdateInformation()
        spacing = behind.GetOutputInformation(0).Get(vtkDataObject.SPACING())
        sampler.GetTriangulation().SetMemoryLimit(1)
        said = Said(sampler)
        behind.UpdatePiece(RANK, RANKS, 0)
        return spacing, behind.GetOutput().GetNumberOfPoints(), sum("MemoryLimit" in error for error in said.errors)

    for spacing, count, errors in on_all_ranks("images behind", on_ranks) or ():
        check(abs(spacing[0] - 0.1) < 1e-9, "the spacing that is announced: %r" % (spacing,))
        check(count == 0 and errors == 1, "after an error: %r" % ((count, errors),))


def try_whole():
    """If the whole raster is requested from each rank, a place counts once, and its memory is estimated."""
    made = pieces(uniform(300), RANKS)

    def on_ranks():
        sampler = make_sampler(made[RANK], {}, {"Dimensions": (400, 400)}, True)
        sampler.Update()
        return (sampler.GetMemoryEstimate(), sampler.GetNumberOfPlaces(), sampler.GetOutput().GetNumberOfPoints(),
                sampler.GetSampleSeconds())

    found = on_all_ranks("whole", on_ranks)
    for rank, (estimate, places, points, seconds) in enumerate(found or ()):
        check(seconds == found[0][3] > 0, "seconds of the longest rank: %r" % seconds)
        check(places == points == 160000, "rank %d: %d places, %d points" % (rank, places, points))
        more = 1024 * (estimate - found[0][0])
        check(rank == 0 or more > 24 * places, "rank %d: %d bytes for places that others have, too" % (rank, more))


def try_surface():
    """A surface as input counts as its points, by a message of one rank."""
    made = pieces(uniform(300), RANKS)

    def on_ranks():
        triangulation = make_filter(made[RANK], {}, True)
        triangulation.SetInputData(make_input(made[RANK]))
        sampler = raster_of(1)
        sampler.SetInputConnection(triangulation.GetOutputPort())
        said = Said(sampler)
        sampler.UpdatePiece(RANK, RANKS, 0)
        return said.warnings

    found = on_all_ranks("surface", on_ranks)
    if found:
        said = [words for words in found[0] if "are not used across ranks" in words]
        check(len(said) == 1, "rank 0 says %r" % found[0])
        check(not any(found[1:]), "others warn: %r" % found[1:])


def try_places_of_an_image():
    """Places that are an image come in pieces, too."""
    made = pieces(uniform(500), RANKS)

    def on_an_image():
        source = vtkRTAnalyticSource()
        source.SetWholeExtent(-5, 5, -4, 4, 0, 0)
        sampler = make_sampler(made[RANK], {}, {}, True)
        sampler.SetPlacesConnection(source.GetOutputPort())
        said = Said(sampler)
        sampler.UpdatePiece(RANK, RANKS, 0)
        check(sampler.GetOutput().GetPointData().HasArray("RTData"), "what the places have is lost")
        return read(sampler, said)

    found = on_all_ranks("image", on_an_image)
    if found:
        check(len({part["extent"] for part in found}) == RANKS, "pieces: %r" % [part["extent"] for part in found])
        values = {}
        for part in found:
            check(not part["errors"], "errors: %r" % part["errors"])
            for point, value in zip(part["points"], part["arrays"]["Elevation"][1]):
                check(values.setdefault(point, value) == value, "two values at %s" % point)
        check(len(values) == 99, "%d places in %r" % (len(values), [part["extent"] for part in found]))


check(RANKS > 1, "to be run on several ranks")
if __name__ == "__main__":
    for k, (case, (given, chosen, *_)) in enumerate(dict(cases(RANKS), **gathered_cases(RANKS)).items()):
        if WANTED in case:
            attempt(case, try_case, k + RANKS, given, chosen)
    check(RANK or WANTED or sum(valued) > 30000, "too few values are compared: %d" % sum(valued))
    check(RANK or WANTED or any(" of Float" in words for words in lacking), "no array lacks values: %r" % lacking)
    for case, (what, said_then) in failures_together().items():
        if WANTED in case:
            attempt(case, try_failure, what, said_then)
    for case, (what, *given) in {
        "again": (try_again, {}), "again by cell size": (try_again, {"RasterSize": 1, "CellSize": (0.07, 0.05)}),
        "image": (try_places_of_an_image,), "other inputs": (try_other_inputs,), "time": (try_time,),
        "images behind": (try_images_behind,), "surface": (try_surface,), "whole": (try_whole,),
        "without effect": (try_without_effect,), "chosen cells": (try_chosen_cells,),
    }.items():
        if WANTED in case:
            attempt(case, what, *given)
    finish()
