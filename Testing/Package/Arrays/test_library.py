# SPDX-License-Identifier: BSD-3-Clause
"""The binding of the C interface: it follows the header, and reports refusals."""

import gc
import inspect
import os
import re
import subprocess
import sys
import unittest

import adaptivehilbertdelaunay
import numpy as np
from adaptivehilbertdelaunay import _interface, delaunay
from adaptivehilbertdelaunay import _library as library
from arraysupport import ROOT, SQUARE, cloud, drawn_by

INTERFACE = os.path.join(ROOT, "Filters", "Engine", "Interface")


def header():
    text = ""
    for name in ("ahd.h", "ahd_edit.h", "ahd_messages.h", "ahd_outline.h", "ahd_refine.h", "ahd_sample.h",
                 "ahd_tiles.h"):
        with open(os.path.join(INTERFACE, name), encoding="utf-8") as file:
            text += file.read()
    return text


class HeaderTest(unittest.TestCase):
    def test_every_function_is_declared(self):
        declared = re.findall(r"^AHD_API [^(]*?(ahd_\w+)\(", header(), re.MULTILINE)
        self.assertEqual(sorted(declared), sorted(_interface._signatures()))

    def test_numbers_of_arguments(self):
        for name, arguments in re.findall(r"^AHD_API [^(;]*?(ahd_\w+)\(([^;]*)\);", header(), re.MULTILINE | re.DOTALL):
            count = 0 if arguments.strip() == "void" else arguments.count(",") + 1
            self.assertEqual(len(_interface._signatures()[name][1]), count, name)

    def test_every_constant_has_its_value(self):
        version = re.search(r"#define AHD_ABI_VERSION (\d+)", header())
        constants = re.findall(r"^  AHD_(\w+) = (-?\d+)", header(), re.MULTILINE)
        self.assertGreater(len(constants), 50)
        for name, value in [*constants, ("ABI_VERSION", version.group(1))]:
            if name.startswith("PHASE_"):
                self.assertEqual(library.PHASES[int(value)], name[6:].lower())
            else:
                self.assertEqual(getattr(library, name), int(value), name)

    def test_every_name_can_be_used(self):
        job = library.Job()
        for kind in (library.INT_SETTINGS, library.DOUBLE_SETTINGS):
            for name in library.names(kind):
                value = job.get(name)
                job.set(**{name: value})
                self.assertEqual(job.get(name), value)
        job.set(want_order=1, want_boxes=1, want_insertion_ranks=1, want_voronoi=1, source_heights=1)
        job.set(split_crossings=1, cell_ids=1, tolerance=0.01, alpha=1.0)
        job.set_array("points", np.concatenate((SQUARE, [[1, 2.001], [9, 9], [9, 8.5], [20, 20]])))
        job.set_array("source_points", SQUARE[:5])
        job.set_array("line_ids", np.array([[0, 2], [1, 3], [0, 4], [4, 2]]))
        job.set_array("cells", np.array([[0, 1, 2]]))
        job.run()
        job.sample_weights(SQUARE)
        job.outline()
        self.assertEqual(set(job.counts()), set(library.names(library.COUNTS)))
        self.assertEqual(set(job.measures()), set(library.names(library.MEASURES)))
        rows = re.findall(r"^ \*   (\w+) +(id|real|uint8|int32|int64|float64) +\((\w+|\w+ \+ 1)(?:, (\d))?\)", header(),
                          re.MULTILINE)  # fmt: skip
        shapes = {name: (kind, int(columns or 1)) for name, kind, _, columns in rows}
        for name in library.names(library.OUTPUT_ARRAYS):
            if name.startswith("tiles_"):  # of visits
                continue
            array, (kind, columns) = job.array(name), shapes[name]
            self.assertEqual(array.shape, job.array_shape(name)[: array.ndim], name)
            self.assertEqual(array.shape[1:], (columns,) if columns > 1 else (), name)
            self.assertEqual(array.dtype, {"id": "int32", "real": "float64"}.get(kind, kind), name)
            if name != "left_out":  # as crossings are split
                self.assertGreater(array.size, 0, name)
            written = np.empty_like(array)
            written.fill(77)
            self.assertIs(job.array(name, out=written), written)
            np.testing.assert_array_equal(written, array)

    def test_delaunay_has_every_setting(self):
        """Settings and arrays without a keyword, and why."""
        without = {
            "skip_mask": "a mark that is not zero",
            "cell_ids": "source_points",
            "first_cell": "for VTK's cells", "unfitted_points": "for surfaces that were made before",
            "alpha_triangles": "kinds are arrays of their own", "alpha_lines": "", "alpha_vertices": "",
            "want_curve": "for VTK's drawing",
            "other_memory": "for VTK's arrays", "other_memory_per_point": "",
            "progress_delay": "set for Ctrl-C",
            "sample_method": "Triangulation.interpolate", "sample_outside": "",
            "sample_first_column": "for tiles", "sample_first_row": "",
        }  # fmt: skip
        names = {"split_crossings": "crossings", "closed_lines": "closed_lines_are_loops"}
        keywords = set(inspect.signature(delaunay).parameters)
        for name in library.names(library.INT_SETTINGS) + library.names(library.DOUBLE_SETTINGS):
            if name not in without and not name.startswith("want_"):
                self.assertIn(names.get(name, name), keywords)


