// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/codec/json.h"

namespace touchstone::catalogue {

/// Parses the text of a file as parse_line does. Reports text that is not JSON with line and column, both from 1; a
/// column is a byte.
Json parse_document(const std::string& text);

}  // namespace touchstone::catalogue
