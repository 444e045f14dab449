// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "catalogue/judge/environment.h"
#include "catalogue/operation.h"
#include "proptests/answer_bits.h"

namespace touchstone::proptests {

/// What robust answers in an environment; then its decision alone, where it has one.
inline AnswerBits robust_bits(const audit::Operation& operation, const audit::Question& question,
                              std::size_t environment) {
  AnswerBits bits;
  try {
    const audit::Tape<double> answer = operation.row().robust(question, environment);
    bits.words.assign(answer.words.begin(), answer.words.end());
    for (const double number : answer.numbers) bits.words.push_back(std::bit_cast<std::uint64_t>(number));
    if (operation.row().decision != nullptr) bits.words.push_back(operation.row().decide(question, environment));
  } catch (const InvalidInput& refused) {
    bits.refused = refused.what();
  }
  return bits;
}

}  // namespace touchstone::proptests
