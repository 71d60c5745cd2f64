# SPDX-License-Identifier: BSD-3-Clause
"""DistributePoints: several ranks (pvbatch --sym) give what one does, and fail together.

    mpiexec -n RANKS pvbatch --sym RanksCompare.py

Each rank writes its result into AHD_SCRATCH, and rank 0 compares it with its own result for all inputs appended.
It runs all cases whatever it finds, so that no rank waits for one that has given up.
"""

import os
import pickle
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import (
    VTK_STRING, vtkBitArray, vtkDoubleArray, vtkFloatArray, vtkIdList, vtkPoints, vtkStringArray, vtkTypeInt64Array,
    vtkUnsignedCharArray,
)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D
from rankcases import PARTIAL, WITHOUT_EFFECT, Piece, appended, cases, counts_of, other_values, pieces, uniform

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
SCRATCH = os.environ["AHD_SCRATCH"]
TYPES = {"float": vtkFloatArray, "double": vtkDoubleArray, "long": vtkTypeInt64Array, "byte": vtkUnsignedCharArray,
         "bit": vtkBitArray, "text": vtkStringArray}
NUMBERS = {"float": 10, "double": 11, "int": 6}
COUNTS = counts_of("delaunay")
failures = []


def check(condition, what):
    if not condition:
        raise AssertionError(what)


# ------------------------------------------------------------------------------------ data sets


def make_points(points, number):
    made = vtkPoints()
    made.SetDataType(NUMBERS[number])
    for point in points:
        made.InsertNextPoint(point)
    return made


def make_array(name, kind, values):
    array = TYPES[kind]()
    array.SetName(name)
    if values and isinstance(values[0], tuple):
        array.SetNumberOfComponents(len(values[0]))
        array.SetComponentName(1, "the second")
        for value in values:
            array.InsertNextTuple(value)
    else:
        for value in values:
            array.InsertNextValue(value)
    return array


def make_input(piece):
    data = vtkPolyData()
    data.SetPoints(make_points(piece.points, piece.number))
    for name, (kind, values) in piece.arrays.items():
        data.GetPointData().AddArray(make_array(name, kind, values))
    if "Float" in piece.arrays:
        data.GetPointData().SetActiveScalars("Float")
    if "Long" in piece.arrays:
        data.GetPointData().SetActiveAttribute("Long", vtkDataSetAttributes.PEDIGREEIDS)
    if piece.marks is not None:
        data.GetPointData().AddArray(make_array("vtkGhostType", "byte", piece.marks))
    return data


def make_source(source, arrays=None):
    points, lines, polygons = source
    data = vtkPolyData()
    data.SetPoints(make_points(points, "double"))
    for name, (kind, values) in (arrays or {}).items():
        data.GetPointData().AddArray(make_array(name, kind, values))
    for cells, put in ((lines, data.SetLines), (polygons, data.SetPolys)):
        array = vtkCellArray()
        for ids in cells:
            array.InsertNextCell(len(ids), ids)
        put(array)
    return data


# ------------------------------------------------------------------------------------ executions


class Said:
    def __init__(self, algorithm):
        self.errors, self.warnings = [], []

        @calldata_type(VTK_STRING)
        def hear(_, event, text):
            text = text.split("): ", 1)[-1].strip()
            (self.errors if event == "ErrorEvent" else self.warnings).append(text)

        algorithm.AddObserver("ErrorEvent", hear)
        algorithm.AddObserver("WarningEvent", hear)
        executive = algorithm.GetExecutive()
        executive.AddObserver("ErrorEvent", hear)
        executive.AddObserver("WarningEvent", hear)


