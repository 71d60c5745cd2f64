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
 * The part of all ranks' points that one rank needs to interpolate at its own places as if it had
 * all: the points around these places (Engine/Distribute/BlockNeeds.h), with their
 * data, and all constraints. Each rank continues with them alone. With settings that have no
 * method for several ranks, each gets all points.
 *
 * Collective; throws vtkAHDStop on all ranks if one fails.
 */
class vtkAHDRankSamples
{
public:
  /// Borrows all of them. `also`: what is needed beside the surface around places. `error` becomes
  /// the error that all ranks report instead of that of the status.
  vtkAHDRankSamples(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
    const vtkAHDContext& context, ahd::BlockNeeds::Also also, std::string& error);
  ~vtkAHDRankSamples();

  /// Shares the descriptions of all ranks, and moves points to their owners. `before`: the reason
  /// if this rank's input failed.
  void Begin(const vtkAHDDataSets& data, ahd::Status before);

  /// Does each rank get all points?
  bool IsWhole() const { return this->Setting != nullptr; }
  /// The bounds of all triangulated points, in their plane. @pre Begin(), !IsWhole().
  ahd::Bounds GetBounds() const { return this->Needs->bounds(); }

  /// Gets the points needed for places in these boxes; none for no place. @pre Begin(). If
  /// IsWhole(), they are there already.
  void Take(const std::vector<ahd::Bounds>& boxes);

  // --- After that ---

  /// The input and source for a single rank, with these settings.
  vtkPolyData* GetInput() const { return this->Input; }
  vtkPolyData* GetSource() const { return this->Source; }
  const vtkAHDSettings& GetLocalSettings() const { return this->LocalSettings; }
  /// The number of points of all ranks, those of sources included.
  std::size_t GetPoints() const { return this->Facts.GetPoints() + this->Facts.GetSourcePoints(); }

  /// The same without those of sources.
  std::size_t GetGivenPoints() const { return this->Facts.GetPoints(); }

  /// The number of points of sources, the last ones of the input.
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
  const ahd::BlockNeeds::Also Also;
  vtkAHDAllFacts Facts;
  const char* Setting = nullptr; // for which each gets all
  std::unique_ptr<vtkAHDRankPoints> Points;
  ahd::BlockChains Chains;
  std::unique_ptr<ahd::BlockNeeds> Needs;
  std::size_t AddedPoints = 0;
  vtkSmartPointer<vtkPolyData> Input, Source;
  std::string& Error;
  std::string Warning;
};

#endif
