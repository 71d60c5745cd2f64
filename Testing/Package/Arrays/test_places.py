# SPDX-License-Identifier: BSD-3-Clause
"""Places, rasters and numbers accepted by interpolation, and those refused with one clear error."""

import pickle
import tracemalloc
import unittest
import unittest.mock
import warnings

import numpy as np
from adaptivehilbertdelaunay import (
    LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator, delaunay,
)  # fmt: skip
from adaptivehilbertdelaunay import _library as library
from arraysupport import SQUARE, cloud


class PlacesTest(unittest.TestCase):
    def test_changed_points_have_no_raster(self):
        points = cloud(1, 100)
        made = delaunay(points)
        made.locate(points[:2])
        points += 100
        with self.assertRaisesRegex(RuntimeError, "changed"):
            made.raster(cell_size=1)

    def test_masked_arrays(self):
        """Where nothing is masked they are ordinary arrays; else all doors refuse them."""
        points = cloud(1, 100)
        whole, masked = np.ma.array(points), np.ma.masked_less(points, 0.2)
        made, linear = delaunay(points), LinearInterpolator(points, points[:, 0])
        np.testing.assert_array_equal(linear(whole), linear(points))
        np.testing.assert_array_equal(linear(whole[:, 0], whole[:, 1]), linear(points))
        np.testing.assert_array_equal(LinearInterpolator(whole, whole[:, 0])(points), linear(points))
        np.testing.assert_array_equal(made.locate(whole).triangle, made.locate(points).triangle)
        for call in (
            lambda: linear(masked), lambda: linear(masked[:, 0], masked[:, 1]), lambda: made.locate(masked),
            lambda: made.interpolate(points[:, 0], masked), lambda: made.interpolate(masked[:, 0], points),
            lambda: LinearInterpolator(masked, points[:, 0]), lambda: NearestInterpolator(points, masked[:, 0]),
            lambda: LinearInterpolator((masked[:, 0], masked[:, 1]), points[:, 0]), lambda: made.weights(masked),
        ):  # fmt: skip
            with self.assertRaisesRegex(TypeError, "are a masked array"):
                call()

    def test_outside_is_a_number(self):
        points = cloud(1, 100)
        made = delaunay(points)
        for outside in ([1, 2], np.array([1.0]), None, 1j):
            for at in (points,) if outside is not None else (points, [[9.0, 9.0]]):
                with self.assertRaisesRegex(TypeError, "outside must be a number, 'nearest' or 'boundary'"):
                    made.interpolate(points[:, 0], at, outside=outside)
            with self.assertRaisesRegex(TypeError, "fill_value must be a number"):
                LinearInterpolator(points, points[:, 0], outside)
        self.assertEqual(made.interpolate(points[:, 0] + 0j, [9, 9], outside=1j), 1j)
        self.assertEqual(made.interpolate(points[:, 0], [9, 9], outside=np.float32(2)), 2)

    def test_the_rim(self):
        turn = np.radians(10)
        turned = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        at, zero, grid = np.arange(50) + 0.5, np.zeros(50), np.indices((51, 51)).reshape(2, -1).T.astype(float)
        middles = [np.c_[at, zero], np.c_[at, zero + 50], np.c_[zero, at], np.c_[zero + 50, at]]
        points, places = grid @ turned, np.concatenate(middles) @ turned
        for rim in ("convex_hull", "trimmed"):
            made = delaunay(points, rim=rim)
            for method in ("linear", "natural", "laplace"):
                np.testing.assert_allclose(made.interpolate(points[:, 0], places, method), places[:, 0], atol=1e-12)
            self.assertTrue((made.locate(places).triangle < 0).any(), "it is about the triangulation")

    def test_nearest_does_not_look_across_a_hole(self):
        points = np.concatenate((SQUARE[:4], [[1.9, 1], [2, 1], [2, 3], [1.9, 3], [2.1, 2]]))
        made = delaunay(points, loops=[[0, 1, 2, 3], [4, 5, 6, 7]])
        self.assertEqual(made.interpolate(np.arange(9.0), [[1.8, 1.99], [2.05, 2]], "nearest").tolist(), [4, 8])

    def test_places_of_interpolators(self):
        points = cloud(1, 100)
        for kind in (LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator):
            made = kind(points, points)
            self.assertEqual(made([]).shape, (0, 2))
            for places in ([[1j, 0]], [["a", "b"]]):
                with self.assertRaisesRegex(TypeError, "places must be real numbers"):
                    made(places)
            with self.assertRaisesRegex(TypeError, "places must be real numbers"):
                made(1j, 0)
            self.assertFalse(pickle.loads(pickle.dumps(made)).values.flags.writeable)

    def test_arguments_of_rasters(self):
        made = delaunay(cloud(1, 100))
        for more in ({"shape": 5}, {"shape": (2,)}, {"shape": ("a", 1)}, {"shape": (2**40, 1)}, {"cell_size": "5"},
                     {"cell_size": "a"}, {"cell_size": 1j}, {"cell_size": (1, "2")},
                     {"cell_size": 1, "bounds": 5}, {"cell_size": 1, "bounds": "0123"}):  # fmt: skip
            with self.assertRaisesRegex((TypeError, ValueError), "(shape|cell_size|bounds) must be", msg=more):
                made.raster(**more)

    def test_a_line_of_points(self):
        """A side of length 0 has one row of cells, through the points."""
        warnings.simplefilter("ignore")  # no triangles
        self.addCleanup(warnings.resetwarnings)
        made = delaunay([[0, 7], [1, 7], [4, 7]])
        cells = made.raster(cell_size=0.5)
        self.assertEqual((cells.origin, cells.shape), ((0.25, 7.0), (1, 8)))
        self.assertFalse(np.isnan(made.interpolate([0, 1, 4], cells)).any())
        self.assertEqual(made.raster(cell_size=2, align=True).origin, (1.0, 7.0))
        self.assertEqual(delaunay([[3, 0], [3, 5]]).raster(cell_size=(2, 1)).origin, (3.0, 0.5))


