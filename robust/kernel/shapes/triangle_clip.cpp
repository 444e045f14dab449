// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/triangle_clip.h"

#include <algorithm>
#include <utility>

namespace touchstone::robust::kernel {
namespace {

using Point = Point3<mpz_class>;
using Vector = Vector3<mpz_class>;

/// segment / w, w > 0, relative to a point: times w.
struct Seen {
  const Segment3<mpz_class>& segment;
  const mpz_class& w;
  Vector a(const Point& from) const { return seen(segment.a, from); }
  Vector b(const Point& from) const { return seen(segment.b, from); }
  Vector seen(const Point& p, const Point& from) const {
    return {mpz_class(p.x - w * from.x), mpz_class(p.y - w * from.y), mpz_class(p.z - w * from.z)};
  }
};

/// normal . (x - at) >= 0
void keep_above(Clipped& part, const Seen& s, const Vector& normal, const Point& at) {
  part.keep(dot(normal, s.a(at)), dot(normal, s.b(at)));
}

/// Clips within the plane: keeps the inner side of all edges. cross(normal, to - from) points inwards.
void keep_triangle(Clipped& part, const Seen& s, const Triangle3<mpz_class>& t, const Vector& normal) {
  part.keep_zero(dot(normal, s.a(t.a)), dot(normal, s.b(t.a)));
  keep_above(part, s, cross(normal, t.b - t.a), t.a);
  keep_above(part, s, cross(normal, t.c - t.b), t.b);
  keep_above(part, s, cross(normal, t.a - t.c), t.c);
}

/// For collinear corners: keeps the points of that line in the box around the corners. If the corners are one point,
/// the box is that point, and there is no line to test.
void keep_without_area(Clipped& part, const Seen& s, const Triangle3<mpz_class>& t) {
  const Vector along = t.b == t.a ? t.c - t.a : t.b - t.a;
  const Vector from_a = cross(along, s.a(t.a)), from_b = cross(along, s.b(t.a));
  for (mpz_class Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) part.keep_zero(from_a.*axis, from_b.*axis);
  for (mpz_class Point::*axis : {&Point::x, &Point::y, &Point::z}) {
    const auto [least, greatest] = std::minmax({t.a.*axis, t.b.*axis, t.c.*axis});
    const mpz_class low = s.w * least, high = s.w * greatest;
    part.keep(s.segment.a.*axis - low, s.segment.b.*axis - low);
    part.keep(high - s.segment.a.*axis, high - s.segment.b.*axis);
  }
}

/// Adds the ends of the parts of t's edges in the other triangle.
void add_ends(std::vector<HomogeneousPoint>& ends, const Triangle3<mpz_class>& t, const Triangle3<mpz_class>& other) {
  for (const Segment3<mpz_class>& edge : {Segment3<mpz_class>{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
    const Clipped part = clipped(edge, other);
    if (part.empty) continue;
    for (const Clipped::Parameter& end : {part.first, part.last}) {
      const mpz_class &n = end.numerator, &d = end.denominator;
      const mpz_class rest = d - n;
      auto& [at, w] = ends.emplace_back(
          HomogeneousPoint{{mpz_class(rest * edge.a.x + n * edge.b.x), mpz_class(rest * edge.a.y + n * edge.b.y),
                            mpz_class(rest * edge.a.z + n * edge.b.z)},
                           d});
      reduce({&w, &at.x, &at.y, &at.z});
    }
  }
}

}  // namespace

void reduce(std::initializer_list<mpz_class*> numbers) {
  mpz_class common;
  for (const mpz_class* number : numbers) {
    common = gcd(common, *number);
    if (common == 1) return;
  }
  if (sgn(common) == 0) return;
  for (mpz_class* number : numbers) mpz_divexact(number->get_mpz_t(), number->get_mpz_t(), common.get_mpz_t());
}

void Clipped::keep(const mpz_class& at_p, const mpz_class& at_q) {
  const int p = sgn(at_p), q = sgn(at_q);
  if (p >= 0 && q >= 0 && !(endless && at_q < at_p)) return;
  if (p < 0 && q < 0 && !(endless && at_p < at_q)) {
    empty = true;
  } else if (p < 0) {
    first = std::max(first, Parameter{-at_p, at_q - at_p});
  } else {
    last = std::min(last, Parameter{at_p, at_p - at_q});
  }
  empty = empty || last < first;
}

Clipped clipped(const Segment3<mpz_class>& segment, const Triangle3<mpz_class>& triangle, const mpz_class& w,
                Clipped part) {
  const Seen seen{segment, w};
  const Vector normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  if (zero(normal)) keep_without_area(part, seen, triangle);
  else keep_triangle(part, seen, triangle, normal);
  return part;
}

Vector displacement(const HomogeneousPoint& p, const HomogeneousPoint& q) {
  return {mpz_class(q.p.x * p.w - p.p.x * q.w), mpz_class(q.p.y * p.w - p.p.y * q.w),
          mpz_class(q.p.z * p.w - p.p.z * q.w)};
}

std::vector<HomogeneousPoint> ends_of_common_part(const Triangle3<mpz_class>& a, const Triangle3<mpz_class>& b) {
  std::vector<HomogeneousPoint> ends;
  add_ends(ends, a, b), add_ends(ends, b, a);
  return ends;
}

}  // namespace touchstone::robust::kernel
