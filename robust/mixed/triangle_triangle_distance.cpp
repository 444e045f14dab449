// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/triangle_triangle_distance.h"

#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/solid_distance.h"

namespace touchstone::robust {
namespace {

void validate_triangle_triangle_distance(const Triangle3d& a, const Triangle3d& b) {
  if (kernel::valid(a) && kernel::valid(b)) return;
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
}

}  // namespace

Perhaps<ConvexDistance<double>> stages::triangle_triangle_distance::enclosed(const Triangle3d& a, const Triangle3d& b) {
  return kernel::certain_distance(kernel::core_of(a), kernel::core_of(b));
}

ConvexDistance<double> stages::triangle_triangle_distance::exact(const Triangle3d& a, const Triangle3d& b) {
  return kernel::exact_distance(kernel::core_of(a), kernel::core_of(b));
}

Decided<ConvexDistance<double>> stages::triangle_triangle_distance::ask(const Triangle3d& a, const Triangle3d& b) {
  return in_turn<triangle_triangle_distance, Stage::enclosed, validate_triangle_triangle_distance, Stage::exact>(a, b);
}

ConvexDistance<double> triangle_triangle_distance(const Triangle3d& a, const Triangle3d& b) {
  return stages::triangle_triangle_distance::ask(a, b).answer;
}

}  // namespace touchstone::robust
