// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/geometry/penetration.h>
#include <touchstone/oracle/mixed/penetration.h>

#include <cmath>
#include <stdexcept>

#include "surfaces.h"

/// Answers about the depth of convex solids for engines that give a depth and a direction.
namespace touchstone::depth {

/// direction: of the translation of a. No engine here names the parts of both solids on which the direction rests: they
/// are those of the direction among the deepest ones that is nearest to its own, so that contact, depth and direction
/// alone are judged.
template <class Real>
Penetration<Real> answer(const Mesh<Real>& a, const Mesh<Real>& b, Real radius_a, Real radius_b, Real depth,
                         const Vector3<Real>& direction) {
  if (!std::isfinite(direction.x) || !std::isfinite(direction.y) || !std::isfinite(direction.z))
    throw std::runtime_error("the direction is not finite");
  const auto parts = oracle::as_deep(surfaces::in_double(a), surfaces::in_double(b), radius_a, radius_b,
                                     {direction.x, direction.y, direction.z})
                         .feature;
  const Contact contact = depth > 0 ? Contact::overlapping : depth == 0 ? Contact::touching : Contact::disjoint;
  return {contact, depth, direction, depth * direction, parts};
}

}  // namespace touchstone::depth
