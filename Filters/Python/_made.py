# SPDX-License-Identifier: BSD-3-Clause
"""Results of a request, computed when first used, and the job that computes them."""

from __future__ import annotations

import os
import sys
import threading
from typing import Any, Callable, Dict, Optional, Set

import numpy as np

from . import _library as library
from ._input import Fingerprint, Request

# Those that a run makes only if it was told before.
_TOLD_BEFORE = frozenset(("insertion_ranks", "order", "boxes", "voronoi"))


def frozen(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


_forks = 0  # that made this process
_renewing = threading.Lock()


def _after_fork() -> None:
    global _forks, _renewing
    _forks += 1
    _renewing = threading.Lock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)


class Made:
    """Holds the job of a request, and its results."""

    _job: Optional[library.Job]
    _told: Set[str]  # announced to the job before it ran
    _cached: Dict[str, Any]  # the results
    _fingerprint: Fingerprint  # of the input when the job ran first
    _counts: Any  # Dict[str, int]

    def _start(self, request: Request, id_dtype: Any) -> None:
        self._request = request
        self._dtype = np.dtype(id_dtype)
        self._lock = threading.RLock()
        self._forks = _forks
        self._job = None
        self._told = set()
        self._cached = {}
        self._fingerprint = {}

    def _locked(self) -> Any:
        """Enters the lock: the job and the results are for one thread at a time."""
        if self._forks != _forks:
            with _renewing:
                if self._forks != _forks:
                    self._leave_to_the_parent()
                    self._forks = _forks
        return self._lock

    def _leave_to_the_parent(self) -> None:
        """In a child of fork: a thread that held the lock cannot release it or finish its work."""
        if self._lock.acquire(blocking=False):
            self._lock.release()
        else:
            self._lock, self._job = threading.RLock(), None

    def _run(self, told: Set[str], progress: Any = None) -> library.Job:
        """A new job that has run, in place of the one there was."""
        self._give_back()
        job = self._request.job(sorted(told))
        if progress is not None:
            job.set_progress(lambda phase, fraction: progress(library.PHASES[phase], fraction) and None)
        job.run()
        self._job, self._told = job, told
        return job

    def _give_back(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            library.give_back(job)

    def __del__(self, ends: Callable[[], bool] = sys.is_finalizing) -> None:
        """Leaves the library's job to the next one. This object stays as good as any: what another finalizer asks it
        for is made by a new job."""
        if self.__dict__.get("_job") is not None and not ends():
            self._give_back()

    def _check_input(self) -> None:
        """RuntimeError if it has changed since it was triangulated."""
        changed = self._request.first_changed(self._fingerprint)
        if changed:
            raise RuntimeError("the %s were changed after they were triangulated: triangulate them again" % changed)

    def _engine(self, name: str = "") -> library.Job:
        """The job, told of this before it ran. Requires: the lock."""
        self._check_input()
        tell = {name} & _TOLD_BEFORE
        if self._job is None or not tell <= self._told:
            return self._run((self._told | tell) & _TOLD_BEFORE)
        return self._job

    def _made(self, name: str, make: Any) -> Any:
        found = self._cached.get(name)
        if found is None:
            with self._locked():
                found = self._cached.get(name)
                if found is None:
                    found = self._cached[name] = make()
        return found

    def _array(self, name: str, dtype: Any = None, told: str = "") -> np.ndarray:
        """An output array of the engine."""
        made: np.ndarray = self._made(name, lambda: frozen(self._engine(told).array(name, dtype or self._dtype)))
        return made
