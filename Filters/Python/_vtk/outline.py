# SPDX-License-Identifier: BSD-3-Clause
"""vtkPlanarSurfaceOutline in Python."""

import numpy

from .. import _library as engine
from . import messages, settings
from .arrays import GHOSTS, Watched, coordinates, held_points, ids_of, new_array, view
from .execution import Progress
from .vtkclass import Inputs, Pieces, build

NAMES = ("vtkPlanarSurfaceOutline", "vtkPolyDataAlgorithm")
LEFT_OUT = 1 | 32  # of ghost marks of cells: duplicate, hidden

ABOUT = """The outline of a surface, as polygons with holes.

Closed polylines around the polygons of a vtkPolyData: a surface of vtkAdaptiveHilbertDelaunay2D, an alpha shape, or
bands of vtkBandedPolyDataContourFilter (GroupArrayName "Scalars"). Two cells are joined where they share an edge, and a
polygon is a largest set of joined cells, of one number in that array. Rings are simple, and touch at vertices only.
The outer ring of a polygon comes first, counterclockwise; its holes run clockwise. Cell data: "PolygonId", "IsHole".
"""


def _array(kind, numbers, name=None):
    made, write = new_array(kind, len(numbers), 1, name)
    write[:] = numbers
    return made


class _Surface:
    """What is outlined: a vtkPolyData, held."""

    blocks = 0  # that are left out
    known = None  # the numbers of its polygons, if it was joined

    def __init__(self, backend, given, group_name):
        self.backend, self.group_name, self.groups, self.ghosts = backend, group_name, None, None
        self.points = held_points(backend, given)
        self.polygons = given.GetPolys()
        self.first = given.GetNumberOfVerts() + given.GetNumberOfLines()
        self.count, self.strips = given.GetNumberOfPolys(), given.GetNumberOfStrips()
        self._cells = self.first + self.count + self.strips
        self.lacks_groups = False
        data = given.GetCellData()
        if group_name not in ("", "None"):
            self.groups = self._fit(data.GetArray(group_name))
            self.lacks_groups = self.groups is None and self._cells > 0
        ghosts = self._fit(data.GetArray(GHOSTS))
        self.ghosts = ghosts if ghosts is not None and ghosts.IsA("vtkUnsignedCharArray") else None

    def _fit(self, array):
        fits = array is not None and array.GetNumberOfComponents() == 1 and array.GetNumberOfTuples() == self._cells
        return array if fits else None

    def numbers(self):
        """Of the polygons, as float64; NaN: it is left out. None: all are alike."""
        if self.known is not None or (self.groups is None and self.ghosts is None):
            return self.known
        part = slice(self.first, self.first + self.count)
        numbers = numpy.zeros(self.count)
        if self.groups is not None:
            copy = self.backend.vtkDoubleArray()
            copy.DeepCopy(self.groups)
            numbers[:] = view(copy)[part]
        if self.ghosts is not None:
            numbers[view(self.ghosts)[part] & LEFT_OUT != 0] = numpy.nan
        return numbers

    def bytes_per_point(self):
        """Of the points that are written, with their data."""
        data = self.points.GetPointData()
        arrays = [data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays())]
        return min(24 + sum(array.GetNumberOfComponents() * array.GetDataTypeSize() for array in arrays), 2**31 - 1)

    def lacks(self):
        """Facts for messages."""
        return {"unfit_group": self.group_name if self.lacks_groups else "", "polygon_strips": self.strips,
                "outlined_blocks": self.blocks,
                "has_no_polygon": not self.count and not self.strips and self.points.GetNumberOfPoints() > 0}


