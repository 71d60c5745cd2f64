// SPDX-License-Identifier: BSD-3-Clause
#include "FilterObservers.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkProcessModule.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <set>
#include <string>

namespace
{
/// Lets widgets show the numbers again: while Apply hands on what is in them they do not listen.
void ShowNumbers(vtkSMProxy* proxy)
{
  auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    const bool isNumber = property->FindDomain("vtkSMIntRangeDomain") ||
      property->FindDomain("vtkSMDoubleRangeDomain");
    if (isNumber && !property->GetInformationOnly())
    {
      property->InvokeEvent(vtkCommand::UncheckedPropertyModifiedEvent);
    }
  }
}

/// Observes one proxy: its data were updated.
class FetchMeasures : public vtkCommand
{
public:
  static FetchMeasures* New() { VTK_STANDARD_NEW_BODY(FetchMeasures); }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* proxy = vtkSMProxy::SafeDownCast(caller);
    proxy->UpdatePropertyInformation();
    ShowNumbers(proxy);
  }
};

/// Is `wanted` among the proxies that make the data of `proxy`, itself included? `seen` are those
/// that were looked at.
bool DependsOn(vtkSMProxy* proxy, vtkSMProxy* wanted, std::set<vtkSMProxy*>& seen)
{
  if (proxy == wanted)
  {
    return true;
  }
  if (!proxy || !seen.insert(proxy).second)
  {
    return false;
  }
  for (unsigned int i = 0; i < proxy->GetNumberOfProducers(); ++i)
  {
    if (DependsOn(proxy->GetProducerProxy(i), wanted, seen))
    {
      return true;
    }
  }
  return false;
}

/// Observes one proxy: a property was changed.
class RefuseCircle : public vtkCommand
{
public:
  static RefuseCircle* New() { VTK_STANDARD_NEW_BODY(RefuseCircle); }
  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const auto* name = static_cast<const char*>(data);
    const auto* refusal = std::find_if(std::begin(kRefusals), std::end(kRefusals),
      [name](const Refusal& r) { return name && std::strcmp(name, r.Property) == 0; });
    if (refusal == std::end(kRefusals))
    {
      return;
    }
    auto* proxy = vtkSMProxy::SafeDownCast(caller);
    auto* item = vtkSMProxyProperty::SafeDownCast(proxy->GetProperty(name));
    std::set<vtkSMProxy*> seen;
    if (item && item->GetNumberOfProxies() > 0 && DependsOn(item->GetProxy(0), proxy, seen))
    {
      vtkGenericWarningMacro(<< refusal->Text);
      item->RemoveAllProxies();
    }
  }

private:
  struct Refusal
  {
    const char* Property;
    const char* Text;
  };
  static constexpr Refusal kRefusals[] = {
    { "Input", "The input was made from this filter's own output. It was taken away again." },
    { "Source",
      "The source was made from the surface that it is to constrain. It was taken away again." },
    { "Places",
      "The places were made from the values that are wanted there. They were taken away again." },
  };
};

// A setting, and the property with its old name, which older states and scripts have.
constexpr const char* kPointStatus = "GeneratePointStatus";
constexpr const char* kOldName = "GenerateFate";

void CopyProperty(vtkSMProxy* proxy, const char* from, const char* to)
{
  vtkSMPropertyHelper(proxy, to).Set(vtkSMPropertyHelper(proxy, from).GetAsInt());
  if (proxy->GetObjectsCreated())
  {
    proxy->UpdateProperty(to);
  }
}

/// Observes one proxy: a property was changed. Keeps the setting the same by both its names.
class FollowOldName : public vtkCommand
{
public:
  static FollowOldName* New() { VTK_STANDARD_NEW_BODY(FollowOldName); }
  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const auto* name = static_cast<const char*>(data);
    auto* proxy = vtkSMProxy::SafeDownCast(caller);
    if (name && std::strcmp(name, kOldName) == 0)
    {
      CopyProperty(proxy, kOldName, kPointStatus);
    }
    else if (name && std::strcmp(name, kPointStatus) == 0)
    {
      CopyProperty(proxy, kPointStatus, kOldName);
    }
  }
};

