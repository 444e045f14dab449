// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/obb_of_points.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/shapes/box_around.h"
#include "oracle/exact/shapes/whole_cloud.h"

namespace touchstone::oracle {
namespace {

using Displacement = Vector3<Integer>;
using Matrix = std::array<std::array<Integer, 3>, 3>;

template <class Number>
IntegerCloud validated_obb_of_points(const std::vector<Point3<Number>>& points) {
  validation::validate("points", points, rule::points);
  return IntegerCloud(points);
}

std::array<Integer, 3> parts(const Displacement& v) { return {v.x, v.y, v.z}; }

/// n^2 times the covariance.
Matrix covariance(const IntegerCloud& cloud) {
  const Integer n = cloud.size();
  Displacement sum{0, 0, 0};
  for (const auto& p : cloud.points) sum = sum + Displacement{p.x, p.y, p.z};
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      Integer products = 0;
      for (const auto& p : cloud.points) products += parts({p.x, p.y, p.z})[i] * parts({p.x, p.y, p.z})[j];
      result[i][j] = n * products - parts(sum)[i] * parts(sum)[j];
    }
  return result;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

/// The fraction with the least denominator from low to high, 0 <= low < high: by continued fractions.
Rational simplest(const Rational& low, const Rational& high) {
  const Integer floor = low.get_num() / low.get_den();
  if (low == floor) return Rational(floor);
  if (high >= floor + 1) return Rational(floor + 1);
  return Rational(floor + 1 / simplest(Rational(1 / Rational(high - floor)), Rational(1 / Rational(low - floor))));
}

/// Approximates the direction of a nonzero vector by small integers; exact if it has small ones.
Displacement shortened(const Displacement& v) {
  const std::array<Integer, 3> part = parts(v);
  const Integer greatest = std::max({Integer(abs(v.x)), Integer(abs(v.y)), Integer(abs(v.z))});
  const Rational near = scaled(Rational(1), -10);
  std::array<Rational, 3> share;
  Integer together = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    Rational size(abs(part[i]), greatest);
    size.canonicalize();
    share[i] = simplest(size > near ? Rational(size - near) : Rational(0), Rational(size + near));
    mpz_lcm(together.get_mpz_t(), together.get_mpz_t(), share[i].get_den_mpz_t());
  }
  const auto integer = [&](std::size_t i) {
    const Rational number(share[i] * together);
    return sgn(part[i]) < 0 ? Integer(-number.get_num()) : number.get_num();
  };
  return {integer(0), integer(1), integer(2)};
}

/// Divides by the common factor.
Displacement primitive(const Displacement& v) {
  Integer common = gcd(Integer(gcd(v.x, v.y)), v.z);
  return {Integer(v.x / common), Integer(v.y / common), Integer(v.z / common)};
}

/// The direction that a nonzero symmetric matrix without negative eigenvalues stretches the most.
Displacement greatest_stretch(Matrix m) {
  for (int time = 0; time < 12; ++time) {
    m = product(m, m);
    std::size_t bits = 0;
    for (const auto& row : m)
      for (const Integer& each : row) bits = std::max(bits, mpz_sizeinbase(each.get_mpz_t(), 2));
    if (bits <= 256) continue;
    for (auto& row : m)
      for (Integer& each : row) each >>= bits - 256;
  }
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (m[i][i] > m[k][k]) k = i;
  return shortened({m[0][k], m[1][k], m[2][k]});
}

/// n . n times the part of a vector perpendicular to n.
Displacement across(const Displacement& n, const Displacement& v) { return dot(n, n) * v - dot(n, v) * n; }

/// Some nonzero vector perpendicular to n.
Displacement beside(const Displacement& n) {
  const Integer x = abs(n.x), y = abs(n.y), z = abs(n.z);
  if (x <= y && x <= z) return cross(n, Displacement{1, 0, 0});
  return y <= z ? cross(n, Displacement{0, 1, 0}) : cross(n, Displacement{0, 0, 1});
}

/// The same for n, near v if that is possible.
Displacement beside(const Displacement& n, const Displacement& v) {
  const Displacement found = across(n, v);
  return zero(found) ? beside(n) : found;
}

/// Perpendicular axes, none of them 0.
std::array<Displacement, 3> axes_of(const IntegerCloud& cloud) {
  const auto with = [](const Displacement& one, const Displacement& other) -> std::array<Displacement, 3> {
    const Displacement a = primitive(one), b = primitive(other);
    return {a, b, primitive(cross(a, b))};
  };
  const std::vector<Index> span = cloud.simplex();
  if (span.size() == 1) return {Displacement{1, 0, 0}, Displacement{0, 1, 0}, Displacement{0, 0, 1}};
  if (span.size() == 2) {
    const Displacement along = cloud.between(span[0], span[1]);
    return with(along, beside(along));
  }
  const Matrix spread = covariance(cloud);
  const Displacement first = greatest_stretch(spread);
  if (span.size() == 3) {
    const Displacement normal = primitive(cloud.normal(span[0], span[1], span[2])), along = beside(normal, first);
    return with(along, cross(normal, along));
  }
  Matrix project;
  const Integer square = dot(first, first);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      project[i][j] = (i == j ? square : Integer(0)) - parts(first)[i] * parts(first)[j];
  return with(first, beside(first, greatest_stretch(product(project, product(spread, project)))));
}

/// The ends along one axis.
struct Ends {
  std::size_t least = 0, most = 0;  ///< indices of points
  Integer low, high;
  Ends(const IntegerCloud& cloud, const Displacement& axis) : low(cloud.along(axis, 0)), high(low) {
    for (Index i = 1; i < cloud.size(); ++i) {
      const Integer at = cloud.along(axis, i);
      if (at < low) low = at, least = i;
      if (at > high) high = at, most = i;
    }
  }
};

Truth<Obb3<Rational>> box_around(const IntegerCloud& cloud) {
  const std::array<Displacement, 3> axes = axes_of(cloud);
  Point3<Rational> center{0, 0, 0};
  std::array<Vector3<Rational>, 3> half_axes;
  std::vector<std::size_t> least, most;
  for (std::size_t k = 0; k < 3; ++k) {
    const Ends ends(cloud, axes[k]);
    if (ends.low != ends.high) least.push_back(ends.least), most.push_back(ends.most);
    const Vector3<Rational> axis{axes[k].x, axes[k].y, axes[k].z};
    const Rational part(cloud.unit / Rational(2 * dot(axes[k], axes[k])));
    center = center + Rational((ends.low + ends.high) * part) * axis;
    half_axes[k] = Rational((ends.high - ends.low) * part) * axis;
  }
  return {{center, {half_axes[0], half_axes[1], half_axes[2]}},
          std::nullopt,
          [least = std::move(least), most = std::move(most)] {
            return Certificate{"touched_faces",
                               {{"least", {least.begin(), least.end()}}, {"most", {most.begin(), most.end()}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<Obb3<Rational>> obb_of_points(const std::vector<Point3<Number>>& points) {
  return box_around(validated_obb_of_points(points));
}
template Truth<Obb3<Rational>> obb_of_points(const std::vector<Point3d>&);
template Truth<Obb3<Rational>> obb_of_points(const std::vector<Point3<Rational>>&);

std::string obb_of_points_defect(const std::vector<Point3d>& points, const Obb3<Rational>& box) {
  return defect_of_box(points, box);
}
std::string obb_of_points_defect(const std::vector<Point3d>& points, const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  const auto finite = [](const auto& p) {
    return validation::finite(p.x) && validation::finite(p.y) && validation::finite(p.z);
  };
  if (!finite(box.center)) return "the center is not finite";
  if (!finite(u) || !finite(v) || !finite(w)) return "a half axis is not finite";
  const auto exactly = [](const Vector3d& a) { return Vector3<Rational>{exact(a.x), exact(a.y), exact(a.z)}; };
  return defect_of_box(points, {exact(box.center), {exactly(u), exactly(v), exactly(w)}});
}

}  // namespace touchstone::oracle
