// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankSampling.h"

#include "Engine/Points/JoinedBounds.h"
#include "Engine/Sample/BoxNeighbors.h"
#include "Execution/vtkAHDMessages.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDSay.h"
#include "Ranks/vtkAHDArrayFacts.h"
#include "Sampling/vtkAHDPlaces.h"
#include "Sampling/vtkAHDSampleBounds.h"
#include "Sampling/vtkAHDSampleMessages.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <tuple>
#include <utility>

namespace
{
/// In so many boxes a rank tells where its places are.
constexpr std::size_t kMostBoxes = 64;

/// Hears what one rank has to say, for all to say it alike.
class Hearing : public vtkCommand
{
public:
  vtkTypeMacro(Hearing, vtkCommand);
  static Hearing* New() { return new Hearing; }

  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    try
    {
      this->Hear(event, text);
    }
    catch (const std::bad_alloc&)
    {
    }
  }

  std::string Error;
  std::vector<std::string> Warnings;

private:
  void Hear(unsigned long event, void* text)
  {
    // Without the place in the source code, and the object, before it.
    const std::string all = text ? static_cast<const char*>(text) : "";
    const std::size_t begin = all.find("): ");
    std::string words = begin == std::string::npos ? all : all.substr(begin + 3);
    words.erase(words.find_last_not_of(" \n") + 1);
    if (event == vtkCommand::WarningEvent)
    {
      this->Warnings.push_back(words);
    }
    else if (this->Error.empty())
    {
      this->Error = words;
    }
  }
};

/// What one rank found.
struct Found
{
  bool IsDone = false, IsAborted = false;
  ahd::SampleReport Counts;
  ahd::Bounds Wanted;
  double Seconds = 0.0;
  std::string Error;
  std::vector<vtkAHDMissingValues> Missing;

  auto fields()
  {
    return std::tie(this->IsDone, this->IsAborted, this->Counts, this->Wanted, this->Seconds,
      this->Error, this->Missing);
  }
};
}

vtkAHDRankSampling::vtkAHDRankSampling(vtkAlgorithm* filter, const vtkAHDSettings& settings,
  const vtkAHDSampleSettings& wishes, vtkAHDRanks& ranks, const vtkAHDContext& context)
  : Filter(filter)
  , Settings(settings)
  , Wishes(wishes)
  , Ranks(ranks)
  , Context(context)
{
}

/// Of the points of all, and their number. Throws vtkAHDStop on all ranks.
ahd::Bounds vtkAHDRankSampling::FindBounds(const Inputs& inputs, std::size_t& points)
{
  std::string said; // by Run()
  vtkAHDCheckBefore(inputs.Before, this->Ranks, this->Context, said);
  vtkAHDSettings settings = this->Settings;
  settings.tolerance = 0.0; // only what determines the points' positions
  settings.split = false;
  settings.sourceHeights = ahd::SourceHeights::Own;
  settings.maximumSegmentLength = 0.0;
  vtkAHDAllFacts facts;
  vtkAHDMeet(settings, inputs.Data, this->Ranks, this->Context, facts);
  facts.Compare(settings, said);
  points = facts.GetPoints();
  this->Ranks.Together(this->Context, [&] { this->FindScalars(facts); });
  if (this->Wishes.UseBounds)
  {
    return ahd::Bounds(); // they do not matter
  }
  vtkAHDRankPoints own(settings, this->Ranks, facts, this->Context);
  own.Read(inputs.Data.Input, inputs.Data.Source);
  ahd::Bounds bounds;
  for (const ahd::Bounds& one : this->Ranks.Share(
         this->Context, [&] { return vtkAHDBoundsOf(own.GetPrepared().points(), this->Context); }))
  {
    bounds = ahd::joined(bounds, one);
  }
  return bounds;
}

