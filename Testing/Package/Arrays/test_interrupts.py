# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C during delaunay."""

import signal
import sys
import threading
import unittest
import unittest.mock

import numpy as np
from adaptivehilbertdelaunay import _calls
from adaptivehilbertdelaunay import _library as library
from adaptivehilbertdelaunay import delaunay
from arraysupport import SQUARE, cloud, in_a_process

# Interrupts itself while the engine runs in the main thread, and returns the outcome.
INTERRUPTED = """
import signal, sys, threading
import numpy as np
from adaptivehilbertdelaunay import _library as library

job = library.Job()
points = np.random.default_rng(1).random((1500000, 2))
job.set_array("points", points)

class Stop(Exception):
    pass

def stop(number, frame):
    raise Stop

if sys.argv[1] == "handler":
    signal.signal(signal.SIGINT, stop)
handler = signal.getsignal(signal.SIGINT)

def change(number, frame):
    signal.signal(signal.SIGINT, stop)
    threading.Timer(0.01, interrupt).start()  # when this has returned to the engine

if sys.argv[1] == "changed":  # by the first signal, which sends another
    signal.signal(signal.SIGINT, change)
    handler = stop

def interrupt():
    while not library._at_work:  # waits for the GIL, which the main thread gives away when it is in the engine
        pass
    signal.raise_signal(signal.SIGINT)

while True:
    if threading.active_count() == 1:
        threading.Thread(target=interrupt, daemon=True).start()
    try:
        job.run()
    except (KeyboardInterrupt, Stop) as error:
        print(type(error).__name__)
        break
try:
    job.count("inserted")
except library.NotAvailable:
    print("it was stopped")
print(signal.getsignal(signal.SIGINT) is handler)
job.run()
print(job.count("inserted"))
"""

FEW_POINTS = """
import signal, threading
import numpy
from adaptivehilbertdelaunay import _library as library, delaunay

def interrupt():
    while not library._at_work:
        pass
    signal.raise_signal(signal.SIGINT)

numbers = numpy.random.default_rng(1)
threading.Thread(target=interrupt, daemon=True).start()
try:
    segments = numbers.integers(0, library.FEW // 2, (library.FEW, 2)) * 2 + [0, 1]
    for each in range(100):
        delaunay(numbers.random((library.FEW, 2)), segments=segments, crossings="split")
    print("went on")
except KeyboardInterrupt:
    print("KeyboardInterrupt")
"""


