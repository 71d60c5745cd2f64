# SPDX-License-Identifier: BSD-3-Clause
"""The world of a program that triangulates NumPy arrays: see worlds.py."""

import contextlib
import copy
import gc
import pickle
import signal
import sys
import threading
import warnings

import numpy as np
from worlds import Mismatch, Rubbish, World, bytes_of, expect_same, fork, outcome, step

from adaptivehilbertdelaunay import (
    DelaunayWarning, LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator, delaunay, release_memory,
)  # fmt: skip

METHODS = ("linear", "natural", "laplace", "nearest")


def heights(made):
    return np.sin(np.arange(len(made.plane_points)) * 0.7)


def places(rng, count=40):
    return np.random.default_rng(rng.randrange(1000)).random((count, 2)) * 1.2 - 0.1


def sampled(method):
    return lambda made, at: made.interpolate(heights(made), at, method)


#: Queries of a triangulation: functions of it and of some places.
ASKS = {name: (lambda made, _, name=name: getattr(made, name)) for name in (
    "triangles", "neighbors", "edges", "boundary", "hull", "plane_points", "point_status", "vertex_of_point",
    "point_of_vertex", "merged", "constraint_edges", "is_constraint", "regions", "left_out", "order", "insertion_ranks",
    "boxes", "lines", "vertices")}
ASKS.update({"interpolate " + method: sampled(method) for method in METHODS})
ASKS.update({
    "voronoi": lambda made, _: made.voronoi(),
    "locate": lambda made, at: made.locate(at),
    "weights": lambda made, at: made.weights(at),
    "natural weights": lambda made, at: made.weights(at, "natural"),
    "gradient": lambda made, at: made.interpolate(heights(made), at, gradient=True),
    "raster": lambda made, _: made.interpolate(heights(made), made.raster(shape=(7, 5))),
    "filled": lambda made, at: made.interpolate(heights(made), at, outside="nearest"),
})


def meshed(made):
    """The arrays of its mesh."""
    mesh = made.refine(25, maximum_added=50)
    return tuple(getattr(mesh, name) for name in (
        "points", "triangles", "regions", "edges", "markers", "on_boundary", "corners", "weights", "bad", "reasons"))


#: Beside those, as they take longer.
MORE = {"errors": lambda made, _: made.errors, "mesh": lambda made, _: meshed(made)}


def closure_of(thing):
    """A function that refers to itself and to something else."""

    def cycle():
        return cycle, thing

    return cycle


class Turned:
    """A function for `plane`, which keeps its argument; copies of it keep nothing."""

    def __init__(self, turn, how, kept):
        self.turn, self.how, self.kept = turn, how, kept

    def __reduce__(self):
        return Turned, (self.turn, self.how, None)

    def __call__(self, xyz):
        x = xyz[:, 0].copy()
        xyz[:, 0] += self.turn * xyz[:, 1]
        xyz[:, 1] -= self.turn * x
        if self.kept is not None:
            self.kept.add("what the function of the plane got", xyz)
        return xyz.copy() if self.how == 0 else xyz if self.how == 1 else None


class Item:
    """A triangulation, the arrays it was made of as its program has them, and copies of these from that time."""

    def __init__(self, make, inputs):
        self.make, self.inputs = make, inputs
        self.given = {name: copy.deepcopy(array) for name, array in inputs.items()}
        self.changed = False  # are the inputs others now?
        self.made = make(inputs)

    def fresh(self):
        return self.make({name: copy.deepcopy(array) for name, array in self.given.items()})

    def check(self, name, at):
        ask = ASKS.get(name) or MORE[name]
        found = outcome(lambda: ask(self.made, at))
        if self.changed and found[0] == "RuntimeError":
            return None
        expect_same(name, found, outcome(lambda: ask(self.fresh(), at)))
        return found


