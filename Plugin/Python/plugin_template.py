# SPDX-License-Identifier: BSD-3-Clause
"""Adaptive Hilbert Delaunay 2D in ParaView, without compiling: load this file by Tools > Manage Plugins.

ParaView 5.11 to 6.1. The Python package adaptivehilbertdelaunay does the computation. It is looked for
beside this file, then around it (this file lies in the package), then where Python finds packages. On a server
this file and the package have to be there; on the client load this file too, so that its panel is up to date.

Menus, panel, help texts and ports are those of the compiled plugin, of whose XML this file was made. Load one of
the two plugins, not both.
"""

import functools
import importlib
import importlib.util
import os
import sys
import weakref

import numpy
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager
from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smproperty, smproxy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataSetAttributes,
    vtkImageData,
    vtkPolyData,
    vtkStructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import (
    vtkAlgorithm,
    vtkStreamingDemandDrivenPipeline,
    vtkTrivialProducer,
)
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.util.numpy_support import vtk_to_numpy

# Replaced by that file: a plugin in Python is one.
from plugin_client import (
    RASTER,
    _data_are_elsewhere,
    _is_client,
    _is_compiled_one_loaded,
    _was_registered,
    _was_unregistered,
)

# Made of AdaptiveHilbertDelaunay.xml by make_plugin.py, which replaces the values of these names.
VERSION = "0"
#: (group, tag, attributes, what stands inside) of each proxy.
PROXIES = []

paraview_plugin_name = "AdaptiveHilbertDelaunayPython"
paraview_plugin_version = VERSION

PACKAGE = "adaptivehilbertdelaunay"
HERE = os.path.dirname(os.path.abspath(__file__))

# --- The package ---------------------------------------------------------------------------------


def _import_package():
    """Imports the package, where it lies beside or around this file without a change of Python's path."""
    if PACKAGE in sys.modules:
        return sys.modules[PACKAGE]
    for place in (HERE, os.path.dirname(HERE)):
        start = os.path.join(place, PACKAGE, "__init__.py")
        if not os.path.isfile(start):
            continue
        spec = importlib.util.spec_from_file_location(PACKAGE, start)
        module = importlib.util.module_from_spec(spec)
        sys.modules[PACKAGE] = module
        try:
            spec.loader.exec_module(module)
        except Exception:
            del sys.modules[PACKAGE]
            raise
        return module
    return importlib.import_module(PACKAGE)


def _vtk_class(name):
    """The package's class of this name. AttributeError or ImportError if there is none."""
    return getattr(_import_package(), name)


def _has(name):
    try:
        return bool(_vtk_class(name))
    except (AttributeError, ImportError):
        return False


def _what_is_wrong():
    """Why there is nothing to compute with, and what to do, as one message. Empty if all is well."""
    try:
        _vtk_class("vtkAdaptiveHilbertDelaunay2D")
        return ""
    except Exception as error:  # whatever is wrong with the package, ParaView goes on
        reason = "%s: %s" % (type(error).__name__, error)
    return (
        "Adaptive Hilbert Delaunay 2D is not there: the Python package %s cannot be used (%s). It was looked for in "
        "%s, in %s and on Python's path (%s). What to do: unzip the wheel, %s-....whl, in %s, or install it for "
        "ParaView's Python %d.%d; then start ParaView again. (On a client it is not needed where a server has it.)"
        % (
            (PACKAGE, reason, HERE, os.path.dirname(HERE), ", ".join(filter(None, sys.path)), PACKAGE, HERE)
            + sys.version_info[:2]
        )
    )


# --- What runs where the data are ----------------------------------------------------------------


