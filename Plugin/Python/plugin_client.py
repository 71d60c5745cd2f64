# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin in Python does on the client. make_plugin.py puts it into the plugin, in place of its import."""

from paraview.modules.vtkRemotingCore import vtkProcessModule
from paraview.modules.vtkRemotingServerManager import (
    vtkSMPropertyHelper,
    vtkSMPropertyIterator,
    vtkSMProxyIterator,
    vtkSMProxyManager,
)
from vtkmodules.vtkCommonCore import vtkOutputWindow

# Made of AdaptiveHilbertDelaunay.xml by make_plugin.py, which replaces the value of this name.
#: Settings whose range goes up to the number of points of the input, and is no limit.
UP_TO_POINTS = []

# --- What ParaView does not do by itself, on the client -------------------------------------------
#
# It fetches information properties before a run, not after it: measures are fetched again after each run.
# It takes a source that was made from the surface, and its update never ends: such a source is taken away.
# It knows no second name of a property: GenerateFate and GeneratePointStatus are kept equal.
# It shows numbers out of a property's range, or of no entry of a list, though the filter takes the nearest legal one:
# so does the panel.
# It has no range that ends at the number of points: that of a hidden property, which is set here, is used.
# It knows no area that suits the points: as long as it is not used, it is suggested.

FILTER = "AdaptiveHilbertDelaunay2D"
#: Of the same class, with one output.
OUTPUTS = "Delaunay2DAdaptiveHilbert", "VoronoiAdaptiveHilbert", "InsertionOrderAdaptiveHilbert"
RASTER = "AdaptiveHilbertInterpolation2D"
MESH, SOURCE, OUTLINE = "AdaptiveHilbertQualityMesh2D", "PlanarPointSource", "PlanarSurfaceOutline"
NAMES = {"GenerateFate": "GeneratePointStatus", "GeneratePointStatus": "GenerateFate"}  # old and new
RANGES = "vtkSMIntRangeDomain", "vtkSMDoubleRangeDomain"
UPDATED, CHANGED = "UpdateDataEvent", "PropertyModifiedEvent"


def _properties(proxy):
    """(name, property) of all of them."""
    found, each = [], vtkSMPropertyIterator()  # proxy.NewPropertyIterator() gives one that would never go
    each.SetProxy(proxy)
    each.Begin()
    while not each.IsAtEnd():
        found.append((each.GetKey(), each.GetProperty()))
        each.Next()
    return found


def _range(item):
    """The range of a setting that is a number, else None."""
    if item is None or item.GetInformationOnly():
        return None
    return next(filter(None, map(item.FindDomain, RANGES)), None)


def _value(proxy, name, element=0):
    item = vtkSMPropertyHelper(proxy, name)
    is_whole = proxy.GetProperty(name).IsA("vtkSMIntVectorProperty")
    return item.GetAsInt(element) if is_whole else item.GetAsDouble(element)


def _fetch_measures(proxy, _event):
    """After a run. Then widgets show the numbers again, as they do not listen while Apply hands on what is in them."""
    proxy.UpdatePropertyInformation()
    for _name, item in _properties(proxy):
        if _range(item):
            item.InvokeEvent("UncheckedPropertyModifiedEvent")


def _depends_on(proxy, wanted, seen):
    """Is `wanted` among the proxies that make the data of `proxy`, itself included? `seen` were looked at."""
    if proxy is wanted:
        return True
    if proxy is None or proxy in seen:
        return False
    seen.add(proxy)
    return any(
        _depends_on(proxy.GetProducerProxy(i), wanted, seen) for i in range(proxy.GetNumberOfProducers())
    )


CIRCLES = {
    "Input": "The input was made from this filter's own output. It was taken away again.\n",
    "Source": "The source was made from the surface that it is to constrain. It was taken away again.\n",
    "Places": "The places were made from the values that are wanted there. They were taken away again.\n",
}


def _refuse_circle(proxy, name):
    item = proxy.GetProperty(name)
    if item.GetNumberOfProxies() > 0 and _depends_on(item.GetProxy(0), proxy, set()):
        vtkOutputWindow.GetInstance().DisplayWarningText(CIRCLES[name])
        item.RemoveAllProxies()


def _keep_equal(proxy, name):
    """Gives the other name of the setting the value that it has by this one."""
    other = NAMES[name]
    vtkSMPropertyHelper(proxy, other).Set(_value(proxy, name))
    if proxy.GetObjectsCreated():
        proxy.UpdateProperty(other)


def _keep_in_enumeration(proxy, name):
    """Sets the property to the nearest of the values that it can have, if these have names."""
    item = proxy.GetProperty(name)
    entries = item and not item.GetInformationOnly() and item.FindDomain("vtkSMEnumerationDomain")
    if entries and entries.GetNumberOfEntries():
        value = _value(proxy, name)
        known = map(entries.GetEntryValue, range(entries.GetNumberOfEntries()))
        kept = min(known, key=lambda entry: abs(entry - value))
        if kept != value:
            vtkSMPropertyHelper(proxy, name).Set(kept)


def _keep_in_range(proxy, name):
    """Sets the property to the nearest value in its range, if it is a number with one that is a limit."""
    _keep_in_enumeration(proxy, name)
    limits = _range(proxy.GetProperty(name))
    if not limits or name in UP_TO_POINTS:
        return
    for element in range(vtkSMPropertyHelper(proxy, name).GetNumberOfElements()):
        value = kept = _value(proxy, name, element)
        if limits.GetMinimumExists(element) and not value >= limits.GetMinimum(element):  # NaN too
            kept = limits.GetMinimum(element)
        elif limits.GetMaximumExists(element) and value > limits.GetMaximum(element):
            kept = limits.GetMaximum(element)
        if kept is not value:
            vtkSMPropertyHelper(proxy, name).Set(element, kept)


