// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankFacts.h"

#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDFingerprint.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDContext.h"
#include "Ranks/vtkAHDRanks.h"
#include "Ranks/vtkAHDRoute.h"

#include "vtkAbstractArray.h"
#include "vtkAbstractTransform.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <set>
#include <string_view>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace
{
std::uint64_t NameOfHost()
{
  char name[256] = {};
#if defined(__unix__) || defined(__APPLE__)
  gethostname(name, sizeof(name) - 1);
#endif
  return std::hash<std::string>()(name);
}

bool IsNamed(const std::vector<vtkAHDArrayFacts>& arrays, const std::string& name)
{
  return std::any_of(arrays.begin(), arrays.end(),
    [&name](const vtkAHDArrayFacts& array) { return array.Name == name; });
}

/// Has the setting of this name no effect, as an interpolation has no outputs of the triangulation?
bool HasNoEffect(const vtkAHDSettings& settings, const char* name)
{
  return settings.samples && std::strncmp(name, "Generate", 8) == 0;
}

/// Settings that must be the same on all ranks, by name: those that always have an effect as they
/// were set, of others the effect.
std::vector<std::pair<const char*, double>> NumbersToCompare(const vtkAHDSettings& settings)
{
  std::vector<std::pair<const char*, double>> numbers;
  for (const auto& number : settings.OfRanks.Numbers)
  {
    if (!HasNoEffect(settings, number.first))
    {
      numbers.push_back(number);
    }
  }
  const bool isHull = settings.rim == ahd::RimKind::Automatic && !settings.isProjected();
  const auto* const polygon = reinterpret_cast<const char*>(settings.voronoiPolygon.data());
  const std::string_view corners(polygon, settings.voronoiPolygon.size() * sizeof(ahd::Point));
  numbers.emplace_back("VoronoiPolygon", double(std::hash<std::string_view>()(corners)));
  const auto addName = [&numbers](const char* setting, bool isRead, const std::string& name)
  { numbers.emplace_back(setting, isRead ? double(std::hash<std::string>()(name)) : 0.0); };
  addName("ValueArrayName", settings.hasValues, settings.ValueArrayName);
  addName("WeightArrayName", settings.hasWeights, settings.WeightArrayName);
  addName("KeepArrayName", settings.hasMarks, settings.KeepArrayName);
  numbers.emplace_back("SourceHeights", double(settings.sourceHeights));
  numbers.emplace_back("ProjectionPlaneMode", settings.fitsPlane());
  numbers.emplace_back("Rim", double(isHull ? ahd::RimKind::ConvexHull : settings.rim));
  return numbers;
}
}

void vtkAHDReadSettings(const vtkAHDSettings& settings, vtkAHDRankFacts& facts)
{
  for (const auto& setting : NumbersToCompare(settings))
  {
    facts.Settings.push_back(setting.second);
  }
  if (auto* linear = vtkHomogeneousTransform::SafeDownCast(settings.Transform))
  {
    vtkNew<vtkMatrix4x4> matrix;
    linear->GetMatrix(matrix);
    facts.Transform.assign(matrix->GetData(), matrix->GetData() + 16);
  }
  else if (settings.Transform)
  {
    // of others nothing but the class can be compared
    const std::string name = settings.Transform->GetClassName();
    facts.Transform.assign(name.begin(), name.end());
  }
  facts.GhostLevels = static_cast<std::uint64_t>(std::max(settings.GhostLevels, 0));
  facts.Host = NameOfHost();
}

void vtkAHDReadArrays(vtkPointSet* input, vtkAHDRankFacts& facts)
{
  if (!input)
  {
    return;
  }
  facts.AreFloats = input->GetNumberOfPoints() > 0 &&
    input->GetPoints()->GetDataType() == VTK_FLOAT;
  vtkNew<vtkPointData> data;
  data->ShallowCopy(input->GetPointData());
  vtkAHDRemoveArraysOfOneName(data);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const char* name = array->GetName();
    if (name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0)
    {
      continue;
    }
    if (name && vtkAHDRoute::CanMove(array) &&
      array->GetNumberOfTuples() == input->GetNumberOfPoints())
    {
      facts.Arrays.emplace_back(data, i);
    }
    else
    {
      facts.OtherArrays.push_back(name ? name : "one without a name");
    }
  }
}

