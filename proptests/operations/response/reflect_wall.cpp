// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/reflect_wall.h"

#include "proptests/space_laws.h"

namespace touchstone::proptests::reflect_wall_tests {
namespace {

using Row = rows::reflect_wall;

constexpr std::array<Axis, 3> axes{Axis::x, Axis::y, Axis::z};
using proptests::exact;
Rational exact(const Rational& value) { return value; }

template <class Real>
Rational squared_length(const Vector3<Real>& v) {
  const Rational x = exact(v.x), y = exact(v.y), z = exact(v.z);
  return x * x + y * y + z * z;
}

template <class Real>
Vector3<Real> opposite(const Vector3<Real>& v) {
  return {Real(-v.x), Real(-v.y), Real(-v.z)};
}

std::vector<std::uint64_t> bits(const Vector3d& v) {
  std::vector<std::uint64_t> words;
  append_bits(v, words);
  return words;
}

}  // namespace

LAW("reflect_wall: reflected twice, every velocity is what it was", v, axis) {
  const auto after = ask(std::tuple(ask(asked), axis));
  return exact(after.x) == exact(v.x) && exact(after.y) == exact(v.y) && exact(after.z) == exact(v.z);
}

ROBUST_LAW("reflect_wall: reflected twice, every bit is what it was, of zeros too", v, axis) {
  return bits(ask(Row::Question{ask(asked), axis})) == bits(v);
}

LAW("reflect_wall: walls across two axes may be met in either order; across all three the velocity is turned round", v,
    axis) {
  for (const Axis other : axes)
    if (!equal(ask(std::tuple(ask(asked), other)), ask(std::tuple(ask(std::tuple(v, other)), axis)))) return false;
  const auto x = ask(std::tuple(v, Axis::x));
  const auto xy = ask(std::tuple(x, Axis::y));
  const auto all = ask(std::tuple(xy, Axis::z));
  return exact(all.x) == -exact(v.x) && exact(all.y) == -exact(v.y) && exact(all.z) == -exact(v.z);
}

LAW("reflect_wall: the opposite velocity is reflected to the opposite one", v, axis) {
  return equal(ask(Row::Question{opposite(v), axis}), opposite(ask(asked)));
}

LAW("reflect_wall: speed is kept exactly") { return squared_length(ask(asked)) == squared_length(std::get<0>(asked)); }

LAW("reflect_wall: only the component along the axis changes, by twice its size", v, axis) {
  const auto after = ask(asked);
  const auto change = [axis = axis](Axis along, const Rational& from, const Rational& to) {
    return axis == along ? to + from == 0 : to == from;
  };
  return change(Axis::x, exact(v.x), exact(after.x)) && change(Axis::y, exact(v.y), exact(after.y)) &&
         change(Axis::z, exact(v.z), exact(after.z));
}

LAW("reflect_wall: exchanges of the axes exchange the wall and the answer", v, axis) {
  const auto after = ask(asked);
  for (const AxisMap& map : axis_maps) {
    const auto to = std::find(std::begin(map.from), std::end(map.from), static_cast<int>(axis)) - map.from;
    if (!equal(ask(Row::Question{map(v), axes[static_cast<std::size_t>(to)]}), map(after))) return false;
  }
  return true;
}

TEST_CASE("reflect_wall: p. 67's walls worked by hand") {
  example<Row>({{3, -4, 0.5}, Axis::x}, {-3, -4, Rational(1, 2)});
  example<Row>({{3, -4, 0.5}, Axis::y}, {3, 4, Rational(1, 2)});
  example<Row>({{3, -4, 0.5}, Axis::z}, {3, -4, Rational(-1, 2)});
  example<Row>({{0, 5, 7}, Axis::x}, {0, 5, 7});  // along the wall
  example<Row>({{0, 0, 0}, Axis::y}, {0, 0, 0});
  example<Row>({{0, -9, 0}, Axis::y}, {0, 9, 0});  // straight at it
}

TEST_CASE("reflect_wall: huge, subnormal and negative zero") {
  example<Row>({{greatest, -greatest, tiny}, Axis::x},
               {Rational(-exact(greatest)), Rational(-exact(greatest)), exact(tiny)});
  example<Row>({{greatest, -greatest, tiny}, Axis::z},
               {exact(greatest), Rational(-exact(greatest)), Rational(-exact(tiny))});
  example<Row>({{-0.0, -tiny, 1}, Axis::x}, {0, Rational(-exact(tiny)), 1});
  CHECK(bits(robust::reflect_wall({-0.0, 0.0, -0.0}, Axis::y)) == bits({-0.0, -0.0, -0.0}));
}

CONTRACT("reflect_wall: the formula in double is right everywhere, as in exact arithmetic") {
  const auto& [x, y, z] = truth.answer;
  return exact(answer.x) == x && exact(answer.y) == y && exact(answer.z) == z;
}

TEST_CASE("reflect_wall: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::reflect_wall_tests