class LoadTest(unittest.TestCase):
    SCRIPT = (
        "import adaptivehilbertdelaunay as a\n"
        "try: a.delaunay\n"
        "except ImportError as error: print(error)\n"
        "else: print('loaded')\n"
    )

    def load(self, path):
        environment = {**os.environ, "ADAPTIVEHILBERTDELAUNAY_LIBRARY": path}
        done = subprocess.run([sys.executable, "-c", self.SCRIPT], env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, check=True)  # fmt: skip
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_what_is_not_there(self):
        said = self.load("/nowhere/lib.so")
        self.assertRegex(said, r"[/\\]nowhere[/\\]lib\.so")
        self.assertIn("pip install .", said)

    def test_another_library(self):
        other = {"win32": "kernel32.dll", "darwin": "/usr/lib/libSystem.B.dylib"}.get(sys.platform, "libm.so.6")
        self.assertIn(other + " is not the library of adaptivehilbertdelaunay", self.load(other))

    def test_a_library_that_lacks_a_function(self):
        """The error says which; an AttributeError would mean that the package has no such name."""
        class Older:
            def __init__(self, path):
                self.ahd_abi_version = lambda: library.ABI_VERSION

            def __getattr__(self, name):
                if name == "ahd_sample_weights":
                    raise AttributeError(name)
                self.__dict__[name] = lambda *_: None
                return self.__dict__[name]

        loader, _interface.ctypes.CDLL = _interface.ctypes.CDLL, Older
        try:
            with self.assertRaisesRegex(ImportError, "x.so has no function ahd_sample_weights"):
                _interface._load("x.so")
        finally:
            _interface.ctypes.CDLL = loader

    def test_a_module_that_cannot_be_loaded(self):
        """The error says why: here NumPy lacks something."""
        script = (
            "import numpy\ndel numpy.int64\n"
            "try:\n    from adaptivehilbertdelaunay import delaunay\nexcept ImportError as error:\n    print(error)\n"
        )
        done = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, check=True)
        self.assertRegex(done.stdout, "delaunay cannot be loaded: module 'numpy' has no attribute 'int64'")

    def test_the_library_itself(self):
        self.assertEqual(self.load(library.library_path()), "loaded\n")

    def test_another_version(self):
        class Other:
            def ahd_abi_version(self):
                return library.ABI_VERSION + 1

        loader, _interface.ctypes.CDLL = _interface.ctypes.CDLL, lambda path: Other()
        try:
            with self.assertRaisesRegex(ImportError, "x.so has version 2 .* version 1 is needed"):
                _interface._load("x.so")
        finally:
            _interface.ctypes.CDLL = loader

    def test_the_package_loads_what_is_asked_for(self):
        script = (
            "import sys, adaptivehilbertdelaunay as a\n"
            "print('numpy' in sys.modules, sorted(name for name in a.__all__ if name not in dir(a)))\n"
            "from adaptivehilbertdelaunay import *\n"
            "print(delaunay.__name__, any(name.startswith('vtk') for name in sys.modules))\n"
        )
        done = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual(done.stdout, "False []\ndelaunay False\n")
        with self.assertRaisesRegex(AttributeError, "no attribute 'nothing'"):
            adaptivehilbertdelaunay.nothing


