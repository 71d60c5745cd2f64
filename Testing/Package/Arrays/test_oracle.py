# SPDX-License-Identifier: BSD-3-Clause
"""delaunay: random inputs of all kinds, against the definition of the constrained Delaunay triangulation in exact
arithmetic, with an oracle that tries all pairs and triples.

    test_oracle.py [--cases N]       N cases in place of those of the quick suite
"""

import itertools
import sys
import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import delaunay
from arraysupport import complaints, hull_of, in_circle, integers, orient, twice_area

CASES = 120


def random_points(random):
    """Few points, degenerate ones among them."""
    count = int(random.integers(0, 14))
    kind = random.integers(0, 5)
    if kind == 0:
        points = random.random((count, 2))
    elif kind == 1:
        points = random.integers(0, 4, (count, 2)).astype(float)
    elif kind == 2:
        points = (random.integers(0, 5, (count, 2)) * 0.1).astype(random.choice([np.float32, np.float64]))
    elif kind == 3:
        points = np.column_stack((np.arange(count), np.arange(count) / 3)) + (random.random((count, 2)) < 0.2) * 1e-15
    else:
        points = random.random((count, 3)) * 2.0 ** random.integers(-300, 300)
    if count and random.random() < 0.2:
        points[random.integers(count), random.integers(2)] = random.choice([np.nan, np.inf, -np.inf])
    return points


def random_chains(random, count):
    """Segments, lines and loops of these points."""

    def chain(least):
        return random.integers(0, count, int(random.integers(least, 6))).tolist()

    if count == 0:
        return {}
    return {
        "segments": random.integers(0, count, (int(random.integers(0, 3)), 2)),
        "lines": [chain(0) for _ in range(random.integers(0, 2))],
        "loops": [chain(3) for _ in range(random.integers(0, 2))],
    }


def between(a, b, p):
    """Is p on the segment from a to b, its ends excluded?"""
    return orient(a, b, p) == 0 and min(a, b) < p < max(a, b)


def cross(a, b, c, d):
    """Do two segments have one point in common that is an end of neither?"""
    return orient(a, b, c) * orient(a, b, d) < 0 and orient(c, d, a) * orient(c, d, b) < 0


class Oracle:
    """The expected result: places, vertices, the constraint edges."""

    def __init__(self, points, chains):
        self.finite = [k for k, point in enumerate(points) if np.isfinite(point[:2]).all()]
        every = dict(zip(self.finite, integers([points[k] for k in self.finite])))
        self.places = [every.get(k) for k in range(len(points))]
        self.vertices = sorted(set(every.values()))
        self.edges, self.left_out, self.without = set(), 0, 0
        for chain, closed in self.rows(chains):
            for a, b in zip(chain, chain[1:] + (chain[:1] if closed else [])):
                self.constrain(self.places[a], self.places[b])

    @staticmethod
    def rows(chains):
        for name in ("segments", "lines", "loops"):
            for row in chains.get(name, ()):
                row = list(map(int, row))
                yield row, name == "loops" and len(row) > 1 and row[0] != row[-1]

    def constrain(self, a, b):
        if a is None or b is None:
            self.without += 1
        elif a != b:
            if any(cross(a, b, *edge) for edge in self.edges):
                self.left_out += 1
                return
            on = sorted([a, b] + [p for p in self.vertices if between(a, b, p)])
            self.edges |= set(zip(on, on[1:]))

    def has_area(self):
        return any(orient(*three) != 0 for three in itertools.combinations(self.vertices, 3))

    def visible(self, a, b):
        return not any(cross(a, b, *edge) for edge in self.edges)

    def is_in(self, corners):
        """Is this triangle one of a constrained Delaunay triangulation? By definition: no vertex visible from its
        inside lies in its circle. Visibility from its corners and edges suffices, which no constraint crosses."""
        middle = tuple(sum(c) for c in zip(*corners))
        for p in self.vertices:
            if in_circle(*corners, p) > 0:
                third = [tuple(3 * x for x in edge[0]) + tuple(3 * x for x in edge[1]) for edge in self.edges]
                tripled = tuple(3 * x for x in p)
                if not any(self.blocks(middle, tripled, e[:2], e[2:]) for e in third):
                    return False
        return True

    @staticmethod
    def blocks(a, b, c, d):
        return orient(a, b, c) * orient(a, b, d) <= 0 and orient(c, d, a) * orient(c, d, b) < 0


