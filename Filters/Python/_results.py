# SPDX-License-Identifier: BSD-3-Clause
"""Results of a Triangulation that consist of several arrays."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Dict, Iterable, Iterator, List, NamedTuple, Tuple, Union

import numpy as np

from . import _library as library


@dataclass(frozen=True)
class Voronoi:
    """The Voronoi diagram of the vertices: cell `i` is the region nearer to point `sites[i]` than to any other.

    Attributes
    ----------
    points : (p, 2) float64
        Corners of the cells, in the plane of the triangulation, in the unit of the points; each shared by the cells
        that meet there.
    offsets : (c + 1,) int
        Cell `i` has the corners ``corners[offsets[i]:offsets[i + 1]]``, at least three, counterclockwise; or none if it
        is empty, as those outside a polygon may be.
    corners : (k,) int
        Rows of `points`.
    sites : (c,) int
        The ids of the points of the cells: rows of `points` of the triangulation.
    """

    points: np.ndarray
    offsets: np.ndarray
    corners: np.ndarray
    sites: np.ndarray

    def __len__(self) -> int:
        return len(self.sites)

    def __iter__(self) -> Iterator[np.ndarray]:
        return (self[i] for i in range(len(self)))

    def __getitem__(self, i: int) -> np.ndarray:
        """The corners of cell `i`, (k, 2)."""
        if not -len(self) <= i < len(self):
            raise IndexError("cell %d of %d" % (i, len(self)))
        i %= len(self)
        found: np.ndarray = self.points[self.corners[self.offsets[i] : self.offsets[i + 1]]]
        return found

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """A FeatureCollection of GeoJSON: a Polygon for each cell that is not empty, whose property "site" is the id of
        its point. All cells are clipped, so none is unbounded."""
        return _collection(
            ({"site": site}, {"type": "Polygon", "coordinates": [_closed(cell)]})
            for site, cell in zip(self.sites.tolist(), self)
            if len(cell)
        )


@dataclass(frozen=True)
class Outline:
    """The outline of the triangles, as polygons with holes: ``len(outline)`` polygons, and ``outline[i]`` is a list of
    the rings of one, the outer ring first, counterclockwise, then its holes, clockwise.

    A polygon is a largest set of triangles joined by edges; those that touch at a vertex only are two. Rings are
    simple. A ring begins at its smallest vertex, by x, then y, and polygons and holes are in the order of these. It is
    made from ids and an exact sign: no place is moved or rounded.

    shapely, geopandas and others take it as it is, as a MultiPolygon: ``shapely.geometry.shape(outline)``.

    Attributes
    ----------
    points : (n, 2) or (n, 3) float32 or float64
        The places that ids refer to: x, y of the triangulation's points; in space, if its plane is not that of x, y.
    corners : (k,) int
        Ids of points, ring after ring; the first of a ring is not repeated.
    rings : (r + 1,) int
        Ring `i` has the corners ``corners[rings[i]:rings[i + 1]]``.
    polygons : (p + 1,) int
        Polygon `i` has the rings from ``polygons[i]`` to ``polygons[i + 1]``.
    """

    points: np.ndarray
    corners: np.ndarray
    rings: np.ndarray
    polygons: np.ndarray

    def __len__(self) -> int:
        return len(self.polygons) - 1

    def __iter__(self) -> Iterator[List[np.ndarray]]:
        return (self[i] for i in range(len(self)))

    def __getitem__(self, i: int) -> List[np.ndarray]:
        """The rings of polygon `i`, each (k, 2) or (k, 3)."""
        if not -len(self) <= i < len(self):
            raise IndexError("polygon %d of %d" % (i, len(self)))
        first, end = self.polygons[i % len(self)], self.polygons[i % len(self) + 1]
        return [self.points[self.corners[self.rings[r] : self.rings[r + 1]]] for r in range(first, end)]

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """A MultiPolygon of GeoJSON: rings are closed."""
        return {"type": "MultiPolygon", "coordinates": [[_closed(ring) for ring in polygon] for polygon in self]}


@dataclass(frozen=True)
class Lines:
    """The lines of a level: ``len(lines)`` of them, and ``lines[i]`` are the places along one, (k, 2) or (k, 3). Higher
    values are on its left. A line around a hill or a hollow ends with its first place; others end at the border of the
    surface.

    shapely and others take it as it is, as a MultiLineString: ``shapely.geometry.shape(lines)``.

    Attributes
    ----------
    points : (n, 2) or (n, 3) float64
        The nodes that numbers refer to: the triangulation's points, then the crossings of edges and levels.
    corners : (k,) int
        Numbers of nodes, line after line.
    offsets : (l + 1,) int
        Line `i` has the nodes ``corners[offsets[i]:offsets[i + 1]]``, two or more.
    """

    points: np.ndarray
    corners: np.ndarray
    offsets: np.ndarray

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __iter__(self) -> Iterator[np.ndarray]:
        return (self[i] for i in range(len(self)))

    def __getitem__(self, i: int) -> np.ndarray:
        if not -len(self) <= i < len(self):
            raise IndexError("line %d of %d" % (i, len(self)))
        i %= len(self)
        found: np.ndarray = self.points[self.corners[self.offsets[i] : self.offsets[i + 1]]]
        return found

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """A MultiLineString of GeoJSON."""
        return {"type": "MultiLineString", "coordinates": [_places(line) for line in self]}


@dataclass(frozen=True)
class Contours:
    """The contours of a surface: ``contours[i]`` are the `Lines` of level `i`, or, filled, the band between levels `i`
    and `i + 1` as an `Outline`, polygons with holes. All share their nodes: places where bands meet are the same.

    geopandas and others take it as it is, as a FeatureCollection with a column "level", or "lower" and "upper":
    ``geopandas.GeoDataFrame.from_features(contours)``. shapely takes each: ``shapely.geometry.shape(contours[i])``.

    Attributes
    ----------
    levels : (m,) float64
        Ascending, each once.
    shapes : tuple
        Of m Lines, or m - 1 Outlines.
    """

    levels: np.ndarray
    shapes: Tuple[Union[Outline, Lines], ...]

    def __len__(self) -> int:
        return len(self.shapes)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.shapes)

    def __getitem__(self, i: int) -> Any:
        """Lines or Outline."""
        return self.shapes[i]

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """A FeatureCollection of GeoJSON: MultiLineStrings with the property "level", or MultiPolygons with "lower" and
        "upper". An infinite level is None, as JSON has no number for it."""
        levels = [level if math.isfinite(level) else None for level in self.levels.tolist()]
        isFilled = len(self.shapes) < len(levels)
        properties = (
            [{"lower": lower, "upper": upper} for lower, upper in zip(levels, levels[1:])] if isFilled else
            [{"level": level} for level in levels]
        )  # fmt: skip
        return _collection(zip(properties, (shape.__geo_interface__ for shape in self.shapes)))


def _places(places: np.ndarray) -> List[Tuple[float, ...]]:
    return [tuple(place) for place in places.tolist()]


def _closed(ring: np.ndarray) -> List[Tuple[float, ...]]:
    places = _places(ring)
    return places + places[:1]


def _collection(rows: Iterable[Tuple[Dict[str, Any], Dict[str, Any]]]) -> Dict[str, Any]:
    """A FeatureCollection of GeoJSON of properties and geometries."""
    features = [{"type": "Feature", "properties": properties, "geometry": shape} for properties, shape in rows]
    return {"type": "FeatureCollection", "features": features}


class Boxes(NamedTuple):
    """Boxes of the grid that are not divided, in the order in which the insertion visits them."""

    bounds: np.ndarray  #: (b, 4) float64: xmin, xmax, ymin, ymax
    levels: np.ndarray  #: (b,) int32: the number of divisions that made it
    counts: np.ndarray  #: (b,) int: the distinct points in it


class Adjacency(NamedTuple):
    """A list of numbers for each point: that of point `i` is ``items[offsets[i]:offsets[i + 1]]``."""

    offsets: np.ndarray  #: (n + 1,) int
    items: np.ndarray  #: (k,) int


class Kind(IntEnum):
    """How a place lies in a triangulation."""

    IN_TRIANGLE = library.IN_TRIANGLE  #: inside of a triangle
    ON_EDGE = library.ON_EDGE  #: between the ends of an edge
    ON_VERTEX = library.ON_VERTEX
    OUTSIDE = library.OUTSIDE  #: of the convex hull
    NOWHERE = library.NOWHERE  #: the place is not finite, or there are no triangles


class Location(NamedTuple):
    """Where places lie."""

    kind: np.ndarray  #: (k,) int32: a Kind for each place
    triangle: np.ndarray  #: (k,) int: the row of a triangle that has the place in it or on its border; -1: none
    corners: np.ndarray  #: (k, 3) int: ids of the triangle's corners, the edge's ends or the vertex; the rest is -1


def chained(edges: np.ndarray) -> np.ndarray:
    """The ids along edges that make one closed chain, from the first edge on."""
    follower = dict(edges.tolist())
    chain = [int(edges[0, 0])]
    while follower[chain[-1]] != chain[0]:
        chain.append(follower[chain[-1]])
    return np.array(chain, edges.dtype)
