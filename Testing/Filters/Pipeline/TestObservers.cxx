// SPDX-License-Identifier: BSD-3-Clause
//
// Observers of progress change the filter's data in any way: all that an execution reads is held
// until it ends, so the result is that of the data at its beginning.
#include "ConstraintTestSupport.h"
#include "SampleTestSupport.h"

#include "vtkImageData.h"
#include "vtkThinPlateSplineTransform.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ahdtest;
using Delaunay = vtkAdaptiveHilbertDelaunay2D;
using Interpolation = vtkAdaptiveHilbertInterpolation2D;

/// Acts at the first progress from a given one on that is not the pipeline's.
class Meddler : public vtkCommand
{
public:
  static Meddler* New() { return new Meddler; }

  void Execute(vtkObject*, unsigned long, void* amount) override
  {
    if (this->Do && *static_cast<double*>(amount) >= this->From)
    {
      this->Do();
      this->Do = nullptr;
    }
  }

  std::function<void()> Do;
  double From = 0.01;
};

/// Points with marks, moved by a transform that only the filter holds, and a source.
struct Case
{
  Case()
  {
    std::vector<Xyz> points = scatteredPoints(8000, 3);
    this->Cloud = makeCloud(points);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName("vtkGhostType");
    marks->SetNumberOfValues(8000);
    marks->FillValue(0);
    marks->SetValue(7, 1);
    this->Cloud->GetPointData()->AddArray(marks);
    addArray<vtkDoubleArray>(this->Cloud, "a", [](vtkIdType i) { return double(i % 17); });
    std::vector<std::vector<vtkIdType>> lines;
    for (vtkIdType i = 0; i < 300; ++i)
    {
      lines.push_back({ 11 * i, 11 * i + 5 });
    }
    this->Source = makeSource(lines, {});
    vtkNew<vtkThinPlateSplineTransform> spline;
    vtkNew<vtkPoints> from, to;
    for (const Xyz& p : scatteredPoints(40, 4))
    {
      from->InsertNextPoint(p.data());
      to->InsertNextPoint(p[0] + 0.01 * p[1], p[1], p[2]);
    }
    spline->SetBasisToR();
    spline->SetSourceLandmarks(from);
    spline->SetTargetLandmarks(to);
    this->Filter->SetTransform(spline);
    this->Filter->SetInputData(this->Cloud);
    this->Filter->SetSourceData(this->Source);
    this->Filter->SetNumberOfThreads(1);
    this->Said->Watch(this->Filter); // of lines that cross
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Watch);
  }

  std::vector<Triangle> Triangles()
  {
    this->Filter->Update();
    return trianglesOf(this->Filter->GetOutput());
  }

  vtkSmartPointer<vtkPolyData> Cloud;
  vtkSmartPointer<vtkPolyData> Source;
  vtkNew<Delaunay> Filter;
  vtkNew<Meddler> Watch;
  vtkNew<Messages> Said;
};

using Act = std::function<void(Case&)>;

/// Acts that leave the memory of arrays alone.
const std::vector<std::pair<const char*, Act>> kActs = {
  { "transform taken", [](Case& c) { c.Filter->SetTransform(nullptr); } },
  { "inputs taken", [](Case& c) { c.Filter->RemoveAllInputs(); } },
  { "input replaced", [](Case& c) { c.Filter->SetInputData(makeCloud(scatteredPoints(9))); } },
  { "input emptied", [](Case& c) { c.Cloud->Initialize(); } },
  { "input let go of",
    [](Case& c)
    {
      c.Filter->RemoveAllInputs();
      c.Cloud = nullptr;
      c.Source = nullptr;
    } },
  { "points replaced", [](Case& c) { c.Cloud->SetPoints(makePoints(scatteredPoints(9))); } },
  { "array replaced",
    [](Case& c) { c.Cloud->GetPoints()->SetData(makePoints(scatteredPoints(9))->GetData()); } },
  { "marks taken", [](Case& c) { c.Cloud->GetPointData()->Initialize(); } },
  { "source emptied", [](Case& c) { c.Source->Initialize(); } },
  { "lines replaced",
    [](Case& c)
    {
      const auto other = makeSource({ { 0, 1 } }, {});
      c.Source->GetLines()->SetData(
        other->GetLines()->GetOffsetsArray(), other->GetLines()->GetConnectivityArray());
    } },
  { "outputs emptied",
    [](Case& c)
    {
      for (int port = 0; port < 3; ++port)
      {
        c.Filter->GetOutput(port)->Initialize();
      }
    } },
};

