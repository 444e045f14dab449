// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace touchstone::report {

/// A formula of a contract, given as plain text, in MathML: `v1' = v1 - 2 m2 / (m1 + m2) c n`. A `/` divides the part
/// before it in the same product by the one factor after it; `a . b` and `a x b` are products of vectors; a short name
/// such as `m1` or `ta` has an index, and so has `a.min`. Empty if the text is not a formula, such as prose.
std::optional<std::string> formula_in_mathml(const std::string& text);

}  // namespace touchstone::report
