# SPDX-License-Identifier: BSD-3-Clause
"""How a run of tiles can fail; the command ends with the exit code of the class."""

from __future__ import annotations


class TilesError(Exception):
    """What keeps a result from being made. Outputs that were there before are unchanged."""

    exit_code = 1


class BadOptions(TilesError, ValueError):
    """Options that do not go together, or that the points do not fit: an output that is there already, another run's
    folder, a cell in metres with degrees."""

    exit_code = 2


class BadFile(TilesError, ValueError):
    """A file cannot be read, or is not what it says."""

    exit_code = 3

    def __init__(self, path: str, message: str) -> None:
        super().__init__("%s: %s" % (path, message))
        self.path = path


class NoSurface(TilesError, ValueError):
    """There are no three points that are not on a line, or none of the class."""

    exit_code = 4


class NoRoom(TilesError, MemoryError):
    """There is not the memory, or not the room on the disk, that the plan says."""

    exit_code = 5


class WriteFailed(TilesError, OSError):
    """A file cannot be written; what was done before is kept for --resume."""

    exit_code = 6


INTERRUPTED = 130  #: the exit code after Ctrl-C
