// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"

namespace touchstone::audit {

/// The version in CMakeLists.txt (a test compares them).
inline constexpr const char* version_number = "0.1.0";

/// The compiler of this build.
#if defined(__clang__)
inline constexpr const char* compiler_name = "clang " __clang_version__;
#else
inline constexpr const char* compiler_name = "g++ " __VERSION__;
#endif

}  // namespace touchstone::audit
