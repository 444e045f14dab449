// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_triangle.h"

#include "geometry/validation.h"
#include "robust/kernel/enclosed/enclosed_crossing.h"
#include "robust/kernel/shapes/ray_part.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/small_hulls.h"

namespace touchstone::robust {
namespace {

using Relation = SegmentTriangleRelation;

void validate_ray_triangle(const Ray3d& ray, const Triangle3d& t) {
  using kernel::valid;
  if (valid(ray.origin) && kernel::valid(ray.direction, rule::direction) && valid(t.a) && valid(t.b) && valid(t.c))
    return;
  validation::validate_all("ray", ray, "triangle", t);
}

}  // namespace

Perhaps<Relation> stages::ray_triangle::decision::lattice(const Ray3d& ray, const Triangle3d& triangle) {
  const auto dimension = kernel::common_dimension_on_lattice(ray, triangle);
  if (!dimension) return std::nullopt;
  return static_cast<Relation>(1 + *dimension);
}

Relation stages::ray_triangle::decision::exact(const Ray3d& ray, const Triangle3d& triangle) {
  return static_cast<Relation>(1 + kernel::common_dimension_in_integers(ray, triangle));
}

Decided<Relation> stages::ray_triangle::decision::past_filter(const Ray3d& ray, const Triangle3d& triangle) {
  return in_turn<decision, validate_ray_triangle, Stage::lattice, Stage::exact>(ray, triangle);
}

/// If the filter says `point`, all three edges are on one side of the ray: it is inside.
Perhaps<RayTriangle<double>> stages::ray_triangle::enclosed(const Ray3d& ray, const Triangle3d& triangle) {
  const auto relation = decision::filter(ray, triangle);
  if (!relation) return std::nullopt;
  if (*relation == Relation::none) return RayTriangle<double>{Relation::none, {}, {}, {}};
  const auto& [origin, direction] = ray;
  if (!kernel::crossable(origin, direction, triangle.a, triangle.b, triangle.c)) return std::nullopt;
  const auto found = kernel::crossing(origin, kernel::loose(direction), triangle);
  if (!found) return std::nullopt;
  return RayTriangle<double>{Relation::point, (*found).t, (*found).point, Location::inside};
}

RayTriangle<double> stages::ray_triangle::exact(const Ray3d& ray, const Triangle3d& triangle) {
  const kernel::RayPart part(ray, triangle);
  RayTriangle<double> answer{part.relation(), {}, {}, {}};
  if (answer.relation == Relation::none) return answer;
  answer.t = part.first_t(), answer.point = part.first_point();
  if (answer.relation == Relation::point) answer.location = part.inside() ? Location::inside : Location::boundary;
  return answer;
}

RayTriangle<double> ray_triangle(const Ray3d& ray, const Triangle3d& triangle) {
  return answer_in_turn<stages::ray_triangle, Stage::enclosed, validate_ray_triangle, Stage::exact>(ray, triangle);
}

}  // namespace touchstone::robust
