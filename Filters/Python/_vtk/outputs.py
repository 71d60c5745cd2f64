# SPDX-License-Identifier: BSD-3-Clause
"""What the job made, as VTK's data: Filters/Output/."""

import math

import numpy

from .arrays import (GHOSTS, cell_array, coordinates, id_list, new_array, remove_arrays_of_one_name, replace_array,
                     view)
from .pointdata import PointData

IDS_NAME = "OriginalPointIds"


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
            if numpy.array_equal(view(self.output.GetPoints().GetData()), now, equal_nan=True):
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

    def _array(self, name, kind, title, components=1):
        rows, _ = self.job.array_shape(name)
        made, write = new_array(kind, rows, components, title)
        if rows:
            self.job.array(name, out=write)
        return made

    def add_arrays(self):
        ids = self.backend.vtkIdTypeArray
        points, cells = self.output.GetPointData(), self.output.GetCellData()
        for setting, name, title in (
                ("GeneratePointStatus", "point_status", "Fate"),
                ("GenerateInsertionRank", "insertion_ranks", "InsertionRank")):
            if self.values[setting]:
                replace_array(points, self._array(name, ids, title))
        if self.values["GenerateConstraintEdges"]:
            cells.AddArray(self._array("constraint_edges", self.backend.vtkUnsignedCharArray, "ConstraintEdges"))
        if self.values["GenerateRegionIds"]:
            cells.AddArray(self._array("regions", ids, "RegionId"))
        if self.values["GenerateNeighbors"]:
            cells.AddArray(self._array("neighbors", ids, "Neighbors", 3))

    def add_crossings(self):
        fields = self.output.GetFieldData()
        if self.job.array_shape("crossing_cells")[0]:
            fields.AddArray(self._array("crossing_cells", self.backend.vtkIdTypeArray, "Crossings", 2))
        else:
            fields.RemoveArray("Crossings")  # the input's


def write_order(backend, job, output):
    """Output port 1: the curve, and the boxes behind it."""
    drawn = job.draw_order(numpy.int64)
    points, ids = backend.vtkPoints(), backend.vtkIdTypeArray
    for title, kind, data, name in (
            (None, backend.vtkDoubleArray, None, "xyz"),
            ("InsertionRank", ids, output.GetPointData(), "ranks"), (IDS_NAME, ids, output.GetPointData(), "ids"),
            ("Level", backend.vtkIntArray, output.GetCellData(), "levels"),
            ("Count", ids, output.GetCellData(), "counts")):
        numbers = drawn[name]
        made, write = new_array(kind, len(numbers), 3 if title is None else 1, title)
        write[...] = numbers
        points.SetData(made) if data is None else data.AddArray(made)
    output.SetPoints(points)
    boxes = job.count("boxes")
    curves, passed = job.count("drawn_cells") - boxes, job.count("drawn_points") - 4 * boxes

    def series(cells, corners, first):
        made, write = new_array(backend.vtkTypeInt32Array, cells * corners)
        write[:] = numpy.arange(first, first + cells * corners, dtype=numpy.int32)
        return cell_array(backend, made, corners) if cells else backend.vtkCellArray()

    output.SetLines(series(curves, passed, 0))
    output.SetPolys(series(boxes, 4, passed))


class Diagram:
    """Output port 2: the Voronoi diagram."""

    def __init__(self, backend, output):
        self.backend, self.output = backend, output

    def write(self, job, surface):
        vtk = self.backend
        corners = job.array("voronoi_points")
        xyz, write = new_array(vtk.vtkDoubleArray, len(corners), 3)
        write[:, :2], write[:, 2:] = corners.reshape(-1, 2), 0.0
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
        given = vtk.vtkPointData()  # what there is of every point
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
        if count and given.GetNumberOfArrays():
            data.CopyData(given, id_list(vtk, view(sites)), id_list(vtk, numpy.arange(count)))
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


def estimate_bytes(values, count, given, expects_added, adds_bounding):
    """Of VTK's outputs, beyond the arrays that the job estimates."""
    data = given.GetPointData()
    total = count * 2 * 4 + 1024  # offsets of the triangles
    if expects_added or adds_bounding:
        per_point = 24
        for i in range(data.GetNumberOfArrays()):
            member = data.GetAbstractArray(i)
            size = member.GetDataTypeSize() if member.IsNumeric() else 32  # an empty string
            per_point += max(1, member.GetNumberOfComponents()) * max(1, size)
        total += count * per_point
    if values["DuplicatePolicy"] == 3:
        total += count * 24
    if values["GenerateVoronoi"]:
        total += count * (2 * 3 * 8 + 2 * 2 * 8 + 8 * 8) + 1024 * data.GetActualMemorySize()
    if values["GenerateInsertionCurve"] or values["GenerateBoxes"]:
        limit = values["InsertionLimit"]
        total += (min(limit, count) if limit else count) * (3 * 8 + 2 * 8 + 4)
    return total
