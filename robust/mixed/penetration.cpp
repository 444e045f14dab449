// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/penetration.h"

#include <cstdint>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/shapes/points_in_space.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/kernel/solids/least_overlap.h"
#include "robust/kernel/solids/solid_distance.h"

namespace touchstone::robust {
namespace {

using kernel::CoreOverlap;

/// The overlap of the cores; below 0 where they are apart.
CoreOverlap overlap_of_cores(const Meshd& a, const Meshd& b) {
  kernel::Separation apart = kernel::separation_of_solids(a, b);
  if (apart.of_a.empty()) return kernel::least_overlap(a, b);
  const auto& [x, y, z] = apart.displacement;
  mpz_class height = -(x * x + y * y + z * z);
  return {apart.displacement, std::move(height), apart.total, apart.exponent, apart.of_a, apart.of_b};
}

SolidPart part_of(const Meshd& mesh, const std::vector<Index>& level) {
  Polygon3d named;
  for (const Index i : level) named.vertices.push_back(mesh.vertices[i]);
  const auto at = kernel::integers_of(named).at;
  const auto zero = [](const Vector3<mpz_class>& v) { return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0; };
  SolidPart part = SolidPart::vertex;
  Vector3<mpz_class> edge;
  for (const auto& p : at) {
    const Vector3<mpz_class> span = p - at[0];
    if (zero(span)) continue;
    if (part == SolidPart::vertex) edge = span, part = SolidPart::edge;
    else if (!zero(cross(edge, span))) return SolidPart::face;
  }
  return part;
}

/// The cores overlap by h / (t |n|), times a power of two like the sum R of the radii: the depth is R plus that, and so
/// (R t q + h sqrt(q)) / (t q), q being the square of n; and the translation that times n / |n|.
Penetration<double> rounded_penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
  const CoreOverlap found = overlap_of_cores(a, b);
  auto radii = kernel::integers_of(radius_a, radius_b);
  mpz_class reach = radii.at[0] + radii.at[1], height = found.height;
  int exponent = found.exponent;
  if (sgn(reach) != 0 && sgn(height) != 0) exponent = std::min(exponent, radii.exponent);
  else if (sgn(reach) != 0) exponent = radii.exponent;
  if (sgn(height) != 0) height <<= static_cast<std::uint64_t>(found.exponent - exponent);
  if (sgn(reach) != 0) reach <<= static_cast<std::uint64_t>(radii.exponent - exponent);
  const auto& n = found.direction;
  const mpz_class square = dot(n, n), whole = found.total * square, of_reach = reach * whole,
                  under_root = height * height * square, across = reach * found.total;
  const int side = sgn(height) < 0 ? -1 : 1, sign = kernel::sign_with_root(of_reach, side, under_root);
  const auto unit = [&](const mpz_class& k) {
    return kernel::with_sign(kernel::round_square_root(mpz_class(k * k), square), sgn(k));
  };
  const auto moved = [&](const mpz_class& k) {
    const mpz_class of_radii = across * k;
    return kernel::round_quadratic_root(mpz_class(k * height), sgn(k) < 0 ? -1 : 1,
                                        mpz_class(of_radii * of_radii * square), whole, exponent);
  };
  return {sign > 0    ? Contact::overlapping
          : sign == 0 ? Contact::touching
                      : Contact::disjoint,
          kernel::round_quadratic_root(of_reach, side, under_root, whole, exponent),
          {unit(n.x), unit(n.y), unit(n.z)},
          {moved(n.x), moved(n.y), moved(n.z)},
          {part_of(a, found.of_a), part_of(b, found.of_b)}};
}

}  // namespace

Penetration<double> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validation::validate_numbers("radius_a", radius_a), validation::validate_numbers("radius_b", radius_b);
  Stage latest = Stage::filter;
  kernel::validate_convex("a", a, latest), kernel::validate_convex("b", b, latest);
  validation::validate("radius_a", radius_a, rule::radius), validation::validate("radius_b", radius_b, rule::radius);
  return rounded_penetration(a, b, radius_a, radius_b);
}

}  // namespace touchstone::robust
