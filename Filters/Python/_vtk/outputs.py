# SPDX-License-Identifier: BSD-3-Clause
"""The results of the job as VTK's data: Filters/Output/."""

import math

import numpy

from .. import _library as engine
from . import table
from .arrays import (GHOSTS, cell_array, coordinates, id_list, new_array, remove_arrays_of_one_name, replace_array,
                     view, write_series)
from .pointdata import PointData

IDS_NAME = "OriginalPointIds"
CROSSINGS = "Crossings"


class Surface:
    """Output port 0."""

    def __init__(self, backend, job, values, output):
        self.backend, self.job, self.values, self.output = backend, job, values, output

    def write_points(self, given, source):
        """Data, and points where some were added or moved to means: else they are the input's, and none are set."""
        if self.job.count("added_points") > 0:
            self._set_points(numpy.float64)
            own = source if source and self.values["SourceMode"] and source.GetNumberOfPoints() else None
            PointData(self.backend, self.job, given, own, self.job.count("points")).write(self.output.GetPointData())
            return
        self.output.SetPoints(None)
        self.output.GetPointData().PassData(given.GetPointData())
        if self.values["DuplicatePolicy"] == 3 and self.job.count("duplicates"):
            now = coordinates(self.backend, given.GetPoints())
            self._set_points(now.dtype)
            if _are_equal(view(self.output.GetPoints().GetData()), now):
                self.output.SetPoints(None)

    def _set_points(self, number):
        kind = self.backend.vtkFloatArray if number == numpy.float32 else self.backend.vtkDoubleArray
        data, write = new_array(kind, self.job.count("points"), 3)
        self.job.array("points", out=write)
        points = self.backend.vtkPoints()
        points.SetData(data)
        self.output.SetPoints(points)

    def _cells(self, name, size):
        rows, _ = self.job.array_shape(name)
        ids, write = new_array(self.backend.vtkTypeInt32Array, rows * size)
        if rows:
            self.job.array(name, out=write)
        return cell_array(self.backend, ids, size)

    def write_cells(self):
        self.output.SetPolys(self._cells("triangles", 3))
        if self.job.count("vertices"):
            self.output.SetVerts(self._cells("vertices", 1))
        if self.job.count("lines"):
            self.output.SetLines(self._cells("lines", 2))

    def add_arrays(self):
        for setting, name, title, kind, components, data in table.ARRAYS:
            if self.values[setting]:
                made, write = new_array(getattr(self.backend, kind), self.job.array_shape(name)[0], components, title)
                if len(write):
                    self.job.array(name, out=write)
                replace_array(getattr(self.output, "Get" + data)(), made)

    def keep_points_of_cells(self, given):
        """Leaves the points of the cells alone, in their order, with their data, and adds their ids. Without cells all
        points stay. Requires: all else is written."""
        output, count = self.output, self.job.count("points")
        cells = [some for some in (output.GetVerts(), output.GetLines(), output.GetPolys()) if some.GetNumberOfCells()]
        corners = [view(some.GetConnectivityArray()) for some in cells]
        is_used = numpy.full(count, not corners)
        for ids in corners:
            is_used[ids] = True
        kept = numpy.flatnonzero(is_used)
        if len(kept) < count:
            numbers = numpy.cumsum(is_used, dtype=numpy.int32) - 1
            for ids in corners:
                ids[:] = numbers[ids]
            self._take_points((output.GetPoints() or given.GetPoints()).GetData(), kept)
        made, write = new_array(self.backend.vtkIdTypeArray, len(kept), 1, IDS_NAME)
        write[:] = kept
        replace_array(output.GetPointData(), made)

    def _take_points(self, places, kept):
        vtk, ids, count = self.backend, id_list(self.backend, kept), places.GetNumberOfTuples()
        left, points, data = places.NewInstance(), vtk.vtkPoints(), self.output.GetPointData()
        left.SetNumberOfComponents(3)
        left.SetNumberOfTuples(len(kept))
        places.GetTuples(ids, left)
        points.SetData(left)
        self.output.SetPoints(points)
        given = vtk.vtkPointData()
        given.ShallowCopy(data)
        remove_arrays_of_one_name(given)
        for i in range(given.GetNumberOfArrays() - 1, -1, -1):
            if given.GetAbstractArray(i).GetNumberOfTuples() < count:
                given.RemoveArray(i)
        data.Initialize()
        data.CopyAllOn()  # which of them are scalars, ids, normals ...
        data.CopyAllocate(given, len(kept))
        for i in range(data.GetNumberOfArrays()):
            data.GetAbstractArray(i).SetNumberOfTuples(len(kept))
            given.GetAbstractArray(i).GetTuples(ids, data.GetAbstractArray(i))

    def add_crossings(self):
        fields, count = self.output.GetFieldData(), self.job.array_shape("crossing_cells")[0]
        if count:
            made, write = new_array(self.backend.vtkIdTypeArray, count, 2, CROSSINGS)
            self.job.array("crossing_cells", out=write)
            fields.AddArray(made)
        else:
            fields.RemoveArray(CROSSINGS)  # the input's


