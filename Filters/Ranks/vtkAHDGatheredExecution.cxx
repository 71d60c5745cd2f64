// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDGatheredExecution.h"

#include "Engine/Core/Memory.h"
#include "Engine/Job/Messages.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <sstream>
#include <tuple>

namespace
{
constexpr std::size_t kPorts = std::tuple_size<vtkAHDOutputs>::value;

/// Numbers from 0 on, as the global ids of points or cells.
void AddIds(vtkDataSetAttributes* data, const char* name, vtkIdType count)
{
  auto ids = vtkAHDNewArray<vtkIdTypeArray>(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType(0));
  ids->SetName(name);
  vtkAHDReplaceArray(data, ids);
  data->SetActiveAttribute(name, vtkDataSetAttributes::GLOBALIDS);
}

/// The structure of one output, without its values.
struct Shape
{
  static constexpr int kNone = -1;
  int Places = kNone; // the type; kNone: no points at all
  std::vector<vtkAHDArrayFacts> PointArrays, CellArrays;

  auto fields() { return std::tie(this->Places, this->PointArrays, this->CellArrays); }
};

/// The rows of the field data array "Crossings", in the output of all ranks.
std::vector<std::array<std::int64_t, 2>> ReadCrossings(vtkPolyData* surface)
{
  std::vector<std::array<std::int64_t, 2>> rows;
  auto* array = vtkAHDOutputArrays::Crossings.Find(surface->GetFieldData());
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    rows.push_back({ { array->GetValue(2 * i), array->GetValue(2 * i + 1) } });
  }
  return rows;
}

std::vector<vtkAHDArrayFacts> ListArrays(vtkDataSetAttributes* data)
{
  std::vector<vtkAHDArrayFacts> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    arrays.emplace_back(data, i);
  }
  return arrays;
}

void AddArrays(const std::vector<vtkAHDArrayFacts>& arrays, vtkDataSetAttributes* data)
{
  for (const vtkAHDArrayFacts& facts : arrays)
  {
    facts.AddTo(data, facts.Make(0));
  }
}
}

vtkAHDGatheredExecution::vtkAHDGatheredExecution(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDAllFacts& facts, const vtkAHDContext& context, const char* setting)
  : Settings(settings)
  , Ranks(ranks)
  , Facts(facts)
  , Context(context)
  , Setting(setting)
  , Gather(settings, ranks, facts, context)
{
}

// ----------------------------------------------------------------------------------------- memory

/// All allocations of the one rank: the received data, and the results.
std::size_t vtkAHDGatheredExecution::EstimateBytes(ahd::Workspace& workspace) const
{
  const auto input = this->Gather.OutlineInput();
  const auto source = this->Gather.OutlineSource();
  vtkAHDInput outline(this->Settings, input, source);
  const std::size_t held = this->Gather.EstimateBytes();
  const vtkAHDExecution execution(this->Settings, outline, workspace, this->Context, held);
  constexpr std::size_t kIds = 4 * sizeof(vtkIdType); // of a point and its share of the cells
  const std::size_t points = ahd::expectedPoints(outline.GetRequest());
  return std::max(
    held + this->Gather.EstimateBytesOnTheWay(), execution.EstimateBytes() + kIds * points);
}

/// What this rank could take. Others that wait on the same machine take nothing but to send.
vtkAHDGatheredExecution::Room vtkAHDGatheredExecution::FindRoom(ahd::Workspace& workspace) const
{
  Room room;
  room.Needed = static_cast<std::int64_t>(this->EstimateBytes(workspace) / 1024);
  room.IsByUser = this->Settings.MemoryLimit > 0;
  const std::size_t there = ahd::availableMemory() / 1024 + workspace.bytes() / 1024;
  constexpr std::size_t kPlenty = std::size_t(1) << 50;
  room.Limit = room.IsByUser ? static_cast<std::int64_t>(this->Settings.MemoryLimit)
                             : static_cast<std::int64_t>(std::min(there, kPlenty));
  room.Share = room.IsByUser
    ? room.Limit
    : room.Limit / static_cast<std::int64_t>(this->Facts.CountOnHostOf(this->Ranks.GetOwn()));
  return room;
}

std::string vtkAHDGatheredExecution::Refuse(
  std::size_t rank, std::int64_t needed, const Room& room) const
{
  const bool isHost = rank == this->Host;
  const ahd::Facts known{ { "reason", ahd::Reason::MemoryLimit }, { "doing", "gathering" },
    { "setting", this->Setting }, { "are_sent", !isHost }, { "rank", rank },
    { "points",
      isHost ? this->Facts.GetPoints() + this->Facts.GetSourcePoints()
             : static_cast<std::size_t>(this->Facts.Of[rank].Points) },
    { "of_rank", true }, { "is_in_kib", true }, { "memory_estimate", needed },
    { "memory_allowed", isHost ? room.Limit : room.Share }, { "memory_limit", room.IsByUser } };
  return ahd::messages(ahd::Topic::Refusal, ahd::Wording::Class, known).at(0).text;
}

