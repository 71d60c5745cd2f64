# SPDX-License-Identifier: BSD-3-Clause
"""The filters for PyVista: `mesh.adaptive.delaunay_2d()`, `voronoi_2d()`, `to_raster()` and `sample()`.

PyVista from 0.48 on finds this module by itself (entry point `pyvista.accessors`); with an older one, or where the
package is not installed but on the path, `import adaptivehilbertdelaunay.pyvista` does it.
"""

import functools
import importlib
import inspect
import math
import operator
import re
import warnings

import numpy
import pyvista

from . import _raster, _vtk
from ._names import by_any_name, value_of
from ._input import CHOICES, real_of
from ._sampling import METHODS
from ._vtk.table import ARRAY_KEYWORDS
from ._warnings import DelaunayWarning, _depth

__all__ = ["Adaptive", "delaunay_2d", "sample", "to_raster", "voronoi_2d"]

NAME = "adaptive"

PLANES = ("xy", "automatic", "best_fit")
#: The words of an argument, in the order of the filter's numbers.
WORDS = {**CHOICES, "heights": CHOICES["source_heights"], "clip": CHOICES["voronoi_clip"],
         "closed_lines": ("lines", "loops"), "plane": PLANES, "method": METHODS, "outside": ("none", "nearest")}


def _number_of(value, argument):
    words = WORDS[argument]
    value = value_of(argument, value)
    if value not in words:
        raise ValueError("%s=%r: it is one of %s" % (argument, value, ", ".join(map(repr, words))))
    return words.index(value)


class _Messages:
    """Makes the filter's errors exceptions and its warnings DelaunayWarnings, once it has run."""

    def __init__(self, algorithm, package):
        core = importlib.import_module(package + ".vtkCommonCore")
        self._said = []

        def keep(_caller, event, text):
            self._said.append((event, text.split("): ", 1)[-1].strip()))
        keep.CallDataType = core.VTK_STRING
        for event in ("WarningEvent", "ErrorEvent"):
            algorithm.AddObserver(event, keep)

    def tell(self):
        for event, text in self._said:
            if event == "ErrorEvent":
                raise MemoryError(_with_keyword(text)) if "memory" in text else RuntimeError(text)
        for _, text in self._said:
            warnings.warn(text, DelaunayWarning, stacklevel=_depth())


def _with_keyword(text):
    """Of `memory_limit`, in bytes, in place of the filter's MemoryLimit, in KiB."""
    text = text.replace("MemoryLimit of Triangulation", "memory_limit").replace("MemoryLimit", "memory_limit")
    return re.sub(r"(\d+) or more \(KiB\)", lambda found: "%d or more (bytes)" % (1024 * int(found[1])), text)


def _is_flat(mesh):
    """Do all points have the same z?"""
    points = mesh.points
    return len(points) == 0 or bool((points[:, 2] == points[0, 2]).all())


def _check_points(mesh):
    """TypeError for a mesh without points of its own."""
    if not mesh.IsA("vtkCompositeDataSet") and not mesh.IsA("vtkPointSet"):
        raise TypeError("a mesh with points of its own is needed, not %s; cast_to_structured_grid() or "
                        "cast_to_unstructured_grid() give it some" % type(mesh).__name__)


