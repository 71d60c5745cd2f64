# SPDX-License-Identifier: BSD-3-Clause
"""mesh.adaptive.to_raster and mesh.adaptive.sample, with whichever VTK PyVista uses."""

import contextlib
import inspect
import math
import pathlib
import re
import sys
import textwrap
import unittest
import warnings

import numpy
import pyvista

from adaptivehilbertdelaunay import DelaunayWarning

if not hasattr(pyvista, "register_dataset_accessor") or "found" not in sys.argv:
    import adaptivehilbertdelaunay.pyvista  # noqa: F401 (with "found" PyVista finds it by its entry point)

README = pathlib.Path(__file__).resolve().parents[3] / "Filters" / "Python" / "README.md"
SLOPE = (0.5, -0.25, 3.0)  # of x, of y, at the origin


def heights_at(x, y):
    return SLOPE[0] * x + SLOPE[1] * y + SLOPE[2]


def slope(count=400, side=100.0):
    """Scattered points of a plane, with the corners of a square."""
    xy = numpy.random.default_rng(5).random((count, 2)) * side
    xy = numpy.r_[xy, [(0, 0), (side, 0), (side, side), (0, side)]]
    mesh = pyvista.PolyData(numpy.c_[xy, heights_at(*xy.T)])
    mesh["twice"] = 2.0 * mesh.points[:, 2]
    return mesh


