# SPDX-License-Identifier: BSD-3-Clause
"""What demo.sh runs in pvbatch: points in, a triangulated surface and a picture out.

    pvbatch demo.py --plugin AdaptiveHilbertDelaunay.so [file] [options]   (see demo.sh --help)

Exit code 2 for a file or an option that cannot be used, 1 for all else that goes wrong.
"""

import argparse
import math
import os
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy

import conversion
import nodata
import pointfiles
import raster
import results as written
from conversion import VTK_FILES
from pointfiles import InputError, PointSet, thousands

SAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data", "survey.csv")


class Arguments(argparse.ArgumentParser):
    def error(self, message):
        raise InputError(message + "; --help lists the options")


def parse_arguments(words):
    parser = Arguments(prog="demo.sh", add_help=False, allow_abbrev=False)
    parser.add_argument("file", nargs="?", default=os.path.normpath(SAMPLE))
    for axis in "xyz":
        parser.add_argument("--" + axis, metavar="COLUMN")
    parser.add_argument("--columns", metavar="X,Y,Z")
    parser.add_argument("--output", metavar="DIR", required=True)
    parser.add_argument("--own-output", action="store_true")  # nobody else writes into that folder
    parser.add_argument("--exaggeration", type=float, metavar="FACTOR")
    parser.add_argument("--edges", action="store_true")
    parser.add_argument("--nodata", type=float, metavar="NUMBER")
    parser.add_argument("--simplify", type=float, metavar="ERROR", default=0.0)
    raster.add_options(parser)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--plugin", metavar="FILE")
    chosen = parser.parse_args(words)
    columns = [chosen.x, chosen.y, chosen.z]
    if chosen.columns:
        if any(columns):
            parser.error("--columns and --x, --y, --z exclude each other")
        columns = [name.strip() or None for name in chosen.columns.split(",")]
        if not 2 <= len(columns) <= 3:
            parser.error("--columns takes two or three names or numbers with commas between")
        columns += [None] * (3 - len(columns))
    chosen.columns = tuple(columns)
    if chosen.exaggeration is not None and not (chosen.exaggeration > 0 and math.isfinite(chosen.exaggeration)):
        parser.error("--exaggeration must be greater than 0 and finite")
    if not (chosen.simplify >= 0 and math.isfinite(chosen.simplify)):
        parser.error("--simplify must be 0 or more and finite")
    raster.check(chosen, parser)
    check_file(chosen)
    check_output(chosen)
    return chosen


def check_file(chosen):
    ending = os.path.splitext(chosen.file)[1].lower()
    known = pointfiles.TABLES + pointfiles.LAS + VTK_FILES
    if os.path.isdir(chosen.file):
        raise InputError("%s is a directory, not a file" % chosen.file)
    if not os.path.isfile(chosen.file):
        raise InputError("no such file: %s" % chosen.file)
    if not os.access(chosen.file, os.R_OK):
        raise InputError("no permission to read %s" % chosen.file)
    if ending not in known:
        raise InputError("%s: unknown kind of file; known are %s" % (chosen.file, " ".join(known)))
    if any(chosen.columns) and ending not in pointfiles.TABLES:
        raise InputError("columns can be chosen in tables only (%s)" % " ".join(pointfiles.TABLES))
    if chosen.nodata is not None and ending in VTK_FILES:
        raise InputError("--nodata is for tables and lidar only (%s)" % " ".join(pointfiles.TABLES + pointfiles.LAS))


def stem(chosen):
    """The results without their endings."""
    return os.path.join(chosen.output, os.path.splitext(os.path.basename(chosen.file))[0])


def results(chosen):
    """Where the surface, the picture and the rasters are written."""
    return (stem(chosen) + ".vtp", stem(chosen) + ".png", *raster.results(chosen, stem(chosen)))


def folder(chosen):
    return written.Folder(chosen.output, chosen.own_output)


