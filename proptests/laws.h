// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "proptests/drawn.h"
#include "proptests/robust_bits.h"
#include "robust/kernel/filters/staged.h"

/// Laws, worked examples and refusals of one operation, in its types.
namespace touchstone::proptests {

using Rational = oracle::Rational;
using robust::Stage;
namespace rows = catalogue::rows;

inline constexpr double tiny = 5e-324, huge = 1e308, greatest = std::numeric_limits<double>::max();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The answer of a row's operation as the oracle gives it, over rationals or surds.
template <class Row>
using exact_answer_t = catalogue::truth_t<Row>;

/// Calls `change` with every point, vector and other number of a question or answer.
template <class T, class Change>
void for_each_part(T& value, const Change& change) {
  if constexpr (requires { change.place(value); }) {
    change.place(value);
  } else if constexpr (requires { std::tuple_size<T>::value; }) {
    std::apply([&](auto&... part) { (for_each_part(part, change), ...); }, value);
  } else if constexpr (catalogue::is_variant<T>) {
    std::visit([&](auto& alternative) { for_each_part(alternative, change); }, value);
  } else if constexpr (catalogue::is_optional<T>) {
    if (value) for_each_part(*value, change);
  } else if constexpr (catalogue::is_vector<T>) {
    for (auto& part : value) for_each_part(part, change);
  } else if constexpr (Composite<T>) {
    with_members(value, [&](auto&... member) { (for_each_part(member, change), ...); });
  }
}

/// x -> (xx x + xy y + tx, yx x + yy y + ty); vectors are not moved, numbers that are no coordinates stay.
struct Affine {
  double xx, xy, yx, yy, tx = 0, ty = 0;
  double determinant() const { return xx * yy - xy * yx; }

  /// 0 times infinity is 0 here: an answer beyond the range has an image too.
  template <class R>
  static R times(double factor, const R& number) {
    return factor == 0 ? R(0) : R(factor * number);
  }
  template <class R>
  void place(Point2<R>& p) const {
    p = {R(times(xx, p.x) + times(xy, p.y) + tx), R(times(yx, p.x) + times(yy, p.y) + ty)};
  }
  template <class R>
  void place(Vector2<R>& v) const {
    v = {R(times(xx, v.x) + times(xy, v.y)), R(times(yx, v.x) + times(yy, v.y))};
  }
  template <class T>
  T operator()(T value) const {
    for_each_part(value, *this);
    return value;
  }
};

/// The symmetries of the axes: exact for every double.
inline constexpr std::array<Affine, 7> axis_symmetries{
    {{-1, 0, 0, -1}, {0, -1, 1, 0}, {0, 1, -1, 0}, {1, 0, 0, -1}, {-1, 0, 0, 1}, {0, 1, 1, 0}, {0, -1, -1, 0}}};
/// Exact on lattice questions: a shear, a turn and stretch, one that turns the plane over, one of large determinant.
inline constexpr std::array<Affine, 4> integer_maps{
    {{1, 3, 0, 1, 7, -11}, {2, -1, 1, 2, -1e6, 1e6}, {1, 2, 2, 1, 3, 5}, {5, -4, 3, 5, 12345, 67890}}};

/// Whether every number is an integer of at most 45 bits, so that `integer_maps` do not round.
template <class Asked>
bool on_lattice(const Asked& asked) {
  bool whole = true;
  catalogue::for_each_number(asked,
                             [&](const double& n) { whole = whole && std::fabs(n) <= 0x1p45 && n == std::trunc(n); });
  return whole;
}

/// Every word and number equal; the two zeros are.
template <class T>
bool equal(const T& a, const T& b) {
  if constexpr (Composite<T>) {
    return with_members(a, [&](const auto&... of_a) {
      return with_members(b, [&](const auto&... of_b) { return (equal(of_a, of_b) && ...); });
    });
  } else if constexpr (catalogue::is_optional<T>) {
    return a.has_value() == b.has_value() && (!a || equal(*a, *b));
  } else if constexpr (catalogue::is_vector<T>) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return equal(x, y); });
  } else {
    return a == b;
  }
}

