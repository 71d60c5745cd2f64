# SPDX-License-Identifier: BSD-3-Clause
"""The quality mesh of the world of pipelines: of the input, or of the output of the filter that triangulates."""

from pipelinedata import QualityMesh, copy_of, dump
from worlds import Rubbish, expect_same, step

MESH = {"MinimumAngle": (20.0, 0.0, 30.0), "MaximumLength": (0.0, 0.0, 0.3), "SizeArrayName": ("", "", "h")}


class WithMesh:
    """Mixed into Pipelines."""

    def __init__(self):
        super().__init__()
        self.mesh, self.meshed = QualityMesh(), {"MaximumNumberOfAddedPoints": 100}
        self.hasMesh = False  # was one made?

    def _connect_mesh(self):
        if self.route == "data":
            self.mesh.SetInputDataObject(0, self.data)
        else:
            self.mesh.SetInputConnection(0, (self.stream if self.route == "stream" else self.surface).GetOutputPort(0))

    def _apply_mesh(self):
        self._set_mesh(self.mesh)
        self.mesh.SetSourceData(self.source if self.route != "surface" else None)

    def _set_mesh(self, mesh):
        self._set_triangulation(mesh.GetTriangulation())
        for name, value in self.meshed.items():
            getattr(mesh, "Set" + name)(value)

    def _check_mesh(self):
        surface, new = self._new()[0], QualityMesh()
        self._set_mesh(new)
        if self.route == "surface":
            new.SetInputConnection(0, surface.GetOutputPort(0))
        else:
            new.SetInputDataObject(0, surface.GetInputDataObject(0, 0))
            if self.source is not None:
                new.SetSourceData(copy_of(self.source))
        new.Update()
        for port in range(2):
            found, wanted = self.mesh.GetOutputDataObject(port), new.GetOutputDataObject(port)
            expect_same("mesh, port %d" % port, dump(found), dump(wanted))

    @step(5)
    def update_mesh(self, rng):
        self.hasMesh = True
        if self.route != "stream" and rng.random() < 0.5:
            self.data.Modified()
            self.isCurrent = False
        self._bring_up_to_date(self.mesh, rng)
        self._check_mesh()
        if rng.random() < 0.3:
            self._hold(self.mesh.GetOutput())

    @step(2)
    def set_mesh(self, rng):
        name = rng.choice(list(MESH))
        self.meshed[name] = rng.choice(MESH[name])
        self._apply()

    @step(1)
    def new_mesh(self, rng):
        self.mesh = QualityMesh()
        Rubbish.collect(rng)
        self._connect()
        self._apply()
