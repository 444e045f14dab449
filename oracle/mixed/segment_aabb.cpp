// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/segment_aabb.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/passage.h"

namespace touchstone::oracle {
namespace {

template <class Segment, class Box>
Truth<Passage<Rational>> truth_segment_aabb(const Segment& segment, const Box& aabb) {
  validation::validate_all("segment", segment, "aabb", aabb);
  return passage_of_box(line_of(segment), coordinates(aabb.min), coordinates(aabb.max));
}

}  // namespace

template <Exact Number>
Truth<Passage<Rational>> segment_aabb(const Segment2<Number>& segment, const Aabb2<Number>& aabb) {
  return truth_segment_aabb(segment, aabb);
}
template <Exact Number>
Truth<Passage<Rational>> segment_aabb(const Segment3<Number>& segment, const Aabb3<Number>& aabb) {
  return truth_segment_aabb(segment, aabb);
}
template Truth<Passage<Rational>> segment_aabb(const Segment2d&, const Aabb2d&);
template Truth<Passage<Rational>> segment_aabb(const Segment3d&, const Aabb3d&);
template Truth<Passage<Rational>> segment_aabb(const Segment2<Rational>&, const Aabb2<Rational>&);
template Truth<Passage<Rational>> segment_aabb(const Segment3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
