# SPDX-License-Identifier: BSD-3-Clause
"""A run from its options to its results. What is done is in the work folder, file by file; so a run goes on where one
before ended, and the results are the same."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import platform
import shutil
import time
from typing import Any, Callable, Dict, List, Optional, Sequence, cast

import numpy as np

from .. import _interface
from .._raster import Raster
from .._sampling import METHODS
from . import _plan, _pvtp, _tiff
from ._errors import BadFile, BadOptions
from ._finish import Finish, Wanted, groups_of
from ._leaves import Leaves
from ._lines import chains_of
from ._options import DUPLICATES, Options, Result, check_degrees
from ._needs import Needs
from ._points import Counted, Points, count, full, is_scattered, scatter, scatter_anew
from ._store import COUNTED, FINISHED, PART, STARTED, Store, failing, has_only, sync, written
from ._visits import Visits
from ._work import Workers

#: Is told the step ("count", "scatter", "visit", "finish", "write"), how much of it is done, 0 to 1, and the seconds
#: that are left of all, None while they are not known.
Progress = Callable[[str, float, Optional[float]], Any]


class _Told:
    """Of the work of one step."""

    def __init__(self, progress: Optional[Progress]) -> None:
        self.progress = progress
        self.planned: Dict[str, float] = {}  # seconds of the steps, in their order
        self.spent: Dict[str, float] = {}  # and what those that ended have taken
        self.step, self.of, self.done = "", 1, 0
        self._begin = self._first = 0.0

    def begin(self, step: str, of: int, before: int = 0) -> None:
        """`before`: what an earlier run has done."""
        self.end()
        self.step, self.of, self.done = step, max(1, of), before
        self._begin, self._first = time.monotonic(), before / self.of
        self(0)

    def end(self) -> None:
        """Of the step."""
        if self.step:
            self.spent[self.step] = self.spent.get(self.step, 0.0) + time.monotonic() - self._begin

    def __call__(self, more: int) -> None:
        self.done += more
        if self.progress is not None:
            fraction = min(1.0, self.done / self.of)
            self.progress(self.step, fraction, self._left(fraction))

    def _left(self, fraction: float) -> Optional[float]:
        if self.step not in self.planned:
            return None
        later = list(self.planned)[list(self.planned).index(self.step) + 1 :]
        whole = self.planned[self.step]
        if fraction - self._first > 0.05:  # as it goes, not as it was planned
            whole = (time.monotonic() - self._begin) / (fraction - self._first)
        return (1 - fraction) * whole + sum(self.planned[step] for step in later)


def _bytes_in(folder: str) -> int:
    return sum(os.path.getsize(os.path.join(at, name)) for at, _, names in os.walk(folder) for name in names)


class Run:
    def __init__(self, options: Options, progress: Optional[Progress], show: Callable[[_plan.Plan], Any]) -> None:
        """`show`: is given the plan. BadOptions."""
        options.check()
        self.options, self.show, self.begin = options, show, time.monotonic()
        self.tell = _Told(progress)
        self.files, self.raster = options.files_found(), cast(Optional[Raster], None)
        self.store = Store(options.work or options.outputs[0] + ".work")
        self.folder = os.path.splitext(os.path.abspath(options.tin))[0] if options.tin else None  # of the pieces
        chains = chains_of(options.lines, options.loops)
        self.points = Points(self.files, options.classes, options.raster is not None, chains)
        threads = options.threads or _interface.threads_told() or _interface.processors()
        self.threads = self.points.threads = min(threads, 256)

    def run(self) -> Result:
        self._check_places()
        with self.store.held():
            return self._run()

    def _run(self) -> Result:
        options, points = self.options, self.points
        points.look(options.skip_bad, options.raster is not None and options.raster.crs is not None)
        self._check_some()
        crs = None if options.raster is None else options.raster.crs if options.raster.crs is not None else points.crs
        self.system = _tiff.system(crs) if options.raster else None
        self.store.clear()
        self._check_outputs()
        self.store.begin(self.files, self._settings(), options.resume)
        leaves = Leaves()
        try:
            counted = self._count(leaves)
        except BaseException:
            if not self.store.has(COUNTED):
                self.store.end()
            raise
        self.plan = leaves.plan()
        if options.tin is not None:
            self.points.kind = full(counted.fields)
        planned = self._planned(counted)
        self.show(planned)
        self._check_room(planned)
        crossing = 0 if options.plan_only else self._make(leaves, counted)
        self.tell.end()
        outputs = [] if options.plan_only else options.outputs
        seconds = time.monotonic() - self.begin
        return Result(planned, outputs, points.skipped, crossing, seconds, self.tell.spent)

    # --- before the work ---

    def _check_some(self) -> None:
        if not self.points.paths:
            path, said = next(iter(self.points.skipped.items()))
            raise BadFile(path, "no file is left: " + said)

    def _check_places(self) -> None:
        """BadOptions for outputs that cannot be there, or that would replace what is no output of this kind."""
        options, pieces = self.options, [self.folder, self.folder + PART] if self.folder else []
        for path in options.outputs:
            folder = os.path.dirname(os.path.abspath(path))
            if not os.path.isdir(folder):
                raise BadOptions("%s: there is no such folder" % path)
            if os.path.isdir(path):
                raise BadOptions("%s is a folder" % path)
            if not os.access(folder, os.W_OK):
                raise BadOptions("%s: nothing can be written in this folder" % path)
        taken = [os.path.realpath(path) for path in [*options.outputs, *pieces[:1], self.store.folder]]
        if len(set(taken)) < len(taken):
            raise BadOptions("outputs, the folder of a TIN's pieces (its name without .pvtp) and the work folder must "
                             "differ: %s" % ", ".join(taken))  # fmt: skip
        for path in self.files:
            if any((os.path.realpath(path) + os.sep).startswith(one + os.sep) for one in taken):
                raise BadOptions("%s would be replaced by the results: name these otherwise" % path)
        for path in pieces:
            if not has_only(path, _pvtp.NAMES):
                raise BadOptions("%s, where the pieces of a TIN come, is there and has other files: name the TIN "
                                 "otherwise" % path)  # fmt: skip

    def _check_outputs(self) -> None:
        options = self.options
        there = [path for path in [*options.outputs, *([self.folder] if self.folder else [])] if os.path.exists(path)]
        isBegun = options.resume and self.store.has(STARTED)
        if there and not (options.overwrite or isBegun or options.plan_only):
            raise BadOptions("%s is there already: --overwrite replaces it" % there[0])

    def _settings(self) -> Dict[str, Any]:
        """For the manifest. What leaves and nodes made is of one version of the library and one kind of processor."""
        chains, sha = self.points.chains, hashlib.sha256()
        for one in (chains.points, chains.offsets, np.array([chains.lines])):
            sha.update(one.tobytes())
        of = {"version": _interface.__version__, "processor": platform.machine()}
        return {**self.options.settings(), **of, "chains": sha.hexdigest()}

    def _extent(self, bounds: Any) -> Optional[Sequence[float]]:
        """The centres of the cells, over points with these bounds."""
        if self.options.raster is None:
            return None
        self.raster = raster = self.options.raster.over(bounds)
        check_degrees(raster, bounds, self.system)
        (x, y), (dx, dy), (rows, columns) = raster.origin, raster.spacing, raster.shape
        return x, x + (columns - 1) * dx, y, y + (rows - 1) * dy

    def _count(self, leaves: Leaves) -> Counted:
        """The plan of leaves, in `leaves`, of this run or one before."""
        if self.store.has(COUNTED):
            with open(self.store.path(COUNTED), "rb") as file:
                saved = json.loads(file.readline())
                plan = np.frombuffer(file.read(), np.uint8)
            self.points.paths, self.points.skipped, self.read = saved["paths"], saved["skipped"], saved["read"]
            counted = Counted(*saved["counted"])
            self._extent(counted.bounds)
            leaves.load(plan)
            return counted
        self.tell.begin("count", self.points.said)
        begin = time.monotonic()
        counted = count(self.points, leaves, self.options.leaf, self._extent, self.options.skip_bad, self.tell)
        self.read = (time.monotonic() - begin) / counted.passes
        with written(self.store.path(COUNTED)) as file:
            file.write(json.dumps({"counted": counted, "paths": self.points.paths, "read": self.read,
                                   "skipped": self.points.skipped}).encode() + b"\n")  # fmt: skip
            file.write(leaves.plan().saved.tobytes())
        return counted

    def _planned(self, counted: Counted) -> _plan.Plan:
        """With as many threads as there is memory for, one at least."""
        given, shape = self.options.raster, None if self.raster is None else self.raster.shape
        record, keeps = self.points.kind.itemsize + 24 * self._has_lines(), self._has_lines()
        # as some are removed, which come anew where their pieces are gone
        isLess = is_scattered(self.store) and not keeps and (not self.folder or len(self._own_folders()) > 0)
        kind = _plan.Kind(given.method if given else "linear", given.dtype if given else "float32", record,
                          _bytes_in(self.store.path("leaf")) if isLess else record * counted.points,
                          self.options.piece if self.folder else 0, keeps)  # fmt: skip
        made: Optional[_plan.Plan] = None
        for threads in range(self.threads, 0, -1):
            made = _plan.planned(counted, self.plan.counts, shape, kind, self.read, threads)
            if made.memory <= _plan.limit(self.options.memory):
                break
        assert made is not None
        self.threads = made.threads
        self.tell.planned = made.steps
        return made

    def _check_room(self, planned: _plan.Plan) -> None:
        pieces = self.folder + PART if self.folder else ""
        used = _bytes_in(self.store.folder), _bytes_in(pieces) if self._is_own(pieces) else 0
        output = os.path.dirname(os.path.abspath(self.options.outputs[0]))
        _plan.check(planned, self.options.memory, self.store.folder, output, used)

    # --- the work ---

    def _make(self, leaves: Leaves, counted: Counted) -> int:
        """Returns how many segments cross earlier ones."""
        raster, cells, count_ = self.options.raster, self.raster, len(self.plan.counts)
        windows = [leaves.cells(leaf, cells) for leaf in range(count_)] if cells else []
        wanted = Wanted(cells, windows, METHODS.index(raster.method) if raster else 0,
                        raster.dtype if raster else "float32", self.folder and self.folder + PART,
                        tuple(counted.fields), self._has_lines(), self.options.longest_edge)  # fmt: skip
        finish = Finish(self.store, self.plan, self.points.kind, wanted)
        threads = max(1, min(self.threads, count_))
        workers = Workers(threads, self.plan.saved, {
            "duplicates": DUPLICATES[self.options.duplicates], "threads": max(1, self.threads // threads),
            "memory_limit": self.options.memory or 0,
            "maximum_edge_length": 0 if self._has_lines() else self.options.longest_edge})  # fmt: skip
        self._scatter(workers)
        self._visit(workers)
        groups = groups_of(self.plan, self.options.piece if self.folder else 0)
        if not self._has_all(finish, groups):
            self._finish(workers, finish, groups)
        crossing = leaves.segments_crossing(finish.shares(0)) if self._has_lines() else 0
        self._write(finish, groups)
        self.store.end()
        if self.folder is not None:
            with contextlib.suppress(OSError):
                os.remove(os.path.join(self.folder, _pvtp.RUN))
        return crossing

    def _has_lines(self) -> bool:
        return len(self.points.chains.points) > 0

    def _scatter(self, workers: Workers) -> None:
        self.tell.begin("scatter", self.points.said)
        scatter(self.points, workers, self.plan.counts, self.store, self.tell)

    def _visit(self, workers: Workers) -> None:
        visits = Visits(self.store, self.plan, self.points.kind, self._has_lines())
        self.tell.begin("visit", len(visits.parents), len(visits.done))
        visits.run(workers, self.tell)

    def _has_all(self, finish: Finish, groups: Sequence[range]) -> bool:
        """Need results only be put together? Somebody may have removed pieces."""
        if not self.store.has(FINISHED) or finish.wanted.pieces is None:
            return self.store.has(FINISHED)
        return any(all(os.path.exists(finish.piece(group, folder)) for group in groups)
                   for folder in self._own_folders())  # fmt: skip

    def _own_folders(self) -> List[str]:
        """Of pieces of this run: two at the most, of which one will be, or is, renamed to the other."""
        assert self.folder is not None
        return list(filter(self._is_own, (self.folder + PART, self.folder)))

    def _finish(self, workers: Workers, finish: Finish, groups: List[range]) -> None:
        pieces = finish.wanted.pieces
        if pieces is not None and not self._is_own(pieces):  # nothing, or what another run left
            self.store.remove(FINISHED)  # of pieces that are gone
            with failing(pieces):
                sync(self.store.folder)
                shutil.rmtree(pieces, ignore_errors=True)
                os.makedirs(pieces)
            with written(os.path.join(pieces, _pvtp.RUN)) as file:
                file.write(self.store.key.encode())
        left = [group for group in groups if not finish.is_done(group)]
        needs = Needs(finish, left, workers)
        if not needs.are_there():
            scatter_anew(self.store, len(self.plan.counts))
            self._scatter(workers)
        needs.begin()
        self.tell.begin("finish", len(groups), len(groups) - len(left))

        def ended(group: range) -> List[range]:
            self.tell(1)
            needs.end(group)
            return []

        workers.run(left, finish.work, ended)
        finish.sync()  # before anybody relies on it, or the work is removed
        self.store.save(FINISHED, len(groups))

    def _is_own(self, pieces: str) -> bool:
        """Are the pieces in this folder of this run?"""
        with contextlib.suppress(OSError), open(os.path.join(pieces, _pvtp.RUN), "rb") as file:
            return file.read() == self.store.key.encode()
        return False

    def _write(self, finish: Finish, groups: Sequence[range]) -> None:
        raster, wanted = self.options.raster, finish.wanted
        self.tell.begin("write", 1)
        if raster is not None and self.raster is not None:
            nodata = float(np.dtype(raster.dtype).type(raster.nodata))
            mosaic = _tiff.Mosaic(self.store, self.raster, wanted.windows, raster.dtype, nodata)
            _tiff.write(os.fspath(raster.path), mosaic, self.raster, self.system, self.threads)
        if self.folder is not None and self.options.tin is not None:
            self._write_tin(finish, groups)
        self.tell(1)

    def _write_tin(self, finish: Finish, groups: Sequence[range]) -> None:
        """The folder of pieces gets its name, and then there is the file that lists them."""
        assert self.folder is not None and self.options.tin is not None and finish.wanted.pieces is not None
        with failing(self.folder):
            if os.path.isdir(finish.wanted.pieces):
                shutil.rmtree(self.folder, ignore_errors=True)
                os.replace(finish.wanted.pieces, self.folder)
                sync(os.path.dirname(self.folder))
        names = ["%s/%d.vtp" % (os.path.basename(self.folder), group[0]) for group in groups]
        _pvtp.write_list(self.options.tin, names, finish.kinds())
        sync(os.path.dirname(self.folder))
