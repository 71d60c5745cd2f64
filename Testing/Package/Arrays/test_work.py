# SPDX-License-Identifier: BSD-3-Clause
"""Runs of delaunay: exceptions of callbacks, kept memory, threads."""

import os
import pickle
import sys
import threading
import time
import unittest

import numpy as np
from adaptivehilbertdelaunay import _library as library
from adaptivehilbertdelaunay import delaunay, release_memory
from arraysupport import SQUARE, cloud, in_a_process


class CallbackTest(unittest.TestCase):
    def test_what_progress_raises_is_raised(self):
        told = []

        def stop(phase, done):
            told.append(phase)
            if phase == "insert":
                raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            delaunay(cloud(52, 20000), progress=stop)
        self.assertEqual((told.count("insert"), told[-1]), (1, "insert"))
        with self.assertRaises(SystemExit):
            delaunay(cloud(52), progress=lambda phase, done: sys.exit(3))

    def test_what_progress_returns_means_nothing(self):
        for value in (True, False, None, "stop"):
            made = delaunay(cloud(53), progress=lambda phase, done, value=value: value)
            self.assertEqual(made.counts["inserted"], 200)

    def test_progress_ends_with_the_call(self):
        told = []
        made = delaunay(cloud(54), progress=lambda phase, done: told.append(phase))
        count = len(told)
        self.assertGreater(count, 0)
        made.neighbors, made.voronoi()
        self.assertEqual(len(told), count)

    def test_calls_within_calls(self):
        made = []
        outer = delaunay(cloud(55), progress=lambda phase, done: made.append(delaunay(SQUARE).triangles))
        self.assertEqual(outer.counts["inserted"], 200)
        for triangles in made:
            np.testing.assert_array_equal(triangles, delaunay(SQUARE).triangles)

    def test_a_job_is_busy_for_its_callbacks(self):
        job, errors = library.Job(), []
        job.set_array("points", SQUARE)

        def ask(phase, done):
            for question in (job.run, lambda: job.set(nmax=3), lambda: job.count("points"), job.release):
                try:
                    question()
                    errors.append(None)
                except library.NotAvailable as error:
                    errors.append(error.status)

        job.set_progress(ask)
        job.run()
        self.assertEqual(set(errors), {library.BUSY})

    def test_projections_of_wrong_points(self):
        """A function that returns NaN leaves points out."""
        with self.assertWarnsRegex(UserWarning, "no finite position in the plane"):
            made = delaunay(SQUARE, plane=lambda xyz: np.where(xyz[:, :1] > 3, np.nan, xyz))
        self.assertEqual(made.counts["not_finite"], 2)


