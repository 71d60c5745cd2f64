# SPDX-License-Identifier: BSD-3-Clause
"""The file of Save Data in ParaView as GeoTIFF, read by its tags. Beside the compiled writer's, and by GDAL:
Testing/Plugin/TestGeoTIFF.py."""

import os
import struct
import tempfile
import unittest
import unittest.mock

import numpy as np
from adaptivehilbertdelaunay import _geotiff

LETTERS = {2: ("s", 1), 3: ("H", 2), 4: ("I", 4), 12: ("d", 8)}


def read(path):
    """(numbers by tag, pixels): what TIFF 6.0 says of a file of one image, row by row."""
    with open(path, "rb") as file:
        content = file.read()
    mark, version, at, count = struct.unpack_from("<2sHIH", content)
    assert (mark, version) == (b"II", 42)
    found = {}
    for k in range(count):
        tag, kind, many = struct.unpack_from("<HHI", content, at + 2 + 12 * k)
        letter, size = LETTERS[kind]
        place = at + 10 + 12 * k
        if many * size > 4:
            (place,) = struct.unpack_from("<I", content, place)
            assert place % 2 == 0  # a word
        found[tag] = struct.unpack_from("<%d%s" % (many, letter), content, place)
    assert list(found) == sorted(found) and struct.unpack_from("<I", content, at + 2 + 12 * count) == (0,)
    rows = [np.frombuffer(content, "<f%d" % (found[258][0] // 8), found[256][0], place) for place in found[273]]
    assert found[273][-1] + found[279][-1] == len(content)
    return found, np.array(rows)


class GeoTiffTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "a.tif")

    def written(self, values, origin=(10.0, 20.0), cell=(2.0, 0.5), **more):
        _geotiff.write(self.path, values, origin, cell, **more)
        self.assertEqual(os.listdir(os.path.dirname(self.path)), ["a.tif"])
        return read(self.path)

    def test_pixels_and_their_place(self):
        for kind in ("float32", "float64"):
            values = np.arange(12).reshape(3, 4).astype(kind) / 7
            tags, pixels = self.written(values)
            self.assertEqual(pixels.dtype, kind)
            np.testing.assert_array_equal(pixels, values[::-1])  # the north first
            self.assertEqual((tags[256], tags[257], tags[278]), ((4,), (3,), (1,)))
            self.assertEqual(tags[279], 3 * (4 * values.itemsize,))
            self.assertEqual((tags[259], tags[262], tags[277], tags[339]), ((1,), (1,), (1,), (3,)))
            self.assertEqual(tags[33550], (2.0, 0.5, 0.0))
            self.assertEqual(tags[33922], (0, 0, 0, 9.0, 21.25, 0))  # the upper left corner of the first pixel
            self.assertNotIn(34735, tags)

    def test_other_numbers_are_written_as_doubles(self):
        _, pixels = self.written(np.arange(6).reshape(2, 3))
        self.assertEqual(pixels.dtype, "float64")

    def test_cells_without_a_value(self):
        values = np.array([[1, np.nan]], "float32")
        for given, number, said in (((), -9999.0, b"-9999\0"), ((0.1,), np.float32(0.1), b"0.10000000149011612\0"),
                                    ((np.nan,), np.nan, b"nan\0")):  # fmt: skip
            tags, pixels = self.written(values, **dict(zip(("no_data",), given)))
            np.testing.assert_array_equal(pixels, np.array([[1, number]], "float32"))
            self.assertEqual(tags[42113], (said,))

    def test_reference_systems(self):
        """Of degrees where the cells are on the globe; one that sticks out beyond a pole is."""
        on_globe = ((12, 47), (-179, 0), (-359, 0), (359, 0), (0, 89.8), (0, -89.8), (0, 90.2), (0, -90.2), (360.9, 0))
        for at, kind in [(at, 2) for at in on_globe] + [((500000, 4000000), 1), ((0, 91), 1), ((0, -91), 1),
                                                        ((-362, 0), 1), ((362, 0), 1)]:  # fmt: skip
            tags, _ = self.written(np.zeros((1, 1)), at, epsg=4326)
            system = 2048 if kind == 2 else 3072
            self.assertEqual(tags[34735], (1, 1, 0, 3, 1024, 0, 1, kind, 1025, 0, 1, 1, system, 0, 1, 4326), at)

    def test_a_file_stays_where_the_new_one_fails(self):
        self.written(np.ones((2, 2)))
        with open(self.path, "rb") as file:
            before = file.read()
        with unittest.mock.patch.object(os, "replace", side_effect=OSError), self.assertRaises(OSError):
            _geotiff.write(self.path, np.zeros((2, 2)), (0, 0), (1, 1))
        self.assertEqual(os.listdir(os.path.dirname(self.path)), ["a.tif"])
        with open(self.path, "rb") as file:
            self.assertEqual(file.read(), before)
        with self.assertRaises(OSError):
            _geotiff.write(os.path.join(self.path, "b.tif"), np.zeros((2, 2)), (0, 0), (1, 1))

    def test_more_pixels_than_a_file_has(self):
        """4 GiB less a place for each row, and for what is said."""
        columns = 1 << 16
        most = (2**32 - 1 - 65536) // (8 * columns + 8)
        opened = unittest.mock.patch("builtins.open", side_effect=FileNotFoundError)
        for rows, error in ((most, FileNotFoundError), (most + 1, ValueError)):
            with opened, self.assertRaises(error):
                _geotiff.write(self.path, np.broadcast_to(0.0, (rows, columns)), (0, 0), (1, 1))


if __name__ == "__main__":
    unittest.main()
