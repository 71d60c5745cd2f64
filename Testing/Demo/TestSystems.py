# SPDX-License-Identifier: BSD-3-Clause
"""Systems on which the commands work: the packages they request there, and their messages elsewhere.

Systems are simulated by files like /etc/os-release, which AHD_OS_RELEASE names.
"""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
COMMANDS = ("Plugin/demo.sh", "Testing/test.sh", "Plugin/Documentation/make_figures.sh")
# Whatever changes a system or builds something.
TOUCHING = ("apt-get", "sudo", "cmake", "dpkg", "pip", "pip3", "Xvfb")

SUPPORTED = {
    "12": 'PRETTY_NAME="Debian GNU/Linux 12 (bookworm)"\nID=debian\nVERSION_ID="12"\nVERSION_CODENAME=bookworm\n',
    "13": 'PRETTY_NAME="Debian GNU/Linux 13 (trixie)"\nID=debian\nVERSION_ID="13"\nVERSION_CODENAME=trixie\n',
    "testing": 'PRETTY_NAME="Debian GNU/Linux forky/sid"\nID=debian\nVERSION_CODENAME=forky\n',
}
OTHERS = {
    "Debian GNU/Linux 11 (bullseye)": "ID=debian\nVERSION_ID=11\nVERSION_CODENAME=bullseye\n",
    "Fedora Linux 43": "ID=fedora\nVERSION_ID=43\n",
    "Ubuntu that claims to be bookworm": "ID=ubuntu\nVERSION_CODENAME=bookworm\n",
}
# Systems derived from Debian or Ubuntu, and the ParaView that each is assumed to have.
DERIVED = {
    "Ubuntu 24.04.1 LTS":
        ('ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=noble\nUBUNTU_CODENAME=noble\n', "5.11.2+dfsg-6"),
    "Linux Mint 22": ('ID=linuxmint\nID_LIKE="ubuntu debian"\nUBUNTU_CODENAME=noble\n', "5.11.2+dfsg-6"),
    "LMDE 7 (gigi)": ("ID=linuxmint\nID_LIKE=debian\nDEBIAN_CODENAME=trixie\n", "5.13.2+dfsg-3"),
    "Only a codename": ("ID=other\nDEBIAN_CODENAME=trixie\n", "5.13.2+dfsg-3"),
    "A rolling one": ('ID=rolling\nID_LIKE="other debian"\n', "6.1.1-2"),
}
LIKE = {"5.11": "12", "5.13": "13", "6.1.": "testing"}


