# SPDX-License-Identifier: BSD-3-Clause
"""The table of a job's settings, and its generated parts: rows for C++, the list in ahd.h."""

import dataclasses
import math
import tomllib

import doors
import rows as tables

HUGE = 2**62
LEFT, RIGHT = 17, 26  # columns of the list: defaults, texts
MOST = {"int": 2**31 - 1, "id": HUGE, "int64": HUGE, "double": math.inf}
SAID = {2**31 - 1: "2^31 - 1", HUGE: "2^62", 1.7e308: "1.7e308", math.inf: "infinity"}


@dataclasses.dataclass
class Setting:
    """README.md says what each field means."""

    name: str
    type: str
    default: object
    least: object = None
    most: object = None
    words: str = ""
    units: str = ""
    help: str = ""
    says_range: bool = True
    elsewhere: bool = False
    setting: str = ""
    run: str = ""
    keyword: str = ""
    names: tuple = ()
    array: bool = False
    keyword_default: object = None
    about: str = ""
    want: str = ""
    mesh: str = ""
    mesh_keyword: str = ""
    mesh_names: tuple = ()
    mesh_default: object = None
    mesh_about: str = ""
    # Of the filter's setting: its name, its place there, the value that counts on a surface.
    of_filter: str = ""
    place: int = 0
    on_surface: object = None

    @property
    def ends(self):
        """Least and most. An enum of the filter's without words here is a switch."""
        if self.type in tables.SWITCHES:
            return 0, 1
        if self.type == "enum":
            return 0, self.most
        return self.least, MOST[self.type] if self.most is None else self.most

    def check(self):
        """ValueError for a row that says what none can."""
        if self.type not in (*MOST, *tables.SWITCHES, "enum"):
            raise ValueError(f"[{self.name}]: there is no type {self.type}")
        if None in self.ends:
            raise ValueError(f"[{self.name}]: no least or most")
        for names, default in ((self.names, self.keyword_default), (self.mesh_names, self.mesh_default)):
            if names and len(set(names)) != self.ends[1] + 1 - self.array:
                raise ValueError(f"[{self.name}]: {len(set(names))} names for 0 to {self.ends[1]}")
            if default is not None and not self.ends[0] <= default <= self.ends[1]:
                raise ValueError(f"[{self.name}]: the default {default} is not from {self.ends[0]} to {self.ends[1]}")
        for wrong, text in ((bool(self.keyword) != bool(self.about), "about: of keywords, and each has it"),
                            (self.keyword and not self.of_filter, "a keyword has a setting of the filter's"),
                            (self.mesh and self.mesh not in doors.GROUPS, f"mesh is one of {doors.GROUPS}"),
                            (self.mesh and not self.keyword, "mesh: of keywords"),
                            (self.want and self.want not in doors.WANTS, f"want is one of {doors.WANTS}")):
            if wrong:
                raise ValueError(f"[{self.name}]: {text}")

    @property
    def value(self):
        return int(self.default) if self.type != "double" else self.default


def read(file, rows):
    """The settings in their order; `rows`: the filter's."""
    with open(tables.HERE / file, "rb") as opened:
        table = tomllib.load(opened)
    of_filter = tables.settings(rows)
    missing = {row.job for row in of_filter if row.job} - table.keys()
    if missing:
        raise ValueError(f"[{min(missing)}]: no row in {file}, and a setting has that job")
    found = [_setting(name, said, of_filter) for name, said in table.items()]
    for door in (doors.of_numpy, doors.of_mesh):
        for keyword in tables.twice([one.name for one in door(found)]):
            raise ValueError(f"{file}: two rows have the keyword {keyword}")
    return found


def _setting(name, said, of_filter):
    row = next((row for row in of_filter if row.name == said.get("setting") or row.job == name), None)
    known = {field.name for field in dataclasses.fields(Setting)} - {"of_filter", "place", "on_surface"}
    if said.keys() - known or (not row and not {"type", "default"} <= said.keys()):
        raise ValueError(f"[{name}]: type and default, if no filter's setting has this job, and of {', '.join(known)}")
    same = {}
    if row:
        most = len(row.values) - 1 if row.values else row.most
        same = {"type": row.type, "default": row.default, "least": row.least, "most": most, "of_filter": row.name,
                "place": of_filter.index(row), "on_surface": row.on_surface}
    made = Setting(name=name, **{**same, **said})
    made.check()
    return made


def _of_kind(settings, is_real):
    return [one for one in settings if (one.type == "double") == is_real]


def constants(settings, is_real):
    names = [tables.constant(one.name) for one in _of_kind(settings, is_real)]
    return [f"  {name}," for name in names[:-1]] + [f"  {names[-1]}"]


def rows(settings, is_real):
    return [f'  {{ "{one.name}", {", ".join(map(_literal, (one.value, *one.ends)))} }},'
            for one in _of_kind(settings, is_real)]


def on_surface(settings, is_real):
    """The settings that a surface has used up, and the values in place of theirs."""
    return [f"  {{ {'Double' if is_real else 'Int'}Setting::{tables.constant(one.name)}, "
            f"{one.on_surface if is_real else int(one.on_surface)} }},"
            for one in _of_kind(settings, is_real) if one.on_surface is not None]


def run_members(settings):
    """The statements that give a run those of its members that are settings."""
    return [f"  put((*this)[{'Double' if one.type == 'double' else 'Int'}Setting::{tables.constant(one.name)}], "
            f"run.{one.run});" for one in settings if one.run]


def _literal(value):
    if value == math.inf:
        return "std::numeric_limits<double>::infinity()"
    return repr(value)


def said(settings):
    """The list in ahd.h, in lines of a comment."""
    lines = []
    for is_real, kind in ((False, "int (made of Filters/Settings/job.toml, as what is double)"), (True, "double")):
        lines.append(f" * {kind}")
        for one in _of_kind(settings, is_real):
            if not one.elsewhere:
                head = f"{one.name}  ".ljust(LEFT) + f"{tables.numbers(one.value)[0]}  "
                lines.append(f" *   {head.ljust(RIGHT)}{_about(one)}")
    too_long = [line for line in lines if len(line) > 100]
    if too_long:
        raise ValueError(f"{too_long[0]}: more than 100 characters")
    return lines


def _about(one):
    if one.words:
        parts = [one.words, one.help]
        return "; ".join(part for part in parts if part)
    least, most = one.ends
    ends = "0, 1" if (least, most) == (0, 1) and one.type != "double" else (
        f"{tables.numbers(least)[0]} to {SAID.get(most) or f'{most:g}'}")
    if not one.says_range:
        return one.help
    ends = ", ".join(part for part in (one.units, ends) if part)
    return ends + ("; " if one.help.startswith("0:") else ": ") + one.help