def _joined(backend, given, group_name):
    """All blocks as one surface, in order."""
    blocks, others, each = [], 0, given.NewIterator()
    each.InitTraversal()
    while not each.IsDoneWithTraversal():
        block = each.GetCurrentDataObject()
        is_surface = isinstance(block, backend.vtkPolyData)
        others += not is_surface
        blocks += [_Surface(backend, block, group_name)] if is_surface else []
        each.GoToNextItem()
    made, begin = backend.vtkPolyData(), 0
    cells, counts = [], [numpy.zeros(1, numpy.int64)]
    for block in blocks:
        offsets, ids = ids_of(backend, block.polygons, "polygons")
        if ids is not None:
            own, points = ids[offsets[0]:offsets[-1]], block.points.GetNumberOfPoints()
            cells.append(numpy.where((own >= 0) & (own < points), own + numpy.int64(begin), -1))  # no other block's
        counts.append(numpy.zeros(block.count, numpy.int64) if ids is None else numpy.diff(offsets))
        begin += block.points.GetNumberOfPoints()
    made.SetPoints(backend.vtkPoints())
    data, xyz = new_array(backend.vtkDoubleArray, begin, 3)
    xyz[:] = numpy.concatenate([numpy.empty((0, 3))] + [coordinates(backend, one.points.GetPoints()) for one in blocks])
    made.GetPoints().SetData(data)
    polygons = backend.vtkCellArray()
    polygons.SetData(_array(backend.vtkIdTypeArray, numpy.cumsum(numpy.concatenate(counts))),
                     _array(backend.vtkIdTypeArray, numpy.concatenate(cells) if cells else numpy.empty(0)))
    made.SetPolys(polygons)
    numbers = [block.numbers() for block in blocks]
    has_groups = any(block.groups is not None for block in blocks)
    known = None
    if any(own is not None for own in numbers):
        known = numpy.concatenate([numpy.zeros(block.count) if own is None else own
                                   for own, block in zip(numbers, blocks)])
    if has_groups:
        made.GetCellData().AddArray(_array(backend.vtkDoubleArray, known, group_name))
    surface = _Surface(backend, made, group_name)
    surface.known = known
    surface.blocks, surface.strips = others, sum(block.strips for block in blocks)
    surface.lacks_groups = any(block.lacks_groups for block in blocks)
    return surface


class _Outlining:
    """How RequestData goes; mixed into the class."""

    def FillInputPortInformation(self, _port, info):
        """The first type decides: a filter that takes composite data sets is not run for each block."""
        required = self._backend.vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
        info.Set(required, "vtkCompositeDataSet")
        info.Append(required, "vtkPolyData")
        return 1

    def RequestUpdateExtent(self, _request, inputs, _outputs):
        """All is needed, whatever piece of the output is wanted."""
        if self._is_alone(None):
            self._ask_for_all(inputs[0])
        return 1

    def RequestData(self, _request, inputs, outputs):
        """Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more."""
        vtk = self._backend
        given, output = vtk.vtkDataObject.GetData(inputs[0], 0), vtk.vtkPolyData.GetData(outputs, 0)
        speaker = messages.Speaker(vtk, self)
        if not self._is_alone(None):
            speaker.error("The surface is on several ranks, and its outline is not that of the parts. The compiled "
                          "class outlines the parts together. The output is empty.")
            return 1
        if self._is_later_piece(outputs.GetInformationObject(0)):
            return 1
        self._watched, self._input_is_changed = Watched(vtk, given), False
        job, report, count = engine.take_job(), engine.OutlineReport(), 0
        try:
            take = _joined if isinstance(given, vtk.vtkCompositeDataSet) else _Surface
            surface = take(vtk, given, self._values["GroupArrayName"])
            count = surface.count
            for text in messages.said(engine.SAY_OUTLINE, surface.lacks()):
                speaker.warn(text)
            self._outline(surface, job, report)
            _Writer(vtk, surface, job, output).write()
            facts = {"unfit_cells": report.unfit_cells, "unfit_edges": report.unfit_edges}
            for text in messages.said(engine.SAY_OUTLINE, facts):
                speaker.warn(text)
            engine.give_back(job)
        except engine.EngineError as error:
            self._end(output, error, report, count)
        except MemoryError:
            output.Initialize()
            speaker.error("Out of memory. The output is empty.")
        finally:
            self._watched = None
        return 1

    def _outline(self, surface, job, report):
        offsets, ids = ids_of(self._backend, surface.polygons, "polygons")
        limit = self._values["MemoryLimit"]
        job.set(memory_limit=min(limit * 1024 + 1023, 2**62) if limit else 0,  # all of its last KiB
                other_memory_per_point=surface.bytes_per_point())
        job.set_progress(Progress(self))
        for name, array in (("points", coordinates(self._backend, surface.points.GetPoints())), ("cells", ids),
                            ("cell_offsets", offsets), ("cell_groups", None if ids is None else surface.numbers())):
            job.set_array(name, array)
        job.outline(report)

    def _end(self, output, error, report, polygons):
        output.Initialize()
        text = str(error)
        if error.status in (engine.MEMORY_LIMIT, engine.OUT_OF_MEMORY):
            limit = self._values["MemoryLimit"]
            text = messages.said(engine.SAY_REFUSAL, {
                "reason": error.status, "doing": "outlining", "polygons": polygons, "memory_limit": limit * 1024,
                "memory_estimate": report.memory_needed, "memory_allowed": report.memory_allowed})[0]
        if error.status != engine.CANCELLED:
            messages.Speaker(self._backend, self).error(text)

    def PrintSelf(self):
        """The settings, as text."""
        return "".join("  %s: %s\n" % (setting.name, self._values[setting.name]) for setting in settings.OUTLINE)