ahd::Fingerprint vtkAHDFingerprintOf(
  vtkPolyData* source, std::size_t rank, const vtkAHDContext& context)
{
  ahd::Fingerprint all = { { 0, 0 } };
  vtkPoints* points = source ? source->GetPoints() : nullptr;
  std::vector<vtkDataArray*> arrays = { points ? points->GetData() : nullptr };
  for (vtkCellArray* cells :
    { source ? source->GetLines() : nullptr, source ? source->GetPolys() : nullptr })
  {
    arrays.push_back(cells ? cells->GetConnectivityArray() : nullptr);
    arrays.push_back(cells ? cells->GetOffsetsArray() : nullptr);
  }
  for (vtkDataArray* array : arrays)
  {
    ahd::Fingerprint one;
    vtkSmartPointer<vtkDataArray> lying = array;
    if (array && !array->HasStandardMemoryLayout())
    {
      lying.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
      lying->DeepCopy(array);
    }
    if (!vtkAHDTakeFingerprint(lying, context, one))
    {
      return { { std::uint64_t(rank), 1 } };
    }
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      all[k] = all[k] * 0x9E3779B97F4A7C15u + one[k];
    }
  }
  return all;
}

// --------------------------------------------------------------------------------- of all ranks

std::size_t vtkAHDAllFacts::GetPoints() const
{
  std::size_t sum = 0;
  for (const vtkAHDRankFacts& facts : this->Of)
  {
    sum += static_cast<std::size_t>(facts.Points);
  }
  return sum;
}

std::size_t vtkAHDAllFacts::GetSourcePoints() const
{
  std::size_t sum = 0;
  for (std::size_t rank = 0; rank < this->Of.size(); ++rank)
  {
    sum += this->CountsSource(rank) ? static_cast<std::size_t>(this->Of[rank].SourcePoints) : 0;
  }
  return sum;
}

std::size_t vtkAHDAllFacts::GetSegments() const
{
  std::size_t sum = 0;
  for (const vtkAHDRankFacts& facts : this->Of)
  {
    sum += static_cast<std::size_t>(facts.Segments);
  }
  return sum;
}

bool vtkAHDAllFacts::AreFloats() const
{
  return this->GetSourcePoints() == 0 &&
    std::all_of(this->Of.begin(), this->Of.end(),
      [](const vtkAHDRankFacts& facts) { return facts.AreFloats || facts.Points == 0; });
}

bool vtkAHDAllFacts::HaveMarks() const
{
  return std::any_of(
    this->Of.begin(), this->Of.end(), [](const vtkAHDRankFacts& facts) { return facts.HasMarks; });
}

int vtkAHDAllFacts::GetGhostLevels() const
{
  std::uint64_t most = 0;
  for (const vtkAHDRankFacts& facts : this->Of)
  {
    most = std::max(most, facts.GhostLevels);
  }
  return static_cast<int>(most);
}

void vtkAHDAllFacts::Compare(const vtkAHDSettings& own, std::string& error) const
{
  const auto names = NumbersToCompare(own);
  const vtkAHDRankFacts& first = this->Of[0];
  for (std::size_t rank = 1; rank < this->Of.size(); ++rank)
  {
    const vtkAHDRankFacts& other = this->Of[rank];
    const char* differs = first.Transform != other.Transform ? "Transform" : nullptr;
    for (std::size_t k = names.size(); k > 0; --k)
    {
      differs = first.Settings[k - 1] != other.Settings[k - 1] ? names[k - 1].first : differs;
    }
    if (differs)
    {
      error = std::string(differs) + " is not the same on ranks 0 and " + std::to_string(rank) +
        ". Points are distributed over ranks only where all have the same settings. Nothing was "
        "computed.";
      throw vtkAHDStop{ ahd::Status::Cancelled };
    }
  }
}

const char* vtkAHDAllFacts::FindUnfit(const vtkAHDSettings& settings) const
{
  const std::vector<const char*>& onOneRank = settings.OfRanks.OnOneRank;
  const auto first = std::find_if(onOneRank.begin(), onOneRank.end(),
    [&settings](const char* name) { return !HasNoEffect(settings, name); });
  if (first != onOneRank.end())
  {
    return *first;
  }
  const bool hasSegments = this->GetSegments() > 0;
  const std::pair<bool, const char*> unfit[] = {
    { settings.mayTrimRim() && hasSegments,
      "Rim Trimmed (what Automatic is in any other plane than x, y), where there are "
      "constraints," },
    { settings.split && hasSegments, "CrossingMode Split" },
    { settings.laysSource() && this->GetSourcePoints() > 0,
      settings.sourceHeights == ahd::SourceHeights::Mixed ? "SourceHeights Mixed"
                                                          : "SourceHeights From Surface" },
  };
  for (const auto& one : unfit)
  {
    if (one.first)
    {
      return one.second;
    }
  }
  return nullptr;
}

std::vector<const vtkAHDRankFacts*> vtkAHDAllFacts::GetThoseWithData() const
{
  std::vector<const vtkAHDRankFacts*> some;
  const bool areEmpty = this->GetPoints() == 0;
  for (const vtkAHDRankFacts& facts : this->Of)
  {
    if (areEmpty ? !facts.Arrays.empty() : facts.Points > 0)
    {
      some.push_back(&facts);
    }
  }
  return some;
}

