// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/polygon_normal.h"

#include "geometry/validation.h"
#include "robust/kernel/plane.h"
#include "robust/kernel/points_in_space.h"
#include "robust/stages/planes/polygon_normal.h"

namespace touchstone::robust {
namespace {

kernel::Int192 multiply(std::int64_t a, std::int64_t b) { return kernel::multiply(kernel::Int128{a}, b); }
mpz_class multiply(const mpz_class& a, const mpz_class& b) { return a * b; }

const mpz_class& integer_of(const mpz_class& n) { return n; }
mpz_class integer_of(const kernel::Int192& n) {
  const bool negative = kernel::sign_of(n) < 0;
  const kernel::Int192 size = negative ? -n : n;
  mpz_class result;
  mpz_import(result.get_mpz_t(), size.limb.size(), -1, sizeof(size.limb[0]), 0, 0, size.limb.data());
  return negative ? mpz_class(-result) : result;
}

double rounded(const kernel::Int192& n, long exponent) { return kernel::round_quotient(n, 1, exponent); }
double rounded(const mpz_class& n, long exponent) { return kernel::round_scaled(n, exponent); }

/// Newell's sum: the areas under the edges, seen along each axis.
template <class Integer>
Vector3<kernel::Third<Integer>> newell_sum(const std::vector<Point3<Integer>>& ring) {
  Vector3<kernel::Third<Integer>> sum{};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point3<Integer>&p = ring[i], &q = ring[i + 1 == ring.size() ? 0 : i + 1];
    sum.x = sum.x + multiply(Integer(p.y - q.y), Integer(p.z + q.z));
    sum.y = sum.y + multiply(Integer(p.z - q.z), Integer(p.x + q.x));
    sum.z = sum.z + multiply(Integer(p.x - q.x), Integer(p.y + q.y));
  }
  return sum;
}

template <class Integer>
PolygonNormal<double> answer_of(const kernel::ScaledPoints<Integer>& points) {
  const auto sum = newell_sum(points.at);
  const mpz_class x = integer_of(sum.x), y = integer_of(sum.y), z = integer_of(sum.z);
  const mpz_class squared_length = x * x + y * y + z * z;
  if (sgn(squared_length) == 0) return {NormalClass::degenerate, std::nullopt, std::nullopt};
  const auto unit = [&](const mpz_class& n) {
    return kernel::with_sign(kernel::round_square_root(n * n, squared_length), sgn(n));
  };
  const long exponent = 2L * points.exponent;
  return {NormalClass::proper, Vector3d{rounded(sum.x, exponent), rounded(sum.y, exponent), rounded(sum.z, exponent)},
          Vector3d{unit(x), unit(y), unit(z)}};
}

void validate(const Polygon3d& polygon) { validation::validate("polygon", polygon); }

}  // namespace

Perhaps<PolygonNormal<double>> stages::polygon_normal::lattice(const Polygon3d& polygon) {
  const auto points = kernel::lattice_of(polygon);
  if (!points) return std::nullopt;
  return answer_of(*points);
}

PolygonNormal<double> stages::polygon_normal::exact(const Polygon3d& polygon) {
  return answer_of(kernel::integers_of(polygon));
}

Decided<PolygonNormal<double>> stages::polygon_normal::ask(const Polygon3d& polygon) {
  return in_turn<polygon_normal, validate, Stage::lattice, Stage::exact>(polygon);
}

PolygonNormal<double> polygon_normal(const Polygon3d& polygon) { return stages::polygon_normal::ask(polygon).answer; }

}  // namespace touchstone::robust
