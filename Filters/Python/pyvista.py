# SPDX-License-Identifier: BSD-3-Clause
# Made by Filters/Settings/generate.py: change what is there, not this.
"""The filters for PyVista: `mesh.adaptive.delaunay_2d()`, `voronoi_2d()`, `to_raster()`, `sample()` and `refine()`.

PyVista from 0.48 on finds this module by itself (entry point `pyvista.accessors`); with an older one, or where the
package is not installed but on the path, `import adaptivehilbertdelaunay.pyvista` does it.
"""

from __future__ import annotations

import functools
import inspect
import math
from typing import Any, Iterable, Literal, Optional, Union

import pyvista

from . import _meshes
from ._input import Corners
from ._names import Function, by_any_name
from ._sampling import Method

# Transforms are of any VTK.
Outside = Literal["none", "nearest", "boundary"]

__all__ = ["Adaptive", "delaunay_2d", "refine", "sample", "to_raster", "voronoi_2d"]

NAME = "adaptive"


@by_any_name()
def delaunay_2d(
    mesh: Any,
    tol: float = 0.0,
    alpha: float = 0.0,
    offset: float = 1.0,
    bound: bool = False,
    inplace: bool = False,
    edge_source: Any = None,
    progress_bar: bool = False,
    *,
    constraints: Any = None,
    plane: Any = "automatic",
    heights: Literal["own", "surface", "mixed"] = "own",
    zero_is_missing: bool = False,
    lines_on_surface: bool = True,
    max_segment_length: float = 0.0,
    closed_lines: Literal["lines", "loops"] = "loops",
    points_as_line: bool = False,
    fill_rule: Literal["orientation", "even_odd"] = "even_odd",
    crossings: Literal["leave_out", "split"] = "leave_out",
    maximum_edge_length: float = 0.0,
    rim: Literal["automatic", "convex_hull", "trimmed"] = "automatic",
    duplicates: Literal["first", "lowest_z", "highest_z", "mean_z"] = "first",
    threads: int = 0,
    memory_limit: Union[int, str] = 0,
    maximum_error: float = 0.0,
    maximum_vertices: int = 0,
    second_pass: bool = False,
    values: Optional[str] = None,
    weights: Optional[str] = None,
    keep: Optional[str] = None,
    arrays: Union[str, Iterable[str]] = (),
) -> pyvista.PolyData:
    """Triangulate the points of a mesh, exactly; the first arguments are PyVista's, in its order.

    PyVista's default of `tol` is 1e-5; here only points that coincide exactly are merged.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own; its cells are ignored. The points of all blocks are triangulated together.
    tol : float from 0 to 1, default 0.0
        Merge points closer to each other than this fraction of the diagonal of the bounding box of all; 0: coinciding
        points are duplicates, and none is merged.
    alpha : float, 0 or more, default 0.0
        The largest circumradius of a triangle in space; 0: no limit.
    offset : float, 0.75 or more, default 1.0
        The distance of the points of `bound` from the centre of the bounding box, in diagonals of it.
    bound : bool, default False
        Add eight points on a circle around all others, `offset` diagonals of their bounding box away. In 'xy' only.
    inplace : bool, default False
        Overwrite the mesh, a pyvista.PolyData.
    edge_source : pyvista.PolyData, optional
        Constraints whose lines and polygons refer to the points of the mesh, by their ids.
    progress_bar : bool, default False
        Show a progress bar.
    constraints : pyvista.PolyData, pyvista.MultiBlock or geometry, optional
        Constraints with points of their own, which are triangulated too and follow those of the mesh. A geometry is
        anything with `__geo_interface__` (shapely's, a GeoDataFrame), a mapping as in GeoJSON, a ring as an array of
        coordinates, or a sequence of these: `help(adaptivehilbertdelaunay.delaunay)` says how they are taken. Where
        none has a z, their points lie on the surface (`heights` is 'surface'), or at the mesh's own z if it is flat;
        where some have one, those of the others do (it is 'mixed', unless 'surface').
    plane : {"automatic", "best_fit", "xy"} or vtkAbstractTransform
        The plane of the triangulation: the best-fitting plane, x and y ("xy"), or x and y of the transformed points;
        "automatic": x and y, or for points that stand like a wall the best-fitting plane, with a warning. Like a wall:
        seen from above a line or a narrow strip, where z is no function of x and y. The points keep their positions.
    heights : {'own', 'surface', 'mixed'}, default 'own'
        The z of the constraints' own points. 'own': as given. 'surface': interpolated on the surface of all others,
        where they lie on it. 'mixed': as given, or where z is NaN, interpolated on the surface of all others and the
        constraints between points with z.
    zero_is_missing : bool, default False
        With `heights` 'mixed', points of the constraints with z = 0 have no height, like those with NaN.
    lines_on_surface : bool, default True
        With `heights` 'surface' or 'mixed', add a point where a constraint crosses an edge of the surface that heights
        come from, so that it follows the terrain. Otherwise it is straight.
    max_segment_length : float, 0 or more, default 0.0
        Divide longer segments of the constraints into equal parts, in the plane, by added points. 0: no limit.
    closed_lines : {'lines', 'loops'}, default 'loops'
        Whether lines that end where they begin, alone or joined end to end, are outlines, like polygons, or just lines.
    points_as_line : bool, default False
        Take the points of `constraints` as one line, in their order, if it has nothing but points.
    fill_rule : {'orientation', 'even_odd'}, default 'even_odd'
        The regions that loops keep. 'even_odd': those inside an odd number of loops, whatever their direction.
        'orientation': those on the left of every loop edge that bounds them, and those that no loop bounds.
    crossings : {'leave_out', 'split'}, default 'leave_out'
        Of two constraints that cross, leave out the later one with a warning, or split both at an added point.
    maximum_edge_length : float, 0 or more, default 0.0
        The longest edge of a triangle in the plane; 0: no limit.
    rim : {'automatic', 'convex_hull', 'trimmed'}, default 'automatic'
        Where the surface ends without loops. 'trimmed': without the flat triangles (an angle above 158.2 degrees) along
        the hull. 'automatic': the convex hull in the plane 'xy', and in the best-fitting one if all points have the
        same z, x or y; else trimmed. Nothing is trimmed with `bound` or limits on the size of triangles.
    duplicates : {'first', 'lowest_z', 'highest_z', 'mean_z'}, default 'first'
        Which of several points at one place is the vertex: the one with the smallest id; with the lowest or highest
        finite z; with the smallest id, moved to the mean of all with a finite z.
    threads : int from 0 to 1024, default 0
        Number of threads; 0: as the environment said at first use (ADAPTIVEHILBERTDELAUNAY_THREADS, else
        VTK_SMP_MAX_THREADS, else OMP_NUM_THREADS), at most and by default one for each processor that the process may
        run on. The result is the same.
    memory_limit : int, 0 or more, or str, default 0
        The most memory to allocate, in bytes or as a text such as '2 GB' (KB, MB, GB of 1000, KiB, MiB, GiB of 1024);
        0: what the process can get without swapping.
    maximum_error : float, 0 or more, default 0.0
        Leave out points as long as the surface differs at none of them by more than this, vertically (in a fitted
        plane: along its normal), in the unit of z. Corners of the convex hull and points of constraints stay. The
        result has only the points of its triangles, with their ids as point data "OriginalPointIds", and the field data
        "LargestError"; with 'status' or 'errors' among `arrays` all points. Not with `alpha` or the mean of
        `duplicates`. 0: all points.
    maximum_vertices : int, 0 or more, default 0
        The best surface of at most so many points: those are left out without which it differs least from all. With
        `maximum_error`, too, it ends at whichever comes first. Points that stay in any case are never too many. 0: no
        limit.
    second_pass : bool, default False
        With `maximum_error` or `maximum_vertices`: at the end take points out again as long as the error stays within
        the bound. It takes longer, and leaves 5 to 20 % fewer.
    values, weights, keep : str, optional
        Point arrays with one number for each point: that of which `maximum_error` is the error, in place of z; times
        which errors count; not 0 where the point stays. A point stays, too, where its value or weight is NaN, or its
        weight negative.
    arrays : iterable of {'status', 'errors', 'rank', 'constraint_edges', 'regions', 'neighbors'}
        Arrays to add: point data "Fate" ('status'), "Error" ('errors'), "InsertionRank" ('rank'); cell data
        "ConstraintEdges" ('constraint_edges'), "RegionId" ('regions'), "Neighbors" ('neighbors').

    Returns
    -------
    pyvista.PolyData
        All points, ids and point data of the mesh, and triangles that are counterclockwise in the plane.

    Raises
    ------
    MemoryError: not enough memory, or `memory_limit` allows less. RuntimeError: more than 2^28 - 2 points.
    TypeError, ValueError: an argument is not as described above.

    Warns
    -----
    DelaunayWarning: rejected points, constraints that are left out, no triangle and the like, with numbers.
    """
    return _meshes.delaunay_2d(**locals())


