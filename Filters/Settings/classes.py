# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a VTK class that its settings and measures make: enums, accessors, members, and loops over all."""

import rows as tables

COLUMNS = 100
CXX = {"bool": "bool", "flag": "vtkTypeBool", "enum": "int", "int": "int", "id": "vtkIdType",
       "int64": "vtkTypeInt64", "double": "double", "text": "std::string"}
LEAST = {"int": "VTK_INT_MIN", "id": "VTK_ID_MIN", "int64": "VTK_TYPE_INT64_MIN", "double": "VTK_DOUBLE_MIN"}
MOST = {"int": "VTK_INT_MAX", "id": "VTK_ID_MAX", "int64": "VTK_TYPE_INT64_MAX", "double": "VTK_DOUBLE_MAX"}


def enums(rows):
    """One for each setting whose values have names of this class."""
    lines = []
    for row in tables.settings(rows):
        if not row.values or not row.values[0].name:
            continue
        lines += [f"  /// The values of {row.name}.", f"  enum {row.name}Values", "  {"]
        last = len(row.values) - 1
        for number, value in enumerate(row.values):
            comma = "," if number < last else ""
            lines += [f"    /// {value.about}", f"    {value.constant} = {number}{comma}"]
        lines += ["  };", ""]
    return lines


def accessors(rows):
    """Set, Get, On, Off and SetXToY, each setting and measure with its contract."""
    lines = []
    for row in tables.settings(rows) + tables.measures(rows):
        lines.append("  ///@{")
        text = f"{row.help} {tables.said_default(row, by_constants=True)}"
        lines += tables.wrapped(text, "  /// ", COLUMNS) + tables.wrapped(row.details, "  /// ", COLUMNS)
        lines += ["  " + line for line in ([_getter(row)] if row.measure else _setters(row) + [_getter(row)])]
        lines += ["  " + line for line in _shortcuts(row)] + ["  ///@}", ""]
    return lines


def _getter(row):
    if row.type == "text":
        return f"virtual std::string Get{row.name}() {{ return this->{row.name}; }}"
    vector = f"Vector{row.elements}" if row.elements > 1 else ""
    return f"vtkGet{vector}Macro({row.name}, {CXX[row.type]});"


def _setters(row):
    name, kind = row.name, CXX[row.type]
    if row.type == "text":
        return [f"virtual void Set{name}(const std::string& name);"]
    if row.elements > 1:
        return _vector_setters(row)
    if row.values:
        return [f"vtkSetClampMacro({name}, int, {row.values[0].constant}, {row.values[-1].constant});"]
    if row.type == "double":
        return [f"virtual void Set{name}(double value);"] + ([] if not row.is_clamped or not row.ends else [
            f"virtual double Get{name}MinValue() {{ return {_least(row)}; }}",
            f"virtual double Get{name}MaxValue() {{ return {_most(row)}; }}"])
    if not row.is_clamped:
        return [f"vtkSetMacro({name}, {kind});"]
    return [f"vtkSetClampMacro({name}, {kind}, {_least(row)}, {_most(row)});"]


def _vector_setters(row):
    """VTK's macros do not clamp those of several elements."""
    name, kind, count = row.name, CXX[row.type], row.elements
    if row.least is None:
        return [f"vtkSetVector{count}Macro({name}, {kind});"]
    arguments = ", ".join(f"{kind} value{k}" for k in range(count))
    return [f"virtual void Set{name}({arguments});",
            f"void Set{name}(const {kind} values[{count}]) VTK_SIZEHINT({count});"]


def _least(row):
    return LEAST[row.type] if row.least is None else repr(row.least)


def _most(row):
    return MOST[row.type] if row.most is None else repr(row.most)


def _shortcuts(row):
    if row.is_switch and not row.measure:
        return [f"vtkBooleanMacro({row.name}, {CXX[row.type]});"] + _old_accessors(row)
    return [f"void Set{row.name}To{value.name}() {{ this->Set{row.name}({value.constant}); }}"
            for value in row.values if value.name]


def _old_accessors(row):
    if not row.old_name:
        return []
    old, name = row.old_name, row.name
    return [f"// {old} is the old name.", f"void Set{old}(bool on) {{ this->Set{name}(on); }}",
            f"bool Get{old}() {{ return this->Get{name}(); }}", f"void {old}On() {{ this->Set{name}(true); }}",
            f"void {old}Off() {{ this->Set{name}(false); }}"]


def members(rows):
    """With the values that they begin with."""
    lines = ["  // Settings."]
    lines += [f"  {CXX[row.type]} {row.name}{_extent(row)} = {_initial(row)};" for row in tables.settings(rows)]
    lines += ["", "  // Measures of the last execution."]
    lines += [f"  {CXX[row.type]} {row.name} = {_initial(row)};" for row in tables.measures(rows)
              if not row.of_all_runs]
    lines += ["", "  // Measures of all executions."]
    return lines + [f"  {CXX[row.type]} {row.name} = {_initial(row)};" for row in tables.measures(rows)
                    if row.of_all_runs]


def _extent(row):
    return f"[{row.elements}]" if row.elements > 1 else ""


def _initial(row):
    if row.values:
        return row.values[row.default].constant
    if row.elements > 1:
        return "{ " + ", ".join(repr(one) for one in row.default) + " }"
    if row.type == "text":
        return f'"{row.default}"'
    if row.type == "bool":
        return "true" if row.default else "false"
    if row.type == "double" and row.default != row.default:
        return "std::numeric_limits<double>::quiet_NaN()"
    return str(int(row.default)) if row.type == "flag" else repr(row.default)


