# SPDX-License-Identifier: BSD-3-Clause
"""adaptivehilbertdelaunay.drop_in: the replaced names; callers of vtkDelaunay2D find the methods of the original."""

import gc
import math
import os
import random
import re
import sys
import types
import unittest

import vtkmodules.all as everything
from vtkmodules import vtkFiltersCore
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, vtkFloatArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkDelaunay2D
from vtkmodules.vtkFiltersCore import vtkDelaunay2D as under_another_name
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

in_a_list = [vtkDelaunay2D]


class Holder:
    held = vtkDelaunay2D


import adaptivehilbertdelaunay  # noqa: E402 (what it changes is part of the test)

changed_by_package = vtkFiltersCore.vtkDelaunay2D is not in_a_list[0] or vtkDelaunay2D is not in_a_list[0]

from adaptivehilbertdelaunay import drop_in  # noqa: E402
from algorithmtests import run_tests  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))


def cloud(points, number=VTK_DOUBLE):
    """A vtkPolyData of points and no cells."""
    made = vtkPoints()
    made.SetDataType(number)
    for point in points:
        made.InsertNextPoint(point)
    data = vtkPolyData()
    data.SetPoints(made)
    return data


def source_of(points, loops=(), lines=()):
    """A vtkPolyData with these chains of point ids as polygons and as polylines."""
    data = vtkPolyData()
    data.SetPoints(points)
    for chains, use in ((loops, data.SetPolys), (lines, data.SetLines)):
        cells = vtkCellArray()
        for chain in chains:
            cells.InsertNextCell(len(chain))
            for corner in chain:
                cells.InsertCellPoint(corner)
        use(cells)
    return data


def cells(surface, kind):
    """The point ids of the Verts, Lines or Polys, one sorted tuple for each, sorted."""
    found = []
    part = getattr(surface, "Get" + kind)()
    for cell in range(part.GetNumberOfCells()):
        ids = vtkIdList()
        part.GetCellAtId(cell, ids)
        found.append(tuple(sorted(ids.GetId(i) for i in range(ids.GetNumberOfIds()))))
    return sorted(found)


def wide(seed, count=300, height=0.0):
    """Points inside half a circle's radius and seven that surround them: no triangle at the hull is flat, so
    that vtkDelaunay2D finds the whole hull."""
    numbers = random.Random(seed)
    points = []
    while len(points) < count:
        x, y = numbers.uniform(-500, 500), numbers.uniform(-500, 500)
        if x * x + y * y < 250000:
            points.append((x, y, numbers.uniform(0, height)))
    for corner in range(7):
        turn = 2 * math.pi * (corner + 0.2 * numbers.random()) / 7
        points.append((1000 * math.cos(turn), 1000 * math.sin(turn), numbers.uniform(0, height)))
    return points


def run(maker, data, **settings):
    """A filter of this class with these settings, updated."""
    algorithm = maker()
    algorithm.SetInputData(data)
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.Update()
    return algorithm


def names_of_it():
    """The values of the names of vtkDelaunay2D in VTK and this module."""
    return vtkFiltersCore.vtkDelaunay2D, everything.vtkDelaunay2D, vtkDelaunay2D, under_another_name


