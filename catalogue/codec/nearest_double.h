// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace touchstone::catalogue {

/// The double nearest to a decimal number, ties to even: infinite beyond the range, subnormal or 0 near 0. Returns
/// nullopt if the text is anything else, or longer. No locale affects it. `hexadecimal_too`: also accepts numbers such
/// as "-0x1.8p+3".
std::optional<double> nearest_double(std::string_view text, bool hexadecimal_too = false);

}  // namespace touchstone::catalogue
