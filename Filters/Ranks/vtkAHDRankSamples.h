// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankSamples_h
#define vtkAHDRankSamples_h

#include "Engine/Distribute/BlockChains.h"
#include "Engine/Distribute/BlockNeeds.h"
#include "Execution/vtkAHDExecution.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Ranks/vtkAHDRankFacts.h"
#include "Ranks/vtkAHDRankPoints.h"
#include "Ranks/vtkAHDRanks.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

/**
 * What one rank needs of all ranks' points to interpolate at places of its own as one rank would
 * that had them all: the points around these places (Engine/Distribute/BlockNeeds.h), with their
 * data, and all constraints. It goes on with them alone. Where a setting asks for what ranks have
 * no method for, each gets all.
 *
 * Collective; throws vtkAHDStop on all ranks if one cannot go on.
 */
class vtkAHDRankSamples
{
public:
  /// Borrows all of them. `asksForNearest`: the nearest vertices are wanted. `error` becomes what
  /// all ranks say alike, instead of the words for the reason why they stop.
  vtkAHDRankSamples(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
    const vtkAHDContext& context, bool asksForNearest, std::string& error);
  ~vtkAHDRankSamples();

  /// Hears what all have, and moves points to where they are asked for. `before`: why this rank has
  /// no input, if it could not get it.
  void Begin(const vtkAHDDataSets& data, ahd::Status before);

  /// Does each rank get all?
  bool IsWhole() const { return this->Setting != nullptr; }
  /// Of all points that are triangulated, in their plane. REQUIRES: Begin(), !IsWhole().
  ahd::Bounds GetBounds() const { return this->Needs->bounds(); }

  /// Takes what is needed for places in these boxes; none for no place. REQUIRES: Begin(). Where
  /// IsWhole() it has been taken already.
  void Take(const std::vector<ahd::Bounds>& boxes);

  // --- Then ---

  /// As input and source of one rank, with these settings.
  vtkPolyData* GetInput() const { return this->Input; }
  vtkPolyData* GetSource() const { return this->Source; }
  const vtkAHDSettings& GetLocalSettings() const { return this->LocalSettings; }
  /// How many points all ranks have, those of sources included.
  std::size_t GetPoints() const { return this->Facts.GetPoints() + this->Facts.GetSourcePoints(); }

  /// How many of the last points of the input are those of sources.
  std::size_t GetAddedPoints() const { return this->AddedPoints; }

  const std::string& GetWarning() const { return this->Warning; }

private:
  void CheckMemory(std::size_t bytes);
  void TakeAll(const vtkAHDDataSets& data);
  void ShareOwn();
  void MoveNeeded(const std::vector<ahd::BlockPoint>& needed);
  void MakeSource(const std::vector<ahd::BlockPoint>& needed);

  const vtkAHDSettings& Settings;
  vtkAHDSettings LocalSettings;
  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
  const bool AsksForNearest;
  vtkAHDAllFacts Facts;
  const char* Setting = nullptr; // that each gets all for
  std::unique_ptr<vtkAHDRankPoints> Points;
  ahd::BlockChains Chains;
  std::unique_ptr<ahd::BlockNeeds> Needs;
  std::size_t AddedPoints = 0;
  vtkSmartPointer<vtkPolyData> Input, Source;
  std::string& Error;
  std::string Warning;
};

#endif
