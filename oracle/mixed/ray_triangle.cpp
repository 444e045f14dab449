// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_triangle.h"

#include <cstddef>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/solids/ray_part.h"

namespace touchstone::oracle {
namespace {

using Relation = SegmentTriangleRelation;

template <class Number>
struct Solved {
  using Scale = CommonScale<Number, 15>;

  Solved(const Ray3<Number>& r, const Triangle3<Number>& t)
      : scale({r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z, t.a.x, t.a.y, t.a.z,
               t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}),
        part(cut_ray(point(0), point(3) - Point3<Integer>{0, 0, 0}, {point(6), point(9), point(12)}),
             {point(6), point(9), point(12)}) {}

  Point3<Integer> point(std::size_t i) const { return {scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)}; }
  Rational actual(const Rational& length) const { return scale.actual(length, 1); }

  Scale scale;
  RayPart part;
};

template <class Number>
Truth<RayTriangle<Rational>> truth_of_ray_triangle(const Ray3<Number>& ray, const Triangle3<Number>& triangle) {
  validation::validate_all("ray", ray, "triangle", triangle);
  Solved<Number> s(ray, triangle);
  Truth<RayTriangle<Rational>> truth{{Relation::none, {}, {}, {}},
                                     s.scale.actual(s.part.squared_distance_to_touch(), 2)};
  if (s.part.any()) {
    const bool one = s.part.one();
    const Point3<Rational> p = s.part.first_point();
    truth.answer = {one ? Relation::point : Relation::segment,
                    s.part.first_t(),
                    Point3<Rational>{s.actual(p.x), s.actual(p.y), s.actual(p.z)},
                    {}};
    if (one) truth.answer.location = s.part.inside() ? Location::inside : Location::boundary;
  }
  truth.certificate = [s = std::move(s)] {
    return s.part.certificate([&s](const Rational& length) { return s.actual(length); });
  };
  return truth;
}

}  // namespace

template <Exact Number>
Truth<RayTriangle<Rational>> ray_triangle(const Ray3<Number>& ray, const Triangle3<Number>& triangle) {
  return truth_of_ray_triangle(ray, triangle);
}
template Truth<RayTriangle<Rational>> ray_triangle(const Ray3d&, const Triangle3d&);
template Truth<RayTriangle<Rational>> ray_triangle(const Ray3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
