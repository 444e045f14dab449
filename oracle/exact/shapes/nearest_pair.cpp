// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/nearest_pair.h"

#include <algorithm>
#include <optional>

#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {
namespace {

using Point = Point3<Rational>;
using Vector = Vector3<Rational>;
using Row = std::vector<Integer>;

/// Numerators over one denominator, which is positive.
struct Fractions {
  Row numerators;
  Integer denominator;
};

/// A square system with its right sides in the last column: the solution, or nullopt if it is singular. Fraction-free
/// Gauss-Jordan elimination: the numbers after each step are minors of the system, so that every division is exact.
std::optional<Fractions> solved(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  Integer last = 1;
  for (std::size_t k = 0; k < n; ++k) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(k);
    const auto pivot = std::find_if(from, rows.end(), [k](const Row& row) { return sgn(row[k]) != 0; });
    if (pivot == rows.end()) return std::nullopt;
    std::iter_swap(from, pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      for (std::size_t j = k + 1; j <= n; ++j) {
        const Integer minor = rows[k][k] * rows[i][j] - rows[i][k] * rows[k][j];
        mpz_divexact(rows[i][j].get_mpz_t(), minor.get_mpz_t(), last.get_mpz_t());
      }
    }
    last = rows[k][k];
  }
  Fractions solution{{}, abs(last)};
  for (const Row& row : rows) solution.numerators.push_back(sgn(last) < 0 ? Integer(-row[n]) : row[n]);
  return solution;
}

/// The points of both hulls from the first of a, those of b negated, as integers times one unit.
struct Points {
  std::vector<IntegerVector> of;
  std::size_t of_a;
  Integer units_in_one = 1;
  std::vector<Row> products{};  ///< the scalar product of every two
};

Points points_of(const Hull& a, const Hull& b) {
  std::vector<Vector> from_first;
  for (const Point& p : a) from_first.push_back(p - a[0]);
  for (const Point& p : b) from_first.push_back(a[0] - p);
  Points points{{}, a.size()};
  const auto common = [&](const Rational& number) {
    mpz_lcm(points.units_in_one.get_mpz_t(), points.units_in_one.get_mpz_t(), number.get_den_mpz_t());
  };
  for (const Vector& v : from_first) common(v.x), common(v.y), common(v.z);
  const auto integer = [&](const Rational& number) {
    return Integer(number.get_num() * Integer(points.units_in_one / number.get_den()));
  };
  for (const Vector& v : from_first) points.of.push_back({integer(v.x), integer(v.y), integer(v.z)});
  for (const IntegerVector& p : points.of) {
    Row& row = points.products.emplace_back();
    for (const IntegerVector& q : points.of) row.push_back(dot(p, q));
  }
  return points;
}

/// The points that may have a weight.
struct Support {
  std::vector<std::size_t> places;
  std::size_t of_a = 0;
};

Support support_of(const Points& points, unsigned chosen) {
  Support support;
  for (std::size_t i = 0; i < points.of.size(); ++i) {
    if ((chosen >> i & 1U) == 0) continue;
    support.places.push_back(i);
    support.of_a += static_cast<std::size_t>(i < points.of_a);
  }
  return support;
}

/// A weight for every point. With w the sum of weights times points: all points of a that may have a weight have the
/// same scalar product with w, and so do those of b; both sums of weights are 1.
std::optional<Fractions> weights(const Points& points, const Support& support) {
  const std::size_t n = support.places.size();
  std::vector<Row> rows(n + 2, Row(n + 3));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t side = i < support.of_a ? n : n + 1;
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = points.products[support.places[i]][support.places[j]];
    rows[i][side] = -1;
    rows[side][i] = 1;
  }
  rows[n][n + 2] = rows[n + 1][n + 2] = 1;
  std::optional<Fractions> found = solved(std::move(rows));
  if (!found) return std::nullopt;
  Row each(points.of.size());
  for (std::size_t i = 0; i < n; ++i) each[support.places[i]] = found->numerators[i];
  found->numerators = std::move(each);
  return found;
}

/// The points first <= i < last times their weights, in the unit over the denominator of the weights.
IntegerVector combination(const Points& points, const Fractions& weights, std::size_t first, std::size_t last) {
  IntegerVector sum{0, 0, 0};
  for (std::size_t i = first; i < last; ++i) sum = sum + weights.numerators[i] * points.of[i];
  return sum;
}

/// True if x, in the unit over a denominator, has the smallest scalar product with w of the points first <= i < last.
bool is_first(const IntegerVector& x, const Integer& denominator, const Points& points, std::size_t first,
              std::size_t last, const IntegerVector& w) {
  const Integer least = dot(w, x);
  for (std::size_t i = first; i < last; ++i)
    if (denominator * dot(w, points.of[i]) < least) return false;
  return true;
}

}  // namespace

Point nearest_to(const Point& point, const Hull& a, const Hull& b, const Point& on_a, const Vector& displacement) {
  const Vector v = a[1] - a[0], w = b[1] - b[0], across = cross(v, w);
  const Rational length = dot(v, v);
  if (sgn(length) == 0 || sgn(dot(across, across)) != 0) return on_a;
  // All are on the line of a, between the ends of a and of b.
  const auto along = [&](const Vector& from_a) { return Rational(dot(from_a, v) / length); };
  const Rational first = along((b[0] - a[0]) - displacement), second = along((b[1] - a[0]) - displacement);
  const Rational low = std::max(Rational(0), std::min(first, second)),
                 high = std::min(Rational(1), std::max(first, second));
  return a[0] + std::min(std::max(along(point - a[0]), low), high) * v;
}

NearestPair nearest_pair(const Hull& a, const Hull& b) {
  const Points points = points_of(a, b);
  const std::size_t of_a = a.size(), all = points.of.size();
  std::optional<NearestPair> nearest;
  for (unsigned chosen = 1; chosen < 1U << all; ++chosen) {
    const Support support = support_of(points, chosen);
    if (support.of_a == 0 || support.of_a == support.places.size()) continue;
    const std::optional<Fractions> found = weights(points, support);
    if (!found) continue;
    const auto& [numerators, denominator] = *found;
    if (std::any_of(numerators.begin(), numerators.end(), [](const Integer& weight) { return sgn(weight) < 0; }))
      continue;
    // b is negated, so w = x - y is a sum.
    const IntegerVector x = combination(points, *found, 0, of_a), minus_y = combination(points, *found, of_a, all),
                        w = x + minus_y;
    if (!is_first(x, denominator, points, 0, of_a, w) || !is_first(minus_y, denominator, points, of_a, all, w))
      continue;
    std::vector<Rational> each;
    for (const Integer& weight : numerators) each.push_back(quotient(weight, denominator));
    if (nearest && each[0] <= nearest->weights_of_a[0]) continue;
    const auto middle = each.begin() + static_cast<std::ptrdiff_t>(of_a);
    const Integer unit = denominator * points.units_in_one;
    const auto actual = [&](const IntegerVector& v) {
      return Vector{quotient(v.x, unit), quotient(v.y, unit), quotient(v.z, unit)};
    };
    nearest = NearestPair{a[0] + actual(x),
                          a[0] + actual(Integer(-1) * minus_y),
                          {each.begin(), middle},
                          {middle, each.end()},
                          quotient(dot(w, w), Integer(unit * unit))};
    if (of_a == 1 || all - of_a == 1) break;  // in a convex set the point nearest to another is unique
  }
  return *nearest;
}

}  // namespace touchstone::oracle
