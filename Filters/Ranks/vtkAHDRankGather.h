// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankGather_h
#define vtkAHDRankGather_h

#include "Execution/vtkAHDExecution.h"
#include "Ranks/vtkAHDRankFacts.h"
#include "Ranks/vtkAHDRoute.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

/// Cells appended from several ranks.
struct vtkAHDCellChain
{
  std::vector<std::int64_t> Ids, Sizes;

  /// See ahd::HasFields.
  auto fields() { return std::tie(this->Ids, this->Sizes); }
};

/**
 * The inputs and sources of all ranks on one of them, appended in the order of the ranks.
 *
 * Points added to those of the input have values in its arrays like those of vtkAHDPointOutput;
 * other arrays of a source are not sent. Ids in the cells of a rank's source, which refer to its
 * own points, become those of the appended points. Collective functions throw vtkAHDStop on
 * all ranks if one fails.
 */
class vtkAHDRankGather
{
public:
  /// Borrows all of them.
  vtkAHDRankGather(const vtkAHDSettings& settings, vtkAHDRanks& ranks, const vtkAHDAllFacts& facts,
    const vtkAHDContext& context);

  /// Collects the sizes of all ranks. Collective.
  void Measure(const vtkAHDDataSets& data);

  // --- After that, the same on all ranks ---

  /// Data sets with the sizes and types of the appended ones, without values in memory:
  /// for estimates, which read no value.
  vtkSmartPointer<vtkPolyData> OutlineInput() const;
  vtkSmartPointer<vtkPolyData> OutlineSource() const;
  /// Upper estimate of the bytes of the appended data sets, with those that any rank has
  /// allocated to make its own.
  std::size_t EstimateBytes() const;
  /// The same of additional bytes on the receiving rank, during the transfer.
  std::size_t EstimateBytesOnTheWay() const;
  /// The same of the bytes that a rank takes to send its data.
  std::size_t EstimateBytesToSend(std::size_t rank) const;

  /// Moves all to one rank. Collective. @pre Measure() of the same data.
  void MoveTo(std::size_t host, const vtkAHDDataSets& data);

  /// The data sets on that rank; on others they have no points.
  vtkPolyData* GetInput() const { return this->Input; }
  vtkPolyData* GetSource() const { return this->Source; }
  /// The original value, in its rank's source, of an id that is not the id of a point.
  std::int64_t GetGivenId(std::int64_t id) const;

private:
  static constexpr std::size_t kKinds = 3; // of cells: vertices, lines, polygons
  struct CellCounts
  {
    std::uint64_t Count = 0;
    std::uint64_t Ids = 0;
  };
  struct Sizes // of what one rank has
  {
    std::uint64_t InputBytes = 0;  // allocated to merge the input
    std::uint64_t DataBytes = 0;   // of the arrays that all ranks have
    std::uint64_t WidestBytes = 0; // of the largest message
    std::array<CellCounts, kKinds> Cells = {};
  };
  using CellArrays = std::array<vtkCellArray*, kKinds>;

  static CellArrays CellsOf(vtkPolyData* source);
  bool AddsSource() const { return this->Facts.GetSourcePoints() > 0; }
  vtkPolyData* CountedSource(const vtkAHDDataSets& data) const;
  Sizes MeasureOwn(const vtkAHDDataSets& data) const;
  CellCounts GetCells(std::size_t kind) const;
  std::size_t GetWidth() const;
  std::int64_t GetFirstId() const;
  std::int64_t GetIdCount() const;
  void MovePoints(vtkPolyData* from, bool areFloats, vtkAHDRoute& route, vtkPolyData* to);
  void MoveMarks(vtkPointSet* input, vtkAHDRoute& route);
  void MoveCells(vtkPolyData* source);
  vtkAHDCellChain ReadCells(vtkCellArray* cells, std::int64_t ownIds) const;
  vtkSmartPointer<vtkPolyData> ReadSourcePoints(vtkPolyData* source) const;

  const vtkAHDSettings& Settings;
  vtkAHDRanks& Ranks;
  const vtkAHDAllFacts& Facts;
  const vtkAHDContext& Context;
  std::vector<Sizes> Of; // of each rank
  std::size_t Host = 0;
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> Source;
};

#endif
