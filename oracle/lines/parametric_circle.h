// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: MPFR's cosine and sine between two neighbours of rising precision, the rest in rationals, until the rounding
/// to binary64 is certain. With u = 0 or radius = 0 the point is exact. Otherwise its coordinates are irrational; each
/// coordinate of the answer is then a rational with the same nearest double (and sign) as the true coordinate, and
/// within 2^-60 of its unit in the last place. Margin: the smaller of the two coordinates' distances, in units in the
/// last place, to the nearest tie between doubles (computed from that rational).
template <Exact Number = double>
Truth<Point2<Rational>> parametric_circle(const Circle2<Number>& circle, const Number& u);

}  // namespace touchstone::oracle
