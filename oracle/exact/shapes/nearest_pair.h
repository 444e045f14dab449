// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/closest.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// The convex hull of a few points: of two, a segment; of three, a triangle. The plane is z = 0.
using Hull = std::vector<Point3<Rational>>;

/// Points of two hulls that are nearest to each other, by weights of their points.
struct NearestPair {
  Point3<Rational> on_a, on_b;
  std::vector<Rational> weights_of_a, weights_of_b;
  Rational squared_distance;
};

/// By the conditions of Karush, Kuhn and Tucker: with x and y the points and w = x - y, the weights are not negative
/// and of sum 1, and no point of a has a smaller scalar product with w than x, none of b a greater one than y. They
/// suffice because all is convex. Each choice of points that may have a weight above 0 gives linear equations; one
/// whose solution satisfies the conditions is there. Among several pairs of nearest points the one is taken whose first
/// point of a has the greatest weight: on segments, the least parameter on a.
NearestPair nearest_pair(const Hull& a, const Hull& b);

/// One of the pairs, by the same conditions, for hulls of more points: from the first point of each. The points that
/// may have a weight are those that have one and a point that is nearer; weights move towards the solution of their
/// equations, and a point whose weight would fall below 0 is left out.
NearestPair any_nearest_pair(const Hull& a, const Hull& b);

/// For two segments, on_a a point of the first that is nearest to the second, way the displacement from there to the
/// nearest point of the second: among all such points of the first the one nearest to another point.
Point3<Rational> nearest_to(const Point3<Rational>& point, const Hull& a, const Hull& b, const Point3<Rational>& on_a,
                            const Vector3<Rational>& displacement);

template <class Number>
Point3<Rational> exact_in_space(const Point2<Number>& p) {
  return {exact(p.x), exact(p.y), 0};
}
template <class Number>
Point3<Rational> exact_in_space(const Point3<Number>& p) {
  return exact(p);
}
inline Point2<Surd> in_plane(const Point3<Rational>& p) { return {p.x, p.y}; }
inline Point3<Surd> in_space(const Point3<Rational>& p) { return {p.x, p.y, p.z}; }

/// The points and a distance, the root of a rational, with the certificate of both: "root" or, where the distance is
/// not rational, "irrational_root".
template <class Answer>
Truth<Answer> truth_of_distance(Answer answer, const Rational& squared_distance,
                                std::vector<std::pair<std::string, std::vector<Rational>>> weights) {
  answer.squared_distance = squared_distance, answer.distance = sqrt(Surd(squared_distance));
  const char* const kind = answer.distance.rational() ? "root" : "irrational_root";
  return {std::move(answer), std::nullopt, [kind, facts = std::move(weights)] { return Certificate{kind, facts}; }};
}

/// A point without its roots, which has none; one of the plane lies at z = 0.
inline Point3<Rational> rational(const Point2<Surd>& p) { return {p.x.rational_part(), p.y.rational_part(), 0}; }
inline Point3<Rational> rational(const Point3<Surd>& p) {
  return {p.x.rational_part(), p.y.rational_part(), p.z.rational_part()};
}

}  // namespace touchstone::oracle
