// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDMessages.h"

#include "Execution/vtkAHDReport.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDSettings.h"

void vtkAHDSayTooManyPoints(vtkAlgorithm* filter, std::size_t count)
{
  vtkAHDSay(
    filter, ahd::Topic::Refusal, { { "reason", ahd::Reason::TooManyPoints }, { "points", count } });
}

void vtkAHDSayBadCells(vtkAlgorithm* filter, const char* what, const ahd::BadCell& bad)
{
  vtkAHDSay(filter, ahd::Topic::Refusal,
    { { "reason", ahd::Reason::BadArray }, { "cells", what ? what : "" }, { "bad_cell", bad.cell },
      { "begin", bad.begin }, { "end", bad.end }, { "ids", bad.ids } });
}

void vtkAHDSayError(vtkAlgorithm* filter, const vtkAHDReport& report)
{
  if (report.status == ahd::Status::BadCells)
  {
    vtkAHDSayBadCells(filter, report.BadCellsOf, report.BadCell);
    return;
  }
  const ahd::Reason reason = ahd::reasonOf(report.status, report.isRefused);
  vtkAHDSay(filter, ahd::Topic::Refusal, ahd::factsOf(report, { { "reason", reason } }));
}

void vtkAHDSayWarnings(vtkAlgorithm* filter, const vtkAHDSettings& settings,
  const vtkAHDReport& report, bool limitIsTold)
{
  ahd::Facts facts = ahd::factsOf(report,
    { { "transform_is_missing", settings.TransformIsMissing },
      { "bounding_is_missing", settings.bounding && !settings.addsBounding() },
      { "is_projected", settings.isProjected() },
      { "splits", settings.split || report.addedToLines > 0 },
      { "cell_ids", !settings.idsAreOfInput },
      { "heights_are_mixed", settings.sourceHeights == ahd::SourceHeights::Mixed },
      { "marks_are_unfit", report.MarksAreUnfit },
      { "may_be_emptied_by_loops", report.MayBeEmptiedByLoops },
      { "diagram_in_plane", report.IsDiagramInPlane }, { "source_points", report.Source.Points },
      { "source_vertices", report.Source.Vertices }, { "source_strips", report.Source.Strips },
      { "limit_is_told", limitIsTold } });
  for (const std::string& name : report.UnfitNumbers)
  {
    facts.add({ "unfit_numbers", name });
  }
  vtkAHDSay(filter, ahd::Topic::Triangulation, facts);
}
