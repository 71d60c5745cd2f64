# SPDX-License-Identifier: BSD-3-Clause
"""The gallery of the documentation: figures show their subject, and the page is generated from its source.

    pvbatch TestGallery.py     (draws some of the figures, small)
"""

import json
import os
import re
import shutil
import sys

import numpy
from PIL import Image

from pluginsupport import PLUGIN, check, check_equal, run, scratch

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
DOCUMENTATION = os.path.join(ROOT, "Plugin", "Documentation")
COMMAND = os.path.join(DOCUMENTATION, "make_figures.sh")
sys.path.insert(0, os.path.join(DOCUMENTATION, "Scripts"))

import make_figures
import page
import palette

BLUE, VERMILLION, LIGHT_GREEN = (
    palette.rgb(c) for c in (palette.BLUE, palette.VERMILLION, palette.LIGHT_GREEN)
)


def share(picture, colour):
    """The share of the picture with nearly this colour."""
    off = numpy.abs(numpy.asarray(picture.convert("RGB"), float) - 255.0 * numpy.array(colour))
    return float((off < 24).all(axis=2).mean())


def draw(name, numbers):
    """The picture of a figure, drawn small; its numbers are added."""
    path = scratch(os.path.join("Figures", name + ".png"))
    numbers[name] = FIGURES[name](path)
    with Image.open(path) as picture:
        check(picture.width > 300 and picture.height > 150, "%s is %r" % (name, picture.size))
        check_equal(picture.convert("RGB").getpixel((0, 0)), (255, 255, 255), "the corner of " + name)
        return picture.copy()


def check_pictures(numbers):
    """Each colour of a figure's subject occurs, and not too much."""
    picture = draw("one-point", numbers)
    check(0.002 < share(picture, LIGHT_GREEN) < 0.2, "the star is not green in one-point")
    check(share(picture, VERMILLION) > 0.0005, "the new point is not to be seen in one-point")
    told = numbers["one-point"]
    check(told["removed"] > 0 and told["made"] == told["removed"] + 2, "a cavity of %r" % told)

    picture = draw("jump", numbers)
    check(0.002 < share(picture, BLUE) < 0.2, "no curve in jump")
    left, right = (picture.crop((k * picture.width // 2, 60, (k + 1) * picture.width // 2, picture.height - 70))
                   for k in (0, 1))  # fmt: skip
    check(share(left, VERMILLION) > 0.0005, "the jumps without genes are not to be seen")
    check_equal(share(right, VERMILLION), 0.0, "jumps drawn with genes")
    check(numbers["jump"]["jumps_off"] > 0, "there should be jumps without genes")
    check_equal(numbers["jump"]["jumps_on"], 0, "jumps with genes")

    picture = draw("multi-grid", numbers)
    check(share(picture, VERMILLION) > 0.0005, "the ways back are not to be seen in multi-grid")


def check_as_published(numbers):
    """Numbers that do not depend on the size of pictures are those of the page."""
    published = read_json(os.path.join(DOCUMENTATION, "Figures", "numbers.json"))
    for name in ("one-point", "multi-grid"):
        check_equal(numbers[name], published[name], "numbers of %s: draw the gallery again?" % name)
    for name in ("jumps_off", "jumps_on"):
        check_equal(numbers["jump"][name], published["jump"][name], name + ": draw the gallery again?")


def read_json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def check_page():
    """The page in the repository is generated from its source and its numbers, and its pictures exist."""
    numbers = read_json(os.path.join(DOCUMENTATION, "Figures", "numbers.json"))
    for name, text in page.pages(DOCUMENTATION, numbers).items():
        with open(os.path.join(DOCUMENTATION, name), encoding="utf-8") as file:
            check(file.read() == text, "%s is out of date: run make_figures.sh --plots" % name)
        check_text(name, text, numbers)


def check_text(name, text, numbers):
    check("{" not in text and "%needs" not in text and "%end" not in text, "something was left in " + name)
    shown = set(re.findall(r'src="Figures/(.*?)\.png"', text))
    check_equal(shown, set(numbers) - {"ledger"}, "pictures on " + name)


def check_plots():
    """make_figures.sh draws the times from results in the form that paper.sh writes: here the paper's own, halved."""
    rows = [row for row in read_json(make_figures.PAPER)["tables"] if row["points"] <= 4000000]
    halves = [dict(row, total=row["total"] / 2) for row in rows]
    with open(scratch("Results.json"), "w", encoding="utf-8") as file:
        json.dump({"tables": halves}, file)
    output = scratch("gallery")
    shutil.rmtree(output, ignore_errors=True)
    shutil.copytree(os.path.join(DOCUMENTATION, "Figures"), os.path.join(output, "Figures"))
    code, _ = run([COMMAND, "--plots", "--results", scratch("Results.json"), "--output", output])
    check_equal(code, 0, "exit code of make_figures.sh --plots")
    numbers = read_json(os.path.join(output, "Figures", "numbers.json"))
    check_equal(
        numbers["times-2m"]["here_over_rg"], numbers["times-2m"]["paper_over_rg"], "gains of HG over RG"
    )
    for name in ("times-2m", "times-4m", "growth-by-distribution", "growth-by-system"):
        with Image.open(os.path.join(output, "Figures", name + ".png")) as picture:
            check(share(picture, BLUE) > 0.0005, "nothing of HG in " + name)
    for name in ("Gallery.md", "gallery.html"):
        with open(os.path.join(output, name), encoding="utf-8") as file:
            check_text(name, file.read(), numbers)


def check_refusals():
    for words in (["--only"], ["--nonsense"], ["--plots", "--only", "no-such-figure"]):
        code, said = run([COMMAND] + words)
        check_equal(code, 2, "exit code of make_figures.sh " + " ".join(words))
        check(words[-1].lstrip("-") in said, "the message does not name " + words[-1])


NUMBERS = {}
FIGURES = make_figures.figures_from_the_plugin(PLUGIN, {}, quick=True)
check_pictures(NUMBERS)
check_as_published(NUMBERS)
check_page()
check_plots()
check_refusals()
print("passed: gallery")
