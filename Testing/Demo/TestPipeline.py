# SPDX-License-Identifier: BSD-3-Clause
"""The demo in pvbatch: VTK's file formats, its output and files, and the picture.

    pvbatch TestPipeline.py <AdaptiveHilbertDelaunay.so>
"""

import contextlib
import importlib.util
import io
import math
import os
import re
import sys
import tempfile
import unittest
from unittest import mock

import numpy

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "Plugin", "Demo"))

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D  # noqa: F401 (so that Python loads it)
import badfiles
import demo
import geotiff
import picture
from paraview.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
import results
from pointfiles import InputError
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkStructuredPointsWriter, vtkUnstructuredGridWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter)  # fmt: skip

PLUGIN = sys.argv[1]

# Exact in float32, as PLY files are; not so small that text at full precision would be needed.
POINTS = numpy.array([[0.5, 0.25, 7.0], [10.5, 0.0, -3.5], [0.0, 12.0, 1.0], [9.0, 11.75, 2.0], [4.0, 5.0, 0.125]])


def points_of(array):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(array, deep=1))
    return points


def poly_data():
    data = vtkPolyData()
    data.SetPoints(points_of(POINTS))
    triangles = vtkCellArray()
    for corners in ((0, 1, 4), (2, 0, 4), (3, 2, 4), (1, 3, 4)):
        triangles.InsertNextCell(3, corners)
    data.SetPolys(triangles)
    return data


