# SPDX-License-Identifier: BSD-3-Clause
"""Lifetimes: cycles, finalizers, threads, forks, the end of a program; tests that might crash in a process of their
own, with malloc's checks."""

import gc
import os
import subprocess
import sys
import unittest

import numpy as np
from adaptivehilbertdelaunay import _held, delaunay, release_memory
from adaptivehilbertdelaunay import _library as library
from arraysupport import SQUARE, cloud

# Freed memory is overwritten, and checked by malloc.
CHECKED = {**os.environ, "MALLOC_PERTURB_": "165", "MALLOC_CHECK_": "3"}

# Every kind of object that owns a job, or is owned by one, in a cycle: only the collector frees the objects of
# `made()`.
CYCLES = """
import faulthandler, gc, os, sys, threading
import numpy as np
from adaptivehilbertdelaunay import (
    LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator, _library as library, delaunay)

faulthandler.enable()
points = np.random.default_rng(1).random((500, 2))
values = points[:, 0].copy()
places = np.array([[0.4, 0.5], [0.6, 0.5]])
expected = delaunay(points).triangles
answers = []

class Owner:
    "Keeps one of its own methods beside an object, as programs do."
    def __init__(self, make):
        self.first = self.ask if make is None else None
        self.thing = make(self) if make else None
        self.again = self.ask
    def ask(self, *_):
        return None

class Asks(Owner):
    "A finalizer that asks the object, which it finds whole."
    def __del__(self, ends=sys.is_finalizing):
        try:
            answers.append(len(self.thing.neighbors) if hasattr(self.thing, "neighbors") else
                           float(self.thing(0.5, 0.5)) if callable(self.thing) else self.thing.count("triangles"))
        except ImportError:  # of NumPy's, which loads modules when something is first asked for
            if not ends():
                raise

def job(owner):
    made = library.Job()
    made.set_array("points", points)
    made.set_progress(owner.ask)
    made.set_projection(owner.ask)
    made.run()
    return made

def asked(owner):
    made = delaunay(points)
    made.neighbors, made.voronoi("bounds"), made.boxes, made.hull
    made.interpolate(values, places, "natural")
    return made

def half_made(owner):
    "The frames of an exception in a constructor keep what was begun."
    def stop(phase, done):
        raise LookupError(owner)
    for keywords in ({"progress": stop}, {"plane": lambda xyz: stop(0, 0)}, {"memory_limit": 1}):
        try:
            delaunay(points, **keywords)
        except (LookupError, MemoryError) as error:
            owner.errors = getattr(owner, "errors", []) + [error]
    return delaunay(points)

kinds = [
    lambda owner: delaunay(points), asked, job, half_made,
    lambda owner: delaunay(points, plane=lambda xyz: owner.ask(), progress=owner.ask),
    lambda owner: LinearInterpolator(points, values), lambda owner: NaturalNeighborInterpolator(points, values),
    lambda owner: NearestInterpolator(points, values)]

def made():
    for make in kinds:
        for kind in (Owner, Asks):
            kind(make)
    cycle = [delaunay(points)]
    cycle.append(cycle)
    late = Asks(None)  # older than what it asks
    late.thing = delaunay(points)

def check():
    assert np.array_equal(delaunay(points).triangles, expected)
    assert len(answers) % (len(kinds) + 1) == 0, answers
"""
WAYS = {
    "collected": "for _ in range(3):\n    made()\n    gc.collect()\nassert len(answers) == 27\ncheck()",
    "automatically": "gc.set_threshold(20, 2, 2)\nfor _ in range(20):\n    made()\ngc.collect()\ncheck()",
    "while others work": (
        "gc.disable()\nfor _ in range(3):\n    made()\n"
        "held = [delaunay(points) for _ in range(3)]\ngc.collect()\n"
        "assert all(np.array_equal(one.neighbors, held[0].neighbors) for one in held)\ncheck()"
    ),
    "in threads": (
        "gc.set_threshold(50, 2, 2)\nsys.setswitchinterval(1e-5)\nbarrier = threading.Barrier(4)\n"
        "def work():\n    barrier.wait()\n    for _ in range(4):\n        made()\n        gc.collect()\n"
        "threads = [threading.Thread(target=work) for _ in range(4)]\n"
        "[one.start() for one in threads]\n[one.join() for one in threads]\ngc.collect()\ncheck()"
    ),
    "after fork": (
        "made()\nchild = os.fork()\ngc.collect()\nassert len(answers) == 9\ncheck()\n"
        "if child == 0:\n    print('survived', flush=True)\n    os._exit(0)\n"
        "assert os.waitpid(child, 0)[1] == 0"
    ),
    "at the end": "gc.disable()\nmade()\nsys.cycle = Owner(kinds[0])\nkept = Owner(kinds[2])",
}  # fmt: skip


def run(script, *arguments, **environment):
    """Python 3.12 and later warn of a fork beside threads, which is what is tested here."""
    return subprocess.run([sys.executable, "-W", "ignore:This process:DeprecationWarning", "-c", script, *arguments],
                          env={**CHECKED, **environment}, timeout=200, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, check=False)  # fmt: skip


