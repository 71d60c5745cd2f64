#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the sources as text, one a run:

    lint.py format [--clang-format PROGRAM]   C++ is as clang-format would have it
    lint.py sizes                             files, functions and comments of public headers are short
    lint.py python                            lines of Python are short, pyflakes is content
    lint.py shell                             shellcheck is content
    lint.py made                              files made from the tables of settings are up to date
    lint.py mathematics                       results need no function whose bits are each system's own
    lint.py docs                              links in Markdown lead somewhere, pages are short
    lint.py rounding --build FOLDER           every object of the filter and the engine is compiled without contraction
    lint.py tidy --build FOLDER [--only REGEX] [--jobs N]
                                              clang-tidy is content; FOLDER has compile_commands.json

Exit code 0: nothing to complain of; 1: complaints, one a line; 77: the tool is not installed.
"""

import argparse
import ast
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("Filters", "Plugin", "Testing", "Data", ".ci")
CXX = {".cxx", ".h"}

# The layout of C++ differs between versions of clang-format: this one is used.
CLANG_FORMAT = "14"
# A file has at most so many lines, except generated ones.
FILE_LINES = 500
MADE = "Made by Filters/Settings/generate.py"
MADE_LIST = re.compile(r"\(made of Filters/Settings/.*?\n \*\n", re.DOTALL)  # in a header otherwise written by hand
# At most so much of a public header is comment: longer texts belong in Reference.md.
PUBLIC_HEADERS = "Filters/vtk*.h"
COMMENT_SHARE = 0.5
# Nine functions of ten have fewer lines than the first, none has more than the second.
USUAL_LINES = 40
MOST_LINES = 80
LONG = {
    # The insertion's hot loop: in pieces, its state would not stay in registers.
    ("Filters/Engine/Insert/Kernel.cxx", "carve"),
    # Made, a line for each setting.
    ("Filters/vtkAdaptiveHilbertAlgorithm.cxx", "PrintSelf"),
    # Their docstrings are the reference of all keywords.
    ("Filters/Python/_arrays.py", "delaunay"),
    ("Filters/Python/pyvista.py", "delaunay_2d"),
    ("Filters/Python/pyvista.py", "to_raster"),
}
# A line of Python has at most so many characters.
PYTHON_COLUMNS = 120

# Pages of Markdown have at most so many words, each, or all that a pattern finds together.
PAGE_WORDS = {"README.md": 800, "Filters/Engine/*/README.md": 1500, "Testing/*/README.md": 1500}
MAPS = ("README.md", "CONTRIBUTING.md", "Filters/README.md", "Filters/Engine/README.md", "Testing/README.md")
MAPS_WORDS = 6000

# Functions of <cmath>, math and NumPy that IEEE 754 does not define: each system's library rounds them differently.
OWN_BITS = re.compile(
    r"\b(?:__builtin_)?(hypot|dist|norm|(?:a|arc)?(?:sin|cos|tan)h?|(?:a|arc)tan2|exp(?:2|m1)?|log(?:2|10|1p)?"
    r"|pow|power|cbrt|erfc?|[lt]gamma)[fl]?(?:<\w+>)?\(|(\*\* ?)-?\d*\.\d")
NO_CODE = {".py": re.compile(r"#.*"), "": re.compile(r"//.*|^ *(\*|/\*).*")}
# How each object that computes results is compiled (Filters/Engine/Rounding.cmake), and options that would undo that.
ROUNDING = {"-ffp-contract=off", "/clang:-ffp-contract=off", "/fp:precise", "/fp:strict"}
UNROUNDED = re.compile(
    r"-Ofast|(/clang:)?-f(fp-contract|fp-model|fast-math|associative-math|unsafe-math|reciprocal-math)|[-/]fp:")

# Pyflakes' message about `from x import *`, which ParaView's scripts begin with.
STARRED = re.compile(r"import \* ?' used|may be undefined, or defined from star imports|\.\*' imported but unused")


def files(root, *suffixes):
    """The project's files with these suffixes, in order."""
    found = []
    for folder in FOLDERS:
        for directory, below, names in os.walk(root / folder):
            below[:] = sorted(name for name in below if name != "__pycache__")
            found += [pathlib.Path(directory) / name for name in sorted(names)]
    return [path for path in found if path.suffix in suffixes]


def shell_files(root):
    """Scripts by their suffix, and those without one by their first line."""
    scripts = files(root, ".sh")
    for path in files(root, ""):
        with open(path, "rb") as file:
            if re.match(rb"#!.*\bbash\b", file.readline()):
                scripts.append(path)
    return scripts