class OracleTest(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("ignore")
        self.addCleanup(warnings.resetwarnings)

    def check(self, points, chains):
        made = delaunay(points, **chains, fill_rule="even_odd")
        whole = delaunay(points, **{**chains, "lines": self.opened(chains), "loops": None})
        expected = Oracle(points, chains)
        counts = made.counts
        self.assertEqual(counts["inserted"], len(expected.vertices))
        self.assertEqual(counts["inserted"] + counts["duplicates"], len(expected.finite))
        if not expected.has_area():
            self.assertEqual(len(made.triangles), 0)
            return
        self.assertEqual((counts["segments_crossing"], counts["segments_without_vertex"]),
                         (expected.left_out, expected.without))  # fmt: skip
        self.assertEqual(counts["constraint_edges"], len(expected.edges))
        places = expected.places
        found = {tuple(sorted((places[a], places[b]))) for a, b in whole.constraint_edges.tolist()}
        self.assertEqual(found, expected.edges)
        fixed = [place or (0, 0) for place in places]
        self.assertEqual(complaints(np.where(np.isfinite(points), points, 0), whole.triangles, whole.neighbors,
                                    whole.is_constraint), [])  # fmt: skip
        hull = hull_of(expected.vertices)
        self.assertEqual(twice_area(fixed, whole.triangles.tolist()),
                         twice_area(hull, [(0, k, k + 1) for k in range(1, len(hull) - 1)]))  # fmt: skip
        for triangle in whole.triangles.tolist():
            self.assertTrue(expected.is_in([places[i] for i in triangle]))
        kept = {tuple(triangle) for triangle in made.triangles.tolist()}
        self.assertLessEqual(kept, {tuple(triangle) for triangle in whole.triangles.tolist()})

    @staticmethod
    def opened(chains):
        """Lines in place of loops: nothing is dropped then."""
        lines = [list(map(int, row)) for row in chains.get("lines", ())]
        loops = [list(map(int, row)) for row in chains.get("loops", ())]
        return lines + [row + row[:1] if len(row) > 1 and row[0] != row[-1] else row for row in loops]

    def test_random_cases(self):
        for seed in range(CASES):
            random = np.random.default_rng(seed)
            points = random_points(random)
            chains = random_chains(random, len(points)) if seed % 3 else {}
            with self.subTest(seed=seed, points=points.tolist(), **chains):
                self.check(points, chains)

    def test_kept_by_even_odd(self):
        """Inside is where a ray from the triangle crosses the loops an odd number of times."""
        for seed in range(CASES):
            random = np.random.default_rng(10**6 + seed)
            points = random.random((20, 2))
            loops = [random.permutation(20)[:4].tolist() for _ in range(1 + seed % 2)]
            made = delaunay(points, loops=loops, crossings="split")
            whole = delaunay(points, lines=[loop + loop[:1] for loop in loops], crossings="split")
            np.testing.assert_array_equal(made.points, whole.points)
            kept = {tuple(triangle) for triangle in made.triangles.tolist()}
            for triangle in whole.triangles.tolist():
                x, y = made.points[triangle].mean(axis=0)
                odd = False
                for loop in loops:
                    corners = points[loop]
                    for (ax, ay), (bx, by) in zip(corners, np.roll(corners, -1, axis=0)):
                        odd ^= bool((ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay))
                area = orient(*made.points[triangle])
                if area > 1e-9:  # a ray from a smaller one cannot be trusted
                    self.assertEqual(tuple(triangle) in kept, odd, (seed, triangle))


if __name__ == "__main__":
    if "--cases" in sys.argv:
        at = sys.argv.index("--cases")
        CASES = int(sys.argv[at + 1])
        del sys.argv[at : at + 2]
    unittest.main()
