# SPDX-License-Identifier: BSD-3-Clause
"""Positions of points in space, for every plane, kind of source, number type and rule for duplicates: recomputed from
the input, and from another triangulation.
"""

import itertools
import tracemalloc
import unittest
import warnings

import numpy as np

from adaptivehilbertdelaunay import DelaunayWarning, NearestInterpolator, delaunay
from arraysupport import cloud

TURN = np.array([[0.6, 0, 0.8, 3], [0, 1, 0, -2], [-0.8, 0, 0.6, 1], [0, 0, 0, 1]])


def turned(xyz):
    return xyz @ TURN[:3, :3].T + TURN[:3, 3]


PLANES = {"xy": "xy", "matrix": TURN, "function": turned, "best_fit": "best_fit"}
LINES = [[0, 1], [2, 3], [4, 5, 6], [7, 8]]
COUNT, OWN = 101, 9  # odd


def flat(points):
    """Nearly in a plane, so that the best fit is unambiguous."""
    points[:, 2] *= 0.05
    return points


class SpaceTest(unittest.TestCase):
    def setUp(self):
        caught = warnings.catch_warnings()
        caught.__enter__()
        self.addCleanup(caught.__exit__)
        warnings.simplefilter("ignore", DelaunayWarning)

    @staticmethod
    def each(*more):
        for plane, dtype, *rest in itertools.product(PLANES, (np.float64, np.float32), *more):
            yield (PLANES[plane], flat(cloud(3, COUNT, 3, dtype)), flat(cloud(4, OWN, 3, dtype)), *rest)

    def test_points_of_input_and_source_are_where_they_were(self):
        for plane, points, source, crossings in self.each(("leave_out", "split")):
            made = delaunay(points, source_points=source, lines=LINES, plane=plane, crossings=crossings)
            self.assertTrue(np.array_equal(made.points[:COUNT], points))
            self.assertTrue(np.array_equal(made.points[COUNT : COUNT + OWN], source))
            added = made.points[COUNT + OWN :]
            self.assertEqual(len(added), made.counts["split_crossings"])
            self.assertEqual(len(added) > 0, crossings == "split")
            f = made.crossing_fractions[:, :, None]
            a, b, c, d = (made.points[made.crossing_ends[:, k]] for k in range(4))
            wanted = ((1 - f[:, 0]) * a + f[:, 0] * b + (1 - f[:, 1]) * c + f[:, 1] * d) / 2
            np.testing.assert_allclose(added, wanted, rtol=1e-6, atol=1e-6)

    def test_source_points_are_laid_on_the_surface(self):
        for plane, points, source in self.each():
            made = delaunay(points, source_points=source, lines=LINES, plane=plane, source_heights="surface")
            # the plane that fits the points alone is another
            same = made.plane_matrix if plane is PLANES["best_fit"] else plane
            alone = delaunay(points, plane=same, rim="convex_hull")
            raised = delaunay(points, source_points=source, lines=LINES, plane=plane)
            places = raised.plane_points[COUNT : COUNT + OWN, :2]
            there = alone.interpolate(points, places)
            inside = np.isfinite(there).all(axis=1)
            self.assertGreater(inside.sum(), 2)
            found = made.points[COUNT : COUNT + OWN]
            if plane is PLANES["xy"]:
                there[:, :2] = source[:, :2]
            np.testing.assert_allclose(found[inside], there[inside], rtol=1e-6, atol=1e-6)
            self.assertTrue(np.array_equal(found[~inside], source[~inside]))
            self.assertEqual(made.counts["points_off_surface"], (~inside).sum())

    def test_means_of_stacks(self):
        """z of five points at each of some places, one of them not finite."""
        for dtype, others in itertools.product((np.float64, np.float32), (False, True)):
            points = np.repeat(cloud(5, 20, 3, dtype), 5, axis=0)
            points[:, 2] = cloud(6, len(points), 2, dtype)[:, 0]
            points[7, 2] = np.nan
            more = {"source_points": cloud(7, 4, 3, dtype) + dtype(2), "lines": [[0, 1], [2, 3]]} if others else {}
            made = delaunay(points, duplicates="mean_z", **more)
            status = made.point_status[: len(points)]
            for vertex in np.unique(status):
                z = points[status == vertex, 2].astype(float)
                self.assertAlmostEqual(made.points[vertex, 2], z[np.isfinite(z)].mean(), places=6)
            rest = np.flatnonzero(status != np.arange(len(points)))
            self.assertTrue(np.array_equal(made.points[rest], points[rest], equal_nan=True))
            if others:
                self.assertTrue(np.array_equal(made.points[len(points) :], more["source_points"]))

    def test_values_that_are_z_follow_the_means(self):
        """In every plane, with added points, and with columns of other data."""
        for dtype, plane, others in itertools.product((np.float64, np.float32), ("xy", "best_fit"), (False, True)):
            points = flat(np.repeat(cloud(5, 20, 3, dtype), 5, axis=0))
            points[:, 2] += np.arange(100) % 5
            points[7, 2] = np.nan
            more = {}
            if plane == "best_fit":  # places of several points have one place in the plane if they are the same
                points[:, :] = points[np.arange(100) // 5 * 5]
            if others:
                source = cloud(7, 4, 3, dtype)
                more = {"source_points": source, "lines": [[0, 1], [2, 3]], "crossings": "split"}
            made = delaunay(points, duplicates="mean_z", plane=plane, **more)
            z = np.concatenate([points[:, 2], source[:, 2]]) if others else points[:, 2]
            vertices = np.unique(made.point_status[made.point_status >= 0])
            places = made.plane_points[vertices, :2]
            np.testing.assert_array_equal(made.interpolate(z, places), made.points[vertices, 2])
            np.testing.assert_array_equal(made.interpolate(z), made.points[:, 2])
            both = np.column_stack([z, 2 * z + 1j])
            found = made.interpolate(both, places)
            np.testing.assert_array_equal(found[:, 0], made.points[vertices, 2])
            own = vertices[vertices < len(z)]
            np.testing.assert_array_equal(found[vertices < len(z), 1], (2 * z + 1j)[own])
        few = np.array([(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 1), (1, 1, 1), (1, 1, 2)], np.float32)
        made = delaunay(few, duplicates="mean_z")
        self.assertEqual(made.points[3, 2], 4 / 3)  # not rounded to float32
        self.assertEqual(made.interpolate(few[:, 2], [1, 1]), 4 / 3)
        numbered = np.column_stack([few[:, :2], np.arange(6)])  # z are ids
        nearest = NearestInterpolator(delaunay(numbered, duplicates="mean_z"), list("abcdef"))
        self.assertEqual(nearest(1, 1), "d")
        bounded = delaunay(few, duplicates="mean_z", bounding=True)
        found = bounded.interpolate(few[:, 2])
        np.testing.assert_array_equal(found[:6], bounded.points[:6, 2])
        self.assertTrue(np.isnan(found[6:]).all())

    def test_other_values_are_no_work_for_all_points(self):
        points = np.repeat(cloud(5, 10000, 3), 2, axis=0)
        made, z, others = delaunay(points, duplicates="mean_z"), points[:, 2].copy(), np.arange(20000.0)
        expected = made.interpolate(others, [0.5, 0.5])
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        self.assertEqual(made.interpolate(others, [0.5, 0.5]), expected)
        self.assertLess(tracemalloc.get_traced_memory()[1], 8 * 20000)
        points += 1  # nor are these read again
        self.assertEqual(made.interpolate(others, [0.5, 0.5]), expected)
        self.assertRaisesRegex(RuntimeError, "points were changed", made.interpolate, z, [0.5, 0.5])

    def test_most_are_stacked_or_on_one_line(self):
        for share, stacked in ((0.0, 0), (0.3, 0), (0.8, 1), (1.0, 1)):
            points = cloud(8, 100, 3)
            many = int(share * 50)
            points[50 : 50 + many, :2] = points[:many, :2]
            self.assertEqual(delaunay(points).counts["stacked"], stacked, share)
        for bend, on_line in ((0.0, 1), (0.5, 0)):
            points = np.arange(30.0)[:, None] * [[1.0, 2.0, 3.0]]
            points[11, 2] += bend
            made = delaunay(points)
            self.assertEqual((len(made.triangles), made.counts["on_one_line"]), (0, on_line), bend)


if __name__ == "__main__":
    unittest.main()
