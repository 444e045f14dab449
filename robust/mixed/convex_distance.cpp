// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/convex_distance.h"

#include "geometry/validation.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/kernel/solids/solid_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {

ConvexDistance<double> convex_distance(const Meshd& a, const Meshd& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  Stage latest = Stage::filter;
  kernel::validate_convex("a", a, latest), kernel::validate_convex("b", b, latest);
  return kernel::distance_of_solids(a, b);
}

ConvexDistance<double> convex_distance(const ConvexSolid& a, const ConvexSolid& b) {
  return kernel::distance_of_solids(a.mesh(), b.mesh());
}

}  // namespace touchstone::robust
