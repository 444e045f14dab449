// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <utility>

#include "catalogue/numbers/ulps.h"
#include "proptests/laws.h"

/// The forward error bounds that the contracts in reference/lines state, in rationals, and the property that they hold.
namespace touchstone::proptests {

inline Rational power_of_two(int exponent) {
  Rational result(1);
  if (exponent >= 0) {
    result <<= static_cast<mp_bitcnt_t>(exponent);
  } else {
    result >>= static_cast<mp_bitcnt_t>(-exponent);
  }
  return result;
}

/// The unit of rounding to nearest in binary64.
inline const Rational& unit() {
  static const Rational u = power_of_two(-53);
  return u;
}

inline Rational exact(double value) { return catalogue::exact_value(value); }
inline Rational size(double value) { return abs(exact(value)); }

template <class... Doubles>
bool finite(Doubles... values) {
  return (std::isfinite(values) && ...);
}

/// The edges from a vertex to the next and to the previous one; empty where a coordinate of these is neither 0 nor
/// between 2^-200 and 2^200 in size, for which the contracts promise nothing.
inline std::optional<std::pair<Vector2<Rational>, Vector2<Rational>>> moderate_corner(const Polygon2d& ring,
                                                                                      std::size_t i) {
  const auto to = [p = ring[i]](const Point2d& q) {
    return Vector2<Rational>{Rational(exact(q.x) - exact(p.x)), Rational(exact(q.y) - exact(p.y))};
  };
  const Vector2<Rational> v = to(ring.next(i)), w = to(ring.previous(i));
  for (const Rational& x : {v.x, v.y, w.x, w.y}) {
    if (sgn(x) != 0 && (abs(x) < power_of_two(-200) || abs(x) > power_of_two(200))) return std::nullopt;
  }
  return std::pair{v, w};
}

/// A cross product v.x w.y - v.y w.x as computed, with `roundings` roundings behind each of its products, and its
/// bounds before and after the subtraction (reference/lines/line_line.h and ray_segment.h).
struct CrossBound {
  double computed;
  bool overflow;
  Rational before, after;

  CrossBound(const Vector2d& v, const Vector2d& w, int roundings) {
    const double left = v.x * w.y, right = v.y * w.x;
    computed = left - right;
    overflow = !finite(left, right, computed);
    if (overflow) return;
    const Rational u = unit(), factor = roundings == 2 ? Rational((2 + u) * u) : Rational((3 + 4 * u) * u);
    before = factor * (size(left) + size(right)) + power_of_two(-1073);
    after = before + u * size(computed);
  }
};

/// A quotient of two cross products as computed, and e(T) of the contract; undefined where the divisor is not certain.
struct QuotientBound {
  double computed = 0;
  bool defined = false;
  Rational error;

  QuotientBound(const CrossBound& n, const CrossBound& d) {
    if (n.overflow || d.overflow || !(size(d.computed) > d.after)) return;
    computed = n.computed / d.computed;
    if (!finite(computed)) return;
    defined = true;
    const Rational q = abs(exact(n.computed) / exact(d.computed));
    error = (n.after + q * d.after) / (size(d.computed) - d.after) + unit() * size(computed) + power_of_two(-1075);
  }

  bool certainly_outside() const { return defined && (exact(computed) < -error || exact(computed) > 1 + error); }
  bool certainly_inside() const { return defined && exact(computed) > error && exact(computed) < 1 - error; }
  bool certainly_positive() const { return defined && exact(computed) > error; }
  bool certainly_negative() const { return defined && exact(computed) < -error; }
};

inline bool within(double computed, const Rational& truth, const Rational& error) {
  return abs(exact(computed) - truth) <= error;
}

/// The property that `claim(truth, answer, arguments...)` holds for the slide's formula in double on every valid
/// question: the contract's promise, as it is written there.
template <class Row, class Claim>
void contract(const std::string& sentence, const Claim& claim, int usual = 12) {
  const auto complaint = [&](const Question& question) -> std::string {
    const auto asked = typed<Row>(question);
    try {
      const auto truth = catalogue::ask_oracle<Row>(asked);
      const auto answer = catalogue::ask_reference<Row>(asked);
      const bool kept =
          catalogue::applied([&](const auto&... argument) { return claim(truth, answer, argument...); }, asked);
      return kept ? "" : "the reference in double breaks its contract";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(catalogue::operation_of_row<Row>(), sentence, complaint, usual);
}

/// CONTRACT("orientation: ...", p0, p1, p) { return answer == truth.answer || ...; } is the test case of one such
/// claim, in the types of the file's `Row`.
#define CONTRACT(...) TOUCHSTONE_CONTRACT(__COUNTER__, __VA_ARGS__)
#define TOUCHSTONE_CONTRACT(number, ...) TOUCHSTONE_CONTRACT_NUMBERED(number, __VA_ARGS__)
#define TOUCHSTONE_CONTRACT_NUMBERED(number, sentence, ...)                                                  \
  static bool keeps_##number(TOUCHSTONE_PARTS(truth, answer __VA_OPT__(, ) __VA_ARGS__));                    \
  TEST_CASE(sentence) {                                                                                      \
    proptests::contract<Row>(sentence, [](const auto&... argument) { return keeps_##number(argument...); }); \
  }                                                                                                          \
  static bool keeps_##number(TOUCHSTONE_PARTS(truth, answer __VA_OPT__(, ) __VA_ARGS__))

/// The property that the formula in exact arithmetic is the truth.
template <class Row>
void right_in_exact_arithmetic() {
  const auto complaint = [&](const Question& question) -> std::string {
    try {
      const catalogue::RowFunctions& row = catalogue::operation_of_row<Row>().row();
      // First: the formula has no guards against what the oracle refuses.
      const catalogue::EncodedTruth truth = row.solve(question).answer;
      const bool same =
          catalogue::same_as_truth(*row.answer, truth, row.reference_exactly(question), catalogue::Reading::complete);
      return same ? "" : "the formula is wrong even in exact arithmetic";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(catalogue::operation_of_row<Row>(), "the formula is right in exact arithmetic", complaint, 3);
}

}  // namespace touchstone::proptests
