# SPDX-License-Identifier: BSD-3-Clause
"""A job that is used again equals a new one: settings and arrays change at random, runs are cancelled, results are
requested in any order; each is that of a new job.
"""

import os
import re
import unittest

import numpy as np

from adaptivehilbertdelaunay import _library as library
from arraysupport import ROOT, TABLE, drawn_by

STEPS, SEEDS = 40, range(1, 9)
# Of memory, and those that questions set.
OTHERS = ("memory_limit", "other_memory", "other_memory_per_point", "want_samples", "sample_method", "sample_outside",
          "sample_first_column", "sample_first_row", "threads")  # fmt: skip
# Values to draw from, where these say more than all of a choice, or the default and a fifth.
BETTER = {
    "plane": (0, 0, 1, 2), "bounding": (0, 0, 1), "nmax": (1, 7, 50), "insertion_limit": (0, 0, 40),
    "maximum_vertices": (0, 0, 40), "maximum_error": (0.0, 0.0, 0.2),
    "tolerance": (0.0, 0.0, 0.02), "unfitted_points": (0, 0, 5, 1 << 40), "skip_mask": (255, 2), "first_cell": (0, 7),
    "offset": (1.0, 3.0),
}  # fmt: skip


def values_of(row):
    if row["type"] == "double":
        return row["default"], row["default"], row["default"] + 0.2
    choices = tuple(range(row["least"], row["most"] + 1))
    return choices + (1,) if row["type"] in ("bool", "flag") else choices


SETTINGS = {name: BETTER.get(name) or values_of(row) for name, row in TABLE["job"].items() if name not in OTHERS}
# With a surface there are no others of these.
ALONE = {name: row["on_surface"] for name, row in TABLE["job"].items()
         if "on_surface" in row and row["type"] == "double"}  # fmt: skip
ALONE.update(bounding=0, insertion_limit=0, rim=library.RIM_CONVEX_HULL)
# Depend on the machine, the moment, or how the work was shared.
OTHER_COUNTS = {"memory_estimate", "memory_allowed", "most_boxes", "most_crossings", "threads_used", "dispatch_target"}
PLACES = np.random.default_rng(5).random((25, 2)) * 1.4 - 0.2


def new_arrays(numbers):
    """Arrays that may fit together."""
    count, own = int(numbers.choice([0, 1, 3, 20, 151])), int(numbers.integers(0, 12))
    dtype = numbers.choice([np.float32, np.float64])
    points = numbers.random((count, int(numbers.integers(2, 4)))).astype(dtype)
    if count > 9 and numbers.random() < 0.5:
        points[5:9] = points[0]
        points[7, 1] = np.nan
    made = {"points": points, "skip": None, "source_points": None, "line_ids": None, "line_offsets": None,
            "loop_ids": None, "loop_offsets": None, "matrix": np.array(np.eye(4)[[1, 2, 0, 3]]),
            "voronoi_polygon": numbers.random((3, 2)), "surface": None, "surface_edges": None, "cells": None,
            "cell_offsets": None, "cell_groups": None, "values": None, "weights": None, "keep": None,
            "rank_bounds": np.array([[-1.0, 2.0], [-1.0, 3.0]]) if own > 6 else None}  # fmt: skip
    if numbers.random() < 0.3:
        made.update(values=numbers.random(count).astype(dtype), weights=numbers.random(count) * 2 - 0.1,
                    keep=(numbers.random(count) < 0.1).astype(np.uint8))  # fmt: skip
    if count and numbers.random() < 0.3:
        made.update(surface_of(points, numbers))
        return made
    if numbers.random() < 0.3:
        made["skip"] = (numbers.random(count) < 0.2).astype(np.uint8)
    if numbers.random() < 0.5:
        made["source_points"] = numbers.random((own, 3))
    if count and numbers.random() < 0.5:
        made["cells"] = numbers.integers(0, count, (7, 3))
        made["cell_groups"] = numbers.choice([0.0, 1.0, np.nan], 7) if numbers.random() < 0.5 else None
    for kind in ("line", "loop"):
        if count and numbers.random() < 0.5:
            made[kind + "_ids"] = numbers.integers(0, min(count, own + 1), 8)
            made[kind + "_offsets"] = np.array([0, 3, 8])
    return made


def surface_of(points, numbers):
    """Some triangles of these points, with one that may be folded, and constraints among their edges."""
    job = library.Job()
    job.set_array("points", points)
    job.run()
    triangles = job.array("triangles")
    triangles = triangles[numbers.random(len(triangles)) < 0.7]
    if len(triangles) and numbers.random() < 0.2:
        triangles[0] = triangles[0, ::-1]
    return {"surface": triangles, "surface_edges": numbers.integers(0, 8, len(triangles)).astype(np.uint8)}


def interpolated(job):
    values = np.arange(job.count("points") * 2.0).reshape(-1, 2)
    job.interpolate(values)
    return [values]


