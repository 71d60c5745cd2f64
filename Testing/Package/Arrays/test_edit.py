# SPDX-License-Identifier: BSD-3-Clause
"""Edit: after any history, done() is what delaunay() gives of the points and segments that are left."""

import copy
import gc
import pickle
import threading
import unittest
import warnings
from unittest import mock

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, Edit, Kind, delaunay
from adaptivehilbertdelaunay import _library as library
from arraysupport import cloud, in_a_process, lattice

INTERRUPTED = """
import signal, threading
import numpy as np
from adaptivehilbertdelaunay import Edit
from adaptivehilbertdelaunay import _library as library

points = np.random.default_rng(1).random((1000000, 2))
edit = Edit([[0, 0], [9, 0], [0, 9]])

def interrupt():
    while not library._at_work:
        pass
    signal.raise_signal(signal.SIGINT)

while len(edit) < 1000003:
    before = len(edit)
    thread = threading.Thread(target=interrupt, daemon=True)
    thread.start()
    try:
        edit.insert(points)
        edit.insert(points[:3])
    except KeyboardInterrupt:
        print("interrupted", len(edit) in (before, before + 1000000))
        break
    thread.join()
print(len(edit.insert([[1, 1]])), edit.done().counts["points"] == len(edit))
"""

# The other thread waits in a callback as long as this one forks.
FORKED = """
import os, threading
import numpy as np
from adaptivehilbertdelaunay import Edit

edit = Edit(np.random.default_rng(1).random((30000, 2)))
isThere, goesOn = threading.Event(), threading.Event()

def wait(phase, fraction):
    isThere.set()
    goesOn.wait()

edit._job.set_progress(wait)
thread = threading.Thread(target=edit.remove, args=(range(20000),))
thread.start()
isThere.wait()
child = os.fork()
if child == 0:
    try:
        print(len(edit))
    except RuntimeError as error:
        print(error)
    print(edit, flush=True)
    edit.__exit__()
    os._exit(0)
os.waitpid(child, 0)
goesOn.set()
thread.join()
assert len(edit) == 10000
"""


