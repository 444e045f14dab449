// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tuple>

#include "catalogue/operation.h"
#include "catalogue/families/numbers.h"
#include "catalogue/judge/ulps.h"
#include "oracle/truth.h"

/// A row of the catalogue is a struct named like its operation, in the file of that name. It holds
///   TOUCHSTONE_ROOMS(op)                     the functions of the three rooms
///   using Question = std::tuple<...>;        the arguments
///   static const Card& card();               names, pages, kind of judgement
///   static std::vector<HardCase<Question>> hard_cases();
/// and where the operation is particular
///   static void scale(Question&, int k);     numbers that are no lengths stay (default: all times 2^k)
///   static std::optional<Truth> as_open_sets(const Truth&, const Question&);   the answer for open sets, if the truth is a touch
///   static void repair(Question&);       makes a question of the operation out of drawn numbers (a ring that does not cross itself)
///   static std::string fault(const Question&, const Answer&);   where many answers are right: what is wrong with one; "" if it is right
///   static Question map_centre();            a degenerate question for the failure map (default: the first hard case at its simplest)
///   static std::pair<std::size_t, std::size_t> map_axes();      which of its numbers move (default: the last two)
///   struct decision { robust(Question), oracle(Question), oracle(the same over std::int64_t) };   decisions alone, at full speed
///   static Word relation(const Question&);   robust's decision alone, where it has a function for it and the row no `decision`
///   static void draw(Scene&, const Question&);   (default: every argument by its type)
/// Everything else - codec, families, judge, tests, fuzz target, vectors, report - follows from these.
#define TOUCHSTONE_ROOMS(op)                                                                         \
  static auto reference(const auto&... q) { return ::touchstone::reference::op(q...); }              \
  static auto robust(const auto&... q) { return ::touchstone::robust::op(q...); }                    \
  static auto oracle(const auto&... q)->decltype(::touchstone::oracle::op(q...)) {                   \
    return ::touchstone::oracle::op(q...);                                                           \
  }                                                                                                  \
  static auto certificate(const auto&... q) { return ::touchstone::oracle::op##_certificate(q...); } \
  template <class E>                                                                                 \
  static auto ask(E& engine, const auto&... q)->decltype(engine.op(q...)) {                          \
    return engine.op(q...);                                                                          \
  }

namespace touchstone::audit {

template <class Question>
struct HardCase {
  std::string name;            ///< the family: "collinear", "shared_end" ...
  Question (*draw)(Choices&);  ///< integers and other exact parameters, so that a shrunk case stays degenerate
};

/// The function of a room on a tuple of arguments.
template <class Row, class... Ts>
auto ask_reference(const std::tuple<Ts...>& q) {
  return std::apply([](const auto&... value) { return Row::reference(value...); }, q);
}
template <class Row, class... Ts>
auto ask_robust(const std::tuple<Ts...>& q) {
  return std::apply([](const auto&... value) { return Row::robust(value...); }, q);
}
template <class Row, class... Ts>
auto ask_oracle(const std::tuple<Ts...>& q) {
  return std::apply([](const auto&... value) { return Row::oracle(value...); }, q);
}
template <class Row>
auto ask_certificate(const typename Row::Question& q) {
  return std::apply([](const auto&... value) { return Row::certificate(value...); }, q);
}

/// Whether the oracle also takes exact rationals, for numbers as they were typed.
template <class Row, class Tuple>
inline constexpr bool oracle_takes = false;
template <class Row, class... Ts>
requires requires(const Ts&... q) { Row::oracle(q...); }
inline constexpr bool oracle_takes<Row, std::tuple<Ts...>> = true;

/// The operation made from a row. Defined in a translation unit of its own for every row, which CMake writes (cmake/rooms.cmake).
template <class Row>
const Operation& operation_of_row();

template <class Row>
using answer_t = decltype(ask_robust<Row>(std::declval<const typename Row::Question&>()));

/// Whether robust decides without numbers in a function of its own, and what that says.
template <class Row>
inline constexpr bool decides_alone = requires(const typename Row::Question& q) {
  Row::relation(q);
}
|| requires(const typename Row::Question& q) { Row::decision::robust(q); };
template <class Row>
auto decision_alone(const typename Row::Question& q) {
  if constexpr (requires { Row::relation(q); }) {
    return Row::relation(q);
  } else {
    return Row::decision::robust(q);
  }
}

/// A lattice point of the plane, near the origin first.
inline Point2d lattice_point(Choices& choices, int bits = 26) {
  const double x = integer(choices, bits);
  return {x, integer(choices, bits)};
}

/// A lattice vector that is not zero; (1, 0) is the simplest.
inline Vector2d lattice_direction(Choices& choices, int bits = 20) {
  const double x = integer(choices, bits), y = integer(choices, bits);
  return x == 0 && y == 0 ? Vector2d{1, 0} : Vector2d{x, y};
}

/// p + t v; exact for the sizes that the two functions above and small t give.
inline Point2d along(const Point2d& p, double t, const Vector2d& v) { return {p.x + t * v.x, p.y + t * v.y}; }

}  // namespace touchstone::audit
