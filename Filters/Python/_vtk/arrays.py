# SPDX-License-Identifier: BSD-3-Clause
"""VTK's arrays and NumPy's, without copies where VTK's numbers lie one after the other."""

import numpy

from .. import _library as engine
from . import messages

# Of VTK's types whole numbers with a sign, without one, floating-point numbers; VTK_ID_TYPE is 12.
_NUMBERS = {2: "i", 3: "u", 4: "i", 5: "u", 6: "i", 7: "u", 8: "i", 9: "u", 10: "f", 11: "f", 12: "i", 15: "i", 16: "i",
            17: "u"}
_FLOATS = (10, 11)  # VTK_FLOAT, VTK_DOUBLE
GHOSTS = "vtkGhostType"


def view(data):
    """A view of the numbers of a vtkDataArray: (n,), or (n, c) with several components. Requires: standard memory
    layout."""
    number = numpy.dtype("%s%d" % (_NUMBERS[data.GetDataType()], data.GetDataTypeSize()))
    count, components = data.GetNumberOfTuples(), data.GetNumberOfComponents()
    if count * components == 0:
        return numpy.empty((count, components) if components > 1 else count, number)
    numbers = numpy.frombuffer(data, number, count * components)
    return numbers.reshape(count, components) if components > 1 else numbers


def is_viewable(data):
    """Do its numbers lie in memory one after the other?"""
    return bool(data.HasStandardMemoryLayout()) and data.GetDataType() in _NUMBERS


def place(data):
    """Where the numbers of a vtkDataArray begin and how many bytes they take, as long as nobody gives it others or
    another size. Requires: standard memory layout."""
    numbers = view(data)
    return numbers.ctypes.data if numbers.size else 0, numbers.nbytes


class HeldPoints:
    """The array that vtkPoints had. No vtkPoints of its own: vtkPoints::SetData() makes the array newer, so that all
    who have it run again. Nor an array of its own on the same memory, which would not know when that is given away."""

    def __init__(self, points):
        self._data = points.GetData()

    def GetData(self):
        return self._data

    def GetNumberOfPoints(self):
        return self._data.GetNumberOfTuples()

    def GetDataType(self):
        return self._data.GetDataType()


class Held:
    """A data set in objects of its own that share the arrays: whatever is done to the other's objects meanwhile, this
    has all arrays that it had. Has the methods of `data`, which is without points where these are in an array of
    their own. `owner`: the data set itself, for those who are given its points; None where it is not to be held."""

    def __init__(self, backend, data, given):
        self._backend, self._data = backend, data
        self._has_points = given.IsA("vtkPointSet")
        points = given.GetPoints() if self._has_points else None
        self._points = points if points is None or isinstance(points, HeldPoints) else HeldPoints(points)
        self._owner = None if isinstance(given, Held) else given
        if self._has_points and data.GetPoints() is not None:
            data.SetPoints(None)

    def __getattr__(self, name):
        return getattr(self._data, name)

    def GetPoints(self):
        return self._points

    def GetNumberOfPoints(self):
        if not self._has_points:
            return self._data.GetNumberOfPoints()
        return self._points.GetNumberOfPoints() if self._points else 0

    def put_into(self, taker):
        """All of it into a data set of the same class."""
        taker.ShallowCopy(self._data)
        self.give_points(taker)

    def give_points(self, taker):
        """To a vtkPointSet; the very vtkPoints of the owner, if these still have the array that was held."""
        if self._points is None:
            return
        points = self._owner.GetPoints() if self._owner is not None else None
        if points is None or points.GetData() is not self._points.GetData():
            points = self._backend.vtkPoints()
            points.SetData(self._points.GetData())
        taker.SetPoints(points)


