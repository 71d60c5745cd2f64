# SPDX-License-Identifier: BSD-3-Clause
"""Which arrays are interpolated, and what comes of them: Filters/Sampling/vtkAHDSampleColumns.cxx."""

import math
import typing

import numpy

from .arrays import GHOSTS, is_viewable, new_array, remove_arrays_of_one_name, replace_array, view
from .pointdata import is_whole

GRADIENT = "Gradient"
LARGEST_FLOAT = float(numpy.finfo(numpy.float32).max)
NEAREST = 3


def as_floats(doubles):
    """Finite numbers that are too large become the largest."""
    kept = numpy.where(numpy.isinf(doubles), doubles, numpy.clip(doubles, -LARGEST_FLOAT, LARGEST_FLOAT))
    return kept.astype(numpy.float32)


def in_memory(backend, data):
    """The array, or one of the same type with its numbers one after the other; of arrays that VTK computes as far as
    they are doubles."""
    if is_viewable(data):
        return data
    copy = backend.vtkDataArray.CreateDataArray(data.GetDataType())
    if not hasattr(data, "GetTypedComponent"):
        copy.DeepCopy(data)
        return copy
    width = data.GetNumberOfComponents()
    copy, write = new_array(lambda: copy, data.GetNumberOfTuples(), width)
    for c, numbers in enumerate(write.reshape(-1, width).T):
        numbers[:] = [data.GetTypedComponent(i, c) for i in range(len(numbers))]
    return copy


class Missing(typing.NamedTuple):
    """The missing values of an array. `name`: empty for the heights; `places`: values at places on the surface that
    are none; `of_points`: has it NaN at vertices, `of_added`: at such that were added, of the source for example?"""

    name: str
    places: int
    of_points: bool
    of_added: bool

    def and_others(self, other):
        return Missing(self.name, self.places + other.places, self.of_points or other.of_points,
                       self.of_added or other.of_added)


def blocks_of(count):
    """Slices of so many rows, one after the other, to compute with little memory."""
    block = 1 << 14
    return (slice(begin, begin + block) for begin in range(0, count, block))


class Column:
    """One array to interpolate. `given`: it; None: the heights. `made`, `slopes`: what came of it; `missing`: how many
    values at places on the surface are none."""

    def __init__(self, name, given=None):
        self.name, self.given, self.made, self.slopes, self.missing = name, given, None, None, 0
        self.components = given.GetNumberOfComponents() if given is not None else 1

    def numbers(self, count):
        """A row for each of so many points, as doubles; the array may have more."""
        data = self.given
        if is_viewable(data):
            return numpy.ascontiguousarray(view(data)[:count], numpy.float64).reshape(-1, self.components)
        rows = numpy.empty((count, self.components))
        for i in range(count):
            rows[i] = data.GetTuple(i)
        return rows


