# SPDX-License-Identifier: BSD-3-Clause
"""The part of a Triangulation that is about a lighter one of the same points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Tuple, TypeVar

import numpy as np

from ._input import Request, marks_of
from ._outlined import Outlined
from ._raster import real_numbers

Same = TypeVar("Same", bound="Simplified")

_EXACT = 5e-324  # a bound that leaves out what is exactly on the surface; the setting's 0 is no bound
_SIMPLIFIED = ("maximum_error", "maximum_vertices", "second_pass")  # settings, keywords too


def numbers_of(request: Request, values: Any, weights: Any, keep: Any) -> Dict[str, np.ndarray]:
    """Copies of what is given for the points of a simplified surface, as arrays of its job; None: nothing."""
    count, made = len(request.points), {}
    for name, given in (("values", values), ("weights", weights)):
        if given is not None:
            made[name] = np.array(real_numbers(name, given))
            counts = {count, count + len(request.arrays.get("source_points", ()))} if name == "values" else {count}
            if made[name].ndim != 1 or len(made[name]) not in counts:
                raise ValueError("%s must have one number for each of %s points, not the shape %s" % (
                    name, " or ".join(map(str, sorted(counts))), made[name].shape))  # fmt: skip
    if keep is not None:
        made["keep"] = np.array(marks_of("keep", keep, count))
    return made


class Simplified(Outlined):
    """The part of a Triangulation that leaves out points within an error."""

    if TYPE_CHECKING:

        def __init__(self, request: Request, id_dtype: Any, wanted: Tuple[str, ...], progress: Any) -> None: ...

    def simplify(
        self: Same,
        maximum_error: Optional[float] = None,
        *,
        maximum_vertices: int = 0,
        second_pass: bool = False,
        values: Any = None,
        weights: Any = None,
        keep: Any = None,
        progress: Optional[Callable[[str, float], Any]] = None,
    ) -> Same:
        """A triangulation of fewer of the points: the others are within an error of its surface.

        The points, constraints and settings are those of this triangulation, and so are ids: `points` are the same
        array, not copied. `point_status` is -3 for points that were left out. ``measures["largest_error"]`` is the
        largest error at these, times its weight, ``counts["within_error"]`` their number; `errors` has those of all
        points, without weights. A simplified triangulation is simplified from all points again. What is not given of
        `values`, `weights` and `keep` is as it was for this triangulation.

        Parameters
        ----------
        maximum_error : float, 0 or more, optional
            As in `delaunay`; 0 leaves out what is exactly on the surface.
        maximum_vertices : int, 0 or more, default 0
        second_pass : bool, default False
            As in `delaunay`.
        values : array of real numbers, one for each point, optional
            Of the surface, in place of z: the error is theirs, in their unit. Where one is NaN or infinite the point
            stays. For the points given, or also for those of `source_points`, which have none else unless their
            heights are those of the surface.
        weights : (n,) array of real numbers, optional
            Times which errors of the points given count. Where one is NaN, infinite or negative the point stays.
        keep : (n,) array of bool or uint8, optional
            The points given that stay.
        progress : function of (str, float), optional
            As in `delaunay`.

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
        >>> bool(light.errors.max() == light.measures["largest_error"])
        True
        >>> warm = np.where(hills[:, 0] < 25, 10, 20)  # of another quantity than z
        >>> made.simplify(0.5, values=warm, keep=hills[:, 2] > 1.9).counts["within_error"] > 2000
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
        request = self._request.changed(given, numbers_of(self._request, values, weights, keep))
        return type(self)(request, self._dtype, (), progress)
