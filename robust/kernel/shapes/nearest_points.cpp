// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/nearest_points.h"

#include <array>
#include <optional>
#include <utility>

#include "robust/kernel/integers/rounding.h"

namespace touchstone::robust::kernel {
namespace {

using Vector = Vector3<mpz_class>;
using Segment = Segment3<mpz_class>;
using Triangle = Triangle3<mpz_class>;

mpz_class square(const Vector& v) { return dot(v, v); }
QuotientPoint vertex(const IntegerPoint& p) { return {p, 1}; }

/// from + n / d v
QuotientPoint along(const IntegerPoint& from, const mpz_class& n, const mpz_class& d, const Vector& v) {
  const auto coordinate = [&](const mpz_class& start, const mpz_class& step) {
    return mpz_class(d * start + n * step);
  };
  return {{coordinate(from.x, v.x), coordinate(from.y, v.y), coordinate(from.z, v.z)}, d};
}

bool less(const Quotient& p, const Quotient& q) { return p.n * q.d < q.n * p.d; }

/// Keeps the first of the points, or pairs, with the least distance.
struct Nearest {
  QuotientPair pair;
  Quotient square;

  Nearest(QuotientPoint p, QuotientPoint q) : pair{std::move(p), std::move(q)} {
    square = squared_distance(pair.on_a, pair.on_b);
  }
  void try_next(QuotientPoint p, QuotientPoint q) {
    Nearest next(std::move(p), std::move(q));
    if (less(next.square, square)) *this = std::move(next);
  }
};

/// True if x is not beyond the edge, seen along the normal of a triangle to its left.
bool on_inner_side(const Vector& normal, const IntegerPoint& from, const IntegerPoint& to, const IntegerPoint& x) {
  return sgn(dot(cross(normal, to - from), x - from)) >= 0;
}

}  // namespace

Contact contact(const Quotient& square, const mpz_class& reach, bool interiors) {
  const int sign = cmp(square.n, mpz_class(reach * reach * square.d));
  if (sign > 0) return Contact::disjoint;
  return sign < 0 && interiors ? Contact::overlapping : Contact::touching;
}

Quotient squared_distance(const QuotientPoint& p, const QuotientPoint& q) {
  const auto difference = [&](const mpz_class& x, const mpz_class& y) { return mpz_class(x * q.d - y * p.d); };
  const Vector between{difference(p.n.x, q.n.x), difference(p.n.y, q.n.y), difference(p.n.z, q.n.z)};
  const mpz_class d = p.d * q.d;
  return {square(between), d * d};
}

/// The foot of the perpendicular, unless it is before a or beyond b.
QuotientPoint nearest_on_segment(const IntegerPoint& p, const Segment& segment) {
  const auto& [a, b] = segment;
  const Vector v = b - a;
  const mpz_class foot = dot(p - a, v), length = square(v);
  if (sgn(foot) <= 0) return vertex(a);
  if (foot >= length) return vertex(b);
  return along(a, foot, length, v);
}

/// The foot of the perpendicular if it is in the triangle; otherwise the nearest point on an edge. Without area all
/// points are on edges.
QuotientPoint nearest_on_triangle(const IntegerPoint& p, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector normal = cross(b - a, c - a);
  const mpz_class length = square(normal);
  const bool over = sgn(length) != 0 && on_inner_side(normal, a, b, p) && on_inner_side(normal, b, c, p) &&
                    on_inner_side(normal, c, a, p);
  if (over) return along(p, dot(normal, a - p), length, normal);
  Nearest nearest(nearest_on_segment(p, {a, b}), vertex(p));
  nearest.try_next(nearest_on_segment(p, {b, c}), vertex(p));
  nearest.try_next(nearest_on_segment(p, {c, a}), vertex(p));
  return nearest.pair.on_a;
}

/// The nearest point is on a face whose plane p is beyond. The vector from it to p is a sum of outward normals of the
/// faces there, with factors >= 0. Its product with itself is positive, so its product with one of these normals is,
/// and p is beyond that face. Each face is two triangles.
QuotientPoint nearest_in_box(const IntegerPoint& p, const IntegerBox& box) {
  const Vector displacement = p - box.center;
  std::optional<Nearest> nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    const Vector &out = box.half_axes[k], &one = box.half_axes[l], &other = box.half_axes[m],
                 normal = cross(box.directions[l], box.directions[m]);
    const mpz_class along = dot(normal, displacement), reach = dot(normal, out);
    if (abs(along) <= abs(reach)) continue;
    const mpz_class side(sgn(along) * sgn(reach)), back(-1);
    const IntegerPoint middle = box.center + side * out;
    const Vector diagonal = one + other, slant = one - other;
    for (const IntegerPoint& third : {middle + slant, middle + back * slant}) {
      QuotientPoint on_face = nearest_on_triangle(p, {middle + diagonal, third, middle + back * diagonal});
      if (nearest) nearest->try_next(std::move(on_face), vertex(p));
      else nearest.emplace(std::move(on_face), vertex(p));
    }
  }
  return nearest ? nearest->pair.on_a : vertex(p);
}