def _make_filter(mesh, plane, tol, duplicates, threads, memory_limit):
    """A filter of the mesh's VTK, and its messages. TypeError for a mesh without points of its own."""
    package = _vtk.package_of(mesh)
    algorithm = _vtk.vtk_class("vtkAdaptiveHilbertDelaunay2D", package)()
    _check_points(mesh)
    if mesh.IsA("vtkCompositeDataSet"):
        algorithm.MergeBlocksOn()
    algorithm.SetInputDataObject(mesh)
    if isinstance(plane, str):
        plane = PLANES[_number_of(plane, "plane")]
        flat = plane == "automatic" and mesh.IsA("vtkPointSet") and _is_flat(mesh)
        fits = plane != "xy" and not flat
        algorithm.SetProjectionPlaneMode(2 if fits else 0)
    else:
        if not (hasattr(plane, "IsA") and plane.IsA("vtkAbstractTransform")):
            raise TypeError("plane must be one of %s, or a vtkAbstractTransform, not %r" % (
                ", ".join(map(repr, PLANES)), plane))
        algorithm.SetProjectionPlaneMode(1)
        algorithm.SetTransform(plane)
    algorithm.SetTolerance(real_of("tol", tol, (0.0, 1.0)))
    algorithm.SetDuplicatePolicy(_number_of(duplicates, "duplicates"))
    algorithm.SetNumberOfThreads(_whole(threads, "threads", 1024))
    algorithm.SetMemoryLimit(-(-_whole(memory_limit, "memory_limit", 2**63 - 1) // 1024))
    algorithm.KeepTriangulationOff()
    algorithm.SetReuseLimit(0)
    return algorithm, _Messages(algorithm, package)


def _whole(value, argument, most):
    """A whole number from 0 on. TypeError, ValueError."""
    try:
        number = operator.index(value)
    except TypeError:
        wanted = "number of bytes" if argument == "memory_limit" else "number"
        raise TypeError("%s must be a whole %s, not %r" % (argument, wanted, value)) from None
    if not 0 <= number <= most:
        raise ValueError("%s must be from 0 to %d, not %r" % (argument, most, value))
    return number


def _set(algorithm, **settings):
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)


def _arrays_to_add(names):
    """Settings of the filter, for the names of arrays."""
    names = [names] if isinstance(names, str) else list(names)
    for name in names:
        if name not in ARRAY_KEYWORDS:
            raise ValueError("arrays: no %r; there are %s" % (name, ", ".join(map(repr, ARRAY_KEYWORDS))))
    return {ARRAY_KEYWORDS[name]: True for name in names}


def _bound_surface(algorithm, port, to_constrain, *, edge_source=None, constraints=None, crossings="leave_out",
                   closed_lines="loops", fill_rule="even_odd", heights="own", rim="automatic", alpha=0.0,
                   maximum_edge_length=0.0):
    """Sets constraints and limits of the surface. The constraints go to a port of `to_constrain`."""
    _set(algorithm, Alpha=real_of("alpha", alpha), AlphaLines=0, AlphaVerts=0,
         MaximumEdgeLength=real_of("maximum_edge_length", maximum_edge_length),
         CrossingMode=_number_of(crossings, "crossings"),
         ClosedLines=_number_of(closed_lines, "closed_lines"),
         FillRule=_number_of(fill_rule, "fill_rule"), Rim=_number_of(rim, "rim"),
         SourceHeights=_number_of(heights, "heights"))
    if edge_source is not None and constraints is not None:
        raise ValueError("edge_source refers to the mesh's points, constraints have their own: give one of them")
    if constraints is not None:
        algorithm.SetSourceModeToCoordinates()
    for argument, given in (("edge_source", edge_source), ("constraints", constraints)):
        if given is not None and not (hasattr(given, "IsA") and (
                given.IsA("vtkPolyData") or given.IsA("vtkCompositeDataSet"))):
            raise TypeError("%s must be a pyvista.PolyData, or a MultiBlock of these, not %s" % (
                argument, type(given).__name__))
    if edge_source is not None or constraints is not None:
        to_constrain.SetInputDataObject(port, constraints if edge_source is None else edge_source)


BOUNDS_OF_SURFACE = tuple(inspect.signature(_bound_surface).parameters)[3:]


def _run(algorithm, messages, progress_bar, title):
    if progress_bar:
        with pyvista.ProgressMonitor(algorithm, message=title):
            algorithm.Update()
    else:
        algorithm.Update()
    messages.tell()


def _taken(output):
    """A PyVista mesh of the output, without the filter's measures."""
    made = pyvista.wrap(output)
    fields = made.GetFieldData()
    for i in range(fields.GetNumberOfArrays() - 1, -1, -1):
        if (fields.GetArrayName(i) or "").startswith(("NumberOf", "SampleSeconds")):
            fields.RemoveArray(i)
    return made


def _into(mesh, made, inplace):
    if not inplace:
        return made
    mesh.copy_from(made, deep=False)
    return mesh


@by_any_name()
def delaunay_2d(mesh, tol=0.0, alpha=0.0, offset=1.0, bound=False, inplace=False, edge_source=None, progress_bar=False,
                *, constraints=None, crossings="leave_out", closed_lines="loops", fill_rule="even_odd", heights="own",
                plane="automatic", rim="automatic", duplicates="first", maximum_edge_length=0.0, arrays=(),
                threads=0, memory_limit=0):
    """Triangulate the points of a mesh, exactly; the first arguments are PyVista's, in its order.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own; its cells are ignored. The points of all blocks are triangulated together.
    tol : float, default: 0.0
        Points closer to another than this fraction (0 to 1) of the diagonal of the bounding box are merged. PyVista's
        default is 1e-5; here only points that coincide exactly are merged.
    alpha : float, default: 0.0
        The largest circumradius of a triangle; 0: no limit.
    offset : float, default: 1.0
        The distance of the points of `bound` from the centre of the bounding box, in diagonals; at least 0.75.
    bound : bool, default: False
        Add eight points around all others, in the plane x, y only.
    inplace : bool, default: False
        Overwrite the mesh, a pyvista.PolyData.
    edge_source : pyvista.PolyData, optional
        Constraints whose lines and polygons refer to the points of the mesh, by their ids.
    progress_bar : bool, default: False
        Show a progress bar.
    constraints : pyvista.PolyData or pyvista.MultiBlock, optional
        Constraints with points of their own, which are triangulated too and follow those of the mesh.
    crossings : {"leave_out", "split"}
        Of two constraints that cross, leave out the later one with a warning, or split both at an added point.
    closed_lines : {"loops", "lines"}
        Whether lines that end where they begin are outlines, like polygons, or just lines.
    fill_rule : {"even_odd", "orientation"}
        What outlines keep: the inside of an odd number of them, or, as in VTK, the left side of each.
    heights : {"own", "surface"}
        The z of the points of `constraints`: their own, or that of the surface of the mesh's points.
    plane : {"automatic", "best_fit", "xy"} or vtkAbstractTransform
        The plane of the triangulation: the best-fitting plane, x and y ("xy"), or x and y of the transformed points;
        "automatic": x and y if all z are the same, otherwise the best-fitting plane. The points keep their positions.
    rim : {"automatic", "convex_hull", "trimmed"}
        Where the surface ends without outlines: at the convex hull, or without the flat triangles along it;
        "automatic": at the hull in x, y, and in the best-fitting plane of points that all have the same z, x or y;
        otherwise trimmed, as these triangles would stand as walls.
    duplicates : {"first", "lowest_z", "highest_z", "mean_z"}
        Which of several points at one place in the plane is in the surface: the one with the smallest id, with the
        lowest or highest z, or the one with the smallest id at the mean of all z.
    maximum_edge_length : float, default: 0.0
        The longest edge of a triangle in the plane; 0: no limit.
    arrays : iterable of {"status", "rank", "constraint_edges", "regions", "neighbors"}
        Arrays to add: point data "Fate" and "InsertionRank", cell data "ConstraintEdges", "RegionId" and "Neighbors".
    threads : int, default: 0
        Number of threads; 0: one for each processor.
    memory_limit : int, default: 0
        The most bytes to allocate; 0: all available memory.

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
    if inplace and not isinstance(mesh, pyvista.PolyData):
        raise TypeError("inplace: a pyvista.PolyData can be overwritten, not %s" % type(mesh).__name__)
    algorithm, messages = _make_filter(mesh, plane, tol, duplicates, threads, memory_limit)
    _set(algorithm, Offset=real_of("offset", offset), BoundingTriangulation=int(bool(bound)), **_arrays_to_add(arrays))
    _bound_surface(algorithm, 1, algorithm, edge_source=edge_source, constraints=constraints, crossings=crossings,
                   closed_lines=closed_lines, fill_rule=fill_rule, heights=heights, rim=rim, alpha=alpha,
                   maximum_edge_length=maximum_edge_length)
    _run(algorithm, messages, progress_bar, "Computing 2D Triangulation")
    return _into(mesh, _taken(algorithm.GetOutput()), inplace)


@by_any_name()
def voronoi_2d(mesh, tol=0.0, clip="hull", *, plane="automatic", duplicates="first", threads=0, memory_limit=0,
               progress_bar=False):
    """The Voronoi diagram of the points of a mesh.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own.
    tol, plane, duplicates, threads, memory_limit, progress_bar
        As in `delaunay_2d`.
    clip : {"hull", "bounds"}
        Clip the outer cells at the convex hull of the points, or at their bounding box in the plane.

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
    algorithm, messages = _make_filter(mesh, plane, tol, duplicates, threads, memory_limit)
    algorithm.GenerateVoronoiOn()
    algorithm.SetVoronoiClip(_number_of(clip, "clip"))
    _run(algorithm, messages, progress_bar, "Computing Voronoi Diagram")
    return _taken(algorithm.GetOutput(2))


def _interpolate(mesh, places, raster, method, outside, no_value, gradients, elevation, plane, tol, duplicates, threads,
                 memory_limit, progress_bar, bounds_of_surface):
    """The output of vtkAdaptiveHilbertInterpolation2D, with settings of its raster."""
    unknown = [name for name in bounds_of_surface if name not in BOUNDS_OF_SURFACE]
    if unknown:
        raise TypeError("unknown argument: %r" % unknown[0])
    if not isinstance(elevation, str):
        raise TypeError("elevation must be a name, a str, not %r" % (elevation,))
    triangulation, _ = _make_filter(mesh, plane, tol, duplicates, threads, memory_limit)
    triangulation.SetInputDataObject(None)
    package = _vtk.package_of(mesh)
    algorithm = _vtk.vtk_class("vtkAdaptiveHilbertInterpolation2D", package)()
    messages = _Messages(algorithm, package)
    algorithm.SetTriangulation(triangulation)
    algorithm.SetInputDataObject(mesh)
    if places is not None:
        algorithm.SetInputDataObject(1, places)
    _bound_surface(triangulation, 2, algorithm, **bounds_of_surface)
    _set(algorithm, Method=_number_of(method, "method"), Outside=_number_of(outside, "outside"),
         NoValue=no_value, GenerateGradients=bool(gradients), HeightArrayName=elevation, **raster)
    _run(algorithm, messages, progress_bar, "Interpolating")
    return _taken(algorithm.GetOutputDataObject(0))


def _raster_settings(cell_size, shape, bounds, align):
    if (cell_size is None) == (shape is None):
        raise ValueError("the raster needs a size: give cell_size, or shape=(rows, columns)")
    made = {"UseBounds": bounds is not None}
    if cell_size is not None:
        made.update(RasterSize=1, CellSize=_raster.size_of(cell_size), AlignToCellSize=bool(align))
    else:
        rows, columns = _raster.shape_of(shape, 1)
        if align:
            raise ValueError("align needs cell_size, but shape is given")
        made.update(RasterSize=0, Dimensions=(columns, rows))
    if bounds is not None:
        given = tuple(bounds)[:4] if numpy.ndim(bounds) == 1 else bounds  # of those of a mesh, without its z
        xmin, xmax, ymin, ymax = made["Bounds"] = _raster.bounds_of(given)
        if xmin == xmax or ymin == ymax:
            raise ValueError("bounds must have an area, not %r" % (bounds,))
    return made


@by_any_name(*BOUNDS_OF_SURFACE)
def to_raster(mesh, cell_size=None, *, shape=None, bounds=None, align=False, method="linear", outside="none",
              no_value=math.nan, gradients=False, surface=False, elevation="Elevation", plane="xy", tol=0.0,
              duplicates="first", threads=0, memory_limit=0, progress_bar=False, **bounds_of_surface):
    """Heights and point data of scattered points on a raster (a DEM), by their exact Delaunay triangulation.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own; its cells are ignored, and the points of all blocks are one surface.
    cell_size : float or (float, float), optional
        The size of a cell along x and y, in the unit of the points. As many cells as cover the bounds.
    shape : (int, int), optional
        Instead of `cell_size`: the number of rows and columns of cells that fill the bounds.
    bounds : (float, float, float, float), optional
        xmin, xmax, ymin, ymax of the raster; if there are more numbers, as in the bounds of a mesh, the first four.
        Default: those of the points.
    align : bool, default: False
        Align the borders of cells with multiples of `cell_size`, like GDAL's -tap, so that the cells of several surveys
        coincide.
    method : {"linear", "natural", "laplace", "nearest"}
        The method: linear in each triangle; natural neighbours (Sibson), smooth except at the points; the same
        neighbours with Laplace's weights; the value of the nearest point.
    outside : {"none", "nearest"}
        The values outside the surface: none, or those of the nearest point.
    no_value : float, default: NaN
        The number where there is no value.
    gradients : bool, default: False
        Add slopes: for the heights and each array of one component "<name>Gradient", d/dx and d/dy. With "linear" only.
    surface : bool, default: False
        Return the raster as a surface with its points at their heights, hidden where there is no value.
    elevation : str, default: "Elevation"
        The name of the array of heights. Empty: none.
    plane : {"xy", "best_fit", "automatic"} or vtkAbstractTransform
        The plane, as in `delaunay_2d`. The raster lies in that plane.
    tol, duplicates, threads, memory_limit, progress_bar
        As in `delaunay_2d`.
    **bounds_of_surface
        Constraints and limits, as in `delaunay_2d`: edge_source, constraints, crossings, closed_lines, fill_rule,
        heights, rim, alpha, maximum_edge_length.

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
    raster = _raster_settings(cell_size, shape, bounds, align)
    return _interpolate(mesh, None, dict(raster, OutputType=int(bool(surface))), method, outside, no_value, gradients,
                        elevation, plane, tol, duplicates, threads, memory_limit, progress_bar, bounds_of_surface)


def _places_of(places):
    """A mesh of places: of arrays its points, at z = 0 where they have none."""
    if isinstance(places, pyvista.DataSet):
        return places
    if isinstance(places, pyvista.MultiBlock):
        raise TypeError("places are one mesh or an array, not a MultiBlock: its combine() is one mesh")
    xyz = _raster.real_numbers("places", places)
    if xyz.shape == (0,):
        xyz = xyz.reshape(0, 3)
    if xyz.ndim == 1 and xyz.size in (2, 3):
        xyz = xyz[None]
    if xyz.ndim != 2 or xyz.shape[1] not in (2, 3):
        raise ValueError("places are a mesh or an array of shape (k, 2) or (k, 3), not %s" % (xyz.shape,))
    return pyvista.PolyData(numpy.c_[xyz, numpy.zeros((len(xyz), 3 - xyz.shape[1]))])


@by_any_name(*BOUNDS_OF_SURFACE)
def sample(mesh, places, *, method="linear", outside="none", no_value=math.nan, gradients=False,
           elevation="Elevation", plane="xy", tol=0.0, duplicates="first", threads=0, memory_limit=0,
           progress_bar=False, **bounds_of_surface):
    """Heights and point data of scattered points at other places, such as the points of a line: a profile.

    The values are those of the points of `mesh`; PyVista's own `sample` works in the other direction.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        With points of its own, as in `to_raster`.
    places : pyvista.DataSet or array-like of shape (k, 2) or (k, 3)
        The points at which to interpolate, by x and y.
    method, outside, no_value, gradients, elevation, plane, tol, duplicates, threads, memory_limit, progress_bar
        As in `to_raster`.
    **bounds_of_surface
        As in `to_raster`.

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
    return _interpolate(mesh, _places_of(places), {}, method, outside, no_value, gradients, elevation, plane, tol,
                        duplicates, threads, memory_limit, progress_bar, bounds_of_surface)


def _method(function):
    """A method of the accessor: with the signature and docstring of the function, for its mesh."""

    @functools.wraps(function)
    def method(self, *arguments, **more):
        return function(self._mesh, *arguments, **more)

    signature = inspect.signature(function)
    mesh, *others = signature.parameters.values()
    method.__signature__ = signature.replace(parameters=[mesh.replace(name="self"), *others])
    return method


class Adaptive:
    """What this package makes of a mesh: `mesh.adaptive`."""

    def __init__(self, mesh):
        self._mesh = mesh

    delaunay_2d = _method(delaunay_2d)
    voronoi_2d = _method(voronoi_2d)
    to_raster = _method(to_raster)
    sample = _method(sample)


def _register():
    for kind in (pyvista.DataSet, pyvista.MultiBlock):
        if hasattr(pyvista, "register_dataset_accessor"):
            pyvista.register_dataset_accessor(NAME, kind)(Adaptive)
        else:
            setattr(kind, NAME, property(Adaptive, doc=Adaptive.__doc__))


_register()