class ReplacementTest(unittest.TestCase):
    def test_the_package_alone_changes_nothing(self):
        self.assertFalse(changed_by_package)

    def test_all_modules_have_the_new_class(self):
        for found in names_of_it():
            self.assertIs(found, drop_in.vtkDelaunay2D)
        self.assertIs(drop_in.original, in_a_list[0])
        self.assertTrue(drop_in.installed())

    def test_what_no_module_holds_stays(self):
        self.assertIs(in_a_list[0], drop_in.original)
        self.assertIs(Holder.held, drop_in.original)

    def test_suspended_and_back(self):
        with drop_in.suspended() as inside:
            self.assertIs(inside, drop_in.original)
            for found in names_of_it():
                self.assertIs(found, drop_in.original)
            with drop_in.suspended():
                pass
            self.assertFalse(drop_in.installed())
        self.assertIs(under_another_name, drop_in.vtkDelaunay2D)

    def test_suspended_ends_with_an_exception(self):
        with self.assertRaises(KeyError):
            with drop_in.suspended():
                raise KeyError
        self.assertTrue(drop_in.installed())

    def test_uninstall_and_install_twice(self):
        for _ in range(2):
            drop_in.uninstall()
            self.assertIs(vtkDelaunay2D, drop_in.original)
        for _ in range(2):
            drop_in.install()
            self.assertIs(vtkDelaunay2D, drop_in.vtkDelaunay2D)

    def test_names_taken_while_installed_go_back_too(self):
        later = types.ModuleType("later")
        exec("from vtkmodules.vtkFiltersCore import vtkDelaunay2D as taken", vars(later))
        sys.modules["later"] = later
        try:
            self.assertIs(later.taken, drop_in.vtkDelaunay2D)
            with drop_in.suspended():
                self.assertIs(later.taken, drop_in.original)
        finally:
            del sys.modules["later"]

    def test_modules_of_any_kind_are_borne(self):
        class Lazy(types.ModuleType):
            def __getattribute__(self, name):
                raise AssertionError("a look at it loads it")

        strange = {"lazy": Lazy("lazy"), "nothing": None, "an object": object(), "a number": 3}
        sys.modules.update(strange)
        try:
            with drop_in.suspended():
                self.assertIs(vtkDelaunay2D, drop_in.original)
        finally:
            for name in strange:
                del sys.modules[name]


class InterfaceTest(unittest.TestCase):
    """Every method of the original is there, with the same default."""

    # Methods without an argument whose result differs, and why.
    DIFFERENT = {
        "GetMTime": "another object",
        "GetObjectDescription": "names the class behind it, and its address",
        "GetNumberOfOutputPorts": "the order of insertion and the Voronoi diagram are outputs, too",
    }

    @staticmethod
    def public(kind):
        return [name for name in dir(kind) if not name.startswith("_")]

    def test_every_method_is_there(self):
        with drop_in.suspended():
            names = self.public(drop_in.original)
        self.assertGreater(len(names), 100)
        self.assertEqual([name for name in names if not hasattr(drop_in.vtkDelaunay2D, name)], [])

    def test_every_default_is_the_same(self):
        ours, theirs = drop_in.vtkDelaunay2D(), drop_in.original()
        compared = 0
        for name in self.public(drop_in.original):
            if not re.match("(Get|Has|Is)[A-Z]", name):
                continue
            try:
                expected = getattr(theirs, name)()
            except TypeError:
                continue  # it needs an argument
            answer = getattr(ours, name)()
            if hasattr(expected, "GetClassName"):
                answer, expected = answer.GetClassName(), expected.GetClassName()
            if name in self.DIFFERENT:
                self.assertNotEqual(answer, expected, name)
            else:
                self.assertEqual(answer, expected, name)
            compared += 1
        self.assertGreater(compared, 25)

    def test_settings_are_kept_in_the_same_ranges(self):
        ours, theirs = drop_in.vtkDelaunay2D(), drop_in.original()
        values = (-1, 0, 0.3, 1, 2, 7, 1e300)
        for name in ("Alpha", "Tolerance", "Offset", "ProjectionPlaneMode", "BoundingTriangulation"):
            for value in values:
                if name in ("ProjectionPlaneMode", "BoundingTriangulation"):
                    value = int(value) % 4
                for algorithm in (ours, theirs):
                    getattr(algorithm, "Set" + name)(value)
                found = [getattr(algorithm, "Get" + name)() for algorithm in (ours, theirs)]
                self.assertEqual(*found, (name, value))

    def test_switches(self):
        methods = self.public(drop_in.original)
        names = [name[:-2] for name in methods if name.endswith("On") and "Get" + name[:-2] in methods]
        self.assertIn("BoundingTriangulation", names)
        for name in names:
            ours = drop_in.vtkDelaunay2D()
            getattr(ours, name + "On")()
            self.assertTrue(getattr(ours, "Get" + name)(), name)
            getattr(ours, name + "Off")()
            self.assertFalse(getattr(ours, "Get" + name)(), name)

    def test_a_new_setting_modifies_the_filter_and_an_old_one_does_not(self):
        ours = drop_in.vtkDelaunay2D()
        for name, value in (("Alpha", 2.0), ("Tolerance", 0.5), ("Offset", 3.0), ("ProjectionPlaneMode", 2)):
            before = ours.GetMTime()
            getattr(ours, "Set" + name)(value)
            after = ours.GetMTime()
            self.assertGreater(after, before, name)
            getattr(ours, "Set" + name)(value)
            self.assertEqual(ours.GetMTime(), after, name)


