# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the plugin in Python alone: it is made of the XML, finds the package or reports that it is missing, and
drives the filter.

    TestInPython.py              runs the cases, those that load the plugin elsewhere in processes of their own
    TestInPython.py load FILE    one such: loads it and tells what is there then
"""

import gc
import shutil
import weakref

from paraview.simple import *

from pluginsupport import *

PACKAGE = "adaptivehilbertdelaunay"
FOLDER = os.path.dirname(PLUGIN)
PROXIES = ("Delaunay2DAdaptiveHilbert", "VoronoiCells2DAdaptiveHilbert", "InsertionOrder2DAdaptiveHilbert",
           "AdaptiveHilbertDelaunay2D", "AdaptiveHilbertInterpolation2D", "PlanarPointSource",
           "AdaptiveHilbertQualityMesh2D", "PlanarSurfaceOutline")
SAYS = "Adaptive Hilbert Delaunay 2D is not there"


class NoInstalledPackage:
    """Makes Python find no package of this name, though one may be installed."""

    def find_spec(self, name, *_):
        if name == PACKAGE:
            raise ModuleNotFoundError("No module named %r" % name)


def load(path):
    """Prints which proxies are there, whether the filter works, and whether Python's path has changed."""
    import paraview.simple

    before = list(sys.path)
    sys.meta_path.insert(0, NoInstalledPackage())
    compiled = os.environ.get("AHD_COMPILED_FIRST")
    if compiled:
        LoadPlugin(compiled, remote=False, ns=vars(paraview.simple))
    LoadPlugin(path, remote=False, ns=vars(paraview.simple))
    found = [name for name in PROXIES if hasattr(paraview.simple, name)]
    print("found:", *found)
    if "AdaptiveHilbertDelaunay2D" in found:
        surface = paraview.simple.AdaptiveHilbertDelaunay2D(Input=Plane(XResolution=3, YResolution=3))
        print("triangles:", measures(surface)["NumberOfTriangles"], surface.SMProxy.GetVTKClassName())
    print("path unchanged:", sys.path == before)


def load_elsewhere(path, **environment):
    """The output of load() in a process that finds no package by itself."""
    command = [os.environ["AHD_PVPYTHON"], "--dr", os.path.abspath(__file__), "load", path]
    status, printed = run(command, **environment)
    check_equal(status, 0, "exit status after loading " + path)
    check("Traceback" not in printed, "loading %s shows a traceback" % path)
    check("path unchanged: True" in printed, "loading %s changes Python's path" % path)
    return printed


def folder(name, start=None):
    """A new folder with a copy of the plugin, and beside it a package that begins with these lines. Returns the path of
    the plugin."""
    place = scratch(name)
    shutil.rmtree(place, ignore_errors=True)
    os.makedirs(place)
    if start is not None:
        os.makedirs(os.path.join(place, PACKAGE))
        with open(os.path.join(place, PACKAGE, "__init__.py"), "w") as file:
            file.write(start)
    return shutil.copy(PLUGIN, place)


def test_it_is_made_of_the_xml():
    sys.path.append(os.environ["AHD_MAKE_PLUGIN"])
    import make_plugin

    with open(PLUGIN, encoding="utf-8") as file:
        check(file.read() == make_plugin.plugin(), "the plugin is not what make_plugin.py makes: build it anew")


def test_it_lies_in_the_package():
    printed = load_elsewhere(PLUGIN)
    found = [name for name in PROXIES if name in globals()]
    check("found: %s\n" % " ".join(found) in printed, "the package around it is not found")
    check("triangles: 18 " in printed, "the filter does not run")


def test_the_package_says_where_it_is():
    status, printed = run(["python3", "-m", PACKAGE, "--paraview-plugin"], PYTHONPATH=os.path.dirname(FOLDER))
    check_equal((status, printed), (0, PLUGIN + "\n"), "what the package says")


def test_the_package_lies_beside_it():
    path = folder("beside")
    os.symlink(FOLDER, os.path.join(os.path.dirname(path), PACKAGE))
    check("triangles: 18 " in load_elsewhere(path), "the package beside it is not found")


def check_refusal(printed, *pieces):
    check("found:\n" in printed, "there is a filter that cannot work")
    check("Failed to load" not in printed, "ParaView complains, too")
    lines = [line for line in printed.splitlines() if SAYS in line]
    check_equal(len(lines), 1, "messages")
    for piece in pieces + ("unzip the wheel",):
        check(piece in lines[0], "%r is not in the message %r" % (piece, lines[0]))