def printed(rows):
    """The statements of PrintSelf()."""
    lines = []
    for row in tables.settings(rows) + tables.measures(rows):
        value = f'(this->{row.name} ? "On\\n" : "Off\\n")' if row.is_switch else f'{_streamed(row)} << "\\n"'
        line = f'  os << indent << "{row.name}: " << {value};'
        lines += _broken(line)
    return lines


def _broken(line):
    """Before operators, as clang-format does it."""
    lines = []
    while len(line) > COLUMNS:
        at = line.rindex(" << ", 0, COLUMNS + 4)  # what is left has at most so many columns
        lines.append(line[:at])
        line = "    " + line[at:]
    return lines + [line]


def _streamed(row):
    return ' << ", " << '.join(f"this->{row.name}{at}" for at in (
        [f"[{k}]" for k in range(row.elements)] if row.elements > 1 else [""]))


def cleared(rows):
    """The statements of ClearMeasures()."""
    return [f"  this->{row.name} = {_initial(row)};" for row in tables.measures(rows) if not row.of_all_runs]


def taken(rows):
    """The statements of TakeMeasures()."""
    return _measured(rows, "=")


def added(rows):
    """The statements of AddMeasures()."""
    return _measured(rows, "+=")


def _measured(rows, assignment):
    lines = []
    for row in tables.measures(rows):
        if row.job:
            kind = "measure" if row.type == "double" else "count"
            value = " + ".join(f'{kind}("{name}")' for name in row.terms)
            head, end = f"  this->{row.name} {assignment} static_cast<{CXX[row.type]}>(", f"{value});"
            lines += [f"  this->{row.name} {assignment} {value};"] if kind == "measure" else (
                [head + end] if len(head + end) <= COLUMNS else [head, "    " + end])
    return lines


def job_counts(rows):
    """The rows of AddCounts() by what the job counts."""
    return [f'    {{ "{row.name}", {" + ".join(f"""count("{name}")""" for name in row.terms)} }},'
            for row in tables.counts(rows)]


def text_getters(rows):
    """Those of the texts of measures, with their contracts."""
    lines = []
    for text, _measures in tables.texts(rows):
        lines += tables.wrapped(f"{text.help} Empty before a run.", "  /// ", COLUMNS)
        lines += [f"  virtual std::string Get{text.name}();", ""]
    return lines


def texts(rows):
    """The definitions of these."""
    lines = []
    for text, found in tables.texts(rows):
        lines += [f"std::string @CLASS@::Get{text.name}()", "{", "  return vtkAHDMeasuresText({"]
        lines += [f'    {{ "{row.said}", double(this->{row.name}), {tables.numbers(row.default)[0]}, '
                  f"{str(row.type == 'double').lower()} }}," for row in found]
        lines += ["  });", "}", ""]
    return lines


def seconds(rows):
    """The statements of ClearSeconds()."""
    return [f"  this->{row.name} = 0.0;" for row in tables.seconds(rows)]


def counts(rows):
    """The rows of AddCounts()."""
    return [f'    {{ "{row.name}", this->{row.name} }},' for row in tables.counts(rows)]


def compared_numbers(rows):
    """The rows of GetSettingsOfRanks()."""
    lines = []
    for row in _compared(rows):
        value, is_on = _streamed(row).split(' << ", " << '), " != 0" if row.type == "flag" else ""
        lines += [f'    {{ "{row.name}", double({one}{is_on}) }},' for one in value if row.type != "text"]
    return lines


def job_values(rows):
    """The statements of GetJobSettings()."""
    return [f"  settings.set(ahd::{'Double' if row.type == 'double' else 'Int'}Setting::{tables.constant(row.job)}, "
            f"this->{row.name}{' != 0' if row.type == 'flag' else ''});" for row in tables.settings(rows) if row.job]


def compared_texts(rows):
    return [f"    this->{row.name}," for row in _compared(rows) if row.type == "text"]


def _compared(rows):
    return [row for row in tables.settings(rows) if row.ranks in ("same", "one")]


def on_one_rank(rows):
    """Settings with which one rank works for all: is each on?"""
    return [f'    {{ this->{row.name}{"" if row.type == "bool" else " > 0"}, "{row.name}" }},'
            for row in tables.settings(rows) if row.ranks == "one"]


def setters(rows):
    """The setters that are not VTK's macros."""
    lines = []
    for row in tables.settings(rows):
        lines += _text_setter(row) if row.type == "text" else _double_setter(row) if row.type == "double" and (
            row.elements == 1) else _vector_setter(row) if row.elements > 1 and row.least is not None else []
    return lines


def _double_setter(row):
    ends = f", {_least(row)}, {_most(row)}" if row.is_clamped else ""
    return [f"void @CLASS@::Set{row.name}(double value)", "{",
            f"  {'vtkAHDSetClamped' if ends else 'vtkAHDSetAny'}(this, this->{row.name}, value{ends});", "}", ""]


def _text_setter(row):
    return [f"void @CLASS@::Set{row.name}(const std::string& name)", "{",
            f"  vtkAHDSetAny(this, this->{row.name}, name);", "}", ""]


def _vector_setter(row):
    kind, count = CXX[row.type], row.elements
    arguments = ", ".join(f"{kind} value{k}" for k in range(count))
    given = ", ".join(f"std::max<{kind}>({row.least}, value{k})" for k in range(count))
    return [f"void @CLASS@::Set{row.name}({arguments})", "{",
            f"  const std::array<{kind}, {count}> values = {{ {given} }};",
            f"  if (!std::equal(values.begin(), values.end(), this->{row.name}))", "  {",
            f"    std::copy(values.begin(), values.end(), this->{row.name});", "    this->Modified();", "  }", "}", "",
            f"void @CLASS@::Set{row.name}(const {kind} values[{count}])", "{",
            f"  this->Set{row.name}({', '.join(f'values[{k}]' for k in range(count))});", "}", ""]
