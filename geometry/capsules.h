// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"

namespace touchstone {

/// The closed set of points that are no farther than the radius from a segment of space. A segment of length 0 is valid
/// (a ball), and so is radius 0 (the segment, which has no interior); a negative radius is refused.
template <class Real>
struct Capsule3 {
  Segment3<Real> segment;
  Real radius;
  static constexpr auto members = as_record("segment", "radius").of(Meaning::length);
  bool rules(const auto& check) const { return check("radius", rule::radius(radius)); }
};

using Capsule3d = Capsule3<double>;

}  // namespace touchstone
