# SPDX-License-Identifier: BSD-3-Clause
"""One execution: input and settings into a job, its run, the outputs: Filters/Execution/vtkAHDExecution.h."""

import math
import os
import re
import time
import types

import numpy

from .. import _library as engine
from . import messages, table
from .arrays import bytes_to_convert, coordinates, ghost_marks, ids_of, is_viewable, must_be_converted, view
from .outputs import Diagram, Surface, bytes_per_added_point, plane_transform, write_order

SKIPPED = 1 | 2  # vtkDataSetAttributes' DUPLICATEPOINT and HIDDENPOINT
STEP, SILENCE = 0.01, 1.0 / 12.0  # of the whole; seconds, at most
MOST_BYTES = 2**62
MOST_THREADS = 1024
INPUT = ("points", "skip", "source_points", "line_ids", "line_offsets", "loop_ids", "loop_offsets", "matrix",
         "voronoi_polygon", "surface", "surface_edges", "values", "weights", "keep")


def threads_to_use(backend, wished):
    """For NumberOfThreads: as many as wished; 0: one for each processor, but no more than vtkSMPTools was told."""
    if wished > 0:
        return min(wished, MOST_THREADS)
    tools = backend.vtkSMPTools
    if tools.IsParallelScope() and not tools.GetNestedParallelism():
        return 1
    if tools.GetBackend() == "Sequential":  # answers 1 whatever it was told
        told = os.environ.get("VTK_SMP_MAX_THREADS", "")
        limit = int(told) if told.isdigit() and int(told) > 0 else MOST_THREADS
    else:
        limit = max(1, tools.GetEstimatedNumberOfThreads())
    return min(engine.processors(), limit, MOST_THREADS)


def corners_in(text):
    """(n, 2): the pairs of numbers in VoronoiPolygon; NaN for what is none."""

    def number(word):
        try:
            return float(word) if re.fullmatch("[-+.0-9eE]+", word) else math.nan  # as C++ reads them: no 1_000
        except ValueError:
            return math.nan

    numbers = [number(word) for word in re.split(r"[\s,;]+", text, flags=re.ASCII) if word]
    return numpy.array(numbers + [math.nan] * (len(numbers) % 2), numpy.float64).reshape(-1, 2)


def numbers_of(points, name):
    """The array of this name with one number for each point; None if there is none."""
    array = points.GetPointData().GetArray(name)
    fits = array is not None and array.GetNumberOfComponents() == 1 and (
        array.GetNumberOfTuples() == points.GetNumberOfPoints())
    return array if fits else None


def copied(arrays):
    """(n,) float64: the numbers of these arrays, one behind the other."""
    return numpy.concatenate([
        view(array).reshape(-1).astype(numpy.float64) if is_viewable(array) else
        numpy.array([array.GetComponent(i, 0) for i in range(array.GetNumberOfTuples())], numpy.float64)
        for array in arrays])


def let_go(job):
    """Of all input and callbacks; with them go the counts of the run."""
    job.set_progress(None)
    job.set_projection(None)
    for name in INPUT:
        job.set_array(name, None)


class Progress:
    """Tells a filter's observers, at each hundredth and at least ten times a second; asks whether it is to abort."""

    def __init__(self, algorithm):
        self.algorithm, self.shown, self.told_at = algorithm, 0.0, time.monotonic()

    def is_aborted(self):
        return self.algorithm._input_is_changed or bool(
            self.algorithm.CheckAbort() if hasattr(self.algorithm, "CheckAbort") else self.algorithm.GetAbortExecute())

    def _look_at_input(self):
        """Nothing is read any more once an observer has given an array of it other memory."""
        watched = self.algorithm._watched
        if watched is not None and not watched.are_in_place():
            self.algorithm._watched, self.algorithm._input_is_changed = None, True
            messages.Speaker(self.algorithm._backend, self.algorithm).error(messages.refusal(input_is_changed=1))

    def __call__(self, _phase, fraction):
        moved = fraction >= self.shown + STEP
        if (moved or time.monotonic() - self.told_at >= SILENCE) and not self.is_aborted():
            self.shown = max(self.shown, fraction)
            self.algorithm.UpdateProgress(self.shown)
            self._look_at_input()
            self.told_at = time.monotonic()  # observers take time
        return self.is_aborted()