class History:
    """Points by id and segments, as they are to be."""

    def __init__(self, seed, columns):
        self.random = np.random.default_rng(seed)
        self.columns, self.points, self.segments = columns, {}, set()
        self.edit = Edit(np.empty((0, columns)))
        self.next = 0

    def draw(self, count):
        return self.random.integers(0, 9, (count, self.columns)) / 4

    def some(self, count):
        ends = {end for pair in self.segments for end in pair}
        free = [k for k in self.points if k not in ends]
        return self.random.permutation(free)[:count]

    def step(self):
        kind, count = self.random.integers(0, 5), self.random.integers(1, 12)
        if kind == 0 or len(self.points) < 8:
            added = self.draw(count)
            ids = self.edit.insert(added)
            self.points.update(zip(ids.tolist(), added))
            assert ids.tolist() == list(range(self.next, self.next + count))
            self.next += int(count)
        elif kind == 1:
            ids, to = self.some(count), self.draw(count)
            self.try_each(self.edit.move, ids, to[: len(ids)])
        elif kind == 2:
            self.try_each(self.edit.remove, self.some(count // 3))
        elif kind == 3:
            pairs = self.random.permutation(list(self.points))[: len(self.points) // 2 * 2].reshape(-1, 2)[:3]
            pairs = [p for p in pairs.tolist() if (self.points[p[0]][:2] != self.points[p[1]][:2]).any()]
            accepted = self.edit.constrain(pairs)
            self.segments.update(tuple(sorted(p)) for p, is_in in zip(pairs, accepted) if is_in)
        elif self.segments:
            pair = sorted(self.segments)[0]
            self.edit.release([pair[::-1]])
            self.segments.remove(pair)

    def try_each(self, change, ids, *to):
        for row, k in enumerate(ids.tolist()):
            try:
                change([k], *(array[row : row + 1] for array in to))
            except ValueError as error:
                assert "two segments meet" in str(error), error
                continue
            if to:
                self.points[k] = to[0][row]
            else:
                del self.points[k]

    def expect_fresh(self, test):
        ids = np.array(sorted(self.points), np.int64)
        test.assertEqual(self.edit.ids.tolist(), ids.tolist())
        test.assertEqual([tuple(pair) for pair in self.edit.segments.tolist()], sorted(self.segments))
        points = np.array([self.points[k] for k in ids.tolist()]).reshape(-1, self.columns)
        pairs = np.searchsorted(ids, np.array(sorted(self.segments), np.int64).reshape(-1, 2))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            fresh, made = delaunay(points, segments=pairs), self.edit.done()
        test.assertEqual(made.triangles.tobytes(), fresh.triangles.tobytes())
        test.assertEqual(made.points.tobytes(), fresh.points.tobytes())
        test.assertEqual(made.constraint_edges.tobytes(), fresh.constraint_edges.tobytes())
        test.assertEqual(made.counts["segments_crossing"], 0)


class EditTest(unittest.TestCase):
    def test_histories(self):
        for seed in range(12):
            history = History(seed, 2 + seed % 2)
            for step in range(60):
                history.step()
                if step % 6 == 0:
                    history.expect_fresh(self)

    def test_of_a_triangulation(self):
        points = cloud(1, 300, 3)
        points[7, 0] = np.nan
        for dtype, chains in ((np.int32, {}), (np.int64, {"lines": [[0, 50, 100], [3, 4, 5, 6]], "segments": [[1, 2]]}),
                              (np.int32, {"lines": np.array([[0, 50, 100], [3, 4, 5]])}),
                              (np.int32, {"lines": [5, 9, 9, 30, 7]})):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                made = delaunay(points, id_dtype=dtype, threads=1, **chains)
                edit = made.edit()
                done = edit.done()
                self.assertEqual(edit.insert([[0.5, 0.5, 3.0]]).tolist(), [300])
                edit.remove([299])
                self.assertEqual(edit.done().points[299].tolist(), [0.5, 0.5, 3.0])
            self.assertEqual(done.triangles.tobytes(), made.triangles.tobytes())
            self.assertEqual(done.triangles.dtype, dtype)
            self.assertEqual(done.constraint_edges.tobytes(), made.constraint_edges.tobytes())
            self.assertEqual(done.points.tobytes(), made.points.tobytes())

    def test_others_are_not_edited(self):
        points = cloud(1, 50, 3)
        for name, value in (("loops", [0, 1, 2]), ("plane", np.eye(4)), ("skip", np.zeros(50, bool)), ("alpha", 1.0),
                            ("tolerance", 0.01), ("duplicates", "mean_z"), ("source_points", points[:5]),
                            ("maximum_edge_length", 0.5), ("bounding", True)):
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                made = delaunay(points, **{name: value})
                self.assertRaisesRegex(ValueError, "not one with .*%s" % name, made.edit)

    def test_where_places_lie(self):
        edit = Edit(lattice(4))
        where = edit.locate([[0, 0], [0.5, 0], [0.25, 0.125], [9, 9], [np.nan, 0]])
        kinds = [Kind.ON_VERTEX, Kind.ON_EDGE, Kind.IN_TRIANGLE, Kind.OUTSIDE, Kind.NOWHERE]
        self.assertEqual(where.kind.tolist(), kinds)
        self.assertEqual((where.points >= 0).sum(axis=1).tolist(), [1, 2, 3, 0, 0])
        self.assertEqual(Edit().locate([[0, 0]]).kind.tolist(), [Kind.NOWHERE])

    def test_refusals_name_the_first(self):
        edit = Edit([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], [[0, 2]])
        for change, arguments, text in (
            (edit.remove, ([3, 9, -1],), "remove: no point has the id 9, and 1 more are refused"),
            (edit.remove, ([0],), "remove: point 0 is the end of a segment"),
            (edit.move, ([2], [[3, 3]]), "move: point 2 is the end of a segment"),
            (edit.constrain, ([[0, 4]],), r"constrain: segment \[0, 4\] has both ends at one place"),
            (edit.release, ([[0, 1]],), r"release: there is no segment \[0, 1\]"),
            (edit.move, ([1], [[3, 3], [4, 4]]), "1 ids and 2 points"),
            (edit.insert, ([[1, 2, 3]],), r"shape \(n, 2\) like the first ones"),
            (edit.constrain, ([0, 1],), r"shape \(k, 2\)"),
            (edit.remove, (np.array([2**64 - 1], np.uint64),), "no point has the id"),
            (edit.locate, ([1, 2, 3],), "places must be of shape"),
        ):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                change(*arguments)
        with self.assertRaisesRegex(TypeError, "whole numbers"):
            edit.remove([0.5])
        self.assertEqual(edit.ids.tolist(), [0, 1, 2, 4])  # 3 is gone
        edit.remove([4])  # a duplicate, and no end

    def test_nothing_and_no_triangles(self):
        edit = Edit()
        edit.remove([])
        self.assertEqual((len(edit), edit.ids.tolist(), edit.segments.tolist()), (0, [], []))
        edit.insert([[0, 0], [1, 1], [2, 2]])
        self.assertEqual(edit.constrain([[0, 2]]).tolist(), [True])
        with self.assertWarnsRegex(DelaunayWarning, "collinear"):
            self.assertEqual(len(edit.done().triangles), 0)
        edit.insert([[0, 1]])
        self.assertEqual(edit.done().constraint_edges.tolist(), [[0, 1], [1, 2]])

    def test_memory_and_progress_of_many(self):
        with self.assertRaisesRegex(MemoryError, "Editing 100000 points"):
            Edit(memory_limit="1 MB").insert(cloud(1, 100000))
        edit = Edit(cloud(1, 5), memory_limit="1 MB")
        with self.assertRaises(MemoryError):
            edit.insert(cloud(2, 100000))
        self.assertEqual(len(edit), 5)
        self.assertEqual(edit.insert(cloud(3, 5)).tolist(), [5, 6, 7, 8, 9])

    def test_columns_are_those_of_points_that_came(self):
        edit = Edit(memory_limit="2 MB")
        with self.assertRaises(MemoryError):
            edit.insert(cloud(1, 100000, 3))
        self.assertRaisesRegex(ValueError, "no point has the id 0", edit.move, [0], [[1, 2, 3]])
        self.assertEqual(edit.insert([[0, 0], [1, 0], [0, 1]]).tolist(), [0, 1, 2])
        self.assertRaisesRegex(ValueError, r"shape \(n, 2\) like the first ones", edit.move, [0], [[1, 2, 3]])
        self.assertEqual(edit.done().points.shape, (3, 2))

    def test_other_threads_go_on_where_all_points_are_looked_at(self):
        edit = Edit([[0, 0], [1, 1], [2, 2]])
        with mock.patch.object(library, "make_call", wraps=library.make_call) as made:
            calls = []
            for change in (lambda: edit.insert([[0, 1]]),  # the first one beside the line
                           lambda: edit.insert([[0, 2]]),
                           lambda: edit.remove([3, 4]),  # the last ones
                           lambda: edit.insert([[3, 3]])):
                change()
                calls.append(made.call_count)
        self.assertEqual(calls, [1, 1, 1, 2])

    def test_it_is_lost_in_a_child_if_it_was_at_work(self):
        said = in_a_process(FORKED).stdout
        self.assertIn("at work in another thread when the process was forked", said)
        self.assertIn("<Edit, closed>\n", said)

    def test_ctrl_c(self):
        said = in_a_process(INTERRUPTED).stdout.split("\n")
        self.assertEqual([line for line in said if line], ["interrupted True", "1 True"])

    def test_as_an_object(self):
        with Edit(cloud(1, 20)) as edit:
            self.assertEqual(repr(edit), "<Edit of 20 points and 0 segments>")
            made = edit.done()
            for copied in (copy.copy, copy.deepcopy, pickle.dumps):
                self.assertRaisesRegex(TypeError, "cannot be copied", copied, edit)
        self.assertEqual(repr(edit), "<Edit, closed>")
        self.assertRaisesRegex(ValueError, "closed", edit.insert, [[0, 0]])
        self.assertEqual(made.edges.shape[1], 2)  # which is its own
        self.assertEqual(len(Edit()), 0)  # with the job that was given back

    def test_it_is_freed_in_cycles(self):
        for _ in range(3):
            edit = Edit(cloud(1, 1000))
            edit.itself = edit
            del edit
        gc.collect()

    def test_threads_have_their_own(self):
        found = []

        def work(seed):
            edit = Edit(cloud(seed, 2000))
            edit.move(np.arange(500), cloud(seed + 10, 500))
            found.append(edit.done().triangles.tobytes() == delaunay(
                np.concatenate((cloud(seed + 10, 500), cloud(seed, 2000)[500:]))).triangles.tobytes())

        threads = [threading.Thread(target=work, args=(seed,)) for seed in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [True] * 4)


if __name__ == "__main__":
    unittest.main()
