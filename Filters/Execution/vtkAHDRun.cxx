// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDRun.h"

#include "Output/vtkAHDOrderOutput.h"
#include "Output/vtkAHDOutput.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkPolyData.h"

#include <new>

vtkAHDRun::vtkAHDRun(vtkAdaptiveHilbertDelaunay2D* filter, vtkPointSet* input, vtkPolyData* source,
  vtkInformationVector* outputs)
  : Filter(filter)
  , Triangulator(*filter->Triangulator)
  , Input(input)
  , Source(source)
  , Surface(vtkPolyData::GetData(outputs, 0))
  , Order(vtkPolyData::GetData(outputs, 1))
  , Voronoi(vtkPolyData::GetData(outputs, 2))
  , Points(input)
  , Progress(filter)
  , Executor(vtkAHDThreadsToUse(filter->NumberOfThreads))
{
}

/// The working memory is kept for the next execution if it is not too much; the input is not.
vtkAHDRun::~vtkAHDRun()
{
  this->Triangulator.forgetPoints();
  const std::size_t held = (this->Triangulator.memoryHeld() + 1023) / 1024;
  if (static_cast<vtkTypeInt64>(held) > this->Filter->ReuseLimit)
  {
    this->Triangulator.release();
  }
}

ahd::Status vtkAHDRun::Triangulate()
{
  ahd::Status status = ahd::Status::OutOfMemory;
  try
  {
    status = this->TakeSteps();
  }
  catch (const std::bad_alloc&)
  {
  }
  this->Progress.Finish();
  this->Report = this->Triangulator.report();
  return status;
}

ahd::Status vtkAHDRun::TakeSteps()
{
  using Step = ahd::Status (vtkAHDRun::*)();
  constexpr Step kSteps[] = { &vtkAHDRun::OpenPoints, &vtkAHDRun::Project, &vtkAHDRun::Merge,
    &vtkAHDRun::AddBounding, &vtkAHDRun::ReadConstraints, &vtkAHDRun::Split, &vtkAHDRun::Insert,
    &vtkAHDRun::ChooseShown, &vtkAHDRun::MakeVoronoi, &vtkAHDRun::Constrain,
    &vtkAHDRun::WritePoints, &vtkAHDRun::ShowMeans, &vtkAHDRun::WriteTriangles,
    &vtkAHDRun::ShowInTriangles, &vtkAHDRun::DropByLength, &vtkAHDRun::AddArrays,
    &vtkAHDRun::ShowInArrays, &vtkAHDRun::AddCellArrays, &vtkAHDRun::WriteVoronoi,
    &vtkAHDRun::WriteOrder };
  ahd::Status status = ahd::Status::Ok;
  for (const Step step : kSteps)
  {
    if (status == ahd::Status::Ok)
    {
      status = (this->*step)();
    }
  }
  return status;
}

ahd::Status vtkAHDRun::Insert()
{
  const ahd::Status status = this->Triangulator.run(
    this->Points.View(), this->GetOptions(), &this->Progress, &this->Executor);
  this->Progress.Finish();
  this->AddBoxesToEstimate(
    status == ahd::Status::TooManyBoxes ? this->MostBoxes + 1 : this->Triangulator.boxes().size());
  if (status == ahd::Status::Ok &&
    !this->Points.FindOddities(this->Executor, this->Progress, this->Odd))
  {
    return ahd::Status::Cancelled;
  }
  this->DelaunayTriangles = this->Triangulator.report().triangles;
  return status;
}

ahd::Status vtkAHDRun::WriteTriangles()
{
  return vtkAHDOutput::WriteTriangles(
    this->Triangulator, this->Surface, this->Executor, this->Progress);
}

ahd::Status vtkAHDRun::AddArrays()
{
  this->AddCrossings();
  ahd::Status status = ahd::Status::Ok;
  if (this->Filter->GeneratePointStatus)
  {
    status = vtkAHDOutput::AddFate(
      this->Triangulator, this->Merged, this->Surface, this->Executor, this->Progress);
  }
  if (status == ahd::Status::Ok && this->Filter->GenerateInsertionRank)
  {
    status = vtkAHDOutput::AddInsertionRank(
      this->Triangulator, this->Surface, this->Executor, this->Progress);
  }
  return status;
}

ahd::Status vtkAHDRun::WriteOrder()
{
  if (!this->IsOrderWanted())
  {
    return ahd::Status::Ok;
  }
  vtkAHDOrderOutput order(
    this->Triangulator, this->Points, this->Shown, this->Executor, this->Progress);
  return order.Write(this->Filter->GenerateInsertionCurve, this->Order);
}

ahd::Options vtkAHDRun::GetOptions() const
{
  ahd::Options options;
  options.order = static_cast<ahd::InsertionOrder>(this->Filter->InsertionOrder);
  options.controlPoints = static_cast<ahd::ControlPoints>(this->Filter->ControlPoints);
  options.geneRotation = this->Filter->GeneRotation;
  options.nmax = this->Filter->Nmax;
  options.countWork = this->Filter->CountWork;
  options.insertionLimit = static_cast<std::size_t>(this->Filter->InsertionLimit);
  options.keepOrder = this->Filter->GenerateInsertionRank || this->IsOrderWanted();
  options.keepLocations = this->Filter->GenerateVoronoi;
  options.keepBoxes = this->Filter->GenerateBoxes;
  options.mostBoxes = this->MostBoxes;
  return options;
}

/// Is anything of the second output asked for?
bool vtkAHDRun::IsOrderWanted() const
{
  return this->Filter->GenerateInsertionCurve || this->Filter->GenerateBoxes;
}
