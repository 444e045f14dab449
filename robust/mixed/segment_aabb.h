// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/filters/passage_filter.h"
#include "robust/kernel/solids/box_passage.h"

namespace touchstone::robust {

/// Finds where a closed segment enters and leaves an axis-aligned box, in the plane and in space: `hit` with the first
/// and the last t, 0 at a and 1 at b; or `none`.
///
/// Touching is a hit, grazing along a face too; flat boxes are valid; zeros in the displacement are no special case.
/// first is 0 if a is in the box, last is 1 if b is; a segment of length 0 is a point, both are 0. Right for all finite
/// doubles in every floating-point environment, and both numbers correctly rounded. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so does min > max ("min <= max"). Contract:
/// reference/mixed/segment_aabb.h.
inline Passage<double> segment_aabb(const Segment2d& segment, const Aabb2d& aabb);
inline Passage<double> segment_aabb(const Segment3d& segment, const Aabb3d& aabb);

/// The decision alone, which costs less.
inline PassageRelation segment_aabb_relation(const Segment2d& segment, const Aabb2d& aabb);
inline PassageRelation segment_aabb_relation(const Segment3d& segment, const Aabb3d& aabb);

namespace stages {

/// The filter decides segments that miss: then there is no number to compute.
struct segment_aabb : kernel::BoxPassage {
  static Decided<Passage<double>> ask(const kernel::Line& segment, const kernel::Box& aabb);

  struct decision : Filtered<decision> {
    static Perhaps<PassageRelation> filter(const kernel::Line& segment, const kernel::Box& aabb) {
      return filters::box_relation(segment, aabb);
    }
    static Perhaps<PassageRelation> lattice(const kernel::Line& segment, const kernel::Box& aabb);
    static PassageRelation exact(const kernel::Line& segment, const kernel::Box& aabb);
    static Decided<PassageRelation> past_filter(const kernel::Line& segment, const kernel::Box& aabb);
  };
};

}  // namespace stages

inline Passage<double> segment_aabb(const Segment2d& segment, const Aabb2d& aabb) {
  return stages::segment_aabb::ask(segment, aabb).answer;
}
inline Passage<double> segment_aabb(const Segment3d& segment, const Aabb3d& aabb) {
  return stages::segment_aabb::ask(segment, aabb).answer;
}

inline PassageRelation segment_aabb_relation(const Segment2d& segment, const Aabb2d& aabb) {
  return stages::segment_aabb::decision::ask(segment, aabb).answer;
}
inline PassageRelation segment_aabb_relation(const Segment3d& segment, const Aabb3d& aabb) {
  return stages::segment_aabb::decision::ask(segment, aabb).answer;
}

}  // namespace touchstone::robust
