# SPDX-License-Identifier: BSD-3-Clause
"""The work folder: files that are there whole or not at all, so that a run that ended at any moment can go on.

A file is written under another name, closed, on the disk, and renamed. What is there is done, what ends in ".part" is
not. A power cut may take renames back, which costs their work; so before a file is removed because of another, the
folder of that is synced. `manifest.json` says of which files and settings the work folder is. Nothing is made or
removed in a folder that has anything else than these files.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import shutil
import sys
from typing import Any, Dict, IO, Iterator, Sequence

import numpy as np

from ._errors import BadOptions, WriteFailed

PART = ".part"
MANIFEST = "manifest.json"
COUNTED = "counted"  #: what the first step found: a line of JSON, then the plan of leaves
STARTED = "scatter.json"  #: of a run that has done more than count
FINISHED = "finished.json"  #: of one whose results need only be put together
ENDED = "ended"  #: of one whose results are there
LOCK = "lock"  #: of one that is at work
FOLDERS = ("leaf", "border", "own", "share", "cells")


def sync(path: str) -> None:
    """Has the disk what was written to a file or, where the system can be asked, renamed in a folder?"""
    isFolder = os.path.isdir(path)
    if isFolder and os.name == "nt":
        return
    handle = os.open(path, os.O_RDONLY if isFolder else os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


@contextlib.contextmanager
def written(path: str) -> Iterator[IO[bytes]]:
    """A file that is at `path` once it is whole. WriteFailed, with nothing there."""
    made = path + PART
    try:
        with open(made, "wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(made, path)
    except BaseException as error:
        with contextlib.suppress(OSError):
            os.remove(made)
        if isinstance(error, OSError) and not isinstance(error, WriteFailed):
            raise WriteFailed("%s cannot be written: %s" % (path, error.strerror or error)) from error
        raise


def hash_of(value: Any) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()


class Store:
    """The folder, and what is in it by name."""

    def __init__(self, folder: str) -> None:
        self.folder = os.path.abspath(folder)
        self.key = ""  # of inputs and settings

    def path(self, *names: str) -> str:
        return os.path.join(self.folder, *names)

    @contextlib.contextmanager
    def held(self) -> Iterator[None]:
        """Makes the folder, where no other run is at work meanwhile. The system lets go of it when the process ends,
        however that is. BadOptions, WriteFailed."""
        names = MANIFEST, COUNTED, STARTED, FINISHED, ENDED, LOCK, *FOLDERS
        if not has_only(self.folder, "|".join(map(re.escape, names))):
            raise BadOptions("%s is no folder of a run, and is not empty: name another with --work" % self.folder)
        with failing(self.folder):
            os.makedirs(self.folder, exist_ok=True)
            try:
                file = _held(self.path(LOCK))
            except BlockingIOError:
                raise BadOptions("%s: another run is at work there" % self.folder) from None
        with file:
            try:
                yield
            finally:
                file.close()  # Windows removes no open file
                self.remove(LOCK)
                with contextlib.suppress(OSError):
                    os.rmdir(self.folder)

    def begin(self, inputs: Sequence[str], settings: Dict[str, Any], resume: bool) -> None:
        """Begins, or goes on if the work is of these inputs and settings. BadOptions, WriteFailed."""
        stats = [(os.path.abspath(path), *_state(path)) for path in inputs]
        self.key = hash_of([stats, settings])
        if self.has(MANIFEST):
            isSame = self.load(MANIFEST)["key"] == self.key
            if isSame and (resume or not self.has(STARTED)):
                return
            if isSame:
                raise BadOptions("%s has the work of a run that did not end: go on with --resume, or remove it" % (
                    self.folder,))  # fmt: skip
            if self.has(STARTED):
                raise BadOptions("%s has the work of a run of other files (names, sizes, times) or settings: remove "
                                 "it, or name another folder with --work" % self.folder)  # fmt: skip
            self.end()  # another plan, no more
        with failing(self.folder):
            for name in FOLDERS:
                os.makedirs(self.path(name), exist_ok=True)
        self.save(MANIFEST, {"key": self.key, "settings": settings, "inputs": [one[0] for one in stats]})

    def has(self, *names: str) -> bool:
        return os.path.exists(self.path(*names))

    def load(self, *names: str) -> Any:
        with open(self.path(*names), encoding="utf-8") as file:
            return json.load(file)

    def save(self, name: str, value: Any) -> None:
        with written(self.path(name)) as file:
            file.write(json.dumps(value).encode())

    def save_bytes(self, folder: str, name: str, array: np.ndarray) -> None:
        with written(self.path(folder, name)) as file:
            file.write(array.data)

    def load_bytes(self, folder: str, name: str) -> np.ndarray:
        """In the file, where there are any."""
        path = self.path(folder, name)
        return np.memmap(path, np.uint8, "r") if os.path.getsize(path) else np.empty(0, np.uint8)

    def remove(self, *names: str) -> None:
        with contextlib.suppress(FileNotFoundError):
            os.remove(self.path(*names))

    def end(self) -> None:
        """The work is done: nothing of the folder is left."""
        with written(self.path(ENDED)):
            pass
        self.clear()

    def clear(self) -> None:
        """Removes what a run left that was at its end; the mark of that goes last."""
        if not self.has(ENDED):
            return
        for name in os.listdir(self.folder):
            if os.path.isdir(self.path(name)):
                shutil.rmtree(self.path(name), ignore_errors=True)
            elif name not in (ENDED, LOCK):
                self.remove(name)
        self.remove(ENDED)


def has_only(folder: str, names: str) -> bool:
    """Is nothing in the folder, if it is there, but files and folders of these names, a pattern, whole or not?"""
    if not os.path.isdir(folder):
        return not os.path.lexists(folder)
    return all(re.fullmatch("(%s)(%s)?" % (names, re.escape(PART)), name) for name in os.listdir(folder))


def _state(path: str) -> Sequence[int]:
    """What shows that a file has changed. One that is not there is left out, or said, elsewhere."""
    with contextlib.suppress(OSError):
        found = os.stat(path)
        return found.st_size, found.st_mtime_ns
    return ()


def _held(path: str) -> IO[bytes]:
    """A file that this run alone has while it is open. BlockingIOError if another has it, OSError."""
    if sys.platform == "win32":  # which removes no open file; not every C library says why a lock failed
        try:
            with contextlib.suppress(FileNotFoundError):
                os.remove(path)
            return open(path, "xb")
        except (PermissionError, FileExistsError) as error:
            if not os.path.exists(path):
                raise
            raise BlockingIOError(str(error)) from error
    import fcntl

    file = open(path, "ab")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        raise
    except OSError:  # a disk without locks
        pass
    return file


@contextlib.contextmanager
def failing(path: str) -> Iterator[None]:
    """OSErrors of the block are WriteFailed, with the path."""
    try:
        yield
    except WriteFailed:
        raise
    except OSError as error:
        raise WriteFailed("%s cannot be written: %s" % (error.filename or path, error.strerror or error)) from error
