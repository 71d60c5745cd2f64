# SPDX-License-Identifier: BSD-3-Clause
"""One object, used by several threads at once: each gets the result that it would get alone.

Threads begin at a barrier, their calls take long enough to overlap in the engine, and Python switches threads as often
as possible.
"""

import pickle
import sys
import threading
import unittest

import numpy as np

from adaptivehilbertdelaunay import LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator, delaunay
from arraysupport import attributes, cloud

POINTS = cloud(1, 8000, 3)
PLACES = cloud(2, 8000)
VALUES = POINTS[:, 2].copy()
SEGMENTS = np.arange(40).reshape(20, 2)
THREADS = 4


def make():
    return delaunay(POINTS, segments=SEGMENTS, crossings="split")


def pickled(made):
    again = pickle.loads(pickle.dumps(made))
    return [again.triangles, again.neighbors]


def weights(made):
    found = made.weights(PLACES)
    return [found.offsets, found.points, found.weights]


QUESTIONS = {
    "interpolate": lambda made: made.interpolate(VALUES, PLACES, "natural"),
    "interpolate linear": lambda made: made.interpolate(VALUES, PLACES, gradient=True),
    "interpolate nearest": lambda made: made.interpolate(VALUES, PLACES, "nearest"),
    "interpolate at points": lambda made: made.interpolate(VALUES),
    "weights": weights,
    "raster": lambda made: [np.array(made.raster(shape=(3, 4)).origin) for _ in range(40)],
    "locate": lambda made: list(made.locate(PLACES)),
    "voronoi": lambda made: [made.voronoi().points, made.voronoi("bounds").corners],
    "pickle": pickled,
    "release": lambda made: [made.release(), made.locate(PLACES[:100]).kind][1:],
}  # fmt: skip
QUESTIONS.update((name, lambda made, name=name: getattr(made, name)) for name in attributes())
QUESTIONS["boxes"] = lambda made: list(made.boxes)


def flat(answer):
    return [np.asarray(part) for part in (answer if isinstance(answer, (list, tuple)) else [answer])]


def at_once(questions, made):
    """The results of each thread; `questions`: a list for each. An exception of one is raised."""
    barrier, answers, errors = threading.Barrier(len(questions)), [[] for _ in questions], []

    def ask(k):
        barrier.wait()
        try:
            for question in questions[k]:
                answers[k].append(flat(question(made)))
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(len(questions))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if errors:
        raise errors[0]
    return answers


class TogetherTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        before = sys.getswitchinterval()
        sys.setswitchinterval(1e-6)
        cls.addClassCleanup(sys.setswitchinterval, before)
        alone = make()
        cls.alone = {name: flat(question(alone)) for name, question in QUESTIONS.items()}

    def check(self, names, answers):
        for name, answer in zip(names, answers):
            self.assertEqual(len(answer), len(self.alone[name]), name)
            for found, expected in zip(answer, self.alone[name]):
                self.assertTrue(np.array_equal(found, expected, equal_nan=found.dtype.kind in "fc"), name)

    def test_all_ask_the_same(self):
        for name, question in QUESTIONS.items():
            for answers in at_once([[question]] * THREADS, make()):
                self.check([name], answers)

    def test_all_ask_something_else(self):
        names = list(QUESTIONS)
        step = len(names) // THREADS
        for first in range(3):
            orders = [names[first + k * step :] + names[: first + k * step] for k in range(THREADS)]
            made = make()
            for order, answers in zip(orders, at_once([[QUESTIONS[name] for name in order] for order in orders], made)):
                self.check(order, answers)

    def test_interpolators(self):
        for kind in (LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator):
            expected = kind(POINTS[:, :2], VALUES)(PLACES)
            for answers in at_once([[lambda made: made(PLACES)] * 2] * THREADS, kind(POINTS[:, :2], VALUES)):
                for (found,) in answers:
                    self.assertTrue(np.array_equal(found, expected, equal_nan=True), kind)


if __name__ == "__main__":
    unittest.main()