class JobTest(unittest.TestCase):
    def setUp(self):
        self.job = library.Job()

    def refuse(self, status, words, work):
        with self.assertRaises(library.EngineError) as caught:
            work()
        self.assertEqual(caught.exception.status, status)
        self.assertRegex(str(caught.exception), words)
        return caught.exception

    def test_each_error_has_a_status_of_its_kind(self):
        for kind in set(library.ERRORS.values()):
            self.assertIs(library.ERRORS[kind("without one").status], kind)
            self.assertEqual(kind("with one", library.BUSY).status, library.BUSY)
        self.assertEqual(library.Fault("without one").status, library.FAILED)

    def test_refused(self):
        job, refuse = self.job, self.refuse
        self.assertIsInstance(refuse(library.UNKNOWN_NAME, "colour", lambda: job.set(colour=1)), ValueError)
        refuse(library.BAD_VALUE, "nmax", lambda: job.set(nmax=0))
        refuse(library.BAD_VALUE, "nmax", lambda: job.set(nmax=2**70))
        refuse(library.BAD_VALUE, "tolerance", lambda: job.set(tolerance=2))
        refuse(library.UNKNOWN_NAME, "colour", lambda: job.get("colour"))
        refuse(library.UNKNOWN_NAME, "colours", lambda: job.set_array("colours", SQUARE))
        refuse(library.BAD_ARRAY, "points.*<i8", lambda: job.set_array("points", SQUARE.astype("<i8")[:, :, None]))
        refuse(library.BAD_ARRAY, "points", lambda: job.set_array("points", np.zeros((3, 4))))
        refuse(library.BAD_ARRAY, ">f8", lambda: job.set_array("points", SQUARE.astype(">f8")))
        self.assertIsInstance(refuse(library.NOT_AVAILABLE, ".", lambda: job.count("inserted")), RuntimeError)
        refuse(library.NOT_AVAILABLE, ".", lambda: job.array("triangles"))
        job.set_array("points", SQUARE)
        job.set(memory_limit=1)
        self.assertIsInstance(refuse(library.MEMORY_LIMIT, ".", job.run), MemoryError)
        job.set(memory_limit=0)
        job.run()
        refuse(library.NOT_AVAILABLE, ".", lambda: job.array("voronoi_sites"))
        refuse(library.UNKNOWN_NAME, "colours", lambda: job.array("colours"))
        refuse(library.BAD_ARRAY, ".", lambda: job.array("triangles", out=np.empty(3, np.int32)))
        refuse(library.BAD_ARRAY, ".", lambda: job.array("triangles", np.float64))
        refuse(library.BAD_ARRAY, "type", lambda: job.array("triangles", np.int8))
        refuse(library.BAD_ARRAY, "values", lambda: job.interpolate(np.zeros(3)))
        refuse(library.BAD_ARRAY, "places", lambda: job.locate(np.zeros(3)))
        with self.assertRaises(TypeError):
            job.set(nmax=1.5)

    def test_memory_that_shows_during_the_run_is_refused(self):
        """The table of loops' edges, each time anew: all memory is returned."""
        job, half = self.job, np.arange(1.0, 601.0)
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        job.set_array("points", (half[:, None, None] * corners).reshape(-1, 2))  # squares within each other
        job.set_array("loop_ids", np.arange(2400).reshape(600, 4))
        job.set(threads=1)
        known = job.estimate()
        job.run()
        needed = job.count("memory_estimate")
        self.assertGreater(needed, known)
        for limit in (known, needed - 1, known):
            job.set(memory_limit=limit)
            refused = self.refuse(library.MEMORY_LIMIT, "2400 points.*\"memory_limit\" allows", job.run)
            self.assertIsInstance(refused, MemoryError)
            job.set(memory_limit=needed)
            job.run()
            self.assertEqual(job.count("memory_estimate"), needed)

    def test_set_get_and_take_away(self):
        job = self.job
        job.set(nmax=np.int16(7), gene_rotation=False, tolerance=np.float32(0.5), alpha=3)
        self.assertEqual([job.get(name) for name in ("nmax", "gene_rotation", "tolerance", "alpha")], [7, 0, 0.5, 3.0])
        job.set_array("points", SQUARE)
        job.set_array("skip", np.array([1, 0, 0, 0, 0, 0], np.uint8))
        job.run()
        self.assertEqual(job.count("skipped"), 1)
        job.set_array("skip", None)
        job.run()
        self.assertEqual(job.count("skipped"), 0)

    def test_arrays_live_as_long_as_the_job(self):
        points = cloud(71, 1000)
        expected = delaunay(points).triangles
        self.job.set_array("points", points.copy()[:, :])
        gc.collect()
        filler = [cloud(72, 1000) for _ in range(20)]
        self.job.run()
        np.testing.assert_array_equal(self.job.array("triangles"), expected)
        self.assertEqual(len(filler), 20)

    def test_estimate_release_and_memory_kept(self):
        job = self.job
        job.set_array("points", cloud(73, 20000))
        estimate = job.estimate()
        self.assertGreater(estimate, 20000 * 16)
        job.set(want_voronoi=1)
        self.assertGreater(job.estimate(), estimate)
        job.run()
        self.assertEqual(job.count("memory_estimate"), job.estimate())
        job.release(10**9)
        self.assertGreater(job.kept_bytes(), 0)
        job.release()
        self.assertEqual(job.kept_bytes(), 0)
        self.refuse(library.NOT_AVAILABLE, ".", lambda: job.array("triangles"))

    def test_draw_order(self):
        job = self.job
        job.set(want_curve=1, want_boxes=1)
        job.set_array("points", cloud(74, 300))
        job.run()
        for dtype in (np.int32, np.int64):
            drawn = drawn_by(job, dtype)
            boxes = job.count("boxes")
            self.assertEqual(drawn["xyz"].shape, (300 + 4 * boxes, 3))
            np.testing.assert_array_equal(drawn["ids"][:300], job.array("order"))
            self.assertEqual(drawn["ranks"][:300].tolist(), list(range(300)))
            self.assertEqual((drawn["levels"][0], drawn["counts"][0], len(drawn["levels"])), (-1, 300, boxes + 1))
            self.assertEqual(drawn["counts"].dtype, dtype)
        job.set(want_curve=0)
        job.run()
        alone = drawn_by(job, np.int32)
        np.testing.assert_array_equal(alone["xyz"], drawn["xyz"][300:])
        self.assertEqual((set(alone["ids"]), set(alone["ranks"]), len(alone["levels"])), ({-1}, {-1}, boxes))

    def test_the_drawing_s_arrays_are_looked_at(self):
        job = self.job
        job.set(want_curve=1)
        job.set_array("points", cloud(74, 300))
        job.run()
        for name, given in (
                ("xyz", np.empty((299, 3))), ("ranks", np.empty(300, np.int64)), ("ids", np.empty(600, np.int32)[::2]),
                ("levels", np.empty(1, np.int64)), ("counts", np.empty(2, np.int32))):
            arrays = dict(drawn_by(job, np.int32), **{name: given})
            self.refuse(library.BAD_ARRAY, "%s: must be [0-9]+ numbers of type" % name,
                        lambda arrays=arrays: job.draw_order(**arrays))

    def test_to_plane(self):
        points, job = cloud(75, 50, 3), self.job
        job.set_array("points", points)
        job.set(plane=library.PLANE_BEST_FIT)
        job.run()
        moved = points.copy()
        job.to_plane(moved)
        np.testing.assert_array_equal(moved, job.array("plane_points"))
        np.testing.assert_array_equal(moved[:, 2], job.array("heights"))
        for given in (moved[:, :2], moved.astype(np.float32), moved[::2]):
            self.refuse(library.BAD_ARRAY, "points: of shape", lambda given=given: job.to_plane(given))

    def test_fit_plane(self):
        points = cloud(75, 50, 3)
        self.job.set_array("points", points)
        matrix = self.job.fit_plane()
        np.testing.assert_array_equal(matrix, delaunay(points, plane="best_fit").plane_matrix)

    def test_fingerprint(self):
        points = cloud(76, 50000)
        found = library.fingerprint(points)
        self.assertEqual(found, library.fingerprint(points.copy()))
        self.assertNotEqual(found, library.fingerprint(points, 1))
        strided = library.fingerprint(points[:, ::-1])
        self.assertEqual(strided, library.fingerprint(points.copy()[:, ::-1]))
        for row in (0, 8191, 8192, 49999):
            points[row, 1] = np.nextafter(points[row, 1], 2)
            self.assertNotEqual(found, library.fingerprint(points))
            self.assertNotEqual(strided, library.fingerprint(points[:, ::-1]))
            found, strided = library.fingerprint(points), library.fingerprint(points[:, ::-1])
        self.assertEqual(len(library.fingerprint(points[:0])), 2)

    def test_the_machine(self):
        self.assertGreaterEqual(library.processors(), 1)
        self.assertGreater(library.available_memory(), 2**20)
        self.assertRegex(library.version(), r"^\d+\.\d+\.\d+")
        self.assertEqual(library.status_name(library.BAD_VALUE), "AHD_BAD_VALUE")

    @unittest.skipUnless(os.path.exists("/proc/self/statm"), "Linux tells how much memory a process has")
    @unittest.skipIf("AHD_TEST_EMULATED" in os.environ, "an emulator has memory of its own: qemu keeps that of threads")
    def test_jobs_are_freed(self):
        """Many at once and one after the other, with results, take no more than the live ones."""
        points = cloud(77, 20000)
        for _ in range(3):
            jobs = [library.Job() for _ in range(10)]
            for job in jobs:
                job.set_array("points", points)
                job.run()
            self.assertEqual({job.count("inserted") for job in jobs}, {20000})
        resident = []
        for _ in range(40):
            delaunay(points)
            with open("/proc/self/statm", encoding="ascii") as file:
                resident.append(int(file.read().split()[1]))
        self.assertLess(resident[-1] - resident[9], 30 * 20000 * 16 / 4096 / 2)


if __name__ == "__main__":
    unittest.main()
