# SPDX-License-Identifier: BSD-3-Clause
"""What callers of `delaunay` give, as arrays and settings of a job. What cannot be used is named."""

from __future__ import annotations

import operator
import re
from typing import Any, Callable, Dict, Literal, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _library as library
from ._geometry import HasGeometry, ring_of
from ._held import anchor
from ._interface import SAY_REFUSAL, WORDS_OF_NUMPY, say
from ._keywords import KEYWORDS
from ._names import value_of
from ._raster import has_mask, real_numbers, table_of

Plane = Union[
    Literal["xy", "automatic", "best_fit"], np.ndarray, Sequence[Sequence[float]],
    Callable[[np.ndarray], Optional[np.ndarray]],
]  # fmt: skip
Corners = Union[np.ndarray, Sequence[Sequence[float]], HasGeometry, Mapping[str, Any]]  # of a polygon
Chains = Tuple[np.ndarray, Optional[np.ndarray]]  # ids, and where each chain begins if they are one list
Fingerprint = Dict[str, Tuple[int, int]]  # of each array that the caller can change

#: The defaults of keywords that are one number or word each.
DEFAULTS: Mapping[str, Any] = {name: row.default for name, row in KEYWORDS.items()}
#: The words of those that have some, in the order of the header's numbers.
CHOICES: Mapping[str, Tuple[str, ...]] = {name: row.words for name, row in KEYWORDS.items() if row.words}

_NAMES_HERE = {"line_ids": "segments or lines", "loop_ids": "loops", "skip": "marks of `skip`"}


def _refused(name: str, value: Any, wanted: str) -> str:
    text = repr(value)
    return "%s must be %s, not %s" % (name, wanted, text if len(text) <= 60 else text[:57] + "...")


def _choice(name: str, value: Any) -> int:
    among = CHOICES[name]
    value = value_of(name, value)
    if not isinstance(value, str) or value not in among:
        kind = ValueError if isinstance(value, str) else TypeError
        raise kind(_refused(name, value, "one of " + ", ".join(map(repr, among))))
    return among.index(value)


def _flag(name: str, value: Any) -> int:
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(_refused(name, value, "True or False"))
    return int(value)


_BASES = (("B", 1000), ("IB", 1024))
_UNITS = {"": 1, **{unit + end: base**k for k, unit in enumerate("KMGT", 1) for end, base in _BASES}}


def bytes_of(value: Any) -> Any:
    """The number of a text such as '2 GB' or '1.5 GiB'; anything else as it is."""
    found = re.fullmatch(r"\s*(\d{1,30}(?:\.\d*)?)\s*([A-Za-z]*)\s*", value) if isinstance(value, str) else None
    unit = None if found is None else _UNITS.get(found[2].upper())
    return value if found is None or unit is None else int(float(found[1]) * unit)


def _whole(name: str, value: Any) -> int:
    least, most = KEYWORDS[name].least, KEYWORDS[name].most
    of = " of bytes, or a text such as '2 GB'," if name == "memory_limit" else ""
    wanted = "a whole number%s from %d to %d" % (of, least, most)
    value = bytes_of(value) if of else value
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(_refused(name, value, wanted))
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(_refused(name, value, wanted)) from None
    if not least <= number <= most:
        raise ValueError(_refused(name, value, wanted))
    return number


def real_of(name: str, value: Any, limits: Optional[Tuple[float, float]] = None) -> float:
    """A number within limits, those of this keyword if none are given. TypeError, ValueError."""
    least, most = limits or (KEYWORDS[name].least, KEYWORDS[name].most)
    wanted = "a number from %g to %g" % (least, most)
    if isinstance(value, (str, bytes, bool, np.bool_)):
        raise TypeError(_refused(name, value, wanted))
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(_refused(name, value, wanted)) from None
    except OverflowError:
        raise ValueError(_refused(name, value, wanted)) from None
    if not least <= number <= most:  # NaN neither
        raise ValueError(_refused(name, value, wanted))
    return number


def _converted(name: str, value: Any) -> Union[int, float]:
    row = KEYWORDS[name]
    convert: Callable[[str, Any], Union[int, float]] = (
        _choice if row.words else _flag if row.least is None else _whole if isinstance(row.least, int) else real_of
    )
    return convert(name, value)


_USUAL = {row.setting: _converted(name, row.default) for name, row in KEYWORDS.items()}


