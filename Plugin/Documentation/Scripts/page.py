# SPDX-License-Identifier: BSD-3-Clause
"""The page of the gallery, from gallery.in.md: as Markdown for readers of the repository and as HTML for
ParaView's help.

gallery.in.md is Markdown. {figure[number]} is a number that the figure told. Lines from "%needs figure" to its
"%end" are left out as long as that figure has not been drawn.
"""

import html
import os
import re

from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))
TITLE = "How it works, in pictures"
MADE = "<!-- Made by make_figures.sh from Scripts/gallery.in.md: change that, not this. -->\n\n"


def write(folder, numbers):
    for name, text in pages(folder, numbers).items():
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        print(path)


def pages(folder, numbers):
    """{file name: text}. Requires: all figures but those that may be left out have been drawn in the folder."""
    with open(os.path.join(HERE, "gallery.in.md"), encoding="utf-8") as file:
        lines = chosen(file.read().split("\n"), numbers)
    text = "\n".join(lines).format(**numbers)
    markdown = re.sub(r"!\[(.*?)\]\((.*?)\)", lambda found: picture(folder, *found.groups()), text)
    return {"Gallery.md": MADE + markdown, "gallery.html": page(folder, text)}


def chosen(lines, numbers):
    """The lines without what needs a figure that is not there."""
    kept, needs = [], []
    for line in lines:
        if line.startswith("%needs "):
            needs.append(line.split()[1] in numbers)
        elif line == "%end":
            needs.pop()
        elif all(needs):
            kept.append(line)
    assert not needs, "%needs without %end"
    return kept


def picture(folder, words, path):
    """Shown at half its size: sharp on fine screens, too."""
    with Image.open(os.path.join(folder, path)) as image:
        width = image.width // 2
    return '<img src="%s" width="%d" alt="%s">' % (path, width, html.escape(words))


# --- the little Markdown that gallery.in.md uses ---------------------------------------------------


def page(folder, text):
    body = "\n".join(block(folder, part) for part in re.split(r"\n\n+", text.strip()))
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>%s</title>\n</head>\n<body>\n%s\n'
        '<p><a href="index.html">Adaptive Hilbert Delaunay: from points to a surface</a></p>\n</body>\n</html>\n'
    ) % (TITLE, body)


def block(folder, text):
    """A heading, a picture, a table, indented code or a paragraph."""
    if text.startswith("#"):
        marks, words = text.split(" ", 1)
        return "<h%d>%s</h%d>" % (len(marks), inline(words), len(marks))
    shown = re.fullmatch(r"!\[(.*?)\]\((.*?)\)", text)
    if shown:
        return "<p>%s</p>" % picture(folder, *shown.groups())
    if text.startswith("|"):
        return table(text.split("\n"))
    if text.startswith("    "):
        return "<pre>\n%s\n</pre>" % html.escape(re.sub("^    ", "", text, flags=re.MULTILINE))
    return "<p>%s</p>" % inline(text)


def table(lines):
    rows = [[inline(cell.strip()) for cell in line.strip("|").split("|")] for line in lines]
    rows.pop(1)  # the rule below the head
    tags = ["th"] + ["td"] * (len(rows) - 1)
    body = [
        "<tr>%s</tr>" % "".join("<%s>%s</%s>" % (tag, cell, tag) for cell in row)
        for tag, row in zip(tags, rows)
    ]
    return '<table border="1" cellpadding="4" cellspacing="0">\n%s\n</table>' % "\n".join(body)


def inline(text):
    text = html.escape(text, quote=False)
    for mark, tag in ((r"\*\*", "b"), (r"\*", "i"), ("`", "code")):
        text = re.sub(mark + r"(.+?)" + mark, r"<%s>\1</%s>" % (tag, tag), text, flags=re.DOTALL)
    return text