def make_filter(piece, settings, distribute):
    algorithm = vtkAdaptiveHilbertDelaunay2D()
    algorithm.SetDistributePoints(distribute)
    if not distribute:
        algorithm.SetController(None)
    algorithm.SetKeepTriangulation(False)
    for name, value in settings.items():
        if name == "Transform":
            turn = vtkTransform()
            turn.RotateX(30)
            turn.RotateZ(20)
            algorithm.SetTransform(turn)
        elif hasattr(algorithm, "Set" + name):
            getattr(algorithm, "Set" + name)(value)
    if isinstance(piece, Piece):
        algorithm.SetInputData(make_input(piece))
        if piece.source:
            algorithm.SetSourceData(make_source(piece.source, piece.source_arrays))
    elif piece is not None:
        algorithm.SetInputDataObject(0, piece)
    return algorithm


def value_of(array, i):
    if isinstance(array, vtkStringArray):
        return array.GetValue(i)
    return repr(array.GetTuple(i)) if not isinstance(array, vtkTypeInt64Array) else array.GetValue(i)


def read(algorithm, said):
    """The outputs as plain values."""
    out = algorithm.GetOutput()
    data, count = out.GetPointData(), out.GetNumberOfPoints()
    ids = data.GetGlobalIds()
    marks = data.GetArray("vtkGhostType")
    name = [ids.GetValue(i) if ids else i for i in range(count)]
    own = {"GlobalPointIds", "vtkGhostType"}
    arrays = {array.GetName(): [value_of(array, i) for i in range(count)]
              for array in (data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays()))
              if array.GetName() not in own}
    every, polys, corners = [], out.GetPolys(), vtkIdList()
    edges = out.GetCellData().GetArray("ConstraintEdges")
    cell_marks = out.GetCellData().GetArray("vtkGhostType")
    cell_ids = out.GetCellData().GetGlobalIds()
    for cell in range(polys.GetNumberOfCells()):
        polys.GetCellAtId(cell, corners)
        triple = [name[corners.GetId(k)] for k in range(3)]
        flags = int(edges.GetValue(cell)) if edges else 0
        bits = [flags >> k & 1 for k in range(3)]
        first = triple.index(min(triple))
        every.append(tuple(triple[first:] + triple[:first] + bits[first:] + bits[:first]))
    used = {i for triangle in every for i in triangle[:3]}
    numbers = [cell_ids.GetValue(i) for i in range(len(every))] if cell_ids else []
    ghosts = [i for i in range(len(every)) if cell_marks and cell_marks.GetValue(i) == 1]
    own = len(every) - len(ghosts)
    check(ghosts == list(range(own, len(every))), "ghost cells are not behind own ones")
    crossings = out.GetFieldData().GetArray("Crossings")
    return {
        "names": name,
        "unused": [name[i] for i in range(count) if name[i] not in used],
        "marks": [int(marks.GetValue(i)) for i in range(count)] if marks else [0] * count,
        "places": [repr(out.GetPoint(i)) for i in range(count)],
        "number": out.GetPoints().GetDataType() if count else None,
        "arrays": arrays,
        "attributes": {kind: data.GetAbstractAttribute(kind).GetName()
                       for kind in range(vtkDataSetAttributes.NUM_ATTRIBUTES)
                       if data.GetAbstractAttribute(kind) and kind != vtkDataSetAttributes.GLOBALIDS},
        "triangles": every[:own],
        "cell ids": numbers[:own],
        "ghosts": [(numbers[i], every[i]) for i in ghosts],
        "has cell marks": cell_marks is not None,
        "counts": {count: getattr(algorithm, "Get" + count)() for count in COUNTS},
        "crossings": [crossings.GetTuple(i) for i in range(crossings.GetNumberOfTuples())] if crossings else [],
        "errors": said.errors,
        "warnings": said.warnings,
    }


def on_all_ranks(name, work):
    """Runs it on each rank; returns all results on rank 0, else None."""
    try:
        result = work()
    except Exception:  # the other ranks wait
        result = traceback.format_exc()
    path = os.path.join(SCRATCH, "%s of %d, rank %%d.pickle" % (name, RANKS))
    with open(path % RANK, "wb") as file:
        pickle.dump(result, file)
    CONTROLLER.Barrier()
    if RANK:
        return None
    every = []
    for rank in range(RANKS):
        with open(path % rank, "rb") as file:
            every.append(pickle.load(file))
        os.remove(path % rank)
    for rank, result in enumerate(every):
        if isinstance(result, str):  # words of large results take long
            raise AssertionError("rank %d: %s" % (rank, result))
    return every


