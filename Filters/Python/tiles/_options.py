# SPDX-License-Identifier: BSD-3-Clause
"""What is asked for, checked as far as it can be before points are read; and what was made."""

from __future__ import annotations

import glob
import math
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence, Tuple

from .. import _interface
from .._raster import Raster, raster_over
from .._sampling import METHODS
from . import _read, _tiff
from ._errors import BadOptions
from ._plan import Plan

DUPLICATES = {"lowest": _interface.DUPLICATES_LOWEST_Z, "highest": _interface.DUPLICATES_HIGHEST_Z,
              "first": _interface.DUPLICATES_FIRST}  # fmt: skip
LEAF, PIECE = 200_000, 1_000_000  #: points


@dataclass(frozen=True)
class GeoTiff:
    """A raster of heights, to be written as a GeoTIFF: a BigTIFF in tiles, compressed by DEFLATE, its north up.

    Attributes
    ----------
    path : str
    cell : float or (dx, dy)
        The size of a cell, in the unit of the points.
    method : {'linear', 'natural', 'laplace', 'nearest'}, default 'linear'
        As in `Triangulation.interpolate`.
    bounds : (xmin, xmax, ymin, ymax), optional
        The area; that of the points otherwise.
    align : bool, default False
        Are borders of cells multiples of the size?
    crs : optional
        The reference system, "EPSG:25832", its number or WKT; that of the files otherwise.
    nodata : float, default NaN
        The value of cells without one.
    dtype : {'float32', 'float64'}, default 'float32'
    """

    path: str
    cell: Any
    method: str = "linear"
    bounds: Optional[Sequence[float]] = None
    align: bool = False
    crs: Any = None
    nodata: float = math.nan
    dtype: str = "float32"

    def check(self) -> None:
        """BadOptions."""
        if self.method not in METHODS:
            raise BadOptions("method must be one of %s, not %r" % (", ".join(METHODS), self.method))
        if self.dtype not in ("float32", "float64"):
            raise BadOptions("dtype must be float32 or float64, not %r" % (self.dtype,))
        _tiff.package()
        self.over((0.0, 0.0, 0.0, 0.0))  # which self.bounds come before

    def over(self, bounds: Sequence[float]) -> Raster:
        """The cells, over points with these bounds. BadOptions."""
        try:
            return raster_over(bounds if self.bounds is None else self.bounds, self.cell, None, self.align)
        except (ValueError, TypeError, MemoryError) as error:
            raise BadOptions("raster: %s" % error) from error


@dataclass(frozen=True)
class Options:
    """The arguments of `make`, which describes them."""

    files: Sequence[str]
    raster: Optional[GeoTiff] = None
    tin: Optional[str] = None
    classes: Sequence[int] = ()
    lines: Sequence[Any] = ()
    loops: Sequence[Any] = ()
    longest_edge: float = 0.0
    duplicates: str = "lowest"
    memory: Optional[int] = None
    threads: int = 0
    work: Optional[str] = None
    overwrite: bool = False
    resume: bool = False
    skip_bad: bool = False
    leaf: int = LEAF
    piece: int = PIECE
    plan_only: bool = False

    @property
    def outputs(self) -> List[str]:
        return [os.fspath(path) for path in (self.raster.path if self.raster else None, self.tin) if path]

    def check(self) -> None:
        """BadOptions."""
        if not self.outputs:
            raise BadOptions("nothing is asked for: give --raster and --cell, or --tin, or all of them")
        if self.duplicates not in DUPLICATES:
            raise BadOptions("duplicates must be one of %s, not %r" % (", ".join(DUPLICATES), self.duplicates))
        if self.tin and (not self.tin.endswith(".pvtp") or self.tin.encode(errors="ignore").decode() != self.tin):
            raise BadOptions("%r: a TIN is a .pvtp, its name in Unicode" % self.tin)
        if self.threads < 0 or (self.memory is not None and self.memory <= 0):
            raise BadOptions("threads must be 0 (one for each processor) or more, and memory more than 0, not %r and "
                             "%r" % (self.threads, self.memory))  # fmt: skip
        if not 0 <= self.longest_edge < math.inf:
            raise BadOptions("longest_edge must be 0 (no limit) or more, not %r" % (self.longest_edge,))
        if not (0 < self.leaf <= 1 << 26 and 0 < self.piece <= 1 << 28):
            raise BadOptions("leaf must be from 1 to %d, and piece to %d" % (1 << 26, 1 << 28))
        if self.raster:
            if self.raster.method == "nearest" and (len(self.lines) or len(self.loops)):
                raise BadOptions("method nearest takes neither lines nor loops: lines do not change which vertex is "
                                 "nearest, and behind loops any may be")  # fmt: skip
            self.raster.check()

    def files_found(self) -> List[str]:
        """The files; of a folder those that can be read, of a pattern those that it fits. BadOptions."""
        found: List[str] = []
        for one in self.files:
            if os.path.isdir(one):
                inside = sorted(os.path.join(one, name) for name in os.listdir(one))
                found += [path for path in inside if os.path.splitext(path)[1].lower() in _read.READERS]
            else:
                found += sorted(glob.glob(one)) if not os.path.exists(one) and glob.has_magic(one) else [one]
        if not found:
            raise BadOptions("there are no files of points: %s" % ", ".join(map(str, self.files)))
        if len(set(map(os.path.realpath, found))) < len(found):
            raise BadOptions("a file is named twice: its points would count twice")
        return found

    def settings(self) -> Dict[str, Any]:
        """Those that the results depend on, for the manifest."""
        raster = None
        if self.raster is not None:
            raster = {name: repr(value) for name, value in vars(self.raster).items()}
            raster["path"] = os.path.abspath(self.raster.path)
        return {"raster": raster, "tin": self.tin and os.path.abspath(self.tin), "classes": list(self.classes),
                "longest_edge": self.longest_edge, "duplicates": self.duplicates, "leaf": self.leaf,
                "piece": self.piece}  # fmt: skip


@dataclass(frozen=True)
class Result:
    """What was made.

    Attributes
    ----------
    plan : Plan
        The counts of points, and what the run was to take.
    outputs : list of str
        The files that were written; none with `plan_only`.
    skipped : dict
        Files that were left out, and why.
    segments_crossing : int
        Segments of lines and loops that are left out, as they cross an earlier one.
    seconds : float
        Of all.
    steps : dict
        Seconds of each step that this run has done; those that were planned are in `plan.steps`.
    """

    plan: Plan
    outputs: List[str]
    skipped: Dict[str, str]
    segments_crossing: int
    seconds: float
    steps: Dict[str, float]


def check_degrees(raster: Raster, bounds: Tuple[float, float, float, float], system: Any) -> None:
    """BadOptions for cells in metres where points are in degrees: those of a size that no map in degrees has."""
    isGeographic = bool(getattr(system, "is_geographic", str(system).startswith(("GEOGCS", "GEOGCRS"))))
    xmin, xmax, ymin, ymax = bounds
    looks = -360 <= xmin and xmax <= 360 and -90 <= ymin and ymax <= 90
    size = max(raster.spacing)
    if (looks and size > max(xmax - xmin, ymax - ymin) / 2) or (isGeographic and size > 0.1):
        raise BadOptions("the points are from (%.10g, %.10g) to (%.10g, %.10g), which seem to be degrees, and a cell "
                         "of %g is larger than makes sense: give --cell in the unit of the points, or project "
                         "them" % (xmin, ymin, xmax, ymax, size))  # fmt: skip
