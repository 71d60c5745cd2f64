# SPDX-License-Identifier: BSD-3-Clause
"""The points of all files, one after the other: those of the class that are finite; and the first two steps of a run:
where the leaves are, and each point to the file of its leaf."""

from __future__ import annotations

import contextlib
import itertools
import os
from typing import Any, Callable, Dict, Generator, Iterator, List, NamedTuple, Optional, Sequence, Set, Tuple

import numpy as np

from .._library import Job
from . import _read
from ._errors import BadFile, BadOptions, NoSurface
from ._leaves import Leaves
from ._lines import Chains
from ._store import STARTED, Store, failing, sync
from ._work import Workers, ahead

Tell = Callable[[int], Any]  # how many points more are done

XYZ = np.dtype([("xyz", "<f8", (3,))])
COMMIT = 1 << 26  #: points that may have to be read again after the end of a run


def full(fields: Sequence[str]) -> np.dtype:
    """With what a TIN has beside it: the number of the point in the files in their order, and those of _read.FIELDS
    that some file has."""
    return np.dtype([*XYZ.descr, ("id", "<i8"), *(field for field in _read.FIELDS if field[0] in fields)])


class Place(NamedTuple):
    """How far all files are read."""

    file: int = 0
    read: int = 0  #: points of this file
    before: int = 0  #: points of those before


class Batch(NamedTuple):
    """Points that are kept, of the kind of `Points`, and how far all is read with them."""

    records: np.ndarray
    read: int
    place: Place


class Counted(NamedTuple):
    """What the first step found, beside the plan of leaves."""

    points: int  #: that are kept
    not_finite: int
    other_class: int
    bounds: Tuple[float, float, float, float]  #: xmin, xmax, ymin, ymax
    passes: int  #: over all points
    fields: Sequence[str]  #: of _read.FIELDS, that some file has


class Points:
    def __init__(self, paths: Sequence[str], classes: Sequence[int], needsZ: bool, chains: Chains) -> None:
        """`needsZ`: are they for heights? `chains`: whose corners are points, too, behind those of all files."""
        self.paths, self.classes, self.needsZ = list(paths), list(classes), needsZ
        self.kind, self.chains = XYZ, chains  # which may become full()
        self.threads = 1  # that read
        self.heads: Dict[str, _read.Head] = {}
        self.skipped: Dict[str, str] = {}
        self.not_finite = self.other_class = 0
        self.fields: Set[str] = set()

    def look(self, skips: bool, isCrsGiven: bool) -> None:
        """Reads the heads. `skips`: are bad files left out? BadFile."""
        for path in self.paths:
            try:
                self.heads[path] = _read.head_of(path)
            except BadFile as error:
                self.leave_out(error, skips)
        while True:
            found = next(_read.check_alike(self.paths, [self.heads[path] for path in self.paths], isCrsGiven), None)
            if found is None:
                return
            self.leave_out(found, skips)

    def leave_out(self, error: BadFile, skips: bool) -> None:
        if not skips:
            raise error
        self.skipped[error.path] = str(error)
        self.paths = [path for path in self.paths if path != error.path]

    @property
    def crs(self) -> Optional[str]:
        return next((self.heads[path].crs for path in self.paths if self.heads[path].crs), None)

    @property
    def said(self) -> int:
        """How many there are, as the files say."""
        return sum(self.heads[path].points for path in self.paths)

    def guess(self) -> Optional[np.ndarray]:
        """xmin, xmax, ymin, ymax, if the files say so and all points are kept."""
        given = [self.heads[path].bounds for path in self.paths]
        boxes = [box for box in given if box is not None and np.isfinite(box).all()]
        if self.classes or len(self.chains.points) or not boxes or len(boxes) < len(given):
            return None
        low, high = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
        return np.array([low[0], high[0], low[1], high[1]]) if (low <= high).all() else None

    @contextlib.contextmanager
    def batches(self, start: Place = Place()) -> Iterator[Iterator[Batch]]:
        """All points from there on. BadFile."""
        made = self._batches(start)
        with contextlib.closing(made if self.threads == 1 else ahead(made)) as found:
            yield found

    def _batches(self, start: Place) -> Generator[Batch, None, None]:
        before = start.before
        if start == Place():
            self.not_finite, self.other_class, self.fields = 0, 0, set()
        for number, path in enumerate(self.paths):
            if number < start.file:
                continue
            read = start.read if number == start.file else 0
            for chunk in _read.chunks_of(path, self.heads[path], read, self.threads):
                read += len(chunk.xyz)
                first = before + read - len(chunk.xyz)
                yield Batch(self._kept(path, chunk, first), len(chunk.xyz), Place(number, read, before))
            before += read
        corners, end = self.chains.points, len(self.paths)
        if len(corners) and start.file <= end:
            made = np.zeros(len(corners), self.kind)
            made["xyz"] = corners
            if self.kind != XYZ:
                made["id"] = before + np.arange(len(corners))
            yield Batch(made, 0, Place(end + 1, 0, before))

    def _kept(self, path: str, chunk: _read.Chunk, first: int) -> np.ndarray:
        if self.needsZ and not chunk.hasZ:
            raise BadFile(path, "has no z, which a raster is made of")
        if self.classes and chunk.classification is None:
            raise BadFile(path, "has no classes, and --class asks for some")
        if not chunk.hasZ:
            chunk.xyz[:, 2] = 0
        kept = None if np.isfinite(chunk.xyz).all() else np.flatnonzero(np.isfinite(chunk.xyz).all(axis=1))
        self.not_finite += 0 if kept is None else len(chunk.xyz) - len(kept)
        if self.classes:
            assert chunk.classification is not None
            isOfClass = np.isin(chunk.classification, self.classes)
            of = np.flatnonzero(isOfClass) if kept is None else kept.compress(isOfClass.take(kept))
            self.other_class += (len(isOfClass) if kept is None else len(kept)) - len(of)
            kept = of
        return self._records(chunk, kept, first)

    def _records(self, chunk: _read.Chunk, kept: Optional[np.ndarray], first: int) -> np.ndarray:
        """`kept`: which of them; None: all."""
        xyz = np.ascontiguousarray(chunk.xyz if kept is None else chunk.xyz.take(kept, axis=0))
        columns = {name: getattr(chunk, name) for name, _ in _read.FIELDS if getattr(chunk, name) is not None}
        self.fields.update(columns)
        if self.kind == XYZ:
            return xyz.view(XYZ).ravel()
        made = np.zeros(len(xyz), self.kind)
        made["xyz"] = xyz
        made["id"] = first + (np.arange(len(xyz)) if kept is None else kept)
        for name in columns.keys() & set(self.kind.names or ()):
            made[name] = columns[name] if kept is None else columns[name].take(kept)
        return made