class IdentityTest(unittest.TestCase):
    def test_it_says_it_is_the_original(self):
        ours = vtkDelaunay2D()
        self.assertEqual(ours.GetClassName(), "vtkDelaunay2D")
        for name in ("vtkDelaunay2D", "vtkAdaptiveHilbertDelaunay2D", "vtkPolyDataAlgorithm", "vtkObject"):
            self.assertEqual(ours.IsA(name), 1, name)
            self.assertEqual(vtkDelaunay2D.IsTypeOf(name), 1, name)
        for name in ("vtkDelaunay3D", ""):
            self.assertEqual(ours.IsA(name), 0, name)
            self.assertEqual(vtkDelaunay2D.IsTypeOf(name), 0, name)
        for name in ("vtkDelaunay2D", "vtkPolyDataAlgorithm", "vtkObject", "vtkCell"):
            generations = drop_in.original.GetNumberOfGenerationsFromBaseType(name)
            self.assertEqual(ours.GetNumberOfGenerationsFromBase(name), generations)
            self.assertEqual(vtkDelaunay2D.GetNumberOfGenerationsFromBaseType(name), generations)

    def test_isinstance_and_casts(self):
        ours, theirs = vtkDelaunay2D(), drop_in.original()
        for one in (ours, theirs):
            self.assertIsInstance(one, vtkDelaunay2D)
            self.assertIs(vtkDelaunay2D.SafeDownCast(one), one)
        for other in (vtkSphereSource(), None):
            self.assertNotIsInstance(other, vtkDelaunay2D)
            self.assertIsNone(vtkDelaunay2D.SafeDownCast(other))

    def test_new_instance(self):
        ours = vtkDelaunay2D()
        ours.SetTolerance(0.25)
        another = ours.NewInstance()
        self.assertIs(type(another), vtkDelaunay2D)
        self.assertEqual(another.GetTolerance(), 1e-5)

    def test_derived_classes(self):
        class Derived(vtkDelaunay2D):
            def __init__(self, alpha):
                self.SetAlpha(alpha)

        derived = Derived(3.0)
        self.assertEqual((derived.GetAlpha(), derived.GetTolerance()), (3.0, 1e-5))
        self.assertIsInstance(derived, vtkDelaunay2D)
        self.assertNotIsInstance(drop_in.original(), Derived)
        self.assertNotIsInstance(vtkDelaunay2D(), Derived)

    def test_only_the_pipeline_knows_it(self):
        def pipeline():
            sphere, delaunay = vtkSphereSource(), vtkDelaunay2D()
            delaunay.SetInputConnection(sphere.GetOutputPort())
            delaunay.SetTolerance(0.125)
            delaunay.note = "kept"
            end = vtkTriangleFilter()
            end.SetInputConnection(delaunay.GetOutputPort())
            return end

        end = pipeline()
        gc.collect()
        end.Update()
        self.assertGreater(end.GetOutput().GetNumberOfPolys(), 0)
        found = end.GetInputConnection(0, 0).GetProducer()
        self.assertIs(type(found), vtkDelaunay2D)
        self.assertEqual((found.GetTolerance(), found.note), (0.125, "kept"))