def settings_of(given: Mapping[str, Any]) -> Dict[str, Union[int, float]]:
    """The settings of a job for keywords that are one number or word each; the defaults of others."""
    made = _USUAL.copy()
    for name, value in given.items():
        usual = DEFAULTS[name]
        if value is not usual and (type(value) is not type(usual) or value != usual):
            made[KEYWORDS[name].setting] = _converted(name, value)
    return made


# --- Arrays -------------------------------------------------------------------------------------------------


_FLOATS = frozenset((np.dtype(np.float32), np.dtype(np.float64)))


def points_of(name: str, given: Any) -> np.ndarray:
    """(n, 2 or 3) float32 or float64, the given array itself if it is that: any strides, but in the machine's
    byte order and aligned. Of a table the columns x, y and z."""
    if has_mask(given):
        raise TypeError("%s are a masked array, whose mask would be lost: give %s.data, and "
                        "skip=%s.mask.any(axis=1)" % (name, name, name))  # fmt: skip
    points = np.asarray(table_of(given, "xyz"))
    if points.size == 0 and points.ndim == 1:
        points = points.reshape(0, 2)
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        hint = ": take its transpose, .T" if points.ndim == 2 and len(points) in (2, 3) else ""
        hint = ": name its columns x, y and z" if hasattr(given, "columns") else hint
        hint = ": take .get_coordinates(include_z=True)" if hasattr(given, "__geo_interface__") else hint
        raise ValueError("%s must be of shape (n, 2) or (n, 3), not %s%s" % (name, points.shape, hint))
    if points.dtype.kind not in "biuf" and points.size:
        raise TypeError("%s must be real numbers, not of type %s" % (name, points.dtype))
    isReady = points.dtype in _FLOATS and points.flags.aligned  # which are of the machine's byte order
    return points if isReady else np.array(points, np.float64)


def with_heights(points: Any, heights: Any) -> np.ndarray:
    """(n, 3): points with a z each. A copy."""
    places = points_of("points", points)
    if places.shape[1] != 2:
        raise ValueError("heights are the z of points of shape (n, 2), not %s: give points[:, :2]" % (places.shape,))
    z = real_numbers("heights", heights)
    if z.shape != (len(places),):
        raise ValueError("heights must have one number for each of %d points, not the shape %s" % (
            len(places), z.shape))  # fmt: skip
    return np.column_stack((places, z))


def marks_of(name: str, given: Any, count: int) -> np.ndarray:
    """(count,) uint8, not 0 for marked points."""
    if has_mask(given):
        raise TypeError("%s is a masked array, whose mask would be lost" % name)
    marks = np.asarray(given)
    if marks.shape != (count,):
        raise ValueError("%s must have one value for each of %d points, not the shape %s" % (name, count, marks.shape))
    if marks.dtype == np.bool_:
        return marks.view(np.uint8)
    if marks.dtype == np.uint8:
        return marks
    if marks.size == 0:
        return np.zeros(0, np.uint8)
    raise TypeError("%s must be of type bool or uint8, not %s" % (name, marks.dtype))


def polygon_of(name: str, given: Any) -> np.ndarray:
    """(n, 2) float64, a copy: corners at which Voronoi cells can be clipped. TypeError, ValueError."""
    corners = np.array(real_numbers(name, ring_of(name, given)))
    if corners.ndim != 2 or corners.shape[1] != 2:
        raise ValueError(_refused(name, given, "%s or corners, of shape (n, 2); of a box two" % (
            ", ".join(map(repr, CHOICES["voronoi_clip"])))))  # fmt: skip
    job = library.take_job()
    try:
        job.set(voronoi_clip=library.CLIP_POLYGON, want_voronoi=1)
        job.set_array("voronoi_polygon", corners)
        job.run()
    except library.BadInput as error:
        raise ValueError(str(error).replace('"voronoi_polygon"', name)) from None
    finally:
        library.give_back(job)
    return corners


_CHAINS = "a chain of ids of points, rows of an array, or a sequence of chains"


def _no_ids(name: str, wanted: str) -> ValueError:
    return ValueError("%s must be %s; coordinates go to constraints" % (name, wanted))