def run(command, **more):
    """The output of a command, and its exit code."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)
    return done.stdout, done.returncode


def tool(name):
    """The tool's path; where it is not installed the test is skipped."""
    path = shutil.which(name)
    if path is None:
        print(f"{name} is not installed")
        sys.exit(77)
    return path


# --- format -------------------------------------------------------------------------------------


def clang_format(program):
    """The program's path; the test is skipped if it has another version."""
    path = tool(program)
    version = re.search(r"version (\d+)", run([path, "--version"])[0])
    if version is None or version[1] != CLANG_FORMAT:
        print(f"clang-format {CLANG_FORMAT} is needed, and {path} is another: for example "
              f"pip install 'clang-format=={CLANG_FORMAT}.*' in a venv")
        sys.exit(77)
    return path


def check_format(root, program):
    """Each C++ file that clang-format would change."""
    sources = [path.relative_to(root) for path in files(root, *CXX)]
    output, code = run([clang_format(program), "--dry-run", "-Werror", *sources], cwd=root)
    complaints = re.findall(r"^(.*?:\d+):\d+: error:", output, re.M)
    if code != 0 and not complaints:
        complaints = [output]
    return [f"{place}: clang-format would change this" for place in complaints]


# --- sizes --------------------------------------------------------------------------------------

OPENS = re.compile(r"^( *)\{$")
NOT_A_FUNCTION = re.compile(r"\b(namespace|class|struct|union|enum)\b[^()]*$|^extern\b|=\s*$|^\s*#")


def cxx_functions(lines):
    """(first line, number of lines, name) of the functions with a body, as clang-format lays them out.

    A body begins and ends with a brace on a line of its own, in the same column; what is above it up to
    the end of the statement before is its head. Functions within functions (lambdas) are part of these.
    """
    number = 0
    while number < len(lines):
        brace = OPENS.match(lines[number])
        if not brace:
            number += 1
            continue
        top = number
        while top > 0 and lines[top - 1].strip() and not re.search(r"[;{}]\s*$|^\s*(//|#|\w+:$)", lines[top - 1]):
            top -= 1
        head = " ".join(line.strip() for line in lines[top:number])
        if "(" not in head or NOT_A_FUNCTION.search(head):
            number += 1
            continue
        end = number
        while not re.match(re.escape(brace.group(1)) + r"\}", lines[end]):
            end += 1
        name = re.search(r"(~?\w+|operator.{1,3})\(", head)
        yield top + 1, end - top + 1, name.group(1) if name else head
        number = end + 1


def python_functions(text):
    """(first line, number of lines, name) of the functions."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno - node.lineno + 1, node.name


def long_comments(place, lines):
    """A header of which too much is comment: lines that are nothing else, as clang-format lays them out."""
    comment = sum(1 for line in lines if re.match(r"\s*(//|/\*|\*)", line))
    if comment <= COMMENT_SHARE * len(lines):
        return []
    return [f"{place}: {comment} of {len(lines)} lines are comment, more than half"]


def check_sizes(root):
    """Reports files, functions and comments that are too long."""
    complaints = []
    functions = []
    for path in files(root, ".cxx", ".h", ".py", ".sh", ".cmake"):
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        place = path.relative_to(root)
        is_made = any(MADE in line for line in lines[:3])
        count = len(MADE_LIST.sub("", text).splitlines())
        if count > FILE_LINES and not is_made:
            complaints.append(f"{place}: {count} lines, more than {FILE_LINES}")
        if place.match(PUBLIC_HEADERS) and len(place.parts) == 2 and not is_made:
            complaints += long_comments(place, lines)
        found = []
        if path.suffix in CXX:
            found = cxx_functions(lines)
        elif path.suffix == ".py":
            found = python_functions(text)
        functions += [(place, *function) for function in found]
    for place, first, length, name in functions:
        if length > MOST_LINES and (str(place), name) not in LONG:
            complaints.append(f"{place}:{first}: {name} has {length} lines, more than {MOST_LINES}")
    long = sum(1 for function in functions if function[2] >= USUAL_LINES)
    print(f"{len(functions)} functions, {long} of them have {USUAL_LINES} lines or more")
    if long * 10 > len(functions):
        complaints.append(f"more than one function of ten has {USUAL_LINES} lines or more")
    return complaints


# --- Python and shell -----------------------------------------------------------------------------


def meant(root, complaint):
    """Is this the result of `from x import *`, or does the line itself allow it?"""
    place = re.match(r"(.*?):(\d+):", complaint)
    if STARRED.search(complaint):
        return True
    lines = (root / place.group(1)).read_text(encoding="utf-8").splitlines()
    return "# noqa" in lines[int(place.group(2)) - 1]


def check_python(root):
    """Lines that are too wide, and pyflakes' reports of errors, unused and unknown names."""
    complaints = []
    sources = files(root, ".py")
    for path in sources:
        place = path.relative_to(root)
        text = path.read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            if len(line) > PYTHON_COLUMNS:
                complaints.append(f"{place}:{number}: {len(line)} characters, more than {PYTHON_COLUMNS}")
    output, _ = run([tool("pyflakes3"), *[path.relative_to(root) for path in sources]], cwd=root)
    found = [line for line in output.splitlines() if re.match(r".*\.py:\d+:", line)]
    return complaints + [line for line in found if not meant(root, line)]


