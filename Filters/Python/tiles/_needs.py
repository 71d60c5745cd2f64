# SPDX-License-Identifier: BSD-3-Clause
"""Which groups need the points of which leaves. A leaf's file is removed when all of these are done, so that at no time
the disk holds all points and all results."""

from __future__ import annotations

from collections import Counter
from typing import Counter as Counts
from typing import Dict, List, Sequence, Set

from . import _finish
from ._finish import Finish
from ._leaves import Leaves
from ._points import has_records, remove_records
from ._work import Workers


class Needs:
    """Of groups that are not done. With lines, lists are known when a group is done; so nothing is removed."""

    def __init__(self, finish: Finish, groups: Sequence[range], workers: Workers) -> None:
        self._finish, self._keepsAll = finish, finish.wanted.hasLines
        self._of: Dict[range, Set[int]] = {}
        workers.run([] if self._keepsAll else groups, self._find, lambda group: [])
        self._users: Counts[int] = Counter(leaf for leaves in self._of.values() for leaf in leaves)
        self._done: List[range] = []

    def _find(self, leaves: Leaves, group: range) -> None:
        self._of[group] = self._finish.needed(leaves, group)

    def are_there(self) -> bool:
        """Are all files? Those of a run whose results were removed are not."""
        return all(has_records(self._finish.store, leaf) for leaf in self._users)

    def begin(self) -> None:
        """Removes what no group needs, which a run that ended may have left."""
        if not self._keepsAll:
            self._finish.sync()
            leaves = set(range(len(self._finish.plan.counts))) - set(self._users)
            self._remove({leaf for leaf in leaves if has_records(self._finish.store, leaf)})

    def end(self, group: range) -> None:
        """The group is done."""
        self._done.append(group)
        counts = self._finish.plan.counts
        if self._keepsAll or sum(int(counts[leaf]) for one in self._done for leaf in one) < _finish.BATCH:
            return
        self._finish.sync()
        needed = [leaf for one in self._done for leaf in self._of.pop(one)]
        self._users.subtract(needed)
        self._remove({leaf for leaf in needed if self._users[leaf] == 0})
        self._done = []

    def _remove(self, leaves: Set[int]) -> None:
        for leaf in leaves:
            remove_records(self._finish.store, leaf)
