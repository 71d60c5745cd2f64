# SPDX-License-Identifier: BSD-3-Clause
"""Planes by transforms of every kind: points made in the plane are moved back into space, where the transform has an
inverse; triangles and cells are those of points transformed before.
"""

from classtests import Case, Filter, Said, cloud, core, ids_of, run_tests, triangles, vtk
from numbered import Random

transforms = vtk("vtkCommonTransforms")


def places(count, seed):
    random = Random(seed)
    return [(random.unit(), random.unit(), 0.1 * random.unit()) for _ in range(count)]


def rigid():
    made = transforms.vtkTransform()
    made.RotateX(25)
    made.Translate(1, -2, 3)
    return made


def perspective():
    made = transforms.vtkPerspectiveTransform()
    made.SetMatrix([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1])
    return made


def spline():
    """Bends the plane a little."""
    made = transforms.vtkThinPlateSplineTransform()
    ends = core.vtkPoints(), core.vtkPoints()
    for x in (-1, 0, 1, 2):
        for y in (-1, 0, 1, 2):
            for z in (-1, 1):
                ends[0].InsertNextPoint(x, y, z)
                ends[1].InsertNextPoint(x + 0.03 * y * y, y - 0.02 * x, z + 0.1 * x)
    made.SetSourceLandmarks(ends[0])
    made.SetTargetLandmarks(ends[1])
    made.SetBasisToR()
    made.SetInverseTolerance(1e-9)
    made.SetInverseIterations(5000)
    return made


def general():
    made = transforms.vtkGeneralTransform()
    made.Concatenate(rigid())
    made.Concatenate(spline())
    return made


def flattening():
    """Has no inverse."""
    made = transforms.vtkTransform()
    made.Scale(1, 1, 0)
    return made


KINDS = (rigid, perspective, spline, general)


class TransformsTest(Case):
    def made(self, points, transform=None):
        algorithm = Filter()
        said = Said(algorithm)
        algorithm.SetInputDataObject(cloud(points))
        algorithm.GenerateVoronoiOn()
        algorithm.SetRimToConvexHull()
        if transform is not None:
            algorithm.SetProjectionPlaneMode(1)
            algorithm.SetTransform(transform)
        algorithm.Update()
        return algorithm, said

    def test_voronoi_corners_come_back(self):
        points = places(60, 3)
        for kind in KINDS:
            transform = kind()
            algorithm, said = self.made(points, transform)
            self.assertSaid(said)
            flat, _ = self.made([transform.TransformPoint(point) for point in points])
            self.assertEqual(triangles(algorithm.GetOutput()), triangles(flat.GetOutput()), kind)
            found, expected = algorithm.GetOutput(2), flat.GetOutput(2)
            self.assertEqual(ids_of(found.GetPolys()), ids_of(expected.GetPolys()), kind)
            self.assertGreater(found.GetNumberOfPoints(), 50)
            for i in range(found.GetNumberOfPoints()):
                there = transform.TransformPoint(found.GetPoint(i))
                for a, b in zip(there[:2], expected.GetPoint(i)[:2]):
                    self.assertAlmostEqual(a, b, delta=2e-4, msg=kind)

    def test_a_plane_without_a_way_back(self):
        points = places(60, 3)
        algorithm, said = self.made(points, flattening())
        flat, _ = self.made([(x, y, 0.0) for x, y, _ in points])
        self.assertEqual(triangles(algorithm.GetOutput()), triangles(flat.GetOutput()))
        self.assertEqual(len(said.errors), 0)
        found, expected = algorithm.GetOutput(2), flat.GetOutput(2)
        if found.GetNumberOfPoints():  # they stay in the plane
            self.assertEqual([found.GetPoint(i) for i in range(found.GetNumberOfPoints())],
                             [expected.GetPoint(i) for i in range(expected.GetNumberOfPoints())])
        self.assertEqual(len(said.warnings), 1)

    def test_a_transform_that_changes_is_noticed(self):
        points = places(30, 4)
        transform = rigid()
        algorithm, _ = self.made(points, transform)
        before, times = triangles(algorithm.GetOutput()), algorithm.GetMTime()
        transform.RotateY(70)
        self.assertGreater(algorithm.GetMTime(), times)
        algorithm.Update()
        fresh, _ = self.made(points, transform)
        self.assertEqual(triangles(algorithm.GetOutput()), triangles(fresh.GetOutput()))
        self.assertNotEqual(triangles(algorithm.GetOutput()), before)
        algorithm.SetTransform(None)
        self.assertIsNone(algorithm.GetTransform())
        times = algorithm.GetMTime()
        transform.RotateY(10)
        self.assertEqual(algorithm.GetMTime(), times)


if __name__ == "__main__":
    run_tests()
