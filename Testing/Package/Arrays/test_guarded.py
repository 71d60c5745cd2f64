# SPDX-License-Identifier: BSD-3-Clause
"""The suites of arrays once more, with inaccessible memory after each array: reading or writing one number past the end
ends the process.
"""

import ctypes
import importlib
import mmap
import sys
import unittest

import numpy as np

import adaptivehilbertdelaunay  # noqa: F401 (a package of the path, before the suites)
from adaptivehilbertdelaunay import _library as library

SUITES = ("test_results", "test_keywords", "test_runs", "test_sampling", "test_places", "test_oracle")
PAGE = mmap.PAGESIZE


def forbid(address):
    """Makes the page that begins here inaccessible."""
    page, size = ctypes.c_void_p(address), ctypes.c_size_t(PAGE)
    if sys.platform == "win32":
        no_access, before = 1, ctypes.c_uint32()
        done = ctypes.windll.kernel32.VirtualProtect(page, size, no_access, ctypes.byref(before)) != 0
    else:
        done = ctypes.CDLL(None).mprotect(page, size, 0) == 0
    if not done:
        raise OSError("the page at %x cannot be protected" % address)


def guarded(count, item):
    """Bytes for `count` items, which end at an inaccessible page."""
    size = max(1, count) * item
    pages = -(-size // PAGE)
    memory = mmap.mmap(-1, (pages + 1) * PAGE)
    address = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    forbid(address + pages * PAGE)
    return np.frombuffer(memory, np.uint8, size, pages * PAGE - size)[: count * item]


def empty(shape, dtype=float, order="C"):
    """As NumPy's."""
    kind = np.dtype(dtype)
    count = int(np.prod(shape, dtype=np.int64))
    return np.ndarray(shape, kind, guarded(count, kind.itemsize).data, order=order)


def copy(array):
    """The same numbers with the same strides, if these go up; else in rows."""
    if array.size == 0 or min(array.strides) < array.itemsize:
        made = empty(array.shape, array.dtype)
    else:
        span = sum((n - 1) * stride for n, stride in zip(array.shape, array.strides)) + array.itemsize
        made = np.ndarray(array.shape, array.dtype, guarded(span, 1).data, 0, array.strides)
    made[...] = array
    return made


class Numpy:
    """NumPy, with arrays that are guarded."""

    def __getattr__(self, name):
        return getattr(np, name)

    empty = staticmethod(empty)

    @staticmethod
    def ascontiguousarray(array, dtype=None):
        return copy(np.ascontiguousarray(array, dtype))


def guard():
    """Every array that goes over the border is guarded."""
    for name, module in list(sys.modules.items()):
        if name.startswith("adaptivehilbertdelaunay._") and hasattr(module, "np"):
            module.np = Numpy()
    given = library.Job.set_array
    library.Job.set_array = lambda job, name, array, _=None: given(job, name, None if array is None else copy(array))


class GuardTest(unittest.TestCase):
    def test_arrays_end_where_they_should(self):
        for dtype in (np.uint8, np.float32, np.float64):
            for count in (1, 3, 511, 513):
                self.assertEqual((empty(count, dtype).ctypes.data + count * np.dtype(dtype).itemsize) % PAGE, 0)
        strided = copy(np.arange(24.0).reshape(6, 4)[::2, 1:3])
        self.assertEqual(strided.tolist(), [[1.0, 2.0], [9.0, 10.0], [17.0, 18.0]])
        self.assertEqual((strided[-1:, -1:].ctypes.data + 8) % PAGE, 0)


def load_tests(loader, tests, _pattern):
    guard()
    for name in SUITES:
        tests.addTests(loader.loadTestsFromModule(importlib.import_module(name)))
    return tests


if __name__ == "__main__":
    unittest.main()
