// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/box_around.h"

#include <gmp.h>

#include <algorithm>
#include <array>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/shapes/whole_list.h"

namespace touchstone::oracle {
namespace {

using Displacement = Vector3<Integer>;
using Place = Point3<Integer>;

constexpr const char* names[] = {"half_axes[0]", "half_axes[1]", "half_axes[2]"};

/// "2.776e-17", even if a double would be 0.
std::string root_of(const Rational& square) {
  std::array<char, 64> text{};
  const mpf_class root = sqrt(mpf_class(square, 128));
  gmp_snprintf(text.data(), text.size(), "%.4Fg", root.get_mpf_t());
  return text.data();
}

Integer size(const Displacement& v) { return Integer(abs(v.x) + abs(v.y) + abs(v.z)); }

/// Points and box in integers times a unit.
struct IntegerInput {
  std::vector<Place> points;
  Place center;
  std::array<Displacement, 3> half_axes;
  Rational unit;

  IntegerInput(const std::vector<Point3d>& doubles, const Obb3<Rational>& box) {
    std::vector<Rational> numbers;
    const auto add = [&numbers](const auto& p) { numbers.insert(numbers.end(), {exact(p.x), exact(p.y), exact(p.z)}); };
    const auto& [u, v, w] = box.half_axes;
    add(u), add(v), add(w), add(box.center);
    for (const Point3d& p : doubles) add(p);
    const IntegerList list = integer_list(numbers);
    const auto at = [&list](std::size_t i) {
      return Place{list.integers[3 * i], list.integers[3 * i + 1], list.integers[3 * i + 2]};
    };
    const Place origin{0, 0, 0};
    half_axes = {at(0) - origin, at(1) - origin, at(2) - origin};
    center = at(3);
    for (std::size_t i = 4; i < numbers.size() / 3; ++i) points.push_back(at(i));
    unit = list.unit;
  }
  Rational greatest_coordinate() const {
    Integer greatest = 0;
    for (const Place& p : points)
      for (const Integer& x : {p.x, p.y, p.z}) greatest = std::max(greatest, Integer(abs(x)));
    return Rational(greatest * unit);
  }
};

/// The half axes, with those that are 0 replaced by vectors perpendicular to all of them.
std::array<Displacement, 3> completed(std::array<Displacement, 3> axes) {
  static const std::array<Displacement, 3> coordinate_axes{Displacement{1, 0, 0}, Displacement{0, 1, 0},
                                                           Displacement{0, 0, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    Displacement &axis = axes[k], &next = axes[(k + 1) % 3], &last = axes[(k + 2) % 3];
    if (!zero(axis)) continue;
    if (!zero(next) && !zero(last)) {
      axis = cross(next, last);
      continue;
    }
    const Displacement& other = zero(next) ? last : next;  // the nonzero one, if any
    for (const Displacement& e : coordinate_axes)
      if (zero(axis)) axis = zero(other) ? e : cross(other, e);
  }
  return axes;
}

/// A pair of faces: normal . (p - center) is between -reach and `reach`.
struct Faces {
  Displacement normal;
  Integer reach, low, high;
  std::size_t lowest = 0, highest = 0;  ///< indices of points

  Faces(const IntegerInput& all, const Displacement& half_axis, const Displacement& one, const Displacement& other,
        bool flat)
      : normal(cross(one, other)), reach(flat ? Integer(0) : Integer(abs(dot(normal, half_axis)))) {
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      const Integer height = dot(normal, all.points[i] - all.center);
      if (i == 0 || height < low) low = height, lowest = i;
      if (i == 0 || height > high) high = height, highest = i;
    }
  }
  /// The squared length of a height; positive.
  Rational squared_length(const Integer& height, const Rational& unit) const {
    Rational result(Integer(height * height), dot(normal, normal));
    result.canonicalize();
    return Rational(result * unit * unit);
  }
};

/// True if half axes are perpendicular, as far as the contract requires.
bool square(const Displacement& a, const Displacement& b, const Rational& unit) {
  const Integer along = abs(dot(a, b)), sizes = size(a) + size(b);
  const Rational more(along - sizes * Rational(scaled(Rational(1), -1072) / unit));
  return sgn(more) <= 0 || more * more <= Rational(dot(a, a) * dot(b, b)) * scaled(Rational(1), -40);
}

}  // namespace

std::string defect_of_box(const std::vector<Point3d>& points, const Obb3<Rational>& box) {
  const IntegerInput all(points, box);
  const std::array<Displacement, 3> axes = completed(all.half_axes);
  if (sgn(dot(axes[0], cross(axes[1], axes[2]))) == 0) return "the half axes are linearly dependent";
  std::vector<Faces> faces;
  for (std::size_t k = 0; k < 3; ++k)
    faces.emplace_back(all, axes[k], axes[(k + 1) % 3], axes[(k + 2) % 3], zero(all.half_axes[k]));
  Rational farthest = 0;
  std::string outside;
  for (std::size_t k = 0; k < 3; ++k) {
    const Faces& f = faces[k];
    const bool above = f.high > -f.low;
    const Integer beyond((above ? f.high : Integer(-f.low)) - f.reach);
    if (sgn(beyond) <= 0) continue;
    const Rational by = f.squared_length(beyond, all.unit);
    if (by <= farthest) continue;
    farthest = by;
    outside = "points[" + std::to_string(above ? f.highest : f.lowest) + "] is outside, " +
              (sgn(f.reach) == 0 ? "across the half axes that are not 0" : std::string("beyond ") + names[k]) + ", by ";
  }
  if (sgn(farthest) > 0) return outside + root_of(farthest);
  for (std::size_t k = 0; k < 3; ++k)
    if (!square(all.half_axes[k], all.half_axes[(k + 1) % 3], all.unit)) return "the half axes are not at right angles";
  const Rational room(scaled(all.greatest_coordinate(), -43) + scaled(Rational(1), -1070));
  for (std::size_t k = 0; k < 3; ++k) {
    const Faces& f = faces[k];
    const Integer left(f.reach - std::min(f.high, Integer(-f.low)));
    const Rational by = f.squared_length(left, all.unit);
    if (by > room * room)
      return std::string(names[k]) + ": a face is beyond all points by " + root_of(by) + ", allowed are " +
             root_of(Rational(room * room));
  }
  return "";
}

}  // namespace touchstone::oracle
