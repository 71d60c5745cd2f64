# SPDX-License-Identifier: BSD-3-Clause
"""Help.md and Recipes.md say what ParaView's help says, and the places in them that others lead to are there."""

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
    for target in re.findall(r"\]\(([^)#]+)\)", published):
        there = os.path.exists(os.path.join(DOCUMENTATION, target))
        check(there, "%s leads to %s, which is not there" % (made, target))

published = read("Plugin", "Documentation", "Help.md")
anchors = {re.sub(r"[^a-z0-9 -]", "", line.lower()).strip().replace(" ", "-")
           for line in published.split("\n") if line.startswith("## ")}  # fmt: skip
links = re.findall(r"\(Plugin/Documentation/Help\.md#([^)]*)\)", read("README.md"))
check("coming-from-delaunay-2d" in links, "README.md does not lead to Coming from Delaunay 2D")
for link in links:
    check(link in anchors, "Help.md has no section %s" % link)
check("Plugin/Documentation/index.html" not in read("README.md"), "README.md links to HTML, shown as source")

first_page = read("README.md")
check(len(first_page.split()) < 800, "README.md is too long for a first page: tables and details go to the docs")
for target in re.findall(r"\]\(([^)#]+)", first_page):
    check(os.path.exists(os.path.join(ROOT, target)), "README.md leads to %s, which is not there" % target)
print("passed: help page")
