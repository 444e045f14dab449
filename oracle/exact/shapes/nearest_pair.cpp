// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/nearest_pair.h"

#include <algorithm>
#include <optional>

namespace touchstone::oracle {
namespace {

using Point = Point3<Rational>;
using Vector = Vector3<Rational>;
using Row = std::vector<Rational>;

/// A square system with its right sides in the last column: the solution, or nothing where it is singular.
std::optional<Row> solved(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(k);
    const auto pivot = std::find_if(from, rows.end(), [k](const Row& row) { return sgn(row[k]) != 0; });
    if (pivot == rows.end()) return std::nullopt;
    std::iter_swap(from, pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || sgn(rows[i][k]) == 0) continue;
      const Rational factor(rows[i][k] / rows[k][k]);
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  Row solution;
  for (std::size_t k = 0; k < n; ++k) solution.push_back(Rational(rows[k][n] / rows[k][k]));
  return solution;
}

/// The points that may have a weight, of a first, those of b negated; and how many of them are a's.
struct Support {
  std::vector<Vector> points;
  std::vector<std::size_t> places;
  std::size_t of_a;
};

Support support_of(const std::vector<Vector>& a, const std::vector<Vector>& b, unsigned chosen) {
  Support support{{}, {}, 0};
  for (std::size_t i = 0; i < a.size() + b.size(); ++i) {
    if ((chosen >> i & 1U) == 0) continue;
    const bool is_of_a = i < a.size();
    support.points.push_back(is_of_a ? a[i] : Rational(-1) * b[i - a.size()]);
    support.places.push_back(i);
    support.of_a += static_cast<std::size_t>(is_of_a);
  }
  return support;
}

/// With w the sum of weights times points: every point of a has one scalar product with w, every one of b another; both
/// sums of weights are 1.
std::optional<Row> weights(const Support& support) {
  const std::size_t n = support.points.size();
  std::vector<Row> rows(n + 2, Row(n + 3));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t side = i < support.of_a ? n : n + 1;
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(support.points[i], support.points[j]);
    rows[i][side] = -1;
    rows[side][i] = 1;
  }
  rows[n][n + 2] = rows[n + 1][n + 2] = 1;
  return solved(std::move(rows));
}

Vector combination(const std::vector<Vector>& points, const Row& weights) {
  Vector sum{0, 0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) sum = sum + weights[i] * points[i];
  return sum;
}

/// No point has a smaller scalar product with w than x.
bool none_before(const std::vector<Vector>& points, const Vector& x, const Vector& w) {
  return std::all_of(points.begin(), points.end(), [&](const Vector& p) { return sgn(dot(w, p - x)) >= 0; });
}

}  // namespace

Point nearest_to(const Point& point, const Hull& a, const Hull& b, const Point& on_a, const Vector& way) {
  const Vector v = a[1] - a[0], w = b[1] - b[0], across = cross(v, w);
  const Rational length = dot(v, v);
  if (sgn(length) == 0 || sgn(dot(across, across)) != 0) return on_a;
  // All are on the line of a, between the ends of a and of b.
  const auto along = [&](const Vector& from_a) { return Rational(dot(from_a, v) / length); };
  const Rational first = along((b[0] - a[0]) - way), second = along((b[1] - a[0]) - way);
  const Rational low = std::max(Rational(0), std::min(first, second)),
                 high = std::min(Rational(1), std::max(first, second));
  return a[0] + std::min(std::max(along(point - a[0]), low), high) * v;
}

NearestPair nearest_pair(const Hull& hull_a, const Hull& hull_b) {
  const Point& origin = hull_a[0];
  std::vector<Vector> a, b;
  for (const Point& p : hull_a) a.push_back(p - origin);
  for (const Point& p : hull_b) b.push_back(p - origin);
  const std::size_t of_a = a.size(), all = of_a + b.size();
  std::optional<NearestPair> nearest;
  for (unsigned chosen = 1; chosen < 1U << all; ++chosen) {
    const Support support = support_of(a, b, chosen);
    if (support.of_a == 0 || support.of_a == support.points.size()) continue;
    const std::optional<Row> found = weights(support);
    if (!found) continue;
    Row each(all);
    for (std::size_t i = 0; i < support.places.size(); ++i) each[support.places[i]] = (*found)[i];
    if (std::any_of(each.begin(), each.end(), [](const Rational& weight) { return sgn(weight) < 0; })) continue;
    const auto middle = each.begin() + static_cast<std::ptrdiff_t>(of_a);
    const Row on_a(each.begin(), middle), on_b(middle, each.end());
    const Vector x = combination(a, on_a), y = combination(b, on_b), w = x - y;
    if (!none_before(a, x, w) || !none_before(b, y, Rational(-1) * w)) continue;
    if (nearest && on_a[0] <= nearest->weights_of_a[0]) continue;
    nearest = NearestPair{origin + x, origin + y, on_a, on_b, dot(w, w)};
    if (of_a == 1 || all - of_a == 1) break;  // a convex set has one point that is nearest to another
  }
  return *nearest;
}

}  // namespace touchstone::oracle
