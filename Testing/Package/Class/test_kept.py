# SPDX-License-Identifier: BSD-3-Clause
"""Data kept between executions: a filter that is used again gives the results of a new one, after any change of its
input, its outputs and their memory."""

import functools
import random

from classtests import (Case, Filter, Random, Said, array, blocks, cells_of, cloud, core, model, run_tests,
                        source, tested_class, vtk)

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
QualityMesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
NUMBERS = vtk("util.numpy_support")
COUNT = 60


@functools.lru_cache(None)
def scattered(count=COUNT, seed=1):
    numbers = Random(seed)
    return [(numbers.below(10**6), numbers.below(10**6), i % 7) for i in range(count)]


def square():
    """A source of lines and polygons with its own points."""
    outer = [(-9, -9, 1), (10**6, -9, 2), (10**6, 10**6, 3), (-9, 10**6, 4)]
    inner = [(4e5, 4e5, 5), (5e5, 4e5, 6), (5e5, 5e5, 7)]
    return source(outer + inner, lines=[(4, 5), (5, 6, 4)], polygons=[(0, 1, 2, 3), (4, 5, 6)])


def with_source(algorithm, lines):
    algorithm.SetInputDataObject(algorithm.GetNumberOfInputPorts() - 1, lines)
    return algorithm


def numbers_of(data):
    """The bytes of an array."""
    return NUMBERS.vtk_to_numpy(data).tobytes() if data is not None and data.GetNumberOfTuples() else b""


def contents(data):
    """All data of an output."""
    found = [data.GetClassName(), data.GetNumberOfPoints()]
    if data.IsA("vtkPointSet"):
        found.append(numbers_of(data.GetPoints() and data.GetPoints().GetData()))
    for kind in ("Verts", "Lines", "Polys") if data.IsA("vtkPolyData") else ():
        cells = getattr(data, "Get" + kind)()
        found.append([numbers_of(part) for part in (cells.GetConnectivityArray(), cells.GetOffsetsArray())]
                     if cells.GetNumberOfCells() else [])
    for part in (data.GetPointData(), data.GetCellData()):
        found += [(part.GetArrayName(i), numbers_of(part.GetArray(i))) for i in range(part.GetNumberOfArrays())]
    return found


def silent(algorithm):
    """Its messages are not printed."""
    Said(algorithm)
    return algorithm


def triangulation(**settings):
    """Constraints by ids: outputs with points of a source are not kept."""
    algorithm = silent(Filter())
    for name, value in dict(settings, GenerateVoronoi=True, GenerateRegionIds=True).items():
        getattr(algorithm, "Set" + name)(value)
    return algorithm


def interpolation(**settings):
    algorithm = silent(Interpolation())
    algorithm.SetDimensions(6, 5)
    for name, value in dict(settings, SourceMode=1).items():
        getattr(algorithm.GetTriangulation(), "Set" + name)(value)
    return algorithm


def outputs(algorithm):
    return [contents(algorithm.GetOutputDataObject(port)) for port in range(algorithm.GetNumberOfOutputPorts())]


def updated(algorithm, given, lines=None):
    """With these inputs."""
    for port, data in ((0, given), (algorithm.GetNumberOfInputPorts() - 1, lines)):
        there = algorithm.GetNumberOfInputConnections(port)
        if data is not (algorithm.GetInputDataObject(port, 0) if there else None):
            algorithm.SetInputDataObject(port, data)
    algorithm.Modified() if algorithm.IsA("vtkAdaptiveHilbertInterpolation2D") else given.Modified()
    algorithm.Update()
    return outputs(algorithm)


def with_arrays(given, lines):
    given.GetPointData().AddArray(array("vtkDoubleArray", "depth", range(given.GetNumberOfPoints())))
    lines.GetPointData().AddArray(array("vtkDoubleArray", "depth", range(lines.GetNumberOfPoints())))