@by_any_name()
def voronoi_2d(
    mesh: Any,
    tol: float = 0.0,
    clip: Union[Literal["hull", "bounds"], Corners] = "hull",
    *,
    plane: Any = "automatic",
    duplicates: Literal["first", "lowest_z", "highest_z", "mean_z"] = "first",
    threads: int = 0,
    memory_limit: Union[int, str] = 0,
    progress_bar: bool = False,
) -> pyvista.PolyData:
    """The Voronoi diagram of the points of a mesh.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own.
    tol, duplicates, threads, memory_limit
        As in `delaunay_2d`.
    plane, progress_bar
        As in `delaunay_2d`.
    clip : {'hull', 'bounds'} or (n, 2) array, default 'hull'
        Clip the Voronoi cells at the convex hull of the points; at their bounding box in the plane; or at a convex
        polygon of these corners there, of two at the box between them. A geometry may stand for the corners.

    Returns
    -------
    pyvista.PolyData
        A convex polygon for each vertex, with the point data of that point as cell data, and its id as
        "OriginalPointIds".

    Raises
    ------
    MemoryError, RuntimeError, TypeError, ValueError: as `delaunay_2d`.

    Warns
    -----
    DelaunayWarning: as `delaunay_2d`.
    """
    return _meshes.voronoi_2d(**locals())


