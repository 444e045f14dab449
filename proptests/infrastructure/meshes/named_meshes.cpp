// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/named_meshes.h"

#include <gmpxx.h>

#include <map>
#include <set>

#include "oracle/polyhedra/point_in_convex_polyhedron.h"
#include "oracle/polyhedra/point_in_polyhedron.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::named_meshes_tests {
namespace {

/// How many vertices lie on the plane of a face.
std::size_t on_plane(const Meshd& mesh, const Face& face) {
  const auto minus = [](const Point3d& p, const Point3d& q) {
    return std::array{mpq_class(mpq_class(p.x) - q.x), mpq_class(mpq_class(p.y) - q.y),
                      mpq_class(mpq_class(p.z) - q.z)};
  };
  const Point3d& a = mesh.vertices[face.a];
  const auto v = minus(mesh.vertices[face.b], a), w = minus(mesh.vertices[face.c], a);
  std::size_t count = 0;
  for (const Point3d& p : mesh.vertices) {
    const auto d = minus(p, a);
    const mpq_class volume =
        d[0] * (v[1] * w[2] - v[2] * w[1]) + d[1] * (v[2] * w[0] - v[0] * w[2]) + d[2] * (v[0] * w[1] - v[1] * w[0]);
    count += sgn(volume) == 0;
  }
  return count;
}

}  // namespace

TEST_CASE("named meshes: each is closed and convex, and all of its vertices are corners") {
  std::set<std::string> names;
  for (const auto& [name, mesh] : named_meshes()) {
    INFO(name);
    CHECK(names.insert(name).second);
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos);
    CHECK(name.ends_with("_" + std::to_string(mesh.vertices.size())));
    CHECK(mesh.vertices.size() >= 60);
    CHECK(mesh.faces.size() == 2 * mesh.vertices.size() - 4);  // Euler's formula, every vertex being in a face
    CHECK(oracle::point_in_convex_polyhedron(mesh, mesh.vertices.back()).answer == Location::boundary);
  }
  CHECK(names.size() >= 4);
}

TEST_CASE("named meshes: faces have the corners that their mesh is there for") {
  const auto corners = [](const char* name) {
    std::multiset<std::size_t> found;
    for (const NamedMesh& named : named_meshes()) {
      if (named.name != name) continue;
      for (const Face& face : named.mesh.faces) found.insert(on_plane(named.mesh, face));
    }
    return found;
  };
  CHECK(corners("geodesic_66").count(3) == 128);
  CHECK(corners("prism_64").count(32) == 60);
  CHECK(corners("prism_64").count(4) == 64);
  const auto sphere = corners("lattice_sphere_72");
  CHECK(2 * sphere.count(3) < sphere.size());
  CHECK(corners("stretched_72") == sphere);
}

TEST_CASE(
    "named meshes: those that need not be convex are closed, not convex, and of the genus and parts they should be") {
  std::set<std::string> names;
  for (const NamedMesh& named : named_meshes()) names.insert(named.name);
  const std::map<std::string, std::size_t> handles_and_parts{
      {"ring_64", 0}, {"hollow_64", 8}, {"star_66", 4}, {"stretched_star_66", 4}};  // 2 V - F: 4 - 4 g a part
  for (const auto& [name, mesh] : named_solids()) {
    INFO(name);
    CHECK(names.insert(name).second);
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos);
    CHECK(name.ends_with("_" + std::to_string(mesh.vertices.size())));
    CHECK(2 * mesh.vertices.size() - mesh.faces.size() == handles_and_parts.at(name));
    CHECK(oracle::point_in_polyhedron(mesh, mesh.vertices.back()).answer == Location::boundary);
    CHECK_THROWS_WITH(oracle::point_in_convex_polyhedron(mesh, mesh.vertices.back()),
                      ContainsSubstring("convex: vertex"));
  }
  CHECK(named_solids().size() == handles_and_parts.size());
}

TEST_CASE("named meshes: the long ones need more than 8 bits for an index, and their last vertices decide answers") {
  for (const auto& [name, mesh] : long_solids()) {
    INFO(name);
    CHECK(name.ends_with("_" + std::to_string(mesh.vertices.size())));
    CHECK(mesh.vertices.size() > 256);
    CHECK(2 * mesh.vertices.size() - mesh.faces.size() == 4);  // Euler's formula of one part without a handle
    const Point3d& last = mesh.vertices.back();
    CHECK(oracle::point_in_polyhedron(mesh, last).answer == Location::boundary);
    CHECK(oracle::point_in_polyhedron(mesh, {last.x - 6, last.y - 6, last.z - 6}).answer == Location::inside);
    CHECK(oracle::point_in_polyhedron(mesh, {last.x + 6, last.y - 6, last.z - 6}).answer == Location::outside);
  }
}

}  // namespace touchstone::proptests::named_meshes_tests