# Possible changes: of the input, of the source.
CHANGES = {
    "a point": lambda given, lines: given.GetPoints().SetPoint(COUNT - 1, 5, 5, 5),
    "a height": lambda given, lines: given.GetPoints().SetPoint(0, *given.GetPoint(0)[:2], 1e3),
    "a mark": lambda given, lines: given.GetPointData().AddArray(
        array("vtkUnsignedCharArray", "vtkGhostType", (COUNT - 1) * [0] + [1])),
    "a point of the source": lambda given, lines: lines.GetPoints().SetPoint(6, 6e5, 6e5, 7),
    "a line's id": lambda given, lines: lines.SetLines(cells_of([(4, 5), (5, 6, 0)])),
    "where a line ends": lambda given, lines: lines.SetLines(cells_of([(4, 5, 5), (6, 4)])),
    "a polygon's id": lambda given, lines: lines.SetPolys(cells_of([(0, 1, 2, 3), (4, 5, 3)])),
    "where a polygon ends": lambda given, lines: lines.SetPolys(cells_of([(0, 1, 2), (3, 4, 5, 6)])),
    "a vertex": lambda given, lines: lines.SetVerts(cells_of([(4,)])),
    "no polygon": lambda given, lines: lines.SetPolys(cells_of([])),
    "no source": lambda given, lines: lines.Initialize(),
}


class ChangesTest(Case):
    """Each array of a triangulation is checked."""

    def assertLikeNew(self, make, given, lines, algorithm, what):
        self.assertTrue(updated(algorithm, given, lines) == updated(make(), given, lines), what)

    def test_each_is_noticed(self):
        for make in (triangulation, interpolation):
            for what, change in CHANGES.items():
                given, lines, algorithm = cloud(scattered()), square(), make()
                with_arrays(given, lines)
                for _ in range(3):
                    updated(algorithm, given, lines)
                before = algorithm.GetNumberOfTriangulations()
                self.assertEqual(before, 2 if make is triangulation else 1, what)
                updated(algorithm, given, lines)
                self.assertEqual(algorithm.GetNumberOfTriangulations(), before, what)
                change(given, lines)
                for data in (given.GetPoints(), lines.GetLines(), lines.GetPolys(), lines):
                    data.Modified()
                self.assertLikeNew(make, given, lines, algorithm, what)
                self.assertEqual(algorithm.GetNumberOfTriangulations(), before + 1, what)

    def test_the_source_s_data_are_looked_at_again(self):
        """On a kept triangulation."""
        given, lines, algorithm = cloud(scattered()), square(), interpolation()
        with_arrays(given, lines)
        updated(algorithm, given, lines)
        lines.GetPointData().GetArray("depth").Fill(1e4)
        self.assertLikeNew(interpolation, given, lines, algorithm, "")
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)

    def test_whole_numbers_are_kept(self):
        """Points of which a copy is read."""
        given, algorithm = cloud(scattered(), core.VTK_INT), interpolation()
        for change in (lambda: None, lambda: None, lambda: given.GetPoints().SetPoint(COUNT - 1, 5, 5, 5)):
            change()
            self.assertTrue(updated(algorithm, given) == updated(interpolation(), given))
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 2)

    def test_what_was_given_first_is_changed(self):
        """While an equal array has its place."""
        for with_source in (False, True):
            first, lines, algorithm = cloud(scattered()), square() if with_source else None, interpolation()
            updated(algorithm, first, lines)
            second = model.vtkPolyData()
            second.DeepCopy(first)
            for i in range(COUNT):
                first.GetPoints().SetPoint(i, i, i * i, 9)
            self.assertLikeNew(interpolation, second, lines, algorithm, with_source)


class MemoryTest(Case):
    """Numbers that are the same, at another address."""

    def start(self, count=3000):
        """Points whose memory is NumPy's."""
        import numpy

        base = numpy.array(scattered(count), float)
        base[:, 2] = base[:, 0] + base[:, 1]
        numbers, points, given = core.vtkDoubleArray(), core.vtkPoints(), model.vtkPolyData()
        numbers.SetNumberOfComponents(3)
        points.SetData(numbers)
        given.SetPoints(points)
        return base, numbers, points, given

    def assertIsPlane(self, algorithm, given, what):
        updated(algorithm, given)
        made = algorithm.GetOutput()
        heights = made.GetPointData().GetArray("Elevation")
        for i in range(made.GetNumberOfPoints()):
            x, y, _ = made.GetPoint(i)
            self.assertAlmostEqual(heights.GetValue(i), x + y, delta=1e-6, msg=what)

    def test_double_buffers(self):
        """Of which the one that is not used is written by the owner."""
        base, numbers, points, given = self.start()
        algorithm, buffers = interpolation(), [base.copy(), base.copy()]
        algorithm.SetUseBounds(True)
        algorithm.SetBounds(3e5, 6e5, 3e5, 6e5)
        for k in range(4):
            buffers[k % 2][:] = base
            numbers.SetVoidArray(buffers[k % 2], base.size, 1)
            for data in (numbers, points, given):
                data.Modified()
            buffers[1 - k % 2][:] = 7 * base[::-1] + k
            self.assertIsPlane(algorithm, given, k)

    def test_memory_that_is_taken_anew(self):
        base, _, _, _ = self.start(20000)
        for change in ("Resize", "Initialize"):
            points, given, algorithm = core.vtkPoints(), model.vtkPolyData(), interpolation()
            points.SetDataTypeToDouble()
            given.SetPoints(points)
            algorithm.SetUseBounds(True)
            algorithm.SetBounds(3e5, 6e5, 3e5, 6e5)
            for k in range(3):
                if change == "Initialize" or k == 0:
                    points.Initialize()
                    points.SetNumberOfPoints(len(base))
                    NUMBERS.vtk_to_numpy(points.GetData())[:] = base
                else:
                    numbers = points.GetData()  # renamed in VTK 9.7
                    getattr(numbers, "ReserveTuples", numbers.Resize)(3 * 4**k * len(base))
                junk = [core.vtkDoubleArray() for _ in range(4)]
                for data in junk:
                    data.SetNumberOfTuples(3 * len(base))
                    data.Fill(-1e9 - k)
                points.Modified()
                self.assertIsPlane(algorithm, given, change)