@by_any_name()
def to_raster(
    mesh: Any,
    cell_size: Any = None,
    *,
    shape: Any = None,
    bounds: Any = None,
    align: bool = False,
    method: Method = "linear",
    outside: Outside = "none",
    no_value: float = math.nan,
    gradients: bool = False,
    surface: bool = False,
    elevation: str = "Elevation",
    plane: Any = "xy",
    edge_source: Any = None,
    constraints: Any = None,
    heights: Literal["own", "surface", "mixed"] = "own",
    zero_is_missing: bool = False,
    lines_on_surface: bool = True,
    max_segment_length: float = 0.0,
    closed_lines: Literal["lines", "loops"] = "loops",
    points_as_line: bool = False,
    fill_rule: Literal["orientation", "even_odd"] = "even_odd",
    crossings: Literal["leave_out", "split"] = "leave_out",
    maximum_edge_length: float = 0.0,
    alpha: float = 0.0,
    rim: Literal["automatic", "convex_hull", "trimmed"] = "automatic",
    tol: float = 0.0,
    duplicates: Literal["first", "lowest_z", "highest_z", "mean_z"] = "first",
    threads: int = 0,
    memory_limit: Union[int, str] = 0,
    progress_bar: bool = False,
) -> Any:
    """Heights and point data of scattered points on a raster (a DEM), by their exact Delaunay triangulation.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own; its cells are ignored, and the points of all blocks are one surface.
    cell_size : float or (float, float), optional
        The size of a cell along x and y, in the unit of the points. As many cells as cover the bounds.
    shape : (int, int), optional
        Instead of `cell_size`: the number of rows and columns of cells that fill the bounds.
    bounds : (float, float, float, float) or what has an area, optional
        xmin, xmax, ymin, ymax of the raster; if there are more numbers, as in the bounds of a mesh, the first four.
        Default: those of the points. Or a geometry, an adaptivehilbertdelaunay.Raster or rasterio's BoundingBox.
        Numbers in the order of shapely and rasterio, xmin, ymin, xmax, ymax, are refused where the points tell.
    align : bool, default False
        Align the borders of cells with multiples of `cell_size`, like GDAL's -tap, so that the cells of several surveys
        coincide.
    method : {"linear", "natural", "laplace", "nearest"}
        The method: linear in each triangle; natural neighbours (Sibson), smooth except at the points; the same
        neighbours with Laplace's weights; the value of the nearest point.
    outside : {"none", "nearest", "boundary"}
        The values outside the surface: none, those of the nearest point (not across a hole or outline), or those at the
        nearest place of the surface. Places outside by no more than rounding have values anyway.
    no_value : float, default NaN
        The number where there is no value.
    gradients : bool, default False
        Add slopes: for the heights and each array of one component "<name>Gradient", d/dx and d/dy. With "linear" only.
    surface : bool, default False
        Return the raster as a surface with its points at their heights, hidden where there is no value.
    elevation : str, default "Elevation"
        The name of the array of heights. Empty: none.
    plane : {"xy", "best_fit", "automatic"} or vtkAbstractTransform
        The plane, as in `delaunay_2d`. The raster lies in that plane.
    edge_source, constraints, progress_bar
        As in `delaunay_2d`.
    heights, zero_is_missing, lines_on_surface, max_segment_length, closed_lines, points_as_line, fill_rule
        As in `delaunay_2d`.
    crossings, maximum_edge_length, alpha, rim
        As in `delaunay_2d`.
    tol, duplicates, threads, memory_limit
        As in `delaunay_2d`.

    Returns
    -------
    pyvista.ImageData
        Its points are the centres of the cells (pixel is area), with the heights, all numeric point data, and
        "vtkValidPointMask", 1 on the surface and 0 outside. ``mesh["Elevation"].reshape(rows, columns)`` begins with
        the southernmost row. With `surface` a pyvista.StructuredGrid.

    Raises
    ------
    MemoryError, RuntimeError, TypeError, ValueError: as `delaunay_2d`.

    Warns
    -----
    DelaunayWarning: as `delaunay_2d`; no cell on the surface, point data that are not numeric, and the like.
    """
    return _meshes.to_raster(**locals())


