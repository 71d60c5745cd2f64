# SPDX-License-Identifier: BSD-3-Clause
"""The shared library of the engine's C interface (Filters/Engine/Interface/ahd*.h): found, loaded and declared.
Constants have the names of the header without AHD_.

The library is the one that the environment variable ADAPTIVEHILBERTDELAUNAY_LIBRARY names, else the one in
the folder of this file. ImportError if there is none, or it is of another version.
"""

from __future__ import annotations

import ctypes
import functools
import os
import sys
from typing import Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from . import __path__ as _folders
from ._keywords import ARRAY_DTYPES

#: The AHD_ABI_VERSION of the header that this file follows.
ABI_VERSION = 1

#: Names a library to be loaded in place of the one beside this file.
LIBRARY_VARIABLE = "ADAPTIVEHILBERTDELAUNAY_LIBRARY"

# How a call ended.
OK, CANCELLED, TOO_MANY_POINTS, TOO_MANY_BOXES, OUT_OF_MEMORY, MEMORY_LIMIT, TOO_MANY_CROSSINGS = range(7)
UNKNOWN_NAME, BAD_VALUE, BAD_ARRAY, NOT_AVAILABLE, BUSY, NO_JOB, FAILED = range(7, 14)

# Types of numbers.
FLOAT32, FLOAT64, INT32, INT64, UINT8 = range(1, 6)

# Phases of the library's work.
PHASES = ("merge", "split", "read", "sort", "insert", "constrain", "extract", "outputs")

# Values of settings.
ORDER_ADAPTIVE_HILBERT, ORDER_MULTI_GRID, ORDER_REGULAR_GRID, ORDER_AS_GIVEN = range(4)
CONTROL_OFF, CONTROL_SINGLE_LEVEL, CONTROL_EVERY_LEVEL = range(3)
DUPLICATES_FIRST, DUPLICATES_LOWEST_Z, DUPLICATES_HIGHEST_Z, DUPLICATES_MEAN_Z = range(4)
IDS_OF_INPUT, IDS_OF_SOURCE = range(2)
HEIGHTS_OWN, HEIGHTS_FROM_SURFACE, HEIGHTS_MIXED = range(3)
FILL_ORIENTATION, FILL_EVEN_ODD = range(2)
PLANE_XY, PLANE_BEST_FIT, PLANE_MATRIX, PLANE_CALLBACK = range(4)
RIM_AUTOMATIC, RIM_CONVEX_HULL, RIM_TRIMMED = range(3)
CLIP_HULL, CLIP_BOUNDS, CLIP_POLYGON = range(3)
SAMPLE_LINEAR, SAMPLE_NATURAL_NEIGHBOR, SAMPLE_LAPLACE, SAMPLE_NEAREST = range(4)
OUTSIDE_NO_VALUE, OUTSIDE_NEAREST_VERTEX, OUTSIDE_BOUNDARY = range(3)

# Values of point_status that are not ids.
POINT_NOT_FINITE, POINT_NOT_INSERTED, POINT_WITHIN_ERROR = -1, -2, -3

# Where a place lies.
IN_TRIANGLE, ON_EDGE, ON_VERTEX, OUTSIDE, NOWHERE = range(5)

# What became of a request of ahd_edit.h.
EDIT_DONE, EDIT_NOT_TRIED, EDIT_NO_POINT, EDIT_END_OF_SEGMENT, EDIT_SEGMENTS_MEET = range(5)
EDIT_NOT_FINITE, EDIT_NO_LENGTH, EDIT_CROSSES, EDIT_NO_SEGMENT = range(5, 9)

# Why a triangle does not meet a request of ahd_refine.h, and as many points as it takes.
REFINE_INPUT_ANGLE, REFINE_BUDGET, REFINE_RESOLUTION = range(3)
REFINE_ALL = 2**64 - 1

# For Job.interpolate.
AT_SURFACE, AT_CROSSINGS = 1, 2

# Whose words a message has, and when it is said.
WORDS_OF_C, WORDS_OF_CLASS, WORDS_OF_NUMPY = range(3)
SAY_REFUSAL, SAY_TRIANGULATION, SAY_COLUMNS, SAY_PLACES, SAY_BLOCKS, SAY_OUTLINE = range(6)

# Kinds of names, for names().
INT_SETTINGS, DOUBLE_SETTINGS, INPUT_ARRAYS, COUNTS, MEASURES, OUTPUT_ARRAYS = range(6)