def first_cell(algorithm):
    cells = algorithm.GetOutput().GetPolys().GetConnectivityArray()
    cells.SetValue(0, cells.GetValue(1))


def fewer_cells(algorithm):
    algorithm.GetOutput().GetPolys().Initialize()


def regions(algorithm):
    algorithm.GetOutput().GetCellData().GetArray("RegionId").Fill(7)


def name(algorithm):
    algorithm.GetOutput().GetCellData().GetArray("RegionId").SetName("another")


def colours(algorithm):
    algorithm.GetOutput().GetCellData().GetArray("RegionId").CreateDefaultLookupTable()


def component(algorithm):
    algorithm.GetOutput().GetPointData().GetArray("Fate").SetComponentName(0, "what it came to")


def means(algorithm):
    algorithm.GetOutput().GetPoints().SetPoint(0, 1, 2, 3)


def fates(algorithm):
    algorithm.GetOutput().GetPointData().GetArray("Fate").SetValue(COUNT - 1, -5)


def diagram(algorithm):
    algorithm.GetOutput(2).GetPoints().SetPoint(0, 1, 2, 3)


def sites(algorithm):
    algorithm.GetOutput(2).GetCellData().GetArray("OriginalPointIds").SetValue(3, 0)


def number(algorithm):
    algorithm.GetOutput().GetFieldData().GetArray("NumberOfTriangles").SetValue(0, 1)


class EditsTest(Case):
    def test_outputs_that_their_owner_edits_are_not_passed_on(self):
        given = cloud(scattered(COUNT - 1) + [(*scattered(1)[0][:2], 50)])
        settings = {"DuplicatePolicy": 3, "GenerateFate": True}
        expected = updated(triangulation(**settings), given)
        for edit in (first_cell, fewer_cells, regions, name, colours, component, means, fates, diagram, sites, number):
            algorithm = triangulation(**settings)
            for _ in range(3):
                updated(algorithm, given)
            before = algorithm.GetNumberOfTriangulations()
            self.assertEqual(before, 2)
            edit(algorithm)
            self.assertTrue(updated(algorithm, given) == expected, edit.__name__)
            self.assertEqual(algorithm.GetNumberOfTriangulations(), before + 1, edit.__name__)
            self.assertGreater(algorithm.GetOutput().GetFieldData().GetArray("NumberOfTriangles").GetValue(0), 9)


# By name, an array of the input or of the source.
ARRAYS = {
    "points": lambda given, _: given.GetPoints().GetData(),
    "numbers": lambda given, _: given.GetPointData().GetArray("depth"),
    "points of the source": lambda _, lines: lines.GetPoints().GetData(),
    "numbers of the source": lambda _, lines: lines.GetPointData().GetArray("depth"),
    "ids of lines": lambda _, lines: lines.GetLines().GetConnectivityArray(),
    "offsets of lines": lambda _, lines: lines.GetLines().GetOffsetsArray(),
    "ids of polygons": lambda _, lines: lines.GetPolys().GetConnectivityArray(),
    "offsets of polygons": lambda _, lines: lines.GetPolys().GetOffsetsArray(),
    "ids of vertices": lambda _, lines: lines.GetVerts().GetConnectivityArray(),
}


