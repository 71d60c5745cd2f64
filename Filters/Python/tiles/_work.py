# SPDX-License-Identifier: BSD-3-Clause
"""Tasks on several threads, each with what it owns; the library's calls release the GIL."""

from __future__ import annotations

import queue
import threading
from collections import deque
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from typing import Any, Callable, Deque, Dict, Generator, Iterable, List, Mapping, Sequence, TypeVar

from ._leaves import Leaves

Item = TypeVar("Item")
Made = TypeVar("Made")

IN_ORDER = 4  #: threads at the most whose results are in order, as each holds some: a disk is not faster


def ahead(items: Iterable[Item], depth: int = 1) -> Generator[Item, None, None]:
    """The same items, made by a thread of their own, at most so many before they are asked for. To be closed, so that
    the thread ends."""
    made: "queue.Queue[Any]" = queue.Queue(depth)
    isOver = threading.Event()

    def put(*what: Any) -> bool:
        while not isOver.is_set():
            try:
                made.put(what, timeout=0.1)
                return True
            except queue.Full:
                continue
        return False

    def make() -> None:
        try:
            if all(put(item) for item in items):
                put()
        except BaseException as error:
            put(None, error)

    thread = threading.Thread(target=make, name="tiles")
    try:
        thread.start()
        while True:
            try:
                got = made.get(timeout=1.0)  # not for ever: Ctrl-C on Windows
            except queue.Empty:
                continue
            if len(got) != 1:
                if got:
                    raise got[1]
                return
            yield got[0]
    finally:
        isOver.set()
        if thread.is_alive():  # Ctrl-C may have come while start() waited for it to begin
            thread.join()


class Workers:
    """Threads with a `Leaves` of a plan each."""

    def __init__(self, count: int, saved: Any, settings: Mapping[str, float]) -> None:
        self.count = count
        self._all: List[Leaves] = []
        self._free: "queue.SimpleQueue[Leaves]" = queue.SimpleQueue()
        for _ in range(count):
            made = Leaves()
            made.load(saved)
            made.set(**settings)
            self._all.append(made)
            self._free.put(made)

    def run(self, tasks: Iterable[Any], work: Callable[[Leaves, Any], Any], ended: Callable[[Any], Sequence[Any]]
            ) -> None:  # fmt: skip
        """work(leaves, task) of each task in some thread, then ended(task) in this one, which returns tasks that can
        begin now: these come first. An exception, Ctrl-C too, ends all at once."""
        ready: Deque[Any] = deque(tasks)
        running: Dict[Future[Any], Any] = {}
        with ThreadPoolExecutor(self.count, "tiles") as pool:
            try:
                while ready or running:
                    while ready and len(running) < self.count:
                        task = ready.popleft()
                        running[pool.submit(self._one, work, task)] = task
                    for done in wait(running, 1.0, FIRST_COMPLETED).done:  # not for ever: Ctrl-C on Windows
                        task = running.pop(done)
                        done.result()
                        ready.extendleft(reversed(ended(task)))
            except BaseException:
                self._end(running)
                raise

    def in_order(self, items: Iterable[Item], work: Callable[[Leaves, Item], Made]) -> Generator[Made, None, None]:
        """work(leaves, item) of each item in some thread, a few ahead, and what they make in the order of the items. To
        be closed."""
        some = min(self.count, IN_ORDER)
        if some == 1:
            for item in items:
                yield self._one(work, item)
            return
        running: Deque[Future[Made]] = deque()
        with ThreadPoolExecutor(some, "tiles") as pool:
            try:
                for item in items:
                    running.append(pool.submit(self._one, work, item))
                    if len(running) > some:
                        yield _result(running.popleft())
                while running:
                    yield _result(running.popleft())
            except BaseException:
                self._end(running)
                raise

    def _end(self, running: Iterable[Future[Any]]) -> None:
        for future in running:
            future.cancel()
        for leaves in self._all:
            leaves.cancel()

    def _one(self, work: Callable[[Leaves, Item], Made], task: Item) -> Made:
        leaves = self._free.get()
        try:
            return work(leaves, task)
        finally:
            self._free.put(leaves)


def _result(future: Future[Made]) -> Made:
    while not wait([future], 1.0).done:  # not for ever: Ctrl-C on Windows
        pass
    return future.result()
