# SPDX-License-Identifier: BSD-3-Clause
"""Messages of the class in Python: of failed runs, of refusals; the end of a failed run, and the information of each
port.
"""

import unittest
import unittest.mock

from classtests import Case, Filter, Said, Source, cloud, core, run_tests, tested_class

import literals  # (classtests has put its folder on the path)

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
Mesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
IN_PYTHON = hasattr(Filter, "_backend")


@unittest.skipUnless(IN_PYTHON, "the compiled class is tested in C++")
class ErrorsTest(Case):
    def test_ranks(self):
        """One reports it, once."""
        for kind, words in (
                (Filter, "There are 3 ranks, and each triangulates its own points only: the surfaces of the ranks do "
                         "not join. DistributePoints has an effect in the compiled class only."),
                (Mesh, "There are 3 ranks, and each refines its own points only: the meshes of the ranks do not join."),
        ):  # fmt: skip
            for rank, warned in ((0, 1), (1, 0)):
                ranks = unittest.mock.Mock()
                ranks.GetNumberOfProcesses.return_value, ranks.GetLocalProcessId.return_value = 3, rank
                with unittest.mock.patch.object(kind._backend, "controller", lambda ranks=ranks: ranks):
                    algorithm = kind()
                    said = Said(algorithm)
                    algorithm.SetInputDataObject(cloud([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))
                    for _ in range(2):
                        algorithm.Modified()
                        algorithm.Update()
                self.assertEqual(said.warnings, warned * [words])


@unittest.skipUnless(IN_PYTHON, "the compiled class is tested in C++")
class LateTest(Case):
    """Memory that runs out when all is made leaves no measure of it, and the next execution runs."""

    def test_delaunay(self):
        from adaptivehilbertdelaunay._vtk import filter as module

        algorithm = Filter()
        said = Said(algorithm)
        algorithm.SetInputData(cloud([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (1, 1, 0)]))
        with unittest.mock.patch.object(module, "without_points", side_effect=MemoryError):
            algorithm.Update()
        self.assertEqual(len(said.errors), 1)
        self.assertIn("Out of memory. The output is empty.", said.errors[0])
        for name in ("NumberOfTriangles", "NumberOfPointsInserted", "NumberOfDuplicates"):
            self.assertEqual(getattr(algorithm, "Get" + name)(), 0, name)
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        algorithm.Modified()
        algorithm.Update()
        self.assertEqual((algorithm.GetNumberOfTriangles(), algorithm.GetNumberOfDuplicates()), (2, 1))
        self.assertEqual(len(said.errors), 1)


@unittest.skipUnless(IN_PYTHON, "VTK's wrappers have words of their own")
class RefusalsTest(Case):
    def rows(self):
        """(what is called, with what, exception, text)"""
        filter_, raster = Filter(), Interpolation()
        package = Filter._backend.package
        points = core.vtkIdList()
        yield filter_.SetTransform, (5,), TypeError, (
            "SetTransform argument 1: a vtkAbstractTransform of %s is required, not int" % package)
        yield filter_.SetSourceData, (points,), TypeError, (
            "SetSourceData argument 1: a vtkPolyData of %s is required, not vtkIdList" % package)
        yield filter_.SetTolerance, ("much",), TypeError, "a float is required, not str"
        yield filter_.SetTolerance, (None,), TypeError, "a float is required, not NoneType"
        yield filter_.SetNmax, (2**31,), OverflowError, "value is out of range for int"
        yield filter_.SetNmax, (-2**31 - 1,), OverflowError, "value is out of range for int"
        yield filter_.SetMemoryLimit, (2**63,), OverflowError, "value is out of range for long long"
        yield filter_.SetMemoryLimit, (-2**63 - 1,), OverflowError, "value is out of range for long long"
        yield lambda: Filter(Nothing=1), (), AttributeError, "vtkAdaptiveHilbertDelaunay2D has no property Nothing"
        yield raster.SetTriangulation, (points,), TypeError, (
            "SetTriangulation argument 1: a vtkAdaptiveHilbertDelaunay2D is required, not vtkIdList")
        yield raster.SetSourceData, (points,), TypeError, (
            "SetSourceData argument 1: a vtkPolyData of %s is required, not vtkIdList" % package)
        yield raster.SetPlacesData, (points,), TypeError, (
            "SetPlacesData argument 1: a vtkDataSet of %s is required, not vtkIdList" % package)
        yield raster.SetCellSize, (1.0, 2.0, 3.0), TypeError, "SetCellSize takes 2 numbers"
        yield raster.SetBounds, ((1.0, 2.0),), TypeError, "SetBounds takes 4 numbers"
        yield raster.SetDimensions, (1, 2.5), TypeError, "'float' object cannot be interpreted as an integer"
        yield raster.SetHeightArrayName, (7,), TypeError, "string is required, not int"

    def test_each_says_why_and_changes_nothing(self):
        for call, given, error, text in self.rows():
            owner = getattr(call, "__self__", None)
            before = owner and (owner.GetMTime(), str(owner).partition("\n")[2])
            with self.assertRaises(error, msg=text) as caught:
                call(*given)
            self.assertEqual(str(caught.exception), text)
            self.assertEqual(owner and (owner.GetMTime(), str(owner).partition("\n")[2]), before, text)

    def test_none_is_left_out(self):
        said = [text for *_, text in self.rows()]
        for name in ("filter.py", "interpolation.py", "settings.py"):
            for line, piece in literals.pieces_of_refusals("_vtk/" + name):
                self.assertTrue([text for text in said if piece in text], (name, line, piece))

    def test_the_ends_of_each_type_are_taken(self):
        filter_ = Filter()
        filter_.SetNmax(2**31 - 1)
        filter_.SetMemoryLimit(2**63 - 1)
        self.assertEqual((filter_.GetNmax(), filter_.GetMemoryLimit()), (2**31 - 1, 2**63 - 1))
        filter_.SetNmax(-2**31)
        filter_.SetMemoryLimit(-2**63)
        self.assertEqual((filter_.GetNmax(), filter_.GetMemoryLimit()), (1, 0))


class PortsTest(Case):
    def test_each_port_has_its_own(self):
        """And without a number it is port 0."""
        filter_, raster = Filter(), Interpolation()
        given = [cloud([(0, 0, 0), (1, 0, 0), (0, 1, 0)]) for _ in range(2)]
        for algorithm in (filter_, raster):
            for port, data in enumerate(given):
                algorithm.SetInputDataObject(port, data)
            self.assertIs(algorithm.GetInput(), given[0])
            for port, data in enumerate(given):
                self.assertIs(algorithm.GetInputDataObject(port, 0), data)
        for port, data in enumerate(given):
            self.assertIs(filter_.GetPolyDataInput(port), data)
            self.assertIs(filter_.GetInput(port), data)
        if IN_PYTHON:
            self.assertIs(filter_.GetPolyDataInput(), given[0])
        filter_.Update()
        self.assertIs(filter_.GetOutput(), filter_.GetOutputDataObject(0))
        for port in range(3):
            self.assertIs(filter_.GetOutput(port), filter_.GetOutputDataObject(port))
        empty = Filter()
        self.assertEqual((empty.GetInput(), empty.GetPolyDataInput(0), empty.GetPolyDataInput(1)), (None,) * 3)


class FailuresTest(Case):
    """A failed run has one message, which the pipeline does not repeat, and empty outputs; the next one is
    unaffected."""

    POINTS = [(0.1 * k, (0.7 * k) % 1.0, 0.0) for k in range(40)]

    def ways(self):
        """(algorithm, what makes it fail, what mends it)"""
        algorithm = Filter()
        algorithm.SetInputDataObject(cloud(self.POINTS))
        yield algorithm, {"MemoryLimit": 1}, {"MemoryLimit": 0}
        for given in ({"CellSize": (0.0, 1.0)}, {"CellSize": (1e-300, 1.0)}, {"CellSize": (1e-9, 1e-9)}):
            algorithm = Interpolation()
            algorithm.SetRasterSizeToByCellSize()
            algorithm.SetInputDataObject(cloud(self.POINTS))
            yield algorithm, given, {"CellSize": (0.5, 0.5)}
        for bounds in ((0.0, 0.0, 0.0, 1.0), (0.0, 1.0, 1.0, 1.0), (1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 1.0, 0.0),
                       (0.0, float("inf"), 0.0, 1.0), (0.0, 1.0, float("nan"), 1.0)):
            algorithm = Interpolation()
            algorithm.UseBoundsOn()
            algorithm.SetInputDataObject(cloud(self.POINTS))
            yield algorithm, {"Bounds": bounds}, {"Bounds": (0.0, 1.0, 0.0, 1.0)}

    @unittest.skipUnless(IN_PYTHON, "the compiled class asks the system")
    def test_memory_for_the_points_of_the_source(self):
        from adaptivehilbertdelaunay._vtk import source

        made = Source()
        said = Said(made)
        for precision, bytes_each in ((0, 16), (1, 28)):
            made.SetOutputPointsPrecision(precision)
            made.SetNumberOfPoints(4096)
            for free, errors in ((4096 * bytes_each - 1024, 1), (4096 * bytes_each, 0)):
                made.Modified()
                with unittest.mock.patch.object(source.engine, "available_memory", lambda: free):
                    self.assertEqual(made.GetExecutive().Update(), 1)
                self.assertSaid(said, errors=errors)
                self.assertEqual(made.GetOutput().GetNumberOfPoints(), 0 if errors else 4096)
                if errors:
                    self.assertEqual(said.errors, [
                        "Making 4096 points takes %s of memory, but there are %s. No point was made. Make fewer." % (
                            ("65.6 KB", "64.5 KB") if bytes_each == 16 else ("115 KB", "113 KB"))])
                del said.errors[:]

    def test_each_is_told_once_and_forgotten(self):
        for algorithm, bad, good in self.ways():
            fresh = algorithm.NewInstance()
            for name in ("RasterSize", "UseBounds"):
                if hasattr(algorithm, "Get" + name):
                    getattr(fresh, "Set" + name)(getattr(algorithm, "Get" + name)())
            if algorithm.GetNumberOfInputPorts():
                fresh.SetInputDataObject(algorithm.GetInputDataObject(0, 0))
            self.give(fresh, good)
            fresh.Update()
            said = Said(algorithm)
            for _ in range(2):
                self.give(algorithm, bad)
                del said.errors[:], said.warnings[:]
                self.assertEqual(algorithm.GetExecutive().Update(), 1, bad)
                self.assertSaid(said, errors=1)
                self.assertEqual(algorithm.GetOutputDataObject(0).GetNumberOfPoints(), 0, bad)
                del said.errors[:]
                self.give(algorithm, good)
                self.assertEqual(algorithm.GetExecutive().Update(), 1, bad)
                self.assertSaid(said)
                number = algorithm.GetOutputDataObject(0).GetNumberOfPoints()
                self.assertEqual(number, fresh.GetOutputDataObject(0).GetNumberOfPoints(), bad)
                self.assertGreater(number, 3)

    @staticmethod
    def give(algorithm, settings):
        for name, value in settings.items():
            getattr(algorithm, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))


if __name__ == "__main__":
    run_tests()