class Systems(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.touched = os.path.join(self.folder, "touched")
        stubs = os.path.join(self.folder, "bin")
        os.mkdir(stubs)
        for name in TOUCHING:
            path = os.path.join(stubs, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write('#!/bin/sh\necho "%s $*" >> "%s"\nexit 1\n' % (name, self.touched))
            os.chmod(path, 0o755)
        self.path = stubs + ":" + os.environ["PATH"]
        self.lists("5.11.2")

    def lists(self, paraview, lacking="nothing"):
        """The package lists have this ParaView, and every package but the missing one."""
        stub = ("#!/bin/sh\nshift\nfor name; do\n  case $name in\n    paraview-dev) version=%s ;;\n"
                "    %s) version='(none)' ;;\n    *) version=1.0 ;;\n  esac\n"
                '  printf "%%s:\\n  Installed: (none)\\n  Candidate: %%s\\n" "$name" "$version"\ndone\n')
        path = os.path.join(self.folder, "bin", "apt-cache")
        with open(path, "w", encoding="utf-8") as file:
            file.write(stub % (paraview, lacking))
        os.chmod(path, 0o755)

    def run_in(self, system, *command):
        """Runs a command in a system with this os-release; None: no such file."""
        path = os.path.join(self.folder, "os-release")
        if system is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(system)
        environment = {
            **os.environ, "AHD_OS_RELEASE": path, "PATH": self.path,
            "AHD_BUILD_DIR": os.path.join(self.folder, "build")}  # fmt: skip
        return subprocess.run(
            command, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            env=environment, cwd=self.folder, check=False)  # fmt: skip

    def packages(self, what, release):
        script = 'program=test logs=/nowhere; . "{0}/.ci/setup.sh"; . "{0}/.ci/packages.sh"; packages_to {1} {2}'
        done = self.run_in("", "bash", "-c", script.format(ROOT, what, release))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_elsewhere_one_message_and_nothing_is_touched(self):
        for name, text in OTHERS.items():
            for command in COMMANDS:
                with self.subTest(system=name, command=command):
                    done = self.run_in('PRETTY_NAME="%s"\n%s' % (name, text), os.path.join(ROOT, command))
                    self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                    self.assertIn("works on Debian 12, 13 and testing, and this is %s" % name, done.stderr)
                    for word in ("pip install .", "the plugin in Python", "cmake --build build", "CMake 3.18",
                                 "paraview-dev", "libgtest-dev"):  # fmt: skip
                        self.assertIn(word, done.stderr)
                    self.assertFalse(os.path.exists(self.touched), "something was run")
                    self.assertFalse(os.path.exists(os.path.join(self.folder, "build")))

    def required(self, text, *needed, finished=""):
        """The variables and the message of require_release."""
        script = ('program=test logs=/nowhere root=/sources; . "{0}/.ci/setup.sh"; . "{0}/.ci/packages.sh";'
                  ' require_release "{1}" {2}; echo "<$release><$like>"')
        return self.run_in(text, "bash", "-c", script.format(ROOT, finished, " ".join(needed)))

    def test_what_works_elsewhere_is_named_first(self):
        said = self.required("ID=fedora\n").stderr
        places = [said.index(words) for words in ("pip install .", "the wheel", "the plugin in Python", "To build")]
        self.assertEqual(places, sorted(places), said)

    def test_systems_made_from_debian_go_on_after_one_line(self):
        for name, (text, paraview) in DERIVED.items():
            with self.subTest(system=name):
                self.lists(paraview)
                done = self.required('PRETTY_NAME="%s"\n%s' % (name, text), "build", "draw", "test")
                release = LIKE[paraview[:4]]
                line, words = done.stdout.splitlines()
                self.assertEqual((done.returncode, done.stderr, words), (0, "", "<%s><%s>" % (release, release)))
                self.assertRegex(line, "not tested here: %s is taken for Debian %s" % (re.escape(name), release))
                self.assertFalse(os.path.exists(self.touched), "something was run")

    def test_the_commands_go_on_there_as_far_as_to_the_packages(self):
        for command in COMMANDS:
            done = self.run_in(DERIVED["Linux Mint 22"][0], os.path.join(ROOT, command))
            self.assertIn("is taken for Debian 12", done.stdout, done.stderr)
            self.assertNotIn("this works on Debian", done.stderr)
            self.assertNotEqual(done.returncode, 2)

    def test_where_packages_lack_they_are_named(self):
        text = DERIVED["Linux Mint 22"][0]
        for paraview, lacking, why in (
            ("5.10.1+dfsg-1", "nothing", "whose package lists have no ParaView from 5.11 on"),
            ("'(none)'", "nothing", "whose package lists have no ParaView from 5.11 on"),
            ("5.11.2", "libglew-dev", "whose package lists lack libglew-dev."),
        ):
            self.lists(paraview, lacking)
            done = self.required(text, "build", "draw", "test")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(why, done.stderr)
            self.assertIn("pip install .", done.stderr)
        self.assertEqual(self.required(text, "build", "draw").returncode, 0)  # libglew-dev is for the tests

    def test_empty_lists_are_fetched_first(self):
        self.lists("5.11.2")
        os.rename(os.path.join(self.folder, "bin", "apt-cache"), os.path.join(self.folder, "filled"))
        apt = os.path.join(self.folder, "bin", "apt-cache")
        with open(apt, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n")
        os.chmod(apt, 0o755)
        script = ('program=test logs={1}/logs; . "{0}/.ci/setup.sh"; . "{0}/.ci/packages.sh"; become_root() {{ :; }};'
                  ' refresh_lists() {{ mv {1}/filled {1}/bin/apt-cache; }}; require_release "" build; echo "$release"')
        done = self.run_in(DERIVED["Linux Mint 22"][0], "bash", "-c", script.format(ROOT, self.folder))
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, "12"), done.stderr)

    def test_with_a_finished_build_the_demo_never_refuses(self):
        """The plugin was built by hand: nothing is installed or built, ParaView is called with it."""
        plugins = os.path.join(self.folder, "build", "lib", "paraview-6.0", "plugins", "AdaptiveHilbertDelaunay")
        os.makedirs(plugins)
        with open(os.path.join(plugins, "AdaptiveHilbertDelaunay.so"), "w", encoding="utf-8"):
            pass
        points = os.path.join(self.folder, "points.csv")
        with open(points, "w", encoding="utf-8") as file:
            file.write("x,y,z\n0,0,0\n1,0,0\n0,1,0\n")
        # a display that is ready at once, and a ParaView that prints its arguments
        for name, words in (("xauth", ""), ("mcookie", ""), ("Xvfb", "echo 7 >&3; sleep 9"), ("pvbatch", 'echo "$@"')):
            with open(os.path.join(self.folder, "bin", name), "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\n%s\n" % words)
            os.chmod(os.path.join(self.folder, "bin", name), 0o755)
        self.lists("5.10.1")
        for text in (*OTHERS.values(), DERIVED["Linux Mint 22"][0], ""):
            done = self.run_in(text, os.path.join(ROOT, "Plugin/demo.sh"), points)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            self.assertIn("--plugin %s/AdaptiveHilbertDelaunay.so %s" % (plugins, points), done.stdout)
            self.assertFalse(os.path.exists(self.touched), "something was run")

    def test_by_hand_with_the_systems_python(self):
        """CMake takes the Python of an active venv, which has no VTK, unless one is given."""
        for name in (".ci/packages.sh", "CONTRIBUTING.md", "Plugin/Documentation/Installing.md"):
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                lines = [line for line in file if "cmake -S . " in line]
            self.assertTrue(lines, name)
            for line in lines:
                self.assertIn(" -DPython3_EXECUTABLE=/usr/bin/python3", line, name)

    def test_without_a_word_about_the_system(self):
        for text in (None, ""):
            done = self.run_in(text, os.path.join(ROOT, "Plugin/demo.sh"))
            self.assertEqual(done.returncode, 2)
            self.assertIn("this is an unknown system", done.stderr)

    def test_on_debian_it_goes_on(self):
        """Up to the package manager, which is a stub here."""
        for name, text in SUPPORTED.items():
            with self.subTest(release=name):
                done = self.required(text, "build")
                self.assertEqual((done.returncode, done.stdout.strip(), done.stderr), (0, "<%s><>" % name, ""))

    def checkout(self, name):
        """A copy of the commands, in a folder of this name."""
        root = os.path.join(self.folder, name)
        for part in (*COMMANDS, ".ci/setup.sh", ".ci/packages.sh", ".ci/unquoted.txt"):
            os.makedirs(os.path.dirname(os.path.join(root, part)), exist_ok=True)
            shutil.copy(os.path.join(ROOT, part), os.path.join(root, part))
        return root

    def test_paths_that_the_shell_cannot_take_are_refused_at_once(self):
        for name in ("a (b)", "a'b", "a&b", "a$b", "a,b"):
            root = self.checkout(name)
            for command in COMMANDS:
                with self.subTest(path=name, command=command):
                    done = self.run_in(SUPPORTED["13"], os.path.join(root, command))
                    self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                    self.assertIn("nothing can be built in %s, as the path has one of" % root, done.stderr)
                    self.assertFalse(os.path.exists(self.touched), "something was run")

    def test_a_space_in_the_path_is_none_of_them(self):
        done = self.run_in(SUPPORTED["13"], os.path.join(self.checkout("a b-c.d+ä"), "Plugin/demo.sh"))
        self.assertNotEqual(done.returncode, 0)  # which one depends on the packages that this system has
        self.assertNotIn("nothing can be built", done.stderr)

    def install(self, *updates):
        """install_packages with an apt-get whose updates print this in turn: its calls, and the end."""
        log = os.path.join(self.folder, "asked")
        for number, words in enumerate(updates, 1):
            with open("%s.%d" % (log, number), "w", encoding="utf-8") as file:
                file.write(words)
        stub = '#!/bin/sh\necho "$*" >> "{0}"\ncase "$*" in *update) cat "{0}.$(wc -l < "{0}")" ;; esac\n'
        with open(os.path.join(self.folder, "bin", "apt-get"), "w", encoding="utf-8") as file:
            file.write(stub.format(log))
        script = ('program=test logs={0}/logs; . "{1}/.ci/setup.sh"; id() {{ echo 0; }};'
                  ' room_for() {{ :; }}; install_packages a b')
        done = self.run_in(SUPPORTED["13"], "bash", "-c", script.format(self.folder, ROOT))
        with open(log, encoding="utf-8") as file:
            return file.read().splitlines(), done

    def test_without_a_network_one_try_and_the_message(self):
        """apt-get's update ends with 0 there, and its install takes minutes over retries."""
        asked, done = self.install("Err:1 http://a b InRelease\n  Could not resolve 'a'\nErr:2 http://c d InRelease\n")
        self.assertEqual((done.returncode, len(asked)), (1, 1), (asked, done.stderr))
        self.assertRegex(asked[0], "Retries=3 .*Retries=0 .*http::Timeout=10 .*https::Timeout=10 update$")
        self.assertIn("none of apt's sources answers, so no packages can be installed. Is the net", done.stderr)

    def test_with_a_network_lists_are_fetched_and_packages_installed(self):
        asked, done = self.install("Hit:1 http://a b InRelease\n")
        self.assertEqual((done.returncode, len(asked)), (0, 2), (asked, done.stderr))
        self.assertTrue(asked[1].endswith("install a b"))

    def test_where_one_source_fails_all_are_tried_again_with_retries(self):
        asked, done = self.install("Get:1 http://a b\nErr:2 http://c d\n", "Get:1 http://a b\n")
        self.assertEqual((done.returncode, len(asked)), (0, 3), (asked, done.stderr))
        self.assertNotIn("Retries=0", asked[1])
        self.assertTrue(asked[2].endswith("install a b"))

    def test_a_build_folder_that_cannot_be_written_is_named_with_the_way_out(self):
        """As in a read-only checkout; /proc is one for root, too."""
        for command in COMMANDS:
            for build in ("/proc/build", "/proc"):
                with self.subTest(command=command, build=build):
                    command = os.path.join(ROOT, command)
                    done = self.run_in(SUPPORTED["13"], "env", "AHD_BUILD_DIR=" + build, command)
                    self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                    self.assertIn("nothing can be written in %s, where this builds" % build, done.stderr)
                    self.assertIn("AHD_BUILD_DIR=/somewhere/else %s\n" % command, done.stderr)
                    self.assertNotIn("line ", done.stderr)
                    self.assertFalse(os.path.exists(self.touched), "something was run")

    def test_room_is_told_before_packages_are_installed(self):
        """As apt prints it, in Debian 12 and since `apt` 3."""
        apt = os.path.join(self.folder, "bin", "apt-get")
        script = (
            'program=test logs="{1}/logs"; . "{0}/.ci/setup.sh"; become_root() {{ :; }}; refresh_lists() {{ :; }};'
            ' as_root() {{ return 100; }}; install_packages one two').format(ROOT, self.folder)  # fmt: skip
        for words in ("After this operation, 3,245 MB of additional disk space will be used.",
                      "  Space needed: 3,245 MB / 10.2 GB available"):  # fmt: skip
            with open(apt, "w", encoding="utf-8") as file:
                file.write('#!/bin/sh\n[ "$*" != "${*#*--assume-no}" ] && echo "%s"\nexit 1\n' % words)
            done = self.run_in(SUPPORTED["12"], "bash", "-c", script)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("Installing 2 packages and what they need (3,245 MB on the disk): one two", done.stdout)
            self.assertIn("Is there room on the disk (3,245 MB and the downloads)", done.stderr)

    def test_every_release_has_its_packages(self):
        for release, qt in (("12", "qttools5-dev"), ("13", "qttools5-dev"), ("testing", "qt6-tools-dev")):
            build = self.packages("build", release)
            self.assertIn("paraview-dev", build)
            self.assertIn(qt, build)
            self.assertIn("xvfb", self.packages("draw", release))
            test = self.packages("test", release)
            self.assertIn("libgtest-dev", test)
            self.assertEqual(len([name for name in test if name.startswith("libclang-rt")]), 1)
            names = build + test + self.packages("draw", release)
            self.assertEqual(len(names), len(set(names)), "named twice")
        self.assertIn("libvtk9.1", self.packages("vtk", "12"))
        self.assertIn("libvtk9.3", self.packages("vtk", "13"))
        self.assertEqual(self.packages("vtk", "testing"), [])


if __name__ == "__main__":
    unittest.main()