TEST(Observers, DoWhatTheyLikeToWhatIsTriangulated)
{
  Case undisturbed;
  const std::vector<Triangle> expected = undisturbed.Triangles();
  ASSERT_GT(expected.size(), 12000u);
  for (const auto& act : kActs)
  {
    for (const double from : { 0.01, 0.3, 0.7 })
    {
      SCOPED_TRACE(std::string(act.first) + " from " + std::to_string(from));
      Case disturbed;
      disturbed.Watch->From = from;
      disturbed.Watch->Do = [&] { act.second(disturbed); };
      EXPECT_EQ(disturbed.Triangles(), expected);
      EXPECT_FALSE(disturbed.Watch->Do) << "it was not heard";
      EXPECT_EQ(disturbed.Filter->GetOutput()->GetNumberOfPoints(), 8000);
    }
  }
}

/// Outputs taken from the filter belong to their taker.
TEST(Observers, ReplaceOutputs)
{
  for (const bool interpolates : { false, true })
  {
    vtkNew<Delaunay> triangulation;
    vtkNew<Interpolation> interpolation;
    vtkAlgorithm* const filter = interpolates ? static_cast<vtkAlgorithm*>(interpolation)
                                              : triangulation;
    filter->SetInputDataObject(makeCloud(scatteredPoints(8000, 3)));
    vtkSmartPointer<vtkDataSet> taken;
    vtkNew<Meddler> watch;
    watch->Do = [&]
    {
      taken = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        const auto other = vtkSmartPointer<vtkDataObject>::Take(
          filter->GetOutputDataObject(port)->NewInstance());
        filter->GetExecutive()->SetOutputData(port, other);
      }
    };
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->GetNumberOfPoints(), interpolates ? 65536 : 8000);
  }
}

/// A transform that changes while it is used gives unspecified values, and no other harm.
TEST(Observers, ChangeATransformInPlace)
{
  for (const bool isLinear : { false, true })
  {
    for (const double from : { 0.01, 0.02, 0.05, 0.2 })
    {
      Case disturbed;
      vtkNew<vtkTransform> linear;
      if (isLinear)
      {
        disturbed.Filter->SetTransform(linear);
      }
      disturbed.Watch->From = from;
      disturbed.Watch->Do = [&]
      {
        if (auto* spline = vtkThinPlateSplineTransform::SafeDownCast(
              disturbed.Filter->GetTransform()))
        {
          spline->SetSourceLandmarks(makePoints(scatteredPoints(5, 6)));
          spline->SetTargetLandmarks(makePoints(scatteredPoints(5, 7)));
          spline->Update();
        }
        linear->RotateZ(30);
        linear->Update();
      };
      EXPECT_GT(disturbed.Triangles().size(), 0u);
      EXPECT_FALSE(disturbed.Watch->Do);
    }
  }
}

/// An interpolation with everything, at places of a kind.
struct Interpolated
{
  explicit Interpolated(vtkSmartPointer<vtkDataSet> places)
    : Places(places)
  {
    this->Of.Filter->RemoveAllInputs();
    this->Filter->SetTriangulation(this->Of.Filter);
    this->Filter->SetInputData(this->Of.Cloud);
    this->Filter->SetSourceData(this->Of.Source);
    this->Filter->SetInputDataObject(1, this->Places);
    this->Filter->SetMethodToNaturalNeighbor();
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Watch);
    this->Said->Watch(this->Filter);
  }

  std::vector<double> Values()
  {
    this->Filter->Update();
    auto* output = vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
    std::vector<double> values = numbersOf(output, "Elevation");
    const auto others = numbersOf(output, "a");
    values.insert(values.end(), others.begin(), others.end());
    for (double& value : values)
    {
      value = std::isnan(value) ? -1e9 : value;
    }
    return values;
  }

  Case Of;
  vtkSmartPointer<vtkDataSet> Places;
  vtkNew<Interpolation> Filter;
  vtkNew<Meddler> Watch;
  vtkNew<Messages> Said;
};

