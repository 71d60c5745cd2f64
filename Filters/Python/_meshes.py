# SPDX-License-Identifier: BSD-3-Clause
"""What the functions of `mesh.adaptive` (pyvista.py) do: VTK's filters on PyVista's meshes. `settings` are the keywords
that are one number or word each, but for `memory_limit`."""

import importlib
import operator
import re
from typing import Any

import numpy
import pyvista

from . import _raster, _vtk
from ._found import count_of, limit_of
from ._geometry import constraints_of
from ._input import PLANES, bytes_of, chosen_plane, polygon_of, real_of, refuse_conflict
from ._interface import (
    HEIGHTS_FROM_SURFACE, HEIGHTS_MIXED, HEIGHTS_OWN, PLANE_BEST_FIT, SAY_TRIANGULATION, WORDS_OF_CLASS, WORDS_OF_NUMPY,
    say, threads_told)
from ._keywords import MESH_KEYWORDS
from ._names import value_of
from ._sampling import METHODS, OUTSIDE
from ._vtk.arrays import coordinates, ghost_marks
from ._vtk.blocks import Blocks
from ._vtk.execution import SKIPPED, threads_to_use
from ._vtk.table import ARRAY_KEYWORDS
from ._warnings import tell

#: The words of an argument, in the order of the filter's numbers.
WORDS = {**{name: row.words for name, row in MESH_KEYWORDS.items() if row.words},
         "plane": PLANES, "method": METHODS, "outside": ("none", *OUTSIDE)}


def _number_of(value, argument):
    words = WORDS[argument]
    value = value_of(argument, value)
    if value not in words:
        raise ValueError("%s=%r: it is one of %s" % (argument, value, ", ".join(map(repr, words))))
    return words.index(value)


class _Messages:
    """Makes the filter's errors exceptions and its warnings DelaunayWarnings, once it has run."""

    def __init__(self, algorithm, package, before=()):
        core = importlib.import_module(package + ".vtkCommonCore")
        self._said = list(before)
        # closed_lines="loops" is the default: lines that are not closed are no fault
        usual = say(SAY_TRIANGULATION, WORDS_OF_CLASS, {"lines_unclosed": 1}).values()

        def keep(_caller, event, text):
            text = text.split("): ", 1)[-1].strip()
            if text not in usual:
                self._said.append((event, text))
        keep.CallDataType = core.VTK_STRING
        for event in ("WarningEvent", "ErrorEvent"):
            algorithm.AddObserver(event, keep)

    def tell(self):
        for event, text in self._said:
            if event == "ErrorEvent":
                raise MemoryError(_with_keyword(text)) if "memory" in text else RuntimeError(text)
        tell(text for _, text in self._said)


def _with_keyword(text):
    """Of `memory_limit`, in bytes, in place of the filter's MemoryLimit, in KiB."""
    text = text.replace("MemoryLimit of Triangulation", "memory_limit").replace("MemoryLimit", "memory_limit")
    return re.sub(r"(\d+) or more \(KiB\)", lambda found: "%d or more (bytes)" % (1024 * int(found[1])), text)


def _stand_like_a_wall(mesh, threads):
    """The points of a mesh, of all its blocks."""
    backend = _vtk.Backend(_vtk.package_of(mesh))
    blocks = Blocks(backend, mesh).blocks if mesh.IsA("vtkCompositeDataSet") else [mesh]
    points = [coordinates(backend, block.GetPoints()) for block in blocks]
    marks = [ghost_marks(block)[0] for block in blocks]
    marks = [numpy.zeros(len(own), numpy.uint8) if of is None else of & SKIPPED for own, of in zip(points, marks)]
    return bool(points) and PLANE_BEST_FIT == chosen_plane(
        *(of[0] if len(of) == 1 else numpy.concatenate(of) for of in (points, marks)), threads)


def _check_points(mesh):
    """TypeError for a mesh without points of its own."""
    if not mesh.IsA("vtkCompositeDataSet") and not mesh.IsA("vtkPointSet"):
        raise TypeError("a mesh with points of its own is needed, not %s; cast_to_structured_grid() or "
                        "cast_to_unstructured_grid() give it some" % type(mesh).__name__)


