// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/rays.h"
#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds the intersection of a closed segment in space and the thin plane normal . p + offset = 0: `none`; `point`,
/// with its t on the segment, from either side; or `inside`, all of the segment.
///
/// An end on the plane is a `point`; a segment of length 0 is `inside` or `none`. Right for all finite doubles in every
/// floating-point environment, and every number correctly rounded. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does a normal of length 0 ("nonzero normal"). Contract:
/// reference/mixed/segment_plane.h.
LinePlane<double> segment_plane(const Segment3d& segment, const Plane3d& plane);

/// The decision alone, which costs less.
inline LinePlaneRelation segment_plane_relation(const Segment3d& segment, const Plane3d& plane);

namespace stages {

struct segment_plane : Signatures<decltype(robust::segment_plane)> {
  static Partial enclosed;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::segment_plane_relation)> {
    /// Decides if neither end is on the plane: both on one side, or one on each.
    static Perhaps<LinePlaneRelation> filter(const Segment3d& segment, const Plane3d& plane) {
      const filters::Sign at_a = filters::plane(plane, segment.a), at_b = filters::plane(plane, segment.b);
      if (at_a == filters::Sign::unknown || at_b == filters::Sign::unknown) return std::nullopt;
      return at_a == at_b ? LinePlaneRelation::none : LinePlaneRelation::point;
    }
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline LinePlaneRelation segment_plane_relation(const Segment3d& segment, const Plane3d& plane) {
  return stages::segment_plane::decision::ask(segment, plane).answer;
}

}  // namespace touchstone::robust
