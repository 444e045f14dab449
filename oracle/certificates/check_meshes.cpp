// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_meshes.h"

#include <cstdint>
#include <map>
#include <utility>

namespace touchstone::certify {
namespace {

std::array<std::size_t, 3> corners(const json& value, const std::string& what, std::size_t vertices) {
  expect(value.is_array() && value.size() == 3, what + ": a list of three");
  std::array<std::size_t, 3> found{};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool counts = value[k].is_number_unsigned() || (value[k].is_number_integer() && value[k].get<long>() >= 0);
    const bool there = counts && value[k].get<std::uint64_t>() < vertices;
    expect(there, what + "[" + std::to_string(k) + "]: index of a vertex");
    found[k] = value[k].get<std::size_t>();
  }
  expect(found[0] != found[1] && found[1] != found[2] && found[2] != found[0], what + ": three different vertices");
  return found;
}

void expect_closed(const Mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> times;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++times[{face[k], face[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : times) {
    const auto reverse = times.find({edge.second, edge.first});
    expect(count == 1 && reverse != times.end() && reverse->second == 1, "truth: the mesh is not closed");
  }
}

/// Positive where a, b, c are seen counter-clockwise.
Plane plane_through(const Triple& a, const Triple& b, const Triple& c) {
  const Triple v = b - a, w = c - a;
  const Triple normal{Rational(v.y * w.z - v.z * w.y), Rational(v.z * w.x - v.x * w.z),
                      Rational(v.x * w.y - v.y * w.x)};
  return {normal, Rational(-dot(normal, a))};
}

}  // namespace

Mesh mesh(const json& value, const std::string& what) {
  only(value, what, {"vertices", "faces"});
  for (const char* list : {"vertices", "faces"}) expect(value[list].is_array(), what + "." + list + ": a list");
  Mesh found;
  for (const json& vertex : value["vertices"])
    found.vertices.push_back(point_in_space(vertex, what + ".vertices[" + std::to_string(found.vertices.size()) + "]"));
  for (const json& face : value["faces"])
    found.faces.push_back(
        corners(face, what + ".faces[" + std::to_string(found.faces.size()) + "]", found.vertices.size()));
  expect(found.faces.size() >= 4, what + ": at least 4 faces");
  return found;
}

std::vector<Plane> outward_planes(const Mesh& mesh) {
  expect_closed(mesh);
  std::vector<Plane> planes;
  bool front = false, back = false;
  for (const auto& face : mesh.faces) {
    planes.push_back(plane_through(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]));
    expect(!(planes.back().normal == Triple{0, 0, 0}), "truth: a face has no area");
    bool beside = false;
    for (const Triple& vertex : mesh.vertices) {
      const int side = sgn(planes.back().at(vertex));
      beside = beside || side != 0, front = front || side > 0, back = back || side < 0;
    }
    expect(beside, "truth: all vertices are on one plane");
    expect(!(front && back), "truth: the mesh is not convex");
  }
  for (Plane& plane : planes) {
    if (front) plane = {Triple{0, 0, 0} - plane.normal, Rational(-plane.offset)};
  }
  return planes;
}

}  // namespace touchstone::certify
