// SPDX-License-Identifier: Apache-2.0
#include "proptests/interrogation.h"

#include <algorithm>

#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests::interrogation_tests {
namespace {

/// How many questions of a family, where questions are cheap, are asked for an aspect.
struct Share {
  Aspect aspect;
  std::uint64_t questions;
};
constexpr Share shares[] = {
    {Aspect::robust, 64 * batch}, {Aspect::stages, 12 * batch},         {Aspect::promise, 8 * batch},
    {Aspect::certificate, 96},    {Aspect::laws_of_robust, 12 * batch}, {Aspect::laws_of_oracle, batch},
};

}  // namespace

EACH_OPERATION("robust, oracle, formula, certificate, stages and laws agree on every family, in every environment") {
  const Aspects all = aspects_of(operation);
  std::uint64_t most = 0;
  for (const Share& share : shares) most = std::max(most, has(all, share.aspect) ? share.questions : 0);
  const auto asked_at = [&](std::uint64_t place) {
    Aspects asked;
    for (const auto& [aspect, questions] : shares) {
      const std::uint64_t each = affordable(operation, most) / affordable(operation, questions);
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
