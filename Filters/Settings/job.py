# SPDX-License-Identifier: BSD-3-Clause
"""The table of a job's settings, and its generated parts: rows for C++, the list in ahd.h, keywords of `delaunay`."""

import dataclasses
import math
import tomllib

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
    keyword: str = ""
    names: tuple = ()
    keyword_default: object = None

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
        if self.names and len(self.names) != self.ends[1] + 1:
            raise ValueError(f"[{self.name}]: {len(self.names)} names for 0 to {self.ends[1]}")

    @property
    def value(self):
        return int(self.default) if self.type != "double" else self.default


def read(file, rows):
    """The settings in their order; `rows`: the filter's."""
    with open(tables.HERE / file, "rb") as opened:
        table = tomllib.load(opened)
    of_filter = {row.job: row for row in tables.settings(rows) if row.job}
    if of_filter.keys() - table.keys():
        raise ValueError(f"[{min(of_filter.keys() - table.keys())}]: no row in {file}, and a setting has that job")
    return [_setting(name, said, of_filter.get(name)) for name, said in table.items()]


def _setting(name, said, row):
    known = {field.name for field in dataclasses.fields(Setting)}
    if said.keys() - known or (not row and not {"type", "default"} <= said.keys()):
        raise ValueError(f"[{name}]: type and default, if no filter's setting has this job, and of {', '.join(known)}")
    same = {}
    if row:
        most = len(row.values) - 1 if row.values else row.most
        same = {"type": row.type, "default": row.default, "least": row.least, "most": most}
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


def keywords(settings):
    """Rows of a Keyword each: of a choice its words, of a number its least and most."""
    lines = []
    for one in settings:
        if one.keyword:
            default = one.default if one.keyword_default is None else one.keyword_default
            if one.names:
                said = f"{one.names[default]!r}, words={tuple(one.names)!r}"
            elif one.ends == (0, 1) and one.type != "double":
                said = repr(bool(default))
            else:
                said = f"{default!r}, least={one.ends[0]!r}, most={repr(one.ends[1]).replace('inf', 'math.inf')}"
            head, said = f'    "{one.keyword}": Keyword("{one.name}",', said.replace("'", '"') + "),"
            lines += [f"{head} {said}"] if len(head + said) < tables.COLUMNS else [head, "        " + said]
    return lines
