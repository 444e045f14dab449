// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/uses.h"

namespace touchstone::audit {

/// SHA-256 (FIPS 180-4) of a text, as 64 hexadecimal digits: what `sha256sum` prints.
std::string sha256(const std::string& text);

}  // namespace touchstone::audit
