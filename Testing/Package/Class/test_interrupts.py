# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C during VTK's requests for data, and memory that runs out then, in the class in Python."""

import contextlib
import ctypes
import importlib
import os
import signal
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

from classtests import (BACKEND, IN_PYTHON, Case, Filter, Said, Source, blocks, cloud, model, run_tests, tested_class,
                        vtk)
from test_kept import contents, scattered, silent
from test_pipeline import behind

Interpolation = tested_class("vtkAdaptiveHilbertInterpolation2D")
QualityMesh = tested_class("vtkAdaptiveHilbertQualityMesh2D")
Outline = tested_class("vtkPlanarSurfaceOutline")
# By class, the last steps of an execution: module, class in it, method.
STEPS = {
    Source: (("source", "_Making", "_make"),),
    Filter: (("outputs", "Surface", "write_points"), ("outputs", "Surface", "write_cells"),
             ("filter", "_Executions", "_execute")),
    Interpolation: (("interpolating", "Interpolating", "_add_mask"), ("interpolation", "_Executions", "_execute")),
    QualityMesh: (("quality", "_Meshing", "_write_points"), ("quality", "_Meshing", "_write_triangles"),
                  ("quality", "_Meshing", "run"), ("quality", "_Executions", "_execute")),
    Outline: (("outline", "_Writer", "_write_points"), ("outline", "_Writer", "write")),
}


def part(name):
    """A module of the class in Python."""
    return importlib.import_module(Source.__mro__[1].__module__.rpartition(".")[0] + "." + name)


