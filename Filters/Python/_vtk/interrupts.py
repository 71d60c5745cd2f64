# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C while VTK asks for data.

VTK calls these classes from C++, where what Python raises is printed and lost. So a request that Ctrl-C ends fails:
the pipeline puts nothing out, and filters behind are not run. The exception arrives in the code in Python that asked
VTK for something, as soon as C++ has returned to it.
"""

import ctypes
import functools
import sys
import threading

_under_way = []  # what is to arrive: one at most


def _asker():
    """The frame that called VTK, from which these requests come; None if no code in Python did."""
    frame, found = sys._getframe(1), None
    while frame is not None:
        if frame.f_code.co_name == "ProcessRequest":  # VTK's, which C++ calls
            found = frame
        frame = frame.f_back
    return found and found.f_back


def _is_below(frame, other):
    """Was this frame called by the other one, directly or not?"""
    while frame is not None and frame is not other:
        frame = frame.f_back
    return frame is not None


class _Arrival:
    """An exception on its way to a frame. The pipeline need not tell of what an exception tells."""

    def __init__(self, raised, asker):
        self.raised, self.asker, self.failed = raised.with_traceback(None), asker, []
        _under_way.append(self)
        self._go_on()

    def fail(self, algorithm):
        """Takes down that a request of this algorithm fails for it. Returns what says so to VTK."""
        executive = algorithm.GetExecutive()
        self.failed.append((algorithm, executive, executive.AddObserver("ErrorEvent", lambda _caller, _event: None)))
        return 0

    def _go_on(self):
        """Has Python, in the main thread, ask for the truth of this between two of its steps: what that raises, it
        raises where it was."""
        is_true = ctypes.cast(ctypes.pythonapi.PyObject_IsTrue, ctypes.c_void_p)
        if ctypes.pythonapi.Py_AddPendingCall(is_true, ctypes.py_object(self)) != 0:  # too many wait
            self._end()

    def __bool__(self):
        """Never true: raises the exception in the frame that it is for."""
        frame = sys._getframe(1)
        if frame is not self.asker and _is_below(frame, self.asker):
            self._go_on()
            return False
        self._end()
        raise self.raised

    def _end(self):
        _under_way.remove(self)
        for algorithm, executive, tag in self.failed:
            executive.RemoveObserver(tag)
            algorithm.Modified()  # the next update runs, also where a block alone failed


def is_under_way():
    """Is an exception on its way in this thread?"""
    return bool(_under_way) and threading.current_thread() is threading.main_thread()


def ends_by_ctrl_c(request):
    """Decorates a ProcessRequest: 0 where Ctrl-C ends it, or has ended what it was called for."""

    @functools.wraps(request)
    def method(self, *given):
        if is_under_way():
            return _under_way[0].fail(self)
        try:
            done = request(self, *given)
        except Exception:
            raise
        except BaseException as raised:
            asker, done = _asker(), 0
            if asker is not None and threading.current_thread() is threading.main_thread():
                _Arrival(raised, asker)
        return _under_way[0].fail(self) if is_under_way() else done

    return method
