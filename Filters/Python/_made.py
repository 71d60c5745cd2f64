# SPDX-License-Identifier: BSD-3-Clause
"""What is made of a request when it is asked for, and the job that makes it."""

from __future__ import annotations

import sys
import threading
from typing import Any, Callable, Dict, Optional, Set

import numpy as np

from . import _library as library
from ._input import Request, checksum

# Those that a run makes only if it was told before.
_TOLD_BEFORE = frozenset(("insertion_ranks", "order", "boxes", "voronoi"))


def frozen(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


class Made:
    """Holds the job of a request, and what has been made of it."""

    _job: Optional[library.Job]
    _told: Set[str]  # what the job was told before it ran
    _hasPlaces: bool  # has the job read the points for the last time?
    _cached: Dict[str, Any]  # what has been made
    _checksum: Optional[bytes]  # of points that the caller can change
    _counts: Dict[str, int]
    _measures: Dict[str, float]

    def _start(self, request: Request, id_dtype: Any) -> None:
        self._request = request
        self._dtype = np.dtype(id_dtype)
        self._lock = threading.RLock()
        self._job = None
        self._told = set()
        self._hasPlaces = False
        self._cached = {}
        self._checksum = None

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
        job, self._job, self._hasPlaces = self._job, None, False
        if job is not None:
            library.give_back(job)

    def __del__(self, ends: Callable[[], bool] = sys.is_finalizing) -> None:
        if self.__dict__.get("_job") is not None and not ends():
            self._give_back()

    def _engine(self, name: str = "") -> library.Job:
        """The job, told of this before it ran. REQUIRES: the lock."""
        if self._checksum is not None and checksum(self._request.points) != self._checksum:
            raise RuntimeError("the points were changed after they were triangulated: triangulate them again")
        tell = {name} & _TOLD_BEFORE
        if self._job is None or not tell <= self._told:
            return self._run((self._told | tell) & _TOLD_BEFORE)
        return self._job

    def _made(self, name: str, make: Any) -> Any:
        found = self._cached.get(name)
        if found is None:
            with self._lock:
                found = self._cached.get(name)
                if found is None:
                    found = self._cached[name] = make()
        return found

    def _array(self, name: str, dtype: Any = None, told: str = "") -> np.ndarray:
        """An output array of the engine."""
        made: np.ndarray = self._made(name, lambda: frozen(self._engine(told).array(name, dtype or self._dtype)))
        return made
