// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace touchstone::catalogue {

/// Text from elsewhere as it may be shown on a terminal: control characters and bytes that are no UTF-8 are written
/// \xNN, and of what is longer than `most` bytes only the beginning is kept, with the full length.
std::string excerpt(std::string_view text, std::size_t most);

/// What is shown of a key that no field has.
constexpr std::size_t most_of_a_key = 60;

}  // namespace touchstone::catalogue
