# SPDX-License-Identifier: BSD-3-Clause
"""Files of points, read in chunks: each kind a few lines over a library.

A reader is `chunks(path, start, rows, threads)`, a generator of `Chunk`s of at most `rows` points, which follow each
other from point `start` on, and `head(path)`, what the file says before its points are read.
"""

from __future__ import annotations

import contextlib
import itertools
import os
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._errors import BadFile, BadOptions

ROWS = 1 << 20  #: points of a chunk
FIELDS = (("intensity", np.dtype("<u2")), ("classification", np.dtype("u1")))


class Chunk(NamedTuple):
    """Points as the file has them."""

    xyz: np.ndarray  #: (k, 3) float64; z is NaN where the file has none
    intensity: Optional[np.ndarray] = None  #: (k,) uint16
    classification: Optional[np.ndarray] = None  #: (k,) uint8
    hasZ: bool = True


class Head(NamedTuple):
    """What a file says of itself."""

    points: int  #: how many, or at most how many: for text a guess from its size
    scales: Optional[Tuple[float, ...]] = None
    crs: Optional[str] = None  #: WKT or "EPSG:number"
    bounds: Optional[np.ndarray] = None  #: (2, 3) lowest and highest x, y, z
    isExact: bool = True


# --- .npy ---------------------------------------------------------------------------------------------------


def _npy(path: str) -> np.memmap:
    made: np.memmap = np.load(path, mmap_mode="r", allow_pickle=False)
    isTable = made.dtype.names is not None and {"x", "y"} <= set(made.dtype.names) and made.ndim == 1
    if not isTable and (made.ndim != 2 or made.shape[1] not in (2, 3) or made.dtype.kind not in "iuf"):
        raise BadFile(path, "must be an array (n, 2) or (n, 3) of numbers, or one with fields x, y, z; it is %s of "
                            "type %s" % (made.shape, made.dtype))  # fmt: skip
    return made


class Npy:
    @staticmethod
    def head(path: str) -> Head:
        return Head(len(_npy(path)))

    @staticmethod
    def chunks(path: str, start: int, rows: int, threads: int) -> Iterator[Chunk]:
        array = _npy(path)
        row = array.nbytes // max(1, len(array))
        for begin in range(start, len(array), rows):
            part: np.ndarray = array[begin : begin + rows]
            if array.flags.c_contiguous:  # pages of a mapped file would stay, and count as memory that is taken
                part = np.fromfile(path, array.dtype, part.size, offset=array.offset + begin * row).reshape(part.shape)
            if part.dtype.names is None:
                yield Chunk(_in_space(part), hasZ=part.shape[1] == 3)
            else:
                columns = {name: part[name] for name in part.dtype.names}
                yield _of_columns(columns)


def _in_space(part: np.ndarray) -> np.ndarray:
    if part.shape[1] == 3:
        return np.ascontiguousarray(part, np.float64)
    made = np.full((len(part), 3), np.nan)
    made[:, :2] = part
    return made


def _of_columns(columns: Dict[str, np.ndarray]) -> Chunk:
    """Of columns by their names, x and y among them."""
    names = [name for name in "xyz" if name in columns]
    intensity, classification = (columns[name].astype(kind) if name in columns else None for name, kind in FIELDS)
    xyz = _in_space(np.stack([columns[name] for name in names], axis=1))
    return Chunk(xyz, intensity, classification, "z" in names)


# --- Text ---------------------------------------------------------------------------------------------------

_NAMES = {"class": "classification", "lon": "x", "longitude": "x", "easting": "x", "lat": "y", "latitude": "y",
          "northing": "y", "elevation": "z", "height": "z", "depth": "z"}  # fmt: skip


_KNOWN = ("x", "y", "z", *(name for name, _ in FIELDS))


class _Layout(NamedTuple):
    """How a text file is laid out."""

    delimiter: Optional[str]
    skip: int  # lines before the points
    columns: List[Tuple[int, str]]  # number and name of those that are read
    line: int  # bytes of the first line of points


def _layout(path: str) -> _Layout:
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        skip, first = 0, file.readline()
        while first and (not first.strip() or first.startswith("#")):
            skip, first = skip + 1, file.readline()
        delimiter = next((one for one in ",;\t" if one in first), None)
        words = [word.strip().strip('"').lower() for word in first.strip().split(delimiter)]
        if all(map(_is_number, words)):
            return _Layout(delimiter, skip, list(enumerate(("x", "y", "z")[: len(words)])), len(first))
        second = file.readline()
    found: Dict[str, int] = {}
    for names in ([_NAMES.get(word, word) for word in words], words):  # x counts before easting, the first of several
        found.update((names[k], k) for k in reversed(range(len(names))) if names[k] in _KNOWN)
    return _Layout(delimiter, skip + 1, sorted((number, name) for name, number in found.items()), len(second))


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


