// SPDX-License-Identifier: BSD-3-Clause
#include "LifetimeData.h"

#include "FilterJudge.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace ahd
{
namespace fuzz
{

vtkStandardNewMacro(TimedPoints);
vtkStandardNewMacro(ImageConsumer);

void TimedPoints::make(double time, int piece, int pieces, vtkPolyData* made)
{
  Dice dice(unsigned(time) + 1);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("h");
  std::vector<double> xyz;
  for (int i = 0; i < 60; ++i)
  {
    double place[3];
    for (double& coordinate : place)
    {
      coordinate = (1.0 + time) * double(dice.below(1 << 20)) / double(1 << 20);
    }
    if (i % pieces == piece)
    {
      xyz.insert(xyz.end(), place, place + 3);
      heights->InsertNextValue(place[0] + place[1]);
    }
  }
  made->SetPoints(pointsOf(xyz));
  made->GetPointData()->SetScalars(heights);
}

int TimedPoints::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const double steps[] = { 0.0, 1.0, 2.0, 3.0 };
  const double range[] = { 0.0, 3.0 };
  vtkInformation* const info = outputs->GetInformationObject(0);
  info->Set(Pipeline::TIME_STEPS(), steps, 4);
  info->Set(Pipeline::TIME_RANGE(), range, 2);
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int TimedPoints::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  const double time = info->Has(Pipeline::UPDATE_TIME_STEP())
    ? info->Get(Pipeline::UPDATE_TIME_STEP())
    : 0.0;
  make(time, std::max(0, info->Get(Pipeline::UPDATE_PIECE_NUMBER())),
    std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())), vtkPolyData::GetData(outputs));
  return 1;
}

int ImageConsumer::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs)->ShallowCopy(vtkImageData::GetData(inputs[0]));
  return 1;
}

vtkSmartPointer<vtkDoubleArray> Lenders::lend(std::vector<double> numbers)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(3);
  auto own = std::make_unique<std::vector<double>>(std::move(numbers));
  array->SetArray(own->data(), vtkIdType(own->size()), 1);
  all_.push_back({ array, std::move(own) });
  return array;
}

bool Lenders::lendOther(vtkDataArray* array)
{
  for (Lent& lent : all_)
  {
    if (lent.array == array)
    {
      auto other = std::make_unique<std::vector<double>>(numbersOf(array)); // it may have others
      lent.array->SetArray(other->data(), vtkIdType(other->size()), 1);
      std::fill(lent.numbers->begin(), lent.numbers->end(), -7.0);
      lent.numbers = std::move(other);
      return true;
    }
  }
  return false;
}

void Rubbish::fill(Dice& dice)
{
  if (all_.size() > 100)
  {
    all_.clear();
  }
  for (int k = 0; k < 20; ++k)
  {
    all_.emplace_back(16 + dice.below(2000), 1.0 / 3.0);
  }
}

std::vector<double> numbersOf(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double* tuple = array->GetTuple(i);
    numbers.insert(numbers.end(), tuple, tuple + array->GetNumberOfComponents());
  }
  return numbers;
}

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<double>& xyz)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
  {
    points->InsertNextPoint(xyz[i], xyz[i + 1], xyz[i + 2]);
  }
  return points;
}

namespace
{

std::vector<double> someNumbers(Dice& dice, std::size_t count, bool isLattice)
{
  std::vector<double> numbers(count);
  for (double& number : numbers)
  {
    number = isLattice ? double(dice.below(9)) / 8.0 : double(dice.below(1 << 20)) / (1 << 20);
  }
  return numbers;
}

void addHeights(vtkPolyData* data, Dice& dice)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("h");
  for (const double z : someNumbers(dice, std::size_t(data->GetNumberOfPoints()), false))
  {
    heights->InsertNextValue(z);
  }
  data->GetPointData()->SetScalars(heights);
}

void insertCell(vtkCellArray* cells, std::initializer_list<vtkIdType> corners)
{
  cells->InsertNextCell(vtkIdType(corners.size()), corners.begin());
}

} // namespace