DTYPES = {FLOAT32: np.float32, FLOAT64: np.float64, INT32: np.int32, INT64: np.int64, UINT8: np.uint8}
TYPES = {np.dtype(dtype): number for number, dtype in DTYPES.items()}

# Arrays whose numbers have a type of their own; the others have ids or, "points", coordinates.
FIXED_DTYPES: Dict[str, Any] = {
    name: np.float64
    for name in (
        "plane_points", "plane_matrix", "box_bounds", "voronoi_points", "surface_weights", "crossing_fractions",
        "points", "heights", "vertex_bounds", "weights",
    )  # fmt: skip
}
FIXED_DTYPES.update(ARRAY_DTYPES, box_levels=np.int32, weight_offsets=np.int64)


# --- Errors -------------------------------------------------------------------------------------------------


class EngineError(Exception):
    """The failure of a call of the engine. `status` is one of the constants above."""

    status = FAILED

    def __init__(self, message: str, status: Optional[int] = None) -> None:
        super().__init__(message)
        self.status = self.status if status is None else status


class Cancelled(EngineError):
    """The work was cancelled, by `Job.cancel` or by the result of a progress function."""

    status = CANCELLED


class OutOfMemory(EngineError, MemoryError):
    """There is not enough memory, or the memory limit allows less than is needed."""

    status = OUT_OF_MEMORY


class BadInput(EngineError, ValueError):
    """A value, array or name that the engine does not take, or too many points."""

    status = BAD_VALUE


class NotAvailable(EngineError, RuntimeError):
    """There is no result, or this was not asked for before the run; or the job is at work."""

    status = NOT_AVAILABLE


class Fault(EngineError, RuntimeError):
    """A fault of the library."""


ERRORS = {
    CANCELLED: Cancelled,
    TOO_MANY_POINTS: BadInput,
    TOO_MANY_BOXES: OutOfMemory,
    OUT_OF_MEMORY: OutOfMemory,
    MEMORY_LIMIT: OutOfMemory,
    TOO_MANY_CROSSINGS: OutOfMemory,
    UNKNOWN_NAME: BadInput,
    BAD_VALUE: BadInput,
    BAD_ARRAY: BadInput,
    NOT_AVAILABLE: NotAvailable,
    BUSY: NotAvailable,
}


# --- The library --------------------------------------------------------------------------------------------


class Array(ctypes.Structure):
    _fields_ = [
        ("data", ctypes.c_void_p),
        ("type", ctypes.c_int32),
        ("columns", ctypes.c_int32),
        ("rows", ctypes.c_int64),
        ("row_stride", ctypes.c_int64),
        ("column_stride", ctypes.c_int64),
    ]


class Drawing(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in ("xyz", "ranks", "ids", "levels", "counts")]


class Places(ctypes.Structure):
    _fields_ = [
        ("xy", ctypes.c_void_p),
        ("count", ctypes.c_uint64),
        ("origin", ctypes.c_double * 2),
        ("spacing", ctypes.c_double * 2),
        ("columns", ctypes.c_uint64),
        ("rows", ctypes.c_uint64),
    ]


class Sampled(ctypes.Structure):
    _fields_ = [
        ("values", ctypes.c_void_p),
        ("columns", ctypes.c_int32),
        ("out", ctypes.c_void_p),
        ("gradients", ctypes.c_void_p),
    ]


class OutlineReport(ctypes.Structure):
    _fields_ = [(name, ctypes.c_uint64) for name in ("unfit_cells", "unfit_edges", "memory_needed", "memory_allowed")]
    _fields_ += [("plane", ctypes.c_int32)]


class RefineRequest(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("minimum_angle", "maximum_area", "maximum_length")]
    _fields_ += [("sizes", ctypes.c_void_p), ("most_points", ctypes.c_uint64)]


class RefineReport(ctypes.Structure):
    _fields_ = [(name, ctypes.c_uint64) for name in (
        "points", "on_segments", "triangles", "ids", "chains", "lines", "bad", "encroached_pieces", "pieces",
        "inner_pieces", "memory_needed", "memory_allowed")]  # fmt: skip


class Refined(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in (
        "places", "corners", "weights", "ids", "offsets", "bad", "reasons", "pieces", "piece_edges",
        "piece_cells")]  # fmt: skip


