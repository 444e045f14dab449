// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/polygon_normal.h"

#include <cstdint>

#include "geometry/validation.h"
#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/points_in_space.h"

namespace touchstone::robust {
namespace {

struct Numbers {
  kernel::Two normal_xy, unit_xy, zs;

  PolygonNormal<double> answer() const {
    return {NormalClass::proper, Vector3d{normal_xy.first(), normal_xy.second(), zs.first()},
            Vector3d{unit_xy.first(), unit_xy.second(), zs.second()}};
  }
};

/// The stage `enclosed`, inlined where an answer is made of its numbers: constructed out of place and copied it would
/// cost more.
///
/// Takes two triangles of the fan around vertex 0 at a time: with a, b, c three vertices relative to it, a x b + b x c
/// = b x (c - a). If the last triangle is alone, c is vertex 0. Not proved by machine: the errors that sum_of_squares
/// carries over.
[[gnu::always_inline]] inline std::optional<Numbers> enclosed_numbers(const Polygon3d& polygon) {
  using namespace kernel;
  const std::size_t n = polygon.size();
  if (validation::fewer_than_three(polygon.vertices) || n > 1 << 12 || !rounds_to_nearest()) return std::nullopt;
  const Point3d& hub = polygon[0];
  const auto xy = [](const Point3d& p) { return Two(p.x, p.y); };
  Window window(xy(hub));
  window.add(xy(polygon[1])).add(Two(hub.z, polygon[1].z));
  struct Terms {
    Term2<Two> plus_xy, minus_xy, z;
  };
  const auto terms = [&](std::size_t i) __attribute__((always_inline)) {
    const Point3d &a = polygon[i], &b = polygon[i + 1], &c = polygon.next(i + 1);
    const Two of_b = xy(b), of_c = xy(c), zs(b.z, c.z);
    window.add(of_b).add(of_c).add(zs);
    const Factor<Two> p = vector_between(xy(hub), of_b), q = vector_between(xy(a), of_c),
                      z = vector_between(Two(hub.z, a.z), zs);
    // p and q as three lanes each: (x, y) and z, the z of both in one pair.
    return Terms{product(both(second(p), first(z)), both(second(z), first(q))),
                 product(both(first(z), first(p)), both(second(q), second(z))), product(p, swapped(q))};
  };
  const Terms start = terms(1);
  Sum<Two> sum_xy(start.plus_xy);
  Sum<double> sum_z(first(start.z));
  sum_xy -= start.minus_xy, sum_z -= second(start.z);
  for (std::size_t i = 3; i + 1 < n; i += 2) {
    const Terms next = terms(i);
    sum_xy += next.plus_xy, sum_xy -= next.minus_xy;
    sum_z += first(next.z), sum_z -= second(next.z);
  }
  if (!window.holds()) return std::nullopt;
  const Enclosed<Two> nxy = sum_xy.value();
  const Enclosed<double> nz = sum_z.value();
  if (!nxy.settled() || !nz.settled()) return std::nullopt;
  const Enclosed<double> square = sum_of_squares(nxy, nz);
  if (!square.settled() || square.high == 0) return std::nullopt;
  const Divisor length(square_root(twice(square)));
  const auto normal_xy = rounded(nxy), unit_xy = rounded(nxy / length);
  const auto zs = rounded(both(nz, first(twice(nz) / length)));
  if (!normal_xy || !unit_xy || !zs) return std::nullopt;
  return Numbers{*normal_xy, *unit_xy, *zs};
}

}  // namespace

Perhaps<PolygonNormal<double>> stages::polygon_normal::enclosed(const Polygon3d& polygon) {
  if (const auto numbers = enclosed_numbers(polygon)) return numbers->answer();
  return std::nullopt;
}

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

double rounded(const kernel::Int192& n, std::int64_t exponent) { return kernel::round_quotient(n, 1, exponent); }
double rounded(const mpz_class& n, std::int64_t exponent) { return kernel::round_scaled(n, exponent); }

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
  const std::int64_t exponent = 2 * points.exponent;
  return {NormalClass::proper, Vector3d{rounded(sum.x, exponent), rounded(sum.y, exponent), rounded(sum.z, exponent)},
          Vector3d{unit(x), unit(y), unit(z)}};
}

void validate_polygon_normal(const Polygon3d& polygon) { validation::validate("polygon", polygon); }

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
  return in_turn<polygon_normal, Stage::enclosed, validate_polygon_normal, Stage::lattice, Stage::exact>(polygon);
}

PolygonNormal<double> polygon_normal(const Polygon3d& polygon) {
  if (const auto numbers = enclosed_numbers(polygon)) return numbers->answer();
  return answer_in_turn<stages::polygon_normal, validate_polygon_normal, Stage::lattice, Stage::exact>(polygon);
}

}  // namespace touchstone::robust
