# SPDX-License-Identifier: BSD-3-Clause
"""The warnings of a run that succeeded."""

from __future__ import annotations

import sys
import warnings
from typing import Any, Iterable, Mapping

from ._interface import SAY_TRIANGULATION, WORDS_OF_NUMPY, say


class DelaunayWarning(UserWarning):
    """Part of the input is not in the triangulation, or there is no triangle: which part, why, and how many.

    `warnings.simplefilter("error", DelaunayWarning)` turns them into errors.
    """


def warn(job: Any, facts: Mapping[str, Any]) -> None:
    """One DelaunayWarning for each message of a job that has run, and of `facts`."""
    tell(say(SAY_TRIANGULATION, WORDS_OF_NUMPY, facts, job).values())


def tell(messages: Iterable[str]) -> None:
    """A DelaunayWarning of each, in the name of the first caller outside of this package."""
    for message in messages:
        warnings.warn(message, DelaunayWarning, stacklevel=_depth())


def _depth() -> int:
    """The stacklevel, for who calls this, of the first caller outside of this package. By names of modules: files may
    have no path, as where the working directory was deleted."""
    inside, depth = __name__.rpartition(".")[0], 1
    frame = sys._getframe(1)
    while frame.f_back is not None and (str(frame.f_globals.get("__name__")) + ".").startswith(inside + "."):
        frame, depth = frame.f_back, depth + 1
    return depth
