# SPDX-License-Identifier: BSD-3-Clause
"""Points of files that are read by a library which may not survive a bad one, in a process of its own.

convert(path, made) has this file run as a program. That writes the points to `made`, in a form that can be
trusted: of what VTK reads as .vtp, of a compressed LAS file as an uncompressed one. A file that cannot be used
raises InputError, whether the program says so or dies.
"""

import os
import re
import resource
import signal
import subprocess
import sys

sys.dont_write_bytecode = True

import plyheader
from pointfiles import InputError

VTK_FILES = (".vtk", ".vtp", ".vtu", ".ply")
PYTHON = "/usr/bin/python3"  # not pvbatch, which would start MPI once more


def convert(path, made):
    """Writes the points of the file to `made`, and gives what the file holds, in a word."""
    if path.lower().endswith(".ply"):
        plyheader.check(path)
    command = [PYTHON, os.path.abspath(__file__), path, made]
    done = subprocess.run(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        errors="replace", check=False)  # fmt: skip
    if done.returncode == 0:
        return done.stdout.strip()
    if done.returncode == 2:
        raise InputError(done.stdout.strip())
    raise InputError("%s cannot be read: its reader %s%s" % (path, ending(done.returncode), reason(done.stderr)))


def ending(code):
    """How a process ended, for people."""
    if code >= 0:
        return "stopped with exit code %d" % code
    if -code == signal.SIGXCPU:
        return "came to no end"
    return "was stopped by %s" % signal.Signals(-code).name


def reason(said):
    """The first error among what VTK said, else its last line."""
    lines = [line for line in said.splitlines() if line.strip() and "Assertion" not in line]
    error = first_error(said, r"ERR\|[^\n]*?0x[0-9a-f]+\): *([^\n]*)") or printable("".join(lines[-1:]))
    return ", saying: " + error if error else ""


def first_error(said, pattern):
    """The first match that says what went wrong, fit for a line, or ""."""
    nothing_new = ("Algorithm ", "No Points element")
    found = [error for error in re.findall(pattern, said) if not error.startswith(nothing_new)]
    return printable(found[0]) if found else ""


def printable(text):
    text = re.sub("\x1b\\[[0-9;]*m", "", text)  # colours
    return "".join(c if c.isprintable() else "?" for c in text).strip()[:200]


# --- in the process of its own ------------------------------------------------------------------


def make_reader(path):
    from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

    kinds = (vtkGenericDataObjectReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader, vtkPLYReader)
    reader = dict(zip(VTK_FILES, kinds))[os.path.splitext(path)[1].lower()]()
    if hasattr(reader, "CanReadFile") and not reader.CanReadFile(path):
        raise InputError("ParaView cannot read %s" % path)
    reader.SetFileName(path)
    return reader


def read_vtk(path):
    """The data set in a file of VTK's. Points that come with an error are not used."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    reader = make_reader(path)
    reader.Update()
    data = reader.GetOutputDataObject(0)
    said = window.GetOutput()
    said = said.decode("utf-8", errors="replace") if isinstance(said, bytes) else said
    # that an ASCII file ends early is only a warning, and numbers of nothing follow
    error = first_error(said, r"(?:ERROR: .*\n.*?\): *|Generic Warning: .*\n(?=Error ))(.*)")
    if data is None:
        raise InputError("ParaView cannot read %s" % path)
    if not data.IsA("vtkPointSet") and not error:
        raise InputError("%s holds %s; a data set with points of its own is needed" % (path, data.GetClassName()))
    is_empty = data.GetNumberOfElements(data.POINT) == 0
    hint = appended_data_hint(path) if is_empty else ""
    if error and not hint:
        raise InputError("ParaView cannot read %s: %s" % (path, error))
    if is_empty:
        raise InputError("%s holds no points%s" % (path, hint))
    return data


def appended_data_hint(path):
    """Whether the file is one that ParaView 5.11 (VTK 9.2) writes and yet cannot read: with their data
    appended, the default, it fails on XML files since libexpat changed when it reports what it has
    read (2.6; in Debian 12 since 2.5.0-1+deb12u2, a security update)."""
    with open(path, "rb") as file:
        if b"<AppendedData" not in file.read(1 << 20):
            return ""
    return (
        " that ParaView can read here: its data is appended, which ParaView 5.11 cannot read with newer"
        "\nversions of libexpat. Save it again with the data mode Binary or Ascii, or as legacy .vtk"
    )


def write_points(data, made):
    """The points, their data and the field data, which are all that the filter passes on."""
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    points = vtkPolyData()
    points.SetPoints(data.GetPoints())
    points.GetPointData().ShallowCopy(data.GetPointData())
    points.GetFieldData().ShallowCopy(data.GetFieldData())
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(made)
    writer.SetInputData(points)
    writer.SetDataModeToBinary()  # not appended, see appended_data_hint
    writer.SetCompressorTypeToNone()
    if writer.Write() != 1 or writer.GetErrorCode():
        raise OSError("%s cannot be written; is the disk full?" % made)


def unpack_las(path, made):
    """Writes a compressed LAS file as an uncompressed one."""
    try:
        import laspy
    except ImportError:
        laspy = None
    if not (laspy and laspy.LazBackend.Lazrs.is_available()):
        raise InputError("%s is compressed; laspy and lazrs, which demo.sh installs to unpack it, are missing" % path)
    try:
        with laspy.open(path) as packed, laspy.open(made, mode="w", header=packed.header) as plain:
            for points in packed.chunk_iterator(1 << 20):
                plain.write_points(points)
    except OSError:
        raise
    except BaseException as error:  # what goes wrong in lazrs, which is made of Rust, is no Exception
        raise InputError("%s is damaged: %s" % (path, printable(str(error)))) from error


def limit(path):
    """Ends this process where a file promises too much, or its reader runs in circles."""
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    seconds = 60 + (os.path.getsize(path) >> 19)  # readers take a tenth of a second for a mebibyte of text
    limits = ((resource.RLIMIT_CORE, 0), (resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, seconds))
    for kind, most in limits:
        resource.setrlimit(kind, (most, resource.getrlimit(kind)[1]))


def main(path, made):
    limit(path)
    sys.stdout.reconfigure(errors="replace")
    try:
        if made.endswith(".las"):
            unpack_las(path, made)
        else:
            data = read_vtk(path)
            write_points(data, made)
            print(data.GetClassName())
    except InputError as error:
        print(error)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
