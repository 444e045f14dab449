// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/penetration.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/penetration.h"
#include "geometry/validation.h"
#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/minkowski/least_overlap.h"
#include "robust/kernel/shapes/points_in_space.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/kernel/solids/solid_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {
namespace {

using kernel::CoreOverlap;

using Faces = std::vector<kernel::DifferenceFace>;

/// The answer, if the nearest faces of the difference are one, of which no other vertex is certainly part, and all
/// numbers are certain. The vertices are `moderate`.
std::optional<Penetration<double>> enclosed_penetration(const Meshd& a, const Meshd& b, double radius_a,
                                                        double radius_b, const Faces& faces) {
  using namespace kernel;
  if (!rounds_to_nearest() || !filters::moderate(radius_a) || !filters::moderate(radius_b)) return std::nullopt;
  Used of_a, of_b;
  for (const DifferenceFace& face : faces)
    for (const auto& [i, j] : face)
      if (!of_a.add(i) || !of_b.add(j)) return std::nullopt;
  if (of_a.count + of_b.count != 4) return std::nullopt;
  const auto& [p, q, r] = faces[0];
  const auto between = [&](const auto& sum, const Corners& from, const Corners& to) {
    const auto in_a = sum(a.vertices[from.of_a], a.vertices[to.of_a]),
               in_b = sum(b.vertices[from.of_b], b.vertices[to.of_b]);
    return filters::Triple{in_b.x - in_a.x, in_b.y - in_a.y, in_b.z - in_a.z};
  };
  const auto normal = cross(between(filters::sized_between, p, q), between(filters::sized_between, p, r));
  if (!alone(a.vertices, of_a, normal) || !alone(b.vertices, of_b, filters::Triple{-normal.x, -normal.y, -normal.z}))
    return std::nullopt;
  const auto n = cross(between(loose_between, p, q), between(loose_between, p, r));
  const Loose height = dot(n, loose_between(a.vertices[p.of_a], b.vertices[p.of_b])), square = dot(n, n);
  if (!square.settled() || square.high == 0) return std::nullopt;
  const Divisor length(square_root<double>(square));
  const Loose depth = Loose(two_sum(radius_a, radius_b)) + Loose(height / length);
  const auto rounded_depth = rounded(depth);
  if (!rounded_depth) return std::nullopt;
  Vector3d direction, translation;
  const auto along = [&](const Loose& part, double& unit, double& moved) {
    const Loose exact = part / length;
    const auto first = rounded(exact), second = rounded(depth * exact);
    if (first && second) unit = *first, moved = *second;
    return first && second;
  };
  if (!along(n.x, direction.x, translation.x) || !along(n.y, direction.y, translation.y) ||
      !along(n.z, direction.z, translation.z))
    return std::nullopt;
  const auto part = [](const Used& used) { return static_cast<SolidPart>(used.count - 1); };
  return Penetration<double>{Contact::overlapping, *rounded_depth, direction, translation, {part(of_a), part(of_b)}};
}

/// The overlap of the cores; below 0 where they are apart.
CoreOverlap overlap_of_cores(const Meshd& a, const Meshd& b, const std::optional<Faces>& nearest) {
  if (nearest) {
    if (auto least = kernel::least_of_faces(a, b, *nearest)) return std::move(*least);
  }
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
  const auto nearest = kernel::nearest_difference_faces(a, b);
  if (nearest) {
    if (const auto enclosed = enclosed_penetration(a, b, radius_a, radius_b, *nearest)) return *enclosed;
  }
  const CoreOverlap found = overlap_of_cores(a, b, nearest);
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

void validate_radii(double radius_a, double radius_b) {
  validation::validate("radius_a", radius_a, rule::radius), validation::validate("radius_b", radius_b, rule::radius);
}

}  // namespace

Penetration<double> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validation::validate_numbers("radius_a", radius_a), validation::validate_numbers("radius_b", radius_b);
  Stage latest = Stage::filter;
  if (!is_simplex(a)) kernel::validate_convex("a", a, latest);
  if (!is_simplex(b)) kernel::validate_convex("b", b, latest);
  validate_radii(radius_a, radius_b);
  return rounded_penetration(a, b, radius_a, radius_b);
}

Penetration<double> penetration(const ConvexSolid& a, const ConvexSolid& b, double radius_a, double radius_b) {
  validation::validate_numbers("radius_a", radius_a), validation::validate_numbers("radius_b", radius_b);
  validate_radii(radius_a, radius_b);
  return rounded_penetration(a.mesh(), b.mesh(), radius_a, radius_b);
}

}  // namespace touchstone::robust
