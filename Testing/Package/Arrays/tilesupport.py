# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of tiles: points, what one piece gives, files of a TIN read without VTK."""

import contextlib
import hashlib
import io
import os
import re
import struct
import tempfile
import unittest
import warnings
import zlib

import numpy as np
from adaptivehilbertdelaunay import DelaunayWarning, delaunay
from adaptivehilbertdelaunay import tiles  # noqa: F401 - for those who import this
from adaptivehilbertdelaunay._exchange import writer
from adaptivehilbertdelaunay.tiles import _command

DTYPES = {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt16": "<u2", "UInt8": "u1"}


class TilesTest(unittest.TestCase):
    """Each in a folder of its own."""

    def setUp(self):
        # where there is one, a disk that is always in step with its files, so that nobody waits for it
        folder = tempfile.TemporaryDirectory(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def at(self, *names):
        return os.path.join(self.folder, *names)

    def saved(self, points, name="points.npy"):
        np.save(self.at(name), points)
        return self.at(name)

    def command(self, *words):
        """Exit code and what was said."""
        said = io.StringIO()
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            try:
                code = _command.main([str(word) for word in words])
            except SystemExit as error:
                code = error.code
        return code, said.getvalue()

    def assert_is_one_piece(self, points, path):
        """The TIN has the triangles of one piece, in its order."""
        whole = one_piece(points).triangles.astype(np.int64)
        self.assertEqual(hash_of(triangles_of(path)), hash_of(whole))


def one_piece(points, **settings):
    """What tiles are compared with."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DelaunayWarning)  # of points that are not finite, and of duplicates
        return delaunay(points, duplicates="lowest_z", **settings)


def needs_raster(test):
    return unittest.skipIf(writer() is None, "there is neither rasterio nor GDAL")(test)


def hash_of(array):
    return hashlib.sha256(np.ascontiguousarray(array).tobytes()).hexdigest()


def bytes_of(path):
    """Of a file, or of a TIN with all of its pieces."""
    with open(path, "rb") as file:
        made = file.read()
    for piece in pieces_of(path) if path.endswith(".pvtp") else ():
        with open(piece, "rb") as file:
            made += file.read()
    return made


def kinds(count):
    """(name, points) of many sorts, with heights."""
    rng = np.random.default_rng(7)
    uniform = rng.random((count, 2)) * (100, 60)
    side = int(count**0.5)
    lattice = np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2).astype(float)
    angle = rng.random(count) * 2 * np.pi
    far = np.concatenate((uniform[: count // 2] / 1000, uniform[count // 2 :] + 1e6))
    found = {"uniform": uniform, "lattice": lattice, "circle": np.stack((np.cos(angle), np.sin(angle)), axis=1),
             "rounded": np.round(uniform / 4), "far apart": far, "squeezed": uniform**3,
             "nearly a line": uniform * (1, 1e-9), "one place many times": np.repeat(uniform[:9], count // 9, axis=0)}
    for name, xy in found.items():
        order = rng.permutation(len(xy))
        yield name, np.column_stack((xy, np.sin(xy[:, 0] / 9) + rng.random(len(xy))))[order]


def pieces_of(path):
    with open(path, encoding="utf-8") as file:
        names = re.findall(r'<Piece Source="([^"]*)"', file.read())
    return [os.path.join(os.path.dirname(path), name) for name in names]


def read_piece(path):
    """(points, point data by name, triangles) of a .vtp of appended, compressed arrays."""
    with open(path, "rb") as file:
        data = file.read()
    head, body = data.split(b'<AppendedData encoding="raw">', 1)
    body = body[body.index(b"_") + 1 :]
    found = {}
    for text in re.findall(r"<DataArray [^>]*>", head.decode()):
        row = dict(re.findall(r'(\w+)="([^"]*)"', text))
        offset = int(row["offset"])
        blocks, size, last = struct.unpack_from("<3Q", body, offset)
        lengths = struct.unpack_from("<%dQ" % blocks, body, offset + 24)
        offset, octets = offset + 24 + 8 * blocks, b""
        for length in lengths:
            octets += zlib.decompress(body[offset : offset + length])
            offset += length
        assert len(octets) == (blocks - (last > 0)) * size + last, text
        array = np.frombuffer(octets, DTYPES[row["type"]])
        found[row["Name"]] = array.reshape(-1, int(row.get("NumberOfComponents", 1)))
    points, corners = found.pop("Points"), found.pop("connectivity").reshape(-1, 3)
    assert (found.pop("offsets").ravel() == 3 * np.arange(1, len(corners) + 1)).all()
    counts = re.search(r'NumberOfPoints="(\d+)".*NumberOfPolys="(\d+)"', head.decode()).groups()
    assert counts == (str(len(points)), str(len(corners)))
    return points, {name: array.ravel() for name, array in found.items()}, corners


def triangles_of(path):
    """(n, 3) int64 global ids of all pieces."""
    made = [np.empty((0, 3), np.int64)]
    for piece in pieces_of(path):
        _, data, corners = read_piece(piece)
        made.append(data["GlobalPointIds"][corners])
    return np.concatenate(made)


def raster_of(path):
    """(rows, columns) of a GeoTIFF, and its place."""
    package = writer()
    if package.__name__ == "rasterio":
        with package.open(path) as file:
            return file.read(1), file.transform.to_gdal()
    file = package.Open(path)
    kind = {"Float32": np.float32, "Float64": np.float64}[package.GetDataTypeName(file.GetRasterBand(1).DataType)]
    octets = file.GetRasterBand(1).ReadRaster(0, 0, file.RasterXSize, file.RasterYSize)
    return np.frombuffer(octets, kind).reshape(file.RasterYSize, file.RasterXSize), file.GetGeoTransform()
