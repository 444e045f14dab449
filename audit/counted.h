// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "audit/uses.h"

/// Counts in readable form.
namespace touchstone::audit {

/// 1234567 -> "1,234,567"
std::string grouped(std::uint64_t n);
/// 1234, "case" -> "1,234 cases"
std::string counted(std::uint64_t n, const std::string& noun);

}  // namespace touchstone::audit