def check_output(chosen):
    """Raises InputError unless the results can be written; makes the folder for them."""
    try:
        os.makedirs(chosen.output, exist_ok=True)
    except OSError as error:
        raise InputError("--output %s cannot be a folder: %s" % (chosen.output, error.strerror)) from error
    try:
        tempfile.TemporaryFile(dir=chosen.output).close()
    except OSError as error:
        raise InputError("nothing can be written in --output %s: %s" % (chosen.output, error.strerror)) from error
    for path in results(chosen):
        if os.path.isdir(path):
            raise InputError("%s cannot be written: it is a directory" % path)
        if os.path.exists(path) and not os.access(path, os.W_OK):
            raise InputError("no permission to write %s" % path)
        if os.path.exists(path) and os.path.samefile(path, chosen.file):
            raise InputError("the result would take the place of %s; choose another folder with --output" % path)
    folder(chosen).check(results(chosen))


# --- what needs ParaView ------------------------------------------------------------------------


def read_vtk(path):
    """(source proxy, PointSet) of a file that VTK reads."""
    from paraview.vtk.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    with tempfile.TemporaryDirectory(prefix="demo-") as folder:
        made = os.path.join(folder, "points.vtp")
        kind = conversion.convert(path, made)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(made)
        reader.Update()
    data = reader.GetOutput()
    xyz = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return producer(data), PointSet(xyz, ("x", "y", "z"), [kind], 0, True)


def read_laz(path):
    """PointSet of a compressed LAS file."""
    with tempfile.TemporaryDirectory(prefix="demo-") as folder:
        made = os.path.join(folder, "points.las")
        conversion.convert(path, made)
        points = pointfiles.read_points(made)
        return points._replace(xyz=numpy.array(points.xyz))  # not of a file that goes


def make_source(points):
    """A source proxy that gives the points to the pipeline."""
    from paraview.vtk.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(numpy.ascontiguousarray(points.xyz), deep=1))
    data = vtkPolyData()
    data.SetPoints(vtk_points)
    return producer(data)


def producer(data):
    """A source proxy that gives a data set to the pipeline."""
    from paraview import simple

    source = simple.TrivialProducer(registrationName="points")
    source.GetClientSideObject().SetOutput(data)
    return source


def triangulate(source, plugin, error):
    """The filter's proxy after a timed run, its surface within an error of all points (0: of all), and NP and NR
    counted in a second run: counting takes time that is not the filter's."""
    # before the filter exists, so that Python knows its class
    from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D
    from paraview import servermanager, simple
    from vtkmodules.vtkCommonCore import vtkObject

    if not hasattr(simple, "AdaptiveHilbertDelaunay2D"):
        simple.LoadPlugin(plugin, remote=False)
    proxy = simple.AdaptiveHilbertDelaunay2D(Input=source, MaximumError=error, GeneratePointStatus=int(error > 0))
    proxy.UpdatePipeline()
    engine = proxy.GetClientSideObject()
    assert isinstance(engine, vtkAdaptiveHilbertDelaunay2D)
    measures = {name: getattr(engine, "Get" + name)() for name in (
        "NumberOfPointsInserted", "NumberOfDuplicates", "NumberOfRejectedPoints",
        "NumberOfSkippedPoints", "NumberOfPointsWithinError", "LargestError", "NumberOfTriangles", "SortSeconds",
        "InsertSeconds", "OutputSeconds")}
    if error > 0:  # its points alone; Fate has their ids
        proxy = simple.Clean(Input=proxy, PointMerging=0)
    surface = servermanager.Fetch(proxy)
    # without a proxy: ParaView switches warnings on for as long as it updates one
    counter = vtkAdaptiveHilbertDelaunay2D()
    counter.SetInputData(source.GetClientSideObject().GetOutputDataObject(0))
    counter.SetMaximumError(error)
    counter.CountWorkOn()
    vtkObject.GlobalWarningDisplayOff()  # the first run has said it all
    counter.Update()
    vtkObject.GlobalWarningDisplayOn()
    measures.update(NP=counter.GetNP(), NR=counter.GetNR())
    return proxy, surface, measures