class Execution:
    """Of a filter with a `job` that it keeps. `bytes_before`: of memory that merging blocks took. `surface`: None, or
    one whose triangles are to be had, of the points that are given (sampling.GivenSurface)."""

    def __init__(self, backend, algorithm, given, source, bytes_before=0, surface=None):
        self.backend, self.algorithm, self.job = backend, algorithm, algorithm._job
        self.given, self.source, self.bytes_before, self.surface = given, source, bytes_before, surface
        self.unfitted = surface.added if surface else 0  # of the points, to which no plane is fitted
        self.values, self.transform = dict(algorithm._values), algorithm._transform  # observers may set others
        mode = self.values["ProjectionPlaneMode"]
        self.fits_plane = mode == 2
        if self.fits_plane:
            self.transform = None
        self.found = types.SimpleNamespace(
            is_projected=bool(self.fits_plane or self.transform), transform_is_missing=mode == 1 and not self.transform,
            diagram_in_plane=False, input_points=given.GetNumberOfPoints(), source_points=0, source_vertices=0,
            source_strips=0, marks_are_unfit=False, unfit_numbers=[], cells=0)
        self.found.adds_bounding = bool(self.values["BoundingTriangulation"]) and not self.found.is_projected
        self.simplifies = self.values["MaximumError"] > 0.0 or self.values["MaximumNumberOfVertices"] > 0
        self.names_numbers, self.numbers = False, {}
        self._find_numbers()
        self.copies_kept = bool(self.values["KeptPointsOnly"] and self.simplifies) and not (
            self.values["GeneratePointStatus"] or self.values["GenerateErrors"])

    def _find_numbers(self):
        """The arrays that the settings name, by their names for the job; of the source behind those of the input."""
        adds = self.source is not None and self.values["SourceMode"] and self.source.GetNumberOfPoints() > 0
        for name, setting, is_read in (
                ("values", "ValueArrayName", self.simplifies or self.values["GenerateErrors"]),
                ("weights", "WeightArrayName", self.simplifies), ("keep", "KeepArrayName", self.simplifies)):
            array = self.values[setting]
            if not is_read or array in ("", "None"):
                continue
            self.names_numbers, found = True, numbers_of(self.given, array)
            if found is None:
                self.found.unfit_numbers += [array] if self.given.GetNumberOfPoints() else []
                continue
            more = numbers_of(self.source, array) if adds and name == "values" else None
            self.numbers[name] = [found] + ([] if more is None else [more])

    def run(self, outputs):
        """Fills the outputs. engine.EngineError where it came to nothing: then they may have a part."""
        self._give_settings()
        self._give_input()
        self.job.set_progress(Progress(self.algorithm))
        self.job.run()
        self._write(outputs)

    def triangulate(self, progress, other_memory):
        """Without outputs, for one who interpolates: `other_memory`, in bytes, is his. engine.EngineError."""
        self._give_settings()
        self.announce(other_memory)
        self._give_input()
        self.job.set_progress(progress)
        self.job.run()
        self.found.cells = self.job.count("triangles")

    def announce(self, other_memory):
        """Values between the points, for which so many bytes are taken."""
        other = self._other_memory() + int(other_memory)
        self.job.set(want_samples=True, other_memory=min(other, MOST_BYTES),
                     other_memory_per_point=bytes_per_added_point(self.given))  # of the data that there are by now

    def announce_all(self):
        """For an estimate of the whole, without outputs."""
        self._give_settings()
        self._give_input()
        self.announce(0)

    def expected_points(self):
        source = self.source if self.values["SourceMode"] else None
        return self.found.input_points + (source.GetNumberOfPoints() if source else 0) + 8 * self.found.adds_bounding

    def bytes_to_find_places(self):
        """For where the points lie in the plane, a copy if they do not lie there or others come to them."""
        count = self.expected_points()
        copied = self.found.is_projected or count > self.found.input_points
        return self.bytes_before + self.bytes_converted() + 25 * count * copied

    def _give_settings(self):
        values = self.values
        self.job.set(**{name: values[of_filter] for name, of_filter in table.SAME.items()})
        for name, on in (("triangles", "AlphaTris"), ("lines", "AlphaLines"), ("vertices", "AlphaVerts")):
            self.job.set(**{"alpha_" + name: bool(values[on])})
        if values["GenerateVoronoi"] and values["VoronoiClip"] == engine.CLIP_POLYGON:
            self.job.set_array("voronoi_polygon", corners_in(values["VoronoiPolygon"]))
        limit = values["MemoryLimit"]
        self.job.set(
            bounding=self.found.adds_bounding, skip_mask=SKIPPED,
            source_heights=values["SourceHeights"] if values["SourceMode"] else 0,
            threads=threads_to_use(self.backend, values["NumberOfThreads"]),
            memory_limit=min(limit * 1024 + 1023, MOST_BYTES) if limit else 0,
            other_memory=self._other_memory(), other_memory_per_point=self._bytes_per_point())

    def _bytes_per_point(self):
        """Of point data, where points are added; if those kept are shown alone, of copies, numbers and ids, too."""
        data = bytes_per_added_point(self.given)
        return 2 * data + 44 if self.copies_kept else data

    def _other_memory(self):
        """Bytes that VTK's arrays take, beyond those that the job knows of."""
        # The polygons of the Voronoi diagram have a copy of the point data.
        copied = self.given.GetPointData().GetActualMemorySize() if self.values["GenerateVoronoi"] else 0
        return self.bytes_before + self.bytes_converted() + 1024 * copied

    def bytes_converted(self):
        source = self.source if self.values["SourceMode"] else None
        cells = (self.source.GetLines(), self.source.GetPolys()) if self.source else ()
        return sum(24 * points.GetNumberOfPoints() for points in (
            self.given.GetPoints(), source.GetPoints() if source else None) if must_be_converted(points)) + sum(
                bytes_to_convert(self.backend, some) for some in cells) + (
                    self.surface.bytes_to_convert() if self.surface else 0) + sum(
                        (1 if name == "keep" else 8) * array.GetNumberOfTuples()
                        for name, arrays in self.numbers.items() for array in arrays)

    def _give_input(self):
        vtk, job = self.backend, self.job
        job.set_array("points", coordinates(vtk, self.given.GetPoints()))
        marks, self.found.marks_are_unfit = ghost_marks(self.given)
        job.set_array("skip", marks)
        source = self.source
        if source is not None:
            if self.values["SourceMode"]:
                job.set_array("source_points", coordinates(vtk, source.GetPoints()))
            for name, what, cells in (
                    ("line", "lines", source.GetLines()), ("loop", "polygons", source.GetPolys())):
                offsets, ids = ids_of(vtk, cells, what + " of the source")
                job.set_array(name + "_ids", ids)
                job.set_array(name + "_offsets", offsets)
            self.found.source_points = source.GetNumberOfPoints()
            self.found.source_vertices = source.GetNumberOfVerts()
            self.found.source_strips = source.GetNumberOfStrips()
            if self.found.source_strips:
                job.set(points_as_line=0)
        self._give_numbers()
        job.set(first_cell=self.found.source_vertices, unfitted_points=self.unfitted)  # verts come before lines
        if self.surface is not None:
            self.found.marks_are_unfit = False  # they are not looked at
            self.surface.give(job)
        self._give_plane()

    def _give_numbers(self):
        """Copies, since observers may write to the arrays, and these may be of any type."""
        for name, arrays in self.numbers.items():
            numbers = copied(arrays)
            self.job.set_array(name, (numbers != 0).view(numpy.uint8) if name == "keep" else numbers)

    def _give_plane(self):
        if self.transform is None:
            self.job.set(plane=engine.PLANE_BEST_FIT if self.fits_plane else engine.PLANE_XY)
            return
        self.transform.Update()
        if self.transform.IsA("vtkLinearTransform"):
            matrix = self.transform.GetMatrix()
            self.job.set_array("matrix", numpy.array(
                [[matrix.GetElement(row, column) for column in range(4)] for row in range(4)]))
            self.job.set(plane=engine.PLANE_MATRIX)
        else:
            self.job.set_projection(self._project)
            self.job.set(plane=engine.PLANE_CALLBACK)

    def _project(self, xyz):
        """Through the method that takes many points: those that not every transform can do one by one."""
        vtk = self.backend
        before, after = vtk.vtkPoints(), vtk.vtkPoints()
        before.SetDataTypeToDouble()
        after.SetDataTypeToDouble()
        before.SetNumberOfPoints(len(xyz))
        coordinates(vtk, before)[:] = xyz
        before.Modified()
        self.transform.TransformPoints(before, after)
        xyz[:] = coordinates(vtk, after)

    def _write(self, outputs):
        values, job = self.values, self.job
        surface = Surface(self.backend, job, values, outputs[0])
        surface.write_points(self.given, self.source)
        surface.write_cells()
        surface.add_crossings()
        surface.add_arrays()
        if values["GenerateVoronoi"]:
            self._write_diagram(outputs)
        if values["GenerateInsertionCurve"] or values["GenerateBoxes"]:
            write_order(self.backend, job, outputs[1])
        if self.copies_kept:
            surface.keep_points_of_cells(self.given)
        self.found.cells = outputs[0].GetNumberOfCells()

    def _write_diagram(self, outputs):
        diagram = Diagram(self.backend, outputs[2])
        diagram.write(self.job, outputs[0])
        if self.found.is_projected:
            to_plane = self.transform or plane_transform(self.backend, self.job.array("plane_matrix"))
            self.found.diagram_in_plane = not diagram.move_back(to_plane)

    def measures(self):
        """The filter's measures, but those of all executions."""
        count, measured = self.job.count, self.job.measures()
        return {name: sum(measured[part] if part in measured else count(part) for part in parts)
                for name, parts in table.OF_JOB.items()}

    def warnings(self, limit_is_told=False):
        return messages.warnings(self.job, self.values, self.found, limit_is_told)
