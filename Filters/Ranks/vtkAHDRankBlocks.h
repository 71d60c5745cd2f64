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

/// How the blocks of a data set are put together, without what is in them.
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
  /// Are there parts of one data set in it, of which each rank has as many as it has?
  bool HasPieces() const { return this->Kind == MultiPiece || this->Kind == Partitions; }

  /// Adds what the other one has and this one has not. Returns false if they are put together
  /// differently.
  bool Join(const vtkAHDBlockTree& other);

  /// See ahd::HasFields.
  auto fields() { return std::tie(this->Kind, this->Children); }
};

/**
 * The blocks that the inputs of all ranks have, where each block is triangulated by itself: block k
 * of all ranks together. One that a rank has not is empty there.
 */
class vtkAHDRankBlocks
{
public:
  /// Hears what all have. Collective; throws vtkAHDStop on all ranks if one cannot go on. `input`
  /// may be null: then this rank has nothing. `areMerged`: blocks do not count.
  vtkAHDRankBlocks(
    vtkAHDRanks& ranks, const vtkAHDContext& context, vtkDataObject* input, bool areMerged);

  /// Of this rank; may be null.
  vtkDataObject* GetInput() const { return this->Input; }
  /// Are there any?
  bool HaveBlocks() const { return this->All.HasBlocks(); }
  /// What is different on two ranks, in a sentence; empty if nothing is.
  const std::string& GetDifference() const { return this->Difference; }

  /// How many at least one rank has. The rest is for one of them, from 0.
  std::size_t GetCount() const { return this->Paths.size(); }
  /// Null if this rank has not.
  vtkDataObject* GetBlock(std::size_t k) const;
  void SetBlock(std::size_t k, vtkDataObject* output, vtkPolyData* block) const;

  /// An output with room for all: put together as the input, and named as it.
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