class RefinedTriangles(ctypes.Structure):
    _fields_ = [("corners", ctypes.c_void_p), ("count", ctypes.c_uint64), ("regions", ctypes.c_void_p),
                ("bad", ctypes.c_void_p), ("least_angle", ctypes.c_double)]  # fmt: skip


class Bytes(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("size", ctypes.c_uint64)]


class Facts(ctypes.Structure):
    _fields_ = [(name, ctypes.c_uint64) for name in ("points", "not_finite", "leaves", "nodes", "most_points")]


class Fact(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("text", ctypes.c_char_p),
        ("number", ctypes.c_int64),
        ("real", ctypes.c_double),
    ]


Progress = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_int32, ctypes.c_double)
Projection = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64)


def _signatures() -> Dict[str, Tuple[Any, List[Any]]]:
    """What each function returns and takes."""
    job, name, status, pointer = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int32, ctypes.c_void_p
    i32, i64, u32, u64, double = (
        ctypes.c_int32, ctypes.c_int64, ctypes.c_uint32, ctypes.c_uint64, ctypes.c_double)  # fmt: skip
    to = ctypes.POINTER
    return {
        "ahd_abi_version": (u32, []),
        "ahd_version": (name, []),
        "ahd_job_new": (job, []),
        "ahd_job_free": (None, [job]),
        "ahd_message": (name, [job]),
        "ahd_set_int": (status, [job, name, i64]),
        "ahd_set_double": (status, [job, name, double]),
        "ahd_get_int": (status, [job, name, to(i64)]),
        "ahd_get_double": (status, [job, name, to(double)]),
        "ahd_set_array": (status, [job, name, to(Array)]),
        "ahd_set_projection": (status, [job, Projection, pointer]),
        "ahd_set_progress": (status, [job, Progress, pointer]),
        "ahd_estimate": (status, [job, to(u64)]),
        "ahd_run": (status, [job]),
        "ahd_cancel": (None, [job]),
        "ahd_kept_bytes": (u64, [job]),
        "ahd_release": (status, [job, u64]),
        "ahd_reset": (status, [job, u64]),
        "ahd_fit_plane": (status, [job, pointer]),
        "ahd_choose_plane": (status, [job, to(i64)]),
        "ahd_count": (status, [job, name, to(i64)]),
        "ahd_measure": (status, [job, name, to(double)]),
        "ahd_counts": (status, [job, to(i64), u64]),
        "ahd_measures": (status, [job, to(double), u64]),
        "ahd_array_size": (status, [job, name, to(u64), to(u64)]),
        "ahd_get_array": (status, [job, name, i32, pointer, u64]),
        "ahd_draw_order": (status, [job, i32, to(Drawing)]),
        "ahd_interpolate": (status, [job, i32, pointer, i32]),
        "ahd_to_plane": (status, [job, pointer, u64]),
        "ahd_locate": (status, [job, pointer, u64, pointer, pointer, pointer]),
        "ahd_sample": (status, [job, to(Places), to(Sampled), u64, pointer]),
        "ahd_sample_estimate": (status, [job, to(Places), u64, to(u64)]),
        "ahd_sample_estimate_before": (status, [job, u64, to(Places), u64, i32, to(u64)]),
        "ahd_sample_weights": (status, [job, to(Places)]),
        "ahd_outline": (status, [job, to(OutlineReport)]),
        "ahd_outline_directed": (status, [job, to(OutlineReport)]),
        "ahd_within_radius": (status, [job, double, pointer]),
        "ahd_refine": (status, [job, to(RefineRequest), to(RefineReport)]),
        "ahd_refine_write": (status, [job, to(Refined)]),
        "ahd_refine_triangles": (status, [job, to(RefinedTriangles)]),
        "ahd_edit_insert": (status, [job, pointer, u64, to(i64)]),
        "ahd_edit_remove": (status, [job, pointer, u64, pointer]),
        "ahd_edit_move": (status, [job, pointer, pointer, u64, pointer]),
        "ahd_edit_constrain": (status, [job, pointer, u64, pointer]),
        "ahd_edit_release": (status, [job, pointer, u64, pointer]),
        "ahd_edit_locate": (status, [job, pointer, u64, pointer, pointer]),
        "ahd_edit_size": (status, [job, to(u64), to(u64)]),
        "ahd_edit_ready": (status, [job, to(i32)]),
        "ahd_edit_write": (status, [job, pointer, pointer, pointer]),
        "ahd_tiles_begin": (status, [job, pointer]),
        "ahd_tiles_count": (status, [job, to(Array)]),
        "ahd_tiles_plan": (status, [job, u64, pointer, to(i32)]),
        "ahd_tiles_load": (status, [job, pointer, u64]),
        "ahd_tiles_get_facts": (status, [job, to(Facts)]),
        "ahd_tiles_leaf_of": (status, [job, to(Array), pointer]),
        "ahd_tiles_cells": (status, [job, u64, to(Places), to(u64)]),
        "ahd_tiles_lines": (status, [job, pointer, pointer, u64, u64, i32]),
        "ahd_tiles_visit": (status, [job, u64, to(Array), pointer]),
        "ahd_tiles_merge": (status, [job, u64, to(Bytes), u64]),
        "ahd_tiles_triangles": (status, [job, u64, to(Array), pointer, to(Bytes), to(Bytes), u64]),
        "ahd_tiles_list": (status, [job, u64, to(Bytes), u64]),
        "ahd_tiles_surface": (status, [job, u64, to(Array), pointer, to(Bytes), to(Bytes), u64]),
        "ahd_say": (u64, [job, i32, i32, to(Fact), u64, pointer, u64]),
        "ahd_name": (name, [i32, u32]),
        "ahd_status_name": (name, [status]),
        "ahd_processors": (u32, []),
        "ahd_available_memory": (u64, []),
        "ahd_fingerprint": (None, [pointer, u64, u64, to(u64)]),
    }


