// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <vector>

#include "geometry/bodies.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Impulses of a connected set of contacts, as in contact_system.h, of rational numbers; `bounce` is 1 + e. No contact
/// separates, so that such impulses exist. Time: a guess in doubles and, if it is right, one exact solution of sparse
/// equations.
std::vector<mpq_class> impulses_of(const std::vector<PointBody<mpq_class>>& bodies,
                                   const std::vector<BodyContact<mpq_class>>& contacts, const mpq_class& bounce);

}  // namespace touchstone::robust::kernel
