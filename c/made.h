// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"
#include "robust/c/answered.h"

/// Shared by the functions of touchstone.h.
namespace touchstone::c {

using namespace catalogue;

/// Throws InvalidInput if there is none of that name.
const Operation& operation_named(const char* name);
/// Throws InvalidInput for a null pointer, naming the argument.
std::string text_of(const char* text, const char* argument);
Question question_of(const Operation& operation, const char* text);

/// Prints every number of the catalogue's output with a point or an exponent, so that none reads as an index.
Json with_points(const Shape& shape, const Json& printed);
Json answer_with_points(const Operation& operation, Json printed);

/// A copy that touchstone_free frees.
char* copied(const std::string& text);

/// Stores in *result the text that `make` returns.
template <class Make>
int made(char** result, touchstone_error* error, const Make& make) {
  if (result != nullptr) *result = nullptr;
  return robust::c::answered(error, [&] {
    if (result == nullptr) throw InvalidInput("result", "missing");
    *result = copied(make());
  });
}

}  // namespace touchstone::c
