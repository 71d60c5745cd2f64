# SPDX-License-Identifier: BSD-3-Clause
"""vtkAdaptiveHilbertQualityMesh2D, compiled and in Python: the bytes of made.refine() for NumPy, data, messages."""

import math
import re
import warnings

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, delaunay
from classtests import (TABLE, Case, Filter, Said, array, blocks, cloud, core, make_points, model, run_tests, source,
                        tested_class, triangles, uniform, values_of, vtk)

QualityMesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
SQUARE = [(0, 0, 0), (9, 0, 9), (9, 9, 0), (0, 9, 9), (3, 3, 1), (6, 3, 2), (6, 6, 3), (3, 6, 4)]
PLATE = {"polygons": [(0, 1, 2, 3), (4, 7, 6, 5)], "lines": [(1, 5)]}


def meshed(points, constraints=None, triangulation=(), **settings):
    """The filter, updated, and its messages."""
    made = QualityMesh()
    said = Said(made)
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    for name, value in dict(triangulation).items():
        getattr(made.GetTriangulation(), "Set" + name)(value)
    made.SetInputDataObject(points)
    if constraints is not None:
        made.SetSourceData(constraints)
    made.Update()
    return made, said


def numbers(data, name):
    return values_of(data.GetArray(name))


def lines_of(data):
    ids, found = core.vtkIdList(), []
    for k in range(data.GetNumberOfLines()):
        data.GetLines().GetCellAtId(k, ids)
        found.append((ids.GetId(0), ids.GetId(1)))
    return found


def plate(**settings):
    return meshed(cloud(SQUARE), source(**PLATE), **settings)