class OutputTest(unittest.TestCase):
    def test_points_and_arrays_are_passed_and_nothing_is_added(self):
        data = cloud(wide(1))
        for attributes, rows in ((data.GetPointData(), data.GetNumberOfPoints()), (data.GetFieldData(), 2)):
            array = vtkFloatArray()
            array.SetName("mine")
            array.SetNumberOfTuples(rows)
            array.Fill(4)
            attributes.AddArray(array)
        surface = run(vtkDelaunay2D, data).GetOutput()
        self.assertIs(surface.GetPoints(), data.GetPoints())
        self.assertEqual(surface.GetClassName(), "vtkPolyData")
        expected = ((surface.GetPointData(), 1), (surface.GetFieldData(), 1), (surface.GetCellData(), 0))
        for attributes, count in expected:
            names = [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]
            self.assertEqual(names, ["mine"] * count)

    def test_field_data_of_blocks(self):
        blocks, inner = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        for place, data in ((inner, cloud(wide(1))), (blocks, cloud(wide(2)))):
            array = vtkFloatArray()
            array.SetName("of this block")
            data.GetFieldData().AddArray(array)
            place.SetBlock(1, data)
        blocks.SetBlock(0, inner)
        ours = vtkDelaunay2D()
        ours.SetInputDataObject(blocks)
        ours.Update()
        output = ours.GetOutputDataObject(0)
        for surface in (output.GetBlock(1), output.GetBlock(0).GetBlock(1)):
            self.assertEqual(surface.GetNumberOfPolys(), 2 * 307 - 2 - 7)
            fields = surface.GetFieldData()
            names = [fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())]
            self.assertEqual(names, ["of this block"])

    def test_points_within_the_tolerance_are_merged_and_counted(self):
        points = [(0, 0, 0), (1000, 0, 0), (1000, 1000, 5000), (0, 1000, 0)]
        points += [(500, 400, 0), (500, 400.01, 9000)]
        ours = run(vtkDelaunay2D, cloud(points))  # 1e-5 of the diagonal, 1414, is 0.014
        self.assertEqual(ours.GetNumberOfMergedPoints(), 1)
        self.assertEqual(ours.GetOutput().GetNumberOfPoints(), 6)
        self.assertEqual(ours.GetOutput().GetNumberOfPolys(), 4)
        ours.SetTolerance(0)
        ours.Update()
        self.assertEqual(ours.GetNumberOfMergedPoints(), 0)
        self.assertEqual(ours.GetOutput().GetNumberOfPolys(), 6)

    def test_the_transform_is_kept(self):
        turn = vtkTransform()
        turn.RotateX(90)
        data = cloud([(x, z, -y) for x, y, z in wide(2)])
        ours = run(vtkDelaunay2D, data, Transform=turn)
        first = cells(ours.GetOutput(), "Polys")
        self.assertIs(ours.GetTransform(), turn)
        ours.Modified()
        ours.Update()
        self.assertIs(ours.GetTransform(), turn)
        self.assertEqual(cells(ours.GetOutput(), "Polys"), first)
        self.assertEqual(len(first), 2 * 307 - 2 - 7)

    def test_progress_and_abort(self):
        data = cloud([(x, y, 0) for x in range(200) for y in range(200)])
        ours = vtkDelaunay2D()
        ours.SetInputData(data)
        said = []
        ours.AddObserver("ProgressEvent", lambda caller, event: said.append(caller.GetProgress()))
        events = []
        for event in ("StartEvent", "EndEvent"):
            ours.AddObserver(event, lambda caller, name: events.append(name))
        ours.Update()
        self.assertGreater(len(said), 2)
        self.assertEqual(said, sorted(said))
        self.assertEqual(events, ["StartEvent", "EndEvent"])
        self.assertEqual(ours.GetOutput().GetNumberOfPolys(), 2 * 199 * 199)

    def test_errors_come_where_the_original_has_them(self):
        def complaints(maker, data):
            algorithm, said = maker(), []
            if data is not None:
                algorithm.SetInputDataObject(data)
            algorithm.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: said.append(event))
            algorithm.Update()
            output = algorithm.GetOutput()
            return len(said), output.GetNumberOfPoints(), output.GetNumberOfCells()

        for data in (None, vtkImageData()):
            self.assertEqual(complaints(vtkDelaunay2D, data), complaints(drop_in.original, data))

    def test_an_empty_input_is_no_error(self):
        ours = vtkDelaunay2D()
        said = []
        for event in ("ErrorEvent", "WarningEvent"):
            ours.AddObserver(event, lambda caller, name: said.append(name))
        ours.SetInputData(vtkPolyData())
        ours.Update()
        self.assertEqual((said, ours.GetOutput().GetNumberOfCells()), ([], 0))