class MemoryTest(unittest.TestCase):
    def setUp(self):
        release_memory()

    def test_memory_waits_for_the_next_call(self):
        points = cloud(56, 20000)
        made = delaunay(points)
        self.assertEqual(library._spare, [])
        del made
        (spare,) = library._spare
        self.assertTrue(20000 * 40 < library.C.ahd_kept_bytes(spare) <= library.REUSE_LIMIT)
        made = delaunay(points)
        self.assertEqual(library._spare, [])
        self.assertIs(made._job._handle, spare)
        two = [delaunay(points), delaunay(points)]
        del made, two
        self.assertEqual(len(library._spare), 1)
        release_memory()
        self.assertEqual(library._spare, [])

    def test_what_is_too_much_is_not_kept(self):
        self.addCleanup(setattr, library, "REUSE_LIMIT", library.REUSE_LIMIT)
        library.REUSE_LIMIT = 1000
        delaunay(cloud(57, 20000))
        self.assertEqual([library.C.ahd_kept_bytes(spare) for spare in library._spare], [0])

    def test_nothing_else_is_kept(self):
        points = cloud(58, 300, 3)
        expected = delaunay(points).triangles
        delaunay(points, source_points=cloud(59, 9), lines=[0, 1, 2], skip=np.arange(300) % 2 == 0, alpha=0.1, nmax=3,
                 plane=lambda xyz: xyz[:, [1, 2, 0]], duplicates="mean_z", want=("boxes", "voronoi"), threads=2,
                 progress=lambda phase, done: None, voronoi_clip="bounds", count_work=True)  # fmt: skip
        (spare,) = library._spare
        job = library.take_job()
        self.assertIs(job._handle, spare)
        self.assertEqual({name: job.get(name) for name in library.defaults()}, library.defaults())
        self.assertEqual((job._arrays, job._progress, job._projection), ({}, None, None))
        job.run()
        self.assertEqual(job.count("points"), 0)
        job.set(plane=library.PLANE_CALLBACK)
        with self.assertRaisesRegex(library.BadInput, "set none"):
            job.run()
        library.give_back(job)
        made = delaunay(points)
        self.assertIs(made._job._handle, spare)
        np.testing.assert_array_equal(made.triangles, expected)
        self.assertEqual(made.measures["np"], -1)

    def test_after_an_error(self):
        points = cloud(60, 300)
        for keywords in ({"memory_limit": 1}, {"plane": lambda xyz: 1 / 0}, {"progress": lambda phase, done: 1 / 0}):
            with self.assertRaises((MemoryError, ZeroDivisionError)):
                delaunay(points, **keywords)
            self.assertEqual(len(delaunay(points).hull), len(delaunay(points, threads=1).hull))

    @unittest.skipUnless(hasattr(os, "fork"), "POSIX only")
    def test_forks(self):
        """Objects made before a fork do not hinder the child."""
        script = (
            "import os, numpy\nfrom adaptivehilbertdelaunay import delaunay\n"
            "points = numpy.random.default_rng(1).random((50000, 2))\n"
            "made = delaunay(points, threads=3)\ndelaunay(points, threads=3)\n"
            "child = os.fork()\n"
            "same = (delaunay(points, threads=3).neighbors == made.neighbors).all()\n"
            "if child == 0:\n    os._exit(7 if same else 1)\n"
            "print(same, os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))\n"
        )
        done = in_a_process(script)
        self.assertEqual((done.stdout, done.returncode), ("True 7\n", 0), done.stderr)

    def test_the_end_of_a_program(self):
        """Triangulations that live until the interpreter's end, or are made there, do no harm."""
        script = (
            "import atexit, sys, numpy\nfrom adaptivehilbertdelaunay import delaunay\n"
            "points = numpy.random.default_rng(1).random((1000, 2))\n"
            "atexit.register(lambda: print(made.neighbors.shape == delaunay(points).triangles.shape))\n"
            "made = delaunay(points)\nmade.itself = made\nsys.kept = delaunay(points)\n"
        )
        done = in_a_process(script)
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("True\n", "", 0))