def _ids(name: str, given: Any, wanted: str = _CHAINS) -> np.ndarray:
    """int32 or int64 of any shape."""
    if has_mask(given):
        raise TypeError("%s: a masked array, whose mask would be lost" % name)
    try:
        ids = np.asarray(given)
    except ValueError:  # lists of unlike lengths
        raise _no_ids(name, wanted) from None
    if ids.size == 0:
        return ids.astype(np.int64)
    if ids.dtype == object:  # of these an older NumPy makes one
        raise _no_ids(name, wanted)
    if ids.dtype.kind not in "iu":
        hint = ": coordinates go to constraints" if ids.dtype.kind == "f" else ""
        raise TypeError("%s must be whole numbers, the ids of points, not of type %s%s" % (name, ids.dtype, hint))
    if ids.dtype.kind == "u" and ids.dtype.itemsize == 8 and int(ids.max()) >= 2**63:  # NumPy 1 compares doubles
        raise ValueError("%s: %d is not the id of a point" % (name, ids.max()))
    isReady = ids.dtype in (np.int32, np.int64) and ids.dtype.isnative and ids.flags.aligned
    return ids if isReady else ids.astype(np.int64)


def chains_of(name: str, given: Any) -> Chains:
    """One chain (a list of ids), many of one length (rows of an array), or a sequence of chains."""
    if not isinstance(given, np.ndarray) or given.dtype == object:
        given = list(given) if hasattr(given, "__iter__") else given
        if isinstance(given, list) and given and all(np.ndim(chain) == 1 for chain in given):
            if len({len(chain) for chain in given}) > 1 or 0 in map(len, given):
                return _joined([_ids("%s[%d]" % (name, k), chain) for k, chain in enumerate(given)])
    ids = _ids(name, given)
    if ids.ndim == 1:
        return ids, np.array([0, len(ids)], np.int64) if len(ids) else np.zeros(1, np.int64)
    if ids.ndim != 2:
        raise _no_ids(name, _CHAINS)
    return (ids, None) if ids.shape[1] > 1 else _joined(list(ids))


def segments_of(name: str, given: Any) -> Chains:
    """(m, 2)."""
    ids = _ids(name, given, "pairs of ids of points, of shape (m, 2)")
    if ids.ndim == 1 and ids.size == 0:
        ids = ids.reshape(0, 2)
    if ids.ndim != 2 or ids.shape[1] != 2:
        raise ValueError("%s must be of shape (m, 2), not %s" % (name, ids.shape))
    return ids, None


def _joined(chains: Sequence[np.ndarray]) -> Chains:
    offsets = np.zeros(len(chains) + 1, np.int64)
    np.cumsum([len(chain) for chain in chains], out=offsets[1:])
    return np.concatenate([np.asarray(chain, np.int64) for chain in chains] or [np.zeros(0, np.int64)]), offsets


def appended(first: Chains, second: Chains) -> Chains:
    """The chains of both."""
    parts = [list(ids) if offsets is None else np.split(ids, offsets[1:-1]) for ids, offsets in (first, second)]
    return _joined([chain for part in parts for chain in part])


def check_ids(name: str, chains: Chains, count: int, whose: str) -> None:
    """ValueError if an id is that of no point."""
    ids, offsets = chains
    if not ids.size or (ids.min() >= 0 and ids.max() < count):
        return
    place = int(np.flatnonzero(((ids < 0) | (ids >= count)).ravel())[0])
    if offsets is None:
        chain = place // ids.shape[1]
    else:
        chain = int(np.searchsorted(offsets, place, "right")) - 1
    raise ValueError(
        "%s[%d] names point %d, but there are %d points%s" % (name, chain, ids.ravel()[place], count, whose)
    )


# --- All of it ----------------------------------------------------------------------------------------------


PLANES = ("xy", "automatic", "best_fit")
_PLANES = "%r, %r, %r, a (4, 4) matrix or a function" % PLANES


def chosen_plane(points: np.ndarray, skip: Optional[np.ndarray], threads: int) -> int:
    """Of plane='automatic': PLANE_BEST_FIT for points that stand like a wall, else PLANE_XY."""
    job = library.Job()
    job.set(threads=library.threads_for(threads))
    job.set_array("points", points)
    if skip is not None:
        job.set_array("skip", skip)
    return job.choose_plane()


def _is_shown(array: np.ndarray, given: Any) -> bool:
    """May the array lie in memory of what was given? Frames, buffers and others may show their own numbers; they are
    not asked for these again, which a file that is read, or a graph that is computed, would be."""
    if isinstance(given, np.ndarray):
        return bool(np.may_share_memory(array, given))
    return not isinstance(given, (list, tuple))


