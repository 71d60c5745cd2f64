// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDMergedBlocks_h
#define vtkAHDMergedBlocks_h

#include "Engine/Result.h"
#include "Input/vtkAHDBlocks.h"
#include "vtkDataObject.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>

class vtkAHDContext;
class vtkAlgorithm;
class vtkPointSet;
class vtkPolyData;
struct vtkAHDSettings;

/**
 * Input and source of one execution, each as one data set: as it is, or all blocks of a composite
 * data set together. They are held copies (vtkAHDHeldCopy), because observers may change or remove
 * the pipeline's data sets.
 */
class vtkAHDMergedBlocks
{
public:
  /// Merges blocks. Too many points, too little memory, invalid offsets of cells and a source that
  /// is neither vtkPolyData nor blocks are one error, reported for the filter; silent without one.
  /// `source` may be null. Throws std::bad_alloc.
  vtkAHDMergedBlocks(vtkAlgorithm* filter, const vtkAHDSettings& settings, vtkDataObject* input,
    vtkDataObject* source, const vtkAHDContext& context);

  /// Null if there is nothing to triangulate: no points, an error, or an abort.
  vtkPointSet* GetInput() const { return this->Input; }

  /// Replaces the points of GetInput() in a surface by the given ones.
  void HandOnPoints(vtkPolyData* surface) const;

  /// Ok, or the reason why there is no input.
  ahd::Status GetStatus(const vtkAHDContext& context) const;

  /// Null if there is none.
  vtkPolyData* GetSource() const { return this->Source; }

  /// The most that merging has allocated.
  std::size_t GetBytes() const { return this->Bytes; }

  /// Warns of ignored blocks.
  void Warn() const;

private:
  vtkSmartPointer<vtkPolyData> Merge(const vtkAHDBlocks& blocks, const vtkAHDContext& context);

  vtkAlgorithm* const Filter;
  const vtkTypeInt64 Limit;
  const vtkSmartPointer<vtkDataObject> GivenInput;
  const vtkSmartPointer<vtkDataObject> GivenSource;
  vtkSmartPointer<vtkPoints> GivenPoints; // null: there are none, or they are of blocks
  vtkSmartPointer<vtkPointSet> Input;
  vtkSmartPointer<vtkPolyData> Source;
  std::size_t Bytes = 0;
  bool CellsAreBad = false;
};

#endif