class OriginalTest(unittest.TestCase):
    """Points in general position, without cases that vtkDelaunay2D gets wrong: the same cells, as sets."""

    def compare(self, data, kinds=("Polys",), **settings):
        ours = run(drop_in.vtkDelaunay2D, data, **settings).GetOutput()
        theirs = run(drop_in.original, data, **settings).GetOutput()
        self.assertIs(type(ours), type(theirs))
        for kind in kinds:
            self.assertEqual(cells(ours, kind), cells(theirs, kind), kind)
        return ours, theirs

    def test_triangles(self):
        for seed in range(6):
            for number in (VTK_FLOAT, VTK_DOUBLE):
                surface, _ = self.compare(cloud(wide(seed, 60 * seed + 20), number))
                self.assertEqual(surface.GetNumberOfPolys(), 2 * (60 * seed + 27) - 2 - 7)

    def test_heights_do_not_matter(self):
        self.compare(cloud(wide(7, height=100)))

    def test_transform(self):
        turn = vtkTransform()
        turn.RotateWXYZ(50, 1, 2, 3)
        back = turn.GetInverse()
        self.compare(cloud([back.TransformPoint(point) for point in wide(8)]), Transform=turn)

    def test_best_fitting_plane(self):
        turn = vtkTransform()
        turn.RotateWXYZ(40, 1, 2, 0)
        wall = cloud([turn.TransformPoint(point) for point in wide(9, height=10)])
        self.compare(wall, ProjectionPlaneMode=2)

    def test_flat_points_in_their_best_fitting_plane(self):
        """As PyVista's delaunay_2d requests it: nothing is trimmed."""
        numbers = random.Random(10)
        flat = cloud([(numbers.random(), numbers.random(), 5.0) for _ in range(2000)])
        surface = run(drop_in.vtkDelaunay2D, flat, ProjectionPlaneMode=2).GetOutput()
        self.assertEqual(cells(surface, "Polys"), cells(run(drop_in.vtkDelaunay2D, flat).GetOutput(), "Polys"))

    def test_alpha(self):
        for seed in range(3):
            for alpha in (10.0, 30.0, 60.0, 200.0):
                data = cloud(wide(seed, height=40))
                self.compare(data, ("Verts", "Lines", "Polys"), Alpha=alpha)

    def test_bounding_triangulation(self):
        for seed in range(3):
            ours, theirs = self.compare(cloud(wide(seed)), BoundingTriangulation=1, Offset=3.0)
            self.assertEqual(ours.GetNumberOfPoints(), 307 + 8)
            for i in range(307 + 8):
                for a, b in zip(ours.GetPoint(i), theirs.GetPoint(i)):
                    self.assertAlmostEqual(a, b, delta=1e-9)

    def test_bounding_triangulation_with_alpha(self):
        self.compare(cloud(wide(4)), ("Verts", "Lines", "Polys"), BoundingTriangulation=1, Alpha=50.0)

    def test_constraints(self):
        """The same part of the plane, with as many triangles: vtkDelaunay2D's need not be Delaunay there."""
        points = wide(5)
        turns = [2 * math.pi * k / 40 for k in range(40)]
        ring = [(400 * math.cos(turn) + 0.5, 300 * math.sin(turn)) for turn in turns]
        hole = [(0.3 * x - 40, 0.4 * y + 10) for x, y in ring]
        near = [(x, y) for x, y in ring + hole]
        points = [p for p in points if all(math.hypot(p[0] - x, p[1] - y) > 25 for x, y in near)]
        count = len(points)
        points += [(x, y, 0.0) for x, y in near]
        data = cloud(points)
        loops = [range(count, count + 40), range(count + 79, count + 39, -1)]
        settings = {"SourceData": source_of(data.GetPoints(), loops=loops)}
        makers = (drop_in.vtkDelaunay2D, drop_in.original)
        surfaces = [run(maker, data, **settings).GetOutput() for maker in makers]
        self.assertEqual(*[surface.GetNumberOfPolys() for surface in surfaces])
        areas = [sum(s.GetCell(i).ComputeArea() for i in range(s.GetNumberOfCells())) for s in surfaces]
        self.assertAlmostEqual(areas[0], areas[1], delta=1e-6 * areas[1])
        self.assertEqual([s.GetNumberOfPoints() for s in surfaces], [len(points)] * 2)

    def test_the_best_fitting_plane_that_is_asked_for(self):
        turn = vtkTransform()
        turn.RotateWXYZ(40, 1, 2, 0)
        data = cloud([turn.TransformPoint(point) for point in wide(9, height=10)])
        plane = drop_in.vtkDelaunay2D.ComputeBestFittingPlane(data)
        self.assertTrue(plane.IsA("vtkAbstractTransform"))
        by_hand = run(vtkDelaunay2D, data, Transform=plane, ProjectionPlaneMode=1).GetOutput()
        itself = run(vtkDelaunay2D, data, ProjectionPlaneMode=2).GetOutput()
        self.assertEqual(cells(by_hand, "Polys"), cells(itself, "Polys"))


if __name__ == "__main__":
    run_tests()
