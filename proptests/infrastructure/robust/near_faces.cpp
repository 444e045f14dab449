// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/near_faces.h"

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "catalogue/families/draw_stream.h"
#include "oracle/polyhedra/polyhedron_complexity.h"
#include "proptests/catch.h"
#include "robust/polyhedra/polyhedron_complexity.h"
#include "robust/structures/box_order.h"

/// Triangles around a vertex of many: looked at in few pairs, and in all that meet.
namespace touchstone::proptests::near_faces_tests {
namespace {

using catalogue::DrawStream;

/// n triangles around the last vertex; the others are on a circle, as high as `height` says.
template <class Height>
Meshd cake(Index n, const Height& height, double size = 1, const Point3d& middle = {0, 0, 0}) {
  Meshd mesh;
  for (Index i = 0; i < n; ++i) {
    const double u = 6.283185307179586 * i / n;
    mesh.vertices.push_back(
        {middle.x + size * std::cos(u), middle.y + size * std::sin(u), middle.z + size * height(i)});
    mesh.faces.push_back({i, (i + 1) % n, n});
  }
  mesh.vertices.push_back(middle);
  return mesh;
}
double flat(Index) { return 0; }

std::vector<Aabb3d> boxes_of(const Meshd& mesh) {
  std::vector<Aabb3d> boxes;
  for (const Face& f : mesh.faces) {
    Aabb3d box{mesh.vertices[f.a], mesh.vertices[f.a]};
    for (const Index v : {f.b, f.c}) box = robust::structures::around(box, {mesh.vertices[v], mesh.vertices[v]});
    boxes.push_back(box);
  }
  return boxes;
}

std::size_t looks_of(const Meshd& mesh) {
  std::set<std::pair<Index, Index>> looks;
  robust::structures::look_at_near_faces(mesh, boxes_of(mesh), [&looks](Index i, Index j) {
    CHECK(i < j);
    CHECK(looks.emplace(i, j).second);
  });
  return looks.size();
}

void check_as_oracle(const Meshd& mesh) {
  const auto truth = oracle::polyhedron_complexity(mesh).answer;
  const auto found = robust::polyhedron_complexity(mesh);
  CHECK(found.meeting_faces == truth.meeting_faces);
  CHECK(found.embedded == truth.embedded);
}

}  // namespace

TEST_CASE("near faces: each slice of a cake is looked at with its neighbours alone") {
  // A slice is between two others, and cones that share an edge of the cube of directions may be looked at as well.
  for (const Index n : {500U, 8000U}) {
    CHECK(looks_of(cake(n, flat)) < 3 * n);
    CHECK(looks_of(cake(n, [](Index i) { return i % 2 == 0 ? 0.25 : -0.25; })) < 8 * n);
  }
}

TEST_CASE("near faces: around a vertex of few all pairs are looked at whose boxes meet") {
  // The boxes of all hold the middle.
  CHECK(looks_of(cake(32, flat)) == 32 * 31 / 2);
}

TEST_CASE("near faces: a cake is embedded, and one with a slice too many is not, wherever that is") {
  DrawStream draws = DrawStream::seeded(1);
  for (int i = 0; i < 20; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(draws.below(41)) - 20);
    const Point3d middle{static_cast<double>(draws.below(9)), -static_cast<double>(draws.below(9)), 3};
    const auto height = [i](Index k) { return i % 2 == 0 ? 0.0 : static_cast<double>(k * k % 7) / 8; };
    Meshd mesh = cake(40, height, size, middle);
    check_as_oracle(mesh);
    const auto from = static_cast<Index>(draws.below(40)), to = static_cast<Index>((from + 2 + draws.below(5)) % 40);
    mesh.faces.push_back({from, to, 40});
    check_as_oracle(mesh);
    std::swap(mesh.faces.back(), mesh.faces[draws.below(40)]);
    check_as_oracle(mesh);
  }
}

