// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDMessages.h"

#include "Execution/vtkAHDReport.h"
#include "Pipeline/vtkAHDMemoryWords.h"
#include "Pipeline/vtkAHDSettings.h"

#include "vtkAlgorithm.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace
{
void SayTooManyBoxes(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  vtkErrorWithObjectMacro(filter,
    "The grid of " << report.Points << " points has more than " << report.MostBoxes
                   << " boxes. Putting out more may take more than "
                   << vtkAHDNeeded(report.Estimate) << " of memory, but "
                   << vtkAHDButAllowed(report.Limit, report.IsLimited)
                   << ". Nothing was computed. Switch GenerateBoxes off, take fewer points or a "
                      "larger Nmax, "
                   << vtkAHDOrSetLimit(report.Estimate));
}

void SayRefused(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  vtkErrorWithObjectMacro(filter,
    "Triangulating " << report.Points << " points may take " << vtkAHDNeeded(report.Estimate)
                     << " of memory, but " << vtkAHDButAllowed(report.Limit, report.IsLimited)
                     << ". Nothing was computed. Take fewer points, switch off outputs that are "
                        "not needed, "
                     << vtkAHDOrSetLimit(report.Estimate));
}

void SayTooManyCrossings(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  vtkErrorWithObjectMacro(filter,
    "The lines and polygons of the source cross in more than "
      << report.MostCrossings << " places. Splitting them there and triangulating " << report.Points
      << " points and the crossings may take more than " << vtkAHDNeeded(report.Estimate)
      << " of memory, but " << vtkAHDButAllowed(report.Limit, report.IsLimited)
      << ". Nothing was computed. Take fewer lines, switch CrossingMode to Leave Out, "
      << vtkAHDOrSetLimit(report.Estimate));
}

void SayOutOfMemory(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  const bool isLimited = report.IsLimited && report.Estimate > report.Limit;
  vtkErrorWithObjectMacro(filter,
    "Out of memory while triangulating "
      << report.Points << " points; about " << vtkAHDNeeded(report.Estimate) << " are needed"
      << (isLimited ? ", and " + vtkAHDButAllowed(report.Limit, true) : std::string())
      << ". Take fewer points, or switch off outputs that are not needed.");
}

void WarnOfPlane(vtkAlgorithm* filter, const vtkAHDSettings& settings)
{
  if (settings.TransformIsMissing)
  {
    vtkWarningWithObjectMacro(filter,
      "ProjectionPlaneMode asks for a Transform, but none is set: the points were triangulated in "
      "x and y.");
  }
  if (settings.Bounding && !settings.AddsBounding())
  {
    vtkWarningWithObjectMacro(filter,
      "There is no bounding triangulation, because the points are triangulated in another plane "
      "than x and y.");
  }
}

void WarnOfPoints(vtkAlgorithm* filter, const vtkAHDSettings& settings, const vtkAHDReport& report)
{
  if (report.MarksAreUnfit)
  {
    vtkWarningWithObjectMacro(filter,
      "The point data array "
        << vtkDataSetAttributes::GhostArrayName() << " does not have one value for each of the "
        << report.InputPoints
        << " points, or is not of type unsigned char, so no point was skipped.");
  }
  if (report.Counts.notFinite > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.Counts.notFinite << " of " << report.Points << " points were left out, since "
         << (settings.IsProjected() ? "they have no finite place in the plane of the triangulation"
                                    : "their x or y is NaN or infinite")
         << "; the first is point " << report.OddPoints.firstNotFinite << ".");
  }
  if (report.OddPoints.oddZ > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.OddPoints.oddZ << " of " << report.Points
         << " points have a z that is NaN or infinite. They are part of the triangulation, which "
            "is computed in x and y, but cannot be drawn.");
  }
}

/// What to do where x and y do not tell the points apart.
const char* const kOtherPlane =
  "To triangulate a wall, set ProjectionPlaneMode to Best-Fitting Plane";

void WarnOfNoTriangle(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  const ahd::Report& counts = report.Counts;
  const bool areFew = counts.inserted < 3;
  if (counts.beyondLimit > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "There is no triangle yet, because InsertionLimit has only the first "
        << counts.inserted << " of " << counts.inserted + counts.beyondLimit
        << " distinct points inserted, "
        << (areFew ? "fewer than three." : "and these are collinear."));
    return;
  }
  const std::string merged = report.MergedPoints == 0
    ? std::string()
    : ", of which Tolerance merged " + std::to_string(report.MergedPoints) + " into others";
  vtkWarningWithObjectMacro(filter,
    "There is no triangle, because "
      << (areFew ? "there are fewer than three distinct points: "
                 : "all distinct points are collinear: ")
      << counts.inserted << " distinct points among " << report.Points << merged << "."
      << (report.AreOnOneLine ? "" : " They are not collinear in space. ")
      << (report.AreOnOneLine ? "" : kOtherPlane) << (report.AreOnOneLine ? "" : "."));
}

