# SPDX-License-Identifier: BSD-3-Clause
"""Estimates of memory, from both sides: the memory taken is no more, and not much less, for every feature and at every
door. Both classes estimate the same, and refuse the same."""

import unittest

import numpy as np

from memorycases import (CLASSES, FEATURES, SAMPLINGS, make_sampler, of_arrays, of_class, of_sampler, sampling, uniform,
                         warm)
from vtkmodules.util.numpy_support import numpy_to_vtk

SMALL = 1 << 17  # bytes: data sets, tables of names


def few_points():
    return uniform()[:1000]


class MemoryTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        warm()

    def assertHolds(self, of, door, taken):
        what = "%s, %s: %d estimated, %d taken" % (of.name, door, taken.estimate, taken.most)
        self.assertEqual(taken.said, [], what)
        self.assertLessEqual(taken.most, taken.estimate + SMALL, what)
        self.assertLessEqual(taken.estimate, of.most * taken.most, what)

    def compare(self, cases, measure):
        for of in cases:
            with self.subTest(of.name):
                taken = {door: measure(of, door) for door in CLASSES}
                for door, found in taken.items():
                    self.assertHolds(of, door, found)
                self.assertEqual(taken["in Python"].estimate, taken["compiled"].estimate, of.name)

    def test_each_output_of_the_classes(self):
        self.compare(FEATURES, of_class)

    def test_each_interpolation(self):
        self.compare(SAMPLINGS, of_sampler)

    def test_of_points_that_are_added(self):
        """Both classes count them, and point data that a kept triangulation got later."""
        of = sampling("", triangulation=dict(BoundingTriangulation=True, KeepTriangulation=True), points=few_points)
        found = {}
        for door in CLASSES:
            algorithm, _ = make_sampler(of, door)
            algorithm.Update()
            found[door] = [algorithm.GetMemoryEstimate()]
            wide = numpy_to_vtk(np.ones((len(few_points()), 100)), deep=1)
            wide.SetName("wide")
            algorithm.GetInput().GetPointData().AddArray(wide)
            algorithm.Update()
            self.assertEqual(algorithm.GetNumberOfTriangulations(), 1)
            found[door].append(algorithm.GetMemoryEstimate())
        self.assertEqual(found["in Python"], found["compiled"])

    def test_each_array(self):
        for of in FEATURES:
            if of.keywords is not None:
                with self.subTest(of.name):
                    taken = of_arrays(of)
                    what = "%s: %d estimated, %d taken" % (of.name, taken.estimate, taken.most)
                    self.assertLessEqual(taken.most, taken.estimate + SMALL, what)
                    self.assertLessEqual(taken.estimate, max(2, of.most) * taken.most, what)

    def test_limits(self):
        """The estimate is enough, and one KiB less is not, unless the number of points to add is not known before."""
        known = [of for of in FEATURES if not {"CrossingMode", "MaximumSegmentLength"} & set(of.settings)]
        for of, measure in [(of, of_class) for of in known[::6]] + [(of, of_sampler) for of in SAMPLINGS[::4]]:
            needed = measure(of, "compiled").estimate // 1024
            for door in CLASSES:
                with self.subTest("%s, %s" % (of.name, door)):
                    self.assertEqual(measure(of, door, needed).said, [])
                    self.assertEqual(measure(of, door, needed - 1).said, ["error"])


if __name__ == "__main__":
    unittest.main()