/// The same on all ranks.
vtkAHDRaster vtkAHDRankSampling::MakeRaster(const vtkAHDRankSamples& samples)
{
  const std::size_t points = samples.GetGivenPoints();
  if (this->Wishes.UseBounds)
  {
    return vtkAHDMakeRasterWithin(this->Wishes.Raster, this->Wishes.Bounds, points);
  }
  ahd::Bounds bounds;
  this->Ranks.Together(this->Context,
    [&]
    {
      bounds = samples.IsWhole()
        ? vtkAHDFindBounds(this->Settings, samples.GetInput(), samples.GetSource(), this->Context)
        : samples.GetBounds();
      for (double* bound : { &bounds.xmin, &bounds.xmax, &bounds.ymin, &bounds.ymax })
      {
        *bound += 0.0; // of zeros of both signs it is chance which one comes first
      }
    });
  return vtkAHDMakeRaster(this->Wishes.Raster, bounds, points);
}

vtkAHDRaster vtkAHDRankSampling::PieceOf(const vtkAHDRaster& whole, const Inputs& inputs)
{
  vtkAHDRaster piece = whole;
  std::array<int, 6> extent = inputs.Extent;
  std::array<int, 6> made = { { 0, static_cast<int>(whole.Cells.columns) - 1, 0,
    static_cast<int>(whole.Cells.rows) - 1, 0, whole.Fault == vtkAHDRasterFault::None ? 0 : -1 } };
  const bool isAsTold = made == inputs.Whole;
  this->OtherRaster = this->Ranks.IsAny(!isAsTold);
  if (this->OtherRaster)
  {
    // The requested piece is that of another raster.
    vtkNew<vtkExtentTranslator> translator;
    const std::array<int, 3>& asked = inputs.Piece;
    if (translator->PieceToExtentThreadSafe(asked[0], asked[1], asked[2], made.data(),
          extent.data(), vtkExtentTranslator::BLOCK_MODE, 0) == 0)
    {
      extent = { { 0, -1, 0, -1, 0, -1 } };
    }
  }
  const auto cut = [](int low, int high, std::size_t& first, std::size_t& count)
  {
    const long long begin = std::max(low, 0);
    const long long end = std::min<long long>(high + 1LL, static_cast<long long>(count));
    first = begin < end ? static_cast<std::size_t>(begin) : 0;
    count = begin < end ? static_cast<std::size_t>(end - begin) : 0;
  };
  ahd::SampleRaster& cells = piece.Cells;
  cut(extent[0], extent[1], cells.firstColumn, cells.columns);
  cut(extent[2], extent[3], cells.firstRow, cells.rows);
  if (cells.columns == 0 || cells.rows == 0)
  {
    cells.columns = cells.rows = cells.firstColumn = cells.firstRow = 0;
  }
  return piece;
}

/// Pieces have borders in common: a place counts on the first rank that has it.
void vtkAHDRankSampling::FindOthers(const vtkAHDRaster& piece)
{
  this->PiecesBefore = this->Ranks.Share(this->Context, [&] { return piece.Cells; });
  this->PiecesBefore.resize(this->Ranks.GetOwn());
}

/// Where this rank's places are, in the plane of the triangulation.
std::vector<ahd::Bounds> vtkAHDRankSampling::BoxesOf(
  const Inputs& inputs, const vtkAHDRaster& piece) const
{
  std::vector<ahd::Bounds> boxes;
  if (inputs.Places)
  {
    vtkAHDPlaces places(vtkDataSet::SafeDownCast(inputs.Places));
    const ahd::PointView view = places.Open(this->Settings, ahd::PreparedInput(), this->Context);
    this->Context.Check(ahd::coverByBoxes(view, kMostBoxes, this->Context, boxes));
    return boxes;
  }
  const ahd::SampleRaster& cells = piece.Cells;
  if (cells.columns > 0)
  {
    const ahd::Point low = cells.at(0, 0), high = cells.at(cells.columns - 1, cells.rows - 1);
    boxes.push_back({ low.x, high.x, low.y, high.y });
  }
  return boxes;
}

bool vtkAHDRankSampling::Run(const Inputs& inputs, vtkDataObject* output)
{
  bool isDone = false;
  const ahd::Status status = this->Ranks.Execute(
    [&] { isDone = this->RunTogether(inputs, output); });
  isDone = isDone && status == ahd::Status::Ok;
  if (!isDone)
  {
    output->Initialize();
  }
  vtkAHDSayOutOfMemory("vtkAdaptiveHilbertInterpolation2D", [&] { this->SayError(status); });
  return isDone;
}

