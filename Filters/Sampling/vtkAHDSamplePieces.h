// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSamplePieces_h
#define vtkAHDSamplePieces_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <utility>
#include <vector>

class vtkDataObject;

/// Places and outputs in pieces: one, or one for each block of a composite data set. Holds shallow
/// copies of the places, and the outputs.
class vtkAHDSamplePieces
{
public:
  /// `places`: null for a raster. An output of blocks gets the structure of the places, and an
  /// empty data set for each block that is one; other blocks are ignored.
  vtkAHDSamplePieces(vtkDataObject* places, vtkDataObject* output);

  std::size_t GetCount() const { return this->Pieces.size(); }
  /// Null for a raster.
  vtkDataSet* GetPlaces(std::size_t k) const { return this->Pieces[k].first; }
  vtkDataSet* GetOutput(std::size_t k) const { return this->Pieces[k].second; }

private:
  void Add(vtkDataSet* places, vtkDataSet* output);

  std::vector<std::pair<vtkSmartPointer<vtkDataSet>, vtkSmartPointer<vtkDataSet>>> Pieces;
};

#endif
