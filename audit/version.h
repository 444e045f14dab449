// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::audit {

/// As CMakeLists.txt has it (a test compares them).
inline constexpr const char* version_number = "0.1.0";

}  // namespace touchstone::audit
