// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace touchstone::catalogue {

/// Makes foreign text safe to print on a terminal: control characters and bytes that are not UTF-8 become \xNN, and
/// text longer than `most` bytes is truncated, with its full length stated.
std::string excerpt(std::string_view text, std::size_t most);

/// The number of bytes printed of an unknown key.
constexpr std::size_t most_of_a_key = 60;

}  // namespace touchstone::catalogue
