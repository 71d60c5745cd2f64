# SPDX-License-Identifier: BSD-3-Clause
"""vtkPlanarPointSource in Python."""

import numpy

from .. import _library as engine
from . import settings
from .arrays import new_array
from .execution import Progress
from .messages import Speaker, refusal
from .planar import PlanarPoints
from .vtkclass import build

NAMES = ("vtkPlanarPointSource", "vtkPolyDataAlgorithm")
PIECE = 1 << 14  # points made between two askings whether to abort

ABOUT = """The point sets that triangulations are compared on.

Points of the plane z = 0, or on hills, and one VTK_POLY_VERTEX cell with all of them: the distributions of Su et al.,
Computers & Graphics 54 (2016) 65-74, figure 10, and a lattice. The points are a function of the settings, to the last
bit; the same as those of the compiled class, which is faster.
"""


class _Making:
    """How RequestData goes; mixed into the class."""

    def RequestData(self, _request, _inputs, outputs):
        """Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more."""
        output = self._backend.vtkPolyData.GetData(outputs, 0)
        count = self._values["NumberOfPoints"]
        say = Speaker(self._backend, self).error
        single = self._values["OutputPointsPrecision"] == 0
        needed, available = count * (16 if single else 28) // 1024, engine.available_memory() // 1024
        if needed > available:
            say(refusal(reason=engine.MEMORY_LIMIT, doing="making", points=count, memory_estimate=needed,
                        memory_allowed=available))
            return 1
        try:
            if not self._make(output, count, single):
                output.Initialize()
        except MemoryError:
            output.Initialize()
            say(refusal(reason=engine.OUT_OF_MEMORY, doing="making", points=count))
        return 1

    def _make(self, output, count, single):
        """False if aborted: then the output is not complete."""
        vtk, progress = self._backend, Progress(self)
        data, xyz = new_array(vtk.vtkFloatArray if single else vtk.vtkDoubleArray, count, 3)
        maker = PlanarPoints(self._values["Distribution"], count, self._values["Seed"])
        height, scale = self._values["HillHeight"], self._values["Scale"]
        for begin in range(0, count, PIECE):
            if progress(None, begin / count):
                return False
            piece = xyz[begin:begin + PIECE]
            x, y = maker.next(len(piece))
            z = height * maker.hills_at(x, y) if height > 0 else 0.0
            piece[:, 0], piece[:, 1], piece[:, 2] = scale * x, scale * y, scale * z
        points = vtk.vtkPoints()
        points.SetData(data)
        output.SetPoints(points)
        if count:
            offsets, ids = new_array(vtk.vtkTypeInt32Array, 2), new_array(vtk.vtkTypeInt32Array, count)
            offsets[1][:] = 0, count
            ids[1][:] = numpy.arange(count, dtype=numpy.int32)
            cells = vtk.vtkCellArray()
            cells.SetData(offsets[0], ids[0])
            output.SetVerts(cells)
        return True

    def PrintSelf(self):
        """The settings, as text."""
        return "".join(
            "  %s: %s\n" % (setting.name, setting.text(self._values[setting.name])) for setting in settings.SOURCE)


def make_class(backend):
    """The class over this VTK."""

    def start(self):
        self._values = {setting.name: setting.default for setting in settings.SOURCE}

    members = {"__doc__": ABOUT}
    members.update((name.upper(), value) for value, name in enumerate(settings.SOURCE[0].names))
    for setting in settings.SOURCE:
        members.update(settings.methods_of(setting))
    made = build(backend, NAMES, (_Making,), members, start, (0, 1))
    for name, member in settings.properties_of(made, [setting.name for setting in settings.SOURCE]).items():
        setattr(made, name, member)
    return made