def _are_equal(some, others):
    """Are these arrays, of as many rows? NaN is equal to NaN. Without tables as large as they are."""
    block = 1 << 14
    return all(numpy.array_equal(some[k:k + block], others[k:k + block], equal_nan=True)
               for k in range(0, len(some), block))


def write_order(backend, job, output):
    """Output port 1: the curve, and the boxes behind it."""
    points, ids = backend.vtkPoints(), backend.vtkIdTypeArray
    drawn_points, drawn_cells, written = job.count("drawn_points"), job.count("drawn_cells"), []
    for title, kind, data, count in (
            (None, backend.vtkDoubleArray, None, drawn_points),
            ("InsertionRank", ids, output.GetPointData(), drawn_points),
            (IDS_NAME, ids, output.GetPointData(), drawn_points),
            ("Level", backend.vtkIntArray, output.GetCellData(), drawn_cells),
            ("Count", ids, output.GetCellData(), drawn_cells)):
        made, write = new_array(kind, count, 3 if title is None else 1, title)
        written.append(write)
        points.SetData(made) if data is None else data.AddArray(made)
    job.draw_order(*written)
    output.SetPoints(points)
    boxes = job.count("boxes")
    curves, passed = drawn_cells - boxes, drawn_points - 4 * boxes

    def series(cells, corners, first):
        made, write = new_array(backend.vtkTypeInt32Array, cells * corners)
        write_series(write, first, 1)
        return cell_array(backend, made, corners) if cells else backend.vtkCellArray()

    output.SetLines(series(curves, passed, 0))
    output.SetPolys(series(boxes, 4, passed))


def _write_in_plane(job, xyz):
    """The corners of Voronoi cells, which have x and y, at z = 0. They are written to the end of the room for three
    numbers each, and moved to their places from the first one on: no copy of all is made."""
    count, flat, block = len(xyz), xyz.reshape(-1), 1 << 14
    xy = job.array("voronoi_points", out=flat[count:].reshape(count, 2))
    for begin in range(0, count, block):
        part = xy[begin:begin + block].copy()
        xyz[begin:begin + block, :2], xyz[begin:begin + block, 2] = part, 0.0


def _leave_out_empty(offsets, sites):
    """Cells without corners, on which filters of VTK crash."""
    ends, ids = view(offsets), view(sites)
    kept = numpy.flatnonzero(ends[1:] != ends[:-1])
    ends[1:len(kept) + 1], ids[:len(kept)] = ends[kept + 1], ids[kept]
    offsets.SetNumberOfTuples(len(kept) + 1)
    sites.SetNumberOfTuples(len(kept))


