// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/uses.h"

namespace touchstone::audit {

/// Text as one word of a POSIX shell, on one line, quoted if a shell would not take it literally. The shell drops
/// newlines at its end.
std::string shell_quoted(const std::string& text);

}  // namespace touchstone::audit
