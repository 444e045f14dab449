// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

namespace touchstone::report {

/// The square root, to 256 bits.
inline mpq_class root(const mpq_class& square) { return mpq_class(mpf_class(sqrt(mpf_class(square, 256)))); }

}  // namespace touchstone::report
