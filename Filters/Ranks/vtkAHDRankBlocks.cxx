// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankBlocks.h"

#include "vtkDataObjectTree.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

namespace
{
using Tree = vtkAHDBlockTree;

int KindOf(vtkDataObject* data)
{
  if (vtkMultiBlockDataSet::SafeDownCast(data))
  {
    return Tree::MultiBlock;
  }
  if (vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    return Tree::Collection;
  }
  if (vtkMultiPieceDataSet::SafeDownCast(data))
  {
    return Tree::MultiPiece;
  }
  if (vtkPartitionedDataSet::SafeDownCast(data))
  {
    return Tree::Partitions;
  }
  return data ? Tree::Leaf : Tree::Nothing;
}

vtkSmartPointer<vtkDataObject> MakeOfKind(int kind)
{
  switch (kind)
  {
    case Tree::MultiBlock:
      return vtkSmartPointer<vtkMultiBlockDataSet>::New();
    case Tree::Collection:
      return vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    case Tree::MultiPiece:
      return vtkSmartPointer<vtkMultiPieceDataSet>::New();
    default:
      return vtkSmartPointer<vtkPartitionedDataSet>::New();
  }
}

unsigned int CountOf(vtkDataObject* data)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    return blocks->GetNumberOfBlocks();
  }
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    return collection->GetNumberOfPartitionedDataSets();
  }
  auto* parts = vtkPartitionedDataSet::SafeDownCast(data);
  return parts ? parts->GetNumberOfPartitions() : 0;
}

/// Null if there is none.
vtkDataObject* ChildOf(vtkDataObject* data, unsigned int k)
{
  if (k >= CountOf(data))
  {
    return nullptr;
  }
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    return blocks->GetBlock(k);
  }
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    return collection->GetPartitionedDataSet(k);
  }
  return vtkPartitionedDataSet::SafeDownCast(data)->GetPartitionAsDataObject(k);
}

void SetChild(vtkDataObject* data, unsigned int k, vtkDataObject* child)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    blocks->SetBlock(k, child);
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    collection->SetPartitionedDataSet(k, vtkPartitionedDataSet::SafeDownCast(child));
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    parts->SetPartition(k, child);
  }
}

void SetCount(vtkDataObject* data, unsigned int count)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    blocks->SetNumberOfBlocks(count);
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    collection->SetNumberOfPartitionedDataSets(count);
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    parts->SetNumberOfPartitions(count);
  }
}

/// Adds the nodes that it has not.
void Complete(const Tree& tree, vtkDataObject* data)
{
  const auto count = static_cast<unsigned int>(tree.Children.size());
  if (CountOf(data) < count)
  {
    SetCount(data, count);
  }
  for (unsigned int k = 0; k < count; ++k)
  {
    const Tree& child = tree.Children[k];
    if (!child.HasBlocks())
    {
      continue;
    }
    if (KindOf(ChildOf(data, k)) != child.Kind)
    {
      SetChild(data, k, MakeOfKind(child.Kind));
    }
    Complete(child, ChildOf(data, k));
  }
}
}

// ------------------------------------------------------------------------------------------- trees

vtkAHDBlockTree::vtkAHDBlockTree(vtkDataObject* data)
  : Kind(KindOf(data))
{
  const unsigned int count = CountOf(data);
  this->Children.reserve(count);
  for (unsigned int k = 0; k < count; ++k)
  {
    this->Children.emplace_back(ChildOf(data, k));
  }
}

bool vtkAHDBlockTree::Join(const vtkAHDBlockTree& other)
{
  if (other.Kind == Nothing)
  {
    return true;
  }
  if (this->Kind == Nothing)
  {
    *this = other;
    return true;
  }
  const std::size_t count = this->Children.size(), others = other.Children.size();
  const bool fits = count == others || count == 0 || others == 0 || this->HasPieces();
  if (this->Kind != other.Kind || !fits)
  {
    return false;
  }
  this->Children.resize(std::max(count, others));
  for (std::size_t k = 0; k < others; ++k)
  {
    if (!this->Children[k].Join(other.Children[k]))
    {
      return false;
    }
  }
  return true;
}

// --------------------------------------------------------------------------------- blocks of ranks

vtkAHDRankBlocks::vtkAHDRankBlocks(
  vtkAHDRanks& ranks, const vtkAHDContext& context, vtkDataObject* input, bool areMerged)
  : Input(input)
{
  const auto all = ranks.Share(context,
    [&]
    {
      auto* points = vtkPointSet::SafeDownCast(input);
      vtkAHDBlockTree tree;
      if (vtkDataObjectTree::SafeDownCast(input) && !areMerged)
      {
        tree = vtkAHDBlockTree(input);
      }
      else if (areMerged || (points && points->GetNumberOfPoints() > 0))
      {
        tree.Kind = input ? Tree::Leaf : Tree::Nothing;
      }
      return tree;
    });
  ranks.Together(context,
    [&]
    {
      for (std::size_t rank = 0; rank < all.size() && this->Difference.empty(); ++rank)
      {
        if (!this->All.Join(all[rank]))
        {
          std::ostringstream words;
          words << "The input of rank " << rank
                << " does not have the same structure of blocks as those of the ranks before it";
          this->Difference = words.str();
        }
      }
      Path path;
      this->FindPaths(this->All, path);
    });
}

void vtkAHDRankBlocks::FindPaths(const vtkAHDBlockTree& tree, Path& path)
{
  if (tree.Kind == Tree::Leaf)
  {
    this->Paths.push_back(path);
  }
  for (std::size_t k = 0; k < tree.Children.size(); ++k)
  {
    path.push_back(static_cast<unsigned int>(k));
    this->FindPaths(tree.Children[k], path);
    path.pop_back();
  }
}

vtkDataObject* vtkAHDRankBlocks::GetBlock(std::size_t k) const
{
  vtkDataObject* block = KindOf(this->Input) == this->All.Kind ? this->Input : nullptr;
  for (const unsigned int child : this->Paths[k])
  {
    block = ChildOf(block, child);
  }
  return block;
}

void vtkAHDRankBlocks::SetBlock(std::size_t k, vtkDataObject* output, vtkPolyData* block) const
{
  const Path& path = this->Paths[k];
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    output = ChildOf(output, path[i]);
  }
  SetChild(output, path.back(), block);
}

vtkSmartPointer<vtkDataObject> vtkAHDRankBlocks::MakeOutput() const
{
  const auto output = MakeOfKind(this->All.Kind);
  if (KindOf(this->Input) == this->All.Kind)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(
      vtkDataObjectTree::SafeDownCast(this->Input));
  }
  Complete(this->All, output);
  return output;
}
