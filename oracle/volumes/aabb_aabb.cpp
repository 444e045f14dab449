// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/aabb_aabb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"

namespace touchstone::oracle {
namespace {

/// Both boxes, axis by axis: a.min, a.max, b.min, b.max.
template <class Number>
CommonScale<Number, 8> scale_of_aabb_aabb(const Aabb2<Number>& a, const Aabb2<Number>& b) {
  return CommonScale<Number, 8>({a.min.x, a.max.x, b.min.x, b.max.x, a.min.y, a.max.y, b.min.y, b.max.y});
}
template <class Number>
CommonScale<Number, 12> scale_of_aabb_aabb(const Aabb3<Number>& a, const Aabb3<Number>& b) {
  return CommonScale<Number, 12>(
      {a.min.x, a.max.x, b.min.x, b.max.x, a.min.y, a.max.y, b.min.y, b.max.y, a.min.z, a.max.z, b.min.z, b.max.z});
}

/// The conditions on a common point's coordinate on one axis, in units of the scale.
template <class Value>
struct Inequalities {
  Value a_min, a_max, b_min, b_max;

  bool in_order() const { return a_min <= a_max && b_min <= b_max; }
  Value low() const { return std::max(a_min, b_min); }
  Value high() const { return std::min(a_max, b_max); }
  bool hold(const Value& x) const { return a_min <= x && x <= a_max && b_min <= x && x <= b_max; }
  /// Tests the middle between low and high.
  bool hold_strictly() const {
    const Value twice(low() + high());
    return 2 * a_min < twice && twice < 2 * a_max && 2 * b_min < twice && twice < 2 * b_max;
  }
  Value difference() const { return Value(high() - low()); }
};

template <class Value, class Number, std::size_t N>
std::array<Inequalities<Value>, N / 4> axes_of(const CommonScale<Number, N>& n) {
  std::array<Inequalities<Value>, N / 4> axes;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    axes[k] = {integer<Value>(n, 4 * k), integer<Value>(n, 4 * k + 1), integer<Value>(n, 4 * k + 2),
               integer<Value>(n, 4 * k + 3)};
  }
  return axes;
}

template <class Axes>
Contact contact_of(const Axes& axes) {
  if (!std::all_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.hold(axis.low()); }))
    return Contact::disjoint;
  const bool inside = std::all_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.hold_strictly(); });
  return inside ? Contact::overlapping : Contact::touching;
}

/// The axis of the least difference, which decides.
template <class Axes>
std::size_t deciding_aabb_aabb(const Axes& axes) {
  const auto least = std::min_element(axes.begin(), axes.end(), [](const auto& first, const auto& second) {
    return first.difference() < second.difference();
  });
  return static_cast<std::size_t>(least - axes.begin());
}

/// The axes of valid boxes; refuses others. (The validation itself builds the names of fields, which costs more than
/// everything else here.)
template <class Value, class Box, class Scale>
auto validated_aabb_aabb(const Scale& n, const Box& a, const Box& b) {
  const auto validate = [&a, &b] { validation::validate_all("a", a, "b", b); };
  if (!n.finite()) validate();
  const auto axes = axes_of<Value>(n);
  if (!std::all_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.in_order(); })) validate();
  return axes;
}

template <class Scale, class Axes>
Certificate certificate_aabb_aabb(const Scale& n, const Axes& axes, Contact contact, std::size_t least) {
  const auto middle = [&n](const auto& axis) {
    return n.actual(Rational((rational(axis.low()) + rational(axis.high())) / 2), 1);
  };
  const std::pair<std::string, std::vector<Rational>> axis{"axis", {Rational(static_cast<std::uint64_t>(least))}};
  if (contact == Contact::disjoint) return {"separating_axis", {axis, {"value", {middle(axes[least])}}}};
  std::vector<Rational> point;
  for (const auto& each : axes) point.push_back(middle(each));
  if (contact == Contact::overlapping) return {"common_interior_point", {{"point", std::move(point)}}};
  const auto& [a_min, a_max, b_min, b_max] = axes[least];
  const bool supports = a_max == b_min || b_max == a_min;
  return {supports ? "supporting_axis" : "flat_axis", {{"point", std::move(point)}, axis}};
}

template <class Value, class Scale, class Box>
Truth<Contact> truth_aabb_aabb(const Scale& n, const Box& a, const Box& b) {
  auto axes = validated_aabb_aabb<Value>(n, a, b);
  const Contact contact = contact_of(axes);
  const std::size_t least = deciding_aabb_aabb(axes);
  return {contact, n.actual(absolute(axes[least].difference()), 1),
          [n, axes = std::move(axes), contact, least] { return certificate_aabb_aabb(n, axes, contact, least); }};
}

template <class Box>
Truth<Contact> truth_of_aabb_aabb(const Box& a, const Box& b) {
  const auto n = scale_of_aabb_aabb(a, b);
  return n.finite() && n.bits() <= most_bits_in_words ? truth_aabb_aabb<Int128>(n, a, b)
                                                      : truth_aabb_aabb<Integer>(n, a, b);
}

}  // namespace

template <Exact Number>
Truth<Contact> aabb_aabb(const Aabb2<Number>& a, const Aabb2<Number>& b) {
  return truth_of_aabb_aabb(a, b);
}
template <Exact Number>
Truth<Contact> aabb_aabb(const Aabb3<Number>& a, const Aabb3<Number>& b) {
  return truth_of_aabb_aabb(a, b);
}
template Truth<Contact> aabb_aabb(const Aabb2d&, const Aabb2d&);
template Truth<Contact> aabb_aabb(const Aabb3d&, const Aabb3d&);
template Truth<Contact> aabb_aabb(const Aabb2<Rational>&, const Aabb2<Rational>&);
template Truth<Contact> aabb_aabb(const Aabb3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
