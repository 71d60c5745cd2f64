// SPDX-License-Identifier: BSD-3-Clause
//
// The steps that change the world: settings, connections, inputs, outputs.
#include "LifetimeWorld.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace ahd
{
namespace fuzz
{

void LifetimeWorld::setSurface(Dice& dice)
{
  settings_[dice.below(8)] = std::uint8_t(dice.below(12));
  this->attach();
}

void LifetimeWorld::setRaster(Dice& dice)
{
  settings_[8 + dice.below(4)] = std::uint8_t(dice.below(12));
  this->attach();
}

void LifetimeWorld::setNumbers(Dice& dice)
{
  settings_[12] = std::uint8_t(dice.below(12));
  settings_[13 + dice.below(5)] = std::uint8_t(dice.below(60));
  this->attach();
}

void LifetimeWorld::setMesh(Dice& dice)
{
  settings_[18 + dice.below(3)] = std::uint8_t(dice.below(12));
  this->attach();
}

void LifetimeWorld::setTransform(Dice& dice)
{
  transform_ = nullptr;
  if (dice.below(3) != 0)
  {
    vtkNew<vtkTransform> turned;
    turned->RotateZ(double(dice.below(90)));
    transform_ = turned;
  }
  this->attach();
}

void LifetimeWorld::connect(Dice& dice)
{
  const Route routes[] = { kData, kSurface, kStream, kStream };
  route_ = routes[dice.below(4)];
  this->attach();
}

void LifetimeWorld::giveTime(Dice& dice)
{
  time_ = double(dice.below(4));
  isCurrent_ = false;
  if (route_ == kStream)
  {
    raster_->UpdateTimeStep(time_);
  }
}

void LifetimeWorld::addConsumer(Dice& dice)
{
  const auto made = vtkSmartPointer<ImageConsumer>::New();
  made->SetInputConnection(consumers_.empty() || dice.below(2) == 0
      ? raster_->GetOutputPort(0)
      : consumers_.back()->GetOutputPort(0));
  consumers_.emplace_back(made);
  if (settings_[11] % 4 != 1 && dice.below(2) == 0)
  {
    made->Update();
  }
}

/// While it is connected; then another time.
void LifetimeWorld::deleteConsumer(Dice& dice)
{
  if (!consumers_.empty())
  {
    consumers_.erase(consumers_.begin() + std::ptrdiff_t(dice.below(consumers_.size())));
  }
  rubbish_.fill(dice);
  this->giveTime(dice);
}

void LifetimeWorld::newFilter(Dice& dice)
{
  if (dice.below(2) == 0)
  {
    surface_ = vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>::New();
  }
  else
  {
    raster_ = vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D>::New();
  }
  rubbish_.fill(dice);
  this->attach();
}

void LifetimeWorld::newMesh(Dice& dice)
{
  mesh_ = vtkSmartPointer<vtkAdaptiveHilbertQualityMesh2D>::New();
  rubbish_.fill(dice);
  this->attach();
}

// --- Inputs ------------------------------------------------------------------------------------

void LifetimeWorld::newInput(Dice& dice)
{
  input_ = makeInput(dice);
  this->attach();
}

void LifetimeWorld::changeInPlace(Dice& dice)
{
  vtkDataArray* const xyz = input_->GetPoints()->GetData();
  const auto row = vtkIdType(dice.below(std::size_t(xyz->GetNumberOfTuples())));
  const int column = int(dice.below(2));
  xyz->SetComponent(row, column, xyz->GetComponent(row, column) + 0.25);
  isCurrent_ = false;
  this->inputModified();
}

/// The same numbers at another address; the former memory is reused or freed.
void LifetimeWorld::movePoints(Dice& dice)
{
  const std::size_t before = dice.below(3);
  if (before == 0)
  {
    this->updateSurface(dice);
  }
  else if (before == 1)
  {
    this->updateRaster(dice);
  }
  vtkPoints* const points = input_->GetPoints();
  const std::vector<double> xyz = numbersOf(points->GetData());
  switch (dice.below(6))
  {
    case 0:
      points->Resize(4 * points->GetNumberOfPoints());
      break;
    case 1:
      points->Initialize();
      for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
      {
        points->InsertNextPoint(xyz[i], xyz[i + 1], xyz[i + 2]);
      }
      break;
    case 2:
      input_->SetPoints(pointsOf(xyz));
      break;
    default:
      if (!lenders_.lendOther(points->GetData()))
      {
        points->SetData(lenders_.lend(xyz));
      }
  }
  this->inputModified();
  rubbish_.fill(dice);
  if (before == 0)
  {
    this->interpolateOnOutput(dice);
  }
  else if (before == 1)
  {
    this->updateRaster(dice);
  }
}

/// Another data set of the same content; the one before is overwritten, or deleted.
void LifetimeWorld::copyInput(Dice& dice)
{
  const auto old = input_;
  input_ = copyOf(old);
  if (dice.below(2) == 0)
  {
    old->GetPoints()->GetData()->Fill(9.0);
    old->GetPoints()->GetData()->Modified();
  }
  this->attach();
}

void LifetimeWorld::changeData(Dice& dice)
{
  vtkPointData* const data = input_->GetPointData();
  const vtkIdType count = input_->GetNumberOfPoints();
  isCurrent_ = false;
  vtkDataArray* const heights = data->GetArray("h");
  if (heights && dice.below(2) == 0)
  {
    heights->SetComponent(vtkIdType(dice.below(std::size_t(count))), 0, 5.0);
    heights->Modified();
  }
  else if (data->HasArray("vtkGhostType"))
  {
    data->RemoveArray("vtkGhostType");
  }
  else
  {
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName("vtkGhostType");
    for (vtkIdType i = 0; i < count; ++i)
    {
      marks->InsertNextValue(dice.below(4) == 0 ? 2 : 0);
    }
    data->AddArray(marks);
  }
  data->Modified();
  this->inputModified();
}

void LifetimeWorld::newSource(Dice& dice)
{
  source_ = dice.below(4) != 0 ? makeSource(dice) : nullptr;
  this->attach();
}

void LifetimeWorld::changeSource(Dice& dice)
{
  if (!source_)
  {
    return;
  }
  isCurrent_ = false;
  vtkPoints* const points = source_->GetPoints();
  if (dice.below(2) == 0)
  {
    const auto other = makeSource(dice);
    source_->SetLines(other->GetLines());
    source_->SetPolys(other->GetPolys());
  }
  else if (!lenders_.lendOther(points->GetData()))
  {
    points->SetData(lenders_.lend(numbersOf(points->GetData())));
  }
  points->GetData()->Modified();
  points->Modified();
  source_->Modified();
  rubbish_.fill(dice);
}

/// Invalid cells are an error, or left out, and nothing else.
void LifetimeWorld::lieInSource(Dice& dice)
{
  const auto before = source_;
  source_ = makeSource(dice);
  makeLie(source_, dice);
  this->attach();
  surface_->Update();
  raster_->Update();
  source_ = before;
  this->attach();
}

// --- Outputs -----------------------------------------------------------------------------------

/// Outputs of a filter belong to their holder.
void LifetimeWorld::editOutput(Dice& dice)
{
  vtkPolyData* const output = surface_->GetOutput();
  vtkCellData* const data = output->GetCellData();
  const int arrays = data->GetNumberOfArrays();
  vtkDataArray* const corners = output->GetPolys()->GetConnectivityArray();
  if (arrays > 0 && dice.below(2) == 0)
  {
    vtkDataArray* const array = data->GetArray(int(dice.below(std::size_t(arrays))));
    array->Fill(77.0);
  }
  else if (corners->GetNumberOfTuples() > 1)
  {
    corners->SetTuple1(0, corners->GetTuple1(1));
  }
  isCurrent_ = false;
  this->inputModified();
}

void LifetimeWorld::dropOutput(Dice&)
{
  surface_->GetOutput()->Initialize();
  isCurrent_ = false;
  surface_->Modified();
}

// --- While a filter works ----------------------------------------------------------------------

vtkAlgorithm* LifetimeWorld::oneFilter(Dice& dice)
{
  if (dice.below(2) == 0)
  {
    return surface_;
  }
  return hasMesh_ && dice.below(2) == 0 ? static_cast<vtkAlgorithm*>(mesh_) : raster_;
}

/// Updates it, and acts at one of its progress events.
void LifetimeWorld::workWith(vtkAlgorithm* filter, unsigned event, const std::function<void()>& act)
{
  struct Rest
  {
    unsigned events;
    const std::function<void()>* act;
  } rest{ event, &act };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&rest);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* left = static_cast<Rest*>(data);
      if (--left->events == 0)
      {
        (*left->act)();
      }
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  isCurrent_ = false;
}

void LifetimeWorld::abort(Dice& dice)
{
  vtkAlgorithm* const filter = this->oneFilter(dice);
  this->workWith(filter, 1 + unsigned(dice.below(5)), [filter] { filter->SetAbortExecute(1); });
}

/// The filter's data are replaced or deleted; the next execution is correct. Memory that is read,
/// such as that of an array, must not be changed meanwhile.
void LifetimeWorld::changeInObserver(Dice& dice)
{
  const std::size_t how = dice.below(5);
  const auto act = [&]
  {
    switch (how)
    {
      case 0:
        transform_ = nullptr;
        surface_->SetTransform(nullptr);
        raster_->GetTriangulation()->SetTransform(nullptr);
        mesh_->GetTriangulation()->SetTransform(nullptr);
        break;
      case 1:
        input_->Initialize();
        break;
      case 2:
        if (source_)
        {
          source_->Initialize();
        }
        break;
      case 3:
        surface_->SetSourceData(nullptr);
        raster_->SetSourceData(nullptr);
        mesh_->SetSourceData(nullptr);
        break;
      default:
        input_->SetPoints(vtkSmartPointer<vtkPoints>::New());
    }
    rubbish_.fill(dice);
  };
  this->workWith(this->oneFilter(dice), 1 + unsigned(dice.below(5)), act);
  input_ = makeInput(dice);
  this->newSource(dice);
}

} // namespace fuzz
} // namespace ahd
