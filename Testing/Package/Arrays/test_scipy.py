# SPDX-License-Identifier: BSD-3-Clause
"""adaptivehilbertdelaunay.scipy by its definitions, without scipy. (Foreign/: beside scipy, and scipy's own tests.)"""

import pickle
import sys
import unittest
import warnings

import numpy as np

import adaptivehilbertdelaunay.scipy as ours
from adaptivehilbertdelaunay import delaunay
from adaptivehilbertdelaunay.scipy import (
    CloughTocher2DInterpolator, Delaunay, LinearNDInterpolator, NearestNDInterpolator, griddata, tsearch,
)  # fmt: skip
from arraysupport import KeywordTest, cloud, lattice

POINTS = np.concatenate((cloud(7, 40), lattice(4) / 3, cloud(7, 40)[:5]))
EDGE = np.linspace(0, 1, 7)[1:-1, None]


class ScipyTest(KeywordTest):
    """A DelaunayWarning is an error: scipy has none."""


class DelaunayTest(ScipyTest):
    def test_neighbors_are_opposite_to_corners(self):
        made = Delaunay(POINTS)
        for row, beyond in enumerate(made.neighbors):
            for k, other in enumerate(beyond):
                edge = set(np.delete(made.simplices[row], k).tolist())
                beside = [r for r, corners in enumerate(made.simplices) if edge <= set(corners.tolist()) and r != row]
                self.assertEqual(beside, [] if other < 0 else [other])

    def test_hull_and_neighbours_of_vertices(self):
        made = Delaunay(POINTS)
        edges = [frozenset(np.delete(corners, k).tolist()) for corners in made.simplices for k in range(3)]
        rim = {edge for edge in edges if edges.count(edge) == 1}
        self.assertEqual({frozenset(edge) for edge in made.convex_hull.tolist()}, rim)
        indptr, indices = made.vertex_neighbor_vertices
        for i in range(len(POINTS)):
            wanted = sorted({j for edge in edges if i in edge for j in edge if j != i})
            self.assertEqual(indices[indptr[i] : indptr[i + 1]].tolist(), wanted)

    def test_points_at_the_place_of_another(self):
        made = Delaunay(POINTS)
        again = len(POINTS) - np.arange(5, 0, -1)
        self.assertEqual(made.coplanar[:, 0].tolist(), again.tolist())
        self.assertEqual(made.coplanar[:, 2].tolist(), list(range(5)))
        rows = made.vertex_to_simplex
        self.assertTrue((POINTS[made.simplices[rows]] == POINTS[:, None]).all(axis=2).any(axis=1).all())
        self.assertEqual(made.coplanar[:, 1].tolist(), rows[again].tolist())

    def test_equations_are_of_the_paraboloid(self):
        made = Delaunay(cloud(3, 30))
        distance = made.plane_distance(made.points)
        self.assertEqual(distance.shape, (30, made.nsimplex))
        of_corners = np.take_along_axis(distance, made.simplices.T, axis=0)
        np.testing.assert_allclose(of_corners, 0, atol=1e-14)
        self.assertLess(distance.max(), 1e-14)  # the circle of no triangle has a point inside
        np.testing.assert_allclose(np.linalg.norm(made.equations[:, :3], axis=1), 1)
        self.assertEqual(made.lift_points([[[1, 2]]]).tolist(), [[[1, 2, 5]]])

    def test_transform_gives_weights(self):
        made = Delaunay(POINTS)
        places = np.random.default_rng(2).random((len(made.simplices), 2))
        part = np.einsum("ijk,ik->ij", made.transform[:, :2], places - made.transform[:, 2])
        weights = np.concatenate((part, 1 - part.sum(axis=1)[:, None]), axis=1)
        found = np.einsum("ij,ijk->ik", weights, POINTS[made.simplices])
        fat = made.triangulation.areas > 1e-6
        np.testing.assert_allclose(found[fat], places[fat], atol=1e-8)
        flat = Delaunay([[0, 0], [1, 1e-17], [2, 0], [1, 1]])
        lost = abs(flat.triangulation.areas) < 1e-9
        self.assertEqual(lost.sum(), 1)
        self.assertEqual(np.isnan(flat.transform).all(axis=(1, 2)).tolist(), lost.tolist())

    def test_where_places_are(self):
        made = Delaunay(lattice(5))
        self.assertEqual(made.find_simplex([7, 7]).shape, ())
        self.assertEqual(made.find_simplex(np.zeros((2, 3, 2))).dtype, np.int32)
        places = np.array([[-0.1, 2.5], [2.5, 4.1], [-0.1, -0.1], [5, 9], [np.nan, 1], [np.inf, 1], [3, 4]])
        self.assertEqual((made.find_simplex(places) >= 0).tolist(), [False] * 6 + [True])
        np.testing.assert_array_equal(tsearch(made, places), made.find_simplex(places))
        near = made.find_simplex(places, tol=0.2)
        self.assertEqual((near >= 0).tolist(), [True, True, True, False, False, False, True])
        for place, row in zip(np.clip(places[:3], 0, 4), near):
            self.assertIn(row, [r for r in range(made.nsimplex) if covers(made.points[made.simplices[r]], place)])

    def test_rounding_takes_no_place_outside(self):
        """Between corners of a slanted hull half of the places are outside by rounding."""
        points = np.array([[0.1, 0.3], [0.7, 1.0], [0.3, 2.1], [-0.5, 1.1]])
        made = Delaunay(points)
        on_sides = np.concatenate([points[i] + EDGE * (points[j] - points[i]) for i, j in made.convex_hull])
        exact = made.triangulation.locate(on_sides).triangle
        self.assertIn(-1, exact.tolist())
        self.assertTrue((made.find_simplex(on_sides) >= 0).all())
        self.assertFalse(np.isnan(CloughTocher2DInterpolator(made, range(4))(on_sides)).any())

    def test_points_are_added(self):
        made = Delaunay(POINTS[:30], incremental=True)
        made.simplices, made.neighbors
        made.add_points(POINTS[30:])
        np.testing.assert_array_equal(made.simplices, Delaunay(POINTS).simplices)
        np.testing.assert_array_equal(made.points, POINTS)
        made.close()
        with self.assertRaises(RuntimeError):
            made.add_points(POINTS)
        self.assertEqual(made.npoints, len(POINTS))

    def test_their_arrays_are_the_callers(self):
        given = POINTS.copy()
        made = Delaunay(given, qhull_options="Qbb Qc Qz Q12")
        given[:] = 0
        made.simplices.sort()  # as some programs do
        self.assertGreaterEqual(made.find_simplex([0.5, 0.5]), 0)
        again = pickle.loads(pickle.dumps(made))
        np.testing.assert_array_equal(again.simplices, made.simplices)
        np.testing.assert_array_equal(again.find_simplex(POINTS), made.find_simplex(POINTS))

    def test_of_a_triangulation_with_a_hole(self):
        square = np.array([[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]], float)
        made = Delaunay(delaunay(square, loops=[[0, 1, 2, 3], [4, 5, 6, 7]]))
        self.assertEqual((made.find_simplex([[1, 1], [5, 5]]) >= 0).tolist(), [True, False])
        smooth = CloughTocher2DInterpolator(made.triangulation, square[:, 0], fill_value=-1)
        np.testing.assert_allclose(smooth([[1, 1], [5, 5], [7, 2]]), [1, -1, 7])

    def test_of_a_triangulation_with_a_source(self):
        """Its points have values of their own."""
        inner, outline = cloud(1, 40) * 8 + 0.5, np.array([[0, 0], [9, 0], [9, 9], [0, 9]], float)
        made = delaunay(inner, source_points=outline, loops=[[0, 1, 2, 3]])
        smooth = CloughTocher2DInterpolator(made, np.concatenate((inner, outline)) @ [1, 2], tol=1e-10)
        np.testing.assert_allclose(smooth([[0.1, 0.1], [8.9, 0.1], [4, 4]]), [0.3, 9.1, 12], rtol=1e-7)

    def test_no_scipy_is_needed(self):
        self.assertNotIn("scipy", sys.modules)