class Watched:
    """The arrays that an execution reads: their memory cannot be held, only looked for. `given`: data sets, blocks of
    these, or None."""

    def __init__(self, backend, *given):
        self._arrays, self._backend = [], backend
        for data in given:
            self._add(data)
        self._places = self._find()

    def are_in_place(self):
        """Have all the memory and the size that they had?"""
        return self._find() == self._places

    def _find(self):
        return [place(data) if is_viewable(data) else data.GetNumberOfValues() for data in self._arrays]

    def _add(self, data):
        if isinstance(data, self._backend.vtkCompositeDataSet):
            each = data.NewIterator()
            each.InitTraversal()
            while not each.IsDoneWithTraversal():
                self._add(each.GetCurrentDataObject())
                each.GoToNextItem()
        elif isinstance(data, self._backend.vtkDataSet):
            arrays = [some.GetArray(i) for some in (data.GetPointData(), data.GetCellData())
                      for i in range(some.GetNumberOfArrays())]
            if data.IsA("vtkPointSet") and data.GetPoints() is not None:
                arrays.append(data.GetPoints().GetData())
            for cells in (data.GetLines(), data.GetPolys()) if data.IsA("vtkPolyData") else ():
                arrays += [cells.GetConnectivityArray(), cells.GetOffsetsArray()]
            self._arrays += [found for found in arrays if found is not None]


def held(backend, given):
    """The same points and data, and the same cells but those of a vtkPolyData that has none. None of None."""
    if given is None:
        return None
    made = given.NewInstance()
    made.ShallowCopy(given._data if isinstance(given, Held) else given)
    for kind in ("Verts", "Lines", "Polys", "Strips") if given.IsA("vtkPolyData") else ():
        cells, own = getattr(given, "Get" + kind)(), None
        if cells.GetNumberOfCells() > 0:  # else it may be an empty one that all share
            own = backend.vtkCellArray()
            own.ShallowCopy(cells)
        getattr(made, "Set" + kind)(own)
    return Held(backend, made, given)


def held_points(backend, given):
    """Points and point data of a vtkPointSet as a vtkPolyData."""
    made = backend.vtkPolyData()
    made.GetPointData().ShallowCopy(given.GetPointData())
    return Held(backend, made, given)


def held_places(backend, given):
    """Points and ghost marks of what is Held as a vtkPolyData, and nothing else of it."""
    made, marks = backend.vtkPolyData(), given.GetPointData().GetAbstractArray(GHOSTS)
    if marks is not None:
        made.GetPointData().AddArray(marks)
    return Held(backend, made, given)


def without_points(backend, given):
    """A vtkPolyData with the arrays of this one, but no points, cells and values."""
    made, points = backend.vtkPolyData(), backend.vtkPoints()
    if given.GetPoints() is not None:
        points.SetDataType(given.GetPoints().GetDataType())
    made.SetPoints(points)
    for to, data in ((made.GetPointData(), given.GetPointData()), (made.GetCellData(), given.GetCellData())):
        to.CopyAllOn()
        to.CopyAllocate(data, 1)
    return made


def new_array(kind, count, components=1, name=None):
    """A VTK array of this class and a view of its numbers, to be written. MemoryError."""
    made = kind()
    made.SetNumberOfComponents(components)
    if name is not None:
        made.SetName(name)
    reserve = getattr(made, "ReserveValues", made.Allocate)  # VTK 9.7 has another name for it
    if count and not reserve(count * components):
        raise MemoryError
    made.SetNumberOfTuples(count)
    return made, view(made)


def put_tuples(made, first, count, given):
    """Copies the first tuples of an array to `first` and following of another. One by one where both may lie component
    after component: of such, VTK 9.1 and 9.2 put ranges to where they come from."""
    if first == 0 or made.HasStandardMemoryLayout():
        made.InsertTuples(first, count, 0, given)
        return
    for i in range(count):
        made.InsertTuple(first + i, i, given)


def must_be_converted(points):
    """Are these vtkPoints neither floats nor doubles, point after point in memory?"""
    return bool(points and points.GetNumberOfPoints()) and not (
        points.GetData().GetDataType() in _FLOATS and points.GetData().HasStandardMemoryLayout())


def coordinates(backend, points):
    """Of vtkPoints, HeldPoints or None: (n, 3), a view if they are floats or doubles."""
    if points is None or points.GetNumberOfPoints() == 0:
        return numpy.empty((0, 3))
    data = points.GetData()
    if must_be_converted(points):
        converted = backend.vtkDoubleArray()
        converted.DeepCopy(data)
        data = converted
    return view(data)


def ghost_marks(given):
    """Of a vtkPointSet: one number for each point, or None where the array does not fit; and whether there is one
    that does not."""
    data = given.GetPointData()
    marks = data.GetAbstractArray(GHOSTS)
    count = given.GetNumberOfPoints()
    if marks is None or count == 0:
        return None, False
    fits = marks.IsA("vtkUnsignedCharArray") and marks.GetNumberOfComponents() == 1 and (
        marks.GetNumberOfTuples() == count)
    return (view(marks), False) if fits else (None, True)


