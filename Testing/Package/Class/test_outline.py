# SPDX-License-Identifier: BSD-3-Clause
"""vtkPlanarSurfaceOutline, compiled and in Python: the same lines, data and messages."""

import math
import re
import unittest

from classtests import Filter, array, blocks, cloud, core, make_points, model, source, tested_class, uniform, vtk

Outline = tested_class("vtkPlanarSurfaceOutline")
FLAT = [(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0), (3, 3, 0), (6, 3, 0), (6, 6, 0), (3, 6, 0)]


def ids_of(data, k):
    ids = core.vtkIdList()
    data.GetLines().GetCellAtId(k, ids)
    return [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


def rings_of(data):
    return [[data.GetPoint(i) for i in ids_of(data, k)] for k in range(data.GetNumberOfLines())]


def values_of(data, name):
    found = data.GetCellData().GetArray(name)
    return [found.GetTuple1(i) for i in range(found.GetNumberOfTuples())]


def area(ring):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:])) / 2


class OutlineTest(unittest.TestCase):
    def run_on(self, data, **settings):
        self.said = []
        made = Outline()
        for event in ("WarningEvent", "ErrorEvent"):
            made.AddObserver(event, self.listener(event))
        made.SetInputDataObject(data)
        for name, value in settings.items():
            getattr(made, "Set" + name)(value)
        made.Update()
        return made.GetOutput()

    def listener(self, event):
        def listen(_caller, _event, text):
            self.said.append((event, text.strip().split("): ")[-1]))

        listen.CallDataType = core.VTK_STRING
        return listen

    def test_a_surface_with_a_hole(self):
        surface = Filter()
        surface.SetInputDataObject(cloud(FLAT))
        surface.SetSourceData(source(FLAT, polygons=[(0, 1, 2, 3), (4, 7, 6, 5)]))
        surface.Update()
        made = self.run_on(surface.GetOutput())
        self.assertEqual(rings_of(made), [[FLAT[k] for k in ring] for ring in ([0, 1, 2, 3, 0], [4, 7, 6, 5, 4])])
        self.assertEqual((values_of(made, "PolygonId"), values_of(made, "IsHole")), ([0, 0], [0, 1]))
        self.assertEqual(self.said, [])

    def test_groups(self):
        squares = source([(k // 2, k % 2, k) for k in range(10)], lines=[(0, 9)],
                         polygons=[(k, k + 2, k + 3, k + 1) for k in range(0, 8, 2)], verts=[(3,)])
        squares.GetPointData().AddArray(array("vtkIntArray", "Own", range(10)))
        squares.GetPointData().AddArray(array("vtkIntArray", "Few", [1]))
        squares.GetCellData().AddArray(array("vtkShortArray", "Band", [-9, -9, 7, 7, 3, 7]))
        made = self.run_on(squares, GroupArrayName="Band")
        self.assertEqual((values_of(made, "Band"), values_of(made, "PolygonId")), ([3, 7, 7], [0, 1, 2]))
        self.assertEqual(made.GetCellData().GetArray("Band").GetClassName(), "vtkShortArray")
        self.assertEqual([len(ring) for ring in rings_of(made)], [5, 7, 5])
        own = made.GetPointData().GetArray("Own")
        self.assertEqual([own.GetTuple1(i) for i in range(10)], [made.GetPoint(i)[2] for i in range(10)])
        self.assertIsNone(made.GetPointData().GetArray("Few"))
        squares.GetCellData().AddArray(array("vtkFloatArray", "Band", [0, 0, 1, math.nan, 1, math.nan]))
        self.assertEqual(values_of(self.run_on(squares, GroupArrayName="Band"), "Band"), [1, 1])
        self.assertEqual(len(rings_of(self.run_on(squares, GroupArrayName="None"))), 1)
        self.assertEqual(self.said, [])
        self.run_on(squares, GroupArrayName="Missing")
        self.assertEqual(self.said, [("WarningEvent", "The cells have no numeric array Missing with one number each. "
                                      "All are outlined together.")])
        squares.GetCellData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [0, 0, 0, 1, 0, 32]))
        self.assertEqual(len(rings_of(self.run_on(squares))), 2)

    def test_blocks_are_one_surface(self):
        """What two have in common at an edge is joined."""
        left = source([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], lines=[(0, 2)], polygons=[(0, 1, 2, 3)])
        right = source([(9, 9, 9), (1, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0)], polygons=[(1, 2, 3, 4)])
        made = self.run_on(blocks(left, None, right))
        self.assertEqual(rings_of(made), [[(int(x), int(y), 0) for x, y in "00 10 20 21 11 01 00".split()]])
        left.GetCellData().AddArray(array("vtkIntArray", "Band", [5, 3]))
        right.GetCellData().AddArray(array("vtkIntArray", "Band", [2]))
        made = self.run_on(blocks(left, right), GroupArrayName="Band")
        self.assertEqual((values_of(made, "Band"), len(rings_of(made))), ([2, 3], 2))
        self.assertEqual(self.said, [])
        right.GetCellData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [1]))
        self.assertEqual(rings_of(self.run_on(blocks(left, right)))[0][1], (1, 0, 0))
        self.assertEqual(len(rings_of(self.run_on(blocks(left, right)))[0]), 5)
        self.run_on(blocks(left, model.vtkImageData()))
        self.assertEqual(self.said, [("WarningEvent", "1 block is not in the outline: not vtkPolyData.")])
        self.assertEqual(self.run_on(blocks()).GetNumberOfCells(), 0)

    def test_ids_of_a_block_are_its_own(self):
        left = source(FLAT[:4], polygons=[(0, 1, 2, 3), (0, 1, 6)])
        right = source(FLAT[4:], polygons=[(0, 1, 2), (0, 1, -2)])
        self.assertEqual([len(ring) for ring in rings_of(self.run_on(blocks(left, right)))], [5, 4])
        self.assertEqual([(kind, text[:12]) for kind, text in self.said], [("WarningEvent", "2 cells have")])

    def test_cells_without_points_have_numbers(self):
        nothing = source(FLAT, polygons=[()])
        nothing.GetCellData().AddArray(array("vtkIntArray", "Band", [3]))
        self.assertEqual(self.run_on(nothing, GroupArrayName="Band").GetNumberOfCells(), 0)
        self.assertEqual(self.said, [])
        square = source(FLAT, polygons=[(0, 1, 2, 3)])
        square.GetCellData().AddArray(array("vtkIntArray", "Band", [4]))
        made = self.run_on(blocks(nothing, square), GroupArrayName="Band")
        self.assertEqual((values_of(made, "Band"), len(rings_of(made))), ([4], 1))
        self.assertEqual([(kind, text[:10]) for kind, text in self.said], [("WarningEvent", "1 cell has")])

    def test_bands_of_contours(self):
        """Areas of bands are those of their cells; the rings of a band touch those of the next."""
        surface = Filter()
        points = [(20 * x, 20 * y, round(6 * math.sin(5 * x) * math.cos(4 * y))) for x, y in make_points(uniform, 400)]
        data = cloud(points)
        heights = array("vtkDoubleArray", "h", [p[2] for p in points])
        data.GetPointData().SetScalars(heights)
        surface.SetInputDataObject(data)
        surface.Update()
        bands = vtk("vtkFiltersModeling").vtkBandedPolyDataContourFilter()
        bands.SetInputData(surface.GetOutput())
        bands.GenerateValues(5, -5, 5)
        bands.SetScalarModeToValue()
        bands.Update()
        cells = bands.GetOutput()
        made = self.run_on(cells, GroupArrayName="Scalars")
        expected = {}
        corners = core.vtkIdList()
        for k in range(cells.GetNumberOfPolys()):
            cells.GetPolys().GetCellAtId(k, corners)
            ring = [cells.GetPoint(corners.GetId(i)) for i in range(corners.GetNumberOfIds())]
            band = cells.GetCellData().GetArray("Scalars").GetTuple1(k)
            expected[band] = expected.get(band, 0.0) + area(ring + ring[:1])
        found = {}
        for ring, band, hole in zip(rings_of(made), values_of(made, "Scalars"), values_of(made, "IsHole")):
            self.assertEqual(len(set(ring)), len(ring) - 1)
            self.assertEqual(area(ring) < 0, hole == 1)
            found[band] = found.get(band, 0.0) + area(ring)
        self.assertEqual(sorted(found), sorted(expected))
        for band, whole in expected.items():
            self.assertAlmostEqual(found[band], whole, delta=1e-3)
        self.assertGreater(sum(values_of(made, "IsHole")), 2)

    def test_what_cannot_be(self):
        self.run_on(cloud(FLAT))
        self.assertRegex(self.said[0][1], "no polygon")
        squares = source(FLAT, polygons=[(0, 1, 2, 3), (0, 1, 77)], strips=[(0, 1, 2, 3)])
        self.assertEqual(len(rings_of(self.run_on(squares))), 1)
        self.assertEqual([kind for kind, _ in self.said], ["WarningEvent"] * 2)
        made = self.run_on(squares, MemoryLimit=1)
        self.assertEqual(made.GetNumberOfCells(), 1)
        many = Filter()
        many.SetInputDataObject(cloud([(x, y, 0) for x, y in make_points(uniform, 3000)]))
        many.Update()
        made = self.run_on(many.GetOutput(), MemoryLimit=100)
        self.assertEqual(made.GetNumberOfCells(), 0)
        self.assertRegex(self.said[0][1], r"outline of \d+ cells may take .* but MemoryLimit allows 102 KB")
        limit = 100
        while made.GetNumberOfCells() == 0:  # the limit that is named is enough to come further
            named = int(re.search(r"or set MemoryLimit to (\d+) or more", self.said[0][1])[1])
            self.assertGreater(named, limit)
            limit, made = named, self.run_on(many.GetOutput(), MemoryLimit=named)
        wide = array("vtkDoubleArray", "Wide", [1.0] * 300000, 100)  # 2.4 MB; rings pass few of the points
        many.GetOutput().GetPointData().AddArray(wide)
        self.assertEqual(self.run_on(many.GetOutput(), MemoryLimit=900).GetNumberOfCells(), 1)
        triangles = many.GetOutput().GetNumberOfCells()
        many.GetOutput().GetCellData().AddArray(array("vtkDoubleArray", "Own", [float(k) for k in range(triangles)]))
        made = self.run_on(many.GetOutput(), MemoryLimit=3000, GroupArrayName="Own")
        self.assertEqual(made.GetNumberOfCells(), 0)
        self.assertRegex(self.said[0][1], r"outline of \d+ cells may take .* but MemoryLimit allows 3.07 MB")
        made = self.run_on(many.GetOutput(), MemoryLimit=8000, GroupArrayName="Own")
        self.assertEqual(made.GetNumberOfCells(), triangles)
        bad = source(FLAT, polygons=[(0, 1, 2, 3)])
        bad.GetPolys().SetData(array("vtkIdTypeArray", "", [0, 7]), array("vtkIdTypeArray", "", [0, 1, 2, 3]))
        self.assertEqual(self.run_on(bad).GetNumberOfCells(), 0)
        self.assertRegex(self.said[0][1], "polygons are damaged")
        self.assertEqual(self.run_on(source()).GetNumberOfCells(), 0)
        self.assertEqual(self.said, [])

    def test_it_is_aborted(self):
        many = Filter()
        many.SetInputDataObject(cloud([(x, y, 0) for x, y in make_points(uniform, 3000)]))
        many.Update()
        made = Outline()
        made.SetInputDataObject(many.GetOutput())
        made.AddObserver("ProgressEvent", lambda caller, _event: made.SetAbortExecute(1))
        made.Update()
        self.assertEqual(made.GetOutput().GetNumberOfCells(), 0)

    def test_pieces_and_settings(self):
        made = Outline()
        made.SetInputDataObject(source(FLAT, polygons=[(0, 1, 2, 3)]))
        made.UpdatePiece(0, 2, 0)
        self.assertEqual(made.GetOutput().GetNumberOfCells(), 1)
        made.UpdatePiece(1, 2, 0)
        self.assertEqual(made.GetOutput().GetNumberOfCells(), 0)
        time = made.GetMTime()
        made.SetGroupArrayName("")
        made.SetMemoryLimit(-5)
        self.assertEqual((made.GetMTime(), made.GetMemoryLimit(), made.GetGroupArrayName()), (time, 0, ""))
        made.SetGroupArrayName("x")
        self.assertGreater(made.GetMTime(), time)
        self.assertIn("\n  GroupArrayName: x\n", str(made))
        self.assertEqual((made.GetClassName(), made.IsA("vtkPolyDataAlgorithm")), ("vtkPlanarSurfaceOutline", 1))


if __name__ == "__main__":
    unittest.main()
