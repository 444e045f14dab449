// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/prepared.h"

#include <algorithm>

#include "audit/meshes/askew.h"
#include "audit/meshes/diagnosis.h"
#include "geometry/invalid_input.h"
#include "proptests/catch.h"
#include "proptests/refusal.h"
#include "proptests/uses.h"

/// Meshes of files with merged vertices and other cuts; all expected values are worked by hand.
namespace touchstone::proptests::prepared_tests {
namespace {

using audit::parse_mesh_file;
using audit::Preparation;
using audit::prepared;
using Places = std::vector<std::size_t>;
using Done = std::vector<std::string>;

/// The corners of the unit square are raised and lowered in turn: its normal is the z-axis, and its thickness 1/4.
const char* const saddle = "v 0 0 0\nv 1 0 0.25\nv 1 1 0\nv 0 1 0.25\nf 1 2 3 4\n";

audit::PreparedMesh made(const std::string& obj, const Preparation& how = {}) {
  return prepared(parse_mesh_file("a.obj", obj), how);
}

void require_refused(const std::string& obj, const Preparation& how, const std::string& words) {
  CHECK(refusal_of([&] { made(obj, how); }) == words);
}

bool all_have(const std::vector<Face>& faces, Index one, Index other) {
  return std::all_of(faces.begin(), faces.end(), [&](const Face& f) {
    const auto has = [&f](Index v) { return f.a == v || f.b == v || f.c == v; };
    return has(one) && has(other);
  });
}

}  // namespace

TEST_CASE("prepared meshes: a planar face is the polygon that it is") {
  const auto mesh = made("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
  CHECK(mesh.mesh.polygons == std::vector<std::vector<Index>>{{0, 1, 2, 3, 4}});
  CHECK(mesh.mesh.faces.size() == 3);
  CHECK(mesh.face_in_file == Places{0});
  CHECK(mesh.vertex_in_file == Places{0, 1, 2, 3, 4});
  CHECK(mesh.done.empty());
}

TEST_CASE("prepared meshes: a face that is not planar is refused with its place and how far it is off") {
  require_refused(
      saddle, {},
      "a.obj:5: face 1 (mesh.faces[0]): planar: its corners lie 0.25 apart across it; --planar TOLERANCE or "
      "--cut fan|shortest makes a solid of it");
  Preparation how;
  how.planar = 0.125;
  require_refused(
      std::string(saddle) + "v 0 0 1\nv 1 0 1.5\nv 1 1 1\nv 0 1 1.5\n# thicker\nf 5 6 7 8\n", how,
      "a.obj:5: face 1 (mesh.faces[0]): planar: its corners lie 0.25 apart across it, and 1 face more is not "
      "planar, the worst face 2 (line 11), by 0.5; --planar TOLERANCE or --cut fan|shortest makes a solid of "
      "them");
}

TEST_CASE("prepared meshes: a face as thick as the tolerance is cut as its projection") {
  Preparation how;
  how.planar = 0.25;
  const auto mesh = made(saddle, how);
  CHECK(mesh.mesh.faces.size() == 2);
  CHECK(mesh.mesh.polygons.empty());
  CHECK(mesh.mesh.vertices[1] == Point3d{1, 0, 0.25});
  CHECK(mesh.face_in_file == Places{0, 0});
  CHECK(mesh.done ==
        Done{"1 face cut as seen along an axis: the corners are not in one plane but up to 0.25 apart across it"});
}

TEST_CASE("prepared meshes: a projection that crosses itself is no cut") {
  const std::vector<Point3d> crossing{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 2, 1}};
  CHECK_FALSE(audit::cut_as_projected(crossing, {0, 1, 2, 3}));
}

TEST_CASE("prepared meshes: a fan leaves the first corner, and shortest diagonals are chosen among those inside") {
  const std::string rhombus = "v 0 0 0.5\nv 3 -1 0\nv 6 0 0.5\nv 3 1 0\nf 1 2 3 4\n";
  Preparation fan, shortest;
  fan.cut = Preparation::Cut::fan, shortest.cut = Preparation::Cut::shortest;
  CHECK(made(rhombus, fan).mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 2, 3}});
  const auto along = made(rhombus, shortest);
  CHECK(along.mesh.faces.size() == 2);
  CHECK(all_have(along.mesh.faces, 1, 3));
  CHECK(along.done ==
        Done{"1 face cut along shortest diagonals: the corners are not in one plane but up to 0.5 apart across it"});
  // The diagonal from -1 to 1 along y = 0 is the shorter one, and outside.
  const auto dart = made("v 0 4 0\nv -1 0 0.25\nv 0 1 0\nv 1 0 0.25\nf 1 2 3 4\n", shortest);
  CHECK(dart.mesh.faces.size() == 2);
  CHECK(all_have(dart.mesh.faces, 0, 2));
}

TEST_CASE("prepared meshes: planar faces beside a cut one stay polygons") {
  Preparation fan;
  fan.cut = Preparation::Cut::fan;
  const auto mesh = made(std::string(saddle) + "v 0 0 9\nv 1 0 9\nv 1 1 9\nv 0 1 9\nf 5 6 7 8\n", fan);
  CHECK(mesh.mesh.polygons == std::vector<std::vector<Index>>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6, 7}});
  CHECK(mesh.face_in_file == Places{0, 0, 1});
}