def run(piece, settings, distribute=True, prepare=None):
    algorithm = make_filter(piece, settings, distribute)
    said = Said(algorithm)
    if prepare:
        prepare(algorithm)
    if distribute:
        algorithm.UpdatePiece(RANK, RANKS, settings.get("GhostLevels", 0))
    else:
        algorithm.Update()
    return read(algorithm, said)


# ------------------------------------------------------------------------------------ comparisons


def compare(found, expected):
    check(not any(part["errors"] for part in found), "errors: %r" % [part["errors"] for part in found])
    triangles = sorted(triangle for part in found for triangle in part["triangles"])
    check(triangles == sorted(expected["triangles"]), "%d triangles, not the %d of one rank" % (
        len(triangles), len(expected["triangles"])))
    cells = sorted(i for part in found for i in part["cell ids"])
    check(cells == list(range(len(triangles))), "the global ids of cells have gaps or come twice")
    seen = set()
    for part in found:
        check(part["number"] in (None, expected["number"]), "type of the points: %r, not %r" % (
            part["number"], expected["number"]))
        check(part["counts"] == expected["counts"], "counts: %r, not %r" % (part["counts"], expected["counts"]))
        check(part["crossings"] == expected["crossings"], "crossings")
        check(not part["names"] or part["attributes"] == expected["attributes"],
              "attributes: %r, not %r" % (part["attributes"], expected["attributes"]))
        if part["names"]:
            check(set(part["arrays"]) == set(expected["arrays"]), "arrays: %r, not %r" % (
                sorted(part["arrays"]), sorted(expected["arrays"])))
        for k, name in enumerate(part["names"]):
            is_foreign = part["marks"][k] != expected["marks"][name]
            check(not is_foreign or name not in part["unused"], "point %d of another rank is no corner" % name)
            check(not is_foreign or part["marks"][k] == expected["marks"][name] | 1, "mark of point %d" % name)
            check(is_foreign or name not in seen, "point %d comes twice" % name)
            if not is_foreign:
                seen.add(name)
            check(part["places"][k] == expected["places"][name], "place of point %d" % name)
            for array, values in part["arrays"].items():
                check(values[k] == expected["arrays"][array][name], "%s of point %d: %r, not %r" % (
                    array, name, values[k], expected["arrays"][array][name]))
    check(len(seen) == len(expected["names"]), "%d points of %d" % (len(seen), len(expected["names"])))
    check(not any(part["warnings"] for part in found[1:]), "other ranks warn too")


def compare_ghosts(found, expected, levels):
    """Layer after layer, each as its owner has it."""
    cells = {number: cell for part in found for number, cell in zip(part["cell ids"], part["triangles"])}
    for rank, part in enumerate(found):
        check(part["has cell marks"] == (levels > 0), "rank %d: the marks of cells" % rank)
        own = set(part["cell ids"])
        points = {name for name, mark in zip(part["names"], part["marks"]) if mark == expected["marks"][name]}
        points |= {point for number in own for point in cells[number][:3]}
        layers = set()
        for _ in range(levels):
            layers = {number for number, cell in cells.items() if points.intersection(cell[:3])}
            points |= {point for number in layers for point in cells[number][:3]}
        wanted = [(number, cells[number]) for number in sorted(layers - own)]
        check(part["ghosts"] == wanted, "rank %d: %d ghosts, not %d, or others" % (
            rank, len(part["ghosts"]), len(wanted)))


def compare_warnings(name, found, expected):
    """Word for word, except messages about ranks."""
    said = list(found["warnings"])
    told = [text for text in expected["warnings"] if "each triangulates its own points" not in text]
    if name == "partial arrays":
        text = said.pop()
        check(text.endswith(PARTIAL), "the warning about arrays: " + text)
    if name == "all dropped":
        check(said and "keep none" in said[0] and said[1:] == told[1:], "warnings: %r, not %r" % (said, told))
        return
    check(said == told, "warnings: %r, not %r" % (said, told))


