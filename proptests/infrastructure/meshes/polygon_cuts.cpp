// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "catalogue/families/meshes/drawn_cut.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/meshes/prism_draws.h"
#include "catalogue/families/meshes/wrong_cuts.h"
#include "oracle/exact/solids/polygon_faces.h"
#include "oracle/polyhedra/point_in_polyhedron.h"
#include "proptests/drawn.h"
#include "proptests/refusal.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/polyhedra/polyhedron_complexity.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::proptests::polygon_cuts_tests {
namespace {

using Corners = std::vector<Index>;

DrawStream seeded(std::uint64_t i) { return DrawStream::seeded(catalogue::seed_of(1, "polygon_cuts", i)); }

/// The triangles as sets of vertices.
std::set<std::set<Index>> drawn(const std::vector<Point3d>& vertices, const Corners& corners, std::uint64_t seed) {
  DrawStream draws = seeded(seed);
  std::set<std::set<Index>> found;
  const auto cut = catalogue::PolygonCutter(vertices).cut(corners, draws);
  for (const Face& f : cut.value_or(std::vector<Face>{})) found.insert({f.a, f.b, f.c});
  return found;
}

/// How many different cuts are drawn of a polygon.
std::size_t cuts(const std::vector<Point3d>& vertices, const Corners& corners) {
  std::set<std::set<std::set<Index>>> found;
  for (std::uint64_t i = 0; i < 400; ++i) found.insert(drawn(vertices, corners, i));
  found.erase(std::set<std::set<Index>>{});
  return found.size();
}

TEST_CASE("polygon cuts: every valid cut of a polygon is drawn, and no other") {
  const std::vector<Point3d> hexagon{{2, 0, 1}, {4, 0, 1}, {6, 2, 1}, {4, 4, 1}, {2, 4, 1}, {0, 2, 1}};
  CHECK(cuts(hexagon, {0, 1, 2, 3, 4, 5}) == 14);  // the fourth Catalan number
  CHECK(cuts(hexagon, {5, 4, 3, 2, 1, 0}) == 14);
  const std::vector<Point3d> p{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 0, 1}};
  CHECK(cuts(p, {0, 4, 1, 2, 3}) == 3);           // a flat corner: all but the two that join its neighbours
  CHECK(cuts(p, {0, 1, 6, 3}) == 1);              // concave: from the corner that turns back
  CHECK(cuts(p, {0, 5, 0, 1, 2, 3}) == 1);        // along a bridge and back
  CHECK(cuts(p, {0, 2, 1, 3}) == 0);              // crosses itself
  CHECK(cuts(p, {0, 1, 2, 3, 4}) == 0);           // touches its own edge
  CHECK(cuts(p, {0, 4, 1, 4}) == 0);              // no area
  CHECK(cuts(p, {0, 1, 1, 2}) == 0);              // a corner twice in a row
  CHECK(cuts(p, {0, 1, 2, 3, 0, 1, 2, 3}) == 0);  // around twice
  CHECK(cuts(p, {0, 4, 5, 2, 3, 5}) == 0);        // two parts with one corner in common
  CHECK(cuts(p, {0, 1, 2, 7}) == 0);              // not planar
}

std::string refusal(void (*validate)(const std::string&, const Meshd&), const Meshd& mesh) {
  return refusal_of([&] { validate("mesh", mesh); });
}

std::string refused_by_both(const Meshd& mesh) {
  const std::string found = refusal(robust::kernel::validate_polygons, mesh);
  CHECK(refusal(oracle::validate_polygons, mesh) == found);
  return found;
}

TEST_CASE("polygon cuts: each rule of a cut refuses alone") {
  DrawStream simplest = DrawStream::replayed({});
  const Meshd cube = catalogue::drawn_prism(simplest);
  CHECK(refused_by_both(cube) == "accepted");
  const std::string cut = "mesh.cut: a cut of the faces into triangles";
  // From another corner on; far away; over another vertex in the same position; turned over; that of another face.
  const std::array<std::string, 5> of_triangle{"accepted", cut, cut, cut, cut};
  for (std::uint8_t kind = 0; kind < of_triangle.size(); ++kind) {
    CAPTURE(kind);
    const std::array<std::uint8_t, 3> bytes{0, kind, 5};
    DrawStream draws = DrawStream::replayed(bytes);
    CHECK(refused_by_both(catalogue::with_wrong_cut(cube, draws)) == of_triangle[kind]);
  }
  // A triangle; a corner within one; one without an area; two with an area in common; two vertices in one position.
  const std::array<std::string, 5> of_polygon{"accepted", cut, cut, cut, "accepted"};
  for (std::uint8_t kind = 0; kind < of_polygon.size(); ++kind) {
    CAPTURE(kind);
    DrawStream draws = DrawStream::replayed({&kind, 1});
    CHECK(refused_by_both(catalogue::with_wrong_polygon(cube, draws)) == of_polygon[kind]);
  }
  // Another boundary, twice; a vertex that is no corner.
  for (std::uint8_t kind = 0; kind < 3; ++kind) {
    CAPTURE(kind);
    DrawStream draws = DrawStream::replayed({&kind, 1});
    CHECK(refused_by_both(catalogue::with_foreign_cut(cube, draws)) == cut);
  }
}