class _Driver(VTKPythonAlgorithmBase):
    """A filter or a source of the package, in the clothes that ParaView knows: it has the methods of the class
    `vtk_class` of the package, and its output is made by an object of it, `_worker`."""

    vtk_class = None

    def __init__(self):
        self._worker = _vtk_class(self.vtk_class)()
        if hasattr(self._worker, "SetController"):  # each rank its own points: the worker's outputs become these
            self._worker.SetController(None)
        ports = self._worker.GetNumberOfInputPorts()
        self._inputs = [None] * ports
        # Behind the worker's ports there is one more, which ParaView does not know: see SetTransform.
        self._ports = self._output_ports()
        super().__init__(nInputPorts=ports + 1, nOutputPorts=len(self._ports))
        self._worker.AddObserver("ProgressEvent", _call_weakly(self, "_pass_on_progress"))
        # VTK keeps what Python knows of an object for some time after Python, here ParaView, has let it go.
        weakref.finalize(self, self.__dict__.clear).atexit = False

    def _output_ports(self):
        """The worker's output ports that are this one's."""
        return list(range(self._worker.GetNumberOfOutputPorts()))

    def __getattr__(self, name):
        """Methods of the worker, or of the settings that are a part of it. What changes it changes this too."""
        worker = self.__dict__.get("_worker")
        if worker is None or not name.startswith(("Set", "Get")):
            raise AttributeError(name)
        has_it = hasattr(worker, name) or not hasattr(worker, "GetTriangulation")
        method = getattr(worker if has_it else worker.GetTriangulation(), name)
        if name.startswith("Get"):
            return method

        def set_it(*values):
            if name != "SetTransform":  # ParaView gives an empty text as None
                values = ["" if value is None else value for value in values]
            before = worker.GetMTime()
            method(*values)
            if worker.GetMTime() != before:
                self._follow_worker()

        return set_it

    def _follow_worker(self):
        for port in range(len(self._inputs)):  # MergeBlocks changes what an input may be
            self.GetInputPortInformation(port).Copy(self._worker.GetInputPortInformation(port), 1)
        self.Modified()

    def SetTransform(self, transform):
        """A transform changes without telling anybody. VTK asks a filter when it, or what it was given, was changed,
        but asks no code in Python: so the last input comes from a filter in C++ that has this transform."""
        asked = None
        if transform:
            nothing = vtkPolyData()
            nothing.SetPoints(vtkPoints())
            asked = vtkTransformPolyDataFilter()
            asked.SetInputData(nothing)
            asked.SetTransform(transform)
        self.SetInputConnection(len(self._inputs), asked.GetOutputPort() if asked else None)
        self.__getattr__("SetTransform")(transform)

    def FillInputPortInformation(self, port, info):
        if port < len(self._inputs):
            info.Copy(self._worker.GetInputPortInformation(port), 1)
        else:
            info.Set(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData")
            info.Set(vtkAlgorithm.INPUT_IS_OPTIONAL(), 1)
        return 1

    def FillOutputPortInformation(self, port, info):
        info.Copy(self._worker.GetOutputPortInformation(self._ports[port]), 1)
        return 1

    def ProcessRequest(self, *given):
        """Ctrl-C that ends the worker ends the request, and the next update runs."""
        request, interrupts = VTKPythonAlgorithmBase.ProcessRequest, sys.modules.get(PACKAGE + "._vtk.interrupts")
        return (interrupts.ends_by_ctrl_c(request) if interrupts else request)(self, *given)

    def RequestInformation(self, request, inInfo, outInfo):
        """A source says whether it makes pieces; a filter passes on what its input says."""
        if not self._inputs:
            self._worker.UpdateInformation()
            pieces = vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST()
            if self._worker.GetOutputInformation(0).Has(pieces):
                outInfo.GetInformationObject(0).Set(pieces, self._worker.GetOutputInformation(0).Get(pieces))
        return 1

    def RequestData(self, request, inInfo, outInfo):
        for port in range(len(self._inputs)):
            self._give(port, vtkDataObject.GetData(inInfo[port], 0))
        self._worker.SetAbortExecute(self.GetAbortExecute())  # after an abort, VTK does not do it
        if self._inputs:
            self._worker.Update()
        else:
            self._update_piece(outInfo.GetInformationObject(0))
        for port, of_worker in enumerate(self._ports):
            vtkDataObject.GetData(outInfo, port).ShallowCopy(self._worker.GetOutputDataObject(of_worker))
        for port in range(self._worker.GetNumberOfOutputPorts()):
            self._worker.GetOutputDataObject(port).Initialize()
        for producer in filter(None, self._inputs):
            producer.SetOutput(None)  # keeps no data alive
        return 1

    def _give(self, port, data):
        """Gives the worker this input; None: none. Its connections stay what they are as long as they can, as a
        change of them is a change of the worker, which would then triangulate again."""
        if data is None:
            if self._inputs[port]:
                self._worker.SetInputConnection(port, None)
            self._inputs[port] = None
            return
        copy = data.NewInstance()  # what the worker's pipeline writes on its input is none of ParaView's business
        copy.ShallowCopy(data)
        if not self._inputs[port]:
            self._inputs[port] = vtkTrivialProducer()
            self._inputs[port].SetOutput(copy)
            self._worker.SetInputConnection(port, self._inputs[port].GetOutputPort())
        self._inputs[port].SetOutput(copy)

    def _update_piece(self, info):
        """What ParaView asks a source for: one piece of many, on several ranks."""
        pipeline = vtkStreamingDemandDrivenPipeline
        keys = pipeline.UPDATE_PIECE_NUMBER, pipeline.UPDATE_NUMBER_OF_PIECES, pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS
        self._worker.UpdatePiece(*(info.Get(key()) if info.Has(key()) else key is keys[1] for key in keys))

    def _pass_on_progress(self):
        """Tells ParaView how far the worker is, and the worker whether it is to stop."""
        self.SetProgressText(self._worker.GetProgressText())
        self.UpdateProgress(self._worker.GetProgress())
        if self.GetAbortExecute() or (hasattr(self, "CheckAbort") and self.CheckAbort()):  # since VTK 9.3
            self._worker.SetAbortExecute(1)


class _OneOutput(_Driver):
    """vtkAdaptiveHilbertOneOutput2D: one of the outputs of vtkAdaptiveHilbertDelaunay2D."""

    def _output_ports(self):
        return [0]

    def SetShownPort(self, port):
        self._ports = [port]
        self.Modified()


class _Raster(_Driver):
    """The interpolation, whose output is an image, or of the kind of the places."""

    def RequestDataObject(self, request, inInfo, outInfo):
        places = vtkDataObject.GetData(inInfo[1], 0)
        if places is None and inInfo[1].GetNumberOfInformationObjects():
            return 0
        made = places.NewInstance() if places else (vtkStructuredGrid if self.GetOutputType() else vtkImageData)()
        now = vtkDataObject.GetData(outInfo, 0)
        if now is None or now.GetClassName() != made.GetClassName():
            outInfo.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), made)
            self.GetOutputPortInformation(0).Set(vtkDataObject.DATA_EXTENT_TYPE(), made.GetExtentType())
        return 1

    def RequestInformation(self, request, inInfo, outInfo):
        """The raster as it will be: the inputs say it, and are brought up to date for that."""
        info, source = outInfo.GetInformationObject(0), inInfo[1].GetInformationObject(0)
        if source is None:
            for port in range(len(self._inputs)):
                if self.GetNumberOfInputConnections(port) > 0:
                    connection = self.GetInputConnection(port, 0)
                    connection.GetProducer().Update(connection.GetIndex())
                self._give(port, vtkDataObject.GetData(inInfo[port], 0))
            self._worker.UpdateInformation()
            source = self._worker.GetOutputInformation(0)
        pipeline = vtkStreamingDemandDrivenPipeline
        for key in pipeline.WHOLE_EXTENT(), vtkDataObject.ORIGIN(), vtkDataObject.SPACING():
            info.CopyEntry(source, key)
        return 1


