# SPDX-License-Identifier: BSD-3-Clause
"""mesh.adaptive: the filter for PyVista. With whichever VTK PyVista uses."""

import contextlib
import inspect
import io
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import numpy
import pyvista

from adaptivehilbertdelaunay import DelaunayWarning, _interface, _meshes

if not hasattr(pyvista, "register_dataset_accessor") or "found" not in sys.argv:
    import adaptivehilbertdelaunay.pyvista  # noqa: F401 (with "found" PyVista finds it by its entry point)

RUN = pyvista.PolyData(numpy.eye(3)).adaptive  # loads it


def accessor():
    return sys.modules["adaptivehilbertdelaunay.pyvista"]


def scattered(count, seed=3, height=0.0):
    numbers = numpy.random.default_rng(seed)
    return numpy.c_[numbers.random((count, 2)) * 1000, numbers.random(count) * height]


def mesh_of(points, **more):
    return pyvista.PolyData(numpy.array(points, float), **more)


def box(x, y, side):
    return [(x, y, 0), (x + side, y, 0), (x + side, y + side, 0), (x, y + side, 0)]


def faces_of(mesh):
    return mesh.faces.reshape(-1, 4)[:, 1:]


def area(mesh):
    """Signed, in x, y: all triangles are counterclockwise."""
    a, b, c = (mesh.points[faces_of(mesh)[:, k]].astype(float) for k in range(3))
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert (areas > 0).all()
    return areas.sum()


