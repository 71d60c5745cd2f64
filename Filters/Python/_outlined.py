# SPDX-License-Identifier: BSD-3-Clause
"""What bounds the triangles of a Triangulation, and parts of them: polygons with holes, and lines."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import _library as library
from ._contours import Cut, contours, levels_of
from ._made import frozen
from ._measured import Measured
from ._raster import number_of
from ._results import Contours, Outline


class Outlined(Measured):
    """The part of a Triangulation that is about polygons and lines, for shapely, geopandas and others."""

    def outline(self) -> Outline:
        """The outline of the triangles, as polygons with holes.

        Without constraints it is the convex hull; with loops, limits of size (such as `alpha`) or a trimmed rim the
        outline of what they leave: concave hulls and alpha shapes.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> square, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]
        >>> outline = delaunay(square + hole, loops=[[0, 1, 2, 3], [4, 5, 6, 7]]).outline()
        >>> [ring.tolist() for ring in outline[0]]
        [[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]], [[3.0, 3.0], [3.0, 6.0], [6.0, 6.0], [6.0, 3.0]]]
        """
        made: Outline = self._made("outline", self._outline_of)
        return made

    def alpha_shape(self, radius: float) -> Outline:
        """The outline of those triangles whose circumcircle has at most this radius, as polygons with holes.

        These are the triangles that ``delaunay(points, alpha=radius)`` has, found in this triangulation: several radii
        are tried without triangulating again. What loops, other limits and `rim` have removed stays removed.

        Parameters
        ----------
        radius : float, greater than 0
            In the unit of the points, in space where they have a z. A triangle at the limit is kept.

        Raises
        ------
        ValueError, TypeError
            It is not greater than 0, or no number.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> made = delaunay([[0, 0], [1, 0], [1, 1], [0, 1], [9, 0]])
        >>> [ring.tolist() for ring in made.alpha_shape(1)[0]]
        [[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]]
        """
        most = number_of(radius)
        if not most > 0:
            raise ValueError("radius must be greater than 0, not %r" % (radius,))
        self._check_input()
        job = library.take_job()
        job.set_array("points", self.points)
        job.set_array("cells", self.triangles)
        kept = job.within_radius(most, len(self.triangles))
        library.give_back(job)
        return self._outline_of(np.where(kept, 0.0, np.nan))

    def contours(self, values: Any, levels: Any, filled: bool = False) -> Contours:
        """The lines of levels, or the bands between them, of the surface that is linear on each triangle.

        Which nodes a line or a polygon has is decided by comparing values and levels alone, so bands have no gaps and
        do not overlap. Where an edge crosses a level there is one node, whose place is computed once, to rounding, and
        is the same in all lines and bands. Rings may touch or cross where rounding takes what is between: in triangles
        as thin as that, and at a level beside another one or beside a point's value. shapely calls these invalid, so
        take levels that are equal to rounded values: ``numpy.arange(11) / 10``, as ``numpy.arange(0, 1.1, 0.1)`` has
        0.30000000000000004.

        Parameters
        ----------
        values : (m,) array of real numbers
            One for each given point, as in `interpolate`. A triangle of a point whose value is not finite is left out.
        levels : sequence of real numbers
            In any order; repeated ones count once. With `filled` two or more, of which the first may be -inf and the
            last inf. A level beyond all values has nothing.
        filled : bool, default False
            The bands: each has values above its lower level up to its upper one, which it includes; the first band
            includes the lowest level, too. This decides where a triangle belongs that is at a level all over:
            matplotlib's `tricontourf`, which is described alike, draws it in the band above.

        Returns
        -------
        Contours
            ``contours[i]``: the lines of level `i`, or the polygons with holes of band `i`. Lines bound what is above
            their level, on their left. So a flat area at the level has a line where it is higher beside it, and none
            where it is lower.

        Raises
        ------
        ValueError, TypeError
            An array is of another shape or type; a level is NaN, or there are too few.
        MemoryError
            There is not enough memory, or `memory_limit` leaves less than is needed.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4]])
        >>> heights = [0, 4, 4, 0]
        >>> [line.tolist() for line in made.contours(heights, [1, 9])[0]]
        [[[1.0, 4.0], [1.0, 3.0], [1.0, 0.0]]]
        >>> bands = made.contours(heights, [0, 1, 4], filled=True)
        >>> len(bands), bands.__geo_interface__["features"][0]["properties"]
        (2, {'lower': 0.0, 'upper': 1.0})
        """
        chosen = levels_of(levels, bool(filled))
        heights = self.interpolate(values)
        if heights.ndim != 1:
            raise ValueError("values must be one number for each point, not rows of shape %s" % (heights.shape[1:],))
        limit = self._request.settings["memory_limit"]
        cut = Cut(self.triangles, heights, chosen, int(limit))
        plane = self.plane_points[:, :2] if self._counts["is_projected"] else None
        job = library.take_job()
        job.set(memory_limit=limit)
        return contours(cut, self._places(), plane, job, bool(filled), self._dtype)

    def _places(self) -> np.ndarray:
        """Of points, as outlines have them."""
        return self.points if self._counts["is_projected"] else frozen(self.points[:, :2])

    def _outline_of(self, groups: Optional[np.ndarray] = None) -> Outline:
        """Of all triangles, or of those whose number is not NaN."""
        self._check_input()
        places = self._places()
        job = library.take_job()
        job.set(memory_limit=self._request.settings["memory_limit"])
        job.set_array("points", self.plane_points if self._counts["is_projected"] else places)
        job.set_array("cells", self.triangles)
        if groups is not None:
            job.set(other_memory=groups.nbytes)
            job.set_array("cell_groups", groups)
        job.outline()
        names = ("outline_points", "outline_rings", "outline_polygons")
        made = Outline(places, *(frozen(job.array(name, self._dtype)) for name in names))
        library.give_back(job)
        return made
