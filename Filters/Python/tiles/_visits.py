# SPDX-License-Identifier: BSD-3-Clause
"""First visits: the border of each leaf, and those of nodes as soon as their parts are done."""

from __future__ import annotations

from typing import Any, Callable, Dict, List

import numpy as np

from .._interface import OutOfMemory
from ._errors import NoRoom
from ._leaves import Leaves, Plan
from ._points import records_of
from ._store import Store, sync
from ._work import Workers


class Visits:
    """A part is done if its border is there, or what the node above made of it: borders of its parts are removed."""

    def __init__(self, store: Store, plan: Plan, kind: np.dtype, hasLines: bool) -> None:
        self.store, self.kind, self.hasLines = store, kind, hasLines
        self.leaves, self.parents = len(plan.counts), plan.parents.tolist()
        self.parts: Dict[int, List[int]] = {}
        for part, parent in enumerate(self.parents):
            self.parts.setdefault(parent, []).append(part)
        self.done = set(filter(self._is_done, range(len(self.parents))))

    def run(self, workers: Workers, tell: Callable[[int], Any]) -> None:
        def ended(part: int) -> List[int]:
            tell(1)
            return self._ended(part)

        nodes = [node for node in range(self.leaves, len(self.parents)) if self._can_begin(node)]
        workers.run([*nodes, *(leaf for leaf in range(self.leaves) if leaf not in self.done)], self._work, ended)

    def _is_done(self, part: int) -> bool:
        folders = ["share"] if part >= self.leaves else ["border", "own"] if self.hasLines else ["border"]
        isThere = all(self.store.has(folder, str(part)) for folder in folders)
        return isThere or (self.parents[part] >= 0 and self._is_done(self.parents[part]))

    def _can_begin(self, node: int) -> bool:
        return node >= 0 and node not in self.done and self.done.issuperset(self.parts[node])

    def _work(self, leaves: Leaves, part: int) -> None:
        store, name = self.store, str(part)
        if part < self.leaves:
            border, own = leaves.visit(part, np.ascontiguousarray(records_of(store, part, self.kind)["xyz"]))
            if self.hasLines:
                store.save_bytes("own", name, own)
            store.save_bytes("border", name, border)
        else:
            try:
                border, share = leaves.merge(part, [store.load_bytes("border", str(one)) for one in self.parts[part]])
            except OutOfMemory as error:
                raise NoRoom(str(error)) from error
            store.save_bytes("border", name, border)
            store.save_bytes("share", name, share)  # after which the node is done

    def _ended(self, part: int) -> List[int]:
        """Parts that can begin now."""
        self.done.add(part)
        if part >= self.leaves:
            for folder in ("own", "border", "share"):
                sync(self.store.path(folder))
            for one in self.parts[part]:
                self.store.remove("border", str(one))
        return [self.parents[part]] if self._can_begin(self.parents[part]) else []
