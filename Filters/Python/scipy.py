# SPDX-License-Identifier: BSD-3-Clause
"""For programs that are written for scipy: names of `scipy.spatial` and `scipy.interpolate`, for points in the plane.

    from adaptivehilbertdelaunay.scipy import Delaunay, LinearNDInterpolator, griddata

Imports change, programs do not. scipy is not needed: triangles, location, gradients and patches are this package's,
exact where scipy's are rounded. `Delaunay` says what differs.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Callable, Dict, Tuple

import numpy as np

from ._cubic import Network, Patches
from ._interpolators import NearestInterpolator, _Interpolator
from ._made import frozen
from ._measured import length
from ._raster import unmasked
from ._sampling import check_outside
from ._spatial import Delaunay, QhullError, plane_points, triangulated, tsearch
from ._triangulation import Triangulation
from ._warnings import _depth

__all__ = [
    "CloughTocher2DInterpolator", "Delaunay", "GradientEstimationWarning", "LinearNDInterpolator",
    "NearestNDInterpolator", "QhullError", "estimate_gradients_2d_global", "griddata", "tsearch",
]  # fmt: skip


class GradientEstimationWarning(Warning):
    """Gradients were not found to the tolerance, in `maxiter` steps or because of rounding."""


class _Called(_Interpolator):
    """Called as scipy's interpolators are, and without this package's warnings."""

    def _triangulated(self, points: np.ndarray, threads: int) -> Triangulation:
        return triangulated(plane_points(points))

    def _places(self, args: Tuple[Any, ...]) -> np.ndarray:
        """(..., 2) float64; one place [x, y] is an array of one."""
        if len(args) == 1 and not isinstance(args[0], tuple) and np.ndim(args[0]) == 1 and np.size(args[0]) % 2 == 0:
            args = (np.asarray(args[0]).reshape(-1, 2),)
        return super()._places(args)


class _OnDelaunay(_Called):
    """Points, values and the triangulation of the points."""

    def _begin(self, points: Any, values: Any, fill_value: Any, rescale: bool) -> None:
        self._origin, self._scale, self._is_rescaled = np.zeros(2), np.ones(2), rescale
        if isinstance(points, (Delaunay, Triangulation)):
            if rescale:
                raise ValueError("rescale is for points, not for a triangulation of them")
            self.tri = points if isinstance(points, Delaunay) else Delaunay(points)
        else:
            self.tri = Delaunay(self._own(points, rescale))
        self.triangulation = self.tri.triangulation
        given = unmasked("values", values)
        self.triangulation._lacking_rows(given)
        if given.dtype.kind not in "biufc":
            raise TypeError("values must be numbers, not of type %s" % given.dtype)
        check_outside("fill_value", fill_value, "", given.dtype.kind)
        self.fill_value, self.values_shape = fill_value, given.shape[1:]
        self.is_complex = given.dtype.kind == "c"
        #: (n, columns) float64 or complex128
        self.values = np.array(given, np.complex128 if self.is_complex else np.float64).reshape(len(given), -1)


class LinearNDInterpolator(_OnDelaunay):
    """Linear interpolation between points in the plane, with the arguments of `scipy.interpolate.LinearNDInterpolator`.

    Parameters
    ----------
    points : (n, 2) array of real numbers, tuple (x, y), Delaunay or Triangulation
        Copied. Of several at one place the first one's value counts.
    values : (n, ...) array of real or complex numbers
    fill_value : number, default NaN
        The value outside the convex hull.
    rescale : bool, default False
        Triangulate the points as they are in a square of side 1.

    Examples
    --------
    >>> from adaptivehilbertdelaunay.scipy import LinearNDInterpolator
    >>> plane = LinearNDInterpolator([[0, 0], [4, 0], [4, 4], [0, 4]], [0, 4, 8, 4])
    >>> plane([1, 2]), plane(1, 2), plane([[3, 3], [5, 5]])
    (array([3.]), array(3.), array([ 6., nan]))
    """

    def __init__(self, points: Any, values: Any, fill_value: Any = np.nan, rescale: bool = False) -> None:
        self._begin(points, values, fill_value, rescale)

    def __call__(self, *args: Any) -> np.ndarray:
        """Values at places: ``f(x, y)``, ``f((x, y))`` or ``f(places)``."""
        places = self._places(args)
        made: np.ndarray = self.triangulation._at(self.values, places, "linear", self.fill_value)
        return made.reshape(places.shape[:-1] + self.values_shape)


def estimate_gradients_2d_global(tri: Delaunay, y: Any, maxiter: int = 400, tol: float = 1e-6) -> np.ndarray:
    """Gradients at the points of the surface with the least curvature along the edges (Nielson's minimum norm network).

    Parameters
    ----------
    tri : Delaunay
    y : (n,) or (n, columns) array of real or complex numbers
        Values at the points. Points where they are not finite are left out.
    maxiter : int, default 400
        The most steps of the iteration; ten are mostly enough. GradientEstimationWarning if not.
    tol : float, default 1e-6
        How close gradients are to the best ones, relative to gradients above 1.

    Returns
    -------
    (n, 2) or (n, columns, 2) float64 or complex128
        d/dx and d/dy.
    """
    given = unmasked("y", y)
    if tri.triangulation._lacking_rows(given) or len(given) < tri.npoints:
        raise ValueError("the triangulation has points that were added, which have no values")
    isComplex = given.dtype.kind == "c"
    parts = np.array(given, np.complex128 if isComplex else np.float64).reshape(len(given), -1).view(np.float64)
    network = Network(tri.points, tri.triangulation.edges)
    found = [network.gradients(part, maxiter, tol) for part in parts.T]
    if not all(converged for _, converged in found):
        text = "gradients were not found to the tolerance: values may be off (maxiter=%d, tol=%g)" % (maxiter, tol)
        warnings.warn(text, GradientEstimationWarning, stacklevel=_depth())
    made = np.stack([gradients for gradients, _ in found], axis=1) if found else np.empty(parts.shape + (2,))
    made = made[:, ::2] + 1j * made[:, 1::2] if isComplex else made
    return made.reshape(given.shape + (2,))


class CloughTocher2DInterpolator(_OnDelaunay):
    """Piecewise cubic interpolation with continuous slopes between points in the plane, with the arguments of
    `scipy.interpolate.CloughTocher2DInterpolator`.

    Clough and Tocher's patches with the gradients of `estimate_gradients_2d_global`, which are in `grad`, (n, columns,
    2), and may be changed.

    Parameters
    ----------
    points, values, fill_value, rescale
        As in `LinearNDInterpolator`. Triangles with a corner whose value is NaN have NaN.
    tol, maxiter
        Of the gradients.

    Examples
    --------
    >>> import numpy as np
    >>> from adaptivehilbertdelaunay.scipy import CloughTocher2DInterpolator
    >>> points = np.random.default_rng(1).random((1000, 2))
    >>> cubes = CloughTocher2DInterpolator(points, points[:, 0] ** 3)
    >>> cubes(0.4, [0.2, 0.6]).round(3).tolist()
    [0.064, 0.064]
    """

    def __init__(
        self,
        points: Any,
        values: Any,
        fill_value: Any = np.nan,
        tol: float = 1e-6,
        maxiter: int = 400,
        rescale: bool = False,
    ) -> None:
        self._begin(points, values, fill_value, rescale)
        made = self.triangulation
        self.grad = estimate_gradients_2d_global(self.tri, self.values, maxiter, tol)
        self._patches = Patches(self.tri.points, made.triangles, made.neighbors)

    def __call__(self, *args: Any) -> np.ndarray:
        """Values at places: ``f(x, y)``, ``f((x, y))`` or ``f(places)``."""
        places = self._places(args)
        flat = places.reshape(-1, 2)
        rows = self.tri.find_simplex(flat)
        inside = np.flatnonzero(rows >= 0)
        rows, flat = rows[inside], flat[inside]
        made = np.full((len(places.reshape(-1, 2)), self.values.shape[1]), self.fill_value, self.values.dtype)
        made[inside] = self._patches.at(rows, flat, self._exact_weights, self.values, self.grad)
        return made.reshape(places.shape[:-1] + self.values_shape)

    def _exact_weights(self, rows: np.ndarray, places: np.ndarray) -> np.ndarray:
        """Of the corners of the triangle of each place, (3, k)."""
        offsets, ids, exact = self.triangulation.weights(places)
        place = np.repeat(np.arange(len(rows)), np.diff(offsets))
        entry, corner = np.nonzero(self.triangulation.triangles[rows[place]] == ids[:, None])
        made = np.zeros((3, len(rows)))
        made[corner, place[entry]] = exact[entry]
        return made


class NearestNDInterpolator(_Called, NearestInterpolator):
    """The value of the nearest of points in the plane, with the arguments of `scipy.interpolate.NearestNDInterpolator`.

    Parameters
    ----------
    x : (n, 2) array of real numbers or tuple (x, y)
    y : (n, ...) array
    rescale : bool, default False
        Take distances as they are in a square of side 1.
    tree_options : dict, optional
        Has no effect: there is no tree.

    Examples
    --------
    >>> from adaptivehilbertdelaunay.scipy import NearestNDInterpolator
    >>> nearest = NearestNDInterpolator([[0, 0], [4, 0], [2, 9]], [10, 20, 30])
    >>> nearest([1, 3, 2], [0, 0, 99]).tolist()
    [10.0, 20.0, 30.0]
    """

    def __init__(self, x: Any, y: Any, rescale: bool = False, tree_options: Any = None) -> None:
        super().__init__(x, y, rescale)
        if self.values.dtype.kind in "biu":
            self.values = frozen(self.values.astype(np.float64))

    if not TYPE_CHECKING:  # for which any name would be one of these

        def __getattr__(self, name: str) -> Any:
            if name == "tree":
                raise AttributeError("there is no tree: call with distance_upper_bound, or make one of `points`")
            return object.__getattribute__(self, name)

    def __call__(
        self,
        *args: Any,
        distance_upper_bound: float = np.inf,
        p: float = 2,
        k: int = 1,
        eps: float = 0,
        workers: int = 1,
    ) -> np.ndarray:
        """Values at places: ``f(x, y)``, ``f((x, y))`` or ``f(places)``; NaN where no point is nearer than
        `distance_upper_bound`. `p` is 2 and `k` is 1; `eps` and `workers` have no effect."""
        if p != 2 or k != 1:
            raise ValueError("p must be 2 and k must be 1, not %r and %r" % (p, k))
        places = self._places(args)
        flat = places.reshape(-1, 2)
        ids = self.triangulation._nearest_ids(flat)
        if distance_upper_bound < np.inf:
            has = np.flatnonzero(ids == ids)
            apart = flat[has] - self.points[ids[has].astype(np.intp)]
            ids[has[~(length(*apart.T) < distance_upper_bound)]] = np.nan
        return self._taken(ids, places.shape[:-1])


_INTERPOLATORS: Dict[str, Callable[..., Any]] = {
    "nearest": lambda points, values, fill_value, rescale: NearestNDInterpolator(points, values, rescale),
    "linear": lambda points, values, fill_value, rescale: LinearNDInterpolator(points, values, fill_value, rescale),
    "cubic": lambda points, values, fill_value, rescale: CloughTocher2DInterpolator(
        points, values, fill_value, rescale=rescale
    ),
}


def griddata(
    points: Any, values: Any, xi: Any, method: str = "linear", fill_value: Any = np.nan, rescale: bool = False
) -> np.ndarray:
    """Values between points in the plane, with the arguments of `scipy.interpolate.griddata`.

    Parameters
    ----------
    points : (n, 2) array of real numbers, or tuple (x, y)
    values : (n, ...) array of real or complex numbers
    xi : (..., 2) array of real numbers, or tuple (x, y) of arrays that broadcast
        Places.
    method : {'linear', 'nearest', 'cubic'}, default 'linear'
        `LinearNDInterpolator`, `NearestNDInterpolator` or `CloughTocher2DInterpolator`.
    fill_value : number, default NaN
        The value outside the convex hull; without effect for 'nearest'.
    rescale : bool, default False
        Triangulate the points as they are in a square of side 1.

    Examples
    --------
    >>> from adaptivehilbertdelaunay.scipy import griddata
    >>> griddata([[0, 0], [4, 0], [4, 4], [0, 4]], [0, 4, 8, 4], ([1, 2, 5], 1))
    array([ 2.,  3., nan])
    """
    if method not in _INTERPOLATORS:
        raise ValueError("method must be one of %s, not %r" % (", ".join(map(repr, _INTERPOLATORS)), method))
    made: np.ndarray = _INTERPOLATORS[method](points, values, fill_value, rescale)(xi)
    return made
