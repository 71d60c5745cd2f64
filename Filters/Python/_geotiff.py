# SPDX-License-Identifier: BSD-3-Clause
"""A raster as a GeoTIFF: the file of Filters/vtkPlanarGeoTIFFWriter.cxx, which has the rules, byte for byte."""

from __future__ import annotations

import math
import os
import struct
from typing import Any, Sequence, Tuple

import numpy as np

TEXT, SHORT, LONG, DOUBLE = (2, "s"), (3, "H"), (4, "I"), (12, "d")


def write(
    path: str, values: np.ndarray, origin: Sequence[float], cell: Sequence[float], epsg: int = 0,
    no_data: float = -9999.0,
) -> None:  # fmt: skip
    """`values`: rows, the first one the southernmost, NaN where there is none; `origin`: the centre of the first of the
    cells, `cell`: their width and height. OSError, with which no file changes; ValueError for more than 4 GiB."""
    kind = np.float32 if values.dtype == np.float32 else np.float64
    rows, columns = values.shape
    row = columns * np.dtype(kind).itemsize
    if rows * row + 8 * rows + 65536 > 2**32 - 1:
        raise ValueError("a GeoTIFF of so many pixels has more than 4 GiB; take larger cells")
    west, south = (start + -0.5 * size for start, size in zip(origin, cell))
    east, north = (start + (n - 0.5) * size for start, size, n in zip(origin, cell, (columns, rows)))
    degrees = west + cell[0] >= -360 and east - cell[0] <= 360 and south + cell[1] >= -90 and north - cell[1] <= 90
    no_data = float(kind(no_data))
    system = (1024, 0, 1, 2 if degrees else 1, 1025, 0, 1, 1, 2048 if degrees else 3072, 0, 1, epsg)
    keys = ((34735, SHORT, (1, 1, 0, 3) + system),) if epsg else ()
    said = b"nan" if math.isnan(no_data) else b"%.17g" % no_data

    def header(begin: int) -> bytes:
        return _directory((
            (256, LONG, [columns]), (257, LONG, [rows]), (258, SHORT, [8 * np.dtype(kind).itemsize]), (259, SHORT, [1]),
            (262, SHORT, [1]), (273, LONG, [begin + k * row for k in range(rows)]), (277, SHORT, [1]), (278, LONG, [1]),
            (279, LONG, [row] * rows), (339, SHORT, [3]), (33550, DOUBLE, [*cell, 0.0]),
            (33922, DOUBLE, [0.0, 0.0, 0.0, west, north, 0.0]), *keys, (42113, TEXT, said + b"\0")))

    made = path + ".part"  # until it is whole
    try:
        with open(made, "wb") as file:
            file.write(header(len(header(0))))
            for one in values[::-1]:
                file.write(np.where(np.isnan(one), no_data, one).astype("<f%d" % np.dtype(kind).itemsize).tobytes())
        os.replace(made, path)
    except BaseException:
        if os.path.exists(made):
            os.remove(made)
        raise


def _directory(entries: Sequence[Tuple[int, Tuple[int, str], Any]]) -> bytes:
    """Header, directory and values: what comes before the pixels."""
    made, values = struct.pack("<2sHIH", b"II", 42, 8, len(entries)), b""
    begin = len(made) + 12 * len(entries) + 4
    for tag, (kind, letter), numbers in entries:
        isText = letter == "s"
        value = numbers if isText else struct.pack("<%d%s" % (len(numbers), letter), *numbers)
        made += struct.pack("<HHI", tag, kind, len(numbers))
        if len(value) > 4:
            made += struct.pack("<I", begin + len(values))
            values += value + b"\0" * (len(value) % 2)
        else:
            made += value.ljust(4, b"\0")
    return made + struct.pack("<I", 0) + values