/// The nearest value in the range of this element; `value` if that is open.
template <typename Domain, typename Number>
Number nearestIn(Domain* domain, unsigned int element, Number value)
{
  int isLimited = 0;
  const auto least = domain->GetMinimum(element, isLimited);
  if (isLimited && !(value >= least)) // NaN too
  {
    return least;
  }
  const auto most = domain->GetMaximum(element, isLimited);
  return isLimited && value > most ? most : value;
}

/// The nearest of the values that the property can have, as the filter takes it.
int nearestIn(vtkSMEnumerationDomain* domain, int value)
{
  int nearest = value;
  for (unsigned int k = 0; k < domain->GetNumberOfEntries(); ++k)
  {
    const int entry = domain->GetEntryValue(k);
    const auto away = [value](int other) { return std::abs(double(other) - double(value)); };
    nearest = k == 0 || away(entry) < away(nearest) ? entry : nearest;
  }
  return nearest;
}

/// Sets an element of the property to the nearest value in its range or of its enumeration, if it
/// has one.
void KeepInRange(vtkSMProperty* property, unsigned int element)
{
  vtkSMPropertyHelper value(property);
  if (auto* whole = vtkSMIntRangeDomain::SafeDownCast(property->FindDomain("vtkSMIntRangeDomain")))
  {
    const int given = value.GetAsInt(element);
    if (const int kept = nearestIn(whole, element, given); kept != given)
    {
      value.Set(element, kept);
    }
  }
  else if (auto* named = vtkSMEnumerationDomain::SafeDownCast(
             property->FindDomain("vtkSMEnumerationDomain")))
  {
    const int given = value.GetAsInt(element);
    if (const int kept = nearestIn(named, given); kept != given)
    {
      value.Set(element, kept);
    }
  }
  else if (auto* real = vtkSMDoubleRangeDomain::SafeDownCast(
             property->FindDomain("vtkSMDoubleRangeDomain")))
  {
    const double given = value.GetAsDouble(element);
    if (const double kept = nearestIn(real, element, given); !(kept == given))
    {
      value.Set(element, kept);
    }
  }
}

/// Does the range serve the widget alone? Numbers of points have no fixed one, and 0 stands for
/// all.
bool isOpenEnded(vtkSMProperty* property)
{
  return property->FindDomain("vtkSMNumberOfPointsRangeDomain") != nullptr;
}

void KeepInRange(vtkSMProxy* proxy, const char* name)
{
  vtkSMProperty* property = proxy->GetProperty(name);
  if (!property || property->GetInformationOnly() || isOpenEnded(property))
  {
    return;
  }
  const unsigned int elements = vtkSMPropertyHelper(property, true).GetNumberOfElements();
  for (unsigned int element = 0; element < elements; ++element)
  {
    KeepInRange(property, element);
  }
}

/// Observes one proxy: a property was changed. What is shown is what the filter uses, which takes
/// the nearest legal value.
class StayInRange : public vtkCommand
{
public:
  static StayInRange* New() { VTK_STANDARD_NEW_BODY(StayInRange); }
  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    if (const auto* name = static_cast<const char*>(data))
    {
      KeepInRange(vtkSMProxy::SafeDownCast(caller), name);
    }
  }
};

/// What was set before anybody observed the proxy.
void KeepAllInRange(vtkSMProxy* proxy)
{
  auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    KeepInRange(proxy, properties->GetKey());
  }
}

/// What was set before anybody observed the proxy: whichever was switched on.
void JoinNames(vtkSMProxy* proxy)
{
  const bool byOldName = vtkSMPropertyHelper(proxy, kOldName).GetAsInt() != 0;
  CopyProperty(proxy, byOldName ? kOldName : kPointStatus, byOldName ? kPointStatus : kOldName);
}

