# SPDX-License-Identifier: BSD-3-Clause
"""A surface as VTK's XML files: pieces (.vtp, appended raw, compressed by zlib) and the .pvtp that lists them."""

from __future__ import annotations

import functools
import struct
import zlib
from typing import IO, Any, Dict, List, NamedTuple, Sequence, Tuple
from xml.sax.saxutils import quoteattr

import numpy as np

from ._store import written

IDS = "GlobalPointIds"
RUN = "run"  #: in the folder of pieces until the TIN is whole: of which run they are
NAMES = r"\d+\.vtp|" + RUN  #: of files in that folder
_BLOCK = 1 << 20  # bytes that are compressed together
_OFFSETS = 1 << 14  # offsets that are
_TYPES = {"f8": "Float64", "i8": "Int64", "i4": "Int32", "u2": "UInt16", "u1": "UInt8"}


class Piece(NamedTuple):
    """Triangles, and the points that are their corners."""

    xyz: np.ndarray  #: (n, 3) float64
    data: Dict[str, np.ndarray]  #: of points by name; IDS among them
    triangles: np.ndarray  #: (m, 3) int32


def _attributes(names: Sequence[str]) -> str:
    return ' GlobalIds="%s"' % IDS + (' Scalars="z"' if "z" in names else "")


def _array(kind: np.dtype, name: str, columns: int, tail: str) -> str:
    more = ' NumberOfComponents="%d"' % columns if columns > 1 else ""
    return '<DataArray type="%s" Name="%s"%s%s/>' % (_TYPES[kind.str[1:]], name, more, tail)


def _appended(file: IO[bytes], array: np.ndarray) -> None:
    """Writes it as vtkZLibDataCompressor does."""
    data = np.ascontiguousarray(array, array.dtype.newbyteorder("<")).reshape(-1).view(np.uint8).data
    blocks = [zlib.compress(data[begin : begin + _BLOCK], 1) for begin in range(0, len(data), _BLOCK)]
    _write_blocks(file, blocks, _BLOCK, len(data))


def _write_blocks(file: IO[bytes], blocks: Sequence[bytes], size: int, length: int) -> None:
    """`size`: of a block before it is compressed, but of the last; `length`: of all."""
    head = struct.pack("<%dQ" % (3 + len(blocks)), len(blocks), size if blocks else 0, length % size,
                       *map(len, blocks))  # fmt: skip
    for part in (head, *blocks):
        file.write(part)


@functools.lru_cache(512)  # 20 kB each
def _offsets_block(begin: int, count: int) -> bytes:
    """Where triangles end: the same numbers in each piece."""
    return zlib.compress(np.arange(3 * begin + 3, 3 * (begin + count) + 3, 3, dtype="<i4").tobytes(), 1)


def _append_offsets(file: IO[bytes], count: int) -> None:
    """Of so many triangles, int32."""
    blocks = [_offsets_block(begin, min(_OFFSETS, count - begin)) for begin in range(0, count, _OFFSETS)]
    _write_blocks(file, blocks, 4 * _OFFSETS, 4 * count)


def _head(kind: str) -> str:
    return ('<?xml version="1.0"?>\n<VTKFile type="%s" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
            'compressor="vtkZLibDataCompressor">\n' % kind)  # fmt: skip


def write_piece(path: str, piece: Piece) -> None:
    """WriteFailed."""
    offsets = np.empty(0, np.int32)
    arrays: List[Tuple[str, str, int, np.ndarray]] = [("PointData", name, 1, one) for name, one in piece.data.items()]
    arrays += [("Points", "Points", 3, piece.xyz), ("Polys", "connectivity", 1, piece.triangles),
               ("Polys", "offsets", 1, offsets)]  # fmt: skip
    with written(path) as file:
        # The places of arrays are known when they are compressed: the head has room for them.
        marks = {name: "%020d" % 0 for _, name, _, _ in arrays}
        file.write(_piece_head(piece, arrays, marks))
        begin = file.tell()
        for _, name, _, array in arrays:
            marks[name] = "%020d" % (file.tell() - begin)
            if array is offsets:
                _append_offsets(file, len(piece.triangles))
            else:
                _appended(file, array)
        file.write(b"\n  </AppendedData>\n</VTKFile>\n")
        file.seek(0)
        file.write(_piece_head(piece, arrays, marks))


def _piece_head(piece: Piece, arrays: Sequence[Tuple[str, str, int, np.ndarray]], marks: Dict[str, str]) -> bytes:
    made = _head("PolyData") + '  <PolyData>\n    <Piece NumberOfPoints="%d" NumberOfVerts="0" NumberOfLines="0" ' \
        'NumberOfStrips="0" NumberOfPolys="%d">\n' % (len(piece.xyz), len(piece.triangles))  # fmt: skip
    for group in ("PointData", "Points", "Polys"):
        made += "      <%s%s>\n" % (group, _attributes(list(piece.data)) if group == "PointData" else "")
        for of, name, columns, array in arrays:
            if of == group:
                tail = ' format="appended" offset="%s"' % marks[name]
                made += "        %s\n" % _array(array.dtype, name, columns, tail)
        made += "      </%s>\n" % group
    return (made + '    </Piece>\n  </PolyData>\n  <AppendedData encoding="raw">\n    _').encode()


def write_list(path: str, pieces: Sequence[str], data: Dict[str, Any]) -> None:
    """The .pvtp: `pieces` are paths relative to it, `data` the types of point data by name. WriteFailed."""
    made = _head("PPolyData") + '  <PPolyData GhostLevel="0">\n    <PPointData%s>\n' % _attributes(list(data))
    for name, kind in data.items():
        made += "      %s\n" % _array(np.dtype(kind), name, 1, "").replace("<DataArray", "<PDataArray")
    made += '    </PPointData>\n    <PPoints>\n      <PDataArray type="Float64" Name="Points" ' \
        'NumberOfComponents="3"/>\n    </PPoints>\n'  # fmt: skip
    made += "".join("    <Piece Source=%s/>\n" % quoteattr(piece) for piece in pieces)
    with written(path) as file:
        file.write((made + "  </PPolyData>\n</VTKFile>\n").encode())
