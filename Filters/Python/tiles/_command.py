# SPDX-License-Identifier: BSD-3-Clause
"""adaptivehilbertdelaunay tiles FILES…: options, a progress bar, exit codes."""

from __future__ import annotations

import argparse
import contextlib
import math
import os
import re
import sys
import time
from typing import Any, List, Optional, Sequence

from .._sampling import METHODS
from . import make
from ._errors import INTERRUPTED, BadOptions, NoRoom, TilesError
from ._options import DUPLICATES, LEAF, PIECE, GeoTiff
from ._plan import Plan, bytes_of, time_said

EXITS = """exit codes: 0 done; 2 options that do not go together; 3 a file that cannot be read, or is not what it says;
4 no surface: no point of the class, one point, all on a line; 5 not enough memory or disk; 6 a file that
cannot be written; 130 Ctrl-C. What was done is kept: the same command with --resume goes on."""


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="adaptivehilbertdelaunay tiles", epilog=EXITS,
        description="A raster or a TIN of more points than memory holds, without seams.")  # fmt: skip
    add = made.add_argument
    add("files", nargs="+", help=".las, .laz, .npy, .csv, .xyz, .txt, .vtp, .vtu; a folder stands for those in it")
    add("--raster", metavar="TIF", help="write the heights as a GeoTIFF; needs --cell")
    add("--cell", type=float, metavar="SIZE", help="of the raster, in the unit of the points")
    add("--method", choices=METHODS, default="linear", help="between the points (linear)")
    add("--bounds", type=float, nargs=4, metavar=("XMIN", "XMAX", "YMIN", "YMAX"), help="of the raster")
    add("--align", action="store_true", help="borders of cells are multiples of the size")
    add("--crs", help="of the raster, such as EPSG:25832; that of the files otherwise")
    add("--nodata", type=float, default=math.nan, metavar="V", help="where there is no value (NaN)")
    add("--dtype", choices=("float32", "float64"), default="float32", help="of the raster (float32)")
    add("--tin", metavar="PVTP", help="write the triangles for ParaView, and a folder of pieces of the same name")
    add("--piece", type=int, default=PIECE, metavar="N", help="points of a piece, about (%(default)s)")
    add("--class", type=int, action="append", default=[], dest="classes", metavar="N",
        help="of the points of this class alone, such as 2, ground; may be repeated")  # fmt: skip
    add("--lines", metavar="JSON", action="append", default=[], help="breaklines with heights: GeoJSON")
    add("--loops", metavar="JSON", action="append", default=[], help="polygons with heights that bound the surface")
    add("--longest-edge", type=float, default=0.0, metavar="L", help="leave out triangles with a longer one")
    add("--duplicates", choices=tuple(DUPLICATES), default="lowest", help="which of several points at one place counts "
        "(lowest); with 'first' the order of the files matters")  # fmt: skip
    add("--memory", type=_bytes, metavar="SIZE", help="that may be taken, such as 8GB (what is available)")
    add("--threads", type=int, default=0, help="(one for each processor)")
    add("--work", metavar="DIR", help="for what is done already (beside the output)")
    add("--overwrite", action="store_true", help="replace outputs that are there")
    add("--skip-bad", action="store_true", help="leave out files that cannot be read, and say so")
    add("--plan", action="store_true", help="count the points, say what the run would take, and stop")
    add("--resume", action="store_true", help="go on where a run of the same files and settings ended")
    add("--leaf", type=int, default=LEAF, help=argparse.SUPPRESS)
    return made


def _bytes(text: str) -> int:
    try:
        return bytes_of(text)
    except BadOptions as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _words(given: Sequence[str]) -> List[str]:
    """Numbers like -1e9, which argparse takes for options, begin with a space."""
    return [" " + word if re.fullmatch(r"-[\d.]+(e[-+]?\d+)?", word, re.IGNORECASE) else word for word in given]


def _say(what: Any, to: Any) -> None:
    """Nothing fails because nobody reads it: results are in files."""
    coding = getattr(to, "encoding", None) or "utf-8"
    try:
        print(str(what).encode(coding, "backslashreplace").decode(coding), file=to, flush=True)
    except OSError:
        with contextlib.suppress(OSError):  # what is still to be written has somewhere to go when Python ends
            os.dup2(os.open(os.devnull, os.O_WRONLY), to.fileno())


class Bar:
    """On a terminal one line that changes, otherwise nothing."""

    def __init__(self) -> None:
        self.isShown, self._last = sys.stderr is not None and sys.stderr.isatty(), 0.0

    def __call__(self, step: str, fraction: float, left: Optional[float]) -> None:
        now = time.monotonic()
        if self.isShown and (now - self._last > 0.2 or fraction in (0.0, 1.0)):
            self._last = now
            full = round(30 * fraction)
            said = "" if left is None else "  %s left" % time_said(left)
            sys.stderr.write("\r\033[K%-8s %s%s %3d %%%s" % (step, "#" * full, "." * (30 - full), 100 * fraction, said))
            sys.stderr.flush()

    def end(self) -> None:
        if self.isShown:
            sys.stderr.write("\r\033[K")


def main(given: Sequence[str]) -> int:
    known = parser()
    args = vars(known.parse_args(_words(given)))
    cell, path = args.pop("cell"), args.pop("raster")
    about = {name: args.pop(name) for name in ("method", "bounds", "align", "crs", "nodata", "dtype")}
    if (cell is None) != (path is None):
        known.error("--raster and --cell go together")
    raster = None if path is None else GeoTiff(path, cell, **about)
    bar = Bar()

    def show(plan: Plan) -> None:
        bar.end()
        _say(plan, sys.stdout if args["plan"] else sys.stderr)

    try:
        made = make(raster=raster, plan_only=args["plan"], progress=bar, show=show,
                    **{name: value for name, value in args.items() if name != "plan"})  # fmt: skip
    except KeyboardInterrupt:
        return _ended(bar, "interrupted: what was done is kept; the same command with --resume goes on", INTERRUPTED)
    except TilesError as error:
        return _ended(bar, str(error), error.exit_code)
    except MemoryError as error:  # the library's, too
        return _ended(bar, str(error) or "there is not enough memory", NoRoom.exit_code)
    bar.end()
    for said in made.skipped.values():
        _say("left out: " + said, sys.stderr)
    if made.segments_crossing:
        _say("left out: %d segments of lines and loops that cross earlier ones" % made.segments_crossing, sys.stderr)
    for output in made.outputs:
        _say(output, sys.stdout)
    return 0


def _ended(bar: Any, message: str, code: int) -> int:
    bar.end()
    _say("adaptivehilbertdelaunay tiles: " + message, sys.stderr)
    return code
