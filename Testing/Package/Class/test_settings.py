# SPDX-License-Identifier: BSD-3-Clause
"""Every method of the compiled class is there, with its defaults, its ranges and its exceptions, as in Settings.json.
AHD_WRITE_HASHES=1 with the compiled class writes the file anew."""

import json
import math
import unittest

from classtests import (BACKEND, FOLDER, IN_PYTHON, WRITES, Case, Filter, Said, Source, cloud, core, run_tests,
                        tested_class, vtk, write_rows)

FILE = FOLDER / "Settings.json"
VALUES = (-7, 0, 1, 2, 3, 17, 1000000, 2**40, 0.3, 1e300, math.nan, True, "a word", None)
OBJECTS = ("SetSourceData", "SetSourceConnection", "SetTransform", "SetController")


def own_names(kind):
    """Methods of a class beyond those of vtkPolyDataAlgorithm and of VTK's algorithms in Python."""
    base = dir(vtk("vtkCommonExecutionModel").vtkPolyDataAlgorithm) + [
        "GetInputData", "GetOutputData", "GetPythonObject", "SetPythonObject", "SetNumberOfInputPorts",
        "SetNumberOfOutputPorts"]
    return [name for name in dir(kind) if not name.startswith("_") and name not in base]


def outcome(algorithm, name, value):
    """The value after setting this, and whether the filter must run again; or the exception."""
    before = algorithm.GetMTime()
    try:
        getattr(algorithm, "Set" + name)(value)
    except (TypeError, OverflowError, ValueError) as error:
        return type(error).__name__
    return [getattr(algorithm, "Get" + name)(), algorithm.GetMTime() > before]


def described(kind):
    settings, constants, answers = {}, {}, {}
    for name in own_names(kind):
        member = getattr(kind, name)
        if name.startswith("Set") and hasattr(kind, "G" + name[1:]) and name not in OBJECTS:
            algorithm = kind()
            key = name[3:]
            settings[key] = [getattr(algorithm, "Get" + key)()] + [outcome(algorithm, key, v) for v in VALUES]
        elif isinstance(member, int):
            constants[name] = int(member)
        elif name.startswith("Get") or "To" in name or name.endswith(("On", "Off")):
            algorithm = kind()
            answer = getattr(algorithm, name)()
            setting = name[3:].split("To")[0] if name.startswith("Set") else name[:-2].removesuffix("O")
            if not name.startswith("Get"):
                answer = getattr(algorithm, "Get" + setting)()
            answers[name] = answer
    methods = [name for name in own_names(kind) if callable(getattr(kind, name))
               and not isinstance(getattr(kind, name), type)]
    return {"settings": settings, "constants": constants, "answers": answers, "methods": sorted(methods)}


