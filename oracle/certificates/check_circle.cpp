// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "oracle/certificates/check_circular.h"
#include "oracle/certificates/check_reading.h"
#include "oracle/certificates/check_rounding.h"

namespace touchstone::certify {
namespace {

using Integer = mpz_class;

Integer floor_quotient(const Integer& n, const Integer& d) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  return result;
}

Integer ceiling_quotient(const Integer& n, const Integer& d) {
  Integer result;
  mpz_cdiv_q(result.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  return result;
}

Between negated(const Between& x) { return {Integer(-x.high), Integer(-x.low)}; }

void add(Between& sum, const Between& term, bool minus) {
  sum.low += minus ? Integer(-term.high) : term.low;
  sum.high += minus ? Integer(-term.low) : term.high;
}

/// 1/q - 1/(3 q^3) + 1/(5 q^5) - ...: the remainder is smaller than the first term left out, at most one unit.
Between arc_tangent_of_inverse(std::int64_t q, std::int64_t bits) {
  const Integer one = Integer(1) << static_cast<mp_bitcnt_t>(bits);
  Between power{floor_quotient(one, q), ceiling_quotient(one, q)}, sum{0, 0};
  for (std::int64_t odd = 1;; odd += 2) {
    const Between term{floor_quotient(power.low, odd), ceiling_quotient(power.high, odd)};
    if (term.high <= 1) return {Integer(sum.low - 1), Integer(sum.high + 1)};
    add(sum, term, odd % 4 == 3);
    power = {floor_quotient(power.low, q * q), ceiling_quotient(power.high, q * q)};
  }
}

/// Machin: pi/4 = 4 arctan(1/5) - arctan(1/239).
Between pi(std::int64_t bits) {
  const Between fifth = arc_tangent_of_inverse(5, bits), small = arc_tangent_of_inverse(239, bits);
  return {Integer(16 * fifth.low - 4 * small.high), Integer(16 * fifth.high - 4 * small.low)};
}

/// Taylor's series of the sine (first = x, from = 2) or cosine (first = 1, from = 1) for x in [0, 1]: the terms fall
/// and change sign, so what is left out is smaller than the first term left out, at most one unit.
Between series(const Between& first, const Between& x, std::int64_t from, std::int64_t bits) {
  const Integer unit_squared = Integer(1) << static_cast<mp_bitcnt_t>(2 * bits);
  Between term = first, sum{0, 0};
  bool minus = false;
  for (std::int64_t k = from; term.high > 1; k += 2, minus = !minus) {
    add(sum, term, minus);
    const Integer divisor(unit_squared * (k * (k + 1)));
    term = {floor_quotient(term.low * x.low * x.low, divisor), ceiling_quotient(term.high * x.high * x.high, divisor)};
  }
  return {Integer(sum.low - 1), Integer(sum.high + 1)};
}

/// u - turns pi/2 in units of 2^-bits.
Between rest_of_turn(const Rational& u, const Integer& turns, std::int64_t bits) {
  const std::int64_t fine = bits + static_cast<std::int64_t>(mpz_sizeinbase(turns.get_mpz_t(), 2));
  const Between circle = pi(fine);
  const Rational scale(Integer(1) << static_cast<mp_bitcnt_t>(bits)),
      finer(Integer(2) << static_cast<mp_bitcnt_t>(fine));
  const bool forward = sgn(turns) >= 0;
  const Rational low(scale * (u - turns * (forward ? circle.high : circle.low) / finer));
  const Rational high(scale * (u - turns * (forward ? circle.low : circle.high) / finer));
  return {floor_quotient(low.get_num(), low.get_den()), ceiling_quotient(high.get_num(), high.get_den())};
}

}  // namespace

std::int64_t integer_bits(const Rational& precision) {
  expect(precision.get_den() == 1 && precision >= 1 && precision <= 8192, "certificate: bits is not from 1 to 8192");
  return precision.get_num().get_si();
}

CosineAndSine cosine_and_sine(const Rational& u, const mpz_class& turns, std::int64_t bits) {
  const Between rest = rest_of_turn(u, turns, bits);
  const Integer one = Integer(1) << static_cast<mp_bitcnt_t>(bits);
  const bool negative = sgn(rest.high) <= 0;
  const Between x = negative ? negated(rest) : rest;
  expect(sgn(x.low) >= 0 && x.high <= one, "certificate: quarter_turns or bits do not fit u");
  const Between c = series({one, one}, x, 1, bits), s_of_x = series(x, x, 2, bits);
  const Between s = negative ? negated(s_of_x) : s_of_x;
  const Integer quadrant(turns & 3);
  const bool swapped = quadrant == 1 || quadrant == 3;
  const Between cosine = swapped ? s : c, sine = swapped ? c : s;
  return {quadrant == 1 || quadrant == 2 ? negated(cosine) : cosine, quadrant >= 2 ? negated(sine) : sine};
}

namespace {

void expect_encloses(const Pair& claimed, const Between& computed, std::int64_t bits, const char* reason) {
  const Integer one = Integer(1) << static_cast<mp_bitcnt_t>(bits);
  expect(claimed.x * one <= computed.low && claimed.y * one >= computed.high, reason);
}

/// The claimed enclosures of cos u and sin u hold.
void expect_cosine_and_sine(const Rational& u, const Pair& cosine, const Pair& sine, const Rational& turns,
                            const Rational& precision) {
  expect(turns.get_den() == 1 && mpz_sizeinbase(turns.get_num_mpz_t(), 2) <= 1030,
         "certificate: quarter_turns is out of range");
  const std::int64_t bits = integer_bits(precision);
  const CosineAndSine computed = cosine_and_sine(u, turns.get_num(), bits);
  expect_encloses(cosine, computed.cosine, bits, "certificate: cosine is wrong");
  expect_encloses(sine, computed.sine, bits, "certificate: sine is wrong");
}

void check_parametric_circle(const Claim& claim) {
  claim.inputs({"circle", "u"});
  const Circle c = circle(claim.input["circle"], "circle");
  const Rational u = number(claim.input["u"], "u");
  claim.answers({"point"});
  const Pair p = exact_pair(claim.truth["point"], "truth.point");
  if (claim.kind() == "exact") {
    claim.facts({}), expect(sgn(u) == 0 || sgn(c.radius) == 0, "certificate: neither u nor the radius is 0");
    expect(p == Pair{Rational(c.center.x + c.radius), c.center.y}, "truth: point is wrong");
    return;
  }
  claim.expect_kind("enclosure");
  expect(sgn(u) != 0 && sgn(c.radius) != 0, "certificate: the point is rational");
  claim.facts({"cosine", "sine", "quarter_turns", "bits"});
  const Pair cosine = claim.pair("cosine"), sine = claim.pair("sine");
  expect_cosine_and_sine(u, cosine, sine, claim.single("quarter_turns"), claim.single("bits"));
  expect_rounds_alike("point", p.x, Rational(c.center.x + c.radius * cosine.x),
                      Rational(c.center.x + c.radius * cosine.y));
  expect_rounds_alike("point", p.y, Rational(c.center.y + c.radius * sine.x), Rational(c.center.y + c.radius * sine.y));
}

}  // namespace

Checks checks_of_circle() { return {{"parametric_circle", check_parametric_circle}}; }

}  // namespace touchstone::certify