class Arrays(World):
    """Triangulations of arrays, and all operations on them."""

    def __init__(self):
        super().__init__()
        self.items, self.errors = [], []
        warnings.simplefilter("ignore", DelaunayWarning)
        sys.setswitchinterval(1e-5)
        self.make_plain()

    def make_plain(self):
        self.items.append(Item(lambda given: delaunay(**given), {"points": np.random.default_rng(0).random((60, 2))}))

    def _item(self, rng):
        if not self.items:
            self.make_plain()
        return rng.choice(self.items)

    def _inputs(self, rng):
        kind, count = rng.randrange(5), rng.choice((3, 5, 24, 101, 400))
        random = np.random.default_rng(rng.randrange(1000))
        points = random.random((count, rng.choice((2, 3)))).astype(rng.choice((np.float64, np.float32)))
        if kind == 0:
            points = np.round(points * 8) / 8  # a lattice, with duplicates
        if kind == 1:
            points = np.repeat(points, 2, axis=0)[::2]  # rows that are not contiguous
        made = {"points": points}
        if rng.random() < 0.3:
            made["segments"] = random.integers(0, count, (3, 2))
        if rng.random() < 0.2:
            made["loops"] = [rng.sample(range(count), min(4, count))]
        if rng.random() < 0.3:
            made["skip"] = random.random(count) < 0.1
        if rng.random() < 0.2:
            made["source_points"] = random.random((count, 2))
        return made

    def _keywords(self, rng):
        found = {"threads": rng.randrange(3)}
        for name, among in (("crossings", ("leave_out", "split")), ("duplicates", ("first", "mean_z", "lowest_z")),
                            ("plane", ("xy", "best_fit")), ("id_dtype", (np.int32, np.int64))):
            if rng.random() < 0.3:
                found[name] = rng.choice(among)
        return found

    # --- making ---

    @step(6)
    def make(self, rng):
        keywords = self._keywords(rng)
        if rng.random() < 0.3:
            keywords["want"] = rng.sample(("neighbors", "order", "voronoi", "boxes", "regions"), 2)
        self.items.append(Item(lambda given: delaunay(**given, **keywords), self._inputs(rng)))
        del self.items[:-5]

    @step(1)
    def make_many(self, rng):
        """So many points that changes of all could cancel in a sum of bits."""
        points = np.random.default_rng(rng.randrange(9)).random((16384, 2))
        self.items.append(Item(lambda given: delaunay(**given), {"points": points}))

    @step(3)
    def make_with_plane(self, rng):
        """With a function that keeps its argument."""
        plane = Turned(rng.random(), rng.randrange(3), self.kept)
        inputs = {"points": np.random.default_rng(rng.randrange(99)).random((rng.choice((7, 300)), 3))}
        self.items.append(Item(lambda given: delaunay(**given, plane=plane), inputs))

    @step(3)
    def simplify(self, rng):
        """A lighter one of the same points, by arrays that its program changes afterwards."""
        item, random = self._item(rng), np.random.default_rng(rng.randrange(99))
        numbers = random.random((3, len(item.given["points"])))
        given = dict(maximum_error=rng.choice((0.0, 0.1, 0.3)), second_pass=rng.random() < 0.3, values=numbers[0])
        if rng.random() < 0.3:
            given.update(weights=numbers[1], keep=numbers[2] < 0.1)
        if rng.random() < 0.2:
            given.update(maximum_vertices=10)
        own, make, other = copy.deepcopy(given), item.make, copy.copy(item)
        other.make = lambda inputs: make(inputs).simplify(**copy.deepcopy(own))
        with contextlib.suppress(ValueError, RuntimeError):  # means exclude it; the inputs are others now
            other.made = item.made.simplify(**given)
            numbers[:] = 7.0
            other.check("triangles", None)
            self.items.append(other)
            del self.items[:-5]

    @step(2)
    def make_and_fail(self, rng):
        """A callback raises, or an argument is invalid; the error is kept, with the objects of its frames."""
        points, how = np.random.default_rng(rng.randrange(99)).random((300, 3)), rng.randrange(4)

        def fails(*given):
            raise ArithmeticError("of a callback")

        try:
            if how == 0:
                delaunay(points, plane=fails)
            elif how == 1:
                delaunay(points, progress=fails)
            elif how == 2:
                delaunay(points, segments=[[0, 300]])
            else:
                LinearInterpolator(points, points[:7, 0])
        except (ArithmeticError, ValueError) as error:
            self._keep_error(error)
        else:
            raise Mismatch("nothing was raised")

    def _keep_error(self, error):
        trace = error.__traceback__
        while trace.tb_next is not None:
            trace = trace.tb_next
            for found in list(trace.tb_frame.f_locals.values()):
                for array in found if isinstance(found, tuple) else (found,):
                    if isinstance(array, np.ndarray):
                        self.kept.add("an array of an error's frame", array)
        self.errors.append(error)
        del self.errors[:-3]

    @step(2)
    def make_interpolator(self, rng):
        kind = rng.choice((LinearInterpolator, NaturalNeighborInterpolator, NearestInterpolator))
        rescale = rng.random() < 0.3
        points = np.random.default_rng(rng.randrange(99)).random((50, 2))
        made, at = kind(points, points[:, 0], rescale=rescale), places(rng)
        other = kind(points.copy(), points[:, 0].copy(), rescale=rescale)
        expect_same(kind.__name__, bytes_of(made(at)), bytes_of(other(at)))
        box = [made]
        del made
        self._leave(rng, box)

    @step(2)
    def interrupt(self, rng):
        """Ctrl-C while the engine works."""
        points, rest = np.random.default_rng(1).random((200, 2)), [rng.randrange(4)]

        def progress(*_):
            rest[0] -= 1
            if rest[0] == -1:
                signal.raise_signal(signal.SIGINT)

        with contextlib.suppress(KeyboardInterrupt):
            delaunay(points, progress=progress, want="voronoi")
            if rest[0] < 0:
                raise Mismatch("Ctrl-C was swallowed")

    @step(1)
    def cancel(self, rng):
        """A progress function that makes another triangulation and stops this one."""
        item = self._item(rng)

        def progress(*_):
            item.check("triangles", None)
            raise StopIteration

        with contextlib.suppress(StopIteration):
            delaunay(np.random.default_rng(2).random((200, 2)), progress=progress)
            raise Mismatch("what a progress function raised was swallowed")

    # --- queries ---

    @step(14)
    def ask(self, rng):
        item, name = self._item(rng), rng.choice(list(ASKS))
        item.check(name, places(rng))
        if not item.changed and rng.random() < 0.3:
            self._keep(item.made, name, places(rng))

    def _keep(self, made, name, at):
        with contextlib.suppress(RuntimeError, ValueError):
            found = ASKS[name](made, at)
            for array in found if isinstance(found, tuple) else (found,):
                if isinstance(array, np.ndarray):
                    self.kept.add(name, array)

    @step(4)
    def ask_more(self, rng):
        self._item(rng).check(rng.choice(list(MORE)), None)

    @step(3)
    def ask_in_threads(self, rng):
        item, at = self._item(rng), places(rng)
        names, barrier, failed = rng.sample(list(ASKS), 3), threading.Barrier(3), []

        def work(name):
            barrier.wait()
            try:
                item.check(name, at)
            except BaseException as error:
                failed.append(error)

        threads = [threading.Thread(target=work, args=(name,)) for name in names]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if failed:
            raise failed[0]

    @step(2)
    def release(self, rng):
        (self._item(rng).made.release if rng.random() < 0.7 else release_memory)()

    @step(3)
    def pickle(self, rng):
        item, how = self._item(rng), rng.randrange(3)
        other = copy.copy(item)
        copies = lambda made: pickle.loads(pickle.dumps(made)), copy.deepcopy, copy.copy  # noqa: E731
        other.made = copies[how](item.made)
        if how < 2:
            other.inputs = {}
        self.items.append(other)

    # --- changing ---

    @step(4)
    def change_points(self, rng):
        self._change(rng, ("points",))

    @step(2)
    def change_other_inputs(self, rng):
        self._change(rng, ("segments", "skip", "source_points"))

    def _change(self, rng, names):
        item = self._item(rng)
        arrays = [item.inputs[name] for name in names if isinstance(item.inputs.get(name), np.ndarray)]
        if not arrays:
            return
        array, how = rng.choice(arrays), rng.randrange(3)
        if how == 0 and array.dtype.kind == "f":
            array[:, 1] *= -1
        elif how == 1 and array.dtype.kind == "f":
            array[rng.randrange(len(array))] += 0.5
        else:
            array[:] = array[::-1].copy()
        item.changed = any(bytes_of(value) != bytes_of(item.given[name]) for name, value in item.inputs.items())
        for other in self.items:
            if any(array is mine for mine in other.inputs.values()):
                other.changed = item.changed

    @step(2)
    def restore(self, rng):
        item = self._item(rng)
        for name, array in item.inputs.items():
            if isinstance(array, np.ndarray):
                array[...] = item.given[name]
        for other in self.items:
            if other.inputs and other.inputs.get("points") is item.inputs.get("points"):
                other.changed = False

    # --- letting go ---

    @step(4)
    def drop(self, rng):
        """The last reference is dropped; results held of it stay."""
        if self.items:
            self._leave(rng, [self.items.pop(rng.randrange(len(self.items))).made])

    def _leave(self, rng, box):
        """Drops the last reference to the content of a box, in one of the ways programs do: mostly in a cycle."""
        thing, how = box.pop(), rng.randrange(6)
        if how == 0:
            return
        if how == 1:
            cycle = [thing]
            cycle.append(cycle)
        elif how == 2:
            cycle = type("Holder", (), {})()
            cycle.ask, cycle.made = cycle.__reduce__, thing
        elif how == 3:
            cycle = closure_of(thing)
        elif how == 4:
            try:
                raise LookupError("of a program")
            except LookupError as error:
                cycle = error
                self.errors.append(error)
        else:
            cycle = {"made": thing}
            cycle["self"] = cycle
            Rubbish.last[:] = [cycle]
        del thing, cycle
        Rubbish.collect(rng)

    @step(3)
    def leave_cycle(self, rng):
        """A triangulation that only the garbage collector frees; its memory is not that of the next ones."""
        self._leave(rng, [delaunay(np.random.default_rng(rng.randrange(9)).random((30, 2)), threads=1)])
        self.items.append(Item(lambda given: delaunay(**given), self._inputs(rng)))

    @step(1)
    def collect_in_thread(self, rng):
        self.errors.clear()
        thread = threading.Thread(target=gc.collect)
        thread.start()
        thread.join()

    # --- fork ---

    @step(1)
    def fork(self, rng):
        item, names = self._item(rng), rng.sample(list(ASKS), 2)
        fork(lambda: [item.check(name, places(rng)) for name in names], 60)

    @step(1)
    def fork_while_asked(self, rng):
        """Another thread holds the lock that the child needs."""
        asked, forked = threading.Event(), threading.Event()

        def plane(xyz):
            if threading.current_thread() is not threading.main_thread():
                asked.set()
                forked.wait(60)

        points = np.random.default_rng(3).random((40, 3))
        made = delaunay(points, plane=plane, rim="convex_hull", threads=1)
        thread = threading.Thread(target=lambda: made.order)
        thread.start()
        asked.wait(60)
        wanted = bytes_of(delaunay(points).neighbors)
        try:
            fork(lambda: expect_same("neighbors", bytes_of(made.neighbors), wanted), 20, threads=1)
        finally:
            forked.set()
            thread.join()

    def end(self):
        for item in self.items:
            item.check("triangles", None)
        self.errors.clear()
