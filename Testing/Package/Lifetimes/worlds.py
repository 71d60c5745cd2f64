# SPDX-License-Identifier: BSD-3-Clause
"""Steps, sequences, and the comparison of results.

A world is the state of a program: inputs, filters, results. A step is a method of the world that is decorated
by `step`; it gets a random number generator of its own, so that a sequence stays the same where steps before it are
left out. A sequence is written as a text, `fill:81,update:3`: names of steps and what their generators start from.
"""

import faulthandler
import gc
import os
import pathlib
import random
import signal
import time
import traceback
from collections.abc import Mapping

import numpy as np


#: Threads of the process before there is a world; those of NumPy's libraries among them.
TASKS = len(os.listdir("/proc/self/task")) if os.path.exists("/proc/self/task") else 1


class Mismatch(AssertionError):
    """A result is wrong."""


def step(weight=1):
    """Marks a method as a step, drawn with this weight."""

    def mark(method):
        method.weight = weight
        return method

    return mark


def bytes_of(thing):
    """All comparable data of a result: nested arrays and numbers."""
    if isinstance(thing, np.ndarray):
        return thing.dtype.str, thing.shape, thing.tobytes()
    if isinstance(thing, Mapping):
        return tuple((name, bytes_of(value)) for name, value in thing.items())
    if isinstance(thing, (list, tuple)):
        return tuple(bytes_of(member) for member in thing)
    fields = getattr(thing, "__dataclass_fields__", None)
    if fields:
        return tuple(bytes_of(getattr(thing, name)) for name in fields)
    return thing


def outcome(ask):
    """The result of a call, by bytes_of(), or its exception."""
    try:
        return bytes_of(ask())
    except (ValueError, TypeError, RuntimeError, MemoryError) as error:
        return type(error).__name__, str(error)


def expect_same(name, found, wanted):
    if found != wanted:
        raise Mismatch("%s: not what a new one gives%s" % (name, difference(found, wanted)))


def difference(found, wanted):
    """Where two results begin to differ, in words."""
    if isinstance(found, (tuple, list)) and isinstance(wanted, (tuple, list)) and len(found) == len(wanted):
        for k, (one, other) in enumerate(zip(found, wanted)):
            if one != other:
                return " [%d]%s" % (k, difference(one, other))
    return ": %.150r for %.150r" % (found, wanted)


class Kept:
    """Arrays that a program holds: only the program changes them."""

    def __init__(self):
        self.arrays = []

    def add(self, name, array):
        self.arrays.append((name, array, array.tobytes()))
        del self.arrays[:-40]

    def check(self):
        for name, array, wanted in self.arrays:
            if array.tobytes() != wanted:
                raise Mismatch("%s: changed while it was held" % name)


class Rubbish:
    """Memory that reuses blocks just freed, and objects that are collected late."""

    #: Objects in a cycle that is not collected before the interpreter ends.
    last = []

    @staticmethod
    def fill(rng):
        sizes = [rng.randrange(16, 4000) for _ in range(30)]
        return [np.full(size, 1 / 3) for size in sizes]

    @staticmethod
    def collect(rng):
        """In one of the ways in which cycles are collected."""
        if rng.random() < 0.6:
            gc.collect()
            return
        before = gc.get_threshold()
        gc.set_threshold(5, 2, 2)
        holders = [[k] for k in range(200)]
        gc.set_threshold(*before)
        del holders


def fork(work, seconds, threads=0):
    """Does some work in a child of fork, which is ended if it hangs. Mismatch if it fails. `threads`: so many of the
    program's threads wait meanwhile."""
    # A thread that was joined may still be in the sanitizer's allocator, which a child would find locked.
    tasks, tries = pathlib.Path("/proc/self/task"), 1000
    while tasks.exists() and len(list(tasks.iterdir())) > TASKS + threads and tries:
        tries -= 1
        time.sleep(0.001)
    child = os.fork()
    if child == 0:
        status = 1
        try:
            signal.alarm(seconds)
            faulthandler.dump_traceback_later(seconds - 5)  # where it hangs
            work()
            gc.collect()
            status = 0
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(status)
    status = os.waitpid(child, 0)[1]
    if status:
        raise Mismatch("a child of fork ended with %d" % status)


class World:
    """The superclass of worlds: has steps, and the results of steps to check."""

    def __init__(self):
        self.kept = Kept()

    @classmethod
    def steps(cls, without=()):
        """Names of the steps and their weights."""
        found = {name: getattr(cls, name) for name in sorted(dir(cls))}
        return {name: method.weight for name, method in found.items()
                if hasattr(method, "weight") and name not in without}

    @classmethod
    def sequence(cls, seed, count, without=()):
        """The text of the sequence with this number."""
        rng = random.Random("%s %s" % (cls.__name__, seed))
        steps = cls.steps(without)
        names = rng.choices(list(steps), list(steps.values()), k=count)
        return ",".join("%s:%d" % (name, rng.randrange(10000)) for name in names)

    def run(self, sequence):
        """Runs a sequence. Raises Mismatch, or any unexpected exception of a step."""
        for token in filter(None, sequence.split(",")):
            name, _, seed = token.partition(":")
            getattr(self, name)(random.Random("%s %s" % (name, seed)))
            self.kept.check()
        self.end()

    def end(self):
        """Checks at the end of a sequence."""
