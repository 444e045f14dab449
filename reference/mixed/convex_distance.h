// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/closest.h"
#include "geometry/polyhedra.h"

namespace touchstone::reference {

/// A vertex of each polyhedron, and the displacement from b's to a's: a point of their Minkowski difference.
template <class Real>
struct SupportPair {
  Point3<Real> on_a, on_b;
  Vector3<Real> displacement;
};

/// At most four support pairs with weights of sum 1, and the point of the difference that these give.
template <class Real>
struct DistanceSimplex {
  std::vector<SupportPair<Real>> pairs;
  std::vector<Real> weights;

  /// The first point, and each edge from it times the weight of its end.
  template <class Start, class Part>
  Start weighted(Start sum, const Part& part) const {
    for (std::size_t k = 1; k < pairs.size(); ++k) sum = sum + weights[k] * (part(pairs[k]) - part(pairs[0]));
    return sum;
  }
  Vector3<Real> displacement() const {
    return weighted(pairs[0].displacement, [](const auto& pair) -> const Vector3<Real>& { return pair.displacement; });
  }
  Point3<Real> on_a() const {
    return weighted(pairs[0].on_a, [](const auto& pair) -> const Point3<Real>& { return pair.on_a; });
  }
  Point3<Real> on_b() const {
    return weighted(pairs[0].on_b, [](const auto& pair) -> const Point3<Real>& { return pair.on_b; });
  }
};

/// The weights with which the foot of the origin's perpendicular on the plane, line or point of the pairs is their sum.
template <class Real>
std::vector<Real> weights_of_foot(const std::vector<SupportPair<Real>>& pairs) {
  const Vector3<Real>& w = pairs[0].displacement;
  const auto edge = [&](std::size_t k) { return pairs[k].displacement - w; };
  const auto solved = [](const Real& whole, const std::vector<Real>& parts) {
    std::vector<Real> weights{Real(1)};
    for (const Real& part : parts) weights.push_back(Real(-part / whole)), weights[0] = weights[0] - weights.back();
    return weights;
  };
  if (pairs.size() == 1) return {Real(1)};
  const Vector3<Real> e = edge(1);
  if (pairs.size() == 2) return solved(dot(e, e), {dot(e, w)});
  const Vector3<Real> f = edge(2), normal = cross(e, f);
  if (pairs.size() == 3) return solved(dot(normal, normal), {dot(cross(w, f), normal), dot(cross(e, w), normal)});
  const Vector3<Real> g = edge(3);
  return solved(dot(normal, g), {dot(cross(f, g), w), dot(cross(g, e), w), dot(normal, w)});
}

/// Among all faces of the simplex on which that foot has no negative weight, the one with the nearest foot.
template <class Real>
DistanceSimplex<Real> nearest_face(const std::vector<SupportPair<Real>>& pairs) {
  DistanceSimplex<Real> nearest;
  for (unsigned chosen = 1; chosen < 1U << pairs.size(); ++chosen) {
    DistanceSimplex<Real> face;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      if ((chosen >> k & 1U) != 0) face.pairs.push_back(pairs[k]);
    face.weights = weights_of_foot(face.pairs);
    const auto positive = [](const Real& weight) { return weight > Real(0); };
    if (!std::all_of(face.weights.begin(), face.weights.end(), positive)) continue;
    const Vector3<Real> displacement = face.displacement(),
                        least = nearest.pairs.empty() ? displacement : nearest.displacement();
    if (nearest.pairs.empty() || face.pairs.size() == 4 || dot(displacement, displacement) < dot(least, least))
      nearest = std::move(face);
  }
  return nearest;
}

/// The vertices of a and of b that are farthest against `direction` and along it.
template <class Real>
SupportPair<Real> support_pair(const Mesh<Real>& a, const Mesh<Real>& b, const Vector3<Real>& direction) {
  const auto height = [&](const Point3<Real>& p) { return dot(direction, Vector3<Real>{p.x, p.y, p.z}); };
  Point3<Real> lowest = a.vertices[0], highest = b.vertices[0];
  for (const Point3<Real>& p : a.vertices)
    if (height(p) < height(lowest)) lowest = p;
  for (const Point3<Real>& p : b.vertices)
    if (height(p) > height(highest)) highest = p;
  return {lowest, highest, lowest - highest};
}

/// The simplex with the shortest displacement: the vertices farthest against each one found give the next, until
/// nothing is farther, or the next is not shorter. With four pairs the polyhedra have a common interior point.
template <class Real>
DistanceSimplex<Real> nearest_simplex(const Mesh<Real>& a, const Mesh<Real>& b) {
  DistanceSimplex<Real> nearest = nearest_face<Real>({{a.vertices[0], b.vertices[0], a.vertices[0] - b.vertices[0]}});
  while (nearest.pairs.size() < 4) {
    const Vector3<Real> displacement = nearest.displacement();
    const SupportPair<Real> next = support_pair(a, b, displacement);
    if (!(dot(displacement, next.displacement) < dot(displacement, displacement))) break;
    std::vector<SupportPair<Real>> pairs = nearest.pairs;
    pairs.push_back(next);
    DistanceSimplex<Real> shorter = nearest_face(pairs);
    const Vector3<Real> found = shorter.displacement();
    if (shorter.pairs.size() < 4 && !(dot(found, found) < dot(displacement, displacement))) break;
    nearest = std::move(shorter);
  }
  return nearest;
}

/// Decides whether two convex polyhedra have a common point, and if not, points of both that are as near to each other
/// as any, and how far that is: the distance and its square.
///
/// No page of the deck asks this. The formula is that of Gilbert, Johnson and Keerthi (A fast procedure for computing
/// the distance between complex objects in three-dimensional space, 1988; Ericson, Real-Time Collision Detection, 9.5),
/// put together from p. 48-50's nearest point and p. 53-54's vertices, edges and faces: of the Minkowski difference,
/// all displacements from a point of b to one of a, the shortest is sought, on simplices of at most four displacements
/// between vertices. a, b: meshes, any unit of length, the same for both; the squared distance is in its square. Closed
/// sets: where they have a common point, touching included, the relation is `meeting`, both distances are 0 and no
/// points are given. Where many pairs are as near, because faces or edges are parallel, the points on a of all of them
/// are a convex set, and the one that is nearest to a.vertices[0] is the answer, with the point of b that is as near to
/// it as any. There is only one such pair. Engines may name another that is as near, unless they declare that they name
/// this one (`nearest`, docs/engines.md). Refused by robust and oracle: NaN or infinity in a vertex; then what is not
/// the surface of a convex solid, by the rules and in the order of reference/polyhedra/point_in_convex_polyhedron.h,
/// with "a" or "b" for the mesh. That page also says which meshes are valid: faces in one plane, flat vertices,
/// vertices of no face, and a surface that is inside out.
///
/// In exact arithmetic relation and distance are always right: the displacement gets shorter each time, and there are
/// finitely many simplices. A new vertex pair is beyond the plane through the point found, so the simplex is never
/// flat, and nothing is divided by 0. Among several nearest pairs it returns any (cause: algorithm).
///
/// Margin: the distance by which a has to be moved, in the maximum norm, until the relation changes.
///
/// Rounding (binary64, to nearest, u = 2^-53), where nothing overflows: where the answer is `apart`, each point as
/// computed is, on each axis, within 16 u (W + M) + 2^-1070 of a point of its polyhedron, W being the extent and M the
/// greatest coordinate of that on the axis: weights add up to at most 1 + 4u, which is 4 u W; differences and products
/// are 3 u W, three sums 4 u (W + M). Let e be the sum of these over both points and all axes. So the distance D is
/// never too short by more: D >= (D* - e) (1 - 4u) - 2^-536, D* being the exact distance. There is no bound on how much
/// too long it may be, nor on when flat simplices make it answer `meeting`. ulps: 60 roundings behind the distance
/// (three differences in the displacements, nine in the edges, 27 in the products of three vectors, three quotients,
/// three weights, nine in a point, three differences, three squares, two sums, the root, less what is shared).
template <class Real>
ConvexDistance<Real> convex_distance(const Mesh<Real>& a, const Mesh<Real>& b) {
  using std::sqrt;
  const DistanceSimplex<Real> nearest = nearest_simplex(a, b);
  const Point3<Real> x = nearest.on_a(), y = nearest.on_b();
  const Real square = dot(x - y, x - y);
  if (nearest.pairs.size() == 4 || square == Real(0)) return {ConvexRelation::meeting, {}, {}, Real(0), Real(0)};
  return {ConvexRelation::apart, x, y, square, Real(sqrt(square))};
}

}  // namespace touchstone::reference