std::string vtkAHDGatheredExecution::FindHost(
  const vtkAHDDataSets& data, ahd::Workspace& workspace, vtkAHDReport& report)
{
  this->Gather.Measure(data);
  const auto rooms = this->Ranks.Share(this->Context, [&] { return this->FindRoom(workspace); });
  std::string refusal;
  this->Ranks.Together(this->Context,
    [&]
    {
      const std::int64_t needed = rooms[0].Needed;
      const auto most = std::max_element(
        rooms.begin(), rooms.end(), [](const Room& a, const Room& b) { return a.Limit < b.Limit; });
      this->Host = needed <= rooms[0].Limit ? 0 : static_cast<std::size_t>(most - rooms.begin());
      const std::int64_t limit = rooms[this->Host].Limit;
      report.estimate = 1024 * static_cast<std::size_t>(needed);
      report.allowed = 1024 * static_cast<std::size_t>(limit);
      report.isLimited = rooms[this->Host].IsByUser;
      refusal = needed > limit ? this->Refuse(this->Host, needed, rooms[this->Host]) : "";
      for (std::size_t rank = 0; rank < rooms.size() && refusal.empty(); ++rank)
      {
        const auto toSend = static_cast<std::int64_t>(
          this->Gather.EstimateBytesToSend(rank) / 1024);
        if (rank != this->Host && toSend > rooms[rank].Share)
        {
          refusal = this->Refuse(rank, toSend, rooms[rank]);
        }
      }
    });
  return refusal;
}

// -------------------------------------------------------------------------------------- execution

/// On the one rank. Throws nothing.
void vtkAHDGatheredExecution::Execute(
  const vtkAHDOutputs& outputs, ahd::Workspace& workspace, vtkAHDReport& report)
{
  vtkAHDInput input(this->Settings, this->Gather.GetInput(), this->Gather.GetSource());
  vtkAHDExecution execution(
    this->Settings, input, workspace, this->Context, this->Gather.EstimateBytes());
  const std::size_t estimate = report.estimate; // with the ids that are added here
  report = execution.Run(outputs);
  report.estimate = std::max(report.estimate, estimate);
  if (report.status != ahd::Status::Ok)
  {
    return;
  }
  report.Source = this->Facts.GetContent();
  report.unfitIds.firstId = this->Gather.GetGivenId(report.unfitIds.firstId);
  try
  {
    AddIds(outputs[0]->GetPointData(), vtkAHDOutputArrays::GlobalPointIds.Name,
      outputs[0]->GetNumberOfPoints());
    AddIds(outputs[0]->GetCellData(), vtkAHDOutputArrays::GlobalCellIds.Name,
      outputs[0]->GetNumberOfCells());
    report.CrossingCells = ReadCrossings(outputs[0]);
  }
  catch (const std::bad_alloc&)
  {
    report.status = ahd::Status::OutOfMemory;
  }
}

void vtkAHDGatheredExecution::ShareReport(vtkAHDReport& report)
{
  const bool isHost = this->Ranks.GetOwn() == this->Host;
  const auto all = this->Ranks.Share(
    this->Context, [&] { return isHost ? report : vtkAHDReport(); });
  this->Ranks.Together(this->Context,
    [&]
    {
      if (!isHost)
      {
        report = all[this->Host];
      }
    });
}

/// Gives the other ranks the outputs of the one, without values.
void vtkAHDGatheredExecution::ShareOutputs(const vtkAHDOutputs& outputs)
{
  const bool isHost = this->Ranks.GetOwn() == this->Host;
  const auto all = this->Ranks.Share(this->Context,
    [&]
    {
      std::vector<Shape> shapes(isHost ? kPorts : 0);
      for (std::size_t port = 0; port < shapes.size(); ++port)
      {
        vtkPoints* points = outputs[port]->GetPoints();
        shapes[port] = { points ? points->GetDataType() : Shape::kNone,
          ListArrays(outputs[port]->GetPointData()), ListArrays(outputs[port]->GetCellData()) };
      }
      return shapes;
    });
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t port = 0; !isHost && port < kPorts; ++port)
      {
        const Shape& shape = all[this->Host][port];
        if (shape.Places != Shape::kNone)
        {
          vtkNew<vtkPoints> points;
          points->SetDataType(shape.Places);
          outputs[port]->SetPoints(points);
        }
        AddArrays(shape.PointArrays, outputs[port]->GetPointData());
        AddArrays(shape.CellArrays, outputs[port]->GetCellData());
      }
    });
}

void vtkAHDGatheredExecution::Run(
  const vtkAHDDataSets& data, ahd::Workspace& workspace, vtkAHDReport& report)
{
  this->Gather.MoveTo(this->Host, data);
  if (this->Ranks.GetOwn() == this->Host)
  {
    this->Execute(data.Outputs, workspace, report);
  }
  this->ShareReport(report);
  this->Context.Check(report.status);
  for (const vtkAHDRankFacts& facts : this->Facts.Of)
  {
    report.MarksAreUnfit = report.MarksAreUnfit || facts.MarksAreUnfit;
  }
  this->ShareOutputs(data.Outputs);
}

std::string vtkAHDGatheredExecution::GetWarning() const
{
  std::ostringstream words;
  words << this->Setting << " is computed on one rank: rank " << this->Host << " of "
        << this->Ranks.GetCount()
        << " has triangulated the points of all, and outputs the whole surface.";
  return words.str();
}
