// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catalogue/codec/shape_json.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/operation/probes/fitted.h"
#include "catalogue/operation/probes/values_in.h"
#include "oracle/polyhedra/point_in_polyhedron.h"
#include "oracle/polyhedra/polyhedron_complexity.h"
#include "proptests/drawn.h"
#include "proptests/refusal.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/polyhedra/polyhedron_complexity.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::proptests::polygon_meshes_tests {
namespace {

using catalogue::Json;
using Corners = std::vector<Index>;
using Polygons = std::vector<Corners>;

/// A prism over a ring in the plane z = 0, counter-clockwise from above, up to z = height: the ring below and above,
/// and a rectangle on each edge.
Meshd prism(const std::vector<Point2d>& ring, double height) {
  std::vector<Point3d> vertices;
  for (const double z : {0.0, height})
    for (const Point2d& p : ring) vertices.push_back({p.x, p.y, z});
  const auto n = static_cast<Index>(ring.size());
  Corners below, above;
  Polygons faces;
  for (Index k = 0; k < n; ++k) {
    below.insert(below.begin(), k), above.push_back(n + k);
    faces.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  faces.push_back(below), faces.push_back(above);
  return robust::polygon_mesh(vertices, faces);
}

const std::vector<Point2d> u_shape{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

/// [-1, 1]^3 with a ninth vertex on an edge between two squares, which both name it.
const std::vector<Point3d> cube_and_midpoint{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1},
                                             {1, -1, 1},   {1, 1, -1},  {1, 1, 1},   {0, 1, 1}};
const Polygons cube_with_midpoint{{0, 1, 3, 2},    {4, 6, 7, 5}, {0, 4, 5, 1},
                                  {3, 8, 7, 6, 2}, {0, 2, 6, 4}, {3, 1, 5, 7, 8}};

/// A square of side 3 with a square hole of side 1, both one high: the ring runs around, in along a bridge, around the
/// hole and back.
Meshd frame() {
  std::vector<Point3d> vertices;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [low, high] : {std::pair{0.0, 3.0}, {1.0, 2.0}})
      vertices.insert(vertices.end(), {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}});
  }
  Polygons faces{{0, 3, 2, 1, 0, 4, 5, 6, 7, 4}, {8, 9, 10, 11, 8, 12, 15, 14, 13, 12}};
  for (Index k = 0; k < 4; ++k) {
    const Index next = (k + 1) % 4;
    faces.push_back({k, next, next + 8, k + 8});
    faces.push_back({next + 4, k + 4, k + 12, next + 12});
  }
  return robust::polygon_mesh(vertices, faces);
}

void expect_counts(const PolyhedronComplexity<double>& found, Index vertices, Index edges, Index faces) {
  CHECK(found.vertices == vertices);
  CHECK(found.edges == edges);
  CHECK(found.faces == faces);
  CHECK(found.euler == static_cast<double>(vertices) - static_cast<double>(edges) + static_cast<double>(faces));
}

/// Robust and the oracle agree, which the answer is of.
PolyhedronComplexity<double> complexity(const Meshd& mesh) {
  const auto found = robust::polyhedron_complexity(mesh);
  const auto truth = oracle::polyhedron_complexity(mesh).answer;
  CHECK(found.edges == truth.edges);
  CHECK(found.embedded == truth.embedded);
  CHECK(found.meeting_faces == truth.meeting_faces);
  CHECK(found.splitting_face == truth.splitting_face);
  return found;
}

Location where(const Meshd& mesh, const Point3d& p) {
  const Location found = robust::point_in_polyhedron(mesh, p);
  CHECK(oracle::point_in_polyhedron(mesh, p).answer == found);
  return found;
}

std::string refusal(const std::vector<Point3d>& vertices, const Polygons& polygons) {
  return refusal_of([&] { robust::polygon_mesh(vertices, polygons); });
}

TEST_CASE("polygon meshes: a concave face is the polygon that it is") {
  const Meshd u = prism(u_shape, 1);
  const auto found = complexity(u);
  expect_counts(found, 16, 24, 10);
  CHECK((found.closed && found.oriented && found.edge_manifold && found.vertex_manifold && found.embedded));
  CHECK_FALSE(found.convex);
  CHECK(found.volume == VolumeSign::positive);
  CHECK(where(u, {1.5, 2, 1}) == Location::outside);
  CHECK(where(u, {1.5, 2, 0.5}) == Location::outside);
  CHECK(where(u, {0.5, 2, 1}) == Location::boundary);
  CHECK(where(u, {1.5, 0.5, 0.5}) == Location::inside);
}

