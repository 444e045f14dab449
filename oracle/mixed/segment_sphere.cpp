// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/segment_sphere.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/passage.h"

namespace touchstone::oracle {
namespace {

template <class Segment, class Ball>
Truth<Passage<Surd>> truth_segment_sphere(const Segment& segment, const Ball& sphere) {
  validation::validate_all("segment", segment, "sphere", sphere);
  return passage_of_ball(line_of(segment), coordinates(sphere.center), exact(sphere.radius));
}

}  // namespace

template <Exact Number>
Truth<Passage<Surd>> segment_sphere(const Segment2<Number>& segment, const Circle2<Number>& sphere) {
  return truth_segment_sphere(segment, sphere);
}
template <Exact Number>
Truth<Passage<Surd>> segment_sphere(const Segment3<Number>& segment, const Sphere3<Number>& sphere) {
  return truth_segment_sphere(segment, sphere);
}
template Truth<Passage<Surd>> segment_sphere(const Segment2d&, const Circle2d&);
template Truth<Passage<Surd>> segment_sphere(const Segment3d&, const Sphere3d&);
template Truth<Passage<Surd>> segment_sphere(const Segment2<Rational>&, const Circle2<Rational>&);
template Truth<Passage<Surd>> segment_sphere(const Segment3<Rational>&, const Sphere3<Rational>&);

}  // namespace touchstone::oracle
