# SPDX-License-Identifier: BSD-3-Clause
"""Results do not depend on the memory layout of arrays: component after component (VTK's SOA) or, as most do, tuple
after tuple; for coordinates, arrays of points and of the source, of each kind of number and of one to three components.
"""

import itertools
import unittest

from classtests import (
    Case, Filter, Said, array, blocks, cells_of, cloud, core, model, run, run_tests, source, tested_class, triangles,
    values_of,
)  # fmt: skip
from numbered import Random

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
QualityMesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
KINDS = {"float64": "vtkDoubleArray", "float32": "vtkFloatArray", "int32": "vtkIntArray",
         "uint8": "vtkUnsignedCharArray", "int16": "vtkShortArray"}  # fmt: skip
COUNT, OWN, MANY = 41, 7, 4000


def of_components(kind):
    """A new array of this kind of number, component after component; None where VTK does not wrap it."""
    wanted = getattr(core, KINDS[kind])().GetDataType()  # on Windows int32 is long, another type than int
    for template in getattr(core, "vtkSOADataArrayTemplate", {}).values():
        if template().GetDataType() == wanted:
            return template()
    return None


def laid(data, kind):
    """The same numbers, component after component."""
    made = of_components(kind)
    made.SetName(data.GetName())
    made.SetNumberOfComponents(data.GetNumberOfComponents())
    made.SetNumberOfTuples(data.GetNumberOfTuples())
    for i in range(data.GetNumberOfTuples()):
        made.SetTuple(i, data.GetTuple(i))
    return made


def places(count, seed):
    random = Random(seed)
    return [(random.unit(), random.unit(), random.unit()) for _ in range(count)]


def numbers(count, components, kind, seed, apart):
    random = Random(seed)
    values = [random.unit() for _ in range(count * components)]
    if not kind.startswith("float"):
        values = [int(100 * value) for value in values]
    data = array(KINDS[kind], "a", values, components)
    return laid(data, kind) if apart else data


def data_of(points, apart):
    """A vtkPolyData of points whose coordinates lie so."""
    data = cloud(points)
    if apart:
        data.GetPoints().SetData(laid(data.GetPoints().GetData(), "float64"))
    return data


def all_values(output):
    """Of each array, by name."""
    data = output.GetPointData()
    found = {data.GetArrayName(i): values_of(data.GetAbstractArray(i)) for i in range(data.GetNumberOfArrays())}
    return {name: [None if value != value else value for value in values] for name, values in found.items()}


