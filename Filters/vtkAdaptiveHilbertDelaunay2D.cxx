// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "Engine/Options.h"
#include "Engine/Result.h"
#include "Engine/Triangulate.h"
#include "vtkAHDExecutor.h"
#include "vtkAHDInput.h"
#include "vtkAHDMemory.h"
#include "vtkAHDOrderOutput.h"
#include "vtkAHDOutput.h"
#include "vtkAHDProgress.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#if VTK_MODULE_ENABLE_VTK_ParallelCore
#include "vtkMultiProcessController.h"
#endif

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkAdaptiveHilbertDelaunay2D);

vtkAdaptiveHilbertDelaunay2D::vtkAdaptiveHilbertDelaunay2D()
  : Triangulator(new ahd::Triangulator)
{
  this->SetNumberOfOutputPorts(2);
}
vtkAdaptiveHilbertDelaunay2D::~vtkAdaptiveHilbertDelaunay2D() = default;

/// One execution: what the steps of RequestData share.
class vtkAdaptiveHilbertDelaunay2D::Run
{
public:
  Run(vtkAdaptiveHilbertDelaunay2D* filter, vtkPointSet* input, vtkInformationVector* outputs)
    : Filter(filter)
    , Input(input)
    , Surface(vtkPolyData::GetData(outputs, 0))
    , Order(vtkPolyData::GetData(outputs, 1))
    , Points(input)
    , Progress(filter)
    , Executor(vtkAHDThreadsToUse(filter->NumberOfThreads))
  {
  }
  ~Run();

  /// Is there memory for it all, as far as that is known before? Says so if not.
  bool FitsInMemory();

  /// Triangulates and fills the outputs; throws nothing.
  ahd::Status Triangulate();

  /// Empties the outputs and says why, unless it was the user who cancelled.
  void Fail(ahd::Status status);

  /// Shows the counts and times of this execution in the filter's Get methods.
  void KeepMeasures();

  /// Warns of marks that do not fit the points, of rejected points, of z that are not finite, and
  /// of a result without triangles.
  void Warn();

private:
  ahd::Options GetOptions() const;
  bool IsOrderWanted() const;
  std::size_t EstimateBytes() const;
  void AddBoxesToEstimate(std::size_t boxes);
  ahd::Status TriangulateOrThrow();
  ahd::Status WriteOutputs();
  void WarnOfNoTriangle();

  vtkAdaptiveHilbertDelaunay2D* const Filter;
  vtkPointSet* const Input;
  vtkPolyData* const Surface;
  vtkPolyData* const Order;
  vtkAHDInput Points;
  vtkAHDProgress Progress;
  vtkAHDExecutor Executor;
  vtkTypeInt64 Limit = 0;    // KiB
  std::size_t MostBoxes = 0; // for which there is memory
  ahd::Report Report;
  vtkAHDInput::Oddities Odd;
};

/// The working memory is kept for the next execution if it is not too much; the input is not.
vtkAdaptiveHilbertDelaunay2D::Run::~Run()
{
  ahd::Triangulator& triangulator = *this->Filter->Triangulator;
  triangulator.forgetPoints();
  const std::size_t held = (triangulator.memoryHeld() + 1023) / 1024;
  if (static_cast<vtkTypeInt64>(held) > this->Filter->ReuseLimit)
  {
    triangulator.release();
  }
}

int vtkAdaptiveHilbertDelaunay2D::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ClearMeasures();
  this->WarnAboutRanks();

  vtkDataObject* data = vtkDataObject::GetData(inputVector[0]);
  vtkPointSet* input = vtkPointSet::SafeDownCast(data);
  if (!input)
  {
    // A block of a composite data set: their types are not looked at by the pipeline.
    vtkWarningMacro("A " << (data ? data->GetClassName() : "missing block")
                         << " has no points of its own: nothing was triangulated for it.");
    return 1;
  }
  // Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more, run
  // this filter again with every Update(), and keep the filters behind it at their last output.
  Run run(this, input, outputVector);
  if (!run.FitsInMemory())
  {
    return 1;
  }
  const ahd::Status status = run.Triangulate();
  if (status != ahd::Status::Ok)
  {
    run.Fail(status);
    return 1;
  }
  run.KeepMeasures();
  run.Warn();
  return 1;
}

int vtkAdaptiveHilbertDelaunay2D::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

