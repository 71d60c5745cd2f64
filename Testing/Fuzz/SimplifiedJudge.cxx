// SPDX-License-Identifier: BSD-3-Clause
#include "SimplifiedJudge.h"

#include "ExactSigns.h"
#include "FilterJudge.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace ahd
{
namespace fuzz
{
namespace
{

using Wide = long double;
using Filter = vtkAdaptiveHilbertDelaunay2D;

constexpr vtkIdType kMostPoints = 100;
constexpr Wide kThin = 0x1p-6L;      // of the square of the longest side
constexpr Wide kRounding = 0x1p-50L; // of the values, by planes in long double
constexpr Wide kDoubles = 0x1p-30L;  // where the filter measures in double

bool simplifies(Filter* filter)
{
  return filter->GetMaximumError() > 0.0 || filter->GetMaximumNumberOfVertices() > 0;
}

/// An array of one number for each point; null if there is none.
vtkDataArray* numbersOf(vtkPointSet* points, const std::string& name)
{
  vtkDataArray* const array = name.empty() || name == "None"
    ? nullptr
    : points->GetPointData()->GetArray(name.c_str());
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == points->GetNumberOfPoints();
  return fits ? array : nullptr;
}

/// How far a point is from a triangle.
struct Distance
{
  bool isKnown; ///< the triangle is not thin
  Wide error;   ///< not finite if a value is not
  Wide size;    ///< sum of the magnitudes of values
};

class Judgement
{
public:
  Judgement(Filter* filter, vtkPolyData* surface)
    : filter_(filter)
    , surface_(surface)
    , input_(vtkPointSet::SafeDownCast(filter->GetInputDataObject(0, 0)))
  {
  }

  /// Is it a surface that it knows all about?
  bool isToJudge() const
  {
    const bool isInPlane = filter_->GetProjectionPlaneMode() != VTK_BEST_FITTING_PLANE &&
      !filter_->GetTransform();
    return input_ && input_->GetPoints() && isInPlane &&
      input_->GetNumberOfPoints() <= kMostPoints && countOf(surface_, "MergedPoints") == 0 &&
      surface_->GetNumberOfPolys() > 0 && filter_->GetDuplicatePolicy() != Filter::MEAN_Z &&
      (simplifies(filter_) || filter_->GetGenerateErrors());
  }

  std::string fault()
  {
    readPlaces();
    readNumbers();
    std::string fault = readTriangles();
    fault = fault.empty() ? faultOfData() : fault;
    for (vtkIdType id = 0; id < input_->GetNumberOfPoints() && fault.empty(); ++id)
    {
      fault = faultAt(id);
    }
    return fault.empty() ? faultOfLargest() : fault;
  }

private:
  struct Triangle
  {
    std::array<Point, 3> at;
    std::array<double, 3> value; ///< if isOfInput
    bool isOfInput;              ///< all corners are
  };

  void readPlaces()
  {
    std::vector<vtkPointSet*> sets{ input_ };
    auto* const source = vtkPointSet::SafeDownCast(filter_->GetInputDataObject(1, 0));
    if (source && source->GetPoints())
    {
      sets.push_back(source);
    }
    for (vtkPointSet* set : sets)
    {
      for (vtkIdType id = 0; id < set->GetNumberOfPoints(); ++id)
      {
        ++pointsAt_[placeOf(set->GetPoint(id))];
      }
    }
    isAllKnown_ = sets.size() == 1;
    // by name: of an array that was renamed VTK's data set does not know
    auto* const marks = vtkUnsignedCharArray::SafeDownCast(
      input_->GetPointData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
    const bool fit = marks && marks->GetNumberOfComponents() == 1 &&
      marks->GetNumberOfTuples() == input_->GetNumberOfPoints() &&
      countOf(surface_, "SkippedPoints") > 0;
    marks_ = fit ? marks : nullptr;
  }

  void readNumbers()
  {
    values_ = numbersOf(input_, filter_->GetValueArrayName());
    weights_ = numbersOf(input_, filter_->GetWeightArrayName());
    keep_ = numbersOf(input_, filter_->GetKeepArrayName());
    vtkPointData* const data = surface_->GetPointData();
    fates_ = filter_->GetGenerateFate() ? idsOf(data, "Fate") : nullptr;
    errors_ = filter_->GetGenerateErrors() ? data->GetArray("Error") : nullptr;
  }

  /// Says if a point of the surface is another one than its id says.
  std::string readTriangles()
  {
    const bool isPart = hasPointsOfCellsOnly(filter_);
    const auto* ids = isPart ? idsOf(surface_->GetPointData(), "OriginalPointIds") : nullptr;
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < surface_->GetNumberOfPolys(); ++cell)
    {
      surface_->GetPolys()->GetCellAtId(cell, corners);
      Triangle triangle;
      triangle.isOfInput = true;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const vtkIdType own = corners->GetId(static_cast<vtkIdType>(k));
        const vtkIdType id = ids ? ids->GetValue(own) : own;
        const std::array<double, 3> place = placeIn(surface_, own);
        const bool isOfInput = id < input_->GetNumberOfPoints();
        if (isOfInput && textOf(place) != textOf(placeIn(input_, id)))
        {
          return "a point at another place than that of its id";
        }
        triangle.at[k] = { place[0], place[1] };
        triangle.isOfInput = triangle.isOfInput && isOfInput;
        triangle.value[k] = isOfInput ? valueAt(id) : 0.0;
        corners_.insert(std::make_pair(place[0], place[1]));
      }
      triangles_.push_back(triangle);
    }
    return "";
  }

  /// Numbers of the input that are others in the surface.
  std::string faultOfData() const
  {
    vtkPointData *const given = input_->GetPointData(), *const made = surface_->GetPointData();
    const auto* ids = hasPointsOfCellsOnly(filter_) ? idsOf(made, "OriginalPointIds") : nullptr;
    for (int k = 0; k < given->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* const array = given->GetArray(k);
      vtkDataArray* const other = array ? made->GetArray(array->GetName()) : nullptr;
      if (!ids || !other || !isOnlyOne(array) || ids == other)
      {
        continue;
      }
      for (vtkIdType i = 0; i < surface_->GetNumberOfPoints(); ++i)
      {
        const vtkIdType id = ids->GetValue(i);
        if (id < input_->GetNumberOfPoints() &&
          textOf({ array->GetComponent(id, 0), 0, 0 }) !=
            textOf({ other->GetComponent(i, 0), 0, 0 }))
        {
          return "data of another point";
        }
      }
    }
    return "";
  }

  /// Has no other array its name, nor one of the filter's own, and has each point a number?
  bool isOnlyOne(vtkDataArray* array) const
  {
    vtkPointData* const data = input_->GetPointData();
    const std::string name = array->GetName() ? array->GetName() : "";
    int count = 0;
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      const char* const other = data->GetAbstractArray(k)->GetName();
      count += other && name == other;
    }
    return count == 1 && (name == "a" || name == "b") &&
      array->GetNumberOfTuples() >= input_->GetNumberOfPoints();
  }

  static std::array<double, 3> placeIn(vtkPointSet* set, vtkIdType id)
  {
    std::array<double, 3> place;
    set->GetPoint(id, place.data());
    return place;
  }

  static std::string textOf(const std::array<double, 3>& place)
  {
    std::string text;
    for (const double number : place)
    {
      text += std::isnan(number) ? "nan " : std::to_string(number) + " ";
    }
    return text + test::hexText({ place[0], place[1] });
  }

  static Point placeOf(const double* xyz) { return { xyz[0], xyz[1] }; }

  struct Less
  {
    bool operator()(const Point& a, const Point& b) const { return lexicographicallyLess(a, b); }
  };

  double valueAt(vtkIdType id) const
  {
    return values_ ? values_->GetComponent(id, 0) : input_->GetPoint(id)[2];
  }

  bool isTaken(vtkIdType id) const
  {
    constexpr int kSkipped = vtkDataSetAttributes::DUPLICATEPOINT |
      vtkDataSetAttributes::HIDDENPOINT;
    const double* const p = input_->GetPoint(id);
    return std::isfinite(p[0]) && std::isfinite(p[1]) &&
      !(marks_ && (marks_->GetValue(id) & kSkipped) != 0);
  }

  std::string faultAt(vtkIdType id)
  {
    const Point p = placeOf(input_->GetPoint(id));
    const double given = errors_ ? errors_->GetComponent(id, 0) : 0.0;
    if (!isTaken(id))
    {
      return errors_ && !std::isnan(given) ? "an error of a point that is not taken" : "";
    }
    if (pointsAt_[p] > 1)
    {
      isAllKnown_ = false;
      return "";
    }
    if (corners_.count({ p.x, p.y }) != 0)
    {
      return errors_ && given != 0.0 ? "an error of a vertex" : "";
    }
    bool isInAny = false;
    std::string fault;
    for (const Triangle& triangle : triangles_)
    {
      if (fault.empty() && contains(triangle, p))
      {
        isInAny = true;
        fault = faultIn(triangle, id);
      }
    }
    return !fault.empty() ? fault : isInAny ? faultOfFate(id) : faultOutside(given);
  }

  static bool contains(const Triangle& t, const Point& p)
  {
    return test::orientSign(t.at[0], t.at[1], p) >= 0 &&
      test::orientSign(t.at[1], t.at[2], p) >= 0 && test::orientSign(t.at[2], t.at[0], p) >= 0;
  }

  /// A point in a triangle that is none of its corners is left out, and may be.
  std::string faultOfFate(vtkIdType id) const
  {
    const double weight = weightAt(id);
    if (!simplifies(filter_))
    {
      return filter_->GetInsertionLimit() > 0 ? "" : "a point in a triangle";
    }
    if ((keep_ && keep_->GetComponent(id, 0) != 0.0) || !std::isfinite(valueAt(id)) ||
      !std::isfinite(weight) || weight < 0.0)
    {
      return "a point less that was to stay";
    }
    return fates_ && fates_->GetValue(id) != -3 ? "a fate of a point left out" : "";
  }

  std::string faultOutside(double given)
  {
    isAllKnown_ = false;
    const bool isHull = filter_->GetRim() != Filter::TRIMMED && !filter_->GetSource() &&
      filter_->GetMaximumEdgeLength() == 0.0 && filter_->GetAlpha() == 0.0 &&
      !filter_->GetBoundingTriangulation();
    return isHull                     ? "a point outside of the triangles"
      : errors_ && !std::isnan(given) ? "an error without a triangle"
                                      : "";
  }

  std::string faultIn(const Triangle& triangle, vtkIdType id)
  {
    const Distance found = distance(triangle, id);
    if (!triangle.isOfInput || !found.isKnown)
    {
      isAllKnown_ = false;
      return "";
    }
    if (!std::isfinite(found.error))
    {
      return faultBesideNone(triangle, id);
    }
    const Wide given = errors_ ? errors_->GetComponent(id, 0) : double(found.error);
    const bool isClose = std::fabs(given - found.error) <= kDoubles * found.size;
    return !isClose && found.size < 1e300L ? "an error that is not the distance"
      : simplifies(filter_)                ? faultOfBound(found, id)
                                           : "";
  }

  /// Of a triangle with a corner without a value: what is inside stays.
  std::string faultBesideNone(const Triangle& triangle, vtkIdType id)
  {
    isAllKnown_ = false;
    const Point p = placeOf(input_->GetPoint(id));
    const bool isInside = test::orientSign(triangle.at[0], triangle.at[1], p) > 0 &&
      test::orientSign(triangle.at[1], triangle.at[2], p) > 0 &&
      test::orientSign(triangle.at[2], triangle.at[0], p) > 0;
    return isInside && simplifies(filter_) && filter_->GetMaximumNumberOfVertices() == 0
      ? "a point less beside one without a value"
      : "";
  }

  std::string faultOfBound(const Distance& found, vtkIdType id)
  {
    const double weight = weightAt(id);
    const bool isBounded = filter_->GetMaximumNumberOfVertices() == 0;
    const double most = filter_->GetMaximumError();
    const double bound = isBounded ? most : std::max(most, filter_->GetLargestError());
    largest_ = std::max(largest_, found.error * weight);
    most_ = std::max(most_, found.size * weight);
    const Wide rounding = (isBounded ? kRounding : kDoubles) * found.size * weight;
    return found.error * weight <= bound + rounding
      ? ""
      : "a point that is farther off than allowed: " + std::to_string(id) + " by " +
        numberText(found.error * weight) + " of " + numberText(bound);
  }

  static std::string numberText(Wide number)
  {
    char text[40];
    std::snprintf(text, sizeof text, "%.17Lg", number);
    return text;
  }

  double weightAt(vtkIdType id) const { return weights_ ? weights_->GetComponent(id, 0) : 1.0; }

  Distance distance(const Triangle& triangle, vtkIdType id) const
  {
    const auto& t = triangle.at;
    const Point p = placeOf(input_->GetPoint(id));
    const Wide bx = Wide(t[1].x) - t[0].x, by = Wide(t[1].y) - t[0].y;
    const Wide cx = Wide(t[2].x) - t[0].x, cy = Wide(t[2].y) - t[0].y;
    const Wide px = Wide(p.x) - t[0].x, py = Wide(p.y) - t[0].y;
    const Wide area = bx * cy - by * cx;
    const std::array<double, 3>& v = triangle.value;
    const Wide value = valueAt(id), a = v[0];
    const Wide ofB = (px * cy - py * cx) / area, ofC = (bx * py - by * px) / area;
    const Wide between = a + ofB * (v[1] - a) + ofC * (v[2] - a);
    const Wide side = std::max({ std::fabs(bx), std::fabs(by), std::fabs(cx), std::fabs(cy) });
    return { area >= kThin * side * side, std::fabs(between - value),
      std::fabs(a) + std::fabs(Wide(v[1])) + std::fabs(Wide(v[2])) + std::fabs(value) };
  }

  /// What LargestError says, of points that are all known.
  std::string faultOfLargest() const
  {
    const double said = filter_->GetLargestError();
    if (filter_->GetMaximumNumberOfVertices() == 0 && said > filter_->GetMaximumError())
    {
      return simplifies(filter_) ? "a largest error above the bound" : "";
    }
    const bool isClose = std::fabs(said - largest_) <= kDoubles * most_;
    return !simplifies(filter_) || !isAllKnown_ || isClose || most_ > 1e300L
      ? ""
      : "a largest error that no point has";
  }

  Filter* const filter_;
  vtkPolyData* const surface_;
  vtkPointSet* const input_;
  std::map<Point, int, Less> pointsAt_;
  std::set<std::pair<double, double>> corners_;
  std::vector<Triangle> triangles_;
  vtkUnsignedCharArray* marks_ = nullptr;
  vtkDataArray *values_ = nullptr, *weights_ = nullptr, *keep_ = nullptr, *errors_ = nullptr;
  const vtkIdTypeArray* fates_ = nullptr;
  bool isAllKnown_ = true; ///< of points that are left out, the distance
  Wide largest_ = 0, most_ = 0;
};

} // namespace

