// SPDX-License-Identifier: BSD-3-Clause
//
// The interpolation's raster where points have other bounds at each time, and downstream filters.
#include "PipelineSupport.h"
#include "Sampling/vtkAHDSampleInformation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace
{

using namespace ahdtest;

TEST(InterpolationTimes, EachTimeHasItsRaster)
{
  vtkNew<Moving> moving;
  WatchedInterpolation filter;
  filter->SetInputConnection(moving->GetOutputPort());
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.1, 0.1);
  for (const double time : { 0.0, 2.0, 1.0, 0.0, 1.0 })
  {
    filter->UpdateTimeStep(time);
    EXPECT_EQ(filter->GetNumberOfPlaces(), vtkIdType(100 * (1 + time) * (1 + time) + 0.5)) << time;
  }
}

/// VTK requests extents before there are data, and downstream filters cannot be given others then.
/// All requested cells exist.
TEST(InterpolationTimes, FiltersBehindHaveWhatTheyWereToldAtEachTime)
{
  vtkNew<Moving> moving;
  WatchedInterpolation filter;
  vtkNew<Behind> behind;
  moving->EmptyAt = 1.5;
  filter->SetInputConnection(moving->GetOutputPort());
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.1, 0.1);
  behind->SetInputConnection(filter->GetOutputPort());
  const auto expect = [&](vtkIdType places, vtkIdType pixels)
  {
    EXPECT_EQ(filter->GetNumberOfPlaces(), places);
    EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), pixels);
    EXPECT_TRUE(behind->HadAll);
    EXPECT_TRUE(filter.Said->Errors.empty());
    EXPECT_TRUE(filter.PipelineSaid->Errors.empty());
  };
  behind->UpdateTimeStep(1.0);
  behind->Update();
  expect(400, 400);
  behind->UpdateTimeStep(2.0); // larger: the announced cells are a part of it
  expect(900, 400);
  behind->Update();
  expect(900, 900);
  behind->UpdateTimeStep(0.0); // smaller: cells beyond the points have no value
  expect(900, 900);
  EXPECT_LT(filter->GetNumberOfValidPlaces(), 101);
  EXPECT_GT(filter->GetNumberOfValidPlaces(), 80);
  behind->Update();
  expect(100, 100);
  behind->UpdateTimeStep(1.5); // its bounds are unknown
  expect(100, 100);
  EXPECT_EQ(filter->GetNumberOfValidPlaces(), 0);
  EXPECT_TRUE(behind->HadItsPlace);
  filter->UseBoundsOn();
  for (const double time : { 0.0, 2.0, 1.0 })
  {
    behind->UpdateTimeStep(time);
    expect(100, 100);
    EXPECT_TRUE(behind->HadItsPlace);
  }
}

/// A request without a cell, whichever side is empty, asks for none.
TEST(InterpolationTimes, FiltersBehindThatWantNothingAreToldOfNothing)
{
  vtkNew<vtkInformation> info;
  EXPECT_EQ(vtkAHDToldRaster(info).columns, 0u);
  const int none[][6] = { { 0, -1, 0, -1, 0, -1 }, { 0, -1, 0, 7, 0, 0 }, { 0, 9, 0, -1, 0, 0 },
    { 4, 3, 0, 7, 0, 0 }, { 0, 9, 5, 2, 0, 0 } };
  for (const auto& extent : none)
  {
    info->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
    EXPECT_EQ(vtkAHDToldRaster(info).columns, 0u) << extent[0] << " " << extent[2];
  }
  const int some[] = { 2, 9, 3, 7, 0, 0 };
  info->Set(Pipeline::UPDATE_EXTENT(), some, 6);
  EXPECT_EQ(vtkAHDToldRaster(info).columns, 10u); // cells are counted from the corner
  EXPECT_EQ(vtkAHDToldRaster(info).rows, 8u);
}

/// A raster that is larger than its points, for downstream filters, is so only until the next
/// update.
TEST(InterpolationTimes, ARasterThatWasCoveredIsItsOwnAtTheNextUpdate)
{
  vtkNew<Moving> moving;
  moving->EmptyAt = 1.5;
  WatchedInterpolation filter;
  vtkNew<Behind> behind;
  filter->SetInputConnection(moving->GetOutputPort());
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.1, 0.1);
  filter->AlignToCellSizeOn(); // the corner stays
  behind->SetInputConnection(filter->GetOutputPort());
  const std::pair<double, vtkIdType> own[] = { { 2.0, 900 }, { 0.0, 100 }, { 1.5, 0 },
    { 1.0, 400 } };
  vtkIdType before = 0;
  for (const auto& step : own)
  {
    behind->UpdateTimeStep(step.first);
    EXPECT_EQ(filter->GetNumberOfPlaces(), std::max(step.second, before));
    behind->Update();
    EXPECT_EQ(filter->GetNumberOfPlaces(), step.second);
    EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), step.second);
    before = step.second;
  }
  EXPECT_TRUE(behind->HadAll);
  EXPECT_TRUE(filter.Said->Errors.empty());
}