class _GeoTIFF(VTKPythonAlgorithmBase):
    """The writer, as vtkPlanarGeoTIFFWriter."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=0, inputType="vtkImageData")
        self._settings = {"FileName": "", "ArrayName": "", "EPSG": 0, "NoDataValue": -9999.0}

    def __getattr__(self, name):
        settings = self.__dict__.get("_settings", {})
        if name[:3] not in ("Set", "Get") or name[3:] not in settings:
            raise AttributeError(name)
        return functools.partial(self._set, name[3:]) if name.startswith("Set") else lambda: settings[name[3:]]

    def _set(self, name, value):
        self._settings[name] = min(max(value, 0), 65535) if name == "EPSG" else value
        self.Modified()

    def Write(self):
        self.Modified()
        self.UpdateWholeExtent()

    def RequestData(self, request, inInfo, outInfo):
        try:
            self._write(vtkImageData.GetData(inInfo[0]))
        except (OSError, ValueError, MemoryError) as error:
            vtkOutputWindow.GetInstance().DisplayErrorText("%s: %s\n" % (type(self).__name__, error))
        return 1

    def _write(self, image):
        settings, data = self._settings, image.GetPointData()
        if not image.GetNumberOfPoints() or image.GetDimensions()[2] != 1 or (
            not image.GetDirectionMatrix().IsIdentity() or min(image.GetSpacing()[:2]) <= 0
        ):
            raise ValueError("The input is not an image of one layer in x and y. No file was written.")
        array = data.GetArray(settings["ArrayName"] or "Elevation")
        if array is None and not settings["ArrayName"]:
            array = data.GetScalars()
        count = image.GetNumberOfPoints()
        if array is None or array.GetNumberOfComponents() != 1 or array.GetNumberOfTuples() != count:
            raise ValueError("There is no point array of one component that ArrayName names. No file was written.")
        found, marks = vtk_to_numpy(array), data.GetArray(vtkDataSetAttributes.GhostArrayName())
        values = found if found.dtype == "float32" else found.astype("float64")
        if marks and marks.IsA("vtkUnsignedCharArray") and marks.GetNumberOfValues() == count:
            hidden = vtk_to_numpy(marks) & vtkDataSetAttributes.HIDDENPOINT
            values = numpy.where(hidden, values.dtype.type("nan"), values)
        extent, spacing = image.GetExtent(), image.GetSpacing()
        origin = [image.GetOrigin()[k] + extent[2 * k] * spacing[k] for k in (0, 1)]
        geotiff = importlib.import_module(_import_package().__name__ + "._geotiff")
        geotiff.write(settings["FileName"], values.reshape(image.GetDimensions()[1::-1]), origin, spacing[:2],
                      settings["EPSG"], settings["NoDataValue"])  # fmt: skip


def _call_weakly(target, method):
    """An observer that calls a method of the target as long as there is the target, and does not keep it."""
    weak = weakref.ref(target)

    def call(_caller, _event):
        if weak() is not None:
            getattr(weak(), method)()

    return call


# --- Loading --------------------------------------------------------------------------------------


class _OfParaView:
    """A proxy of a class of ParaView's own, or of none, for which ParaView's decorators are not made."""

    def __init__(self, group, tag, attributes, inside):
        described = "".join(' %s="%s"' % item for item in attributes.items())
        self._pvsm_proxy_xml = (
            '<ServerManagerConfiguration><ProxyGroup name="%s"><%s%s>%s</%s></ProxyGroup></ServerManagerConfiguration>'
            % (group, tag, described, inside, tag)
        )


def _declare(works, group, tag, attributes, inside):
    """Makes what ParaView looks for in this module: the class of a proxy, with its description. Where nothing works,
    only what nobody sees, as ParaView 6 complains of a plugin without any."""
    name, vtk_class = attributes["name"], attributes.get("class", "")
    has_one = vtk_class.endswith("OneOutput2D")
    vtk_class = "vtkAdaptiveHilbertDelaunay2D" if has_one else vtk_class
    inside = inside.replace(":/AdaptiveHilbertDelaunay/", os.path.join(HERE, "icons", ""))
    if group == "transforms":
        globals()[name] = _OfParaView(group, tag, attributes, inside)
    elif works and (_data_are_elsewhere() or group == "writers" or _has(vtk_class)):
        base = _Raster if name == RASTER else _OneOutput if has_one else _Driver
        base = _GeoTIFF if group == "writers" else base
        made = type(name, (base,), {"vtk_class": vtk_class, "__module__": __name__})
        known = {key: value for key, value in attributes.items() if key != "class"}
        smproperty.xml(inside)(made)
        smproxy.source(type=tag, group=group, support_reload=False, **known)(made)
        globals()[name] = made


def _load():
    window, wrong = vtkOutputWindow.GetInstance(), ""
    there_already = _is_compiled_one_loaded()
    if there_already:
        window.DisplayWarningText(
            "The compiled plugin AdaptiveHilbertDelaunay is loaded already. The one in Python adds nothing to it.\n"
        )
    elif not _data_are_elsewhere():
        wrong = _what_is_wrong()
    if wrong:
        window.DisplayErrorText(wrong + "\n")
    for proxy in PROXIES:
        _declare(not wrong and not there_already, *proxy)
    if _is_client():
        manager = vtkSMProxyManager.GetProxyManager()
        manager.AddObserver("RegisterEvent", _was_registered)
        manager.AddObserver("UnRegisterEvent", _was_unregistered)


_load()
