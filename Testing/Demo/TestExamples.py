# SPDX-License-Identifier: BSD-3-Clause
"""The examples of Plugin/Examples, run as their README says.

    python3 TestExamples.py <build folder> <plugin> <cmake> <generator> <compiler>
"""

import importlib.util
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
EXAMPLES = os.path.join(ROOT, "Plugin", "Examples")
SAMPLE = os.path.join(ROOT, "Data", "survey.csv")
BUILD, PLUGIN, CMAKE, GENERATOR, COMPILER = sys.argv[1:6]
del sys.argv[1:6]


def hull_size(places):
    """The number of points on the boundary of the convex hull, those on its edges included. Exact for
    integers."""

    def half(ordered):
        chain = []
        for x, y in ordered:
            while len(chain) > 1:
                (ax, ay), (bx, by) = chain[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0:
                    break
                chain.pop()
            chain.append((x, y))
        return chain

    ordered = sorted(places)
    return len(set(half(ordered) + half(ordered[::-1])))


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def run_example(self, *command):
        done = subprocess.run(
            command, cwd=self.folder, text=True, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("Traceback", done.stdout)
        return done.stdout

    def test_surface(self):
        with open(SAMPLE, encoding="ascii") as file:
            rows = [line.split(",") for line in file.read().splitlines()[1:]]
        # metres to one place: as integers, exact
        places = {tuple(int(field.replace(".", "")) for field in row[:2]) for row in rows}
        said = self.run_example("pvpython", os.path.join(EXAMPLES, "surface.py"), PLUGIN, SAMPLE, "survey.png")
        self.assertIn("NumberOfTriangles %d\n" % (2 * len(places) - 2 - hull_size(places)), said)
        self.assertIn("NumberOfDuplicates %d\n" % (len(rows) - len(places)), said)
        self.assertIn("NumberOfRejectedPoints 0\n", said)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "survey.png")), 20000)

    def test_coastline(self):
        """Every point of shore and islands is a vertex, nothing was left out, and no land remains."""
        bay = os.path.join(ROOT, "Data", "Bay")
        files = [os.path.join(bay, name) for name in ("soundings.csv", "coastline.vtp")]
        said = self.run_example("pvpython", os.path.join(EXAMPLES, "coastline.py"), PLUGIN, *files, "bay.png")
        numbers = {name: int(value) for name, value in re.findall(r"^(NumberOf\w+) (\d+)$", said, re.MULTILINE)}
        with open(files[1], encoding="ascii") as file:
            text = file.read()
        sizes = [int(n) for n in re.search(r'NumberOfPoints="(\d+)".*NumberOfPolys="(\d+)"', text).groups()]
        ends = [[int(n) for n in body.split()] for body in re.findall(r'Name="offsets"[^>]*>([^<]*)<', text)]
        (line,), loops = ends
        with open(files[0], encoding="ascii") as file:
            soundings = len(file.read().splitlines()) - 1
        self.assertEqual(numbers["NumberOfAddedPoints"], sizes[0], said)
        for name in ("NumberOfCrossings", "NumberOfConstraintsLeftOut", "NumberOfUnfilledLoops"):
            self.assertEqual(numbers[name], 0, said)
        # a polygon has as many segments as points, the channel one less
        self.assertEqual(numbers["NumberOfConstraintEdges"], loops[-1] + line - 1, said)
        # Euler: v points of which b on the boundaries, 4 holes and a lagoon of its own
        self.assertEqual(numbers["NumberOfTriangles"], 2 * (soundings + sizes[0]) - loops[-1] + 2 * 4 - 2 - 2, said)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "bay.png")), 50000)

    def test_orders(self):
        said = self.run_example("pvbatch", os.path.join(EXAMPLES, "orders.py"), PLUGIN, "20000")
        rows = re.findall(r"^([a-z].*?) +(\d+\.\d\d) +(\d+\.\d\d) +\d+\.\d{4} +\d+\.\d{4}$", said, re.MULTILINE)
        self.assertEqual(len(rows), 5, said)
        removed = {label: float(nr) for label, _, nr in rows}
        # any triangulation of a point's surroundings loses at least one triangle to it
        self.assertTrue(all(nr > 1.0 for nr in removed.values()), said)
        control = "adaptive Hilbert, control points: "
        self.assertLess(removed[control + "every level"], removed[control + "off"])

    def test_insertion(self):
        said = self.run_example("pvpython", os.path.join(EXAMPLES, "insertion.py"), PLUGIN, self.folder)
        grown = [(int(n), int(t)) for n, t in re.findall(r"^ *(\d+) points: +(\d+) triangles$", said, re.MULTILINE)]
        self.assertEqual([n for n, _ in grown], [20, 100, 400, 1000, 2000], said)
        pictures = set()
        for n, triangles in grown:
            self.assertTrue(n <= triangles <= 2 * n - 5, said)  # 2 n - 2 less the 3 or more of the hull
            with open(os.path.join(self.folder, "insertion-%04d.png" % n), "rb") as file:
                pictures.add(file.read())
        self.assertEqual(len(pictures), len(grown), "pictures that are alike")

    def test_pipeline(self):
        said = self.run_example(sys.executable, os.path.join(EXAMPLES, "pipeline.py"), "hill.vtp")
        self.assertRegex(said, r"\d+ triangles on 9998 points")
        self.assertIn("point 77 is 7 again; point 99 is rejected", said)
        self.assertIn("every triangle counterclockwise: True", said)
        # the integral of exp(-3 r²) over the square; the hull of the points misses a little of its rim
        hill = math.pi / 3 * math.erf(math.sqrt(3)) ** 2
        volume = float(re.search(r"volume below the surface: ([\d.]+)", said).group(1))
        self.assertAlmostEqual(volume, hill, delta=0.01)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "hill.vtp")), 10000)

    def test_arrays(self):
        """The water is the area inside the coastline, of which nothing was left out."""
        files = [os.path.join(ROOT, "Data", "Bay", name) for name in ("soundings.csv", "coastline.vtp")]
        said = self.run_example(sys.executable, os.path.join(EXAMPLES, "arrays.py"), *files)
        with open(files[1], encoding="ascii") as file:
            text = file.read()
        arrays = [[float(n) for n in body.split()] for body in re.findall(r"<DataArray[^>]*>([^<]*)<", text)]
        _, places, _, line_ends, ids, ends = arrays
        twice = 0  # counterclockwise around water, clockwise around islands
        for begin, end in zip([0.0] + ends, ends):
            loop = [int(id) for id in ids[int(begin) : int(end)]]
            for a, b in zip(loop, loop[1:] + loop[:1]):
                twice += places[3 * a] * places[3 * b + 1] - places[3 * b] * places[3 * a + 1]
        area = float(re.search(r"^([\d.]+) square kilometres of water", said, re.MULTILINE).group(1))
        self.assertAlmostEqual(area, twice / 2e6, 3, said)
        self.assertIn("; %d constraint edges\n0 of" % (ends[-1] + line_ends[-1] - 1), said)
        regions = [float(size) for size in re.findall(r"^region \d+: ([\d.]+)", said, re.MULTILINE)]
        self.assertAlmostEqual(sum(regions), area, 3, said)
        self.assertGreater(len(regions), 1, said)
        depths = [float(depth) for depth in re.findall(r"([\d.]+) m deep", said)]
        self.assertEqual(len(depths), 3, said)
        self.assertTrue(all(0 < depth < 40 for depth in depths), said)
        self.assertIn("(1002634, 1445): no water", said)

    @unittest.skipUnless(GENERATOR == "Ninja", "ninja alone tells of what a target is made")
    def test_the_demo_builds_what_arrays_need(self):
        """demo.sh builds one target; the library is part of it, or `delaunay` would not work in its build folder."""
        said = subprocess.run(["ninja", "-C", BUILD, "-t", "query", "AHDInstalled"], check=True, text=True,
                              stdout=subprocess.PIPE).stdout  # fmt: skip
        self.assertIn("    AdaptiveHilbertDelaunayPythonLibrary\n", said.partition("outputs:")[0])

    def test_raster(self):
        """The water of the raster is that of the coastline: its area is known by the corners of the polygons."""
        bay = os.path.join(ROOT, "Data", "Bay")
        files = [os.path.join(bay, name) for name in ("soundings.csv", "coastline.vtp")] + ["bay.vti", "bay.png"]
        said = self.run_example("pvpython", os.path.join(EXAMPLES, "raster.py"), PLUGIN, *files)
        cells, water = (int(n) for n in re.search(r"(\d+) cells, (\d+) of them water", said).groups())
        area = float(re.search(r"^([\d.]+) square", self.run_example(
            sys.executable, os.path.join(EXAMPLES, "arrays.py"), *files[:2]), re.MULTILINE).group(1))  # fmt: skip
        self.assertAlmostEqual(water * 100 / 1e6, area, delta=0.01 * area)
        self.assertGreater(cells, water)
        places, deepest = re.search(r"(\d+) of 201 places are water, the deepest at ([-\d.]+) m", said).groups()
        self.assertTrue(100 < int(places) < 201, said)
        self.assertTrue(-40 < float(deepest) < -5, said)
        for name in files[2:]:
            self.assertGreater(os.path.getsize(os.path.join(self.folder, name)), 20000, name)

    def test_dem_gis(self):
        """The cells of the GeoTIFF are those of the water."""
        missing = [name for name in ("geopandas", "rasterio", "matplotlib") if importlib.util.find_spec(name) is None]
        if missing:
            self.skipTest("no %s here" % " and no ".join(missing))
        bay = os.path.join(ROOT, "Data", "Bay")
        files = [os.path.join(bay, name) for name in ("soundings.csv", "coastline.vtp")] + ["bay.tif", "dem.png"]
        said = self.run_example(sys.executable, os.path.join(EXAMPLES, "dem_gis.py"), *files)
        self.assertIn("; 0 of the constraints' segments were left out", said)
        rows, columns, water, deepest = re.search(
            r"(\d+) x (\d+) cells in EPSG:32632, (\d+) of them water, the deepest at ([-\d.]+) m", said).groups()
        area = float(re.search(r"^([\d.]+) square", self.run_example(
            sys.executable, os.path.join(EXAMPLES, "arrays.py"), *files[:2]), re.MULTILINE).group(1))  # fmt: skip
        self.assertAlmostEqual(int(water) * 25 / 1e6, area, delta=0.001 * area)
        lengths, levels = zip(*re.findall(r"([\d.]+) km of the line at (-\d+) m", said))
        self.assertEqual(levels, ("-20", "-15", "-10", "-5"))
        self.assertTrue(all(2 < float(length) < 30 for length in lengths), said)
        self.assertTrue(int(water) < int(rows) * int(columns) and -40 < float(deepest) < -5, said)
        for name in files[2:]:
            self.assertGreater(os.path.getsize(os.path.join(self.folder, name)), 20000, name)

    def test_volumes(self):
        """Of the hull of the soundings: above the deepest less below the highest is the area times the difference."""
        soundings = os.path.join(ROOT, "Data", "Bay", "soundings.csv")
        found = {}
        for level in (-100, -5, 100):
            said = self.run_example(sys.executable, os.path.join(EXAMPLES, "volumes.py"), soundings, str(level))
            found[level] = [float(n) for n in re.findall(r"[-\d.]+(?:e[+-]?\d+)?", said)]
        (deep, none, whole), (above, below, part), (nothing, high, no_area) = found.values()
        self.assertEqual((none, nothing, no_area), (0, 0, 0))
        self.assertAlmostEqual((deep + high) / (200 * whole), 1, 4)
        self.assertAlmostEqual((above - below) / (deep - 95 * whole), 1, 3)
        self.assertTrue(0 < part < whole, found)
        run = subprocess.run(
            [sys.executable, os.path.join(EXAMPLES, "volumes.py")],
            stderr=subprocess.PIPE, text=True, check=False)  # fmt: skip
        self.assertTrue(run.returncode == 1 and run.stderr.startswith("usage: "), run.stderr)

    def test_heat(self):
        """The area is that of the plate, whose heat leaves at its outline; the hottest place is beside the hole."""
        said = self.run_example(sys.executable, os.path.join(EXAMPLES, "heat.py"), "heat.png")
        numbers = r"heat in ([\d.]+), out through the outline ([\d.]+)\nhottest: ([\d.]+) at \(2.[67]\d, 1.[67]\d\)"
        heat, flow, hottest = (float(n) for n in re.search(numbers, said).groups())
        hole = 12 * 0.9**2 * math.sin(math.pi / 12)  # of 24 sides
        self.assertAlmostEqual(heat, 20 - hole, 5)
        self.assertAlmostEqual(flow, heat, 5)
        self.assertAlmostEqual(hottest, 0.9098, delta=0.006)  # that of 10^5 triangles
        if importlib.util.find_spec("skfem") is not None:
            self.assertRegex(said, r"scikit-fem differs by \de-1\d")
        if importlib.util.find_spec("matplotlib") is not None:
            self.assertGreater(os.path.getsize(os.path.join(self.folder, "heat.png")), 20000)

    def test_without_arguments(self):
        """One line names the missing package, like the text at the top: no traceback."""
        for name in sorted(os.listdir(EXAMPLES)):
            path = os.path.join(EXAMPLES, name)
            if not name.endswith(".py") or name == "pipeline.py":  # whose one argument may be left out
                continue
            with open(path, encoding="utf-8") as file:
                text = file.read()
            usage = re.search(r'sys\.exit\("usage: (.*)"\)\n', text)
            self.assertTrue(usage and usage.group(1) in text.split('"""')[1], name)
        run = subprocess.run([sys.executable, os.path.join(EXAMPLES, "arrays.py")], stderr=subprocess.PIPE, text=True,
                             check=False)  # fmt: skip
        self.assertEqual((run.returncode, run.stderr[:25]), (1, "usage: python3 arrays.py "))

    def test_volumes_of_flat_triangles(self):
        """Points at the level are not above it."""
        with open(os.path.join(self.folder, "flat.csv"), "w", encoding="ascii") as file:
            file.write("x,y,z\n0,0,5\n1,0,5\n0,1,5\n")
        said = self.run_example(sys.executable, os.path.join(EXAMPLES, "volumes.py"), "flat.csv", "5")
        self.assertRegex(said, "area above the level: 0$")

    def test_cxx(self):
        """With either generator of CMake, if its program is installed: the demo installs ninja alone."""
        with open(os.path.join(self.folder, "points.xyz"), "w", encoding="ascii") as file:
            file.write("0 0 1\n1 0 2\n1 1 3\n0 1 4\n0.5 0.5 5\n1 0 6\n")
        programs = {"Ninja": "ninja", "Unix Makefiles": "make"}
        for generator in {GENERATOR, *(name for name, program in programs.items() if shutil.which(program))}:
            folder = generator.replace(" ", "")
            self.run_example(
                CMAKE, "-S", os.path.join(EXAMPLES, "cxx"), "-B", folder, "-G", generator,
                "-DCMAKE_PREFIX_PATH=" + BUILD, "-DCMAKE_CXX_COMPILER=" + COMPILER)  # fmt: skip
            self.run_example(CMAKE, "--build", folder)
            said = self.run_example(os.path.join(self.folder, folder, "triangulate_xyz"), "points.xyz", folder + ".vtp")
            self.assertIn("6 points, 1 duplicates, 4 triangles in ", said)
            self.assertTrue(os.path.exists(os.path.join(self.folder, folder + ".vtp")))

    def test_lines_of_the_documents(self):
        """They name a generator, whose program the demo installs, and plugins by whole paths: ParaView 5.13 accepts no
        others."""
        for name in ("Plugin/Examples/README.md", "Plugin/Examples/cxx/CMakeLists.txt",
                     "Filters/Engine/Interface/README.md", "Testing/Engine/README.md"):  # fmt: skip
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                text = file.read()
            for line in re.findall(r"cmake -S .*", text):
                self.assertIn(" -G Ninja ", line, name)
            for start in re.findall(r"(.{5})build/lib/paraview-", text):
                self.assertTrue(start.endswith(("$PWD/", "/to/")), name + ": " + start)

    def test_a_relative_path_of_the_plugin(self):
        for name in sorted(os.listdir(EXAMPLES)):
            if name.endswith(".py"):
                with open(os.path.join(EXAMPLES, name), encoding="utf-8") as file:
                    for loaded in re.findall(r"LoadPlugin\((.*?), remote", file.read()):
                        self.assertEqual(loaded, "os.path.abspath(plugin)", name)


if __name__ == "__main__":
    unittest.main()
