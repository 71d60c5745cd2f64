# SPDX-License-Identifier: BSD-3-Clause
"""For every type, number of columns and layout of arrays the results are those of contiguous doubles; and defaults are
as documented."""

import inspect
import itertools
import re
import unittest

import arraysupport  # noqa: F401 (finds what is beside this folder)
import numpy as np

import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import (
    LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator, Triangulation, delaunay,
)  # fmt: skip
from adaptivehilbertdelaunay._input import CHOICES, DEFAULTS

METHODS = ("linear", "natural", "laplace", "nearest")
TYPES = (np.float64, np.float32, np.int16, np.int64, ">f8", ">f4", np.float16, bool)


def rows(array):
    """Every other row of one that is twice as long."""
    twice = np.zeros((2 * len(array), *array.shape[1:]), array.dtype)
    twice[::2] = array
    return twice[::2]


def columns(array):
    """Columns that are not contiguous."""
    wide = np.zeros((*array.shape[:-1], 2 * array.shape[-1] + 1), array.dtype)
    wide[..., 1::2] = array
    return wide[..., 1::2]


def backwards(array):
    return array[::-1].copy()[::-1]


def unaligned(array):
    buffer = np.zeros(array.nbytes + 1, np.uint8)
    made = buffer[1:].view(array.dtype).reshape(array.shape)
    made[...] = array
    return made


LAYOUTS = {"contiguous": np.ascontiguousarray, "by column": np.asfortranarray, "rows": rows, "columns": columns,
           "backwards": backwards, "unaligned": unaligned, "list": lambda array: array.tolist()}


def given(count, wide, kind, seed=3):
    """Points or values of a type; whole numbers are not all one."""
    numbers = np.random.default_rng(seed).random((count, wide)) * 90
    return (numbers > 45 if kind is bool else numbers).astype(kind)


class Points(unittest.TestCase):
    def check(self, kind, layout, wide, count):
        points = given(count, wide, kind)
        plain = delaunay(np.ascontiguousarray(points, np.float64))
        made = delaunay(LAYOUTS[layout](points))
        for name in ("triangles", "neighbors", "edges", "hull", "plane_points", "point_status", "order", "boxes"):
            one, other = getattr(made, name), getattr(plain, name)
            for k, array in enumerate(one if isinstance(one, tuple) else (one,)):
                np.testing.assert_array_equal(array, other[k] if isinstance(other, tuple) else other, name)
        return plain, made

    def test_types_and_layouts(self):
        for kind, layout, wide, count in itertools.product(TYPES, LAYOUTS, (2, 3), (20, 21)):
            if kind is bool:
                continue  # a point is no truth value: test_input.py
            with self.subTest(kind=kind, layout=layout, wide=wide, count=count):
                self.check(kind, layout, wide, count)

    def test_planes(self):
        for kind, layout, count in itertools.product(TYPES[:-1], LAYOUTS, (60, 61)):
            points = given(count, 3, kind)
            with self.subTest(kind=kind, layout=layout, count=count):
                made, plain = delaunay(LAYOUTS[layout](points), plane="best_fit"), delaunay(points, plane="best_fit")
                np.testing.assert_array_equal(made.plane_matrix, plain.plane_matrix)
                np.testing.assert_array_equal(made.triangles, plain.triangles)

    def test_methods(self):
        at = given(17, 2, np.float64, 5)
        for kind, layout, wide, count in itertools.product(TYPES[:5], LAYOUTS, (2, 3), (40, 41)):
            plain, made = self.check(kind, layout, wide, count)
            heights = np.arange(float(count))
            for method in METHODS:
                with self.subTest(kind=kind, layout=layout, wide=wide, count=count, method=method):
                    np.testing.assert_array_equal(
                        made.interpolate(heights, at, method), plain.interpolate(heights, at, method))