def check_shell(root):
    """The warnings of shellcheck; sourced files are followed."""
    scripts = [path.relative_to(root) for path in shell_files(root)]
    command = [tool("shellcheck"), "--severity=warning", "--external-sources", "--source-path=SCRIPTDIR"]
    output, _ = run([*command, "--format=gcc", *scripts], cwd=root)
    return output.splitlines()


def check_made(root):
    """Files that generate.py would change. Its tables are TOML, which Python reads from 3.11 on."""
    if sys.version_info < (3, 11):
        print("Python 3.11 is needed for the tables of settings")
        sys.exit(77)
    output, code = run([sys.executable, "-B", root / "Filters" / "Settings" / "generate.py", "--check"])
    return output.splitlines() if code else []


def check_mathematics(root):
    """Calls of OWN_BITS in the filter, the engine and the package; comments aside."""
    for path in files(root, ".cxx", ".h", ".py"):
        if path.relative_to(root).parts[0] == "Filters":
            no_code = NO_CODE.get(path.suffix, NO_CODE[""])
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for found in OWN_BITS.finditer(no_code.sub("", line)):
                    yield f"{path.relative_to(root)}:{number}: {found[1] or found[2]} differs between systems"


def check_rounding(root, build):
    """Objects of Filters/ without an option of ROUNDING, or with another that changes rounding."""
    with open(build / "compile_commands.json", encoding="utf-8") as file:
        entries = [(entry, pathlib.Path(build, entry["file"]).resolve()) for entry in json.load(file)]
    entries = [(entry, path) for entry, path in entries if path.is_relative_to(root / "Filters")]
    for entry, path in entries:
        words = [word for word in shlex.split(entry["command"]) if word in ROUNDING or UNROUNDED.match(word)]
        if not words or not ROUNDING.issuperset(words):
            yield f"{path.relative_to(root)}: compiled with {' '.join(words) or 'no option for rounding'}"
    if len(entries) < 100:
        yield f"only {len(entries)} objects were looked at"


# --- Markdown --------------------------------------------------------------------------------------


def pages(root):
    """{path: text} of the pages, without templates."""
    found = [*root.glob("*.md"), *files(root, ".md")]
    return {path: path.read_text(encoding="utf-8") for path in found if not path.name.endswith(".in.md")}


