// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankBlocks_h
#define vtkAHDRankBlocks_h

#include "Ranks/vtkAHDRanks.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

class vtkDataObject;
class vtkDataObjectTree;
class vtkPolyData;

/// The structure of the blocks of a data set, without their content.
struct vtkAHDBlockTree
{
  enum Kinds
  {
    Nothing, ///< a block that is missing
    Leaf,    ///< a block, or a data set that has none
    MultiBlock,
    MultiPiece,
    Partitions,
    Collection
  };

  int Kind = Nothing;
  std::vector<vtkAHDBlockTree> Children;

  vtkAHDBlockTree() = default;
  explicit vtkAHDBlockTree(vtkDataObject* data);

  bool HasBlocks() const { return this->Kind > Leaf; }
  /// Does it have parts of one data set, whose number may differ between ranks?
  bool HasPieces() const { return this->Kind == MultiPiece || this->Kind == Partitions; }

  /// Adds the blocks that only the other one has. Returns false if their structures
  /// differ.
  bool Join(const vtkAHDBlockTree& other);

  /// See ahd::HasFields.
  auto fields() { return std::tie(this->Kind, this->Children); }
};

/**
 * The blocks of the inputs of all ranks, if each block is triangulated by itself: block k
 * of all ranks together. A block that a rank lacks is empty there.
 */
class vtkAHDRankBlocks
{
public:
  /// Collects the structures. Collective; throws vtkAHDStop on all ranks if one fails. `input`
  /// may be null: then this rank has nothing. `areMerged`: blocks do not count.
  vtkAHDRankBlocks(
    vtkAHDRanks& ranks, const vtkAHDContext& context, vtkDataObject* input, bool areMerged);

  /// Of this rank; may be null.
  vtkDataObject* GetInput() const { return this->Input; }
  /// Are there any?
  bool HaveBlocks() const { return this->All.HasBlocks(); }
  /// A difference between two ranks, as a sentence; empty if there is none.
  const std::string& GetDifference() const { return this->Difference; }

  /// The number of blocks of all ranks. The functions below take one of them, from 0.
  std::size_t GetCount() const { return this->Paths.size(); }
  /// Null if this rank lacks it.
  vtkDataObject* GetBlock(std::size_t k) const;
  void SetBlock(std::size_t k, vtkDataObject* output, vtkPolyData* block) const;

  /// An output for all blocks, with the structure and names of the input.
  vtkSmartPointer<vtkDataObject> MakeOutput() const;

private:
  using Path = std::vector<unsigned int>; // from the root, the number of each child

  void FindPaths(const vtkAHDBlockTree& tree, Path& path);

  const vtkSmartPointer<vtkDataObject> Input;
  vtkAHDBlockTree All;
  std::string Difference;
  std::vector<Path> Paths; // of all blocks
};

#endif
