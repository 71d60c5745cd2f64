// SPDX-License-Identifier: BSD-3-Clause
#include "FilterObservers.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <set>

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
    if (!name || std::strcmp(name, "Source") != 0)
    {
      return;
    }
    auto* proxy = vtkSMProxy::SafeDownCast(caller);
    auto* source = vtkSMProxyProperty::SafeDownCast(proxy->GetProperty("Source"));
    std::set<vtkSMProxy*> seen;
    if (source && source->GetNumberOfProxies() > 0 && DependsOn(source->GetProxy(0), proxy, seen))
    {
      vtkGenericWarningMacro(
        "The source was made from the surface that it is to constrain. It was taken "
        "away again.");
      source->RemoveAllProxies();
    }
  }
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

/// A setting without a fixed range: its widget's range is no limit.
constexpr const char* kOpenEnded = "InsertionLimit";

/// The nearest value in the range; `value` if that is open.
template <typename Domain, typename Number>
Number nearestIn(Domain* domain, Number value)
{
  int isLimited = 0;
  const auto least = domain->GetMinimum(0, isLimited);
  if (isLimited && !(value >= least)) // NaN too
  {
    return least;
  }
  const auto most = domain->GetMaximum(0, isLimited);
  return isLimited && value > most ? most : value;
}

/// Sets the property to the nearest value in its range, if it is a number with one.
void KeepInRange(vtkSMProxy* proxy, const char* name)
{
  vtkSMProperty* property = proxy->GetProperty(name);
  if (!property || property->GetInformationOnly() || std::strcmp(name, kOpenEnded) == 0)
  {
    return;
  }
  vtkSMPropertyHelper value(property);
  if (auto* whole = vtkSMIntRangeDomain::SafeDownCast(property->FindDomain("vtkSMIntRangeDomain")))
  {
    if (const int kept = nearestIn(whole, value.GetAsInt()); kept != value.GetAsInt())
    {
      value.Set(kept);
    }
  }
  else if (auto* real = vtkSMDoubleRangeDomain::SafeDownCast(
             property->FindDomain("vtkSMDoubleRangeDomain")))
  {
    if (const double kept = nearestIn(real, value.GetAsDouble()); !(kept == value.GetAsDouble()))
    {
      value.Set(kept);
    }
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

/// Observes the proxy manager: a proxy was registered.
class ObserveFilters : public vtkCommand
{
public:
  static ObserveFilters* New() { VTK_STANDARD_NEW_BODY(ObserveFilters); }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    auto* proxy = vtkSMSourceProxy::SafeDownCast(registered->Proxy);
    if (!proxy || !proxy->GetXMLName() ||
      std::strcmp(proxy->GetXMLName(), "AdaptiveHilbertDelaunay2D") != 0 ||
      proxy->HasObserver(vtkCommand::UpdateDataEvent, this->Fetch))
    {
      return; // another proxy, or the same under one more name
    }
    proxy->AddObserver(vtkCommand::UpdateDataEvent, this->Fetch);
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Refuse);
    JoinNames(proxy);
    KeepAllInRange(proxy);
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Range);
    proxy->AddObserver(vtkCommand::PropertyModifiedEvent, this->Follow);
  }

private:
  vtkNew<FetchMeasures> Fetch;
  vtkNew<RefuseCircle> Refuse;
  vtkNew<FollowOldName> Follow;
  vtkNew<StayInRange> Range;
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
