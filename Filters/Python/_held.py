# SPDX-License-Identifier: BSD-3-Clause
"""Owners of objects kept between calls of the library: its jobs, and memory that it reads."""

from __future__ import annotations

import weakref
from typing import Any, Optional, Tuple

import numpy as np

from ._interface import C, OutOfMemory


class Handle:
    """The only owner of a job of the library.

    The job must be there for as long as any finalizer can still use it. Python's collector of cycles runs the
    finalizers of all that it found unreachable, in any order, and before them the callbacks of weak references to it.
    So neither `__del__` nor a weak reference to this object may free the job. An array is no container to the
    collector, which never finds one: the array below goes when the memory of this object goes, after all finalizers.
    """

    __slots__ = ("address", "_as_parameter_", "_lives", "_end")  # the second is what ctypes passes to the library

    def __init__(self) -> None:
        address = C.ahd_job_new()
        if not address:
            raise OutOfMemory("there is no memory for a job")
        self._lives = np.empty(0)
        self._end = weakref.finalize(self._lives, C.ahd_job_free, address)
        self._end.atexit = False  # others may use it until the very end
        self.address: Optional[int] = address
        self._as_parameter_ = address

    def abandon(self) -> None:
        """Never frees the job: that of a thread which was at work with it, in a child of fork, where it is no more."""
        self._end.detach()


class _NoHandle(Handle):
    """In place of one that was handed on: the library refuses every call."""

    __slots__ = ()

    def __init__(self) -> None:
        self.address = self._as_parameter_ = None


NO_HANDLE = _NoHandle()


def anchor(array: np.ndarray) -> Tuple[Any, ...]:
    """Keeps the memory of an array in place as long as it is held. The array alone does not: the one that owns
    the memory can be resized in place, and so can what other memory belongs to (a bytearray, an mmap, shared memory),
    unless it knows of somebody who looks at it."""
    owner = array
    while isinstance(owner.base, np.ndarray):
        owner = owner.base
    if owner.base is None:
        return array, weakref.ref(owner)  # NumPy resizes no array that has one, whatever `refcheck` says
    try:
        return array, memoryview(owner.base)
    except (TypeError, ValueError, BufferError):  # it has another way to show its memory
        return array, owner.base
