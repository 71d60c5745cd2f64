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

/// Calls work(part) for all of a report that can be sent.
template <typename Report, typename Work>
void ForParts(Report& report, const Work& work)
{
  work(report.status);
  work(report.isRefused);
  work(report.isLimited);
  work(report.points);
  work(report.estimate);
  work(report.allowed);
  work(report.crossings);
  work(report.mostBoxes);
  work(report.mostCrossings);
  work(report.counts);
  work(report.constraints.segments);
  work(report.constraints.points);
  work(report.constraints.withoutVertex);
  work(report.constraints.crossing);
  work(report.constraints.unfilledLoops);
  work(report.constraints.edges);
  work(report.delaunayTriangles);
  work(report.MayBeEmptiedByLoops);
  work(report.Triangles);
  work(report.Cells);
  work(report.inputPoints);
  work(report.mergedPoints);
  work(report.addedPoints);
  work(report.firstCrossing);
  work(report.bentConstraints);
  work(report.firstBentCell);
  work(report.unfitIds);
  work(report.oddPoints);
  work(report.MarksAreUnfit);
  work(report.Source);
  work(report.pointsOffSurface);
  work(report.areOnOneLine);
  work(report.areStacked);
  work(report.IsDiagramInPlane);
  work(report.Seconds);
  work(report.threadsUsed);
}

/// The rows of the field data array "Crossings", which all ranks put out.
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

void WriteShape(vtkDataSetAttributes* data, ahd::BytesWriter& writer)
{
  writer.write(data->GetNumberOfArrays());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAHDArrayFacts(data, i).Write(writer);
  }
}

void ReadShape(ahd::BytesReader& reader, vtkDataSetAttributes* data)
{
  for (int count = reader.read<int>(); count > 0; --count)
  {
    vtkAHDArrayFacts facts;
    facts.Read(reader);
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

/// All that the one rank allocates: what comes, and what is made of it.
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

/// What each rank could take. Others that wait on the same machine take nothing but to send.
void vtkAHDGatheredExecution::ShareRooms(ahd::Workspace& workspace, std::vector<Room>& rooms)
{
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [&]
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
      ahd::BytesWriter(own).write(room);
    });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      for (const ahd::BlockBytes& bytes : all)
      {
        rooms.push_back(ahd::BytesReader(bytes).read<Room>());
      }
    });
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
  std::vector<Room> rooms;
  this->ShareRooms(workspace, rooms);
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
      report.isLimited = rooms[this->Host].IsByUser != 0;
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
  report = execution.Run(outputs);
  if (report.status != ahd::Status::Ok)
  {
    return;
  }
  report.Source = this->Gather.GetContent();
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
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  const bool isHost = this->Ranks.GetOwn() == this->Host;
  this->Ranks.Together(this->Context,
    [&]
    {
      if (isHost)
      {
        ahd::BytesWriter writer(own);
        ForParts(report, [&writer](const auto& part) { writer.write(part); });
        writer.writeAll(report.CrossingCells);
      }
    });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      ahd::BytesReader reader(all[this->Host]);
      ForParts(
        report, [&reader](auto& part) { part = reader.read<std::decay_t<decltype(part)>>(); });
      report.CrossingCells.clear();
      reader.readAll(report.CrossingCells);
    });
}

/// Gives the other ranks what the one has, but for all that is in it.
void vtkAHDGatheredExecution::ShareOutputs(const vtkAHDOutputs& outputs)
{
  constexpr int kNone = -1; // no points at all
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  const bool isHost = this->Ranks.GetOwn() == this->Host;
  this->Ranks.Together(this->Context,
    [&]
    {
      ahd::BytesWriter writer(own);
      for (std::size_t port = 0; isHost && port < kPorts; ++port)
      {
        vtkPoints* points = outputs[port]->GetPoints();
        writer.write(points ? points->GetDataType() : kNone);
        WriteShape(outputs[port]->GetPointData(), writer);
        WriteShape(outputs[port]->GetCellData(), writer);
      }
    });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      ahd::BytesReader reader(all[this->Host]);
      for (std::size_t port = 0; !isHost && port < kPorts; ++port)
      {
        const int type = reader.read<int>();
        if (type != kNone)
        {
          vtkNew<vtkPoints> points;
          points->SetDataType(type);
          outputs[port]->SetPoints(points);
        }
        ReadShape(reader, outputs[port]->GetPointData());
        ReadShape(reader, outputs[port]->GetCellData());
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
        << " has triangulated the points of all, and puts out the whole surface.";
  return words.str();
}
