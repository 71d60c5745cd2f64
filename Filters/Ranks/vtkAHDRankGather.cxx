// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankGather.h"

#include "Output/vtkAHDPointOutput.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDCellsView.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace
{
constexpr std::size_t kPlace = 3 * sizeof(double);
/// Ids from here on are far from all that there are, and stay as they are.
constexpr std::int64_t kFar = std::int64_t(1) << 62;

/// An array that says how many values it has, and has none.
template <typename Array>
vtkSmartPointer<Array> Outline(std::size_t tuples, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetArray(nullptr, static_cast<vtkIdType>(tuples) * components, 1);
  return array;
}

vtkSmartPointer<vtkPoints> OutlinePoints(std::size_t count, bool areFloats)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  if (areFloats)
  {
    points->SetData(Outline<vtkFloatArray>(count, 3));
  }
  else
  {
    points->SetData(Outline<vtkDoubleArray>(count, 3));
  }
  return points;
}

std::size_t BytesOf(vtkAbstractArray* array)
{
  return std::max(1024 * static_cast<std::size_t>(array->GetActualMemorySize()),
    static_cast<std::size_t>(array->GetNumberOfValues()) *
      static_cast<std::size_t>(std::max(1, array->GetDataTypeSize())));
}

vtkSmartPointer<vtkCellArray> MakeCells(const vtkAHDCellChain& chain)
{
  const auto count = static_cast<vtkIdType>(chain.Sizes.size());
  auto ids = vtkAHDNewArray<vtkTypeInt64Array>(static_cast<vtkIdType>(chain.Ids.size()));
  auto offsets = vtkAHDNewArray<vtkTypeInt64Array>(count + 1);
  std::copy(chain.Ids.begin(), chain.Ids.end(), ids->GetPointer(0));
  offsets->SetValue(0, 0);
  std::partial_sum(chain.Sizes.begin(), chain.Sizes.end(), offsets->GetPointer(1));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}
}

vtkAHDRankGather::vtkAHDRankGather(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDAllFacts& facts, const vtkAHDContext& context)
  : Settings(settings)
  , Ranks(ranks)
  , Facts(facts)
  , Context(context)
{
}

// ------------------------------------------------------------------------------------------- sizes

vtkAHDRankGather::CellArrays vtkAHDRankGather::CellsOf(vtkPolyData* source)
{
  return { { source->GetVerts(), source->GetLines(), source->GetPolys() } };
}

/// Null if this rank has none, or the same as others, which counts once.
vtkPolyData* vtkAHDRankGather::CountedSource(const vtkAHDDataSets& data) const
{
  return this->Facts.CountsSource(this->Ranks.GetOwn()) ? data.Source : nullptr;
}

vtkAHDRankGather::Sizes vtkAHDRankGather::MeasureOwn(const vtkAHDDataSets& data) const
{
  Sizes own;
  own.InputBytes = data.InputBytes;
  const std::size_t points = static_cast<std::size_t>(this->Facts.Of[this->Ranks.GetOwn()].Points);
  own.WidestBytes = points * kPlace;
  const auto selected = this->Facts.SelectArrays(data.Input);
  for (int i = 0; i < selected->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const std::size_t bytes = BytesOf(selected->GetPointData()->GetAbstractArray(i));
    own.DataBytes += bytes;
    own.WidestBytes = std::max<std::uint64_t>(own.WidestBytes, bytes);
  }
  if (vtkPolyData* source = this->CountedSource(data))
  {
    for (std::size_t kind = 0; kind < kKinds; ++kind)
    {
      const ahd::CellsView counts = vtkAHDCellsView(CellsOf(source)[kind], nullptr).GetCounts();
      own.Cells[kind] = { counts.cells, counts.ids };
    }
  }
  return own;
}

void vtkAHDRankGather::Measure(const vtkAHDDataSets& data)
{
  this->Of = this->Ranks.Share(this->Context, [&] { return this->MeasureOwn(data); });
}

