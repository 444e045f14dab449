// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/capsule_triangle.h"

#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_capsule_triangle(const Capsule3d& capsule, const Triangle3d& triangle) {
  if (kernel::valid(capsule) && kernel::valid(triangle)) return;
  validation::validate_all("capsule", capsule, "triangle", triangle);
}

}  // namespace

Perhaps<Contact> stages::capsule_triangle::filter(const Capsule3d& capsule, const Triangle3d& triangle) {
  const auto& [p, q] = capsule.segment;
  const auto& [a, b, c] = triangle;
  const double r = capsule.radius;
  if (kernel::sign_bit(r)) return std::nullopt;  // -0.0, or negative, which validation refuses
  if (!(filters::moderate(capsule.segment) & filters::moderate(triangle) & filters::moderate(r))) return std::nullopt;
  return filters::Differences<3, 0, true>{{p - q, b - a, c - a}, p - a}.contact(r);
}

/// No distance is less than the radius 0 of a segment, so that its lack of an interior needs no special case.
Contact stages::capsule_triangle::exact(const Capsule3d& capsule, const Triangle3d& triangle) {
  using namespace kernel;
  const auto& [p, q] = capsule.segment;
  const auto& [a, b, c] = triangle;
  const auto [at, exponent] = integer_points(p, q, a, b, c, Point3d{capsule.radius, 0, 0});
  return contact(squared_distance({at[0], at[1]}, Triangle3<mpz_class>{at[2], at[3], at[4]}), at[5].x, true);
}

Decided<Contact> stages::capsule_triangle::ask(const Capsule3d& capsule, const Triangle3d& triangle) {
  return in_turn<capsule_triangle, Stage::filter, validate_capsule_triangle, Stage::exact>(capsule, triangle);
}

Contact capsule_triangle(const Capsule3d& capsule, const Triangle3d& triangle) {
  return stages::capsule_triangle::ask(capsule, triangle).answer;
}

}  // namespace touchstone::robust
