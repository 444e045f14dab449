// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// At most five questions of an operation that every implementation answers rightly if it maps fields and enumerators
/// correctly: short numbers, nothing that only touches, and the textbook formula in double (or float) is right; meshes
/// face outwards, as most engines expect. They cover as many different truths as were found. The same every time.
struct EasyQuestion {
  Question question;
  std::unique_ptr<Examination> examination;
};
std::vector<EasyQuestion> easy_questions(const Operation& operation, const Declaration& declaration = {});

}  // namespace touchstone::audit