class CycleTest(unittest.TestCase):
    def survives(self, way):
        done = run(CYCLES + WAYS[way] + "\nprint('survived')")
        self.assertEqual((done.returncode, done.stderr), (0, ""), way)
        self.assertRegex(done.stdout, "^(survived\n)+$")

    def test_collected(self):
        self.survives("collected")

    def test_automatically(self):
        self.survives("automatically")

    def test_while_others_work(self):
        self.survives("while others work")

    def test_in_threads(self):
        self.survives("in threads")

    @unittest.skipUnless(hasattr(os, "fork"), "POSIX only")
    def test_after_fork(self):
        self.survives("after fork")

    def test_at_the_end(self):
        self.survives("at the end")


class HandleTest(unittest.TestCase):
    def setUp(self):
        release_memory()

    def test_a_job_outlives_all_finalizers(self):
        """Objects made before and after the job use it in their finalizers."""
        found = []

        class Asks:
            def __del__(self):
                found.append((self.job.count("triangles"), len(self.job.array("neighbors"))))

        for _ in range(3):
            first, job, last = Asks(), library.Job(), Asks()
            job.set_array("points", SQUARE)
            job.run()
            first.job = last.job = job
            first.last, last.first = last, first
            del first, job, last
            gc.collect()
        self.assertEqual(found, [(6, 6)] * 6)

    def test_the_collector_frees_it(self):
        freed = []
        for _ in range(2):
            handle = _held.Handle()
            freed.append(handle._end)
            cycle = [handle]
            cycle.append(cycle)
        del handle, cycle
        gc.collect()
        self.assertEqual([end.alive for end in freed], [False, False])

    def test_it_is_taken_out_when_handed_on(self):
        job = library.take_job()
        handle = job._handle
        job.set_array("points", SQUARE)
        job.run()
        library.give_back(job)
        self.assertEqual(library._spare, [handle])
        for question in (job.run, lambda: job.count("points"), lambda: job.set(nmax=3), job.release):
            with self.assertRaises(library.Fault) as caught:
                question()
            self.assertEqual(caught.exception.status, library.NO_JOB)
        job.cancel()
        self.assertIs(library.take_job()._handle, handle)
        self.assertEqual(library._spare, [])

    def test_what_is_not_handed_on(self):
        job = library.take_job()
        job.cancel()
        library.give_back(job)
        self.assertEqual(library._spare, [])
        self.assertEqual(len(delaunay(SQUARE).triangles), 6)
        job = library.take_job()
        job.set_array("points", SQUARE)
        job.set_progress(lambda phase, done: library.give_back(job))
        job.run()
        self.assertEqual(job.count("triangles"), 6)
        self.assertEqual(library._spare, [])

    def test_a_finalizer_that_brings_it_back(self):
        kept = []

        class Saves:
            def __del__(self):
                kept.append(self.made)

        owner = Saves()
        owner.made, owner.itself = delaunay(SQUARE), owner
        del owner
        gc.collect()
        others = [delaunay(SQUARE), delaunay(cloud(1))]
        self.assertEqual(kept[0].neighbors.tolist(), others[0].neighbors.tolist())
        self.assertEqual(len(kept[0].order), 6)

    def test_without_memory(self):
        class None_:
            @staticmethod
            def ahd_job_new():
                return None

        library_, _held.C = _held.C, None_
        try:
            self.assertRaises(MemoryError, delaunay, SQUARE)
        finally:
            _held.C = library_
        gc.collect()

    def test_half_made(self):
        """Its repr, as debuggers show it."""
        from adaptivehilbertdelaunay import LinearInterpolator, NearestInterpolator, Triangulation

        for kind in (Triangulation, LinearInterpolator, NearestInterpolator):
            self.assertEqual(repr(kind.__new__(kind)), "<%s that was not made>" % kind.__name__)
        shown = []
        for work in (lambda: delaunay(SQUARE, progress=lambda phase, done: 1 / 0),
                     lambda: LinearInterpolator([[1]], [1]), lambda: NearestInterpolator([[1]], [1])):  # fmt: skip
            try:
                work()
            except (ZeroDivisionError, ValueError) as error:
                trace = error.__traceback__
                while trace is not None:
                    shown += [repr(value) for name, value in trace.tb_frame.f_locals.items() if name == "self"]
                    trace = trace.tb_next
        self.assertTrue({"<Triangulation that was not made>", "<LinearInterpolator that was not made>",
                         "<NearestInterpolator that was not made>"} <= set(shown), shown)  # fmt: skip


DAEMONS = """
import sys, threading
import numpy as np
from adaptivehilbertdelaunay import _library as library, delaunay
points = np.random.default_rng(1).random((200000, 2))
hear = {"progress": lambda phase, done: None, "plane": lambda xyz: None}
def work():
    while True:
        delaunay(points, **({sys.argv[1]: hear[sys.argv[1]]} if sys.argv[1] in hear else {}))
for _ in range(2):
    threading.Thread(target=work, daemon=True).start()
while len(library._at_work) < 2:
    pass
import atexit
atexit.register(lambda: print(len(delaunay(points[:9]).points)))
"""