vtkAHDRankGather::CellCounts vtkAHDRankGather::GetCells(std::size_t kind) const
{
  CellCounts all;
  for (const Sizes& sizes : this->Of)
  {
    all.Count += sizes.Cells[kind].Count;
    all.Ids += sizes.Cells[kind].Ids;
  }
  return all;
}

/// Bytes of all arrays for one point, as a mean, rounded up.
std::size_t vtkAHDRankGather::GetWidth() const
{
  std::size_t bytes = 0;
  for (const Sizes& sizes : this->Of)
  {
    bytes += static_cast<std::size_t>(sizes.DataBytes);
  }
  const std::size_t points = std::max<std::size_t>(1, this->Facts.GetPoints());
  return (bytes + points - 1) / points;
}

vtkSmartPointer<vtkPolyData> vtkAHDRankGather::OutlineInput() const
{
  auto input = vtkSmartPointer<vtkPolyData>::New();
  const std::size_t count = this->Facts.GetPoints();
  input->SetPoints(OutlinePoints(count, this->Facts.AreFloats()));
  if (const std::size_t width = this->GetWidth())
  {
    auto data = Outline<vtkUnsignedCharArray>(count, static_cast<int>(width));
    data->SetName("data");
    input->GetPointData()->AddArray(data);
  }
  return input;
}

vtkSmartPointer<vtkPolyData> vtkAHDRankGather::OutlineSource() const
{
  auto source = vtkSmartPointer<vtkPolyData>::New();
  source->SetPoints(OutlinePoints(this->Facts.GetSourcePoints(), false));
  std::array<vtkNew<vtkCellArray>, kKinds> cells;
  for (std::size_t kind = 0; kind < kKinds; ++kind)
  {
    const CellCounts counts = this->GetCells(kind);
    if (counts.Count > 0)
    {
      cells[kind]->SetData(
        Outline<vtkTypeInt64Array>(counts.Count + 1, 1), Outline<vtkTypeInt64Array>(counts.Ids, 1));
    }
  }
  source->SetVerts(cells[0]);
  source->SetLines(cells[1]);
  source->SetPolys(cells[2]);
  return source;
}

std::size_t vtkAHDRankGather::EstimateBytes() const
{
  const std::size_t points = this->Facts.GetPoints() + this->Facts.GetSourcePoints();
  std::uint64_t before = 0;
  for (const Sizes& sizes : this->Of)
  {
    before = std::max(before, sizes.InputBytes);
  }
  std::size_t bytes = static_cast<std::size_t>(before) + points * (kPlace + 1 + this->GetWidth());
  for (std::size_t kind = 0; kind < kKinds; ++kind)
  {
    const CellCounts cells = this->GetCells(kind);
    bytes += sizeof(std::int64_t) * static_cast<std::size_t>(cells.Count + 1 + cells.Ids);
  }
  return bytes;
}

std::size_t vtkAHDRankGather::EstimateBytesToSend(std::size_t rank) const
{
  const Sizes& sizes = this->Of[rank];
  const std::size_t added = this->Facts.CountsSource(rank)
    ? static_cast<std::size_t>(this->Facts.Of[rank].SourcePoints)
    : 0;
  std::size_t cells = 0;
  for (const CellCounts& kind : sizes.Cells)
  {
    cells += sizeof(std::int64_t) * static_cast<std::size_t>(kind.Count + kind.Ids);
  }
  // a message, which may have grown, and what it is made of where that has to be converted
  return 2 * static_cast<std::size_t>(sizes.WidestBytes) + 2 * cells +
    (static_cast<std::size_t>(this->Facts.Of[rank].Points) + added) * sizeof(ahd::Index) +
    added * (3 * kPlace + 2 + 2 * this->GetWidth());
}

std::size_t vtkAHDRankGather::EstimateBytesOnTheWay() const
{
  std::size_t bytes = 0;
  for (std::size_t rank = 0; rank < this->Of.size(); ++rank)
  {
    bytes += this->EstimateBytesToSend(rank);
  }
  return 2 * bytes; // sent, as far as that is done on the same machine, and received
}

// ----------------------------------------------------------------------------------------- moving

