# SPDX-License-Identifier: BSD-3-Clause
"""The string literals of the sources: compared with tables of messages, so that none is left out."""

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PYTHON = ROOT / "Filters" / "Python"
FORMAT = re.compile(r"%(?:\.\d+)?[a-zA-Z]|%%")
CXX_COMMENT = re.compile(r"//[^\n]*")
CXX_JOINT = re.compile(r'"\s*"')  # of literals one after the other
CXX_LITERAL = re.compile(r'"((?:\\.|[^"\\\n])*)"')


def pieces_of(tree):
    """(line, text) of all literals below a node but docstrings and operands of comparisons, without the values of %."""
    others = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare):
            others |= {id(each) for each in node.comparators}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in others:
            for piece in FORMAT.split(node.value):
                if len(piece) > 1:
                    yield node.lineno, piece


def pieces_of_refusals(name):
    """(line, text) of the literals in exceptions of a module of the package."""
    for node in ast.walk(ast.parse((PYTHON / name).read_text(encoding="utf-8"))):
        if isinstance(node, ast.Raise):
            yield from pieces_of(node)


def said_in_cxx():
    """All literals of the sources in C++, one after the other."""
    paths = sorted(path for path in (ROOT / "Filters").rglob("*") if path.suffix in (".cxx", ".h"))
    texts = (CXX_JOINT.sub("", CXX_COMMENT.sub("", path.read_text(encoding="utf-8"))) for path in paths)
    found = (match for text in texts for match in CXX_LITERAL.findall(text))
    return "\0".join(match.replace('\\"', '"').replace("\\n", "\n") for match in found)