std::vector<vtkAHDArrayFacts> vtkAHDAllFacts::GetArrays() const
{
  std::vector<vtkAHDArrayFacts> common;
  bool isFirst = true;
  for (const vtkAHDRankFacts* facts : this->GetThoseWithData())
  {
    if (isFirst)
    {
      common = facts->Arrays;
      isFirst = false;
    }
    std::vector<vtkAHDArrayFacts> both;
    for (vtkAHDArrayFacts array : common)
    {
      const auto found = std::find(facts->Arrays.begin(), facts->Arrays.end(), array);
      if (found != facts->Arrays.end())
      {
        array.Attribute = array.Attribute == found->Attribute ? array.Attribute : -1;
        both.push_back(array);
      }
    }
    common.swap(both);
  }
  return common;
}

vtkSmartPointer<vtkPolyData> vtkAHDAllFacts::SelectArrays(vtkPointSet* input) const
{
  auto selected = vtkSmartPointer<vtkPolyData>::New();
  const bool isEmpty = !input || input->GetNumberOfPoints() == 0;
  if (!isEmpty)
  {
    selected->SetPoints(input->GetPoints());
  }
  for (const vtkAHDArrayFacts& facts : this->GetArrays())
  {
    vtkSmartPointer<vtkAbstractArray> array;
    if (isEmpty)
    {
      array = facts.Make(0);
    }
    else
    {
      array = input->GetPointData()->GetAbstractArray(facts.Name.c_str());
    }
    facts.AddTo(selected->GetPointData(), array);
  }
  return selected;
}

std::string vtkAHDAllFacts::GetPartialArrays() const
{
  const std::vector<vtkAHDArrayFacts> common = this->GetArrays();
  std::set<std::string> names;
  for (const vtkAHDRankFacts* facts : this->GetThoseWithData())
  {
    names.insert(facts->OtherArrays.begin(), facts->OtherArrays.end());
    for (const vtkAHDArrayFacts& array : facts->Arrays)
    {
      if (!IsNamed(common, array.Name))
      {
        names.insert(array.Name);
      }
    }
  }
  std::string words;
  for (const std::string& name : names)
  {
    words += (words.empty() ? "" : ", ") + name;
  }
  return words;
}

bool vtkAHDAllFacts::IsOneSource() const
{
  return this->Of[0].SourcePoints > 0 &&
    std::all_of(this->Of.begin(), this->Of.end(),
      [this](const vtkAHDRankFacts& facts) {
        return facts.SourcePoints == this->Of[0].SourcePoints && facts.Source == this->Of[0].Source;
      });
}

vtkAHDInput::SourceContent vtkAHDAllFacts::GetContent() const
{
  vtkAHDInput::SourceContent all;
  for (std::size_t rank = 0; rank < this->Of.size(); ++rank)
  {
    if (this->CountsSource(rank))
    {
      all.Points += this->Of[rank].Content.Points;
      all.Vertices += this->Of[rank].Content.Vertices;
      all.Strips += this->Of[rank].Content.Strips;
    }
  }
  return all;
}

std::size_t vtkAHDAllFacts::CountOnHostOf(std::size_t rank) const
{
  return static_cast<std::size_t>(std::count_if(this->Of.begin(), this->Of.end(),
    [this, rank](const vtkAHDRankFacts& facts) { return facts.Host == this->Of[rank].Host; }));
}

void vtkAHDCheckBefore(
  ahd::Status before, vtkAHDRanks& ranks, const vtkAHDContext& context, std::string& error)
{
  const ahd::Status status = ranks.agree(before);
  if (status != ahd::Status::Ok && status != ahd::Status::Cancelled)
  {
    error =
      "A rank could not take its input: its blocks could not be merged, its source is none or "
      "damaged, or there is too little memory. Nothing was computed on any rank.";
  }
  context.Check(status);
}

void vtkAHDMeet(const vtkAHDSettings& settings, const vtkAHDDataSets& data, vtkAHDRanks& ranks,
  const vtkAHDContext& context, vtkAHDAllFacts& facts)
{
  facts.Of = ranks.Share(context,
    [&]
    {
      vtkAHDRankFacts mine;
      vtkAHDReadSettings(settings, mine);
      vtkAHDReadArrays(data.Input, mine);
      vtkSmartPointer<vtkPointSet> input = data.Input;
      if (!input)
      {
        input = vtkSmartPointer<vtkPolyData>::New();
      }
      const vtkAHDInput counts(settings, input, data.Source);
      const ahd::InputRequest& request = counts.GetRequest();
      mine.Points = request.points.count;
      mine.SourcePoints = request.sourcePoints.count;
      mine.Segments = ahd::segmentsOf(request);
      mine.HasMarks = request.points.skip != nullptr;
      mine.MarksAreUnfit = counts.GetMarksAreUnfit();
      mine.Content = counts.GetSourceContent();
      if (mine.SourcePoints > 0)
      {
        mine.Source = vtkAHDFingerprintOf(data.Source, ranks.GetOwn(), context);
      }
      return mine;
    });
}
