# SPDX-License-Identifier: BSD-3-Clause
"""What a caller sees beside results: the version, sizes in words, threads of the environment, pictures in notebooks."""

import os
import re
import subprocess
import sys
import unittest
import unittest.mock
import xml.etree.ElementTree as tree

import numpy as np

import adaptivehilbertdelaunay
import arraysupport
from adaptivehilbertdelaunay import DelaunayWarning, _interface, delaunay
from adaptivehilbertdelaunay._input import bytes_of
from arraysupport import SQUARE, KeywordTest, cloud

VARIABLES = _interface.THREADS_VARIABLES


class VersionTest(unittest.TestCase):
    def test_version(self):
        with open(os.path.join(arraysupport.ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
            wanted = re.search(r"project\(AdaptiveHilbertDelaunay VERSION ([\d.]+)", file.read())[1]
        self.assertEqual(adaptivehilbertdelaunay.__version__, wanted)
        command = [sys.executable, "-m", "adaptivehilbertdelaunay"]
        said = subprocess.run([*command, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout
        self.assertEqual(said, "adaptivehilbertdelaunay %s (%s)\n" % (wanted, _interface.library_path()))
        done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual((done.returncode, "--version" in done.stderr), (2, True))


class ThreadsTest(unittest.TestCase):
    def threads(self, *told, threads=0, processors=8):
        """Of a job, with these values of the variables; None: it is not set."""
        given = {name: value for name, value in zip(VARIABLES, told) if value is not None}
        with unittest.mock.patch.object(_interface, "_told", _interface.threads_in(given)):
            with unittest.mock.patch.object(_interface, "processors", lambda: processors):
                return delaunay(SQUARE, threads=threads)._request.job(()).get("threads")

    def test_the_first_variable_counts(self):
        self.assertEqual(self.threads(), 0)
        self.assertEqual(self.threads("3", "5", "7"), 3)
        self.assertEqual(self.threads(None, "5", "7"), 5)
        self.assertEqual(self.threads(None, None, "7"), 7)
        self.assertEqual(self.threads(None, None, " 4,2 "), 4)
        self.assertEqual(self.threads("0", "5"), 0)
        self.assertEqual(self.threads("many", "5"), 5)
        self.assertEqual(self.threads("", "-1", "2"), 2)

    def test_not_more_than_there_are_processors(self):
        self.assertEqual(self.threads("64"), 8)
        self.assertEqual(self.threads("64", processors=1), 1)

    def test_a_program_is_told(self):
        script = "from adaptivehilbertdelaunay import _interface as i; print(i._told)"
        clean = {name: value for name, value in os.environ.items() if name not in VARIABLES}
        for name in VARIABLES:
            said = subprocess.run([sys.executable, "-c", script], env={**clean, name: "3"}, check=True,
                                  stdout=subprocess.PIPE, text=True).stdout  # fmt: skip
            self.assertEqual(said, "3\n")

    def test_the_keyword_counts_more(self):
        self.assertEqual(self.threads("1", "1", "1", threads=5), 5)


class SizesTest(KeywordTest):
    def test_words(self):
        for text, wanted in (("2 GB", 2 * 10**9), ("2gb", 2 * 10**9), ("1.5 GiB", 3 * 2**29), ("800MB", 8 * 10**8),
                             ("64 KiB", 2**16), (" 7 ", 7), ("3 TB", 3 * 10**12)):  # fmt: skip
            self.assertEqual(bytes_of(text), wanted)
        self.assertEqual(len(delaunay(SQUARE, memory_limit="100 MB").triangles), 6)
        with self.assertRaisesRegex(MemoryError, "allows 10 KB"):
            delaunay(cloud(1, 5000), memory_limit="10 KB")
        for text in ("2 G", "GB", "-2 GB", "2 GB of it", "", "1e9", "9" * 400 + " GB"):
            with self.assertRaisesRegex(TypeError, "memory_limit must be .* of bytes, or a text such as '2 GB'"):
                delaunay(SQUARE, memory_limit=text)


class WordsTest(KeywordTest):
    def test_x_and_y(self):
        with self.assertRaisesRegex(TypeError, r"the points alone .* make numpy.column_stack\(\[x, y\]\)"):
            delaunay(SQUARE[:, 0], SQUARE[:, 1])

    def test_heights_of_points_without(self):
        for name in ("lowest_z", "highest_z", "mean_z", "mean"):
            with self.assertWarnsRegex(DelaunayWarning, "duplicates='%s' has no effect.* no z" % name):
                delaunay(SQUARE, duplicates=name)
        delaunay(np.c_[SQUARE, SQUARE[:, 0]], duplicates="mean_z")
        delaunay(SQUARE, source_points=np.c_[SQUARE, SQUARE[:, 0]][:3], loops=[0, 1, 2], duplicates="mean_z")


class PictureTest(KeywordTest):
    SVG = "{http://www.w3.org/2000/svg}"

    def paths(self, made):
        """The paths of the picture, which is small: of cells, and of triangles."""
        said = made._repr_html_()
        self.assertLess(len(said), 30000)
        self.assertIn(repr(made)[1:-1], said)
        image = tree.fromstring(said.replace("<br>", "<br/>")).find(self.SVG + "svg")
        return [path.get("d") for path in image.iter(self.SVG + "path")]

    def test_every_triangle_of_a_few(self):
        for points in (SQUARE, 1e308 * cloud(1, 30), np.array([[0, 0], [5e-324, 0], [0, 5e-324]]), cloud(2, 50, 3),
                       np.float32(cloud(3, 100)) + 1e6):  # fmt: skip
            made = delaunay(points)
            cells, drawn = self.paths(made)
            self.assertEqual((cells, drawn.count("M")), ("", len(made.triangles)))
            numbers = np.array(re.findall(r"-?\d+\.\d", drawn), float)
            self.assertTrue(0 <= numbers.min() and numbers.max() <= 240)

    def covered(self, cells):
        """The cells, of 3 by 3, as a picture."""
        made = np.zeros((60, 100), bool)
        for column, row, width in np.array(re.findall(r"M(\d+),(\d+)h(\d+)v3h-\d+z", cells), int) // 3:
            made[row, column : column + width] = True
        return made

    def test_cells_of_many(self):
        """Also of many more than are looked at; holes are holes."""
        for count in (20000, 120000):
            hole = [(1, 0.3), (2, 0.3), (2, 0.7), (1, 0.7)]
            outline = [(0.01, 0.01), (2.99, 0.01), (2.99, 0.99), (0.01, 0.99)]
            made = delaunay(cloud(4, count) * (3, 1), constraints=[outline, hole])
            cells, _ = self.paths(made)
            picture = self.covered(cells)[:26, :80]
            self.assertFalse(picture[10:16, 30:50].any())
            self.assertGreater(picture[:, :24].mean(), 0.97)
            self.assertGreater(picture[:, 56:].mean(), 0.97)

    def test_large_ones_among_many(self):
        cells, drawn = self.paths(delaunay(np.concatenate((cloud(5, 3000), [[0, 9], [9, 9], [9, 0]]))))
        self.assertTrue(1 < drawn.count("M") <= 200)
        self.assertLess(self.covered(cells).mean(), 0.1)

    def test_in_the_plane(self):
        wall = np.array([(x, 2 * x, z) for x in range(4) for z in range(3)], float)
        self.assertEqual(self.paths(delaunay(wall, plane="best_fit"))[1].count("M"), 12)

    def test_what_became_of_the_points(self):
        made = delaunay(np.concatenate((SQUARE, SQUARE[:2])), segments=[(0, 2)])
        self.assertIn("8 points: 6 triangles; constraint edges: 1; duplicates: 2<", made._repr_html_())
        with self.assertWarns(DelaunayWarning):
            none = delaunay(SQUARE[:2])
        self.assertEqual(none._repr_html_(), "<div><br>Triangulation of 2 points: 0 triangles</div>")


if __name__ == "__main__":
    unittest.main()