def unstructured_grid():
    data = vtkUnstructuredGrid()
    data.SetPoints(points_of(POINTS))
    data.InsertNextCell(5, 3, (0, 1, 4))
    return data


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write_text(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def run_demo(self, *words):
        """The demo's output."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            demo.run(demo.parse_arguments(["--plugin", PLUGIN, "--output", self.folder, *words]))
        return said.getvalue()

    def surface(self, name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        return reader.GetOutput()


class VtkFormats(InFolder):
    def check(self, name, writer, data):
        path = self.path(name)
        writer.SetFileName(path)
        if hasattr(writer, "SetDataModeToBinary"):
            writer.SetDataModeToBinary()  # not appended: see appended_data_hint in demo.py
        writer.SetInputData(data)
        self.assertEqual(writer.Write(), 1)
        _, found = demo.read_vtk(path)
        numpy.testing.assert_array_equal(found.xyz, POINTS)

    def test_legacy(self):
        self.check("poly.vtk", vtkPolyDataWriter(), poly_data())
        self.check("grid.vtk", vtkUnstructuredGridWriter(), unstructured_grid())

    def test_xml(self):
        self.check("poly.vtp", vtkXMLPolyDataWriter(), poly_data())
        self.check("grid.vtu", vtkXMLUnstructuredGridWriter(), unstructured_grid())

    def test_ply(self):
        self.check("poly.ply", vtkPLYWriter(), poly_data())

    def test_images_have_no_points_of_their_own(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 1)
        image.AllocateScalars(10, 1)
        writer = vtkStructuredPointsWriter()
        writer.SetFileName(self.path("image.vtk"))
        writer.SetInputData(image)
        writer.Write()
        with self.assertRaisesRegex(InputError, "holds vtkStructuredPoints; a data set with points of its own is"):
            demo.read_vtk(self.path("image.vtk"))

    def test_a_file_without_points(self):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(self.path("empty.vtp"))
        writer.SetInputData(vtkPolyData())
        writer.Write()
        with self.assertRaisesRegex(InputError, "holds no points that .* its data is appended"):
            demo.read_vtk(self.path("empty.vtp"))
        writer.SetDataModeToBinary()
        writer.Write()
        with self.assertRaisesRegex(InputError, "holds no points$"):
            demo.read_vtk(self.path("empty.vtp"))


class WholeRuns(InFolder):
    def assert_lines(self, said, *lines):
        found = [" ".join(line.split()) for line in said.splitlines()]
        for line in lines:
            self.assertIn(line, found, said)

    def assert_picture(self, name):
        """1920 × 1080, with the many shades of a lit surface, over a good part of the middle."""
        reader = vtkPNGReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions()[:2], picture.SIZE)
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(1080, 1920, -1)[..., :3]
        middle = pixels[200:880, 300:1600].reshape(-1, 3).astype(int)
        self.assertGreater(len(numpy.unique(middle, axis=0)), 300, "%s: hardly any colours" % name)
        coloured = numpy.ptp(middle, axis=1) > 30  # the background is all but grey
        self.assertGreater(coloured.mean(), 0.3, "%s: hardly anything drawn" % name)

    def test_counts(self):
        rows = "x,y,z\n0,0,0\n4,0,1\n4,4,2\n0,4,3\n4,4,5\nnan,1,1\nbad,1,1\n2,1,4\n"
        said = self.run_demo(self.write_text("square.csv", rows))
        self.assert_lines(
            said, "1 of 8 rows cannot be read and are left out:", "line 8: bad,1,1",
            "points 7", "unreadable 1 (not among the points)", "triangles 4",
            "duplicates 1 (same x and y as another point)", "rejected 1 (x or y not finite)")  # fmt: skip
        self.assertRegex(said, r"NP +(?!0\.00)\d+\.\d\d ")
        self.assertRegex(said, r"NR +(?!0\.00)\d+\.\d\d ")
        self.assertRegex(said, r"seconds +\d+\.\d{3} = \d+\.\d{3} sort \+ \d+\.\d{3} insert \+ \d+\.\d{3} output")
        self.assert_picture("square.png")

    def test_simplified(self):
        """The surface has the points that are left, and says which they were."""
        said = self.run_demo("--simplify", "20")
        sample = numpy.loadtxt(os.path.join(ROOT, "Data", "survey.csv"), delimiter=",", skiprows=1)
        surface = self.surface("survey.vtp")
        ids = vtk_to_numpy(surface.GetPointData().GetArray("Fate"))
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetPoints().GetData()), sample[ids])
        self.assertLess(len(ids), len(sample) / 2)
        told = r"left out +([\d ,]+) \(the surface differs from them by ([\d.]+) at most\)"
        out, largest = re.search(told, said).groups()
        self.assertGreater(int(re.sub(r"\D", "", out)), len(sample) / 2)
        self.assertTrue(19 < float(largest) <= 20, largest)
        self.assert_picture("survey.png")

    def test_a_table_with_text_in_it(self):
        """As a spreadsheet saves it: names, a row of units, remarks, gaps as words, a foot."""
        rows = ["station;lat;lon;depth;remark", "-;deg;deg;m;-"]
        rows += ["S%02d;%d;%d;%d;ok" % (i, i // 6, i % 6, i % 5) for i in range(36)]
        rows[7] = "S05;0;5;n/a;\"lost; see log\""
        rows[8] = "S06;1;0;;no echo"
        rows[9] = "S07;1;1;1 m;"
        rows[10] = "S08;one;2;3;ok"
        rows[11] = "S09;1;3;nan;a gap that is said as a number"
        rows.append("36 stations")
        said = self.run_demo(self.write_text("log.csv", "\n".join(rows) + "\n"), "--edges")
        self.assert_lines(
            said, "columns: x = lon, y = lat, z = depth, semicolons between",
            "6 of 38 rows cannot be read and are left out:", "line 2: -;deg;deg;m;-", "...",
            "points 32", "unreadable 6 (not among the points)", "duplicates 0 (same x and y as another point)",
            "rejected 0 (x or y not finite)")  # fmt: skip
        self.assertIn("1 points without a finite z drawn at the bottom", said)
        self.assertEqual(self.surface("log.vtp").GetNumberOfPoints(), 32)

    def test_the_sample(self):
        said = self.run_demo()
        surface = self.surface("survey.vtp")
        sample = numpy.loadtxt(os.path.join(ROOT, "Data", "survey.csv"), delimiter=",", skiprows=1)
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetPoints().GetData()), sample)
        with open(self.path("survey.vtp"), "rb") as file:
            self.assertNotIn(b"<AppendedData", file.read(), "see appended_data_hint in demo.py")
        distinct = len(numpy.unique(sample[:, :2], axis=0))
        self.assert_lines(
            said, "points {:,}".format(len(sample)), "triangles {:,}".format(surface.GetNumberOfPolys()),
            "duplicates {:,} (same x and y as another point)".format(len(sample) - distinct),
            "vertical exaggeration 3 (taking x, y and z to be in one unit)")  # fmt: skip
        # 2 v - 2 - h triangles, and every hull vertex is the end of two boundary edges
        hull = len(picture.boundary_edges(picture.corner_ids(surface)))
        self.assertEqual(surface.GetNumberOfPolys(), 2 * distinct - 2 - hull)
        self.assert_picture("survey.png")

    def test_heights_that_are_not_finite_are_drawn_and_told(self):
        rows = "".join("%d %d %s\n" % (i % 20, i // 20, "nan" if i == 77 else i % 7) for i in range(400))
        said = self.run_demo(self.write_text("odd.xyz", rows), "--edges")
        self.assertIn("1 points without a finite z drawn at the bottom", said)
        self.assertNotIn("unreadable", said)
        self.assert_picture("odd.png")

    def test_no_height_is_finite(self):
        rows = "".join("%d %d nan\n" % (i % 20, i // 20) for i in range(400))
        said = self.run_demo(self.write_text("nowhere.xyz", rows))
        self.assertIn("flat: z is 0; 400 points without a finite z", said)
        self.assert_picture("nowhere.png")

    def test_a_flat_set_shows_its_edges(self):
        rows = "".join("%d,%d\n" % (i % 20, i // 20) for i in range(400))
        said = self.run_demo(self.write_text("flat.csv", rows))
        self.assertIn("flat: z is 0", said)
        self.assert_picture("flat.png")

    def test_a_line_has_no_triangle_and_no_picture(self):
        with self.assertRaisesRegex(InputError, "no triangle, so no picture"):
            self.run_demo(self.write_text("line.txt", "0 0 1\n1 1 2\n2 2 3\n"))
        self.assertEqual(self.surface("line.vtp").GetNumberOfPoints(), 3)
        self.assertFalse(os.path.exists(self.path("line.png")))

    def test_no_old_picture_stays_beside_a_new_empty_surface(self):
        self.run_demo(self.write_text("same.csv", badfiles.HILL.decode()))
        self.assertTrue(os.path.exists(self.path("same.png")))
        with self.assertRaisesRegex(InputError, "no triangle, so no picture"):
            self.run_demo(self.write_text("same.csv", "0,0,1\n1,1,2\n2,2,3\n"))
        self.assertEqual(self.surface("same.vtp").GetNumberOfPolys(), 0)
        self.assertFalse(os.path.exists(self.path("same.png")))

    def test_no_old_raster_stays_beside_a_new_surface(self):
        path = self.write_text("same.csv", badfiles.HILL.decode())
        self.run_demo(path, "--raster=0.5")
        self.assertTrue(os.path.exists(self.path("same.vti")))
        self.run_demo(path)
        self.assertFalse(os.path.exists(self.path("same.vti")) or os.path.exists(self.path("same.tif")))
        self.assertTrue(os.path.exists(self.path("same.png")))

    def test_files_of_somebody_else_stay(self):
        path = self.write_text("line.csv", "0,0,1\n1,1,2\n2,2,3\n")
        for name in ("line.png", "line.vtp"):
            mine = self.write_text(name, "mine")
            with self.assertRaisesRegex(InputError, name + " is there, and is not as this program wrote it"):
                self.run_demo(path)
            with open(mine, encoding="utf-8") as file:
                self.assertEqual(file.read(), "mine")
            os.remove(mine)
        mine = self.write_text("line.vti", "mine")  # no result of this run
        with self.assertRaisesRegex(InputError, "no triangle, so no picture"):
            self.run_demo(path)
        self.assertTrue(os.path.exists(mine))
        with open(self.path("line.vtp"), "a", encoding="utf-8") as file:
            file.write("<!-- mine now -->")
        with self.assertRaisesRegex(InputError, "line.vtp is there"):
            self.run_demo(path)
        with self.assertRaisesRegex(InputError, "no triangle, so no picture"):
            self.run_demo(path, "--own-output")

    def test_links_and_lists_that_lie(self):
        """Nothing is written through another user's link, wherever it leads."""
        path = self.write_text("line.csv", "0,0,1\n1,1,2\n2,2,3\n")
        os.symlink(self.path("nowhere.vtp"), self.path("line.vtp"))
        for known in ("", "[" * 100_000, "{}", '{"line.vtp": null, "../x": [1, 2], "a\\u0000": 3}', "[1]"):
            self.write_text(results.LIST, known)
            with self.assertRaisesRegex(InputError, "line.vtp is there"):
                self.run_demo(path)
        with self.assertRaisesRegex(InputError, "no triangle, so no picture"):
            self.run_demo(path, "--own-output")
        self.assertFalse(os.path.islink(self.path("line.vtp")) or os.path.exists(self.path("nowhere.vtp")))

    def test_where_memory_is_short_one_line_says_so(self):
        words = ["demo.py", "--output", self.folder, self.write_text("square.csv", "0,0,1\n1,0,2\n0,1,2\n")]
        said = io.StringIO()
        with mock.patch.object(demo, "run", side_effect=MemoryError), mock.patch.object(sys, "argv", words):
            with contextlib.redirect_stderr(said):
                self.assertEqual(demo.main(), 1)
        self.assertRegex(said.getvalue(), r"^demo: out of memory; [^\n]*\n$")

    def test_what_cannot_be_drawn_is_triangulated_all_the_same(self):
        for name, (content, words) in badfiles.FOR_THE_PICTURE.items():
            with self.subTest(name=name):
                with self.assertRaisesRegex(InputError, "^no picture: .*" + re.escape(words)):
                    self.run_demo(self.write_text(name, content.decode()))
                self.assertGreater(self.surface(name[:-4] + ".vtp").GetNumberOfPolys(), 0)
        for factor in ("1e-300", "1e300"):
            with self.assertRaisesRegex(InputError, "^no picture: a vertical exaggeration of"):
                self.run_demo(self.write_text("hill.csv", badfiles.HILL.decode()), "--exaggeration", factor)

    def test_the_largest_and_smallest_that_are_drawn(self):
        for name, unit in (("large.csv", 2e28), ("small.csv", 1e-20)):
            rows = "".join("%r,%r,%r\n" % (i % 20 * unit, i // 20 * unit, i % 7 * unit) for i in range(400))
            self.run_demo(self.write_text(name, rows))
            self.assert_picture(name[:-4] + ".png")

    def test_the_input_is_not_overwritten(self):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(self.path("points.vtp"))
        writer.SetInputData(poly_data())
        writer.SetDataModeToBinary()
        writer.Write()
        with self.assertRaisesRegex(InputError, "the result would take the place of"):
            self.run_demo(self.path("points.vtp"))
        self.assertEqual(self.surface("points.vtp").GetNumberOfPolys(), 4)


class Rasters(InFolder):
    """Of a plane, 0.5 x - 0.25 y + 3, without a corner. No picture is drawn, which takes longest."""

    def setUp(self):
        super().setUp()
        drawing = mock.patch.object(demo, "write_picture", lambda _surface, _points, _chosen, path: self.write_text(
            os.path.basename(path), "drawn"))
        drawing.start()
        self.addCleanup(drawing.stop)
        self.rows = "".join("%d,%d,%r\n" % (x, y, 0.5 * x - 0.25 * y + 3)
                            for x in range(21) for y in range(11) if x + y <= 25)

    def raster(self, name):
        """The image, and its heights in rows."""
        reader = vtkXMLImageDataReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        columns, rows, _ = reader.GetOutput().GetDimensions()
        heights = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("Elevation"))
        return reader.GetOutput(), heights.reshape(rows, columns)

    def test_the_centres_of_cells_have_the_heights_of_the_surface(self):
        for method in ("linear", "natural", "laplace"):
            said = self.run_demo(self.write_text("plane.csv", self.rows), "--raster", "0.4", "--method", method)
            image, heights = self.raster("plane.vti")
            self.assertEqual((image.GetDimensions(), image.GetSpacing()[:2]), ((50, 25, 1), (0.4, 0.4)))
            x, y = 0.2 + 0.4 * numpy.arange(50), 0.2 + 0.4 * numpy.arange(25)[:, None]
            inside = x + y < 25.0
            self.assertTrue(numpy.array_equal(numpy.isfinite(heights), inside))
            expected = 0.5 * x - 0.25 * y + 3
            self.assertLess(numpy.abs(heights - expected)[inside].max(), 1e-12)
            self.assertIn("50 × 25 cells of 0.4, %s, %.1f %% of them with a height" % (
                method, 100.0 * inside.mean()), said)
        with open(self.path("plane.vti"), "rb") as file:
            self.assertNotIn(b"<AppendedData", file.read(), "see appended_data_hint in demo.py")

    def test_borders_are_multiples_of_the_size(self):
        self.run_demo(self.write_text("off.csv", "1.7,-3.2,1\n8.1,-3.2,2\n8.1,4.9,3\n1.7,4.9,4\n"), "--raster=2")
        image, heights = self.raster("off.vti")
        self.assertEqual((image.GetOrigin(), heights.shape), ((1.0, -3.0, 0.0), (5, 5)))

    @unittest.skipUnless(importlib.util.find_spec("osgeo") or os.environ.get("CI") == "true", "no GDAL for Python")
    def test_the_geotiff(self):
        from osgeo import gdal

        said = self.run_demo(self.write_text("plane.csv", self.rows), "--raster=0.5", "--crs=EPSG:32633")
        self.assertIn("plane.tif (EPSG:32633)", said)
        found = gdal.Open(self.path("plane.tif"))
        self.assertEqual(found.GetGeoTransform(), (0.0, 0.5, 0.0, 10.0, 0.0, -0.5))
        self.assertIn("32633", found.GetProjection())
        _, heights = self.raster("plane.vti")
        numbers = numpy.frombuffer(found.GetRasterBand(1).ReadRaster(), numpy.float64).reshape(20, 40)
        numpy.testing.assert_array_equal(numbers, heights[::-1])

    def test_without_gdal_a_line_says_how_to_get_it(self):
        path = self.write_text("plane.csv", self.rows)
        results.Folder(self.folder).add(self.write_text("plane.tif", "of an earlier run"))
        with mock.patch.object(geotiff, "writer", return_value=None):
            said = self.run_demo(path, "--raster=0.5")
        self.assertRegex(said, "no GeoTIFF: .*apt install python3-gdal")
        self.assertFalse(os.path.exists(self.path("plane.tif")))
        self.assertGreater(os.path.getsize(self.path("plane.vti")), 1000)
        self.assertTrue(os.path.exists(self.path("plane.png")))

    def test_the_unit_of_the_cells(self):
        rows = ["%g,%g,%d" % (10 + 0.02 * (i % 10), 50 + 0.01 * (i // 10), i % 7) for i in range(100)]
        path = self.write_text("degrees.csv", "\n".join(["longitude,lat_wgs84,depth"] + rows))
        span = r" is in degrees, the unit of x and y, and x and y span 0\.18 × 0\.09; for about a point in a cell: "
        words = "--raster 5" + span + r"--raster 0\.01 \(5 m are about 4\.5e-05 degrees\)"
        with self.assertRaisesRegex(InputError, words):
            self.run_demo(path, "--raster=5")
        self.assertRegex(self.run_demo(path, "--raster=0.05"), "few cells: --raster 0.05" + span)
        os.remove(self.path("degrees.vti"))
        with self.assertRaisesRegex(InputError, "--raster 0.09" + span):
            self.run_demo(path, "--raster=0.09")
        self.assertFalse(os.path.exists(self.path("degrees.vti")))
        self.assertIn("Raster   18 × 9 cells of 0.01", self.run_demo(path, "--raster=0.01"))
        path = self.write_text("metres.csv", "\n".join(["x,y,z"] + rows))
        said = self.run_demo(path, "--raster=5")
        self.assertIn("few cells: --raster 5 is in the unit of x and y, and x and y span 0.18 × 0.09", said)
        self.assertNotIn("few cells", self.run_demo(path, "--raster=0.01"))

    def test_a_raster_that_is_too_large(self):
        with self.assertRaisesRegex(InputError, "no raster of cells of 1e-09"):
            self.run_demo(self.write_text("plane.csv", self.rows), "--raster=1e-9")
        self.assertFalse(os.path.exists(self.path("plane.vti")))

    def test_the_input_is_not_overwritten(self):
        self.write_text("plane.csv", self.rows)
        os.symlink(self.path("plane.csv"), self.path("plane.vti"))
        with self.assertRaisesRegex(InputError, "the result would take the place of"):
            self.run_demo(self.path("plane.csv"), "--raster=1")


class Drawing(unittest.TestCase):
    def test_degrees_beside_metres(self):
        """One degree square at 60 N, 1000 m deep: 55.6 by 111.2 km. No wall, and true to scale."""
        corners = numpy.array([[5, 59.5, -1000], [6, 59.5, 0], [6, 60.5, -500], [5, 60.5, -700.0]])
        scale = picture.choose_scale(corners, ("lon", "lat", "depth"))
        self.assertTrue(scale.geographic)
        self.assertAlmostEqual(scale.factors[0], 0.5, places=12)
        diagonal = math.hypot(*(numpy.ptp(corners[:, axis]) * scale.factors[axis] for axis in range(2)))
        relief = (scale.high - scale.low) * scale.factors[2]
        self.assertAlmostEqual(relief / diagonal, picture.RELIEF, delta=0.005)
        self.assertAlmostEqual(scale.factors[2], scale.exaggeration / 111195.0)

    def test_degrees_are_told_by_names(self):
        corners = numpy.array([[5, 59.5, 0], [6, 60.5, 9.0]])
        self.assertFalse(picture.choose_scale(corners, ("x", "y", "z")).geographic)
        self.assertFalse(picture.choose_scale(corners * 1000, ("lon", "lat", "z")).geographic)

    def test_exaggeration(self):
        self.assertEqual(picture.choose_exaggeration(110.0, 1000.0), 1.0)
        self.assertEqual(picture.choose_exaggeration(80.0, 1000.0), 1.0)
        self.assertEqual(picture.choose_exaggeration(1.0, 1000.0), 110)
        self.assertEqual(picture.choose_exaggeration(1e4, 1000.0), 0.011)
        self.assertEqual(picture.choose_exaggeration(0.0, 1000.0), 1.0)
        self.assertEqual([picture.two_digits(value) for value in (34.2, 7.36, 0.0123, 456.0)], [34, 7.5, 0.012, 460])

    def test_decimals_of_big_numbers(self):
        self.assertEqual([picture.decimals(span) for span in (3000.0, 20.0, 9.0, 0.9, 0.0)], [0, 0, 1, 2, 0])

    def test_normals_of_a_slope_drawn_steeper(self):
        """z = x drawn ten times as high: the drawn normal is (-10, 0, 1), turned back for storing."""
        xyz = numpy.array([[0, 0, 0], [1, 0, 1], [1, 1, 1], [0, 1, 0.0]])
        stored = picture.smooth_normals(xyz, numpy.array([[0, 1, 2], [0, 2, 3]]), (1.0, 1.0, 10.0))
        drawn = stored / numpy.array([1.0, 1.0, 10.0])
        drawn /= numpy.linalg.norm(drawn, axis=1, keepdims=True)
        numpy.testing.assert_allclose(drawn, [[-10 / 101**0.5, 0, 1 / 101**0.5]] * 4, atol=1e-14)

    def test_the_camera_fits_the_block(self):
        points = numpy.array([[x, y, z] for x in (0, 7e5) for y in (4e6, 4.1e6) for z in (-3e4, 0)])
        back = picture.toward(202.0, picture.VIEW_HEIGHT)
        right = picture.toward(112.0, 0.0)
        up = numpy.cross(back, right)
        focus, distance = picture.fit(points, points.mean(axis=0), back, right, up)
        local = points - focus
        away = (distance - local @ back) * math.tan(math.radians(picture.VIEW_ANGLE / 2))
        across, upward = (local @ right) / away, (local @ up) / away
        self.assertLess(numpy.abs(across).max(), 1920 / 1080)
        self.assertLess(numpy.abs(upward).max(), 1.0)
        self.assertTrue(numpy.ptp(across) > 2.5 or numpy.ptp(upward) > 1.5, "the block is drawn too small")


if __name__ == "__main__":
    result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if result.wasSuccessful() else 1)  # pvbatch does not pass on the code of sys.exit
