# SPDX-License-Identifier: BSD-3-Clause
"""Values between the points: known functions, places on vertices and edges, shapes, refusals."""

import copy
import pickle
import signal
import threading
import unittest
import warnings
from fractions import Fraction

import numpy as np
from adaptivehilbertdelaunay import (
    LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator, Raster, delaunay,
)  # fmt: skip
from adaptivehilbertdelaunay import _library as library
from arraysupport import SQUARE, cloud, integers, lattice

METHODS = ("linear", "natural", "laplace", "nearest")
SMOOTH = METHODS[:3]


def utm(count):
    """Metres far from the origin, of centimetres."""
    return np.round(cloud(7, count) * 1000, 2) + [455000.0, 5230000.0]


def sets():
    yield "uniform", cloud(1, 500)
    yield "lattice", lattice(15)
    yield "utm", utm(500)


def inside(made, count, seed=5):
    """Places on the triangles of a triangulation: within, on edges, on vertices."""
    random = np.random.default_rng(seed)
    corners = made.points[made.triangles[random.integers(0, len(made.triangles), count)]][:, :, :2]
    weights = random.dirichlet((1, 1, 1), count)
    places = (weights[:, :, None] * corners).sum(axis=1)
    places[: count // 4] = corners[: count // 4, 0]
    places[count // 4 : count // 2] = corners[count // 4 : count // 2, :2].mean(axis=1)
    return places[made.locate(places).triangle >= 0]


class KnownTest(unittest.TestCase):
    def test_linear_functions(self):
        for name, points in sets():
            made = delaunay(points)
            places = inside(made, 2000)
            function = np.array([3.0, -2.0])
            values, expected = points @ function, places @ function
            for method in SMOOTH:
                found = made.interpolate(values, places, method)
                worst = np.abs(found - expected).max()
                self.assertLessEqual(worst, 1e-13 * np.abs(values).max(), (name, method))
            slopes = made.interpolate(values, places, gradient=True)[1]
            self.assertEqual(slopes.shape, (len(places), 2))

    def test_slopes_of_a_plane(self):
        points = cloud(3, 300)
        made = delaunay(points)
        places = inside(made, 400)[200:]
        values = np.stack((points @ [3, -2], points[:, 0]), axis=1)
        found, slopes = made.interpolate(values, places, gradient=True)
        self.assertEqual(slopes.shape, (len(places), 2, 2))
        within = made.locate(places).kind == library.IN_TRIANGLE
        np.testing.assert_allclose(slopes[within, 0], np.broadcast_to([3, -2], (within.sum(), 2)), atol=1e-9)
        np.testing.assert_allclose(slopes[within, 1], np.broadcast_to([1, 0], (within.sum(), 2)), atol=1e-9)
        both = values[:, 0] + 1j * values[:, 1]
        known, complexes = made.interpolate(both, places, gradient=True)
        np.testing.assert_array_equal(known, found[:, 0] + 1j * found[:, 1])
        np.testing.assert_array_equal(complexes, slopes[:, 0] + 1j * slopes[:, 1])

    def test_against_fractions(self):
        """Linear values are those of the triangle that locate() gives, computed exactly."""
        for name, points in sets():
            made = delaunay(points)
            values = np.random.default_rng(2).standard_normal(len(points))
            places = inside(made, 300)
            found = made.interpolate(values, places)
            rows = made.locate(places).triangle
            exact = integers(np.concatenate((points, places)))
            for place, value, row in zip(exact[len(points) :], found, rows):
                ids = made.triangles[row]
                (ax, ay), (bx, by), (cx, cy) = (exact[i] for i in ids)
                px, py = place
                area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
                b = Fraction((px - ax) * (cy - ay) - (py - ay) * (cx - ax), area)
                c = Fraction((bx - ax) * (py - ay) - (by - ay) * (px - ax), area)
                z = [Fraction(float(values[i])) for i in ids]
                expected = z[0] + b * (z[1] - z[0]) + c * (z[2] - z[0])
                self.assertLessEqual(abs(float(expected - Fraction(float(value)))), 1e-12 * np.abs(values).max(), name)

    def test_vertices_and_edges(self):
        for name, points in sets():
            made = delaunay(points)
            values = np.random.default_rng(2).standard_normal(len(points))
            for method in METHODS:
                np.testing.assert_array_equal(made.interpolate(values, points, method), values, name)
        made = delaunay(lattice(4))
        values = np.random.default_rng(3).standard_normal(16)
        ends = made.edges[(made.points[made.edges[:, 0]] == made.points[made.edges[:, 1]]).any(axis=1)]
        found = made.interpolate(values, made.points[ends].mean(axis=1))
        np.testing.assert_array_equal(found, 0.5 * values[ends[:, 0]] + 0.5 * values[ends[:, 1]])

    def test_nearest(self):
        for name, points in sets():
            made = delaunay(points)
            low, high = points.min(axis=0), points.max(axis=0)
            places = low + (np.random.default_rng(4).random((300, 2)) * 2 - 0.5) * (high - low)
            ids = made.interpolate(np.arange(len(points)), places, "nearest").astype(int)
            exact = integers(np.concatenate((points, places)))
            for (px, py), found in zip(exact[len(points) :], ids):
                best = min(((x - px) ** 2 + (y - py) ** 2, x, y) for x, y in exact[: len(points)])
                self.assertEqual(best[1:], exact[found], name)

    def test_values_stay_between_those_around(self):
        points = cloud(8, 400)
        made = delaunay(points)
        values = np.random.default_rng(2).standard_normal(len(points))
        places = inside(made, 1000)
        for method in METHODS:
            offsets, ids, weights = made.weights(places, method)
            self.assertTrue((weights >= 0).all())
            sums = np.add.reduceat(weights, offsets[:-1])
            np.testing.assert_allclose(sums, 1, atol=1e-14)
            found = np.add.reduceat(weights * values[ids], offsets[:-1])
            np.testing.assert_allclose(found, made.interpolate(values, places, method), atol=1e-13)
            low, high = np.minimum.reduceat(values[ids], offsets[:-1]), np.maximum.reduceat(values[ids], offsets[:-1])
            self.assertTrue((found >= low - 1e-13).all() and (found <= high + 1e-13).all())


class SurfaceTest(unittest.TestCase):
    def test_outside(self):
        made = delaunay(SQUARE)
        values, places = np.arange(6.0), [[2, 2], [5, 5], [np.nan, 1], [np.inf, 1]]
        for method in SMOOTH:
            found = made.interpolate(values, places, method)
            self.assertEqual(np.isnan(found).tolist(), [False, True, True, True])
            self.assertEqual(made.interpolate(values, places, method, outside=-9)[1:].tolist(), [-9, -9, -9])
            nearest = made.interpolate(values, places, method, outside="nearest")
            self.assertEqual(nearest[1], 2.0)
            self.assertEqual(nearest[0], found[0])
            self.assertTrue(np.isnan(nearest[2:]).all())
            boundary = made.interpolate(values, [[2, 2], [9, 3], [np.nan, 1]], method, outside="boundary")
            np.testing.assert_allclose(boundary, [found[0], 1.75, np.nan])
        self.assertEqual(made.interpolate(values, places, "nearest", outside=-9)[1:].tolist(), [2, -9, -9])

    def test_holes_and_limits(self):
        points = np.concatenate((SQUARE[:4], [[1, 1], [3, 1], [3, 3], [1, 3]]))
        made = delaunay(points, loops=[[0, 1, 2, 3], [4, 5, 6, 7]])
        for method in SMOOTH:
            found = made.interpolate(points[:, 0], [[2, 2], [0.5, 2], [1, 1.5]], method)
            self.assertEqual(np.isnan(found).tolist(), [True, False, False])
            self.assertEqual(found[2], 1.0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            long = delaunay(SQUARE, maximum_edge_length=2.5)
        self.assertTrue(np.isnan(long.interpolate(np.ones(6), [[2, 0.1]])).all())

    def test_missing_values(self):
        made = delaunay(SQUARE)
        values = SQUARE[:, 0].copy()
        values[4] = np.nan
        self.assertTrue(np.isnan(made.interpolate(values, [[1.5, 2]])[0]))
        for method in ("natural", "laplace"):
            found = made.interpolate(values, [[1.5, 2]], method)
            self.assertTrue(0 <= found[0] <= 4)
        self.assertTrue(np.isnan(made.interpolate(np.full(6, np.nan), [[1.5, 2]], "natural")).all())

    def test_collinear(self):
        points = np.array([[0, 0], [2, 2], [6, 6]], float)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            line, one = delaunay(points), delaunay(points[:1])
            none = delaunay(np.zeros((0, 2)))
        for method in SMOOTH:
            found = line.interpolate([0, 10, 50], [[1, 1], [4, 4], [2, 2], [7, 7], [1, 1.5]], method)
            np.testing.assert_array_equal(found, [5, 30, 10, np.nan, np.nan])
            np.testing.assert_array_equal(one.interpolate([3], [[0, 0], [1, 0]], method), [3, np.nan])
            np.testing.assert_array_equal(none.interpolate([], [[0, 0]], method), [np.nan])
        self.assertEqual(line.interpolate([0, 10, 50], [9, 0], "nearest"), 50)
        self.assertEqual(one.interpolate([3], [9, 0], "nearest"), 3)

    def test_points_that_were_added(self):
        points = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], float)
        made = delaunay(points, segments=[(0, 2), (1, 3)], crossings="split")
        found = made.interpolate([0, 10, 20, 50], [[2, 2], [0, 0]], "natural")
        np.testing.assert_array_equal(found, [20, 0])
        source = delaunay(points, source_points=[[1, 1]], lines=[], tolerance=0.0)
        np.testing.assert_array_equal(source.interpolate([0, 1, 2, 3, 99], [[1, 1]]), [99])

    def test_another_plane(self):
        """Places are in the plane of the triangulation."""
        points = np.concatenate((cloud(2, 50) * 9, np.zeros((50, 1))), axis=1)
        swap = np.array([[0, 1, 0, 5], [-1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
        made = delaunay(points, plane=swap, rim="convex_hull")
        places = inside(delaunay(made.plane_points[:, :2]), 100)
        np.testing.assert_allclose(made.interpolate(points[:, 0], places), -places[:, 1], atol=1e-12)

    def test_duplicates(self):
        points = np.concatenate((SQUARE, SQUARE))
        values = np.arange(12.0)
        np.testing.assert_array_equal(delaunay(points).interpolate(values, SQUARE), values[:6])


class ShapeTest(unittest.TestCase):
    def test_shapes(self):
        made = delaunay(SQUARE)
        for at, shape in (
            (np.ones((5, 2)), (5,)), (np.ones((3, 4, 2)), (3, 4)), (np.ones(2), ()), (np.zeros((0, 2)), (0,)),
            ([], (0,)), (made.raster(shape=(3, 2)), (3, 2)), (Raster((0, 0), (1, 1), (0, 7)), (0, 7)),
        ):  # fmt: skip
            for values, more in ((np.ones(6), ()), (np.ones((6, 1)), (1,)), (np.ones((6, 2, 3)), (2, 3)),
                                 (np.ones((6, 0)), (0,))):  # fmt: skip
                for method in METHODS:
                    found = made.interpolate(values, at, method)
                    self.assertEqual((found.shape, found.dtype), (shape + more, np.float64))
                    np.testing.assert_allclose(found, 1, rtol=1e-14)
                slopes = made.interpolate(values, at, gradient=True)[1]
                self.assertEqual(slopes.shape, shape + more + (2,))

    def test_types(self):
        made = delaunay(SQUARE)
        for dtype in (np.float32, np.int8, np.uint64, np.bool_, ">f8"):
            values = np.array([0, 1, 1, 0, 1, 0]).astype(dtype)
            np.testing.assert_array_equal(
                made.interpolate(values, [[2, 1]]), made.interpolate(values.astype(float), [[2, 1]])
            )
        for places in (np.array([[2, 1]], np.float32), np.array([[2, 1]]), [[2, 1]], np.array([[2, 9, 1]])[:, ::2]):
            self.assertEqual(made.interpolate(SQUARE[:, 0], places), 2)

    def test_rasters_are_places(self):
        for name, points in sets():
            made = delaunay(points)
            cells = made.raster(shape=(40, 70))
            places = np.stack(np.meshgrid(cells.x, cells.y), axis=-1)
            down = Raster((cells.x[0], cells.y[-1]), (cells.spacing[0], -cells.spacing[1]), cells.shape)
            for method in METHODS:
                found = made.interpolate(points[:, 1], cells, method, outside="nearest")
                np.testing.assert_array_equal(found, made.interpolate(points[:, 1], places, method, outside="nearest"))
                np.testing.assert_allclose(found[::-1], made.interpolate(points[:, 1], down, method, outside="nearest"),
                                           rtol=1e-9, err_msg=name)  # fmt: skip

    def test_rasters(self):
        made = delaunay([[1, 1], [9.5, 1], [9.5, 5], [1, 5]])
        self.assertEqual(made.raster(shape=(2, 17)), Raster((1.25, 2), (0.5, 2), (2, 17)))
        self.assertEqual(made.raster(cell_size=2), Raster((2, 2), (2, 2), (2, 5)))
        self.assertEqual(made.raster(cell_size=(4, 2), align=True), Raster((2, 1), (4, 2), (3, 3)))
        self.assertEqual(made.raster(cell_size=2, bounds=(-3, -2, 0, 7), align=True), Raster((-3, 1), (2, 2), (4, 1)))
        self.assertEqual(made.raster(cell_size=3, bounds=(5, 5, 0, 0)), Raster((5, 0), (3, 3), (1, 1)))
        self.assertEqual(made.raster(shape=(1, 1), bounds=(5, 5, 0, 0)), Raster((5, 0), (1, 1), (1, 1)))
        self.assertEqual(made.raster(cell_size=2).bounds, (1, 11, 1, 5))
        self.assertEqual(made.raster(cell_size=0.1, bounds=(0, 1.1, 0, 0.7)).shape, (7, 11))
        self.assertEqual(made.raster(cell_size=0.1, bounds=(-0.3, 0.6, 0.1, 0.7), align=True).shape, (6, 9))
        self.assertEqual(made.raster(cell_size=0.1, bounds=(0, 1.101, 0, 0.699)).shape, (7, 12))
        self.assertEqual(made.raster(shape=(3, 5), bounds=(2, 2, 0, 6)), Raster((2, 1), (2, 2), (3, 1)))
        self.assertEqual(made.raster(shape=(3, 5), bounds=(4, 4, 2, 2)), Raster((4, 2), (1, 1), (1, 1)))
        wide = made.raster(shape=(1, 2), bounds=(-1.7e308, 1.7e308, 0, 1))
        self.assertEqual((wide.origin[0], wide.spacing[0]), (-0.85e308, 1.7e308))
        self.assertEqual(made.raster(cell_size=2, align=True).geotransform, (0, 2, 0, 0, 0, 2))

    def test_raster_of_points_that_are_no_vertices(self):
        points = np.concatenate((SQUARE, [[99, 99], [np.nan, 200]]))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            made = delaunay(points, skip=np.arange(8) == 6)
            none = delaunay(np.full((2, 2), np.nan))
        self.assertEqual(made.raster(cell_size=1).bounds, (0, 4, 0, 4))
        with self.assertRaisesRegex(ValueError, "no vertices"):
            none.raster(cell_size=1)
        self.assertEqual(none.interpolate([1, 2], Raster((0, 0), (1, 1), (1, 1)), outside="nearest").shape, (1, 1))


class RefusedTest(unittest.TestCase):
    def test_rasters(self):
        made = delaunay(SQUARE)
        for kind, said, ask in (
            (ValueError, "either a cell_size or a shape", lambda: made.raster()),
            (ValueError, "either a cell_size or a shape", lambda: made.raster(cell_size=1, shape=(1, 1))),
            (ValueError, "greater than 0", lambda: made.raster(cell_size=0)),
            (ValueError, "greater than 0", lambda: made.raster(cell_size=-1)),
            (ValueError, "greater than 0", lambda: made.raster(cell_size=(1, np.nan))),
            (TypeError, "two numbers", lambda: made.raster(cell_size=(1, 1, 1))),
            (ValueError, "from 1 to", lambda: made.raster(shape=(0, 5))),
            (TypeError, "whole numbers", lambda: made.raster(shape=(1.5, 5))),
            (ValueError, "align", lambda: made.raster(shape=(1, 5), align=True)),
            (ValueError, "ascending", lambda: made.raster(cell_size=1, bounds=(1, 0, 0, 1))),
            (ValueError, "ascending", lambda: made.raster(cell_size=1, bounds=(0, np.nan, 0, 1))),
            (TypeError, "four numbers", lambda: made.raster(cell_size=1, bounds=(0, 1))),
            (MemoryError, "rows or columns", lambda: made.raster(cell_size=1e-12)),
            (ValueError, "apart", lambda: made.raster(cell_size=1, bounds=(1e17, 1e17 + 64, 0, 1))),
            (ValueError, "wider", lambda: made.raster(shape=(8, 8), bounds=(0, 1, -1.7e308, 1.7e308))),
            (ValueError, "wider", lambda: made.raster(cell_size=1e300, bounds=(-1.7e308, 1.7e308, 0, 1))),
            (ValueError, "spacing", lambda: Raster((0, 0), (0, 1), (1, 1))),
            (ValueError, "origin", lambda: Raster((np.inf, 0), (1, 1), (1, 1))),
            (ValueError, "shape", lambda: Raster((0, 0), (1, 1), (-1, 1))),
        ):  # fmt: skip
            with self.assertRaisesRegex(kind, said):
                ask()

    def test_arguments(self):
        made, values = delaunay(SQUARE), np.ones(6)
        for kind, said, ask in (
            (ValueError, "one of 'linear'", lambda: made.interpolate(values, [[1, 1]], "cubic")),
            (TypeError, "one of 'linear'", lambda: made.interpolate(values, [[1, 1]], 1)),
            (ValueError, "row for each of 6", lambda: made.interpolate(np.ones(5), [[1, 1]])),
            (TypeError, "numbers", lambda: made.interpolate(["a"] * 6, [[1, 1]])),
            (TypeError, "mask", lambda: made.interpolate(np.ma.masked_equal(np.ones(6), 1), [[1, 1]])),
            (TypeError, "mask", lambda: made.interpolate(values, np.ma.masked_equal(np.ones((1, 2)), 1))),
            (ValueError, r"\(k, 2\)", lambda: made.interpolate(values, [[1, 1, 1]])),
            (TypeError, "real", lambda: made.interpolate(values, [["a", "b"]])),
            (TypeError, "real", lambda: made.interpolate(values, [[1j, 2]])),
            (ValueError, "'nearest'", lambda: made.interpolate(values, [[1, 1]], outside="far")),
            (ValueError, "gradients", lambda: made.interpolate(values, [[1, 1]], "natural", gradient=True)),
            (ValueError, "as `at`", lambda: made.interpolate(values, method="natural")),
            (ValueError, "as `at`", lambda: made.interpolate(values, outside=0)),
            (ValueError, "one of 'linear'", lambda: made.weights([[1, 1]], "cubic")),
        ):  # fmt: skip
            with self.assertRaisesRegex(kind, said):
                ask()

    def test_memory(self):
        made = delaunay(cloud(1, 100), memory_limit=10**8)
        huge = made.raster(shape=(2**20, 2**20))
        with self.assertRaisesRegex(MemoryError, '1099511627776 places may take .* "memory_limit" leaves'):
            made.interpolate(np.ones(100), huge)
        with self.assertRaisesRegex(MemoryError, "places may take"):
            made.weights(huge)
        with self.assertRaisesRegex(MemoryError, "there are"):
            delaunay(SQUARE).interpolate(np.ones(6), huge, outside="nearest")
        with self.assertRaisesRegex(MemoryError, "not fit in any memory"):
            made.interpolate(np.ones(100), Raster((0, 0), (1, 1), (2**31 - 1, 2**31 - 1)))
        self.assertAlmostEqual(float(made.interpolate(np.ones(100), [0.5, 0.5])), 1)  # goes on

    def test_changed_points(self):
        points = cloud(1, 100)
        made = delaunay(points)
        points[0] = 7
        with self.assertRaisesRegex(RuntimeError, "changed"):
            made.interpolate(np.ones(100), [[0.5, 0.5]])


class WorkTest(unittest.TestCase):
    def test_other_arrays_in_between(self):
        points = cloud(6, 3000)
        places, values = cloud(9, 500), points[:, 0] * points[:, 1]
        made = delaunay(points, duplicates="highest_z", want=("order",))
        expected = {method: made.interpolate(values, places, method, outside="nearest") for method in METHODS}
        fresh = delaunay(points, duplicates="highest_z", want=("order",))
        for name in ("neighbors", "point_status", "vertex_of_point", "order", "regions", "plane_points",
                     "insertion_ranks", "boxes"):  # fmt: skip
            for method in METHODS:
                np.testing.assert_array_equal(
                    made.interpolate(values, places, method, outside="nearest"), expected[method]
                )
            ours, theirs = getattr(made, name), getattr(fresh, name)
            for one, other in zip(ours, theirs) if isinstance(ours, tuple) else [(ours, theirs)]:
                np.testing.assert_array_equal(one, other)
        for method in METHODS:
            np.testing.assert_array_equal(made.interpolate(values, places, method, outside="nearest"), expected[method])

    def test_threads_of_the_engine(self):
        points = cloud(6, 30000)
        cells = delaunay(points).raster(shape=(300, 300))
        for method in METHODS:
            one, two = (delaunay(points, threads=k).interpolate(points[:, 0], cells, method) for k in (1, 2))
            self.assertEqual(one.tobytes(), two.tobytes())

    def test_threads_of_the_caller(self):
        points = cloud(6, 3000)
        shared, places = LinearInterpolator(points, points[:, 0]), cloud(9, 2000)
        expected, found = shared(places), []
        workers = [threading.Thread(target=lambda: found.append(shared(places))) for _ in range(8)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(len(found), 8)
        for one in found:
            np.testing.assert_array_equal(one, expected)

    def test_progress(self):
        points = cloud(6, 30000)
        made, heard = delaunay(points), []
        cells = made.raster(shape=(500, 500))
        made.interpolate(points[:, 0], cells, "natural", progress=lambda phase, done: heard.append((phase, done)))
        self.assertGreater(len(heard), 10)
        self.assertEqual({phase for phase, _ in heard}, {"outputs"})
        self.assertEqual(heard, sorted(heard))
        self.assertEqual(heard[-1][1], 1.0)
        for more in ({"method": "nearest"}, {"outside": "nearest"}, {}):
            heard.clear()
            made.interpolate(points[:, 0], cells, progress=lambda phase, done: heard.append((phase, done)), **more)
            self.assertEqual(heard[-1][1], 1.0, more)

        class Stop(Exception):
            pass

        def stop(phase, done):
            raise Stop

        with self.assertRaises(Stop):
            made.interpolate(points[:, 0], cells, "natural", progress=stop)
        self.assertAlmostEqual(float(made.interpolate(np.ones(30000), [0.5, 0.5])), 1)

    def test_a_progress_function_cannot_ask(self):
        """And is still called afterwards."""
        points = cloud(6, 30000)
        made, heard, refused = delaunay(points), [], []
        cells = made.raster(shape=(500, 500))

        def ask(phase, done):
            heard.append(done)
            try:
                made.interpolate(points[:, 0], [[0.5, 0.5]])
            except RuntimeError as error:
                refused.append(str(error))

        made.interpolate(points[:, 0], cells, "natural", progress=ask)
        self.assertGreater(len(heard), 10)
        self.assertEqual(heard[-1], 1.0)
        self.assertEqual(len(refused), len(heard))
        self.assertRegex(refused[0], "being computed: a progress function cannot use")

    def test_ctrl_c(self):
        points = cloud(6, 20000)
        made = delaunay(points, threads=1)
        cells = made.raster(shape=(4000, 4000))
        before = signal.signal(signal.SIGINT, signal.default_int_handler)  # as it may be ignored
        self.addCleanup(signal.signal, signal.SIGINT, before)
        with self.assertRaises(KeyboardInterrupt):
            threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
            made.interpolate(points[:, 0], cells, "natural")
        self.assertAlmostEqual(float(made.interpolate(np.ones(20000), [0.5, 0.5])), 1)


class InterpolatorTest(unittest.TestCase):
    def test_calls(self):
        points = cloud(6, 300)
        for kind in (LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator):
            f = kind(points, points @ [2, 1])
            places = cloud(9, 60) * 0.5 + 0.25
            expected = f(places)
            self.assertEqual(expected.shape, (60,))
            np.testing.assert_array_equal(f(places[:, 0], places[:, 1]), expected)
            np.testing.assert_array_equal(f((places[:, 0], places[:, 1])), expected)
            np.testing.assert_array_equal(f(places.reshape(3, 20, 2)), expected.reshape(3, 20))
            np.testing.assert_array_equal(f(0.5, [0.4, 0.5]), [f(0.5, 0.4), f(0.5, 0.5)])
            np.testing.assert_array_equal(f(*np.ogrid[0:1:3j, 0:1:4j]).shape, (3, 4))
            np.testing.assert_array_equal(kind((points[:, 0], points[:, 1]), points @ [2, 1])(places), expected)
            np.testing.assert_array_equal(kind(delaunay(points), points @ [2, 1])(places), expected)
            np.testing.assert_array_equal(pickle.loads(pickle.dumps(f))(places), expected)
            np.testing.assert_array_equal(copy.deepcopy(f)(places), expected)
            self.assertRaises(TypeError, f, 1, 2, 3)
            self.assertRaises(ValueError, f, [[1, 2, 3]])
            self.assertRaises(ValueError, kind, points, np.ones(7))
            for rescale in (False, True):
                for points_of_wrong_shape in (cloud(1, 9, 3), cloud(1, 9, 2)[0], np.ones((9, 1)), np.ones((9, 2, 1))):
                    with self.assertRaisesRegex(ValueError, r"points must be of shape \(n, 2\), not"):
                        kind(points_of_wrong_shape, np.ones(len(points_of_wrong_shape)), rescale=rescale)
            self.assertRaises(ValueError, kind, delaunay(points), np.ones(300), rescale=True)
            self.assertRaises(TypeError, kind, points, np.ma.masked_equal(np.ones(300), 1))

    def test_its_own_copies(self):
        points, values = cloud(6, 300), np.arange(300.0)
        f = LinearInterpolator(points, values)
        expected = f(0.5, 0.5)
        points[:], values[:] = 0, 0
        self.assertEqual(f(0.5, 0.5), expected)

    def test_fill_value(self):
        f = LinearInterpolator(SQUARE, np.ones((6, 2)), fill_value=7)
        np.testing.assert_array_equal(f([[2, 2], [9, 9], [np.nan, 0]]), [[1, 1], [7, 7], [7, 7]])
        g = NaturalNeighborInterpolator(SQUARE, np.ones(6) * 1j, 2j)
        np.testing.assert_array_equal(g([[2, 2], [9, 9]]), [1j, 2j])
        self.assertRaises(TypeError, LinearInterpolator, SQUARE, np.ones(6), "nearest")

    def test_rescale(self):
        points = cloud(6, 300) * [1, 1e6] + [5, 7]
        values = points @ [1, 1e-6]
        for kind in (LinearInterpolator, NaturalNeighborInterpolator):
            f, places = kind(points, values, rescale=True), cloud(9, 60) * [0.5, 5e5] + [5.25, 2.5e5]
            np.testing.assert_allclose(f(places), places @ [1, 1e-6], rtol=1e-12)
        constant = LinearInterpolator([[0, 0], [9, 0], [9, 9]], [1, 1, 1], rescale=True)
        self.assertEqual(constant(8, 1), 1)

    def test_nearest_keeps_types(self):
        self.assertEqual(NearestInterpolator(SQUARE, np.arange(6))([[0, 0]]).dtype, np.arange(6).dtype)
        self.assertTrue(np.isnan(NearestInterpolator(SQUARE, np.ones(6))(np.nan, 0)))
        self.assertRaises(ValueError, NearestInterpolator(SQUARE, np.arange(6)), np.nan, 0)
        self.assertEqual(NearestInterpolator(SQUARE, list("abcdef"))(9, 9), "c")


if __name__ == "__main__":
    unittest.main()