class ObserversTest(Case):
    """Observers of progress change the filter's data."""

    def watched(self, make, given, change, **settings):
        algorithm, seen = make(**settings), []

        def look(_caller, _event):
            seen.append(1)
            if algorithm.GetProgress() > 0.1:
                change(algorithm)

        algorithm.AddObserver("ProgressEvent", look)
        algorithm.SetInputDataObject(0, given)
        algorithm.Update()
        self.assertGreater(len(seen), 5)
        return [] if algorithm.GetOutputDataObject(0).IsA("vtkCompositeDataSet") else outputs(algorithm)

    def test_input(self):
        for make in (triangulation, interpolation):
            expected = updated(make(), cloud(scattered(20000)))
            for change in (lambda given: given.Initialize(), lambda given: given.SetPoints(None),
                           lambda given: given.GetPoints().SetData(cloud(scattered(9)).GetPoints().GetData())):
                given = cloud(scattered(20000))
                with_arrays(given, given)
                again = cloud(scattered(20000))
                self.assertTrue(self.watched(make, again, lambda _: change(again)) == expected)

    def test_source(self):
        expected = updated(triangulation(SourceMode=1), cloud(scattered(20000)), square())
        for change in (lambda lines: lines.GetPoints().SetData(cloud(scattered(3)).GetPoints().GetData()),
                       lambda lines: lines.GetLines().ShallowCopy(cells_of([(0, 1)])),
                       lambda lines: lines.GetPolys().ShallowCopy(cells_of([(0, 1, 5)]))):
            lines = square()
            found = self.watched(lambda **settings: with_source(triangulation(**settings), lines),
                                 cloud(scattered(20000)), lambda _: change(lines), SourceMode=1)
            self.assertTrue(found == expected)

    def test_places(self):
        def at(places):
            algorithm = interpolation()
            algorithm.SetInputDataObject(1, places)
            return algorithm

        expected = updated(at(cloud(scattered(50, 2))), cloud(scattered(20000)))
        for change in (lambda places: places.Initialize(), lambda places: places.GetPoints().SetData(
                cloud(scattered(9)).GetPoints().GetData())):
            places = cloud(scattered(50, 2))
            found = self.watched(lambda: at(places), cloud(scattered(20000)), lambda _: change(places))
            self.assertTrue(found == expected)

    def test_the_size_of_an_array(self):
        """Of any that is read: an error before more of it is read. Of others it does not matter."""
        for make in (triangulation, interpolation, lambda: silent(QualityMesh())):
            for name, arrays in ARRAYS.items():
                given, lines = cloud(scattered(3000)), square()
                with_arrays(given, lines)
                lines.SetVerts(cells_of([(0,), (1,)]))
                taken, algorithm = arrays(given, lines), with_source(make(), lines)
                said = Said(algorithm)
                algorithm.SetInputDataObject(0, given)
                algorithm.AddObserver(
                    "ProgressEvent", lambda *_: algorithm.GetProgress() > 0.1 and taken.SetNumberOfTuples(1))
                algorithm.Update()
                with self.subTest(kind=algorithm.GetClassName(), array=name):
                    self.assertEqual(["other memory or another size" in text for text in said.errors],
                                     [] if name == "ids of vertices" else [True])

    def test_outputs(self):
        """They are empty until all is written, and data that observers take from them before are not lost."""
        for make, ports in ((triangulation, 3), (interpolation, 1)):
            given = cloud(scattered() + [(float("nan"), 0, 0)])  # which a warning reports
            expected, algorithm, seen = updated(make(GenerateVoronoi=True), given), make(GenerateVoronoi=True), []

            def look(*_):
                for port in range(ports):
                    output = algorithm.GetOutputDataObject(port)
                    seen.append((output.GetNumberOfPoints(), output.GetNumberOfCells()))
                    output.Initialize()

            algorithm.AddObserver("WarningEvent", look)
            for _ in range(4):  # the last two pass on kept outputs
                self.assertTrue(updated(algorithm, given) == expected)
            self.assertGreater(len(seen), 0)
            self.assertEqual(set(seen), {(0, 0)})

    def test_transform(self):
        def bent():
            made = vtk("vtkCommonTransforms").vtkThinPlateSplineTransform()
            places = core.vtkPoints(), core.vtkPoints()
            for k, points in enumerate(places):
                for x, y, _ in scattered(12):
                    points.InsertNextPoint(x + k * y / 9, y, 0)
            made.SetSourceLandmarks(places[0])
            made.SetTargetLandmarks(places[1])
            made.SetBasisToR2LogR()
            return made

        for make in (triangulation, interpolation):
            def drop(algorithm):
                (algorithm.GetTriangulation() if make is interpolation else algorithm).SetTransform(None)

            expected = updated(make(ProjectionPlaneMode=1, Transform=bent()), cloud(scattered(20000)))
            found = self.watched(make, cloud(scattered(20000)), drop, ProjectionPlaneMode=1, Transform=bent())
            self.assertTrue(found == expected)

    def test_settings(self):
        """They count from the next execution on."""
        def change(algorithm):
            algorithm.SetDuplicatePolicy(3)
            algorithm.SetSourceMode(1)
            algorithm.SetGenerateNeighbors(True)
            algorithm.SetGenerateVoronoi(False)

        given = cloud(scattered(20000))
        self.assertTrue(self.watched(triangulation, given, change) == updated(triangulation(), given))

        def change_interpolation(algorithm):
            algorithm.SetGenerateGradients(True)
            algorithm.SetHeightArrayName("z")
            algorithm.SetOutside(1)
            algorithm.SetOutputType(1)

        found = self.watched(interpolation, given, change_interpolation)
        self.assertTrue(found == updated(interpolation(), given))

    def test_triangulation(self):
        given = cloud(scattered(20000))
        found = self.watched(interpolation, given, lambda algorithm: algorithm.SetTriangulation(Filter()))
        self.assertTrue(found == updated(interpolation(), given))

    def test_triangulation_that_goes_between_two_blocks_of_places(self):
        def stretched():
            made = vtk("vtkCommonTransforms").vtkTransform()
            made.Scale(2, 1, 1)
            return made

        expected = None
        for change in (lambda algorithm: None, lambda algorithm: algorithm.SetTriangulation(None),
                       lambda algorithm: algorithm.GetTriangulation().SetTransform(stretched()),
                       lambda algorithm: algorithm.GetTriangulation().SetMaximumEdgeLength(1e-9)):
            algorithm = interpolation(ProjectionPlaneMode=1, Transform=vtk("vtkCommonTransforms").vtkTransform(), Rim=1)
            algorithm.SetInputDataObject(1, blocks(cloud(scattered(50, 2)), cloud(scattered(70, 3))))
            self.watched(lambda: algorithm, cloud(scattered(20000)), change)
            self.assertEqual((algorithm.GetNumberOfPlaces(), algorithm.GetNumberOfValidPlaces()), (120, 120))
            found = [contents(algorithm.GetOutputDataObject(0).GetBlock(k)) for k in range(2)]
            self.assertTrue(found == (expected or found))
            self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)
            expected = found


