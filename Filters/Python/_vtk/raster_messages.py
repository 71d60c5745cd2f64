# SPDX-License-Identifier: BSD-3-Clause
"""The facts in the messages of vtkAdaptiveHilbertInterpolation2D."""

import types

from .. import _library as engine
from . import messages
from .columns import GRADIENT


def of_raster(fault, values):
    """The reason why there is no raster; None if only points are missing."""
    width, height = values["CellSize"]
    columns, rows = fault.wished
    return messages.refusal(
        raster=fault.kind, cell_width=width, cell_height=height, columns=float(columns), rows=float(rows),
        bounds=list(values["Bounds"]))


def of_names(values):
    """The reason why output arrays cannot have their names; None if they can."""
    heights = values["HeightArrayName"]
    has_gradients = heights and values["GenerateGradients"] and values["Method"] == 0
    return messages.refusal(
        heights_name=heights, mask_name=values["ValidPointMaskArrayName"],
        gradients_name=heights + GRADIENT if has_gradients else "")


def of_memory(places, points, estimate, limit, is_limited, is_refused):
    """The refusal of so many KiB, or the error that they were not enough. `places`: below 0 if unknown."""
    return messages.refusal(
        reason=engine.MEMORY_LIMIT if is_refused else engine.OUT_OF_MEMORY, doing="interpolating", of_triangulation=1,
        places=float(places), points=points, memory_estimate=estimate, memory_allowed=limit, memory_limit=is_limited)


def of_arrays(values, columns):
    """Warnings about arrays that are not interpolated, and about missing gradients."""
    return messages.said(engine.SAY_COLUMNS, dict(
        unfit_array=columns.unfit, replaced_array=columns.replaced,
        gradients_are_missing=values["GenerateGradients"] and values["Method"] != 0))


def together(found, more):
    """The sum of the results of two sets of places on the same surface; None: no result yet."""
    if found is None:
        return more
    counts = {name: count + more.counts[name] for name, count in found.counts.items()}
    boxes = [box for box in (found.wanted, more.wanted) if box is not None]
    wanted = tuple(end(box[k] for box in boxes) for k, end in enumerate((min, max, min, max))) if boxes else None
    return types.SimpleNamespace(
        triangles=more.triangles, wanted=wanted, surface=found.surface or more.surface,
        missing=_missing_together(found.missing + more.missing), counts=counts)


def _missing_together(all_missing):
    """One for each name."""
    made = {}
    for one in all_missing:
        made[one.name] = made[one.name].and_others(one) if one.name in made else one
    return list(made.values())


def of_places(found):
    """Warnings about places and values. `found`: the job's counts by name, triangles, wanted and surface, the boxes of
    the places and of the points, and missing, the arrays without some values."""
    boxes = {name: list(getattr(found, name) or ("nowhere",)) for name in ("wanted", "surface")}
    return messages.said(engine.SAY_PLACES, dict(
        found.counts, **boxes, triangles=found.triangles, missing=[(one.name, one.places) for one in found.missing],
        of_points=[one.of_points for one in found.missing], of_added=[one.of_added for one in found.missing]))