TEST_CASE("polygon cuts: triangles over a vertex that is no corner of the polygon do not cut it") {
  // The last vertex is within the triangle 0 1 2. A bridge to it and back; the same along an edge instead.
  const std::vector<Point3d> p{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}};
  const std::vector<Face> triangles{{0, 1, 3}, {3, 1, 2}, {0, 3, 2}};
  CHECK(refused_by_both({p, triangles, {{0, 1, 3, 1, 2}}}) == "accepted");
  CHECK(refused_by_both({p, triangles, {{0, 1, 0, 1, 2}}}) == "mesh.cut: a cut of the faces into triangles");
}

TEST_CASE("polygon cuts: triangles over its corners that have another boundary do not cut a polygon") {
  const std::vector<Point3d> dart{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  CHECK(refused_by_both({dart, {{0, 1, 2}, {0, 2, 3}}, {{0, 1, 2, 3}}}) == "accepted");
  CHECK(refused_by_both({dart, {{0, 1, 2}, {1, 3, 2}}, {{0, 1, 2, 3}}}) ==
        "mesh.cut: a cut of the faces into triangles");
}

TEST_CASE("polygon cuts: robust answers of any valid cut as of its own") {
  std::size_t meeting = 0, other = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    CAPTURE(i);
    DrawStream draws = seeded(i);
    Meshd mesh = i % 2 == 0 ? catalogue::drawn_prism(draws) : catalogue::two_prisms(draws);
    if (i % 4 == 0) mesh = catalogue::with_fin(mesh, draws);
    CHECK(refused_by_both(mesh) == "accepted");
    const Meshd own = robust::polygon_mesh(mesh.vertices, mesh.polygons);
    if (own.faces == mesh.faces) continue;
    const auto found = robust::polyhedron_complexity(mesh), of_own = robust::polyhedron_complexity(own);
    CHECK(found.embedded == of_own.embedded);
    CHECK(found.convex == of_own.convex);
    CHECK(found.meeting_faces == of_own.meeting_faces);
    CHECK(found.splitting_face == of_own.splitting_face);
    CHECK(found.nesting == of_own.nesting);
    ++other, meeting += found.meeting_faces.has_value();
    if (!found.closed) continue;
    const Point3d p = mesh.vertices[0], q = mesh.vertices[mesh.vertices.size() / 2];
    const Point3d middle{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    CHECK(robust::point_in_polyhedron(mesh, middle) == robust::point_in_polyhedron(own, middle));
  }
  CHECK(other > 100);
  CHECK(meeting > 20);
  CHECK(meeting < other);
}

TEST_CASE("polygon cuts: the edge that keeps a mesh open is named as its face has it, whatever the cut") {
  DrawStream simplest = DrawStream::replayed({});
  Meshd open = catalogue::drawn_prism(simplest);  // a cube of squares
  open.polygons.erase(open.polygons.begin());
  std::set<std::vector<std::array<Index, 3>>> cuts;
  for (std::uint64_t i = 0; i < 8; ++i) {
    DrawStream draws = seeded(i);
    const Meshd mesh = catalogue::recut(open, draws);
    std::vector<std::array<Index, 3>> cut;
    for (const Face& f : mesh.faces) cut.push_back({f.a, f.b, f.c});
    cuts.insert(cut);
    const std::string found = refusal_of([&] { robust::point_in_polyhedron(mesh, {1, 1, 1}); });
    CHECK(found == "mesh.faces[1]: closed: the edge from vertex 0 to vertex 1 must be in an even number of faces");
    CHECK(refusal_of([&] { oracle::point_in_polyhedron(mesh, {1, 1, 1}); }) == found);
  }
  CHECK(cuts.size() > 1);
}

}  // namespace
}  // namespace touchstone::proptests::polygon_cuts_tests