def _file_name() -> str:
    if sys.platform == "win32":
        return "adaptivehilbertdelaunay.dll"
    return "libadaptivehilbertdelaunay." + ("dylib" if sys.platform == "darwin" else "so")


def library_path() -> str:
    """Where the library is looked for: in the package's last folder (see editable.py.in)."""
    return os.environ.get(LIBRARY_VARIABLE) or os.path.join(os.path.abspath(_folders[-1]), _file_name())


def _load(path: str) -> Tuple[ctypes.CDLL, ctypes.PyDLL]:
    """C and Held."""
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(
            "adaptivehilbertdelaunay: its library cannot be loaded (%s). `pip install .` builds it; the variable %s "
            "names another." % (error, LIBRARY_VARIABLE)
        ) from error
    try:
        found = library.ahd_abi_version()
    except AttributeError as error:
        raise ImportError("%s is not the library of adaptivehilbertdelaunay" % path) from error
    if found != ABI_VERSION:
        raise ImportError(
            "adaptivehilbertdelaunay: %s has version %d of the C interface, but version %d is needed"
            % (path, found, ABI_VERSION)
        )
    signatures = _signatures()
    for name in signatures:
        if getattr(library, name, None) is None:
            raise ImportError("adaptivehilbertdelaunay: %s has no function %s: it is of another build" % (path, name))
    held = ctypes.PyDLL(path, handle=library._handle)
    for name, (result, arguments) in signatures.items():
        for function in (getattr(library, name), getattr(held, name)):
            function.restype, function.argtypes = result, arguments
    return library, held


#: The functions of the library, twice: the GIL is released while one of the first is at work, and kept while one of the
#: second is, which must end soon: nothing of Python's happens meanwhile, callbacks excepted.
C, Held = _load(library_path())


def version() -> str:
    """The version of the project that the library was built from, like "1.0.0"."""
    return str(C.ahd_version().decode())


__version__ = version()


def processors() -> int:
    """Processors that this process may run on; at least 1."""
    return int(C.ahd_processors())


#: Of these environment variables the first that has a number says how many threads there are where `threads` is 0.
THREADS_VARIABLES = ("ADAPTIVEHILBERTDELAUNAY_THREADS", "VTK_SMP_MAX_THREADS", "OMP_NUM_THREADS")


def threads_in(environment: Mapping[str, str]) -> int:
    """What the first of the variables with a number says; 0: none has one."""
    # OpenMP's may be a list
    texts = (environment.get(name, "").partition(",")[0].strip() for name in THREADS_VARIABLES)
    return next((int(text) for text in texts if text.isdecimal()), 0)


_told = threads_in(os.environ)


