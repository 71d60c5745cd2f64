# SPDX-License-Identifier: BSD-3-Clause
"""The source of points in Python. Run by /usr/bin/python3, pvpython and pvbatch alike."""

import hashlib
import math
import unittest

from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT
from vtkmodules.vtkCommonDataModel import VTK_POLY_VERTEX

from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D, vtkPlanarPointSource
from algorithmtests import check_abort_and_run_again, run_tests

DISTRIBUTIONS = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed", "Lattice"]


def run(name, **settings):
    """The output of the source with a distribution and settings."""
    source = vtkPlanarPointSource()
    getattr(source, "SetDistributionTo" + name)()
    for setting, value in settings.items():
        getattr(source, "Set" + setting)(value)
    source.Update()
    return source.GetOutput()


def coordinates(data):
    """The bytes of the coordinates."""
    return bytes(memoryview(data.GetPoints().GetData()))


class SourceTest(unittest.TestCase):
    def test_names_and_numbers(self):
        source = vtkPlanarPointSource()
        self.assertEqual(source.GetDistribution(), source.UNIFORM)
        self.assertEqual((source.GetNumberOfPoints(), source.GetSeed()), (10000, 1))
        self.assertEqual(source.GetOutputPointsPrecision(), source.DOUBLE_PRECISION)
        for number, name in enumerate(DISTRIBUTIONS):
            self.assertEqual(getattr(source, name.upper()), number)
            getattr(source, "SetDistributionTo" + name)()
            self.assertEqual(source.GetDistribution(), number)

    def test_points_are_the_same_everywhere(self):
        # Of 1000 points and seed 1: whichever VTK, interpreter and processor.
        whole = hashlib.sha256()
        for name in DISTRIBUTIONS:
            whole.update(coordinates(run(name, NumberOfPoints=1000)))
        self.assertEqual(
            whole.hexdigest(), "7280f070c170562ab55db605a3c1a2acbcf3a9e46c8702081b3b4201113c53aa")

    def test_hills_are_the_same_everywhere(self):
        whole = hashlib.sha256()
        for name in DISTRIBUTIONS:
            whole.update(coordinates(run(name, NumberOfPoints=1000, HillHeight=0.1, Scale=1000.0)))
        self.assertEqual(whole.hexdigest(), "8cef1ac786e3f7dc15521620918bc723ca5121e34e772100ceedc872952346b6")

    def test_hills(self):
        for name in DISTRIBUTIONS:
            flat, made = run(name, NumberOfPoints=400), run(name, NumberOfPoints=400, HillHeight=0.3, Scale=10.0)
            width = 20.0 if name == "Lattice" else 1.0
            for i in range(400):
                (x, y, z), place = flat.GetPoint(i), made.GetPoint(i)
                u, v = x / width, y / width
                hill = 0.5 + 0.3 * math.sin(1.6 * math.pi * u) * math.cos(1.3 * math.pi * v) + 0.2 * math.cos(
                    2.6 * math.pi * u - 1.8 * math.pi * v)
                self.assertEqual((z, *place[:2]), (0.0, 10.0 * x, 10.0 * y))
                self.assertAlmostEqual(place[2], 3.0 * width * hill, 9)

    def test_range_of_hills(self):
        source = vtkPlanarPointSource()
        self.assertEqual((source.GetHillHeight(), source.GetScale()), (0.0, 1.0))
        for name, least, most in (("HillHeight", 0.0, 1000.0), ("Scale", 1e-9, 1e9)):
            for given, kept in ((-1.0, least), (math.nan, least), (math.inf, most)):
                getattr(source, "Set" + name)(given)
                self.assertEqual(getattr(source, "Get" + name)(), kept, name)

    def test_one_cell_for_all_points(self):
        for name in DISTRIBUTIONS:
            data = run(name, NumberOfPoints=50)
            self.assertEqual(data.GetNumberOfPoints(), 50)
            self.assertEqual(data.GetPoints().GetDataType(), VTK_DOUBLE)
            self.assertEqual(data.GetNumberOfCells(), 1)
            self.assertEqual(data.GetCellType(0), VTK_POLY_VERTEX)
            self.assertEqual(data.GetCell(0).GetNumberOfPoints(), 50)

    def test_none_and_single_precision(self):
        self.assertEqual(run("Mixed", NumberOfPoints=0).GetNumberOfPoints(), 0)
        data = run("Mixed", OutputPointsPrecision=vtkPlanarPointSource.SINGLE_PRECISION)
        self.assertEqual(data.GetPoints().GetDataType(), VTK_FLOAT)

    def test_into_the_filter(self):
        source = vtkPlanarPointSource()
        surface = vtkAdaptiveHilbertDelaunay2D()
        surface.SetInputConnection(source.GetOutputPort())
        for name in DISTRIBUTIONS:
            getattr(source, "SetDistributionTo" + name)()
            surface.Update()
            self.assertEqual(surface.GetNumberOfPointsInserted(), 10000, name)
            self.assertGreater(surface.GetNumberOfTriangles(), 19000, name)
        self.assertEqual(surface.GetNumberOfTriangles(), 2 * 99 * 99)

    def test_abort_and_run_again(self):
        source = vtkPlanarPointSource()
        source.SetNumberOfPoints(300000)
        points = check_abort_and_run_again(self, source, lambda output: output.GetNumberOfPoints())
        self.assertEqual(points, 300000)


if __name__ == "__main__":
    run_tests()
