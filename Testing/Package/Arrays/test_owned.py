# SPDX-License-Identifier: BSD-3-Clause
"""Ownership of memory: results, and input that callers change, move or free afterwards."""

import copy
import gc
import mmap
import os
import pickle
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import LinearInterpolator, Raster, delaunay
from adaptivehilbertdelaunay import _library as library
from arraysupport import SQUARE, cloud

METHODS = ("linear", "natural", "laplace", "nearest")


class ProjectionTest(unittest.TestCase):
    def test_what_is_kept_of_a_plane(self):
        """Its points outlive the engine's, and so do frames of an error."""
        script = (
            "import numpy as np\nfrom adaptivehilbertdelaunay import delaunay\n"
            "points, kept = np.random.default_rng(0).random((40000, 3)), []\n"
            "delaunay(points, plane=kept.append)\n"
            "assert np.array_equal(np.concatenate(kept), points), 'others than it was given'\n"
            "def fail(xyz):\n    raise LookupError\n"
            "try:\n    delaunay(points, plane=fail)\n"
            "except LookupError as error:\n"
            "    trace, shown = error.__traceback__, 0\n"
            "    while trace is not None:\n"
            "        shown += len([repr(value) for value in list(trace.tb_frame.f_locals.values())])\n"
            "        trace = trace.tb_next\n"
            "    xyz = error.__traceback__\n"
            "    while xyz.tb_next is not None:\n        xyz = xyz.tb_next\n"
            "    assert np.array_equal(xyz.tb_frame.f_locals['xyz'], points[:16384])\n"
            "print(len(kept), shown > 5)\n"
        )
        done = subprocess.run([sys.executable, "-c", script], env={**os.environ, "MALLOC_PERTURB_": "165"},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)  # fmt: skip
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("3 True\n", "", 0))

    def test_changed_in_place_or_given_anew(self):
        points = cloud(1, 20000, 3)
        expected = delaunay(points[:, [1, 2]])

        def turn(xyz):
            xyz[:] = xyz[:, [1, 2, 0]]

        for plane in (turn, lambda xyz: xyz[:, [1, 2, 0]], lambda xyz: xyz[:, [1, 2, 0]].tolist()):
            made = delaunay(points, plane=plane, rim="convex_hull")
            np.testing.assert_array_equal(made.triangles, expected.triangles)
            np.testing.assert_array_equal(made.plane_points, points[:, [1, 2, 0]])

    def test_a_changed_shape_is_refused(self):
        def shrink(xyz):
            xyz.resize((1, 3), refcheck=False)

        def flatten(xyz):
            xyz.shape = (-1,)

        for plane in (shrink, flatten):
            with self.assertRaisesRegex(ValueError, "changed the shape of its points"):
                delaunay(cloud(2, 300, 3), plane=plane)


