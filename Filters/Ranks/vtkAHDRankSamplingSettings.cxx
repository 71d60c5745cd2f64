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
#include <cstring>
#include <new>
#include <tuple>
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

/// What one rank says of itself.
struct Wish
{
  bool AreUnfit = false, IsSurface = false;
  std::vector<double> Numbers;
  std::vector<std::string> Texts;

  auto fields() { return std::tie(this->AreUnfit, this->IsSurface, this->Numbers, this->Texts); }
};

bool IsSame(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0; // NaN is NaN
}
}

vtkAHDRankSampling::Meeting vtkAHDRankSampling::Meet(const Inputs& inputs)
{
  const bool hasPlaces = inputs.Places != nullptr;
  std::vector<std::pair<const char*, double>> numbers;
  const auto all = this->Ranks.Share(this->Context,
    [&]
    {
      const auto& settings = this->Wishes.OfRanks.Numbers;
      numbers.emplace_back("whether there are places", hasPlaces);
      numbers.insert(numbers.end(), settings.begin(), settings.end());
      Wish own{ hasPlaces && !vtkDataSet::SafeDownCast(inputs.Places),
        !inputs.Data.Source && IsOfSurface(inputs.Data.Input), {}, this->Wishes.OfRanks.Texts };
      for (const auto& number : numbers)
      {
        own.Numbers.push_back(number.second);
      }
      return own;
    });
  Meeting meeting;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    const Wish &first = all[0], &own = all[rank];
    meeting.AreUnfit = meeting.AreUnfit || own.AreUnfit;
    this->HaveSurface = this->HaveSurface || own.IsSurface;
    const auto other = std::mismatch(
      first.Numbers.begin(), first.Numbers.end(), own.Numbers.begin(), IsSame);
    const bool isOther = other.first != first.Numbers.end();
    if (meeting.Other == 0 && (isOther || own.Texts != first.Texts))
    {
      meeting.Other = rank;
      meeting.Difference = isOther
        ? numbers[static_cast<std::size_t>(other.first - first.Numbers.begin())].first
        : "A name of an array";
    }
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
    this->Error = "On several ranks, places must be a data set without blocks. Nothing was "
                  "computed. Merge the blocks first (Merge Blocks).";
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
  std::size_t points = 0;
  const ahd::Bounds bounds = this->FindBounds(inputs, points);
  return this->Wishes.UseBounds
    ? vtkAHDMakeRasterWithin(this->Wishes.Raster, this->Wishes.Bounds, points)
    : vtkAHDMakeRaster(this->Wishes.Raster, bounds, points);
}

/// The active scalars of the output, among the arrays that all ranks have.
void vtkAHDRankSampling::FindScalars(const vtkAHDAllFacts& facts)
{
  vtkNew<vtkPointData> data;
  for (const vtkAHDArrayFacts& array : facts.GetArrays())
  {
    array.AddTo(data, array.Make(0));
  }
  this->Scalars = vtkAHDSampleColumns(this->Wishes, data, data, 0).GetKindOfScalars();
}
