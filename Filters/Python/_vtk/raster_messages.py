# SPDX-License-Identifier: BSD-3-Clause
"""What vtkAdaptiveHilbertInterpolation2D has to say, word for word as the compiled class
(Filters/Sampling/vtkAHDSampleMessages.cxx)."""

import types

from . import messages, raster
from .arrays import GHOSTS
from .columns import GRADIENT


def _box(box):
    return "nowhere" if box is None else "x %.9g to %.9g, y %.9g to %.9g" % tuple(box)


def _names(names):
    """"a, b and 3 more"."""
    words = ", ".join(names[:5])
    return words if len(names) <= 5 else "%s and %d more" % (words, len(names) - 5)


def of_raster(fault, values):
    """Why there is no raster; None where only points are missing."""
    size = "%.9g, %.9g" % values["CellSize"]
    if fault.kind == raster.CELL_SIZE:
        return "CellSize is %s, but both numbers must be greater than 0 and finite. Nothing was computed." % size
    if fault.kind == raster.BOUNDS:
        return ("Bounds are %s, but they must be finite, the first of each two below the second. Nothing was "
                "computed." % _box(values["Bounds"]))
    if fault.kind == raster.TOO_MANY:
        return ("With a CellSize of %s the raster would have %.9g x %.9g cells, but 2147483647 along x and y are the "
                "most. Nothing was computed." % ((size,) + fault.wished))
    if fault.kind == raster.TOO_WIDE:
        return ("The raster would be wider or higher than the largest number of double precision, 1.8e+308. Nothing "
                "was computed.")
    if fault.kind == raster.OUT_OF_NUMBERS:
        return ("A raster of %.9g x %.9g cells has coordinates that double precision cannot tell apart. Nothing was "
                "computed." % fault.wished)
    return None


def of_names(values):
    """Why arrays that are made cannot have their names; None where they can."""
    heights, mask = values["HeightArrayName"], values["ValidPointMaskArrayName"]
    for setting in ("HeightArrayName", "ValidPointMaskArrayName"):
        if values[setting] == GHOSTS:
            return '%s is "%s", the name of the marks by which VTK hides points. Nothing was computed.' % (
                setting, GHOSTS)
    if mask and mask == heights:
        return ('HeightArrayName and ValidPointMaskArrayName are both "%s", but two arrays cannot have one name. '
                "Nothing was computed." % mask)
    if heights and values["GenerateGradients"] and values["Method"] == 0 and mask == heights + GRADIENT:
        return ('ValidPointMaskArrayName is "%s", the name of the gradients of the heights. Nothing was computed.'
                % mask)
    return None


def of_memory(places, points, estimate, limit, is_limited, is_refused):
    """KiB that are too many, or that were not enough. `places`: in words."""
    if not is_refused:
        return ("Out of memory while interpolating at %s from %d points; about %s are needed. Take a larger "
                "CellSize, smaller Dimensions, fewer places or points." % (
                    places, points, messages.needed_in_words(estimate)))
    return ("Interpolating at %s from %d points may take %s of memory, but %s. Nothing was computed. Take a "
            "larger CellSize, smaller Dimensions, fewer places or points, %s" % (
                places, points, messages.needed_in_words(estimate),
                messages.but_allowed(limit, is_limited, "of Triangulation "), messages.or_set_limit(estimate)))


def of_arrays(values, columns):
    """Of arrays that are passed over, and of gradients that there are none of."""
    if columns.unfit:
        yield ("Point arrays that are no numbers, have no name or not one tuple for each point are not interpolated: "
               "%s." % _names(columns.unfit))
    if columns.replaced:
        yield ("Point arrays of the input whose names are those of arrays that are made are not interpolated: %s. See "
               "HeightArrayName and ValidPointMaskArrayName." % _names(columns.replaced))
    if values["GenerateGradients"] and values["Method"] != 0:
        yield "There are no gradients: only the Method Linear has them."


def together(found, more):
    """What places and others on the same surface came to; None: nothing yet."""
    if found is None:
        return more
    counts = {name: getattr(found, name) + getattr(more, name) for name in (
        "places", "valued", "outside", "not_finite", "without_value", "left_out")}
    boxes = [box for box in (found.wanted, more.wanted) if box is not None]
    wanted = tuple(end(box[k] for box in boxes) for k, end in enumerate((min, max, min, max))) if boxes else None
    return types.SimpleNamespace(
        triangles=more.triangles, wanted=wanted, surface=found.surface or more.surface,
        missing=_missing_together(found.missing + more.missing), **counts)


def _missing_together(all_missing):
    """One for each name."""
    made = {}
    for one in all_missing:
        made[one.name] = made[one.name].and_others(one) if one.name in made else one
    return list(made.values())


def _of_missing(begin, each):
    return begin + _names(each) + "." if each else ""


def of_places(found):
    """Of places and values, in order. `found`: places, valued, outside, not_finite, without_value, left_out, triangles,
    wanted and surface, the boxes of the places and of the points, and missing, of which arrays values are."""
    if found.not_finite:
        yield "%d of %d places have no value, since their x or y is NaN or infinite." % (
            found.not_finite, found.places)
    if found.outside and not found.valued:
        triangles = " of %d triangles" % found.triangles if found.triangles else ""
        yield "None of %d places is on the surface%s. Places: %s; points: %s." % (
            found.places, triangles, _box(found.wanted), _box(found.surface))
    lack, missing = " Points that were added (of the source, for example) lack ", found.missing
    if found.without_value:
        heights = " height" if any(one.places == 1 and not one.name for one in missing) else " heights"
        names = [str(one.places) + (" of " + one.name if one.name else heights) for one in missing if one.places]
        no_height = "" if any(one.places and not one.name for one in missing) else " No height is missing."
        added = _of_missing(lack, [one.name or "heights" for one in missing if one.of_added and one.places])
        yield "%d values at places on the surface are none, since values of points are NaN%s%s%s" % (
            found.without_value, _of_missing(": ", names), no_height, added)
    if found.left_out:
        names = [one.name or "heights" for one in missing if one.of_points]
        added = _of_missing(lack, [one.name or "heights" for one in missing if one.of_added])
        yield ("%d values at places are interpolated without some of their natural neighbours, whose values are NaN"
               "%s%s" % (found.left_out, _of_missing(": ", names), added))
