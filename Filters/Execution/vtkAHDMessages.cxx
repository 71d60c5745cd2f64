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
    "The grid of " << report.points << " points has more than " << report.mostBoxes
                   << " boxes. Putting out more may take more than "
                   << vtkAHDNeeded(report.GetEstimate()) << " of memory, but "
                   << vtkAHDButAllowed(report.GetLimit(), report.isLimited)
                   << ". Nothing was computed. Switch GenerateBoxes off, take fewer points or a "
                      "larger Nmax, "
                   << vtkAHDOrSetLimit(report.GetEstimate()));
}

void SayRefused(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  vtkErrorWithObjectMacro(filter,
    "Triangulating " << report.points << " points may take " << vtkAHDNeeded(report.GetEstimate())
                     << " of memory, but " << vtkAHDButAllowed(report.GetLimit(), report.isLimited)
                     << ". Nothing was computed. Take fewer points, switch off outputs that are "
                        "not needed, "
                     << vtkAHDOrSetLimit(report.GetEstimate()));
}

void SayTooManyCrossings(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  vtkErrorWithObjectMacro(filter,
    "The lines and polygons of the source cross in more than "
      << report.mostCrossings << " places. Splitting them there and triangulating "
      << report.points - report.crossings << " points and the crossings may take more than "
      << vtkAHDNeeded(report.GetEstimate()) << " of memory, but "
      << vtkAHDButAllowed(report.GetLimit(), report.isLimited)
      << ". Nothing was computed. Take fewer lines, switch CrossingMode to Leave Out, "
      << vtkAHDOrSetLimit(report.GetEstimate()));
}

void SayOutOfMemory(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  const bool isLimited = report.isLimited && report.GetEstimate() > report.GetLimit();
  vtkErrorWithObjectMacro(filter,
    "Out of memory while triangulating "
      << report.points << " points; about " << vtkAHDNeeded(report.GetEstimate()) << " are needed"
      << (isLimited ? ", and " + vtkAHDButAllowed(report.GetLimit(), true) : std::string())
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
  if (settings.bounding && !settings.addsBounding())
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
        << report.inputPoints
        << " points, or is not of type unsigned char, so no point was skipped.");
  }
  if (report.counts.notFinite > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.counts.notFinite << " of " << report.points << " points were left out, since "
         << (settings.isProjected() ? "they have no finite place in the plane of the triangulation"
                                    : "their x or y is NaN or infinite")
         << "; the first is point " << report.oddPoints.firstNotFinite << ".");
  }
  if (report.oddPoints.oddZ > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.oddPoints.oddZ << " of " << report.points
         << " points have a z that is NaN or infinite. They are part of the triangulation, which "
            "is computed in x and y, but cannot be drawn.");
  }
}

/// What to do where x and y do not tell the points apart.
const char* const kOtherPlane =
  "To triangulate a wall, set ProjectionPlaneMode to Best-Fitting Plane";

void WarnOfNoTriangle(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  const ahd::Report& counts = report.counts;
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
  const std::string merged = report.mergedPoints == 0
    ? std::string()
    : ", of which Tolerance merged " + std::to_string(report.mergedPoints) + " into others";
  vtkWarningWithObjectMacro(filter,
    "There is no triangle, because "
      << (areFew ? "there are fewer than three distinct points: "
                 : "all distinct points are collinear: ")
      << counts.inserted << " distinct points among " << report.points << merged << "."
      << (report.areOnOneLine ? "" : " They are not collinear in space. ")
      << (report.areOnOneLine ? "" : kOtherPlane) << (report.areOnOneLine ? "" : "."));
}

void WarnOfStacks(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  if (report.areStacked)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.counts.duplicates << " of " << report.points
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
  if (report.counts.triangles > 0 && report.Cells == 0)
  {
    vtkWarningWithObjectMacro(filter,
      "Nothing is put out: Alpha, its switches and MaximumEdgeLength leave none of "
        << report.counts.triangles << (report.counts.triangles == 1 ? " triangle" : " triangles")
        << ", no line and no vertex. Larger numbers keep more, and 0 is no limit.");
  }
  if (report.MayBeEmptiedByLoops)
  {
    vtkWarningWithObjectMacro(filter,
      "There is no triangle, because the polygons of the source keep none (see FillRule), or all "
      "distinct points are collinear.");
  }
  else if (report.delaunayTriangles == 0 && report.counts.inserted + report.counts.notFinite > 0)
  {
    WarnOfNoTriangle(filter, report);
  }
  WarnOfStacks(filter, report);
  if (report.delaunayTriangles > 0 && report.counts.triangles + report.counts.trimmed == 0)
  {
    vtkWarningWithObjectMacro(filter,
      "There is no triangle, because the polygons of the source keep none of the "
        << report.delaunayTriangles << " triangles (see FillRule).");
  }
}

/// Of what is more than the slivers along a rim.
void WarnOfRim(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  constexpr double kMuch = 0.1;
  const ahd::Report& counts = report.counts;
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
  if (found.Points + found.Strips > 0 && report.constraints.segments == 0)
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
  if (report.pointsOffSurface > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << report.pointsOffSurface << " of " << found.Points
         << " points of the source lie outside the surface of the input and keep their own z (see "
            "SourceHeights).");
  }
}

void WarnOfConstraints(
  vtkAlgorithm* filter, const vtkAHDSettings& settings, const vtkAHDReport& report)
{
  const ahd::ConstraintReport& constraints = report.constraints;
  // The engine counts pieces where segments were split.
  const std::string ofAll = settings.split
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
         << report.firstCrossing[0] << " and crosses cell " << report.firstCrossing[1] << "."
         << loops.str());
    loops.str("");
  }
  if (report.bentConstraints > 0)
  {
    const bool isOne = report.bentConstraints == 1;
    vtkWarningWithObjectMacro(filter,
      "" << report.bentConstraints << (isOne ? " segment" : " segments") << " of the source bend"
         << (isOne ? "s" : "") << " by rounding, led through a point that is not exactly on "
         << (isOne ? "it" : "them") << "; the first is in cell " << report.firstBentCell << ".");
  }
  if (report.unfitIds.count > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << constraints.withoutVertex << ofAll
         << " of the source are no constraints: " << report.unfitIds.count
         << " of the ids in its cells are not those of points, the first is "
         << report.unfitIds.firstId << " in cell " << report.unfitIds.firstCell
         << ". They refer to the points of "
         << (settings.idsAreOfInput ? "the input (see SourceMode)." : "the source.")
         << loops.str());
  }
  else if (constraints.withoutVertex > 0 && report.delaunayTriangles > 0)
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
  switch (report.status)
  {
    case ahd::Status::Ok:
    case ahd::Status::Cancelled:
      return;
    case ahd::Status::TooManyPoints:
      vtkAHDSayTooManyPoints(filter, report.points);
      return;
    case ahd::Status::TooManyBoxes:
      SayTooManyBoxes(filter, report);
      return;
    case ahd::Status::TooManyCrossings:
      SayTooManyCrossings(filter, report);
      return;
    case ahd::Status::OutOfMemory:
      report.isRefused ? SayRefused(filter, report) : SayOutOfMemory(filter, report);
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
