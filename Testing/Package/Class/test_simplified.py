# SPDX-License-Identifier: BSD-3-Clause
"""A simplified surface: which points it has and what they carry, errors, arrays of numbers; nothing of them is kept."""

import math

from classtests import (Case, Filter, Said, array, model, run, run_tests, source, tested_class, triangles,
                        values_of, vtk)
from simplifiedcases import hills

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
BOUND = 2.0


def with_numbers(name, numbers, points=None):
    points = points or hills()
    points.GetPointData().AddArray(array("vtkDoubleArray", name, numbers))
    return points


def places_of(surface):
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]


def column(surface, name):
    return values_of(surface.GetPointData().GetArray(name))


class KeptPointsTest(Case):
    def surfaces(self, points, **settings):
        """With the points of the triangles, and with all; the ids of the former."""
        light, said = run(points, MaximumError=BOUND, **settings)
        self.assertSaid(said)
        whole, _ = run(points, MaximumError=BOUND, KeptPointsOnly=False, **settings)
        return light, whole, [int(i) for i in column(light.GetOutput(), "OriginalPointIds")]

    def check(self, light, whole, ids):
        """The triangles, the points and their data are those of all points."""
        given, made = whole.GetOutput(), light.GetOutput()
        self.assertEqual([tuple(ids[k] for k in corners) for corners in triangles(made)], triangles(given))
        self.assertEqual(sorted(ids), ids)
        self.assertEqual(set(ids), {k for corners in triangles(given) for k in corners})
        self.assertEqual(places_of(made), [given.GetPoint(i) for i in ids])
        for name in ("Number", "Flow"):
            data, width = column(given, name), given.GetPointData().GetArray(name).GetNumberOfComponents()
            self.assertEqual(column(made, name), [data[width * i + k] for i in ids for k in range(width)])
        self.assertEqual([made.GetPointData().GetAbstractArray("Word").GetValue(k) for k in range(len(ids))],
                         ["w%d" % i if i < 600 else "" for i in ids])
        self.assertEqual(made.GetPointData().GetScalars().GetName(), "Number")

    def points(self):
        points = with_numbers("Flow", [])
        data = points.GetPointData()
        data.RemoveArray("Flow")
        data.SetScalars(array("vtkIntArray", "Number", range(600)))
        data.AddArray(array("vtkFloatArray", "Flow", [0.5 * i for i in range(1200)], 2))
        data.AddArray(array("vtkStringArray", "Word", ["w%d" % i for i in range(600)]))
        data.AddArray(array("vtkIntArray", "Short", range(7)))
        return points

    def test_those_of_the_triangles(self):
        light, whole, ids = self.surfaces(self.points())
        self.check(light, whole, ids)
        self.assertLess(len(ids), 200)
        self.assertFalse(light.GetOutput().GetPointData().HasArray("Short"))
        self.assertFalse(whole.GetOutput().GetPointData().HasArray("OriginalPointIds"))
        self.assertEqual(whole.GetOutput().GetNumberOfPoints(), 600)

    def test_other_outputs_refer_to_all(self):
        lines = source([(100, 100, 0), (900, 800, 0), (100, 700, 0), (900, 200, 0)], lines=[(0, 1), (2, 3)])
        asked = dict(SourceData=lines, SourceMode=1, SourceHeights=1, CrossingMode=1, GenerateVoronoi=True,
                     GenerateNeighbors=True, GenerateInsertionCurve=True)
        light, whole, ids = self.surfaces(self.points(), **asked)
        self.check(light, whole, ids)
        self.assertGreater(max(ids), 600)
        for port in (1, 2):
            data = "GetCellData" if port == 2 else "GetPointData"
            some, others = (getattr(of.GetOutput(port), data)() for of in (light, whole))
            self.assertEqual(*(values_of(of.GetArray("OriginalPointIds")) for of in (some, others)))
        self.assertEqual(values_of(light.GetOutput(2).GetCellData().GetArray("Number")),
                         values_of(whole.GetOutput(2).GetCellData().GetArray("Number")))

    def test_status_and_errors_are_about_all_points(self):
        for asked in ({"GeneratePointStatus": True}, {"GenerateErrors": True}):
            light, whole, = run(hills(), MaximumError=BOUND, **asked)[0], run(hills(), **asked)[0]
            self.assertEqual(light.GetOutput().GetNumberOfPoints(), whole.GetOutput().GetNumberOfPoints())

    def interpolated(self, surface, plane):
        algorithm = Interpolation()
        said = Said(algorithm)
        algorithm.SetDimensions(20, 20)
        algorithm.SetInputData(surface)
        algorithm.GetTriangulation().SetProjectionPlaneMode(plane)
        algorithm.Update()
        self.assertSaid(said)
        return values_of(algorithm.GetOutput().GetPointData().GetArray("Elevation"))

    def test_interpolation_takes_it(self):
        lines = source([(500, 500, 9), (100, 100, 0), (900, 800, 0)], lines=[(1, 2)])
        light, whole, _ = self.surfaces(hills(), SourceData=lines, SourceMode=1)
        found = (self.interpolated(of.GetOutput(), 0) for of in (light, whole))
        valued = [(a, b) for a, b in zip(*found) if a == a and b == b]
        self.assertGreater(len(valued), 300)
        self.assertLess(max(abs(a - b) for a, b in valued), 1e-9)

    def test_a_raster_around_points_that_are_moved_or_added(self):
        """Where it lies is found before there is a surface."""
        turned = vtk("vtkCommonTransforms").vtkTransform()
        turned.RotateX(10)
        for settings in ({"ProjectionPlaneMode": 2}, {"Transform": turned, "ProjectionPlaneMode": 1},
                         {"BoundingTriangulation": 1}):
            rasters = []
            for simplifying in ({"MaximumError": BOUND}, {"MaximumNumberOfVertices": 50}, {}):
                made = Interpolation()
                said = Said(made)
                for name, value in dict(settings, **simplifying).items():
                    getattr(made.GetTriangulation(), "Set" + name)(value)
                made.SetInputData(hills())
                made.Update()
                self.assertSaid(said)
                rasters.append((made.GetOutput().GetOrigin(), made.GetOutput().GetSpacing()))
            self.assertEqual(rasters, [rasters[-1]] * 3, settings)

    def test_its_plane_is_that_of_points_of_the_input(self):
        """Not of added points, of which it has some: as if all that were added were still there."""
        more = hills(900)
        points = [more.GetPoint(i) for i in range(600, 900)] + [(200, 500, 80), (700, 500, 80)]
        lines = source(points, lines=[(300, 301)])
        light, _, ids = self.surfaces(hills(), SourceData=lines, SourceMode=1, ProjectionPlaneMode=2)
        found = self.interpolated(light.GetOutput(), 2)
        plain = model.vtkPolyData()
        plain.ShallowCopy(light.GetOutput())
        plain.GetPointData().RemoveArray("OriginalPointIds")
        for added in (sum(i >= 600 for i in ids), 302):
            self.assertEqual(len(ids) > added, added < 302)
            plain.GetFieldData().AddArray(array("vtkIdTypeArray", "NumberOfAddedPoints", [added]))
            self.assertEqual(str(self.interpolated(plain, 2)) == str(found), added < 302)

    def test_nothing_is_kept(self):
        """Of another input with the same points the data are its own."""
        light, _, ids = self.surfaces(self.points())
        given = light.GetInput()
        for start in (0, 5, 9, 14):
            given.GetPointData().SetScalars(array("vtkIntArray", "Number", range(start, start + 600)))
            given.Modified()
            light.Update()
            self.assertEqual(column(light.GetOutput(), "Number"), [start + i for i in ids])