void WarnOfStacks(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  if (report.AreStacked)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.Counts.duplicates << " of " << report.Points
         << " points have the x and y of others and lie above or below them: of each stack one "
            "point "
            "is in the surface (see DuplicatePolicy). "
         << kOtherPlane << "; of a volume mesh, triangulate one layer of points.");
  }
}

void WarnOfCells(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  if (report.IsDiagramInPlane)
  {
    vtkWarningWithObjectMacro(filter,
      "The Voronoi diagram lies in the plane z = 0, as Transform has no inverse to take it back to "
      "the points.");
  }
  if (report.Counts.triangles > 0 && report.Cells == 0)
  {
    vtkWarningWithObjectMacro(filter,
      "Nothing is put out: Alpha, its switches and MaximumEdgeLength leave none of "
        << report.Counts.triangles << (report.Counts.triangles == 1 ? " triangle" : " triangles")
        << ", no line and no vertex. Larger numbers keep more, and 0 is no limit.");
  }
  if (report.MayBeEmptiedByLoops)
  {
    vtkWarningWithObjectMacro(filter,
      "There is no triangle, because the polygons of the source keep none (see FillRule), or all "
      "distinct points are collinear.");
  }
  else if (report.DelaunayTriangles == 0 && report.Counts.inserted + report.Counts.notFinite > 0)
  {
    WarnOfNoTriangle(filter, report);
  }
  WarnOfStacks(filter, report);
  if (report.DelaunayTriangles > 0 && report.Counts.triangles + report.Counts.trimmed == 0)
  {
    vtkWarningWithObjectMacro(filter,
      "There is no triangle, because the polygons of the source keep none of the "
        << report.DelaunayTriangles << " triangles (see FillRule).");
  }
}

/// Of what is more than the slivers along a rim.
void WarnOfRim(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  constexpr double kMuch = 0.1;
  const ahd::Report& counts = report.Counts;
  if (counts.bareVertices == 0 && !(counts.trimmedArea > kMuch))
  {
    return;
  }
  const bool isEmpty = counts.triangles == 0;
  // NaN where areas are beyond all doubles
  const double part = std::min(1.0, std::max(0.0, counts.trimmedArea));
  const int percent = static_cast<int>(100.0 * part + 0.5);
  vtkWarningWithObjectMacro(filter,
    "" << (isEmpty ? "There is no triangle left: trimming" : "Trimming") << " the rim took "
       << (isEmpty ? "all " : "") << counts.trimmed << " of " << counts.triangles + counts.trimmed
       << " triangles away, " << percent << " % of the area in the plane, and left "
       << counts.bareVertices << (counts.bareVertices == 1 ? " point" : " points")
       << " without a triangle. Set Rim to Convex Hull to keep them all.");
}

/// "1 point, 2 vertices"; nothing of what there is none of.
std::string InWords(const vtkAHDInput::SourceContent& found)
{
  std::string words;
  const auto add = [&words](vtkIdType count, const char* one, const char* many)
  {
    if (count > 0)
    {
      words += (words.empty() ? "" : ", ") + std::to_string(count) + (count == 1 ? one : many);
    }
  };
  add(found.Points, " point", " points");
  add(found.Vertices, " vertex", " vertices");
  add(found.Strips, " triangle strip", " triangle strips");
  return words;
}

void WarnOfSource(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  const vtkAHDInput::SourceContent& found = report.Source;
  if (found.Points + found.Strips > 0 && report.Constraints.segments == 0)
  {
    vtkWarningWithObjectMacro(filter,
      "The source constrains nothing: it has no line and no polygon of two points or more. Found"
        << (found.Strips > 0 ? " (strips are ignored): " : ": ") << InWords(found) << ".");
  }
  else if (found.Strips > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << found.Strips << (found.Strips == 1 ? " triangle strip" : " triangle strips")
         << " of the source " << (found.Strips == 1 ? "is" : "are")
         << " ignored: lines and polygons constrain.");
  }
  if (report.PointsOffSurface > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.PointsOffSurface << " of " << found.Points
         << " points of the source lie outside the surface of the input and keep their own z (see "
            "SourceHeights).");
  }
}