/// The property that `holds(ask, asked)` for every question of every family that is inside the contract, once with
/// robust as `ask` and once with the oracle. ask: question as a tuple -> answer.
template <class Row, class Ask, class Holds>
void law_of(const std::string& sentence, const Ask& ask, const Holds& holds, int usual) {
  never(
      catalogue::operation_of_row<Row>(), sentence,
      [&](const Question& question) -> std::string {
        const auto asked = typed<Row>(question);
        try {
          ask(asked);
        } catch (const InvalidInput&) {
          return "";
        }
        try {
          return holds(ask, asked) ? "" : "the law is broken";
        } catch (const InvalidInput& refused) {
          return std::string("the law is broken: refused, ") + refused.what();
        }
      },
      usual);
}

template <class Row, class Holds>
void robust_law(const std::string& sentence, const Holds& holds, int usual = 12) {
  law_of<Row>(
      "robust: " + sentence, [](const auto& asked) { return catalogue::ask_robust<Row>(asked); }, holds, usual);
}

template <class Row, class Holds>
void law(const std::string& sentence, const Holds& holds) {
  robust_law<Row>(sentence, holds);
  law_of<Row>(
      "oracle: " + sentence, [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; }, holds, 3);
}

/// LAW("orientation: both points are on their line", p0, p1) {
///   return ask(Row::Question{p0, p1, p0}) == Side::on && ask(Row::Question{p0, p1, p1}) == Side::on;
/// }
/// is the test case of one law, in the types of the file's `Row`. It names as many of the question's parts as it needs,
/// from the first on; the whole question is `asked`.
#define LAW(...) TOUCHSTONE_LAW(law, __COUNTER__, __VA_ARGS__)
#define ROBUST_LAW(...) TOUCHSTONE_LAW(robust_law, __COUNTER__, __VA_ARGS__)
#define TOUCHSTONE_LAW(kind, number, ...) TOUCHSTONE_LAW_NUMBERED(kind, number, __VA_ARGS__)
#define TOUCHSTONE_LAW_NUMBERED(kind, number, sentence, ...)                                       \
  static bool holds_##number(TOUCHSTONE_PARTS(ask, asked __VA_OPT__(, ) __VA_ARGS__));             \
  TEST_CASE(sentence) {                                                                            \
    proptests::kind<Row>(sentence, [](const auto& ask, const auto& asked) {                        \
      const auto holds = [&](const auto&... part) { return holds_##number(ask, asked, part...); }; \
      return catalogue::applied(holds, asked);                                                     \
    });                                                                                            \
  }                                                                                                \
  static bool holds_##number(TOUCHSTONE_PARTS(ask, asked __VA_OPT__(, ) __VA_ARGS__))

/// a, b -> const auto& a, const auto& b, and whatever follows. Of up to nine.
#define TOUCHSTONE_PARTS(...) TOUCHSTONE_THRICE(TOUCHSTONE_THRICE(TOUCHSTONE_PART(__VA_ARGS__))) const auto&...
#define TOUCHSTONE_PART(name, ...) \
  [[maybe_unused]] const auto &name, __VA_OPT__(TOUCHSTONE_NEXT TOUCHSTONE_NOTHING()(__VA_ARGS__))
#define TOUCHSTONE_NEXT() TOUCHSTONE_PART
#define TOUCHSTONE_NOTHING
#define TOUCHSTONE_THRICE(...) TOUCHSTONE_ONCE(TOUCHSTONE_ONCE(TOUCHSTONE_ONCE(__VA_ARGS__)))
#define TOUCHSTONE_ONCE(...) __VA_ARGS__

/// Whether an answer's numbers are rationals (an answer of one word counts as exact).
template <class Answer>
inline constexpr bool is_exact = std::is_same_v<Answer, catalogue::rebound_t<Answer, Rational>> ||
                                 std::is_same_v<Answer, catalogue::rebound_t<Answer, catalogue::TrueNumber>>;

/// Whether t and s are parameters of one point on a segment and on the reversed segment: told exactly of rationals; of
/// rounded numbers only that both are there.
template <class R>
bool reversed(const std::optional<R>& t, const std::optional<R>& s) {
  if constexpr (std::is_same_v<R, Rational>) return t.has_value() == s.has_value() && (!t || *s == 1 - *t);
  return t.has_value() == s.has_value();
}

/// Rounding keeps its relative place as long as no number is subnormal, or may have been before it was rounded, or is
/// infinite.
inline bool scaled_number(double n, double found, int k) {
  if (std::fabs(n) < 0x1p-1021) return std::fabs(found) <= std::ldexp(0x1p-1021, k);
  if (std::isinf(n)) return true;
  const double expected = std::ldexp(n, k);
  return found == expected || (std::fabs(expected) < 0x1p-1021 && std::fabs(found) < 0x1p-1021);
}
inline bool scaled_number(const catalogue::TrueNumber& n, const catalogue::TrueNumber& found, int k) {
  const catalogue::TrueNumber two_to_k = catalogue::exact_value(std::ldexp(1, k));
  return found == n * two_to_k;
}

/// Whether `found` is `answer` with every point times 2^k, as far as no coordinate is subnormal.
template <class R>
bool scaled(const Point2<R>& answer, const Point2<R>& found, int k) {
  return scaled_number(answer.x, found.x, k) && scaled_number(answer.y, found.y, k);
}
template <class T>
bool scaled(const T& answer, const T& found, int k) {
  if constexpr (Composite<T>) {
    return with_members(answer, [&](const auto&... of_answer) {
      return with_members(found, [&](const auto&... of_found) { return (scaled(of_answer, of_found, k) && ...); });
    });
  } else if constexpr (catalogue::is_optional<T>) {
    return answer.has_value() == found.has_value() && (!answer || scaled(*answer, *found, k));
  } else if constexpr (catalogue::is_vector<T>) {
    return std::equal(answer.begin(), answer.end(), found.begin(), found.end(),
                      [k](const auto& x, const auto& y) { return scaled(x, y, k); });
  } else {
    return answer == found;
  }
}

template <class Asked>
std::vector<double> numbers_of(const Asked& asked) {
  std::vector<double> numbers;
  catalogue::for_each_number(asked, [&](const double& number) { numbers.push_back(number); });
  return numbers;
}

/// The law of scaling: all lengths of a question times 2^k, where that is exact, give the same answer with its points
/// times 2^k.
template <class Row>
inline constexpr auto scales = [](const auto& ask, const auto& asked) {
  const auto times_two_to = [](auto question, int k) {
    if constexpr (requires { Row::scale(question, k); }) {
      Row::scale(question, k);
    } else {
      catalogue::for_each_number(question, [&](double& number) { number = std::ldexp(number, k); });
    }
    return question;
  };
  const auto answer = ask(asked);
  for (const int k : {1, -29, 300, -300, 1000, -1000}) {
    const auto larger = times_two_to(asked, k);
    if (numbers_of(times_two_to(larger, -k)) == numbers_of(asked) && !scaled(answer, ask(larger), k)) return false;
  }
  return true;
};

template <class Row>
std::unique_ptr<catalogue::Examination> examined(const typename Row::Question& question) {
  return catalogue::operation_of_row<Row>().examine(catalogue::packed(question));
}

/// A worked example: the oracle answers exactly this, robust the nearest doubles of it, and so does the reference in
/// double, unless `by_reference` says which verdict it gets instead.
void example(const Operation& operation, const Question& question, const catalogue::EncodedTruth& expected,
             const std::string& by_reference);
template <class Row>
void example(const typename Row::Question& question, const exact_answer_t<Row>& expected,
             const std::string& by_reference = "agree") {
  example(catalogue::operation_of_row<Row>(), catalogue::packed(question),
          catalogue::packed_as<catalogue::TrueNumber>(expected), by_reference);
}

/// The same, and the oracle's margin: `constexpr Worked<Row> worked;`
template <class Row>
struct Worked {
  void operator()(const typename Row::Question& question, const exact_answer_t<Row>& expected, const Rational& margin,
                  const std::string& by_reference = "agree") const {
    example<Row>(question, expected, by_reference);
    CHECK(*catalogue::ask_oracle<Row>(question).margin == margin);
  }
};

/// Robust and oracle both refuse, naming this field and rule.
void refused(const Operation& operation, const Question& question, const std::string& expected);
template <class Row>
void refused(const typename Row::Question& question, const std::string& field, const std::string& rule) {
  refused(catalogue::operation_of_row<Row>(), catalogue::packed(question), field + ": " + rule);
}

}  // namespace touchstone::proptests
