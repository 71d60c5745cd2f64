# SPDX-License-Identifier: BSD-3-Clause
"""Scripts written for vtkDelaunay2D run under adaptivehilbertdelaunay.drop_in, and with the name changed."""

import glob
import os
import re
import runpy
import unittest

import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import drop_in
from algorithmtests import run_tests

HERE = os.path.dirname(os.path.abspath(__file__))


class OldScriptsTest(unittest.TestCase):
    """Scripts for vtkDelaunay2D: as they are, and with the name of the class changed."""

    def check(self, names, checks=True):
        surface = names["surface"]
        found = {"points": surface.GetNumberOfPoints()}
        for kind in ("Polys", "Lines", "Verts"):
            found[kind.lower()] = getattr(surface, "GetNumberOf" + kind)()
        self.assertEqual(found, names["expected"])
        if checks:
            self.assertEqual(names["checks"], [True] * len(names["checks"]))

    def scripts(self):
        found = sorted(glob.glob(os.path.join(HERE, "OldScripts", "*.py")))
        self.assertGreater(len(found), 4)
        return found

    def test_they_are_right_about_the_original(self):
        for script in self.scripts():
            with self.subTest(script), drop_in.suspended():
                self.check(runpy.run_path(script), checks=False)

    def test_unchanged(self):
        for script in self.scripts():
            with self.subTest(script):
                names = runpy.run_path(script)
                self.assertIs(type(names["delaunay"]), drop_in.vtkDelaunay2D)
                self.check(names)

    def test_with_the_name_changed(self):
        ours = adaptivehilbertdelaunay.vtkAdaptiveHilbertDelaunay2D
        for script in self.scripts():
            with open(script, encoding="utf-8") as file:
                text = file.read()
            text = text.replace("from vtkmodules.vtkFiltersCore import vtkDelaunay2D", "")
            text = re.sub(r"\b(vtk\.|vtkmodules\.vtkFiltersCore\.)?vtkDelaunay2D\b", ours.__name__, text)
            names = {ours.__name__: ours}
            with self.subTest(script), drop_in.suspended():
                exec(compile(text, script, "exec"), names)
                self.assertIs(type(names["delaunay"]), ours)
                self.check(names)


if __name__ == "__main__":
    run_tests()