# --- Where the leaves are -----------------------------------------------------------------------------------


class _Spread:
    """Are all points on a line? Asked of the engine, of a few that are far from a line through two of them."""

    def __init__(self) -> None:
        self.isWide = False
        self._some = np.zeros((0, 2))

    def add(self, xy: np.ndarray) -> None:
        if self.isWide or not len(xy):
            return
        if len(self._some) < 2:
            first = self._some[0] if len(self._some) else xy[0]
            self._some = np.stack([first, xy[np.abs(xy - first).sum(axis=1).argmax()]])
        a, b = self._some
        away = np.abs((b[0] - a[0]) * (xy[:, 1] - a[1]) - (b[1] - a[1]) * (xy[:, 0] - a[0]))
        far = np.argpartition(away, -min(len(xy), 100))[-min(len(xy), 100) :]
        job = Job()
        job.set_array("points", np.concatenate((self._some, xy[far])))
        job.run()
        self.isWide = job.count("triangles") > 0
        if (a == b).all():
            self._some = self._some[:1]


def count(points: Points, leaves: Leaves, most: int, extent: Callable[[Any], Any], skips: bool, tell: Tell) -> Counted:
    """Makes the plan of leaves of at most so many points. `extent`: the centres of cells within bounds. BadFile,
    NoSurface."""
    while True:
        try:
            return _count(points, leaves, most, extent, tell)
        except BadFile as error:
            points.leave_out(error, skips)  # and all anew: the engine cannot take points back


def _count(points: Points, leaves: Leaves, most: int, extent: Callable[[Any], Any], tell: Tell) -> Counted:
    guess = points.guess()
    leaves.begin(guess)
    box, spread = [np.inf, -np.inf, np.inf, -np.inf], _Spread()
    for number in itertools.count(1):
        kept = 0
        with points.batches() as batches:
            for batch in batches:
                xyz = np.ascontiguousarray(batch.records["xyz"])
                kept += len(xyz)
                if len(xyz):
                    leaves.count_points(xyz)  # which refuses other bounds in a later pass
                    if number == 1:
                        for k, x in enumerate((xyz[:, 0], xyz[:, 1])):  # an axis of its own is many times as fast
                            box[2 * k : 2 * k + 2] = min(box[2 * k], x.min()), max(box[2 * k + 1], x.max())
                        spread.add(xyz[:, :2])
                tell(batch.read)
        _check_surface(points, kept, spread)
        bounds = float(box[0]), float(box[1]), float(box[2]), float(box[3])
        if not leaves.end_pass(most, extent(bounds)):
            fields = [name for name, _ in _read.FIELDS if name in points.fields]
            if len(points.chains.points):
                leaves.set_lines(points.chains)
            return Counted(kept, points.not_finite, points.other_class, bounds, number, fields)
    raise AssertionError