/// The bounds of the points that the proxy is given, null if they are not known yet.
const double* InputBounds(vtkSMProxy* proxy)
{
  const vtkSMPropertyHelper input(proxy, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(
    input.GetNumberOfElements() > 0 ? input.GetAsProxy(0) : nullptr);
  if (!source || !source->GetOutputPortsCreated())
  {
    return nullptr;
  }
  const double* bounds = source->GetDataInformation(input.GetOutputPort(0))->GetBounds();
  return bounds && bounds[0] <= bounds[1] && bounds[2] <= bounds[3] ? bounds : nullptr;
}

/// Fills in what is not used yet: an area from which one may start. @pre a proxy of the
/// interpolation.
void SuggestRaster(vtkSMProxy* proxy)
{
  const double* bounds = InputBounds(proxy);
  vtkSMProperty* area = proxy->GetProperty("Bounds");
  if (bounds && !vtkSMPropertyHelper(proxy, "UseBounds").GetAsInt() && area->IsValueDefault())
  {
    vtkSMPropertyHelper(area).Set(bounds, 4);
  }
}

/// Scripts that set Dimensions alone mean these: they are chosen where no cell size is given. @pre
/// a proxy of the interpolation.
void UseDimensions(vtkSMProxy* proxy)
{
  if (proxy->GetProperty("CellSize")->IsValueDefault() &&
    !proxy->GetProperty("Dimensions")->IsValueDefault())
  {
    vtkSMPropertyHelper(proxy, "RasterSize").Set(0);
    proxy->UpdateProperty("RasterSize");
  }
}

/// Observes one proxy: a property was changed.
class FollowDimensions : public vtkCommand
{
public:
  static FollowDimensions* New() { VTK_STANDARD_NEW_BODY(FollowDimensions); }
  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const auto* name = static_cast<const char*>(data);
    if (name && std::strcmp(name, "Dimensions") == 0)
    {
      UseDimensions(vtkSMProxy::SafeDownCast(caller));
    }
  }
};

/// Observes the proxy manager: a proxy was registered.
class ObserveFilters : public vtkCommand
{
public:
  static ObserveFilters* New() { VTK_STANDARD_NEW_BODY(ObserveFilters); }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    auto* proxy = vtkSMSourceProxy::SafeDownCast(registered->Proxy);
    const std::string name = proxy && proxy->GetXMLName() ? proxy->GetXMLName() : "";
    const bool isInterpolation = name == "AdaptiveHilbertInterpolation2D";
    if ((name == "PlanarPointSource" || name == "PlanarSurfaceOutline") &&
      !proxy->HasObserver(vtkCommand::PropertyModifiedEvent, this->Range))
    {
      KeepAllInRange(proxy);
      proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Range);
    }
    if (!(isInterpolation || std::count(std::begin(kFilters), std::end(kFilters), name)) ||
      proxy->HasObserver(vtkCommand::UpdateDataEvent, this->Fetch))
    {
      return; // another proxy, or the same under one more name
    }
    proxy->AddObserver(vtkCommand::UpdateDataEvent, this->Fetch);
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Refuse);
    const bool hasOldName = proxy->GetProperty(kOldName) != nullptr;
    if (hasOldName)
    {
      JoinNames(proxy);
    }
    if (isInterpolation)
    {
      SuggestRaster(proxy);
      if (!proxy->GetSessionProxyManager()->GetInLoadXMLState()) // which has all settings
      {
        UseDimensions(proxy);
      }
      proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Dimensions);
    }
    KeepAllInRange(proxy);
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Range);
    if (hasOldName)
    {
      proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Follow);
    }
  }

private:
  // Of vtkAdaptiveHilbertDelaunay2D and its outputs, and of the quality mesh.
  static constexpr const char* kFilters[] = { "Delaunay2DAdaptiveHilbert",
    "AdaptiveHilbertDelaunay2D", "VoronoiAdaptiveHilbert", "InsertionOrderAdaptiveHilbert",
    "AdaptiveHilbertQualityMesh2D" };

  vtkNew<FetchMeasures> Fetch;
  vtkNew<RefuseCircle> Refuse;
  vtkNew<FollowOldName> Follow;
  vtkNew<StayInRange> Range;
  vtkNew<FollowDimensions> Dimensions;
};
}

void ObserveTheFilters()
{
  const auto type = vtkProcessModule::GetProcessType();
  if (type == vtkProcessModule::PROCESS_SERVER || type == vtkProcessModule::PROCESS_DATA_SERVER ||
    type == vtkProcessModule::PROCESS_RENDER_SERVER)
  {
    return;
  }
  vtkNew<ObserveFilters> observer;
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, observer);
}
