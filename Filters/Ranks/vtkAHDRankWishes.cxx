// SPDX-License-Identifier: BSD-3-Clause
//
// What ranks compare before they interpolate.
#include "Ranks/vtkAHDArrayFacts.h"
#include "Ranks/vtkAHDRankSampling.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <utility>

namespace
{
/// By name, as they are to be the same on all ranks.
std::vector<std::pair<const char*, double>> NumbersOf(
  const vtkAHDSampleSettings& wishes, bool hasPlaces)
{
  return {
    { "whether there are places", hasPlaces },
    { "Method", double(wishes.Method) },
    { "RasterSize", wishes.Raster.ByCellSize },
    { "Dimensions", double(wishes.Raster.Dimensions[0]) },
    { "Dimensions", double(wishes.Raster.Dimensions[1]) },
    { "CellSize", wishes.Raster.CellSize[0] },
    { "CellSize", wishes.Raster.CellSize[1] },
    { "AlignToCellSize", wishes.Raster.Align },
    { "UseBounds", wishes.UseBounds },
    { "Bounds", wishes.Bounds[0] },
    { "Bounds", wishes.Bounds[1] },
    { "Bounds", wishes.Bounds[2] },
    { "Bounds", wishes.Bounds[3] },
    { "OutputType", wishes.AsSurface },
    { "Outside", wishes.NearestOutside },
    { "NoValue", wishes.NoValue },
    { "GenerateGradients", wishes.Gradients },
  };
}
}

/// Stops all if they do not want the same, or have places in blocks, of which others may have
/// others.
void vtkAHDRankSampling::CompareWishes(vtkDataObject* places)
{
  const bool hasPlaces = places != nullptr;
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  const auto numbers = NumbersOf(this->Wishes, hasPlaces);
  const bool areFit = !hasPlaces || vtkDataSet::SafeDownCast(places);
  if (this->Ranks.agree(areFit ? ahd::Status::Ok : ahd::Status::Cancelled) != ahd::Status::Ok)
  {
    this->Error = "Places of several blocks are interpolated on one rank only. Nothing was "
                  "computed. Merge the blocks before (Merge Blocks).";
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
  this->Ranks.Together(this->Context,
    [&]
    {
      ahd::BytesWriter writer(own);
      for (const auto& number : numbers)
      {
        writer.write(number.second);
      }
      vtkAHDWriteText(writer, this->Wishes.Heights);
      vtkAHDWriteText(writer, this->Wishes.Mask);
    });
  this->Context.Check(this->Ranks.gather(own, all));
  for (std::size_t rank = 1; rank < all.size(); ++rank)
  {
    if (all[rank] == all[0])
    {
      continue;
    }
    const auto isOther = [&](std::size_t k)
    {
      constexpr std::size_t kSize = sizeof(double);
      return !std::equal(all[0].data() + k * kSize, all[0].data() + (k + 1) * kSize,
        all[rank].data() + k * kSize); // NaN equals NaN
    };
    std::size_t k = 0;
    while (k < numbers.size() && !isOther(k))
    {
      ++k;
    }
    this->Error = std::string(k < numbers.size() ? numbers[k].first : "A name of an array") +
      " is not the same on ranks 0 and " + std::to_string(rank) +
      ". Values are interpolated over ranks only where all have the same settings. Nothing was "
      "computed.";
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
}