void vtkAHDRankGather::MoveTo(std::size_t host, const vtkAHDDataSets& data)
{
  this->Host = host;
  vtkPolyData* source = this->CountedSource(data);
  vtkSmartPointer<vtkPolyData> local;
  this->Ranks.Together(this->Context,
    [&]
    {
      local = this->Facts.SelectArrays(data.Input);
      this->Input = vtkSmartPointer<vtkPolyData>::New();
      this->Source = vtkSmartPointer<vtkPolyData>::New();
    });
  vtkAHDRoute route(this->Ranks, this->Context);
  this->MovePoints(local, this->Facts.AreFloats(), route, this->Input);
  if (this->Facts.HaveMarks())
  {
    this->MoveMarks(data.Input, route);
  }
  if (this->AddsSource())
  {
    this->Ranks.Together(this->Context, [&] { local = this->ReadSourcePoints(source); });
    vtkAHDRoute sourceRoute(this->Ranks, this->Context);
    this->MovePoints(local, false, sourceRoute, this->Source);
  }
  this->MoveCells(source);
}

/// Points and those of their arrays that all ranks have.
void vtkAHDRankGather::MovePoints(
  vtkPolyData* from, bool areFloats, vtkAHDRoute& route, vtkPolyData* to)
{
  this->Context.Check(route.toOne(static_cast<std::size_t>(from->GetNumberOfPoints()), this->Host));
  vtkSmartPointer<vtkAbstractArray> mine, all;
  const auto move = [&](const auto& prepare)
  {
    this->Ranks.Together(this->Context, prepare);
    route.Move(mine, all, 0);
  };
  move(
    [&]
    {
      all = vtkAHDMakePlaces(route.count(), areFloats);
      mine = vtkAHDPlacesOf(from->GetPoints(), areFloats);
    });
  vtkNew<vtkPoints> points;
  points->SetData(vtkArrayDownCast<vtkDataArray>(all));
  to->SetPoints(points);
  for (const vtkAHDArrayFacts& facts : this->Facts.GetArrays())
  {
    move(
      [&]
      {
        mine = from->GetPointData()->GetAbstractArray(facts.Name.c_str());
        all = facts.Make(route.count());
      });
    facts.AddTo(to->GetPointData(), all);
  }
}

/// Of ranks that have none, points that are none's ghosts.
void vtkAHDRankGather::MoveMarks(vtkPointSet* input, vtkAHDRoute& route)
{
  std::vector<unsigned char> mine;
  vtkSmartPointer<vtkUnsignedCharArray> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      mine.assign(static_cast<std::size_t>(this->Facts.Of[this->Ranks.GetOwn()].Points), 0);
      if (!mine.empty())
      {
        const vtkAHDInput opened(this->Settings, input, nullptr);
        const unsigned char* given = opened.GetRequest().points.skip;
        std::copy_n(given ? given : mine.data(), mine.size(), mine.data());
      }
      all = vtkAHDNewArray<vtkUnsignedCharArray>(static_cast<vtkIdType>(route.count()));
      all->SetName(vtkDataSetAttributes::GhostArrayName());
    });
  this->Context.Check(route.move(mine.data(), 1, all->GetPointer(0)));
  vtkAHDReplaceArray(this->Input->GetPointData(), all);
}

/// The points of a source, with values in the arrays of the input. May be null.
vtkSmartPointer<vtkPolyData> vtkAHDRankGather::ReadSourcePoints(vtkPolyData* source) const
{
  const auto nothing = this->Facts.SelectArrays(nullptr);
  if (!source || source->GetNumberOfPoints() == 0)
  {
    return nothing;
  }
  vtkAHDSettings settings;
  settings.idsAreOfInput = false;
  settings.AddSourcePoints = true;
  vtkNew<vtkPolyData> points;
  points->SetPoints(source->GetPoints());
  points->GetPointData()->ShallowCopy(source->GetPointData());
  vtkAHDInput input(settings, nothing, points);
  input.Open(this->Context);
  ahd::PreparedInput prepared;
  this->Context.Check(ahd::prepare(input.GetRequest(), this->Context, prepared));
  auto read = vtkSmartPointer<vtkPolyData>::New();
  const vtkAHDPointOutput output(input, prepared);
  output.WritePlaces(nullptr, read, this->Context);
  output.WriteData(read->GetPointData(), this->Context);
  return read;
}