def _use_dimensions(proxy):
    """Scripts that set Dimensions alone mean these: they are chosen where no cell size is given."""
    if proxy.GetProperty("CellSize").IsValueDefault() and not proxy.GetProperty("Dimensions").IsValueDefault():
        vtkSMPropertyHelper(proxy, "RasterSize").Set(0)
        proxy.UpdateProperty("RasterSize")


def _suggest_raster(proxy):
    """Fills in what is not used yet: an area from which one may start."""
    item = proxy.GetProperty("Input")
    source = item.GetProxy(0) if item.GetNumberOfProxies() > 0 else None
    if source is None or not source.GetObjectsCreated():
        return
    xmin, xmax, ymin, ymax = source.GetDataInformation(item.GetOutputPortForConnection(0)).GetBounds()[:4]
    if not (xmin <= xmax and ymin <= ymax):
        return
    if not _value(proxy, "UseBounds") and proxy.GetProperty("Bounds").IsValueDefault():
        for element, bound in enumerate((xmin, xmax, ymin, ymax)):
            vtkSMPropertyHelper(proxy, "Bounds").Set(element, bound)


def _follow_points(proxy):
    """Gives the ranges that go up to the number of points this end, and has them follow the input."""
    ranges = [name + "Range" for name in UP_TO_POINTS if proxy.GetProperty(name + "Range")]
    if not ranges:
        return
    item = proxy.GetProperty("Input")
    source = item.GetProxy(0) if item.GetNumberOfProxies() > 0 else None
    points = 0
    if source is not None and source.GetObjectsCreated():
        points = source.GetDataInformation(item.GetOutputPortForConnection(0)).GetNumberOfPoints()
        if not source.__dict__.get("_ahd_followed"):
            source._ahd_followed = True
            source.AddObserver(UPDATED, _input_was_updated)
    most = min(max(points, 0), 2**31 - 1)
    for name in ranges:
        ends = vtkSMPropertyHelper(proxy, name)
        ends.Set(0, min(3, most))
        ends.Set(1, most)


def _input_was_updated(source, _event):
    for i in range(source.GetNumberOfConsumers()):
        proxy = source.GetConsumerProxy(i)
        if _is_observed(proxy):
            _follow_points(proxy)


def _property_changed(proxy, _event, name):
    if name == "Input":
        _refuse_circle(proxy, name)
        _follow_points(proxy)
    elif name in CIRCLES:
        _refuse_circle(proxy, name)
    elif name in NAMES:
        _keep_equal(proxy, name)
    else:
        _keep_in_range(proxy, name)
        if name == "Dimensions":
            _use_dimensions(proxy)


_property_changed.CallDataType = "string0"


def _observe(proxy):
    """From now on this proxy, which may have been set before, is looked after."""
    proxy._ahd_observed = True
    if proxy.GetXMLName() == RASTER:
        _suggest_raster(proxy)
        if not proxy.GetSessionProxyManager().GetInLoadXMLState():  # which has all settings
            _use_dimensions(proxy)
    old, new = NAMES
    if proxy.GetProperty(old):
        _keep_equal(proxy, old if _value(proxy, old) else new)
    for name, _item in _properties(proxy):
        _keep_in_range(proxy, name)
    _follow_points(proxy)
    proxy.AddObserver(UPDATED, _fetch_measures)
    proxy.AddObserver(CHANGED, _property_changed)


def _is_observed(proxy):
    return proxy is not None and "_ahd_observed" in proxy.__dict__


def _is_filter(proxy):
    """Is it one of ours, and that of a plugin in Python? The compiled one has its own observers."""
    return proxy.GetXMLName() in (FILTER, *OUTPUTS, RASTER, MESH, SOURCE, OUTLINE) and "." in proxy.GetVTKClassName()


_seen = {"sources": 0}


def _was_registered(manager, _event):
    """Looks for new filters, as what was registered is told in a way that Python cannot read."""
    session = manager.GetActiveSessionProxyManager()
    count = session.GetNumberOfProxies("sources") if session else 0
    if count == _seen["sources"]:
        return
    _seen["sources"] = count
    each = vtkSMProxyIterator()
    each.SetSessionProxyManager(session)
    each.SetModeToOneGroup()
    each.Begin("sources")
    while not each.IsAtEnd():
        proxy = each.GetProxy()
        if _is_filter(proxy) and not _is_observed(proxy):
            _observe(proxy)
        each.Next()


def _was_unregistered(_manager, _event):
    _seen["sources"] = 0


def _is_client():
    """A server has no properties."""
    module = vtkProcessModule
    servers = module.PROCESS_SERVER, module.PROCESS_DATA_SERVER, module.PROCESS_RENDER_SERVER
    return module.GetProcessType() not in servers


def _session():
    """The proxy manager of the session that is active on this client, if there is one."""
    return vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager() if _is_client() else None


def _data_are_elsewhere():
    """Does this process show what a server computes?"""
    session = _session()
    return bool(session and session.GetSession().IsA("vtkSMSessionClient"))


def _is_compiled_one_loaded():
    session = _session()
    known = session and session.GetProxyDefinitionManager().HasDefinition("filters", FILTER)
    return bool(known) and "." not in session.GetPrototypeProxy("filters", FILTER).GetVTKClassName()