ahd::Options vtkAdaptiveHilbertDelaunay2D::Run::GetOptions() const
{
  ahd::Options options;
  options.order = static_cast<ahd::InsertionOrder>(this->Filter->InsertionOrder);
  options.controlPoints = static_cast<ahd::ControlPoints>(this->Filter->ControlPoints);
  options.geneRotation = this->Filter->GeneRotation;
  options.nmax = this->Filter->Nmax;
  options.countWork = this->Filter->CountWork;
  options.insertionLimit = static_cast<std::size_t>(this->Filter->InsertionLimit);
  options.keepOrder = this->Filter->GenerateInsertionRank || this->IsOrderWanted();
  options.keepBoxes = this->Filter->GenerateBoxes;
  options.mostBoxes = this->MostBoxes;
  return options;
}

/// Is anything of the second output asked for?
bool vtkAdaptiveHilbertDelaunay2D::Run::IsOrderWanted() const
{
  return this->Filter->GenerateInsertionCurve || this->Filter->GenerateBoxes;
}

/// How many boxes there are shows only when the points are sorted; the rest is known before.
std::size_t vtkAdaptiveHilbertDelaunay2D::Run::EstimateBytes() const
{
  const std::size_t count = static_cast<std::size_t>(this->Points.GetCount());
  const std::size_t limit = static_cast<std::size_t>(this->Filter->InsertionLimit);
  const std::size_t idArrays = static_cast<std::size_t>(this->Filter->GenerateFate) +
    static_cast<std::size_t>(this->Filter->GenerateInsertionRank);
  std::size_t bytes = ahd::Triangulator::memoryEstimate(count, this->GetOptions()) +
    vtkAHDOutput::EstimateBytes(count, idArrays) + this->Points.GetBytesToConvert();
  if (this->IsOrderWanted())
  {
    bytes += vtkAHDOrderOutput::EstimateBytes(limit > 0 ? std::min(limit, count) : count);
  }
  return bytes;
}

bool vtkAdaptiveHilbertDelaunay2D::Run::FitsInMemory()
{
  // What was kept for this execution is part of the estimate. With a limit, all of it is given back
  // where it might be too much.
  const std::size_t bytes = this->EstimateBytes();
  ahd::Triangulator& triangulator = *this->Filter->Triangulator;
  const bool isLimited = this->Filter->MemoryLimit > 0;
  if (isLimited && triangulator.memoryHeld() / 1024 > bytes / 1024)
  {
    triangulator.release();
  }
  constexpr vtkTypeInt64 kPlenty = vtkTypeInt64(1) << 50;
  const vtkTypeInt64 needed = static_cast<vtkTypeInt64>(bytes / 1024);
  const vtkTypeInt64 held = static_cast<vtkTypeInt64>(triangulator.memoryHeld() / 1024);
  this->Limit = std::min(
    kPlenty, isLimited ? this->Filter->MemoryLimit : vtkAHDAvailableMemory() + held);
  this->Filter->MemoryEstimate = needed;
  if (needed > this->Limit)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "Triangulating "
        << this->Points.GetCount() << " points may take " << needed << " KiB of memory, but "
        << (isLimited ? "MemoryLimit allows " : "there are ") << this->Limit
        << " KiB. Nothing was computed. Take fewer points, or set MemoryLimit (in KiB) to allow "
           "more.");
    return false;
  }
  const std::size_t left = (static_cast<std::size_t>(this->Limit) + 1) * 1024 - 1 - bytes;
  this->MostBoxes = left / vtkAHDOrderOutput::EstimateBoxBytes(1);
  return true;
}

ahd::Status vtkAdaptiveHilbertDelaunay2D::Run::Triangulate()
{
  try
  {
    return this->TriangulateOrThrow();
  }
  catch (const std::bad_alloc&)
  {
    return ahd::Status::OutOfMemory;
  }
}

ahd::Status vtkAdaptiveHilbertDelaunay2D::Run::TriangulateOrThrow()
{
  ahd::Triangulator& triangulator = *this->Filter->Triangulator;
  if (!this->Points.Open(this->Executor, this->Progress))
  {
    return ahd::Status::Cancelled;
  }
  ahd::Status status = triangulator.run(
    this->Points.View(), this->GetOptions(), &this->Progress, &this->Executor);
  this->Progress.Finish();
  this->AddBoxesToEstimate(
    status == ahd::Status::TooManyBoxes ? this->MostBoxes + 1 : triangulator.boxes().size());
  if (status == ahd::Status::Ok &&
    !this->Points.FindOddities(this->Executor, this->Progress, this->Odd))
  {
    status = ahd::Status::Cancelled;
  }
  if (status == ahd::Status::Ok)
  {
    status = this->WriteOutputs();
  }
  this->Progress.Finish();
  this->Report = triangulator.report();
  return status;
}