class MemoryTest(unittest.TestCase):
    """An array's memory is not moved or freed while it is borrowed."""

    def refuses(self, given, move):
        """`move` fails while a triangulation of the array lives, released or not."""
        made = delaunay(given)
        expected = delaunay(np.array(given)).order
        self.assertRaises((ValueError, BufferError), move)
        made.release()
        self.assertRaises((ValueError, BufferError), move)
        np.testing.assert_array_equal(made.order, expected)

    def test_arrays_that_are_resized(self):
        def resize(array):
            return lambda: array.resize((1000, array.shape[1]), refcheck=False)

        for view in (lambda array: array, lambda array: array[::2], lambda array: array[:, ::-1].view(np.float64)):
            points = cloud(3, 100)
            self.refuses(view(points), resize(points))
        sources, ids, marks = cloud(4, 9), np.array([[0, 1], [2, 3]]), np.zeros((100, 1), bool)
        made = delaunay(cloud(3, 100), source_points=sources, segments=ids)
        other = delaunay(cloud(3, 100), skip=marks[:, 0])
        for array in (sources, ids, marks):
            self.assertRaises(ValueError, resize(array))
        self.assertEqual(made.counts["constraint_edges"], len(made.constraint_edges))
        del made, other
        gc.collect()
        resize(ids)()
        self.assertEqual(ids.shape, (1000, 2))

    def test_other_memory(self):
        numbers = cloud(5, 100)
        memory = bytearray(numbers.tobytes())
        self.refuses(np.ndarray((100, 2), buffer=memory), lambda: memory.extend(bytes(4096)))
        self.refuses(np.frombuffer(memory).reshape(100, 2), lambda: memory.extend(bytes(4096)))
        with tempfile.TemporaryFile() as file:
            file.write(bytes(numbers.nbytes))
            file.flush()
            mapped = mmap.mmap(file.fileno(), numbers.nbytes)
            points = np.ndarray((100, 2), buffer=mapped)
            points[:] = numbers
            self.refuses(points, mapped.close)
            del points
            gc.collect()
            mapped.close()

    def test_during_a_call(self):
        """Places, values and outputs."""
        points, places, tried = cloud(6, 3000), cloud(7, 3000), []
        values = np.ascontiguousarray(points[:, 0])
        made = delaunay(points)
        expected = made.interpolate(values, places.copy(), "natural")

        def move(phase, done):
            for array in (places, values):
                with self.assertRaises(ValueError):
                    array.resize(10**6, refcheck=False)
                tried.append(done)

        np.testing.assert_array_equal(made.interpolate(values, places, "natural", progress=move), expected)
        job = made._job
        out = np.empty((job.count("triangles"), 3), np.int32)

        def move_out(phase, done):
            with self.assertRaises(ValueError):
                out.resize((10**6, 3), refcheck=False)
            tried.append(done)

        job.set_progress(move_out)
        job.array("neighbors", out=out)
        job.set_progress(None)
        np.testing.assert_array_equal(out, made.neighbors)
        self.assertGreater(len(tried), 2)

    def test_places_live_as_long_as_the_call(self):
        """Values other than contiguous doubles are copied: by `sample` for the call."""
        job, wide = library.Job(), cloud(8, 40000, 4)
        points = cloud(9, 3000)
        job.set_array("points", points)
        job.run()
        values, fill = np.ascontiguousarray(points[:, 0]), []
        expected = job.sample(np.ascontiguousarray(wide[:, 1:3]), [values], method=library.SAMPLE_NATURAL_NEIGHBOR)

        def use_memory(phase, done):
            fill.append([np.full((40000, 2), 0.5) for _ in range(8)])

        job.set_progress(use_memory)
        found = job.sample(wide[:, 1:3], [values], method=library.SAMPLE_NATURAL_NEIGHBOR)
        self.assertGreater(len(fill), 5)
        np.testing.assert_array_equal(found.values[0], expected.values[0])
        job.sample_weights(wide[:, 1:3])
        weights = job.array("weights")
        job.sample_weights(np.ascontiguousarray(wide[:, 1:3]))
        np.testing.assert_array_equal(job.array("weights"), weights)

    def test_a_shape_that_the_caller_changes(self):
        points = cloud(10, 100)
        made = delaunay(points)
        points.shape = (50, 4)
        np.testing.assert_array_equal(made.points, points.reshape(100, 2))
        self.assertEqual(len(made.order), 100)

    def test_arrays_of_a_job(self):
        """A job keeps the arrays that it reads; the former one if the next is refused."""
        job, points = library.Job(), cloud(11, 100)
        job.set_array("points", points.copy())
        with self.assertRaises(library.BadInput):
            job.set_array("points", np.zeros((3, 4)))
        with self.assertRaises(library.BadInput):
            job.set_array("colours", points)
        self.assertEqual(list(job._arrays), ["points"])
        filler = [cloud(12, 100) for _ in range(20)]
        job.run()
        np.testing.assert_array_equal(job.array("triangles"), delaunay(points).triangles)
        self.assertEqual(len(filler), 20)


