// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/circular.h"

#include <mpfr.h>

#include <bit>
#include <cstdint>

#include "catalogue/codec/json.h"
#include "catalogue/families/numbers.h"
#include "oracle/certificates/check.h"
#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/lines/parametric_circle.h"
#include "proptests/catch.h"

namespace touchstone::proptests::circular_tests {
namespace {

using catalogue::DrawStream;
using oracle::Enclosure;
using oracle::Integer;
using oracle::Rational;

/// floor(pi * 2^bits)
Integer pi(int bits) {
  mpfr_t value;
  mpfr_init2(value, bits + 64);
  mpfr_const_pi(value, MPFR_RNDN);
  mpfr_mul_2ui(value, value, static_cast<std::uint64_t>(bits), MPFR_RNDN);
  Integer result;
  mpfr_get_z(result.get_mpz_t(), value, MPFR_RNDD);
  mpfr_clear(value);
  return result;
}

Rational low(const Enclosure& x) { return oracle::scaled(Integer(x.nearest - x.width), x.exponent); }
Rational high(const Enclosure& x) { return oracle::scaled(Integer(x.nearest + x.width), x.exponent); }

/// An enclosure of few bits holds the one of many bits, as both hold the true value.
bool holds(const Enclosure& wide, const Enclosure& narrow) {
  return low(wide) <= low(narrow) && high(narrow) <= high(wide);
}

template <class Number>
bool enclosed(const Number& u) {
  const auto few = oracle::cosine_and_sine(u, 100), many = oracle::cosine_and_sine(u, 2000);
  return holds(few.cosine, many.cosine) && holds(few.sine, many.sine);
}

std::uint64_t nearest_bits(const Rational& value) {
  return std::bit_cast<std::uint64_t>(oracle::nearest_double(value));
}

}  // namespace

TEST_CASE(
    "cosine and sine: what is enclosed with few bits is what is enclosed with many, for doubles and for rationals") {
  DrawStream draws = DrawStream::seeded(20240604);
  int wrong = 0;
  for (int i = 0; i < 1500; ++i) {
    double u = draws.below(2) == 0 ? catalogue::ordinary(draws) : catalogue::mixed_exponent(draws);
    if (u == 0) u = 1;
    const Rational third(oracle::exact(u) / 3);
    wrong += !enclosed(u) + !enclosed(third);
  }
  CHECK(wrong == 0);
}

TEST_CASE("cosine and sine: a rational that is a double is enclosed as that double") {
  for (const double u : {1.0, -0.75, 3.141592653589793, 1e300, 5e-324}) {
    const auto of_double = oracle::cosine_and_sine(u, 1500),
               of_rational = oracle::cosine_and_sine(oracle::exact(u), 1000);
    CHECK(holds(of_rational.cosine, of_double.cosine));
    CHECK(holds(of_rational.sine, of_double.sine));
  }
}

TEST_CASE("parametric_circle: rationals closer to a half turn than any double leave the sign of the sine certain") {
  const Circle2<Rational> circle{{Rational(0), Rational(0)}, Rational(1)};
  const int bits = 3000;
  const Rational below = oracle::scaled(pi(bits), -bits), above = oracle::scaled(Integer(pi(bits) + 1), -bits);
  CHECK(nearest_bits(oracle::parametric_circle(circle, below).answer.y) == 0);
  CHECK(nearest_bits(oracle::parametric_circle(circle, above).answer.y) == std::uint64_t{1} << 63);
  CHECK(nearest_bits(oracle::parametric_circle(circle, below).answer.x) == std::bit_cast<std::uint64_t>(-1.0));
}

TEST_CASE("parametric_circle: what cancels in one coordinate only is still found to the last bit") {
  const auto exact = oracle::cosine_and_sine(1.0, 2000);
  const double sine = oracle::nearest_double(low(exact.sine));
  const auto point = oracle::parametric_circle({{0, -sine}, 1}, 1.0).answer;
  const Rational y_low(low(exact.sine) - oracle::exact(sine)), y_high(high(exact.sine) - oracle::exact(sine));
  CHECK(nearest_bits(y_low) == nearest_bits(y_high));
  CHECK(nearest_bits(point.y) == nearest_bits(y_low));
  CHECK(nearest_bits(point.x) == nearest_bits(low(exact.cosine)));
}

TEST_CASE("quarter turns: what is left is less than 0.8") {
  DrawStream draws = DrawStream::seeded(20240605);
  const int bits = 2200;
  const Rational half_pi = oracle::scaled(pi(bits), -bits - 1);
  for (int i = 0; i < 2000; ++i) {
    const double u = draws.below(2) == 0 ? catalogue::any_finite(draws) : 100 * catalogue::ordinary(draws);
    const Rational rest(oracle::exact(u) - Rational(oracle::quarter_turns(u)) * half_pi);
    CHECK(abs(rest) < Rational(4, 5));
  }
}

TEST_CASE("certificates: no enclosure of a sine or cosine is accepted that leaves the true value out by one unit") {
  mpfr_t angle, sine, cosine;
  mpfr_init2(angle, 53), mpfr_inits2(2600, sine, cosine, static_cast<mpfr_ptr>(nullptr));
  int accepted_wrongly = 0, accepted = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "sharp enclosures", i));
    const double u = draws.below(2) == 0 ? catalogue::ordinary(draws) * 100 : catalogue::mixed_exponent(draws);
    if (u == 0) continue;
    const std::uint64_t bits = 4 + draws.below(200);
    mpfr_set_d(angle, u, MPFR_RNDN);
    mpfr_sin_cos(sine, cosine, angle, MPFR_RNDN);
    nlohmann::json claim{{"op", "parametric_circle"}, {"truth", {{"point", {"1", "1"}}}}};
    claim["input"] = {{"circle", {{"center", {0, 0}}, {"radius", 1}}}, {"u", catalogue::hexadecimal(u)}};
    claim["certificate"] = {{"kind", "enclosure"},
                            {"cosine", {"-2", "2"}},
                            {"sine", {"-2", "2"}},
                            {"quarter_turns", {oracle::quarter_turns(u).get_str()}},
                            {"bits", {std::to_string(bits)}}};
    for (const auto& [name, value] : {std::pair{"cosine", cosine}, {"sine", sine}}) {
      Integer below;  // the true value lies between this many units and one more
      mpfr_mul_2ui(value, value, bits, MPFR_RNDN);
      mpfr_get_z(below.get_mpz_t(), value, MPFR_RNDD);
      const auto says = [&, name = name](const Integer& low, const Integer& high) {
        nlohmann::json shown = claim;
        const auto part = [&](const Integer& units) {
          return oracle::scaled(units, -static_cast<int>(bits)).get_str();
        };
        shown["certificate"][name] = {part(low), part(high)};
        return certify::refuse(shown).value_or("").starts_with("truth:");  // the enclosures have been accepted
      };
      const Integer more = Integer(1) << 40;
      accepted_wrongly += says(below + 1, below + more) || says(below - more, below);
      accepted += says(below - more, below + more);
    }
  }
  CHECK(accepted_wrongly == 0);
  CHECK(accepted > 2000);
  mpfr_clears(angle, sine, cosine, static_cast<mpfr_ptr>(nullptr));
}

}  // namespace touchstone::proptests::circular_tests
