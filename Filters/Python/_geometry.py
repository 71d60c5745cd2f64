# SPDX-License-Identifier: BSD-3-Clause
"""Constraints that bring their own points: geometries of shapely, geopandas, GeoJSON and others (anything with
`__geo_interface__`), and rings as arrays of coordinates. What cannot be used is named."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Protocol, Sequence, Tuple

import numpy as np

WANTED = (
    "a geometry (shapely, geopandas, GeoJSON, anything with __geo_interface__), a ring as an array of shape (k, 2) or "
    "(k, 3), or a sequence of these"
)
#: Of each type its members, which are geometries: the name of the field.
_MEMBERS = {"Feature": "geometry", "FeatureCollection": "features", "GeometryCollection": "geometries"}
_NUMBERS = (int, float, np.number)


class Constraints(NamedTuple):
    """Points, and chains of their ids, in the order of the geometries."""

    points: np.ndarray  #: (m, 2) or (m, 3) float64; z is NaN where a geometry has none and others have one
    lines: List[np.ndarray]
    loops: List[np.ndarray]  #: without the first point once more at the end

    def source(self, isInSpace: bool) -> np.ndarray:
        """The points beside others that have a z, or not: NaN is an unknown one."""
        if self.points.shape[1] == 3 or not isInSpace:
            return self.points
        return np.column_stack((self.points, np.full(len(self.points), np.nan)))


def constraints_of(given: Any, name: str = "constraints") -> Constraints:
    """TypeError, ValueError for what is none, and for places that are not finite."""
    reader = _Reader()
    reader.take(name, given)
    columns = max([part.shape[1] for part in reader.parts], default=2)
    points = np.full((reader.count, columns), np.nan)
    for begin, part in zip(reader.begins, reader.parts):
        points[begin : begin + len(part), : part.shape[1]] = part
    return Constraints(points, reader.lines, reader.loops)


class HasGeometry(Protocol):
    """What shapely's objects and others are for type checkers."""

    @property
    def __geo_interface__(self) -> Any: ...


def ring_of(name: str, given: Any) -> Any:
    """(k, 2): of a geometry that is a polygon without holes, its ring; anything else as it is. ValueError."""
    if not (hasattr(given, "__geo_interface__") or isinstance(given, Mapping)):
        return given
    made = constraints_of(given, name)
    if len(made.loops) != 1 or len(made.loops[0]) != len(made.points):
        raise ValueError("%s must be one polygon without holes, but there are %d rings, %d lines and %d points in "
                         "all" % (name, len(made.loops), len(made.lines), len(made.points)))  # fmt: skip
    return made.points[:, :2]


