// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/certificates/check_reading.h"

/// Shared by the checks of convex solids that move along straight lines.
namespace touchstone::certify {

using Coordinates = std::vector<Rational>;

Rational dot(const Coordinates& p, const Coordinates& q);

/// A convex solid, reduced to what a claim needs.
struct Solid {
  virtual ~Solid() = default;
  virtual bool holds(const Coordinates& p) const = 0;
  /// The greatest value of normal . p.
  virtual Rational highest(const Coordinates& normal) const = 0;
  Rational lowest(Coordinates normal) const;
};

/// Checks the truth, `relation` and `t`, for a moving with that velocity while b rests.
///
/// start: `point` is in both, t is 0. first_contact: `point` minus t velocity is in a, the point in b, 0 < t <= 1;
/// along `normal` a ends at t no higher than where b begins, and rises with t: before, it was lower, so nothing was
/// common. separating_axis: along `normal` a ends below where b begins at t = 0 and at t = 1, and so in between.
void prove_first_contact(const Claim& claim, const Solid& a, const Solid& b, const Coordinates& velocity);

}  // namespace touchstone::certify
