# SPDX-License-Identifier: BSD-3-Clause
"""Calls of the library that are at work: who is told of them, what they look at, and how they end when Ctrl-C is
pressed, when the interpreter ends and in a child of fork."""

from __future__ import annotations

import atexit
import ctypes
import os
import threading
import time
from types import FrameType
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    import signal
else:
    try:
        import _signal as signal  # without the conversions to enumerations, which take ten times as long
    except ImportError:
        import signal

from ._held import anchor
from ._interface import BAD_ARRAY, BUSY, NO_JOB, BadInput, NotAvailable, Progress, Projection

if TYPE_CHECKING:
    from ._library import Job


class Call(NamedTuple):
    """One that is at work."""

    job: Job  # is told by callbacks
    thread: threading.Thread
    arrays: List[Any]  # owners of the memory that the library reads and writes meanwhile


AT_WORK: Dict[Optional[int], Call] = {}  # by the address of the library's job, which callbacks are given


def _on_progress(number: int, phase: int, fraction: float) -> int:
    job = AT_WORK[number].job
    try:
        if job._raised is None and job._progress is not None and job._progress(phase, fraction):
            return 1
    except BaseException as error:
        job._raised = error
    return 0 if job._raised is None else 1


def _on_projection(number: int, xyz: int, count: int) -> int:
    """The function gets a copy: references to it, also in a debugger, outlive the library's memory."""
    job = AT_WORK[number].job
    try:
        if job._raised is None and job._projection is not None:
            points = np.empty((count, 3))
            ctypes.memmove(points.ctypes.data, xyz, points.nbytes)
            job._projection(points)
            if points.shape != (count, 3):
                raise BadInput("the projection changed the shape of its points to %s" % (points.shape,), BAD_ARRAY)
            moved = np.ascontiguousarray(points, np.float64)
            ctypes.memmove(xyz, moved.ctypes.data, moved.nbytes)
    except BaseException as error:
        job._raised = error
    return 0 if job._raised is None else 1


PROGRESS, NO_PROGRESS = Progress(_on_progress), Progress()
PROJECTION, NO_PROJECTION = Projection(_on_projection), Projection()


# --- Ctrl-C -------------------------------------------------------------------------------------------------


class Interrupts:
    """While it is entered, exceptions of the handler of SIGINT are put aside: they cancel the call, which raises them,
    and those that its callbacks have made of other jobs.

    Python runs the handler when a callback begins, before its first line: an exception from there would be
    printed by ctypes and lost. Only the main thread runs handlers, so others need none of this.

    The handler that the program wants is the one that it set last: before, by its handler or by a callback.
    """

    def __init__(self, job: Job, thread: threading.Thread) -> None:
        self._job = job
        self._thread = thread  # this one
        self._handler: Any = None  # the program's
        self._isEntered = False

    def __enter__(self) -> None:
        if self._thread is not threading.main_thread():
            return
        handler = signal.getsignal(signal.SIGINT)
        if not callable(handler):
            return
        self._handler, self._isEntered = handler, True
        try:
            signal.signal(signal.SIGINT, self._interrupt)
        except ValueError:  # an interpreter beside the main one: it runs no handlers
            self._isEntered = False

    def __exit__(self, *_: Any) -> None:
        if self._isEntered:
            last = signal.signal(signal.SIGINT, self._handler)
            if last != self._interrupt:  # which the program has set meanwhile
                signal.signal(signal.SIGINT, last)
            self._isEntered = False

    def _put_aside(self, error: BaseException) -> None:
        self._job._raised = error
        for call in list(AT_WORK.values()):
            if call.thread is self._thread:
                call.job._raised = error

    def _interrupt(self, number: int, frame: Optional[FrameType]) -> None:
        if not self._isEntered:  # a program that looked the handler up during the work has set it again
            self._handler(number, frame)
            return
        before = signal.getsignal(signal.SIGINT)  # not this one, where a call within the call has this one as handler
        try:
            self._handler(number, frame)
        except BaseException as error:
            self._put_aside(error)
        changed = signal.getsignal(signal.SIGINT)
        if changed != before and callable(changed):
            self._handler = changed
            signal.signal(signal.SIGINT, self._interrupt)


# --- The call -----------------------------------------------------------------------------------------------

SOON = 0.05  #: seconds of a call before it notices Ctrl-C: most end sooner, and are spared the callbacks


def busy() -> NotAvailable:
    return NotAvailable("the triangulation is being computed: a progress function cannot use it", BUSY)


def make_call(job: Job, function: Any, arguments: Tuple[Any, ...], arrays: Sequence[np.ndarray]) -> int:
    """Calls a function of the library with a job and these arguments, and returns the status. `arrays`: those of
    callers whose addresses are among the arguments."""
    handle = job._handle
    thread = threading.current_thread()
    call = Call(job, thread, [anchor(array) for array in arrays])
    if handle.address is None:
        return NO_JOB
    raised: Optional[BaseException] = None
    try:
        with Interrupts(job, thread):  # until the call is unregistered
            try:
                if AT_WORK.setdefault(handle.address, call) is not call:
                    raise busy()
                end_with_the_program()
                # without a progress function the main thread alone, for Ctrl-C
                isMain = thread is threading.main_thread()
                job._hear(0.0 if job._progress is not None else SOON if isMain else None)
                status = function(handle, *arguments)
            finally:
                if AT_WORK.get(handle.address) is call:
                    del AT_WORK[handle.address]
    finally:
        if handle.address not in AT_WORK:  # else it is for the call that is at work
            raised, job._raised = job._raised, None
    if raised is not None:
        try:
            raise raised
        finally:
            del raised  # else it and this frame keep each other
    end_with_the_program()
    return int(status)


# --- When threads end that are at work ----------------------------------------------------------------------

_isEnding = False


def _at_exit() -> None:
    """Daemon threads may be at work when the interpreter ends. A callback cannot come after that (it would end the
    process with an error), so their work is cancelled, and none begins."""
    global _isEnding
    _isEnding = True
    until = time.monotonic() + 10  # a callback of theirs may never return
    while time.monotonic() < until:
        calls = [call for call in list(AT_WORK.values()) if call.thread.daemon]
        if not calls:
            return
        for call in calls:
            call.job.cancel()
        time.sleep(0.001)


def end_with_the_program() -> None:
    """Ends a daemon thread where the interpreter ends."""
    if _isEnding and threading.current_thread().daemon:
        raise SystemExit


def _after_fork() -> None:
    """In a child process there is the thread that forked, alone. What others were at work with stays half done."""
    for address, call in list(AT_WORK.items()):
        if call.thread is not threading.current_thread():
            del AT_WORK[address]
            call.job.begin_anew()


atexit.register(_at_exit)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)
