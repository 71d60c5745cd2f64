# SPDX-License-Identifier: BSD-3-Clause
"""The part of a Triangulation that is about a lighter one of the same points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Tuple, TypeVar

import numpy as np

from . import _library as library
from ._input import Request
from ._made import frozen
from ._outlined import Outlined
from ._raster import real_numbers

Same = TypeVar("Same", bound="Simplified")

_EXACT = 5e-324  # a bound that leaves out what is exactly on the surface; the setting's 0 is no bound
_SIMPLIFIED = ("maximum_error", "maximum_vertices", "second_pass")  # settings, keywords too


class Simplified(Outlined):
    """The part of a Triangulation that leaves out points within an error."""

    if TYPE_CHECKING:

        @property
        def _measures(self) -> Dict[str, float]: ...

        def __init__(self, request: Request, id_dtype: Any, wanted: Tuple[str, ...], progress: Any) -> None: ...

        @property
        def plane_points(self) -> np.ndarray: ...

    def simplify(
        self: Same,
        maximum_error: Optional[float] = None,
        *,
        maximum_vertices: int = 0,
        second_pass: bool = False,
        values: Any = None,
        progress: Optional[Callable[[str, float], Any]] = None,
    ) -> Same:
        """A triangulation of fewer of the points: the others are within an error of its surface.

        The points, constraints and settings are those of this triangulation, and so are ids: `points` are the same
        array, not copied. `point_status` is -3 for points that were left out. ``measures["largest_error"]`` is the
        largest error at these, ``counts["within_error"]`` their number. A simplified triangulation is simplified from
        all points again.

        Parameters
        ----------
        maximum_error : float, 0 or more, optional
            As in `delaunay`; 0 leaves out what is exactly on the surface.
        maximum_vertices : int, 0 or more, default 0
        second_pass : bool, default False
            As in `delaunay`.
        values : (n,) array of real numbers, optional
            Of the surface, in place of z: the error is theirs, in their unit. Where one is NaN or infinite the point
            stays. Only with `duplicates` 'first', and without points that were added. `points` are copied for the
            time of the call.
        progress : function of (str, float), optional
            As in `delaunay`; with `values` there are two runs.

        Raises
        ------
        TypeError, ValueError
            Neither a bound nor a number of vertices is given, or this triangulation has a setting that is not possible
            together with them: `insertion_limit`, `alpha`, duplicates='mean_z'.
        MemoryError, KeyboardInterrupt
            As `delaunay`.

        Examples
        --------
        >>> import numpy as np
        >>> from adaptivehilbertdelaunay import delaunay
        >>> x, y = np.meshgrid(np.arange(50.0), np.arange(50.0))
        >>> hills = np.column_stack((x.ravel(), y.ravel(), (x * (49 - x) * y * (49 - y)).ravel() / 2e5))
        >>> made = delaunay(hills)
        >>> light = made.simplify(0.05)
        >>> len(made.triangles), len(light.triangles) < 400, light.measures["largest_error"] <= 0.05
        (4802, True, True)
        >>> bool(np.abs(light.interpolate(hills[:, 2], hills[:, :2]) - hills[:, 2]).max() <= 0.05)
        True
        >>> kept = light.points[light.point_of_vertex]  # those that are left
        >>> made.simplify(maximum_vertices=100).counts["inserted"] <= 100
        True
        >>> warm = np.where(hills[:, 0] < 25, 10, 20)  # of another quantity than z
        >>> made.simplify(0.5, values=warm).counts["within_error"] > 2000
        True
        """
        if maximum_error is None and not maximum_vertices:
            raise TypeError("simplify() needs maximum_error or maximum_vertices")
        bound: Any = 0.0 if maximum_error is None else maximum_error  # an array, too, which is refused by name
        if maximum_error is not None and np.ndim(bound) == 0 and not isinstance(bound, (bool, np.bool_)) and bound == 0:
            bound = _EXACT
        given = dict(zip(_SIMPLIFIED, (bound, maximum_vertices, second_pass)))
        with self._locked():
            self._check_input()
        if values is None:
            return type(self)(self._request.changed(given), self._dtype, (), progress)
        return self._simplify_values(given, values, progress)

    def _simplify_values(self: Same, given: Dict[str, Any], values: Any, progress: Any) -> Same:
        """First the points with the values as z, then those that this keeps."""
        request = self._request
        numbers = real_numbers("values", values)
        if numbers.shape != (len(request.points),):
            raise ValueError("values must have one number for each of %d points, not the shape %s" % (
                len(request.points), numbers.shape))  # fmt: skip
        if "source_points" in request.arrays:
            raise ValueError("values: the triangulation has points of the constraints, which have none; give "
                             "delaunay() all as points")  # fmt: skip
        if request.settings["bounding"]:
            raise ValueError("values: the triangulation has bounding points, which have none")
        if request.settings["duplicates"] != library.DUPLICATES_FIRST:
            raise ValueError("values: duplicates must be 'first', as z does not say which value counts")
        isPlain = request.settings["plane"] == library.PLANE_XY
        places = (request.points if isPlain else self.plane_points[: len(numbers)])[:, :2]
        first = request.changed(given, points=np.column_stack((places, numbers)))
        job = first.job(["point_status"])
        job.set(other_memory=first.points.nbytes)
        if progress is not None:
            job.set_progress(lambda phase, fraction: progress(library.PHASES[phase], fraction) and None)
        job.run()
        job.set_progress(None)
        found = {name: frozen(job.array(name, self._dtype)) for name in ("point_status", "merged")}
        counts, measures = job.counts(), job.measures()
        library.give_back(job)
        return self._without(found, counts, measures["largest_error"], progress)

    def _without(self: Same, found: Dict[str, np.ndarray], counts: Dict[str, int], error: float, progress: Any) -> Same:
        """Of the points that the status found does not leave out. What became of all is said as if one run had found
        it."""
        request = self._request
        isOut = found["point_status"][: len(request.points)] == library.POINT_WITHIN_ERROR
        skip = request.arrays.get("skip")
        marks = isOut if skip is None else isOut | (skip != 0)
        second = request.changed(dict.fromkeys(_SIMPLIFIED[:2], 0), skip=marks.view(np.uint8))
        made = type(self)(second, self._dtype, (), progress)
        made._counts.update({name: counts[name] for name in ("within_error", "skipped", "merged_points")})
        made._measures["largest_error"] = error
        made._cached.update(found)
        return made
