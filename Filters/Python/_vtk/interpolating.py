# SPDX-License-Identifier: BSD-3-Clause
"""One execution of vtkAdaptiveHilbertInterpolation2D: Filters/Sampling/vtkAHDSampleExecution.cxx."""

import math
import time
import types

import numpy

from .. import _library as engine
from .._raster import Raster
from . import messages, raster, raster_messages, table
from .arrays import GHOSTS, must_be_converted, new_array, view
from .blocks import MOST_POINTS
from .columns import NEAREST, Columns, blocks_of
from .execution import Execution, Progress, threads_to_use
from .lent import borrow
from .sampling import SampledSurface, area_of

HIDDENPOINT = 2  # of vtkDataSetAttributes
TRIANGULATION = 0.7  # how much of the time it takes, about
KEPT_BYTES = 110  # of a triangulation, for each point


class Stopped(Exception):
    """The output is empty. `text`: the error to report, None if the work was aborted. `estimate`: KiB."""

    def __init__(self, text=None, estimate=0):
        super().__init__(text)
        self.text, self.estimate = text, estimate


class _Stage(Progress):
    """A part of the work, from `first` on and so long, of 1."""

    def __init__(self, algorithm, first, length):
        super().__init__(algorithm)
        self.first, self.length = first, length

    def __call__(self, phase, fraction):
        return super().__call__(phase, self.first + self.length * fraction)


