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
 * data set together. They are held copies (vtkAHDHeldCopy), as observers may do what they like to
 * what the pipeline has, or take it from the filter.
 */
class vtkAHDMergedBlocks
{
public:
  /// Merges what has to be. Says in an error if there are too many points or too little memory, or
  /// where offsets of cells lie, or if the source is neither vtkPolyData nor blocks; nothing
  /// without a filter. `source` may be null. Throws std::bad_alloc.
  vtkAHDMergedBlocks(vtkAlgorithm* filter, const vtkAHDSettings& settings, vtkDataObject* input,
    vtkDataObject* source, const vtkAHDContext& context);

  /// Null if there is nothing to be triangulated: no points, an error, or an abort.
  vtkPointSet* GetInput() const { return this->Input; }

  /// Lets a surface that has the points of GetInput() have those that were given instead.
  void HandOnPoints(vtkPolyData* surface) const;

  /// Why there is no input: Ok if there is one.
  ahd::Status GetStatus(const vtkAHDContext& context) const;

  /// Null if there is none.
  vtkPolyData* GetSource() const { return this->Source; }

  /// Those that merging has taken, at most.
  std::size_t GetBytes() const { return this->Bytes; }

  /// Warns of blocks that were passed over.
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
