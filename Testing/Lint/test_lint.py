# SPDX-License-Identifier: BSD-3-Clause
"""lint.py reports each fault that it checks for: each is planted in a project of one file."""

import contextlib
import io
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

import lint

CLEAN = """// SPDX-License-Identifier: BSD-3-Clause
namespace n
{
struct Held
{
  int value;
};

int twice(const Held& held)
{
  return 2 * held.value;
}

} // namespace n
"""


def function(lines, name="f"):
    """A C++ function of so many lines."""
    return f"int {name}()\n{{\n" + "  work();\n" * (lines - 4) + "  return 0;\n}\n"


class ComplaintsTest(unittest.TestCase):
    """One project in a folder of its own, with the layout of this one's sources."""

    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        shutil.copy(lint.ROOT / ".clang-format", self.root)
        shutil.copy(lint.ROOT / ".clang-tidy", self.root)

    def write(self, name, text):
        """Writes a file there and returns its path."""
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def need(self, tool):
        """Skips the test if the tool is not installed."""
        if shutil.which(tool) is None:
            self.skipTest(f"{tool} is not installed")

    def test_format(self):
        program = shutil.which("clang-format-14") or "clang-format"
        try:
            lint.clang_format(program)
        except SystemExit:
            self.skipTest("clang-format 14 is not installed")
        self.write("Filters/a.cxx", CLEAN)
        self.assertEqual(lint.check_format(self.root, program), [])
        self.write("Testing/b.h", CLEAN.replace("  return", " return"))
        self.assertEqual(lint.check_format(self.root, program), ["Testing/b.h:10: clang-format would change this"])

    def test_another_clang_format_is_not_asked(self):
        for said, status in (("Debian clang-format version 19.1.7", 77), ("nothing", 77), ("version 14.0.6", None)):
            program = self.write("bin/clang-format", f"#!/bin/sh\necho '{said}'\n")
            program.chmod(0o755)
            if status is None:
                self.assertEqual(lint.clang_format(str(program)), str(program))
                continue
            with self.assertRaises(SystemExit) as stopped, contextlib.redirect_stdout(io.StringIO()) as words:
                lint.clang_format(str(program))
            self.assertEqual(stopped.exception.code, status)
            self.assertIn("clang-format 14 is needed", words.getvalue())

    def test_long_files(self):
        self.write("Testing/short.cxx", "int a;\n" * 500)
        self.assertEqual(lint.check_sizes(self.root), [])
        for name in ("Filters/long.cxx", "Plugin/long.py", "Testing/long.cmake"):
            path = self.write(name, "a = 0\n" * 501)
            self.assertEqual(lint.check_sizes(self.root), [f"{name}: 501 lines, more than 500"])
            path.unlink()
        made = "/*\n * int (made of Filters/Settings/job.toml)\n" + " *   a\n" * 50 + " *\n */\n"
        self.write("Filters/list.h", made + "int a;\n" * 495)
        self.assertEqual(lint.check_sizes(self.root), [])
        self.write("Filters/list.h", made + "int a;\n" * 500)
        self.assertEqual(len(lint.check_sizes(self.root)), 1)

    def test_comments_of_public_headers(self):
        text = "/**\n * A word.\n */\n/// Another.\n// One more.\n" + "int a;\n\n" * 2 + "int b;\n"
        self.write("Filters/vtkPublic.h", text)
        self.assertEqual(lint.check_sizes(self.root), [])
        self.write("Filters/vtkPublic.h", "// Too much.\n" + text)
        for other in ("Filters/Input/vtkPrivate.h", "Filters/vtkPublic.cxx", "Testing/vtkTest.h"):
            self.write(other, "// A word.\n")
        self.assertEqual(
            lint.check_sizes(self.root), ["Filters/vtkPublic.h: 6 of 11 lines are comment, more than half"]
        )

    def test_long_functions(self):
        self.write("Filters/many.cxx", "\n".join(function(5, f"f{i}") for i in range(9)))
        self.write("Filters/one.cxx", function(80))
        self.assertEqual(lint.check_sizes(self.root), [])
        self.write("Filters/one.cxx", function(81))
        self.assertEqual(lint.check_sizes(self.root), ["Filters/one.cxx:1: f has 81 lines, more than 80"])
        self.write("Filters/one.cxx", function(40))
        self.write("Filters/two.py", "def f():\n" + "    pass\n" * 39)
        self.assertEqual(lint.check_sizes(self.root), ["more than one function of ten has 40 lines or more"])

    def test_functions_are_found_where_they_are(self):
        inside = "struct S\n{\n  int f()\n  {\n    return 1;\n  }\n  S(int a)\n    : a_(a)\n  {\n  }\n};\n"
        below = "/// A word.\ntemplate <int N>\nint g(\n  int a, int b)\n{\n  return a;\n}\n"
        lines = (CLEAN + inside + below).splitlines()
        found = [(name, length) for _, length, name in lint.cxx_functions(lines)]
        self.assertEqual(found, [("twice", 4), ("f", 4), ("S", 4), ("g", 6)])

    def test_python(self):
        self.need("pyflakes3")
        self.write("Plugin/good.py", "from math import *\n\nprint(sqrt(2))\nimport os  # noqa: F401\n")
        self.assertEqual(lint.check_python(self.root), [])
        for text, complaint in (
            ("import os\n", "'os' imported but unused"),
            ("print(unknown)\n", "undefined name 'unknown'"),
            ("print('" + 120 * "x" + "')\n", "129 characters"),
            ("def f(:\n", "invalid syntax"),
        ):
            self.write("Plugin/bad.py", text)
            said = lint.check_python(self.root)
            self.assertTrue(said and all(line.startswith("Plugin/bad.py:1:") for line in said), said)
            self.assertIn(complaint, said[0])

    def test_docs(self):
        self.write("Filters/a.md", "# A page\n\n## `More`, of [it](a.md)\n")
        page = "[a](Filters/a.md#a-page) [b](Filters/a.md#more-of-it) [c](#top) [d](https://e.f) `[g](h)`\n"
        page += "\n    [i](j)\n"
        self.write("README.md", "# Top\n" + page)
        self.assertEqual(lint.check_docs(self.root), [])
        for link in ("b.md", "Filters/a.md#less", "#bottom"):
            self.write("README.md", f"# Top\n[x]({link})\n")
            self.assertEqual(lint.check_docs(self.root), [f"README.md: {link} leads nowhere"])
        self.write("README.md", "word " * 801)
        self.write("Filters/Engine/Merge/README.md", "word " * 1501)
        self.write("Filters/README.md", "word " * 1501)
        self.write("CONTRIBUTING.md", "word " * 3699)
        self.assertEqual(sorted(lint.check_docs(self.root)), [
            "Filters/Engine/Merge/README.md: 1501 words, more than 1500",
            ", ".join(lint.MAPS) + ": 6001 words, more than 6000",
            "README.md: 801 words, more than 800"])

    def copy_settings(self):
        """The input of the tables' generator."""
        settings = pathlib.Path("Filters/Settings")
        shutil.copytree(lint.ROOT / settings, self.root / settings)
        for name in ("Plugin/AdaptiveHilbertDelaunay.xml.in", "Filters/Engine/Interface/ahd.h",
                     "Filters/Engine/Interface/ahd_sample.h", "Filters/Engine/Job/ReportRows.h"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(lint.ROOT / name, self.root / name)
        return settings

    def test_version(self):
        def complaints(number, recipe, *sections):
            self.write("CMakeLists.txt", f"# x\nproject(A VERSION {number} LANGUAGES C)\n")
            self.write("Testing/Package/conda/recipe.yaml", f'context:\n  version: "{recipe}"\n')
            self.write("Plugin/Documentation/ChangeNotes.md", "".join(f"## {name}\n\n" for name in sections))
            return lint.check_version(self.root)

        for number, *sections in (
                ("1.0.0", "Next", "0.9"), ("1.0.0", "1.0.0 (2027-01-01)", "0.9"), ("1.10.0", "Next", "1.9.2", "1.9.1")):
            self.assertEqual(complaints(number, number, *sections), [])
        self.assertIn("the version is not 1.0.1", complaints("1.0.1", "1.0.0", "Next", "0.9")[0])
        self.assertIn("1.0.0 is not newer than 1.0", complaints("1.0.0", "1.0.0", "Next", "1.0")[0])
        self.assertIn("1.0.0 is not 1.1.0", complaints("1.0.0", "1.0.0", "1.1.0", "1.0.0")[0])
        self.assertIn("not in order", complaints("1.2.0", "1.2.0", "Next", "1.0.0", "1.1.0")[0])

    @unittest.skipIf(sys.version_info < (3, 11), "the tables are TOML")
    def test_made(self):
        """A row changed by hand in a generated file, or in its table without generating the files."""
        settings = self.copy_settings()
        made = [line.split(":")[0] for line in lint.check_made(self.root)]
        self.assertIn("Filters/vtkAdaptiveHilbertAlgorithm.h", made)
        for name in made:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(lint.ROOT / name, self.root / name)
        self.assertEqual(lint.check_made(self.root), [])
        table = self.root / settings / "delaunay.toml"
        table.write_text(table.read_text(encoding="utf-8").replace("most = 1024", "most = 1025"), encoding="utf-8")
        # panel, header, the job's rows and ahd.h, four files in Python, two lists of tests
        self.assertEqual(len(lint.check_made(self.root)), 10)

    @unittest.skipIf(sys.version_info < (3, 11), "the tables are TOML")
    def test_rows(self):
        """A row of each type is generated; an invalid one is named."""
        settings = self.copy_settings()
        table = self.root / settings / "delaunay.toml"
        rows = table.read_text(encoding="utf-8")
        for row, complaint in (
                ('type = "bool"\ndefault = false\nhepl = ""', "there is no field hepl"),
                ('type = "boole"\ndefault = false', "there is no type boole"), ('default = 1', "no type"),
                ('type = "bool"\ndefault = 1', "default is no bool"), ('type = "double"\ndefault = "1"', "no float"),
                ('type = "int"', "no default"), ('type = "int"\ndefault = [1]', "no list"),
                ('type = "enum"\ndefault = 0', "an enum has values"),
                ('type = "int"\ndefault = 1\npanel = "hidden"', "panel is one of"),
                ('type = "int"\ndefault = 1\nvisible = ["Alhpa = 0"]', "there is no Alhpa"),
                ('type = "int"\ndefault = 1\njob = "New"', "no row in job.toml"),
                ('type = "int"\ndefault = [1, 2]\nranks = "one"', "of a number or a switch"),
                ('type = "id"\nmeasure = true', "words in a text"),
                ('type = "id"\nmeasure = true\nsaid = "a"\npanel = "advanced"', "the panel has a text of measures"),
                ('type = "id"\nmeasure = true\nsaid = "a"', "no text of [Outline]"),
                ('type = "double"\ndefault = [1, 2]\nleast = 0', "lists are clamped")):
            table.write_text(f'{rows}\n[Outline.New]\nhelp = "New."\n{row}\n', encoding="utf-8")
            said = lint.check_made(self.root)
            self.assertEqual(len(said), 1, said)
            self.assertIn("New]", said[0])
            self.assertIn(complaint, said[0])
        table.write_text(rows, encoding="utf-8")
        free = ('"int"', "3"), ('"int"', "[1, 2]"), ('"double"', "1"), ('"double"', "nan"), ('"text"', '"a"')
        for kind, default in free:
            table.write_text(f'{rows}\n[Outline.New]\nhelp = "New."\ntype = {kind}\ndefault = {default}\n',
                             encoding="utf-8")
            self.assertIn("Filters/vtkAdaptiveHilbertAlgorithm.h", str(lint.check_made(self.root)))

    @unittest.skipIf(sys.version_info < (3, 11), "the tables are TOML")
    def test_rows_of_arrays_and_jobs(self):
        settings = self.copy_settings()
        for name, row, complaint in (
                ("arrays", 'of = "points"', "fields are"),
                ("arrays", 'of = "lines"\ntype = "id"\nhelp = "a"', "of is one of"),
                ("arrays", 'of = "cells"\ntype = "id"\nhelp = "a"', "job: of the surface's arrays"),
                ("arrays", 'of = "ranks"\ntype = "id"\nhelp = "a"\nsetting = "Alhpa"', "no setting Alhpa"),
                ("arrays", 'of = "cells"\ntype = "id"\nhelp = "a"\njob = "areas"', "ahd.h has no areas"),
                ("arrays", 'of = "cells"\ntype = "id"\nhelp = "a"\njob = "order"\nsetting = "GenerateBoxes"',
                 "with the job want_order"),
                ("job", 'help = "a"', "type and default"), ("job", 'type = "text"\ndefault = "a"', "no type text"),
                ("job", 'type = "int"\ndefault = 1', "no least or most"),
                ("job", 'type = "enum"\ndefault = 1\nmost = 2\nnames = ["a", "b"]', "names for 0 to 2")):
            other = self.root / settings / f"{name}.toml"
            its_rows = other.read_text(encoding="utf-8")
            other.write_text(f"{its_rows}\n[New]\n{row}\n", encoding="utf-8")
            said = lint.check_made(self.root)
            self.assertTrue(len(said) == 1 and complaint in said[0], said)
            other.write_text(its_rows, encoding="utf-8")

    @unittest.skipIf(sys.version_info < (3, 11), "the tables are TOML")
    def test_rows_that_others_contradict(self):
        settings = self.copy_settings()
        for name, old, new, complaint in (
                ("interpolation", '[Outline.Triangulation]\ntype = "exposed"', "", "[MaximumEdgeLength]: exposed, but"),
                ("delaunay", 'job = "merged_points"', 'job = "merged_points + lime"', "a job has no lime"),
                ("delaunay", 'job = "merged_points"', 'job = "np"', "a job has no np of this kind"),
                ("delaunay", 'job = "rim"\non_surface = 1', 'job = "rim"\non_surface = 3', "on_surface is no value"),
                ("job", "keyword_default = 1", "keyword_default = 2", "the default 2 is not from 0 to 1"),
                ("job", "mesh_default = 1", "mesh_default = 2", "the default 2 is not from 0 to 1"),
                ("job", 'names = ["own", "surface", "mixed"]', 'names = ["own", "own"]', "1 names for 0 to 2"),
                ("job", 'keyword = "nmax"', 'keyword = "rim"', "two rows have the keyword rim"),
                ("job", 'mesh_keyword = "tol"', 'mesh_keyword = "rim"', "two rows have the keyword rim"),
                ("arrays", 'keyword = "rank"', 'keyword = "status"', "two rows have the keyword status")):
            table = self.root / settings / f"{name}.toml"
            rows = table.read_text(encoding="utf-8")
            self.assertEqual(rows.count(old), 1, old)
            table.write_text(rows.replace(old, new), encoding="utf-8")
            said = lint.check_made(self.root)
            self.assertTrue(len(said) == 1 and complaint in said[0], said)
            table.write_text(rows, encoding="utf-8")

    def test_shell(self):
        self.need("shellcheck")
        self.write("Testing/good.sh", "#!/usr/bin/env bash\nset -u\n")
        self.assertEqual(lint.check_shell(self.root), [])
        for name in ("Testing/bad.sh", ".ci/run"):
            path = self.write(name, "#!/usr/bin/env bash\ncd /nowhere\n")
            said = lint.check_shell(self.root)
            self.assertEqual(len(said), 1)
            self.assertIn("SC2164", said[0])
            self.assertTrue(said[0].startswith(name))
            path.unlink()

    def test_mathematics(self):
        for text, count in (("return std::hypot(x, y);", 1), ("f = math.sin(x) + np.exp2(y)", 2), ("sine(x);", 0),
                            ("// std::hypot(x, y) would be", 0), ("std::sqrt(x); std::fma(x, y, z);", 0)):  # fmt: skip
            self.write("Filters/Engine/a.cxx", text)
            self.assertEqual(len(list(lint.check_mathematics(self.root))), count, text)
        for text, count in (("#define SINE(x) std::sin(x)", 1), ("std::pow<double>(x, 2) + __builtin_cosf(x)", 2)):
            self.write("Filters/Engine/a.cxx", text)
            self.assertEqual(len(list(lint.check_mathematics(self.root))), count, text)
        self.write("Filters/Engine/a.cxx", "")
        for text, count in (("n // 2 + math.log(x)", 1), ("np.arctan2(y, x) + np.power(x, y)", 2), ("x**0.5 + x**2", 1),
                            ("# math.sin(x)", 0), ("np.linalg.norm(x)", 1), ("math.dist(p, q)", 1)):  # fmt: skip
            self.write("Filters/Python/a.py", text)
            self.assertEqual(len(list(lint.check_mathematics(self.root))), count, text)

    def test_rounding(self):
        for options, is_well in (("-ffp-contract=off", True), ("", False), ("-ffp-contract=off -ffast-math", False),
                                 ("-ffp-contract=off -ffp-contract=fast", False), ("/fp:precise", True),
                                 ("-ffp-contract=off -I/fast-math -ffp-contract=off", True),
                                 ("-ffp-contract=off -ffp-model=fast", False),
                                 ("/fp:precise /fp:fast", False)):  # fmt: skip
            entry = {"file": str(self.root / "Filters" / "a.cxx"), "command": f"c++ {options} -c a.cxx"}
            self.write("compile_commands.json", json.dumps([entry] * 100))
            self.assertEqual(list(lint.check_rounding(self.root, self.root)) == [], is_well, options)
        self.write("compile_commands.json", "[]")
        self.assertEqual(len(list(lint.check_rounding(self.root, self.root))), 1)

    def test_tidy(self):
        self.need("clang-tidy")
        source = self.write("Filters/a.cxx", CLEAN)
        precompiled = f"-Winvalid-pch -include {self.write('cmake_pch.hxx', '')}"
        self.write("cmake_pch.hxx.gch", "made by gcc")
        entry = {"directory": str(self.root), "file": str(source), "command": f"c++ {precompiled} -c {source}"}
        self.write("compile_commands.json", json.dumps([entry]))
        self.assertEqual(lint.check_tidy(self.root, self.root, "Filters/", 1), [])
        self.assertEqual(lint.check_tidy(self.root, self.root, "Testing/", 1), ["no file was looked at"])
        self.write("Filters/a.cxx", CLEAN.replace("return 2", "int* p = 0;\n  return *p"))
        self.assertTrue(any("clang-analyzer-core.NullDereference" in line for line in self.tidied()))
        self.write("Filters/a.cxx", CLEAN.replace("int value", "int valve"))
        self.assertTrue(any("no member named 'value'" in line for line in self.tidied()))

    def tidied(self):
        """The messages of clang-tidy for the project's file."""
        return lint.check_tidy(self.root, self.root, "Filters/", 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