class Values(unittest.TestCase):
    def setUp(self):
        self.points = given(41, 2, np.float64)
        self.made = delaunay(self.points)
        self.at = given(17, 2, np.float64, 5)

    def test_types_and_layouts(self):
        for kind, layout, wide, method in itertools.product(TYPES, LAYOUTS, (1, 2, 3), METHODS):
            values = given(41, wide, kind, 7)
            with self.subTest(kind=kind, layout=layout, wide=wide, method=method):
                try:
                    found = self.made.interpolate(LAYOUTS[layout](values), self.at, method)
                except TypeError:
                    self.assertIs(kind, bool)
                    continue
                plain = self.made.interpolate(np.ascontiguousarray(values, np.float64), self.at, method)
                np.testing.assert_allclose(found, plain, rtol=2e-3 if np.dtype(found.dtype).itemsize < 4 else 1e-6)
                if found.dtype == plain.dtype:
                    np.testing.assert_array_equal(found, plain)

    def test_places(self):
        heights = np.arange(41.0)
        for kind, layout, method in itertools.product(TYPES[:-1], LAYOUTS, METHODS):
            at = given(17, 2, kind, 5)
            with self.subTest(kind=kind, layout=layout, method=method):
                np.testing.assert_array_equal(
                    self.made.interpolate(heights, LAYOUTS[layout](at), method),
                    self.made.interpolate(heights, np.ascontiguousarray(at, np.float64), method))

    def test_interpolators(self):
        for kind, layout, each in itertools.product(
                TYPES[:5], LAYOUTS, (LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator)):
            points, values = given(41, 2, kind), given(41, 2, kind, 7)
            with self.subTest(kind=kind, layout=layout, each=each.__name__):
                found = each(LAYOUTS[layout](points), LAYOUTS[layout](values))(self.at)
                plain = each(points.astype(np.float64), values.astype(np.float64))(self.at)
                np.testing.assert_allclose(found, plain, rtol=1e-6)


def documented(thing):
    """Names and defaults in a docstring, "name : kind, default value"."""
    text = inspect.getdoc(thing) or ""
    return re.findall(r"^(\w+) : .*default (.+)$", text, re.MULTILINE)


class Documented(unittest.TestCase):
    """Each default in a docstring is that of the signature, and each value that it lists is accepted."""

    CALLABLES = (delaunay, LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator,
                 Triangulation.interpolate, Triangulation.raster, Triangulation.weights)

    def test_defaults(self):
        seen = 0
        for thing in self.CALLABLES:
            signature = inspect.signature(thing).parameters
            for name, told in documented(thing):
                with self.subTest(thing=thing.__qualname__, name=name):
                    is_true = signature[name].default
                    names = {"numpy": np, "nan": float("nan"), "NaN": float("nan")}
                    value = eval(told.strip().rstrip("."), names)
                    self.assertTrue(value == is_true or (value != value and is_true != is_true), (told, is_true))
                    seen += 1
        self.assertGreater(seen, 25)

    def test_every_keyword_is_documented(self):
        for thing in (delaunay, LinearInterpolator, Triangulation.interpolate, Triangulation.weights):
            text = inspect.getdoc(thing)
            for name, parameter in inspect.signature(thing).parameters.items():
                if name in ("self", "args"):
                    continue
                with self.subTest(thing=thing.__qualname__, name=name):
                    self.assertRegex(text, r"(?m)^(\w+, )*%s(, \w+)* : " % name)
                    line = re.search(r"(?m)^(\w+, )*%s(, \w+)* : .*$" % name, text).group()
                    is_optional = parameter.default is not parameter.empty
                    self.assertEqual("optional" in line or "default" in line, is_optional, line)

    def test_choices(self):
        text = inspect.getdoc(delaunay)
        for name, among in CHOICES.items():
            told = re.search(r"(?m)^%s : \{(.*)\}" % name, text)
            self.assertEqual(sorted(told.group(1).split(", ")), sorted(map(repr, among)), name)

    def test_input_knows_the_same_defaults(self):
        for name, parameter in inspect.signature(delaunay).parameters.items():
            if name in DEFAULTS:
                self.assertEqual(parameter.default, DEFAULTS[name], name)
        self.assertLessEqual(set(DEFAULTS), set(inspect.signature(delaunay).parameters))

    def test_names_of_the_package(self):
        self.assertLessEqual(set(adaptivehilbertdelaunay.__all__), set(dir(adaptivehilbertdelaunay)))


if __name__ == "__main__":
    unittest.main()
