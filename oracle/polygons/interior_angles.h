// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the exact dot and cross product of the two edges at a vertex, from the one on whose left the inside is (by
/// the sign of the area), and MPFR's angle of that vector, rounded down and up with more and more bits until both ends
/// are the same double and less than 2^-60 units in the last place apart. Angles are irrational: pi times a fraction,
/// or else transcendental (Lindemann), so no tie is possible. Margin: the least distance of an angle, in units in the
/// last place, to the nearest tie between doubles (computed from that rational).
template <Exact Number = double>
Truth<std::vector<Rational>> interior_angles(const Polygon2<Number>& polygon);

}  // namespace touchstone::oracle