class Interpolating:
    """Of a filter. `asked`: the filter with the settings of the triangulation, these, and those of the interpolation,
    as they were when the execution began, and the surface that is given or None; `merged`: the points and constraints;
    `places`: of one piece, None for a raster. The triangulation is kept until the last piece is done. `pieces`: the
    places of all, if they are several; the first piece answers for the memory of all."""

    def __init__(self, algorithm, asked, merged, places, speaker, is_first=True, is_last=True, pieces=()):
        self.algorithm, self.backend, self.job = algorithm, algorithm._backend, algorithm._job
        self.triangulation, self.values, self.wishes, self.surface, self.speaker = *asked, speaker
        self.given, self.source, self.bytes_before = merged.input, merged.source, merged.bytes
        self.places, self.cells, self.count, self.points = places, None, 0, 0
        self.is_kept = self.is_triangulated = False
        self.bytes_behind = 0
        self.is_first, self.is_last = is_first, is_last
        self.pieces = pieces if is_first else ()

    def run(self, made):
        """Fills the output; returns what the places came to, which warnings are said of. Stopped."""
        try:
            if _Stage(self.algorithm, 0.0, 0.0).is_aborted():
                raise Stopped
            self._find_places()
            self._take_surface()
            found = self._interpolate(made)
            self._keep()
            return found
        except raster.Fault as fault:
            raise Stopped(raster_messages.of_raster(fault, self.wishes)) from None
        except engine.EngineError as error:
            raise Stopped(*self._what_went_wrong(error)) from None
        except MemoryError:
            raise Stopped(*self._memory_is_short(False)) from None

    def _find_places(self):
        """Where values are wanted. raster.Fault."""
        if self.places is not None:
            self.count = self.places.GetNumberOfPoints()
            return
        points = self.given.GetNumberOfPoints()
        try:
            if self.wishes["UseBounds"]:
                self.cells = raster.make_raster_within(self.wishes, self.wishes["Bounds"], points)
            else:
                self._check_memory_to_find_places()
                self.cells = raster.make_raster(self.wishes, area_of(
                    self.backend, self.triangulation, self.values, self.given, self.source, self.surface), points)
        except raster.Fault as fault:
            if fault.kind != raster.NO_AREA:
                raise
            self.cells = raster.NONE
        self.count = self.cells.count()

    def _check_memory_to_find_places(self):
        """The copy that the compiled class takes to find out where the raster lies. Stopped."""
        asked = self._execution()
        limit = self.values["MemoryLimit"]
        allowed = limit or engine.available_memory() // 1024
        if asked.bytes_to_find_places() // 1024 <= allowed:
            return
        asked.announce_all()
        columns, rows = self.wishes["Dimensions"]
        is_unknown = self.wishes["RasterSize"] == 1 or raster.is_chosen(self.wishes)
        places = -1 if is_unknown else columns * rows
        estimate = asked.job.estimate() // 1024
        raise Stopped(raster_messages.of_memory(
            places, asked.expected_points(), estimate, allowed, limit > 0, True), estimate)

    def _execution(self):
        """One that triangulates, to be asked what it takes, with a job of its own."""
        asked = types.SimpleNamespace(
            _job=engine.Job(), _values=dict(self.values), _transform=self.triangulation.GetTransform())
        return Execution(self.backend, asked, self.given, self.source, self.bytes_before, self.surface)

    def _estimate_behind(self):
        """Bytes that interpolating takes, as the compiled class's (vtkAHDSampleExecution::EstimateSampling): columns
        and output, places, and the engine's own."""
        data = self.given.GetPointData()
        columns = Columns(self.backend, self.wishes, data, data, self.given.GetNumberOfPoints())
        if self.places is None:
            beside = 25 if self.wishes["OutputType"] else 1
            return beside * self.count + self._estimate_at(columns, self._raster(), self.count)
        if not self.pieces:
            return self._estimate_of(columns, self.places)
        outputs = [columns.output_bytes(piece.GetNumberOfPoints()) for piece in self.pieces]
        return sum(outputs) + max(
            self._estimate_of(columns, piece) - output for piece, output in zip(self.pieces, outputs))

    def _estimate_of(self, columns, places):
        """Of one piece: its places in the plane, and x and y of these."""
        count = places.GetNumberOfPoints()
        lie = places.IsA("vtkPointSet")
        copies = (lie and must_be_converted(places.GetPoints())) + (not lie or self._is_projected())
        return (24 * copies + 16) * count + self._estimate_at(columns, count, count)

    def _estimate_at(self, columns, places, count):
        is_nearest = self.wishes["Method"] == NEAREST
        return columns.estimate_bytes(self.points, count) + self.job.sample_estimate_before(
            min(self.points, MOST_POINTS), places, 1 if is_nearest else columns.components(),
            self.wishes["Outside"] != 0 and not is_nearest)

    def _raster(self):
        return Raster(self.cells.origin, self.cells.spacing, (self.cells.rows, self.cells.columns))

    def _is_projected(self):
        mode = self.values["ProjectionPlaneMode"]
        return mode == 2 or (mode == 1 and self.triangulation.GetTransform() is not None)

    def _take_surface(self):
        """The surface that was kept, or a new one in its place. engine.EngineError."""
        filter_, source = self.algorithm, self.source
        kept = filter_._surface
        self.points = self._execution().expected_points()
        may_keep = self.values["KeepTriangulation"] or not self.is_last
        self.is_kept = not self.is_first or bool(  # all pieces are of one surface, whatever observers do meanwhile
            may_keep and kept is not None and kept.is_of(self.triangulation, self.given, source, self.surface))
        self.bytes_behind = self._estimate_behind()
        if not self.is_kept and self.surface is not None:
            lent = borrow(self._execution())
            if lent is not None:
                self.algorithm._let_go()
                filter_._surface, self.is_kept, kept = lent, True, lent
        if self.is_kept:
            self.is_triangulated = True
            self.job = kept.job
            kept.take_data(self.given, source)
            self._check_memory(kept)
            return
        if kept is not None:
            filter_._surface = None
            kept.give_back()
        filter_._surface = SampledSurface(
            self.backend, self.job, self.triangulation, self.values, self.given, source, self.bytes_before,
            self.surface)
        try:
            filter_._values["NumberOfTriangulations"] += 1
            filter_._surface.make(_Stage(filter_, 0.0, TRIANGULATION), self.bytes_behind, may_keep)
        except engine.EngineError as error:
            nothing_was_done = error.status in (engine.MEMORY_LIMIT, engine.BAD_ARRAY)
            filter_._values["NumberOfTriangulations"] -= nothing_was_done
            raise
        self.is_triangulated = True
        for text in filter_._surface.execution.warnings():
            self.speaker.warn(text)

    def _check_memory(self, kept):
        """Is there enough for interpolating on a surface that is there?"""
        limit = self.values["MemoryLimit"]
        allowed = limit or engine.available_memory() // 1024
        if (kept.estimate(self.bytes_behind) if limit else self.bytes_behind) // 1024 > allowed:
            raise Stopped(*self._memory_is_short(True))

    def _memory(self):
        """KiB, of all."""
        kept = self.algorithm._surface
        if self.is_kept and kept is not None:
            return int(kept.estimate(self.bytes_behind)) // 1024
        return self.job.count("memory_estimate") // 1024

    def _memory_is_short(self, is_refused):
        limit = self.values["MemoryLimit"]
        allowed = limit or (engine.available_memory() if self.is_kept else self.job.count("memory_allowed")) // 1024
        estimate = self._memory()
        count = sum(piece.GetNumberOfPoints() for piece in self.pieces) or self.count
        return raster_messages.of_memory(
            count, self.points, estimate, allowed, limit > 0, is_refused), estimate

    def _what_went_wrong(self, error):
        """Text and estimate, for Stopped."""
        if error.status in (engine.MEMORY_LIMIT, engine.OUT_OF_MEMORY):
            return self._memory_is_short(error.status == engine.MEMORY_LIMIT)
        if self.surface is not None and self.job.count("folded_triangles"):
            return messages.refusal(folded_triangles=self.job.count("folded_triangles"),
                                    triangles=self.surface.triangles), self._memory()
        return messages.error_text(error.status, self.job, str(error)), self._memory()

    def _interpolate(self, made):
        started, surface = time.monotonic(), self.algorithm._surface
        xy, found = None, types.SimpleNamespace()
        if self.places is not None:
            xy = surface.places_in_plane(self.places)
        columns = Columns(self.backend, self.wishes, self.given.GetPointData(), surface.point_data(),
                          self.job.count("points"))
        heights = surface.heights()
        mask = self._sample(columns, heights, xy, found)
        found.missing = []
        if found.counts["sampled_without_value"] + found.counts["sampled_left_out"]:
            added = self.surface.added if self.surface else self.job.count("added_points")
            found.missing = columns.find_missing(self.job, heights, self.job.count("points") - added)
        if self.places is not None:
            self.places.put_into(made)
        elif self.wishes["OutputType"]:
            self._write_surface(made, view(columns.heights()), view(mask))
        elif self.count:
            made.SetExtent(0, self.cells.columns - 1, 0, self.cells.rows - 1, 0, 0)
            made.SetOrigin(*self.cells.origin, 0.0)
            made.SetSpacing(*self.cells.spacing, 1.0)
            if found.counts["sampled_outside"] + found.counts["sampled_without_value"]:
                self._hide(made, columns, view(mask))
        columns.add_to(made.GetPointData())
        self._add_mask(made.GetPointData(), mask)
        found.wanted = found.surface = None
        if found.counts["sampled_outside"] and not found.counts["sampled_valued"]:
            found.wanted = raster.box_of(xy) if xy is not None else self.cells.box()
            found.surface = surface.bounds()
        self._take_measures(made, found, time.monotonic() - started)
        for text in raster_messages.of_arrays(self.wishes, columns) if self.is_first else ():
            self.speaker.warn(text)
        return found

    def _sample(self, columns, heights, xy, found):
        job, missing, places = self.job, None, xy
        if xy is None:
            places = self._raster()
        job.set(memory_limit=0, other_memory=0,  # as all of it was looked at before
                threads=threads_to_use(self.backend, self.values["NumberOfThreads"]))
        first = 0.0 if self.is_kept else TRIANGULATION
        job.set_progress(_Stage(self.algorithm, first, 1.0 - first))
        if self.wishes["Method"] == NEAREST:
            mask, missing = columns.gather(job, places, heights)
        else:
            mask = columns.interpolate(job, places, heights, self.wishes["Outside"])
        job.set_progress(None)
        found.counts = {part: job.count(part) for parts in table.INTERPOLATION_OF_JOB.values() for part in parts}
        if missing is not None:
            found.counts["sampled_without_value"] = missing
        found.triangles = job.count("triangles")
        return mask

    def _write_surface(self, made, heights, mask):
        """Points at their heights; those without one are hidden, at the lowest height."""
        vtk, cells, lowest = self.backend, self.cells, math.inf
        for part in blocks_of(self.count):
            shown = heights[part][(mask[part] == 1) & numpy.isfinite(heights[part])]
            lowest = min(lowest, float(shown.min())) if shown.size else lowest
        lowest = lowest + 0.0 if math.isfinite(lowest) else 0.0
        data, xyz = new_array(vtk.vtkDoubleArray, self.count, 3)
        grid = xyz.reshape(cells.rows, cells.columns, 3)
        grid[..., 0], grid[..., 1] = cells.axis(0), cells.axis(1)[:, None]
        hidden, write = new_array(vtk.vtkUnsignedCharArray, self.count, 1, GHOSTS)
        for part in blocks_of(self.count):
            shown = (mask[part] == 1) & numpy.isfinite(heights[part])
            xyz[part, 2] = numpy.where(shown, heights[part], lowest)
            write[part] = numpy.where(shown, 0, HIDDENPOINT)
        points = vtk.vtkPoints()
        points.SetData(data)
        made.SetExtent(0, cells.columns - 1, 0, cells.rows - 1, 0, 0)
        made.SetPoints(points)
        made.GetPointData().AddArray(hidden)

    def _hide(self, made, columns, mask):
        """Marks the points of an image where neither the height nor an array has a value."""
        hidden, write = new_array(self.backend.vtkUnsignedCharArray, self.count, 1, GHOSTS)
        fills = self.wishes["Outside"] and self.wishes["Method"] != NEAREST
        for part in blocks_of(self.count):
            shown = ((mask[part] == 1) | bool(fills)) & columns.have_value(part)
            write[part] = numpy.where(shown, 0, HIDDENPOINT)
        if write.any():
            made.GetPointData().AddArray(hidden)

    def _add_mask(self, data, mask):
        name = self.wishes["ValidPointMaskArrayName"]
        if name:
            mask.SetName(name)
            data.RemoveArray(name)
            data.AddArray(mask)

    def _take_measures(self, made, found, seconds):
        counts = {name: sum(found.counts[part] for part in parts)
                  for name, parts in table.INTERPOLATION_OF_JOB.items()}
        values = self.algorithm._values
        for name, count in dict(counts, SampleSeconds=seconds).items():
            values[name] += count
        values["MemoryEstimate"] = max(values["MemoryEstimate"], self._memory())
        for name, count in counts.items():
            array, write = new_array(self.backend.vtkIdTypeArray, 1, 1, name)
            write[0] = count
            made.GetFieldData().AddArray(array)

    def _keep(self):
        """Leaves the surface to the next execution, or its memory."""
        surface, most = self.algorithm._surface, self.values["ReuseLimit"] * 1024
        if not self.is_last:
            return
        if not surface.is_lent and self.values["KeepTriangulation"] and self.job.count("points") * KEPT_BYTES <= most:
            surface.drop_data()
            return
        surface.give_back()
        self.algorithm._surface = None
        if not surface.is_lent:
            self.job.release(min(most, 2**62))
