# SPDX-License-Identifier: BSD-3-Clause
"""Pages of ParaView's help as Markdown for readers of the repository: index.html is Help.md, recipes.html Recipes.md.

    python3 help_page.py     writes both anew, after one of the pages was changed
"""

import html.parser
import os
import re
import textwrap

DOCUMENTATION = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
MADE = "<!-- Made by Scripts/help_page.py from %s: change that, not this. -->\n\n"
SOURCES = {"index.html": "Help.md", "recipes.html": "Recipes.md"}
PAGES = dict(SOURCES, **{"gallery.html": "Gallery.md"})  # others are made with the help, of the plugin's XML
MARKS = {"b": "**", "i": "*", "code": "`"}
BLOCKS = ("h1", "h2", "p", "pre", "li")


class Converter(html.parser.HTMLParser):
    """Understands the tags that these pages have, and no others."""

    def __init__(self):
        super().__init__()
        self.blocks, self.text, self.row = [], None, None
        self.lists, self.link, self.is_code = [], None, False

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        if tag in BLOCKS or tag in ("td", "th"):
            self.text = ""
        elif tag == "table":
            self.blocks.append([])
        elif tag == "tr":
            self.row = []
        elif tag in ("ul", "ol"):
            self.lists.append(0 if tag == "ol" else None)
        elif tag == "a":
            self.link = PAGES.get(given["href"])
            self.text += "[" if self.link else ""
        elif tag == "img":
            self.text += "![%s](%s)" % (" ".join(given["alt"].split()), given["src"])
        elif tag in MARKS:
            self.is_code = self.is_code or tag == "code"
            self.text += MARKS[tag]
        elif tag not in ("html", "head", "meta", "title", "body"):
            raise ValueError("help_page.py does not know <%s>" % tag)

    def handle_data(self, data):
        if self.text is not None:
            self.text += data if self.is_code or self.lasttag == "pre" else re.sub(r"([*_<|])", r"\\\1", data)

    def handle_endtag(self, tag):
        if tag in MARKS:
            self.is_code = self.is_code and tag != "code"
            self.text += MARKS[tag]
        elif tag == "a":
            self.text += "](%s)" % self.link if self.link else ""
        elif tag in ("td", "th"):
            self.row.append(" ".join(self.text.split()))
        elif tag == "tr":
            self.end_row()
        elif tag in ("ul", "ol"):
            self.lists.pop()
        elif tag in BLOCKS:
            self.end_block(tag)

    def end_row(self):
        table = self.blocks[-1]
        table.append("| %s |" % " | ".join(self.row))
        if len(table) == 1:
            table.append("|" + "---|" * len(self.row))

    def end_block(self, tag):
        words = " ".join(self.text.split())
        if tag == "pre":
            self.blocks.append(textwrap.indent(self.text.strip("\n"), "    ").split("\n"))
        elif tag == "li":
            self.end_item(words)
        elif tag == "p":
            self.blocks.append(wrapped(words))
        else:
            self.blocks.append(["#" * int(tag[1]) + " " + words])
        self.text = None

    def end_item(self, words):
        number = self.lists[-1]
        mark = "- " if number is None else "%d. " % (number + 1)
        lines = wrapped(words, mark, " " * len(mark))
        if number is not None:
            self.lists[-1] += 1
        is_first = not (self.blocks and self.blocks[-1][0].startswith(("- ", "1. "))) or number == 0
        self.blocks.append(lines) if is_first else self.blocks[-1].extend(lines)


def wrapped(words, first="", others=""):
    return textwrap.wrap(
        words, 140, initial_indent=first, subsequent_indent=others, break_long_words=False, break_on_hyphens=False)


def markdown(page="index.html"):
    """The text that the Markdown of this page has to have."""
    with open(os.path.join(DOCUMENTATION, page), encoding="utf-8") as file:
        text = file.read()
    converter = Converter()
    converter.feed(text)
    return MADE % page + "\n\n".join("\n".join(lines) for lines in converter.blocks) + "\n"


if __name__ == "__main__":
    for source, made in SOURCES.items():
        with open(os.path.join(DOCUMENTATION, made), "w", encoding="utf-8") as output:
            output.write(markdown(source))
