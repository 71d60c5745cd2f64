# SPDX-License-Identifier: BSD-3-Clause
"""The filter in Python. Run by /usr/bin/python3, pvpython and pvbatch alike."""

import math
import random
import unittest

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import (
    VTK_DOUBLE,
    VTK_FLOAT,
    VTK_STRING,
    vtkDoubleArray,
    vtkIdList,
    vtkPoints,
)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

try:
    from vtkmodules.vtkFiltersCore import vtkDelaunay2D
except ImportError:
    vtkDelaunay2D = None

from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D
from algorithmtests import check_abort_and_run_again, run_tests


def cloud(points, number=VTK_DOUBLE):
    """A vtkPolyData of points and no cells."""
    made = vtkPoints()
    made.SetDataType(number)
    for point in points:
        made.InsertNextPoint(point)
    data = vtkPolyData()
    data.SetPoints(made)
    return data


def lattice_points(count, side, seed=1):
    """Points with whole coordinates: exact as float and as double."""
    numbers = random.Random(seed)
    return [(numbers.randrange(side), numbers.randrange(side), 0.0) for _ in range(count)]


def triangles(surface):
    ids = vtkIdList()
    found = []
    for cell in range(surface.GetNumberOfCells()):
        surface.GetCellPoints(cell, ids)
        found.append(tuple(ids.GetId(i) for i in range(ids.GetNumberOfIds())))
    return found


def watch(algorithm):
    """Keeps the warnings and errors of a filter."""
    said = {"WarningEvent": [], "ErrorEvent": []}

    @calldata_type(VTK_STRING)
    def keep(_, event, text):
        said[event].append(text)

    for event in said:
        algorithm.AddObserver(event, keep)
    return said


