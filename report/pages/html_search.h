// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"
#include "report/uses.h"

/// Searches in structures over bodies. Results are HTML, empty of an operation or a drawing that has none.
namespace touchstone::report {

/// What the search of a drawing passed, in words, and what its lines mean.
std::string search_caption(const Drawing& drawing);

/// A search for each sort of query, with some bodies to tell apart: the first ones that the families draw.
std::string search_section(const Operation& operation);

}  // namespace touchstone::report
