// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "catalogue/families/draw_stream.h"
#include "catalogue/judge/environment.h"
#include "catalogue/operation/operation.h"
#include "proptests/answer_bits.h"

namespace touchstone::proptests {

/// Which environment a question is asked in beside the first: any, but always the same one for the same question.
inline std::size_t environment_of(const catalogue::Question& question) {
  std::uint64_t mixed = 0;
  for (const double number : question.numbers)
    mixed = catalogue::seed_of(mixed, "", std::bit_cast<std::uint64_t>(number));
  return 1 + mixed % (environment_count - 1);
}

/// What robust answers in an environment; then its decision alone, where it has one.
inline AnswerBits robust_bits(const catalogue::Operation& operation, const catalogue::Question& question,
                              std::size_t environment) {
  AnswerBits bits;
  try {
    const catalogue::EncodedValue<double> answer = operation.row().robust(question, environment);
    bits.words.assign(answer.words.begin(), answer.words.end());
    for (const double number : answer.numbers) bits.words.push_back(std::bit_cast<std::uint64_t>(number));
    if (operation.row().decision != nullptr) bits.words.push_back(operation.row().decide(question, environment));
  } catch (const InvalidInput& refused) {
    bits.refused = refused.what();
  }
  return bits;
}

}  // namespace touchstone::proptests
