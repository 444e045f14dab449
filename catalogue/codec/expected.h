// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/shape/shape.h"

/// Error messages that state a rule as expectation and fact.
namespace touchstone::catalogue {

/// Returns `expected a number, got "x"`; a long value is truncated.
std::string expected(const std::string& what, const Json& got);

/// Returns `no such field (did you mean "side"?); expected side`.
std::string no_such_field(const std::string& key, const std::vector<const char*>& names);

/// The system's text for an error number, as the end of a sentence: "no such file or directory".
std::string why_of(int error);

/// An example of a shape: 0 for numbers, one element in each list, nothing optional; of an enumeration all enumerators,
/// as "left | on | right".
Json example_of(const Shape& shape);

}  // namespace touchstone::catalogue