class Diagram:
    """Output port 2: the Voronoi diagram."""

    def __init__(self, backend, output):
        self.backend, self.output = backend, output

    def write(self, job, surface):
        vtk = self.backend
        xyz, write = new_array(vtk.vtkDoubleArray, job.array_shape("voronoi_points")[0], 3)
        if len(write):
            _write_in_plane(job, write)
        points = vtk.vtkPoints()
        points.SetData(xyz)
        self.output.SetPoints(points)
        made = []
        for name, kind in (("voronoi_offsets", vtk.vtkTypeInt32Array), ("voronoi_corners", vtk.vtkTypeInt32Array),
                           ("voronoi_sites", vtk.vtkIdTypeArray)):
            data, write = new_array(kind, job.array_shape(name)[0])
            if len(write):
                job.array(name, out=write)
            made.append(data)
        if job.get("voronoi_clip") == engine.CLIP_POLYGON:
            _leave_out_empty(made[0], made[2])
        polygons = vtk.vtkCellArray()
        polygons.SetData(made[0], made[1])
        self.output.SetPolys(polygons)
        made[2].SetName(IDS_NAME)
        self.output.GetCellData().AddArray(made[2])
        self.write_data(surface.GetPointData(), job.count("points"))

    def is_written(self):
        return bool(self.output.GetCellData().HasArray(IDS_NAME))

    def leave_only_ids(self):
        data = self.output.GetCellData()
        sites = data.GetAbstractArray(IDS_NAME)
        data.Initialize()
        if sites is not None:
            data.AddArray(sites)

    def write_data(self, points, points_count):
        """The point data of the surface, which has so many points; of each cell that of its point."""
        vtk = self.backend
        given = vtk.vtkPointData()  # arrays with a value for every point
        given.ShallowCopy(points)
        given.RemoveArray(IDS_NAME)
        remove_arrays_of_one_name(given)
        for i in range(given.GetNumberOfArrays() - 1, -1, -1):
            if given.GetAbstractArray(i).GetNumberOfTuples() < points_count:
                given.RemoveArray(i)
        data = self.output.GetCellData()
        sites = data.GetAbstractArray(IDS_NAME)
        count = sites.GetNumberOfTuples()
        data.Initialize()
        data.CopyFieldOff(GHOSTS)  # its bits mean others for cells
        data.CopyAllocate(given, count)
        block = 1 << 16  # lists of all would take 16 bytes a cell, and more while they are made
        for begin in range(0, count if given.GetNumberOfArrays() else 0, block):
            end = min(count, begin + block)
            data.CopyData(given, id_list(vtk, view(sites)[begin:end]), id_list(vtk, numpy.arange(begin, end)))
        data.AddArray(sites)

    def move_back(self, to_plane):
        """Takes the diagram from the plane to the points. False if the transform has no inverse."""
        to_plane.Update()
        back = to_plane.GetInverse()
        if not self._brings_back(to_plane, back):
            return False
        moved = self.backend.vtkPoints()
        moved.SetDataTypeToDouble()
        back.TransformPoints(self.output.GetPoints(), moved)
        self.output.SetPoints(moved)
        return True

    def _brings_back(self, to_plane, back):
        """Whatever it is, a transform that cannot be undone does not bring a point back."""
        if to_plane.IsA("vtkHomogeneousTransform"):
            determinant = to_plane.GetMatrix().Determinant()
            return math.isfinite(determinant) and determinant != 0.0
        size = error = 0.0
        points = self.output.GetPoints()
        for i in range(min(points.GetNumberOfPoints(), 100)):
            start = points.GetPoint(i)
            end = to_plane.TransformPoint(back.TransformPoint(start))
            for a, b in zip(start, end):
                size = max(size, abs(a))
                error = max(error, abs(b - a)) if math.isfinite(b) else math.inf
        return error <= 1e-6 * size


def plane_transform(backend, matrix):
    """The plane of a job as a vtkTransform."""
    made = backend.vtkTransform()
    made.SetMatrix([float(number) for number in numpy.ravel(matrix)])
    return made


def bytes_per_added_point(given):
    """Of point data, where points are added."""
    data, total = given.GetPointData(), 0
    for i in range(data.GetNumberOfArrays()):
        member = data.GetAbstractArray(i)
        size = member.GetDataTypeSize() if member.IsNumeric() else 32  # an empty string
        total += max(1, member.GetNumberOfComponents()) * max(1, size)
    return total
