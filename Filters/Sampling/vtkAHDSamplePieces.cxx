// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSamplePieces.h"

#include "Input/vtkAHDHeldCopy.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPointSet.h"

vtkAHDSamplePieces::vtkAHDSamplePieces(vtkDataObject* places, vtkDataObject* output)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(places);
  auto* outputs = vtkCompositeDataSet::SafeDownCast(output);
  if (!blocks || !outputs)
  {
    this->Add(vtkDataSet::SafeDownCast(places), vtkDataSet::SafeDownCast(output));
    return;
  }
  outputs->CopyStructure(blocks);
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    if (auto* block = vtkDataSet::SafeDownCast(each->GetCurrentDataObject()))
    {
      auto made = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
      outputs->SetDataSet(each, made);
      this->Add(block, made);
    }
  }
}

void vtkAHDSamplePieces::Add(vtkDataSet* places, vtkDataSet* output)
{
  vtkSmartPointer<vtkDataSet> held;
  if (places)
  {
    held.TakeReference(places->NewInstance());
    held->ShallowCopy(places);
    vtkAHDOwnPoints(vtkPointSet::SafeDownCast(held));
  }
  this->Pieces.emplace_back(held, output);
}