/// As many cells somewhere else: filters for images place them at the announced origin, which is
/// reported once, and are correct from the next update on.
TEST(InterpolationTimes, AnotherPlaceIsSaidOnce)
{
  vtkNew<Moving> moving;
  moving->Begin = 5.0;
  WatchedInterpolation filter;
  vtkNew<Behind> behind;
  filter->SetInputConnection(moving->GetOutputPort());
  behind->SetInputConnection(filter->GetOutputPort());
  for (const double time : { 0.0, 1.0, 2.0 })
  {
    behind->UpdateTimeStep(time);
    EXPECT_EQ(behind->HadItsPlace, time == 0.0);
    EXPECT_EQ(filter.Said->Warnings.size(), time == 0.0 ? 0u : 1u);
    behind->Update();
    EXPECT_TRUE(behind->HadItsPlace);
  }
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("UseBounds"), std::string::npos);
  WatchedInterpolation alone; // nothing was reported
  alone->SetInputConnection(moving->GetOutputPort());
  for (const double time : { 0.0, 1.0, 2.0 })
  {
    alone->UpdateTimeStep(time);
    EXPECT_EQ(alone->GetOutput()->GetBounds()[0] > 4.0, time > 0.0);
  }
  EXPECT_TRUE(alone.Said->Warnings.empty());
}

/// An executive whose memory is overwritten at deletion and not reused: following a pointer to it
/// crashes.
class Tombstone : public vtkStreamingDemandDrivenPipeline
{
public:
  static Tombstone* New() { VTK_STANDARD_NEW_BODY(Tombstone); }
  vtkTypeMacro(Tombstone, vtkStreamingDemandDrivenPipeline);
  static void* operator new(std::size_t size) { return std::malloc(size); }
  static void operator delete(void* memory, std::size_t size)
  {
    static std::vector<std::shared_ptr<void>> graves;
    graves.emplace_back(std::memset(memory, 0xA5, size), std::free);
  }
};

/// VTK's list of consumers keeps those that were deleted while they were connected.
/// There is no memory to tell an observer.
class Unheard : public vtkCommand
{
public:
  static Unheard* New() { return new Unheard; }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    ++this->Times;
    throw std::bad_alloc();
  }
  int Times = 0;
};

TEST(InterpolationTimes, AnotherPlaceThatCannotBeSaidIsAnError)
{
  vtkNew<Moving> moving;
  moving->Begin = 5.0;
  vtkNew<vtkAdaptiveHilbertInterpolation2D> filter;
  vtkNew<Unheard> unheard;
  vtkNew<Messages> said, pipelineSaid;
  vtkNew<Behind> behind;
  filter->SetInputConnection(moving->GetOutputPort());
  behind->SetInputConnection(filter->GetOutputPort());
  behind->UpdateTimeStep(0.0);
  filter->AddObserver(vtkCommand::WarningEvent, unheard);
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  pipelineSaid->Watch(filter->GetExecutive());
  EXPECT_NO_THROW(behind->UpdateTimeStep(1.0));
  EXPECT_EQ(unheard->Times, 1);
  ASSERT_EQ(said->Errors.size(), 1u);
  EXPECT_NE(said->Errors[0].find("emory"), std::string::npos) << said->Errors[0];
  EXPECT_EQ(behind->Executed, 1) << "on an empty image";
  EXPECT_EQ(filter->GetNumberOfPlaces(), 0);
  behind->Update();
  EXPECT_EQ(behind->Executed, 2);
  EXPECT_TRUE(behind->HadItsPlace);
}

TEST(InterpolationTimes, FiltersBehindThatWereDeleted)
{
  for (const bool isAnotherThere : { false, true })
  {
    vtkNew<Moving> moving;
    WatchedInterpolation filter;
    filter->SetInputConnection(moving->GetOutputPort());
    filter->SetRasterSizeToByCellSize();
    filter->SetCellSize(0.1, 0.1);
    {
      vtkNew<Behind> behind;
      vtkNew<Tombstone> executive;
      behind->SetExecutive(executive);
      behind->SetInputConnection(filter->GetOutputPort());
      behind->UpdateTimeStep(2.0);
      behind->Update();
      EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 900);
    }
    vtkNew<Behind> another;
    if (isAnotherThere)
    {
      another->SetInputConnection(filter->GetOutputPort());
      another->Update();
    }
    for (const double time : { 1.0, 0.0 })
    {
      filter->UpdateTimeStep(time);
      const vtkIdType own = time == 1.0 ? 400 : 100, before = time == 1.0 ? 900 : 400;
      EXPECT_EQ(filter->GetNumberOfPlaces(), isAnotherThere ? before : own); // as announced
      filter->Update();
      EXPECT_EQ(filter->GetNumberOfPlaces(), own);
    }
    filter->SetHeightArrayName("vtkValidPointMask"); // an error
    filter->Update();
    EXPECT_EQ(filter.Said->Errors.size(), 1u);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

} // namespace