def anchors(text):
    """The anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), re.M)
    titles = [re.sub(r"\]\([^)]*\)", "", title) for title in headings]
    return {re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") for title in titles}


def dead_links(path, text):
    """Relative links of a page without a file, or a heading, at the other end. Code has none."""
    prose = re.sub(r"^```.*?^```|^ {4}.*?$|`[^`\n]*`", "", text, flags=re.M | re.S)
    for link in re.findall(r"\]\(([^)\s]+)\)", prose):
        target, _, anchor = link.partition("#")
        end = path.parent / target if target else path
        if re.match(r"\w+:", link) or end.suffix == ".html":
            continue
        if not end.exists() or (anchor and anchor not in anchors(end.read_text(encoding="utf-8"))):
            yield link


def check_docs(root):
    """Dead links, and pages that are too long."""
    texts = pages(root)
    complaints = [f"{path.relative_to(root)}: {link} leads nowhere"
                  for path, text in texts.items() for link in dead_links(path, text)]
    words = {str(path.relative_to(root)): len(text.split()) for path, text in texts.items()}
    for name, count in words.items():
        for pattern, most in PAGE_WORDS.items():
            if pathlib.PurePath("/" + name).match("/" + pattern) and count > most:
                complaints.append(f"{name}: {count} words, more than {most}")
    together = sum(words.get(name, 0) for name in MAPS)
    if together > MAPS_WORDS:
        complaints.append(f"{', '.join(MAPS)}: {together} words, more than {MAPS_WORDS}")
    return complaints


# --- The version ----------------------------------------------------------------------------------


def numbers(text):
    """(1, 2, 0) of 1.2 or 1.2.0."""
    return tuple([*map(int, text.split(".")), 0, 0][:3])


def check_version(root):
    """The number is that of CMakeLists.txt: where it must be repeated, and in the change notes' order."""
    project = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    number = re.search(r"^project\(\w+ VERSION ([\d.]+)", project, re.M)[1]
    complaints = []
    recipe = root / "Testing" / "Package" / "conda" / "recipe.yaml"
    repeated = re.search(r'^  version: "([\d.]+)"', recipe.read_text(encoding="utf-8"), re.M)
    if not repeated or repeated[1] != number:
        complaints.append(f"{recipe.relative_to(root)}: the version is not {number}, that of CMakeLists.txt")
    notes = root / "Plugin" / "Documentation" / "ChangeNotes.md"
    first, *sections = re.findall(r"^## (Next|[\d.]+)", notes.read_text(encoding="utf-8"), re.M)
    released = sections if first == "Next" else [first, *sections]
    order = [numbers(section) for section in released]
    if order != sorted(set(order), reverse=True):
        complaints.append(f"{notes.relative_to(root)}: the versions are not in order, newest first")
    elif first == "Next" and order and order[0] >= numbers(number):
        complaints.append(f"CMakeLists.txt: {number} is not newer than {released[0]}, the newest in the change notes")
    elif first != "Next" and order[0] != numbers(number):
        complaints.append(f"CMakeLists.txt: {number} is not {first}, the newest in the change notes")
    return complaints


# --- clang-tidy -----------------------------------------------------------------------------------


def tidy_sources(root, build, only):
    """The files of the filter, the engine and the tests' tools that the build compiles, each once."""
    with open(build / "compile_commands.json", encoding="utf-8") as file:
        compiled = {pathlib.Path(entry["file"]).resolve() for entry in json.load(file)}
    wanted = re.compile(only)
    inside = [path for path in files(root, ".cxx") if path.resolve() in compiled]
    return [path for path in inside if wanted.match(str(path.relative_to(root)))]


def check_tidy(root, build, only, jobs):
    """The warnings of clang-tidy. Its own errors count too: then a file was not checked."""
    program = tool("clang-tidy")
    sources = tidy_sources(root, build, only)
    commands = (build / "compile_commands.json").read_text(encoding="utf-8")

    def look(path):
        # gcc's options that clang does not know are no fault
        quiet = ["--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wno-ignored-optimization-argument"]
        return run([program, "--quiet", "--warnings-as-errors=*", *quiet, "-p", folder, path], cwd=root)

    complaints = set()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        # clang cannot read headers precompiled by gcc
        with open(os.path.join(folder, "compile_commands.json"), "w", encoding="utf-8") as file:
            file.write(re.sub(r" -Winvalid-pch -include \S*cmake_pch\.hxx", "", commands))
        for path, (output, code) in zip(sources, pool.map(look, sources)):
            found = re.findall(r"^(/.*?: (?:warning|error): .*)$", output, re.M)
            complaints.update(line.replace(f"{root}/", "") for line in found)
            if code != 0 and not found:
                complaints.add(f"{path.relative_to(root)}: clang-tidy stopped with {code}: {output[-500:]}")
    print(f"{len(sources)} files were looked at")
    return sorted(complaints) if sources else ["no file was looked at"]


def main():
    """Runs the check that the command line names."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("check", choices=("format", "sizes", "python", "shell", "made", "mathematics", "docs",
                                          "rounding", "version", "tidy"))
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the project (default: this one)")
    parser.add_argument("--clang-format", default="clang-format")
    parser.add_argument("--build", type=pathlib.Path, help="a folder with compile_commands.json")
    parser.add_argument("--only", default="Filters/|Testing/Support/", help="a regex of paths (tidy)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    if options.check == "format":
        complaints = check_format(options.root, options.clang_format)
    elif options.check == "rounding":
        complaints = list(check_rounding(options.root, options.build))
    elif options.check == "tidy":
        complaints = check_tidy(options.root, options.build, options.only, options.jobs)
    else:
        checks = {"sizes": check_sizes, "python": check_python, "shell": check_shell, "made": check_made,
                  "mathematics": check_mathematics, "docs": check_docs, "version": check_version}
        complaints = list(checks[options.check](options.root))
    for complaint in complaints:
        print(complaint)
    print(f"{len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
