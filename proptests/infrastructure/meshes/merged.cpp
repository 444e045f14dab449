// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/merged.h"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "audit/meshes/in_file.h"
#include "audit/meshes/repeated_faces.h"
#include "audit/meshes/rims.h"
#include "audit/meshes/shorter_faces.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::merged_tests {
namespace {

using Vertices = std::vector<Point3d>;
using Into = std::vector<Index>;

/// Single linkage by its definition: each vertex takes the least number that a near one has, until nothing changes.
Into by_definition(const Vertices& vertices, double reach) {
  Into into(vertices.size());
  for (Index v = 0; v < into.size(); ++v) into[v] = v;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index v = 0; v < into.size(); ++v) {
      for (Index w = 0; w < into.size(); ++w) {
        const Vector3d d = vertices[v] - vertices[w];
        const double apart = std::hypot(d.x, d.y, d.z);
        if ((apart == 0 || apart < reach) && into[w] < into[v]) into[v] = into[w], changed = true;
      }
    }
  }
  return into;
}

}  // namespace

TEST_CASE("merged vertices: tolerance 0 merges equal positions, -0 and 0 alike, and no others") {
  const auto merging = audit::merging_of({{1, 0, 0}, {0, 0, 0}, {-0.0, 0, -0.0}, {1, 0, 5e-324}, {1, 0, 0}}, 0);
  CHECK(merging.into == Into{0, 1, 1, 3, 0});
  CHECK(merging.merged == 2);
  CHECK(merging.largest == 0);
}

TEST_CASE("merged vertices: a chain of near vertices is one, and what is as far apart as the tolerance is not near") {
  const auto merging = audit::merging_of({{0, 0, 0}, {1.5, 0, 0}, {0.75, 0, 0}, {1024, 0, 0}, {1023, 0, 0}}, 0x1p-10);
  CHECK(merging.into == Into{0, 0, 0, 3, 4});
  CHECK(merging.merged == 2);
  CHECK(merging.largest == 1.5);
}

TEST_CASE("merged vertices: the grid finds the pairs that the definition finds") {
  std::mt19937_64 draw(1);
  const auto cell = [&draw](unsigned most) { return static_cast<double>(draw() % most); };
  for (int turn = 0; turn < 50; ++turn) {
    Vertices vertices{{0, 0, 0}, {4096, 4096, 4096}};
    for (int i = 0; i < 150; ++i) vertices.push_back({300 + cell(40) / 4, 300 + cell(40) / 4, 300 + cell(40) / 4});
    const double tolerance = 0x1p-12 * (1 + cell(8) / 4), size = audit::size_of(vertices);
    REQUIRE(size == 4096);
    CHECK(audit::merging_of(vertices, tolerance).into == by_definition(vertices, tolerance * size));
  }
}

TEST_CASE("merged vertices: of tolerances that leave as many edges open the least is told") {
  // Vertex 4 is 3e-9 from vertex 0, of a size of 2: 1e-8 makes edge 0 1 one of two faces. Vertices 5 and 6 are in none.
  const Vertices vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {3e-9, 0, 0}, {0, 0, 0.5}, {3e-6, 0, 0.5}};
  const auto closes = audit::merging_that_closes(vertices, {{0, 1, 2}, {1, 4, 3}}, 6);
  REQUIRE(closes);
  CHECK(closes->tolerance == 1e-8);
  CHECK(closes->open == 4);
  CHECK(std::pair(closes->one, closes->other) == std::pair(Index{0}, Index{4}));
  CHECK(closes->apart == 3e-9);
}

TEST_CASE("merged vertices: an edge of three faces is open, one of two or four is not") {
  CHECK(audit::count_open_edges({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}) == 7);
  CHECK(audit::count_open_edges({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}}) == 8);
}

TEST_CASE("merged vertices: three corners in one position are told as one group") {
  const auto file = audit::parse_mesh_file(
      "a.obj",
      "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 0 1\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
      "f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\n");
  CHECK(audit::hints_of_merging(file, {}) ==
        std::vector<std::string>{"12 vertices have 4 positions; with --merge it is closed"});
}

TEST_CASE("merged vertices: places of the merged mesh are those of the file") {
  const auto file = audit::parse_mesh_file("a.obj", "v 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\n");
  audit::Preparation how;
  how.merge = 0;
  const Json places =
      audit::places_in_file(file, audit::prepared(file, how), {{"open_edge", {0, 1}}, {"pinched_vertex", 1}});
  CHECK(places["open_edge"] == "edge from vertex 1 to vertex 3 (lines 1 and 3)");
  CHECK(places["pinched_vertex"] == "vertex 3 (line 3)");
}

TEST_CASE("merged vertices: faces behind one that is dropped keep their places in the file") {
  const auto shorter = audit::meshes::shorter_faces({{0, 1, 2}, {0, 3, 2}, {1, 2, 3}}, {0, 0, 2, 3});
  CHECK(shorter.faces == std::vector<std::vector<Index>>{{0, 3, 2}, {0, 2, 3}});
  CHECK(shorter.face_in_file == std::vector<std::size_t>{1, 2});
  CHECK(shorter.dropped == std::vector<std::size_t>{0});
}

TEST_CASE("merged vertices: faces are repeated wherever their corners begin, one that they name twice as well") {
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  const auto found = audit::meshes::repeated_faces({{0, 5, 0, 1, 2, 3}, {0, 1, 2, 3, 0, 5}, {3, 2, 1, 0, 5, 0}});
  CHECK(found.same == Pairs{{1, 0}});
  CHECK(found.opposed == Pairs{{2, 0}});
}

TEST_CASE("merged vertices: a T-junction names the edge within which a vertex lies") {
  const Vertices vertices{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<audit::meshes::EdgeOfFile> open{{0, 1, 0}, {0, 2, 1}, {1, 2, 2}};
  const auto rims = audit::meshes::rims_of(open, vertices);
  REQUIRE(rims.size() == 1);
  const auto found = audit::meshes::t_junction(rims[0], open, vertices);
  REQUIRE(found);
  CHECK(found->vertex == 1);
  CHECK(found->edge.face == 1);
}

TEST_CASE("merged vertices: the greatest and the least doubles do not overflow") {
  constexpr double most = std::numeric_limits<double>::max();
  CHECK(audit::merging_of({{-most, 0, 0}, {most, 0, 0}, {-most, most * 0x1p-40, 0}}, 1e-9).into == Into{0, 1, 0});
  std::size_t pairs = 0;
  audit::each_near_pair({{-most, 0, 0}, {most, 0, 0}, {-most, most * 0x1p-40, 0}}, 1e-9,
                        [&](Index v, Index w, double d) {
                          CHECK((v == 0 && w == 2 && d == most * 0x1p-40));
                          ++pairs;
                        });
  CHECK(pairs == 1);
  CHECK(audit::merging_of({{0, 0, 0}, {5e-324, 0, 0}}, 1e-9).into == Into{0, 1});
  CHECK(audit::merging_of({{0, 0, 0}, {0, 0, 0}}, 1e-9).into == Into{0, 0});
  CHECK(audit::merging_of({}, 1e-9).into.empty());
}

}  // namespace touchstone::proptests::merged_tests