class SeriesTest(Case):
    """One filter for a long time, after random changes, against a new one at each."""

    def changed(self, numbers, given, lines):
        def array_of(count):
            return array("vtkDoubleArray", "depth", [numbers.random() for _ in range(count)])

        def ids(sizes):
            return [[numbers.randrange(7) for _ in range(size)] for size in sizes]

        kind = numbers.randrange(8)
        if kind == 0:
            given.GetPointData().AddArray(array_of(COUNT))
        elif kind == 1:
            given.GetPoints().SetPoint(numbers.randrange(COUNT), *(numbers.uniform(0, 1e6) for _ in range(3)))
            given.GetPoints().Modified()
        elif kind == 2:
            lines.SetPolys(cells_of(ids([4])))
        elif kind == 3:
            lines.SetLines(cells_of(ids(numbers.choice(([2, 3], [3, 2], [5])))))
        elif kind == 4:
            lines.GetPointData().AddArray(array_of(7))
        elif kind == 5:
            copy = model.vtkPolyData()
            copy.DeepCopy(given)
            if numbers.random() < 0.7:
                for i in range(COUNT):
                    given.GetPoints().SetPoint(i, i % 9, i % 7, 9)
            return copy
        elif kind == 6:
            marks = [numbers.choice((0, 0, 0, 2)) for _ in range(COUNT)]
            given.GetPointData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", marks))
        return given

    def test_series(self):
        for seed in range(8):
            numbers, make = random.Random(seed), (triangulation, interpolation)[seed % 2]
            given, lines, algorithm = cloud(scattered()), square(), make()
            with_arrays(given, lines)
            for step in range(20):
                given = self.changed(numbers, given, lines)
                lines.Modified()
                self.assertTrue(updated(algorithm, given, lines) == updated(make(), given, lines), (seed, step))


if __name__ == "__main__":
    run_tests()
