// SPDX-License-Identifier: BSD-3-Clause
//
// What ranks compare before they interpolate, and what they say of the output before there are
// data.
#include "Ranks/vtkAHDArrayFacts.h"
#include "Ranks/vtkAHDRankSampling.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

namespace
{
/// Is it one rank's piece of a surface that vtkAdaptiveHilbertDelaunay2D made? Its field data are
/// those of all pieces: vtkAHDFindSurface() knows whole ones.
bool IsOfSurface(vtkDataObject* input)
{
  auto* piece = vtkPolyData::SafeDownCast(input);
  return piece && piece->GetNumberOfPolys() > 0 &&
    piece->GetFieldData()->HasArray("NumberOfTriangles") != 0 &&
    piece->GetFieldData()->HasArray("NumberOfPointsInserted") != 0;
}
}

vtkAHDRankSampling::Meeting vtkAHDRankSampling::Meet(const Inputs& inputs)
{
  struct Head
  {
    std::uint64_t AreUnfit, IsSurface;
  };
  const bool hasPlaces = inputs.Places != nullptr;
  std::vector<std::pair<const char*, double>> numbers;
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      const auto& settings = this->Wishes.OfRanks.Numbers;
      numbers.emplace_back("whether there are places", hasPlaces);
      numbers.insert(numbers.end(), settings.begin(), settings.end());
      ahd::BytesWriter writer(own);
      writer.write(Head{ hasPlaces && !vtkDataSet::SafeDownCast(inputs.Places),
        !inputs.Data.Source && IsOfSurface(inputs.Data.Input) });
      for (const auto& number : numbers)
      {
        writer.write(number.second);
      }
      for (const std::string& text : this->Wishes.OfRanks.Texts)
      {
        vtkAHDWriteText(writer, text);
      }
    });
  this->Context.Check(this->Ranks.gather(own, all));
  Meeting meeting;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    const auto head = ahd::BytesReader(all[rank]).read<Head>();
    meeting.AreUnfit = meeting.AreUnfit || head.AreUnfit != 0;
    this->HaveSurface = this->HaveSurface || head.IsSurface != 0;
    const auto begin = static_cast<std::ptrdiff_t>(sizeof(Head));
    const bool isSame = all[rank].size() == all[0].size() &&
      std::equal(all[rank].begin() + begin, all[rank].end(), all[0].begin() + begin);
    if (isSame || meeting.Other > 0)
    {
      continue;
    }
    meeting.Other = rank;
    const auto isOther = [&](std::size_t k)
    {
      constexpr std::size_t kSize = sizeof(double);
      const std::size_t at = sizeof(Head) + k * kSize;
      return !std::equal(all[0].data() + at, all[0].data() + at + kSize,
        all[rank].data() + at); // NaN equals NaN
    };
    std::size_t k = 0;
    while (k < numbers.size() && !isOther(k))
    {
      ++k;
    }
    meeting.Difference = k < numbers.size() ? numbers[k].first : "A name of an array";
  }
  return meeting;
}

/// Stops all if they do not want the same, or have places in blocks, of which others may have
/// others.
void vtkAHDRankSampling::MeetAll(const Inputs& inputs)
{
  const Meeting meeting = this->Meet(inputs);
  if (meeting.AreUnfit)
  {
    this->Error = "Over ranks, places must be a data set without blocks. Nothing was computed. "
                  "Merge blocks before (Merge Blocks).";
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
  if (meeting.Other > 0)
  {
    this->Error = std::string(meeting.Difference) + " is not the same on ranks 0 and " +
      std::to_string(meeting.Other) +
      ". Values are interpolated over ranks only where all have the same settings. Nothing was "
      "computed.";
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
}

vtkAHDRaster vtkAHDRankSampling::FindRaster(const Inputs& inputs)
{
  if (this->Meet(inputs).Other > 0)
  {
    throw vtkAHDStop{ ahd::Status::Cancelled }; // which Run() says
  }
  const ahd::Bounds bounds = this->FindBounds(inputs);
  return this->Wishes.UseBounds ? vtkAHDMakeRasterWithin(this->Wishes.Raster, this->Wishes.Bounds)
                                : vtkAHDMakeRaster(this->Wishes.Raster, bounds);
}

/// What the active scalars of the output will be, of the arrays that all ranks have.
void vtkAHDRankSampling::FindScalars(const vtkAHDAllFacts& facts)
{
  vtkNew<vtkPointData> data;
  for (const vtkAHDArrayFacts& array : facts.GetArrays())
  {
    array.AddTo(data, array.Make(0));
  }
  this->Scalars = vtkAHDSampleColumns(this->Wishes, data, data, 0).GetKindOfScalars();
}
