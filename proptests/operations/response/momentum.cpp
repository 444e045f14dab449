// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/momentum.h"

#include "proptests/body_laws.h"

namespace touchstone::proptests::momentum_tests {

using Row = rows::momentum;

TEST_CASE("momentum: bodies in any order, in other units") {
  law<Row>("any order", in_any_order);
  law<Row>("masses scale", masses_scale);
}

EXACT_LAW("momentum: another observer sees the mass of all times his velocity more; lists add up", bodies) {
  const Motion3 shift{Rational(7, 3), Rational(-11), Rational(13, 5)}, sum = ask(asked);
  ExactBodies twice = bodies;
  twice.insert(twice.end(), bodies.begin(), bodies.end());
  return same(ask(std::tuple(with(bodies, shift))), sum + mass_of(bodies) * shift) &&
         same(ask(std::tuple(twice)), Rational(2) * sum);
}

ROBUST_LAW("momentum: of one body it is IEEE 754's product, and a body and its opposite have none", bodies) {
  for (const auto& [m, v] : bodies) {
    if (!equal(ask(std::tuple(Bodies{{m, v}})), m * v)) return false;
    if (!equal(ask(std::tuple(Bodies{{m, v}, {m, -1.0 * v}})), Vector3d{0, 0, 0})) return false;
  }
  return true;
}

TEST_CASE("momentum: p. 65 worked by hand") {
  example<Row>({{{1, {1, 2, 3}}, {3, {1, 0, 0}}}}, {4, 2, 3});
  example<Row>({{{2, {3, -6, 9}}, {3, {-2, 4, -6}}}}, {0, 0, 0});
  example<Row>({{{0.5, {1, 1, 1}}}}, {Rational(1, 2), Rational(1, 2), Rational(1, 2)});
  example<Row>({{}}, {0, 0, 0});
}

TEST_CASE("momentum: huge, subnormal and negative zero") {
  const Rational most = exact(greatest), least = exact(tiny);
  example<Row>({{{2, {greatest, 0, 0}}, {1, {-greatest, 0, 0}}}}, {most, 0, 0}, "invalid");
  example<Row>({{{2, {greatest, 0, 0}}}}, {Rational(2 * most), 0, 0});  // the nearest double is infinity
  example<Row>({{{0.25, {tiny, 0, 0}}, {0.5, {tiny, 0, 0}}}}, {Rational(3 * least / 4), 0, 0});
  example<Row>({{{1, {1, 0x1p53, 0}}, {1, {tiny, 1, 0}}, {1, {-1, 0, 0}}}}, {least, Rational(exact(0x1p53) + 1), 0});
  CHECK(plus_zero(robust::momentum({{1, {-0.0, 1, 0}}, {2, {-0.0, -0.5, 0}}}).x));
  CHECK(plus_zero(robust::momentum({{1, {-0.0, 1, 0}}, {2, {-0.0, -0.5, 0}}}).y));
}

TEST_CASE("momentum: ties go to the even neighbour") {
  CHECK(robust::momentum({{1, {0x1p53, 0, 0}}, {1, {1, 0, 0}}}).x == 0x1p53);
  CHECK(robust::momentum({{1, {0x1p53, 0, 0}}, {1, {3, 0, 0}}}).x == 0x1p53 + 4);
}

TEST_CASE("momentum: thousands of bodies") {
  const Bodies bodies = thousands_of_bodies();
  const auto truth = oracle::momentum(bodies).answer;
  const auto found = robust::momentum(bodies);
  CHECK((found.x == catalogue::nearest(truth.x) && found.y == catalogue::nearest(truth.y) &&
         found.z == catalogue::nearest(truth.z)));
}

CONTRACT("momentum: the formula in double keeps its contract", bodies) {
  if (!moderate(bodies)) return true;
  Motion3 sizes = none();
  for (const auto& [m, v] : bodies) sizes = sizes + exact(m) * Motion3{size(v.x), size(v.y), size(v.z)};
  const Rational factor = Rational(bodies.size() + 1) * unit();
  return within(answer.x, truth.answer.x, factor * sizes.x) && within(answer.y, truth.answer.y, factor * sizes.y) &&
         within(answer.z, truth.answer.z, factor * sizes.z);
}

TEST_CASE("momentum: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::momentum_tests