class Text:
    @staticmethod
    def head(path: str) -> Head:
        layout = _layout(path)
        if not {"x", "y"} <= {name for _, name in layout.columns}:
            raise BadFile(path, "must have columns x and y, and z: by name in its first line, or as the first ones")
        return Head(os.path.getsize(path) // max(1, layout.line) + 1, isExact=False)

    @staticmethod
    def chunks(path: str, start: int, rows: int, threads: int) -> Iterator[Chunk]:
        layout = _layout(path)
        numbers = [number for number, _ in layout.columns]
        with open(path, encoding="utf-8-sig", errors="replace") as file:
            for _ in itertools.islice(file, layout.skip):
                pass
            lines = (line for line in file if line.strip() and not line.startswith("#"))
            for _ in itertools.islice(lines, start):
                pass
            while True:
                some = list(itertools.islice(lines, rows))
                if not some:
                    return
                found = np.loadtxt(some, delimiter=layout.delimiter, usecols=numbers, ndmin=2, comments=None)
                yield _of_columns({name: found[:, k] for k, (_, name) in enumerate(layout.columns)})


# --- LAS and LAZ, COPC too -----------------------------------------------------------------------------------

_GEO_KEYS, _WKT = 34735, 2112  # records of coordinate systems
_PROJECTED, _GEOGRAPHIC = 3072, 2048


class Las:
    @staticmethod
    def _open(path: str, threads: int = 1) -> Any:
        try:
            import laspy
        except ImportError:
            raise BadOptions("%s: to read .las and .laz, pip install 'laspy[lazrs]'" % path) from None
        backends = laspy.LazBackend
        backend = backends.Lazrs if threads == 1 else backends.LazrsParallel
        return laspy.open(path, laz_backend=backend)

    @classmethod
    def head(cls, path: str) -> Head:
        with cls._open(path) as file:
            header = file.header
            bounds = np.array([header.mins, header.maxs], float)
            made = Head(header.point_count, tuple(map(float, header.scales)), _crs_of(header), bounds)
        if not header.are_points_compressed:  # else the end of the points is not where their number says
            ends = os.path.getsize(path), header.start_of_first_evlr, header.start_of_waveform_data_packet_record
            room = (min(filter(None, ends)) - header.offset_to_point_data) // header.point_format.size
            if room > made.points:
                raise BadFile(path, "says that it has %d points, and has room for %d: its header is wrong" % (
                    made.points, room))  # fmt: skip
        return made

    @classmethod
    def chunks(cls, path: str, start: int, rows: int, threads: int) -> Iterator[Chunk]:
        with cls._open(path, threads) as file:
            if start:
                file.seek(start)
            for part in file.chunk_iterator(rows):
                xyz = np.stack([np.asarray(axis) for axis in (part.x, part.y, part.z)], axis=1)
                yield Chunk(xyz, np.asarray(part.intensity), np.asarray(part.classification).astype(np.uint8))


def _crs_of(header: Any) -> Optional[str]:
    records = {one.record_id: one for one in [*header.vlrs, *(header.evlrs or [])]
               if one.user_id.strip("\0 ") == "LASF_Projection"}  # fmt: skip
    if _WKT in records:
        text = records[_WKT].record_data_bytes().decode("utf-8", "replace").strip("\0 \n")
        return text or None
    if _GEO_KEYS in records:
        keys = np.frombuffer(records[_GEO_KEYS].record_data_bytes(), "<u2")
        found = {int(row[0]): int(row[3]) for row in keys[4 : len(keys) // 4 * 4].reshape(-1, 4) if row[1] == 0}
        number = found.get(_PROJECTED) or found.get(_GEOGRAPHIC)
        return "EPSG:%d" % number if number and number != 32767 else None
    return None


# --- VTK's --------------------------------------------------------------------------------------------------


class Vtk:
    @staticmethod
    def _read(path: str) -> Any:
        try:
            from vtkmodules import vtkIOXML
            from vtkmodules.util.numpy_support import vtk_to_numpy
        except ImportError:
            raise BadOptions("%s: to read .vtp and .vtu, pip install vtk" % path) from None
        isPoly = path.lower().endswith("vtp")
        reader = vtkIOXML.vtkXMLPolyDataReader() if isPoly else vtkIOXML.vtkXMLUnstructuredGridReader()
        errors: List[str] = []
        reader.AddObserver("ErrorEvent", lambda *_: errors.append("VTK cannot read it"))
        reader.SetFileName(path)
        reader.Update()
        if errors or reader.GetErrorCode() or reader.GetOutput().GetPoints() is None:
            raise BadFile(path, "VTK cannot read points from it")
        made = reader.GetOutput()
        columns = dict(zip("xyz", vtk_to_numpy(made.GetPoints().GetData()).T))
        for name, _ in FIELDS:
            array = made.GetPointData().GetArray(name)
            if array is not None:
                columns[name] = vtk_to_numpy(array)
        return columns

    @classmethod
    def head(cls, path: str) -> Head:
        return Head(len(cls._read(path)["x"]))

    @classmethod
    def chunks(cls, path: str, start: int, rows: int, threads: int) -> Iterator[Chunk]:
        columns = cls._read(path)
        for begin in range(start, len(columns["x"]), rows):
            yield _of_columns({name: column[begin : begin + rows] for name, column in columns.items()})


# --- All ----------------------------------------------------------------------------------------------------

READERS: Dict[str, Any] = {
    ".npy": Npy, **dict.fromkeys((".csv", ".xyz", ".txt"), Text), **dict.fromkeys((".las", ".laz"), Las),
    **dict.fromkeys((".vtp", ".vtu"), Vtk)}  # fmt: skip


def reader_of(path: str) -> Any:
    reader = READERS.get(os.path.splitext(path)[1].lower())
    if reader is None:
        raise BadFile(path, "is none of %s" % ", ".join(READERS))
    return reader


@contextlib.contextmanager
def _named(path: str) -> Iterator[None]:
    """What a library raises becomes a BadFile; libraries have exceptions of many classes."""
    try:
        yield
    except (BadFile, BadOptions, MemoryError):
        raise
    except Exception as error:
        said = str(error).splitlines()
        raise BadFile(path, "cannot be read: %s" % (said[0] if said else type(error).__name__)) from error


def head_of(path: str) -> Head:
    """BadFile, BadOptions."""
    with _named(path):
        if not os.path.exists(path):
            raise BadFile(path, "there is no such file")
        return reader_of(path).head(path)  # type: ignore[no-any-return]


def chunks_of(path: str, head: Head, start: int = 0, threads: int = 1) -> Iterator[Chunk]:
    """BadFile, also where there are fewer or more points than the head says, or some out of its bounds."""
    count = start
    with _named(path):
        for chunk in reader_of(path).chunks(path, start, ROWS, threads):
            count += len(chunk.xyz)
            if head.bounds is not None:
                _check_bounds(path, chunk.xyz, head)
            yield chunk
    if head.isExact and count != head.points:
        raise BadFile(path, "says that it has %d points, and has %d: it is truncated, or its header is wrong" % (
            head.points, count))  # fmt: skip


def _check_bounds(path: str, xyz: np.ndarray, head: Head) -> None:
    """A coordinate may be off by the rounding of the bounds, a step of the scale."""
    assert head.bounds is not None and head.scales is not None
    if not len(xyz):
        return
    low, high = (np.array([end(axis) for axis in xyz.T]) for end in (np.min, np.max))
    if ((low >= head.bounds[0] - head.scales) & (high <= head.bounds[1] + head.scales)).all():
        return
    raise BadFile(path, "has points from %s to %s, and says that they are from %s to %s" % tuple(
        "(%s)" % ", ".join("%.10g" % number for number in numbers) for numbers in (low, high, *head.bounds)))


def check_alike(paths: Sequence[str], heads: Sequence[Head], isCrsGiven: bool) -> Iterator[BadFile]:
    """Those whose scale or reference system is not that of the first that has one; what a file does not say is not
    compared."""
    for what in ("scales",) if isCrsGiven else ("scales", "crs"):
        first: Optional[int] = None
        for number, head in enumerate(heads):
            value = getattr(head, what)
            if value is None:
                continue
            if first is None:
                first = number
            elif value != getattr(heads[first], what):
                yield BadFile(paths[number], "has the %s %s, and %s has %s" % (
                    "scale" if what == "scales" else "reference system", _short(value), paths[first],
                    _short(getattr(heads[first], what))))  # fmt: skip


def _short(value: Any) -> str:
    said = str(value)
    return said if len(said) < 60 else said[:57] + "..."