class SourceTest(unittest.TestCase):
    def test_points_of_the_source(self):
        """Have values of their own; added points have none, which the nearest point needs."""
        points, source = cloud(6, 300), cloud(7, 5)
        made = delaunay(points, source_points=source, lines=[0, 1])
        values = np.concatenate((points, source)) @ [2, 1]
        places = cloud(9, 60) * 0.5 + 0.25
        for kind in (LinearInterpolator, NaturalNeighborInterpolator):
            np.testing.assert_allclose(kind(made, values)(places), places @ [2, 1], rtol=1e-12)
            self.assertRaises(ValueError, kind, made, values[:300])
            self.assertEqual(len(pickle.loads(pickle.dumps(kind(made, values))).values), 305)
        self.assertRaisesRegex(ValueError, "points that were added", NearestInterpolator, made, values)

    def test_the_nearest_point_is_found_without_work_for_all(self):
        f = NearestInterpolator(cloud(6, 20000), np.arange(20000))
        expected = f(0.5, 0.5)
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        self.assertEqual(f(0.5, 0.5), expected)
        self.assertLess(tracemalloc.get_traced_memory()[1], 8 * 20000)

    def test_a_limit_counts_few_results_too(self):
        points, places = cloud(1, 100), cloud(2, 20000)
        plain = delaunay(points)
        made = delaunay(points, memory_limit=plain._job.estimate())

        def refusal():
            with self.assertRaisesRegex(MemoryError, "20000 places may take") as found:
                made.interpolate(np.ones(100), places)
            return str(found.exception)

        said = refusal()
        with unittest.mock.patch.object(library, "FEW_BYTES", 0):
            self.assertEqual(refusal(), said)


if __name__ == "__main__":
    unittest.main()
