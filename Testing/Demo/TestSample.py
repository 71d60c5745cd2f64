# SPDX-License-Identifier: BSD-3-Clause
"""The sample survey in Data/ is what make_survey.py makes, and has in it what is claimed."""

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

    def test_duplicates_relief_and_size(self):
        soundings = numpy.loadtxt(SAMPLE, delimiter=",", skiprows=1)
        places = numpy.unique(soundings[:, :2], axis=0)
        self.assertGreater(len(soundings) - len(places), 300, "crossings and the station make duplicates")
        self.assertGreater(numpy.ptp(soundings[:, 2]), 3000, "metres of relief")
        self.assertLess(os.path.getsize(SAMPLE), 1e6)


if __name__ == "__main__":
    unittest.main()
