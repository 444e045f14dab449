// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/laws.h"

namespace touchstone::proptests {

/// A worked example whose answer is no rational: robust, and the oracle rounded, give these doubles; the reference gets
/// this verdict. `constexpr Gives<Row> gives;`
template <class Row>
struct Gives {
  void operator()(const typename Row::Question& question, const audit::answer_t<Row>& expected,
                  const std::string& by_reference = "agree") const {
    INFO(audit::one_line(audit::operation_of_row<Row>().print(audit::packed(question))));
    CHECK(equal(audit::ask_robust<Row>(question), expected));
    const auto truth = audit::converted<double>(audit::ask_oracle<Row>(question).answer,
                                                [](const Rational& number) { return audit::nearest(number); });
    CHECK(equal(truth, expected));
    CHECK(audit::name_of(examined<Row>(question)->judge_reference().verdict) == by_reference);
  }
};

}  // namespace touchstone::proptests