def _check_surface(points: Points, kept: int, spread: _Spread) -> None:
    if not spread.isWide:
        of = " of class %s" % ", ".join(map(str, points.classes)) if points.classes else ""
        said = "there is no point" if kept == 0 else "there is one point" if kept == 1 else \
            "all %d points%s lie on a line, or at one place" % (kept, of)  # fmt: skip
        raise NoSurface(said + of * (kept < 2) + ": there is no surface (%d read; not finite: %d; of other classes: "
                        "%d)" % (points.said, points.not_finite, points.other_class))  # fmt: skip


# --- To the leaves ------------------------------------------------------------------------------------------


class Dealt(NamedTuple):
    """A batch, by leaf."""

    read: int
    place: Place
    parts: List[Tuple[int, np.ndarray]]  #: leaves that have some of it, and their records


def scatter(points: Points, workers: Workers, counts: np.ndarray, store: Store, tell: Tell) -> None:
    """Each point to the file of its leaf, in the order of the files; `counts`: how many belong to each. Goes on where a
    run before ended: the files are cut to what was committed. BadFile, BadOptions, WriteFailed."""
    with failing(store.path("leaf")):
        if store.has(STARTED):
            saved = store.load(STARTED)
        else:
            saved = _nothing(len(counts))
        if saved["isDone"]:
            return
        place, sizes, since = Place(*saved["place"]), saved["sizes"], 0
        dirty: Set[int] = set()
        for leaf, size in enumerate(sizes):
            with open(_leaf_file(store, leaf), "ab") as file:
                file.truncate(size)
        tell(place.before + place.read)

        def deal(leaves: Leaves, batch: Batch) -> Dealt:
            return Dealt(batch.read, batch.place, _by_leaf(batch.records, leaves, len(sizes)))

        with points.batches(place) as batches, contextlib.closing(workers.in_order(batches, deal)) as dealt:
            for read, place, parts in dealt:
                for leaf, records in parts:
                    with open(_leaf_file(store, leaf), "ab") as file:
                        file.write(records.view(np.uint8).data)
                    sizes[leaf] += records.nbytes
                    dirty.add(leaf)
                since += read
                if since >= COMMIT:
                    _commit(store, dirty, {"place": place, "sizes": sizes, "isDone": False})
                    since = 0
                tell(read)
        if [size // points.kind.itemsize for size in sizes] != counts.tolist():
            raise BadOptions("files of points were changed while they were read: begin anew, in another --work folder")
        _commit(store, dirty, {"place": place, "sizes": sizes, "isDone": True})


def _nothing(leaves: int) -> Dict[str, Any]:
    """How far a scatter is that begins."""
    return {"place": Place(), "sizes": [0] * leaves, "isDone": False}


def is_scattered(store: Store) -> bool:
    return store.has(STARTED) and bool(store.load(STARTED)["isDone"])


def scatter_anew(store: Store, leaves: int) -> None:
    """The next scatter() begins with the first file. WriteFailed."""
    store.save(STARTED, _nothing(leaves))


def _by_leaf(records: np.ndarray, leaves: Leaves, count: int) -> List[Tuple[int, np.ndarray]]:
    """Of each of so many leaves that has some its records, in their order."""
    of = leaves.leaf_of(np.ascontiguousarray(records["xyz"]))
    ends = np.cumsum(np.bincount(of, minlength=count))
    # take() is many times as fast as an index is, a sort of small numbers as one of others
    sorted_ = records.take(np.argsort(of.astype(np.uint16) if count <= 1 << 16 else of, kind="stable"))
    found = np.flatnonzero(np.diff(ends, prepend=0)).tolist()
    return [(leaf, sorted_[ends[leaf - 1] if leaf else 0 : ends[leaf]]) for leaf in found]


def _commit(store: Store, dirty: Set[int], state: Dict[str, Any]) -> None:
    for leaf in sorted(dirty):
        sync(_leaf_file(store, leaf))
    sync(store.path("leaf"))
    dirty.clear()
    store.save(STARTED, state)


def _leaf_file(store: Store, leaf: int) -> str:
    return store.path("leaf", "%d" % leaf)


def has_records(store: Store, leaf: int) -> bool:
    """Is its file there?"""
    return os.path.exists(_leaf_file(store, leaf))


def remove_records(store: Store, leaf: int) -> None:
    with contextlib.suppress(OSError):  # Windows keeps what a program looks at; the end of the run removes it
        os.remove(_leaf_file(store, leaf))


def records_of(store: Store, leaf: int, kind: np.dtype) -> np.ndarray:
    """Those of a leaf, in the file."""
    path = _leaf_file(store, leaf)
    if not os.path.getsize(path):
        return np.empty(0, kind)
    return np.memmap(path, kind, "r")
