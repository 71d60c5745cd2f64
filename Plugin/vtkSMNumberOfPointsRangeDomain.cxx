// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMNumberOfPointsRangeDomain.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"

#include <algorithm>

vtkStandardNewMacro(vtkSMNumberOfPointsRangeDomain);

void vtkSMNumberOfPointsRangeDomain::Update(vtkSMProperty*)
{
  vtkPVDataInformation* input = this->GetInputDataInformation("Input");
  const vtkTypeInt64 points = input ? std::max<vtkTypeInt64>(0, input->GetNumberOfPoints()) : 0;
  const vtkTypeInt64 most = std::min<vtkTypeInt64>(points, VTK_INT_MAX);
  const vtkTypeInt64 least = std::min<vtkTypeInt64>(3, most);
  this->SetEntries({ vtkEntry(static_cast<int>(least), static_cast<int>(most)) });
}

void vtkSMNumberOfPointsRangeDomain::Register()
{
  // ParaView makes domains by name through this; classes in modules are registered by generated
  // code.
  vtkClientServerInterpreterInitializer::GetGlobalInterpreter()->AddNewInstanceFunction(
    "vtkSMNumberOfPointsRangeDomain",
    [](void*) -> vtkObjectBase* { return vtkSMNumberOfPointsRangeDomain::New(); });
}