bool hasPointsOfCellsOnly(Filter* filter)
{
  return simplifies(filter) && filter->GetKeptPointsOnly() && !filter->GetGenerateFate() &&
    !filter->GetGenerateErrors();
}

std::string faultOfPointsOfCells(vtkPolyData* surface, vtkIdType count)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  const auto* ids = idsOf(surface->GetPointData(), "OriginalPointIds");
  if (!ids || ids->GetNumberOfValues() != points)
  {
    return "points without their ids";
  }
  for (vtkIdType i = 0; i < points; ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    if (id < (i == 0 ? 0 : ids->GetValue(i - 1) + 1) || id >= count)
    {
      return "an id that is none of a point, or not in order";
    }
  }
  std::vector<bool> hasCell(static_cast<std::size_t>(points), false);
  vtkNew<vtkIdList> corners;
  for (vtkCellArray* cells : { surface->GetVerts(), surface->GetLines(), surface->GetPolys() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      {
        hasCell[static_cast<std::size_t>(corners->GetId(k))] = true;
      }
    }
  }
  const bool isEach = std::find(hasCell.begin(), hasCell.end(), false) == hasCell.end();
  return surface->GetNumberOfCells() == 0 ? points == count ? "" : "points less, and no cells"
    : isEach                              ? ""
                                          : "a point without a cell";
}

std::string faultOfSimplified(Filter* filter, vtkPolyData* surface)
{
  Judgement judgement(filter, surface);
  return judgement.isToJudge() ? judgement.fault() : "";
}

} // namespace fuzz
} // namespace ahd
