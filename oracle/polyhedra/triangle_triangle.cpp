// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/triangle_triangle.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/solids/common_dimension.h"
#include "oracle/exact/solids/common_dimension_on_grid.h"
#include "oracle/exact/solids/triangles.h"

namespace touchstone::oracle {
namespace {

using TriangleTriangleRelation = TriangleTriangleRelation;

template <class Number>
struct TriangleTriangleSolved {
  TriangleTriangleSolved(const Triangle3<Number>& s, const Triangle3<Number>& t)
      : scale({s.a.x, s.a.y, s.a.z, s.b.x, s.b.y, s.b.z, s.c.x, s.c.y, s.c.z, t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z,
               t.c.x, t.c.y, t.c.z}),
        a{point(0), point(3), point(6)},
        b{point(9), point(12), point(15)},
        common(a, b) {}

  Point3<Integer> point(std::size_t i) const { return {scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)}; }

  CommonScale<Number, 18> scale;
  Triangle3<Integer> a, b;
  CommonDimension common;
};

template <class Number>
Certificate certificate_triangle_triangle(const TriangleTriangleSolved<Number>& s) {
  std::vector<Rational> planes, on_a, on_b;
  for (const WitnessPlane& plane : s.common.planes) {
    const auto& [x, y, z] = plane.normal;
    planes.insert(planes.end(), {Rational(x), Rational(y), Rational(z), s.scale.actual(plane.offset, 1)});
  }
  if (s.common.dimension >= 0) {
    for (const PointOfBoth& p : points_of_both(s.a, s.b, s.common.dimension)) {
      on_a.insert(on_a.end(), p.on_a.begin(), p.on_a.end());
      on_b.insert(on_b.end(), p.on_b.begin(), p.on_b.end());
    }
  }
  return {"dimension", {{"planes", planes}, {"on_a", on_a}, {"on_b", on_b}}};
}

TriangleTriangleRelation relation_of(int dimension) {
  static constexpr TriangleTriangleRelation relations[]{TriangleTriangleRelation::none, TriangleTriangleRelation::point,
                                                        TriangleTriangleRelation::segment,
                                                        TriangleTriangleRelation::area};
  return relations[dimension + 1];
}

template <class Number>
TriangleTriangleSolved<Number> solved(const Triangle3<Number>& a, const Triangle3<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  return {a, b};
}

template <class Number>
Truth<TriangleTriangleRelation> truth_of_triangle_triangle(const Triangle3<Number>& a, const Triangle3<Number>& b) {
  TriangleTriangleSolved<Number> s = solved(a, b);
  Truth<TriangleTriangleRelation> truth{relation_of(s.common.dimension), Rational(0)};
  if (truth.answer == TriangleTriangleRelation::none || truth.answer == TriangleTriangleRelation::segment) {
    std::vector<Rational> displacements;
    for (const auto& [t, other] : {std::pair{&s.a, &s.b}, std::pair{&s.b, &s.a}})
      for (const auto& edge : {Segment3<Integer>{t->a, t->b}, {t->b, t->c}, {t->c, t->a}})
        displacements.push_back(squared_distance_to_touch(edge, *other));
    truth.margin = s.scale.actual(*std::min_element(displacements.begin(), displacements.end()), 2);
  }
  truth.certificate = [s = std::move(s)] { return certificate_triangle_triangle(s); };
  return truth;
}

}  // namespace

TriangleTriangleRelation triangle_triangle_relation(const Triangle3d& a, const Triangle3d& b) {
  return relation_of(solved(a, b).common.dimension);
}
TriangleTriangleRelation triangle_triangle_relation(const Triangle3<std::int64_t>& a,
                                                    const Triangle3<std::int64_t>& b) {
  return relation_of(common_dimension_on_grid(a, b));
}

template <Exact Number>
Truth<TriangleTriangleRelation> triangle_triangle(const Triangle3<Number>& a, const Triangle3<Number>& b) {
  return truth_of_triangle_triangle(a, b);
}
template Truth<TriangleTriangleRelation> triangle_triangle(const Triangle3d&, const Triangle3d&);
template Truth<TriangleTriangleRelation> triangle_triangle(const Triangle3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
