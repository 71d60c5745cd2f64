# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertInterpolation2D: the same outputs, messages and measures from the compiled class and from the one
in Python, as Interpolation.json has them; methods, defaults and ranges. AHD_WRITE_HASHES=1 with the compiled class
writes the file anew."""

import json
import re

from classtests import (FOLDER, TABLE, WRITES, Case, Filter, Said, array, blocks, cloud, core, model, run_tests, source,
                        tested_class, values_of, vtk, write_rows)
from inputs import full, square
from rastercases import CASES, image, surface_of, wanted_places
from test_cases import masked, of_array, of_attributes
from test_kept import scattered
from test_pipeline import behind
from test_settings import described

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")

FILE = FOLDER / "Interpolation.json"
MEASURES = (*(name for name, row in TABLE["interpolation"]["measures"].items() if row["type"] == "id"),
            "NumberOfTriangulations")

def set_all(algorithm, settings):
    for name, value in settings.items():
        target, _, own = name.rpartition(".")
        target = algorithm.GetTriangulation() if target else algorithm
        getattr(target, "Set" + own)(*(value if isinstance(value, tuple) else (value,)))


def of_output(data):
    found = {"class": data.GetClassName()}
    if data.IsA("vtkCompositeDataSet"):
        return dict(found, blocks=[of_output(data.GetBlock(i)) if data.GetBlock(i) else None
                                   for i in range(data.GetNumberOfBlocks())])
    if not data.IsA("vtkDataSet"):
        return found
    if data.IsA("vtkImageData"):
        found["image"] = [repr(numbers) for numbers in (data.GetExtent(), data.GetOrigin(), data.GetSpacing())]
    elif data.GetNumberOfPoints():
        found["points"] = of_array(data.GetPoints().GetData())
    for kind in ("PointData", "CellData", "FieldData"):
        rows = of_attributes(getattr(data, "Get" + kind)()) if data.GetNumberOfPoints() else {}
        found.update({kind: rows} if rows else {})
    return found


def record(given, settings):
    algorithm = Interpolation()
    algorithm.SetTriangulation(Filter())
    said = Said(algorithm)
    set_all(algorithm, settings)
    algorithm.SetInputDataObject(given)
    algorithm.Update()
    measures = {name: getattr(algorithm, "Get" + name)() for name in MEASURES}
    found = {"warnings": [masked(text) for text in said.warnings], "errors": [masked(text) for text in said.errors],
             "measures": measures, "output": of_output(algorithm.GetOutputDataObject(0)), "pipeline": said.pipeline}
    algorithm.Modified()
    algorithm.Update()
    found["again"] = of_output(algorithm.GetOutputDataObject(0)) == found["output"]
    found["triangulations"] = algorithm.GetNumberOfTriangulations()
    return found


def growing_square():
    """A class of sources: at time t the corners of a square with sides of 10 t."""
    base, pipeline = vtk("util.vtkAlgorithm").VTKPythonAlgorithmBase, vtk(
        "vtkCommonExecutionModel").vtkStreamingDemandDrivenPipeline

    class Growing(base):
        def __init__(self):
            base.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

        def RequestInformation(self, _request, _inputs, outputs):
            info = outputs.GetInformationObject(0)
            info.Set(pipeline.TIME_STEPS(), (1.0, 2.0, 3.0), 3)
            info.Set(pipeline.TIME_RANGE(), (1.0, 3.0), 2)
            return 1

        def RequestData(self, _request, _inputs, outputs):
            info = outputs.GetInformationObject(0)
            time = info.Get(pipeline.UPDATE_TIME_STEP()) if info.Has(pipeline.UPDATE_TIME_STEP()) else 1.0
            made = model.vtkPolyData.GetData(outputs, 0)
            made.ShallowCopy(cloud([(time * x, time * y, z) for x, y, z in square()]))
            return 1

    return Growing


def silent():
    """Its messages are not printed."""
    algorithm = Interpolation()
    Said(algorithm)
    return algorithm


class InterpolationTest(Case):
    def test_cases(self):
        found = {}
        for name, make in CASES.items():
            found[name] = json.loads(json.dumps(record(*make())))
        if WRITES:
            write_rows(FILE, dict(json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}, cases=found))
        expected = json.loads(FILE.read_text(encoding="utf-8"))["cases"]
        self.assertEqual(set(found), set(expected))
        for name, row in found.items():
            with self.subTest(name):
                self.assertEqual(row, expected[name])
                self.assertTrue(row["again"])

    def test_means_are_not_rounded_to_the_type_of_the_points(self):
        identity = vtk("vtkCommonTransforms").vtkTransform()
        for number, transform in ((core.VTK_FLOAT, None), (core.VTK_DOUBLE, None), (core.VTK_FLOAT, identity)):
            algorithm = Interpolation()
            algorithm.GetTriangulation().SetDuplicatePolicy(3)
            algorithm.GetTriangulation().SetTransform(transform)
            algorithm.SetInputDataObject(cloud([(0, 0, 0), (0, 0, 0), (0, 0, 1), (3, 0, 0), (0, 3, 0)], number))
            algorithm.SetPlacesData(cloud([(0, 0, 0)]))
            algorithm.Update()
            heights = values_of(algorithm.GetOutputDataObject(0).GetPointData().GetArray("Elevation"))
            self.assertEqual(list(heights), [1 / 3])

    def test_what_is_missing_is_named_and_why(self):
        given = cloud([(0, 0, 0), (8, 0, 1), (8, 8, 2), (0, 8, 3), (1, 1, 5), (7, 7, 4)])
        nan = float("nan")
        for name, values in (("depth", [1.0] * 6), ("salt", [1.0, 1.0, 1.0, 1.0, nan, 1.0])):
            given.GetPointData().AddArray(array("vtkDoubleArray", name, values))
        shore = source([(4, 2, 0), (4, 6, 0)], lines=[(0, 1)])
        places = cloud([(2, 1, 0), (5, 4, 0), (7.5, 7, 0), (0.5, 0.5, 0)])
        added = " Added points (of the source, for example) lack %s."
        none = "values at places on the surface are missing, because values of points are NaN"
        left = "values at places are interpolated without some of their natural neighbours, whose values are NaN"

        def check(wanted, begin=none, given=given, places=places, **settings):
            """`wanted`: with a count of each of the arrays that have a name."""
            algorithm = Interpolation()
            found = Said(algorithm)
            set_all(algorithm, settings)
            algorithm.SetInputDataObject(given)
            algorithm.SetPlacesData(places)
            algorithm.Update()
            self.assertEqual(found.errors, [])
            data = algorithm.GetOutputDataObject(0).GetPointData()
            counts = [sum(value != value for value in values_of(data.GetArray(name)))
                      for name in ("Elevation", "depth", "salt")]
            some = [count for count in counts if count]
            every = sum(some) or algorithm.GetNumberOfPlacesWithNeighborsLeftOut()
            self.assertGreater(every, 0)
            wanted = "%d %s%s" % (every, begin, wanted % tuple(some))
            self.assertEqual([text for text in found.warnings if "values at places" in text], [wanted])

        check(": %d of salt. No height is missing.")
        algorithm = Interpolation()
        algorithm.SetInputDataObject(given)
        algorithm.SetInputDataObject(1, blocks(
            cloud([(2, 1, 0), (7.5, 7, 0)]), cloud([(7.4, 7, 0)]), cloud([(0.5, 0.5, 0)])))
        said = Said(algorithm)
        algorithm.Update()
        self.assertEqual(said.warnings, ["2 " + none + ": 2 of salt. No height is missing."])
        check(": %d of salt. No height is missing.", Method=3)
        check(": salt.", left, Method=1)
        lacking = added % "depth, salt"
        made = {"Triangulation.SourceMode": 1, "SourceData": shore}
        check(": %d of depth, %d of salt. No height is missing." + lacking, **made)
        check(": depth, salt." + lacking, left, Method=1, **made)
        only = dict(places=cloud([(1, 1, 0)]))
        check(": %d of salt. No height is missing." + added % "salt", **only, **made)  # depth is there
        surface = Filter()
        surface.SetSourceMode(1)
        surface.SetInputDataObject(given)
        surface.SetSourceData(shore)
        surface.Update()
        check(": %d of depth, %d of salt. No height is missing." + lacking, given=surface.GetOutput())
        across = source([(0, 0, 0), (8, 0, 1), (8, 8, 2), (0, 8, 3), (1, 1, 5)], lines=[(0, 4, 2), (1, 3)])
        check(": %d of salt. No height is missing.", SourceData=across,  # the crossing's are those of its ends
              **{"Triangulation.CrossingMode": 1})
        given.GetPoints().SetPoint(4, 1, 1, nan)
        given.GetPoints().Modified()
        check(": %d heights, %d of salt.")
        check(": %d height, %d of salt.", **only)

    def test_arrays_with_more_values_than_points(self):
        """The first are those of the points, as in VTK's own filters."""
        given, longer = cloud(square()), cloud(square())
        for data, more in ((given, 0), (longer, 3)):
            data.GetPointData().AddArray(array("vtkDoubleArray", "depth", range(data.GetNumberOfPoints() + more)))
        for method in range(4):
            found = []
            for data in (given, longer):
                algorithm = Interpolation()
                said = Said(algorithm)
                algorithm.SetMethod(method)
                algorithm.SetNoValue(-1)
                algorithm.SetDimensions(4, 3)
                algorithm.SetInputData(data)
                algorithm.Update()
                self.assertSaid(said)
                found.append(values_of(algorithm.GetOutput().GetPointData().GetArray("depth")))
            self.assertEqual(len(found[0]), 12)
            self.assertEqual(*found)

    def test_methods_defaults_and_ranges(self):
        found = json.dumps(described(Interpolation), default=lambda thing: thing.GetClassName())
        found = json.loads(found.replace("NaN", '"NaN"'))
        if WRITES:
            write_rows(FILE, dict(json.loads(FILE.read_text(encoding="utf-8")), **found))
        expected = json.loads(FILE.read_text(encoding="utf-8"))
        self.assertGreater(len(expected["settings"]), 12)
        for name, row in expected["settings"].items():
            self.assertEqual(found["settings"].get(name), row, name)
        self.assertEqual(found["constants"], expected["constants"])
        self.assertEqual([name for name in expected["methods"] if name not in found["methods"]], [])
        for name in expected["methods"]:
            self.assertTrue(getattr(Interpolation, name).__doc__, name)

    def test_the_triangulation_is_kept(self):
        """Whatever the raster and the method; and not where the points or the way to triangulate have changed."""
        given, algorithm = full(), silent()
        algorithm.SetTriangulation(Filter())
        algorithm.SetInputData(given)
        for change in (lambda: None, lambda: algorithm.SetMethod(1), lambda: algorithm.SetDimensions(5, 5),
                       lambda: algorithm.SetPlacesData(wanted_places()), lambda: algorithm.SetInputData(full())):
            change()
            algorithm.Update()
            self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)
        algorithm.GetTriangulation().SetAlpha(300.0)
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 2)
        algorithm.SetInputData(full(199))
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 3)
        algorithm.GetTriangulation().KeepTriangulationOff()
        for count in (4, 5):
            algorithm.Modified()
            algorithm.Update()
            self.assertEqual(algorithm.GetNumberOfTriangulations(), count)

    def test_other_settings_with_the_same_transform_are_seen(self):
        """Although they were changed before the transform that both have."""
        whole, parts, transform = Filter(), Filter(), vtk("vtkCommonTransforms").vtkTransform()
        for settings in (whole, parts):
            settings.SetProjectionPlaneMode(1)
            settings.SetTransform(transform)
        parts.SetMaximumEdgeLength(1e-9)
        transform.RotateZ(30)
        algorithm, valid = silent(), []
        algorithm.SetInputData(full())
        for settings in (whole, parts, whole):
            algorithm.SetTriangulation(settings)
            algorithm.Update()
            valid.append(algorithm.GetNumberOfValidPlaces())
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 3)
        self.assertTrue(valid[0] == valid[2] > valid[1], valid)

    def test_blocks_of_places_are_refused_before_the_first(self):
        """The outputs of all exist at the same time."""
        places, algorithm = full(5000), silent()
        algorithm.SetInputData(full())
        given = {}
        for count in (1, 20):
            blocks = model.vtkMultiBlockDataSet()
            for k in range(count):
                blocks.SetBlock(k, places)
            algorithm.SetInputDataObject(1, blocks)
            algorithm.Update()
            given[count] = algorithm.GetMemoryEstimate()
        self.assertGreater(given[20], given[1] + 19 * 5000 * 9 // 1024)
        before = algorithm.GetNumberOfTriangulations()
        algorithm.GetTriangulation().SetMemoryLimit((given[1] + given[20]) // 2)
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), before)
        self.assertEqual(algorithm.GetNumberOfPlaces(), 0)

    def test_blocks_without_memory_are_one_error(self):
        blocks, algorithm = model.vtkMultiBlockDataSet(), Interpolation()
        algorithm.SetTriangulation(Filter())
        blocks.SetBlock(0, full())
        blocks.SetBlock(1, full(500))
        said = Said(algorithm)
        algorithm.SetInputDataObject(blocks)
        algorithm.GetTriangulation().SetMemoryLimit(1)
        algorithm.Update()
        self.assertEqual(len(said.errors), 1, said.errors)

    def test_memory_is_refused_with_figures_of_this_execution(self):
        """Also where the triangulation of the last one is kept."""
        given, texts = full(), []
        for is_kept in (False, True):
            algorithm = Interpolation()
            algorithm.SetInputData(given)
            if is_kept:
                algorithm.Update()
            said = Said(algorithm)
            algorithm.SetDimensions(10**6, 10**6)
            algorithm.Update()
            self.assertSaid(said, errors=1)
            texts.append(said.errors[0])
        numbers = [int(re.search("set MemoryLimit to ([0-9]+) or more", text).group(1)) for text in texts]
        self.assertGreater(numbers[1], 10**9, texts)  # KiB
        self.assertEqual(*numbers, texts)

    def test_no_raster_is_found_without_memory_for_that(self):
        """Where the points lie in the plane takes a copy of them: 24 KiB."""
        algorithm = Interpolation()
        algorithm.SetInputData(full(1000))
        algorithm.GetTriangulation().SetProjectionPlaneMode(1)
        algorithm.GetTriangulation().SetTransform(vtk("vtkCommonTransforms").vtkSphericalTransform())
        algorithm.GetTriangulation().SetMemoryLimit(20)
        said = Said(algorithm)
        for make, places in ((algorithm.Modified, "65536 places"),
                             (algorithm.SetRasterSizeToByCellSize, "the places of a raster")):
            make()
            algorithm.Update()
            self.assertRegex(said.errors[-1], "Interpolating at %s from 1000 points may take .* MemoryLimit" % places)
            self.assertGreater(algorithm.GetMemoryEstimate(), 50)
        self.assertEqual(len(said.errors), 2)

    def test_values_change_on_a_surface_that_is_kept(self):
        given, algorithm = cloud(square()), Interpolation()
        given.GetPointData().AddArray(array("vtkDoubleArray", "a", [1, 1, 1, 1]))
        algorithm.SetInputData(given)
        algorithm.SetDimensions(2, 2)
        algorithm.Update()
        given.GetPointData().GetArray("a").Fill(5.0)
        given.Modified()
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)
        self.assertEqual(algorithm.GetOutput().GetPointData().GetArray("a").GetRange(), (5.0, 5.0))

    def test_an_array_that_the_input_no_longer_has_is_gone(self):
        """Scalars too, which VTK leaves in an image; and they would be of as many cells as there were."""
        given, algorithm = cloud(square()), silent()
        given.GetPointData().SetScalars(array("vtkDoubleArray", "a", [1, 1, 1, 1]))
        algorithm.SetInputData(given)
        for columns, names in ((2, ["Elevation", "a", "vtkValidPointMask"]), (3, ["Elevation", "vtkValidPointMask"])):
            algorithm.SetDimensions(columns, 2)
            algorithm.Update()
            data = algorithm.GetOutput().GetPointData()
            self.assertEqual([data.GetArrayName(k) for k in range(data.GetNumberOfArrays())], names)
            given.GetPointData().RemoveArray("a")
            given.Modified()

    def test_filters_behind_know_the_raster_before_there_are_data(self):
        algorithm = silent()
        algorithm.SetInputData(full())
        algorithm.SetRasterSizeToByCellSize()
        algorithm.SetCellSize(100.0, 50.0)
        algorithm.SetMethodToNearest()
        algorithm.GetInput().GetPointData().SetActiveScalars("Kind")
        algorithm.UpdateInformation()
        data, info = model.vtkDataObject, algorithm.GetOutputInformation(0)
        scalars = data.GetActiveFieldInformation(info, data.FIELD_ASSOCIATION_POINTS, 0)
        self.assertEqual(scalars.Get(data.FIELD_ARRAY_TYPE()), core.VTK_INT)
        pipeline = vtk("vtkCommonExecutionModel").vtkStreamingDemandDrivenPipeline
        self.assertEqual(algorithm.GetOutputInformation(0).Get(pipeline.WHOLE_EXTENT()), (0, 9, 0, 19, 0, 0))
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetExtent(), (0, 9, 0, 19, 0, 0))

    def test_a_raster_that_is_too_large_is_not_announced(self):
        """9 bytes for each place; downstream filters for images may allocate one as large."""
        algorithm, pipeline = silent(), vtk("vtkCommonExecutionModel").vtkStreamingDemandDrivenPipeline
        algorithm.SetInputData(full())
        algorithm.SetDimensions(1000, 1000)
        whole, none = (0, 999, 0, 999, 0, 0), (0, -1, 0, -1, 0, -1)
        for limit, extent in ((8790, whole), (8700, none), (8790, whole)):
            algorithm.GetTriangulation().SetMemoryLimit(limit)
            algorithm.Modified()
            algorithm.UpdateInformation()
            self.assertEqual(algorithm.GetOutputInformation(0).Get(pipeline.WHOLE_EXTENT()), extent)

    def test_points_that_change_with_time(self):
        """The raster is that of the time; the next update announces it."""
        algorithm, pipeline = silent(), vtk("vtkCommonExecutionModel").vtkStreamingDemandDrivenPipeline
        points = growing_square()()
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.SetRasterSizeToByCellSize()
        for time, cells in ((1.0, 10), (3.0, 30), (2.0, 20)):
            algorithm.UpdateTimeStep(time)
            self.assertEqual(algorithm.GetOutput().GetDimensions()[:2], (cells, cells))
            algorithm.Update()
            self.assertEqual(algorithm.GetOutputInformation(0).Get(pipeline.WHOLE_EXTENT())[1], cells - 1)

    def test_a_time_whose_raster_is_refused(self):
        """A downstream filter is not run, as one for images would read out of bounds; and at the time before and after
        there is the raster of that time."""
        algorithm = silent()
        points, after = growing_square()(), behind(algorithm)
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.SetRasterSizeToByCellSize()
        algorithm.SetCellSize(0.05, 0.05)
        algorithm.GetTriangulation().SetMemoryLimit(2700)
        for time, cells in ((1.0, 200), (3.0, 0), (1.0, 200), (2.0, 400), (3.0, 0), (2.0, 400)):
            after.UpdateTimeStep(time)
            self.assertEqual(algorithm.GetOutput().GetDimensions()[:2], (cells, cells), time)
            self.assertGreater(after.GetOutput().GetNumberOfPoints(), 0, time)

    def test_a_surface_that_changes(self):
        """Kept with its own triangles and constraints."""
        surface = surface_of("breaklines")
        algorithm = silent()
        algorithm.SetMethod(1)
        algorithm.SetInputData(surface)
        found = []
        for change in (None, None, "edges", "triangles"):
            if change == "edges":
                surface.GetCellData().GetArray("ConstraintEdges").Fill(0)
            if change == "triangles":
                surface.ShallowCopy(surface_of("size_limits"))
            surface.Modified()
            algorithm.Update()
            found.append((algorithm.GetNumberOfTriangulations(), values_of(
                algorithm.GetOutput().GetPointData().GetArray("Elevation"))))
        self.assertEqual([count for count, _ in found], [1, 1, 2, 3])
        self.assertEqual(str(found[0][1]), str(found[1][1]))
        self.assertNotEqual(str(found[1][1]), str(found[2][1]))

    def test_a_surface_to_which_others_added(self):
        """Strips, which are behind the triangles; an array with the name of a count, of which none is one."""
        strip, words = model.vtkCellArray(), array("vtkStringArray", "NumberOfAddedPoints", ["3"])
        strip.InsertNextCell(3)
        for point in (0, 1, 2):
            strip.InsertCellPoint(point)
        changes = {
            "nothing": lambda surface: None,
            "a strip": lambda surface: surface.SetStrips(strip),
            "words": lambda surface: surface.GetFieldData().AddArray(words)}
        found = {}
        for name, change in changes.items():
            surface, algorithm = surface_of("breaklines"), silent()
            edges = surface.GetCellData().GetArray("ConstraintEdges")
            change(surface)
            if surface.GetNumberOfCells() > edges.GetNumberOfTuples():
                edges.InsertNextValue(0)
            algorithm.SetMethod(1)
            algorithm.SetInputData(surface)
            algorithm.Update()
            found[name] = str(values_of(algorithm.GetOutput().GetPointData().GetArray("Elevation")))
        self.assertEqual(found, dict.fromkeys(changes, found["nothing"]))

    def test_aborted(self):
        """The output is empty, without a message."""
        algorithm = Interpolation()
        said = Said(algorithm)
        algorithm.SetInputData(full(5000))
        algorithm.AddObserver("ProgressEvent", lambda caller, _event: caller.SetAbortExecute(1))
        algorithm.Update()
        self.assertEqual((algorithm.GetOutput().GetNumberOfPoints(), said.errors, said.warnings), (0, [], []))
        self.assertEqual(algorithm.GetNumberOfPlaces(), 0)

    def test_progress_never_falls(self):
        told, algorithm = [], silent()
        algorithm.SetInputData(full(5000))
        algorithm.SetMethod(1)
        algorithm.AddObserver("ProgressEvent", lambda caller, _event: told.append(caller.GetProgress()))
        algorithm.Update()
        self.assertGreater(len(told), 5)
        self.assertEqual(told, sorted(told))
        self.assertLessEqual((told[-1], told.count(1.0)), (1.0, 2))  # the filter's and VTK's, at the end

    def test_the_name_of_the_class(self):
        algorithm = Interpolation()
        self.assertEqual(algorithm.GetClassName(), "vtkAdaptiveHilbertInterpolation2D")
        for name in ("vtkAdaptiveHilbertInterpolationAlgorithm", "vtkDataSetAlgorithm", "vtkAlgorithm"):
            self.assertEqual(algorithm.IsA(name), 1, name)
        self.assertEqual(algorithm.GetTriangulation().GetClassName(), "vtkAdaptiveHilbertDelaunay2D")
        self.assertIn("\n  CellSize: 1, 1\n", str(algorithm))

    def test_arguments_of_another_kind(self):
        algorithm = Interpolation()
        for method, value in (("SetPlacesData", vtk("vtkCommonCore").vtkPoints()), ("SetSourceData", image()),
                              ("SetTriangulation", algorithm), ("SetTriangulation", 3)):
            with self.assertRaises(TypeError, msg=method):
                getattr(algorithm, method)(value)
        algorithm.SetSourceData(source(lines=[(0, 1)]))
        algorithm.SetPlacesData(image())
        self.assertEqual(algorithm.GetSource().GetNumberOfCells(), 1)
        self.assertEqual(algorithm.GetPlaces().GetClassName(), "vtkImageData")


class EstimateTest(Case):
    """Testing/Package/Memory compares memory taken with estimates."""

    def test_the_triangulation_counts(self):
        """That of an execution which makes it anew, and of one on a kept surface."""
        algorithm = silent()
        algorithm.SetInputData(cloud(scattered(20000)))
        algorithm.SetDimensions(2, 2)
        estimates = []
        for _ in range(2):
            algorithm.Modified()
            algorithm.Update()
            estimates.append(algorithm.GetMemoryEstimate() * 1024 / 20000)
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)
        self.assertTrue(100 < estimates[0] < 350, estimates)
        self.assertLess(abs(estimates[0] - estimates[1]), 1.0)


if __name__ == "__main__":
    run_tests()
