# SPDX-License-Identifier: BSD-3-Clause
"""Requests between upstream and downstream filters: pieces, changes elsewhere, damaged cells."""

import unittest

from classtests import (IN_PYTHON, Case, Filter, Said, blocks, cells_of, cloud, core, model, run_tests, source,
                        tested_class, triangles, vtk)
from test_kept import contents, scattered, silent

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
execution = vtk("vtkCommonExecutionModel")
transforms = vtk("vtkCommonTransforms")


def behind(algorithm):
    """A filter of VTK's in C++."""
    made = vtk("vtkFiltersCore").vtkAppendFilter()
    made.SetInputConnection(algorithm.GetOutputPort())
    return made


def sliced_points(count=600):
    """A class of sources of which each piece has the points of its part along x, with lines and a polygon."""
    base, pipeline = vtk("util.vtkAlgorithm").VTKPythonAlgorithmBase, execution.vtkStreamingDemandDrivenPipeline

    class Sliced(base):
        runs = 0

        def __init__(self):
            base.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

        def RequestInformation(self, _request, _inputs, outputs):
            outputs.GetInformationObject(0).Set(execution.vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
            return 1

        def RequestData(self, _request, _inputs, outputs):
            info = outputs.GetInformationObject(0)
            number, of_all = (info.Get(key()) for key in (
                pipeline.UPDATE_PIECE_NUMBER, pipeline.UPDATE_NUMBER_OF_PIECES))
            own = [point for point in scattered(count) if int(point[0] * of_all / 10**6) == number]
            self.runs += 1
            made = cloud(own)
            made.SetLines(cells_of([(0, 1)]))
            model.vtkPolyData.GetData(outputs, 0).ShallowCopy(made)
            return 1

    return Sliced()


class PiecesTest(Case):
    """In one process the output is made of all points, whatever the requested piece."""

    def test_each_piece_of_a_raster_is_of_all_points(self):
        points, lines = sliced_points(), sliced_points()
        for given in (None, lines):
            algorithm = silent(Interpolation())
            algorithm.SetInputConnection(points.GetOutputPort())
            algorithm.GetTriangulation().SetSourceMode(1)
            if given is not None:
                algorithm.SetSourceConnection(given.GetOutputPort())
            algorithm.SetDimensions(12, 8)
            algorithm.Update()
            whole = contents(algorithm.GetOutput())
            for of_all in (2, 3, 1):
                for number in range(of_all):
                    algorithm.Modified()
                    algorithm.UpdatePiece(number, of_all, 0)
                    self.assertTrue(contents(algorithm.GetOutput()) == whole, (number, of_all))

    def test_the_raster_is_announced_by_all_points(self):
        points, algorithm = sliced_points(), silent(Interpolation())
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.SetRasterSizeToByCellSize()
        algorithm.SetCellSize(5e4, 5e4)
        points.UpdatePiece(1, 4, 0)
        algorithm.UpdateInformation()
        extent = algorithm.GetOutputInformation(0).Get(execution.vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
        self.assertEqual(extent[1], 19)

    def test_of_places_the_piece_that_is_wanted(self):
        points, places, algorithm = sliced_points(), sliced_points(), silent(Interpolation())
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.SetPlacesConnection(places.GetOutputPort())
        count = 0
        for number in range(3):
            algorithm.UpdatePiece(number, 3, 0)
            made = algorithm.GetOutput()
            count += made.GetNumberOfPoints()
            for i in range(made.GetNumberOfPoints()):
                self.assertEqual(made.GetPointData().GetArray("Elevation").GetValue(i), made.GetPoint(i)[2])
        self.assertEqual(count, 600)

    def test_the_first_piece_is_the_whole_triangulation(self):
        points, algorithm = sliced_points(), silent(Filter())
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.GenerateVoronoiOn()
        algorithm.GeneratePointStatusOn()
        algorithm.Update()
        whole = triangles(algorithm.GetOutput())
        for number in (1, 0, 2, 0):
            algorithm.UpdatePiece(number, 3, 1)
            self.assertTrue(triangles(algorithm.GetOutput()) == (whole if number == 0 else []), number)
            marks = algorithm.GetOutput().GetPointData().GetAbstractArray(0)  # there are in all pieces
            self.assertEqual(marks.GetNumberOfTuples(), 0 if number else 600)
            self.assertEqual(algorithm.GetOutput(2).GetNumberOfCells(), 600)  # of that the first is requested
        self.assertEqual(points.runs, 1)

    def test_other_pieces_take_no_triangulation(self):
        points, algorithm = sliced_points(), silent(Filter())
        algorithm.SetInputConnection(points.GetOutputPort())
        for number in range(2):
            algorithm.UpdatePiece(number, 2, 0)
            self.assertEqual((algorithm.GetNumberOfTriangulations(), algorithm.GetNumberOfPointsInserted()), (1, 600))
        self.assertEqual(points.runs, 1)

    @unittest.skipUnless(IN_PYTHON, "the compiled class takes controllers of VTK's only")
    def test_several_ranks_have_pieces_of_their_own(self):
        class Ranks:
            def GetNumberOfProcesses(self):
                return 2

        points, algorithm = sliced_points(), silent(Filter())
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.SetController(Ranks())
        numbers = []
        for number in range(2):
            algorithm.UpdatePiece(number, 2, 0)
            numbers.append(algorithm.GetOutput().GetNumberOfPoints())
        self.assertEqual(sum(numbers), 600)
        self.assertTrue(all(numbers))


class FollowersTest(Case):
    """Changes of a transform and of the settings of a triangulation are noticed by any update."""

    ROUTES = {
        "its own update": lambda algorithm, after: algorithm.Update(),
        "all of it": lambda algorithm, after: algorithm.UpdateWholeExtent(),
        "a piece": lambda algorithm, after: algorithm.UpdatePiece(0, 1, 0),
        "its executive": lambda algorithm, after: algorithm.GetExecutive().Update(),
        "a filter behind": lambda algorithm, after: after.Update(),
    }

    def assertNoticed(self, algorithm, changes, result):
        after = behind(algorithm)
        after.Update()
        for route, update in self.ROUTES.items():
            for change in changes:
                before = result()
                after.Update()
                self.assertTrue(result() == before, route)
                change()
                update(algorithm, after)
                self.assertFalse(result() == before, route)

    def test_settings_of_a_triangulation(self):
        algorithm, other = silent(Interpolation()), Filter()
        algorithm.SetInputData(cloud(scattered()))
        algorithm.SetDimensions(8, 8)
        for settings in (algorithm.GetTriangulation(), other):
            algorithm.SetTriangulation(settings)
            self.assertNoticed(algorithm, (lambda: settings.SetMaximumEdgeLength(1e-6),
                                           lambda: settings.SetMaximumEdgeLength(0.0)),
                               lambda: contents(algorithm.GetOutput()))

    def turned(self):
        """A transform, and one that it is made of: changes of the latter are not signalled."""
        inner, outer = transforms.vtkTransform(), transforms.vtkTransform()
        outer.SetInput(inner)
        return inner, outer

    def test_transform(self):
        inner, outer = self.turned()
        algorithm = silent(Filter())
        algorithm.SetInputData(cloud([(0, 0, 0), (1, 0, 0), (0, 1, 1), (1, 1, 1.5), (0.5, 0.5, 0.5)]))
        algorithm.SetProjectionPlaneMode(1)
        algorithm.SetTransform(outer)
        self.assertNoticed(algorithm, (lambda: inner.RotateX(80), lambda: inner.Identity(), lambda: outer.RotateX(80),
                                       lambda: outer.RotateX(-80)),
                           algorithm.GetNumberOfTriangulations)

    def test_transform_of_a_triangulation(self):
        inner, outer = self.turned()
        algorithm = silent(Interpolation())
        algorithm.SetInputData(cloud(scattered()))
        algorithm.SetDimensions(8, 8)
        algorithm.GetTriangulation().SetProjectionPlaneMode(1)
        algorithm.GetTriangulation().SetTransform(outer)
        self.assertNoticed(algorithm, (lambda: inner.Scale(2, 1, 1), lambda: outer.Scale(0.5, 1, 1)),
                           lambda: contents(algorithm.GetOutput()))

    def test_a_transform_that_is_no_longer_its_own_is_not(self):
        first, second, algorithm = transforms.vtkTransform(), transforms.vtkTransform(), silent(Filter())
        algorithm.SetInputData(cloud(scattered()))
        for transform in (first, second, None):
            algorithm.SetTransform(transform)
        algorithm.Update()
        for transform in (first, second):
            transform.Translate(1, 2, 3)
            algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)

    def test_nothing_is_left_at_a_transform(self):
        transform = transforms.vtkTransform()
        for make in (Filter, lambda: Interpolation().GetTriangulation()):
            made = [make() for _ in range(3)]
            for algorithm in made:
                algorithm.SetTransform(transform)
        self.assertFalse(transform.HasObserver("ModifiedEvent"))

    def test_ports(self):
        for make, inputs in ((Filter, 2), (Interpolation, 3)):
            self.assertEqual(make().GetNumberOfInputPorts(), inputs)
            self.assertEqual(make().GetNumberOfOutputPorts(), 3 if make is Filter else 1)
            algorithm = make()
            algorithm.SetInputData(cloud(scattered()))
            (algorithm if make is Filter else algorithm.GetTriangulation()).SetTransform(transforms.vtkTransform())
            self.assertEqual(algorithm.GetTotalNumberOfInputConnections(), 1)


LIES = {
    (0, 2, 200000000): "number 1 among them are 2 and 200000000", (0, 2, 5): "number 1 among them are 2 and 5",
    (0, 3, 1): "number 1 among them are 3 and 1", (0, -5, 4): "number 0 among them are 0 and -5",
    (-1, 2, 4): "number 0 among them are -1 and 2", (7, 7, 4): "number 0 among them are 7 and 7"}


class BadCellsTest(Case):
    """Invalid offsets of cells are one error, which says where."""

    SQUARE = [(0, 0, 1), (4, 0, 2), (4, 4, 3), (0, 4, 4)]

    def cells(self, offsets, kind):
        made, parts = model.vtkCellArray(), []
        for numbers in (offsets, range(4)):
            part = getattr(core, kind)()
            for number in numbers:
                part.InsertNextValue(number)
            parts.append(part)
        made.SetData(*parts)
        return made

    def assertDamaged(self, algorithm, said, part, what):
        algorithm.Update()
        self.assertEqual(said.errors, ["The %s of %s are damaged: the offsets of %s, but offsets must ascend from 0 to "
                                       "the number of point ids, 4. Nothing was computed." % (*what, part)])
        self.assertEqual((algorithm.GetOutputDataObject(0).GetNumberOfPoints(), said.pipeline), (0, []))
        if algorithm.IsA("vtkAdaptiveHilbertInterpolation2D"):
            self.assertEqual(algorithm.GetNumberOfTriangulations(), 0)

    def test_lines_and_polygons(self):
        good = cloud(self.SQUARE)
        for offsets, part in LIES.items():
            for kind in ("vtkTypeInt64Array", "vtkTypeInt32Array"):
                for what, port, in_blocks in (("lines", "Lines", False), ("polygons", "Polys", False),
                                              ("lines", "Lines", True), ("polygons", "Polys", True)):
                    bad = cloud(self.SQUARE)
                    getattr(bad, "Set" + port)(self.cells(offsets, kind))
                    given = blocks(source(self.SQUARE, lines=[(0, 1)]), bad) if in_blocks else bad
                    whose = "a block of the source" if in_blocks else "the source"
                    for make, *others in ((Filter, given), (Interpolation, None, given), (Interpolation, good, given)):
                        algorithm = make()
                        said = Said(algorithm)
                        for port, data in enumerate((good, *others)):
                            algorithm.SetInputDataObject(port, data)
                        self.assertDamaged(algorithm, said, part, (what, whose))

    def test_good_cells_after_bad_ones(self):
        bad, algorithm = cloud(self.SQUARE), silent(Filter())
        bad.SetLines(self.cells((0, 3, 1), "vtkTypeInt64Array"))
        algorithm.SetInputData(cloud(self.SQUARE))
        algorithm.SetSourceData(bad)
        algorithm.Update()
        algorithm.SetSourceData(source(self.SQUARE, lines=[(0, 2)]))
        algorithm.Update()
        self.assertEqual((algorithm.GetNumberOfTriangles(), algorithm.GetNumberOfConstraintEdges()), (2, 1))

    def test_cells_that_begin_late_keep_their_ids_in_blocks(self):
        """Ids before the first and after the last cell belong to no cell."""
        late, other = cloud(self.SQUARE), source(self.SQUARE, lines=[(0, 1)], verts=[(0,), (1,)])
        late.SetLines(self.cells((1, 3), "vtkTypeInt32Array"))
        algorithm = silent(Filter())
        algorithm.SetInputData(cloud(self.SQUARE))
        algorithm.SetInputDataObject(1, blocks(late, other))
        algorithm.Update()
        self.assertEqual((algorithm.GetNumberOfConstraintEdges(), algorithm.GetNumberOfConstraintsLeftOut()), (2, 0))


if __name__ == "__main__":
    run_tests()