/// What Execute() has returned, on all ranks alike.
void vtkAHDRankSampling::SayError(ahd::Status status)
{
  this->Aborted = status == ahd::Status::Cancelled && this->Error.empty();
  if (!this->Error.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << this->Error);
  }
  else if (status == ahd::Status::OutOfMemory)
  {
    vtkErrorWithObjectMacro(
      this->Filter, "Out of memory on a rank while interpolating. The output is empty.");
  }
  else if (status == ahd::Status::TooManyPoints)
  {
    vtkErrorWithObjectMacro(
      this->Filter, "A rank has too many points to be triangulated. The output is empty.");
  }
  else if (status == ahd::Status::BadCells)
  {
    vtkAHDSayBadCells(this->Filter, nullptr, {});
  }
}

/// Returns false on all ranks if there is an error that each has said. Throws as FindRaster().
bool vtkAHDRankSampling::RunTogether(const Inputs& inputs, vtkDataObject* output)
{
  using Also = ahd::BlockNeeds::Also;
  const Also also = this->Wishes.IsNearest()                    ? Also::Nearest
    : this->Wishes.Outside == ahd::OutsideValues::Boundary      ? Also::All
    : this->Wishes.Outside == ahd::OutsideValues::NearestVertex ? Also::Nearest
                                                                : Also::Nothing;
  vtkAHDRankSamples samples(this->Settings, this->Ranks, this->Context, also, this->Error);
  this->MeetAll(inputs);
  samples.Begin(inputs.Data, inputs.Before);
  if (!vtkAHDAreNamesFit(this->Filter, this->Wishes)) // on all ranks alike
  {
    return false;
  }
  vtkAHDRaster piece;
  if (!inputs.Places)
  {
    const vtkAHDRaster whole = this->MakeRaster(samples);
    if (whole.Fault != vtkAHDRasterFault::None && whole.Fault != vtkAHDRasterFault::NoArea)
    {
      vtkAHDSayNoRaster(this->Filter, this->Wishes, whole);
      return false;
    }
    piece = this->PieceOf(whole, inputs);
    this->FindOthers(piece);
  }
  std::vector<ahd::Bounds> boxes;
  this->Ranks.Together(this->Context,
    [&]
    {
      if (!samples.IsWhole())
      {
        boxes = this->BoxesOf(inputs, piece);
      }
    });
  const ahd::Bounds bounds = samples.IsWhole() ? ahd::Bounds() : samples.GetBounds();
  samples.Take(boxes);
  this->Result.Surface = bounds;
  this->Interpolate(inputs, piece, samples, vtkDataSet::SafeDownCast(output));
  return true;
}

/// Each rank by itself; then all hear how it went.
void vtkAHDRankSampling::Interpolate(const Inputs& inputs, const vtkAHDRaster& piece,
  const vtkAHDRankSamples& samples, vtkDataSet* output)
{
  vtkAHDSampleInputs local;
  local.Points = samples.GetInput();
  local.Source = samples.GetSource();
  local.AddedPoints = samples.GetAddedPoints();
  local.Places = vtkDataSet::SafeDownCast(inputs.Places);
  local.Raster = inputs.Places ? nullptr : &piece;
  local.PiecesBefore = &this->PiecesBefore;
  vtkNew<vtkAlgorithm> speaker;
  vtkNew<Hearing> hearing;
  speaker->AddObserver(vtkCommand::ErrorEvent, hearing);
  speaker->AddObserver(vtkCommand::WarningEvent, hearing);
  vtkAHDSampleMemoryKept none;
  vtkAHDSampleExecution execution(
    speaker, samples.GetLocalSettings(), this->Wishes, this->Context, false);
  const bool isDone = execution.Run(local, none, output);
  this->Estimate = execution.GetMemory().Estimate;
  this->Share(execution, isDone, hearing->Error, samples);
  if (auto* surface = vtkStructuredGrid::SafeDownCast(inputs.Places ? nullptr : output))
  {
    this->LowerHidden(surface);
  }
  else if (!inputs.Places)
  {
    this->MarkAlike(output);
  }
  this->Say(execution, samples, hearing->Warnings);
}