vtkSmartPointer<vtkDataSet> placesOf(bool areImage)
{
  if (!areImage)
  {
    return makeCloud(scatteredPoints(3000, 8));
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(60, 50, 1);
  image->SetSpacing(1 / 60.0, 1 / 50.0, 1.0);
  return image;
}

TEST(Observers, DoWhatTheyLikeToWhatIsInterpolated)
{
  const std::vector<std::pair<const char*, std::function<void(Interpolated&)>>> acts = {
    { "triangulation taken",
      [](Interpolated& i)
      {
        i.Filter->SetTriangulation(nullptr);
        i.Of.Filter->SetTransform(nullptr);
      } },
    { "inputs taken",
      [](Interpolated& i)
      {
        i.Filter->RemoveAllInputs();
        i.Of.Cloud = i.Of.Source = nullptr;
        i.Places = nullptr;
      } },
    { "output emptied", [](Interpolated& i) { i.Filter->GetOutputDataObject(0)->Initialize(); } },
    { "places replaced",
      [](Interpolated& i)
      {
        if (auto* cloud = vtkPointSet::SafeDownCast(i.Places))
        {
          cloud->GetPoints()->SetData(makePoints(scatteredPoints(9))->GetData());
        }
      } },
    { "all emptied",
      [](Interpolated& i)
      {
        i.Of.Cloud->Initialize();
        i.Of.Source->Initialize();
        i.Places->Initialize();
      } },
  };
  for (const bool areImage : { false, true })
  {
    Interpolated undisturbed(placesOf(areImage));
    const std::vector<double> expected = undisturbed.Values();
    ASSERT_EQ(expected.size(), 6000u);
    for (const auto& act : acts)
    {
      for (const double from : { 0.01, 0.3, 0.6, 0.9, 0.97 })
      {
        SCOPED_TRACE(std::string(act.first) + " from " + std::to_string(from));
        Interpolated disturbed(placesOf(areImage));
        disturbed.Watch->From = from;
        disturbed.Watch->Do = [&] { act.second(disturbed); };
        EXPECT_EQ(disturbed.Values(), expected);
        EXPECT_FALSE(disturbed.Watch->Do) << "it was not heard";
        EXPECT_EQ(
          vtkDataSet::SafeDownCast(disturbed.Filter->GetOutputDataObject(0))->GetNumberOfPoints(),
          3000);
      }
    }
  }
}

using Change = std::function<void(vtkDataArray*)>;
const std::vector<std::pair<const char*, Change>> kChangesOfMemory = {
  { "grown", [](vtkDataArray* array) { array->Resize(1000000); } },
  { "shrunk", [](vtkDataArray* array) { array->Resize(10); } },
  { "let go of", [](vtkDataArray* array) { array->Initialize(); } },
};

vtkDataArray* placesIn(vtkDataSet* data)
{
  return vtkPointSet::SafeDownCast(data)->GetPoints()->GetData();
}

/// Nothing is read once it is gone: an error, no output, and the next execution is as ever.
TEST(Observers, TakeMemoryOfWhatIsTriangulated)
{
  const std::vector<std::pair<const char*, std::function<vtkDataArray*(Case&)>>> arrays = {
    { "points", [](Case& c) { return placesIn(c.Cloud); } },
    { "marks", [](Case& c) -> vtkDataArray* { return c.Cloud->GetPointGhostArray(); } },
    { "lines", [](Case& c) { return c.Source->GetLines()->GetConnectivityArray(); } },
    { "offsets", [](Case& c) { return c.Source->GetLines()->GetOffsetsArray(); } },
  };
  for (const auto& array : arrays)
  {
    for (const auto& change : kChangesOfMemory)
    {
      for (const double from : { 0.01, 0.3, 0.7 })
      {
        SCOPED_TRACE(std::string(array.first) + change.first + std::to_string(from));
        Case disturbed;
        disturbed.Watch->From = from;
        disturbed.Watch->Do = [&] { change.second(array.second(disturbed)); };
        EXPECT_TRUE(disturbed.Triangles().empty());
        EXPECT_EQ(disturbed.Said->Errors.size(), 1u);
        EXPECT_EQ(disturbed.Filter->GetOutput()->GetNumberOfPoints(), 0);
        disturbed.Filter->SetInputData(makeCloud(scatteredPoints(9)));
        disturbed.Filter->SetSourceData(nullptr);
        EXPECT_FALSE(disturbed.Triangles().empty());
      }
    }
  }
}

TEST(Observers, TakeMemoryOfWhatIsInterpolated)
{
  const std::vector<std::pair<const char*, std::function<vtkDataArray*(Interpolated&)>>> arrays = {
    { "points", [](Interpolated& i) { return placesIn(i.Of.Cloud); } },
    { "values", [](Interpolated& i) { return i.Of.Cloud->GetPointData()->GetArray("a"); } },
    { "places", [](Interpolated& i) { return placesIn(i.Places); } },
  };
  for (const auto& array : arrays)
  {
    for (const auto& change : kChangesOfMemory)
    {
      for (const double from : { 0.01, 0.3, 0.9 })
      {
        SCOPED_TRACE(std::string(array.first) + change.first + std::to_string(from));
        Interpolated disturbed(placesOf(false));
        disturbed.Watch->From = from;
        disturbed.Watch->Do = [&] { change.second(array.second(disturbed)); };
        EXPECT_TRUE(disturbed.Values().empty());
        EXPECT_EQ(disturbed.Said->Errors.size(), 1u);
      }
    }
  }
}

/// Numbers behind a triangulation that is lent, which nobody can be seen to change: all of them are
/// read before anybody is told of progress.
TEST(Observers, OverwriteWhatALentTriangulationIsMadeOf)
{
  std::vector<Xyz> points = scatteredPoints(20000, 3);
  for (Xyz& p : points)
  {
    p[2] = p[0] * p[1];
  }
  const auto heights = [&points](int threads, int method, double from, const Change& change)
  {
    vtkNew<Delaunay> triangulation;
    triangulation->SetInputData(makeCloud(points));
    triangulation->SetNumberOfThreads(threads);
    triangulation->Update();
    vtkNew<Interpolation> filter;
    filter->GetTriangulation()->SetNumberOfThreads(threads);
    filter->SetInputConnection(triangulation->GetOutputPort());
    filter->SetMethod(method);
    filter->SetDimensions(60, 50);
    vtkNew<Meddler> watch;
    watch->From = from;
    watch->Do = [&]
    { change(placesIn(vtkDataSet::SafeDownCast(triangulation->GetInputDataObject(0, 0)))); };
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    EXPECT_FALSE(watch->Do) << "it was not heard";
    EXPECT_EQ(filter->GetNumberOfTriangulations(), 0) << "it is not lent";
    return numbersOf(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)), "Elevation");
  };
  for (const int method : { Interpolation::LINEAR, Interpolation::NATURAL_NEIGHBOR })
  {
    const std::vector<double> expected = heights(1, method, 0.01, [](vtkDataArray*) {});
    ASSERT_EQ(expected.size(), 3000u);
    for (const int threads : { 1, 2 })
    {
      for (const double from : { 0.01, 0.1 })
      {
        SCOPED_TRACE(std::to_string(threads) + " threads, from " + std::to_string(from));
        EXPECT_EQ(heights(threads, method, from, [](vtkDataArray* places) { places->Fill(0.5); }),
          expected);
      }
    }
  }
}

