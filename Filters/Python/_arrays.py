# SPDX-License-Identifier: BSD-3-Clause
"""Delaunay triangulation of NumPy arrays."""

from __future__ import annotations

from typing import Any, Callable, Optional, Sequence, Union

import numpy as np

from ._input import DEFAULTS, Plane, Request
from ._library import release_memory
from ._names import by_any_name
from ._results import Boxes, Kind, Location, Voronoi
from ._triangulation import WANTED, Triangulation
from ._warnings import DelaunayWarning, warn

__all__ = ["Boxes", "DelaunayWarning", "Kind", "Location", "Triangulation", "Voronoi", "delaunay", "release_memory"]


@by_any_name()
def delaunay(
    points: Any,
    *,
    segments: Any = None,
    lines: Any = None,
    loops: Any = None,
    source_points: Any = None,
    skip: Any = None,
    crossings: str = "leave_out",
    fill_rule: str = "even_odd",
    closed_lines_are_loops: bool = False,
    source_heights: str = "own",
    plane: Plane = "xy",
    rim: str = "automatic",
    duplicates: str = "first",
    tolerance: float = 0.0,
    alpha: float = 0.0,
    maximum_edge_length: float = 0.0,
    bounding: bool = False,
    offset: float = 1.0,
    insertion_order: str = "adaptive_hilbert",
    nmax: int = 50,
    control_points: str = "every_level",
    gene_rotation: bool = True,
    insertion_limit: int = 0,
    count_work: bool = False,
    voronoi_clip: str = "hull",
    id_dtype: Any = np.int32,
    want: Union[str, Sequence[str]] = (),
    threads: int = 0,
    memory_limit: int = 0,
    progress: Optional[Callable[[str, float], Any]] = None,
) -> Triangulation:
    """The Delaunay triangulation of points in the plane: exact, and the same to the byte on any machine.

    Triangles are counterclockwise and cover the convex hull; points on its edges are corners of triangles. Of points
    at one place one is the vertex (see `duplicates`). Where four or more lie on one circle, their coordinates decide
    which triangulation is taken. Shuffling the points changes ids, nothing else.

    Parameters
    ----------
    points : (n, 2) or (n, 3) array of real numbers, n at most 2**28 - 2
        x, y and perhaps z, in any one unit. float32 and float64 are not copied, whatever their strides (but those whose
        coordinates do not lie side by side); other types are converted to float64. A point whose x or y is NaN or
        infinite is no vertex, and a warning counts them. Do not change arrays while the triangulation is in use.
    segments : (m, 2) array of int, optional
        Pairs of ids that become edges. A segment that passes through points becomes several edges.
    lines : sequence of sequences of int, or (c, w) array, optional
        Open chains of ids, such as breaklines: each pair of successive ones is a segment. A flat sequence is one line.
    loops : sequence of sequences of int, or (c, w) array, optional
        Closed chains, whose last point is joined to the first: outlines and holes. They are edges too, and bound what
        is kept (see `fill_rule`).
    source_points : (m, 2) or (m, 3) array of real numbers, optional
        Points of the constraints. The ids in segments, lines and loops are then rows of these, and all of them are
        triangulated with the others; their ids in the result go on where those of `points` end.
    skip : (n,) array of bool or uint8, optional
        Points that are left out are those where it is not zero.
    crossings : {'leave_out', 'split'}, default 'leave_out'
        What is done where segments cross. 'leave_out': the later one is no constraint, a loop that has it bounds
        nothing, and a warning says so (segments come before lines, lines before loops). 'split': a point is added.
    fill_rule : {'even_odd', 'orientation'}, default 'even_odd'
        What loops keep. 'even_odd': what is inside an odd number of loops, whichever way they run. 'orientation': what
        is on the left of every loop edge that bounds it, and what no loop bounds.
    closed_lines_are_loops : bool, default False
        Are lines that end where they begin loops?
    source_heights : {'own', 'surface'}, default 'own'
        'surface': z of the source points, where they lie on the triangulation of the others, is interpolated there.
    plane : {'xy', 'best_fit'}, (4, 4) array or function, default 'xy'
        Where to triangulate: x and y; the plane of least squares of distances (of points that all have one z, or one
        x or y, the two other coordinates as they are); x and y after the matrix is applied to (x, y, z, 1); x and y of
        what the function gives. It is called with (k, 3) float64, k at most 2**14, which it changes in place or returns
        anew: the place in the plane and the height above it. Exactness is for the numbers in that plane, in float64.
    rim : {'automatic', 'convex_hull', 'trimmed'}, default 'automatic'
        'trimmed': without the flat triangles (an angle above 153.4 degrees) along the hull. 'automatic': the convex
        hull in the plane 'xy', and in 'best_fit' of points that all have one z, x or y; else trimmed. Nothing is
        trimmed with alpha, maximum_edge_length or bounding.
    duplicates : {'first', 'lowest_z', 'highest_z', 'mean_z'}, default 'first'
        Which of several points at one place is the vertex: that of smallest id; of lowest or highest finite z; of
        smallest id, moved to the mean of all that have a finite z.
    tolerance : float from 0 to 1, default 0.0
        Merge points nearer to each other than this part of the diagonal of the bounding box of all; 0: those that
        coincide are duplicates, and none is merged.
    alpha : float, 0 or more, default 0.0
        Keep triangles whose circumradius in space is not greater, in the unit of the points; 0: all. See `lines` and
        `vertices` of the result.
    maximum_edge_length : float, 0 or more, default 0.0
        Keep triangles whose edges in the plane are not longer; 0: all.
    bounding : bool, default False
        Add eight points on a circle around all others, `offset` diagonals of their bounding box away. In 'xy' only.
    offset : float, 0.75 or more, default 1.0
        How far out the points of `bounding` lie.
    insertion_order : {'adaptive_hilbert', 'multi_grid', 'regular_grid', 'as_given'}, default 'adaptive_hilbert'
        This and the next three change the time, never the triangles.
    nmax : int, 1 or more, default 50
        A box of the grid with more points is divided.
    control_points : {'off', 'single_level', 'every_level'}, default 'every_level'
        Which points are inserted before all others.
    gene_rotation : bool, default True
        Does the curve turn in each box to meet its neighbours?
    insertion_limit : int, 0 or more, default 0
        Stop after so many points of the insertion order; 0: all.
    count_work : bool, default False
        Count np and nr, see `Triangulation.measures`. One thread inserts.
    voronoi_clip : {'hull', 'bounds'}, default 'hull'
        See `Triangulation.voronoi`.
    id_dtype : numpy.int32 or numpy.int64, default numpy.int32
        The type of all ids in the result. 32 bits are always enough.
    want : sequence of str, optional
        What to make in this call: 'neighbors', 'constraint_edges', 'regions', 'point_status', 'insertion_ranks',
        'order', 'boxes', 'voronoi'. All can be asked for later too; the last four then triangulate once more.
    threads : int from 0 to 1024, default 0
        How many work; 0: one for each processor that the process may run on. The result is the same.
    memory_limit : int, 0 or more, default 0
        Bytes that may be taken; 0: what the process can get without swapping.
    progress : function of (str, float), optional
        Is told the phase ('merge', 'split', 'read', 'sort', 'insert', 'constrain', 'extract', 'outputs') and the
        fraction that is done, 0 to 1, about each hundredth and in this thread. To stop the work, raise an exception.

    Returns
    -------
    Triangulation

    Raises
    ------
    ValueError
        An array is of another shape, an id is that of no point, a value is out of its range, there are too many points.
    TypeError
        An array or a value is of another type.
    MemoryError
        There is not enough memory, or `memory_limit` allows less than is needed: then at once, but for what shows
        while segments are split or inserted.
    KeyboardInterrupt
        Ctrl-C: at once.

    Warns
    -----
    DelaunayWarning
        Points that are not finite, segments that were left out, no triangle, ...: see there.

    Notes
    -----
    Other Python threads go on while the engine works. Several calls may be at work at once. The arrays are not to be
    changed meanwhile.

    Examples
    --------
    >>> import numpy as np
    >>> from adaptivehilbertdelaunay import delaunay
    >>> square = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2], [3, 2]], float)
    >>> made = delaunay(square)
    >>> made.triangles.shape, made.edges.shape, sorted(made.hull.tolist())
    ((6, 3), (11, 2), [0, 1, 2, 3])

    A constraint; an outline with a notch:

    >>> delaunay(square, segments=[(0, 2)]).constraint_edges
    array([[0, 2]], dtype=int32)
    >>> notched = delaunay(square, loops=[(0, 1, 2, 3, 4)])
    >>> len(notched.triangles), notched.boundary.shape
    (5, (5, 2))
    """
    given = {name: value for name, value in locals().items() if name in DEFAULTS}
    chains = {"segments": segments, "lines": lines, "loops": loops}
    dtype = np.dtype(id_dtype)
    if dtype not in (np.int32, np.int64) or not dtype.isnative:
        raise TypeError("id_dtype must be numpy.int32 or numpy.int64, not %s" % dtype)
    wanted = (want,) if isinstance(want, str) else tuple(want)
    for name in wanted:
        if name not in WANTED:
            raise ValueError("want: %r is none of %s" % (name, ", ".join(map(repr, WANTED))))
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function, not %r" % (progress,))
    request = Request(points, skip, source_points, chains, plane, given)
    made = Triangulation(request, dtype, wanted, progress)
    warn(made._job)
    return made
