# SPDX-License-Identifier: BSD-3-Clause
"""The results are those of the engine, byte for byte: rows of Data/Hashes/Engine.txt, as Testing/Engine/README.md
describes them."""

import unittest
import warnings

import numpy as np
from adaptivehilbertdelaunay import Raster, delaunay
from adaptivehilbertdelaunay import _library as library
from arraysupport import Hash, Random, corpus, expected_hashes, lattice, uniform

EXPECTED = expected_hashes()
OK = 0  # the status of each call of the engine is hashed as well


def add_written(hashed, made):
    """Status of the three writes excepted."""
    counts = made.counts
    names = ("inserted", "beyond_limit", "duplicates", "not_finite", "skipped")
    hashed.add(*(counts[name] for name in names), len(made.triangles))
    hashed.vector(made.triangles)
    hashed.vector(made.point_status)
    hashed.vector(made.neighbors)


def hash_of_triangles(points, **settings):
    made, hashed = delaunay(points, **settings), Hash()
    hashed.add(OK, OK, OK, OK)
    add_written(hashed, made)
    return hashed.text()


def hash_of_constrained(points, chains, rule):
    made, hashed = delaunay(points, fill_rule=rule, **chains), Hash()
    counts = made.counts
    hashed.add(OK, OK)
    names = ("segments", "segments_of_no_length", "segments_without_vertex", "segments_crossing", "unfilled_loops")
    hashed.add(*(counts[name] for name in names), counts["constraint_edges"])
    hashed.numbers(made.left_out)
    hashed.add(OK, OK, OK)
    add_written(hashed, made)
    hashed.add(OK, OK)
    hashed.vector(made.is_constraint @ np.array([1, 2, 4]))
    hashed.vector(made.regions)
    return hashed.text()


def hash_of_voronoi(points):
    made, hashed = delaunay(points), Hash()
    hashed.add(OK, OK, OK, OK)
    for clip in ("hull", "bounds"):
        diagram = made.voronoi(clip)
        hashed.add(OK)
        hashed.vector(diagram.points, len(diagram.points))
        for name in ("offsets", "corners", "sites"):
            hashed.vector(getattr(diagram, name))
    return hashed.text()


