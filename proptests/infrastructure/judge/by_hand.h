// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"
#include "proptests/uses.h"

namespace touchstone::proptests {

using Boundary = Declaration::Boundary;

/// One engine and one question, asked about many answers.
struct Case {
  const char* operation;
  const char* question;
  Boundary boundary = Boundary::unspecified;
  double tolerance = 0;
  bool binary32 = false;

  Judgement judge(const std::string& answer) const {
    const Operation& asked = *find_operation(operation);
    const auto examination = asked.examine(asked.parse(parse_line(question)));
    return examination->judge_engine(parse_line(answer), Declaration{"by hand", boundary, binary32, tolerance});
  }
  std::string says(const std::string& answer) const { return name_of(judge(answer).verdict); }
  int touch(const std::string& answer) const { return judge(answer).touch_reading; }
};

}  // namespace touchstone::proptests
