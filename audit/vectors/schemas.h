// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

/// JSON Schemas (draft 2020-12) of the lines of vectors.
namespace touchstone::audit {

inline constexpr int vector_version = 1;
inline constexpr std::size_t digits_of_id = 10;  ///< after the name of the operation, hexadecimal
/// The family of vectors with numbers that are not all finite; it is separate from the families, which have no such
/// numbers.
inline constexpr const char* not_finite_family = "not_finite";

/// The family of vectors that were found in recorded calls.
inline constexpr const char* recorded_family = "recorded";

/// The members of every line, with every flag explained.
Json vector_schema();

/// A line of one operation, strictly: no other fields, its own enumerators and families, numbers only in the forms that
/// are written. For a certificate it states how facts are written; the checkers define which facts exist. `recorded`:
/// for vectors from recorded calls.
Json vector_schema(const Operation& operation, bool recorded = false);

}  // namespace touchstone::audit