void vtkAdaptiveHilbertDelaunay2D::Run::AddBoxesToEstimate(std::size_t boxes)
{
  const std::size_t bytes = this->EstimateBytes() + vtkAHDOrderOutput::EstimateBoxBytes(boxes);
  this->Filter->MemoryEstimate = static_cast<vtkTypeInt64>(bytes / 1024);
}

ahd::Status vtkAdaptiveHilbertDelaunay2D::Run::WriteOutputs()
{
  ahd::Triangulator& triangulator = *this->Filter->Triangulator;
  ahd::Status status = vtkAHDOutput::Write(
    triangulator, this->Input, this->Surface, this->Executor, this->Progress);
  if (status == ahd::Status::Ok && this->Filter->GenerateFate)
  {
    status = vtkAHDOutput::AddFate(triangulator, this->Surface, this->Executor, this->Progress);
  }
  if (status == ahd::Status::Ok && this->Filter->GenerateInsertionRank)
  {
    status = vtkAHDOutput::AddInsertionRank(
      triangulator, this->Surface, this->Executor, this->Progress);
  }
  if (status == ahd::Status::Ok && this->IsOrderWanted())
  {
    vtkAHDOrderOutput order(triangulator, this->Points, this->Executor, this->Progress);
    status = order.Write(this->Filter->GenerateInsertionCurve, this->Order);
  }
  return status;
}

void vtkAdaptiveHilbertDelaunay2D::Run::Fail(ahd::Status status)
{
  this->Surface->Initialize();
  this->Order->Initialize();
  this->Filter->Triangulator->release();
  if (status == ahd::Status::TooManyPoints)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "" << this->Points.GetCount() << " points are too many: at most " << ahd::kMaximumPoints
         << " can be triangulated.");
  }
  else if (status == ahd::Status::TooManyBoxes)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "The grid of "
        << this->Points.GetCount() << " points has more than " << this->MostBoxes
        << " boxes, and putting out more may take more memory than "
        << (this->Filter->MemoryLimit > 0 ? "MemoryLimit allows, " : "there is, ") << this->Limit
        << " KiB. Nothing was computed. Switch GenerateBoxes off, take fewer points or "
           "a larger Nmax, or set MemoryLimit (in KiB) to allow more.");
  }
  else if (status == ahd::Status::OutOfMemory)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "Out of memory while triangulating " << this->Points.GetCount() << " points; about "
                                           << this->Filter->MemoryEstimate << " KiB are needed.");
  }
}

void vtkAdaptiveHilbertDelaunay2D::Run::KeepMeasures()
{
  vtkAdaptiveHilbertDelaunay2D* filter = this->Filter;
  filter->NumberOfPointsInserted = static_cast<vtkIdType>(this->Report.inserted);
  filter->NumberOfDuplicates = static_cast<vtkIdType>(this->Report.duplicates);
  filter->NumberOfRejectedPoints = static_cast<vtkIdType>(this->Report.notFinite);
  filter->NumberOfSkippedPoints = static_cast<vtkIdType>(this->Report.skipped);
  filter->NumberOfPointsBeyondLimit = static_cast<vtkIdType>(this->Report.beyondLimit);
  filter->NumberOfTriangles = static_cast<vtkIdType>(this->Report.triangles);
  if (filter->CountWork)
  {
    filter->NP = this->Report.np();
    filter->NR = this->Report.nr();
  }
  filter->SortSeconds = this->Progress.GetSeconds(ahd::Phase::Read) +
    this->Progress.GetSeconds(ahd::Phase::Sort);
  filter->InsertSeconds = this->Progress.GetSeconds(ahd::Phase::Insert);
  filter->OutputSeconds = this->Progress.GetSeconds(ahd::Phase::Extract) +
    this->Progress.GetSeconds(ahd::Phase::Fates);
  filter->NumberOfThreadsUsed = static_cast<int>(this->Executor.GetThreadsUsed());
}

