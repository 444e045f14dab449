// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/uses.h"

namespace touchstone::audit {

/// Text as one word of a POSIX shell, on one line, quoted where a shell would not take it as it stands. Of newlines at
/// its end the shell keeps none.
std::string shell_quoted(const std::string& text);

}  // namespace touchstone::audit
