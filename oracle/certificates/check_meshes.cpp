// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_meshes.h"

#include <cstdint>
#include <map>
#include <utility>

namespace touchstone::certify {
namespace {

using Face = std::array<std::size_t, 3>;

Face corners(const json& value, const std::string& what, std::size_t vertices) {
  expect(value.is_array() && value.size() == 3, what + ": a list of three");
  Face found{};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool there = value[k].is_number_unsigned() && value[k].get<std::uint64_t>() < vertices;
    expect(there, numbered(what, k) + ": index of a vertex");
    found[k] = value[k].get<std::size_t>();
  }
  return found;
}

void expect_closed(const Mesh& mesh, const std::string& what) {
  std::map<std::pair<std::size_t, std::size_t>, int> times;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++times[{face[k], face[(k + 1) % 3]}];
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = mesh.faces[i][k], to = mesh.faces[i][(k + 1) % 3];
      const auto reverse = times.find({to, from});
      const bool matched = times[{from, to}] == 1 && reverse != times.end() && reverse->second == 1;
      const std::string a = std::to_string(from), b = std::to_string(to);
      expect(matched, numbered(what + ".faces", i) + ": closed: edge " + a + " -> " + b + " must occur once, and " + b +
                          " -> " + a + " once");
    }
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
    found.vertices.push_back(point_in_space(vertex, numbered(what + ".vertices", found.vertices.size())));
  for (const json& face : value["faces"])
    found.faces.push_back(corners(face, numbered(what + ".faces", found.faces.size()), found.vertices.size()));
  for (std::size_t i = 0; i < found.faces.size(); ++i) {
    const Face& f = found.faces[i];
    expect(f[0] != f[1] && f[1] != f[2] && f[2] != f[0], numbered(what + ".faces", i) + ": three different vertices");
  }
  expect(found.faces.size() >= 4, what + ": at least 4 faces");
  return found;
}

std::vector<Plane> outward_planes(const Mesh& mesh, const std::string& what) {
  expect_closed(mesh, what);
  std::vector<Plane> planes;
  for (const Face& face : mesh.faces) {
    const std::string field = numbered(what + ".faces", planes.size());
    planes.push_back(plane_through(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]));
    expect(!(planes.back().normal == Triple{0, 0, 0}), field + ": nonzero area");
  }
  int front = 0;  // the side of the first plane on which the first vertex lies that is not on it
  for (std::size_t v = 0; v < mesh.vertices.size() && front == 0; ++v) front = sgn(planes[0].at(mesh.vertices[v]));
  expect(front != 0, what + ": convex: vertices on one plane have no inside");
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (front > 0) planes[i] = {Triple{0, 0, 0} - planes[i].normal, Rational(-planes[i].offset)};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      expect(sgn(planes[i].at(mesh.vertices[v])) <= 0,
             numbered(what + ".faces", i) + ": convex: vertex " + std::to_string(v) + " must not lie beyond its plane");
    }
  }
  return planes;
}

std::optional<Rational> crossing(const std::array<Triple, 3>& corners, const Triple& direction) {
  Rational sum;
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Triple &a = corners[k], &b = corners[(k + 1) % 3], span = cross(a, b), none{0, 0, 0};
    const Rational side = dot(direction, span);
    const bool away = span == none && sgn(dot(a, b)) > 0 && !(cross(direction, a) == none);
    expect(sgn(side) != 0 || away, "certificate: the ray's line meets an edge");
    left += sgn(side) > 0, right += sgn(side) < 0, sum += side;
  }
  if (left != 3 && right != 3) return std::nullopt;
  const Rational t = dot(corners[0], cross(corners[1], corners[2])) / sum;
  expect(sgn(t) != 0, "certificate: the point is on a face");
  return sgn(t) > 0 ? std::optional(t) : std::nullopt;
}

}  // namespace touchstone::certify
