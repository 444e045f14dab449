// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/triangle_triangle_distance.h"

#include <algorithm>

#include "geometry/validation.h"
#include "oracle/exact/shapes/nearest_pair.h"
#include "oracle/exact/solids/solid_distance.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Hull corners_of(const Triangle3<Number>& t) {
  return {exact(t.a), exact(t.b), exact(t.c)};
}

/// Corners as far along w as x, moved.
Hull level(const Hull& hull, const Vector3<Rational>& w, const Point3<Rational>& x, const Vector3<Rational>& by) {
  Hull found;
  for (const Point3<Rational>& p : hull)
    if (sgn(dot(w, p - x)) == 0) found.push_back(p + by);
  return found;
}

/// Points that span the common part of two hulls in one plane: its corners, perhaps with others.
Hull common_points(const Hull& a, const Hull& b) {
  Hull common;
  const auto add = [&common](const Hull& one, const Hull& other) {
    const NearestPair nearest = any_nearest_pair(one, other);
    if (sgn(nearest.squared_distance) == 0) common.push_back(nearest.on_a);
  };
  for (const auto& p : a) add({p}, b);
  for (const auto& q : b) add({q}, a);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) add({a[i], a[(i + 1) % a.size()]}, {b[j], b[(j + 1) % b.size()]});
  return common;
}

/// Among the points of a of all nearest pairs the one that is nearest to another point.
Point3<Rational> nearest_among(const Hull& a, const Hull& b, const NearestPair& any, const Point3<Rational>& to) {
  const Vector3<Rational> w = any.on_a - any.on_b;
  const Hull of_a = level(a, w, any.on_a, {0, 0, 0}), of_b = level(b, w, any.on_b, w);
  if (of_a.size() == 1 || of_b.size() == 1) return any.on_a;
  return any_nearest_pair(common_points(of_a, of_b), {to}).on_a;
}

/// The square of the least height of the origin below the planes that bound a - b; 0 if that has no interior.
Rational squared_depth(const Hull& a, const Hull& b) {
  const auto edges = [](const Hull& t) { return std::array{t[1] - t[0], t[2] - t[1], t[0] - t[2]}; };
  const auto of_a = edges(a), of_b = edges(b);
  std::vector<Vector3<Rational>> normals{cross(of_a[0], of_a[1]), cross(of_b[0], of_b[1])};
  for (const auto& v : of_a)
    for (const auto& w : of_b) normals.push_back(cross(v, w));
  std::optional<Rational> least;
  for (const auto& n : normals) {
    const Rational square = dot(n, n);
    if (sgn(square) == 0) continue;
    const auto height = [&](std::size_t i) { return dot(n, (i < 3 ? a : b)[i % 3] - a[0]); };
    const auto [low_a, high_a] = std::minmax({height(0), height(1), height(2)});
    const auto [low_b, high_b] = std::minmax({height(3), height(4), height(5)});
    const Rational depth = std::min(Rational(high_a - low_b), Rational(high_b - low_a));
    least = std::min(Rational(depth * depth / square), least.value_or(depth * depth / square));
  }
  return least.value_or(0);
}

}  // namespace

ConvexDistance<Surd> as_near(const Triangle3d& a, const Triangle3d& b, const ConvexDistance<Surd>& truth,
                             const Point3d& on_a) {
  const Hull of_a = corners_of(a), of_b = corners_of(b);
  const NearestPair any = any_nearest_pair(of_a, of_b);
  const Point3<Rational> x = nearest_among(of_a, of_b, any, exact(on_a));
  return {truth.relation, in_space(x), in_space(x + (any.on_b - any.on_a)), truth.squared_distance, truth.distance};
}

template <Exact Number>
Truth<ConvexDistance<Surd>> triangle_triangle_distance(const Triangle3<Number>& a, const Triangle3<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const Hull of_a = corners_of(a), of_b = corners_of(b);
  const NearestPair any = any_nearest_pair(of_a, of_b);
  if (sgn(any.squared_distance) == 0)
    return {{ConvexRelation::meeting, {}, {}, {}, {}}, squared_depth(of_a, of_b), [any] {
              return Certificate{"common_point", {{"on_a", any.weights_of_a}, {"on_b", any.weights_of_b}}};
            }};
  const Point3<Rational> on_a = nearest_among(of_a, of_b, any, of_a[0]), on_b = on_a + (any.on_b - any.on_a);
  Truth<ConvexDistance<Surd>> truth = truth_of_distance(
      ConvexDistance<Surd>{ConvexRelation::apart, in_space(on_a), in_space(on_b), {}, {}}, any.squared_distance, {});
  truth.margin = any.squared_distance;
  truth.certificate = [=, kind = truth.certificate().kind] {
    return Certificate{kind,
                       {{"on_a", any_nearest_pair(of_a, {on_a}).weights_of_a},
                        {"on_b", any_nearest_pair(of_b, {on_b}).weights_of_a},
                        {"first", multiplier(of_a, of_b, on_a, on_a - on_b)}}};
  };
  return truth;
}
template Truth<ConvexDistance<Surd>> triangle_triangle_distance(const Triangle3d&, const Triangle3d&);
template Truth<ConvexDistance<Surd>> triangle_triangle_distance(const Triangle3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