QUESTIONS = {
    "locate": lambda job: list(job.locate(PLACES)),
    "weights": lambda job: (job.sample_weights(PLACES, library.SAMPLE_NATURAL_NEIGHBOR), job.array("weights"))[1:],
    "drawing": lambda job: list(drawn_by(job, np.int32).values()),
    "at points": interpolated,
    "counts": lambda job: [np.array([job.count(n) for n in library.names(library.COUNTS) if n not in OTHER_COUNTS
                                     and not n.startswith("sampl")])],
    "measures": lambda job: [np.array([job.measure(n) for n in library.names(library.MEASURES)
                                       if not n.startswith("seconds")])],
}  # fmt: skip
QUESTIONS.update((name, lambda job, name=name: [job.array(name)]) for name in library.names(library.OUTPUT_ARRAYS)
                 if not name.startswith(("weight", "outline")))  # fmt: skip


def outlined(job):
    job.outline()
    return [job.array(name) for name in library.names(library.OUTPUT_ARRAYS) if name.startswith("outline")]


QUESTIONS["outline"] = outlined


def sampled(job, method, outside):
    values = np.sin(np.arange(job.count("points") * 2.0)).reshape(-1, 2)
    found = job.sample(PLACES, [values], method=method, outside=outside, gradients=method == library.SAMPLE_LINEAR)
    return [*found.values, *(slope for slope in found.gradients if slope is not None), found.mask]


for method in range(4):
    for outside in range(3):
        QUESTIONS["sampled %d %d" % (method, outside)] = (
            lambda job, method=method, outside=outside: sampled(job, method, outside))  # fmt: skip


def answer(job, question):
    try:
        return [np.array(part) for part in question(job)]
    except library.EngineError as error:
        return [np.array("%s: %s" % (type(error).__name__, error))]


class AgainTest(unittest.TestCase):
    def compare(self, used, fresh, name, about):
        found, expected = (answer(job, QUESTIONS[name]) for job in (used, fresh))
        self.assertEqual(len(found), len(expected), (name, *about))
        for one, other in zip(found, expected):
            self.assertEqual((one.shape, one.dtype, one.tobytes()), (other.shape, other.dtype, other.tobytes()),
                             (name, one, other, *about))

    def check_nothing_is_there(self, job):
        for name in ("triangles", "locate", "counts", "sampled 0 0"):
            self.assertIn("NotAvailable", str(answer(job, QUESTIONS[name])[0]))

    def test_random_uses(self):
        results = 0
        for seed in SEEDS:
            numbers = np.random.default_rng(seed)
            used, settings, arrays = library.Job(), {"threads": 1, **ALONE}, new_arrays(numbers)
            is_to_be_cancelled = False
            for step in range(STEPS):
                for name in numbers.choice(list(SETTINGS), 4):
                    settings[str(name)] = numbers.choice(SETTINGS[str(name)]).item()
                if numbers.random() < 0.6:
                    arrays = new_arrays(numbers)
                fresh = library.Job()
                is_cancelled = is_to_be_cancelled or numbers.random() < 0.2
                given = arrays["surface"] is not None and len(arrays["surface"]) and numbers.random() < 0.9
                for job in (used, fresh):
                    job.set(**dict(settings, **ALONE) if given else settings)
                    for name, array in arrays.items():
                        job.set_array(name, array)
                    if is_cancelled:
                        job.cancel()  # the next call, which is the run
                ends = [answer(job, lambda job: [np.array(job.run() is None)])[0].tolist() for job in (used, fresh)]
                self.assertEqual(*ends, (seed, step))
                is_to_be_cancelled = is_cancelled and "Cancelled" not in str(ends[0])  # a run that was refused was not
                if ends[0] is not True:
                    self.check_nothing_is_there(used)
                results += ends[0] is True
                names = list(QUESTIONS)
                numbers.shuffle(names)
                for name in names[: int(numbers.choice([3, len(names)]))]:
                    self.compare(used, fresh, name, (seed, step, settings))
                if numbers.random() < 0.2:
                    used.release(int(numbers.choice([0, 1 << 28])))
                    self.check_nothing_is_there(used)
        self.assertGreater(results, STEPS)


class NamesTest(unittest.TestCase):
    """A new input array of the library must be set here and by the fuzzers."""

    NAMES = {name for kind in (library.INT_SETTINGS, library.DOUBLE_SETTINGS, library.INPUT_ARRAYS)
             for name in library.names(kind)}
    OF_OUTLINES = {"cells", "cell_offsets", "cell_groups"}  # Engine/Outline/ has tests of its own
    NOT_OF_RESULTS = {"progress_delay", "memory_limit", "other_memory", "other_memory_per_point", "want_samples"}

    def test_here(self):
        given = {*SETTINGS, *OTHERS, *new_arrays(np.random.default_rng(1))}
        self.assertEqual(self.NAMES - given, set())

    def test_by_the_fuzzers(self):
        given = set()
        for path in (("Fuzz", "JobJudge.cxx"), ("Support", "Run", "JobRun.cxx")):
            with open(os.path.join(ROOT, "Testing", *path), encoding="utf-8") as file:
                given.update(re.findall(r'"(\w+)"', file.read()))
        self.assertEqual(self.NAMES - given - self.OF_OUTLINES, self.NOT_OF_RESULTS)  # "cells" is a count, too


if __name__ == "__main__":
    unittest.main()
