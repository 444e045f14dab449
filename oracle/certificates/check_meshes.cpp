// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_meshes.h"

#include <cstdint>
#include <map>
#include <utility>

namespace touchstone::certify {
namespace {

using Face = std::array<std::size_t, 3>;

std::vector<std::size_t> corners(const json& value, const std::string& what, std::size_t vertices) {
  expect(value.is_array() && value.size() >= 3, what + ": at least 3 corners");
  std::vector<std::size_t> found;
  for (const json& corner : value) {
    const bool there = corner.is_number_unsigned() && corner.get<std::uint64_t>() < vertices;
    expect(there, numbered(what, found.size()) + ": index of a vertex");
    found.push_back(corner.get<std::size_t>());
  }
  return found;
}

std::vector<std::vector<std::size_t>> faces(const json& list, const std::string& what, std::size_t vertices) {
  expect(list.is_array(), what + ": a list");
  std::vector<std::vector<std::size_t>> found;
  for (const json& face : list) found.push_back(corners(face, numbered(what, found.size()), vertices));
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
      expect(matched, numbered(what + ".faces", mesh.face_of[i]) + ": closed: edge " + a + " -> " + b +
                          " must occur once, and " + b + " -> " + a + " once");
    }
  }
}

/// Positive if a, b, c are seen counter-clockwise.
Plane plane_through(const Triple& a, const Triple& b, const Triple& c) {
  const Triple v = b - a, w = c - a;
  const Triple normal{Rational(v.y * w.z - v.z * w.y), Rational(v.z * w.x - v.x * w.z),
                      Rational(v.x * w.y - v.y * w.x)};
  return {normal, Rational(-dot(normal, a))};
}

bool is_cut(const json& value) { return value.is_object() && value.contains("cut"); }

/// The faces and the triangles as they are listed.
Mesh listed(const json& value, const std::string& what) {
  const bool cut = is_cut(value);
  if (cut) only(value, what, {"vertices", "faces", "cut"});
  else only(value, what, {"vertices", "faces"});
  expect(value["vertices"].is_array(), what + ".vertices: a list");
  Mesh found;
  for (const json& vertex : value["vertices"])
    found.vertices.push_back(point_in_space(vertex, numbered(what + ".vertices", found.vertices.size())));
  found.named = faces(value["faces"], what + ".faces", found.vertices.size());
  const auto triangles = cut ? faces(value["cut"], what + ".cut", found.vertices.size()) : found.named;
  for (std::size_t i = 0; i < found.named.size(); ++i)
    found.face_of.insert(found.face_of.end(), found.named[i].size() - 2, i);
  for (const auto& triangle : triangles) {
    expect(triangle.size() == 3, what + (cut ? ".cut: lists of three" : ".faces: lists of three, or a cut"));
    found.faces.push_back({triangle[0], triangle[1], triangle[2]});
  }
  expect(found.faces.size() == found.face_of.size(), what + ".cut: a cut of the faces into triangles");
  return found;
}

}  // namespace

const char* part_of(const Mesh& mesh, std::size_t face, const Triple& x) {
  const std::vector<std::size_t>& corners = mesh.named[face];
  const char* part = "inside";
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Triple from = x - mesh.vertices[corners[k]], to = x - mesh.vertices[corners[(k + 1) % corners.size()]];
    if (from == Triple{0, 0, 0}) return "vertex";
    if (cross(from, to) == Triple{0, 0, 0} && sgn(dot(from, to)) <= 0) part = "edge";
  }
  return part;
}

Mesh listed_faces(const json& value, const std::string& what) {
  const Mesh found = listed(value, what);
  if (is_cut(value)) expect_cut(found, what);
  return found;
}

Mesh mesh(const json& value, const std::string& what) {
  const Mesh found = listed_faces(value, what);
  for (std::size_t i = 0; i < found.faces.size(); ++i) {
    const Face& f = found.faces[i];
    expect(f[0] != f[1] && f[1] != f[2] && f[2] != f[0],
           numbered(what + ".faces", found.face_of[i]) + ": three different vertices");
  }
  expect(found.named.size() >= 4, what + ": at least 4 faces");
  return found;
}

std::vector<Plane> outward_planes(const Mesh& mesh, const std::string& what) {
  expect_closed(mesh, what);
  std::vector<Plane> planes;
  for (const Face& face : mesh.faces) {
    const std::string field = numbered(what + ".faces", mesh.face_of[planes.size()]);
    planes.push_back(plane_through(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]));
    expect(!(planes.back().normal == Triple{0, 0, 0}), field + ": nonzero area");
  }
  int front = 0;  // the side of the first plane of the first vertex that is not on it
  for (std::size_t v = 0; v < mesh.vertices.size() && front == 0; ++v) front = sgn(planes[0].at(mesh.vertices[v]));
  expect(front != 0, what + ": convex: vertices on one plane have no inside");
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (front > 0) planes[i] = {Triple{0, 0, 0} - planes[i].normal, Rational(-planes[i].offset)};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      expect(sgn(planes[i].at(mesh.vertices[v])) <= 0, numbered(what + ".faces", mesh.face_of[i]) +
                                                           ": convex: vertex " + std::to_string(v) +
                                                           " must not lie beyond its plane");
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