class DelaunayTest(unittest.TestCase):
    @contextlib.contextmanager
    def warns(self, pattern):
        """One warning, attributed to the test's line. (unittest's assertWarns loads all of PyVista.)"""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            yield
        caught = [w for w in caught if w.category is DelaunayWarning]  # VTK 9.5 warns of NumPy 2.5
        self.assertEqual(len(caught), 1)
        self.assertRegex(str(caught[0].message), pattern)
        self.assertEqual(caught[0].filename, __file__)

    def test_no_point_is_lost_and_the_hull_is_whole(self):
        """Of UTM coordinates with ties: PyVista's own loses points, or leaves notches."""
        lattice = numpy.array([(450000.25 * 1 + i % 40 * 0.25, 5.4e6 + i // 40 * 0.25, 0) for i in range(1600)])
        made = mesh_of(lattice).adaptive.delaunay_2d()
        self.assertEqual((made.n_cells, made.n_points), (2 * 39 * 39, 1600))
        self.assertEqual(len(numpy.unique(made.faces)), 1600)

    def test_nothing_is_merged_by_default(self):
        points = box(0, 0, 1000) + [(500, 400, 0), (500, 400.001, 0)]
        self.assertEqual(mesh_of(points).adaptive.delaunay_2d().n_cells, 6)
        self.assertEqual(mesh_of(points).adaptive.delaunay_2d(tol=1e-5).n_cells, 4)

    def test_arguments_are_those_of_pyvista_in_their_order(self):
        theirs = list(inspect.signature(pyvista.PolyData.delaunay_2d).parameters)
        ours = list(inspect.signature(accessor().Adaptive.delaunay_2d).parameters)
        self.assertEqual(ours[:len(theirs)], theirs)

    def test_points_and_data_are_carried_along(self):
        mesh = mesh_of(scattered(50))
        mesh["height"] = numpy.arange(50.0)
        made = mesh.adaptive.delaunay_2d()
        self.assertIsInstance(made, pyvista.PolyData)
        self.assertEqual(made.array_names, ["height"])
        self.assertTrue(numpy.array_equal(made.points, mesh.points))

    def test_outlines_run_either_way(self):
        """Whichever way loops run, what is inside an odd number of them is kept."""
        for outer in (1, -1):
            for inner in (1, -1):
                loops = [box(0, 0, 10)[::outer], box(2, 2, 3)[::inner]]
                mesh = mesh_of(loops[0] + loops[1], faces=[4, 0, 1, 2, 3, 4, 4, 5, 6, 7])
                self.assertAlmostEqual(area(mesh.adaptive.delaunay_2d(edge_source=mesh)), 100 - 9)

    def test_closed_lines_are_outlines(self):
        mesh = mesh_of(box(0, 0, 10) + box(2, 2, 3), lines=[5, 0, 1, 2, 3, 0, 5, 4, 5, 6, 7, 4])
        self.assertAlmostEqual(area(mesh.adaptive.delaunay_2d(edge_source=mesh)), 91)
        lines = mesh.adaptive.delaunay_2d(edge_source=mesh, closed_lines="lines")
        self.assertAlmostEqual(area(lines), 100)

    def test_an_outline_in_pieces(self):
        """As `extract_feature_edges` gives it; lines of which none is closed are no fault here."""
        mesh = mesh_of(box(0, 0, 10), lines=[2, 1, 0, 2, 1, 2, 2, 3, 2, 2, 3, 0])
        made = mesh_of(scattered(300) / 50).adaptive.delaunay_2d(constraints=mesh)
        self.assertAlmostEqual(area(made), 100)
        with warnings.catch_warnings():
            warnings.simplefilter("error", DelaunayWarning)
            mesh_of(scattered(300)).adaptive.delaunay_2d(constraints=mesh_of(box(300, 300, 10), lines=[3, 0, 1, 2]))

    def test_a_polygon_that_is_a_line_too(self):
        """PyVista's own example of a square with two holes."""
        square = pyvista.Polygon(n_sides=4, radius=8, fill=False).rotate_z(45)
        holes = [pyvista.Polygon(center=center, n_sides=30, radius=1) for center in ((2, 3, 0), (-2, -3, 0))]
        mesh = holes[0].append_polydata(holes[1], square)
        hole = 15 * numpy.sin(2 * numpy.pi / 30)
        self.assertAlmostEqual(area(mesh.adaptive.delaunay_2d(edge_source=mesh)), 128 - 2 * hole, 4)

    def test_points_as_line(self):
        shore = mesh_of(box(2, 2, 3) + box(2, 2, 3)[:1])
        points = mesh_of([(x, y, 0) for x in range(9) for y in range(9)])
        made = points.adaptive.delaunay_2d(constraints=shore, points_as_line=True)
        self.assertAlmostEqual(area(made), 9)
        made = points.adaptive.delaunay_2d(constraints=shore, points_as_line=True, closed_lines="lines")
        self.assertAlmostEqual(area(made), 64)

    def test_constraints_elsewhere(self):
        with self.warns("does not overlap.*x 2000 to 2010, y 0 to 10; points: x "):
            mesh_of(scattered(300)).adaptive.delaunay_2d(constraints=mesh_of(box(2000, 0, 10), faces=[4, 0, 1, 2, 3]))

    def test_constraints_without_heights(self):
        with self.warns("1 line or polygon of the source lies at z = 0.*SourceHeights.*ZeroIsMissing"):
            mesh_of(scattered(300) + (0, 0, 7)).adaptive.delaunay_2d(
                constraints=mesh_of(box(300, 300, 10), lines=[2, 0, 1]))

    def test_orientation(self):
        mesh = mesh_of(box(0, 0, 10) + box(2, 2, 3)[::-1], faces=[4, 0, 1, 2, 3, 4, 4, 5, 6, 7])
        made = mesh.adaptive.delaunay_2d(edge_source=mesh, fill_rule="orientation")
        self.assertAlmostEqual(area(made), 91)

    def test_constraints_with_points_of_their_own(self):
        ends = [(-50, 500.5, 0), (1050, 500.5, 0), (500.5, -50, 0), (500.5, 1050, 0)]
        lines = mesh_of(ends, lines=[2, 0, 1, 2, 2, 3])
        mesh = mesh_of(scattered(300))
        split = mesh.adaptive.delaunay_2d(constraints=lines, crossings="split", arrays=["regions", "constraint_edges"])
        self.assertEqual(split.n_points, 300 + 4 + 1)
        self.assertEqual(set(split["RegionId"]), {0, 1, 2, 3})
        with self.warns("1 of 2 segments of the source were left out"):
            left = mesh.adaptive.delaunay_2d(constraints=lines, arrays="regions")
        self.assertEqual(set(left["RegionId"]), {0, 1})
        self.assertIn("Crossings", left.field_data)

    def test_heights_of_the_surface(self):
        lines = mesh_of([(100, 100, 0), (900, 900, 0)], lines=[2, 0, 1])
        mesh = mesh_of(numpy.r_[scattered(300), box(0, 0, 1000)] + (0, 0, 7))
        made = mesh.adaptive.delaunay_2d(constraints=lines, heights="surface", plane="xy")
        self.assertGreater(made.n_points, 306, "points along the line")
        numpy.testing.assert_allclose(made.points[:, 2], 7, rtol=1e-15)

    def test_geometries(self):
        """As for arrays: with a z of their own, of the surface, or of a flat mesh."""
        xy = numpy.r_[scattered(300), box(0, 0, 1000)][:, :2]
        hill, flat = mesh_of(numpy.c_[xy, xy.sum(axis=1)]), mesh_of(numpy.c_[xy, numpy.full(len(xy), 7.0)])
        ring, hole = numpy.array(box(100, 100, 800)), numpy.array(box(300, 300, 200))[::-1]
        field = {"type": "Polygon", "coordinates": [ring[:, :2], hole[:, :2]]}
        line = {"type": "LineString", "coordinates": [(200, 200), (200, 800)]}
        for mesh, z in ((hill, lambda made: made.points[:, :2].sum(axis=1)), (flat, lambda made: 7)):
            for given in (field, [field, line], [ring[:, :2], hole[:, :2].tolist()]):
                made = mesh.adaptive.delaunay_2d(constraints=given)
                self.assertAlmostEqual(area(made), 600000, delta=1)
                self.assertLess(abs(made.points[:, 2] - z(made)).max(), 1e-9)
        dem = hill.adaptive.to_raster(100, constraints=field)
        self.assertEqual(dem["vtkValidPointMask"].sum(), 60)
        in_hole = hill.adaptive.sample([[400, 400, 0]], constraints=[ring, hole])
        self.assertTrue(numpy.isnan(in_hole["Elevation"][0]))
        ridge = {"type": "LineString", "coordinates": [(1, 1, 5), (9, 9, 6)]}
        self.assertEqual(hill.adaptive.delaunay_2d(constraints=ridge).points[-2:, 2].tolist(), [5, 6])
        made = hill.adaptive.delaunay_2d(constraints=[ridge, {"type": "Point", "coordinates": (500, 400)}])
        self.assertEqual(made.points[-3:, 2].round(9).tolist(), [5, 6, 900])
        self.assertEqual(hill.adaptive.delaunay_2d(constraints=[]).n_cells, hill.adaptive.delaunay_2d().n_cells)

    def test_alpha_and_lengths(self):
        mesh = mesh_of(scattered(500))
        whole, small = mesh.adaptive.delaunay_2d(), mesh.adaptive.delaunay_2d(alpha=40.0)
        self.assertTrue(0 < small.n_cells < whole.n_cells)
        self.assertEqual((small.n_lines, small.n_verts), (0, 0))
        short = mesh.adaptive.delaunay_2d(maximum_edge_length=60.0)
        corners = short.points[faces_of(short)]
        self.assertLessEqual(numpy.linalg.norm(corners - corners[:, [1, 2, 0]], axis=2).max(), 60.001)

    def test_planes(self):
        wall = mesh_of([(i % 8, 2 * (i % 8), i // 8) for i in range(40)])
        self.assertEqual(wall.adaptive.delaunay_2d(plane="best_fit").n_cells, 56)
        with self.warns("stand like a wall.*Set plane='best_fit' if that is meant, or plane='xy'"):
            self.assertEqual(wall.adaptive.delaunay_2d().n_cells, 56)
        with self.warns("collinear"):
            self.assertEqual(wall.adaptive.delaunay_2d(plane="xy").n_cells, 0)
        core = type(wall).__mro__[-3].__module__.split(".")[0]
        transforms = __import__(core + ".vtkCommonTransforms", fromlist=["vtkTransform"])
        turned = transforms.vtkTransform()
        turned.RotateX(90)
        made = wall.adaptive.delaunay_2d(plane=turned)
        self.assertGreaterEqual(made.n_cells, 56)

    def test_terrain_is_triangulated_in_x_and_y(self):
        """Whatever the units of x and y are, unlike in PyVista."""
        data = pathlib.Path(__file__).resolve().parents[3] / "Data"
        soundings = numpy.genfromtxt(data / "survey.csv", delimiter=",", skip_header=1) / (111000, 111000, 1)  # degrees
        trees = scattered(4000, height=20) * (1, 0.1, 1) + (0, 0, 5)
        corridor = scattered(2000)
        corridor[:, 1] /= 200
        corridor[:, 2] = 40 * numpy.sin(corridor[:, 0] / 100)
        slope = numpy.array([(i % 30, i // 30, i % 30) for i in range(900)], float)
        for name, points in (("soundings", soundings), ("trees", trees), ("corridor", corridor), ("slope", slope)):
            for unit in (1.0, 111000.0, 1 / 111000):
                mesh = mesh_of(points * (unit, unit, 1))
                with warnings.catch_warnings():
                    warnings.simplefilter("error", DelaunayWarning)
                    made = mesh.adaptive.delaunay_2d()
                self.assertTrue(numpy.array_equal(made.faces, mesh.adaptive.delaunay_2d(plane="xy").faces), name)
                box = numpy.prod(numpy.ptp(mesh.points[:, :2].astype(float), axis=0))
                self.assertLessEqual(area(made), box * (1 + 1e-6), name)
        with self.warns("steeper than 80 degrees.*ProjectionPlaneMode to XY Plane"):
            mesh_of(soundings).adaptive.delaunay_2d(plane="best_fit", rim="convex_hull")

    def test_walls_are_triangulated_in_their_plane(self):
        points = scattered(3000, height=400)
        points[:, 1] = 8 * numpy.sin(points[:, 0] / 40) + 6 * numpy.cos(points[:, 2] / 30)
        face = mesh_of(points)
        for run in (face.adaptive.delaunay_2d, face.adaptive.voronoi_2d):
            with self.warns("stand like a wall"):
                made = run()
            expected = run(plane="best_fit")
            self.assertTrue(numpy.array_equal(made.faces, expected.faces))
        halves = pyvista.MultiBlock([mesh_of(points[::2]), mesh_of(points[1::2])])
        with self.warns("stand like a wall"):
            self.assertEqual(halves.adaptive.delaunay_2d().n_cells, face.adaptive.delaunay_2d(plane="best_fit").n_cells)
        with self.warns("stand like a wall"):
            face.adaptive.to_raster(10.0, plane="automatic")
        lying = numpy.r_[points, scattered(3000)]
        hidden = mesh_of(lying)
        hidden["vtkGhostType"] = numpy.r_[numpy.zeros(3000, numpy.uint8), numpy.full(3000, 2, numpy.uint8)]
        with self.warns("stand like a wall"):
            hidden.adaptive.delaunay_2d()

    def test_a_volume_is_triangulated_in_x_and_y(self):
        layers = mesh_of([(i % 10, i // 10 % 10, i // 100) for i in range(1000)])
        with self.warns("lie above or below them.*for a volume mesh, triangulate one layer"):
            self.assertEqual(layers.adaptive.delaunay_2d().n_cells, 162)

    def test_flat_points_are_triangulated_in_x_and_y(self):
        """Exactly: a lattice far away from the origin, turned, would no longer be one."""
        lattice = mesh_of([(1e6 + 0.25 * (i % 30), 5e6 + 0.25 * (i // 30), 3) for i in range(900)])
        self.assertEqual(lattice.adaptive.delaunay_2d().n_cells, 2 * 29 * 29)
        self.assertTrue(numpy.array_equal(lattice.adaptive.delaunay_2d(rim="convex_hull").faces,
                                          lattice.adaptive.delaunay_2d(plane="xy").faces))

    def test_arrays(self):
        mesh = mesh_of(scattered(30).tolist() + [scattered(30)[4].tolist()])
        made = mesh.adaptive.delaunay_2d(arrays=("status", "rank", "neighbors", "regions", "constraint_edges"))
        self.assertEqual(set(made.point_data.keys()), {"Fate", "InsertionRank"})
        self.assertEqual(set(made.cell_data.keys()), {"Neighbors", "RegionId", "ConstraintEdges"})
        self.assertEqual(made["Fate"][30], 4)

    def test_duplicates(self):
        mesh = mesh_of(box(0, 0, 10) + [(5, 5, 1), (5, 5, 4)])
        for name, used, z in (("first", 4, 1), ("highest_z", 5, 4), ("lowest_z", 4, 1), ("mean_z", 4, 2.5)):
            made = mesh.adaptive.delaunay_2d(duplicates=name, plane="xy")
            self.assertIn(used, made.faces)
            self.assertEqual(made.points[used][2], z)

    def test_bounding_points(self):
        self.assertEqual(mesh_of(scattered(20)).adaptive.delaunay_2d(bound=True, offset=2.0).n_points, 28)

    def test_inplace(self):
        mesh = mesh_of(scattered(50))
        self.assertIs(mesh.adaptive.delaunay_2d(inplace=True), mesh)
        self.assertGreater(mesh.n_cells, 80)
        self.assertGreater(mesh.adaptive.delaunay_2d().n_cells, 80)

    def test_other_meshes(self):
        grid = pyvista.StructuredGrid(*numpy.meshgrid([0., 1, 2, 3], [0., 1, 2, 3, 4], [0.0], indexing="ij"))
        self.assertEqual(grid.adaptive.delaunay_2d().n_cells, 24)
        self.assertEqual(grid.cast_to_unstructured_grid().adaptive.delaunay_2d().n_cells, 24)
        image = pyvista.ImageData(dimensions=(4, 5, 1))
        with self.assertRaisesRegex(TypeError, "points of its own"):
            image.adaptive.delaunay_2d()
        both = pyvista.MultiBlock([mesh_of(box(0, 0, 1)), mesh_of(box(2, 2, 1))])
        self.assertEqual(both.adaptive.delaunay_2d(plane="xy").n_points, 8)

    def test_float_points_stay_floats(self):
        mesh = pyvista.PolyData(scattered(40).astype("float32"))
        self.assertEqual(mesh.adaptive.delaunay_2d().points.dtype, numpy.float32)

    def test_progress_bar(self):
        said = io.StringIO()
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            made = mesh_of(scattered(3000)).adaptive.delaunay_2d(progress_bar=True)
        self.assertGreater(made.n_cells, 5000)
        self.assertIn("Computing 2D Triangulation", said.getvalue())

    def test_warnings_and_errors(self):
        points = scattered(40)
        points[7, 0] = numpy.nan
        with self.warns("1 of 40 points were rejected.*first is point 7"):
            mesh_of(points).adaptive.delaunay_2d(plane="xy")
        with self.assertRaisesRegex(MemoryError, "40 points may take .* set memory_limit to [0-9]+ or more"):
            mesh_of(points).adaptive.delaunay_2d(memory_limit=4096)
        with warnings.catch_warnings():
            warnings.simplefilter("error", DelaunayWarning)
            mesh_of(scattered(40)).adaptive.delaunay_2d()

    def test_arguments_that_are_none(self):
        mesh = mesh_of(scattered(10))
        for more, text in (
                ({"plane": "x"}, "plane='x': it is one of 'xy', 'automatic', 'best_fit'"),
                ({"fill_rule": 1}, "fill_rule=1: it is one of 'orientation', 'even_odd'"),
                ({"closed_lines": "rings"}, "closed_lines='rings': it is one of 'lines', 'loops'"),
                ({"crossings": "cut"}, "crossings='cut': it is one of 'leave_out', 'split'"),
                ({"rim": ""}, "rim='': it is one of 'automatic', 'convex_hull', 'trimmed'"),
                ({"duplicates": "last"}, "duplicates='last': it is one of 'first', 'lowest_z', 'highest_z', 'mean_z'"),
                ({"heights": "zero"}, "heights='zero': it is one of 'own', 'surface', 'mixed'"),
                ({"arrays": ["fate"]}, "arrays: no 'fate'; there are 'status', 'errors', 'rank', "
                                       "'constraint_edges', 'regions', 'neighbors'"),
                ({"edge_source": mesh, "constraints": mesh},
                 "edge_source refers to the mesh's points, constraints have their own: give one of them"),
                ({"threads": 1025}, "threads must be from 0 to 1024, not 1025"),
                ({"memory_limit": -1}, "memory_limit must be from 0 to 9223372036854775807, not -1")):
            self.assertRefused(ValueError, text, mesh.adaptive.delaunay_2d, **more)
        self.assertRefused(ValueError, "clip='box': it is one of 'hull', 'bounds'", mesh.adaptive.voronoi_2d,
                           clip="box")
        self.assertRefused(TypeError, "threads must be a whole number, not 1.5", mesh.adaptive.delaunay_2d,
                           threads=1.5)
        self.assertRefused(TypeError, "inplace: a pyvista.PolyData can be overwritten, not UnstructuredGrid",
                           mesh.cast_to_unstructured_grid().adaptive.delaunay_2d, inplace=True)
        self.assertRefused(TypeError, "tol must be a number from 0 to 1, not 'much'", mesh.adaptive.delaunay_2d,
                           tol="much")

    def assertRefused(self, kind, text, call, **more):
        with self.assertRaises(kind, msg=more) as caught:
            call(**more)
        self.assertEqual(str(caught.exception), text)

    def test_threads_and_memory_in_words(self):
        """As for arrays."""
        mesh = mesh_of(scattered(50))
        with self.assertRaisesRegex(MemoryError, "allows 2.04 KB"):
            mesh.adaptive.delaunay_2d(memory_limit="2 KiB")
        self.assertEqual(mesh.adaptive.delaunay_2d(memory_limit="1 GB").n_cells, mesh.adaptive.delaunay_2d().n_cells)
        asked = []
        with unittest.mock.patch.object(_interface, "_told", 1):
            with unittest.mock.patch.object(_meshes, "_set", lambda algorithm, **more: asked.append(more)):
                mesh.adaptive.delaunay_2d()
                mesh.adaptive.delaunay_2d(threads=3)
        told = [more["NumberOfThreads"] for more in asked if "NumberOfThreads" in more]
        self.assertEqual(told, [1, 3])

    def test_other_names(self):
        """Those of `delaunay` and shorter ones are accepted as synonyms, and never both."""
        mesh = mesh_of(numpy.r_[scattered(60), scattered(9) + (0, 0, 5)])
        for other, name, value, own in (
                ("max_edge_length", "maximum_edge_length", 60.0, 60.0), ("tolerance", "tol", 0.05, 0.05),
                ("source_heights", "heights", "surface", "surface"), ("source_heights", "heights", "mixed", "mixed"),
                ("maximum_segment_length", "max_segment_length", 9.0, 9.0), ("rim", "rim", "hull", "convex_hull"),
                ("rim", "rim", "auto", "automatic"), ("duplicates", "duplicates", "lowest", "lowest_z"),
                ("duplicates", "duplicates", "highest", "highest_z"), ("duplicates", "duplicates", "mean", "mean_z"),
                ("plane", "plane", "fit", "best_fit"), ("plane", "plane", "auto", "automatic")):
            given = {} if "plane" in (other, name) else {"plane": "xy"}
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                made, expected = (mesh.adaptive.delaunay_2d(**given, **{key: word}) for key, word in (
                    (other, value), (name, own)))
            self.assertTrue(numpy.array_equal(made.faces, expected.faces), (other, value))
            self.assertTrue(numpy.array_equal(made.points, expected.points), (other, value))
            if other != name:
                self.assertRefused(TypeError, "delaunay_2d() got %s and %s, which are two names for one argument" % (
                    name, other), mesh.adaptive.delaunay_2d, **{name: own, other: value})
        self.assertEqual(mesh_of(scattered(20)).adaptive.delaunay_2d(bounding=True, offset=2.0).n_points, 28)
        self.assertEqual(area(mesh.adaptive.delaunay_2d(plane="xy")), area(mesh.adaptive.delaunay_2d(0.0, plane="xy")))
        with self.assertRaisesRegex(TypeError, "got tol and tolerance"):
            mesh.adaptive.delaunay_2d(0.0, tolerance=0.0)
        boxed = mesh.adaptive.voronoi_2d(voronoi_clip="bounds", plane="xy")
        self.assertEqual(boxed.area, mesh.adaptive.voronoi_2d(clip="bounds", plane="xy").area)
        for more in ({"max_edge_length": 60.0}, {"maximum_edge_length": 60.0}):
            raster = mesh.adaptive.to_raster(20.0, duplicates="mean", **more)
            self.assertEqual(int(raster["vtkValidPointMask"].sum()), int(mesh.adaptive.to_raster(
                20.0, duplicates="mean_z", maximum_edge_length=60.0)["vtkValidPointMask"].sum()))
        with self.assertRaisesRegex(TypeError, "two names for one argument"):
            mesh.adaptive.sample(mesh, heights="own", source_heights="own")

    def test_nothing_is_left_at_a_transform(self):
        """Each change of which would have to reach all filters ever made."""
        core = type(mesh_of(box(0, 0, 1))).__mro__[-3].__module__.split(".")[0]
        turned = __import__(core + ".vtkCommonTransforms", fromlist=["vtkTransform"]).vtkTransform()
        for _ in range(3):
            mesh_of(scattered(20)).adaptive.delaunay_2d(plane=turned)
            mesh_of(scattered(20)).adaptive.to_raster(20.0, plane=turned)
        self.assertFalse(turned.HasObserver("ModifiedEvent"))


class VoronoiTest(unittest.TestCase):
    def test_cells_cover_hull_and_box(self):
        mesh = mesh_of(scattered(100))
        mesh["name"] = numpy.arange(100)
        hull = area(mesh.adaptive.delaunay_2d())
        for clip, expected in (("hull", hull), ("bounds", numpy.prod(numpy.ptp(mesh.points[:, :2], axis=0)))):
            made = mesh.adaptive.voronoi_2d(clip=clip)
            self.assertEqual(made.n_cells, 100)
            self.assertAlmostEqual(made.area, expected, delta=1e-6 * expected)
            self.assertTrue(numpy.array_equal(made["name"], made["OriginalPointIds"]))

    def test_cells_cover_a_polygon(self):
        mesh = mesh_of(scattered(100))
        low, high = mesh.points[:, :2].min(axis=0), mesh.points[:, :2].max(axis=0)
        for corners, cells in ([low - 1, high + 2], 100), ([low, high, [high[0], low[1]]], None):
            made = mesh.adaptive.voronoi_2d(clip=corners)
            width, height = corners[1] - corners[0]
            whole = width * height / (len(corners) - 1)
            self.assertAlmostEqual(made.area, whole, delta=1e-6 * whole)
            self.assertEqual(made.n_cells, cells or len(set(made["OriginalPointIds"])))
        self.assertLess(made.n_cells, 100)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # there is no triangle
            self.assertEqual(mesh_of(scattered(1)).adaptive.voronoi_2d(clip=[[0, 0], [2, 3]]).area, 6)

    def test_on_a_slope(self):
        points = scattered(100)
        points[:, 2] = points[:, 0]
        made = mesh_of(points).adaptive.voronoi_2d(plane="best_fit")
        self.assertAlmostEqual(float(abs(made.points[:, 2] - made.points[:, 0]).max()), 0, delta=1e-2)


class OutlineTest(unittest.TestCase):
    def test_a_surface_and_its_groups(self):
        points = scattered(900)
        points[:, 2] = 0
        surface = mesh_of(points).adaptive.delaunay_2d(maximum_edge_length=50)
        outline = surface.adaptive.outline()
        self.assertGreater(sum(outline["IsHole"]), 1)
        rings = [ring.points[:, :2].astype(float) for ring in (outline.get_cell(k) for k in range(outline.n_cells))]
        areas = [float(numpy.sum(r[:-1, 0] * r[1:, 1] - r[:-1, 1] * r[1:, 0])) / 2 for r in rings]
        self.assertEqual([area < 0 for area in areas], [hole == 1 for hole in outline["IsHole"]])
        self.assertAlmostEqual(sum(areas), surface.area, delta=1)
        surface.cell_data["side"] = surface.cell_centers().points[:, 0] > 500
        parts = surface.adaptive.outline("side")
        self.assertEqual(sorted(set(parts["side"])), [0, 1])
        self.assertGreater(parts.n_cells, outline.n_cells)
        with self.assertRaisesRegex(MemoryError, "outline of .* memory_limit allows"):
            surface.adaptive.outline(memory_limit=2000)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            strips = pyvista.PolyData(points, strips=[3, 0, 1, 2])
            self.assertEqual(strips.adaptive.outline().n_cells, 0)
        self.assertEqual([(row.category, "strip" in str(row.message)) for row in caught], [(DelaunayWarning, True)])


class FoundTest(unittest.TestCase):
    def test_it_is_shown(self):
        """Docstrings, and the names that are completed."""
        self.assertIn("adaptive", dir(pyvista.PolyData()))
        self.assertIn("even_odd", inspect.getdoc(RUN.delaunay_2d))
        self.assertNotIn("mesh", inspect.signature(RUN.voronoi_2d).parameters)
        for name in ("delaunay_2d", "voronoi_2d", "to_raster", "sample", "refine", "outline"):
            text = inspect.getdoc(getattr(RUN, name))
            for keyword in inspect.signature(getattr(RUN, name)).parameters:
                self.assertRegex(text, r"(?m)^(\w+, )*%s(, \w+)*($| : )" % keyword, name)


def can_draw():
    try:
        return shutil.which("xvfb-run") and hasattr(pyvista, "Plotter")
    except ImportError:  # cvista without its modules for rendering
        return False


class ExampleTest(unittest.TestCase):
    @unittest.skipUnless(can_draw(), "nothing to draw with")
    def test_bay(self):
        root = pathlib.Path(__file__).resolve().parents[3]
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "bay.png"
            done = subprocess.run(
                ["xvfb-run", "-a", sys.executable, root / "Plugin/Examples/bay_pyvista.py",
                 root / "Data/Bay/soundings.csv", root / "Data/Bay/coastline.vtp", picture],
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertIn("846 soundings: 1673 triangles; with the coastline: 1453 points, 2369 triangles", done.stdout)
            pixels = pyvista.read(picture).point_data.active_scalars
        blue = (pixels[:, 2].astype(int) - pixels[:, 0] > 60).mean()
        self.assertTrue(0.1 < blue < 0.9, blue)


if __name__ == "__main__":
    outcome = unittest.main(argv=sys.argv[:1], exit=False).result
    sys.exit(not outcome.wasSuccessful())
