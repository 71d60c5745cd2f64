# SPDX-License-Identifier: BSD-3-Clause
"""The samples in Data/ are made by make_survey.py and make_bay.py, and have the documented content."""

import filecmp
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
SAMPLE = os.path.join(DATA, "survey.csv")


class Sample(unittest.TestCase):
    def test_made_anew_it_is_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "survey.csv")
            subprocess.run([sys.executable, os.path.join(DATA, "make_survey.py"), path], check=True)
            with open(path, "rb") as new, open(SAMPLE, "rb") as committed:
                self.assertEqual(new.read(), committed.read(), "Data/survey.csv is not what Data/make_survey.py makes")

    def test_the_bay_made_anew_is_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, os.path.join(DATA, "make_bay.py"), folder], check=True)
            for name in ("soundings.csv", "coastline.vtp"):
                new, committed = os.path.join(folder, name), os.path.join(DATA, "Bay", name)
                same = filecmp.cmp(new, committed, shallow=False)
                self.assertTrue(same, "Data/Bay/%s is not what Data/make_bay.py makes" % name)

    def test_duplicates_relief_and_size(self):
        soundings = numpy.loadtxt(SAMPLE, delimiter=",", skiprows=1)
        places = numpy.unique(soundings[:, :2], axis=0)
        self.assertGreater(len(soundings) - len(places), 300, "crossings and the station make duplicates")
        self.assertGreater(numpy.ptp(soundings[:, 2]), 3000, "metres of relief")
        self.assertLess(os.path.getsize(SAMPLE), 1e6)

    def test_seen_in_paraview_as_it_is(self):
        """Heights are in the unit of x and y: neither a wall nor a dot, without a scale."""
        soundings = numpy.loadtxt(SAMPLE, delimiter=",", skiprows=1)
        width, length, relief = numpy.ptp(soundings, axis=0)
        self.assertLess(relief, min(width, length))
        self.assertGreater(relief, 0.02 * max(width, length))


if __name__ == "__main__":
    unittest.main()
