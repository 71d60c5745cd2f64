// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuresAfterUpdate.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <cstring>

namespace
{
/// Observes one proxy: its data were updated.
class FetchMeasures : public vtkCommand
{
public:
  static FetchMeasures* New() { VTK_STANDARD_NEW_BODY(FetchMeasures); }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    vtkSMProxy::SafeDownCast(caller)->UpdatePropertyInformation();
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
    if (!proxy || !proxy->GetXMLName() ||
      std::strcmp(proxy->GetXMLName(), "AdaptiveHilbertDelaunay2D") != 0 ||
      proxy->HasObserver(vtkCommand::UpdateDataEvent, this->Fetch))
    {
      return; // another proxy, or the same under one more name
    }
    proxy->AddObserver(vtkCommand::UpdateDataEvent, this->Fetch);
  }

private:
  vtkNew<FetchMeasures> Fetch;
};
}

void FetchMeasuresAfterUpdate()
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