void WarnOfConstraints(
  vtkAlgorithm* filter, const vtkAHDSettings& settings, const vtkAHDReport& report)
{
  const ahd::ConstraintReport& constraints = report.Constraints;
  // The engine counts pieces where segments were split.
  const std::string ofAll = settings.Split
    ? " segments or pieces of segments"
    : " of " + std::to_string(constraints.segments) + " segments";
  std::ostringstream loops;
  if (constraints.unfilledLoops > 0)
  {
    loops << " " << constraints.unfilledLoops
          << (constraints.unfilledLoops == 1 ? " polygon bounds" : " polygons bound")
          << " nothing, since a segment is missing.";
  }
  if (constraints.crossing > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << constraints.crossing << ofAll
         << " of the source were left out, since they cross others that come before "
            "them; the first is in cell "
         << report.FirstCrossing[0] << " and crosses cell " << report.FirstCrossing[1] << "."
         << loops.str());
    loops.str("");
  }
  if (report.BentConstraints > 0)
  {
    const bool isOne = report.BentConstraints == 1;
    vtkWarningWithObjectMacro(filter,
      "" << report.BentConstraints << (isOne ? " segment" : " segments") << " of the source bend"
         << (isOne ? "s" : "") << " by rounding, led through a point that is not exactly on "
         << (isOne ? "it" : "them") << "; the first is in cell " << report.FirstBentCell << ".");
  }
  if (report.UnfitIds.count > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << constraints.withoutVertex << ofAll
         << " of the source are no constraints: " << report.UnfitIds.count
         << " of the ids in its cells are not those of points, the first is "
         << report.UnfitIds.firstId << " in cell " << report.UnfitIds.firstCell
         << ". They refer to the points of "
         << (settings.SourceIdsAreOfInput ? "the input (see SourceMode)." : "the source.")
         << loops.str());
  }
  else if (constraints.withoutVertex > 0 && report.DelaunayTriangles > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << constraints.withoutVertex << ofAll
         << " of the source are no constraints, since an end of theirs is a point that "
            "was rejected, is skipped or lies beyond InsertionLimit."
         << loops.str());
  }
}
}

void vtkAHDSayTooManyPoints(vtkAlgorithm* filter, std::size_t count)
{
  vtkErrorWithObjectMacro(filter,
    "" << count << " points are too many: at most " << ahd::kMaximumPoints
       << " can be triangulated.");
}

void vtkAHDSayBadCells(vtkAlgorithm* filter, const char* what, const ahd::BadCell& bad)
{
  if (!what)
  {
    vtkErrorWithObjectMacro(filter,
      "Cells of the source are damaged on one of the ranks: their offsets do not ascend from 0 to "
      "the number of point ids. Nothing was computed.");
    return;
  }
  vtkErrorWithObjectMacro(filter,
    "The " << what << " are damaged: the offsets of number " << bad.cell << " among them are "
           << bad.begin << " and " << bad.end
           << ", but offsets must ascend from 0 to the number of point ids, " << bad.ids
           << ". Nothing was computed.");
}

void vtkAHDSayError(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  switch (report.Status)
  {
    case ahd::Status::Ok:
    case ahd::Status::Cancelled:
      return;
    case ahd::Status::TooManyPoints:
      vtkAHDSayTooManyPoints(filter, report.Points);
      return;
    case ahd::Status::TooManyBoxes:
      SayTooManyBoxes(filter, report);
      return;
    case ahd::Status::TooManyCrossings:
      SayTooManyCrossings(filter, report);
      return;
    case ahd::Status::OutOfMemory:
      report.IsRefused ? SayRefused(filter, report) : SayOutOfMemory(filter, report);
      return;
    case ahd::Status::BadCells:
      vtkAHDSayBadCells(filter, report.BadCellsOf, report.BadCell);
  }
}

void vtkAHDSayWarnings(
  vtkAlgorithm* filter, const vtkAHDSettings& settings, const vtkAHDReport& report)
{
  WarnOfPlane(filter, settings);
  WarnOfPoints(filter, settings, report);
  WarnOfCells(filter, report);
  WarnOfRim(filter, report);
  WarnOfSource(filter, report);
  WarnOfConstraints(filter, settings, report);
}
