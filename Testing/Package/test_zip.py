# SPDX-License-Identifier: BSD-3-Clause
"""The .zip for ParaView's users (Plugin/Python/make_zip.py), made of a wheel that has the build's package.

    python3 test_zip.py <folder of the build's Python packages>
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".")
PACKAGE = "adaptivehilbertdelaunay"
WHEEL = PACKAGE + "-1.2.3-py3-none-win_amd64.whl"


class Zip(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def make(self, files):
        with zipfile.ZipFile(self.folder / WHEEL, "w") as wheel:
            for name, content in files.items():
                wheel.writestr(name, content)
        command = [sys.executable, str(ROOT / "Plugin/Python/make_zip.py"), str(self.folder), str(self.folder / WHEEL)]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)

    def test_the_package_with_the_plugin_and_nothing_of_pip(self):
        files = [path for path in (PACKAGES / PACKAGE).rglob("*") if path.is_file() and path.suffix != ".pyc"]
        package = {str(path.relative_to(PACKAGES)): path.read_bytes() for path in files}
        info = PACKAGE + "-1.2.3.dist-info/"
        done = self.make({**package, info + "RECORD": "", info + "licenses/LICENSE": "BSD"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        path = self.folder / (PACKAGE + "-1.2.3-paraview-win_amd64.zip")
        self.assertEqual(done.stdout.strip(), str(path))
        with zipfile.ZipFile(path) as made:
            self.assertIsNone(made.testzip())
            made.extractall(self.folder / "there")
        top = self.folder / "there" / "AdaptiveHilbertDelaunay"
        self.assertEqual(sorted(os.listdir(top)), ["LICENSE.txt", "README.txt", PACKAGE])
        text = (top / "README.txt").read_text(encoding="ascii")
        words = next(line for line in text.splitlines() if "Plugin.py" in line)
        self.assertTrue((self.folder / "there" / words.replace(" ", "")).is_file(), words)
        code = "import numpy, adaptivehilbertdelaunay as a; print(len(a.delaunay(numpy.eye(3)[:, :2]).triangles))"
        environment = {**os.environ, "PYTHONPATH": str(top), "PYTHONDONTWRITEBYTECODE": "1"}
        self.assertEqual(subprocess.check_output([sys.executable, "-c", code], env=environment, text=True), "1\n")

    def test_a_wheel_without_the_plugin_is_refused(self):
        done = self.make({PACKAGE + "/__init__.py": ""})
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("there is no plugin in", done.stderr)


if __name__ == "__main__":
    unittest.main()
