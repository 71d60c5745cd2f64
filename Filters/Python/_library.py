# SPDX-License-Identifier: BSD-3-Clause
"""The C interface of the engine (Filters/Engine/Interface/ahd.h), as Python has it.

A `Job` has the settings, the input and, after `run`, the result. Names of settings, arrays, counts and
measures are those of the header, which describes them. Arrays are NumPy's, errors are exceptions.
The constants, errors and functions of `_interface` can be had from here too.
"""

from __future__ import annotations

import contextlib
import ctypes
import functools
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Set, Tuple, Union

import numpy as np

from ._interface import *  # noqa: F403
from ._interface import (
    AT_CROSSINGS, AT_SURFACE, BAD_ARRAY, COUNTS, DOUBLE_SETTINGS, ERRORS, FIXED_DTYPES, INT_SETTINGS, MEASURES,
    OK, OUTSIDE_NO_VALUE, SAMPLE_LINEAR, TYPES, Array, BadInput, C, Drawing, Fault, Held,
    OutlineReport, Places, Sampled, address_of, array_type, described, names, status_name,
)  # fmt: skip
from ._calls import AT_WORK as _at_work
from ._calls import NO_PROGRESS, NO_PROJECTION, PROGRESS, PROJECTION, busy, end_with_the_program, make_call
from ._held import NO_HANDLE, Handle, anchor
from ._raster import Raster, Samples


# --- Jobs ---------------------------------------------------------------------------------------------------
ProgressFunction = Callable[[int, float], Any]
ProjectionFunction = Callable[[np.ndarray], Any]
Number = Union[int, float]
FEW = 256  #: points or places: work on so many mostly ends within 0.1 ms, on the worst in 50
FEW_NUMBERS = 16 * FEW  #: of results, written in such a time
FEW_BYTES = 1 << 20  #: without a limit, results of so many need not be counted before there is memory for them
NO_MASK = np.empty(0, np.uint8)

_PLAIN = frozenset(("points", "skip", "matrix", "voronoi_polygon"))  # no constraints
_INTS = frozenset(names(INT_SETTINGS))
_DOUBLES = frozenset(names(DOUBLE_SETTINGS))


