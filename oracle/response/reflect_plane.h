// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: v put together again from its products with three vectors at right angles, the normal among them: that one
/// with the opposite sign. Nothing is decided: there is no margin.
///
/// Certificate: "decomposition": the parts of v, `along` the normal and `across` it.
template <Exact Number = double>
Truth<Vector3<Rational>> reflect_plane(const Vector3<Number>& velocity, const Vector3<Number>& normal);

}  // namespace touchstone::oracle
