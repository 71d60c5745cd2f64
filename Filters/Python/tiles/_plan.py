# SPDX-License-Identifier: BSD-3-Clause
"""What a run will take, said and compared with what there is before hours are spent."""

from __future__ import annotations

import math
import os
import shutil
from dataclasses import dataclass
from typing import Dict, NamedTuple, Optional, Tuple

import numpy as np

from .._interface import available_memory
from ._errors import BadOptions, NoRoom
from ._finish import BATCH, CELLS
from ._points import Counted
from ._read import ROWS
from ._work import IN_ORDER

# Measured, as are the times (seconds a point or cell on one core); Filters/Python/Tiles.md has more.
_BASE = 150e6  # bytes: Python, libraries, a batch of points that is read
_BATCH = 2.2 * ROWS  # for each byte of a point's record: a batch that is read ahead, or dealt, on several threads
_LEAF = 250.0  # bytes for each point of a leaf that a thread is at work on
_CELL = 22.0  # and for each of its cells
_PIECE = 175.0  # and for each point of a piece of a TIN
_SHARE = 520.0  # bytes of borders and shares for each sqrt(points) of a leaf
_RIM = 0.8  # times the root of the groups: so many are done and have points that others need
_SCATTER, _VISIT, _FINISH, _TIN = 60e-9, 210e-9, 230e-9, 850e-9
_CELLS = {"linear": 70e-9, "natural": 450e-9, "laplace": 450e-9, "nearest": 150e-9}
_MOSAIC, _TIFF = 20e-9, 50e-9


@dataclass(frozen=True)
class Plan:
    """What a run will take, once the points are counted.

    Attributes
    ----------
    points, not_finite, other_class : int
        Points that the surface is made of, and those left out.
    leaves : int
        How many boxes the points are divided into.
    shape : (rows, columns) or None
        Of the raster.
    memory, disk, output, both : int
        Bytes at the most, from now on: of memory; of the work folder; of the results (uncompressed cells, a usual TIN);
        of work folder and results at a time, which is less than the sum, as points of what is done are removed.
    seconds : float
        Of all steps after counting.
    threads : int
    """

    points: int
    not_finite: int
    other_class: int
    leaves: int
    shape: Optional[Tuple[int, int]]
    memory: int
    disk: int
    output: int
    both: int
    seconds: float
    threads: int
    steps: Dict[str, float]  #: seconds of each

    def __str__(self) -> str:
        left_out = ["%s %s" % (_grouped(n), what) for n, what in (
            (self.not_finite, "not finite"), (self.other_class, "of other classes")) if n]  # fmt: skip
        cells = "" if self.shape is None else "raster   %s x %s cells\n" % tuple(map(_grouped, self.shape[::-1]))
        return ("points   %s%s\nleaves   %s\n%smemory   %s\ndisk     %s (work %s, results up to %s)\n"
                "time     %s on %d thread%s" % (
                    _grouped(self.points), " (left out: %s)" % ", ".join(left_out) if left_out else "",
                    _grouped(self.leaves), cells, bytes_said(self.memory), bytes_said(self.both),
                    bytes_said(self.disk), bytes_said(self.output), time_said(self.seconds), self.threads,
                    "s" * (self.threads > 1)))  # fmt: skip


class Kind(NamedTuple):
    """What of a run its cost depends on."""

    method: str
    dtype: str
    record: int  #: bytes of a point in the work folder
    records: int  #: and of all that are, or will be, there
    piece: int  #: points of a piece of a TIN; 0: there is none
    keeps: bool  #: are the points of what is done kept, as with lines?


def planned(
    counted: Counted, counts: np.ndarray, shape: Optional[Tuple[int, int]], kind: Kind, read: float, threads: int
) -> Plan:  # fmt: skip
    """`counts`: points of each leaf; `read`: seconds of one pass over all files."""
    points, leaves, most = counted.points, len(counts), int(counts.max())
    cells = shape[0] * shape[1] if shape else 0
    width = 8 if kind.dtype == "float64" else 4
    tin, at_once, borders = points * (kind.piece > 0), min(threads, leaves), float(_SHARE * np.sqrt(counts).sum())
    work = _LEAF * most + _CELL * min(CELLS, cells / leaves) + _PIECE * min(tin, max(most, 1.5 * kind.piece))
    dealt = _BATCH * kind.record * (2 + min(at_once, IN_ORDER)) * (threads > 1)
    memory = _BASE + max(dealt, at_once * work + borders / math.sqrt(leaves))
    output = (26 + 2 * len(counted.fields)) * tin + width * cells
    steps = {"scatter": read + _SCATTER * points, "visit": _VISIT * points / at_once,
             "finish": (_FINISH * points + _TIN * tin + _CELLS[kind.method] * cells) / at_once,
             "write": (_MOSAIC + _TIFF / threads) * cells}  # fmt: skip
    groups = max(1.0, points / kind.piece if kind.piece else leaves)
    kept = 1.0 if kind.keeps else min(1.0, _RIM / math.sqrt(groups) + BATCH / points)
    disk, both = (borders + max(kind.records, more) + kept * min(kind.records, more) for more in (
        width * cells, width * cells + output))  # fmt: skip
    return Plan(points, counted.not_finite, counted.other_class, leaves, shape, int(memory), int(disk), int(output),
                int(both), sum(steps.values()), threads, steps)  # fmt: skip


def limit(memory: Optional[int]) -> int:
    """Bytes that may be taken. `memory`: what the caller allows."""
    return min(memory or 1 << 62, available_memory())


def check(plan: Plan, memory: Optional[int], work: str, output: str, used: Tuple[int, int]) -> None:
    """NoRoom. Both folders are there. `used`: bytes of the work and of the pieces of a TIN that are there already."""
    most = limit(memory)
    if plan.memory > most:
        raise NoRoom("%s of memory are needed, and %s are %s" % (
            bytes_said(plan.memory), bytes_said(most), "allowed" if most == memory else "available"))  # fmt: skip
    isSame = os.stat(work).st_dev == os.stat(output).st_dev
    left, results = plan.both - sum(used) if isSame else plan.disk - used[0], plan.output - used[1]
    for folder, needed in ((work, left), (output, min(left, results) if isSame else results)):
        free = shutil.disk_usage(folder).free
        if needed > free:
            raise NoRoom("%s on the disk of %s are needed, and %s are free" % (
                bytes_said(needed), folder, bytes_said(free)))  # fmt: skip


def bytes_of(text: str) -> int:
    """Of "8 GB", "500MB", "4e9". BadOptions."""
    words = text.strip().upper().replace("IB", "B").rstrip("B").strip()
    factor = {"K": 1e3, "M": 1e6, "G": 1e9, "T": 1e12}.get(words[-1:], 1.0)
    try:
        return int(float(words.rstrip("KMGT")) * factor)
    except (ValueError, OverflowError):
        raise BadOptions("%r is no size, such as 8GB" % text) from None


def bytes_said(count: float) -> str:
    for unit in ("bytes", "kB", "MB", "GB"):
        if abs(count) < 999.5:
            return "%.3g %s" % (count, unit)
        count /= 1000
    return "%.3g TB" % count


def time_said(seconds: float) -> str:
    if seconds < 60:
        return "%d s" % max(1, round(seconds))
    minutes = round(seconds / 60)
    return "%d min" % minutes if minutes < 120 else "%d h %d min" % divmod(minutes, 60)


def _grouped(number: int) -> str:
    return "{:,}".format(number)
