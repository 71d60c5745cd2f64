# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's properties and groups, as XML, of the rows of a table."""

import dataclasses
import re
from xml.sax.saxutils import escape, quoteattr

import rows as tables

TAGS = {"double": "Double", "text": "String"}
# What never holds. So texts of measures cannot be edited, and the panel does not have the measures, which would be no
# attributes in Python with a panel_visibility of never.
NEVER = {"delaunay": "NumberOfThreads = -1", "interpolation": "Method = 99", "quality": "MinimumAngle = 99"}
CONDITION = re.compile(r"\s*(\w+) (=|!=|in|is) ((?:[\w-]+ ?)+?)(?=\s+(?:or|and)\b|\s*\)|\s*$)")


class Lines:
    """XML, an element a line, its attributes below each other, as ParaView's own files have it."""

    def __init__(self, depth):
        self.depth, self.lines = depth, []

    def open(self, tag, attributes=(), ends=""):
        head = "  " * self.depth + "<" + tag + (" " if attributes else "")
        said = ("\n" + " " * len(head)).join(f"{name}={quoteattr(str(value))}" for name, value in attributes)
        self.lines.append(head + said + ends + ">")
        self.depth += 0 if ends else 1

    def close(self, tag):
        self.depth -= 1
        self.lines.append("  " * self.depth + f"</{tag}>")

    def empty(self, tag, attributes=()):
        self.open(tag, attributes, "/")

    def text(self, tag, text):
        indent = "  " * self.depth
        lines = tables.wrapped(f"<{tag}>{escape(text)}</{tag}>", indent + "  ")
        self.lines += [lines[0][2:]] + lines[1:]


def properties(rows, kind, of="surface", depth=3):
    """The settings that a filter has, in the panel or for scripts. `of` "ports": those that the filter with all output
    ports has beside those of the surface."""
    xml = Lines(depth)
    for row in tables.settings(rows):
        panel = row.panels.get(of, "none")
        if of == "ports":
            panel = "none" if "surface" in row.panels else "advanced"
        if panel == "none":
            continue
        here = dataclasses.replace(row, panel_default=True) if row.on_in == of else row
        _property(xml, here, panel, _conditions(row, rows, of))
        if row.old_name and of == "surface":
            _old_property(xml, row)
    return xml.lines


def _conditions(row, rows, of):
    """(mode, condition) of a row, without those on settings that the filter does not have."""
    known = [one.name for one in rows if of == "ports" or of in one.panels] + tables.INPUTS
    given = [("visibility", text) for text in row.visible] + [("enabled_state", text) for text in row.enabled]
    left = [(mode, _on_known(Condition(text).parse(), known)) for mode, text in given]
    return [one for one in left if one[1]]


def _on_known(condition, known):
    """What is left of a parsed condition; None: nothing."""
    if isinstance(condition, tuple):
        return condition if condition[0] in known else None
    word, *parts = condition
    parts = [part for part in (_on_known(part, known) for part in parts) if part]
    return [word] + parts if len(parts) > 1 else parts[0] if parts else None


def measures(rows, kind, depth=3):
    """The measures: in the panel as texts, in scripts each by itself, too."""
    xml = Lines(depth)
    never = Condition(NEVER[kind]).parse()
    for text, found in tables.texts(rows):
        _text_of_measures(xml, text, never)
        for row in found:
            _property(xml, row, "advanced", [("visibility", never)])
    return xml.lines


def _property(xml, row, panel, conditions):
    tag = TAGS.get(row.type, "Int") + "VectorProperty"
    attributes = [("name", row.name), ("label", row.label), ("command", ("Get" if row.measure else "Set") + row.name),
                  ("number_of_elements", row.elements), ("default_values", _default_of(row))]
    attributes += [("animateable", 1)] if row.animateable else []
    attributes += [("information_only", 1)] if row.measure else []
    xml.open(tag, attributes + [("panel_visibility", panel)])
    if row.measure:
        xml.empty(f"Simple{tag[:-len('VectorProperty')]}InformationHelper")
    _domain(xml, row)
    xml.text("Documentation", f"{row.help} {tables.said_default(row, by_constants=False)}")
    _hints(xml, conditions)
    xml.close(tag)
    xml.lines.append("")


def _text_of_measures(xml, row, never):
    """A text that cannot be edited."""
    xml.open("StringVectorProperty", [
        ("name", row.name), ("label", row.label), ("command", "Get" + row.name), ("number_of_elements", 1),
        ("default_values", ""), ("information_only", 1), ("panel_visibility", row.panel)])
    xml.empty("SimpleStringInformationHelper")
    xml.text("Documentation", row.help)
    _hints(xml, [("enabled_state", never)], [("Widget", [("type", "multi_line")])])
    xml.close("StringVectorProperty")
    xml.lines.append("")


def _old_property(xml, row):
    xml.lines.append("  " * xml.depth + "<!-- No command: FilterObservers.cxx keeps it equal to the one above. -->")
    xml.open("IntVectorProperty", [
        ("name", row.old_name), ("label", tables.spaced(row.old_name)), ("number_of_elements", 1),
        ("default_values", _default_of(row)), ("panel_visibility", "never")])
    xml.empty("BooleanDomain", [("name", "bool")])
    xml.text("Documentation", f"The old name of {row.label}, for states and scripts that have it.")
    xml.close("IntVectorProperty")
    xml.lines.append("")


