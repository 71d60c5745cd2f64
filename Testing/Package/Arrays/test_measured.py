# SPDX-License-Identifier: BSD-3-Clause
"""Neighbours, areas, lengths and circumcentres of a triangulation, by their definitions."""

import math
import pickle
import unittest
import warnings
from fractions import Fraction

import numpy as np

from adaptivehilbertdelaunay import Adjacency, delaunay
from arraysupport import SQUARE, cloud, lattice

INPUTS = (
    {"points": SQUARE},
    {"points": np.concatenate((cloud(3, 60), cloud(3, 60)[:9], [[np.nan, 0]])), "id_dtype": np.int64},
    {"points": lattice(5), "loops": [[0, 4, 24, 20], [6, 8, 18, 16]]},
    {"points": cloud(4, 80), "alpha": 0.1},
    {"points": SQUARE[:2]},
    {"points": cloud(5, 20), "segments": [[0, 1], [2, 3], [4, 5]], "crossings": "split"},
    {"points": cloud(6, 30, 3) * 9, "plane": "best_fit", "bounding": False},
)


def made_of(given):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return delaunay(**given)


class MeasuredTest(unittest.TestCase):
    def test_lists(self):
        for given in INPUTS:
            made = made_of(given)
            edges = [set(edge) for edge in made.edges.tolist()]
            for lists, wanted in (
                (made.vertex_neighbors, lambda i: sorted(j for edge in edges if i in edge for j in edge - {i})),
                (made.vertex_triangles, lambda i: np.flatnonzero((made.triangles == i).any(axis=1)).tolist()),
            ):
                self.assertIsInstance(lists, Adjacency)
                self.assertEqual({array.dtype for array in lists}, {np.dtype(given.get("id_dtype", np.int32))})
                self.assertEqual(len(lists.offsets), len(made.points) + 1)
                for i, (begin, end) in enumerate(zip(lists.offsets, lists.offsets[1:])):
                    self.assertEqual(lists.items[begin:end].tolist(), wanted(i))

    def test_sizes(self):
        for given in INPUTS:
            made = made_of(given)
            exact = [[Fraction(number) for number in place[:2]] if place[0] == place[0] else None
                     for place in made.plane_points.tolist()]  # fmt: skip
            for row, corners in enumerate(made.triangles):
                a, b, c = (exact[corner] for corner in corners)
                area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
                self.assertAlmostEqual(made.areas[row], float(area), delta=1e-14 * float(area))
                centre = made.circumcenters[row]
                radii = np.hypot(*(made.plane_points[corners, :2] - centre).T)
                self.assertLess(np.ptp(radii), 1e-9 * radii[0])
            lengths = [np.hypot(*(made.plane_points[i] - made.plane_points[j])[:2]) for i, j in made.edges]
            np.testing.assert_allclose(made.edge_lengths, np.array(lengths), rtol=1e-15)
            self.assertEqual(made.areas.shape + made.circumcenters.shape, (len(made.triangles),) * 2 + (2,))

    def test_areas_of_slivers(self):
        """Their error is a rounding of the product of two edges."""
        made = delaunay(lattice(12) @ [[0.8, 0.6], [-0.6, 0.8]] / 7)
        corners = made.plane_points[made.triangles, :2]
        self.assertLess(made.areas.min(), 1e-15)
        for (a, b, c), area in zip(corners.tolist(), made.areas):
            (ax, ay), (bx, by), (cx, cy) = (map(Fraction, place) for place in (a, b, c))
            exact = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
            self.assertGreater(exact, 0)
            edges = math.hypot(bx - ax, by - ay) * math.hypot(cx - ax, cy - ay)
            self.assertLess(abs(area - float(exact)), 4e-16 * edges)

    def test_they_are_kept_and_pickled(self):
        made = delaunay(SQUARE)
        self.assertIs(made.vertex_neighbors, made.vertex_neighbors)
        again = pickle.loads(pickle.dumps(made))
        for name in ("vertex_neighbors", "vertex_triangles"):
            for array, other in zip(getattr(made, name), getattr(again, name)):
                np.testing.assert_array_equal(array, other)
                self.assertFalse(array.flags.writeable or other.flags.writeable)
        self.assertFalse(again.areas.flags.writeable)


if __name__ == "__main__":
    unittest.main()