def try_case(name, made, settings):
    settings = dict(settings)
    if settings.pop("turn", False):
        for piece in made:
            piece.source[2][0].reverse()
    found = on_all_ranks("case", lambda: run(made[RANK], settings))
    if RANK:
        return
    expected = run(appended(made, settings), settings, distribute=False)
    if not settings.get("Transform") and "not finite" != name:
        empty = ("nothing", "two points", "one line", "all dropped", "no edge is short", "ghosts of nothing",
                 "bounding points of nothing", "a fitted plane of nothing", "a fitted plane of a line",
                 "all is trimmed")
        check(name in empty or len(expected["names"]) < 3 or expected["triangles"], "no triangle to compare")
        is_trimmed = "trimmed" in name and name != "trimmed in a plane"
        check(not is_trimmed or expected["counts"]["NumberOfTrimmedTriangles"] > 50, "nothing is trimmed")
    compare(found, expected)
    compare_ghosts(found, expected, settings.get("GhostLevels", 0))
    compare_warnings(name, found[0], expected)


# ------------------------------------------------------------------------------------ failing together


def failures_together():
    """name -> (the action of each rank, words of the one error on each; None: no error)"""
    some = pieces(uniform(300), RANKS)
    last = RANK == RANKS - 1

    def abort(algorithm):
        if last:
            algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
            algorithm.SetAbortExecute(1)

    def with_(made=some, prepare=None, **settings):
        return lambda: run(made[RANK], settings, prepare=prepare)

    return {
        **{name: (with_(**needed, **({name: other} if last else {})), name + " is not the same")
           for name, other, needed in other_values("delaunay")},
        "different planes": (with_(Rim=1, **({"Transform": True} if last else {})), "Transform is not the same"),
        "a limit on memory": (with_(MemoryLimit=1), "MemoryLimit allows 1.02 KB"),
        "a limit on one rank": (with_(MemoryLimit=int(last)), "may take"),
        "abort": (with_(prepare=abort), None),
    }


def try_failure(name, work, words):
    found = on_all_ranks("failure", work)
    for rank, part in enumerate(found or ()):
        check(not part["names"] and not part["triangles"], "rank %d puts something out" % rank)
        check(not any(part["counts"].values()), "rank %d counts" % rank)
        check(len(part["errors"]) == (words is not None), "rank %d says %r" % (rank, part["errors"]))
        check(words is None or words in part["errors"][0], "rank %d: %r" % (rank, part["errors"]))
        check(part["errors"] == found[0]["errors"], "rank %d says something else than rank 0" % rank)


def try_without_effect():
    """Differing settings without effect do not stop ranks."""
    made, last = pieces(uniform(300), RANKS), RANK == RANKS - 1

    def on_ranks():
        return [run(made[RANK], dict(settings, **(other if last else {}))) for settings, other in WITHOUT_EFFECT]

    found = on_all_ranks("without effect", on_ranks)
    for k, (settings, _) in enumerate(WITHOUT_EFFECT if found else ()):
        compare([part[k] for part in found], run(appended(made, settings), settings, distribute=False))


def try_odd_inputs(name, odd):
    """The last rank has no input, or one without points: the others go on."""
    made = pieces(uniform(400), RANKS - 1) + [Piece([])]
    found = on_all_ranks("input", lambda: run(odd if RANK == RANKS - 1 else made[RANK], {}))
    if RANK:
        return
    said = found[-1]["warnings"]
    check([("has no points" in text) for text in said] == [True] * (odd is not None), "the last rank says %r" % said)
    found[-1]["warnings"] = []
    expected = run(appended(made, {}), {}, distribute=False)
    compare(found, expected)


