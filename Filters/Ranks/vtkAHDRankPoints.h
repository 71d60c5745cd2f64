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
 * The points of all ranks: first each on the rank of its input, then each on the rank that
 * owns its location. All ranks use one id for a point: its number in the appended inputs of all
 * ranks, followed by the sources' points, if these are added.
 *
 * Collective functions throw vtkAHDStop on all ranks if one fails.
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

  /// Those of the sources of all ranks. Collective.
  ahd::SourceBounds JoinSourceBounds() const;

  /// Moves coordinates and ids of each point to its owner. Collective.
  void MoveToOwners();

  /// This rank's own input and source after prepare().
  const ahd::PreparedInput& GetPrepared() const { return this->Prepared; }
  /// The global ids of its points.
  const ahd::BlockIds& GetOwnIds() const { return this->OwnIds; }
  /// Are the eight bounding points added? They are on the last rank, after all others.
  bool AreBounded() const { return this->Bounds[0][0] <= this->Bounds[1][0]; }
  /// Upper estimate of the bytes for reading.
  std::size_t EstimateBytes() const;

  // --- After the points have moved to their owners ---

  std::size_t GetCount() const { return this->Ids.size(); }
  const std::vector<std::int64_t>& GetIds() const { return this->Ids; }
  /// The points in the plane of the triangulation.
  ahd::PointView GetView() const;
  /// The input of the engine, with these constraints.
  ahd::BlockInput GetBlock(const ahd::BlockChains& chains) const;
  /// The points in space: floats or doubles.
  vtkDataArray* GetPlaces() const { return this->Places; }
  /// The same, handed over, with room for so many points; views of them become invalid.
  /// Throws std::bad_alloc.
  vtkSmartPointer<vtkDataArray> TakePlaces(std::size_t count);
  /// Their ghost marks; null if no rank has any.
  vtkUnsignedCharArray* GetMarks() const { return this->Marks; }

  /// The route of the points, for their data, and the data to send.
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
  ahd::Plane Plane; // of all ranks, if fitted
  std::array<ahd::Vector3, 2> Bounds = { { { { 1, 1, 1 } },
    { { 0, 0, 0 } } } }; // of all, if bounding points are added
  ahd::PreparedInput Prepared;
  ahd::BlockIds OwnIds;
  vtkAHDRoute Route;
  std::vector<std::int64_t> Ids;
  vtkSmartPointer<vtkDataArray> Places;
  std::vector<double> InPlane; // x, y, height; empty where the plane is x, y
  vtkSmartPointer<vtkUnsignedCharArray> Marks;
};

#endif
