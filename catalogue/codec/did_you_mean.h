// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::catalogue {

/// Returns ` (did you mean "orientation"?)` if a name is a misspelling of one of these, otherwise "". A misspelling has
/// at most a third of its letters wrong, missing, surplus, or swapped with a neighbour; case is ignored, and '-' equals
/// '_'. A name of the same words in another order comes first, then the first of several equally near names; if none is
/// near, the first that begins with these letters, three or more.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);
std::string did_you_mean(std::string_view name, const std::vector<const char*>& known);

}  // namespace touchstone::catalogue
