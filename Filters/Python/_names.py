# SPDX-License-Identifier: BSD-3-Clause
"""Names that are accepted beside those that documents have: keywords and values are the same at both doors of Python,
`delaunay` and `mesh.adaptive`, but for what PyVista calls otherwise in its own `delaunay_2d`."""

from __future__ import annotations

import functools
import inspect
from typing import Any, Callable, Mapping, TypeVar

#: Of values, by the keyword that has them: the other name and the one that documents have.
VALUES: Mapping[str, Mapping[str, str]] = {
    "duplicates": {"lowest": "lowest_z", "highest": "highest_z", "mean": "mean_z"},
    "rim": {"auto": "automatic", "hull": "convex_hull"},
    "plane": {"auto": "automatic", "fit": "best_fit"},
}

#: Of keywords: each pair names one thing. A function has one of them in its signature.
KEYWORDS = (
    ("maximum_edge_length", "max_edge_length"),
    ("maximum_segment_length", "max_segment_length"),
    ("bounding", "bound"),
    ("tolerance", "tol"),
    ("source_heights", "heights"),
    ("voronoi_clip", "clip"),
    ("minimum_angle", "min_angle"),
    ("maximum_area", "max_area"),
    ("maximum_length", "max_length"),
    ("sizes", "size"),
)

Function = TypeVar("Function", bound=Callable[..., Any])


def value_of(keyword: str, value: Any) -> Any:
    """The name that documents have, if this is another one for it."""
    return VALUES.get(keyword, {}).get(value, value) if isinstance(value, str) else value


def by_any_name(positional: str = "") -> Callable[[Function], Function]:
    """Decorates a function that takes each keyword of its signature by the other name too. TypeError for one that is
    given by both, and with the words of `positional` for more than one argument without a name, if there are any."""

    def decorate(function: Function) -> Function:
        signature = inspect.signature(function)
        has = signature.parameters
        pairs = (pair[::step] for pair in KEYWORDS for step in (1, -1))
        others = {other: name for name, other in pairs if name in has and other not in has}

        names = frozenset(others)

        @functools.wraps(function)
        def call(*arguments: Any, **keywords: Any) -> Any:
            if positional and len(arguments) > 1:
                raise TypeError("%s() %s" % (function.__name__, positional))
            if names.isdisjoint(keywords):
                return function(*arguments, **keywords)
            for other in names & keywords.keys():
                name = others[other]
                if name in keywords or name in list(signature.parameters)[: len(arguments)]:
                    raise TypeError("%s() got %s and %s, which are two names for one argument" % (
                        function.__name__, name, other))  # fmt: skip
                keywords[name] = keywords.pop(other)
            return function(*arguments, **keywords)

        return call  # type: ignore[return-value]

    return decorate