def report(points, measures):
    """What the filter did, for people."""
    seconds = [measures[phase + "Seconds"] for phase in ("Sort", "Insert", "Output")]
    lines = [
        ("points", thousands(len(points.xyz))),
        ("triangles", thousands(measures["NumberOfTriangles"])),
        ("duplicates", thousands(measures["NumberOfDuplicates"]) + " (same x and y as another point)"),
        ("rejected", thousands(measures["NumberOfRejectedPoints"]) + " (x or y not finite)"),
        ("seconds", "%.3f = %.3f sort + %.3f insert + %.3f output" % tuple([sum(seconds)] + seconds)),
        ("NP", "%.2f (triangles visited to find the place of a point, on average)" % measures["NP"]),
        ("NR", "%.2f (triangles replaced per point, on average)" % measures["NR"]),
    ]
    if measures["NumberOfSkippedPoints"]:
        lines.insert(4, ("skipped", thousands(measures["NumberOfSkippedPoints"]) + " (ghost or hidden)"))
    if measures["NumberOfPointsWithinError"]:
        lines.insert(1, ("left out", "%s (the surface differs from them by %.6g at most)" % (
            thousands(measures["NumberOfPointsWithinError"]), measures["LargestError"])))  # fmt: skip
    if points.bad_rows:
        lines.insert(1, ("unreadable", thousands(points.bad_rows) + " (not among the points)"))
    for name, value in lines:
        print("  %-11s %s" % (name, value))


def write_picture(surface, points, chosen, path):
    import picture

    scale = picture.choose_scale(points.xyz, points.names, chosen.exaggeration)
    unit = "" if scale.geographic else " (taking x, y and z to be in one unit)"
    told = "vertical exaggeration %g%s" % (scale.exaggeration, unit)
    if scale.low == scale.high:
        told = "flat: z is %g" % scale.low
    odd = int(numpy.isinf(points.xyz[:, 2]).sum() + numpy.isnan(points.xyz[:, 2]).sum())
    if odd:
        told += "; %s points without a finite z drawn at the bottom" % thousands(odd)
    title = (
        os.path.basename(chosen.file),
        "%s points, %s triangles" % (thousands(len(points.xyz)), thousands(surface.GetNumberOfPolys())),
        told,
    )
    picture.draw(surface, scale, points.names[2], title, path, chosen.edges)
    return told


def read(chosen):
    """(source proxy, PointSet) of the file."""
    if os.path.splitext(chosen.file)[1].lower() in VTK_FILES:
        return read_vtk(chosen.file)
    if chosen.file.lower().endswith(".laz") and pointfiles.is_compressed(chosen.file):
        points = read_laz(chosen.file)
    else:
        points = pointfiles.read_points(chosen.file, chosen.columns)
    points = nodata.without(points, chosen.nodata) if chosen.nodata is not None else points
    return make_source(points), points


def run(chosen):
    print("Reading %s" % chosen.file, flush=True)
    source, points = read(chosen)
    few = raster.check_unit(points, chosen.raster) if chosen.raster else []
    for note in points.notes + nodata.notes(points) + few:
        print("  " + note)
    print("Triangulating", flush=True)
    proxy, surface, measures = triangulate(source, chosen.plugin, chosen.simplify)
    report(points, measures)
    vtp, png, *rasters = results(chosen)
    own = folder(chosen)
    own.remove(stem(chosen) + ending for ending in (".vtp", ".png", *raster.ENDINGS))  # nothing old beside this surface
    save_surface(proxy, vtp)
    own.add(vtp)
    if surface.GetNumberOfPolys() == 0:
        raise InputError("no triangle, so no picture: all points lie on one line, or there are fewer than three")
    if rasters:
        for path in raster.run(proxy.GetClientSideObject().GetOutputDataObject(0), chosen, rasters):
            check_written(path)
            own.add(path)
    told = write_picture(surface, points, chosen, png)
    check_written(png)
    own.add(png)
    print("Picture  %s\n         %s" % (png, told))


def save_surface(proxy, path):
    from paraview import simple

    # not appended, see appended_data_hint
    simple.SaveData(path, proxy=proxy, DataMode="Binary", CompressorType="ZLib")
    check_written(path)
    print("Surface  %s" % path)


def check_written(path):
    if not os.path.isfile(path) or os.path.getsize(path) == 0:
        raise OSError("%s could not be written; is the disk full?" % path)


def main():
    try:
        chosen = parse_arguments(sys.argv[1:])
        if not chosen.check:
            run(chosen)
    except InputError as error:
        sys.stdout.flush()
        print("demo: %s" % error, file=sys.stderr)
        return 2
    except OSError as error:
        print("demo: %s" % error, file=sys.stderr)
        return 1
    except MemoryError:
        print("demo: out of memory; take fewer points, or a larger cell of the raster", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    code = main()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)  # pvbatch does not pass on the code of sys.exit