class NumbersTest(Case):
    def test_errors(self):
        """Largest Error is the largest; 0 for vertices, NaN for what is not there."""
        points = with_numbers("Heat", [math.sin(i) for i in range(600)])
        marks = array("vtkUnsignedCharArray", "vtkGhostType", [int(i == 7) for i in range(600)])
        points.GetPointData().AddArray(marks)
        made, said = run(points, MaximumError=BOUND, GenerateErrors=True, GeneratePointStatus=True)
        self.assertSaid(said)
        errors, status = (column(made.GetOutput(), name) for name in ("Error", "Fate"))
        self.assertEqual([i for i, error in enumerate(errors) if error != error], [7])
        self.assertEqual(max(error for error, of in zip(errors, status) if of == -3), made.GetLargestError())
        self.assertTrue(all(error == 0.0 for i, error in enumerate(errors) if status[i] == i))
        self.assertTrue(all(errors[i] == abs(points.GetPoint(i)[2] - points.GetPoint(int(of))[2])
                            for i, of in enumerate(status) if of >= 0))

    def test_values_are_as_heights(self):
        heights = hills()
        flat = with_numbers("Height", [heights.GetPoint(i)[2] for i in range(600)])
        for i in range(600):
            flat.GetPoints().SetPoint(i, *heights.GetPoint(i)[:2], float(i % 5))
        expected, _ = run(heights, MaximumError=BOUND)
        for name in ("Height", "None"):
            made, said = run(flat, MaximumError=BOUND, ValueArrayName=name)
            self.assertSaid(said)
            self.assertEqual(triangles(made.GetOutput()) == triangles(expected.GetOutput()), name == "Height")
        self.assertLess(expected.GetLargestError(), made.GetLargestError() + BOUND)

    def test_weights_and_points_that_stay(self):
        points = with_numbers("Weight", [0.0 if i % 2 else 3.0 for i in range(600)])
        with_numbers("Keep", [float(i % 50 == 1) for i in range(600)], points)
        made, said = run(points, MaximumError=BOUND, WeightArrayName="Weight", KeepArrayName="Keep",
                         GenerateErrors=True, GeneratePointStatus=True)
        self.assertSaid(said)
        errors, status = (column(made.GetOutput(), name) for name in ("Error", "Fate"))
        left = [i for i in range(600) if status[i] == -3]
        self.assertTrue(all(3.0 * errors[i] <= BOUND * (1 + 1e-12) for i in left if i % 2 == 0))
        self.assertGreater(max(errors[i] for i in left if i % 2), BOUND)
        self.assertTrue(all(status[i] >= 0 for i in range(1, 600, 50)))

    def test_a_change_of_the_array_is_noticed(self):
        """By the surface, and by an interpolation on one; also where the array was not there before."""
        points = hills()
        surface = Filter()
        raster = Interpolation()
        surface.SetGenerateErrors(True)
        for made in (surface, raster.GetTriangulation()):
            made.SetValueArrayName("Heat")
            made.SetMaximumError(5.0)
        raster.SetDimensions(30, 30)
        found = []
        for made in (surface, raster):
            said = Said(made)
            made.SetInputData(points)
            made.Update()
            self.assertEqual(len(said.warnings), 1)
            self.assertIn("are not used: Heat", said.warnings[0])
        for amount in (1.0, 1.0, 10.0, 1.0):
            points.GetPointData().RemoveArray("Heat")
            with_numbers("Heat", [amount * math.sin(i / 90) for i in range(600)], points)
            points.Modified()
            for made in (surface, raster):
                made.Update()
            found.append((surface.GetLargestError(), column(surface.GetOutput(), "Error"),
                          values_of(raster.GetOutput().GetPointData().GetArray("Elevation"))))
        self.assertEqual(str(found[0]), str(found[1]))
        self.assertEqual(str(found[0]), str(found[3]))
        for k in range(3):
            self.assertNotEqual(str(found[0][k]), str(found[2][k]))


if __name__ == "__main__":
    run_tests()