def _default_of(row):
    return row.shown_default if row.type == "text" else " ".join(tables.numbers(row.shown_default))


def _domain(xml, row):
    least = row.least if row.panel_least is None else row.panel_least
    if row.measure:
        return
    if row.is_switch:
        xml.empty("BooleanDomain", [("name", "bool")])
    elif row.values:
        xml.open("EnumerationDomain", [("name", "enum")])
        for number, value in enumerate(row.values):
            xml.lines.append("  " * xml.depth + f'<Entry value="{number}" text={quoteattr(value.label)}/>')
        xml.close("EnumerationDomain")
    elif row.panel_range == "point arrays":
        xml.open("ArrayListDomain", [("name", "array_list"), ("none_string", "None"), ("default_values", "None"),
                                     ("input_domain_name", "point_arrays")])
        xml.open("RequiredProperties")
        xml.empty("Property", [("name", "Input"), ("function", "Input")])
        xml.close("RequiredProperties")
        xml.close("ArrayListDomain")
    elif row.panel_range == "points":
        xml.open("NumberOfPointsRangeDomain", [("name", "range")])
        xml.open("RequiredProperties")
        xml.empty("Property", [("name", "Input"), ("function", "Input")])
        xml.close("RequiredProperties")
        xml.close("NumberOfPointsRangeDomain")
    elif least is not None or row.most is not None or row.panel_range == "any":
        _range(xml, row, least)


def _range(xml, row, least):
    """A maximum makes a slider, which is right for a short range alone."""
    ends = [("min", least), ("max", None if row.panel_range == "without a most" else row.most)]
    given = [(end, " ".join(tables.numbers(value) * row.elements)) for end, value in ends if value is not None]
    xml.empty(TAGS.get(row.type, "Int") + "RangeDomain", [("name", "range")] + given)


def _hints(xml, conditions, others=()):
    if not conditions:
        return
    xml.open("Hints")
    for tag, attributes in others:
        xml.empty(tag, attributes)
    for mode, expression in conditions:
        if isinstance(expression, list):
            xml.open("PropertyWidgetDecorator", [("type", "CompositeDecorator")])
            _expression(xml, mode, expression)
            xml.close("PropertyWidgetDecorator")
        else:
            _decorator(xml, mode, expression)
    xml.close("Hints")


def _expression(xml, mode, expression):
    word, *parts = expression
    xml.open("Expression", [("type", word)])
    for part in parts:
        (_expression if isinstance(part, list) else _decorator)(xml, mode, part)
    xml.close("Expression")


def _decorator(xml, mode, condition):
    name, operator, value = condition
    if operator == "is":  # of the input
        attributes = [("type", "InputDataTypeDecorator"), ("mode", mode), ("name", value)]
    else:
        attributes = [("type", "GenericDecorator"), ("mode", mode), ("property", name),
                      ("values" if operator == "in" else "value", value)]
        attributes += [("inverse", 1)] if operator == "!=" else []
    xml.empty("PropertyWidgetDecorator", attributes)


class Condition:
    """When a property is shown or enabled: "Alpha != 0", "A in 0 1 or (B = 2 and C = 1)"."""

    def __init__(self, text):
        self.text, self.at = text, 0

    def parse(self):
        """(property, operator, value), or [and | or, condition, condition, ...]."""
        parts, word = [self._one()], None
        while found := re.compile(r"\s*(or|and)\s+").match(self.text, self.at):
            if word not in (None, found[1]):
                raise ValueError(f"{self.text}: and, or with parentheses")
            word, self.at = found[1], found.end()
            parts.append(self._one())
        return [word] + parts if word else parts[0]

    def _one(self):
        opened = re.compile(r"\s*\(").match(self.text, self.at)
        if opened:
            self.at = opened.end()
            inside = self.parse()
            self.at = re.compile(r"\s*\)").match(self.text, self.at).end()
            return inside
        found = CONDITION.match(self.text, self.at)
        if not found:
            raise ValueError(f"{self.text}: no condition at {self.text[self.at:]!r}")
        self.at = found.end()
        return found[1], found[2], found[3].strip()


def _is_in(row, of):
    return row.type == "exposed" or row.panels.get(of, "advanced" if of == "ports" else "none") != "none"


def groups(rows, _kind, of="surface", depth=3):
    """The property groups of a filter, in the order in which they come in the table."""
    xml = Lines(depth)
    rows = [row for row in rows if row.group and _is_in(row, of) and not (row.measure or row.type == "measures")]
    for label in dict.fromkeys(row.group for row in rows):
        xml.open("PropertyGroup", [("label", label)])
        for row in rows:
            if row.group == label:
                _named(xml, row.name)
                if row.old_name and of == "surface":
                    _named(xml, row.old_name)
        xml.close("PropertyGroup")
        xml.lines.append("")
    return xml.lines


def exposed(rows, depth=5):
    """The names of the settings of the filter within that the panel shows."""
    xml = Lines(depth)
    for row in rows:
        if row.type == "exposed":
            panel = row.panels.get("interpolation")
            _named(xml, row.name, [("panel_visibility", panel)] if panel else [])
    return xml.lines


def _named(xml, name, more=()):
    xml.empty("Property", [("name", name), *more])
