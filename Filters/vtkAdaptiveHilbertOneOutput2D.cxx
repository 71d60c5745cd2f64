// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertOneOutput2D.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkAdaptiveHilbertOneOutput2D);

vtkAdaptiveHilbertOneOutput2D::vtkAdaptiveHilbertOneOutput2D()
{
  this->All->SetNumberOfInformationObjects(this->GetNumberOfOutputPorts());
  this->SetNumberOfOutputPorts(1);
}

vtkAdaptiveHilbertOneOutput2D::~vtkAdaptiveHilbertOneOutput2D() = default;

vtkTypeBool vtkAdaptiveHilbertOneOutput2D::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* const real = outputs->GetInformationObject(0);
  vtkNew<vtkInformationVector> all;
  for (int port = 0; port < this->All->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const own = this->All->GetInformationObject(port);
    if (port != this->ShownPort)
    {
      vtkSmartPointer<vtkDataObject> data = own->Get(vtkDataObject::DATA_OBJECT());
      if (!data)
      {
        data = vtkSmartPointer<vtkPolyData>::New();
      }
      own->Copy(real); // the same piece is wanted
      own->Set(vtkDataObject::DATA_OBJECT(), data);
    }
    all->Append(port == this->ShownPort ? real : own);
  }
  const vtkTypeBool result = this->Superclass::ProcessRequest(request, inputs, all);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    for (int port = 0; port < this->All->GetNumberOfInformationObjects(); ++port)
    {
      this->All->GetInformationObject(port)->Clear(); // keeps no data alive
    }
  }
  return result;
}

void vtkAdaptiveHilbertOneOutput2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShownPort: " << this->ShownPort << "\n";
}