def hash_of_order(points, **settings):
    made, hashed = delaunay(points, want=("order", "insertion_ranks", "boxes"), **settings), Hash()
    hashed.add(OK, OK, OK)
    hashed.vector(made.order)
    hashed.vector(made.insertion_ranks)
    for (xmin, xmax, ymin, ymax), level, count in zip(*made.boxes):
        hashed.numbers(np.array([xmin, ymin, xmax, ymax]))
        hashed.add(int(level), int(count))
    half = delaunay(points, insertion_limit=len(points) // 2 + 1, **settings)
    hashed.add(OK, OK, OK, OK)
    add_written(hashed, half)
    return hashed.text()


# --- Values: Testing/Support/Run/HashedSamples.cxx -----------------------------------------------------------


def places_among(points, count):
    """On points, halfway between two of them, on their line and anywhere."""
    random, n = Random(3), len(points)
    for k in range(count):
        a, b, c = points[random.below(n)], points[random.below(n)], points[k % n]
        t, s = 1.5 * random.unit() - 0.25, random.unit()
        on_line = a + t * (b - a)
        yield (a, 0.5 * a + 0.5 * b, on_line, on_line + s * (c - on_line))[k % 4]


def raster_over(points, cells):
    low, high = points.min(axis=0), points.max(axis=0)
    spacing = high / (cells - 4) - low / (cells - 4)
    return Raster(low - 1.5 * spacing, spacing, (cells, cells))


def add_numbers(hashed, array):
    """A NaN is a NaN, whatever its sign."""
    hashed.vector(np.where(np.isnan(array), np.nan, array))


def add_sampled(hashed, job):
    """The counts of a call."""
    hashed.add(*(job.count("sampled_" + name) for name in ("valued", "outside", "not_finite", "without_value",
                                                           "left_out")))  # fmt: skip


def hash_of_samples(points, cells=40):
    """By each method at a raster and at places, the weights of these."""
    job, hashed, random = library.Job(), Hash(), Random(4)
    job.set_array("points", points)
    job.run()
    values = [np.nan if k % 301 == 7 else 2.0 * random.unit() - 1.0 for k in range(points.size)]
    values = np.array(values).reshape(-1, 2)
    places = np.array(list(places_among(points, cells * cells // 4)))
    for method in (library.SAMPLE_LINEAR, library.SAMPLE_NATURAL_NEIGHBOR, library.SAMPLE_LAPLACE,
                   library.SAMPLE_NEAREST):  # fmt: skip
        is_linear = method == library.SAMPLE_LINEAR
        hashed.add(OK, OK)
        for at in (raster_over(points, cells if is_linear else cells // 2), places):
            (found,), (slopes,), mask = job.sample(at, [values], method=method, gradients=is_linear)
            hashed.add(OK)
            add_numbers(hashed, found)
            add_numbers(hashed, slopes if is_linear else np.full(2 * found.size, -7.0))
            hashed.vector(mask)
            add_sampled(hashed, job)
            hashed.add(OK)
            add_numbers(hashed, job.sample(at, [values], method=method, outside=1).values[0])
        job.sample_weights(places, method)
        hashed.add(OK)
        for name in ("weight_offsets", "weight_points"):
            hashed.vector(job.array(name, np.int64))
        add_numbers(hashed, job.array("weights"))
        add_sampled(hashed, job)
    return hashed.text()


# --- Constraints of Testing/Support/Points/ConstraintMakers.h -------------------------------------------------


def random_segments(count, segments):
    random = Random(14)
    return uniform(count, 14), {"segments": [(random.below(count), random.below(count)) for _ in range(segments)]}


def lattice_segments(side, segments):
    ways = ((1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (-1, 0), (0, -1), (1, 2))
    random, found = Random(17), []
    for _ in range(segments):
        x, y = random.below(side), random.below(side)
        dx, dy = ways[random.below(8)]
        length = 1 + random.below(6)
        ends = (x, y, x + dx * length, y + dy * length)
        if 0 <= min(ends) and max(ends) < side:
            found.append((ends[0] * side + ends[1], ends[2] * side + ends[3]))
    return lattice(side)[:, ::-1], {"segments": np.array(found)}


def nested_loops(depth):
    side, loops = 4 * depth, []
    for k in range(depth):
        low, high = 2 * k, side - 1 - 2 * k
        loop = [x * side + y for x, y in ((low, low), (high, low), (high, high), (low, high))]
        loops.append(loop[::-1] if k % 2 else loop)
    return lattice(side)[:, ::-1], {"loops": loops}


def chains_through_uniform(count, chains, seed):
    points, random = uniform(count, seed), Random(seed)
    lines, loops = [], []
    for k in range(chains):
        chain = [random.below(count) for _ in range(2 + random.below(4))]
        (loops if k % 3 == 2 else lines).append(chain)
    return points, {"lines": lines, "loops": loops}


class HashTest(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("ignore")
        self.addCleanup(warnings.resetwarnings)

    def check(self, name, found):
        self.assertEqual(found, EXPECTED[name], name)

    def test_corpus(self):
        names = [name for name, _ in corpus()]
        self.assertEqual(sorted("corpus/" + name for name in names),
                         sorted(name for name in EXPECTED if name.startswith("corpus/")))  # fmt: skip
        for name, points in corpus():
            self.check("corpus/" + name, hash_of_triangles(points))

    def test_points(self):
        points = uniform(10000, 7)
        self.check("points/Uniform", hash_of_triangles(points))
        self.check(
            "points/Uniform", hash_of_triangles(np.asfortranarray(points), threads=3, insertion_order="multi_grid")
        )
        self.check("points/Lattice", hash_of_triangles(lattice(100)))
        self.check("points/AllEqual", hash_of_triangles(np.tile([0.1, -0.7], (10000, 1))))

    def test_order(self):
        points = uniform(2000, 7)
        orders = {
            "default": {},
            "HG": {"control_points": "single_level"},
            "HG,nmax=1,genes=off,control=off": {"control_points": "off", "gene_rotation": False, "nmax": 1},
            "MG": {"insertion_order": "multi_grid", "control_points": "single_level"},
            "RG": {"insertion_order": "regular_grid"},
            "AsGiven": {"insertion_order": "as_given"},
        }
        for name, settings in orders.items():
            self.check("order/%s/Uniform" % name, hash_of_order(points, **settings))

    def test_voronoi(self):
        self.check("voronoi/Uniform", hash_of_voronoi(uniform(2000, 7)))

    def test_samples(self):
        self.check("sample/Uniform", hash_of_samples(uniform(2000, 7)))

    def test_constrained(self):
        cases = {
            "randomSegments": random_segments(2000, 300),
            "latticeSegments": lattice_segments(40, 800),
            "nestedLoops": nested_loops(10),
            "chainsThroughUniform": chains_through_uniform(1000, 40, 9),
        }
        for name, (points, chains) in cases.items():
            for row, rule in (("Orientation", "orientation"), ("EvenOdd", "even_odd")):
                self.check("constrained/%s/%s" % (row, name), hash_of_constrained(points, chains, rule))


if __name__ == "__main__":
    unittest.main()