class ReadOnlyTest(unittest.TestCase):
    def test_nothing_is_written_there(self):
        job = library.Job()
        job.set_array("points", SQUARE)
        job.run()
        for work, array in ((lambda out: job.array("triangles", out=out), np.zeros((6, 3), np.int32)),
                            (job.interpolate, np.zeros(6))):  # fmt: skip
            work(array)
            array[...] = 0
            array.flags.writeable = False
            with self.assertRaisesRegex(library.BadInput, "read-only"):
                work(array)
            self.assertFalse(array.any())


class ChangedTest(unittest.TestCase):
    """Any change of any input is noticed."""

    def noticed(self, made, name):
        for ask in (lambda: made.order, lambda: made.neighbors, lambda: made.voronoi("bounds")):
            with self.assertRaisesRegex(RuntimeError, name + " were changed"):
                ask()

    def test_signs_that_flip(self):
        for side in (128, 256):
            x, y = np.meshgrid(np.arange(float(side)), np.arange(float(side)))
            for dtype in (np.float64, np.float32):
                given = np.stack((x.ravel(), y.ravel()), axis=1).astype(dtype)
                for flip in (lambda points: points[:, 1], lambda points: points):
                    points = given.copy()
                    made = delaunay(points, threads=1)
                    flip(points)[...] *= -1
                    self.noticed(made, "points")

    def test_every_input(self):
        marks = np.zeros(60, bool)
        inputs = {
            "points": lambda: (cloud(20, 60), {}),
            "source_points": lambda: (cloud(21, 9), {"lines": [0, 1]}),
            "marks of `skip`": lambda: (marks.copy(), {}),
            "segments or lines": lambda: (np.array([[0, 1], [2, 3]]), {}),
            "loops": lambda: (np.array([[0, 1, 2], [3, 4, 5]], np.int32), {}),
        }
        keywords = {"points": None, "source_points": "source_points", "marks of `skip`": "skip", "loops": "loops"}
        for name, make in inputs.items():
            for keyword in [keywords[name]] if name in keywords else ["segments", "lines"]:
                array, more = make()
                points = array if keyword is None else cloud(20, 60)
                if keyword is not None:
                    more[keyword] = array
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    made = delaunay(points, **more)
                    np.copyto(array, array[::-1].copy())
                    if array.dtype == bool:
                        array[7] = True
                    twins = [pickle.loads(pickle.dumps(made)), copy.deepcopy(made)]
                    for one in (made, *twins):
                        self.noticed(one, name)
                        rows = made.counts["input_points"] + made.counts["source_points"]
                        self.assertRaises(RuntimeError, one.interpolate, np.zeros(rows), [[0.5, 0.5]])

    def test_of_two_chains_in_one(self):
        """Copied, so that nothing can change."""
        segments, lines = np.array([[0, 1]]), np.array([[2, 3]])
        made = delaunay(SQUARE, segments=segments, lines=lines)
        edges = delaunay(SQUARE, segments=[[0, 1]], lines=[[2, 3]]).constraint_edges
        segments[:], lines[:] = 4, 5
        np.testing.assert_array_equal(made.constraint_edges, edges)

    def test_points_that_are_shown(self):
        points = cloud(22, 60)
        made, again = delaunay(points), delaunay(points)
        again.points
        points[0] = 7
        with self.assertRaisesRegex(RuntimeError, "points were changed"):
            made.points

    def test_copies_of_what_was_not_changed(self):
        """In every memory layout."""
        for points in (cloud(23, 20000)[:, ::-1], cloud(23, 20000)[::-1], np.asfortranarray(cloud(23, 20000, 3)),
                       cloud(23, 20001, 5, np.float32)[::2, 1:4]):  # fmt: skip
            made = delaunay(points, threads=1)
            for twin in (pickle.loads(pickle.dumps(made)), copy.deepcopy(made)):
                np.testing.assert_array_equal(twin.neighbors, made.neighbors)
                self.assertEqual(twin._fingerprint, made._fingerprint)

    def test_changed_during_the_run(self):
        points, changed = cloud(24, 3000), []

        def change(phase, done):
            if phase == "read" and not changed:
                changed.append(True)
                points[:, 1] *= -1

        made = delaunay(points, progress=change)
        with self.assertRaisesRegex(RuntimeError, "points were changed"):
            made.neighbors

    def test_when_places_were_found(self):
        """By this result of the job."""
        job = library.Job()
        job.set_array("points", SQUARE)
        for end in (job.run, job.release, lambda: job.set_array("skip", None), lambda: job.set_array("points", SQUARE)):
            job.run()
            self.assertFalse(job.hasTables)
            job.locate(SQUARE)
            self.assertTrue(job.hasTables)
            end()
            self.assertFalse(job.hasTables)

    def test_places_need_no_points(self):
        """Once places were found; in any order of queries, and with any method."""
        given, places = cloud(25, 300), cloud(26, 50)
        values = given @ [2, 1]
        reference = delaunay(given.copy())
        for first in (*METHODS, "locate", "weights"):
            points = given.copy()
            made = delaunay(points)
            if first in ("locate", "weights"):
                getattr(made, first)(places)
            else:
                made.interpolate(values, places, first)
            points[:] = 5
            for method in METHODS:
                np.testing.assert_array_equal(made.interpolate(values, places, method),
                                              reference.interpolate(values, places, method))  # fmt: skip
                np.testing.assert_array_equal(made.weights(places, method).weights,
                                              reference.weights(places, method).weights)  # fmt: skip
            np.testing.assert_array_equal(made.locate(places).corners, reference.locate(places).corners)

    def test_a_new_job_has_found_no_places(self):
        """One made by a progress function shares nothing with the running one."""
        for ask in (lambda made: made.order, lambda made: made.voronoi(), lambda made: made.boxes):
            points = cloud(27, 3000)
            made, asked = delaunay(points), []

            def tell(phase, done):
                if not asked:
                    asked.append(1)
                    ask(made)

            made.interpolate(points[:, 0], [[0.5, 0.5]], progress=tell)
            points[:] *= -3
            for again in (lambda: made.interpolate(points[:, 0], [[0.5, 0.5]]), lambda: made.locate([[0.5, 0.5]]),
                          lambda: made.weights([[0.5, 0.5]])):  # fmt: skip
                self.assertRaisesRegex(RuntimeError, "points were changed", again)

    def test_odd_numbers_of_floats(self):
        for count, columns in ((101, 3), (9001, 3), (1, 3), (7, 3)):
            points = cloud(28, count, columns, np.float32)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                made = delaunay(points)
                self.assertEqual(made.neighbors.shape, made.triangles.shape)
                made = delaunay(points)
            points[-1, -1] += 1
            self.assertRaises(RuntimeError, lambda made=made: made.neighbors)


class FrozenTest(unittest.TestCase):
    def test_after_pickling(self):
        """It is not writable either."""
        made = delaunay(cloud(29, 60), segments=[[0, 1]])
        arrays = ("triangles", "neighbors", "constraint_edges", "is_constraint", "hull")
        [getattr(made, name) for name in arrays]
        made.voronoi(), made.boxes
        twin = pickle.loads(pickle.dumps(made))
        found = [getattr(twin, name) for name in arrays] + [twin.points, *twin.boxes, *vars(twin.voronoi()).values()]
        f = pickle.loads(pickle.dumps(LinearInterpolator(SQUARE, SQUARE[:, 0])))
        for array in [*found, f.values, f.points]:
            with self.assertRaises(ValueError):
                array[...] = 0

    def test_a_raster_of_one_point(self):
        with self.assertWarns(UserWarning):
            made = delaunay([[3.0, 4.0]])
        cells = made.raster(cell_size=2)
        self.assertEqual(cells, Raster((3, 4), (2, 2), (1, 1)))
        for method in METHODS:
            self.assertEqual(made.interpolate([5], cells, method).tolist(), [[5]])


if __name__ == "__main__":
    unittest.main()
