# SPDX-License-Identifier: BSD-3-Clause
# Made by Filters/Settings/generate.py: change what is there, not this.
"""Delaunay triangulation of NumPy arrays."""

from __future__ import annotations

from typing import Any, Callable, Literal, Optional, Sequence, Union

import numpy as np

from ._input import Corners, Plane
from ._keywords import Wanted
from ._library import release_memory
from ._names import by_any_name
from ._results import Boxes, Kind, Location, Outline, Voronoi
from ._triangulate import triangulate
from ._triangulation import Triangulation
from ._warnings import DelaunayWarning

__all__ = [
    "Boxes", "DelaunayWarning", "Kind", "Location", "Outline", "Triangulation", "Voronoi", "delaunay", "release_memory",
]  # fmt: skip


@by_any_name("takes the points alone without a name: of x and y make numpy.column_stack([x, y])")
def delaunay(
    points: Any,
    *,
    heights: Any = None,
    constraints: Any = None,
    segments: Any = None,
    lines: Any = None,
    loops: Any = None,
    source_points: Any = None,
    skip: Any = None,
    weights: Any = None,
    keep: Any = None,
    plane: Plane = "xy",
    source_heights: Literal["own", "surface", "mixed"] = "own",
    zero_is_missing: bool = False,
    lines_on_surface: bool = True,
    maximum_segment_length: float = 0.0,
    closed_lines_are_loops: bool = False,
    points_as_line: bool = False,
    fill_rule: Literal["orientation", "even_odd"] = "even_odd",
    crossings: Literal["leave_out", "split"] = "leave_out",
    maximum_edge_length: float = 0.0,
    alpha: float = 0.0,
    maximum_error: float = 0.0,
    maximum_vertices: int = 0,
    second_pass: bool = False,
    rim: Literal["automatic", "convex_hull", "trimmed"] = "automatic",
    tolerance: float = 0.0,
    duplicates: Literal["first", "lowest_z", "highest_z", "mean_z"] = "first",
    voronoi_clip: Union[Literal["hull", "bounds"], Corners] = "hull",
    insertion_order: Literal["adaptive_hilbert", "multi_grid", "regular_grid", "as_given"] = "adaptive_hilbert",
    nmax: int = 50,
    control_points: Literal["off", "single_level", "every_level"] = "every_level",
    gene_rotation: bool = True,
    count_work: bool = False,
    insertion_limit: int = 0,
    offset: float = 1.0,
    bounding: bool = False,
    threads: int = 0,
    memory_limit: Union[int, str] = 0,
    id_dtype: Any = np.int32,
    want: Union[Wanted, Sequence[Wanted]] = (),
    progress: Optional[Callable[[str, float], Any]] = None,
) -> Triangulation:
    """The Delaunay triangulation of points in the plane: exact, and the same to the byte on any machine.

    Triangles are counterclockwise and cover the convex hull; points on its edges are corners of triangles. Of points
    at one place one is the vertex (see `duplicates`). Where four or more lie on one circle, their coordinates decide
    which triangulation is taken. Shuffling the points changes ids, nothing else.

    Parameters
    ----------
    points : (n, 2) or (n, 3) array of real numbers, or table, n at most 2**28 - 2
        x, y and optionally z, in one unit; of a table (a data frame, a structured array) the columns of these names, if
        it has x and y. float32 and float64 are not copied, whatever their strides, if the
        coordinates of a point are contiguous; other types are converted to float64. Points whose x or y is NaN or
        infinite are rejected, and a warning counts them. Do not change arrays while the triangulation is in use.
    heights : (n,) array of real numbers, optional
        The z of (n, 2) points, which are copied then. (A word is `source_heights`.)
    constraints : geometry, (k, 2) or (k, 3) array of real numbers, or sequence of these, optional
        Constraints with points of their own, which follow `points` in the result, in this order: polygons and rings are
        loops, lines are lines, points just points. A geometry is anything with `__geo_interface__` (shapely's,
        a GeoDataFrame) or a mapping as in GeoJSON, collections included; an array is a ring. A ring may end with its
        first point; empty geometries and None are nothing. If none has a z, heights and values are those of the surface
        (`source_heights` is 'surface'); if some have one, those of the others are (it is 'mixed', unless 'surface').
        All rings count alike for `fill_rule`: with 'even_odd' a place in two polygons is outside, and so are polygons
        in others; dissolve them before (``gdf.union_all()``) to keep all that lies in any. Rings that cross themselves
        or others are treated as `crossings` says.
    segments : (m, 2) array of int, optional
        Pairs of ids that become edges. A segment that passes through points becomes several edges.
    lines : sequence of sequences of int, or (c, w) array, optional
        Open chains of ids, such as breaklines: each pair of successive ones is a segment. A flat sequence is one line.
    loops : sequence of sequences of int, or (c, w) array, optional
        Closed chains, whose last point is joined to the first: outlines and holes. They are edges too, and bound the
        surface (see `fill_rule`).
    source_points : (m, 2) or (m, 3) array of real numbers, optional
        Points of the constraints. The ids in segments, lines and loops are then rows of these, and all of them are
        triangulated with the others; in the result their ids follow those of `points`.
    skip : (n,) array of bool or uint8, optional
        Points with a nonzero value are skipped.
    weights : (n,) array of real numbers, optional
        With `maximum_error` or `maximum_vertices`: times which the errors of `points` count. Where one is NaN, infinite
        or negative the point stays.
    keep : (n,) array of bool or uint8, optional
        With the same: points with a nonzero value stay.
    plane : {'xy', 'automatic', 'best_fit'}, (4, 4) array or function, default 'xy'
        The plane of the triangulation: x and y; these, or 'best_fit' with a warning for `points` that stand like a wall
        (the Reference says which do); the plane with the least sum of squared distances (if all points have the same z,
        x or y: the two other coordinates, unchanged); x and y after the matrix is applied to (x, y, z, 1);
        x and y of the function's result. The function gets (k, 3) float64, k at most 2**14, and changes it in place or
        returns an array: the position in the plane and the height above it. The result is exact for the coordinates in
        that plane, in float64.
    source_heights : {'own', 'surface', 'mixed'}, default 'own'
        The z of the constraints' own points. 'own': as given. 'surface': interpolated on the surface of all others,
        where they lie on it. 'mixed': as given, or where z is NaN, interpolated on the surface of all others and the
        constraints between points with z.
    zero_is_missing : bool, default False
        With `source_heights` 'mixed', points of the constraints with z = 0 have no height, like those with NaN.
    lines_on_surface : bool, default True
        With `source_heights` 'surface' or 'mixed', add a point where a constraint crosses an edge of the surface that
        heights come from, so that it follows the terrain. Otherwise it is straight.
    maximum_segment_length : float, 0 or more, default 0.0
        Divide longer segments of the constraints into equal parts, in the plane, by added points. 0: no limit.
    closed_lines_are_loops : bool, default False
        Treat lines that end where they begin as loops, alone or joined end to end.
    points_as_line : bool, default False
        Take `source_points` as one line, in their order, if there are no segments, lines or loops.
    fill_rule : {'orientation', 'even_odd'}, default 'even_odd'
        The regions that loops keep. 'even_odd': those inside an odd number of loops, whatever their direction.
        'orientation': those on the left of every loop edge that bounds them, and those that no loop bounds.
    crossings : {'leave_out', 'split'}, default 'leave_out'
        How crossing segments are treated. 'leave_out': the later one is left out, its loop bounds nothing, and a
        warning counts them (segments come before lines, lines before loops). 'split': a point is added.
    maximum_edge_length : float, 0 or more, default 0.0
        The longest edge of a triangle in the plane; 0: no limit.
    alpha : float, 0 or more, default 0.0
        The largest circumradius in space, in the unit of the points; 0: no limit. See `lines` and `vertices` of the
        result.
    maximum_error : float, 0 or more, default 0.0
        Leave out points as long as the surface differs at none of them by more than this, vertically (in a fitted
        plane: along its normal), in the unit of z. Corners of the convex hull and points of constraints stay. Not with
        `insertion_limit`, `alpha` or the mean of `duplicates`. 0: all points.
    maximum_vertices : int, 0 or more, default 0
        The best surface of at most so many points: those are left out without which it differs least from all. With
        `maximum_error`, too, it ends at whichever comes first. Points that stay in any case are never too many. 0: no
        limit.
    second_pass : bool, default False
        With `maximum_error` or `maximum_vertices`: at the end take points out again as long as the error stays within
        the bound. It takes longer, and leaves 5 to 20 % fewer.
    rim : {'automatic', 'convex_hull', 'trimmed'}, default 'automatic'
        Where the surface ends without loops. 'trimmed': without the flat triangles (an angle above 158.2 degrees) along
        the hull. 'automatic': the convex hull in the plane 'xy', and in the best-fitting one if all points have the
        same z, x or y; else trimmed. Nothing is trimmed with `bounding` or limits on the size of triangles.
    tolerance : float from 0 to 1, default 0.0
        Merge points closer to each other than this fraction of the diagonal of the bounding box of all; 0: coinciding
        points are duplicates, and none is merged.
    duplicates : {'first', 'lowest_z', 'highest_z', 'mean_z'}, default 'first'
        Which of several points at one place is the vertex: the one with the smallest id; with the lowest or highest
        finite z; with the smallest id, moved to the mean of all with a finite z.
    voronoi_clip : {'hull', 'bounds'} or (n, 2) array, default 'hull'
        Clip the Voronoi cells at the convex hull of the points; at their bounding box in the plane; or at a convex
        polygon of these corners there, of two at the box between them. A geometry may stand for the corners.
    insertion_order : {'adaptive_hilbert', 'multi_grid', 'regular_grid', 'as_given'}, default 'adaptive_hilbert'
        The order of insertion. This and the next three change the time, never the triangles.
    nmax : int, 1 or more, default 50
        Boxes of the grid with more points are divided.
    control_points : {'off', 'single_level', 'every_level'}, default 'every_level'
        Points inserted before all others.
    gene_rotation : bool, default True
        Turn the curve in each box to connect to the boxes before and after.
    count_work : bool, default False
        Count np and nr, see `Triangulation.measures`. One thread inserts.
    insertion_limit : int, 0 or more, default 0
        Insert only so many points of the order; 0: all.
    offset : float, 0.75 or more, default 1.0
        The distance of the points of `bounding` from the centre of the bounding box, in diagonals of it.
    bounding : bool, default False
        Add eight points on a circle around all others, `offset` diagonals of their bounding box away. In 'xy' only.
    threads : int from 0 to 1024, default 0
        Number of threads; 0: as the environment said at first use (ADAPTIVEHILBERTDELAUNAY_THREADS, else
        VTK_SMP_MAX_THREADS, else OMP_NUM_THREADS), at most and by default one for each processor that the process may
        run on. The result is the same.
    memory_limit : int, 0 or more, or str, default 0
        The most memory to allocate, in bytes or as a text such as '2 GB' (KB, MB, GB of 1000, KiB, MiB, GiB of 1024);
        0: what the process can get without swapping.
    id_dtype : numpy.int32 or numpy.int64, default numpy.int32
        The type of all ids in the result. 32 bits are always enough.
    want : sequence of str, optional
        Results to compute in this call: 'point_status', 'errors', 'constraint_edges', 'regions', 'neighbors',
        'voronoi', 'order', 'boxes', 'insertion_ranks'. All are available later, too; 'voronoi', 'order', 'boxes' and
        'insertion_ranks' then triangulate once more.
    progress : function of (str, float), optional
        Called with the phase ('merge', 'split', 'read', 'sort', 'insert', 'constrain', 'extract', 'outputs') and the
        fraction done, 0 to 1, about every hundredth, in this thread. To stop the work, raise an exception.

    Returns
    -------
    Triangulation

    Raises
    ------
    ValueError
        An array has the wrong shape, an id is not the id of a point, a value is out of range, there are too many
        points.
    TypeError
        An array or a value has the wrong type.
    MemoryError
        There is not enough memory, or `memory_limit` allows less than needed: then before the work, unless the need
        is only known while segments are split or inserted.
    KeyboardInterrupt
        Ctrl-C, at once.

    Warns
    -----
    DelaunayWarning
        Rejected points, segments that were left out, no triangle, ...: see there.

    Notes
    -----
    Other Python threads run while the engine works, and several calls may run at once. The arrays must not be changed
    meanwhile.

    Examples
    --------
    >>> import numpy as np
    >>> from adaptivehilbertdelaunay import delaunay
    >>> square = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2], [3, 2]], float)
    >>> made = delaunay(square)
    >>> made.triangles.shape, made.edges.shape, sorted(made.hull.tolist())
    ((6, 3), (11, 2), [0, 1, 2, 3])

    A constraint; an outline with a notch:

    >>> delaunay(square, segments=[(0, 2)]).constraint_edges.tolist()
    [[0, 2]]
    >>> notched = delaunay(square, loops=[(0, 1, 2, 3, 4)])
    >>> len(notched.triangles), notched.boundary.shape
    (5, (5, 2))
    """
    return triangulate({**locals()})