@by_any_name()
def sample(
    mesh: Any,
    places: Any,
    *,
    method: Method = "linear",
    outside: Outside = "none",
    no_value: float = math.nan,
    gradients: bool = False,
    elevation: str = "Elevation",
    plane: Any = "xy",
    edge_source: Any = None,
    constraints: Any = None,
    heights: Literal["own", "surface", "mixed"] = "own",
    zero_is_missing: bool = False,
    lines_on_surface: bool = True,
    max_segment_length: float = 0.0,
    closed_lines: Literal["lines", "loops"] = "loops",
    points_as_line: bool = False,
    fill_rule: Literal["orientation", "even_odd"] = "even_odd",
    crossings: Literal["leave_out", "split"] = "leave_out",
    maximum_edge_length: float = 0.0,
    alpha: float = 0.0,
    rim: Literal["automatic", "convex_hull", "trimmed"] = "automatic",
    tol: float = 0.0,
    duplicates: Literal["first", "lowest_z", "highest_z", "mean_z"] = "first",
    threads: int = 0,
    memory_limit: Union[int, str] = 0,
    progress_bar: bool = False,
) -> Any:
    """Heights and point data of scattered points at other places, such as the points of a line: a profile.

    The values are those of the points of `mesh`; PyVista's own `sample` works in the other direction.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own, as in `to_raster`.
    places : pyvista.DataSet or array-like of shape (k, 2) or (k, 3)
        The points at which to interpolate, by x and y.
    method, outside, no_value, gradients, elevation, plane, edge_source, constraints, progress_bar
        As in `to_raster`.
    heights, zero_is_missing, lines_on_surface, max_segment_length, closed_lines, points_as_line, fill_rule
        As in `delaunay_2d`.
    crossings, maximum_edge_length, alpha, rim
        As in `delaunay_2d`.
    tol, duplicates, threads, memory_limit
        As in `delaunay_2d`.

    Returns
    -------
    pyvista.DataSet
        The places with their data, and the interpolated values as point data.

    Raises
    ------
    MemoryError, RuntimeError, TypeError, ValueError: as `to_raster`.

    Warns
    -----
    DelaunayWarning: as `to_raster`.
    """
    return _meshes.sample(**locals())


