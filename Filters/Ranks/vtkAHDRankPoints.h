// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankPoints_h
#define vtkAHDRankPoints_h

#include "Engine/Distribute/BlockChains.h"
#include "Engine/Distribute/BlockTriangulation.h"
#include "Engine/Points/Points.h"
#include "Engine/Prepare/Prepare.h"
#include "Input/vtkAHDInput.h"
#include "Ranks/vtkAHDRankFacts.h"
#include "Ranks/vtkAHDRoute.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkPointData;
class vtkPointSet;

/**
 * The points of all ranks: first each on the rank whose input it is of, then each on the rank that
 * owns its place. All know a point by one id: its number in the appended inputs of all ranks and,
 * behind these, the sources' points, where these are added.
 *
 * What is said to be collective throws vtkAHDStop on all ranks if one cannot go on.
 */
class vtkAHDRankPoints
{
public:
  /// Borrows all of them.
  vtkAHDRankPoints(const vtkAHDSettings& settings, vtkAHDRanks& ranks, const vtkAHDAllFacts& facts,
    const vtkAHDContext& context);
  ~vtkAHDRankPoints();

  /// Reads this rank's input and source. Collective.
  void Read(vtkPointSet* input, vtkPolyData* source);

  /// The constraints of all ranks. Collective.
  void JoinChains(ahd::BlockChains& chains);

  /// Takes each point to its owner: places and ids. Collective.
  void MoveToOwners();

  /// What prepare() made of this rank's own input and source.
  const ahd::PreparedInput& GetPrepared() const { return this->Prepared; }
  /// What its points are called by all.
  const ahd::BlockIds& GetOwnIds() const { return this->OwnIds; }
  /// Are the eight bounding points added? They are on the last rank, behind all others.
  bool AreBounded() const { return this->Bounds[0][0] <= this->Bounds[1][0]; }
  /// Upper estimate of the bytes that reading takes.
  std::size_t EstimateBytes() const;

  // --- Once the points are with their owners ---

  std::size_t GetCount() const { return this->Ids.size(); }
  const std::vector<std::int64_t>& GetIds() const { return this->Ids; }
  /// As they are triangulated.
  ahd::PointView GetView() const;
  /// For the engine, with these constraints.
  ahd::BlockInput GetBlock(const ahd::BlockChains& chains) const;
  /// Where they are in space: floats or doubles.
  vtkDataArray* GetPlaces() const { return this->Places; }
  /// The same, given away, with room for so many points; there is no view of them after that.
  /// Throws std::bad_alloc.
  vtkSmartPointer<vtkDataArray> TakePlaces(std::size_t count);
  /// Their ghost marks; null if no rank has any.
  vtkUnsignedCharArray* GetMarks() const { return this->Marks; }

  /// The way that they have come, for their data, and what is to be sent along.
  vtkAHDRoute& GetRoute() { return this->Route; }
  vtkPointData* GetDataToMove() const;

private:
  void FitPlane();
  void FindBounds();
  void Prepare();
  std::vector<ahd::Point> FindSamples() const;
  void FindOwners();
  void SortIds(const std::vector<std::int64_t>& arrived);
  bool AreFloats() const;
  void MovePlaces();
  void MoveMarks();

  const vtkAHDSettings& Settings;
  vtkAHDRanks& Ranks;
  const vtkAHDAllFacts& Facts;
  const vtkAHDContext& Context;
  vtkSmartPointer<vtkPolyData> Local;    // points and what all ranks have of their data
  vtkSmartPointer<vtkPolyData> Combined; // with the source's behind, where these are added
  std::unique_ptr<vtkAHDInput> Input;
  ahd::Plane Plane; // of all ranks, if one is to be fitted
  std::array<ahd::Vector3, 2> Bounds = { { { { 1, 1, 1 } },
    { { 0, 0, 0 } } } }; // of all, if there are to be points around them
  ahd::PreparedInput Prepared;
  ahd::BlockIds OwnIds;
  vtkAHDRoute Route;
  std::vector<std::int64_t> Ids;
  vtkSmartPointer<vtkDataArray> Places;
  std::vector<double> InPlane; // x, y, height; empty where the plane is x, y
  vtkSmartPointer<vtkUnsignedCharArray> Marks;
};

#endif
