// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace touchstone::proptests {

/// Compares a text with the file of that path below proptests/infrastructure, and names the first line that differs.
/// With TOUCHSTONE_WRITE_GOLDEN=1 in the environment the file is written anew, to be looked at.
void check_golden(const std::string& file, const std::string& text);

}  // namespace touchstone::proptests
