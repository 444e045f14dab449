// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/convex_mesh.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/penetration.h"
#include "geometry/validation.h"
#include "oracle/exact/solids/closed_mesh.h"
#include "oracle/exact/solids/polygon_faces.h"

namespace touchstone::oracle {
namespace {

template <class Number>
std::vector<Point3<Rational>> exact_vertices(const std::string& field, const Mesh<Number>& mesh) {
  validation::validate(field, mesh), validate_polygons(field, mesh), validation::validate_triangles(field, mesh);
  std::vector<Point3<Rational>> vertices;
  for (const auto& vertex : mesh.vertices) vertices.push_back(exact(vertex));
  return vertices;
}

Integer common_denominator(const std::vector<Point3<Rational>>& points) {
  Integer common(1);
  for (const auto& p : points) {
    for (const Rational* number : {&p.x, &p.y, &p.z})
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), number->get_den_mpz_t());
  }
  return common;
}

Integer common_factor(const std::vector<Point3<Integer>>& points) {
  Integer common(0);
  for (const auto& p : points) {
    for (const Integer* number : {&p.x, &p.y, &p.z})
      mpz_gcd(common.get_mpz_t(), common.get_mpz_t(), number->get_mpz_t());
  }
  return sgn(common) == 0 ? Integer(1) : common;
}

Point3<Integer> multiplied(const Point3<Rational>& p, const Integer& denominator) {
  const auto integer = [&denominator](const Rational& number) {
    return Integer(number.get_num() * (denominator / number.get_den()));
  };
  return {integer(p.x), integer(p.y), integer(p.z)};
}

using Edge = std::pair<Index, Index>;

void validate_closed(const std::string& field, const Mesh<Rational>& mesh) {
  std::map<Edge, int> times;
  for (const Face& face : mesh.faces) {
    for (const Edge& edge : edges_of(face)) ++times[edge];
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (const Edge& edge : edges_of(mesh.faces[i])) {
      const auto reverse = times.find({edge.second, edge.first});
      if (times[edge] > 1 || reverse == times.end() || reverse->second > 1)
        validation::refuse_edge(field, mesh, i, edge.first, edge.second);
    }
  }
}

/// The cofactors of the fourth row of the determinant of a, b, c and p, each with a 1.
IntegerPlane plane_through(const Point3<Integer>& a, const Point3<Integer>& b, const Point3<Integer>& c) {
  const auto position = [](const Point3<Integer>& p) { return Vector3<Integer>{p.x, p.y, p.z}; };
  const Vector3<Integer> ab = cross(position(a), position(b)), bc = cross(position(b), position(c)),
                         ca = cross(position(c), position(a));
  return {{Integer(ab.x + bc.x + ca.x), Integer(ab.y + bc.y + ca.y), Integer(ab.z + bc.z + ca.z)},
          Integer(-dot(ab, position(c)))};
}

void turn(IntegerPlane& plane) {
  plane = {{Integer(-plane.normal.x), Integer(-plane.normal.y), Integer(-plane.normal.z)}, Integer(-plane.offset)};
}

}  // namespace

ConvexMesh::ConvexMesh(const std::vector<Point3<Rational>>& exactly, const std::vector<Face>& triangles)
    : faces(triangles) {
  const Integer denominator = common_denominator(exactly);
  for (const auto& p : exactly) vertices.push_back(multiplied(p, denominator));
  const Integer factor = common_factor(vertices);
  for (auto& p : vertices) p = {Integer(p.x / factor), Integer(p.y / factor), Integer(p.z / factor)};
  unit = Rational(factor, denominator);
  unit.canonicalize();
  for (const auto& [a, b, c] : faces) planes.push_back(plane_through(vertices[a], vertices[b], vertices[c]));
}

ConvexMesh::ConvexMesh(const std::string& field, const Mesh<Rational>& mesh)
    : ConvexMesh(exact_vertices(field, mesh), mesh.faces) {
  examine(field, mesh);
}

ConvexMesh::ConvexMesh(const std::string& field, const Meshd& mesh)
    : ConvexMesh(field, Mesh<Rational>{exact_vertices(field, mesh), mesh.faces, mesh.polygons}) {}

template <class Number>
ConvexMesh ConvexMesh::core(const std::string& field, const Mesh<Number>& mesh) {
  if (!is_simplex(mesh)) return {field, mesh};
  std::vector<Point3<Rational>> exactly;
  for (const auto& vertex : mesh.vertices) exactly.push_back(exact(vertex));
  return {exactly, sides_of_simplex(mesh)};
}
template ConvexMesh ConvexMesh::core(const std::string&, const Meshd&);
template ConvexMesh ConvexMesh::core(const std::string&, const Mesh<Rational>&);

void ConvexMesh::examine(const std::string& field, const Mesh<Rational>& mesh) {
  validate_closed(field, mesh);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (zero(planes[i].normal)) validation::refuse_area(field, mesh, i);
  }
  const auto off = std::find_if(vertices.begin(), vertices.end(),
                                [this](const auto& vertex) { return sgn(planes[0].at(vertex)) != 0; });
  if (off == vertices.end()) validation::refuse_flat_mesh(field);
  if (sgn(planes[0].at(*off)) > 0) std::for_each(planes.begin(), planes.end(), turn);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (sgn(planes[i].at(vertices[v])) > 0) validation::refuse_beyond(field, mesh, i, v);
    }
  }
}

HomogeneousPoint ConvexMesh::integer(const Point3<Rational>& p) const {
  const Point3<Rational> counted{Rational(p.x / unit), Rational(p.y / unit), Rational(p.z / unit)};
  const Integer w = common_denominator({counted});
  auto [x, y, z] = multiplied(counted, w);
  return {std::move(x), std::move(y), std::move(z), w};
}

HomogeneousPoint ConvexMesh::integer(const Point3d& p) const { return integer(exact(p)); }

}  // namespace touchstone::oracle
