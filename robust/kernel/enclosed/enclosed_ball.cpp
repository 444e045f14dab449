// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/enclosed/enclosed_ball.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/enclosed/support_guess.h"
#include "robust/kernel/filters/sized.h"

namespace touchstone::robust::kernel {
namespace {

using Number = Enclosed<double>;
using Numbers = Enclosed<Two>;

/// Certainly positive, both if there are two.
bool positive(const Number& x) { return x.settled() && x.high > 0; }
bool positive(const Numbers& x) { return x.settled() && x.high.first() > 0 && x.high.second() > 0; }

Numbers swapped(const Numbers& x) { return {x.high.swapped(), x.low.swapped(), x.error.swapped()}; }

/// The vectors from a point to two points.
using Edges = Vector3<Factor<Two>>;
Edges edges(const Point3d& from, const Point3d& p, const Point3d& q) {
  return {vector_between(Two(from.x), Two(p.x, q.x)), vector_between(Two(from.y), Two(p.y, q.y)),
          vector_between(Two(from.z), Two(p.z, q.z))};
}
Edges swapped(const Edges& v) { return {kernel::swapped(v.x), kernel::swapped(v.y), kernel::swapped(v.z)}; }

Numbers dots(const Edges& v, const Edges& w) {
  Sum sum(product(v.x, w.x));
  sum += product(v.y, w.y), sum += product(v.z, w.z);
  return sum.value();
}
template <class Float>
Vector3<Enclosed<Float>> crosses(const Vector3<Factor<Float>>& v, const Vector3<Factor<Float>>& w) {
  const auto part = [](const Factor<Float>& a, const Factor<Float>& b, const Factor<Float>& c, const Factor<Float>& d) {
    return (Sum(product(a, b)) -= product(c, d)).value();
  };
  return {part(v.y, w.z, v.z, w.y), part(v.z, w.x, v.x, w.z), part(v.x, w.y, v.y, w.x)};
}
template <class Float>
Enclosed<Float> dot_of(const Vector3<Enclosed<Float>>& v, const Vector3<Enclosed<Float>>& w) {
  return times(v.x, w.x) + times(v.y, w.y) + times(v.z, w.z);
}

/// The least double that is not below an enclosed number. That rounds to `nearest`, so it is that one, or the next one
/// if the number is certainly above it.
std::optional<double> rounded_up(const Number& x) {
  const auto nearest = rounded(x);
  const Pair<double> parts = in_order(x);
  if (!nearest || parts.high != *nearest || !(std::fabs(parts.low) > x.error)) return std::nullopt;
  return parts.low > 0 ? std::nextafter(*nearest, INFINITY) : *nearest;
}

using Support = std::span<const Point3d>;

std::optional<Point3d> rounded(const Number& x, const Number& y, const Number& z) {
  const auto xy = rounded(both(x, y));
  const auto last = rounded(z);
  if (!xy || !last) return std::nullopt;
  return Point3d{xy->first(), xy->second(), *last};
}

/// With u and v from a to b and c, the center is a + s u + t v, where s and t are v.v (u.u - u.v) and u.u (v.v - u.v),
/// divided by 2 (u.u v.v - (u.v)^2), which is twice the first and u.v (v.v - u.v); and 1 - s - t has the sign of u.v.
/// The triangle is acute if all are positive.
std::optional<Point3d> center_of_triangle(Support on) {
  const Point3d& a = on[0];
  const Edges uv = edges(a, on[1], on[2]);
  const Numbers squares = dots(uv, uv), mixed = dots(uv, swapped(uv)), rest = squares - mixed;
  if (!positive(mixed) || !positive(rest) || !positive(squares)) return std::nullopt;
  const Numbers shares = swapped(squares) * rest;
  const Number half = first(shares) + second(mixed * rest), whole = half + half;
  if (!positive(whole)) return std::nullopt;
  const Numbers t = shares / Divisor(twice(whole));
  const auto coordinate = [&t](double from, const Factor<Two>& to) {
    const Numbers steps = along(Two(from, 0), t, to);
    return first(steps) + second(steps);
  };
  return rounded(coordinate(a.x, uv.x), coordinate(a.y, uv.y), coordinate(a.z, uv.z));
}

/// With u, v and w from a to the others, d = w . (u x v) and n = u.u (v x w) + v.v (w x u) + w.w (u x v), the center is
/// a + m for m = n / (2 d), and the weights of the others are m . (v x w) / d and so on. It is inside the tetrahedron
/// if these are positive and their sum is below 1.
std::optional<Point3d> center_of_tetrahedron(Support on) {
  const Point3d& a = on[0];
  const Edges uv = edges(a, on[1], on[2]), vw = edges(a, on[2], on[3]), wu = edges(a, on[3], on[1]);
  const auto firsts = [](const Edges& v) { return Vector3<Factor<double>>{first(v.x), first(v.y), first(v.z)}; };
  const Vector3<Numbers> two = crosses(vw, wu);  // v x w, w x u
  const Vector3<Number> last = crosses(firsts(uv), firsts(vw));
  const Numbers of_uv = dots(uv, uv), of_wu = dots(wu, wu);
  const auto exactly = [](double from, double to) -> Number {
    const Pair<double> step = difference(to, from);
    return {step.high, step.low, 0};
  };
  const Point3d& to = on[3];
  const Number d = dot_of({exactly(a.x, to.x), exactly(a.y, to.y), exactly(a.z, to.z)}, last);
  if (!d.settled() || d.high == 0) return std::nullopt;
  const Divisor whole(d + d);
  const auto quotient = [&](const Numbers& x, const Number& y) {
    const Numbers parts = times(of_uv, x);
    return (first(parts) + second(parts) + times(first(of_wu), y)) / whole;
  };
  const Vector3<Number> m{quotient(two.x, last.x), quotient(two.y, last.y), quotient(two.z, last.z)};
  const auto and_all = [](const Numbers& x, const Number& y) { return both(y, first(x) + second(x) + y); };
  const Vector3<Numbers> rest{and_all(two.x, last.x), and_all(two.y, last.y), and_all(two.z, last.z)};
  const Vector3<Numbers> steps{twice(m.x), twice(m.y), twice(m.z)};
  const Numbers shares = dot_of(steps, two), others = dot_of(steps, rest);
  const auto right = [&d](const Number& x) { return positive(d.high < 0 ? -x : x); };
  if (!right(first(shares)) || !right(second(shares)) || !right(first(others)) || !right(d - second(others)))
    return std::nullopt;
  return rounded(Number{a.x, 0, 0} + m.x, Number{a.y, 0, 0} + m.y, Number{a.z, 0, 0} + m.z);
}

/// The center of the smallest ball around these points, if each of them is certainly needed on its boundary.
std::optional<Point3d> certain_center(Support on) {
  const auto middle = [](double p, double q) { return (p + q) / 2 + 0.0; };  // -0 + 0 is +0
  const Point3d &p = on[0], &q = on[1 % on.size()];
  if (on.size() <= 2) return Point3d{middle(p.x, q.x), middle(p.y, q.y), middle(p.z, q.z)};
  return on.size() == 3 ? center_of_triangle(on) : center_of_tetrahedron(on);
}

bool all_moderate(Support points) {
  return std::all_of(points.begin(), points.end(), [](const Point3d& p) { return filters::moderate(p); });
}

}  // namespace

std::optional<double> enclosed_radius(const Point3d& center, Support points) {
  if (!filters::moderate(center) || !all_moderate(points)) return std::nullopt;
  double radius = 0;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const Edges to = edges(center, points[i], points[std::min(i + 1, points.size() - 1)]);
    const Numbers squares = dots(to, to);
    if (!positive(squares)) return std::nullopt;
    const Numbers roots = square_root(squares);
    const auto one = rounded_up(first(roots)), other = rounded_up(second(roots));
    if (!one || !other) return std::nullopt;
    radius = std::max({radius, *one, *other});
  }
  return radius;
}

std::optional<Sphere3d> enclosed_smallest_ball(const std::vector<Point3d>& points) {
  const SupportGuess guess(points);
  const Support on = guess.support();
  if (!all_moderate(on)) return std::nullopt;
  const auto center = certain_center(on);
  if (!center) return std::nullopt;
  const InnerBall inner(*center, std::sqrt(squared_distance(*center, on[0])));
  for (const Point3d& p : points)
    if (!inner.holds(p) && std::find(on.begin(), on.end(), p) == on.end()) return std::nullopt;
  if (on.size() == 1) return Sphere3d{*center, 0};
  const auto radius = enclosed_radius(*center, on);
  if (!radius) return std::nullopt;
  return Sphere3d{*center, *radius};
}

}  // namespace touchstone::robust::kernel