TEST_CASE("prepared meshes: of a corner that is there twice it is said what to drop, and merging drops it") {
  const std::string twice = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 2 3\n";
  require_refused(
      twice, {},
      "a.obj:4: face 1 (mesh.faces[0]): names vertex 2 (line 2) twice in a row; drop one of the two corners, "
      "or --merge does");
  const std::string position = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nf 1 2 3 4\nf 1 2 3 4\n";
  require_refused(position, {},
                  "a.obj:5: face 1 (mesh.faces[0]): vertices 4 and 1 (lines 4 and 1), corners in a row, have one "
                  "position; drop one of the two corners, or --merge does; so it is with 1 face more");
  Preparation merge;
  merge.merge = 0;
  const auto mesh = made(position, merge);
  CHECK(mesh.mesh.vertices.size() == 3);
  CHECK(mesh.mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 1, 2}});
  CHECK(mesh.done == Done{"1 vertex merged into others, those in equal positions; 3 vertices left",
                          "2 faces left without the corners that would stand twice in a row: face 1 (line 5), face 2 "
                          "(line 6)"});
}

TEST_CASE("prepared meshes: merged vertices are those of the file that come first, and a face may vanish") {
  Preparation merge;
  merge.merge = 0.0078125;  // nearer than 1 of 128
  const auto mesh = made("v 0 0 0\nv 128 0 0\nv 0 0 0.5\nv 0 128 0\nv 0 1 0\nf 1 2 3\nf 3 2 4\nf 5 2 4\n", merge);
  CHECK(mesh.vertex_in_file == Places{0, 1, 3, 4});
  CHECK(mesh.mesh.faces == std::vector<Face>{{0, 1, 2}, {3, 1, 2}});
  CHECK(mesh.face_in_file == Places{1, 2});
  CHECK(mesh.done == Done{"1 vertex merged into others, those nearer than 0.0078125 of the size 128, the largest "
                          "distance being 0.5; 4 vertices left",
                          "1 face with fewer than three corners left dropped: face 1 (line 6)"});
}

TEST_CASE("prepared meshes: how far a face is off counts both sides of its first corner") {
  // A square whose sides' middles are raised and lowered in turn; half a turn maps it to itself, so the normal is z.
  require_refused(
      "v 0 0 0\nv 1 0 0.25\nv 2 0 0\nv 2 1 -0.25\nv 2 2 0\nv 1 2 0.25\nv 0 2 0\nv 0 1 -0.25\nf 1 2 3 4 5 6 7 8\n", {},
      "a.obj:9: face 1 (mesh.faces[0]): planar: its corners lie 0.5 apart across it; --planar TOLERANCE or "
      "--cut fan|shortest makes a solid of it");
}

TEST_CASE("prepared meshes: of faces that are not planar the worst is told, wherever it stands") {
  // Saddles 1/4, 1/2 and 1/8 thick.
  const auto saddle_at = [](const std::string& x, const std::string& next, const std::string& height) {
    return "v " + x + " 0 0\nv " + next + " 0 " + height + "\nv " + next + " 1 0\nv " + x + " 1 " + height + "\n";
  };
  require_refused(
      saddle_at("0", "1", "0.25") + saddle_at("2", "3", "0.5") + saddle_at("4", "5", "0.125") +
          "f 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\n",
      {},
      "a.obj:13: face 1 (mesh.faces[0]): planar: its corners lie 0.25 apart across it, and 2 faces more are "
      "not planar, the worst face 2 (line 14), by 0.5; --planar TOLERANCE or --cut fan|shortest makes a "
      "solid of them");
}

TEST_CASE("prepared meshes: the shortest diagonal is found whatever axis the face looks along") {
  // The saddle with 1 to 3 the longer diagonal, seen along y from above and below, and along x.
  const std::vector<Point3d> along_y{{0, 0, 0}, {0, 0.25, 1}, {2, 0, 1}, {1, 0.25, 0}},
      along_x{{0, 0, 0}, {0.25, 1, 0}, {0, 2, 1}, {0.25, 0, 1}};
  for (const auto& vertices : {along_y, along_x}) {
    for (const std::vector<Index>& corners : {std::vector<Index>{0, 1, 2, 3}, {3, 2, 1, 0}}) {
      const auto cut = audit::cut_along_shortest(vertices, corners);
      REQUIRE(cut);
      CHECK(cut->size() == 2);
      CHECK(all_have(*cut, 1, 3));
    }
  }
}

TEST_CASE("prepared meshes: a diagnosis cuts as it is told to, and faces around a hole look no way") {
  // A pyramid whose base is a saddle; without its last side.
  const std::string pyramid = "v 0 0 0\nv 1 0 0.25\nv 1 1 0\nv 0 1 0.25\nv 0.5 0.5 2\n",
                    open = "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\n";
  Preparation how;
  how.cut = Preparation::Cut::shortest;
  const auto closed = audit::diagnosed(parse_mesh_file("a.obj", pyramid + open + "f 4 1 5\n"), how);
  CHECK(closed.solid());
  CHECK(closed.done ==
        Done{"1 face cut along shortest diagonals: the corners are not in one plane but up to 0.25 apart "
             "across it"});
  const auto inwards =
      audit::diagnosed(parse_mesh_file("a.obj", pyramid + "f 1 2 3 4\nf 5 2 1\nf 5 3 2\nf 5 4 3\n"), how);
  REQUIRE(inwards.found.size() == 1);
  CHECK(inwards.found[0].defect == audit::MeshDefect::open_edge);
  CHECK(inwards.reversed.empty());
}

}  // namespace touchstone::proptests::prepared_tests