class _Writer:
    """The rings of a job as closed polylines."""

    def __init__(self, backend, surface, job, output):
        self.backend, self.surface, self.output = backend, surface, output
        self.corners, self.rings, self.polygons, self.cells = (
            job.array("outline_" + name, numpy.int64) for name in ("points", "rings", "polygons", "cells"))

    def write(self):
        vtk, rings = self.backend, len(self.rings) - 1
        passed, self.corners = numpy.unique(self.corners, return_inverse=True)
        self._write_points(passed)
        offsets = _array(vtk.vtkIdTypeArray, self.rings + numpy.arange(rings + 1))
        closed = numpy.insert(self.corners, self.rings[1:], self.corners[self.rings[:-1]])
        lines = vtk.vtkCellArray()
        lines.SetData(offsets, _array(vtk.vtkIdTypeArray, closed))
        self.output.SetLines(lines)
        polygon = numpy.repeat(numpy.arange(len(self.cells)), numpy.diff(self.polygons))
        is_hole = numpy.ones(rings, numpy.uint8)
        is_hole[self.polygons[:-1]] = 0
        data = self.output.GetCellData()
        data.AddArray(_array(vtk.vtkIdTypeArray, polygon, "PolygonId"))
        data.AddArray(_array(vtk.vtkUnsignedCharArray, is_hole, "IsHole"))
        if self.surface.groups is not None:
            groups = self.surface.groups.NewInstance()
            groups.SetName(self.surface.group_name)
            groups.SetNumberOfTuples(rings)
            for ring, cell in enumerate(self.cells[polygon].tolist()):
                groups.SetTuple(ring, self.surface.first + cell, self.surface.groups)
            data.AddArray(groups)

    def _write_points(self, passed):
        """Those that rings pass, with arrays that have a value for each point of the input."""
        vtk, given = self.backend, self.surface.points
        if given.GetNumberOfPoints() == 0:
            return
        xyz = coordinates(vtk, given.GetPoints())
        data, write = new_array(vtk.vtkFloatArray if xyz.dtype == numpy.float32 else vtk.vtkDoubleArray, len(passed), 3)
        write[:] = xyz[passed]
        points = vtk.vtkPoints()
        points.SetData(data)
        self.output.SetPoints(points)
        fit = vtk.vtkPointData()
        fit.ShallowCopy(given.GetPointData())
        for k in range(fit.GetNumberOfArrays() - 1, -1, -1):
            if fit.GetAbstractArray(k).GetNumberOfTuples() != given.GetNumberOfPoints():
                fit.RemoveArray(k)
        fit.RemoveArray(GHOSTS)
        to = self.output.GetPointData()
        to.CopyAllocate(fit, len(passed))
        for i, point in enumerate(passed.tolist()):
            to.CopyData(fit, point, i)


def make_class(backend):
    """The class over this VTK."""

    def start(self):
        self._values = {setting.name: setting.default for setting in settings.OUTLINE}

    members = {"__doc__": ABOUT}
    for setting in settings.OUTLINE:
        members.update(settings.methods_of(setting))
    made = build(backend, NAMES, (_Outlining, Inputs, Pieces), members, start, (1, 1))
    for name, member in settings.properties_of(made, [setting.name for setting in settings.OUTLINE]).items():
        setattr(made, name, member)
    return made