TEST_CASE("polygon meshes: a corner on an edge changes no word") {
  const auto found = complexity(robust::polygon_mesh(cube_and_midpoint, cube_with_midpoint));
  expect_counts(found, 9, 13, 6);
  CHECK((found.closed && found.oriented && found.edge_manifold && found.vertex_manifold && found.embedded &&
         found.convex));
  CHECK(found.volume == VolumeSign::positive);
}

TEST_CASE("polygon meshes: a hole by a bridge") {
  const Meshd mesh = frame();
  const auto found = complexity(mesh);
  expect_counts(found, 16, 26, 10);  // two bridges; V - E + F of a torus
  CHECK((found.closed && found.oriented && found.edge_manifold && found.vertex_manifold && found.embedded));
  CHECK(where(mesh, {1.5, 1.5, 1}) == Location::outside);
  CHECK(where(mesh, {0.5, 0.5, 1}) == Location::boundary);  // on the bridge
  CHECK(where(mesh, {0.5, 1.5, 0.5}) == Location::inside);
}

TEST_CASE("polygon meshes: an edge of one face along a diagonal of another is contact") {
  // A square on the ground, and two triangles back to back on two opposite corners of it.
  const std::vector<Point3d> vertices{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 2}};
  for (const Corners& square : {Corners{0, 1, 2, 3}, {1, 2, 3, 0}}) {
    const Meshd fin = robust::polygon_mesh(vertices, {square, {3, 2, 1, 0}, {0, 2, 4}, {2, 0, 4}});
    const auto found = complexity(fin);
    CHECK(found.closed);
    CHECK(found.edge_manifold);
    CHECK(found.meeting_faces == std::optional(IndexPair{0, 1}));
  }
  const Meshd one =
      robust::polygon_mesh(vertices, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 4}});
  CHECK(complexity(one).meeting_faces == std::optional(IndexPair{0, 5}));
}

TEST_CASE("polygon meshes: what is no polygon in a plane is refused by its place") {
  const std::vector<Point3d> p{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 0, 0},
                               {2, 2, 0}, {0, 0, 1}, {2, 2, 1}, {2, 0, 0}, {0x1p-1074, 0, 0}};
  const std::string ring = "mesh.faces[1]: a polygon that encloses one area and does not cross itself";
  const auto second = [&p](const Corners& face) { return refusal(p, {{0, 1, 2}, face}); };
  CHECK(second({0, 1, 2, 3}) == "accepted");
  CHECK(second({0, 4, 1, 2, 3}) == "accepted");
  CHECK(second({0, 2, 1, 3}) == ring);              // crosses itself
  CHECK(second({0, 1, 2, 3, 4}) == ring);           // touches its own edge
  CHECK(second({0, 4, 1, 4}) == ring);              // no area
  CHECK(second({0, 1, 1, 2}) == ring);              // a corner twice in a row
  CHECK(second({0, 1, 2, 3, 0, 1, 2, 3}) == ring);  // around twice
  CHECK(second({0, 4, 5, 2, 3, 5}) == ring);        // two parts with one corner in common
  CHECK(second({0, 4, 8, 1, 2}) == ring);           // two vertices in one position, one after the other
  CHECK(second({0, 1, 2, 6}) == "mesh.faces[1]: planar");
  CHECK(second({9, 1, 2, 3}) == "accepted");  // a subnormal is a number like others
  CHECK(second({0, 1}) == "mesh.faces[1]: at least 3 corners");
  CHECK(second({0, 1, 2, 10}) == "mesh.faces[1][3]: index of a vertex");
}

TEST_CASE("polygon meshes: thickness of a quadrilateral is the distance of its diagonals' lines") {
  const std::vector<Point3d> p{{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1}};
  CHECK(robust::thickness(p, {0, 1, 2, 3}) == 1);
  CHECK(robust::thickness(p, {0, 1, 2}) == 0);
  for (const int exponent : {-1022, -400, 400, 1022}) {
    std::vector<Point3d> scaled;
    for (const Point3d& q : p)
      scaled.push_back({std::scalbn(q.x, exponent), std::scalbn(q.y, exponent), std::scalbn(q.z, exponent)});
    CHECK(robust::thickness(scaled, {0, 1, 2, 3}) == std::scalbn(1, exponent));
  }
}

