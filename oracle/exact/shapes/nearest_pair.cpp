// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/nearest_pair.h"

#include <algorithm>
#include <optional>
#include <utility>

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

template <class Chosen>
Support support_of(const Points& points, const Chosen& chosen) {
  Support support;
  for (std::size_t i = 0; i < points.of.size(); ++i) {
    if (!chosen(i)) continue;
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

/// The first of the points from <= i < to with the least scalar product with w, if that is less than that of x, which
/// is in the unit over a denominator.
std::optional<std::size_t> nearer_than(const IntegerVector& x, const Integer& denominator, const Points& points,
                                       std::size_t from, std::size_t to, const IntegerVector& w) {
  std::optional<std::size_t> nearest;
  Integer least = dot(w, x);
  for (std::size_t i = from; i < to; ++i) {
    const Integer here = denominator * dot(w, points.of[i]);
    if (here < least) nearest = i, least = here;
  }
  return nearest;
}

/// The points that weights give, and w.
struct Weighted {
  IntegerVector x, minus_y, w;  ///< b is negated, so w = x - y is a sum
  const Points& points;
  const Fractions& weights;

  Weighted(const Points& all, const Fractions& each)
      : x(combination(all, each, 0, all.of_a)),
        minus_y(combination(all, each, all.of_a, all.of.size())),
        w(x + minus_y),
        points(all),
        weights(each) {}

  /// A point that is nearer to the other hull than x or y are: one of a, or, if a has none, of b.
  std::optional<std::size_t> nearer() const {
    const auto of_a = nearer_than(x, weights.denominator, points, 0, points.of_a, w);
    return of_a ? of_a : nearer_than(minus_y, weights.denominator, points, points.of_a, points.of.size(), w);
  }

  NearestPair pair(const Point& first_of_a) const {
    std::vector<Rational> each;
    for (const Integer& weight : weights.numerators) each.push_back(quotient(weight, weights.denominator));
    const auto middle = each.begin() + static_cast<std::ptrdiff_t>(points.of_a);
    const Integer unit = weights.denominator * points.units_in_one;
    const auto actual = [&](const IntegerVector& v) {
      return Vector{quotient(v.x, unit), quotient(v.y, unit), quotient(v.z, unit)};
    };
    return {first_of_a + actual(x),
            first_of_a + actual(Integer(-1) * minus_y),
            {each.begin(), middle},
            {middle, each.end()},
            quotient(dot(w, w), Integer(unit * unit))};
  }
};

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
    const Support support = support_of(points, [chosen](std::size_t i) { return (chosen >> i & 1U) != 0; });
    if (support.of_a == 0 || support.of_a == support.places.size()) continue;
    const std::optional<Fractions> found = weights(points, support);
    if (!found) continue;
    if (std::any_of(found->numerators.begin(), found->numerators.end(), [](const auto& n) { return sgn(n) < 0; }))
      continue;
    const Weighted at(points, *found);
    if (at.nearer()) continue;
    NearestPair here = at.pair(a[0]);
    if (nearest && here.weights_of_a[0] <= nearest->weights_of_a[0]) continue;
    nearest = std::move(here);
    if (of_a == 1 || all - of_a == 1) break;  // in a convex set the point nearest to another is unique
  }
  return *nearest;
}

/// The equations of each support have one solution. They would have several if displacements among its points, with
/// factors that are not all 0, added up to 0; but those that were there before a point was added had no such factors,
/// and all of them are equally far along w, from which the added point leads away. The square of w falls with every
/// solution that is reached, so no support repeats.
NearestPair any_nearest_pair(const Hull& a, const Hull& b) {
  const Points points = points_of(a, b);
  std::vector<Rational> at(points.of.size());
  at[0] = at[a.size()] = 1;
  std::optional<std::size_t> added;
  for (;;) {
    const Support support = support_of(points, [&](std::size_t i) { return sgn(at[i]) > 0 || i == added; });
    const Fractions solution = weights(points, support).value();
    const auto weight = [&solution](std::size_t i) { return quotient(solution.numerators[i], solution.denominator); };
    Rational share(1);
    for (const std::size_t i : support.places)
      if (sgn(solution.numerators[i]) < 0) share = std::min(share, Rational(at[i] / (at[i] - weight(i))));
    for (const std::size_t i : support.places) at[i] += share * (weight(i) - at[i]);
    added.reset();
    if (share < 1) continue;
    const Weighted reached(points, solution);
    added = reached.nearer();
    if (!added) return reached.pair(a[0]);
  }
}

}  // namespace touchstone::oracle
