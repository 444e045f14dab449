// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/point_in_convex_polyhedron.h"

#include <array>
#include <optional>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/exact/solids/convex_mesh.h"

namespace touchstone::oracle {
namespace {

struct Question {
  ConvexMesh mesh;
  HomogeneousPoint point;
};

template <class Number>
Question validated(const Mesh<Number>& mesh, const Point3<Number>& point) {
  validation::validate_numbers("mesh", mesh), validation::validate_numbers("point", point);
  ConvexMesh integers("mesh", mesh);
  HomogeneousPoint at = integers.integer(point);
  return {std::move(integers), std::move(at)};
}

Integer determinant(const Vector3<Integer>& u, const Vector3<Integer>& v, const Vector3<Integer>& w) {
  return dot(u, cross(v, w));
}

/// The tetrahedron of vertex 0 and a face that contains the point: the weights of its corners times `whole` > 0.
struct Tetrahedron {
  std::array<Index, 4> corners;
  std::array<Integer, 4> weights;
  Integer total;
};

/// By Cramer's rule: the point minus vertex 0 as a sum of multiples of the other three corners minus vertex 0.
std::optional<Tetrahedron> holding(const Question& q, const Face& face) {
  const auto& vertices = q.mesh.vertices;
  const Point3<Integer>& apex = vertices[0];
  const Integer& w = q.point.w;
  const Vector3<Integer> a = vertices[face.a] - apex, b = vertices[face.b] - apex, c = vertices[face.c] - apex,
                         p{Integer(q.point.x - w * apex.x), Integer(q.point.y - w * apex.y),
                           Integer(q.point.z - w * apex.z)};
  Integer volume = determinant(a, b, c);
  if (sgn(volume) == 0) return std::nullopt;
  const int turned = sgn(volume);
  const auto positive = [turned](const Integer& value) { return Integer(turned * value); };
  Tetrahedron found{
      {0, face.a, face.b, face.c},
      {Integer(0), positive(determinant(p, b, c)), positive(determinant(a, p, c)), positive(determinant(a, b, p))},
      Integer(positive(volume) * w)};
  found.weights[0] = found.total - found.weights[1] - found.weights[2] - found.weights[3];
  for (const Integer& weight : found.weights) {
    if (sgn(weight) < 0) return std::nullopt;
  }
  return found;
}

std::optional<Tetrahedron> holding(const Question& q) {
  for (const Face& face : q.mesh.faces) {
    if (auto found = holding(q, face)) return found;
  }
  return std::nullopt;
}

Location located(const Question& q, bool held) {
  if (!held) return Location::outside;
  for (const IntegerPlane& plane : q.mesh.planes) {
    if (sgn(plane.at(q.point)) == 0) return Location::boundary;
  }
  return Location::inside;
}

/// The squared distance of the point from a plane, in squared units.
Rational squared_distance_point_in_convex_polyhedron(const Question& q, const IntegerPlane& plane) {
  const Integer height = plane.at(q.point);
  return quotient(Integer(height * height), Integer(dot(plane.normal, plane.normal) * q.point.w * q.point.w));
}

Certificate barycentric(const Tetrahedron& found) {
  std::vector<Rational> corners, weights;
  for (const Index corner : found.corners) corners.emplace_back(corner);
  for (const Integer& weight : found.weights) weights.push_back(quotient(weight, found.total));
  return {"barycentric", {{"corners", corners}, {"weights", weights}}};
}

template <class Number>
Truth<Location> truth_of_point_in_convex_polyhedron(const Mesh<Number>& mesh, const Point3<Number>& point) {
  const Question q = validated(mesh, point);
  auto found = holding(q);
  const Location location = located(q, found.has_value());
  Truth<Location> truth{location, Rational(0)};
  if (found) truth.certificate = [found = std::move(*found)] { return barycentric(found); };
  if (location == Location::boundary) return truth;
  std::optional<Rational> deciding;
  for (const IntegerPlane& plane : q.mesh.planes) {
    if (location == Location::outside && sgn(plane.at(q.point)) <= 0) continue;
    if (!truth.certificate)
      truth.certificate = [face = &plane - q.mesh.planes.data()] {
        return Certificate{"separating_face", {{"face", {Rational(face)}}}};
      };
    Rational distance = squared_distance_point_in_convex_polyhedron(q, plane);
    if (!deciding || (location == Location::outside) == (distance > *deciding)) deciding = std::move(distance);
  }
  truth.margin = deciding.value() * q.mesh.unit * q.mesh.unit;
  return truth;
}

}  // namespace

template <Exact Number>
Truth<Location> point_in_convex_polyhedron(const Mesh<Number>& mesh, const Point3<Number>& point) {
  return truth_of_point_in_convex_polyhedron(mesh, point);
}
template Truth<Location> point_in_convex_polyhedron(const Meshd&, const Point3d&);
template Truth<Location> point_in_convex_polyhedron(const Mesh<Rational>&, const Point3<Rational>&);

}  // namespace touchstone::oracle
