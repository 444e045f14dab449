// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "program/commands/commands.h"

namespace touchstone::program {

/// Calls visit(family, index, examination) for each question of `touchstone draw`: within the contract, spread over the
/// families in turn; the index is that in an audit of the same seed. Throws UsageError naming the option if there are
/// no such questions.
void draw_questions(const DrawCommand& command,
                    const std::function<void(const std::string&, std::uint64_t, const Examination&)>& visit);

}  // namespace touchstone::program
