// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankFacts_h
#define vtkAHDRankFacts_h

#include "Engine/Core/Fingerprint.h"
#include "Engine/Result.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Ranks/vtkAHDArrayFacts.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

class vtkAHDContext;
class vtkAHDRanks;
class vtkPointSet;
class vtkPolyData;
struct vtkAHDDataSets;

/// The description of a rank before the work begins: settings, input and source.
struct vtkAHDRankFacts
{
  std::vector<double> Settings; ///< that must be the same on all
  std::vector<double> Transform;
  std::uint64_t Points = 0;             ///< of the input
  std::uint64_t SourcePoints = 0;       ///< to be added
  std::uint64_t Segments = 0;           ///< at most
  std::uint64_t Host = 0;               ///< names the machine
  std::uint64_t GhostLevels = 0;        ///< requested
  bool AreFloats = false;               ///< the coordinates of the input
  bool HasMarks = false;                ///< are there ghost marks?
  bool MarksAreUnfit = false;           ///< there are some, but not one for each point
  ahd::Fingerprint Source = {};         ///< of points and cells
  vtkAHDInput::SourceContent Content;   ///< the rest of the source
  std::vector<vtkAHDArrayFacts> Arrays; ///< that can be moved, without marks
  std::vector<std::string> OtherArrays; ///< that cannot

  /// See ahd::HasFields.
  auto fields()
  {
    return std::tie(this->Settings, this->Transform, this->Points, this->SourcePoints,
      this->Segments, this->Host, this->GhostLevels, this->AreFloats, this->HasMarks,
      this->MarksAreUnfit, this->Source, this->Content, this->Arrays, this->OtherArrays);
  }
};

/// Fills the settings.
void vtkAHDReadSettings(const vtkAHDSettings& settings, vtkAHDRankFacts& facts);

/// Fills in the points' data. `input` may be null.
void vtkAHDReadArrays(vtkPointSet* input, vtkAHDRankFacts& facts);

/// The fingerprint of the source's points and cells, if these have one; else one of its own.
ahd::Fingerprint vtkAHDFingerprintOf(
  vtkPolyData* source, std::size_t rank, const vtkAHDContext& context);

/// The descriptions of all ranks, on each rank.
class vtkAHDAllFacts
{
public:
  std::vector<vtkAHDRankFacts> Of; ///< of each rank

  std::size_t GetPoints() const;
  std::size_t GetSourcePoints() const;
  std::size_t GetSegments() const;
  bool AreFloats() const;
  bool HaveMarks() const;
  /// Layers of ghosts in the output: the most that any rank is asked for.
  int GetGhostLevels() const;

  /// Throws vtkAHDStop on all ranks if settings differ between ranks; `error` then names the first.
  void Compare(const vtkAHDSettings& own, std::string& error) const;
  /// The first setting without a method for several ranks: one of them must triangulate all points.
  /// Null if there is none.
  const char* FindUnfit(const vtkAHDSettings& settings) const;
  /// The arrays that all ranks with points have, in the order of the first of these; if no rank has
  /// points, those that all ranks with arrays have.
  std::vector<vtkAHDArrayFacts> GetArrays() const;
  /// The points of a rank's input with these arrays; empty ones where there are no points. `input`
  /// may be null.
  vtkSmartPointer<vtkPolyData> SelectArrays(vtkPointSet* input) const;
  /// The arrays that only some have or that cannot be moved, "A, B"; empty if there is none.
  std::string GetPartialArrays() const;

  /// Do all ranks have the same source? Only if its points are added: ids differ between ranks.
  bool IsOneSource() const;
  /// A rank whose source counts.
  bool CountsSource(std::size_t rank) const { return rank == 0 || !this->IsOneSource(); }
  /// The content of the sources that count besides lines and polygons.
  vtkAHDInput::SourceContent GetContent() const;
  /// The number of ranks on the machine of this one.
  std::size_t CountOnHostOf(std::size_t rank) const;

private:
  std::vector<const vtkAHDRankFacts*> GetThoseWithData() const; ///< whose arrays count
};

/// Stops all ranks if the input of one failed (`before` is not Ok, and reported there): `error` is
/// then reported by all. Collective; throws vtkAHDStop on all ranks.
void vtkAHDCheckBefore(
  ahd::Status before, vtkAHDRanks& ranks, const vtkAHDContext& context, std::string& error);

/// Shares the descriptions of all ranks. Collective; throws vtkAHDStop on all ranks if one
/// fails.
void vtkAHDMeet(const vtkAHDSettings& settings, const vtkAHDDataSets& data, vtkAHDRanks& ranks,
  const vtkAHDContext& context, vtkAHDAllFacts& facts);

#endif
