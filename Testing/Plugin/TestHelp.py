# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's help is built, documents every property, and has no dead links.

    TestHelp.py FOLDER    the folder in which the help was built
"""

import glob
import html.parser
import os
import re
import sqlite3
import sys

from pluginsupport import MEASURES, RASTER_MEASURES, RASTER_SETTINGS, check, check_equal, names_of

FOLDER = sys.argv[1]
OURS = {"index.html", "gallery.html", "recipes.html"}  # ParaView's generated pages leave some tags open
VOID = {"br", "hr", "img", "link", "meta", "input"}


class Page(html.parser.HTMLParser):
    """Collects a page's text and links, and notices tags that are not closed in order."""

    def __init__(self, path):
        super().__init__()
        self.name, self.text, self.links, self.open = os.path.basename(path), "", [], []
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)
        self.links += [value for name, value in attributes if name in ("href", "src")]

    def handle_endtag(self, tag):
        if self.name in OURS:
            check_equal(self.open.pop() if self.open else None, tag, "tag closed in line %d" % self.getpos()[0])

    def handle_data(self, data):
        self.text += data


pages = {os.path.basename(path): Page(path) for path in glob.glob(os.path.join(FOLDER, "*.html"))}
check_equal(
    set(pages),
    OURS
    | {
        "filters.AdaptiveHilbertDelaunay2D.html",
        "filters.AdaptiveHilbertInterpolation2D.html",
        "filters.AdaptiveHilbertQualityMesh2D.html",
        "filters.Delaunay2DAdaptiveHilbert.html",
        "filters.InsertionOrderAdaptiveHilbert.html",
        "filters.PlanarSurfaceOutline.html",
        "filters.VoronoiAdaptiveHilbert.html",
        "Readers.html",
        "Writers.html",
        "writers.PlanarGeoTIFFWriter.html",
        "internal.AdaptiveHilbertTriangulation.html",
        "sources.PlanarPointSource.html",
        "transforms.AdaptiveHilbertTransform.html",
    },
    "pages of the help",
)

# ParaView makes pages that nobody looks for, too: the contents are without these.
with open(os.path.join(FOLDER, "AdaptiveHilbertDelaunay.qhp"), encoding="utf-8") as file:
    listed = re.findall(r'<section title="(.*?)" ref="(.*?)"', file.read())
internal = {"filters.AdaptiveHilbertDelaunay2D.html", "Readers.html", "Writers.html"} | {
    name for name in pages if name.startswith(("internal.", "transforms."))}
check_equal({page for _title, page in listed}, set(pages) - internal, "pages in the contents of the help")
check_equal(len(listed), len(pages) - len(internal), "entries in the contents of the help")
check(all(title in " ".join(pages[page].text.split()) for title, page in listed), "a title is not that of its page")

DESCRIBED = {
    "Delaunay2DAdaptiveHilbert": names_of("delaunay", "settings", lambda row: row["panel"]) + MEASURES
    + ["Source", "Transform"],
    "VoronoiAdaptiveHilbert": ["VoronoiClip", "Transform"],
    "InsertionOrderAdaptiveHilbert": ["InsertionOrder", "GenerateBoxes", "Transform"],
    "AdaptiveHilbertInterpolation2D": RASTER_SETTINGS + RASTER_MEASURES + ["Places", "Source"],
    "AdaptiveHilbertQualityMesh2D": names_of("quality", "settings", lambda row: True) + ["Source"],
}
for filter_name, described in DESCRIBED.items():
    reference = " ".join(pages["filters.%s.html" % filter_name].text.split())
    for name in described:
        spaced = "".join(" " + c if c.isupper() and i and name[i - 1].islower() else c for i, c in enumerate(name))
        check(spaced in reference, "the page of %s does not describe %s" % (filter_name, spaced))
    check("**" not in reference, "markup was left in the page of " + filter_name)

# A .qch is an SQLite database.
with sqlite3.connect("file:%s?mode=ro" % os.path.join(FOLDER, "AdaptiveHilbertDelaunay.qch"), uri=True) as database:
    inside = {row[0] for row in database.execute("SELECT Name FROM FileNameTable")}
check(set(pages) <= inside, "the help file holds %r" % inside)
for page in pages.values():
    for link in page.links:
        check(link in inside, "%s needs %s, which is not there" % (page.name, link))
print("passed: help")
