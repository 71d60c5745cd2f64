# SPDX-License-Identifier: BSD-3-Clause
"""Help.md and Recipes.md have the text of ParaView's help, and their anchors exist."""

import html
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
DOCUMENTATION = os.path.join(ROOT, "Plugin", "Documentation")
sys.path.insert(0, os.path.join(DOCUMENTATION, "Scripts"))

import help_page
from pluginsupport import check


def read(*names):
    with open(os.path.join(ROOT, *names), encoding="utf-8") as file:
        return file.read()


def words(text):
    return re.findall(r"[A-Za-z0-9]+", text)


for source, made in help_page.SOURCES.items():
    published = read("Plugin", "Documentation", made)
    is_new = published == help_page.markdown(source)
    check(is_new, made + " is out of date: run Plugin/Documentation/Scripts/help_page.py")
    # Whatever the converter does, no word is lost.
    page = read("Plugin", "Documentation", source).split("<body>")[1]
    seen = html.unescape(re.sub(r"<[^>]*>", "", re.sub("</t[dh]>", " ", page)))
    told = re.sub(r"^\d+\. |!\[[^]]*\]\([^)]*\)|\]\([^)]*\)", "", published.split("-->")[1], flags=re.MULTILINE)
    lost = [pair for pair in zip(words(told) + ["the end"], words(seen) + ["the end"]) if pair[0] != pair[1]]
    check(not lost, "%s and %s say %r" % (made, source, lost[:1]))

first_page = read("README.md")
check("(Plugin/Documentation/Help.md#coming-from-delaunay-2d)" in first_page, "no way to Coming from Delaunay 2D")
check("Plugin/Documentation/index.html" not in first_page, "README.md links to HTML, shown as source")
print("passed: help page")
