# SPDX-License-Identifier: BSD-3-Clause
"""The filter in a VTK pipeline, without ParaView's server manager.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 pipeline.py [surface.vtp]

Runs in pvpython and pvbatch too. The package works with the VTK it was built with and no other.
"""

import sys

import numpy
from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

# A hill, sampled at random. One sample is there twice and one has no place.
samples = numpy.random.default_rng(1).uniform(-1, 1, (10000, 3))
samples[:, 2] = numpy.exp(-3 * (samples[:, 0] ** 2 + samples[:, 1] ** 2))
samples[77] = samples[7]
samples[99, 0] = numpy.nan

points = vtkPoints()
points.SetData(numpy_to_vtk(samples, deep=True))  # float64; float32 is taken as it is, too
cloud = vtkPolyData()
cloud.SetPoints(points)

delaunay = vtkAdaptiveHilbertDelaunay2D()
delaunay.SetInputData(cloud)
delaunay.GeneratePointStatusOn()  # adds the point array "Fate"
delaunay.Update()  # warns of the point without a place
surface = delaunay.GetOutput()

status = vtk_to_numpy(surface.GetPointData().GetArray("Fate"))
corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
print("%d triangles on %d points" % (surface.GetNumberOfPolys(), delaunay.GetNumberOfPointsInserted()))
print("point 77 is", status[77], "again; point 99 is", "rejected" if status[99] == -1 else "used")

# Points, their ids and their data are the input's: corners index `samples`.
a, b, c = (samples[corners[:, i]] for i in range(3))
area = 0.5 * ((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0]))
volume = (area * (a[:, 2] + b[:, 2] + c[:, 2]) / 3).sum()
print("every triangle counterclockwise:", bool((area > 0).all()))
print("volume below the surface: %.3f" % volume)

if len(sys.argv) > 1:
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetDataModeToBinary()  # VTK 9.2 cannot read its default, appended data, with newer libexpat
    writer.SetInputData(surface)
    writer.Write()
