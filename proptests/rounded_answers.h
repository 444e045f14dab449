// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/laws.h"

namespace touchstone::proptests {

/// A worked example whose answer is no rational: robust, and the oracle rounded, give these doubles; the reference gets
/// this verdict. `constexpr Gives<Row> gives;`
template <class Row>
struct Gives {
  void operator()(const typename Row::Question& question, const catalogue::answer_t<Row>& expected,
                  const std::string& by_reference = "agree") const {
    INFO(catalogue::one_line(catalogue::operation_of_row<Row>().print(catalogue::packed(question))));
    CHECK(equal(catalogue::ask_robust<Row>(question), expected));
    const auto truth = catalogue::converted<double>(catalogue::ask_oracle<Row>(question).answer,
                                                    [](const auto& number) { return catalogue::nearest(number); });
    CHECK(equal(truth, expected));
    CHECK(name_of(examined<Row>(question)->judge_reference().verdict) == by_reference);
  }
};

}  // namespace touchstone::proptests