FORKED = """
import faulthandler, os, sys, threading
import numpy as np
from adaptivehilbertdelaunay import _library as library, delaunay
faulthandler.dump_traceback_later(60, exit=True)
points = np.random.default_rng(1).random((20000, 2))
made, other = delaunay(points, threads=1), delaunay(points, threads=1)
places = np.random.default_rng(2).random((200000, 2))
job = library.Job()
handle = job._handle
job.set_array("points", points)
forked = threading.Event()
def wait(phase, done):
    forked.wait()
def ask():
    made.interpolate(points[:, 0], places, "natural", progress=wait)
def run():
    job.set_progress(wait)
    job.run()
threads = [threading.Thread(target=ask), threading.Thread(target=run)]
[one.start() for one in threads]
while len(library._at_work) < 2:
    pass
child = os.fork()
if child == 0:
    same = [(made.neighbors == other.neighbors).all(), (made.locate(places).kind == other.locate(places).kind).all()]
    job.set_array("points", points)
    job.run()
    del made
    print(all(same), job.count("inserted"), library._at_work, "freed" if handle._end.alive else "left", flush=True)
    os._exit(0)
print(os.waitpid(child, 0)[1], job._handle is handle and handle._end.alive, flush=True)
forked.set()
[one.join() for one in threads]
print(len(made.neighbors) == len(other.neighbors), job.count("inserted"))
"""

FORKED_IN_A_CALLBACK = """
import faulthandler, os
import numpy as np
from adaptivehilbertdelaunay import delaunay
faulthandler.dump_traceback_later(60, exit=True)
points = np.random.default_rng(1).random((2000, 2))
made, children = delaunay(points, threads=1), []
def fork(phase, done):
    if not children:
        children.append(os.fork())
value = made.interpolate(points[:, 0], [[0.5, 0.5]], progress=fork)
right = abs(value[0] - 0.5) < 1e-9 and len(made.neighbors) == len(delaunay(points).neighbors)
if children[0] == 0:
    os._exit(0 if right else 1)
print(right, os.waitpid(children[0], 0)[1])
"""


FORKED_BY_A_CHILD = """
import os, signal, threading
import numpy as np
from adaptivehilbertdelaunay import _made, delaunay
points = np.random.default_rng(1).random((2000, 2))
made, other, count = delaunay(points), delaunay(points), len(delaunay(points).triangles)
begun, forked, leave = threading.Event(), threading.Event(), _made.Made._leave_to_the_parent
def slow(self):
    begun.set()
    forked.wait()
    leave(self)
child = os.fork()
if child == 0:
    signal.alarm(60)
    _made.Made._leave_to_the_parent = slow
    thread = threading.Thread(target=lambda: made.neighbors)
    thread.start()
    begun.wait()
    grandchild = os.fork()
    if grandchild == 0:
        signal.alarm(30)
        _made.Made._leave_to_the_parent = leave
        os._exit(0 if len(made.neighbors) == len(other.neighbors) == count else 1)
    code = os.waitpid(grandchild, 0)[1]
    forked.set()
    thread.join()
    os._exit(0 if code == 0 and len(made.neighbors) == count else 1)
print(os.waitpid(child, 0)[1], len(made.neighbors) == count)
"""


class EndTest(unittest.TestCase):
    def test_daemon_threads_at_work(self):
        """A callback that came after the interpreter's end ended the process with an error."""
        for way in ("progress", "plane", "neither"):
            done = run(DAEMONS, way)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "9\n", ""), way)

    @unittest.skipUnless(hasattr(os, "fork"), "POSIX only")
    @unittest.skipIf("AHD_TEST_EMULATED" in os.environ, "qemu-user 7.2 ends in children of processes with threads")
    def test_a_child_does_not_wait_for_its_parents_threads(self):
        done = run(FORKED)
        self.assertEqual((done.stdout, done.stderr), ("True 20000 {} left\n0 True\nTrue 20000\n", ""))

    @unittest.skipUnless(hasattr(os, "fork"), "POSIX only")
    def test_a_child_of_a_callback(self):
        done = run(FORKED_IN_A_CALLBACK)
        self.assertEqual((done.stdout, done.stderr), ("True 0\n", ""))


    @unittest.skipUnless(hasattr(os, "fork"), "POSIX only")
    @unittest.skipIf("AHD_TEST_EMULATED" in os.environ, "qemu-user 7.2 ends in children of processes with threads")
    def test_a_child_forks_while_a_thread_finds_out_that_it_is_one(self):
        done = run(FORKED_BY_A_CHILD)
        self.assertEqual((done.stdout, done.stderr), ("0 True\n", ""))


class NumPyTest(unittest.TestCase):
    def test_arrays_are_not_seen_by_the_collector(self):
        """Which Handle builds on."""
        array = np.empty(0)
        self.assertFalse(gc.is_tracked(array))


if __name__ == "__main__":
    unittest.main()