class Job:
    """Settings, input and result; see ahd_job in the header.

    For one thread at a time; several jobs may be at work in several threads at once. `cancel` alone may be
    called by another thread, or from a callback.

    An exception of a callback cancels the call and is raised by it, and so is KeyboardInterrupt: Ctrl-C works
    while the library does.

    Raises
    ------
    BadInput (a ValueError), OutOfMemory (a MemoryError), Cancelled, NotAvailable and Fault (RuntimeErrors):
    all are EngineErrors and have a `status`.
    """

    isLost = False  #: has it nothing, as it was at work in another thread when the process was forked?
    wasCancelled = False  #: perhaps the next call will hear of it
    hasTables = False  #: has the library all that it needs of the input to find places?
    _raised: Optional[BaseException] = None
    _progress: Optional[ProgressFunction] = None
    _projection: Optional[ProjectionFunction] = None
    _hears: Optional[float] = None  # of progress, after so many seconds
    _isLimited = False  # is there a memory_limit?
    _how: Optional[Tuple[int, int]] = (SAMPLE_LINEAR, OUTSIDE_NO_VALUE)  # that are set, if they are known
    _sampledBy = -1  # the method that is ready
    _rows = -1  # of results for points, where they have been counted

    def __init__(self, handle: Optional[Handle] = None) -> None:
        """Of a new job of the library, or of one that was handed on."""
        self._handle = Handle() if handle is None else handle
        self._arrays: Dict[str, Any] = {}  # owners of the memory that the library reads
        self._long: Set[str] = set()  # inputs with which a run may take long; without, it is one of a few points

    def _forget(self) -> None:
        """There is no result, or another one."""
        self.hasTables, self._sampledBy, self._rows = False, -1, -1

    def hand_on(self) -> Handle:
        """The library's job, taken out of this one, which is of no use any more."""
        handle, self._handle = self._handle, NO_HANDLE
        return handle

    def begin_anew(self) -> None:
        """With a new job of the library. The one before may be at work for ever, and is not freed."""
        self._handle.abandon()
        self.__dict__.clear()
        self.__init__()  # type: ignore[misc]
        self.isLost = True

    # --- calls ---

    def _check(self, status: int) -> None:
        if status != OK:
            message = Held.ahd_message(self._handle).decode() or status_name(status)
            raise ERRORS.get(status, Fault)(message, status)

    def _hear(self, wanted: Optional[float]) -> None:
        """Of progress, after so many seconds. Callbacks take the GIL."""
        if wanted != self._hears:
            self._hears = -1.0  # if this is interrupted
            function = NO_PROGRESS if wanted is None else PROGRESS
            self._check(Held.ahd_set_progress(self._handle, function, self._handle))
            self._check(Held.ahd_set_double(self._handle, b"progress_delay", wanted or 0.0))
            self._hears = wanted

    def refuse_if_busy(self) -> None:
        """NotAvailable during a call, which is that of a progress function."""
        if self._handle.address in _at_work:
            raise busy()

    def _call(self, name: str, *arguments: Any, arrays: Sequence[np.ndarray] = (), isBrief: bool = False) -> None:
        """A call that may take long, unless it `isBrief`: then nothing of Python's happens meanwhile, and Ctrl-C waits
        for its end. `arrays`: those of callers whose addresses are among the arguments."""
        if isBrief and self._progress is None:
            self.refuse_if_busy()
            end_with_the_program()
            self._hear(None)
            status = getattr(Held, name)(self._handle.address, *arguments)
        else:
            status = make_call(self, getattr(C, name), arguments, arrays)
        self._check(status)

    # --- settings ---

    def set(self, **settings: Number) -> None:
        """Changes settings, whole numbers (True and False too) and others by their names."""
        for name, value in settings.items():
            if name in _DOUBLES:
                self._check(Held.ahd_set_double(self._handle, name.encode(), float(value)))
            else:
                number = value.__index__() if hasattr(value, "__index__") else None
                if number is None and name in _INTS:
                    raise TypeError("%s must be a whole number, not %r" % (name, value))
                if number is not None and not -(1 << 63) <= number < 1 << 63:
                    raise BadInput("%s: %d is out of range" % (name, number))
                self._check(Held.ahd_set_int(self._handle, name.encode(), number or 0))
                self._isLimited = number != 0 if name == "memory_limit" else self._isLimited

    def get(self, name: str) -> Number:
        """The value of a setting."""
        value: Any
        if name in _DOUBLES:
            value = ctypes.c_double()
            self._check(Held.ahd_get_double(self._handle, name.encode(), value))
        else:
            value = ctypes.c_int64()
            self._check(Held.ahd_get_int(self._handle, name.encode(), value))
        return value.value  # type: ignore[no-any-return]

    # --- input ---

    def set_array(self, name: str, array: Optional[np.ndarray], given: Optional[Array] = None) -> None:
        """An input array of one or two dimensions; None takes it away. It is not copied, and must stay unchanged until
        another one takes its place; its memory stays where it is. Any strides; the types are those of the header, in
        the machine's byte order, aligned. `given`: described(array), if there is one."""
        if array is None:
            self._forget()
            self._check(Held.ahd_set_array(self._handle, name.encode(), None))
            self._arrays.pop(name, None)
            self._long.discard(name)
            return
        given = given or described(name, array)
        self._forget()
        self._long.add(name)
        before, now = self._arrays.get(name), anchor(array)
        self._arrays[name] = (before, now)  # whichever of them the library has if this is interrupted
        status = Held.ahd_set_array(self._handle, name.encode(), given)
        self._arrays[name] = now if status == OK else before
        if self._arrays[name] is None:
            del self._arrays[name]
        self._check(status)
        if name in _PLAIN and given.rows <= FEW:
            self._long.discard(name)

    def set_projection(self, projection: Optional[ProjectionFunction]) -> None:
        """For PLANE_CALLBACK: a function that is given (k, 3) float64, points, and changes them in place to
        where they lie in the plane and their height above it. None takes it away."""
        function = NO_PROJECTION if projection is None else PROJECTION
        self._long.add("projection")
        self._check(Held.ahd_set_projection(self._handle, function, self._handle))
        self._projection = projection
        if projection is None:
            self._long.discard("projection")

    def set_progress(self, progress: Optional[ProgressFunction]) -> None:
        """A function that is told the phase, a number of PHASES, and the fraction that is done, 0 to 1, by the
        thread that makes the call; a true result cancels. None: no calls."""
        self._progress = progress

    def reset(self, most: int) -> bool:
        """Makes the library's job as new, but for its memory: that is kept for the next run, unless it is more than
        `most` bytes. It is to be handed on then. False if it is at work, or may be cancelled still."""
        return C.ahd_reset(self._handle, most) == OK and not self.wasCancelled

    # --- running ---

    def estimate(self) -> int:
        """Upper estimate of the bytes that `run` and the arrays announced take, but for what shows meanwhile."""
        value = ctypes.c_uint64()
        self._check(C.ahd_estimate(self._handle, value))
        return value.value

    def run(self) -> None:
        """Triangulates. Discards the previous result."""
        self._forget()
        self._call("ahd_run", isBrief=not self._long)

    def cancel(self) -> None:
        """Ends the call that is at work, or else the next one. From any thread."""
        self.wasCancelled = True
        C.ahd_cancel(self._handle)

    def kept_bytes(self) -> int:
        """Bytes of working memory that are kept for the next run; those of a result not counted."""
        return int(C.ahd_kept_bytes(self._handle))

    def release(self, most: int = 0) -> None:
        """Drops the result. Its memory is kept for the next run, unless that would be more than `most` bytes."""
        self._forget()
        self._check(C.ahd_release(self._handle, most))

    def fit_plane(self) -> np.ndarray:
        """The plane that fits the points best, without a run: (4, 4), see plane_matrix."""
        matrix = np.empty((4, 4))
        self._call("ahd_fit_plane", address_of(matrix))
        return matrix

    def choose_plane(self) -> int:
        """PLANE_BEST_FIT if the points stand like a wall, else PLANE_XY: see ahd_choose_plane."""
        plane = ctypes.c_int64()
        self._call("ahd_choose_plane", plane)
        return plane.value

    def outline(self, report: Optional[OutlineReport] = None, directed: bool = False) -> OutlineReport:
        """Makes the outline of the array cells: outline_points, outline_rings, outline_polygons and outline_cells, see
        ahd_outline.h. What became of it goes to `report`, also where it fails. `directed`: see
        ahd_outline_directed."""
        made = OutlineReport() if report is None else report
        self._call("ahd_outline_directed" if directed else "ahd_outline", made)
        return made

    def within_radius(self, radius: float, count: int) -> np.ndarray:
        """Which of the array cells, so many triangles, are not too large: (count,) bool, see ahd_within_radius."""
        kept = np.zeros(count, np.bool_)
        self._call("ahd_within_radius", radius, address_of(kept), arrays=(kept,))
        return kept

    # --- results ---

    def count(self, name: str) -> int:
        """A count of the last run."""
        value = ctypes.c_int64()
        self._check(Held.ahd_count(self._handle, name.encode(), value))
        return value.value

    def measure(self, name: str) -> float:
        """A measure of the last run."""
        value = ctypes.c_double()
        self._check(Held.ahd_measure(self._handle, name.encode(), value))
        return value.value

    def counts(self) -> Dict[str, int]:
        """All counts of the last run."""
        return dict(zip(names(COUNTS), self.numbers(COUNTS)))

    def measures(self) -> Dict[str, float]:
        """All measures of the last run."""
        return dict(zip(names(MEASURES), self.numbers(MEASURES)))

    def numbers(self, kind: int) -> Any:
        """A ctypes array of all counts or measures, COUNTS or MEASURES, in the order of names(kind)."""
        function, of = (Held.ahd_counts, ctypes.c_int64) if kind == COUNTS else (Held.ahd_measures, ctypes.c_double)
        count = len(names(kind))
        made = array_type(of, count)()
        self._check(function(self._handle, made, count))
        return made

    def array_shape(self, name: str) -> Tuple[int, int]:
        """Rows and columns of an output array."""
        rows, columns = ctypes.c_uint64(), ctypes.c_uint64()
        self._check(Held.ahd_array_size(self._handle, name.encode(), rows, columns))
        return rows.value, columns.value

    def array(self, name: str, dtype: Any = None, out: Optional[np.ndarray] = None) -> np.ndarray:
        """An output array: of shape (rows,) if it is a list, else (rows, columns).

        `dtype`: int32, the default, or int64 for ids; float64, the default, or float32 for "points"; others have
        one type only. `out`: an array to be written, C-contiguous, of the right type and with room enough."""
        if out is None:
            rows, columns = self.array_shape(name)
            shape = (rows,) if columns == 1 else (rows, columns)
            out = np.empty(shape, dtype or FIXED_DTYPES.get(name, np.int32))
        number = TYPES.get(out.dtype)
        if number is None or not out.flags.c_contiguous:
            raise BadInput("%s: cannot be written into this array of type %s" % (name, out.dtype.str), BAD_ARRAY)
        _check_writeable(name, out)
        given = name.encode(), number, address_of(out), out.size
        isBrief = not self._long and out.size <= FEW_NUMBERS
        self._call("ahd_get_array", *given, arrays=(out,), isBrief=isBrief)
        return out

    def draw_order(self, xyz: np.ndarray, ranks: np.ndarray, ids: np.ndarray, levels: np.ndarray, counts: np.ndarray
                   ) -> None:
        """Writes the insertion order as it is drawn into these arrays: see ahd_drawing. They are C-contiguous, and as
        large as the counts drawn_points and drawn_cells say; ids are int32 or int64."""
        arrays = (xyz, ranks, ids, levels, counts)
        sizes = (3 * self.count("drawn_points"), *2 * (self.count("drawn_points"),), *2 * (self.count("drawn_cells"),))
        types: Tuple[Any, ...] = (np.float64, ids.dtype, ids.dtype, np.int32, ids.dtype)
        for name, array, size, dtype in zip(("xyz", "ranks", "ids", "levels", "counts"), arrays, sizes, types):
            if not array.flags.c_contiguous or array.dtype != dtype or array.size != size:
                raise BadInput("%s: must be %d numbers of type %s" % (name, size, np.dtype(dtype).str), BAD_ARRAY)
            _check_writeable(name, array)
        drawing = Drawing(*map(address_of, arrays))
        self._call("ahd_draw_order", TYPES[ids.dtype], drawing, arrays=arrays)

    def interpolate(self, values: np.ndarray, where: int = AT_SURFACE | AT_CROSSINGS) -> None:
        """Point data of points that lie between others, in place: `values` has one row of float64 for each
        output point, C-contiguous. See ahd_interpolate."""
        columns = 1 if values.ndim == 1 else values.shape[1]
        if values.dtype != np.float64 or not values.flags.c_contiguous or len(values) != self.count("points"):
            raise BadInput("values: one row of float64 for each of %d points" % self.count("points"), BAD_ARRAY)
        _check_writeable("values", values)
        self._call("ahd_interpolate", where, address_of(values), columns, arrays=(values,))

    def to_plane(self, xyz: np.ndarray) -> None:
        """Moves points, (k, 3) float64, C-contiguous, in place to their position in the plane: see ahd_to_plane."""
        if xyz.dtype != np.float64 or not xyz.flags.c_contiguous or xyz.shape[1:] != (3,):
            raise BadInput("points: of shape %s, not (k, 3) float64" % (xyz.shape,), BAD_ARRAY)
        _check_writeable("points", xyz)
        self._call("ahd_to_plane", address_of(xyz), len(xyz), arrays=(xyz,))

    def locate(self, places: np.ndarray, dtype: Any = np.int64) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Where places, (k, 2), lie in the plane: kinds (k,) int32, ids (k, 3) and cells (k,) of this type; see
        ahd_locate."""
        xy = np.ascontiguousarray(places, np.float64)
        if xy.ndim != 2 or xy.shape[1] != 2:
            raise BadInput("places: of shape %s, not (k, 2)" % (xy.shape,), BAD_ARRAY)
        count = len(xy)
        kinds, numbers = np.empty(count, np.int32), np.empty(4 * count, np.int64)
        begin = address_of(numbers)
        out = (address_of(kinds), begin, begin + 24 * count)
        self._call("ahd_locate", address_of(xy), count, *out, arrays=(xy,), isBrief=self._is_brief(count))
        self.hasTables = True
        numbers = numbers.astype(dtype, copy=False)
        return kinds, numbers[: 3 * count].reshape(count, 3), numbers[3 * count :]

    def _is_brief(self, places: int) -> bool:
        """Is looking up so many places?"""
        return places <= FEW and (self.hasTables or not self._long)

    def _sample_by(self, method: int, outside: int) -> None:
        if (method, outside) != self._how:
            self._how = None  # if this is interrupted
            self.set(sample_method=method, sample_outside=outside)
            self._how = (method, outside)

    @contextlib.contextmanager
    def _with_memory(self, bytes_given: int) -> Iterator[None]:
        """Counts memory for results of one call."""
        other = int(self.get("other_memory"))
        self.set(other_memory=min(other + bytes_given, 1 << 62))
        try:
            yield
        finally:
            self.set(other_memory=other)

    def sample(
        self,
        places: Union[np.ndarray, Raster],
        values: Sequence[np.ndarray],
        *,
        method: int = SAMPLE_LINEAR,
        outside: int = 0,
        gradients: bool = False,
        has_mask: bool = True,
        make: Optional[Callable[[int], Tuple[List[np.ndarray], List[Any], np.ndarray]]] = None,
    ) -> Samples:
        """Values at places, (k, 2) in the plane, or on a raster: see ahd_sample. `values`: arrays with one row of
        float64 for each output point, C-contiguous. `method`: SAMPLE_...; `outside`: OUTSIDE_...; `gradients`: with
        SAMPLE_LINEAR the slopes too; without `has_mask` the mask is empty. Memory is asked for when the library has
        said that it is enough, unless it is little: of make(places), which returns Samples to be filled."""
        at, count, owners = _places_of(places)
        if self._rows < 0:
            self._rows = self.count("points")
        for array in values:
            if array.dtype != np.float64 or not array.flags.c_contiguous or len(array) != self._rows:
                raise BadInput("values: one row of float64 for each of %d points" % self._rows, BAD_ARRAY)
        columns = [1 if array.ndim == 1 else array.shape[1] for array in values]
        numbers = sum(columns)
        self._sample_by(method, outside)
        isReady = self._sampledBy == SAMPLE_LINEAR or not self._long
        isLittle = count <= FEW and count * numbers <= FEW_NUMBERS
        isBrief = isLittle and self._how == (SAMPLE_LINEAR, OUTSIDE_NO_VALUE) and isReady

        def find() -> Samples:
            if make is not None:
                out, slopes, mask = make(count)
            else:
                out = [np.empty((count, n)) for n in columns]
                slopes = [np.empty((count, 2 * n)) if gradients else None for n in columns]
                mask = np.empty(count, np.uint8) if has_mask else NO_MASK
            arrays = array_type(Sampled, len(columns))()
            for one, array, n, to, slope in zip(arrays, values, columns, out, slopes):
                one.values, one.columns, one.out = address_of(array), n, address_of(to)
                one.gradients = None if slope is None else address_of(slope)
            marks = None if mask is NO_MASK else address_of(mask)
            given = at, arrays, len(columns), marks
            self._call("ahd_sample", *given, arrays=(*owners, *values), isBrief=isBrief)
            return Samples(out, slopes, mask)

        needed = count * (8 * numbers * (3 if gradients else 1) + 1)
        if needed <= FEW_BYTES and make is None and not self._isLimited:
            found = find()
        else:
            with self._with_memory(needed):
                self._check(C.ahd_sample_estimate(self._handle, at, numbers, ctypes.c_uint64()))
                found = find()
        self.hasTables = True
        self._sampledBy = method
        return found

    def sample_estimate_before(self, points: int, places: Union[int, Raster], columns: int, fills: bool) -> int:
        """Upper estimate of what sampling takes on a triangulation of so many points with its tables, at so many places
        or on a raster: see ahd_sample_estimate_before."""
        bytes_ = ctypes.c_uint64()
        at = _places_of(places)[0] if isinstance(places, Raster) else Places(None, places)
        self._check(C.ahd_sample_estimate_before(self._handle, points, at, columns, fills, bytes_))
        return bytes_.value

    def sample_weights(self, places: Union[np.ndarray, Raster], method: int = SAMPLE_LINEAR) -> None:
        """Makes the arrays weight_offsets, weight_points and weights: see ahd_sample_weights."""
        at, _, owners = _places_of(places)
        self._sample_by(method, OUTSIDE_NO_VALUE)
        self._call("ahd_sample_weights", at, arrays=owners)
        self.hasTables = True
        self._sampledBy = method


def _places_of(places: Union[np.ndarray, Raster]) -> Tuple[Places, int, Tuple[np.ndarray, ...]]:
    """Places as the library knows them, how many they are, and the arrays that they lie in."""
    if isinstance(places, Raster):
        rows, columns = places.shape
        at = Places(None, 0, places.origin, places.spacing, columns, rows)
        return at, rows * columns, ()
    xy = np.ascontiguousarray(places, np.float64)
    if xy.ndim != 2 or xy.shape[1] != 2:
        raise BadInput("places: of shape %s, not (k, 2)" % (xy.shape,), BAD_ARRAY)
    return Places(address_of(xy), len(xy)), len(xy), (xy,)


def _check_writeable(name: str, array: np.ndarray) -> None:
    if not array.flags.writeable:
        raise BadInput("%s: cannot be written into this array, which is read-only" % name, BAD_ARRAY)


@functools.lru_cache(None)
def defaults() -> Dict[str, Number]:
    """All settings of a new job."""
    job = Job()
    return {name: job.get(name) for name in (*_INTS, *_DOUBLES)}


# --- Jobs that have memory ----------------------------------------------------------------------------------

#: Most bytes that are kept for the next job.
REUSE_LIMIT = 1 << 28

_spare: List[Handle] = []  # at most one; each access is one step, so that threads need no lock


def take_job() -> Job:
    """A job with default settings, which has the memory of the last one that was given back."""
    try:
        return Job(_spare.pop())
    except IndexError:
        return Job()


def give_back(job: Job) -> None:
    """Keeps the memory of an unused job, at most REUSE_LIMIT bytes, for the next one: asking the
    system for it takes a tenth of the time of 10^6 points. The job has nothing after that; if it is at work, it keeps
    all."""
    if job.reset(REUSE_LIMIT):
        _spare.append(job.hand_on())
        del _spare[1:]


def release_memory() -> None:
    """Gives the memory that is kept for the next job back to the system."""
    _spare.clear()
