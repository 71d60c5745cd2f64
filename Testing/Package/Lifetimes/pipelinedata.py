# SPDX-License-Identifier: BSD-3-Clause
"""Data sets of the world of pipelines: inputs, a source of time steps and pieces, and results as bytes.

Environment: AHD_TEST_CLASS, python for the classes in Python where the package has compiled ones too.
"""

import importlib
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkDataArray, vtkDoubleArray, vtkIdTypeArray, vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from worlds import expect_same

vtkObject.GlobalWarningDisplayOff()


def tested_class(name):
    import adaptivehilbertdelaunay

    if os.environ.get("AHD_TEST_CLASS") == "python":
        return importlib.import_module("adaptivehilbertdelaunay._vtk").python_class("vtkmodules", name)
    return getattr(adaptivehilbertdelaunay, name)


Delaunay = tested_class("vtkAdaptiveHilbertDelaunay2D")
Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
QualityMesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")


# --- Inputs -------------------------------------------------------------------------------------------------


def random_of(rng):
    return np.random.default_rng(rng.randrange(1000))


def points_of(numbers):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numbers, deep=1))
    return points


def named(name, numbers):
    made = numpy_to_vtk(numbers, deep=1)
    made.SetName(name)
    return made


def make_input(rng):
    """Points of some kind with two arrays."""
    random, count = random_of(rng), rng.choice((60, 81, 200))
    numbers = random.random((count, 3)).astype(rng.choice((np.float64, np.float64, np.float32)))
    if rng.random() < 0.2:
        numbers[:, :2] = np.round(numbers[:, :2] * 8) / 8
    made = vtkPolyData()
    made.SetPoints(points_of(numbers))
    made.GetPointData().SetScalars(named("h", random.random(count)))
    made.GetPointData().AddArray(named("k", random.integers(0, 9, count).astype(np.int32)))
    return made


def cells_of(rng, count, sizes):
    cells = vtkCellArray()
    for size in sizes:
        cells.InsertNextCell(size)
        for k in rng.sample(range(count), size):
            cells.InsertCellPoint(k)
    return cells


def make_source(rng):
    """Constraints, by points of their own or by ids."""
    made = vtkPolyData()
    made.SetPoints(points_of(random_of(rng).random((12, 3))))
    made.GetPointData().SetScalars(named("h", random_of(rng).random(12)))
    made.SetLines(cells_of(rng, 12, rng.choice(((2, 3), (4,), (2,)))))
    if rng.random() < 0.4:
        made.SetPolys(cells_of(rng, 12, (4,)))
    return made


def lying_cells(rng):
    """Cells with invalid offsets."""
    offsets, corners = vtkIdTypeArray(), vtkIdTypeArray()
    for k in rng.choice(((0, 2, 200000000), (0, 5, 2, 3), (0, -7, 3), (1, 2, 3), (0, 2, 3, 900))):
        offsets.InsertNextValue(k)
    for k in range(3):
        corners.InsertNextValue(k)
    cells = vtkCellArray()
    cells.SetData(offsets, corners)
    return cells


def copy_of(data):
    made = data.NewInstance()
    made.DeepCopy(data)
    return made


class Source(VTKPythonAlgorithmBase):
    """Points that depend on the time; a piece of them where pieces are requested."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

    @staticmethod
    def whole(time):
        numbers = np.random.default_rng(int(time)).random((90, 3)) * (1 + time % 3)
        made = vtkPolyData()
        made.SetPoints(points_of(numbers))
        made.GetPointData().SetScalars(named("h", numbers.sum(1)))
        return made

    def RequestInformation(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(Pipeline.TIME_STEPS(), [0.0, 1.0, 2.0, 3.0], 4)
        info.Set(Pipeline.TIME_RANGE(), [0.0, 3.0], 2)
        info.Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(Pipeline.UPDATE_TIME_STEP()) if info.Has(Pipeline.UPDATE_TIME_STEP()) else 0.0
        whole, pieces = self.whole(time), max(1, info.Get(Pipeline.UPDATE_NUMBER_OF_PIECES()) or 1)
        rows = slice(max(0, info.Get(Pipeline.UPDATE_PIECE_NUMBER()) or 0), None, pieces)
        made = vtkPolyData.GetData(outputs)
        made.SetPoints(points_of(vtk_to_numpy(whole.GetPoints().GetData())[rows].copy()))
        made.GetPointData().SetScalars(named("h", vtk_to_numpy(whole.GetPointData().GetArray("h"))[rows].copy()))
        return 1


# --- Results ------------------------------------------------------------------------------------------------


def numbers_of(data):
    """Of a vtkDataArray, copied; of others their text."""
    if data is None or data.GetNumberOfTuples() == 0:
        return b""
    if isinstance(data, vtkDataArray):
        return vtk_to_numpy(data).tobytes()
    return str([data.GetValue(k) for k in range(data.GetNumberOfValues())]).encode()


def arrays_of(data):
    arrays = [data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays())]
    return [(array.GetName(), array.GetDataType(), array.GetNumberOfComponents(), numbers_of(array)) for array in arrays
            if not (array.GetName() or "").endswith("Seconds")]


def dump(data):
    """All comparable data of a data set."""
    if data is None:
        return None
    made = [data.GetClassName(), arrays_of(data.GetPointData()), arrays_of(data.GetCellData()),
            arrays_of(data.GetFieldData())]
    if isinstance(data, vtkImageData):
        return made + [data.GetExtent(), data.GetOrigin(), data.GetSpacing()]
    points = data.GetPoints()
    made.append(numbers_of(points.GetData()) if points else b"")
    for kind in ("GetVerts", "GetLines", "GetPolys"):
        if hasattr(data, kind):
            cells = getattr(data, kind)()
            made.append((numbers_of(cells.GetConnectivityArray()), cells.GetNumberOfCells()))
    return made


def expect_close(name, found, wanted):
    """The same numbers, but for the rounding of weights: on a surface they come from its triangulation or, if that is
    not available, from its own triangles, whose corners begin elsewhere."""
    one, other = found.GetPointData(), wanted.GetPointData()
    expect_same(name + " [arrays]", one.GetNumberOfArrays(), other.GetNumberOfArrays())
    for k in range(other.GetNumberOfArrays()):
        numbers = [vtk_to_numpy(data.GetArray(k)) for data in (one, other)]
        if numbers[0].shape != numbers[1].shape or not np.allclose(*numbers, rtol=1e-11, atol=1e-11, equal_nan=True):
            expect_same(name, dump(found), dump(wanted))


def part_of(image, extent):
    """Point arrays of an image's part, as dump() has them, where that is another part than all of it."""
    whole = image.GetExtent()
    columns, rows = whole[1] - whole[0] + 1, whole[3] - whole[2] + 1
    made = []
    for name, kind, components, numbers in arrays_of(image.GetPointData()):
        size = len(numbers) // (columns * rows * components)
        cells = np.frombuffer(numbers, np.uint8).reshape(rows, columns, components * size)
        cells = cells[extent[2] - whole[2] : extent[3] + 1 - whole[2], extent[0] - whole[0] : extent[1] + 1 - whole[0]]
        made.append((name, kind, components, cells.tobytes()))
    return made


def doubles(numbers):
    """A vtkDoubleArray over the program's memory, freed with the array."""
    made = vtkDoubleArray()
    made.SetNumberOfComponents(3)
    lend(made, numbers)
    return made


def lend(array, numbers):
    """Lends other memory to an array; returns the memory lent before."""
    before = getattr(array, "lent", None)
    array.SetVoidArray(numbers, numbers.size, 1)
    array.lent = numbers
    return before