def threads_told() -> int:
    """What the environment said when this was loaded, but not more than processors(); 0: nothing, so one for each of
    these."""
    return min(_told, processors(), 1024) if _told else 0


def threads_for(wished: int) -> int:
    """The setting `threads`, for a keyword: as wished; 0: as the environment says."""
    return wished or threads_told()


def available_memory() -> int:
    """Bytes that this process can still get without swapping."""
    return int(C.ahd_available_memory())


@functools.lru_cache(None)
def names(kind: int) -> Tuple[str, ...]:
    """All names of one kind: INT_SETTINGS, DOUBLE_SETTINGS, INPUT_ARRAYS, COUNTS, MEASURES or OUTPUT_ARRAYS."""
    found: List[str] = []
    while True:
        name = C.ahd_name(kind, len(found))
        if name is None:
            return tuple(found)
        found.append(name.decode())


@functools.lru_cache(64)
def array_type(kind: Any, count: int) -> Any:
    """The type of a C array; ctypes forgets those that nobody holds, and makes another one each time."""
    return kind * count


_addressof = ctypes.addressof
_byte_of: Any = ctypes.c_char.from_buffer  # for mypy an array is no buffer


def address_of(array: np.ndarray) -> int:
    """Where its numbers begin. NumPy's own way to say it, the last one, takes three times as long; the other one is for
    arrays that may be written without a warning."""
    flags = array.flags
    if flags.owndata and flags.writeable and flags.c_contiguous and array.size:
        return _addressof(_byte_of(array))
    return int(array.ctypes.data)


def described(name: str, array: np.ndarray) -> Array:
    """How an input array lies in memory."""
    number, flat = TYPES.get(array.dtype), array.ndim == 1
    if number is None or not array.flags.aligned or array.ndim not in (1, 2):
        raise BadInput("%s: an array of %d dimensions and type %s" % (name, array.ndim, array.dtype.str), BAD_ARRAY)
    return Array(
        address_of(array) if array.size else None,
        number,
        1 if flat else array.shape[1],
        array.shape[0],
        array.strides[0],
        array.itemsize if flat else array.strides[1],
    )


def _fact(name: str, value: Any) -> Fact:
    text, number = value if isinstance(value, tuple) else (value, 0) if isinstance(value, str) else (None, value)
    written = None if text is None else text.encode(errors="surrogateescape")
    return Fact(name.encode(), written, 0 if isinstance(number, float) else int(number), float(number))


def say(topic: int, words: int, facts: Mapping[str, Any], job: Any = None) -> Dict[str, str]:
    """The messages by their names, in order: see ahd_say. `facts`: numbers, texts, tuples of both,
    or lists of these; `job`: a Job whose counts are facts, too."""
    lists = {name: value if isinstance(value, list) else [value] for name, value in facts.items()}
    rows = [_fact(name, one) for name, each in lists.items() for one in each]
    given = array_type(Fact, len(rows))(*rows) if rows else None
    handle, count = job and job._handle, len(rows)
    needed = Held.ahd_say(handle, topic, words, given, count, None, 0)
    if needed == 1:
        return {}
    out = ctypes.create_string_buffer(needed)
    if needed == 0 or Held.ahd_say(handle, topic, words, given, count, out, needed) != needed:
        raise MemoryError
    said = out.raw[: needed - 1].decode(errors="surrogateescape").split("\0")
    return dict(zip(said[::2], said[1::2]))


def status_name(status: int) -> str:
    """The name of a status in the header, like "AHD_BAD_VALUE"."""
    return str(C.ahd_status_name(status).decode())


_TwoWords = ctypes.c_uint64 * 2


def fingerprint(array: np.ndarray, kind: int = 0, address: Optional[int] = None) -> Tuple[int, int]:
    """128 bits that differ, in practice always, where the numbers of the array or `kind` do; the same however they lie
    in memory. They are copied in small parts where they do not lie side by side. `address`: theirs, if it is known."""
    made = _TwoWords(kind, 0)
    rows = 1 << 13
    if address is not None and len(array) <= rows and array.flags.c_contiguous:
        Held.ahd_fingerprint(address, array.nbytes, kind, made)
        return made[0], made[1]
    for begin in range(0, max(1, len(array)), rows):
        part = np.ascontiguousarray(array[begin : begin + rows])
        C.ahd_fingerprint(address_of(part), part.nbytes, made[0] ^ made[1], made)
    return made[0], made[1]