/// Every mesh of the question with other cuts of its polygons.
Question cut_anew(const Operation& operation, const Question& question, std::uint64_t seed) {
  Question result = question;
  DrawStream draws = DrawStream::seeded(seed);
  catalogue::for_each_value<Meshd>(operation, question, [&](const Meshd& mesh, const catalogue::Cursor<double>& first) {
    const auto words = catalogue::packed(catalogue::recut(mesh, draws)).words;
    std::copy(words.begin(), words.end(), result.words.begin() + (first.word - question.words.data()));
  });
  return result;
}

/// What is wrong with the answers to other cuts. Counts the questions that have some.
std::string complaint_of_other_cut(const Operation& operation, const Question& question, int& compared) {
  std::unique_ptr<catalogue::Examination> one;
  try {
    one = operation.examine(question);
  } catch (const InvalidInput&) {
    return "";
  }
  const Question anew = cut_anew(operation, question, 1);
  if (anew == question) return "";
  const auto other = operation.examine(anew);
  ++compared;
  if (one->truth() != other->truth()) return "another truth";
  return one->robust() == other->robust() ? "" : "another answer of robust";
}

TEST_CASE("polygon meshes: any valid cut gives the same truth and the same answer of robust") {
  for (const char* name : {"polyhedron_complexity", "point_in_polyhedron", "point_in_convex_polyhedron",
                           "polyhedron_polyhedron", "swept_convex_polyhedra", "convex_distance", "point_mesh_distance",
                           "ray_mesh", "swept_sphere_mesh"}) {
    CAPTURE(name);
    const Operation& operation = *catalogue::find_operation(name);
    int compared = 0;
    for (std::size_t family = 0; family < operation.families().size(); ++family) {
      if (operation.families()[family] != "polygons" && operation.families()[family] != "prisms") continue;
      for (int seed = 0; seed < scaled(40); ++seed) {
        const Drawn drawn = recorded(operation, family, static_cast<std::uint64_t>(seed));
        const std::string complaint = complaint_of_other_cut(operation, drawn.question, compared);
        if (!complaint.empty()) FAIL_CHECK(complaint + ": " + tests::shown(drawn));
      }
    }
    CHECK(compared > 0);
  }
}

TEST_CASE("polygon meshes: JSON names polygons, and shows their cut") {
  const Operation& operation = *catalogue::find_operation("point_in_polyhedron");
  Json input = Json::object();
  input["mesh"] = catalogue::to_json(prism(u_shape, 1));
  input["point"] = Json::array({1.5, 2, 1});
  CHECK(input["mesh"]["faces"].size() == 10);
  CHECK(input["mesh"]["cut"].size() == 28);
  const auto parse = [&](const Json& json) {
    return operation.parse(catalogue::parse_line(catalogue::one_line(json)));
  };
  const Question question = parse(input);
  Json without = input;
  without["mesh"].erase("cut");
  CHECK(parse(without) == question);
  const auto answer = [&](const Json& json) -> std::string {
    try {
      return operation.examine(parse(json))->outcome();
    } catch (const InvalidInput& refused) {
      return refused.what();
    }
  };
  CHECK(answer(input) == "outside");
  Json wrong = input;
  std::swap(wrong["mesh"]["cut"][0][0], wrong["mesh"]["cut"][0][1]);
  CHECK(answer(wrong) == "mesh.cut: a cut of the faces into triangles");
  wrong = input, wrong["mesh"]["cut"].erase(0);
  CHECK(answer(wrong) == "mesh.cut: a cut of the faces into triangles");
  wrong = without, wrong["mesh"]["vertices"][8][2] = 3;
  CHECK(answer(wrong).starts_with("mesh.faces[9]: planar: its corners lie "));
}

TEST_CASE("polygon meshes: engines are asked triangles unless they declare polygons") {
  const Operation& operation = *catalogue::find_operation("polyhedron_polyhedron");
  const Meshd u = prism(u_shape, 1), cube = robust::polygon_mesh(cube_and_midpoint, cube_with_midpoint);
  const Question question = catalogue::packed(std::tuple{u, cube});
  catalogue::Declaration declaration;
  declaration.skew_boxes = true;
  const Meshd u_triangles{u.vertices, u.faces, {}}, cube_triangles{cube.vertices, cube.faces, {}};
  CHECK(catalogue::fitted(operation, question, declaration) ==
        catalogue::packed(std::tuple{u_triangles, cube_triangles}));
  declaration.polygons = true;
  CHECK(catalogue::fitted(operation, question, declaration) == question);
}

}  // namespace
}  // namespace touchstone::proptests::polygon_meshes_tests
