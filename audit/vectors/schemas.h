// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

/// JSON Schemas (draft 2020-12) of the lines of vectors.
namespace touchstone::audit {

inline constexpr int vector_version = 1;
inline constexpr std::size_t digits_of_id = 10;  ///< after the name of the operation, hexadecimal
/// The family of vectors whose numbers are not all finite; it stands next to the families, which hold no such numbers.
inline constexpr const char* not_finite_family = "not_finite";

/// The family of vectors that were found in recorded calls.
inline constexpr const char* recorded_family = "recorded";

/// What every line has, with every flag explained.
Json vector_schema();

/// A line of one operation, strictly: no other fields, its own words and families, numbers only in the forms that are
/// written. Of a certificate it says how facts are written; which there are is the checkers' to know.
/// `recorded`: of vectors from recorded calls.
Json vector_schema(const Operation& operation, bool recorded = false);

}  // namespace touchstone::audit
