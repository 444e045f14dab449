// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/probes/symmetries.h"
#include "testing/asked.h"

/// Checks a function against the exact symmetries of an operation, without any truth.
///
///   const auto question = *questions<operations::orientation>();
///   RC_ASSERT(broken_law(question, my::orientation) == "");
namespace touchstone::tests {

using catalogue::Compared;

/// Returns the law that a function of the operation's arguments breaks for a question ("arguments exchanged", "times a
/// power of two", "a symmetry of the axes", "an integer similarity", "an integer map"); "" if it breaks none. The
/// function returns the full answer, the enumerator that decides, or a bool.
template <class Row, class... Ts, class Mine>
std::string broken_law(const Asked<Row, Ts...>& asked, const Mine& mine, Compared compared = Compared::decisions) {
  using Arguments = typename Asked<Row, Ts...>::Arguments;
  const auto answer = [&mine](const catalogue::Question& question) {
    auto read = catalogue::unpacked<typename Row::Question>(question);
    if constexpr (std::is_same_v<Arguments, typename Row::Question>) return called_with(mine, read);
    else return called_with(mine, std::get<Arguments>(read));
  };
  using Answer = std::decay_t<decltype(answer(asked.drawn.question))>;
  const Operation& operation = *asked.drawn.operation;
  const auto packed_answer = [&](const catalogue::Question& question) {
    operation.row().robust(question, 0);  // throws InvalidInput if an image is outside the contract
    return catalogue::packed(answer(question));
  };
  return catalogue::broken_law(operation, asked.drawn.question, packed_answer, catalogue::shape_of<Answer>(), compared);
}

}  // namespace touchstone::tests
