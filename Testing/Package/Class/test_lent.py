# SPDX-License-Identifier: BSD-3-Clause
"""Interpolation on the triangulation that a surface was written from: as long as that exists, and nothing has changed;
else on its own triangles, with the same values. For the values see the cases behind_... of test_interpolation.py."""

import gc
import threading
import unittest
import weakref

from classtests import (TABLE, Case, Said, array, blocks, cloud, core, model, run_tests, source, tested_class,
                        values_of)
from rastercases import copy_of, maker_of
from test_kept import scattered

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
COUNT = 1500


def interpolation(surface):
    algorithm = Interpolation()
    algorithm.said = Said(algorithm)
    algorithm.SetDimensions(40, 30)
    algorithm.SetMethod(1)
    algorithm.SetInputData(surface)
    return algorithm


def shallow(data):
    made = model.vtkPolyData()
    made.ShallowCopy(data)
    return made


def watched(data, gone):
    """The same, which tells when it is deleted: objects of Python refer to it without its knowing."""
    data.AddObserver("DeleteEvent", lambda *_: gone.append(1))
    return data


class LentTest(Case):
    def setUp(self):
        self.given = cloud(scattered(COUNT))
        # a Delaunay edge: only the filter knows that it is a constraint
        self.maker = maker_of(self.given, source([], lines=[(700, 3)]))

    def assertTriangulates(self, algorithm, count):
        """Updated, this often; returns the values."""
        algorithm.Update()
        self.assertSaid(algorithm.said)
        self.assertEqual(algorithm.GetNumberOfTriangulations(), count)
        return values_of(algorithm.GetOutput().GetPointData().GetArray("Elevation"))

    def test_of_the_surface_and_its_shallow_copies(self):
        surface = self.maker.GetOutput()
        algorithm = interpolation(surface)
        found = self.assertTriangulates(algorithm, 0)
        self.assertEqual(str(self.assertTriangulates(interpolation(shallow(surface)), 0)), str(found))
        self.assertTriangulates(interpolation(copy_of(surface)), 1)
        algorithm.SetMethod(0)
        self.assertTriangulates(algorithm, 0)

    def test_gone_with_its_filter(self):
        surface = shallow(self.maker.GetOutput())
        algorithm = interpolation(surface)
        maker = weakref.ref(self.maker)
        del self.maker
        gc.collect()
        self.assertIsNone(maker())
        self.assertTriangulates(algorithm, 1)

    def test_too_large_for_the_limit(self):
        for limit, count in ((1000, 1), (2000, 0)):
            self.maker.SetReuseLimit(limit)
            self.maker.Update()
            self.assertTriangulates(interpolation(self.maker.GetOutput()), count)

    def test_as_large_as_the_library_says(self):
        """The limit is in KiB, and more than what is kept."""
        try:
            import numpy
            from adaptivehilbertdelaunay import _library as library
        except ImportError:
            raise unittest.SkipTest("there is no C library") from None
        job = library.Job()
        for maximum, lines in ((0.0, False), (0.0, True), (6e4, True)):
            job.set_array("points", numpy.array(scattered(COUNT), float))
            job.set_array("line_ids", numpy.array([[700, 3]]) if lines else None)
            job.set(maximum_edge_length=maximum)
            job.run()
            limit = job.count("kept_estimate") // 1024
            maker = maker_of(self.given, source([], lines=[(700, 3)]) if lines else None, MaximumEdgeLength=maximum)
            for more, count in ((0, 1), (1, 0)):
                maker.SetReuseLimit(limit + more)
                maker.Modified()
                maker.Update()
                self.assertTriangulates(interpolation(maker.GetOutput()), count)

    def test_of_the_last_execution(self):
        surface = shallow(self.maker.GetOutput())
        self.maker.SetMaximumEdgeLength(6e4)
        self.maker.Update()
        self.assertTriangulates(interpolation(surface), 1)
        self.assertTriangulates(interpolation(self.maker.GetOutput()), 0)

    def test_points_that_moved(self):
        """Without Modified(), and in the surface's own arrays."""
        surface = self.maker.GetOutput()
        x, y, z = self.given.GetPoint(700)
        self.given.GetPoints().SetPoint(700, x, y, z + 1.0)
        self.assertTriangulates(interpolation(surface), 1)
        means = maker_of(self.given, DuplicatePolicy=3)
        surface = means.GetOutput()
        self.given.GetPoints().SetPoint(700, x, y, z)
        self.assertTriangulates(interpolation(surface), 1)

    def test_corners_that_are_new(self):
        self.maker.GetOutput().GetPolys().GetConnectivityArray().Modified()
        self.assertTriangulates(interpolation(self.maker.GetOutput()), 1)

    def test_another_plane(self):
        algorithm = interpolation(self.maker.GetOutput())
        algorithm.GetTriangulation().SetProjectionPlaneMode(2)
        self.assertTriangulates(algorithm, 1)

    def test_lent_to_one_at_a_time(self):
        """An interpolation during another one makes its own, and both have values; then it is available again."""
        surface, counts = self.maker.GetOutput(), []
        outer = interpolation(surface)

        def during(caller, _event):
            if caller.GetProgress() > 0.3 and not counts:
                inner = interpolation(shallow(surface))
                inner.Update()
                counts.append((inner.GetNumberOfTriangulations(), inner.GetNumberOfValidPlaces()))

        outer.AddObserver("ProgressEvent", during)
        self.assertTriangulates(outer, 0)
        self.assertEqual(counts, [(1, outer.GetNumberOfValidPlaces())])
        self.assertTriangulates(interpolation(surface), 0)

    def test_the_filter_executes_while_it_is_lent(self):
        surface, runs = shallow(self.maker.GetOutput()), []
        expected = str(self.assertTriangulates(interpolation(surface), 0))
        outer = interpolation(surface)

        def during(caller, _event):
            if caller.GetProgress() > 0.3 and not runs:
                runs.append(1)
                self.maker.SetMaximumEdgeLength(6e4)
                self.maker.Update()

        outer.AddObserver("ProgressEvent", during)
        self.assertEqual(str(self.assertTriangulates(outer, 0)), expected)
        self.assertTriangulates(interpolation(surface), 1)
        self.assertTriangulates(interpolation(self.maker.GetOutput()), 0)

    def test_given_back_by_who_was_aborted(self):
        surface = self.maker.GetOutput()
        algorithm = interpolation(surface)
        tag = algorithm.AddObserver("ProgressEvent", lambda caller, _event: caller.SetAbortExecute(1))
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        algorithm.RemoveObserver(tag)
        algorithm.SetAbortExecute(0)
        algorithm.Modified()
        self.assertTriangulates(algorithm, 0)

    def test_observers_that_write_to_what_it_is_made_of(self):
        """During the interpolation: all was read before. While it is made: it is not lent."""
        expected = str(self.assertTriangulates(interpolation(self.maker.GetOutput()), 0))

        def overwrite(caller, _event):
            if caller.GetProgress() > 0:
                self.given.GetPoints().GetData().Fill(caller.GetProgress())

        algorithm = interpolation(self.maker.GetOutput())
        algorithm.AddObserver("ProgressEvent", overwrite)
        self.assertEqual(str(self.assertTriangulates(algorithm, 0)), expected)
        self.given = cloud(scattered(COUNT))
        self.maker.SetInputData(self.given)
        self.maker.AddObserver("ProgressEvent", overwrite)
        self.maker.Update()
        algorithm = interpolation(self.maker.GetOutput())
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)

    def test_observers_that_take_memory(self):
        """An error before it is read, at both filters; then all is as ever."""
        for takes in (lambda data: data.Resize(10), lambda data: data.Resize(10**6), lambda data: data.Initialize()):
            given = cloud(scattered(COUNT))
            maker = maker_of(given)
            for algorithm in (interpolation(maker.GetOutput()), maker):
                said = Said(algorithm)
                tag = algorithm.AddObserver("ProgressEvent", lambda caller, _event: (
                    caller.GetProgress() > 0 and takes(given.GetPoints().GetData())))
                algorithm.Modified()
                algorithm.Update()
                self.assertSaid(said, errors=1)
                self.assertIn("other memory or another size", said.errors[0])
                self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
                algorithm.RemoveObserver(tag)
                given = cloud(scattered(COUNT))
                maker.SetInputData(given)
            maker.Update()
            self.assertTriangulates(interpolation(maker.GetOutput()), 0)

    def test_no_input_of_before_is_held(self):
        gone = []
        for _ in range(3):  # the third passes on
            watched(self.given.GetPoints().GetData(), gone)
            points = core.vtkPoints()
            points.SetDataType(self.given.GetPoints().GetDataType())
            points.DeepCopy(self.given.GetPoints())
            self.given.SetPoints(points)
            self.maker.Update()
        self.assertEqual(len(gone), 3)

    def test_no_point_data_of_the_input_are_held(self):
        for given in (self.given, blocks(self.given)):
            self.given.GetPointData().AddArray(array("vtkDoubleArray", "Flow", range(COUNT)))
            maker = maker_of(given, MergeBlocks=True)
            gone = []
            watched(maker.GetOutput().GetPointData().GetArray("Flow"), gone)
            self.given.GetPointData().RemoveArray("Flow")
            maker.GetOutput().ReleaseData()
            self.assertEqual(len(gone), 1)

    def test_one_that_is_kept_by_an_interpolation_holds_no_data(self):
        """None but its own data; of the points and of a surface."""
        for given in (self.given, copy_of(self.maker.GetOutput())):
            data = given.GetPointData(), given.GetCellData()
            gone = []
            for part, count in zip(data, (COUNT, given.GetNumberOfCells())):
                part.AddArray(watched(array("vtkDoubleArray", "Own", range(count)), gone))
            algorithm = interpolation(given)
            for _ in range(2):
                algorithm.Modified()
                self.assertTriangulates(algorithm, 1)
            for part in data:
                part.RemoveArray("Own")
            algorithm.GetOutput().ReleaseData()
            self.assertEqual(len(gone), 2)

    def test_several_threads(self):
        """An interpolation that finds it lent makes its own, by the surface's constraint edges."""
        self.maker.GenerateConstraintEdgesOn()
        self.maker.Update()
        filters = [interpolation(shallow(self.maker.GetOutput())) for _ in range(3)]
        threads = [threading.Thread(target=one.Update) for one in filters]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        found = {str(values_of(one.GetOutput().GetPointData().GetArray("Elevation"))) for one in filters}
        self.assertEqual(len(found), 1)
        self.assertTriangulates(interpolation(self.maker.GetOutput()), 0)


