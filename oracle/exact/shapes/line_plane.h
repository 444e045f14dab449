// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// The intersection of a line through two points and a plane, in rationals, from the heights over the plane of both
/// points: the point with these weights, of which t is that of the second.
class LinePlaneHeights {
 public:
  LinePlaneHeights(const Point3<Rational>& from, const Point3<Rational>& to, const Plane<Rational>& plane);

  /// The part with t >= 0, and t <= 1 if it ends.
  LinePlane<Rational> common(bool ends) const;
  const Rational& at_start() const { return at_start_; }
  const Rational& at_end() const { return at_end_; }
  /// The squared distance of a point of that height.
  Rational squared_distance(const Rational& height) const { return Rational(height * height / squared_normal_); }
  /// The heights of both points.
  Certificate certificate() const { return {"heights", {{"heights", {at_start_, at_end_}}}}; }

 private:
  Point3<Rational> from_, to_;
  Rational at_start_, at_end_, squared_normal_;
};

}  // namespace touchstone::oracle
