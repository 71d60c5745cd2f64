# SPDX-License-Identifier: BSD-3-Clause
"""VTK's files as input of tiles: the points and fields of any .npy. Left out without VTK."""

import sys
import unittest

import numpy as np
from tilesupport import TilesTest, pieces_of, read_piece, tiles

from adaptivehilbertdelaunay.tiles import _read

try:
    from vtkmodules import vtkIOXML
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
except ImportError:
    sys.exit(77)

KINDS = {".vtp": (vtkPolyData, vtkIOXML.vtkXMLPolyDataWriter),
         ".vtu": (vtkUnstructuredGrid, vtkIOXML.vtkXMLUnstructuredGridWriter)}  # fmt: skip
COUNT = 900


class VtkTest(TilesTest):
    def setUp(self):
        super().setUp()
        random = np.random.default_rng(4)
        self.points = random.uniform(-9, 9, (COUNT, 3))
        self.fields = {"intensity": random.integers(0, 60000, COUNT).astype("u2"),
                       "classification": random.integers(0, 20, COUNT).astype("u1")}  # fmt: skip

    def written(self, ending, points, fields):
        kind, writer = KINDS[ending][0](), KINDS[ending][1]()
        places = vtkPoints()
        places.SetData(numpy_to_vtk(points, deep=True))
        kind.SetPoints(places)
        for name, values in fields.items():
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            kind.GetPointData().AddArray(array)
        writer.SetInputData(kind)
        writer.SetFileName(self.at("points" + ending))
        self.assertEqual(writer.Write(), 1)
        return self.at("points" + ending)

    def test_points_are_those_of_an_array(self):
        for ending in KINDS:
            for kind in ("f8", "f4"):
                with self.subTest(ending=ending, kind=kind):
                    points = self.points.astype(kind)
                    made = tiles.make([self.written(ending, points, {})], tin=self.at("tin.pvtp"), leaf=100,
                                      overwrite=True)  # fmt: skip
                    self.assertEqual(made.plan.points, COUNT)
                    self.assert_is_one_piece(points.astype(float), self.at("tin.pvtp"))

    def test_fields_come_along(self):
        for ending in KINDS:
            with self.subTest(ending=ending):
                path = self.written(ending, self.points, self.fields)
                tiles.make([path], tin=self.at("tin.pvtp"), leaf=100, piece=200, overwrite=True)
                for piece in pieces_of(self.at("tin.pvtp")):
                    places, data, _ = read_piece(piece)
                    ids = data["GlobalPointIds"]
                    np.testing.assert_array_equal(places, self.points[ids])
                    for name, values in self.fields.items():
                        np.testing.assert_array_equal(data[name], values[ids], name)

    def test_from_any_point_on(self):
        """A run that goes on reads the rest, in pieces."""
        for ending in KINDS:
            path = self.written(ending, self.points, self.fields)
            self.assertEqual(_read.reader_of(path).head(path).points, COUNT)
            chunks = list(_read.reader_of(path).chunks(path, 250, 200, 1))
            self.assertEqual([len(chunk.xyz) for chunk in chunks], [200, 200, 200, 50])
            np.testing.assert_array_equal(np.concatenate([chunk.xyz for chunk in chunks]), self.points[250:])
            for name, values in self.fields.items():
                found = np.concatenate([getattr(chunk, name) for chunk in chunks])
                np.testing.assert_array_equal(found, values[250:], name)

    def test_what_vtk_cannot_read(self):
        for ending in KINDS:
            path = self.at("damaged" + ending)
            for text in ("", "no XML", '<VTKFile type="ImageData" version="0.1"></VTKFile>'):
                with self.subTest(ending=ending, text=text), open(path, "w") as file:
                    file.write(text)
                code, said = self.command(path, "--tin", self.at("tin.pvtp"))
                self.assertEqual(code, 3, said)
                self.assertIn("damaged" + ending, said)
                self.assertIn("VTK cannot read points from it", said)
                self.assertNotIn("Traceback", said)


if __name__ == "__main__":
    unittest.main()
