# SPDX-License-Identifier: BSD-3-Clause
"""mesh.adaptive.delaunay_2d(maximum_error=...): the points of the triangles, and what they carry."""

import unittest
import warnings

import numpy
import pyvista

import adaptivehilbertdelaunay.pyvista  # noqa: F401 (registers mesh.adaptive)
from adaptivehilbertdelaunay import DelaunayWarning, delaunay

BOUND = 0.5


def hills(count=4000):
    places = numpy.random.default_rng(3).random((count, 2)) * 1000
    mesh = pyvista.PolyData(numpy.c_[places, 50 * numpy.sin(places[:, 0] / 160) * numpy.cos(places[:, 1] / 180)])
    mesh["Number"] = numpy.arange(count)
    mesh["Name"] = ["n%d" % i for i in range(count)]
    mesh["Flow"] = mesh.points
    mesh["OriginalPointIds"] = numpy.zeros(count)  # in the way
    return mesh


class SimplifiedTest(unittest.TestCase):
    def test_its_points_are_those_of_its_triangles(self):
        mesh = hills()
        light = mesh.adaptive.delaunay_2d(maximum_error=BOUND, arrays=["regions", "neighbors"])
        made = delaunay(mesh.points, maximum_error=BOUND)
        ids = light["OriginalPointIds"]
        self.assertTrue(numpy.array_equal(ids[light.faces.reshape(-1, 4)[:, 1:]], made.triangles))
        self.assertTrue(numpy.array_equal(numpy.sort(made.point_of_vertex), ids))
        self.assertLess(light.n_points, mesh.n_points / 4)
        for name, array in (("Number", ids), ("Name", ["n%d" % i for i in ids]), ("Flow", mesh.points[ids])):
            self.assertTrue(numpy.array_equal(light.point_data[name], array), name)
        self.assertTrue(numpy.array_equal(light.points, mesh.points[ids]))
        self.assertTrue(numpy.array_equal(light.cell_data["Neighbors"], made.neighbors))
        self.assertEqual(light["LargestError"][0], made.measures["largest_error"])
        self.assertEqual((mesh.n_points, mesh["OriginalPointIds"].max()), (4000, 0))

    def test_all_points_on_request(self):
        mesh = hills()
        whole = mesh.adaptive.delaunay_2d(maximum_error=BOUND, arrays="status")
        self.assertEqual(whole.n_points, mesh.n_points)
        light = mesh.adaptive.delaunay_2d(maximum_error=BOUND)
        self.assertEqual((whole["Fate"] == -3).sum(), mesh.n_points - light.n_points)
        self.assertEqual(light.n_cells, whole.n_cells)
        errors = mesh.adaptive.delaunay_2d(maximum_error=BOUND, arrays="errors")
        self.assertEqual(errors["Error"].max(), errors["LargestError"][0])
        self.assertEqual(errors.n_points, mesh.n_points)

    def test_arrays_by_name(self):
        mesh = hills()
        mesh["Height"] = mesh.points[:, 2].astype(float)
        mesh["Weight"] = numpy.where(mesh.points[:, 0] < 500, 1, 4)
        mesh["Keep"] = numpy.arange(4000) % 40 == 0
        names = dict(values="Height", weights="Weight", keep="Keep")
        flat = mesh.copy()
        flat.points[:, 2] = 0
        light = flat.adaptive.delaunay_2d(maximum_error=BOUND, **names)
        made = delaunay(mesh.points).simplify(BOUND, weights=mesh["Weight"], keep=mesh["Keep"])
        ids = light["OriginalPointIds"]
        self.assertTrue(numpy.array_equal(ids[light.faces.reshape(-1, 4)[:, 1:]], made.triangles))
        self.assertEqual(set(range(0, 4000, 40)) - set(ids.tolist()), set())
        for argument in names:
            with self.assertRaisesRegex(ValueError, argument + ": the points have no array 'Depth'"):
                mesh.adaptive.delaunay_2d(maximum_error=BOUND, **{argument: "Depth"})
            with self.assertRaisesRegex(TypeError, argument + " must be the name"):
                mesh.adaptive.delaunay_2d(maximum_error=BOUND, **{argument: 7})

    def test_vertices_passes_and_constraints(self):
        mesh = hills()
        few = mesh.adaptive.delaunay_2d(maximum_vertices=100)
        self.assertTrue(90 <= few.n_points <= 100)
        once, twice = (mesh.adaptive.delaunay_2d(maximum_error=BOUND, second_pass=again) for again in (False, True))
        self.assertLess(twice.n_points, once.n_points)
        ring = pyvista.PolyData([(300.0, 300, 0), (700, 300, 0), (500, 700, 0)], faces=[3, 0, 1, 2])
        inside = mesh.adaptive.delaunay_2d(maximum_error=BOUND, constraints=ring, heights="surface")
        self.assertEqual(set(range(4000, 4003)) - set(inside["OriginalPointIds"].tolist()), set())
        inside.points[:, 2] = 0
        self.assertAlmostEqual(inside.area, 80000, places=2)

    def test_in_place_and_refused(self):
        mesh = hills()
        light = mesh.adaptive.delaunay_2d(maximum_error=BOUND)
        mesh.adaptive.delaunay_2d(maximum_error=BOUND, inplace=True)
        self.assertTrue(numpy.array_equal(mesh.faces, light.faces))
        for more, words in (({"alpha": 5.0}, "`alpha`"), ({"duplicates": "mean_z"}, "duplicates='mean_z'")):
            with self.assertRaisesRegex(ValueError, words + " exclude each other"):
                hills().adaptive.delaunay_2d(maximum_vertices=9, **more)
        two = pyvista.PolyData([(0.0, 0, 0), (1, 1, 0)])
        with warnings.catch_warnings():  # unittest's assertWarns loads all of PyVista
            warnings.simplefilter("ignore", DelaunayWarning)
            self.assertEqual(two.adaptive.delaunay_2d(maximum_error=1.0).n_points, 2)


if __name__ == "__main__":
    unittest.main()
