// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/shape/shape.h"

/// Rules as expectation and fact.
namespace touchstone::catalogue {

/// `expected a number, got "x"`; of a long value the beginning.
std::string expected(const std::string& what, const Json& got);

/// `no such field (did you mean "side"?); expected side`
std::string no_such_field(const std::string& key, const std::vector<const char*>& names);

/// What the system says of an error number, as the end of a sentence: "no such file or directory".
std::string why_of(int error);

/// A value of that shape: the first enumerator of each, 0 for numbers, one element in each list, nothing optional.
Json example_of(const Shape& shape);

}  // namespace touchstone::catalogue
