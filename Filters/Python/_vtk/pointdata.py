# SPDX-License-Identifier: BSD-3-Clause
"""Point data where points were added: Filters/Output/vtkAHDPointOutput.cxx."""

import math

import numpy

from .. import _library as engine
from .._found import spread
from .arrays import GHOSTS, is_viewable, put_tuples, remove_arrays_of_one_name, view


def is_whole(backend, data):
    return data.GetDataType() not in (backend.VTK_FLOAT, backend.VTK_DOUBLE)


def to_whole(values, data):
    """The closest values that an array of whole numbers can have; 0 for NaN."""
    least, most = data.GetDataTypeMin(), data.GetDataTypeMax()
    largest = math.nextafter(most, 0.0) if most > 2.0**60 else most
    rounded = numpy.copysign(numpy.floor(numpy.abs(values)), values)
    rounded += numpy.copysign(numpy.where(numpy.abs(values) - numpy.abs(rounded) >= 0.5, 1.0, 0.0), values)
    return numpy.where(numpy.isnan(values), 0.0, numpy.clip(rounded, least, largest))


class PointData:
    """Writes the point data of `count` points: of the input, then of the source, then of added points."""

    def __init__(self, backend, job, given, source, count):
        self.backend, self.job, self.given, self.source, self.count = backend, job, given, source, count
        self.input_count = given.GetNumberOfPoints()

    def write(self, output):
        vtk = self.backend
        given, data = vtk.vtkPointData(), vtk.vtkPointData()
        given.ShallowCopy(self.given.GetPointData())
        remove_arrays_of_one_name(given)
        data.CopyAllOn()  # which of them are scalars, ids, normals ...
        data.CopyAllocate(given, self.count)
        for i in range(data.GetNumberOfArrays()):
            made = data.GetAbstractArray(i)
            made.SetNumberOfTuples(self.count)
            self._write_array(made, given.GetAbstractArray(i))
        # As such they would have to name each point.
        data.SetActiveAttribute(-1, vtk.vtkDataSetAttributes.GLOBALIDS)
        data.SetActiveAttribute(-1, vtk.vtkDataSetAttributes.PEDIGREEIDS)
        output.ShallowCopy(data)

    def _write_array(self, made, from_):
        data = self.given.GetPointData()
        known = min(self.input_count, from_.GetNumberOfTuples())
        are_ids = from_ is data.GetGlobalIds() or from_ is data.GetPedigreeIds()
        if known:
            put_tuples(made, 0, known, from_)
        self._clear(made, known, are_ids)
        if are_ids or made.GetName() == GHOSTS:
            return
        self._take_from_source(made)
        if made.IsA("vtkDataArray"):
            self._interpolate(made)

    def _clear(self, made, first, are_ids):
        """What points have that were added, and for which there is no other value."""
        if not made.IsA("vtkDataArray") or first >= self.count:
            return  # strings and the like: they are empty from the beginning
        if are_ids:
            value = -1.0 if made.GetDataTypeMin() < 0 else 0.0
        else:
            value = 0.0 if is_whole(self.backend, made) else math.nan
        if is_viewable(made):
            view(made)[first:] = value
            return
        for i in range(first, self.count):
            for c in range(made.GetNumberOfComponents()):
                made.SetComponent(i, c, value)

    def _take_from_source(self, made):
        more = self.source.GetPointData().GetAbstractArray(made.GetName()) if self.source and made.GetName() else None
        numbers = more is not None and made.IsA("vtkDataArray") and more.IsA("vtkDataArray")
        if more is None or made.GetNumberOfComponents() != more.GetNumberOfComponents() or not (
                numbers or made.GetDataType() == more.GetDataType()):
            return
        many = min(self.source.GetNumberOfPoints(), more.GetNumberOfTuples())
        areas_long = numbers and made.GetDataTypeSize() == 8 and is_whole(self.backend, more)  # as doubles they are not
        if numbers and is_whole(self.backend, made) and made.GetDataType() != more.GetDataType() and not areas_long:
            self._put(made, self.input_count, numpy.array(
                [more.GetTuple(i) for i in range(many)]).reshape(many, more.GetNumberOfComponents()))
        elif many:
            put_tuples(made, self.input_count, many, more)

    def _put(self, made, first, values):
        """Rows of doubles, rounded where the array has whole numbers."""
        if is_whole(self.backend, made):
            values = to_whole(values, made)
        if is_viewable(made) and len(values):
            numbers = view(made)
            numbers[first:first + len(values)] = values.reshape((len(values),) + numbers.shape[1:])
            return
        for i, row in enumerate(values):
            made.SetTuple(first + i, [float(value) for value in row])

    def _interpolate(self, made):
        """At source points laid on a surface and points added to lines, then at crossings."""
        first = self.count - self.job.count("split_crossings")
        inside = self._inside()
        if inside is None and first == self.count:
            return
        numbers = view(made) if is_viewable(made) else numpy.array([made.GetTuple(i) for i in range(self.count)])
        values = numpy.array(numbers, numpy.float64).reshape(self.count, made.GetNumberOfComponents())
        if inside is not None:
            self.job.interpolate(values, engine.AT_SURFACE)
            rows = slice(self.input_count, self.input_count + len(inside))
            if is_whole(self.backend, made):
                values[rows][inside] = to_whole(values[rows][inside], made)
            elif made.GetDataType() == self.backend.VTK_FLOAT:
                values[rows][inside] = values[rows][inside].astype(numpy.float32)
            for k in numpy.flatnonzero(inside):
                self._put(made, self.input_count + int(k), values[self.input_count + k][None])
        if first < self.count:
            self.job.interpolate(values, engine.AT_CROSSINGS)
            self._put(made, first, values[first:])

    def _inside(self):
        """Of the points of the source, then of those added to lines: do they lie between others? None if none do."""
        weights = self.job.array("surface_weights", "float64").reshape(-1, 3)
        return weights.sum(1) > 0.0 if len(weights) else None


class RefinedData(PointData):
    """Writes the point data of a vtkPolyData, and after them those of points that were added (_found.Found)."""

    def __init__(self, backend, given, found):
        super().__init__(backend, None, given, None, given.GetNumberOfPoints() + len(found.corners))
        self.found = found

    def write(self, output):
        if self.count == self.input_count:
            output.PassData(self.given.GetPointData())
        else:
            super().write(output)

    def _interpolate(self, made):
        numbers = view(made) if is_viewable(made) else numpy.array([made.GetTuple(i) for i in range(self.input_count)])
        values = numpy.array(numbers[:self.input_count], numpy.float64).reshape(-1, made.GetNumberOfComponents())
        self._put(made, self.input_count, spread(values, self.found.corners, self.found.weights))
