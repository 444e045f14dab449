// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "proptests/forward_error.h"

/// Laws of solids that move along straight lines.
namespace touchstone::proptests {

/// A velocity times 2^k where that is exact.
template <class Vector>
std::optional<Vector> times_two_to(const Vector& v, int k) {
  Vector w = v;
  catalogue::for_each_number(w, [k](double& number) { number = std::ldexp(number, k); });
  Vector back = w;
  catalogue::for_each_number(back, [k](double& number) { number = std::ldexp(number, -k); });
  return numbers_of(back) == numbers_of(v) ? std::optional(w) : std::nullopt;
}

/// Whether `found` is the answer after all velocities have been multiplied by 2^k: t is divided by it. What is never
/// met may be met by a faster motion, and a slower one may not get there.
template <class Answer>
bool divided(const Answer& answer, const Answer& found, int k) {
  using Number = std::remove_cvref_t<decltype(*answer.t)>;
  if (!answer.t) return k > 0 || !found.t;
  if constexpr (std::is_same_v<Number, double>) {
    // A rounded t that is 2^k may have been more.
    if (!found.t) return *answer.t >= std::ldexp(1, k);
    return scaled_number(*answer.t, *found.t, -k);
  } else {
    if (*answer.t > Number(power_of_two(k))) return !found.t;
    return found.t && *found.t == *answer.t * Number(power_of_two(-k));
  }
}

/// Velocities times a power of two, where that is exact, divide t by it. velocities: their numbers among the parts of
/// the question, which may stand in a plane or in space.
template <std::size_t... velocities>
inline constexpr auto velocities_divide_t = [](const auto& ask, const auto& asked) {
  const auto answer = ask(asked);
  const auto kept = [&](auto question, int k) {
    const auto faster = [k](auto& velocity) {
      const auto w = times_two_to(velocity, k);
      if (w) velocity = *w;
      return w.has_value();
    };
    return !(faster(std::get<velocities>(question)) && ...) || divided(answer, ask(question), k);
  };
  for (const int k : {1, -2, 40, -40, 500})
    if (!catalogue::applied([&](const auto&... part) { return kept(std::tuple(part...), k); }, asked)) return false;
  return true;
};

/// In exact arithmetic the formula is right, but where the two meet at the start.
template <class Row>
void right_but_at_the_start() {
  const catalogue::RowFunctions& row = catalogue::operation_of_row<Row>().row();
  const auto complaint = [&](const Question& question) -> std::string {
    try {
      const auto truth = row.solve(question).answer;
      if (!truth.numbers.empty() && truth.numbers[0] == oracle::Surd(Rational(0))) return "";
      const bool same =
          catalogue::same_as_truth(*row.answer, truth, row.reference_exactly(question), catalogue::Reading::complete);
      return same ? "" : "the formula is wrong even in exact arithmetic";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(catalogue::operation_of_row<Row>(), "right in exact arithmetic but for a meeting at the start", complaint, 3);
}

/// The test case of velocities_divide_t, in the types of the file's `Row`.
#define VELOCITIES_LAW(operation, ...)                                      \
  TEST_CASE(operation ": velocities times a power of two divide t by it") { \
    law<Row>("faster and slower", velocities_divide_t<__VA_ARGS__>);        \
  }

}  // namespace touchstone::proptests