class ThreadTest(unittest.TestCase):
    def in_threads(self, work, count):
        """The results of `work(k)` for each k, called by as many threads at once."""
        results, errors, start = [None] * count, [], threading.Barrier(count)

        def run(k):
            try:
                start.wait()
                results[k] = work(k)
            except BaseException as error:
                errors.append(error)

        threads = [threading.Thread(target=run, args=(k,)) for k in range(count)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])
        return results

    def test_several_calls_at_once(self):
        points = [cloud(60 + k, 30000) for k in range(6)]
        expected = [delaunay(each, threads=1).triangles for each in points]
        for k, triangles in enumerate(self.in_threads(lambda k: delaunay(points[k], threads=1 + k % 3).triangles, 6)):
            np.testing.assert_array_equal(triangles, expected[k])
        for triangles in self.in_threads(lambda k: delaunay(points[0]).triangles, 6):
            np.testing.assert_array_equal(triangles, expected[0])

    def test_one_triangulation_in_several_threads(self):
        points = cloud(61, 20000)
        expected, made = delaunay(points), delaunay(points)
        places = cloud(62, 100)

        def ask(k):
            names = ["neighbors", "edges", "order", "boxes", "regions", "hull"]
            for name in names[k:] + names[:k]:
                getattr(made, name)
            made.release()
            return made.edges, made.order, made.voronoi().points, made.locate(places).triangle

        answers = self.in_threads(ask, 6)
        self.assertTrue(all(answer[0] is answers[0][0] for answer in answers))
        for answer in answers:
            for one, two in zip(answer, (expected.edges, expected.order, expected.voronoi().points,
                                         expected.locate(places).triangle)):  # fmt: skip
                np.testing.assert_array_equal(one, two)

    def test_what_one_thread_asks_waits_for_the_other(self):
        """Every query, while another thread interpolates; none is refused, and none returns before."""
        points, places, values = cloud(65, 2000), cloud(66, 3000), cloud(65, 2000)[:, 0].copy()
        questions = {
            **{name: lambda made, name=name: getattr(made, name) for name in (
                "neighbors", "edges", "boundary", "hull", "lines", "vertices", "constraint_edges", "is_constraint",
                "regions", "left_out", "crossing_ends", "crossing_fractions", "order", "insertion_ranks", "boxes",
                "points", "plane_points", "plane_matrix", "point_status", "vertex_of_point", "point_of_vertex",
                "merged")},
            "voronoi": lambda made: made.voronoi(), "voronoi in bounds": lambda made: made.voronoi("bounds"),
            "locate": lambda made: made.locate(places), "weights": lambda made: made.weights(places, "natural"),
            "raster": lambda made: made.raster(shape=(3, 3)), "release": lambda made: made.release(),
            "interpolate": lambda made: made.interpolate(values, places),
            "for all points": lambda made: made.interpolate(values),
            "with a slope": lambda made: made.interpolate(values, places, gradient=True),
            "pickle": pickle.dumps,
        }  # fmt: skip
        for name, question in questions.items():
            made = delaunay(points, threads=1)
            asking, answered, early, wrong = threading.Event(), [], [], []

            def hear(phase, done, asking=asking, answered=answered, early=early):
                asking.wait()
                if not early:
                    time.sleep(0.01)  # a query without a lock would return in this time
                    early.append(list(answered))

            def ask(made=made, question=question, asking=asking, answered=answered, wrong=wrong):
                while not library._at_work:
                    pass
                asking.set()
                try:
                    question(made)
                except Exception as error:
                    wrong.append(error)
                answered.append(True)

            other = threading.Thread(target=ask)
            other.start()
            found = made.interpolate(values, places, "natural", progress=hear)
            other.join()
            self.assertEqual((wrong, early[0], answered), ([], [], [True]), name)
            np.testing.assert_allclose(found[np.isfinite(found)], places[np.isfinite(found), 0], atol=1e-9)

    def test_many_threads_begin_at_once(self):
        """Each the same long work with one triangulation; none is refused."""
        interval = sys.getswitchinterval()
        self.addCleanup(sys.setswitchinterval, interval)
        sys.setswitchinterval(1e-6)
        points, places = cloud(67, 5000), cloud(68, 5000)
        works = (
            lambda made: made.interpolate(points[:, 0], places, "natural"), lambda made: made.weights(places).weights,
            lambda made: made.locate(places).corners, lambda made: made.neighbors, lambda made: made.order,
            lambda made: made.interpolate(points[:, 0]), lambda made: made.voronoi("bounds").points,
            lambda made: np.array(made.raster(shape=(3, 3)).bounds),
        )  # fmt: skip
        for work in works:
            made, barrier = delaunay(points), threading.Barrier(6)
            expected = work(delaunay(points))

            def begin(k, made=made, barrier=barrier, work=work):
                barrier.wait()
                return [work(made) for _ in range(3)]

            for found in self.in_threads(begin, 6):
                for one in found:
                    np.testing.assert_array_equal(one, expected)

    def test_other_threads_go_on(self):
        """The main thread runs while the other is in the engine: so they do not wait for the GIL."""
        points, seen = cloud(63, 200000), 0
        while not seen:
            worker = threading.Thread(target=delaunay, args=(points,))
            worker.start()
            while worker.is_alive():
                seen += bool(library._at_work)
            worker.join()
        self.assertGreater(seen, 0)

    def test_cancel_from_another_thread(self):
        job = library.Job()
        points = cloud(64, 200000)
        job.set_array("points", points)

        def cancel():
            while not library._at_work:
                pass
            job.cancel()

        canceller = threading.Thread(target=cancel)
        canceller.start()
        with self.assertRaises(library.Cancelled):
            while True:  # it may come between two runs: then the next one ends
                job.run()
                job.count("points")
        canceller.join()
        job.run()
        self.assertEqual(job.count("inserted"), 200000)


if __name__ == "__main__":
    unittest.main()
