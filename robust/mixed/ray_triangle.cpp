// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_triangle.h"

#include "geometry/validation.h"
#include "robust/kernel/enclosed/enclosed_crossing.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/triangle_clip.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/small_hulls.h"

namespace touchstone::robust {
namespace {

using kernel::Clipped;
using Relation = SegmentTriangleRelation;
using Vector = Vector3<mpz_class>;

/// The question in integers times 2^exponent, and the part of the ray in the triangle.
struct Question {
  Point3<mpz_class> origin;
  Vector direction;
  Triangle3<mpz_class> triangle;
  int exponent;
  Clipped part;

  Question(const Ray3d& ray, const Triangle3d& t) {
    const auto& [o, v] = ray;
    const auto integers = kernel::integers_of(o.x, o.y, o.z, v.x, v.y, v.z, t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z,
                                              t.c.x, t.c.y, t.c.z);
    const auto& n = integers.at;
    const auto point = [&n](std::size_t i) { return Point3<mpz_class>{n[i], n[i + 1], n[i + 2]}; };
    origin = point(0), direction = {n[3], n[4], n[5]}, triangle = {point(6), point(9), point(12)};
    exponent = integers.exponent;
    part = kernel::clipped({origin, origin + direction}, triangle, 1, Clipped::ray());
  }

  Relation relation() const {
    if (part.empty) return Relation::none;
    return part.first < part.last ? Relation::segment : Relation::point;
  }

  /// Locates the first common point: inside if it is inside of all three edges; without area there is no inside.
  Location location() const {
    const auto& [a, b, c] = triangle;
    const mpz_class &n = part.first.numerator, &d = part.first.denominator;
    const Vector normal = cross(b - a, c - a);
    const auto inside = [&](const Point3<mpz_class>& from, const Point3<mpz_class>& to) {
      const Vector inwards = cross(normal, to - from);
      return d * dot(inwards, origin - from) + n * dot(inwards, direction) > 0;
    };
    return inside(a, b) && inside(b, c) && inside(c, a) ? Location::inside : Location::boundary;
  }

  /// The first common point, rounded.
  Point3d first() const {
    const mpz_class &n = part.first.numerator, &d = part.first.denominator;
    const auto coordinate = [&](const mpz_class& from, const mpz_class& displacement) {
      return kernel::round_quotient(mpz_class(d * from + n * displacement), d, exponent);
    };
    return {coordinate(origin.x, direction.x), coordinate(origin.y, direction.y), coordinate(origin.z, direction.z)};
  }
};

void validate_ray_triangle(const Ray3d& ray, const Triangle3d& t) {
  using kernel::valid;
  if (valid(ray.origin) && kernel::valid(ray.direction, rule::direction) && valid(t.a) && valid(t.b) && valid(t.c))
    return;
  validation::validate_numbers("ray", ray), validation::validate_numbers("triangle", t);
  validation::validate("ray", ray);
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
  if (!(filters::moderate(origin) & filters::moderate(direction) & filters::moderate(triangle))) return std::nullopt;
  const auto found = kernel::crossing(origin, kernel::loose(direction), triangle);
  if (!found) return std::nullopt;
  return RayTriangle<double>{Relation::point, (*found).t, (*found).point, Location::inside};
}

RayTriangle<double> stages::ray_triangle::exact(const Ray3d& ray, const Triangle3d& triangle) {
  const Question q(ray, triangle);
  RayTriangle<double> answer{q.relation(), {}, {}, {}};
  if (answer.relation == Relation::none) return answer;
  answer.t = kernel::round_quotient(q.part.first.numerator, q.part.first.denominator);
  answer.point = q.first();
  if (answer.relation == Relation::point) answer.location = q.location();
  return answer;
}

RayTriangle<double> ray_triangle(const Ray3d& ray, const Triangle3d& triangle) {
  return answer_in_turn<stages::ray_triangle, Stage::enclosed, validate_ray_triangle, Stage::exact>(ray, triangle);
}

}  // namespace touchstone::robust