def covers(corners, place):
    sides = zip(corners, np.roll(corners, -1, axis=0))
    return all((q - p)[0] * (place - p)[1] >= (q - p)[1] * (place - p)[0] for p, q in sides)


def energy(points, edges, values, gradients):
    """The sum over edges of the integral of the squared second derivative of the cubic along each: by its values at
    both ends, between which it is linear."""
    total = 0.0
    for i, j in edges:
        along = points[j] - points[i]
        length = np.hypot(*along)
        first, last = along @ gradients[i] / length, along @ gradients[j] / length
        slope = (values[j] - values[i]) / length
        begin, end = (6 * slope - 4 * first - 2 * last) / length, (2 * first + 4 * last - 6 * slope) / length
        total += length * (begin**2 + begin * end + end**2) / 3
    return total


class CubicTest(ScipyTest):
    def test_gradients_have_the_least_energy(self):
        points, edges = cloud(11, 25), delaunay(cloud(11, 25)).edges
        values = np.random.default_rng(4).random(25)
        found = ours.estimate_gradients_2d_global(Delaunay(points), values, tol=1e-13)

        def at(flat):
            return energy(points, edges, values, flat.reshape(-1, 2))

        # the energy is quadratic: its derivative by each number is that of the parabola through three values
        for k in range(50):
            step = np.zeros(50)
            step[k] = 1
            below, here, above = (at(found.ravel() + t * step) for t in (-1, 0, 1))
            self.assertLess(abs(above - below), 1e-9 * (above + below - 2 * here))

    def test_the_tolerance_holds(self):
        """The error of the gradients is less than the last step, whatever the triangles."""
        for points in (cloud(1, 500), cloud(2, 500) * [1000, 1], cloud(3, 500) ** 4, lattice(20) @ [[3, 4], [-4, 3]]):
            values = np.sin(points[:, 0]) + points[:, 1]
            tri = Delaunay(points)
            exact = ours.estimate_gradients_2d_global(tri, values, tol=1e-12)
            for tol in (1e-2, 1e-6):
                found = ours.estimate_gradients_2d_global(tri, values, tol=tol)
                self.assertLess((abs(found - exact) / np.maximum(1, abs(exact))).max(), tol)
        with self.assertWarnsRegex(ours.GradientEstimationWarning, "maxiter=3"):
            ours.estimate_gradients_2d_global(tri, values, maxiter=3)

    def test_values_and_slopes_are_continuous(self):
        points = lattice(6) + 0.3 * cloud(1, 36)
        smooth = CloughTocher2DInterpolator(points, np.random.default_rng(8).random((36, 2)))
        made = smooth.triangulation
        np.testing.assert_allclose(smooth(points), smooth.values, atol=1e-14)
        fat = made.areas > 0.2  # whose slopes do not change much in a step
        rows, corners = np.nonzero((made.neighbors >= 0) & fat[made.neighbors] & fat[:, None])
        self.assertGreater(len(rows), 100)
        a, b = points[made.triangles[rows, corners]], points[made.triangles[rows, (corners + 1) % 3]]
        centre = points[made.triangles].mean(axis=1)[rows]
        for share in (0.02, 0.3, 0.5, 0.9):
            self.check_slopes(smooth, a + share * (b - a), (b - a)[:, ::-1] * [1, -1])
            self.check_slopes(smooth, a + share * (centre - a), b - a)  # where the thirds meet
        self.check_slopes(smooth, centre, b - a)

    def check_slopes(self, smooth, places, directions):
        """On both sides of places the same, to second order in the step."""
        step = 1e-4 * directions
        here = 3 * smooth(places)
        after, before = (4 * smooth(places + s * step) - smooth(places + 2 * s * step) - here for s in (1, -1))
        np.testing.assert_allclose(after / 2e-4, -before / 2e-4, atol=1e-6)

    def test_slopes_at_points_are_the_gradients(self):
        points = cloud(5, 30)
        smooth = CloughTocher2DInterpolator(points, np.cos(3 * points[:, 0]))
        inner = np.setdiff1d(np.arange(30), smooth.tri.convex_hull)
        for k in range(2):
            step = np.eye(2)[k] * 1e-6
            slope = (smooth(points[inner] + step) - smooth(points[inner] - step)) / 2e-6
            np.testing.assert_allclose(slope, smooth.grad[inner, 0, k], atol=1e-3)

    def test_linear_functions_and_affine_maps(self):
        points, places = cloud(6, 50), cloud(9, 300)
        plane = CloughTocher2DInterpolator(points, points @ [2, -3] + 1, tol=1e-12)
        inside = places[plane.tri.find_simplex(places) >= 0]
        np.testing.assert_allclose(plane(inside), inside @ [2, -3] + 1, atol=1e-10)
        values, matrix = np.random.default_rng(3).random(50), np.array([[3, 1], [-2, 0.5]])
        corners = delaunay(points[:3])
        for turn in (np.eye(2), matrix):
            moved = CloughTocher2DInterpolator(corners.points @ turn, values[:3])
            moved.grad[:] = np.linalg.solve(turn, np.array([[1, 2], [0, 4], [-3, 1]]).T).T[:, None]
            found = moved((corners.points.mean(axis=0) + (cloud(4, 20) - 0.5) / 50) @ turn)
            if turn is not matrix:
                wanted = found
        np.testing.assert_allclose(found, wanted, rtol=1e-12)

    def test_values_that_are_not_there(self):
        points, values = cloud(8, 200), cloud(8, 200)[:, 0].copy()
        values[17] = np.nan
        smooth, linear = CloughTocher2DInterpolator(points, values), LinearNDInterpolator(points, values)
        places = cloud(3, 500)
        np.testing.assert_array_equal(np.isnan(smooth(places)), np.isnan(linear(places)))
        np.testing.assert_allclose(smooth(places), linear(places), atol=1e-9)  # of x itself

    def test_slivers(self):
        """Of corners whose area is lost in rounding."""
        points = np.array([[0, 0], [1, 1e-17], [2, 0], [1, 1], [1, -1]])
        smooth = CloughTocher2DInterpolator(points, points[:, 0])
        np.testing.assert_allclose(smooth([[0.5, 0], [1.5, 0], [1, 1e-17], [1, 5e-18]]), [0.5, 1.5, 1, 1], atol=1e-12)
        angle = lattice(12) @ [[0.8, 0.6], [-0.6, 0.8]] / 7
        rotated = CloughTocher2DInterpolator(angle, angle @ [1, 2], tol=1e-12)
        self.assertGreater((rotated.triangulation.areas < 1e-12).sum(), 5)
        on_side = angle[:12].repeat(2, axis=0)[1:-1].reshape(-1, 2, 2).mean(axis=1)
        np.testing.assert_allclose(rotated(on_side), on_side @ [1, 2], rtol=1e-9)

    def test_any_unit(self):
        points, values, places = cloud(1, 80), cloud(2, 80)[:, 0], cloud(3, 50)
        wanted = CloughTocher2DInterpolator(points, values, tol=1e-9)(places)
        for unit in (2.0**-400, 2.0**-30, 2.0**400):
            found = CloughTocher2DInterpolator(points * unit, values, tol=1e-9 * min(1, 1 / unit))(places * unit)
            np.testing.assert_allclose(found, wanted, rtol=1e-7)

    def test_points_that_rounding_sets_apart(self):
        """Their distance says nothing of the slope between them."""
        random = np.random.default_rng(1)
        points = cloud(1, 300).repeat(2, axis=0) * (1 + 1e-15 * random.integers(-4, 5, (600, 2)))
        values = points[:, 0] + random.random(600) * 1e-9
        smooth, places = CloughTocher2DInterpolator(points, values), cloud(2, 500)
        inside = places[smooth.tri.find_simplex(places) >= 0]
        np.testing.assert_allclose(smooth(inside), inside[:, 0], atol=0.05)

    def test_points_nearly_on_a_line(self):
        x = np.random.default_rng(2).random(500)
        points = np.stack((x, x + 1e-12 * np.random.default_rng(3).random(500)), axis=1)
        with self.assertWarns(ours.GradientEstimationWarning):
            smooth = CloughTocher2DInterpolator(points, 3 * x)
        centres = points[smooth.tri.simplices].mean(axis=1)
        np.testing.assert_allclose(smooth(centres), 3 * centres[:, 0], atol=1e-3)

    def test_columns_are_apart(self):
        points, places = cloud(2, 60), cloud(3, 90)
        values = np.random.default_rng(1).random((60, 2, 2)) + 1j * np.random.default_rng(2).random((60, 2, 2))
        whole = CloughTocher2DInterpolator(points, values)(places)
        self.assertEqual((whole.shape, whole.dtype), ((90, 2, 2), np.complex128))
        for i, j in np.ndindex(2, 2):
            parts = [CloughTocher2DInterpolator(points, part[:, i, j])(places) for part in (values.real, values.imag)]
            np.testing.assert_allclose(whole[:, i, j], parts[0] + 1j * parts[1], atol=1e-5)


