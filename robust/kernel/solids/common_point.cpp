// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/common_point.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace touchstone::robust::kernel {
namespace {

using RationalPoint = Point3<mpq_class>;
using RationalVector = Vector3<mpq_class>;

RationalVector quotients(const Vector3<mpz_class>& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

/// The corners of the hull, counter-clockwise about the normal; two of a segment, or one. By chains from the first to
/// the last point in lexicographic order and back, which is the order along some direction in the plane.
std::vector<RationalPoint> ring_of(std::vector<IntegerPoint> points, const Vector3<mpz_class>& normal) {
  const auto before = [](const IntegerPoint& p, const IntegerPoint& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<IntegerPoint> ring;
  if (points.size() == 1) ring = points;
  const auto chain = [&](const auto& list) {
    const std::size_t start = ring.size();
    for (const IntegerPoint& p : list) {
      const auto turns_left = [&] {
        const IntegerPoint &q = ring[ring.size() - 2], &r = ring.back();
        return sgn(dot(normal, cross(r - q, p - r))) > 0;
      };
      while (ring.size() >= start + 2 && !turns_left()) ring.pop_back();
      ring.push_back(p);
    }
    ring.pop_back();
  };
  if (ring.empty()) chain(points), std::reverse(points.begin(), points.end()), chain(points);
  std::vector<RationalPoint> found;
  for (const IntegerPoint& p : ring) found.push_back({mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)});
  return found;
}

/// The points with inward . (p - from) >= 0.
struct HalfSpace {
  RationalPoint from;
  RationalVector inward;
  mpq_class height(const RationalPoint& p) const { return dot(inward, p - from); }
};

/// Half spaces at each edge, and for a segment also at its ends.
std::vector<HalfSpace> half_spaces(const std::vector<RationalPoint>& ring, const RationalVector& normal) {
  std::vector<HalfSpace> all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RationalVector displacement = ring[(i + 1) % ring.size()] - ring[i];
    all.push_back({ring[i], cross(normal, displacement)});
    if (ring.size() == 2) all.push_back({ring[i], displacement});
  }
  return all;
}

std::vector<RationalPoint> clipped(const std::vector<RationalPoint>& ring, const HalfSpace& kept) {
  std::vector<RationalPoint> part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RationalPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const mpq_class at_p = kept.height(p), at_q = kept.height(q);
    if (sgn(at_p) >= 0) part.push_back(p);
    if (sgn(at_p) * sgn(at_q) < 0) part.push_back(p + mpq_class(at_p / (at_p - at_q)) * (q - p));
  }
  return part;
}

RationalPoint nearest_on_edge(const RationalPoint& p, const RationalPoint& q, const RationalPoint& to) {
  const RationalVector displacement = q - p;
  const mpq_class along = dot(displacement, to - p), length = dot(displacement, displacement);
  if (sgn(along) <= 0) return p;
  return along >= length ? q : p + mpq_class(along / length) * displacement;
}

QuotientPoint over_one_denominator(const RationalPoint& p) {
  mpz_class d;
  mpz_lcm(d.get_mpz_t(), p.x.get_den_mpz_t(), p.y.get_den_mpz_t());
  mpz_lcm(d.get_mpz_t(), d.get_mpz_t(), p.z.get_den_mpz_t());
  const auto integer = [&d](const mpq_class& x) { return mpz_class(x.get_num() * (d / x.get_den())); };
  return {{integer(p.x), integer(p.y), integer(p.z)}, d};
}

}  // namespace

/// The foot of the perpendicular, if both sets contain it; otherwise the point is on an edge of their intersection.
QuotientPoint nearest_common_point(std::vector<IntegerPoint> a, std::vector<IntegerPoint> b,
                                   const Vector3<mpz_class>& normal, const IntegerPoint& to) {
  const RationalVector n = quotients(normal);
  const RationalPoint target{mpq_class(to.x), mpq_class(to.y), mpq_class(to.z)};
  std::vector<RationalPoint> common = ring_of(std::move(a), normal);
  const std::vector<RationalPoint> other = ring_of(std::move(b), normal);
  if (common.size() == 1) return over_one_denominator(common[0]);
  if (other.size() == 1) return over_one_denominator(other[0]);
  const mpq_class steps(dot(n, common[0] - target) / dot(n, n));
  const RationalPoint foot = target + steps * n;
  const auto holds = [&foot](const HalfSpace& side) { return sgn(side.height(foot)) >= 0; };
  const auto of_a = half_spaces(common, n), of_b = half_spaces(other, n);
  if (std::all_of(of_a.begin(), of_a.end(), holds) && std::all_of(of_b.begin(), of_b.end(), holds))
    return over_one_denominator(foot);
  for (const HalfSpace& side : of_b) common = clipped(common, side);
  std::optional<RationalPoint> nearest;
  const auto square = [&target](const RationalPoint& p) { return dot(p - target, p - target); };
  for (std::size_t i = 0; i < common.size(); ++i) {
    RationalPoint p = nearest_on_edge(common[i], common[(i + 1) % common.size()], target);
    if (!nearest || square(p) < square(*nearest)) nearest = std::move(p);
  }
  return over_one_denominator(nearest.value());
}

}  // namespace touchstone::robust::kernel
