# SPDX-License-Identifier: BSD-3-Clause
"""demo.sh as it is called: help, messages, exit codes, and one run from file to picture.

    python3 TestCommand.py <build folder>
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
HERE = os.path.dirname(os.path.abspath(__file__))
BUILD = sys.argv.pop(1)

sys.path.insert(0, HERE)

import badfiles  # noqa: E402


def run(command, *arguments, **environment):
    return subprocess.run(
        [os.path.join(ROOT, command), *arguments], cwd=tempfile.gettempdir(), text=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        env={**os.environ, "AHD_BUILD_DIR": BUILD, **environment})  # fmt: skip


class Command(unittest.TestCase):
    def assert_refused(self, message, *arguments):
        done = run("Plugin/demo.sh", *arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    def write(self, folder, name, content):
        path = os.path.join(folder, name)
        with open(path, "wb") as file:
            file.write(content)
        return path

    def test_help(self):
        for command in ("Plugin/demo.sh", "Testing/test.sh"):
            done = run(command, "--help")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("./" + command, done.stdout)
            self.assertIn("exit code", done.stdout)

    def test_every_option_of_the_demo_is_in_its_help(self):
        with open(os.path.join(ROOT, "Plugin", "Demo", "demo.py"), encoding="utf-8") as file:
            source = file.read()
        with open(os.path.join(ROOT, "Plugin", "Demo", "raster.py"), encoding="utf-8") as file:
            source += file.read()
        said = run("Plugin/demo.sh", "--help").stdout
        for option in ("--x", "--y", "--z", "--columns", "--exaggeration", "--nodata", "--simplify", "--edges",
                       "--raster", "--method", "--crs", "--output"):
            self.assertIn(option, said)
            self.assertIn(option if len(option) > 3 else '"--" + axis', source)

    def test_the_demo_builds_all_that_is_installed(self):
        """So that `cmake --install build` works after it: the demo's targets must build all installed files. By ninja's
        dependencies."""
        with open(os.path.join(ROOT, "Plugin", "demo.sh"), encoding="utf-8") as file:
            targets = re.search(r"/usr/bin/python3 -- (.*)", file.read()).group(1).split()
        if not os.path.exists(os.path.join(BUILD, "build.ninja")):
            self.skipTest("not built by ninja")

        def ninja(*arguments):
            command = ["ninja", "-C", BUILD, "-t", *arguments]
            return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout

        made = {line.rpartition(": ")[0] for line in ninja("targets", "all").splitlines()}
        needed = {path[len(BUILD) + 1:] if path.startswith(BUILD + "/") else path
                  for path in re.findall('label="([^"]*)"', ninja("graph", *targets))}  # fmt: skip
        installed = set()
        for folder, folders, files in os.walk(BUILD):
            folders[:] = [name for name in folders if name not in ("CMakeFiles", "Testing")]
            if "cmake_install.cmake" in files:
                with open(os.path.join(folder, "cmake_install.cmake"), encoding="utf-8") as file:
                    installed.update(re.findall('"%s/([^"]*)"' % re.escape(BUILD), file.read()))
        installed &= made
        self.assertGreater(len(installed), 4, "what is installed was not found")
        for path in installed:  # links are made with their targets
            self.assertIn(os.path.relpath(os.path.realpath(os.path.join(BUILD, path)), os.path.realpath(BUILD)), needed)

    def test_what_cannot_be_used(self):
        self.assert_refused("no such file: /nowhere.csv", "/nowhere.csv")
        self.assert_refused("one file at a time: a.csv or b.csv", "a.csv", "b.csv")
        self.assert_refused("unrecognized arguments: --fast", "--fast")
        self.assert_refused("--output needs a folder", "--output")
        self.assert_refused("--columns needs a value", "--columns")
        self.assert_refused("--exaggeration must be greater than 0", "--exaggeration", "-1")
        for factor in ("inf", "nan", "0"):
            self.assert_refused("--exaggeration must be greater than 0 and finite", "--exaggeration=" + factor)
        self.assert_refused("--raster must be greater than 0 and finite", "--raster", "0")
        self.assert_refused("invalid choice: 'cubic'", "--raster", "1", "--method=cubic")
        self.assert_refused("--method and --crs are for --raster", "--method", "natural")
        self.assert_refused("--crs takes a code such as EPSG:32633, not 32633", "--raster=1", "--crs", "32633")
        self.assert_refused("--crs takes a code such as EPSG:32633, not ", "--raster=1", "--crs=")
        self.assert_refused("%s is a directory, not a file" % ROOT, ROOT)
        self.assert_refused("--simplify must be 0 or more and finite", "--simplify", "nan")
        self.assert_refused("invalid float value: 'much'", "--exaggeration", "much")
        self.assert_refused("--columns and --x, --y, --z exclude each other", "--columns", "1,2", "--x", "3")
        self.assert_refused("two or three names or numbers", "--columns", "1,2,3,4")
        self.assert_refused("unknown kind of file; known are .csv", __file__)

    def test_from_file_to_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a hill.csv")
            with open(path, "w", encoding="utf-8") as file:
                for i in range(400):
                    x, y = i % 20, i // 20
                    file.write("%d;%d;%g\n" % (x, y, 90 - (x - 9) ** 2 - (y - 9) ** 2))
            done = run("Plugin/demo.sh", path, "--raster", "0.25", "--output", os.path.join(folder, "new", "out"))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("76 × 76 cells of 0.25, linear, 100.0 % of them with a height", done.stdout)
            self.assertIn("triangles   722", done.stdout)
            for ending in ("vtp", "png", "vti"):
                self.assertGreater(os.path.getsize(os.path.join(folder, "new", "out", "a hill." + ending)), 10000)

    def test_a_file_that_turns_out_bad_in_paraview(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "header.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write("x,y,z\n")
            self.assert_refused("holds a header and no data", path, "--output", folder)
            path = os.path.join(folder, "prose.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write("who, what, where\nsomebody, something, somewhere\nnobody, nothing, nowhere\n")
            self.assert_refused("fewer than two columns of numbers: x and y are needed", path, "--output", folder)
            path = os.path.join(folder, "noise.vtp")
            with open(path, "w", encoding="utf-8") as file:
                file.write("noise\n")
            self.assert_refused("ParaView cannot read " + path, path, "--output", os.path.join(folder, "out"))

    def test_each_bad_file_ends_in_one_line(self):
        """No traceback, no stack of ParaView's, though VTK's reader dies of some."""
        known = {**badfiles.FOR_VTK, **badfiles.FOR_THE_DEMO, **badfiles.FOR_THE_PICTURE}
        files = {name: known[name] for name in (
            "much.vtk", "rows.ply", "list.ply", "field.csv", "null.csv", "scale.las", "huge.csv", "high.csv")}
        with tempfile.TemporaryDirectory() as folder:
            for name, (content, words) in files.items():
                with self.subTest(name=name):
                    path = self.write(folder, name, content)
                    done = self.assert_refused(words, path, "--output", os.path.join(folder, "out"))
                    self.assertRegex(done.stderr, r"\Ademo: [^\n]*\n\Z")

    def test_columns_that_are_no_decimal_number(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.write(folder, "hill.csv", badfiles.HILL)
            done = self.assert_refused('no column "\u00b2" for x', path, "--columns=\u00b2,2,3", "--output", folder)
            self.assertRegex(done.stderr, r"\Ademo: [^\n]*\n\Z")

    def test_output_that_cannot_be_written_is_refused_before_the_work(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.write(folder, "hill.csv", badfiles.HILL)
            os.mkdir(os.path.join(folder, "hill.png"))
            outputs = (
                (path, "--output %s cannot be a folder" % path),
                ("/proc/no", "--output /proc/no cannot be a folder"),
                ("/proc", "nothing can be written in --output /proc"),
                (folder, "hill.png cannot be written: it is a directory"),
            )
            for output, words in outputs:
                done = self.assert_refused(words, path, "--output", output)
                self.assertEqual(done.stdout, "")

    def test_compressed_lidar(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(HERE, "Inputs", "hill.laz"), "rb") as file:
                content = file.read()
            path = self.write(folder, "hill.LAZ", content)
            done = run("Plugin/demo.sh", path, "--output", folder)
            if "could not be installed from PyPI" in done.stderr and os.environ.get("CI") != "true":
                self.skipTest("PyPI is out of reach")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("LAS 1.2, point format 1, 400 points", done.stdout)
            self.assertIn("triangles   722", done.stdout)
            self.assertGreater(os.path.getsize(os.path.join(folder, "hill.png")), 10000)
            path = self.write(folder, "cut.laz", content[:900])
            self.assert_refused("is damaged", path, "--output", folder)
            path = self.write(folder, "hill.las", content)
            self.assert_refused("is compressed (LAZ); give it a name that ends in .laz", path, "--output", folder)

    def test_the_help_of_the_plugin_is_built(self):
        done = run("Plugin/demo.sh", "--output", os.path.join(BUILD, "demo"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(os.path.join(BUILD, "CMakeCache.txt"), encoding="utf-8") as file:
            self.assertRegex(file.read(), r"\nAHD_PLUGIN_DOC:\w+=ON\n")
        pages = os.path.join(BUILD, "Plugin", "paraview_help", "AdaptiveHilbertDelaunay.qch")
        self.assertGreater(os.path.getsize(pages), 100000)
        with open(os.path.join(ROOT, "Plugin", "demo.sh"), encoding="utf-8") as file:
            self.assertIn("AHD_PLUGIN_DOC=ON", file.read())

    def test_the_filter_warns_once(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "line.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write("1,1,0\n2,2,0\n3,3,0\n")
            done = run("Plugin/demo.sh", path, "--output", folder)
            self.assertEqual((done.stdout + done.stderr).count("There is no triangle"), 1, done.stderr)

    def test_without_rights_to_install_it_says_what_to_ask_for(self):
        """No password is requested here: sudo is not in the PATH."""
        script = 'program=test logs=%s; . "%s/.ci/setup.sh"; id() { echo 1000; }; PATH=/nowhere; become_root "a b"'
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                ["/bin/bash", "-c", script % (folder, ROOT)], text=True, stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("needs root or sudo", done.stderr)
        self.assertIn("apt-get install --no-install-recommends a b", done.stderr)

    def test_a_step_that_fails_names_its_log_and_shows_its_end(self):
        script = 'program=test logs=%s; . "%s/.ci/setup.sh"; step "Trying" try sh -c "echo why; exit 7"'
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                ["/bin/bash", "-c", script % (folder, ROOT)], text=True, check=False,
                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 7)
            self.assertIn("  | why", done.stderr)
            self.assertIn(os.path.join(folder, "try.log"), done.stderr)


if __name__ == "__main__":
    unittest.main()
