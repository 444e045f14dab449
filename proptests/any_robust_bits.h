// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/catalogue.h"
#include "proptests/robust_bits.h"

/// For tests that go through the whole catalogue; a test of one operation includes its row alone, so that a new row compiles no other.
namespace touchstone::proptests {

/// What robust answers in an environment.
inline AnswerBits robust_bits(const audit::Operation& operation, const audit::Question& question,
                              std::size_t environment) {
  AnswerBits bits;
  audit::for_each_row([&]<class Row>() {
    if (&Row::card() == &operation.card()) bits = robust_bits<Row>(question, environment);
  });
  return bits;
}

}  // namespace touchstone::proptests
