// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"
#include "report/uses.h"

/// Searches in structures over bodies. Results are HTML, empty for an operation or a drawing without any.
namespace touchstone::report {

/// The nodes that the search of a drawing passed, in words, and the meaning of its lines.
std::string search_caption(const Drawing& drawing);

/// A search for each kind of query, with some bodies to distinguish: the first ones that the families draw.
std::string search_section(const Operation& operation);

}  // namespace touchstone::report