@unittest.skipUnless(of_components("float64") is not None, "this VTK does not wrap such arrays")
class LayoutsTest(Case):
    def given(self, kind, components, apart):
        """Input and source. `apart`: of coordinates, the input's array, the source's."""
        given = data_of(places(COUNT, 1), apart[0])
        given.GetPointData().AddArray(numbers(COUNT, components, kind, 2, apart[1]))
        lines = source(places(OWN, 3), lines=[tuple(range(OWN)), (0, 3, 6, 2)])
        if apart[0]:
            lines.GetPoints().SetData(laid(lines.GetPoints().GetData(), "float64"))
        lines.GetPointData().AddArray(numbers(OWN, components, kind, 4, apart[2]))
        return given, lines

    def triangulated(self, kind, components, apart, heights):
        given, lines = self.given(kind, components, apart)
        algorithm = Filter()
        algorithm.SetInputDataObject(given)
        algorithm.SetSourceData(lines)
        algorithm.SetSourceModeToCoordinates()
        algorithm.SetCrossingModeToSplit()
        algorithm.SetSourceHeights(heights)
        Said(algorithm)  # of points outside
        algorithm.Update()
        output = algorithm.GetOutput()
        self.assertGreater(output.GetNumberOfPoints(), COUNT + OWN)  # there are crossings
        points = [output.GetPoint(i) for i in range(output.GetNumberOfPoints())]
        return points, output.GetNumberOfCells(), all_values(output)

    def interpolated(self, kind, components, apart, at):
        given, _ = self.given(kind, components, apart)
        algorithm = Interpolation()
        algorithm.SetInputDataObject(given)
        algorithm.SetDimensions(5, 3)
        algorithm.SetGenerateGradients(True)
        if at:
            algorithm.SetPlacesData(data_of([(x, y, 0) for x, y, _ in places(11, 5)], apart[2]))
        algorithm.Update()
        return all_values(algorithm.GetOutputDataObject(0))

    def check(self, made, options):
        for kind, components in itertools.product(KINDS, (1, 2, 3)):
            for option in options:
                expected = made(kind, components, (False, False, False), option)
                for apart in ((True, False, False), (False, True, False), (False, False, True), (True, True, True)):
                    self.assertEqual(made(kind, components, apart, option), expected, (kind, components, option, apart))

    def test_times_of_what_is_read_stay(self):
        """An array whose time changed makes all its other users run again."""
        for apart in ((False,) * 3, (True,) * 3):
            given, lines = self.given("float64", 1, apart)
            at = cloud(places(COUNT, 5))
            read = [made for data in (given, lines, at) for made in (
                data, data.GetPoints(), data.GetPoints().GetData(), data.GetPointData(), data.GetLines())]
            times = [thing.GetMTime() for thing in read]
            surface, in_blocks, values, at_places = Filter(), Filter(), Interpolation(), Interpolation()
            at_places.SetInputDataObject(1, at)
            for algorithm in (surface, in_blocks, values, at_places):
                Said(algorithm)
                algorithm.SetInputDataObject(0, blocks(given) if algorithm is in_blocks else given)
                algorithm.SetInputDataObject(1 if isinstance(algorithm, Filter) else 2, lines)
                for _ in range(3):  # the last passes on kept outputs
                    algorithm.Update()
                    self.assertEqual([thing.GetMTime() for thing in read], times)
                    algorithm.Modified()
            self.assertIs(surface.GetOutput().GetPoints().GetData(), given.GetPoints().GetData())
            self.assertIs(at_places.GetOutput().GetPoints().GetData(), at.GetPoints().GetData())

    def test_an_array_that_is_replaced_meanwhile(self):
        """Outputs have the points of the execution's beginning, whatever an observer sets."""
        for is_surface in (True, False):
            given, at = cloud(places(COUNT, 6)), cloud(places(COUNT, 7))
            read = given if is_surface else at
            data = read.GetPoints().GetData()
            algorithm = Filter() if is_surface else Interpolation()
            algorithm.SetInputDataObject(0, given)
            if not is_surface:
                algorithm.SetInputDataObject(1, at)

            def replace(*_):
                if 0 < algorithm.GetProgress() < 1:  # at 0 it has not begun, at 1 the outputs are passed on
                    read.GetPoints().SetData(cloud(places(3, 8)).GetPoints().GetData())

            algorithm.AddObserver("ProgressEvent", replace)
            algorithm.Update()
            self.assertIsNot(read.GetPoints().GetData(), data)
            self.assertIs(algorithm.GetOutput().GetPoints().GetData(), data)
            self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), COUNT)

    def test_of_the_surface(self):
        self.check(self.triangulated, (0, 1))

    def test_of_values_between(self):
        self.check(self.interpolated, (False, True))

    def refined(self, kind, apart, sizes):
        given = cloud([(9 * x, 9 * y, z) for x, y, z in places(COUNT, 12)])
        data = array(KINDS[kind], "size", sizes)
        given.GetPointData().AddArray(laid(data, kind) if apart else data)
        algorithm = QualityMesh()
        algorithm.SetInputDataObject(given)
        algorithm.SetSizeArrayName("size")
        algorithm.Update()
        self.assertGreater(algorithm.GetNumberOfAddedPoints(), 10)
        return triangles(algorithm.GetOutput(0))

    def test_sizes_of_a_mesh(self):
        """Each point has its own, of whatever type."""
        sizes = [1 + k % 3 for k in range(COUNT)]
        expected = self.refined("float64", False, sizes)
        for kind, apart in itertools.product(KINDS, (False, True)):
            self.assertEqual(self.refined(kind, apart, sizes), expected, (kind, apart))
        self.assertNotEqual(self.refined("float64", True, sizes[1:] + sizes[:1]), expected)

    def merged(self, kind, components, apart, _option):
        """Blocks of different lengths."""
        parts = []
        for k, count in enumerate((11, 1, 7)):
            parts.append(data_of(places(count, 6 + k), apart[0]))
            parts[-1].GetPointData().AddArray(numbers(count, components, kind, 9 + k, apart[1 + k % 2]))
        algorithm = Filter()
        algorithm.SetInputDataObject(blocks(*parts))
        algorithm.MergeBlocksOn()
        algorithm.Update()
        return algorithm.GetOutput().GetNumberOfCells(), all_values(algorithm.GetOutput())

    def test_of_blocks(self):
        self.check(self.merged, (0,))

    def test_of_cells(self):
        """Ids of 32 and of 64 bits, in arrays of several kinds."""
        lines = source(places(OWN, 3))
        expected = None
        for kind in ("vtkTypeInt32Array", "vtkTypeInt64Array"):
            ids, offsets = (getattr(core, kind)() for _ in range(2))
            for to, values in ((ids, (0, 1, 2, 3, 4)), (offsets, (0, 2, 5))):
                for value in values:
                    to.InsertNextValue(value)
            cells = model.vtkCellArray()
            cells.SetData(offsets, ids)
            lines.SetLines(cells)
            algorithm = Filter()
            algorithm.SetInputDataObject(data_of(places(COUNT, 1), False))
            algorithm.SetSourceData(lines)
            algorithm.SetSourceModeToCoordinates()
            algorithm.GenerateConstraintEdgesOn()
            algorithm.Update()
            surface = algorithm.GetOutput()
            found = values_of(surface.GetCellData().GetAbstractArray("ConstraintEdges"))
            expected = expected or found
            self.assertEqual(found, expected, kind)
            self.assertGreater(sum(found), 0)
        lines.SetLines(cells_of([(0, 1), (2, 3, 4)]))
        algorithm.Update()
        self.assertEqual(values_of(algorithm.GetOutput().GetCellData().GetAbstractArray("ConstraintEdges")), expected)