@by_any_name()
def refine(
    mesh: Any,
    minimum_angle: float = 20.0,
    *,
    maximum_area: Optional[float] = None,
    maximum_length: Optional[float] = None,
    sizes: Any = None,
    maximum_added: Optional[int] = None,
    segments: bool = False,
    edge_source: Any = None,
    constraints: Any = None,
    plane: Any = "automatic",
    heights: Literal["own", "surface", "mixed"] = "own",
    zero_is_missing: bool = False,
    lines_on_surface: bool = True,
    max_segment_length: float = 0.0,
    closed_lines: Literal["lines", "loops"] = "loops",
    points_as_line: bool = False,
    fill_rule: Literal["orientation", "even_odd"] = "even_odd",
    crossings: Literal["leave_out", "split"] = "leave_out",
    rim: Literal["automatic", "convex_hull", "trimmed"] = "automatic",
    tol: float = 0.0,
    duplicates: Literal["first", "lowest_z", "highest_z", "mean_z"] = "first",
    threads: int = 0,
    memory_limit: Union[int, str] = 0,
    progress_bar: bool = False,
) -> Any:
    """A mesh to compute on: the points of a mesh and its constraints are triangulated, and points are added until no
    angle is smaller and no triangle is larger than wished.

    All triangles that loops of the constraints leave are refined; lines stay in their places and are divided where
    needed. Angles between lines and loops stay as they are.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own; its cells are ignored. The points of all blocks are triangulated together.
    minimum_angle : float, 0 to 34, default 20
        In degrees. It ends by theorem up to 20.7, where lines meet in 60 degrees or more, and in practice up to 34:
        give `maximum_added` above 30.
    maximum_area, maximum_length : float, greater than 0, optional
        Of a triangle, and of an edge, in the plane.
    sizes : str or (m,) array, optional
        The longest edge wished at each point, linear between them: the name of an array of the points, and of those of
        constraints if these bring their own; or numbers for the points of the mesh, which get them as "sizes". All are
        finite and greater than 0.
    maximum_added : int, 0 or more, optional
        Added points. Triangles that are not as wished by then have a "BadReason".
    segments : bool, default False
        Return the edges along lines and loops, too.
    edge_source, constraints, plane, progress_bar
        As in `delaunay_2d`.
    heights, zero_is_missing, lines_on_surface, max_segment_length, closed_lines, points_as_line, fill_rule
        As in `delaunay_2d`.
    crossings, rim
        As in `delaunay_2d`.
    tol, duplicates, threads, memory_limit
        As in `delaunay_2d`.

    Returns
    -------
    pyvista.PolyData
        Triangles, and all points, in double precision: those of the mesh with their ids, those of the constraints,
        crossings, and the added ones; with point data in between, and "OriginalPointIds", -1 for all but the first.
        Cell data: "RegionId", the region between lines; "BadReason": -1, or why a triangle is not as wished, a
        `BadReason`. With `segments` a tuple of it and a pyvista.PolyData of lines, with the same points; cell data:
        "SourceCell", the cell of the constraints that each lies on, or -1; "IsBoundary": does it bound the mesh?

    Raises
    ------
    MemoryError: not enough memory, or `memory_limit` allows less. RuntimeError: more than 2^28 - 2 points.
    TypeError, ValueError: an argument is not as described above.

    Warns
    -----
    DelaunayWarning: as `delaunay_2d`.
    """
    return _meshes.refine(**locals())


@by_any_name()
def outline(
    mesh: Any, groups: Any = None, *, memory_limit: int = 0, progress_bar: bool = False
) -> pyvista.PolyData:
    """The outline of a surface as polygons with holes: of `delaunay_2d`, of an alpha shape, of bands between contours.

    Rings are simple, and which is outer is exact. A polygon is a largest set of cells joined by edges; polygons that
    touch at a vertex only are two.

    Parameters
    ----------
    mesh : pyvista.PolyData
        With triangles or other polygons.
    groups : str, optional
        An array of the cells with one number each: polygons are of cells with equal numbers, and cells with NaN are
        left out. Default: all are alike.
    memory_limit : int, default 0
        Bytes; 0: what the process can get.
    progress_bar : bool, default False
        Show a progress bar.

    Returns
    -------
    pyvista.PolyData
        A closed line for each ring, with the cell data "PolygonId", "IsHole" and `groups`. The outer ring of a polygon
        comes first, counterclockwise in x, y; its holes run clockwise.

    Raises
    ------
    MemoryError: not enough memory, or `memory_limit` allows less. TypeError, ValueError: an argument is not as
    described above.

    Warns
    -----
    DelaunayWarning: cells that are left out or cannot join, with numbers.
    """
    return _meshes.outline(**locals())


def _method(function: Function) -> Function:
    """A method of the accessor: with the signature and docstring of the function, for its mesh."""

    @functools.wraps(function)
    def method(self: Adaptive, *arguments: Any, **more: Any) -> Any:
        return function(self._mesh, *arguments, **more)

    signature = inspect.signature(function)
    mesh, *others = signature.parameters.values()
    setattr(method, "__signature__", signature.replace(parameters=[mesh.replace(name="self"), *others]))
    return method  # type: ignore[return-value]


class Adaptive:
    """What this package makes of a mesh: `mesh.adaptive`."""

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    delaunay_2d = _method(delaunay_2d)
    voronoi_2d = _method(voronoi_2d)
    to_raster = _method(to_raster)
    sample = _method(sample)
    refine = _method(refine)
    outline = _method(outline)


def _register() -> None:
    for kind in (pyvista.DataSet, pyvista.MultiBlock):
        if hasattr(pyvista, "register_dataset_accessor"):
            pyvista.register_dataset_accessor(NAME, kind)(Adaptive)
        else:
            setattr(kind, NAME, property(Adaptive, doc=Adaptive.__doc__))


_register()
