# SPDX-License-Identifier: BSD-3-Clause
"""Filters, and what refers to them, in cycles that only Python's collector frees; with malloc's checks."""

import os
import subprocess
import sys
import unittest

from classtests import FOLDER

# Filters with observers, transforms and outputs that refer to them, some from finalizers; one that failed.
SCRIPT = """
import faulthandler, gc, sys, threading
faulthandler.enable()
sys.path.insert(0, sys.argv[1])
from classtests import Filter, Random, core, model, tested_class, uniform, vtk
core.vtkObject.GlobalWarningDisplayOff()
Sampled = tested_class("vtkAdaptiveHilbertInterpolation2D")
Transform = vtk("vtkCommonTransforms").vtkTransform
counts = []

def given():
    points = core.vtkPoints()
    random = Random(7)
    for _ in range(60):
        points.InsertNextPoint(*uniform(random, 7), 0)
    data = model.vtkPolyData()
    data.SetPoints(points)
    return data

class Owner:
    def __init__(self, kind, asks):
        self.filter, self.asks = kind(), asks
        self.filter.SetInputDataObject(given())
        if kind is Filter:
            transform = Transform()
            transform.AddObserver("ModifiedEvent", self.hear)
            self.filter.SetTransform(transform)
            self.filter.SetProjectionPlaneMode(1)
        else:
            self.filter.SetDimensions(9, 9)
        self.filter.AddObserver("ProgressEvent", self.hear)
        self.filter.Update()
        self.output = self.filter.GetOutputDataObject(0)
        self.filter.owner = self if asks is not None else None
    def hear(self, *_):
        pass
    def __del__(self, counts=counts):
        if self.asks:
            self.filter.Modified()
            self.filter.Update()
            counts.append(self.output.GetNumberOfPoints() > 0)

def fails():
    owner = Owner(Filter, False)
    owner.filter.SetMemoryLimit(1)
    owner.filter.Update()

def make():
    for kind in (Filter, Sampled):
        for asks in (True, False, None):
            Owner(kind, asks).again = Owner(kind, asks)
    fails()

for way in sys.argv[2].split():
    if way == "collected":
        make()
        gc.collect()
    elif way == "automatically":
        before = gc.get_threshold()
        gc.set_threshold(30, 2, 2)
        make()
        gc.set_threshold(*before)
    elif way == "threads":
        threads = [threading.Thread(target=lambda: (make(), gc.collect())) for _ in range(2)]
        [one.start() for one in threads]
        [one.join() for one in threads]
    elif way == "end":
        gc.disable()
        kept = [Owner(Filter, False), Owner(Sampled, False)]
        kept.append(kept)
assert all(counts), counts
print("survived")
"""


class CycleTest(unittest.TestCase):
    def test_cycles(self):
        for ways in ("collected automatically", "threads", "end"):
            done = subprocess.run(
                [sys.executable, "-c", SCRIPT, str(FOLDER), ways], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                env={**os.environ, "MALLOC_PERTURB_": "165", "MALLOC_CHECK_": "3"}, text=True, check=False)  # fmt: skip
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "survived\n", ""), ways)


if __name__ == "__main__":
    unittest.main()