class EstimateTest(Case):
    """Copies that are read in place of arrays are in the estimate of memory, to the byte (it is in KiB)."""

    def points(self, seed, kind=core.VTK_DOUBLE):
        return cloud([[int(1e6 * x) for x in point] for point in places(MANY, seed)], kind)

    def estimate(self, given, lines=None, **settings):
        algorithm, said = run(given, **settings, **({"SourceData": lines} if lines else {}))
        self.assertEqual(said.errors, [])
        return algorithm.GetMemoryEstimate()

    def assertTakes(self, size, more, than):
        self.assertAlmostEqual(more - than, size / 1024, delta=1)

    def test_points(self):
        """Three doubles each: floats and doubles are read where they lie. Of the source where it brings its own."""
        exact, whole = (self.points(1, kind) for kind in (core.VTK_DOUBLE, core.VTK_INT))
        self.assertTakes(24 * MANY, self.estimate(whole), self.estimate(exact))
        for mode in (0, 1):
            lines = [self.points(2, kind) for kind in (core.VTK_DOUBLE, core.VTK_INT)]
            for one in lines:
                one.SetLines(cells_of([(0, 1)]))
            known, more = (self.estimate(exact, one, SourceMode=mode) for one in lines)
            self.assertTakes(24 * MANY * mode, more, known)

    def test_numbers(self):
        """A double for each value and weight, a byte for whether a point is kept."""
        given = self.points(1)
        given.GetPointData().AddArray(array("vtkFloatArray", "own", [1 + k % 7 for k in range(MANY)]))
        given.GetPointData().AddArray(array("vtkFloatArray", "none", MANY * [0]))
        known = self.estimate(given, MaximumError=1e-9)
        for setting, name, size in (("Value", "own", 8), ("Weight", "own", 8), ("Keep", "none", 1)):
            more = self.estimate(given, MaximumError=1e-9, **{setting + "ArrayName": name})
            self.assertTakes(size * MANY, more, known)

    @unittest.skipUnless(hasattr(model.vtkCellArray, "IsStorageGeneric"), "ids and offsets are of one kind")
    def test_cells(self):
        """Ids and offsets are read in place where both have 32 bits or both 64."""
        given, known = self.points(1), None
        for kinds, is_copied in ((("Int64", "Int64"), (0, 0)), (("Int32", "Int32"), (0, 0)),
                                 (("Int64", "Int32"), (0, 1)), (("Int32", "Int64"), (1, 0)),
                                 (("Int16", "Int32"), (1, 1)), (("UInt16", "Int16"), (1, 1))):  # fmt: skip
            ids, offsets = (getattr(core, "vtkType%sArray" % kind)() for kind in kinds)
            for data, step in ((ids, 1), (offsets, 4)):
                for k in range(0, MANY + 1 if step == 4 else MANY, step):
                    data.InsertNextValue(k)
            lines, cells = self.points(2), model.vtkCellArray()
            cells.SetData(offsets, ids)
            lines.SetLines(cells)
            found = self.estimate(given, lines, SourceMode=1)
            known = known or found
            with self.subTest(kinds=kinds):
                self.assertTakes(8 * (MANY * is_copied[0] + (MANY // 4 + 1) * is_copied[1]), found, known)


if __name__ == "__main__":
    run_tests()