vtkSmartPointer<vtkPolyData> makeInput(Dice& dice)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  const std::size_t counts[] = { 40, 61, 150 };
  const bool isLattice = dice.below(4) == 0;
  made->SetPoints(pointsOf(someNumbers(dice, 3 * counts[dice.below(3)], isLattice)));
  if (dice.below(4) == 0)
  {
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(made->GetPoints()->GetData());
    made->GetPoints()->SetData(floats);
  }
  addHeights(made, dice);
  return made;
}

vtkSmartPointer<vtkPolyData> makeSource(Dice& dice)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->SetPoints(pointsOf(someNumbers(dice, 36, false)));
  addHeights(made, dice);
  vtkNew<vtkCellArray> lines;
  const auto first = vtkIdType(dice.below(6));
  insertCell(lines, { first, first + 1, first + 5 });
  if (dice.below(2) == 0)
  {
    insertCell(lines, { first + 2, first + 3 });
  }
  made->SetLines(lines);
  if (dice.below(2) == 0)
  {
    vtkNew<vtkCellArray> polys;
    insertCell(polys, { first, first + 2, first + 4, first + 6 });
    made->SetPolys(polys);
  }
  return made;
}

void makeLie(vtkPolyData* source, Dice& dice)
{
  const std::vector<vtkIdType> lies[] = { { 0, 2, 200000000 }, { 0, 5, 2, 3 }, { 0, -7, 3 },
    { 1, 2, 3 }, { 0, 2, 3, 900 } };
  vtkNew<vtkIdTypeArray> offsets, corners;
  for (const vtkIdType offset : lies[dice.below(5)])
  {
    offsets->InsertNextValue(offset);
  }
  for (vtkIdType k = 0; k < 3; ++k)
  {
    corners->InsertNextValue(k);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  source->SetLines(cells);
}

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->DeepCopy(data);
  return made;
}

std::string rasterText(vtkDataObject* raster)
{
  auto* image = vtkImageData::SafeDownCast(raster);
  if (!image)
  {
    return textOf(raster);
  }
  char text[300];
  const int* extent = image->GetExtent();
  std::snprintf(text, sizeof text, "%d %d %d %d: %a %a, %a %a\n", extent[0], extent[1], extent[2],
    extent[3], image->GetOrigin()[0], image->GetOrigin()[1], image->GetSpacing()[0],
    image->GetSpacing()[1]);
  return text + partText(raster, extent) + textOf(raster);
}

std::string partText(vtkDataObject* raster, const int extent[6])
{
  auto* image = vtkImageData::SafeDownCast(raster);
  std::string text;
  char word[40];
  for (int i = 0; image && i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = image->GetPointData()->GetArray(i);
    text += array->GetName() + std::string(":");
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        int cell[3] = { x, y, 0 };
        const double value = array->GetTuple(image->ComputePointId(cell))[0];
        std::snprintf(word, sizeof word, std::isnan(value) ? " nan" : " %a", value);
        text += word;
      }
    }
    text += "\n";
  }
  return text;
}

bool areClose(vtkDataObject* found, vtkDataObject* wanted)
{
  vtkDataSet* const sets[] = { vtkDataSet::SafeDownCast(found), vtkDataSet::SafeDownCast(wanted) };
  const int arrays = sets[1]->GetPointData()->GetNumberOfArrays();
  bool isClose = sets[0]->GetPointData()->GetNumberOfArrays() == arrays &&
    sets[0]->GetNumberOfPoints() == sets[1]->GetNumberOfPoints();
  for (int k = 0; isClose && k < arrays; ++k)
  {
    const std::vector<double> one = numbersOf(sets[0]->GetPointData()->GetArray(k));
    const std::vector<double> other = numbersOf(sets[1]->GetPointData()->GetArray(k));
    isClose = std::equal(one.begin(), one.end(), other.begin(), other.end(),
      [](double a, double b)
      { return std::isnan(a) ? std::isnan(b) : std::fabs(a - b) <= 1e-11 * (1 + std::fabs(b)); });
  }
  return isClose;
}

} // namespace fuzz
} // namespace ahd
