// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/enclosed/enclosed_nearest.h"

#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/window.h"

namespace touchstone::robust {
namespace {

using filters::Part;
using filters::Parts;

/// Calls with_n_and_d(n, d) for the square n / d of the distance of two parts: of corners; of a corner and a line; of
/// lines, or a corner and a plane, along their normal.
template <class Between, class Number, class Use>
auto with_square(const Parts& parts, const Between& between, const Number& one, const Use& with_n_and_d) {
  const auto& [a, b] = parts;
  const auto r = between(b.at[0], a.at[0]);
  const int corners = a.corners + b.corners;
  if (corners == 2) return with_n_and_d(dot(r, r), one);
  const Part& first = a.corners == 1 ? b : a;
  const auto v = between(first.at[0], first.at[1]);
  if (corners == 3) {
    const auto x = cross(v, r);
    return with_n_and_d(dot(x, x), dot(v, v));
  }
  const auto w = a.corners == 3 ? between(a.at[0], a.at[2]) : between(b.at[0], b.at[1]);
  const auto normal = cross(v, w);
  const auto height = dot(r, normal);
  return with_n_and_d(height * height, dot(normal, normal));
}

/// The contact of what is nearer than its reach.
Contact of_nearer(bool interiors) { return interiors ? Contact::overlapping : Contact::touching; }

}  // namespace

Perhaps<Contact> filters::contact(const Parts& parts, double radius_of_a, double radius_of_b, bool interiors) {
  if (!parts) return std::nullopt;
  const auto reach = sized_sum(radius_of_a, radius_of_b);
  return with_square(parts, sized_between, Sized<0>{1, 1}, [&](const auto& n, const auto& d) -> Perhaps<Contact> {
    const auto apart = n - reach * reach * d;
    if (apart.positive()) return Contact::disjoint;
    if (!apart.negative()) return std::nullopt;
    return of_nearer(interiors);
  });
}

namespace kernel {
namespace {

using Vector = filters::Triple<Loose>;

std::optional<Loose> quotient(const Loose& n, const Loose& d) {
  if (!d.settled() || d.high == 0) return std::nullopt;
  return n / Divisor(static_cast<const Enclosed<double>&>(d));
}

Point3d positive_zeros(const Point3d& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

/// The point of a part of a that is nearest to a part of b.
std::optional<Point3d> nearest_on(const Part& a, const Part& b) {
  const Point3d &from = a.at[0], &to = a.at[1], &other = b.at[0];
  if (a.corners == 1) return positive_zeros(from);
  const Vector v = loose_between(from, to);
  if (a.corners == 3) {
    const Vector normal = cross(v, loose_between(from, a.at[2]));
    const auto t = quotient(dot(loose_between(other, from), normal), dot(normal, normal));
    if (!t) return std::nullopt;
    return rounded_along(other, *t, normal);
  }
  const Vector r = loose_between(from, other);
  if (b.corners == 1) {
    const auto t = quotient(dot(r, v), dot(v, v));
    if (!t) return std::nullopt;
    return rounded_along(from, *t, v);
  }
  const Vector w = loose_between(other, b.at[1]), normal = cross(v, w);
  const auto t = quotient(dot(cross(r, w), normal), dot(normal, normal));
  if (!t) return std::nullopt;
  return rounded_along(from, *t, v);
}

bool zero(const Enclosed<double>& x) { return x.high == 0 && x.low == 0 && x.error == 0; }

}  // namespace

Perhaps<Contact> close_contact(const Parts& parts, double radius_of_a, double radius_of_b, bool interiors) {
  if (!parts || !rounds_to_nearest()) return std::nullopt;
  const Loose reach = Loose(radius_of_a) + Loose(radius_of_b);
  return with_square(parts, loose_between, Loose(1), [&](const Loose& n, const Loose& d) -> Perhaps<Contact> {
    const Loose apart = ordered(n - reach * reach * d);
    if (!certain(apart)) return std::nullopt;
    return apart.high > 0 ? Contact::disjoint : of_nearer(interiors);
  });
}

Perhaps<ClosestPair3<double>> closest_pair(const Parts& parts) {
  if (!parts || !rounds_to_nearest()) return std::nullopt;
  const auto square = with_square(parts, loose_between, Loose(1), quotient);
  if (!square || !(square->settled() && square->high >= 0)) return std::nullopt;
  const auto on_a = nearest_on(parts.of_a, parts.of_b), on_b = nearest_on(parts.of_b, parts.of_a);
  if (!on_a || !on_b) return std::nullopt;
  if (zero(*square)) return ClosestPair3<double>{*on_a, *on_b, 0, 0};
  const auto squared = rounded(*square), distance = rounded(square_root(*square));
  if (!squared || !distance) return std::nullopt;
  return ClosestPair3<double>{*on_a, *on_b, *squared, *distance};
}

Perhaps<ClosestPoint3<double>> closest_point(const Parts& parts) {
  const auto pair = closest_pair(parts);
  if (!pair) return std::nullopt;
  return ClosestPoint3<double>{(*pair).on_a, (*pair).squared_distance, (*pair).distance};
}

}  // namespace kernel
}  // namespace touchstone::robust
