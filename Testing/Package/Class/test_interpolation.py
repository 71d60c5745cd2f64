# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertInterpolation2D: the same outputs, messages and measures from the compiled class and from the one
in Python, as Interpolation.json has them; methods, defaults and ranges. AHD_WRITE_HASHES=1 with the compiled class
writes the file anew."""

import json
import math

from classtests import (FOLDER, WRITES, Case, Filter, Said, array, blocks, cloud, core, model, run_tests, source,
                        tested_class, vtk, write_rows)
from inputs import full, lines_and_loops, scattered, square
from test_cases import masked, of_array, of_attributes
from test_settings import described

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")

FILE = FOLDER / "Interpolation.json"
NAN = math.nan
MEASURES = ("NumberOfPlaces", "NumberOfValidPlaces", "NumberOfPlacesOutside", "NumberOfNotFinitePlaces",
            "NumberOfPlacesWithoutValue", "NumberOfPlacesWithNeighborsLeftOut", "NumberOfTriangulations")
SMALL = {"Dimensions": (13, 7)}
CASES = {}


def case(make):
    """A function that makes an input and settings; those of Triangulation have its name before theirs."""
    CASES[make.__name__] = make
    return make


def wanted_places():
    """On the surface, beyond it, in between, not finite; with data of their own."""
    made = cloud([(x * 101.0, y * 77.0, 5.0) for x in range(-1, 12) for y in range(-1, 14)] + [(NAN, 1, 2)])
    count = made.GetNumberOfPoints()
    made.GetPointData().AddArray(array("vtkDoubleArray", "Height", range(count)))
    made.GetPointData().AddArray(array("vtkIntArray", "Own", range(count)))
    made.GetFieldData().AddArray(array("vtkDoubleArray", "Month", [7.0]))
    return made


def image(kind="vtkImageData"):
    made = getattr(model, kind)()
    made.SetDimensions(9, 8, 1)
    if kind == "vtkImageData":
        made.SetOrigin(50.0, 60.0, 7.0)
        made.SetSpacing(100.0, 90.0, 1.0)
    return made


def holey():
    """Values that are NaN at some points."""
    made = full(120)
    heights = made.GetPointData().GetArray("Height")
    for i in range(0, 120, 9):
        heights.SetValue(i, NAN)
    return made


@case
def linear():
    return full(), SMALL


@case
def linear_with_gradients():
    return full(), dict(SMALL, GenerateGradients=True)


@case
def natural():
    return full(), dict(SMALL, Method=1, GenerateGradients=True)


@case
def laplace():
    return full(), dict(SMALL, Method=2)


@case
def nearest():
    return full(), dict(SMALL, Method=3, UseBounds=True, Bounds=(-100.0, 1100.0, 0.0, 500.0))


@case
def floats():
    return full(150, core.VTK_FLOAT), dict(SMALL, OutputType=1)


@case
def cells_of_a_size():
    return full(), {"RasterSize": 1, "CellSize": (90.0, 110.5)}


@case
def cells_on_multiples():
    return full(), {"RasterSize": 1, "CellSize": (90.0, 110.5), "AlignToCellSize": True}


@case
def tenths():
    return cloud(square()), {"RasterSize": 1, "CellSize": (0.1, 0.3), "UseBounds": True, "Bounds": (0.0, 1.1, 0.0, 3.3)}


@case
def beyond_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(-500.0, 700.0, -300.0, 2000.0), NoValue=-9999.0)


@case
def filled_beyond_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(-500.0, 700.0, -300.0, 2000.0), Outside=1, OutputType=1)


@case
def nowhere_on_the_surface():
    return full(), dict(SMALL, UseBounds=True, Bounds=(2000.0, 3000.0, 0.0, 1.0))


@case
def values_that_are_nan():
    return holey(), dict(SMALL, OutputType=1)


@case
def neighbors_that_are_nan():
    return holey(), dict(SMALL, Method=1)


@case
def nearest_that_are_nan():
    return holey(), dict(SMALL, Method=3, NoValue=-1.0)


@case
def places():
    return full(), {"PlacesData": wanted_places()}


@case
def places_by_neighbors():
    return full(), {"PlacesData": wanted_places(), "Method": 1, "Outside": 1}


@case
def places_none_of_which_is_on_the_surface():
    return full(), {"PlacesData": cloud([(5000, 1, 0), (6000, 2, 0)])}


@case
def no_places():
    return full(), {"PlacesData": cloud([])}


@case
def places_of_an_image():
    return full(), {"PlacesData": image()}


@case
def places_of_blocks():
    nothing = model.vtkMultiBlockDataSet()
    nothing.SetNumberOfBlocks(1)
    return full(), {"InputDataObject": (1, blocks(wanted_places(), nothing, image(), model.vtkTable()))}


@case
def places_of_no_block():
    return full(), {"InputDataObject": (1, model.vtkMultiBlockDataSet())}


@case
def constraints():
    return full(), dict(SMALL, SourceData=lines_and_loops(), **{
        "Triangulation.SourceMode": 1, "Triangulation.FillRule": 1, "Triangulation.CrossingMode": 1})


@case
def heights_from_the_surface():
    return full(), dict(SMALL, Method=1, SourceData=lines_and_loops(), **{
        "Triangulation.SourceMode": 1, "Triangulation.SourceHeights": 1})


@case
def triangles_that_are_left_out():
    return full(), dict(SMALL, **{"Triangulation.Alpha": 70.0, "Triangulation.MaximumEdgeLength": 130.0})


@case
def means():
    return full(), dict(SMALL, **{"Triangulation.DuplicatePolicy": 3, "Triangulation.Tolerance": 0.01})


@case
def means_and_crossings():
    return full(), dict(SMALL, SourceData=lines_and_loops(), **{
        "Triangulation.DuplicatePolicy": 3, "Triangulation.SourceMode": 1, "Triangulation.CrossingMode": 1,
        "Triangulation.ClosedLines": 1, "Triangulation.FillRule": 1})


@case
def bounding():
    return full(), dict(SMALL, **{"Triangulation.BoundingTriangulation": 1})


def turned():
    made = vtk("vtkCommonTransforms").vtkTransform()
    made.RotateX(30.0)
    made.RotateY(-20.0)
    return made


@case
def another_plane():
    return full(), dict(SMALL, **{"Triangulation.ProjectionPlaneMode": 1, "Triangulation.Transform": turned()})


@case
def places_in_another_plane():
    return full(), {"PlacesData": full(), "Triangulation.ProjectionPlaneMode": 1, "Triangulation.Transform": turned()}


@case
def the_best_plane():
    return full(), dict(SMALL, OutputType=1, **{"Triangulation.ProjectionPlaneMode": 2})


@case
def no_transform():
    return full(), dict(SMALL, **{"Triangulation.ProjectionPlaneMode": 1})


@case
def merged_blocks():
    return blocks(full(80), cloud(scattered(60)), image()), SMALL


@case
def names():
    return full(), dict(SMALL, HeightArrayName="Kind", ValidPointMaskArrayName="", GenerateGradients=True)


@case
def no_name_for_heights():
    return full(), dict(SMALL, HeightArrayName="", GenerateGradients=True)


@case
def no_points():
    return model.vtkPolyData(), SMALL


@case
def no_points_but_places():
    return cloud([]), {"PlacesData": wanted_places(), "Outside": 1}


@case
def one_point():
    return cloud([(1, 2, 3)]), {"PlacesData": cloud([(1, 2, 0), (1, 3, 0)])}


@case
def one_point_and_a_raster():
    return cloud([(1, 2, 3)]), SMALL


@case
def collinear():
    return cloud([(i, 2 * i, i % 3) for i in range(30)]), {"PlacesData": cloud([(2.5, 5, 0), (3, 5, 0)])}


@case
def not_finite():
    return cloud(square((NAN, 1, 0), (5, 5, NAN), (3, 3, math.inf))), SMALL


@case
def cells_of_no_size():
    return full(), {"RasterSize": 1, "CellSize": (1.0, 0.0)}


@case
def too_many_cells():
    return full(), {"RasterSize": 1, "CellSize": (1e-9, 1.0)}


@case
def more_cells_than_memory():
    return full(), {"RasterSize": 1, "CellSize": (1e-4, 1e-4)}


@case
def cells_too_fine():
    return cloud([(x + 1e15, y, 0) for x, y, _ in square()]), {"RasterSize": 1, "CellSize": (0.01, 1.0)}


@case
def bounds_that_are_none():
    return full(), {"UseBounds": True, "Bounds": (1.0, 1.0, 0.0, 2.0)}


@case
def a_memory_limit():
    return full(), {"Triangulation.MemoryLimit": 16}


@case
def no_triangulation():
    return full(), {"Triangulation": None}


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


def silent():
    """What it says is not printed."""
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

    def test_aborted(self):
        """The output is empty, and nothing is said."""
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
        self.assertLessEqual(told[-1], 1.0)

    def test_the_name_of_the_class(self):
        algorithm = Interpolation()
        self.assertEqual(algorithm.GetClassName(), "vtkAdaptiveHilbertInterpolation2D")
        self.assertEqual((algorithm.IsA("vtkDataSetAlgorithm"), algorithm.IsA("vtkAlgorithm")), (1, 1))
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


if __name__ == "__main__":
    run_tests()
