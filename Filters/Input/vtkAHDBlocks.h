// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDBlocks_h
#define vtkAHDBlocks_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkAHDContext;
class vtkCompositeDataSet;
class vtkPointSet;
class vtkPolyData;

/**
 * The points of all blocks of a composite data set as one point set.
 *
 * The points of one block follow those of the one before, in the order of the data set's iterator.
 * Blocks without points are ignored, and so are blocks that are not a vtkPointSet (of a source: a
 * vtkPolyData), which are counted. Holds the data that the blocks have when it is created.
 */
class vtkAHDBlocks
{
public:
  /// The use of the blocks.
  enum class Kind
  {
    PointSets,
    Sources,     ///< vtkPolyData, whose cells are merged too
    SourcesByIds ///< the same, the ids in the cells left as they are
  };

  explicit vtkAHDBlocks(vtkCompositeDataSet* blocks, Kind kind = Kind::PointSets);

  /// Blocks without points of their own, or not a vtkPolyData.
  vtkIdType GetNumberOfOthers() const { return this->Others; }

  /// The class of the first of them.
  const std::string& GetFirstOther() const { return this->FirstOther; }

  /// Blocks whose ghost marks (vtkGhostType) are not one unsigned char for each point.
  vtkIdType GetNumberOfUnfitMarks() const { return this->UnfitMarks; }

  /// The number of all points.
  vtkIdType GetCount() const { return this->Count; }

  /// Upper estimate of the bytes that Merge() allocates.
  std::size_t EstimateBytes() const;

  /// All points: floats, if all blocks have floats, else doubles. Point data: the arrays that all
  /// blocks have, by name, type and number of components, with a value for each point. Blocks
  /// without ghost marks that fit count as unmarked if others have some. Of sources the cells too,
  /// by kind (vertices, lines, polygons, strips), with the new ids of their points. Throws
  /// vtkAHDStop on an abort or if offsets of lines or polygons are invalid, and
  /// std::bad_alloc.
  vtkSmartPointer<vtkPolyData> Merge(const vtkAHDContext& context) const;

private:
  void MergePointData(vtkPolyData* merged, const vtkAHDContext& context) const;

  void MergeCells(vtkPolyData* merged, const vtkAHDContext& context) const;

  bool HasCells() const { return this->Wanted != Kind::PointSets; }

  const Kind Wanted;
  std::vector<vtkSmartPointer<vtkPolyData>> Blocks; // those with points, as held copies
  vtkIdType Count = 0;
  vtkIdType Others = 0;
  vtkIdType UnfitMarks = 0;
  std::string FirstOther;
};

#endif