// ------------------------------------------------------------------------------------------ cells

/// Of this rank's points among those that ids in sources name. Where only the first rank's source
/// counts, no other asks.
std::int64_t vtkAHDRankGather::GetFirstId() const
{
  std::uint64_t first = 0;
  for (std::size_t rank = 0; rank < this->Ranks.GetOwn(); ++rank)
  {
    const vtkAHDRankFacts& facts = this->Facts.Of[rank];
    first += this->Settings.idsAreOfInput ? facts.Points : facts.SourcePoints;
  }
  return static_cast<std::int64_t>(first);
}

/// How many points ids in the appended source can name.
std::int64_t vtkAHDRankGather::GetIdCount() const
{
  return static_cast<std::int64_t>(
    this->Settings.idsAreOfInput ? this->Facts.GetPoints() : this->Facts.GetSourcePoints());
}

std::int64_t vtkAHDRankGather::GetGivenId(std::int64_t id) const
{
  return id >= this->GetIdCount() && id < kFar ? id - this->GetIdCount() : id;
}

/// Ids that are not those of this rank's `ownIds` points become ids of no point of all ranks.
vtkAHDCellChain vtkAHDRankGather::ReadCells(vtkCellArray* array, std::int64_t ownIds) const
{
  const std::int64_t first = this->GetFirstId(), all = this->GetIdCount();
  vtkAHDCellsView opened(array, nullptr); // their name is not sent to other ranks
  const ahd::CellsView cells = opened.Open(this->Context);
  vtkAHDCellChain chain;
  chain.Ids.reserve(cells.ids);
  chain.Sizes.reserve(cells.cells);
  const auto offset = [&cells](std::size_t k)
  { return cells.offsets32 ? std::int64_t(cells.offsets32[k]) : cells.offsets64[k]; };
  for (std::size_t k = 0; k < cells.cells; ++k)
  {
    chain.Sizes.push_back(offset(k + 1) - offset(k));
  }
  for (std::size_t i = 0; i < cells.ids; ++i)
  {
    const std::int64_t id = cells.ids32 ? std::int64_t(cells.ids32[i]) : cells.ids64[i];
    const bool isFar = id < 0 || id >= kFar - all;
    chain.Ids.push_back(isFar ? id : id + (id < ownIds ? first : all));
    if (i % (std::size_t(1) << 14) == 0)
    {
      this->Context.StopIfAborted();
    }
  }
  return chain;
}

void vtkAHDRankGather::MoveCells(vtkPolyData* source)
{
  const vtkAHDRankFacts& own = this->Facts.Of[this->Ranks.GetOwn()];
  const auto ids = static_cast<std::int64_t>(
    this->Settings.idsAreOfInput ? own.Points : own.SourcePoints);
  const auto received = this->Ranks.Exchange<vtkAHDCellChain>(this->Context,
    [&](std::vector<std::vector<vtkAHDCellChain>>& to)
    {
      for (std::size_t kind = 0; source && kind < kKinds; ++kind)
      {
        to[this->Host].push_back(this->ReadCells(CellsOf(source)[kind], ids));
      }
    });
  this->Ranks.Together(this->Context,
    [&]
    {
      std::array<vtkAHDCellChain, kKinds> all;
      for (const std::vector<vtkAHDCellChain>& some : received)
      {
        for (std::size_t kind = 0; kind < some.size(); ++kind)
        {
          vtkAHDCellChain& to = all[kind];
          to.Ids.insert(to.Ids.end(), some[kind].Ids.begin(), some[kind].Ids.end());
          to.Sizes.insert(to.Sizes.end(), some[kind].Sizes.begin(), some[kind].Sizes.end());
        }
      }
      this->Source->SetVerts(MakeCells(all[0]));
      this->Source->SetLines(MakeCells(all[1]));
      this->Source->SetPolys(MakeCells(all[2]));
    });
}
