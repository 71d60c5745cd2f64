# SPDX-License-Identifier: BSD-3-Clause
"""Bad files of kinds that VTK reads: each is refused with one line, whatever VTK's reader does.

Read in a process of its own, good ones come back as they are.
"""

import os
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Plugin", "Demo"))

import badfiles
import conversion
import pointfiles
from pointfiles import InputError
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, content):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(content)
        return path

    def refusal(self, call, *arguments):
        with self.assertRaises(InputError) as caught:
            call(*arguments)
        said = str(caught.exception)
        self.assertEqual(said.count("\n"), 0, said)
        self.assertTrue(said.isprintable(), repr(said))
        return said


class BadFiles(InFolder):
    def test_of_vtk(self):
        for name, (content, words) in badfiles.FOR_VTK.items():
            with self.subTest(name=name):
                path = self.write(name, content)
                said = self.refusal(conversion.convert, path, os.path.join(self.folder, "made.vtp"))
                self.assertIn(words, said)
                self.assertIn(path, said)

    def test_tables_and_lidar(self):
        for name, (content, words) in badfiles.FOR_THE_DEMO.items():
            with self.subTest(name=name):
                self.assertIn(words, self.refusal(pointfiles.read_points, self.write(name, content)))

    def test_a_reader_that_dies_is_named_with_its_last_words(self):
        said = "noise\n\x1b[31m( 1 s) [ ] x.txx:436    ERR| vtkFloatArray (0x55): No room.\x1b[0m \nStack trace:\n1 2"
        self.assertEqual(conversion.reason(said), ", saying: No room.")
        self.assertEqual(conversion.reason("end of file\nx: y: Assertion `0' failed.\n"), ", saying: end of file")
        self.assertEqual(conversion.reason(""), "")
        self.assertEqual(conversion.ending(-11), "was stopped by SIGSEGV")
        self.assertEqual(conversion.ending(-24), "came to no end")

    def test_compressed_lidar_without_what_unpacks_it(self):
        path = os.path.join(HERE, "Inputs", "hill.laz")
        self.assertTrue(pointfiles.is_compressed(path))
        environment = dict(os.environ)
        os.environ["PYTHONPATH"] = "/nowhere"
        try:
            said = self.refusal(conversion.convert, path, os.path.join(self.folder, "made.las"))
        finally:
            os.environ.update(environment)
        self.assertIn("laspy and lazrs", said)


class GoodFiles(InFolder):
    def test_points_and_data_come_back(self):
        points = vtkPoints()
        points.SetDataType(VTK_FLOAT)
        values, words, field = vtkDoubleArray(), vtkStringArray(), vtkDoubleArray()
        for array, name in ((values, "a name"), (words, "words"), (field, "time")):
            array.SetName(name)
        for k in range(5):
            points.InsertNextPoint(k, k * k, 0.1 * k)
            values.InsertNextValue(k / 7)
            words.InsertNextValue("w%d" % k)
        field.InsertNextValue(1 / 3)
        data = vtkPolyData()
        data.SetPoints(points)
        data.GetPointData().AddArray(values)
        data.GetPointData().AddArray(words)
        data.GetFieldData().AddArray(field)
        writer = vtkPolyDataWriter()
        writer.SetFileName(os.path.join(self.folder, "good.vtk"))
        writer.SetInputData(data)
        writer.SetFileTypeToBinary()
        writer.Write()
        made = os.path.join(self.folder, "made.vtp")
        self.assertEqual(conversion.convert(writer.GetFileName(), made), "vtkPolyData")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(made)
        reader.Update()
        found = reader.GetOutput()
        self.assertEqual(found.GetPoints().GetDataType(), VTK_FLOAT)
        for k in range(5):
            self.assertEqual(found.GetPoint(k), data.GetPoint(k))
            self.assertEqual(found.GetPointData().GetArray("a name").GetValue(k), k / 7)
            self.assertEqual(found.GetPointData().GetAbstractArray("words").GetValue(k), "w%d" % k)
        self.assertEqual(found.GetFieldData().GetArray("time").GetValue(0), 1 / 3)


if __name__ == "__main__":
    unittest.main()
