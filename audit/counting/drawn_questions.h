// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "audit/counting/tally.h"

namespace touchstone::audit {

struct DrawOptions {
  std::vector<std::string> families;  ///< empty: all
  std::uint64_t cases = 100, seed = 1;
  bool ordinary_only = false;  ///< leaves out questions of extreme magnitude
  bool binary32 = false;       ///< rounds numbers to float before the truth is computed
};

/// Calls visit(family, index, examination) for each question: within the contract, spread over the families in turn;
/// the index is that in an audit of the same seed. Throws InvalidInput, with the field "families", if there are no such
/// questions.
void draw_questions(const Operation& operation, const DrawOptions& options,
                    const std::function<void(const std::string&, std::uint64_t, const Examination&)>& visit);

}  // namespace touchstone::audit
