// SPDX-License-Identifier: BSD-3-Clause
//
// A triangulation is lent to one borrower at a time, on any thread.
#include "ContextSupport.h"
#include "Execution/vtkAHDLentTriangulation.h"
#include "FilterTestSupport.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace
{

using namespace ahdtest;
using Lent = vtkAHDLentTriangulation;

/// Lets so many threads go on at the same moment, again and again.
class Barrier
{
public:
  explicit Barrier(int threads)
    : Threads(threads)
  {
  }

  void Wait()
  {
    const int round = this->Round;
    if (++this->Waiting == this->Threads)
    {
      this->Waiting = 0;
      ++this->Round;
    }
    while (this->Round == round)
    {
      std::this_thread::yield();
    }
  }

private:
  const int Threads;
  std::atomic<int> Waiting{ 0 };
  std::atomic<int> Round{ 0 };
};

/// A surface of one triangle, and a triangulation kept for it.
struct Surface
{
  Surface()
  {
    vtkNew<vtkCellArray> triangles;
    triangles->InsertNextCell({ vtkIdType(0), vtkIdType(1), vtkIdType(2) });
    this->Data->SetPolys(triangles);
    auto content = std::make_unique<Lent::Content>();
    EXPECT_TRUE(this->Lender->Keep(content, this->Data, Work(1).Context));
    EXPECT_EQ(content, nullptr);
  }

  vtkSmartPointer<vtkPolyData> Data = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  vtkNew<Lent> Lender;
};

/// All request it at the same moment; the borrower works while the others retry.
TEST(LentTriangulation, IsLentToOneAtATime)
{
  constexpr int kThreads = 2, kRounds = 3000;
  Surface surface;
  Barrier barrier(kThreads);
  std::atomic<int> lent{ 0 }, wrong{ 0 };
  const auto ask = [&]
  {
    const Work work(1);
    for (int round = 0; round < kRounds; ++round)
    {
      vtkSmartPointer<Lent> lender, again;
      barrier.Wait();
      Lent::ContentPointer content = Lent::Borrow(surface.Data, work.Context, lender);
      lent += content ? 1 : 0;
      barrier.Wait();
      wrong += lent == 1 ? 0 : 1;
      wrong += Lent::Borrow(surface.Data, work.Context, again) ? 1 : 0;
      barrier.Wait();
      lent = 0;
      if (content)
      {
        lender->GiveBack(std::move(content));
      }
    }
  };
  std::vector<std::thread> threads;
  for (int k = 0; k < kThreads; ++k)
  {
    threads.emplace_back(ask);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, 0);
}

TEST(LentTriangulation, IsGoneWhenItIsClosed)
{
  Surface surface;
  const Work work(1);
  vtkSmartPointer<Lent> lender, none;
  Lent::ContentPointer content = Lent::Borrow(surface.Data, work.Context, lender);
  ASSERT_NE(content, nullptr);
  EXPECT_EQ(lender, surface.Lender.Get());
  EXPECT_EQ(surface.Lender->Close(), nullptr) << "it is lent";
  lender->GiveBack(std::move(content));
  EXPECT_EQ(Lent::Borrow(surface.Data, work.Context, none), nullptr);
}

/// Nothing is interpolated on a triangulation whose points, marks or corners were written to, until
/// they are what they were.
TEST(LentTriangulation, IsLentAgainOnceAChangeIsUndone)
{
  auto cloud = makeCloud(scatteredPoints(50));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(50);
  marks->FillValue(0);
  cloud->GetPointData()->AddArray(marks);
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(cloud);
  filter->Update();
  vtkPolyData* const surface = filter->GetOutput();
  const auto isLent = [surface]
  {
    vtkSmartPointer<Lent> lender;
    Lent::ContentPointer content = Lent::Borrow(surface, Work(1).Context, lender);
    const bool is = content != nullptr;
    EXPECT_EQ(lender != nullptr, is);
    is ? lender->GiveBack(std::move(content)) : void();
    return is;
  };
  EXPECT_TRUE(isLent());
  vtkDataArray* const corners = surface->GetPolys()->GetConnectivityArray();
  for (vtkDataArray* array :
    { cloud->GetPoints()->GetData(), vtkDataArray::SafeDownCast(marks), corners })
  {
    SCOPED_TRACE(array->GetClassName());
    const double before = array->GetComponent(array->GetNumberOfTuples() - 1, 0);
    array->SetComponent(array->GetNumberOfTuples() - 1, 0, before == 1.0 ? 0.0 : 1.0);
    EXPECT_FALSE(isLent());
    array->SetComponent(array->GetNumberOfTuples() - 1, 0, before);
    EXPECT_TRUE(isLent());
  }
}

/// Lines and vertices left by limits belong to the surface.
TEST(LentTriangulation, HasNoMemoryOfOtherCellsThanTriangles)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(
    makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 4, 0, 0 }, { 4.5, 0, 0 }, { 4, 9, 0 } }));
  filter->SetAlpha(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 1);
  EXPECT_GT(filter->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfVerts(), 0);
  vtkSmartPointer<Lent> lender;
  const Lent::ContentPointer content = Lent::Borrow(filter->GetOutput(), Work(1).Context, lender);
  ASSERT_NE(content, nullptr);
  const ahd::Selection& selection = content->Made.selection;
  EXPECT_EQ(selection.keptCount, 1u);
  EXPECT_EQ(selection.lines.capacity() + selection.vertices.capacity(), 0u);
}

/// The copies that a simplification reads are gone with the execution.
TEST(LentTriangulation, HasNoAddressOfCopiesOfTheInput)
{
  auto cloud = makeCloud(scatteredPoints(200));
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("numbers");
  numbers->SetNumberOfValues(200);
  numbers->FillValue(1.0);
  cloud->GetPointData()->AddArray(numbers);
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(cloud);
  filter->SetMaximumError(1e-3);
  filter->KeptPointsOnlyOff(); // else nothing is lent
  filter->SetValueArrayName("numbers");
  filter->SetWeightArrayName("numbers");
  filter->SetKeepArrayName("numbers");
  filter->Update();
  vtkSmartPointer<Lent> lender;
  const Lent::ContentPointer content = Lent::Borrow(filter->GetOutput(), Work(1).Context, lender);
  ASSERT_NE(content, nullptr);
  const ahd::PointNumbers& kept = content->Made.numbers;
  EXPECT_FALSE(kept.values.isGiven());
  EXPECT_FALSE(kept.weights.isGiven());
  EXPECT_EQ(kept.keep, nullptr);
}

} // namespace