class InterruptTest(unittest.TestCase):
    def test_control_c(self):
        """Cancels the engine, raises the exception of its handler, and none is lost."""
        for how, name in (("default", "KeyboardInterrupt"), ("handler", "Stop"), ("changed", "Stop")):
            done = in_a_process(INTERRUPTED, how)
            self.assertEqual(done.stdout.split("\n"), [name, "it was stopped", "True", "1500000", ""], done.stderr)
            self.assertEqual(done.stderr, "")

    def test_control_c_ends_a_program(self):
        script = (
            "import signal, numpy\nfrom adaptivehilbertdelaunay import delaunay\n"
            "delaunay(numpy.random.default_rng(1).random((100000, 2)),\n"
            "         progress=lambda phase, done: phase == 'insert' and signal.raise_signal(signal.SIGINT))\n"
            "print('went on')\n"
        )
        done = in_a_process(script)
        code = 0xC000013A if sys.platform == "win32" else -signal.SIGINT  # as other programs that Ctrl-C ended
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertIn("KeyboardInterrupt", done.stderr)
        self.assertNotIn("ignored", done.stderr)

    def test_a_handler_that_returns_stops_nothing(self):
        called = []
        before = signal.signal(signal.SIGINT, lambda number, frame: called.append(number))
        self.addCleanup(signal.signal, signal.SIGINT, before)
        told = []

        def once(phase, done):
            if phase == "insert" and phase not in told:
                signal.raise_signal(signal.SIGINT)
            told.append(phase)

        self.assertEqual(delaunay(cloud(51, 20000), progress=once).counts["inserted"], 20000)
        self.assertEqual(called, [signal.SIGINT])

    def test_a_handler_that_is_changed(self):
        """By the handler or by a callback: it remains installed, and works during the run."""
        for change_in in ("handler", "callback"):
            heard = []

            def second(number, frame, heard=heard):
                heard.append("second")
                raise LookupError

            def first(number, frame, heard=heard, second=second, change_in=change_in):
                heard.append("first")
                if change_in == "handler":
                    signal.signal(signal.SIGINT, second)

            before = signal.signal(signal.SIGINT, first)
            self.addCleanup(signal.signal, signal.SIGINT, before)

            def press(phase, done, heard=heard, second=second, change_in=change_in):
                if phase == "insert" and len(heard) < 2:
                    signal.raise_signal(signal.SIGINT)
                if phase == "insert" and change_in == "callback":
                    signal.signal(signal.SIGINT, second)

            with self.assertRaises(LookupError):
                delaunay(cloud(51, 20000), progress=press)
            self.assertEqual(heard, ["first", "second"])
            self.assertIs(signal.getsignal(signal.SIGINT), second)

    def test_a_handler_that_is_ignored_from_now_on(self):
        def once(number, frame):
            signal.signal(signal.SIGINT, signal.SIG_IGN)

        before = signal.signal(signal.SIGINT, once)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        delaunay(cloud(51, 20000), progress=lambda phase, done: signal.raise_signal(signal.SIGINT))
        self.assertEqual(signal.getsignal(signal.SIGINT), signal.SIG_IGN)

    def test_a_handler_that_was_looked_up_during_the_work(self):
        """And is restored afterwards: it raises what the program's raises."""
        def stop(number, frame):
            raise LookupError

        before, found = signal.signal(signal.SIGINT, stop), []
        self.addCleanup(signal.signal, signal.SIGINT, before)
        delaunay(SQUARE, progress=lambda phase, done: found.append(signal.getsignal(signal.SIGINT)))
        self.assertIs(signal.getsignal(signal.SIGINT), stop)
        signal.signal(signal.SIGINT, found[0])
        with self.assertRaises(LookupError):
            signal.raise_signal(signal.SIGINT)
            signal.getsignal(signal.SIGINT)

    def press_everywhere(self, begin, work, after):
        """Begins with a job, presses after each call of the package in work(job), and says how often. No job stays
        running; after(job) follows."""
        handler, tried = signal.getsignal(signal.SIGINT), 0
        while True:
            job, left = library.Job(), [tried + 1]
            begin(job)

            def press(frame, event, argument, left=left):
                if event != "c_call" and str(frame.f_globals.get("__name__")).startswith("adaptivehilbertdelaunay"):
                    left[0] -= 1
                    if left[0] == 0:
                        signal.raise_signal(signal.SIGINT)

            before = sys.getprofile()
            sys.setprofile(press)
            try:
                work(job)
                wasRaised = False
            except KeyboardInterrupt:
                wasRaised = True
            finally:
                sys.setprofile(before)
            if left[0] > 0:
                return tried
            tried += 1
            self.assertTrue(wasRaised, tried)
            self.assertEqual((library._at_work, signal.getsignal(signal.SIGINT)), ({}, handler), tried)
            after(job, tried)

    def test_wherever_it_comes(self):
        """The next run is unaffected: of few points, which is not interrupted, and of more."""
        for points, least in ((SQUARE, 5), (cloud(51, library.FEW + 1), 25)):
            def run_again(job, tried, points=points):
                job.run()
                self.assertEqual(job.count("inserted"), len(points), tried)

            tried = self.press_everywhere(
                lambda job, points=points: job.set_array("points", points), lambda job: job.run(), run_again)
            self.assertGreater(tried, least)

    def test_wherever_it_comes_after_a_progress_function(self):
        """The next one is told."""
        told = []

        def begin(job):
            job.set_array("points", SQUARE)
            job.set_progress(lambda phase, done: told.append(phase))
            job.run()
            job.set_progress(None)

        def run_again(job, tried):
            told.clear()
            job.set_progress(lambda phase, done: told.append(phase))
            job.run()
            self.assertTrue(told, tried)

        self.assertGreater(self.press_everywhere(begin, lambda job: job.run(), run_again), 8)

    def test_few_places_with_many_values(self):
        """Are work that may take long: it is cancelled, and others go on meanwhile."""
        made, places = delaunay(SQUARE), cloud(1, library.FEW)
        with unittest.mock.patch.object(library, "make_call", wraps=library.make_call) as long:
            made.interpolate(np.ones((len(SQUARE), library.FEW_NUMBERS // library.FEW)), places)
            self.assertFalse(long.called)
            made.interpolate(np.ones((len(SQUARE), library.FEW_NUMBERS // library.FEW + 1)), places)
            self.assertTrue(long.called)

    def test_few_points_with_many_weights(self):
        made, places = delaunay(SQUARE), np.full((library.FEW_NUMBERS, 2), 0.3)
        with unittest.mock.patch.object(library, "make_call", wraps=library.make_call) as long:
            made.weights(places)
        names = [call.args[2][0] for call in long.call_args_list if call.args[2][0] in (b"weights", b"weight_points")]
        self.assertEqual(names, [b"weight_points", b"weights"])

    def test_few_places_when_the_tables_are_ready(self):
        """Of another method, the library may make those of this one first."""
        made, few = delaunay(cloud(1, 20000)), cloud(2, 9)
        for method, isLong in (("natural", True), ("linear", False), ("natural", True)):
            made.weights(few, method=method)
            with unittest.mock.patch.object(library, "make_call", wraps=library.make_call) as long:
                made.interpolate(made.points[:, 0], few)
            self.assertEqual(long.called, isLong, method)

    def test_what_looks_at_all_triangles(self):
        """Is work that may take long, of few points, too."""
        made = delaunay(SQUARE)
        with unittest.mock.patch.object(library, "make_call", wraps=library.make_call) as long:
            made.refine(20)
            made.weights(SQUARE)
            made.outline()
        names = {call.args[1].__name__ for call in long.call_args_list}
        wanted = "refine refine_write refine_triangles sample_weights outline"
        self.assertLessEqual({"ahd_" + name for name in wanted.split()}, names)

    def test_few_places_when_the_program_ends(self):
        """A daemon thread ends before them, without a message, though another one's work was cancelled."""
        made, ends = delaunay(SQUARE), []
        made._job.cancel()

        def work():
            try:
                made.interpolate(np.ones(len(SQUARE)), SQUARE)
            except BaseException as error:
                ends.append(type(error))

        thread = threading.Thread(target=work, daemon=True)
        with unittest.mock.patch.object(_calls, "_isEnding", True):
            thread.start()
            thread.join()
        self.assertEqual(ends, [SystemExit])

    def test_few_points_whose_work_is_long(self):
        """Because of their constraints: it is cancelled."""
        done = in_a_process(FEW_POINTS)
        self.assertEqual((done.stdout, done.stderr), ("KeyboardInterrupt\n", ""))

    def test_wherever_it_comes_while_values_are_found(self):
        """The next values are those of their own method."""
        places, values = SQUARE * 0.9 + 0.02, SQUARE[:, 0] + SQUARE[:, 1] ** 2

        def begin(job):
            job.set_array("points", SQUARE)
            job.run()

        def sample(job, method=library.SAMPLE_LINEAR):
            return job.sample(places, [values], method=method).values[0].tolist()

        job = library.Job()
        begin(job)
        expected = sample(job)
        self.assertNotEqual(sample(job, library.SAMPLE_NEAREST), expected)
        tried = self.press_everywhere(
            begin, lambda job: sample(job, library.SAMPLE_NEAREST),
            lambda job, tried: self.assertEqual(sample(job), expected, tried))
        self.assertGreater(tried, 25)

    def test_calls_within_calls(self):
        """All are cancelled, the inner one at once, and the program's handler is restored."""
        told, outcome, handler = [], [], signal.getsignal(signal.SIGINT)

        def press(phase, done):
            if not told:
                signal.raise_signal(signal.SIGINT)
            told.append(phase)

        def call(phase, done):
            try:
                outcome.append(delaunay(cloud(57), progress=press))
            except KeyboardInterrupt as error:
                outcome.append(error)

        with self.assertRaises(KeyboardInterrupt) as caught:
            delaunay(cloud(58), progress=call)
        self.assertEqual((len(told), outcome), (1, [caught.exception]))
        self.assertIs(signal.getsignal(signal.SIGINT), handler)

    def test_a_callback_that_asks_afterwards(self):
        """A call refused because the job is running does not lose the interrupt."""
        job, told = library.Job(), []
        job.set_array("points", SQUARE)

        def press(phase, done):
            signal.raise_signal(signal.SIGINT)
            self.assertRaises(library.NotAvailable, job.run)
            told.append(phase)

        job.set_progress(press)
        self.assertRaises(KeyboardInterrupt, job.run)
        self.assertEqual(len(told), 1)

    def test_ignored_stays_ignored(self):
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        delaunay(SQUARE)
        self.assertEqual(signal.getsignal(signal.SIGINT), signal.SIG_IGN)


if __name__ == "__main__":
    unittest.main()
