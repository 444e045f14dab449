// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::catalogue {

/// ` (did you mean "orientation"?)` where a name is a misspelling of one of these; else empty. A misspelling has at
/// most a third of its letters wrong, missing, too many, or swapped with a neighbour; small and capital letters, '-'
/// and '_' are alike. Of several equally near the first is named; where none is near, the first that begins with these
/// letters, three or more.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);
std::string did_you_mean(std::string_view name, const std::vector<const char*>& known);

}  // namespace touchstone::catalogue
