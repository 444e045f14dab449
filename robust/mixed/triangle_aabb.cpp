// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/triangle_aabb.h"

#include <algorithm>
#include <array>

#include "geometry/validation.h"
#include "robust/kernel/filters/face_filter.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/separating_axes.h"

namespace touchstone::robust {
namespace {

/// Compares doubles as bits: no subnormal is read as 0.
constexpr auto less = [](double x, double y) { return kernel::ordered_bits(x) < kernel::ordered_bits(y); };

/// The projection along one axis of space: a triangle and a rectangle of the plane.
struct Shadow {
  std::array<Point2d, 3> corners;
  Aabb2d box;

  /// The corner of the rectangle that lies farthest to the left of p -> q.
  Point2d leftmost(const Point2d& p, const Point2d& q) const {
    return {less(p.y, q.y) ? box.min.x : box.max.x, less(p.x, q.x) ? box.max.y : box.min.y};
  }
};

/// The projections along x, y and z, oriented so that the triangle turns left in one if the coordinate of its normal is
/// positive.
std::array<Shadow, 3> shadows(const Triangle3d& t, const Aabb3d& box) {
  const auto& [a, b, c] = t;
  const auto& [min, max] = box;
  return {{{{{{a.y, a.z}, {b.y, b.z}, {c.y, c.z}}}, {{min.y, min.z}, {max.y, max.z}}},
           {{{{a.z, a.x}, {b.z, b.x}, {c.z, c.x}}}, {{min.z, min.x}, {max.z, max.x}}},
           {{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}}, {{min.x, min.y}, {max.x, max.y}}}}};
}

/// One coordinate of the triangle, and the interval of the box.
struct Interval {
  double least, greatest, min, max;
};
std::array<Interval, 3> intervals(const Triangle3d& t, const Aabb3d& box) {
  const auto of = [](double a, double b, double c, double min, double max) {
    return Interval{std::min({a, b, c}, less), std::max({a, b, c}, less), min, max};
  };
  const auto& [a, b, c] = t;
  const auto& [min, max] = box;
  return {of(a.x, b.x, c.x, min.x, max.x), of(a.y, b.y, c.y, min.y, max.y), of(a.z, b.z, c.z, min.z, max.z)};
}

/// The corner of the box at which a normal whose coordinates have these signs is highest; if one is 0 either end will
/// do.
Point3d highest(const Aabb3d& box, int x, int y, int z) {
  return {x > 0 ? box.max.x : box.min.x, y > 0 ? box.max.y : box.min.y, z > 0 ? box.max.z : box.min.z};
}

bool inside(const Aabb3d& box, const Point3d& p) {
  const auto& [min, max] = box;
  return less(min.x, p.x) && less(p.x, max.x) && less(min.y, p.y) && less(p.y, max.y) && less(min.z, p.z) &&
         less(p.z, max.z);
}

}  // namespace

/// All signs are those of proved filters. The coordinates of the normal must be certain: they determine the side of an
/// edge on which the triangle lies, and the extreme corners of the box. If they are certain, none of the contract's 13
/// axes is zero, and each is tested on the only side on which it can separate them; the plane on both.
Perhaps<Contact> stages::triangle_aabb::filter(const Triangle3d& t, const Aabb3d& box) {
  using filters::Sign;
  bool overlap = true;
  for (const auto& [least, greatest, min, max] : intervals(t, box)) {
    if (less(greatest, min) || less(max, least)) return Contact::disjoint;
    overlap = overlap && less(min, max) && less(least, max) && less(min, greatest);
  }
  if (inside(box, t.a) || inside(box, t.b) || inside(box, t.c)) return Contact::overlapping;
  std::array<int, 3> normal{};
  bool certain = true;
  for (std::size_t k = 0; const Shadow& seen : shadows(t, box)) {
    const auto& [a, b, c] = seen.corners;
    const Sign turn = filters::orientation(a, b, c);
    normal[k++] = static_cast<int>(turn) - static_cast<int>(Sign::unknown);
    if (turn == Sign::unknown) {
      certain = false;
      continue;
    }
    const auto &second = turn == Sign::positive ? b : c, &third = turn == Sign::positive ? c : b;
    for (const Segment2d& edge : {Segment2d{a, second}, {second, third}, {third, a}}) {
      const Sign side = filters::orientation(edge.a, edge.b, seen.leftmost(edge.a, edge.b));
      if (side == Sign::negative) return Contact::disjoint;
      overlap = overlap && side == Sign::positive;
    }
  }
  if (!certain) return std::nullopt;
  const auto [x, y, z] = normal;
  const filters::FacePlane<double> plane(t.a, t.b, t.c);
  const Sign high = plane.side(highest(box, x, y, z)), low = plane.side(highest(box, -x, -y, -z));
  if (high == Sign::negative || low == Sign::positive) return Contact::disjoint;
  if (!overlap || high == Sign::unknown || low == Sign::unknown) return std::nullopt;
  return Contact::overlapping;
}

namespace {

/// Everything is doubled, so that the center is an integer. A flat box has no interior.
template <class Integer>
Contact contact_of_triangle(const std::array<Integer, 15>& n) {
  const auto at = [&n](std::size_t i) { return Point3<Integer>{n[i], n[i + 1], n[i + 2]}; };
  const Point3<Integer> a = at(0), b = at(3), c = at(6), min = at(9), max = at(12);
  const Vector3<Integer> width = max - min;
  const Integer zero(0), one(1);
  const auto seen = [&](const Point3<Integer>& p) { return (p - min) + (p - max); };
  const Contact contact = kernel::contact_with_triangle<Integer>(
      {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}, b - a, c - b, a - c}},
      {{{width.x, zero, zero}, {zero, width.y, zero}, {zero, zero, width.z}}}, {seen(a), seen(b), seen(c)});
  const bool flat = width.x == 0 || width.y == 0 || width.z == 0;
  return contact == Contact::overlapping && flat ? Contact::touching : contact;
}

/// `numbers` takes any count of doubles.
template <class Numbers>
auto numbers_of(const Triangle3d& t, const Aabb3d& box, const Numbers& numbers) {
  const auto& [a, b, c] = t;
  const auto& [min, max] = box;
  return numbers(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, min.x, min.y, min.z, max.x, max.y, max.z);
}

void validate_triangle_aabb(const Triangle3d& triangle, const Aabb3d& aabb) {
  if (kernel::valid(triangle) && kernel::valid(aabb)) return;
  validation::validate_all("triangle", triangle, "aabb", aabb);
}

}  // namespace

Perhaps<Contact> stages::triangle_aabb::lattice(const Triangle3d& triangle, const Aabb3d& aabb) {
  const auto lattice = numbers_of(triangle, aabb, [](auto... n) { return kernel::lattice_of(n...); });
  if (!lattice) return std::nullopt;
  return contact_of_triangle(lattice->at);
}

Contact stages::triangle_aabb::exact(const Triangle3d& triangle, const Aabb3d& aabb) {
  return contact_of_triangle(numbers_of(triangle, aabb, [](auto... n) { return kernel::integers_of(n...); }).at);
}

/// The filter decides by some of the numbers, so all are validated before it.
Decided<Contact> stages::triangle_aabb::ask(const Triangle3d& triangle, const Aabb3d& aabb) {
  return in_turn<triangle_aabb, validate_triangle_aabb, Stage::filter, Stage::lattice, Stage::exact>(triangle, aabb);
}

Contact triangle_aabb(const Triangle3d& triangle, const Aabb3d& aabb) {
  return stages::triangle_aabb::ask(triangle, aabb).answer;
}

}  // namespace touchstone::robust