class Case(unittest.TestCase):
    @contextlib.contextmanager
    def warns(self, pattern):
        """One warning, attributed to the test's line."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            yield
        caught = [w for w in caught if w.category is DelaunayWarning]
        self.assertEqual(len(caught), 1, [str(w.message) for w in caught])
        self.assertRegex(str(caught[0].message), pattern)
        self.assertEqual(caught[0].filename, __file__)

    def assert_heights(self, mesh, places=None):
        points = mesh.points if places is None else places
        numpy.testing.assert_allclose(mesh["Elevation"], heights_at(points[:, 0], points[:, 1]), rtol=0, atol=1e-5)


class RasterTest(Case):
    def test_cells_of_a_size(self):
        made = slope().adaptive.to_raster(2.5)
        self.assertIsInstance(made, pyvista.ImageData)
        self.assertEqual((made.dimensions, made.spacing), ((40, 40, 1), (2.5, 2.5, 1.0)))
        self.assertEqual(made.origin, (1.25, 1.25, 0.0))  # the centre of the first cell
        self.assertEqual(set(made.point_data.keys()), {"Elevation", "twice", "vtkValidPointMask"})
        self.assertEqual(made.field_data.keys(), [])
        self.assert_heights(made)
        numpy.testing.assert_allclose(made["twice"], 2 * made["Elevation"], rtol=1e-6)
        self.assertTrue((made["vtkValidPointMask"] == 1).all())

    def test_rows_and_columns(self):
        made = slope().adaptive.to_raster(shape=(20, 50), bounds=(0, 100, 20, 60))
        self.assertEqual((made.dimensions, made.spacing[:2], made.origin), ((50, 20, 1), (2.0, 2.0), (1.0, 21.0, 0.0)))
        rows = made["Elevation"].reshape(20, 50)
        self.assertAlmostEqual(rows[0, 0], heights_at(1.0, 21.0), places=5)
        self.assertAlmostEqual(rows[1, 0] - rows[0, 0], 2.0 * SLOPE[1], places=5)

    def test_bounds_of_a_mesh_and_alignment(self):
        other = pyvista.PolyData(numpy.array([(11.0, 21.0, 0.0), (28.9, 39.9, 7.0)]))
        made = slope().adaptive.to_raster((3, 4), bounds=other.bounds, align=True)
        self.assertEqual((made.dimensions, made.spacing[:2]), ((7, 5, 1), (3.0, 4.0)))
        self.assertEqual(made.origin, (10.5, 22.0, 0.0))

    def test_the_order_of_bounds(self):
        """That of shapely and rasterio is refused where the points tell; what has an area is taken."""
        mesh = slope()
        with self.assertRaisesRegex(ValueError, "xmin, ymin, xmax, ymax, as in shapely"):
            mesh.adaptive.to_raster(2.5, bounds=(20, 10, 60, 50))
        far = mesh.translate((0, 5e6, 0), inplace=False)
        with self.assertRaisesRegex(ValueError, "xmin, ymin, xmax, ymax, as in shapely"):
            far.adaptive.to_raster(5e4, bounds=(10, 5000010, 60, 5000050))
        area = {"type": "MultiPoint", "coordinates": [(0, 20), (100, 60)]}
        made = mesh.adaptive.to_raster(shape=(20, 50), bounds=area)
        self.assertEqual(made.origin, (1.0, 21.0, 0.0))

    def test_methods(self):
        for method in ("linear", "natural", "laplace"):
            self.assert_heights(slope().adaptive.to_raster(5.0, method=method))
        nearest = slope().adaptive.to_raster(5.0, method="nearest")
        self.assertTrue(numpy.isin(nearest["Elevation"].astype(numpy.float32),
                                   slope().points[:, 2].astype(numpy.float32)).all())

    def test_outside(self):
        bounds = (-50, 150, 0, 100)
        made = slope().adaptive.to_raster(5.0, bounds=bounds)
        mask = made["vtkValidPointMask"] == 1
        self.assertEqual(mask.sum(), 20 * 20)
        self.assertTrue(numpy.array_equal(mask, numpy.isfinite(made["Elevation"])))
        self.assertTrue((slope().adaptive.to_raster(5.0, bounds=bounds, no_value=-9.0)["Elevation"][~mask] == -9).all())
        filled = slope().adaptive.to_raster(5.0, bounds=bounds, outside="nearest")
        self.assertTrue(numpy.isfinite(filled["Elevation"]).all())
        self.assertTrue(numpy.array_equal(filled["vtkValidPointMask"] == 1, mask))
        along = slope().adaptive.to_raster(5.0, bounds=bounds, outside="boundary")
        rows = along["Elevation"].reshape(20, 40)
        self.assertTrue((rows[:, :10] == rows[:, :1]).all() and (rows[:, 30:] == rows[:, -1:]).all())
        with self.warns("surface"):
            slope().adaptive.to_raster(5.0, bounds=(200, 300, 0, 100))

    def test_gradients_and_names(self):
        made = slope().adaptive.to_raster(5.0, gradients=True, elevation="z")
        self.assertEqual(set(made.point_data.keys()), {"z", "twice", "zGradient", "twiceGradient", "vtkValidPointMask"})
        numpy.testing.assert_allclose(made["zGradient"], numpy.tile(SLOPE[:2], (400, 1)), atol=1e-4)

    def test_a_surface_of_heights(self):
        made = slope().adaptive.to_raster(5.0, surface=True, bounds=(-50, 100, 0, 100))
        self.assertIsInstance(made, pyvista.StructuredGrid)
        self.assertEqual(made.dimensions, (30, 20, 1))
        seen = made["vtkValidPointMask"] == 1
        numpy.testing.assert_allclose(made.points[seen, 2], made["Elevation"][seen], rtol=1e-6)
        self.assertTrue(((made["vtkGhostType"] & 2 > 0) == ~seen).all())

    def test_constraints(self):
        """No value in a hole, nor beyond an outline."""
        ring = [(20, 20, 0), (60, 20, 0), (60, 60, 0), (20, 60, 0)]
        pond = pyvista.PolyData(numpy.array(ring, float), faces=[4, 0, 1, 2, 3])
        made = slope().adaptive.to_raster(4.0, constraints=pond, heights="surface")
        inside = numpy.isfinite(made["Elevation"])
        expected = ((made.points[:, :2] > 20) & (made.points[:, :2] < 60)).all(1)
        self.assertTrue(numpy.array_equal(inside, expected))
        with self.assertRaisesRegex(ValueError, "give one of them"):
            slope().adaptive.to_raster(4.0, constraints=pond, edge_source=pond)

    def test_edges_that_are_too_long(self):
        """There is no value between two parts."""
        mesh = slope(4000)
        mesh = pyvista.PolyData(mesh.points[(mesh.points[:, 0] < 40) | (mesh.points[:, 0] > 60)])
        made = mesh.adaptive.to_raster(2.0, bounds=(0, 100, 0, 100), maximum_edge_length=15.0)
        middle = (made.points[:, 0] > 41) & (made.points[:, 0] < 59)
        self.assertFalse(numpy.isfinite(made["Elevation"][middle]).any())
        self.assertGreater(numpy.isfinite(made["Elevation"]).mean(), 0.7)

    def test_other_meshes(self):
        grid = pyvista.StructuredGrid(*numpy.meshgrid([0., 1, 2, 3], [0., 1, 2, 3, 4], [0.0], indexing="ij"))
        self.assertEqual(grid.adaptive.to_raster(0.5).dimensions, (6, 8, 1))
        both = pyvista.MultiBlock([slope(), pyvista.PolyData(slope().points + (100, 0, 50))])
        self.assert_heights(both.adaptive.to_raster(10.0))
        with self.assertRaisesRegex(TypeError, "points of its own"):
            pyvista.ImageData(dimensions=(4, 5, 1)).adaptive.to_raster(1.0)

    def test_arguments_that_are_none(self):
        no_size = "the raster needs a size: give cell_size, or shape=(rows, columns)"
        sizes = "cell_size must be one number or two numbers, x and y"
        positive = "cell_size must be greater than 0 and finite"
        two = "shape must be two whole numbers, rows and columns"
        each = "shape must be rows and columns, each from 1 to 2147483647"
        area = "bounds must have an area,"
        four, ascending = "bounds must be four numbers: xmin, xmax, ymin, ymax;", (
            "bounds must be xmin, xmax, ymin, ymax, finite and ascending,")
        for kind, text, more in (
                (ValueError, no_size, {}), (ValueError, no_size, {"cell_size": 1.0, "shape": (2, 2)}),
                (ValueError, positive + ", not 0.0", {"cell_size": 0.0}),
                (ValueError, positive + ", not nan", {"cell_size": math.nan}),
                (TypeError, sizes + ", not (1, 2, 3)", {"cell_size": (1, 2, 3)}),
                (TypeError, sizes + ", not '5'", {"cell_size": "5"}),
                (TypeError, sizes + ", not 1j", {"cell_size": 1j}),
                (ValueError, each + ", not (0, 3)", {"shape": (0, 3)}),
                (ValueError, each + ", not (1099511627776, 1)", {"shape": (2**40, 1)}),
                (TypeError, two + ", not 5", {"shape": 5}), (TypeError, two + ", not (2,)", {"shape": (2,)}),
                (TypeError, two + ", not ('a', 1)", {"shape": ("a", 1)}),
                (ValueError, "align needs cell_size, but shape is given",
                 {"shape": (2, 2), "align": True}),
                (TypeError, four + " not (0, 1, 2)", {"cell_size": 1.0, "bounds": (0, 1, 2)}),
                (TypeError, four + " not 5", {"cell_size": 1.0, "bounds": 5}),
                (TypeError, four + " not 'abcd'", {"cell_size": 1.0, "bounds": "abcd"}),
                (ValueError, ascending + " not (1, 0, 0, 1)", {"cell_size": 1.0, "bounds": (1, 0, 0, 1)}),
                (ValueError, area + " not (1, 1, 0, 1)", {"cell_size": 1.0, "bounds": (1, 1, 0, 1)}),
                (ValueError, area + " not (0, 1, 1, 1)", {"cell_size": 1.0, "bounds": (0, 1, 1, 1)}),
                (ValueError, "method='cubic': it is one of 'linear', 'natural', 'laplace', 'nearest'",
                 {"cell_size": 1.0, "method": "cubic"}),
                (ValueError, "outside='far': it is one of 'none', 'nearest', 'boundary'",
                 {"cell_size": 1.0, "outside": "far"}),
                (TypeError, "elevation must be a name, a str, not None", {"cell_size": 1.0, "elevation": None}),
                (ValueError, "threads must be from 0 to 1024, not -1", {"cell_size": 1.0, "threads": -1}),
                (ValueError, "memory_limit must be from 0 to 9223372036854775807, not -1",
                 {"cell_size": 1.0, "memory_limit": -1}),
                (TypeError, "to_raster() got an unexpected keyword argument 'unknown'",
                 {"cell_size": 1.0, "unknown": 1})):
            with self.assertRaises(kind, msg=more) as caught:
                slope().adaptive.to_raster(**more)
            self.assertEqual(str(caught.exception), text)
        with self.assertRaisesRegex(MemoryError, r"^Interpolating at .* places from 2004 points may take"):
            slope(2000).adaptive.to_raster(1e-4)
        refused = r"but memory_limit allows 4.09 KB\. .* set memory_limit to [0-9]+ or more \(bytes\)"
        with self.assertRaisesRegex(MemoryError, refused):
            slope().adaptive.to_raster(1.0, memory_limit=4096)


class SampleTest(Case):
    def test_places_that_are_none(self):
        mesh, places = slope(), numpy.array([[10.0, 20.0], [30.0, 40.0]])
        self.assertEqual(mesh.adaptive.sample([]).n_points, 0)
        self.assertEqual(mesh.adaptive.sample(numpy.ma.array(places)).n_points, 2)
        with self.assertRaisesRegex(TypeError, "masked array"):
            mesh.adaptive.sample(numpy.ma.masked_less(places, 15))
        with self.assertRaisesRegex(TypeError, "MultiBlock"):
            mesh.adaptive.sample(pyvista.MultiBlock([mesh]))
        with self.assertRaisesRegex(TypeError, "real numbers"):
            mesh.adaptive.sample([[1j, 0]])

    def test_along_a_line(self):
        line = pyvista.Line((0, 0, 500), (100, 100, 500), resolution=50)
        line["own"] = numpy.arange(51.0)
        made = slope().adaptive.sample(line)
        self.assertIsInstance(made, pyvista.PolyData)
        self.assertEqual((made.n_lines, made.n_points), (1, 51))
        self.assert_heights(made, line.points)
        self.assertTrue(numpy.array_equal(made["own"], line["own"]))
        self.assertTrue(numpy.array_equal(made.points, line.points))
        self.assertNotIn("Elevation", line.point_data)

    def test_at_places(self):
        places = numpy.array([(10.0, 10.0), (50.0, 75.5), (1000.0, 0.0)])
        made = slope().adaptive.sample(places, method="natural")
        self.assertEqual(list(made["vtkValidPointMask"]), [1, 1, 0])
        numpy.testing.assert_allclose(made["Elevation"], [*heights_at(*places[:2].T), math.nan], atol=1e-5)
        self.assertEqual(slope().adaptive.sample((10, 10)).n_points, 1)
        with self.assertRaisesRegex(ValueError, "of shape"):
            slope().adaptive.sample(numpy.zeros((3, 4)))

    def test_a_grid(self):
        grid = pyvista.ImageData(dimensions=(11, 11, 1), spacing=(10, 10, 1))
        made = slope().adaptive.sample(grid)
        self.assertIsInstance(made, pyvista.ImageData)
        self.assert_heights(made)

    def test_warnings(self):
        mesh = slope()
        mesh["words"] = ["a"] * mesh.n_points
        with self.warns("words"):
            self.assert_heights(mesh.adaptive.sample(slope(20)), slope(20).points)
        with self.warns("1 of 2"):
            mesh = slope()
            mesh.adaptive.sample(numpy.array([(1.0, 1.0), (math.nan, 1.0)]))


class ReadmeTest(unittest.TestCase):
    def test_what_it_shows_runs(self):
        """Without a warning: what PyVista deprecates, its next version refuses."""
        text = README.read_text(encoding="utf-8").partition("## PyVista: mesh.adaptive")[2]
        shown = re.search(r"(?m)^( {4}import pyvista.*\n(?:(?: {4}.*)?\n)+)", text).group(1)
        self.assertIn("pyvista.Line(", shown)
        mesh = slope()
        coastline = pyvista.PolyData(mesh.points[:3], lines=[3, 0, 1, 2])
        shore = pyvista.PolyData([(10.0, 10, 0), (90, 10, 0), (90, 90, 0), (10, 90, 0)], faces=[4, 0, 1, 2, 3])
        names = dict(mesh=mesh, coastline=coastline, shore=shore, start=(1, 1, 0), end=(99, 99, 0))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            exec(compile(textwrap.dedent(shown), str(README), "exec"), names)
        self.assertEqual(names["profile"].n_points, 501)


class FoundTest(unittest.TestCase):
    def test_it_is_shown(self):
        run = pyvista.PolyData(numpy.eye(3)).adaptive
        self.assertIn("pixel is area", inspect.getdoc(run.to_raster))
        names = list(inspect.signature(run.to_raster).parameters)
        self.assertEqual(names[:4], ["cell_size", "shape", "bounds", "align"])
        self.assertEqual(next(iter(inspect.signature(run.sample).parameters)), "places")


if __name__ == "__main__":
    outcome = unittest.main(argv=sys.argv[:1], exit=False).result
    sys.exit(not outcome.wasSuccessful())