class BadCells(engine.EngineError):
    """Offsets of cells that lie."""

    status = engine.BAD_ARRAY


def ids_of(backend, cells, what):
    """Offsets and ids of a vtkCellArray, both of 32 bits or both of 64; (None, None) where no cell has a point. `what`
    they are, for the text of BadCells."""
    if cells is None or cells.GetNumberOfConnectivityIds() == 0 or cells.GetNumberOfCells() <= 0:
        return None, None
    found, parts = [], (cells.GetOffsetsArray(), cells.GetConnectivityArray())
    sizes = [data.GetDataTypeSize() if is_viewable(data) else 0 for data in parts]
    for data, size in zip(parts, sizes):
        if not (size == 8 or sizes == [4, 4]):
            copy = backend.vtkTypeInt64Array()
            copy.DeepCopy(data)
            data = copy
        numbers = view(data)
        found.append(numbers.view(numpy.int64 if numbers.itemsize == 8 else numpy.int32))
    offsets, ids = found
    begin, end = offsets[:-1], offsets[1:]
    bad = (begin < 0) | (begin > end) | (end > len(ids))
    if bad.any():
        cell = int(bad.argmax())
        raise BadCells(messages.refusal(
            reason=engine.BAD_ARRAY, cells=what, bad_cell=cell, begin=begin[cell], end=end[cell], ids=len(ids)))
    return found


def bytes_to_convert(backend, cells):
    """The bytes of the compiled class for a copy of these cells: it reads ids and offsets in place if both have 32
    bits or both 64."""
    if cells is None or cells.GetNumberOfConnectivityIds() == 0 or cells.GetNumberOfCells() <= 0:
        return 0
    parts = ((cells.GetConnectivityArray(), cells.GetNumberOfConnectivityIds()),
             (cells.GetOffsetsArray(), cells.GetNumberOfCells() + 1))
    kinds = [data.GetDataType() if is_viewable(data) else None for data, _ in parts]
    if kinds == [backend.VTK_INT, backend.VTK_INT]:
        return 0
    wide = backend.VTK_LONG_LONG, backend.VTK_ID_TYPE
    return sum(8 * count for kind, (_, count) in zip(kinds, parts) if kind not in wide)


def cells_of(backend, offsets, ids):
    """A vtkCellArray of these whole numbers. MemoryError."""
    made, parts = backend.vtkCellArray(), []
    for numbers in (offsets, ids):
        part, write = new_array(backend.vtkTypeInt64Array, len(numbers))
        write[:] = numbers
        parts.append(part)
    made.SetData(*parts)
    return made


def remove_arrays_of_one_name(data):
    """Of several arrays of one name only the last stays, as it does where VTK passes them on."""
    i = data.GetNumberOfArrays() - 1
    while i >= 0:
        name = data.GetArrayName(i)
        for k in range(i - 1, -1, -1):
            if name and data.GetArrayName(k) == name:
                data.RemoveArray(k)
                i -= 1
        i -= 1


def replace_array(data, made):
    """In place of one that has its name, which ceases to be normals, ids or whatever else it was."""
    data.RemoveArray(made.GetName())
    data.AddArray(made)


def write_series(write, first, step):
    """first, first + step, ..., without a copy of all."""
    block = 1 << 16
    for begin in range(0, len(write), block):
        part = write[begin:begin + block]
        part[:] = numpy.arange(first + step * begin, first + step * (begin + len(part)), step, part.dtype)


def id_list(backend, numbers):
    """A vtkIdList of these, filled by VTK."""
    made = backend.vtkIdList()
    cells_of(backend, (0, len(numbers)), numbers).GetCellAtId(0, made)
    return made


def cell_array(backend, ids, size):
    """A vtkCellArray of cells with `size` points each, of a VTK array of ids of 32 bits."""
    count = ids.GetNumberOfTuples() * ids.GetNumberOfComponents() // size
    offsets, write = new_array(backend.vtkTypeInt32Array, count + 1)
    write_series(write, 0, size)
    ids.SetNumberOfComponents(1)
    made = backend.vtkCellArray()
    made.SetData(offsets, ids)
    return made
