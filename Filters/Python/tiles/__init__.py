# SPDX-License-Identifier: BSD-3-Clause
"""Rasters and TINs of more points than memory holds, with the bytes of one piece.

    from adaptivehilbertdelaunay import tiles

    tiles.make(["a.laz", "b.npy"], raster=tiles.GeoTiff("dtm.tif", cell=1), memory="8 GB", progress=print)

It is the command `adaptivehilbertdelaunay tiles`, too. The points are put into the files of leaves in a work folder, so
the run takes the memory of a few leaves; no seam shows where these meet, whatever the leaves, the threads, the memory
and, for rasters, the order of the files are.
"""

from __future__ import annotations

import os
from typing import Any, Optional, Sequence, Union

import numpy as np

from ._errors import BadFile, BadOptions, NoRoom, NoSurface, TilesError, WriteFailed
from ._options import LEAF, PIECE, GeoTiff, Options, Result
from ._plan import Plan, bytes_of
from ._run import Progress, Run

__all__ = [
    "BadFile", "BadOptions", "GeoTiff", "NoRoom", "NoSurface", "Plan", "Result", "TilesError", "WriteFailed", "make",
]  # fmt: skip


def make(
    files: Sequence[Any],
    *,
    raster: Optional[GeoTiff] = None,
    tin: Optional[str] = None,
    classes: Sequence[int] = (),
    lines: Sequence[Any] = (),
    loops: Sequence[Any] = (),
    longest_edge: float = 0.0,
    duplicates: str = "lowest",
    memory: Union[None, int, str] = None,
    threads: int = 0,
    work: Optional[str] = None,
    overwrite: bool = False,
    resume: bool = False,
    skip_bad: bool = False,
    leaf: int = LEAF,
    piece: int = PIECE,
    plan_only: bool = False,
    progress: Optional[Progress] = None,
    show: Any = lambda plan: None,
) -> Result:
    """Makes a raster, a TIN or both of the points of files.

    Parameters
    ----------
    files : sequence of paths, or one
        .las, .laz (COPC too; laspy and lazrs), .npy ((n, 2), (n, 3), or fields x, y, z), .csv, .xyz, .txt (columns by
        name or the first ones), .vtp, .vtu (VTK). Folders stand for the files in them, patterns for what they fit.
    raster : GeoTiff, optional
    tin : path of a .pvtp, optional
        With its pieces in the folder of the same name.
    classes : sequence of int, or one
        Of points with these classes alone, such as 2, ground; by default of all.
    lines : sequence of paths of GeoJSON files, or of geometries, optional
        Breaklines, with heights: their corners become points, their segments edges; one that crosses an earlier one is
        left out. Polygons are lines, too.
    loops : as lines
        Polygons and closed lines: the surface is inside an odd number of them.
    longest_edge : float, default 0
        Triangles with a longer one are left out, and have no value; 0: none.
    duplicates : {'lowest', 'highest', 'first'}
        Which of several points at one place counts. With 'first' it depends on the order of the files, as the
        GlobalPointIds of a TIN do.
    memory : int, or str like "8 GB", optional
        Bytes that may be taken; by default what is available. Results do not depend on it, nor on:
    threads : int, default 0
        0: one for each processor.
    work : path of a folder, optional
        For what is done already, removed at the end; by default beside the first output, its name and ".work".
    overwrite, resume : bool
        Are outputs replaced that are there? Is gone on with a run of the same files and settings that ended early?
    skip_bad : bool
        Are files that cannot be read, or are not what they say, left out, and said in `Result.skipped`?
    leaf, piece : int
        The most points of a leaf, which results do not depend on; and about how many are in a piece of a TIN.
    plan_only : bool
        Counts the points, and says what the run would take.
    progress : function of (step, fraction, seconds left or None), optional
    show : function of (Plan), optional
        Is told the plan before the work begins.

    Returns
    -------
    Result

    Raises
    ------
    TilesError
        BadOptions, BadFile, NoSurface, NoRoom, WriteFailed. Outputs that were there are unchanged; what was done is
        kept in the work folder, after KeyboardInterrupt too.
    """
    limit = bytes_of(memory) if isinstance(memory, str) else memory
    options = Options(
        [os.fspath(path) for path in _several(files)], raster, tin and os.fspath(tin),
        [int(one) for one in np.atleast_1d(classes)], _several(lines), _several(loops), float(longest_edge), duplicates,
        limit, int(threads), work, overwrite, resume, skip_bad, int(leaf), int(piece), plan_only)  # fmt: skip
    return Run(options, progress, show).run()


def _several(given: Any) -> Any:
    return [given] if isinstance(given, (str, os.PathLike)) else given