/// Numbers that an observer of the filter that lends it wrote over are not those of the
/// triangulation: it is not lent.
TEST(Observers, OverwriteWhatIsTriangulatedAndLent)
{
  for (const double from : { 0.01, 0.2, 0.4, 0.6, 0.8, 0.99 })
  {
    SCOPED_TRACE(from);
    const auto cloud = makeCloud(scatteredPoints(20000, 3));
    vtkNew<Delaunay> triangulation;
    triangulation->SetInputData(cloud);
    triangulation->SetNumberOfThreads(1);
    vtkNew<Meddler> watch;
    watch->From = from;
    watch->Do = [&]
    {
      const std::vector<Xyz> others = scatteredPoints(20000, 4);
      for (vtkIdType i = 0; i < 20000; ++i)
      {
        placesIn(cloud)->SetTuple(i, others[static_cast<std::size_t>(i)].data());
      }
    };
    triangulation->AddObserver(vtkCommand::ProgressEvent, watch);
    triangulation->Update();
    EXPECT_FALSE(watch->Do) << "it was not heard";
    vtkNew<Interpolation> filter;
    filter->SetInputConnection(triangulation->GetOutputPort());
    filter->SetMethodToNaturalNeighbor();
    filter->SetDimensions(60, 50);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfTriangulations(), 1) << "it is lent";
  }
}

} // namespace