TEST_CASE("near faces: at the ends of the range of doubles") {
  for (const double size : {0x1p-1070, 0x1p-1040, 0x1p-960, 0x1p1023}) {
    Meshd mesh = cake(40, flat, size);
    // Rounded to so few digits, slices may have no area.
    if (robust::polyhedron_complexity(mesh).flat_face) continue;
    check_as_oracle(mesh);
    mesh.faces.push_back({3, 7, 40});
    check_as_oracle(mesh);
  }
  check_as_oracle(cake(40, flat, 0x1p1023, {0x1p1022, -0x1p1022, 0x1p1023}));
}

TEST_CASE("near faces: slices around two vertices, and faces that are far from both") {
  Meshd mesh = cake(40, flat);
  // Another one above it, upside down, around a vertex of its own; both have the rim.
  mesh.vertices.push_back({0, 0, 1});
  for (Index i = 0; i < 40; ++i) mesh.faces.push_back({(i + 1) % 40, i, 41});
  check_as_oracle(mesh);
  mesh.vertices.insert(mesh.vertices.end(), {{0.5, 0.25, -1}, {0.5, 0.25, 2}, {9, 9, 9}, {0.5, 9, 9}});
  mesh.faces.push_back({42, 45, 44});
  check_as_oracle(mesh);
  mesh.faces.push_back({42, 43, 44});  // through both cakes
  check_as_oracle(mesh);
}

TEST_CASE("near faces: faces that go around a vertex twice, all of them seen from one side, meet") {
  Meshd mesh{{{0, 0, 1}, {0, 0, -9}}, {}};
  const std::array<Point3d, 3> around{{{4, 0, 0}, {-2, 3, 0}, {-2, -3, 0}}};
  for (Index k = 0; k < 6; ++k) {
    const Point3d& p = around[k % 3];
    const double size = k < 3 ? 1 : 2;
    mesh.vertices.push_back({size * p.x, size * p.y, -size});
  }
  for (Index k = 0; k < 6; ++k) mesh.faces.push_back({0, 2 + k, 2 + (k + 1) % 6});
  for (Index k = 0; k < 6; ++k) mesh.faces.push_back({1, 2 + (k + 1) % 6, 2 + k});
  const auto found = robust::polyhedron_complexity(mesh);
  CHECK((found.closed && found.oriented && found.vertex_manifold && !found.embedded));
  check_as_oracle(mesh);
}

TEST_CASE("splitting faces: the first of a ball of many vertices, one of which is moved into it") {
  constexpr Index around = 16, rings = 15;
  for (const Index moved : {0U, 17U, 130U, 239U, 241U}) {
    Meshd mesh{{{0, 0, 32}}, {}};
    for (Index ring = 1; ring <= rings; ++ring) {
      for (Index k = 0; k < around; ++k) {
        const double height = 3.141592653589793 * ring / (rings + 1), angle = 6.283185307179586 * k / around;
        mesh.vertices.push_back(
            {32 * std::sin(height) * std::cos(angle), 32 * std::sin(height) * std::sin(angle), 32 * std::cos(height)});
      }
    }
    mesh.vertices.push_back({0, 0, -32});
    const auto at = [](Index ring, Index k) { return 1 + (ring - 1) * around + k % around; };
    const auto last = static_cast<Index>(mesh.vertices.size() - 1);
    for (Index k = 0; k < around; ++k) {
      mesh.faces.insert(mesh.faces.end(), {{0, at(1, k), at(1, k + 1)}, {last, at(rings, k + 1), at(rings, k)}});
      for (Index ring = 1; ring < rings; ++ring) {
        mesh.faces.push_back({at(ring, k), at(ring + 1, k), at(ring, k + 1)});
        mesh.faces.push_back({at(ring, k + 1), at(ring + 1, k), at(ring + 1, k + 1)});
      }
    }
    Point3d& p = mesh.vertices[moved];
    p = {0.75 * p.x, 0.75 * p.y, 0.75 * p.z};
    const auto truth = oracle::polyhedron_complexity(mesh).answer;
    const auto found = robust::polyhedron_complexity(mesh);
    CHECK(found.splitting_face);
    CHECK(found.splitting_face == truth.splitting_face);
    CHECK((found.embedded && found.volume == VolumeSign::positive && truth.volume == VolumeSign::positive));
  }
}

}  // namespace touchstone::proptests::near_faces_tests