class CalledTest(ScipyTest):
    def test_values_can_be_replaced(self):
        """As programs do that have many values for the same points."""
        points, places = cloud(4, 50), cloud(5, 20)
        again = LinearNDInterpolator(points, np.zeros(50))
        again.values = points[:, :1].copy()
        np.testing.assert_allclose(again(places), LinearNDInterpolator(points, points[:, 0])(places))

    def test_nearest(self):
        points, places = POINTS[:40], cloud(6, 300) * 2
        apart = np.hypot(*(places[:, None] - points).transpose(2, 0, 1))
        nearest = NearestNDInterpolator(points, np.arange(40))
        np.testing.assert_array_equal(nearest(places), apart.argmin(axis=1))
        self.assertEqual(nearest(places).dtype, np.float64)
        near = nearest(places, distance_upper_bound=0.3, workers=-1)
        np.testing.assert_array_equal(np.isnan(near), apart.min(axis=1) >= 0.3)
        self.assertEqual(NearestNDInterpolator([[0, 0], [1, 1]], [["a"], ["b"]])([3, 3]).tolist(), [["b"]])
        self.assertEqual(NearestNDInterpolator([[0, 0], [1, 9]], [1 + 1j, 2])(0.9, 1, p=2).tolist(), 1 + 1j)

    def test_rescaled(self):
        points, places = cloud(1, 40), cloud(2, 30)
        wide = [1000, 0.001]
        for method in ("linear", "nearest", "cubic"):
            wanted = griddata(points, points[:, 0], places, method, rescale=True)
            found = griddata(points * wide + 5, points[:, 0], tuple((places * wide + 5).T), method, rescale=True)
            np.testing.assert_allclose(found, wanted, rtol=1e-6)

    def test_rescaled_on_request_only(self):
        points, places = cloud(1, 40) * [1000, 1], cloud(2, 30) * [600, 0.6] + [200, 0.2]
        values = points[:, 0] * points[:, 1]
        for kind in (LinearNDInterpolator, CloughTocher2DInterpolator, NearestNDInterpolator):
            found, plain, rescaled = (kind(points, values, **how)(places) for how in (
                {}, {"rescale": False}, {"rescale": True}))  # fmt: skip
            np.testing.assert_array_equal(found, plain)
            self.assertFalse(np.array_equal(found, rescaled))
        for method in ("linear", "nearest", "cubic"):
            found, plain = (griddata(points, values, places, method, **how) for how in ({}, {"rescale": False}))
            np.testing.assert_array_equal(found, plain)

    def test_places_outside_are_no_news(self):
        """scipy has no warning, and such a one would be an error here."""
        for method in ("linear", "cubic"):
            self.assertTrue(np.isnan(griddata(cloud(1, 40), cloud(2, 40), [[7, 7], [8, 8]], method)).all())

    def test_pickled(self):
        for kind in (LinearNDInterpolator, CloughTocher2DInterpolator, NearestNDInterpolator):
            f = kind(cloud(1, 40), cloud(2, 40))
            np.testing.assert_array_equal(pickle.loads(pickle.dumps(f))(cloud(3, 9)), f(cloud(3, 9)))

    def test_warnings_name_their_caller(self):
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            CloughTocher2DInterpolator(cloud(1, 40), cloud(1, 40)[:, 0], maxiter=1)
        self.assertEqual([w.filename for w in found], [__file__])


if __name__ == "__main__":
    unittest.main()
