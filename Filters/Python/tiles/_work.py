# SPDX-License-Identifier: BSD-3-Clause
"""Tasks on several threads, each with what it owns; the library's calls release the GIL."""

from __future__ import annotations

import queue
from collections import deque
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from typing import Any, Callable, Deque, Dict, Iterable, List, Mapping, Sequence

from ._leaves import Leaves


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
        running: Dict[Future[None], Any] = {}
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
                for future in running:
                    future.cancel()
                for leaves in self._all:
                    leaves.cancel()
                raise

    def _one(self, work: Callable[[Leaves, Any], Any], task: Any) -> None:
        leaves = self._free.get()
        try:
            work(leaves, task)
        finally:
            self._free.put(leaves)