class QualityMeshTest(Case):
    def assertIsMesh(self, made, mesh, values):
        """The outputs are those of NumPy's, bit for bit."""
        found, pieces = made.GetOutput(0), made.GetOutput(1)
        reasons = np.full(len(mesh.triangles), -1)
        reasons[mesh.bad] = mesh.reasons
        self.assertEqual(pieces.GetNumberOfPoints(), found.GetNumberOfPoints())
        for what, one, other in (
                ("points", [found.GetPoint(i) for i in range(found.GetNumberOfPoints())], mesh.points),
                ("triangles", triangles(found), mesh.triangles),
                ("BadReason", numbers(found.GetCellData(), "BadReason"), reasons),
                ("RegionId", numbers(found.GetCellData(), "RegionId"), mesh.regions),
                ("Value", numbers(found.GetPointData(), "Value"), mesh.interpolate(values)),
                ("lines", lines_of(pieces), mesh.edges),
                ("SourceCell", numbers(pieces.GetCellData(), "SourceCell"), mesh.markers[:, 0]),
                ("IsBoundary", numbers(pieces.GetCellData(), "IsBoundary"), mesh.on_boundary),
                ("Value of pieces", numbers(pieces.GetPointData(), "Value"), numbers(found.GetPointData(), "Value")),
        ):  # fmt: skip
            np.testing.assert_array_equal(one, other, what)  # assertEqual() would compare long lists for minutes
        self.assertEqual(made.GetNumberOfAddedPoints(), len(mesh.corners))
        self.assertEqual(made.GetNumberOfBadTriangles(), len(mesh.bad))
        self.assertEqual(made.GetNumberOfEncroachedPieces(), mesh.encroached_pieces)

    def test_the_mesh_of_numpy(self):
        random = np.random.default_rng(3)
        for trial in range(24):
            count = int(random.integers(5, 30))
            xyz = np.c_[random.random((count, 2)) if trial % 3 else random.integers(0, 7, (count, 2)),
                        random.random(count)]
            lines = [random.integers(0, count, random.integers(2, 5)).tolist() for _ in range(random.integers(0, 4))]
            loops = [random.integers(0, count, random.integers(3, 6)).tolist() for _ in range(random.integers(0, 2))]
            values, splits, fits = random.random(count), trial % 2, trial % 5 == 4
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DelaunayWarning)
                mesh = delaunay(
                    xyz, lines=lines, loops=loops, fill_rule="even_odd", crossings="split" if splits else "leave_out",
                    plane="best_fit" if fits else "xy").refine(25, maximum_area=0.05, maximum_added=400)
            given = cloud(xyz.tolist())
            given.GetPointData().AddArray(array("vtkDoubleArray", "Value", values))
            made, said = meshed(
                given, source(lines=lines, polygons=loops), MinimumAngle=25, MaximumArea=0.05,
                MaximumNumberOfAddedPoints=400, triangulation={
                    "FillRule": 1, "CrossingMode": int(splits), "ProjectionPlaneMode": 2 * fits})
            self.assertEqual((said.errors, said.pipeline), ([], []))
            with self.subTest(trial=trial):
                self.assertIsMesh(made, mesh, values)

    def test_a_source_with_points_and_sizes(self):
        inside = [(1, 1, 5), (8, 8, 6), (9, 9, 7), (math.nan, 1, 1), (1, 1, 9)]
        given, constraints = cloud(inside), source(SQUARE, verts=[(0,)], **PLATE)
        sizes = [2, 1, 1, 1, 2], [1, 1, 1, 1, 0.2, 0.2, 0.2, 0.2]
        for data, of in ((given, sizes[0]), (constraints, sizes[1])):
            data.GetPointData().AddArray(array("vtkDoubleArray", "Value", of))
        made, said = meshed(given, constraints, SizeArrayName="Value", MinimumAngle=28,
                            triangulation={"SourceMode": Filter.SOURCE_COORDINATES, "FillRule": 1})
        self.assertSaid(said, warnings=1)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            before = delaunay(np.array(inside), source_points=np.array(SQUARE, float), fill_rule="even_odd",
                              lines=PLATE["lines"], loops=PLATE["polygons"])
            mesh = before.refine(28, sizes=sum(sizes, []))
        found, pieces = made.GetOutput(0), made.GetOutput(1)
        self.assertEqual(triangles(found), [tuple(row) for row in mesh.triangles.tolist()])
        self.assertEqual(numbers(found.GetPointData(), "OriginalPointIds"),
                         list(range(5)) + [-1] * (found.GetNumberOfPoints() - 5))
        # of the source with a vertex before its cells
        self.assertEqual(numbers(pieces.GetCellData(), "SourceCell"), (mesh.markers[:, 0] + 1).tolist())
        self.assertGreaterEqual(made.GetLeastAngle(), 28 - 1e-9)

    def test_a_lighter_surface(self):
        """Settings of the simplification hold; all points stay, with their ids."""
        hills = [(x, y, 0.2 * math.cos(3 * x) * math.cos(2 * y)) for x, y in make_points(uniform, 300)]
        given, values = cloud(hills), [float(k) for k in range(300)]
        given.GetPointData().AddArray(array("vtkDoubleArray", "Value", values))
        mesh = delaunay(np.array(hills), maximum_error=0.02).refine(25, maximum_area=0.02)
        made, said = meshed(given, MinimumAngle=25, MaximumArea=0.02, triangulation={"MaximumError": 0.02})
        self.assertSaid(said)
        self.assertIsMesh(made, mesh, np.array(values))
        used = {corner for cell in triangles(made.GetOutput(0)) for corner in cell if corner < 300}
        self.assertLess(len(used), 200)

    def test_data_of_all_kinds(self):
        data = cloud(SQUARE)
        for kind, name in (("vtkFloatArray", "Float"), ("vtkIntArray", "Int"), ("vtkUnsignedCharArray", "Byte"),
                           ("vtkIdTypeArray", "Ids")):
            data.GetPointData().AddArray(array(kind, name, range(8)))
        data.GetPointData().AddArray(array("vtkDoubleArray", "Vector", [float(k) for k in range(16)], 2))
        names = core.vtkStringArray()
        names.SetName("Names")
        for k in range(8):
            names.InsertNextValue("point %d" % k)
        data.GetPointData().AddArray(names)
        data.GetPointData().SetGlobalIds(data.GetPointData().GetArray("Ids"))
        made, said = meshed(data, source(**PLATE), MinimumAngle=30, MaximumArea=0.5)
        self.assertSaid(said)
        points, count = made.GetOutput(0).GetPointData(), made.GetOutput(0).GetNumberOfPoints()
        self.assertGreater(count, 20)
        self.assertIsNone(points.GetGlobalIds())
        self.assertEqual(numbers(points, "Ids"), list(range(8)) + [-1] * (count - 8))
        for name, kind in (("Float", "vtkFloatArray"), ("Int", "vtkIntArray"), ("Byte", "vtkUnsignedCharArray")):
            self.assertEqual(points.GetArray(name).GetClassName(), kind)
            self.assertEqual(points.GetArray(name).GetNumberOfTuples(), count)
        floats = numbers(points, "Float")
        self.assertEqual(numbers(points, "Int")[8:], [math.floor(value + 0.5) for value in floats[8:]])
        self.assertEqual(numbers(points, "Int"), numbers(points, "Byte"))
        self.assertEqual(points.GetArray("Vector").GetNumberOfTuples(), count)
        self.assertEqual([points.GetAbstractArray("Names").GetValue(k) for k in (7, 8)], ["point 7", ""])

    def test_infinite_values(self):
        """NumPy has nothing to say of them."""
        data = cloud(SQUARE)
        data.GetPointData().AddArray(array("vtkDoubleArray", "Huge", [math.inf, 1e308, -math.inf, 0.0] * 2))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            made, said = meshed(data, source(**PLATE), MinimumAngle=30)
            self.assertSaid(said)
            mesh = delaunay(np.array(SQUARE, float), lines=PLATE["lines"], loops=PLATE["polygons"],
                            fill_rule="even_odd").refine(30)
            values = mesh.interpolate(np.array([math.inf, 1e308, -math.inf, 0.0] * 2))
        self.assertTrue(any(value != value for value in values))
        self.assertEqual(str(numbers(made.GetOutput(0).GetPointData(), "Huge")), str(values.tolist()))

    def test_floats_duplicates_and_hidden_points(self):
        xyz = SQUARE + [(0, 0, 5), (4, 1, 0), (1, 4, 0)]
        data = cloud(xyz, core.VTK_FLOAT)
        data.GetPointData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [0] * 10 + [2]))
        made, said = meshed(data, source(**PLATE), MinimumAngle=30)
        found = made.GetOutput(0)
        self.assertEqual(found.GetPoints().GetDataType(), core.VTK_DOUBLE)
        used = {corner for cell in triangles(found) for corner in cell}
        self.assertEqual({8, 10} & used, set())
        self.assertTrue(set(range(8)) | {9} <= used)
        marks = [0] * 10 + [2] + [0] * made.GetNumberOfAddedPoints()
        self.assertEqual(numbers(found.GetPointData(), "vtkGhostType"), marks)

    def test_counts_and_measures(self):
        made, said = plate(MinimumAngle=30, MaximumArea=0.5)
        self.assertSaid(said)
        fields = made.GetOutput(0).GetFieldData()
        for name, row in TABLE["quality"]["measures"].items():
            value = getattr(made, "Get" + name)()
            if row["type"] == "id":
                self.assertEqual(numbers(fields, name), [value])
        self.assertEqual(made.GetNumberOfTriangles(), made.GetOutput(0).GetNumberOfCells())
        self.assertRegex(made.GetMeasures(), r"\d+ triangles\n\d+ points added\n\d+ of these on segments\n"
                                             r"3\d(\.\d)? degrees in the least angle")
        self.assertRegex(made.GetResources(), r"[\d,]+ KiB")
        self.assertIn("\n  MinimumAngle: 30\n", str(made))
        made, _ = plate(MinimumAngle=30, MaximumArea=0.5, MaximumNumberOfAddedPoints=60)
        reasons = numbers(made.GetOutput(0).GetCellData(), "BadReason")
        self.assertEqual((made.GetNumberOfAddedPoints(), set(reasons)), (60, {-1, 1}))

    def test_nothing(self):
        for data, said_of in ((cloud([]), 0), (cloud(SQUARE[:2]), 1)):
            made, said = meshed(data)
            self.assertSaid(said, warnings=said_of)
            self.assertEqual((made.GetOutput(0).GetNumberOfCells(), made.GetLeastAngle()), (0, 0.0))
            self.assertEqual(made.GetOutput(0).GetNumberOfPoints(), data.GetNumberOfPoints())
        made, said = meshed(cloud(SQUARE), source(polygons=[(3, 2, 1, 0)]))  # a hole, and nothing around it
        self.assertEqual((made.GetOutput(0).GetNumberOfCells(), made.GetNumberOfTriangles()), (0, 0))
        self.assertSaid(said, warnings=1)

    def assertRefused(self, pattern, data=None, constraints=None, **settings):
        made, said = meshed(cloud(SQUARE) if data is None else data, constraints, **settings)
        self.assertEqual((len(said.errors), said.pipeline), (1, []), said.errors)
        self.assertRegex(said.errors[0], pattern)
        for output in map(made.GetOutput, (0, 1)):
            self.assertEqual((output.GetNumberOfPoints(), output.GetNumberOfCells()), (0, 0))
            parts = output.GetPointData(), output.GetCellData(), output.GetFieldData()
            self.assertEqual([part.GetNumberOfArrays() for part in parts], [0, 0, 0])
        self.assertEqual((made.GetNumberOfTriangles(), made.GetNumberOfAddedPoints(), made.GetMeasures()), (0, 0, ""))
        return made

    def test_refusals(self):
        for name, value in (("Alpha", 2.0), ("MaximumEdgeLength", 2.0), ("InsertionLimit", 5)):
            self.assertRefused("with %s cannot be refined" % name, triangulation={name: value})
        self.assertRefused("no numeric array Missing", SizeArrayName="Missing")
        for values, components, pattern in (
                ([1.0] * 3 + [0.0] + [1.0] * 4, 1, r"The size at point 3 is 0\.0+: sizes .* above 0\. Nothing was"),
                ([1.0] * 7 + [math.nan], 1, "The size at point 7 is -?nan"), ([1.0] * 7, 1, "no numeric array Size"),
                ([1.0] * 16, 2, "no numeric array Size")):
            data = cloud(SQUARE)
            data.GetPointData().AddArray(array("vtkDoubleArray", "Size", values, components))
            self.assertRefused(pattern, data, SizeArrayName="Size")
        self.assertRefused("A coordinate of point 1", cloud([(0, 0, 0), (1e300, 0, 0), (0, 1e300, 0)]))
        bad = source(polygons=[(0, 1, 2, 3)])
        bad.GetPolys().SetData(array("vtkIdTypeArray", "", [0, 7]), array("vtkIdTypeArray", "", [0, 1, 2, 3]))
        self.assertRefused("polygons of the source are damaged", constraints=bad)
        made = QualityMesh()
        said = Said(made)
        made.SetTriangulation(None)
        made.SetInputDataObject(cloud(SQUARE))
        made.Update()
        self.assertEqual(len(said.errors), 1)
        self.assertRegex(said.errors[0], "Triangulation is null")
        made, said = meshed(blocks(cloud(SQUARE[:3]), cloud(SQUARE[3:])))
        self.assertSaid(said)
        self.assertEqual(made.GetNumberOfTriangles(), meshed(cloud(SQUARE))[0].GetNumberOfTriangles())

    def test_memory(self):
        """Before it, and in the middle."""
        many = cloud([(x, y, 0) for x, y in make_points(uniform, 3000)])
        made = self.assertRefused("Triangulating 3000 points may take .* MemoryLimit allows 102 KB", many,
                                  triangulation={"MemoryLimit": 100})
        self.assertGreater(made.GetMemoryEstimate(), 100)
        made, said = meshed(many, triangulation={"MemoryLimit": 50000}, MinimumAngle=20, MaximumNumberOfAddedPoints=0)
        self.assertSaid(said)
        least = made.GetMemoryEstimate()
        made = self.assertRefused(
            r"Refining the triangles of 3000 points takes more than .* of memory, but MemoryLimit .*allows .*"
            r"or set MemoryLimit to \d+ or more \(KiB\)", many,
            triangulation={"MemoryLimit": least + 3000}, MaximumLength=0.001)
        self.assertGreater(made.GetMemoryEstimate(), least + 3000)

    def test_the_limit_that_is_named_is_enough(self):
        """To come further: there is another refusal, of more memory, or a mesh."""
        many = cloud([(x, y, 0) for x, y in make_points(uniform, 3000)])
        wishes = {"MaximumArea": 1e-5, "MaximumNumberOfAddedPoints": 500}
        whole, _ = meshed(many, **wishes)
        limit, stages = 1, []
        while True:
            made, said = meshed(many, triangulation={"MemoryLimit": limit}, **wishes)
            if not said.errors:
                break
            more = int(re.search(r"or set MemoryLimit to (\d+) or more", said.errors[0])[1])
            self.assertGreater(more, limit, said.errors)
            stages.append(said.errors[0].split()[0])
            limit = more
        self.assertEqual((stages[0], set(stages)), ("Triangulating", {"Triangulating", "Refining"}))
        self.assertEqual((limit, made.GetMemoryEstimate()), (whole.GetMemoryEstimate(),) * 2)
        self.assertEqual(triangles(made.GetOutput(0)), triangles(whole.GetOutput(0)))

    def test_it_is_aborted(self):
        for at in (0.0, 0.3, 0.9):
            made = QualityMesh()
            said, told = Said(made), []
            made.SetInputDataObject(cloud([(x, y, 0) for x, y in make_points(uniform, 3000)]))

            def stop(_caller, _event):
                told.append(made.GetProgress())
                if told[-1] >= at:
                    made.SetAbortExecute(1)

            made.AddObserver("ProgressEvent", stop)
            made.SetMinimumAngle(30)
            made.Update()
            self.assertSaid(said)
            self.assertEqual([made.GetOutput(port).GetNumberOfPoints() for port in (0, 1)], [0, 0])
            self.assertEqual(told, sorted(told))

    def test_progress(self):
        made, told = QualityMesh(), []
        made.SetInputDataObject(cloud([(x, y, 0) for x, y in make_points(uniform, 3000)]))
        made.AddObserver("ProgressEvent", lambda _caller, _event: told.append(made.GetProgress()))
        made.Update()
        self.assertEqual(told, sorted(told))
        self.assertGreater(len(told), 5)
        self.assertLessEqual(told[-1], 1.0)

    def test_an_input_that_an_observer_takes_away(self):
        given = cloud([(x, y, 0) for x, y in make_points(uniform, 3000)])
        made = QualityMesh()
        said = Said(made)
        made.SetInputDataObject(given)

        def take(_caller, _event):
            if made.GetProgress() > 0:  # before, the filter has not begun
                given.GetPoints().SetNumberOfPoints(5)
                given.GetPoints().Squeeze()

        made.AddObserver("ProgressEvent", take)
        made.Update()
        self.assertEqual(len(said.errors), 1)
        self.assertRegex(said.errors[0], "An observer gave an array of the input other memory")
        self.assertEqual(made.GetOutput(0).GetNumberOfPoints(), 0)

    def test_it_runs_when_something_has_changed(self):
        given, constraints = cloud(SQUARE), source(**PLATE)
        made, _ = meshed(given, constraints)
        runs = []
        made.AddObserver("StartEvent", lambda _caller, _event: runs.append(1))
        made.Update()
        self.assertEqual(len(runs), 0)
        transform = vtk("vtkCommonTransforms").vtkTransform()
        for change in (given.Modified, constraints.Modified, lambda: made.SetMaximumArea(0.7),
                       lambda: made.GetTriangulation().SetTolerance(0.001), lambda: made.SetSizeArrayName("None"),
                       lambda: made.GetTriangulation().SetTransform(transform), lambda: transform.Scale(2, 2, 2),
                       lambda: made.SetTriangulation(Filter())):
            change()
            made.Update()
            made.Update()
        self.assertEqual(len(runs), 8)

    def test_pieces_and_settings(self):
        made = QualityMesh()
        made.SetInputDataObject(cloud(SQUARE))
        made.UpdatePiece(0, 2, 0)
        self.assertGreater(made.GetOutput(0).GetNumberOfCells(), 0)
        made.UpdatePiece(1, 2, 0)
        self.assertEqual(made.GetOutput(0).GetNumberOfCells(), 0)
        for name, row in TABLE["quality"]["settings"].items():
            self.assertEqual(getattr(made, "Get" + name)(), row["default"], name)
        for value, kept in ((50, 34), (-3, 0), (math.nan, 0)):
            made.SetMinimumAngle(value)
            self.assertEqual(made.GetMinimumAngle(), kept)
        made.SetMaximumNumberOfAddedPoints(-7)
        self.assertEqual(made.GetMaximumNumberOfAddedPoints(), -1)
        self.assertEqual((made.GetNumberOfInputPorts(), made.GetNumberOfOutputPorts()), (2, 2))
        self.assertEqual((made.GetClassName(), made.IsA("vtkAdaptiveHilbertQualityMeshAlgorithm")),
                         ("vtkAdaptiveHilbertQualityMesh2D", 1))
        self.assertIsNone(made.GetSource())
        made.SetSourceData(source(**PLATE))
        self.assertIsInstance(made.GetSource(), model.vtkPolyData)


if __name__ == "__main__":
    run_tests()