def refuse_conflict(limit: Any, alpha: Any, duplicates: Any, *simplified: Any) -> None:
    """ValueError for settings that exclude a simplified surface: that of the others, if one is not 0."""
    facts = {"limit": limit, "alpha": alpha, "mean": duplicates == library.DUPLICATES_MEAN_Z}
    found = ["conflict_with_" + name for name, holds in facts.items() if holds]
    if found and any(simplified):
        (text,) = say(SAY_REFUSAL, WORDS_OF_NUMPY, {"conflict": 1, found[0]: 1}).values()
        raise ValueError(text)


_CONFLICT = ("insertion_limit", "alpha", "duplicates", "maximum_error", "maximum_vertices")


class Request:
    """Settings and arrays of a job. Never changes once it is made, but for the numbers in arrays that are the caller's:
    `fingerprint` tells whether they did."""

    def __init__(
        self,
        points: Any,
        skip: Any,
        source_points: Any,
        chains: Mapping[str, Any],
        plane: Plane,
        settings: Mapping[str, Any],
    ) -> None:
        clip = settings.get("voronoi_clip", "hull")
        self.arrays: Dict[str, np.ndarray] = {}
        self.settings = settings_of(settings if isinstance(clip, str) else {**settings, "voronoi_clip": "hull"})
        if not isinstance(clip, str):
            self.arrays["voronoi_polygon"] = polygon_of("voronoi_clip", clip)
            self.settings["voronoi_clip"] = library.CLIP_POLYGON
        refuse_conflict(*map(self.settings.get, _CONFLICT))
        self._shared: Dict[str, Any] = {}  # those in memory of the caller's: what keeps it where it is
        self._described: Dict[str, library.Array] = {}  # how they lie in memory
        self.projection: Optional[Callable[[np.ndarray], None]] = None
        self.plane_was_chosen = False  # 'automatic' took the best-fitting one
        self._take("points", points_of("points", points), points)
        if skip is not None:
            self._take("skip", marks_of("skip", skip, len(self.points)), skip)
        if source_points is not None:
            self._take("source_points", points_of("source_points", source_points), source_points)
            self.settings["cell_ids"] = library.IDS_OF_SOURCE
        elif self.settings["source_heights"] != library.HEIGHTS_OWN:
            words = CHOICES["source_heights"]
            raise ValueError("source_heights=%r needs source_points" % words[int(self.settings["source_heights"])])
        elif self.settings["points_as_line"]:
            raise ValueError("points_as_line needs source_points")
        self._take_chains(chains)
        self._take_plane(plane)

    def _take(self, name: str, array: np.ndarray, given: Any) -> None:
        """A view, with its own shape, of the array made of an argument."""
        if _is_shown(array, given):
            self._shared[name] = anchor(array)
            self._described[name] = library.described(name, array)
            array = array.view()
        self.arrays[name] = array

    def __getstate__(self) -> Dict[str, Any]:
        """A copy has memory of its own; its numbers are compared all the same."""
        return {**self.__dict__, "_shared": dict.fromkeys(self._shared), "_described": {}}

    def changed(self, given: Mapping[str, Any], numbers: Mapping[str, np.ndarray]) -> Request:
        """The same with these keywords and numbers of points. Nothing is copied."""
        made = object.__new__(Request)
        made.__dict__.update(self.__dict__)
        made.settings = {**self.settings, **{KEYWORDS[name].setting: _converted(name, given[name]) for name in given}}
        refuse_conflict(*map(made.settings.get, _CONFLICT))
        made.arrays = {**self.arrays, **numbers}
        made._described = {}
        return made

    def fingerprint(self) -> Fingerprint:
        """Of all arrays that the caller can change."""
        return {name: self._numbers_of(name) for name in self._shared}

    def _numbers_of(self, name: str) -> Tuple[int, int]:
        return library.fingerprint(self.arrays[name], address=self._laid_out(name).data)

    def _laid_out(self, name: str) -> library.Array:
        """How an array lies in memory."""
        made = self._described.get(name)
        if made is None:
            made = self._described[name] = library.described(name, self.arrays[name])
        return made

    def first_changed(self, before: Fingerprint) -> str:
        """The caller's name of the first array whose numbers have changed; empty if none has."""
        for name, numbers in before.items():
            if self._numbers_of(name) != numbers:
                return _NAMES_HERE.get(name, name)
        return ""

    @property
    def points(self) -> np.ndarray:
        return self.arrays["points"]

    @property
    def columns(self) -> int:
        """2, or 3 if a point was given three numbers."""
        source = self.arrays.get("source_points")
        return max(int(array.shape[1]) for array in (self.points, source) if array is not None)

    @property
    def z(self) -> np.ndarray:
        """(n,) float64: of all points that were given, those of source_points behind the others."""
        given = [array for array in (self.points, self.arrays.get("source_points")) if array is not None]
        made = [array[:, 2] if array.shape[1] == 3 else np.zeros(len(array)) for array in given]
        return np.concatenate(made).astype(np.float64)

    def _take_chains(self, given: Mapping[str, Any]) -> None:
        source = self.arrays.get("source_points")
        count, whose = (len(self.points), "") if source is None else (len(source), " in source_points")
        lines: Optional[Chains] = None
        ofLines: Any = ()
        for name, value in given.items():
            if value is None:
                continue
            chains = segments_of(name, value) if name == "segments" else chains_of(name, value)
            check_ids(name, chains, count, whose)
            own = value if name == "segments" or isinstance(value, np.ndarray) else ()  # else chains_of() copied it
            if name == "loops":
                self._set_chains("loop", chains, own)
            elif lines is None:
                lines, ofLines = chains, own
            else:
                lines, ofLines = appended(lines, chains), ()
        if lines is not None:
            self._set_chains("line", lines, ofLines)

    def _set_chains(self, kind: str, chains: Chains, given: Any) -> None:
        ids, offsets = chains
        if ids.size:
            self._take(kind + "_ids", ids, given)
            if offsets is not None:
                self.arrays[kind + "_offsets"] = offsets

    def _take_plane(self, plane: Plane) -> None:
        if isinstance(plane, str):
            plane = value_of("plane", plane)
            if plane not in PLANES:
                raise ValueError(_refused("plane", plane, _PLANES))
            self.settings["plane"] = library.PLANE_XY if plane == "xy" else library.PLANE_BEST_FIT
            if plane == "automatic":
                threads = int(self.settings["threads"])
                self.settings["plane"] = chosen_plane(self.points, self.arrays.get("skip"), threads)
                self.plane_was_chosen = self.settings["plane"] == library.PLANE_BEST_FIT
        elif callable(plane):
            self.settings["plane"] = library.PLANE_CALLBACK
            self.projection = Projection(plane)
        else:
            matrix = np.asarray(plane)
            if matrix.shape != (4, 4) or matrix.dtype.kind not in "iuf":
                raise ValueError(_refused("plane", plane, _PLANES))
            if not np.isfinite(matrix).all():
                raise ValueError("plane: the matrix has numbers that are not finite")
            self.settings["plane"] = library.PLANE_MATRIX
            self.arrays["matrix"] = np.array(matrix, np.float64)
        if self.settings["bounding"] and self.settings["plane"] != library.PLANE_XY:
            raise ValueError("bounding points are added in the plane 'xy' only")

    def job(self, wanted: Sequence[str]) -> library.Job:
        """A job that is ready to run, with these arrays announced."""
        job = library.take_job()
        usual = library.defaults()
        settings = {**self.settings, "threads": library.threads_for(int(self.settings["threads"]))}
        settings = {name: value for name, value in settings.items() if value != usual[name]}
        job.set(**settings, **{"want_" + name: 1 for name in wanted})
        for name, array in self.arrays.items():
            job.set_array(name, array, self._laid_out(name))
        if self.projection is not None:
            job.set_projection(self.projection)
        return job


class Projection:
    """A caller's function of points as a job calls it."""

    def __init__(self, function: Callable[[np.ndarray], Optional[np.ndarray]]) -> None:
        self.function = function

    def __call__(self, xyz: np.ndarray) -> None:
        moved = self.function(xyz)
        if moved is not None and moved is not xyz:
            moved = np.asarray(moved)
            if moved.shape != xyz.shape:
                raise ValueError(
                    "plane: the function returned an array of shape %s for points of shape %s"
                    % (moved.shape, xyz.shape)
                )
            xyz[...] = moved
