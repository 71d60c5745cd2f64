# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the tables for callers from Python: tables, signatures and docstrings of `delaunay` (NumPy) and of the
functions of `mesh.adaptive` (PyVista)."""

import dataclasses
import math
import re

import rows as tables

COLUMNS = 120
# Which functions of mesh.adaptive have a keyword.
GROUPS = ("points", "surface", "delaunay_2d", "voronoi_2d")
WANTS = ("any time", "in the run")


@dataclasses.dataclass
class Keyword:
    """A keyword as one of the two has it. `kind`: str, bool, int, float, or Any where an array is taken in place of a
    name; `names`: of a str; `ends`: of a number."""

    name: str
    setting: str
    kind: str
    default: object
    names: tuple
    ends: tuple
    about: str
    group: str

    @property
    def shown_default(self):
        return repr(self.default).replace("'", '"')

    @property
    def hint(self):
        """For type checkers."""
        if self.name == "memory_limit":
            return "Union[int, str]"
        if self.kind == "Any":
            return f"Union[{_literal(self.names)}, Corners]"
        return _literal(self.names) if self.kind == "str" else self.kind

    @property
    def type(self):
        """For docstrings."""
        if self.names:
            array = " or (n, 2) array" if self.kind == "Any" else ""
            return "{" + ", ".join(map(repr, self.names)) + "}" + array
        if self.kind == "bool":
            return self.kind
        if self.name == "memory_limit":
            return "int, 0 or more, or str"
        least, most = (tables.numbers(end)[0] if math.isfinite(end) else "" for end in self.ends)
        if self.ends[1] >= 2**31 - 1:
            return f"{self.kind}, {least} or more"
        return f"{self.kind} from {least} to {most}"


def _literal(names):
    return "Literal[" + ", ".join(f'"{name}"' for name in names) + "]"


def _keyword(one, name, setting, names, default, about):
    is_switch = not names and one.ends == (0, 1) and one.type != "double"
    of_words = "Any" if one.array else "str"
    kind = of_words if names else "bool" if is_switch else "float" if one.type == "double" else "int"
    value = names[default] if names else bool(default) if is_switch else default
    return Keyword(name, setting, kind, value, tuple(names), one.ends, about, one.mesh)


def _first(value, other):
    return other if value is None else value


def of_numpy(settings):
    """In the order of the panel."""
    found = [one for one in settings if one.keyword]
    return [_keyword(one, one.keyword, one.name, one.names, _first(one.keyword_default, one.default), one.about)
            for one in sorted(found, key=lambda one: one.place)]


def of_mesh(settings):
    """Likewise, with the filter's settings."""
    found = [one for one in settings if one.mesh]
    made = []
    for one in sorted(found, key=lambda one: one.place):
        default = _first(one.mesh_default, _first(one.keyword_default, one.default))
        made.append(_keyword(one, one.mesh_keyword or one.keyword, one.of_filter, one.mesh_names or one.names, default,
                             one.mesh_about or one.about))
    names = {one.keyword: one.mesh_keyword for one in found if one.mesh_keyword}
    for keyword in made:
        keyword.about = re.sub(r"`(\w+)`", lambda word: f"`{names.get(word[1], word[1])}`", keyword.about)
    return made


def _chosen(settings, *words):
    """Those of mesh.adaptive with these names or in these groups, but those with the names after `but`."""
    cut = words.index("but") if "but" in words else len(words)
    keywords = of_mesh(settings)
    found = [one for word in words[:cut] for one in keywords if word in (one.name, one.group)]
    return [one for one in found if one.name not in words[cut + 1:]]


# --- tables -------------------------------------------------------------------------------------


def _rows(keywords):
    lines = []
    for one in keywords:
        said = one.shown_default
        if one.names:
            said += ", words=" + repr(one.names)
        elif one.kind != "bool":
            said += f", least={one.ends[0]!r}, most={repr(one.ends[1]).replace('inf', 'math.inf')}"
        head, said = f'    "{one.name}": Keyword("{one.setting}",', said.replace("'", '"') + "),"
        lines += [f"{head} {said}"] if len(head + said) < COLUMNS else [head, "        " + said]
    return lines


def numpy_rows(settings, _):
    return _rows(of_numpy(settings))


def mesh_rows(settings, _):
    return _rows(of_mesh(settings))


def wanted(settings, _):
    """What `want` of delaunay may name: first what can be had at any time."""
    return [f'    "{name}",' for kind in WANTS for name in _wanted(settings, kind)]


def _wanted(settings, kind):
    return [one.name.partition("_")[2] for one in settings if one.want == kind]


# --- signatures ---------------------------------------------------------------------------------


def numpy_parameters(settings, _):
    return [f"    {one.name}: {one.hint} = {one.shown_default}," for one in of_numpy(settings)]



def mesh_parameters(settings, _, *words):
    return [f"    {one.name}: {one.hint} = {one.shown_default}," for one in _chosen(settings, *words)]


# --- docstrings ---------------------------------------------------------------------------------


def _paragraphs(keywords):
    lines = []
    for one in keywords:
        lines.append(f"    {one.name} : {one.type}, default {one.default!r}")
        lines += tables.wrapped(one.about, "        ")
    return lines


def numpy_paragraphs(settings, _):
    return _paragraphs(of_numpy(settings))


def mesh_paragraphs(settings, _, *words):
    return _paragraphs(_chosen(settings, *words))


def mesh_names(settings, _, *words):
    """Those that are described with another function."""
    names = ", ".join(one.name for one in _chosen(settings, *words))
    return [line for part in tables.wrapped(names, "    ", COLUMNS - 4) for line in (
        part.rstrip(","), "        As in `delaunay_2d`.")]


def numpy_want(settings, _):
    names, again = (list(map(repr, names)) for names in (
        [name for kind in WANTS for name in _wanted(settings, kind)], _wanted(settings, "in the run")))
    text = (f"Results to compute in this call: {', '.join(names)}. All are available later, too; "
            f"{', '.join(again[:-1])} and {again[-1]} then triangulate once more.")
    return ["    want : sequence of str, optional", *tables.wrapped(text, "        ")]


def mesh_arrays(arrays, _):
    """The keyword of delaunay_2d that adds arrays."""
    with_keyword = [one for one in arrays if one.keyword]
    said = {of: ", ".join(f'"{one.name}" ({one.keyword!r})' for one in with_keyword if one.of == of)
            for of in ("points", "cells")}
    text = f"Arrays to add: point data {said['points']}; cell data {said['cells']}."
    return ["    arrays : iterable of {" + ", ".join(repr(one.keyword) for one in with_keyword) + "}",
            *tables.wrapped(text, "        ")]
