# SPDX-License-Identifier: BSD-3-Clause
"""The filter as a part of a pipeline: ports, progress, aborts, kept data, ownership."""

import gc
import os
import subprocess
import sys
import threading

from classtests import (TABLE, Case, Filter, Random, Said, array, blocks, cloud, core, model, run, run_tests, source,
                        triangles, values_of, vtk)

execution = vtk("vtkCommonExecutionModel")


def scattered(count, seed=1):
    random = Random(seed)
    return [(random.below(10**6), random.below(10**6), i % 7) for i in range(count)]


class PipelineTest(Case):
    def test_points_are_shared_and_their_data_passed(self):
        given = cloud(scattered(50))
        depth = array("vtkDoubleArray", "depth", range(50))
        given.GetPointData().AddArray(depth)
        surface = run(given)[0].GetOutput()
        self.assertIs(surface.GetPoints(), given.GetPoints())
        self.assertIs(surface.GetPointData().GetArray("depth"), depth)

    def test_inputs_and_outputs_by_all_names(self):
        algorithm, given, lines = Filter(), cloud(scattered(50)), source(lines=[(0, 1)])
        self.assertIsNone(algorithm.GetSource())
        algorithm.SetInputData(given)
        algorithm.SetSourceData(lines)
        self.assertIs(algorithm.GetInput(), given)
        self.assertIs(algorithm.GetInput(0), given)
        self.assertIs(algorithm.GetSource(), lines)
        algorithm.Update()
        for port in range(3):
            self.assertIs(algorithm.GetOutput(port), algorithm.GetOutputDataObject(port))
        self.assertIs(algorithm.GetOutput(), algorithm.GetOutput(0))
        self.assertEqual(algorithm.GetNumberOfConstraintEdges(), 1)
        algorithm.SetSourceData(None)
        self.assertIsNone(algorithm.GetSource())
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfConstraintEdges(), 0)

    def test_connections(self):
        points, lines, algorithm = (execution.vtkTrivialProducer() for _ in range(2)), None, Filter()
        points, lines = points
        points.SetOutput(cloud(scattered(50)))
        lines.SetOutput(source(lines=[(0, 1), (2, 3)]))
        algorithm.SetInputConnection(points.GetOutputPort())
        algorithm.SetSourceConnection(lines.GetOutputPort())
        behind = Filter()
        behind.SetInputConnection(algorithm.GetOutputPort())
        behind.Update()
        self.assertGreater(algorithm.GetNumberOfConstraintEdges(), 0)
        self.assertGreater(behind.GetOutput().GetNumberOfCells(), 50)
        self.assertEqual(behind.GetNumberOfConstraintEdges(), 0)

    def test_it_runs_where_something_changed_only(self):
        given = cloud(scattered(50))
        algorithm, _ = run(given)
        for change, runs in ((lambda: None, 1), (algorithm.Modified, 2), (given.Modified, 3), (lambda: None, 3)):
            change()
            algorithm.SetKeepTriangulation(False) if runs == 1 else None
            algorithm.Update()
            self.assertEqual(algorithm.GetNumberOfTriangulations(), runs + 1 if runs > 1 else 2)

    def test_python_may_let_go_of_it(self):
        algorithm, behind = Filter(), Filter()
        algorithm.SetInputData(cloud(scattered(80)))
        algorithm.SetNmax(9)
        behind.SetInputConnection(algorithm.GetOutputPort())
        del algorithm
        gc.collect()
        behind.Update()
        self.assertGreater(behind.GetOutput().GetNumberOfCells(), 50)
        found = behind.GetInputConnection(0, 0).GetProducer()
        self.assertEqual(found.GetNmax(), 9)
        self.assertGreater(found.GetNumberOfTriangles(), 50)

    def test_outputs_outlive_it(self):
        settings = {"GenerateVoronoi": True, "GenerateNeighbors": True, "BoundingTriangulation": True}
        algorithm, _ = run(cloud(scattered(80)), **settings)
        surface, diagram = algorithm.GetOutput(), algorithm.GetOutput(2)
        expected = triangles(surface), surface.GetPoint(85), diagram.GetPoint(7)
        del algorithm, _
        gc.collect()
        junk = [cloud(scattered(80)) for _ in range(20)]
        self.assertEqual((triangles(surface), surface.GetPoint(85), diagram.GetPoint(7)), expected)
        self.assertEqual(len(junk), 20)

    def test_it_ends(self):
        """Without references, neither it nor its input stays alive."""
        import weakref

        algorithm, _ = run(cloud(scattered(80)), Transform=vtk("vtkCommonTransforms").vtkTransform())
        known = weakref.ref(algorithm)
        points = weakref.ref(algorithm.GetInputDataObject(0, 0))
        del algorithm, _
        gc.collect()
        self.assertEqual((known(), points()), (None, None))

    def test_a_class_may_be_derived(self):
        class Coarse(Filter):
            def GetNmax(self):
                return -5

        algorithm = Coarse()
        algorithm.SetInputData(cloud(scattered(30)))
        algorithm.Update()
        self.assertEqual(algorithm.GetNmax(), -5)
        self.assertGreater(algorithm.GetOutput().GetNumberOfCells(), 20)

    def test_composite_output_of_blocks(self):
        algorithm, _ = run(blocks(cloud(scattered(30)), cloud(scattered(40, 2))))
        self.assertIsInstance(algorithm.GetOutputDataObject(0), model.vtkMultiBlockDataSet)
        self.assertEqual(algorithm.GetOutputDataObject(0).GetBlock(1).GetNumberOfPoints(), 40)

    def test_merged_blocks_and_back(self):
        algorithm, _ = run(blocks(cloud(scattered(30)), cloud(scattered(40, 2))), MergeBlocks=True)
        self.assertIsInstance(algorithm.GetOutputDataObject(0), model.vtkPolyData)
        algorithm.MergeBlocksOff()
        algorithm.Update()
        self.assertIsInstance(algorithm.GetOutputDataObject(0), model.vtkMultiBlockDataSet)

    def test_arrays_of_merged_blocks(self):
        """In the order of their names, with their documentation; those without a name one by one."""
        attributes, table, members = model.vtkDataSetAttributes, core.vtkLookupTable(), []
        for k in range(2):
            block = cloud(scattered(30, k))
            data = block.GetPointData()
            for kind, name, width in (
                    ("vtkDoubleArray", "z", 1), ("vtkFloatArray", "b", 3), ("vtkIntArray", None, 1),
                    ("vtkDoubleArray", "a", 1), ("vtkIntArray", None, 2),
                    ("vtkIntArray" if k else "vtkLongArray", "c", 1)):
                data.AddArray(array(kind, name, [k] * 30 * width, width))
            data.GetArray("b").SetComponentName(1, "north")
            data.GetArray("b").SetLookupTable(table)
            data.SetActiveAttribute("b", attributes.VECTORS)
            data.SetActiveAttribute("az"[k], attributes.SCALARS)
            members.append(block)
        data = run(blocks(*members), MergeBlocks=True)[0].GetOutput().GetPointData()
        self.assertEqual([data.GetArrayName(i) for i in range(data.GetNumberOfArrays())], [None, None, "a", "b", "z"])
        for i in range(5):
            width = data.GetArray(i).GetNumberOfComponents()
            self.assertEqual(values_of(data.GetArray(i)), 30 * width * [0] + 30 * width * [1])
        self.assertEqual([data.GetArray("b").GetComponentName(c) for c in range(3)], [None, "north", None])
        self.assertIs(data.GetArray("b").GetLookupTable(), table)
        self.assertEqual([data.GetAbstractAttribute(kind) and data.GetAbstractAttribute(kind).GetName() for kind in (
            attributes.SCALARS, attributes.VECTORS)], [None, "b"])

    def test_the_diagram_has_the_arrays_with_a_value_for_each_point(self):
        for length in (0, 49, 50, 51):
            given = cloud(scattered(50))
            given.GetPointData().AddArray(array("vtkDoubleArray", "depth", range(length)))
            data = run(given, GenerateVoronoi=True)[0].GetOutput(2).GetCellData()
            sites = values_of(data.GetArray("OriginalPointIds"))
            self.assertEqual(len(sites), 50)
            self.assertEqual(data.HasArray("depth"), length >= 50)
            if length >= 50:
                self.assertEqual(values_of(data.GetArray("depth")), sites)

    def test_ids_of_the_diagram_replace_an_array_of_the_points(self):
        """With its place among the others, and its use."""
        given = cloud(scattered(50))
        for name in ("OriginalPointIds", "depth"):
            given.GetPointData().AddArray(array("vtkFloatArray", name, range(50)))
        given.GetPointData().SetActiveScalars("OriginalPointIds")
        data = run(given, GenerateVoronoi=True)[0].GetOutput(2).GetCellData()
        self.assertEqual([data.GetArrayName(k) for k in range(data.GetNumberOfArrays())], ["depth", "OriginalPointIds"])
        self.assertEqual(data.GetArray("OriginalPointIds").GetClassName(), "vtkIdTypeArray")
        self.assertIsNone(data.GetScalars())

    def test_field_data_of_the_input(self):
        """Are those of each output, whether it is made or not."""
        given = cloud(scattered(30))
        given.GetFieldData().AddArray(array("vtkIntArray", "survey", [7]))
        for settings in ({}, {"GenerateVoronoi": True}, {"GenerateBoxes": True}):
            algorithm, _ = run(given, **settings)
            for port in range(3):
                self.assertTrue(algorithm.GetOutput(port).GetFieldData().HasArray("survey"), (settings, port))

    def test_best_fitting_plane(self):
        points = [(x, y, 2 * x + y) for x, y, _ in scattered(40)]
        plane = Filter.ComputeBestFittingPlane(cloud(points))
        self.assertIsInstance(plane, vtk("vtkCommonTransforms").vtkTransform)
        for point in points:
            self.assertAlmostEqual(plane.TransformPoint(point)[2], 0, delta=1e-6)
        self.assertIsNone(Filter.ComputeBestFittingPlane(None))

    def test_points_of_one_z_x_or_y_are_their_own_plane(self):
        points = [(x + 1e6, y, 7.25) for x, y, _ in scattered(400)]
        plain = Filter()
        plain.SetInputDataObject(cloud(points))
        plain.Update()
        for turn in range(3):
            algorithm = Filter()
            algorithm.SetInputDataObject(cloud([(p + p)[turn:turn + 3] for p in points]))
            algorithm.SetProjectionPlaneMode(2)
            algorithm.Update()
            self.assertEqual(triangles(algorithm.GetOutput()), triangles(plain.GetOutput()), turn)
            self.assertEqual(algorithm.GetNumberOfTrimmedTriangles(), 0)

    def test_errors_are_said_once_and_reach_the_filters_behind(self):
        algorithm, said = run(cloud(scattered(500)))
        behind = Filter()
        behind.SetInputConnection(algorithm.GetOutputPort())
        behind.Update()
        self.assertGreater(behind.GetOutput().GetNumberOfCells(), 0)
        algorithm.SetMemoryLimit(3)
        for _ in range(2):
            behind.Update()
        self.assertSaid(said, errors=1)
        self.assertEqual(behind.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        needed = algorithm.GetMemoryEstimate()
        self.assertGreater(needed, 3)
        algorithm.SetMemoryLimit(needed)
        algorithm.Update()
        self.assertSaid(said, errors=1)
        self.assertGreater(algorithm.GetOutput().GetNumberOfCells(), 0)

    def test_corners_of_a_polygon_are_decimal_numbers(self):
        for word, is_one in (("0", True), ("-.5", True), ("+1.e0", True), ("1_0", False), ("\u0661", False),
                             ("one", False), ("1e", False), ("1e999", False), ("nan", False), ("0 9", False),
                             ("0\u00a09 0", False)):
            with self.subTest(word=word):
                _, said = run(cloud(scattered(20)), GenerateVoronoi=True, VoronoiClip=2,
                              VoronoiPolygon="-9 -9;9 %s,\t3 30" % word)
                self.assertSaid(said, errors=0 if is_one else 1)

    def test_every_number_at_its_ends(self):
        """An execution works with every value that a setter accepts or clamps to."""
        ends = {"int": 2**31 - 1, "id": 2**63 - 1, "int64": 2**63 - 1, "double": 1e299}
        rows = {name: row for name, row in TABLE["delaunay"]["settings"].items() if row["type"] in ends}
        self.assertGreater(len(rows), 8)
        for name, row in rows.items():
            for end in (ends[row["type"]], -ends[row["type"]]):
                with self.subTest(name=name, end=end):
                    algorithm, said = run(cloud(scattered(50)), **{name: end})
                    self.assertEqual(said.errors, [])
                    merges = name == "Tolerance" and end > 0
                    left_out = algorithm.GetNumberOfPointsWithinError()
                    self.assertEqual(left_out > 0, name == "MaximumError" and end > 0)
                    self.assertEqual(algorithm.GetNumberOfPointsInserted() + left_out, 1 if merges else 50)

    def test_estimate_grows_with_what_is_asked_for(self):
        """By the bytes of the outputs at least, and not by much more; bytes per point."""
        count, points = 20000, scattered(20000)

        def estimate(number=core.VTK_DOUBLE, arrays=0, **settings):
            given = cloud(points, number)
            for k in range(arrays):
                made = array("vtkDoubleArray", "a%d" % k, (), 3)
                made.SetNumberOfTuples(count)
                given.GetPointData().AddArray(made)
            return 1024 * run(given, **settings)[0].GetMemoryEstimate() / count

        plain = estimate()
        self.assertTrue(2 * 3 * 4 + 2 * 4 < plain < 250, plain)
        for (least, most), settings in (
                ((24, 25), {"number": core.VTK_INT}), ((-1, 1), {"number": core.VTK_FLOAT}), ((-1, 1), {"arrays": 4}),
                ((7, 16), {"GeneratePointStatus": True}), ((7, 16), {"GenerateInsertionRank": True}),
                ((48, 200), {"GenerateNeighbors": True}), ((16, 160), {"GenerateRegionIds": True}),
                ((2, 140), {"GenerateConstraintEdges": True}), ((200, 780), {"GenerateVoronoi": True}),
                ((40, 125), {"GenerateInsertionCurve": True}), ((40, 140), {"GenerateBoxes": True}),
                ((24, 95), {"BoundingTriangulation": 1}), ((24, 325), {"DuplicatePolicy": 3})):
            more = estimate(**settings) - plain
            self.assertTrue(least <= more <= most, (settings, more))
        for (least, most), name in (((96, 97), "BoundingTriangulation"), ((96, 205), "GenerateVoronoi")):
            more = estimate(arrays=4, **{name: 1}) - estimate(**{name: 1})
            self.assertTrue(least <= more <= most, (name, more))

    def test_messages_nobody_listens_to_go_to_the_output_window(self):
        window = core.vtkStringOutputWindow()
        before = core.vtkOutputWindow.GetInstance()
        core.vtkOutputWindow.SetInstance(window)
        try:
            algorithm = Filter()
            algorithm.SetInputData(cloud([(1, 2, 3)]))
            algorithm.Update()
            self.assertIn("There is no triangle", window.GetOutput())
            self.assertIn("vtkAdaptiveHilbertDelaunay2D (", window.GetOutput())
            said = len(window.GetOutput())
            core.vtkObject.GlobalWarningDisplayOff()
            algorithm.Modified()
            algorithm.Update()
            self.assertEqual(len(window.GetOutput()), said)
        finally:
            core.vtkObject.GlobalWarningDisplayOn()
            core.vtkOutputWindow.SetInstance(before)


class ProgressTest(Case):
    @staticmethod
    def watched(count, abort_at=2.0, **settings):
        algorithm, seen = Filter(), []
        said = Said(algorithm)
        for name, value in settings.items():
            getattr(algorithm, "Set" + name)(value)
        algorithm.SetInputData(cloud(scattered(count)))

        def look(caller, _event):
            seen.append(caller.GetProgress())
            if seen[-1] >= abort_at:
                caller.SetAbortExecute(1)

        tag = algorithm.AddObserver("ProgressEvent", look)
        algorithm.Update()
        return algorithm, said, seen, tag

    def test_it_rises_from_0_to_1(self):
        for settings in ({}, {"GenerateVoronoi": True, "ProjectionPlaneMode": 2, "GenerateRegionIds": True}):
            _, _, seen, _ = self.watched(20000, **settings)
            self.assertGreater(len(seen), 10)
            self.assertLess(len(seen), 150)
            self.assertEqual((seen[0], seen[-1], sorted(seen)), (0.0, 1.0, seen))

    def test_abort_anywhere_and_run_again(self):
        settings = {"GenerateVoronoi": True, "ProjectionPlaneMode": 2, "GenerateInsertionCurve": True}
        expected = triangles(self.watched(20000, **settings)[0].GetOutput())
        for at in (0.005, 0.1, 0.3, 0.6, 0.9):
            algorithm, said, seen, tag = self.watched(20000, at, **settings)
            self.assertLess(seen[-2], 1.0)
            for port in range(3):
                output = algorithm.GetOutput(port)
                self.assertEqual((output.GetNumberOfPoints(), output.GetNumberOfCells()), (0, 0), (at, port))
            self.assertEqual(algorithm.GetNumberOfTriangles(), 0)
            self.assertSaid(said)
            algorithm.RemoveObserver(tag)
            algorithm.SetAbortExecute(0)
            algorithm.Modified()
            algorithm.Update()
            self.assertTrue(triangles(algorithm.GetOutput()) == expected, at)

    def test_two_at_once_in_threads(self):
        expected = [triangles(run(cloud(scattered(20000, seed)))[0].GetOutput()) for seed in (1, 2)]
        found = [None, None]
        made = [run(cloud(scattered(20000, seed)), NumberOfThreads=1)[0] for seed in (1, 2)]

        def work(k):
            made[k].Modified()
            made[k].Update()
            found[k] = triangles(made[k].GetOutput())

        threads = [threading.Thread(target=work, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(found == expected)


class KeptTest(Case):
    """Outputs passed on from the third execution on."""

    def start(self, **settings):
        given = cloud(scattered(60))
        algorithm, said = run(given, **settings)
        given.Modified()
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfTriangulations(), 2)
        return given, algorithm, said

    def again(self, given, algorithm):
        before = algorithm.GetNumberOfTriangulations()
        given.Modified()
        algorithm.Update()
        return algorithm.GetNumberOfTriangulations() - before

    def test_new_point_data_go_with_the_old_triangles(self):
        given, algorithm, _ = self.start(GenerateVoronoi=True, GenerateFate=True)
        cells = algorithm.GetOutput().GetPolys()
        depth = array("vtkDoubleArray", "depth", range(60))
        given.GetPointData().AddArray(depth)
        self.assertEqual(self.again(given, algorithm), 0)
        surface, diagram = algorithm.GetOutput(), algorithm.GetOutput(2)
        self.assertIs(surface.GetPolys(), cells)
        self.assertIs(surface.GetPointData().GetArray("depth"), depth)
        self.assertEqual(surface.GetPointData().GetArrayName(1), "Fate")
        self.assertTrue(diagram.GetCellData().HasArray("depth"))
        self.assertTrue(surface.GetFieldData().HasArray("NumberOfTriangles"))
        self.assertEqual(algorithm.GetNumberOfPointsInserted(), 60)
        self.assertEqual(algorithm.GetInsertSeconds(), 0.0)

    def test_a_point_that_moved_is_noticed(self):
        given, algorithm, _ = self.start()
        given.GetPoints().SetPoint(3, 5, 5, 5)
        given.GetPoints().Modified()
        self.assertEqual(self.again(given, algorithm), 1)

    def test_a_setting_is_noticed(self):
        given, algorithm, _ = self.start()
        algorithm.SetAlpha(3.0)
        self.assertEqual(self.again(given, algorithm), 1)

    def test_a_source_is_noticed(self):
        lines = source(lines=[(0, 1)])
        given, algorithm, _ = self.start(SourceData=lines)
        self.assertEqual(self.again(given, algorithm), 0)
        ids = core.vtkIdList()
        ids.InsertNextId(2)
        ids.InsertNextId(3)
        lines.GetLines().ReplaceCellAtId(0, ids)
        lines.Modified()
        self.assertEqual(self.again(given, algorithm), 1)

    def test_ghost_marks_are_noticed(self):
        given, algorithm, _ = self.start()
        given.GetPointData().AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [1] + 59 * [0]))
        self.assertEqual(self.again(given, algorithm), 1)

    def test_off(self):
        given, algorithm, _ = self.start(KeepTriangulation=False)
        self.assertEqual(self.again(given, algorithm), 1)