def test_without_the_package():
    path = folder("alone")
    check_refusal(load_elsewhere(path), PACKAGE, os.path.dirname(path), "No module named")


def test_a_package_that_cannot_be_used():
    check_refusal(load_elsewhere(folder("broken", "raise ImportError('made for another VTK')")), "made for another VTK")
    check_refusal(load_elsewhere(folder("empty", "")), "vtkAdaptiveHilbertDelaunay2D")


def test_a_package_without_the_source_of_points():
    start = (
        "import sys; sys.path.append(%r)\nimport %s_all as all_of_it\nsys.path.pop()\n"
        "vtkAdaptiveHilbertDelaunay2D = all_of_it.vtkAdaptiveHilbertDelaunay2D\n"
    )
    path = folder("part", start % (scratch("part"), PACKAGE))
    os.symlink(FOLDER, os.path.join(os.path.dirname(path), PACKAGE + "_all"))
    printed = load_elsewhere(path)
    check("found: %s\n" % " ".join(PROXIES[:4]) in printed, "a source that is not in the package is there")
    check("triangles: 18 " in printed, "the filter does not run")


def test_beside_the_compiled_plugin():
    if "AHD_COMPILED" not in os.environ:
        print("left out: there is no compiled plugin")
        return
    printed = load_elsewhere(PLUGIN, AHD_COMPILED_FIRST=os.environ["AHD_COMPILED"])
    check_equal(printed.count("is loaded already"), 1, "messages of the second plugin")
    check("triangles: 18 vtkAdaptiveHilbertDelaunay2D" in printed, "the compiled filter was replaced")


def driven(**settings):
    """A filter with 90,000 points, and its driver."""
    surface = AdaptiveHilbertDelaunay2D(Input=Plane(XResolution=299, YResolution=299), **settings)
    return surface, surface.GetClientSideObject()


def test_progress():
    surface, driver = driven()
    seen = []
    driver.AddObserver("ProgressEvent", lambda *_: seen.append(driver.GetProgress()))
    surface.UpdatePipeline()
    check(len(seen) > 5, "it told its progress %d times" % len(seen))
    check(seen == sorted(seen) and seen[-1] == 1.0, "progress goes like this: %r" % seen)


def test_abort():
    surface, driver = driven()
    tag = driver.AddObserver("ProgressEvent", lambda *_: driver.SetAbortExecute(1))
    surface.UpdatePipeline()
    check_equal(driver.GetOutputDataObject(0).GetNumberOfCells(), 0, "triangles after an abort")
    driver.RemoveObserver(tag)
    driver.SetAbortExecute(0)
    surface.Nmax = 60
    check_equal(measures(surface)["NumberOfTriangles"], 2 * 299 * 299, "triangles of the next run")
    check_equal(driver.GetOutputDataObject(0).GetNumberOfCells(), 2 * 299 * 299, "cells of the next run")


def test_settings_of_the_same_value_change_nothing():
    surface, driver = driven()
    surface.UpdatePipeline()
    before = driver.GetMTime()
    driver.SetNmax(driver.GetNmax())
    check_equal(driver.GetMTime(), before, "time of the last change, as nothing was changed")
    driver.SetNmax(driver.GetNmax() + 1)
    check(driver.GetMTime() > before, "a change is not noticed")


def test_nothing_is_kept():
    """Neither the data between runs, nor the filter once ParaView has released it."""
    surface, driver = driven()
    surface.UpdatePipeline()
    for port in (0, 1, 2):
        check_equal(driver._worker.GetOutputDataObject(port).GetNumberOfPoints(), 0, "points kept of port %d" % port)
    given = driver._inputs[0].GetOutputDataObject(0)
    check_equal(given.GetNumberOfElements(given.POINT), 0, "points kept of the input")
    worker, driver = weakref.ref(driver._worker), None
    Delete(surface)
    del surface
    gc.collect()
    check(worker() is None, "the filter is there when ParaView has let it go")


if len(sys.argv) > 2:
    load(sys.argv[2])
else:
    LoadPlugin(PLUGIN, remote=False, ns=globals())
    for name, test in sorted(globals().items()):
        if name.startswith("test_"):
            test()
            print("passed:", name)