void vtkAdaptiveHilbertDelaunay2D::Run::Warn()
{
  if (this->Points.GetMarksAreUnfit())
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The point data array " << vtkDataSetAttributes::GhostArrayName()
                              << " does not have one value for each of the "
                              << this->Points.GetCount() << " points, so no point was skipped.");
  }
  if (this->Report.notFinite > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "" << this->Report.notFinite << " of " << this->Points.GetCount()
         << " points were left out, since their x or y is NaN or infinite; the first is point "
         << this->Odd.FirstRejected << ".");
  }
  if (this->Odd.OddZ > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "" << this->Odd.OddZ << " of " << this->Points.GetCount()
         << " points have a z that is NaN or infinite. They are part of the triangulation, which "
            "is computed in x and y, but cannot be drawn.");
  }
  if (this->Report.triangles == 0 && this->Report.inserted + this->Report.notFinite > 0)
  {
    this->WarnOfNoTriangle();
  }
}

void vtkAdaptiveHilbertDelaunay2D::Run::WarnOfNoTriangle()
{
  const bool areFew = this->Report.inserted < 3;
  if (this->Report.beyondLimit > 0)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "There is no triangle yet, because InsertionLimit has only the first "
        << this->Report.inserted << " of " << this->Report.inserted + this->Report.beyondLimit
        << " distinct points inserted, "
        << (areFew ? "fewer than three." : "and these are collinear."));
    return;
  }
  vtkWarningWithObjectMacro(this->Filter,
    "There is no triangle, because " << (areFew ? "there are fewer than three distinct points: "
                                                : "all distinct points are collinear: ")
                                     << this->Report.inserted << " distinct points among "
                                     << this->Points.GetCount() << ".");
}

void vtkAdaptiveHilbertDelaunay2D::ClearMeasures()
{
  this->NumberOfPointsInserted = 0;
  this->NumberOfDuplicates = 0;
  this->NumberOfRejectedPoints = 0;
  this->NumberOfSkippedPoints = 0;
  this->NumberOfPointsBeyondLimit = 0;
  this->NumberOfTriangles = 0;
  this->NP = -1.0;
  this->NR = -1.0;
  this->SortSeconds = 0.0;
  this->InsertSeconds = 0.0;
  this->OutputSeconds = 0.0;
  this->NumberOfThreadsUsed = 0;
  this->MemoryEstimate = 0;
}

void vtkAdaptiveHilbertDelaunay2D::WarnAboutRanks()
{
#if VTK_MODULE_ENABLE_VTK_ParallelCore
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (!this->WarnedAboutRanks && ranks && ranks->GetNumberOfProcesses() > 1 &&
    ranks->GetLocalProcessId() == 0)
  {
    this->WarnedAboutRanks = true;
    vtkWarningMacro("There are " << ranks->GetNumberOfProcesses()
                                 << " ranks, and each triangulates its own points only: the "
                                    "surfaces of the ranks do not join.");
  }
#endif
}

void vtkAdaptiveHilbertDelaunay2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InsertionOrder: " << this->InsertionOrder << "\n";
  os << indent << "Nmax: " << this->Nmax << "\n";
  os << indent << "ControlPoints: " << this->ControlPoints << "\n";
  os << indent << "GeneRotation: " << (this->GeneRotation ? "On\n" : "Off\n");
  os << indent << "CountWork: " << (this->CountWork ? "On\n" : "Off\n");
  os << indent << "GenerateFate: " << (this->GenerateFate ? "On\n" : "Off\n");
  os << indent << "InsertionLimit: " << this->InsertionLimit << "\n";
  os << indent << "GenerateInsertionRank: " << (this->GenerateInsertionRank ? "On\n" : "Off\n");
  os << indent << "GenerateInsertionCurve: " << (this->GenerateInsertionCurve ? "On\n" : "Off\n");
  os << indent << "GenerateBoxes: " << (this->GenerateBoxes ? "On\n" : "Off\n");
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "ReuseLimit: " << this->ReuseLimit << "\n";
  os << indent << "NumberOfPointsInserted: " << this->NumberOfPointsInserted << "\n";
  os << indent << "NumberOfDuplicates: " << this->NumberOfDuplicates << "\n";
  os << indent << "NumberOfRejectedPoints: " << this->NumberOfRejectedPoints << "\n";
  os << indent << "NumberOfSkippedPoints: " << this->NumberOfSkippedPoints << "\n";
  os << indent << "NumberOfPointsBeyondLimit: " << this->NumberOfPointsBeyondLimit << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NP: " << this->NP << "\n";
  os << indent << "NR: " << this->NR << "\n";
  os << indent << "SortSeconds: " << this->SortSeconds << "\n";
  os << indent << "InsertSeconds: " << this->InsertSeconds << "\n";
  os << indent << "OutputSeconds: " << this->OutputSeconds << "\n";
  os << indent << "NumberOfThreadsUsed: " << this->NumberOfThreadsUsed << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << "\n";
}