class SettingsTest(Case):
    @classmethod
    def setUpClass(cls):
        found = dict(described(Filter), **{"source " + key: value for key, value in described(Source).items()})
        cls.found = json.loads(json.dumps(found).replace("NaN", '"NaN"'))
        if WRITES:
            write_rows(FILE, cls.found)
        cls.expected = json.loads(FILE.read_text(encoding="utf-8"))

    def test_the_methods_are_there(self):
        self.assertEqual([name for name in self.expected["methods"] if name not in self.found["methods"]], [])

    def test_defaults_ranges_and_exceptions(self):
        self.assertGreater(len(self.expected["settings"]), 35)
        for name, row in self.expected["settings"].items():
            self.assertEqual(self.found["settings"].get(name), row, name)

    def test_constants(self):
        self.assertEqual(self.found["constants"], self.expected["constants"])

    def test_methods_without_arguments(self):
        self.assertEqual(self.found["answers"], self.expected["answers"])

    def test_the_source_of_points(self):
        self.assertEqual(len(self.expected["source settings"]), 6)
        for key in ("settings", "constants", "answers"):
            self.assertEqual(self.found["source " + key], self.expected["source " + key])
        self.assertEqual(
            [name for name in self.expected["source methods"] if name not in self.found["source methods"]], [])
        self.assertEqual((Source().GetClassName(), Source().IsA("vtkPolyDataAlgorithm")), ("vtkPlanarPointSource", 1))

    def test_each_says_what_it_does(self):
        for name in self.expected["methods"]:
            self.assertTrue(getattr(Filter, name).__doc__, name)

    def test_the_name_of_the_class(self):
        algorithm = Filter()
        self.assertEqual(algorithm.GetClassName(), "vtkAdaptiveHilbertDelaunay2D")
        for name in ("vtkAdaptiveHilbertDelaunay2D", "vtkAdaptiveHilbertAlgorithm", "vtkPolyDataAlgorithm",
                     "vtkAlgorithm", "vtkObject"):
            self.assertEqual((algorithm.IsA(name), Filter.IsTypeOf(name)), (1, 1), name)
        self.assertEqual(algorithm.IsA("vtkDelaunay2D"), 0)
        self.assertIs(Filter.SafeDownCast(algorithm), algorithm)
        self.assertIsNone(Filter.SafeDownCast(cloud([])))
        self.assertIsInstance(algorithm.NewInstance(), Filter)

    def test_settings_are_printed(self):
        algorithm = Filter()
        algorithm.SetNmax(77)
        algorithm.SetTolerance(0.25)
        text = str(algorithm)
        for name, row in self.expected["settings"].items():
            if name != "GenerateFate":
                self.assertIn("\n  %s: " % name, text)
        self.assertIn("\n  Nmax: 77\n", text)
        self.assertIn("\n  Tolerance: 0.25\n", text)
        self.assertIn("\n  GenerateBoxes: Off\n", text)
        self.assertIn("\n  NumberOfTriangles: 0\n", text)

    @unittest.skipUnless(IN_PYTHON, "VTK's wrappers have texts of their own")
    def test_what_is_refused_is_said(self):
        algorithm, other = Filter(), tested_class("vtkAdaptiveHilbertInterpolation2D")()
        for kind, text, call, *given in (
                (TypeError, "a float is required, not str", algorithm.SetAlpha, "1"),
                (TypeError, "a float is required, not list", algorithm.SetTolerance, [1.0]),
                (TypeError, "'float' object cannot be interpreted as an integer", algorithm.SetNmax, 1.5),
                (OverflowError, "value is out of range for int", algorithm.SetNmax, 2**31),
                (OverflowError, "value is out of range for int", algorithm.SetNmax, -2**31 - 1),
                (OverflowError, "value is out of range for long long", algorithm.SetMemoryLimit, 2**63),
                (TypeError, "SetTransform argument 1: a vtkAbstractTransform of %s is required, not int" % BACKEND,
                 algorithm.SetTransform, 3),
                (TypeError, "SetSourceData argument 1: a vtkPolyData of %s is required, not int" % BACKEND,
                 algorithm.SetSourceData, 3),
                (TypeError, "SetDimensions takes 2 numbers", other.SetDimensions, 1, 2, 3),
                (TypeError, "SetBounds takes 4 numbers", other.SetBounds, (1, 2, 3)),
                (OverflowError, "value is out of range for int", other.SetDimensions, 1, 2**31),
                (TypeError, "a float is required, not str", other.SetCellSize, 1.0, "2"),
                (TypeError, "a float is required, not NoneType", other.SetNoValue, None),
                (TypeError, "string is required, not int", other.SetHeightArrayName, 3),
                (TypeError, "SetTriangulation argument 1: a vtkAdaptiveHilbertDelaunay2D is required, not int",
                 other.SetTriangulation, 3)):
            with self.assertRaises(kind) as caught:
                call(*given)
            self.assertEqual(str(caught.exception), text)
        self.assertEqual((algorithm.GetNmax(), algorithm.GetAlpha(), other.GetDimensions()), (50, 0.0, (256, 256)))

    def test_transform(self):
        algorithm, transform = Filter(), vtk("vtkCommonTransforms").vtkTransform()
        self.assertIsNone(algorithm.GetTransform())
        algorithm.SetTransform(transform)
        self.assertIs(algorithm.GetTransform(), transform)
        before = algorithm.GetMTime()
        transform.RotateX(90)
        self.assertGreater(algorithm.GetMTime(), before)
        with self.assertRaises(TypeError):
            algorithm.SetTransform(core.vtkPoints())
        algorithm.SetTransform(None)
        self.assertIsNone(algorithm.GetTransform())

    def test_ports(self):
        algorithm = Filter()
        self.assertEqual((algorithm.GetNumberOfInputPorts(), algorithm.GetNumberOfOutputPorts()), (2, 3))
        self.assertEqual(algorithm.GetTotalNumberOfInputConnections(), 0)
        required = vtk("vtkCommonExecutionModel").vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
        names = {}
        for port, merge in ((0, False), (0, True), (1, False)):
            algorithm.SetMergeBlocks(merge)
            info = algorithm.GetInputPortInformation(port)
            names[port, merge] = [required.Get(info, i) for i in range(required.Length(info))]
        self.assertEqual(names, {
            (0, False): ["vtkPointSet", "vtkTable"], (0, True): ["vtkCompositeDataSet", "vtkPointSet", "vtkTable"],
            (1, False): ["vtkPolyData", "vtkCompositeDataSet"]})

    def test_another_input_is_refused_by_the_pipeline(self):
        algorithm = Filter()
        said = Said(algorithm)
        algorithm.SetInputDataObject(vtk("vtkCommonDataModel").vtkImageData())
        algorithm.Update()
        self.assertEqual(len(said.pipeline), 1)
        self.assertIn("vtkPointSet", said.pipeline[0])


if __name__ == "__main__":
    run_tests()
