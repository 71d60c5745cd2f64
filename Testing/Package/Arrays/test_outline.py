# SPDX-License-Identifier: BSD-3-Clause
"""Triangulation.outline(): its edges are those of `boundary`, its areas those of the triangles."""

import copy
import pickle
import unittest

import numpy as np
from adaptivehilbertdelaunay import delaunay
from arraysupport import cloud, integers, lattice, twice_area


def area(places):
    """Twice the area of a ring; exact for whole numbers."""
    return twice_area(places, [(0, k, k + 1) for k in range(1, len(places) - 1)])


class OutlineTest(unittest.TestCase):
    def expect_outline(self, made):
        outline, edges = made.outline(), set()
        places = integers(made.points[:, :2])
        total = 0
        for i in range(len(outline)):
            for r in range(outline.polygons[i], outline.polygons[i + 1]):
                ring = outline.corners[outline.rings[r]:outline.rings[r + 1]].tolist()
                self.assertEqual(len(set(ring)), len(ring))
                self.assertEqual(places[ring[0]], min(places[k] for k in ring))
                signed = area([places[k] for k in ring])
                self.assertEqual(signed > 0, r == outline.polygons[i])
                total += signed
                edges.update(zip(ring, ring[1:] + ring[:1]))
        self.assertEqual(edges, {tuple(edge) for edge in made.boundary.tolist()})
        self.assertEqual(total, twice_area(places, made.triangles.tolist()))
        return outline

    def test_alpha_shapes_and_hulls(self):
        for seed in range(6):
            points = np.round(cloud(seed, 300) * 50)
            for settings in ({}, {"alpha": 3.0}, {"alpha": 2.0}, {"maximum_edge_length": 4.5}, {"rim": "trimmed"}):
                self.expect_outline(delaunay(points, **settings))
        self.assertEqual(len(delaunay(lattice(5)).outline()), 1)

    def test_loops(self):
        field = np.array([(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6), (4, 4), (5, 4), (5, 5)])
        made = delaunay(field, loops=[[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10]])
        outline = self.expect_outline(made)
        self.assertEqual([len(polygon) for polygon in outline], [2, 1])
        self.assertEqual(outline[-1][0].tolist(), [[4, 4], [5, 4], [5, 5]])
        geo = outline.__geo_interface__
        self.assertEqual(geo["type"], "MultiPolygon")
        self.assertEqual(geo["coordinates"][1], [[(4, 4), (5, 4), (5, 5), (4, 4)]])
        self.assertEqual(geo["coordinates"][0][1], [(3, 3), (3, 6), (6, 6), (6, 3), (3, 3)])
        with self.assertRaises(IndexError):
            outline[2]

    def test_in_a_plane(self):
        """Of a wall with a window, in space."""
        wall = np.array([(0, 5, 0), (9, 5, 0), (9, 5, 9), (0, 5, 9), (3, 5, 3), (6, 5, 3), (6, 5, 6), (3, 5, 6)], float)
        outline = delaunay(wall, plane="best_fit", loops=[[0, 1, 2, 3], [4, 5, 6, 7]]).outline()
        self.assertEqual([len(ring) for ring in outline[0]], [4, 4])
        self.assertEqual({tuple(p) for p in outline[0][1]}, {tuple(p) for p in wall[4:]})

    def test_nothing(self):
        made = delaunay(cloud(3, 50), alpha=1e-9)
        self.assertEqual((len(made.outline()), list(made.outline())), (0, []))
        self.assertEqual(made.outline().__geo_interface__, {"type": "MultiPolygon", "coordinates": []})

    def test_it_is_kept_copied_and_refused(self):
        points = cloud(4, 500)
        made = delaunay(points, id_dtype=np.int64)
        outline = made.outline()
        self.assertIs(made.outline(), outline)
        self.assertEqual(outline.corners.dtype, np.int64)
        self.assertFalse(outline.corners.flags.writeable)
        for other in (pickle.loads(pickle.dumps(made)), copy.deepcopy(made)):
            np.testing.assert_array_equal(other.outline().corners, outline.corners)
        made = delaunay(points)
        points[7] += 1
        with self.assertRaisesRegex(RuntimeError, "changed"):
            made.outline()


if __name__ == "__main__":
    unittest.main()
