// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Criteria_h
#define ahd_Criteria_h

#include "Refine.h"

namespace ahd
{

/// A vector in units of the mesh's width, so that products neither overflow nor underflow.
struct ScaledVector
{
  double x, y;
};
inline double dot(const ScaledVector& a, const ScaledVector& b)
{
  return a.x * b.x + a.y * b.y;
}
inline double cross(const ScaledVector& a, const ScaledVector& b)
{
  return a.x * b.y - a.y * b.x;
}

/// What is wrong with a triangle.
struct Measured
{
  double shortest; ///< its shortest edge, squared and scaled,
  int apex;        ///< which is opposite to this corner
  bool isThin, isLarge;
};

/// Lengths, angles and sizes, rounded: functions of places in the order in which they are passed.
class Criteria
{
public:
  /// `width`: of the mesh. @pre it is above 0; the request has no fault
  Criteria(const RefineRequest& request, double width);

  ScaledVector vector(const Point& from, const Point& to) const
  {
    return { (to.x - from.x) * scale_, (to.y - from.y) * scale_ };
  }
  /// Squared and scaled; the same both ways.
  double length(const Point& a, const Point& b) const
  {
    const ScaledVector v = vector(a, b);
    return dot(v, v);
  }
  /// Are they nearer to each other than 1024 units in the last place?
  bool areClose(const Point& a, const Point& b) const;
  /// Is the edge longer than the request has it? `size`: the longest wished there, 0 for any.
  bool isTooLong(const Point& a, const Point& b, double size) const;
  /// Is p so near to the edge that the edge must be split? The angle at p is obtuse, exactly, and
  /// above 180 degrees less twice the minimum angle. The same both ways.
  bool encroaches(const Point& a, const Point& b, const Point& p) const;
  /// @pre the corners are in lexicographic order; `sizes`, or null: wished there
  Measured measure(const Point corners[3], const double* sizes) const;
  /// The place to insert for a triangle: the circumcentre, or the off-centre of its shortest edge
  /// if that is nearer (Ungor 2004). @pre as in measure()
  Point centre(const Point corners[3], int apex) const;
  /// Is the angle at c between a and b below 60 degrees?
  bool isSharp(const Point& a, const Point& c, const Point& b) const;

private:
  double scale_;
  double sineSquared_;
  double lens_;      ///< the square of the cosine of twice the angle
  double offCentre_; ///< its distance from the middle of the shortest edge, over that edge's length
  double area_;      ///< twice the largest, scaled; infinite for any
  double length_;    ///< the longest; infinite for any
};

} // namespace ahd

#endif
