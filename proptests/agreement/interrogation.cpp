// SPDX-License-Identifier: Apache-2.0
#include "proptests/interrogation.h"

#include <algorithm>

#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests::interrogation_tests {
namespace {

/// How many questions of a family, where questions are cheap, are asked for an aspect, and how many at least. A law
/// solves a question once for each image, and a promise asks the formula in rationals: for these, one or two do.
struct Share {
  Aspect aspect;
  std::uint64_t questions;
  std::uint64_t least = least_cases;
};
constexpr Share shares[] = {
    {Aspect::robust, 64 * batch}, {Aspect::stages, 12 * batch},         {Aspect::promise, 8 * batch, 2},
    {Aspect::certificate, 96},    {Aspect::laws_of_robust, 12 * batch}, {Aspect::laws_of_oracle, batch, 1},
};

}  // namespace

EACH_OPERATION("robust, oracle, formula, certificate, stages and laws agree on every family, in every environment") {
  const Aspects all = aspects_of(operation);
  std::uint64_t most = 0;
  for (const Share& share : shares) most = std::max(most, has(all, share.aspect) ? share.questions : 0);
  const auto asked_at = [&](std::uint64_t place) {
    Aspects asked;
    for (const auto& [aspect, questions, least] : shares) {
      const std::uint64_t each = affordable(operation, most) / affordable(operation, questions, least);
      asked[static_cast<std::size_t>(aspect)] = has(all, aspect) && place % each == 0;
    }
    return asked;
  };
  never_at(
      operation, "robust agrees with the oracle",
      [&](const Question& question, std::uint64_t place) { return interrogated(operation, question, asked_at(place)); },
      static_cast<int>(most / batch));
}

}  // namespace touchstone::proptests::interrogation_tests
