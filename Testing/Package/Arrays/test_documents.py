# SPDX-License-Identifier: BSD-3-Clause
"""The docstrings and the README are right about arrays; every public name is documented and typed."""

import ast
import doctest
import inspect
import os
import re
import typing
import unittest

import numpy as np

import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import (
    _arrays, _calls, _contours, _cubic, _held, _input, _interface, _interpolators, _library, _measured, _outlined,
    _raster, _refined, _results, _sampling, _spatial, _triangulation, _warnings, scipy,
)  # fmt: skip
from adaptivehilbertdelaunay import DelaunayWarning, LinearInterpolator, NaturalNeighborInterpolator
from arraysupport import ROOT

MODULES = (
    _arrays, _calls, _contours, _cubic, _held, _input, _interface, _interpolators, _library, _measured, _outlined,
    _raster, _refined, _results, _sampling, _spatial, _triangulation, _warnings, scipy,
)  # fmt: skip
README = os.path.join(ROOT, "Filters", "Python", "README.md")
COMING_FROM = os.path.join(ROOT, "Filters", "Python", "ComingFrom.md")


class DocumentTest(unittest.TestCase):
    def test_docstrings(self):
        attempted = 0
        for module in MODULES:
            result = doctest.testmod(module)
            self.assertEqual(result.failed, 0, module.__name__)
            attempted += result.attempted
        self.assertGreater(attempted, 15)

    def test_readme(self):
        result = doctest.testfile(README, module_relative=False)
        self.assertEqual(result.failed, 0)
        self.assertGreater(result.attempted, 8)

    def test_coming_from_others(self):
        """The page's examples and, in what they define, each of this package's expressions."""
        with open(COMING_FROM, encoding="utf-8") as file:
            text = file.read()
        self.assertEqual(doctest.testfile(COMING_FROM, module_relative=False).failed, 0)
        names = {}
        for example in doctest.DocTestParser().get_examples(text):
            exec(example.source, names)
        rows = re.findall(r"^\| .*? \| `([^|`]*)` \|", text, re.MULTILINE)
        self.assertGreater(len(rows), 35)
        for row in rows:
            if "matplotlib" not in row:  # Foreign/ has it
                self.assertIsNotNone(eval(row, names), row)

    def public(self):
        """(name, object) of what callers use."""
        own = [(name, adaptivehilbertdelaunay) for name in adaptivehilbertdelaunay.__all__]
        for name, module in [*own, *((name, scipy) for name in scipy.__all__)]:
            found = getattr(module, name)
            yield name, found
            if inspect.isclass(found) and found.__module__.startswith("adaptivehilbertdelaunay"):
                members = {}
                for base in reversed(found.__mro__):
                    members.update(vars(base) if base.__module__.startswith("adaptivehilbertdelaunay") else {})
                for member, value in members.items():
                    if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                        yield name + "." + member, value

    def test_everything_is_documented_and_typed(self):
        seen = 0
        for name, found in self.public():
            seen += 1
            self.assertTrue(inspect.getdoc(found), name)
            function = found.fget if isinstance(found, property) else found
            if inspect.isfunction(function):
                hints = typing.get_type_hints(function)
                self.assertIn("return", hints, name)
                for parameter in inspect.signature(function).parameters:
                    self.assertTrue(parameter == "self" or parameter in hints, "%s: %s" % (name, parameter))
        self.assertGreater(seen, 30)

    def test_the_first_lines_of_the_project(self):
        """Run verbatim from the README's first screen."""
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
            begin, code = file.read().split("```python\n")[:2]
        self.assertLess(begin.count("\n"), 20)
        names = {}
        exec(code.split("```")[0], names)
        self.assertEqual(names["triangles"].shape[1], 3)
        self.assertGreater(len(names["triangles"]), len(names["points"]))

    def test_the_readme_names_every_array(self):
        with open(README, encoding="utf-8") as file:
            text = file.read()
        for name, found in self.public():
            if name.startswith("Triangulation."):
                self.assertRegex(text, "`%s[(`]" % name.split(".")[1])

    def test_interpolators_of_collinear_points(self):
        """Cause a warning and have values on their line, as documented; scipy's refuses such points."""
        self.assertIn("all on one line", LinearInterpolator.__doc__)
        for kind in (LinearInterpolator, NaturalNeighborInterpolator):
            with self.assertWarnsRegex(DelaunayWarning, "all distinct points are collinear"):
                f = kind([[0, 0], [2, 2], [6, 6]], [0, 10, 50])
            np.testing.assert_array_equal(f([[1, 1], [4, 4], [7, 7], [1, 2]]), [5, 30, np.nan, np.nan])
            with self.assertWarnsRegex(DelaunayWarning, "fewer than three"):
                one = kind([[3, 4]], [7])
            np.testing.assert_array_equal(one([[3, 4], [3, 5]]), [7, np.nan])

    def test_the_headers_name_all_that_the_library_knows_by_name(self):
        folder = os.path.join(ROOT, "Filters", "Engine", "Interface")
        text = ""
        for header in ("ahd.h", "ahd_edit.h", "ahd_messages.h", "ahd_outline.h", "ahd_refine.h", "ahd_sample.h",
                       "ahd_tiles.h"):
            with open(os.path.join(folder, header), encoding="utf-8") as file:
                text += file.read()
        for kind in range(6):
            names = _interface.names(kind)
            self.assertGreater(len(names), 3)
            missing = [name for name in names if not re.search(r"\b%s\b" % name, text)]
            self.assertEqual(missing, [], kind)

    def test_it_says_that_it_is_typed(self):
        folder = os.path.dirname(adaptivehilbertdelaunay.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))

    def test_type_checkers_find_names_that_are_none(self):
        """For a class with __getattr__ they accept any name, unless it is hidden from them."""
        for kind in adaptivehilbertdelaunay.Triangulation.__mro__[:-1]:
            (made,) = ast.parse(inspect.getsource(kind)).body
            seen = [node.name for node in made.body if isinstance(node, ast.FunctionDef)]
            self.assertGreater(len(seen), 0)
            self.assertNotIn("__getattr__", seen)


if __name__ == "__main__":
    unittest.main()