class UsedUpTest(Case):
    """Settings of a triangulation that shape its surface do nothing where that was made before."""

    @staticmethod
    def others(row):
        """Other values than that which counts."""
        if row["values"]:
            return [value for value in range(len(row["values"])) if value != row["on_surface"]]
        if row["type"] in ("bool", "flag"):
            return [not row["on_surface"]]
        return [row["most"] or 20]

    def test_each(self):
        plain, shaping = cloud(scattered(200)), set()
        maker = maker_of(plain, source([], lines=[(70, 3)]))
        given = plain, copy_of(maker.GetOutput()), maker.GetOutput()
        for name, row in TABLE["delaunay"]["settings"].items():
            for value in self.others(row) if "on_surface" in row else ():
                for number, data in enumerate(given):
                    found = []
                    algorithm = interpolation(data)
                    algorithm.SetDimensions(24, 24)
                    algorithm.SetUseBounds(True)
                    algorithm.SetBounds(*plain.GetBounds()[:4])
                    for given_value in (row["on_surface"], value):
                        getattr(algorithm.GetTriangulation(), "Set" + name)(given_value)
                        algorithm.Update()
                        found.append(str(values_of(algorithm.GetOutput().GetPointData().GetArray("Elevation"))))
                    if number:
                        self.assertEqual(*found, (name, value))
                    elif found[0] != found[1]:
                        shaping.add(name)
        self.assertLessEqual({"Alpha", "MaximumEdgeLength", "Tolerance", "InsertionLimit", "Rim"}, shaping)


if __name__ == "__main__":
    run_tests()