namespace {

/// They do unless the displacement of their middles leads farther along a direction than half of the edges of both do
/// together; that is then so along a normal of two of the edges, which span the faces of the solid of all such
/// displacements. All is doubled. That of a flat box is so of all less flat ones, and thus of itself.
bool meet(const Segment& segment, const IntegerBox& box) {
  const mpz_class two(2);
  const auto& [u, v, w] = box.half_axes;
  const Vector step = segment.b - segment.a;
  const std::array edges{two * u, two * v, two * w, step};
  const std::array directions{box.directions[0], box.directions[1], box.directions[2], step};
  const Vector way = (segment.a - box.center) + (segment.b - box.center);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector normal = cross(directions[i], directions[j]);
      mpz_class reach;
      for (const Vector& edge : edges) reach += abs(dot(normal, edge));
      if (abs(dot(normal, way)) > reach) return false;
    }
  }
  return true;
}

}  // namespace

/// Where they do not meet, one of the nearest points is an end of the segment, or the other is on an edge of the box:
/// within a face and between the ends both may move along the face until one of that is so.
Quotient squared_distance(const Segment& segment, const IntegerBox& box) {
  if (meet(segment, box)) return {0, 1};
  Nearest nearest(vertex(segment.a), nearest_in_box(segment.a, box));
  nearest.try_next(vertex(segment.b), nearest_in_box(segment.b, box));
  const auto& [u, v, w] = box.half_axes;
  for (const auto& [out, one, other] : {std::array{u, v, w}, std::array{v, w, u}, std::array{w, u, v}}) {
    for (const Vector& across : {one + other, one - other}) {
      for (const int side : {-1, 1}) {
        const IntegerPoint middle = box.center + mpz_class(side) * across;
        QuotientPair pair = nearest_pair(segment, {middle + mpz_class(-1) * out, middle + out});
        nearest.try_next(std::move(pair.on_a), std::move(pair.on_b));
      }
    }
  }
  return nearest.square;
}

namespace {

/// True if the segment passes through the triangle and both ends are outside of its plane.
bool passes(const Segment& segment, const Triangle& triangle) {
  const auto& [p, q] = segment;
  const auto& [a, b, c] = triangle;
  const Vector normal = cross(b - a, c - a), step = q - p;
  if (sgn(dot(normal, p - a)) * sgn(dot(normal, q - a)) >= 0) return false;
  const auto side = [&](const IntegerPoint& from, const IntegerPoint& to) {
    return sgn(dot(step, cross(from - segment.a, to - segment.a)));
  };
  const int of_c = side(a, b), of_a = side(b, c), of_b = side(c, a);
  return (of_c >= 0 && of_a >= 0 && of_b >= 0) || (of_c <= 0 && of_a <= 0 && of_b <= 0);
}

}  // namespace

/// One of the nearest points is an end of the segment, or the other is on an edge of the triangle, as of a box.
Quotient squared_distance(const Segment& segment, const Triangle& triangle) {
  if (passes(segment, triangle)) return {0, 1};
  const auto& [p, q] = segment;
  const auto& [a, b, c] = triangle;
  Nearest nearest(vertex(p), nearest_on_triangle(p, triangle));
  nearest.try_next(vertex(q), nearest_on_triangle(q, triangle));
  for (const Segment& edge : {Segment{a, b}, Segment{b, c}, Segment{c, a}}) {
    QuotientPair pair = nearest_pair(segment, edge);
    nearest.try_next(std::move(pair.on_a), std::move(pair.on_b));
  }
  return nearest.square;
}

/// The feet of the common perpendicular if both are on the segments; otherwise, and if the segments are parallel, one
/// of the points is an end. For parallel segments the candidates are in order of the parameter on a: at 0; where b
/// begins or ends; at 1. The nearer end of b comes first.
QuotientPair nearest_pair(const Segment& a, const Segment& b) {
  const Vector v = a.b - a.a, w = b.b - b.a, between = b.a - a.a, normal = cross(v, w);
  const mpz_class length = square(normal);
  if (sgn(length) != 0) {
    const mpz_class on_a = dot(cross(between, w), normal), on_b = dot(cross(between, v), normal);
    if (sgn(on_a) >= 0 && on_a <= length && sgn(on_b) >= 0 && on_b <= length)
      return {along(a.a, on_a, length, v), along(b.a, on_b, length, w)};
  }
  const bool opposite = sgn(dot(v, w)) < 0;
  const IntegerPoint &first = opposite ? b.b : b.a, &last = opposite ? b.a : b.b;
  Nearest nearest(vertex(a.a), nearest_on_segment(a.a, b));
  nearest.try_next(nearest_on_segment(first, a), vertex(first));
  nearest.try_next(nearest_on_segment(last, a), vertex(last));
  nearest.try_next(vertex(a.b), nearest_on_segment(a.b, b));
  return nearest.pair;
}

Point3d rounded(const QuotientPoint& p, int exponent) {
  return {round_quotient(p.n.x, p.d, exponent), round_quotient(p.n.y, p.d, exponent),
          round_quotient(p.n.z, p.d, exponent)};
}

ClosestPoint3<double> closest_point(const IntegerPoint& from, const QuotientPoint& nearest, int exponent) {
  const auto [point, on_b, squared, distance] = closest_pair({nearest, vertex(from)}, exponent);
  return {point, squared, distance};
}

ClosestPair3<double> closest_pair(const QuotientPair& pair, int exponent) {
  const Quotient square = squared_distance(pair.on_a, pair.on_b);
  return {rounded(pair.on_a, exponent), rounded(pair.on_b, exponent), round_quotient(square.n, square.d, 2 * exponent),
          round_square_root(square.n, square.d, 2 * exponent)};
}

}  // namespace touchstone::robust::kernel
