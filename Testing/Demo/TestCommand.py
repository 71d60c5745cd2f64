# SPDX-License-Identifier: BSD-3-Clause
"""demo.sh as it is called: help, messages, exit codes, and one run from file to picture.

    python3 TestCommand.py <build folder>
"""

import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
BUILD = sys.argv.pop(1)


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

    def test_help(self):
        for command in ("Plugin/demo.sh", "Testing/test.sh"):
            done = run(command, "--help")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("./" + command, done.stdout)
            self.assertIn("exit code", done.stdout)

    def test_every_option_of_the_demo_is_in_its_help(self):
        with open(os.path.join(ROOT, "Plugin", "Demo", "demo.py"), encoding="utf-8") as file:
            source = file.read()
        said = run("Plugin/demo.sh", "--help").stdout
        for option in ("--x", "--y", "--z", "--columns", "--exaggeration", "--edges", "--output"):
            self.assertIn(option, said)
            self.assertIn(option if len(option) > 3 else '"--" + axis', source)

    def test_what_cannot_be_used(self):
        self.assert_refused("no such file: /nowhere.csv", "/nowhere.csv")
        self.assert_refused("one file at a time: a.csv or b.csv", "a.csv", "b.csv")
        self.assert_refused("unrecognized arguments: --fast", "--fast")
        self.assert_refused("--output needs a folder", "--output")
        self.assert_refused("--columns needs a value", "--columns")
        self.assert_refused("--exaggeration must be greater than 0", "--exaggeration", "-1")
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
            done = run("Plugin/demo.sh", path, "--output", os.path.join(folder, "new", "out"))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("triangles   722", done.stdout)
            for ending in ("vtp", "png"):
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
            self.assert_refused("ParaView cannot read " + path, path, "--output", folder)

    def test_a_file_in_place_of_the_output_folder(self):
        with tempfile.NamedTemporaryFile() as file:
            self.assert_refused("--output %s cannot be a folder" % file.name, "--output", file.name)

    def test_the_filter_warns_once(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "line.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write("1,1,0\n2,2,0\n3,3,0\n")
            done = run("Plugin/demo.sh", path, "--output", folder)
            self.assertEqual((done.stdout + done.stderr).count("There is no triangle"), 1, done.stderr)

    def test_without_rights_to_install_it_says_what_to_ask_for(self):
        """Nobody is asked for a password here: sudo is not in the PATH."""
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
