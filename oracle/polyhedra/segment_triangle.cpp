// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/segment_triangle.h"

#include <tuple>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/solids/triangles.h"

namespace touchstone::oracle {
namespace {

using SegmentTriangleRelation = SegmentTriangleRelation;

template <class Number>
using Scale = CommonScale<Number, 15>;

template <class Number>
struct SegmentTriangleSolved {
  SegmentTriangleSolved(const Segment3<Number>& s, const Triangle3<Number>& t)
      : scale(
            {s.a.x, s.a.y, s.a.z, s.b.x, s.b.y, s.b.z, t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}),
        segment{point(0), point(3)},
        triangle{point(6), point(9), point(12)},
        common(segment, triangle) {
    if (segment.a == segment.b && common.any) {  // any t is right
      common.first.t = 0;
      common.last = common.first;
    }
  }

  Point3<Integer> point(std::size_t i) const { return {scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)}; }
  Point3<Rational> actual_at(const Rational& t) const {
    const Point3<Rational> p = point_at(segment, t);
    return {scale.actual(p.x, 1), scale.actual(p.y, 1), scale.actual(p.z, 1)};
  }

  Scale<Number> scale;
  Segment3<Integer> segment;
  Triangle3<Integer> triangle;
  CommonPart common;
};

template <class Number>
Certificate certificate_segment_triangle(const SegmentTriangleSolved<Number>& s) {
  const auto& [first, last] = std::tie(s.common.first, s.common.last);
  const auto normal = [](const WitnessPlane& plane) {
    return std::vector<Rational>{Rational(plane.normal.x), Rational(plane.normal.y), Rational(plane.normal.z)};
  };
  const auto offset = [&s](const WitnessPlane& plane) { return s.scale.actual(plane.offset, 1); };
  if (!s.common.any) {
    const WitnessPlane& plane = s.common.between;
    return {"separating_plane", {{"normal", normal(plane)}, {"offset", {offset(plane)}}}};
  }
  const auto numbers = [&](const WitnessPlane& plane) {
    std::vector<Rational> found = normal(plane);
    found.push_back(offset(plane));
    return found;
  };
  std::vector<Rational> on_segment{first.t}, weights(first.weights.begin(), first.weights.end()), before, after;
  if (first.t != last.t) {
    on_segment.push_back(last.t);
    weights.insert(weights.end(), last.weights.begin(), last.weights.end());
  }
  if (sgn(first.t) > 0) before = numbers(plane_at_first(s.segment, s.triangle, first.t));
  if (last.t < 1 && !(s.segment.a == s.segment.b))
    after = numbers(plane_at_first({s.segment.b, s.segment.a}, s.triangle, Rational(1 - last.t)));
  return {"common_part", {{"on_segment", on_segment}, {"weights", weights}, {"before", before}, {"after", after}}};
}

template <class Number>
Truth<SegmentTriangle<Rational>> truth_of_segment_triangle(const Segment3<Number>& segment,
                                                           const Triangle3<Number>& triangle) {
  validation::validate_numbers("segment", segment), validation::validate_numbers("triangle", triangle);
  SegmentTriangleSolved<Number> s(segment, triangle);
  const auto& [first, last] = std::tie(s.common.first.t, s.common.last.t);
  Truth<SegmentTriangle<Rational>> truth{{SegmentTriangleRelation::none, {}, {}, {}},
                                         s.scale.actual(squared_distance_to_touch(s.segment, s.triangle), 2)};
  if (s.common.any && first == last) truth.answer = {SegmentTriangleRelation::point, first, s.actual_at(first), {}};
  else if (s.common.any)
    truth.answer = {
        SegmentTriangleRelation::segment, {}, {}, Segment3<Rational>{s.actual_at(first), s.actual_at(last)}};
  truth.certificate = [s = std::move(s)] { return certificate_segment_triangle(s); };
  return truth;
}

}  // namespace

template <Exact Number>
Truth<SegmentTriangle<Rational>> segment_triangle(const Segment3<Number>& segment, const Triangle3<Number>& triangle) {
  return truth_of_segment_triangle(segment, triangle);
}
template Truth<SegmentTriangle<Rational>> segment_triangle(const Segment3d&, const Triangle3d&);
template Truth<SegmentTriangle<Rational>> segment_triangle(const Segment3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