class PackageTest(Case):
    def run_python(self, script, *arguments):
        done = subprocess.run([sys.executable, "-c", script, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_it_can_be_looked_at(self):
        """As help() does; with VTK and without."""
        script = (
            "import sys\n"
            "for name in sys.argv[1:]: sys.modules[name] = None\n"
            "import adaptivehilbertdelaunay as package, pydoc\n"
            "pydoc.render_doc(package)\n"
            "print(*dir(package))\n")
        self.assertIn("vtkPlanarPointSource", self.run_python(script).split())
        without = self.run_python(script, "vtkmodules", "cvista").split()
        self.assertNotIn("vtkPlanarPointSource", without)
        self.assertIn("delaunay", without)

    def test_no_vtk_is_loaded_before_one_is_needed(self):
        script = (
            "import adaptivehilbertdelaunay, sys\n"
            "from adaptivehilbertdelaunay import delaunay, drop_in\n"
            "print([name for name in sys.modules if name.split('.')[0] in ('vtkmodules', 'cvista', 'vtk')])\n")
        self.assertEqual(self.run_python(script).strip(), "[]")


class ThreadsTest(Case):
    def test_threads(self):
        given = cloud(scattered(40000))
        expected = triangles(run(given, NumberOfThreads=1)[0].GetOutput())
        for threads in (1, 2, 3):
            algorithm, _ = run(given, NumberOfThreads=threads)
            self.assertEqual(algorithm.GetNumberOfThreadsUsed(), threads)
            self.assertTrue(triangles(algorithm.GetOutput()) == expected, threads)
        self.assertGreaterEqual(run(given)[0].GetNumberOfThreadsUsed(), 1)

    def test_vtk_says_how_many(self):
        before = os.environ.get("VTK_SMP_MAX_THREADS")
        os.environ["VTK_SMP_MAX_THREADS"] = "1"  # read anew by its Sequential backend, once by others
        core.vtkSMPTools.Initialize(1)
        try:
            self.assertEqual(run(cloud(scattered(40000)))[0].GetNumberOfThreadsUsed(), 1)
        finally:
            del os.environ["VTK_SMP_MAX_THREADS"]
            core.vtkSMPTools.Initialize(0)
            if before is not None:
                os.environ["VTK_SMP_MAX_THREADS"] = before

    def test_seconds(self):
        algorithm, _ = run(cloud(scattered(40000)), SourceData=source(lines=[(0, 1)]))
        for name in ("Sort", "Insert", "Output", "Constrain"):
            seconds = getattr(algorithm, "Get%sSeconds" % name)()
            self.assertTrue(0.0 < seconds < 100.0, name)


if __name__ == "__main__":
    run_tests()
