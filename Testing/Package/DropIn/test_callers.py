# SPDX-License-Identifier: BSD-3-Clause
"""adaptivehilbertdelaunay.drop_in: arguments of its constructor, observers, versions of VTK."""

import gc
import os
import subprocess
import sys
import types
import unittest

import adaptivehilbertdelaunay
from adaptivehilbertdelaunay import drop_in
from algorithmtests import run_tests
from test_drop_in import cloud, wide
from vtkmodules.vtkCommonCore import vtkCommand, vtkVersion
from vtkmodules.vtkFiltersCore import vtkDelaunay2D, vtkTriangleFilter


@unittest.skipUnless(
    "AdaptiveHilbertDelaunayFilters" in adaptivehilbertdelaunay.vtkAdaptiveHilbertDelaunay2D.__module__,
    "nothing was compiled with this VTK")
class VersionTest(unittest.TestCase):
    @staticmethod
    def ask_for_the_class(version):
        """Where VTK reports this version, and there is no class in Python."""
        script = (
            "import vtkmodules.vtkCommonCore as core\n"
            "class Other:\n"
            "    GetVTKVersion = staticmethod(lambda: '%s')\n"
            "core.vtkVersion = Other\n"
            "from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D\n"
        ) % version
        return subprocess.run(
            [sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, check=False,
            env=dict(os.environ, ADAPTIVEHILBERTDELAUNAY_LIBRARY="/nowhere"))

    def test_another_vtk_is_refused(self):
        """Instead of crashing the process."""
        done = self.ask_for_the_class("8.9.9")
        self.assertEqual(done.returncode, 1)
        self.assertIn("ImportError: adaptivehilbertdelaunay was built for VTK 9", done.stderr)
        self.assertIn("but Python found VTK 8.9.9", done.stderr)

    def test_a_patch_of_vtk_is_none_other(self):
        major, minor = vtkVersion.GetVTKVersion().split(".")[:2]
        done = self.ask_for_the_class("%s.%s.987" % (major, minor))
        self.assertEqual(done.returncode, 0, done.stderr)


class ConstructorTest(unittest.TestCase):
    """Refuses what VTK refuses, with the same exception."""

    ARGUMENTS = (((1,), {}), (("no address",), {}), ((None,), {}), ((1, 2), {}), ((), {"Alpha": 2}), ((), {"no": 1}))

    @staticmethod
    def outcome(maker, arguments, properties):
        try:
            return maker(*arguments, **properties) is not None
        except (TypeError, ValueError) as error:
            return type(error)

    def test_arguments(self):
        for arguments, properties in self.ARGUMENTS:
            theirs = self.outcome(drop_in.original, arguments, properties)
            self.assertIs(self.outcome(vtkDelaunay2D, arguments, properties), theirs, (arguments, properties))

    def test_properties_where_vtk_takes_them(self):
        """As VTK 9.4 and later do."""
        properties = {"alpha": 2, "tolerance": 0.25}
        theirs = self.outcome(drop_in.original, (), properties)
        self.assertIs(self.outcome(vtkDelaunay2D, (), properties), theirs)
        if theirs is True:
            ours = vtkDelaunay2D(**properties)
            self.assertEqual((ours.GetAlpha(), ours.GetTolerance()), (2, 0.25))


class ObserverTest(unittest.TestCase):
    """The filter's measures are no field data of the output, whatever the caller does with observers."""

    @staticmethod
    def fields(algorithm):
        algorithm.Modified()
        algorithm.Update()
        data = algorithm.GetOutput().GetFieldData()
        return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    def test_removing_observers_takes_off_those_of_the_caller_only(self):
        removals = (
            lambda algorithm: algorithm.RemoveAllObservers(),
            lambda algorithm: algorithm.RemoveObservers("EndEvent"),
            lambda algorithm: algorithm.RemoveObservers(vtkCommand.EndEvent),
        )
        for remove in removals:
            ours, said = vtkDelaunay2D(), []
            ours.SetInputData(cloud(wide(1)))
            ours.AddObserver("EndEvent", lambda caller, event: said.append(event))
            for _ in range(2):
                remove(ours)
                self.assertEqual(self.fields(ours), [])
            self.assertEqual(said, [])

    def test_other_observers_stay(self):
        ours, said = vtkDelaunay2D(), []
        ours.SetInputData(cloud(wide(1)))
        for event in ("StartEvent", "EndEvent"):
            ours.AddObserver(event, lambda caller, name: said.append(name))
        ours.RemoveObservers("StartEvent")
        self.assertEqual(self.fields(ours), [])
        self.assertEqual(said, ["EndEvent"])

    def test_callers_never_see_the_measures(self):
        ours, seen = vtkDelaunay2D(), []
        ours.SetInputData(cloud(wide(1)))

        def look(caller, _event):
            seen.append(caller.GetOutput().GetFieldData().GetNumberOfArrays())

        ours.AddObserver("EndEvent", look)
        self.fields(ours)
        ours.RemoveAllObservers()
        ours.AddObserver("ProgressEvent", lambda caller, event: None)
        ours.RemoveObservers("EndEvent")
        for _ in range(3):
            ours.AddObserver("EndEvent", look)
        self.fields(ours)
        self.assertEqual(seen, [0] * 4)

    def test_no_priority_above_0(self):
        """VTK 9.7 calls an observer of such a priority endlessly once Python no longer holds the filter."""
        added = []

        class Spy(vtkDelaunay2D):
            def AddObserver(self, event, command, priority=0.0):
                added.append((event, priority))
                return super().AddObserver(event, command, priority)

        Spy().RemoveAllObservers()
        self.assertEqual(set(added), {("EndEvent", 0.0)})

    def test_only_the_pipeline_knows_it_and_it_ends(self):
        ours = vtkDelaunay2D()
        ours.SetInputData(cloud(wide(1)))
        end = vtkTriangleFilter()
        end.SetInputConnection(ours.GetOutputPort())
        del ours
        gc.collect()
        end.Update()
        found = end.GetInputConnection(0, 0).GetProducer()
        self.assertEqual(found.GetOutput().GetFieldData().GetNumberOfArrays(), 0)


class NamesTest(unittest.TestCase):
    def setUp(self):
        """A module of a user's, which drop_in finds."""
        self.user = types.ModuleType("user")
        sys.modules["user"] = self.user
        self.addCleanup(sys.modules.pop, "user")
        self.addCleanup(drop_in.install)  # whatever a test takes off

    def test_names_that_a_module_took_from_here_stay(self):
        """Whatever is suspended, installed or removed; names imported from VTK are replaced as before."""
        user = self.user
        exec("from vtkmodules.vtkFiltersCore import vtkTriangleFilter as other\n"
             "from adaptivehilbertdelaunay import drop_in\n"
             "with drop_in.suspended():\n"
             "    from vtkmodules.vtkFiltersCore import vtkDelaunay2D as of_vtk\n"
             "drop_in.install()\n", vars(user))
        self.assertIs(user.of_vtk, drop_in.original)  # used where the original was requested
        exec("from adaptivehilbertdelaunay.drop_in import original as theirs\n"
             "from adaptivehilbertdelaunay.drop_in import vtkDelaunay2D as ours\n", vars(user))
        for change in (drop_in.uninstall, drop_in.install, drop_in.install, drop_in.uninstall, drop_in.install):
            change()
            self.assertEqual((user.theirs, user.ours), (drop_in.original, drop_in.vtkDelaunay2D))
            expected = drop_in.vtkDelaunay2D if drop_in.installed() else drop_in.original
            self.assertIs(vtkDelaunay2D, expected)  # here, where both have been requested
        with drop_in.suspended():
            self.assertEqual((user.theirs, user.ours), (drop_in.original, drop_in.vtkDelaunay2D))
        self.assertEqual((user.theirs, user.ours), (drop_in.original, drop_in.vtkDelaunay2D))

    def test_a_name_that_is_given_the_other_class_keeps_it(self):
        """Though a class was put there before."""
        user = self.user
        exec("from vtkmodules.vtkFiltersCore import vtkDelaunay2D as one, vtkDelaunay2D as two\n"
             "from adaptivehilbertdelaunay import drop_in\n"
             "drop_in.uninstall()\n"
             "drop_in.install()\n"
             "one = drop_in.original\n", vars(user))
        for change in (drop_in.install, drop_in.uninstall, drop_in.install, drop_in.install):
            change()
            expected = drop_in.vtkDelaunay2D if drop_in.installed() else drop_in.original
            self.assertEqual((user.one, user.two), (drop_in.original, expected))

    def test_it_is_loaded_again(self):
        done = subprocess.run([sys.executable, "-c", (
            "from vtkmodules import vtkFiltersCore\n"
            "known = [vtkFiltersCore.vtkDelaunay2D]\n"
            "import importlib, adaptivehilbertdelaunay.drop_in as drop_in\n"
            "mine = drop_in.original\n"
            "importlib.reload(drop_in)\n"
            "assert drop_in.original is known[0] and mine is known[0]\n"
            "assert vtkFiltersCore.vtkDelaunay2D is drop_in.vtkDelaunay2D is not known[0]\n"
            "drop_in.uninstall()\n"
            "assert vtkFiltersCore.vtkDelaunay2D is known[0]\n")],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_what_a_block_gives_stays(self):
        user = self.user
        exec("import contextlib\n"
             "from adaptivehilbertdelaunay.drop_in import suspended\n"
             "with suspended() as one: pass\n"
             "with contextlib.ExitStack() as stack: two = stack.enter_context(suspended())\n", vars(user))
        drop_in.uninstall()
        drop_in.install()
        self.assertEqual((user.one, user.two), (drop_in.original, drop_in.original))


if __name__ == "__main__":
    run_tests()
