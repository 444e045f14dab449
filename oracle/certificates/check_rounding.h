// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

/// Requires for the irrational true number called `name` in [low, high] that the claimed one is also there, rounds to
/// the same double, with the same sign, and is within 2^-60 units in the last place.
void expect_rounds_alike(const std::string& name, const Rational& claimed, const Rational& low, const Rational& high);

}  // namespace touchstone::certify
