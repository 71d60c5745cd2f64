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

_under_way = []  # the interrupt to deliver: at most one
_called = []  # what Python has yet to call, once for each call; it holds no references itself

_is_true = ctypes.cast(ctypes.pythonapi.PyObject_IsTrue, ctypes.c_void_p)
_any_function = ctypes.pythonapi.Py_IsInitialized  # for _take_off: with an exception set, it could not be found


def _asker(frame):
    """The frame that called VTK, from which the request comes that this frame works on; None if no code in Python
    did."""
    while frame is not None:
        if frame.f_code.co_name == "ProcessRequest" and "vtkself" in frame.f_code.co_varnames:  # what C++ calls
            return frame.f_back
        frame = frame.f_back
    return None


def _is_below(frame, other):
    """Was this frame called by the other one, directly or not?"""
    while frame is not None and frame is not other:
        frame = frame.f_back
    return frame is not None


def _take_off(raised):
    """Clears an exception that is set while Python is called, as by VTK when it warns that a filter in Python raised
    one: with it set, functions in C seem to fail. One that is not this one is printed, as VTK would have."""
    try:
        _any_function()  # a function of ctypes.pythonapi raises what is set after it
    except BaseException as left:
        if left is not raised:
            sys.excepthook(type(left), left, left.__traceback__)


class _Failed:
    """An algorithm of which a request fails for an exception. The pipeline need not tell of what that tells. Where VTK
    calls the algorithm for one block after the other, it takes no notice; with an input of no kind of data set, which
    it tells of, filters behind do not run, nor writers."""

    def __init__(self, algorithm):
        self.algorithm, self.executive, self.outputs = algorithm, algorithm.GetExecutive(), []
        self.observed = [(self.executive, self.executive.AddObserver("ErrorEvent", lambda _caller, _event: None)),
                         (algorithm, algorithm.AddObserver("EndEvent", self._hide_blocks))]

    def _hide_blocks(self, _caller, _event):
        for port in range(self.algorithm.GetNumberOfOutputPorts()):
            data, info = self.executive.GetOutputData(port), self.executive.GetOutputInformation(port)
            if data is not None and data.IsA("vtkCompositeDataSet"):
                data.Initialize()
                self.outputs.append((info, data))
                info.Set(data.DATA_OBJECT(), self.algorithm._backend.vtkDataObject())

    def end(self):
        for info, data in self.outputs:
            info.Set(data.DATA_OBJECT(), data)
        for observed, tag in self.observed:
            observed.RemoveObserver(tag)
        self.algorithm.Modified()  # the next update runs, also where a block alone failed


class _Arrival:
    """An exception on its way to a frame; where that works on a request itself, as a filter in Python does that asks
    others, VTK loses what is raised, and it goes on to the frame that this request comes from."""

    def __init__(self, raised, asker):
        self.raised, self.asker, self.failed = raised, asker, []
        _under_way.append(self)
        self._set_out()

    def fail(self, algorithm):
        """Takes down that a request of this algorithm fails for it. Returns what says so to VTK."""
        self.failed.append(_Failed(algorithm))
        return 0

    def is_under_way(self, frame):
        """Is it still to arrive? If its asker has ended without it, it arrives at who asks in this frame."""
        if not _is_below(frame, self.asker):
            self.asker = _asker(frame)
            if self.asker is None:
                self._end()
            else:
                self._set_out()
        return self in _under_way

    def _set_out(self):
        for _ in range(2):  # from Python 3.13 on, what the 32nd call in a row adds is forgotten if no other waits
            self._go_on()

    def _go_on(self):
        """Has Python, in the main thread, ask for the truth of this between two of its steps: what that raises, it
        raises where it was."""
        _called.append(self)
        if ctypes.pythonapi.Py_AddPendingCall(_is_true, ctypes.py_object(self)) != 0:  # too many wait
            _called.remove(self)
            if self not in _called and self in _under_way:
                self._end()

    def __bool__(self):
        """Never true: raises the exception in the frame that it is for."""
        _take_off(self.raised)
        try:
            _called.remove(self)
            self._arrive(sys._getframe(1))
        finally:
            if self in _under_way:
                self._go_on()
        return False

    def _arrive(self, frame):
        if self not in _under_way or (frame is not self.asker and _is_below(frame, self.asker)):
            return
        self.asker = _asker(frame)
        if self.asker is None:
            self._end()
        raise self.raised.with_traceback(None)

    def _end(self):
        _under_way.remove(self)
        for failed in self.failed:
            failed.end()


def is_under_way():
    """Is an exception on its way in this thread?"""
    if not _under_way or threading.current_thread() is not threading.main_thread():
        return False
    return _under_way[0].is_under_way(sys._getframe(1))


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
            asker, done = _asker(sys._getframe()), 0
            is_main = threading.current_thread() is threading.main_thread()
            if asker is not None and is_main and not is_under_way():
                _Arrival(raised, asker)
        return _under_way[0].fail(self) if is_under_way() else done

    return method