class _Reader:
    """Gathers the parts of geometries."""

    def __init__(self) -> None:
        self.parts: List[np.ndarray] = []
        self.begins: List[int] = []
        self.count = 0
        self.lines: List[np.ndarray] = []
        self.loops: List[np.ndarray] = []

    def take(self, where: str, given: Any) -> None:
        """A geometry, a ring or a sequence of these; None is an empty geometry, as in tables and in GeoJSON."""
        if given is None or getattr(given, "is_empty", None) is True:  # shapely 1.8 cannot show an empty point
            return
        if _has_measure(given):
            raise ValueError("%s has measures (M), which are no z: give shapely.force_2d() of it" % where)
        found = getattr(given, "__geo_interface__", given)
        if isinstance(found, Mapping):
            self._take_geometry(where, found)
            return
        if hasattr(found, "__array__") and not isinstance(found, np.ndarray):
            found = np.asarray(found)
        isText = isinstance(found, (str, bytes))
        if isText or not hasattr(found, "__iter__") or (isinstance(found, np.ndarray) and found.ndim == 0):
            hint = ": shapely.from_wkt() or json.loads() makes one of a text" if isText else ""
            raise TypeError("%s must be %s, not %s%s" % (where, WANTED, type(given).__name__, hint))
        members = found if isinstance(found, np.ndarray) else list(found)
        if _are_positions(members):
            self._take_ring(where, members)
        else:
            for k, member in enumerate(members):
                self.take("%s[%d]" % (where, k), member)

    def _take_geometry(self, where: str, geometry: Mapping[str, Any]) -> None:
        kind = geometry.get("type")
        if kind in _MEMBERS:
            self.take(where, geometry.get(_MEMBERS[kind]))
            return
        readers: Dict[Any, Tuple[Callable[[str, Any], Any], int]] = {
            "Point": (lambda name, at: self._add(_positions(name, [at])), 0),
            "MultiPoint": (lambda name, at: self._add(_positions(name, at)), 0),
            "LineString": (self._take_line, 0),
            "MultiLineString": (self._take_line, 1),
            "LinearRing": (self._take_ring, 0),
            "Polygon": (self._take_ring, 1),
            "MultiPolygon": (self._take_ring, 2),
        }
        if kind not in readers:
            raise ValueError("%s must be %s, not a mapping of type %r" % (where, WANTED, kind))
        read, depth = readers[kind]
        self._each(read, "%s, a %s" % (where, kind), geometry.get("coordinates"), depth)

    def _each(self, read: Callable[[str, Any], Any], name: str, coordinates: Any, depth: int) -> None:
        """Reads what lies so deep in nested sequences; empty ones are nothing."""
        if not hasattr(coordinates, "__len__") and coordinates is not None:
            raise ValueError("%s: its coordinates are of type %s" % (name, type(coordinates).__name__))
        if coordinates is None or len(coordinates) == 0:
            return
        if depth == 0:
            read(name, coordinates)
            return
        for members in coordinates:
            self._each(read, name, members, depth - 1)

    def _take_line(self, name: str, given: Any) -> None:
        places = _positions(name, given)
        if len(places) < 2:
            raise ValueError("%s: a line must have two points or more, not %d" % (name, len(places)))
        self.lines.append(self._add(places))

    def _take_ring(self, name: str, given: Any) -> None:
        places = _positions(name, given)
        if not len(places):
            return
        if len(places) > 1 and (places[0, :2] == places[-1, :2]).all():
            places = places[:-1]
        if len(places) < 3:
            raise ValueError("%s: a ring must have three points or more, not %d" % (name, len(places)))
        self.loops.append(self._add(places))

    def _add(self, places: np.ndarray) -> np.ndarray:
        """The ids of these points."""
        begin, self.count = self.count, self.count + len(places)
        self.parts.append(places)
        self.begins.append(begin)
        return np.arange(begin, self.count)


def _has_measure(given: Any) -> bool:
    """Has a geometry of shapely, or one of a table, an M? Without a z it comes third, as a z does."""
    found = getattr(given, "has_m", False)
    return bool(found.any()) if hasattr(found, "any") else found is True


def _are_positions(members: Any) -> bool:
    """Are these the numbers of points, rather than rings and geometries?"""
    if isinstance(members, np.ndarray) and members.dtype != object:
        return members.ndim < 3
    return all(
        isinstance(member, (Sequence, np.ndarray)) and all(isinstance(number, _NUMBERS) for number in member)
        for member in members
    )  # fmt: skip


def _positions(name: str, given: Any) -> np.ndarray:
    """(k, 2) or (k, 3) float64, x and y finite."""
    try:
        found = np.asarray(given)
    except ValueError:  # of unlike lengths
        found = np.asarray(None)
    if found.size == 0:
        return np.zeros((0, 2))
    if found.dtype.kind not in "biuf" or found.ndim != 2 or found.shape[1] not in (2, 3):
        isRagged = found.ndim == 0 or found.dtype == object
        said = "numbers of unlike counts" if isRagged else "%s of type %s" % (found.shape, found.dtype)
        raise ValueError("%s: its points must all have two numbers, or all three: x, y and z; not %s" % (name, said))
    if isinstance(given, np.ma.MaskedArray) and np.ma.is_masked(given):
        raise TypeError("%s: a masked array, whose mask would be lost" % name)
    places = np.array(found, np.float64)
    odd = np.flatnonzero(~np.isfinite(places[:, :2]).all(axis=1))
    if len(odd):
        raise ValueError("%s: point %d is at (%g, %g), which is not finite" % (name, odd[0], *places[odd[0], :2]))
    return places