void vtkAHDRankSampling::Share(const vtkAHDSampleExecution& execution, bool isDone,
  const std::string& error, const vtkAHDRankSamples& samples)
{
  const vtkAHDSampleResult& mine = execution.GetResult();
  std::vector<Found> all;
  const auto make = [&](Found& found) // not Share(): an abort is told with the rest
  {
    found = { isDone, !isDone && this->Context.IsAborted(), mine.Counts, mine.Wanted,
      execution.GetSeconds(), error, mine.Missing };
    return ahd::Status::Ok;
  };
  this->Context.Check(ahd::share(this->Ranks, make, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < all.size(); ++rank)
      {
        const Found& one = all[rank];
        if (!one.IsDone && this->Error.empty() && !one.IsAborted)
        {
          this->Error = "Rank " + std::to_string(rank) + ": " +
            (one.Error.empty() ? "the interpolation failed. The output is empty." : one.Error);
        }
        this->Aborted = this->Aborted || one.IsAborted;
        ahd::addCounts(one.Counts, this->Result.Counts);
        this->Result.AddMissing(one.Missing);
        this->Result.Wanted = ahd::joined(this->Result.Wanted, one.Wanted);
        this->Seconds = std::max(this->Seconds, one.Seconds);
      }
    });
  if (!this->Error.empty() || this->Aborted)
  {
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
  if (samples.IsWhole())
  {
    this->Result.Surface = mine.Surface;
    this->Result.Triangles = mine.Triangles;
  }
}

/// Hidden points lie at the lowest height of all ranks.
void vtkAHDRankSampling::LowerHidden(vtkStructuredGrid* surface)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  auto* marks = vtkArrayDownCast<vtkUnsignedCharArray>(
    surface->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  auto* places = surface->GetPoints()
    ? vtkArrayDownCast<vtkDoubleArray>(surface->GetPoints()->GetData())
    : nullptr;
  const vtkIdType count = marks && places ? marks->GetNumberOfTuples() : 0;
  double least = kInfinity;
  for (const double own : this->Ranks.Share(this->Context,
         [&]
         {
           double lowest = kInfinity;
           for (vtkIdType i = 0; i < count; ++i)
           {
             lowest = marks->GetValue(i) == 0 ? std::min(lowest, places->GetValue(3 * i + 2))
                                              : lowest;
           }
           return lowest;
         }))
  {
    least = std::min(least, own);
  }
  least = std::isfinite(least) ? least + 0.0 : 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (marks->GetValue(i) != 0)
    {
      places->SetValue(3 * i + 2, least);
    }
  }
}

/// Pieces of one image have the same arrays: all the marks of hidden points, or none.
void vtkAHDRankSampling::MarkAlike(vtkDataSet* image)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  const bool isMarked = image->GetPointData()->HasArray(name) != 0;
  if (this->Ranks.IsAny(isMarked) && !isMarked)
  {
    auto marks = vtkAHDNewArray<vtkUnsignedCharArray>(image->GetNumberOfPoints());
    marks->SetName(name);
    marks->FillValue(0);
    image->GetPointData()->AddArray(marks);
  }
}

/// On the first rank.
void vtkAHDRankSampling::Say(const vtkAHDSampleExecution& execution,
  const vtkAHDRankSamples& samples, const std::vector<std::string>& warnings)
{
  if (this->Ranks.GetOwn() != 0)
  {
    return;
  }
  if (samples.IsWhole())
  {
    vtkAHDSayWarnings(this->Filter, samples.GetLocalSettings(), execution.GetReport());
  }
  for (const std::string& warning : warnings) // of arrays
  {
    vtkWarningWithObjectMacro(this->Filter, << warning);
  }
  if (this->HaveSurface)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The input is a surface made by vtkAdaptiveHilbertDelaunay2D. Its points are triangulated "
      "again with the settings of Triangulation: its own triangles are not used across ranks.");
  }
  vtkAHDSayPlaceWarnings(this->Filter, this->Result);
  if (!samples.GetWarning().empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << samples.GetWarning());
  }
}
