# SPDX-License-Identifier: BSD-3-Clause
"""mesh.adaptive.refine(): the mesh of NumPy's refine(), with what PyVista's meshes carry."""

import unittest

import numpy
import pyvista

import adaptivehilbertdelaunay.pyvista  # noqa: F401 (registers mesh.adaptive)
from adaptivehilbertdelaunay import delaunay


def mesh_of(points, **more):
    return pyvista.PolyData(numpy.array(points, float), **more)


def box(x, y, side):
    return [(x, y, 0), (x + side, y, 0), (x + side, y + side, 0), (x, y + side, 0)]


class RefinedTest(unittest.TestCase):
    def test_it_is_that_of_numpy(self):
        """The mesh of NumPy's refine()."""
        plate = box(0, 0, 10) + box(2, 2, 3)
        mesh = mesh_of(plate, faces=[4, 0, 1, 2, 3, 4, 4, 5, 6, 7])
        mesh.point_data["t"] = numpy.arange(8.0)
        sizes = [2.0] * 4 + [0.5] * 4
        xy = numpy.array(plate, float)[:, :2]
        numpys = delaunay(xy, loops=[[0, 1, 2, 3], [4, 5, 6, 7]]).refine(28, maximum_area=1.5, sizes=sizes)
        made, edges = mesh.adaptive.refine(28, max_area=1.5, size=sizes, edge_source=mesh, segments=True)
        self.assertTrue(numpy.array_equal(made.points[:, :2], numpys.points))
        self.assertTrue(numpy.array_equal(made.faces.reshape(-1, 4)[:, 1:], numpys.triangles))
        self.assertTrue(numpy.array_equal(made["t"], numpys.interpolate(numpy.arange(8.0))))
        self.assertTrue(numpy.array_equal(edges.lines.reshape(-1, 3)[:, 1:], numpys.edges))
        self.assertTrue(numpy.array_equal(edges["SourceCell"], numpys.markers[:, 0]))
        self.assertTrue(edges["IsBoundary"].all())
        self.assertEqual(sorted(made.array_names), ["BadReason", "OriginalPointIds", "RegionId", "sizes", "t"])
        self.assertNotIn("sizes", mesh.array_names)
        mesh.point_data["wished"] = sizes
        again = mesh.adaptive.refine(28, maximum_area=1.5, sizes="wished", edge_source=mesh)
        self.assertTrue(numpy.array_equal(again.points, made.points))
        fewer = mesh.adaptive.refine(28, maximum_area=0.1, maximum_added=10, edge_source=mesh)
        self.assertEqual((fewer.n_points, set(fewer["BadReason"])), (18, {-1, 1}))

    def test_a_geometry_and_memory(self):
        ring = {"type": "Polygon", "coordinates": [[p[:2] for p in box(0, 0, 10)]]}
        inside = mesh_of([(3, 3, 0), (4, 7, 0), (8, 2, 0)]).adaptive.refine(constraints=ring)
        self.assertAlmostEqual(inside.area, 100)
        with self.assertRaisesRegex(MemoryError, "memory_limit allows"):
            mesh_of(box(0, 0, 10)).adaptive.refine(memory_limit=2000)


if __name__ == "__main__":
    unittest.main()