class Columns:
    """Of one execution. `values`: the filter's settings. `given`: the point data of the input, which says which arrays
    are ids; `data`: with a value for each of `count` points."""

    def __init__(self, backend, values, given, data, count):
        self.backend, self.values, self.data = backend, values, data
        self.is_nearest = values["Method"] == NEAREST
        self.makes_slopes = values["GenerateGradients"] and values["Method"] == 0
        self.columns, self.unfit, self.replaced = [Column(values["HeightArrayName"])], [], []
        arrays = backend.vtkPointData()
        arrays.ShallowCopy(data)
        remove_arrays_of_one_name(arrays)
        self.arrays, self.points = arrays, count
        self.ids = [ids.GetName() for ids in (given.GetGlobalIds(), given.GetPedigreeIds()) if ids is not None]
        for i in range(arrays.GetNumberOfArrays()):
            self._choose(arrays.GetAbstractArray(i))

    def _fits(self, array):
        """Has it a name, and numbers for each point?"""
        return array.IsA("vtkDataArray") and array.GetName() and array.GetNumberOfComponents() > 0 and (
            array.GetNumberOfTuples() >= self.points)

    def _is_taken(self, name):
        """Is it the name of an array that is made? In whatever order the arrays are."""
        if name in (self.values["HeightArrayName"], self.values["ValidPointMaskArrayName"]):
            return True
        base = name[:-len(GRADIENT)]
        return bool(self.makes_slopes and base and name == base + GRADIENT and self._makes_slopes_of(base))

    def _makes_slopes_of(self, name):
        """Is there an array of this name, of one component, that is interpolated?"""
        if name == self.values["HeightArrayName"]:
            return True
        array = self.arrays.GetAbstractArray(name)
        return array is not None and name != GHOSTS and self._fits(array) and array.GetNumberOfComponents() == 1 and (
            name not in self.ids and not self._is_taken(name))

    def _choose(self, array):
        name = array.GetName()
        if name == GHOSTS:
            return
        if name is not None and self._is_taken(name):
            self.replaced.append(name)
        elif not self._fits(array):
            self.unfit.append(name or "one without a name")
        elif self.is_nearest or name not in self.ids:
            self.columns.append(Column(name, array))

    def components(self):
        return sum(column.components for column in self.columns)

    def kind_of_scalars(self):
        """Type and number of components of the active scalars after add_to()."""
        active = self.data.GetScalars()
        for column in self.columns[1:]:
            if active is not None and active.GetName() == column.name:
                single = column.given.GetDataType() == self.backend.VTK_FLOAT
                interpolated = self.backend.VTK_FLOAT if single else self.backend.VTK_DOUBLE
                return column.given.GetDataType() if self.is_nearest else interpolated, column.components
        return self.backend.VTK_DOUBLE, 1

    def estimate_bytes(self, points, places):
        """Upper estimate of all allocations below, as in the compiled class (vtkAHDSampleColumns::EstimateBytes)."""
        per_point, per_place, copied = 8, self._output_per_place(), 0  # heights
        if self.is_nearest:
            per_point, per_place = per_point + 8, per_place + 8  # ids
        for column in self.columns:
            data, width = column.given, column.components
            if self.is_nearest:
                is_copied = data is not None and data.GetDataType() != self.backend.VTK_BIT and not is_viewable(data)
                copied = max(copied, self._bytes_per_place(column)) if is_copied else copied
                continue
            is_double = data is None or (data.GetDataType() == self.backend.VTK_DOUBLE and is_viewable(data))
            per_point += 0 if is_double else 8 * width
            per_place += 8 * self._numbers_per_place(column) if self._is_float(column) else 0
        return (per_point + copied) * points + per_place * places

    def output_bytes(self, places):
        """Bytes of the output arrays, mask included."""
        return self._output_per_place() * places

    def _output_per_place(self):
        return 1 + sum(map(self._bytes_per_place, self.columns))

    def _is_float(self, column):
        return column.given is not None and column.given.GetDataType() == self.backend.VTK_FLOAT

    def _has_slopes(self, column):
        return self.makes_slopes and column.components == 1

    def _numbers_per_place(self, column):
        return column.components + 2 * self._has_slopes(column)

    def _bytes_per_place(self, column):
        """The output array of a column."""
        of_type = max(1, column.given.GetDataTypeSize()) if column.given is not None else 8
        size = of_type if self.is_nearest else 4 if self._is_float(column) else 8
        return size * self._numbers_per_place(column)

    def interpolate(self, job, places, heights, outside):
        """Fills the columns, each by weights; the mask, a vtkCharArray. engine.EngineError, MemoryError."""
        numbers = [heights.reshape(-1, 1)] + [column.numbers(self.points) for column in self.columns[1:]]
        mask = None

        def make(count):
            nonlocal mask
            values, slopes = [], []
            for column in self.columns:
                column.made, write = self._new_doubles(count, column.components)
                values.append(write)
                has_slopes = self._has_slopes(column) and column.name
                column.slopes, write = self._new_doubles(count, 2) if has_slopes else (None, None)
                slopes.append(write)
            mask, write = new_array(self.backend.vtkCharArray, count)
            return values, slopes, write.view(numpy.uint8)

        method = self.values["Method"]
        job.sample(places, numbers, method=method, outside=outside, gradients=self.makes_slopes, make=make)
        del numbers
        for column in self.columns:
            if job.count("sampled_without_value"):
                found, valid = view(column.made), view(mask)
                column.missing = sum(int(numpy.isnan(found[part][valid[part] == 1]).sum())
                                     for part in blocks_of(len(found)))
            column.made = self._finished(column, column.made)
            column.slopes = column.slopes and self._finished(column, column.slopes)
        return mask

    def _new_doubles(self, count, components):
        made, write = new_array(self.backend.vtkDoubleArray, count, components)
        return made, write.reshape(count, components)

    def _finished(self, column, made):
        """With NoValue in place of NaN, and as floats where the column is of these."""
        none, numbers = self.values["NoValue"], view(made)
        single, floats = self._is_float(column), None
        if single:
            floats, write = new_array(self.backend.vtkFloatArray, len(numbers), made.GetNumberOfComponents())
        for part in blocks_of(len(numbers)):
            if not math.isnan(none):
                some = numbers[part]
                some[numpy.isnan(some)] = none
            if single:
                write[part] = as_floats(numbers[part])
        return floats if single else made

    def gather(self, job, places, heights):
        """Fills the columns, each place with the values of its nearest point as they are; the mask, a vtkCharArray, and
        the number of values that are NaN."""
        mask = None

        def make(count):
            nonlocal mask
            mask, write = new_array(self.backend.vtkCharArray, count)
            return [numpy.empty((count, 1))], [None], write.view(numpy.uint8)

        sampled = job.sample(places, [numpy.arange(len(heights), dtype=float)], method=NEAREST, make=make)
        ids, missing = sampled.values[0].reshape(-1), 0
        for column in self.columns:
            if column.given is not None and column.given.GetDataType() == self.backend.VTK_BIT:
                found = ~numpy.isnan(ids)
                column.made = self._gathered_bits(column.given, numpy.where(found, ids, 0).astype(numpy.int64), found)
                continue
            given = column.given if column.given is None else in_memory(self.backend, column.given)
            column.made, column.missing = self._gathered(given, heights if given is None else view(given), ids)
            missing += column.missing
        return mask, missing

    def find_missing(self, job, heights, first_added):
        """A Missing for each array that may have NaN, the heights first. Points from number `first_added` on were added
        to the input; the crossings among them have values that are made of those of others."""
        vertices, found = job.array("point_of_vertex"), []
        first_crossing = self.points - job.count("split_crossings")
        for column in self.columns:
            if column.given is not None and is_whole(self.backend, column.given):
                continue
            numbers = (heights if column.given is None else column.numbers(self.points)).reshape(self.points, -1)
            of_points = of_added = False
            for part in blocks_of(len(vertices)):
                odd = numpy.isnan(numbers[vertices[part]]).any(axis=1)
                of_points = of_points or bool(odd.any())
                added = (vertices[part] >= first_added) & (vertices[part] < first_crossing)
                of_added = of_added or bool((odd & added).any())
            found.append(Missing(column.name if column.given is not None else "", column.missing, of_points, of_added))
        return found

    def _gathered(self, given, numbers, nearest):
        """`nearest`: ids as doubles, NaN where there is none."""
        vtk, count = self.backend, len(nearest)
        kind = given.NewInstance() if given is not None else vtk.vtkDoubleArray()
        made, write = new_array(lambda: kind, count, given.GetNumberOfComponents() if given is not None else 1)
        isWhole, none = given is not None and is_whole(vtk, given), self.values["NoValue"]
        none = 0 if isWhole else as_floats(numpy.array(none)) if write.dtype == numpy.float32 else none
        missing = 0
        for part in blocks_of(count):
            found, some = ~numpy.isnan(nearest[part]), write[part]
            ids = numpy.where(found, nearest[part], 0).astype(numpy.int64)
            some[...] = numbers[ids] if len(numbers) else 0
            if not isWhole:
                odd = numpy.isnan(some) & (found if some.ndim == 1 else found[:, None])
                some[odd] = none
                missing += int(odd.sum())
            some[~found] = none
        return made, missing

    def _gathered_bits(self, given, ids, found):
        made = self.backend.vtkDataArray.CreateDataArray(given.GetDataType())
        made.SetNumberOfComponents(given.GetNumberOfComponents())
        made.SetNumberOfTuples(len(ids))
        for i, (point, is_found) in enumerate(zip(ids.tolist(), found.tolist())):
            if is_found:
                made.SetTuple(i, point, given)
            else:
                for c in range(made.GetNumberOfComponents()):
                    made.SetComponent(i, c, 0.0)
        return made

    def add_to(self, places):
        """Adds the arrays to the point data of places, with the active attributes of the input."""
        attributes = self.backend.vtkDataSetAttributes
        has_scalars = False
        for column in self.columns:
            if column.given is not None and column.given.HasAComponentName():
                column.made.CopyComponentNames(column.given)
            for made, name in ((column.made, column.name), (column.slopes, column.name + GRADIENT)):
                if made is not None and column.name:
                    made.SetName(name)
                    replace_array(places, made)
            for kind in range(attributes.NUM_ATTRIBUTES if column.given is not None else 0):
                active = self.data.GetAbstractAttribute(kind)
                if kind not in (attributes.GLOBALIDS, attributes.PEDIGREEIDS) and active is not None and (
                        active.GetName() == column.name):
                    places.SetActiveAttribute(column.name, kind)
                    has_scalars = has_scalars or kind == attributes.SCALARS
        if not has_scalars and self.values["HeightArrayName"]:
            places.SetActiveAttribute(self.values["HeightArrayName"], attributes.SCALARS)

    def have_value(self, part):
        """Of some places, has each a number that is not NaN in one of the arrays that were made?"""
        found = ~numpy.isnan(view(self.columns[0].made)[part])
        for column in self.columns[1:] if not found.all() else ():
            if is_whole(self.backend, column.made):
                return numpy.ones_like(found)
            found |= ~numpy.isnan(view(column.made)[part]).reshape(len(found), -1).all(axis=1)
        return found

    def heights(self):
        """At the places, written."""
        return self.columns[0].made