def try_pipeline():
    """No ghost levels are requested, and no rank outputs old results once others have changed."""
    made = pieces(uniform(300), RANKS)
    algorithm = make_filter(made[RANK], {}, True)
    said = Said(algorithm)

    def twice():
        algorithm.UpdatePiece(RANK, RANKS, 1)
        asked = algorithm.GetInputInformation().Get(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_GHOST_LEVELS())
        check(asked == 0, "%r ghost levels are asked for" % asked)
        algorithm.SetFillRule(1)
        algorithm.UpdatePiece(RANK, RANKS, 1)
        return read(algorithm, said)

    found = on_all_ranks("pipeline", twice)
    if found:
        expected = run(appended(made, {}), {}, distribute=False)
        compare(found, expected)
        compare_ghosts(found, expected, 1)


def try_more_ghosts():
    """Ranks that requested fewer layers before get those requested by one rank, if they fit."""
    made = pieces(uniform(300), RANKS)
    algorithm = make_filter(made[RANK], {}, True)
    said = Said(algorithm)

    def with_more():
        algorithm.UpdatePiece(RANK, RANKS, 0)
        before = read(algorithm, said)
        algorithm.UpdatePiece(RANK, RANKS, 2 if RANK == 0 else 1)
        after = read(algorithm, said)
        algorithm.SetMemoryLimit(algorithm.GetMemoryEstimate() - 1)
        algorithm.UpdatePiece(RANK, RANKS, 2)
        check(len(said.errors) == 1 and "ghost cells included" in said.errors[0], "errors: %r" % said.errors)
        check(algorithm.GetOutput().GetNumberOfPoints() == 0, "ghosts that do not fit")
        return dict(before, errors=[]), dict(after, errors=[])

    found = on_all_ranks("more ghosts", with_more)
    if found:
        expected = run(appended(made, {}), {}, distribute=False)
        for levels, parts in zip((0, 2), zip(*found)):
            compare(parts, expected)
            compare_ghosts(parts, expected, levels)


def try_again_after_abort():
    """An execution aborted on one rank is repeated by all, although nothing has changed on the others."""
    made = pieces(uniform(300), RANKS)
    algorithm = make_filter(made[RANK], {}, True)
    said = Said(algorithm)

    def again():
        if RANK == RANKS - 1:
            algorithm.SetAbortExecute(1)
        algorithm.UpdatePiece(RANK, RANKS, 0)
        check(algorithm.GetOutput().GetNumberOfPoints() == 0, "an output after an abort")
        algorithm.SetAbortExecute(0)
        algorithm.UpdatePiece(RANK, RANKS, 0)
        return read(algorithm, said)

    found = on_all_ranks("again", again)
    if found:
        compare(found, run(appended(made, {}), {}, distribute=False))


def attempt(name, work, *arguments):
    try:
        work(*arguments)
    except Exception:  # the other ranks continue
        failures.append(name)
        print("rank %d, %s:" % (RANK, name), traceback.format_exc(), flush=True)


def finish():
    """Prints the outcome, and exits with a status on failure."""
    print("rank %d of %d: %s" % (RANK, RANKS, "failed: " + ", ".join(failures) if failures else "passed"), flush=True)
    sys.stdout.flush()
    if failures:
        sys.exit(1)


check(RANKS > 1, "to be run on several ranks")
WANTED = os.environ.get("AHD_RANK_CASES", "")
if __name__ == "__main__":
    for case, (made, settings) in cases(RANKS).items():
        if WANTED in case:
            attempt(case, try_case, case, made, settings)
    for case, (work, words) in failures_together().items():
        if WANTED in case:
            attempt(case, try_failure, case, work, words)
    for case, odd in (("no input", None), ("a table", vtkTable())):
        if WANTED in case:
            attempt(case, try_odd_inputs, case, odd)
    others = {"without effect": try_without_effect, "pipeline": try_pipeline, "more ghosts": try_more_ghosts,
              "again": try_again_after_abort}
    for case, work in others.items():
        if WANTED in case:
            attempt(case, work)
    finish()