@unittest.skipUnless(IN_PYTHON, "the compiled class does not hear it")
class InterruptsTest(Case):
    """Ctrl-C is raised by the call that requested data; there is no output, and the next update runs."""

    def setUp(self):
        self.before = signal.signal(signal.SIGINT, signal.default_int_handler)

    def tearDown(self):
        signal.signal(signal.SIGINT, self.before)

    def interrupted(self, algorithm, at=0.3):
        """Sends the signal while this filter works. Returns what ends that."""
        sent = []

        def send(_caller, _event):
            if algorithm.GetProgress() > at and not sent:
                sent.append(1)
                signal.raise_signal(signal.SIGINT)

        tag = algorithm.AddObserver("ProgressEvent", send)
        return lambda: algorithm.RemoveObserver(tag)

    def make(self, kind):
        algorithm = kind()
        algorithm.SetInputDataObject(0, cloud(scattered(20000)))
        if kind is Interpolation:
            algorithm.SetDimensions(9, 9)
        return algorithm

    def test_its_own_update(self):
        for kind in (Filter, Interpolation):
            algorithm = self.make(kind)
            said = Said(algorithm)
            ends = self.interrupted(algorithm)
            for _ in range(2):
                with self.assertRaises(KeyboardInterrupt):
                    algorithm.Update()
                self.assertEqual(algorithm.GetOutputDataObject(0).GetNumberOfPoints(), 0)
                ends()
                algorithm.Update()
                expected = self.make(kind)
                expected.Update()
                self.assertTrue(contents(algorithm.GetOutput()) == contents(expected.GetOutput()), kind)
                ends = self.interrupted(algorithm, 0.05)
                algorithm.Modified()
                self.assertEqual((said.errors, said.warnings), ([], []))
            ends()

    def test_a_filter_behind(self):
        for kind in (Filter, Interpolation):
            algorithm = self.make(kind)
            runs, after = [], behind(algorithm)
            after.AddObserver("StartEvent", lambda _caller, _event: runs.append(1))
            ends = self.interrupted(algorithm)
            with self.assertRaises(KeyboardInterrupt):
                after.Update()
            self.assertEqual(runs, [])
            ends()
            after.Update()
            self.assertGreater(after.GetOutputDataObject(0).GetNumberOfPoints(), 80)

    def test_it_arrives_at_once(self):
        """And where the caller can catch it."""
        def asks(after):
            try:
                after.Update()
                return "went on"
            except KeyboardInterrupt:
                return "caught"

        algorithm = self.make(Filter)
        self.interrupted(algorithm)
        self.assertEqual(asks(behind(algorithm)), "caught")

    def test_filters_behind_do_not_ask_again(self):
        """One in Python, which updates its input when information is requested."""
        first, second = self.make(Filter), silent(Interpolation())
        second.SetInputConnection(first.GetOutputPort())
        ends = self.interrupted(first)
        with self.assertRaises(KeyboardInterrupt):
            behind(second).Update()
        self.assertEqual((first.GetNumberOfTriangulations(), second.GetNumberOfTriangulations()), (1, 0))
        ends()
        second.Update()
        self.assertGreater(second.GetNumberOfValidPlaces(), 0)

    def test_a_file_is_left_alone(self):
        writers = vtk("vtkIOXML") if BACKEND == "vtkmodules" else None
        if writers is None:
            self.skipTest("no writer")
        algorithm, writer = self.make(Filter), writers.vtkXMLPolyDataWriter()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "surface.vtp")
            writer.SetInputConnection(algorithm.GetOutputPort())
            writer.SetFileName(path)
            self.interrupted(algorithm)
            with self.assertRaises(KeyboardInterrupt):
                writer.Write()
            self.assertFalse(os.path.exists(path))
            self.assertEqual(writer.Write(), 1)
            self.assertTrue(os.path.exists(path))

    def test_a_file_of_blocks_is_left_alone(self):
        """In any block; VTK calls the filter for each."""
        writers = vtk("vtkIOXML") if BACKEND == "vtkmodules" else None
        if writers is None:
            self.skipTest("no writer")
        algorithm, writer = silent(Filter()), writers.vtkXMLMultiBlockDataWriter()
        algorithm.SetInputDataObject(blocks(cloud(scattered(20000)), cloud(scattered(20000, 2))))
        writer.SetInputConnection(algorithm.GetOutputPort())
        writer.GetExecutive().AddObserver("ErrorEvent", lambda _caller, _event: None)  # that it has no input
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "surfaces.vtm")
            writer.SetFileName(path)
            for at in (0.3, 0.6):
                ends = self.interrupted(algorithm, at)
                with self.assertRaises(KeyboardInterrupt):
                    writer.Write()
                ends()
                self.assertEqual(os.listdir(folder), [], at)
                self.assertEqual(algorithm.GetOutputDataObject(0).GetNumberOfCells(), 0)
            self.assertEqual(writer.Write(), 1)
            self.assertEqual(len(os.listdir(folder)), 2)
            self.assertGreater(algorithm.GetOutputDataObject(0).GetNumberOfCells(), 60000)

    def test_a_block(self):
        algorithm = silent(Filter())
        algorithm.SetInputDataObject(blocks(cloud(scattered(20000)), cloud(scattered(20000, 2))))
        ends = self.interrupted(algorithm)
        with self.assertRaises(KeyboardInterrupt):
            algorithm.Update()
        ends()
        algorithm.Update()
        for k in range(2):
            self.assertGreater(algorithm.GetOutputDataObject(0).GetBlock(k).GetNumberOfCells(), 30000)

    def test_elsewhere_than_in_the_engine(self):
        """Raised by Python between its steps: of the source, and while outputs are written."""
        points = Source()
        points.SetNumberOfPoints(500)
        triangulation = Filter()
        triangulation.SetInputConnection(points.GetOutputPort())
        for kind, method in ((part("planar").PlanarPoints, "next"), (part("outputs").Surface, "write_cells")):
            with unittest.mock.patch.object(kind, method, side_effect=KeyboardInterrupt):
                with self.assertRaises(KeyboardInterrupt):
                    behind(triangulation).Update()
        triangulation.Update()
        self.assertGreater(triangulation.GetOutput().GetNumberOfCells(), 900)

    def test_after_each_of_the_last_steps(self):
        """When outputs have been written, in part or all. The same where memory runs out, which is said."""
        surface = self.make(Filter)
        surface.Update()
        for kind, steps in STEPS.items():
            for module, owner, method in steps:
                for error in (KeyboardInterrupt,) + (MemoryError,) * (method != "_execute"):  # which catches that
                    algorithm = kind() if kind is Source else self.make(kind)
                    if kind is Outline:
                        algorithm.SetInputDataObject(surface.GetOutput())
                    with self.subTest(kind=kind, method=method, error=error):
                        self.assertIsEmptyAfter(algorithm, getattr(part(module), owner), method, error)

    def assertIsEmptyAfter(self, algorithm, owner, method, error):
        known, said = getattr(owner, method), Said(algorithm)

        def step(*given):
            known(*given)
            raise error

        with unittest.mock.patch.object(owner, method, step):
            with self.assertRaises(error) if error is KeyboardInterrupt else contextlib.nullcontext():
                algorithm.Update()
        self.assertEqual(["emory" in text for text in said.errors], [] if error is KeyboardInterrupt else [True])
        outputs = [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]
        for output in outputs:
            data = output.GetPointData(), output.GetCellData(), output.GetFieldData()
            self.assertEqual((output.GetNumberOfPoints(), [part.GetNumberOfArrays() for part in data]), (0, [0, 0, 0]))
        if error is MemoryError:
            algorithm.Modified()  # else VTK takes the empty outputs for good
        algorithm.Update()
        self.assertGreater(outputs[0].GetNumberOfPoints(), 0)

    def test_a_filter_in_python_that_asks_others(self):
        """It is interrupted first, and its request fails; then its caller's does."""
        base, heard, algorithm, test = vtk("util.vtkAlgorithm").VTKPythonAlgorithmBase, [], self.make(Filter), self

        class Asks(base):
            def __init__(self):
                base.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

            def RequestData(self, _request, _inputs, outputs):
                try:
                    algorithm.Update()
                except KeyboardInterrupt:
                    heard.append(1)
                    raise
                model.vtkPolyData.GetData(outputs, 0).ShallowCopy(algorithm.GetOutput())
                return 1

        def ProcessRequest():  # not VTK's
            with test.assertRaises(KeyboardInterrupt):
                algorithm.Update()
            return "caught"

        asks, runs = silent(Asks()), []
        after = behind(asks)
        after.AddObserver("StartEvent", lambda _caller, _event: runs.append(1))
        ends = self.interrupted(algorithm)
        with self.assertRaises(KeyboardInterrupt):
            after.Update()
        self.assertEqual((heard, runs), ([1], []))
        ends()
        asks.Modified()
        after.Update()
        self.assertGreater(after.GetOutputDataObject(0).GetNumberOfCells(), 30000)
        algorithm.Modified()
        self.interrupted(algorithm)
        self.assertEqual(ProcessRequest(), "caught")

    def heard_behind(self, hears):
        """Ctrl-C downstream of a filter in Python, which calls this when interrupted, and raises it again. Returns
        whether the test is interrupted, too."""
        base, algorithm = vtk("util.vtkAlgorithm").VTKPythonAlgorithmBase, self.make(Filter)

        class Asks(base):
            def __init__(self):
                base.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

            def RequestData(self, _request, _inputs, _outputs):
                try:
                    algorithm.Update()
                except KeyboardInterrupt:
                    hears()
                    raise
                return 1

        ends = self.interrupted(algorithm)
        try:
            behind(silent(Asks())).Update()
            return False
        except KeyboardInterrupt:
            return True
        finally:
            ends()
            algorithm.Update()
            self.assertGreater(algorithm.GetOutput().GetNumberOfCells(), 30000)

    def test_a_filter_in_python_that_does_much_when_it_hears_it(self):
        def step():
            pass

        def hears():
            for _ in range(100):
                step()

        self.assertTrue(self.heard_behind(hears))

    def test_an_exception_is_set_where_python_goes_on(self):
        """As while VTK reports a failure: that exception is printed, and Ctrl-C is not lost."""
        printed, known = [], sys.excepthook

        def hears():  # after the pending one: this sets a TypeError that is not raised
            sets = ctypes.cast(ctypes.pythonapi.PyErr_BadArgument, ctypes.c_void_p)
            self.assertEqual(ctypes.pythonapi.Py_AddPendingCall(sets, None), 0)

        sys.excepthook = lambda kind, *_more: printed.append(kind)
        try:
            self.assertTrue(self.heard_behind(hears))
        finally:
            sys.excepthook = known
        self.assertEqual(printed, [TypeError])

    def test_who_asked_has_ended(self):
        """Without it: the next call raises it, once."""
        interrupts = part("interrupts")
        lost = interrupts._Arrival.__new__(interrupts._Arrival)  # which Python does not call
        lost.raised, lost.asker, lost.failed = KeyboardInterrupt(), (lambda: sys._getframe())(), []
        interrupts._under_way.append(lost)
        algorithm = self.make(Filter)
        with self.assertRaises(KeyboardInterrupt):
            algorithm.Update()
        self.assertEqual(interrupts._under_way, [])
        algorithm.Update()
        self.assertGreater(algorithm.GetOutput().GetNumberOfCells(), 30000)

    def test_another_exception_of_the_handler(self):
        class Enough(BaseException):
            pass

        def handler(_number, _frame):
            raise Enough(7)

        signal.signal(signal.SIGINT, handler)
        algorithm = self.make(Filter)
        self.interrupted(algorithm)
        with self.assertRaises(Enough) as caught:
            behind(algorithm).Update()
        self.assertEqual(caught.exception.args, (7,))

    def test_nothing_is_printed(self):
        """VTK's pipeline need not repeat the exception."""
        script = (
            "import signal\n"
            "from test_interrupts import Filter, InterruptsTest, behind\n"
            "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
            "test = InterruptsTest('test_nothing_is_printed')\n"
            "algorithm = test.make(Filter)\n"
            "test.interrupted(algorithm)\n"
            "try:\n"
            "    behind(algorithm).Update()\n"
            "except KeyboardInterrupt:\n"
            "    print('heard')\n")
        done = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False, cwd=os.path.dirname(os.path.abspath(__file__)))
        self.assertEqual(done.stdout.strip(), "heard")


if __name__ == "__main__":
    run_tests()
