#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the Python plugin of the description of the compiled one, so that there is no second one.

    make_plugin.py FILE      writes the plugin, and beside it the icons

plugin_template.py has the code, with plugin_client.py in it. What it does not say, ParaView's menus, panels and help
texts, is taken from AdaptiveHilbertDelaunay.xml, and the version from CMakeLists.txt. Two things in the XML need C++:
the NumberOfPointsRangeDomain becomes a range that takes its ends from a hidden property, which the template sets; a
proxy inside another becomes properties of the other.
"""

import copy
import pathlib
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
XML = HERE.parent / "AdaptiveHilbertDelaunay.xml"
TEMPLATE = HERE / "plugin_template.py"
CLIENT = HERE / "plugin_client.py"
ICONS = HERE.parent / "Icons"
CMAKE = HERE.parents[1] / "CMakeLists.txt"


def to_points(proxy, item, domain):
    """Has the property's range end at what the hidden property says, which is added to the proxy."""
    hidden = item.get("name") + "Range"
    domain.tag = "IntRangeDomain"
    for child in list(domain):
        domain.remove(child)
    required = ElementTree.SubElement(domain, "RequiredProperties")
    ElementTree.SubElement(required, "Property", {"name": hidden, "function": "Range"})
    added = ElementTree.Element(
        "IntVectorProperty",
        {
            "name": hidden,
            "label": item.get("label") + " Range",
            "number_of_elements": "2",
            "default_values": "0 1",  # not what it is without points: ParaView reads the range when it changes
            "is_internal": "1",
            "panel_visibility": "never",
        },
    )
    documentation = ElementTree.SubElement(added, "Documentation")
    documentation.text = "The ends of the range of %s, set by this plugin." % item.get("label")
    proxy.insert(list(proxy).index(item), added)


def without_cxx(proxy):
    """Replaces what needs C++ code of the compiled plugin. Returns the names of the properties with such ranges."""
    found = []
    for item in list(proxy):
        domain = item.find("NumberOfPointsRangeDomain")
        if domain is not None:
            to_points(proxy, item, domain)
            found.append(item.get("name"))
    return found


def with_exposed_properties(proxy, others):
    """Replaces the proxy inside, which takes a C++ class, by the properties of it that are exposed: they become the
    filter's own. `others`: by name, proxies whose properties others inherit."""
    for part in proxy.findall("SubProxy"):
        inherits = others[part.find("Proxy").get("proxyname")].get("base_proxyname")
        known = {item.get("name"): item for item in others[inherits] if item.get("label")}
        place = list(proxy).index(part)
        proxy.remove(part)
        for item in reversed(part.find("ExposedProperties")):
            exposed = copy.deepcopy(known[item.get("name")])
            exposed.set("panel_visibility", item.get("panel_visibility", exposed.get("panel_visibility")))
            proxy.insert(place, exposed)


def inherited(proxy, others):
    """What a proxy takes from the one that it is based on: all but what it has itself."""
    own = {_key(item) for item in proxy}
    return [copy.deepcopy(item) for item in others[proxy.get("base_proxyname")] if _key(item) not in own]


def _key(item):
    return item.get("name") or item.get("label") or item.tag


def proxies():
    """(group, tag, attributes, inside) of each proxy, and the names of the properties that go up to the number of
    points."""
    found, up_to_points = [], []
    root = ElementTree.parse(XML).getroot()
    by_name = {proxy.get("name"): proxy for group in root for proxy in group}
    for group in root:
        for proxy in group:
            if group.get("name") == "internal":
                continue  # is there to be inside another
            if proxy.get("base_proxyname"):
                proxy[:] = inherited(proxy, by_name) + list(proxy)
            with_exposed_properties(proxy, by_name)
            up_to_points += [name for name in without_cxx(proxy) if name not in up_to_points]
            inside = "".join(ElementTree.tostring(child, encoding="unicode") for child in proxy)
            inside = re.sub(r"\n\s*\n", "\n\n", inside.strip())
            attributes = {name: value for name, value in proxy.items() if not name.startswith("base_")}
            found.append((group.get("name"), proxy.tag, attributes, inside))
    return found, up_to_points


def literal(inside):
    """The text as a raw string of Python, its lines as they are."""
    if '"""' in inside or "\\" in inside:
        raise ValueError("the XML has what a raw string cannot hold")
    return 'r"""\n%s\n"""' % inside


def version():
    return re.search(r"project\(\w+ VERSION ([\d.]+)", CMAKE.read_text(encoding="utf-8")).group(1)


def code():
    """The template, with the other file in the place of its import."""
    client = CLIENT.read_text(encoding="utf-8").split('"""', 2)[2].strip()
    template = TEMPLATE.read_text(encoding="utf-8")
    imported = r"# Replaced by that file[^\n]*\nfrom plugin_client import \([^)]*\)\n"
    text, count = re.subn(imported, lambda _match: client + "\n", template)
    if count != 1:
        raise ValueError("the template does not import plugin_client")
    return text


def plugin():
    """The text of the plugin."""
    found, up_to_points = proxies()
    listed = "".join(
        "    (\n        %r,\n        %r,\n        %r,\n        %s,\n    ),\n" % (*named, literal(inside))
        for *named, inside in found
    )
    values = {"VERSION": '"%s"' % version(), "PROXIES": "[\n%s]" % listed, "UP_TO_POINTS": repr(up_to_points)}
    text = code()
    for name, value in values.items():
        text, count = re.subn(r"(?m)^%s = .*$" % name, lambda _match: "%s = %s" % (name, value), text)
        if count != 1:
            raise ValueError("the template has no %s" % name)
    return text


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    made = pathlib.Path(sys.argv[1])
    made.parent.mkdir(parents=True, exist_ok=True)
    made.write_text(plugin(), encoding="utf-8")
    shutil.copytree(ICONS, made.parent / "icons", ignore=shutil.ignore_patterns("*.qrc"), dirs_exist_ok=True)
