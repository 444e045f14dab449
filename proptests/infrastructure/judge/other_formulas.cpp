// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "catalogue/rows/planes/point_plane.h"
#include "catalogue/rows/response/elastic_collision.h"
#include "catalogue/rows/response/momentum.h"
#include "catalogue/rows/response/reflect_plane.h"
#include "catalogue/rows/response/restitution_collision.h"
#include "catalogue/rows/sweeps/swept_sphere_sphere.h"
#include "catalogue/rows/volumes/closest_point_on_aabb.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"

/// Other sensible formulas than the textbook's are as good: what they are off by is `inexact`, and nobody's defect.
namespace touchstone::proptests::other_formulas_tests {
namespace {

namespace rows = catalogue::rows;

double length(const Vector3d& v) { return std::sqrt(dot(v, v)); }
Vector3d normalised(const Vector3d& v) {
  const double size = length(v);
  return {v.x / size, v.y / size, v.z / size};
}
double fused_dot(const Vector3d& v, const Vector3d& w) { return std::fma(v.x, w.x, std::fma(v.y, w.y, v.z * w.z)); }
Vector3d plus_times(const Vector3d& v, double k, const Vector3d& w) {
  return {std::fma(k, w.x, v.x), std::fma(k, w.y, v.y), std::fma(k, w.z, v.z)};
}
Vector3d as_vector(const Point3d& p) { return {p.x, p.y, p.z}; }
Vector3d in_float(const Vector3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// No number of the formula is laid to its method, and to rounding only where it has no correct digit. Of what it
/// decides nothing is said here. Some number must be off at all, unless the formula cannot round.
template <class Row, class Formula>
void as_good(const Formula& formula, const Asking& asking = {.each = 200}, bool rounds = true) {
  std::uint64_t inexact = 0;
  audited<Row>(formula, asking, [&](const Examination& question, const Judgement& judgement) {
    if (!judgement.number) return;
    const auto [exact, answered] = *judgement.number;
    if (judgement.verdict == Verdict::inexact) ++inexact;
    const bool no_digit = 2 * std::fabs(answered - exact) >= std::fabs(exact) * (1 - 0x1p-20);
    INFO(one_line(question.operation().print_hexadecimal(question.question()))
         << ": " << exact << ", got " << answered);
    if (judgement.verdict == Verdict::algorithm || (judgement.verdict == Verdict::rounding && !no_digit))
      FAIL(Row::metadata.name << ": " << name_of(judgement.verdict));
  });
  CHECK((inexact > 0) == rounds);
}

using Bodies = std::vector<Body<double>>;

Vector3d kahan(const Bodies& bodies) {
  Vector3d sum{0, 0, 0}, rest{0, 0, 0};
  for (const auto& body : bodies) {
    const Vector3d term = body.mass * body.velocity - rest, next = sum + term;
    rest = (next - sum) - term, sum = next;
  }
  return sum;
}
Vector3d backwards(const Bodies& bodies) {
  Vector3d sum{0, 0, 0};
  for (std::size_t i = bodies.size(); i-- > 0;) sum = sum + bodies[i].mass * bodies[i].velocity;
  return sum;
}
Vector3d fused_momentum(const Bodies& bodies) {
  Vector3d sum{0, 0, 0};
  for (const auto& body : bodies) sum = plus_times(sum, body.mass, body.velocity);
  return sum;
}
using Impact = Velocitiesd;
Impact by_impulse(const Massesd& m, const Velocitiesd& v, const Vector3d& normal, double e) {
  const Vector3d n = normalised(normal);
  const double j = -(1 + e) * dot(v.first - v.second, n) / (1 / m.first + 1 / m.second);
  return {v.first + j / m.first * n, v.second - j / m.second * n};
}
Impact by_parts(const Massesd& m, const Velocitiesd& v, const Vector3d& normal, double e) {
  const Vector3d n = normalised(normal);
  const double v1 = dot(v.first, n), v2 = dot(v.second, n), mass = m.first + m.second;
  const double after1 = (m.first * v1 + m.second * v2 + m.second * e * (v2 - v1)) / mass,
               after2 = (m.first * v1 + m.second * v2 + m.first * e * (v1 - v2)) / mass;
  return {v.first + (after1 - v1) * n, v.second + (after2 - v2) * n};
}
Impact by_the_centre(const Massesd& m, const Velocitiesd& v, const Vector3d& n, double e) {
  const Vector3d centre = (m.first / (m.first + m.second)) * v.first + (m.second / (m.first + m.second)) * v.second;
  const Vector3d a = v.first - centre, b = v.second - centre;
  const double ca = fused_dot(a, n) / fused_dot(n, n), cb = fused_dot(b, n) / fused_dot(n, n);
  return {plus_times(v.first, -(1 + e) * ca, n), plus_times(v.second, -(1 + e) * cb, n)};
}

Vector3d twice(const Vector3d& v, const Vector3d& n) { return v - (2 * dot(v, n) / dot(n, n)) * n; }
template <class Real>
Vector3<Real> with_unit_normal(const Vector3<Real>& v, const Vector3<Real>& normal) {
  const Real size = std::sqrt(dot(normal, normal));
  const Vector3<Real> n{normal.x / size, normal.y / size, normal.z / size};
  return v - (2 * dot(v, n)) * n;
}
Vector3d computed_in_float(const Vector3d& v, const Vector3d& n) {
  const auto converted = [](const Vector3d& w) {
    return Vector3<float>{static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
  };
  const Vector3<float> after = with_unit_normal(converted(v), converted(n));
  return {after.x, after.y, after.z};
}
Vector3d fused_twice(const Vector3d& v, const Vector3d& n) {
  return plus_times(v, -2 * (fused_dot(v, n) / fused_dot(n, n)), n);
}
Vector3d by_householder(const Vector3d& v, const Vector3d& n) {
  const double k = 2 / dot(n, n);
  return {(1 - k * n.x * n.x) * v.x - k * n.x * n.y * v.y - k * n.x * n.z * v.z,
          (1 - k * n.y * n.y) * v.y - k * n.y * n.x * v.x - k * n.y * n.z * v.z,
          (1 - k * n.z * n.z) * v.z - k * n.z * n.x * v.x - k * n.z * n.y * v.y};
}

PointPlane<double> at_distance(double d) {
  return {d > 0 ? PlaneSide::front : d < 0 ? PlaneSide::back : PlaneSide::on, d};
}
PointPlane<double> by_unit_normal(const Plane3d& plane, const Point3d& p) {
  return at_distance(dot(normalised(plane.normal), as_vector(p)) + plane.offset / length(plane.normal));
}
PointPlane<double> by_foot(const Plane3d& plane, const Point3d& p) {
  const Vector3d& n = plane.normal;
  const Vector3d foot = (-plane.offset / dot(n, n)) * n;
  return at_distance(dot(n, as_vector(p) - foot) / length(n));
}
PointPlane<double> fused_distance(const Plane3d& plane, const Point3d& p) {
  const Vector3d& n = plane.normal;
  return at_distance(std::fma(n.x, p.x, std::fma(n.y, p.y, std::fma(n.z, p.z, plane.offset))) /
                     std::hypot(n.x, n.y, n.z));
}

FirstContact<double> at_time(double t) {
  if (0 <= t && t <= 1) return {HitRelation::hit, t};
  return {HitRelation::never, std::nullopt};
}
struct Approach {
  Vector3d p, v;
  double r;
};
Approach approach(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb) {
  return {a.center - b.center, va - vb, a.radius + b.radius};
}
FirstContact<double> half_b(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb) {
  const auto [p, v, r] = approach(a, b, va, vb);
  const double square = dot(v, v), half = dot(p, v), d = half * half - square * (dot(p, p) - r * r);
  return d < 0 ? at_time(-1) : at_time((-half - std::sqrt(d)) / square);
}
FirstContact<double> stable_root(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb) {
  const auto [p, v, r] = approach(a, b, va, vb);
  const double square = fused_dot(v, v), half = fused_dot(p, v), c = (length(p) - r) * (length(p) + r);
  const double d = half * half - square * c;
  return d < 0 || half >= 0 ? at_time(-1) : at_time(c / (-half + std::sqrt(d)));
}
FirstContact<double> by_directions(const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb) {
  const auto [p, v, r] = approach(a, b, va, vb);
  const Vector3d direction = normalised(v);
  const double along = -dot(p, direction);
  const Vector3d beside = p + along * direction;
  const double inside = r * r - dot(beside, beside);
  return inside < 0 ? at_time(-1) : at_time((along - std::sqrt(inside)) / length(v));
}

double from_centre(double x, double min, double max) {
  const double centre = (min + max) / 2, half = (max - min) / 2;
  return centre + std::clamp(x - centre, -half, half);
}
double moved_inside(double x, double min, double max) { return x + std::max(min - x, 0.0) - std::max(x - max, 0.0); }
double in_the_middle(double x, double min, double max) { return std::max(min, std::min(x, max)); }
template <double (*clamp)(double, double, double)>
struct Closest {
  std::variant<Point2d, Point3d> operator()(const Point2d& p, const Aabb2d& b) const {
    return Point2d{clamp(p.x, b.min.x, b.max.x), clamp(p.y, b.min.y, b.max.y)};
  }
  std::variant<Point2d, Point3d> operator()(const Point3d& p, const Aabb3d& b) const {
    return Point3d{clamp(p.x, b.min.x, b.max.x), clamp(p.y, b.min.y, b.max.y), clamp(p.z, b.min.z, b.max.z)};
  }
};

}  // namespace

const Asking in_floats{.each = 200, .binary32 = true};

TEST_CASE("other formulas: momentum summed with compensation, backwards, fused, and in double for floats") {
  as_good<rows::momentum>(kahan);
  as_good<rows::momentum>(backwards);
  as_good<rows::momentum>(fused_momentum);
  as_good<rows::momentum>([](const Bodies& bodies) { return in_float(backwards(bodies)); }, in_floats);
}

TEST_CASE(
    "other formulas: a bounce by an impulse and a unit normal, by speeds along the normal, around the centre of mass") {
  for (const auto& bounce : {by_impulse, by_parts, by_the_centre}) {
    const auto elastic = [&](const Massesd& m, const Velocitiesd& v, const Vector3d& n) { return bounce(m, v, n, 1); };
    as_good<rows::restitution_collision>(bounce);
    as_good<rows::elastic_collision>(elastic);
    const auto rounded = [&](const Massesd& m, const Velocitiesd& v, const Vector3d& n) {
      const Impact after = elastic(m, v, n);
      return Impact{in_float(after.first), in_float(after.second)};
    };
    as_good<rows::elastic_collision>(rounded, in_floats);
  }
}

TEST_CASE("other formulas: reflection in one subtraction, with a unit normal, fused, by a matrix, in float") {
  as_good<rows::reflect_plane>(twice);
  as_good<rows::reflect_plane>(with_unit_normal<double>);
  as_good<rows::reflect_plane>(fused_twice);
  as_good<rows::reflect_plane>(by_householder);
  as_good<rows::reflect_plane>(computed_in_float, in_floats);
}

TEST_CASE("other formulas: the distance from a plane with a unit normal, from the plane's foot, fused") {
  as_good<rows::point_plane>(by_unit_normal);
  as_good<rows::point_plane>(by_foot);
  as_good<rows::point_plane>(fused_distance);
}

TEST_CASE("other formulas: the time of contact of two spheres by half of b, by the stable root, by directions") {
  as_good<rows::swept_sphere_sphere>(half_b);
  as_good<rows::swept_sphere_sphere>(stable_root);
  as_good<rows::swept_sphere_sphere>(by_directions);
}

TEST_CASE("other formulas: the nearest point of a box from its centre, moved inside, as the middle of three numbers") {
  as_good<rows::closest_point_on_aabb>(Closest<from_centre>());
  as_good<rows::closest_point_on_aabb>(Closest<moved_inside>());
  as_good<rows::closest_point_on_aabb>(Closest<in_the_middle>(), {.each = 200}, false);
}

}  // namespace touchstone::proptests::other_formulas_tests