def _make_filter(mesh, plane, memory_limit, settings):
    """A filter of the mesh's VTK, and its messages. TypeError for a mesh without points of its own."""
    package = _vtk.package_of(mesh)
    algorithm = _vtk.vtk_class("vtkAdaptiveHilbertDelaunay2D", package)()
    said = []
    _check_points(mesh)
    if mesh.IsA("vtkCompositeDataSet"):
        algorithm.MergeBlocksOn()
    algorithm.SetInputDataObject(mesh)
    if isinstance(plane, str):
        plane = PLANES[_number_of(plane, "plane")]
        is_wall = plane == "automatic" and _stand_like_a_wall(mesh, _whole(settings["threads"], "threads", 1024))
        said += say(SAY_TRIANGULATION, WORDS_OF_NUMPY, {"plane_was_chosen": int(is_wall)}).values()
        algorithm.SetProjectionPlaneMode(2 if is_wall or plane == "best_fit" else 0)
    else:
        if not (hasattr(plane, "IsA") and plane.IsA("vtkAbstractTransform")):
            raise TypeError("plane must be one of %s, or a vtkAbstractTransform, not %r" % (
                ", ".join(map(repr, PLANES)), plane))
        algorithm.SetProjectionPlaneMode(1)
        algorithm.SetTransform(plane)
    _set(algorithm, AlphaLines=0, AlphaVerts=0, **_settings_of(settings))
    algorithm.SetMemoryLimit(-(-_whole(memory_limit, "memory_limit", 2**63 - 1) // 1024))
    algorithm.KeepTriangulationOff()
    algorithm.SetReuseLimit(0)
    return algorithm, _Messages(algorithm, package, [("WarningEvent", text) for text in said])


def _whole(value, argument, most):
    """A whole number from 0 on. TypeError, ValueError."""
    try:
        number = operator.index(bytes_of(value) if argument == "memory_limit" else value)
    except TypeError:
        wanted = "number of bytes, or a text such as '2 GB'" if argument == "memory_limit" else "number"
        raise TypeError("%s must be a whole %s, not %r" % (argument, wanted, value)) from None
    if not 0 <= number <= most:
        raise ValueError("%s must be from 0 to %d, not %r" % (argument, most, value))
    return number


def _threads(value):
    """As the environment says where it is 0, but not more than VTK was told."""
    number, told = _whole(value, "threads", MESH_KEYWORDS["threads"].most), threads_told()
    return number or (told and min(told, threads_to_use(_vtk.Backend(_vtk.package_in_use()), 0)))


def _settings_of(given):
    """Settings of the filter, for keywords that are one number or word each. TypeError, ValueError."""
    made = {}
    for name, value in given.items():
        row = MESH_KEYWORDS[name]
        made[row.setting] = (
            _number_of(value, name) if row.words else int(bool(value)) if row.least is None
            else _threads(value) if name == "threads" else _whole(value, name, row.most) if isinstance(row.least, int)
            else real_of(name, value, (row.least, row.most)))
    return made


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


def _constrain(algorithm, port, to_constrain, edge_source, constraints, mesh):
    """Gives the constraints, if any, to a port of `to_constrain`."""
    if edge_source is not None and constraints is not None:
        raise ValueError("edge_source refers to the mesh's points, constraints have their own: give one of them")
    if constraints is not None:
        algorithm.SetSourceModeToCoordinates()
        if not hasattr(constraints, "IsA"):
            constraints = _mesh_of(constraints, algorithm, mesh)
    for argument, given in (("edge_source", edge_source), ("constraints", constraints)):
        if given is not None and not (hasattr(given, "IsA") and (
                given.IsA("vtkPolyData") or given.IsA("vtkCompositeDataSet"))):
            raise TypeError("%s must be a pyvista.PolyData, or a MultiBlock of these, not %s" % (
                argument, type(given).__name__))
    if edge_source is not None or constraints is not None:
        to_constrain.SetInputDataObject(port, constraints if edge_source is None else edge_source)


def _mesh_of(constraints, algorithm, mesh):
    """Geometries as a pyvista.PolyData. Where none has a z, they lie on the surface: of a mesh in one height at that,
    else they take theirs from it, as do those without a z where others have one."""
    made = constraints_of(constraints)
    points = made.source(True)
    if made.points.shape[1] == 2:
        low, high = mesh.bounds[4:6]
        if low == high:
            points[:, 2] = low
        else:
            algorithm.SetSourceHeights(HEIGHTS_FROM_SURFACE)
    elif algorithm.GetSourceHeights() == HEIGHTS_OWN and numpy.isnan(points[:, 2]).any():
        algorithm.SetSourceHeights(HEIGHTS_MIXED)
    cells = {name: numpy.concatenate([numpy.r_[len(chain), chain] for chain in chains])
             for name, chains in (("lines", made.lines), ("faces", made.loops)) if chains}
    return pyvista.PolyData(points, **cells)


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


def _name_numbers(algorithm, mesh, names):
    """The arrays of numbers by which it simplifies, by the filter's settings."""
    for setting, (argument, name) in names.items():
        if name is not None and not isinstance(name, str):
            raise TypeError("%s must be the name of a point array, a str, not %r" % (argument, name))
        if name is not None and hasattr(mesh, "point_data") and name not in mesh.point_data:
            raise ValueError("%s: the points have no array %r; there are %s" % (
                argument, name, mesh.point_data.keys()))
        _set(algorithm, **{setting: name or ""})


def _into(mesh, made, inplace):
    if not inplace:
        return made
    mesh.copy_from(made, deep=False)
    return mesh


def delaunay_2d(mesh: Any, inplace: Any, edge_source: Any, progress_bar: Any, constraints: Any, plane: Any,
                memory_limit: Any, values: Any, weights: Any, keep: Any, arrays: Any, **settings: Any
                ) -> pyvista.PolyData:
    if inplace and not isinstance(mesh, pyvista.PolyData):
        raise TypeError("inplace: a pyvista.PolyData can be overwritten, not %s" % type(mesh).__name__)
    algorithm, messages = _make_filter(mesh, plane, memory_limit, settings)
    simplified = algorithm.GetMaximumError(), algorithm.GetMaximumNumberOfVertices()
    refuse_conflict(0, algorithm.GetAlpha(), algorithm.GetDuplicatePolicy(), *simplified)
    _set(algorithm, **_arrays_to_add(arrays))
    _name_numbers(algorithm, mesh, {"ValueArrayName": ("values", values), "WeightArrayName": ("weights", weights),
                                    "KeepArrayName": ("keep", keep)})
    _constrain(algorithm, 1, algorithm, edge_source, constraints, mesh)
    _run(algorithm, messages, progress_bar, "Computing 2D Triangulation")
    made = _taken(algorithm.GetOutput())
    if any(simplified):
        made.field_data.set_array([algorithm.GetLargestError()], "LargestError")
    return _into(mesh, made, inplace)


def voronoi_2d(
    mesh: Any, plane: Any, memory_limit: Any, progress_bar: Any, clip: Any, **settings: Any
) -> pyvista.PolyData:
    corners = None if isinstance(clip, str) else polygon_of("clip", clip)
    settings["clip"] = clip if corners is None else "hull"
    algorithm, messages = _make_filter(mesh, plane, memory_limit, settings)
    algorithm.GenerateVoronoiOn()
    if corners is not None:
        algorithm.SetVoronoiClipToPolygon()
        algorithm.SetVoronoiPolygon(", ".join("%r %r" % tuple(corner) for corner in corners.tolist()))
    _run(algorithm, messages, progress_bar, "Computing Voronoi Diagram")
    return _taken(algorithm.GetOutput(2))


def _sizes_of(mesh, sizes):
    """The mesh, and the name of the array with these. ValueError, TypeError."""
    if isinstance(sizes, str):
        parts = mesh if isinstance(mesh, pyvista.MultiBlock) else [mesh]
        if not all(part is None or sizes in part.point_data for part in parts):
            raise ValueError("sizes: the points have no array %r" % (sizes,))
        return mesh, sizes
    if isinstance(mesh, pyvista.MultiBlock):
        raise TypeError("sizes of a MultiBlock are the name of an array that its blocks have")
    numbers = _raster.real_numbers("sizes", sizes)
    if numbers.shape != (mesh.n_points,):
        raise ValueError("sizes must be one number for each of %d points, not of shape %s" % (
            mesh.n_points, numbers.shape))
    mesh = mesh.copy(deep=False)
    mesh.point_data["sizes"] = numbers
    return mesh, "sizes"


def refine(mesh: Any, minimum_angle: Any, maximum_area: Any, maximum_length: Any, sizes: Any, maximum_added: Any,
           segments: Any, edge_source: Any, constraints: Any, plane: Any, memory_limit: Any, progress_bar: Any,
           **settings: Any) -> Any:
    _check_points(mesh)
    mesh, name = (mesh, "") if sizes is None else _sizes_of(mesh, sizes)
    wishes = dict(
        MinimumAngle=real_of("minimum_angle", minimum_angle, (0.0, 34.0)),
        MaximumArea=limit_of("maximum_area", maximum_area), MaximumLength=limit_of("maximum_length", maximum_length),
        SizeArrayName=name,
        MaximumNumberOfAddedPoints=-1 if maximum_added is None else min(
            count_of("maximum_added", maximum_added), 2**31 - 1))
    algorithm, messages = _with_triangulation("vtkAdaptiveHilbertQualityMesh2D", mesh, plane, memory_limit, settings)
    _set(algorithm, **wishes)
    _constrain(algorithm.GetTriangulation(), 1, algorithm, edge_source, constraints, mesh)
    try:
        _run(algorithm, messages, progress_bar, "Computing Quality Mesh")
    except RuntimeError as error:
        raise (ValueError if str(error).startswith("The size at") else RuntimeError)(str(error)) from None
    made = _taken(algorithm.GetOutput(0))
    return (made, _taken(algorithm.GetOutput(1))) if segments else made


def outline(mesh: Any, groups: Any, memory_limit: Any, progress_bar: Any) -> pyvista.PolyData:
    if not isinstance(mesh, pyvista.PolyData):
        raise TypeError("an outline is that of a pyvista.PolyData, not of %s: extract_surface() makes one"
                        % type(mesh).__name__)
    if groups is not None and groups not in mesh.cell_data:
        raise ValueError("groups: the cells have no array %r; there are %s" % (groups, mesh.cell_data.keys()))
    package = _vtk.package_of(mesh)
    algorithm = _vtk.vtk_class("vtkPlanarSurfaceOutline", package)()
    messages = _Messages(algorithm, package)
    algorithm.SetInputDataObject(mesh)
    _set(algorithm, GroupArrayName=groups or "",
         MemoryLimit=-(-_whole(memory_limit, "memory_limit", 2**63 - 1) // 1024))
    _run(algorithm, messages, progress_bar, "Computing Outline")
    return _taken(algorithm.GetOutput())


def _with_triangulation(name, mesh, plane, memory_limit, settings):
    """A filter of this name with a triangulation, for this mesh, and its messages."""
    triangulation, messages = _make_filter(mesh, plane, memory_limit, settings)
    triangulation.SetInputDataObject(None)
    package = _vtk.package_of(mesh)
    algorithm = _vtk.vtk_class(name, package)()
    algorithm.SetTriangulation(triangulation)
    algorithm.SetInputDataObject(mesh)
    return algorithm, _Messages(algorithm, package, messages._said)


def _interpolate(mesh, places, raster, method, outside, no_value, gradients, elevation, plane, edge_source, constraints,
                 memory_limit, progress_bar, **settings):
    """The output of vtkAdaptiveHilbertInterpolation2D, with settings of its raster."""
    if not isinstance(elevation, str):
        raise TypeError("elevation must be a name, a str, not %r" % (elevation,))
    algorithm, messages = _with_triangulation("vtkAdaptiveHilbertInterpolation2D", mesh, plane, memory_limit, settings)
    if places is not None:
        algorithm.SetInputDataObject(1, places)
    _constrain(algorithm.GetTriangulation(), 2, algorithm, edge_source, constraints, mesh)
    _set(algorithm, Method=_number_of(method, "method"), Outside=_number_of(outside, "outside"),
         NoValue=no_value, GenerateGradients=bool(gradients), HeightArrayName=elevation, **raster)
    _run(algorithm, messages, progress_bar, "Interpolating")
    return _taken(algorithm.GetOutputDataObject(0))


def _raster_settings(mesh, plane, cell_size, shape, bounds, align):
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
        given = tuple(bounds)[:4] if numpy.ndim(bounds) == 1 and len(bounds) > 4 else bounds  # of a mesh, without z
        if plane == "xy":
            _raster.check_order(given, lambda: mesh.bounds[:4])
        xmin, xmax, ymin, ymax = made["Bounds"] = _raster.bounds_of(given)
        if xmin == xmax or ymin == ymax:
            raise ValueError("bounds must have an area, not %r" % (bounds,))
    return made


def to_raster(mesh: Any, cell_size: Any, shape: Any, bounds: Any, align: Any, surface: Any, **more: Any) -> Any:
    raster = _raster_settings(mesh, more["plane"], cell_size, shape, bounds, align)
    return _interpolate(mesh, None, dict(raster, OutputType=int(bool(surface))), **more)


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


def sample(mesh: Any, places: Any, **more: Any) -> Any:
    return _interpolate(mesh, _places_of(places), {}, **more)