class FilterTest(unittest.TestCase):
    def run_filter(self, data, **settings):
        algorithm = vtkAdaptiveHilbertDelaunay2D()
        for name, value in settings.items():
            getattr(algorithm, "Set" + name)(value)
        algorithm.SetInputData(data)
        algorithm.Update()
        return algorithm

    def test_triangles_are_counterclockwise_and_complete(self):
        points = lattice_points(500, 10**4)
        algorithm = self.run_filter(cloud(points))
        found = triangles(algorithm.GetOutput())
        self.assertEqual(len(found), algorithm.GetNumberOfTriangles())
        sides = set()
        for a, b, c in found:
            (ax, ay, _), (bx, by, _), (cx, cy, _) = points[a], points[b], points[c]
            self.assertGreater((bx - ax) * (cy - ay) - (by - ay) * (cx - ax), 0, (a, b, c))
            sides |= {(a, b), (b, c), (c, a)}
        hull = sum((end, start) not in sides for start, end in sides)
        self.assertEqual(len(found), 2 * len(set(points)) - 2 - hull)

    def test_float_and_double_and_every_setting_agree(self):
        points = lattice_points(400, 60)
        expected = triangles(self.run_filter(cloud(points)).GetOutput())
        self.assertEqual(
            triangles(self.run_filter(cloud(points, VTK_FLOAT)).GetOutput()), expected)
        for order in range(4):
            for control in range(3):
                surface = self.run_filter(
                    cloud(points), InsertionOrder=order, ControlPoints=control, Nmax=3).GetOutput()
                self.assertEqual(triangles(surface), expected, (order, control))

    def test_points_are_shared_and_their_data_passed(self):
        data = cloud(lattice_points(50, 1000))
        depth = vtkDoubleArray()
        depth.SetName("depth")
        depth.SetNumberOfValues(50)
        depth.Fill(2.0)
        data.GetPointData().AddArray(depth)
        surface = self.run_filter(data).GetOutput()
        self.assertIs(surface.GetPoints(), data.GetPoints())
        self.assertIs(surface.GetPointData().GetArray("depth"), depth)

    def test_named_values(self):
        algorithm = vtkAdaptiveHilbertDelaunay2D()
        self.assertEqual(algorithm.GetInsertionOrder(), algorithm.ADAPTIVE_HILBERT)
        self.assertEqual(algorithm.GetControlPoints(), algorithm.EVERY_LEVEL)
        algorithm.SetInsertionOrderToMultiGrid()
        self.assertEqual(algorithm.GetInsertionOrder(), algorithm.MULTI_GRID)
        algorithm.SetNmax(-1)
        self.assertEqual(algorithm.GetNmax(), 1)

    def test_measures_and_fate(self):
        data = cloud([(0, 0, 0), (4, 0, 0), (0, 4, 0), (4, 0, 5)])
        algorithm = self.run_filter(data, CountWork=True, GenerateFate=True)
        self.assertEqual(algorithm.GetNumberOfPointsInserted(), 3)
        self.assertEqual(algorithm.GetNumberOfDuplicates(), 1)
        self.assertGreaterEqual(algorithm.GetNP(), 0.0)
        self.assertGreaterEqual(algorithm.GetNR(), 0.0)
        self.assertGreater(algorithm.GetMemoryEstimate(), 0)
        fate = algorithm.GetOutput().GetPointData().GetArray("Fate")
        self.assertEqual([fate.GetValue(i) for i in range(4)], [0, 1, 2, 1])
        counts = algorithm.GetOutput().GetFieldData()
        self.assertEqual(counts.GetArray("NumberOfDuplicates").GetValue(0), 1)
        self.assertEqual(counts.GetArray("NumberOfTriangles").GetValue(0), 1)

    def test_insertion_can_be_watched(self):
        points = lattice_points(300, 10**6)
        settings = {"GenerateInsertionRank": True, "GenerateInsertionCurve": True, "GenerateBoxes": True}
        algorithm = self.run_filter(cloud(points), InsertionLimit=120, **settings)
        self.assertEqual(algorithm.GetNumberOfPointsInserted(), 120)
        self.assertEqual(algorithm.GetNumberOfPointsBeyondLimit(), 180)
        counts = algorithm.GetOutput().GetFieldData()
        self.assertEqual(counts.GetArray("NumberOfPointsBeyondLimit").GetValue(0), 180)
        ranks = algorithm.GetOutput().GetPointData().GetArray("InsertionRank")
        ranks = [ranks.GetValue(i) for i in range(300)]
        self.assertEqual(sorted(ranks), list(range(300)))
        used = {point for triangle in triangles(algorithm.GetOutput()) for point in triangle}
        self.assertEqual(used, {point for point in range(300) if ranks[point] < 120})

        order = algorithm.GetOutput(1)
        boxes = order.GetNumberOfPolys()
        self.assertEqual((order.GetNumberOfLines(), order.GetNumberOfPoints()), (1, 120 + 4 * boxes))
        ids = order.GetPointData().GetArray("OriginalPointIds")
        for i in range(120):
            self.assertEqual(order.GetPoint(i), points[ids.GetValue(i)])
            self.assertEqual(ranks[ids.GetValue(i)], i)
        held = order.GetCellData().GetArray("Count")
        self.assertEqual(sum(held.GetValue(i) for i in range(1, 1 + boxes)), 300)

    def test_constraints(self):
        points = [(x, y, 0.0) for x in range(10) for y in range(10)]
        hole = vtkCellArray()
        hole.InsertNextCell(4)
        for point in (22, 25, 45, 42):  # clockwise
            hole.InsertCellPoint(point)
        line = vtkCellArray()
        line.InsertNextCell(2)
        line.InsertCellPoint(0)
        line.InsertCellPoint(97)
        source = vtkPolyData()
        source.SetPolys(hole)
        algorithm = vtkAdaptiveHilbertDelaunay2D()
        self.assertIsNone(algorithm.GetSource())
        algorithm.SetInputData(cloud(points))
        algorithm.SetSourceData(source)
        algorithm.Update()
        self.assertIs(algorithm.GetSource(), source)
        self.assertEqual(algorithm.GetNumberOfTriangles(), 162 - 12)
        self.assertEqual(algorithm.GetNumberOfConstraintEdges(), 10)

        said = watch(algorithm)
        source.SetLines(line)  # crosses the hole
        source.Modified()
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfUnfilledLoops(), 1)
        self.assertEqual(len(said["WarningEvent"]), 1, said)
        crossings = algorithm.GetOutput().GetFieldData().GetArray("Crossings")
        self.assertEqual(crossings.GetTuple(0), (1.0, 0.0))

        algorithm.SetCrossingModeToSplit()
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfUnfilledLoops(), 0)
        self.assertEqual(algorithm.GetNumberOfAddedPoints(), algorithm.GetNumberOfCrossings())
        self.assertGreater(algorithm.GetNumberOfAddedPoints(), 0)
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 100 + algorithm.GetNumberOfAddedPoints())
        self.assertEqual(len(said["WarningEvent"]), 1, said)

        algorithm.SetInsertionOrderToAsGiven()
        for limit, told in ((60, 2), (80, 2), (0, 2), (60, 3)):  # as in an animation
            algorithm.SetInsertionLimit(limit)
            algorithm.Update()
            self.assertEqual(algorithm.GetNumberOfConstraintsLeftOut() > 0, limit > 0)
            self.assertEqual(len(said["WarningEvent"]), told, said)

    def test_source_coordinates_and_tolerance(self):
        source = cloud([(0.5, 0.25, 0), (3.5, 3.75, 0), (4.001, 4, 0)])
        algorithm = vtkAdaptiveHilbertDelaunay2D()
        algorithm.SetInputData(cloud([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]))
        algorithm.SetSourceData(source)
        algorithm.SetSourceMode(algorithm.SOURCE_COORDINATES)
        algorithm.SetTolerance(0.001)
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 7)
        self.assertEqual(algorithm.GetNumberOfAddedPoints(), 3)
        self.assertEqual(algorithm.GetNumberOfMergedPoints(), 1)
        self.assertEqual(algorithm.GetNumberOfPointsInserted(), 6)

    def test_warning_with_counts(self):
        algorithm = vtkAdaptiveHilbertDelaunay2D()
        said = watch(algorithm)
        algorithm.SetInputData(cloud([(0, 0, 0), (4, 0, 0), (math.nan, 1, 0), (0, 4, 0)]))
        algorithm.Update()
        self.assertEqual(len(said["WarningEvent"]), 1, said)
        self.assertIn("1 of 4 points", said["WarningEvent"][0])
        self.assertIn("point 2", said["WarningEvent"][0])
        self.assertEqual(said["ErrorEvent"], [])

    def test_threads(self):
        data = cloud(lattice_points(40000, 10**6))
        expected = None
        for threads in (1, 2, 3, 5, 8):
            algorithm = self.run_filter(data, NumberOfThreads=threads)
            self.assertEqual(algorithm.GetNumberOfThreads(), threads)
            self.assertEqual(algorithm.GetNumberOfThreadsUsed(), threads)
            polys = algorithm.GetOutput().GetPolys()
            made = bytes(memoryview(polys.GetConnectivityArray())), bytes(memoryview(polys.GetOffsetsArray()))
            expected = expected or made
            self.assertTrue(made == expected, threads)
        self.assertGreaterEqual(self.run_filter(data).GetNumberOfThreadsUsed(), 1)

    def test_memory_is_reused(self):
        algorithm = self.run_filter(cloud(lattice_points(5000, 10**6)), ReuseLimit=1000000)
        expected = triangles(algorithm.GetOutput())
        for limit in (1000000, 0, 1000000):
            algorithm.SetReuseLimit(limit)
            algorithm.Modified()
            algorithm.Update()
            self.assertTrue(triangles(algorithm.GetOutput()) == expected, limit)

    @unittest.skipIf(vtkDelaunay2D is None, "VTK has no vtkDelaunay2D here")
    def test_bounding_points_are_those_of_vtk(self):
        numbers = random.Random(3)
        points = [tuple(numbers.uniform(-k, 9 * k) for k in (1, 2, 3)) for _ in range(50)]
        for offset in (0.75, 1.0, 12.5):
            theirs = vtkDelaunay2D()
            theirs.SetInputData(cloud(points))
            theirs.SetOffset(offset)
            theirs.BoundingTriangulationOn()
            theirs.Update()
            algorithm = self.run_filter(cloud(points), Offset=offset, BoundingTriangulation=True)
            self.assertEqual(algorithm.GetNumberOfAddedPoints(), 8)
            self.assertEqual(theirs.GetOutput().GetNumberOfPoints(), 58)
            for i in range(50, 58):
                for ours, expected in zip(
                        algorithm.GetOutput().GetPoint(i), theirs.GetOutput().GetPoint(i)):
                    self.assertAlmostEqual(ours, expected, delta=1e-11, msg=(offset, i))

    def test_abort_and_run_again(self):
        algorithm = vtkAdaptiveHilbertDelaunay2D()
        algorithm.SetInputData(cloud(lattice_points(20000, 10**5)))
        cells = check_abort_and_run_again(self, algorithm, lambda output: output.GetNumberOfCells())
        self.assertGreater(cells, 30000)


if __name__ == "__main__":
    run_tests()
