// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "audit/meshes/formats/mesh_file.h"
#include "catalogue/codec/json.h"
#include "program/commands/commands.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// `touchstone mesh`: words by hand for small meshes, and repairs that are solids.
namespace touchstone::proptests::mesh_command_tests {
namespace {

using Faces = std::vector<std::vector<int>>;

const Faces cube_faces{{4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}};

/// The eight lines of a cube's vertices.
std::string corners(double from, double to) {
  std::string text;
  for (const double z : {from, to})
    for (const auto& [x, y] : {std::pair{from, from}, {to, from}, {to, to}, {from, to}})
      text += fmt::format("v {} {} {}\n", x, y, z);
  return text;
}

std::string faces(const Faces& all, int behind = 0) {
  std::string text;
  for (const std::vector<int>& face : all) {
    text += 'f';
    for (const int v : face) text += ' ' + std::to_string(v + behind);
    text += '\n';
  }
  return text;
}

std::vector<int> reversed(std::vector<int> face) { return {face.rbegin(), face.rend()}; }

Faces inside_out() {
  Faces all;
  for (const auto& face : cube_faces) all.push_back(reversed(face));
  return all;
}

/// A vertex for each corner of a cube, as exporters write it.
std::string split_cube(const Faces& all) {
  constexpr std::array<std::array<int, 3>, 8> at{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  std::string vertices, named;
  int next = 1;
  for (const auto& face : all) {
    named += 'f';
    for (const int v : face) {
      const auto& p = at[static_cast<std::size_t>(v - 1)];
      vertices += fmt::format("v {} {} {}\n", p[0], p[1], p[2]), named += ' ' + std::to_string(next++);
    }
    named += '\n';
  }
  return vertices + named;
}

Called examined(const std::string& text, std::vector<const char*> options = {}) {
  const TextFile file("mesh.obj", text);
  options.insert(options.begin(), {"mesh", file.path()});
  return called(options);
}

/// What is found and not a solid, with all of these words in this order.
void check_found(const Called& call, const std::vector<std::string>& words) {
  INFO(call.out << call.err);
  CHECK(call.code == findings);
  CHECK(call.err.empty());
  std::size_t at = call.out.find("It bounds no solid");
  REQUIRE(at != std::string::npos);
  for (const std::string& word : words) {
    const std::size_t next = call.out.find(word, at);
    INFO(word);
    REQUIRE(next != std::string::npos);
    at = next + word.size();
  }
}

void check_solid(const Called& call) {
  INFO(call.out << call.err);
  CHECK(call.code == nothing_found);
  CHECK_THAT(call.out, ContainsSubstring("It bounds a solid."));
}

/// The repair is a solid in each format, and its report says so in these words.
void check_repaired(const std::string& text, const std::vector<std::string>& changes) {
  for (const char* ending : {"obj", "off", "ply"}) {
    const TextFile file("broken.obj", text), repaired(std::string("repaired.") + ending, "");
    const Called call = called({"mesh", file.path(), "--repair", repaired.path()});
    INFO(call.out << call.err);
    CHECK(call.code == nothing_found);
    for (const std::string& change : changes) CHECK_THAT(call.out, ContainsSubstring("\n- " + change + "\n"));
    CHECK_THAT(call.out, ContainsSubstring("After that: it bounds a solid"));
    check_solid(called({"mesh", repaired.path()}));
  }
}

TEST_CASE("mesh: a cube bounds a solid, and is described") {
  const Called call = examined(corners(0, 1) + faces(cube_faces));
  check_solid(call);
  CHECK_THAT(call.out, ContainsSubstring("OBJ, 8 vertices, 12 edges, 6 quadrilaterals, 1 part\n") &&
                           ContainsSubstring("x 0 to 1, y 0 to 1, z 0 to 1\n") &&
                           ContainsSubstring("closed, oriented, a manifold at its edges, a manifold at its vertices, "
                                             "embedded, convex, volume positive\n"));
}

TEST_CASE("mesh: a cube without a face has a rim of four edges") {
  check_found(
      examined(corners(0, 1) + faces({cube_faces.begin(), cube_faces.end() - 1})),
      {"4 open edges, in 1 rim\n", "the first: edge from vertex 1 to vertex 4 (lines 1 and 4), of face 1 (line 9)\n",
       "to mend: fill the hole"});
}

TEST_CASE("mesh: a cube with a vertex for each corner is a solid once they are merged") {
  const std::string split = split_cube(cube_faces);
  check_found(examined(split),
              {"24 open edges, in 6 rims\n", "merge: 24 vertices have 8 positions; with --merge no edge is open\n",
               "faces meet beyond the vertices that both name\n", "faces 1 and 3 (lines 25 and 27)\n"});
  check_solid(examined(split, {"--merge"}));
  check_solid(examined(split, {"--merge=1e-9"}));
  check_repaired(split, {"16 of 24 vertices merged into others in equal positions"});
}

TEST_CASE("mesh: vertices that are nearly one are named, and the tolerance that merges them") {
  std::string nearly = split_cube(cube_faces);
  nearly.replace(nearly.find("v 0 1 0"), 7, "v 1e-15 1 0");  // vertex 1, in which the first face begins
  check_found(
      examined(nearly, {"--merge"}),
      {"open edges",
       "merge: vertices 1 and 18 (lines 1 and 18) are 1e-15 apart, 1e-15 of the size; with --merge 1e-12 no edge is "
       "open"});
  // The left side takes over the corner, and is then off its plane.
  check_found(examined(nearly, {"--merge", "1e-9"}), {"1 face is not planar", "face 6 (line 30)\n"});
  check_solid(examined(nearly, {"--merge", "1e-9", "--planar", "1e-9"}));
}

TEST_CASE("mesh: a rim on one line is a T-junction, and the face to split is told") {
  // The front is two triangles and a quadrilateral that know vertex 9 in the middle of the edge 1-2; the floor does
  // not.
  Faces all = cube_faces;
  all[2] = {1, 9, 2, 6, 5};
  const std::string text = corners(0, 1) + "v 0.5 0 0\n" + faces(all);
  const Called call = examined(text);
  check_found(call,
              {"3 open edges, in 1 rim: a T-junction\n",
               "  vertex 9 (line 9) at (0.5, 0, 0) lies on the edge from vertex 1 to vertex 2 (lines 1 and 2), of "
               "face 1 (line 10)\n",
               "to mend: split that face there\n"});
  CHECK_THAT(call.out, !ContainsSubstring("move the parts apart"));
  // The floor taken away is a hole beside no T-junction.
  Faces hole = all;
  hole.erase(hole.begin());
  check_found(examined(corners(0, 1) + "v 0.5 0 0\n" + faces(hole)), {"5 open edges, in 1 rim\n", "fill the hole"});
  // Off the line by one ulp it is a hole.
  check_found(examined(corners(0, 1) + "v 0.5 0 5e-324\n" + faces(all), {"--planar", "1"}),
              {"3 open edges, in 1 rim\n", "fill the hole"});
}

TEST_CASE("mesh: of two rims each is told, and which of them is a T-junction") {
  Faces all = cube_faces;
  all[2] = {1, 9, 2, 6, 5}, all.erase(all.begin() + 1);
  check_found(examined(corners(0, 1) + "v 0.5 0 0\n" + faces(all)),
              {"7 open edges, in 2 rims, 1 of them a T-junction\n", "vertex 9 (line 9) at (0.5, 0, 0)",
               "split that face there; fill the other holes"});
}

TEST_CASE("mesh: the least tolerance of --merge that closes the mesh is named, and in units of its size") {
  for (const auto& [apart, tolerance] : {std::pair{3e-13, "1e-12"}, {3e-11, "1e-10"}, {3e-6, "1e-05"}}) {
    std::string nearly = split_cube(cube_faces);
    nearly.replace(nearly.find("v 0 1 0"), 7, fmt::format("v {} 1 0", apart));
    check_found(examined(nearly, {"--merge"}),
                {fmt::format("are {0} apart, {0} of the size; with --merge {1} no edge is open", apart, tolerance)});
  }
  std::string far = split_cube(cube_faces);
  far.replace(far.find("v 0 1 0"), 7, "v 0.001 1 0");
  check_found(examined(far, {"--merge"}), {"open edges", "to mend: fill the hole"});
  check_found(examined(split_cube(cube_faces)), {"faces meet beyond", "to mend: merge first, as at the open edges"});
}

TEST_CASE("mesh: parts that a file names are named, where there are two or more") {
  const std::string two =
      "o Cube\n" + corners(0, 1) + faces(cube_faces) + "o Ball\n" + corners(0.5, 1.5) + faces(cube_faces, 8);
  check_found(examined(two), {"faces 2 and 9 (lines 11 and 27, of Cube and Ball)\n", "or move the parts apart"});
  const std::string one = "o Cube\n" + corners(0, 1) + faces(inside_out());
  CHECK_THAT(examined(one).out, !ContainsSubstring("of Cube"));
}

TEST_CASE("mesh: places in STL are positions") {
  const std::string tetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.5\n" + faces({{1, 3, 2}, {1, 2, 4}, {1, 4, 3}});  // open at 2-3-4
  const TextFile file("open.obj", tetrahedron), stl("open.stl", "");
  called({"mesh", file.path(), "--repair", stl.path()});
  check_found(called({"mesh", stl.path()}),
              {"3 open edges, in 1 rim\n",
               "the first: edge (0, 1, 0) - (1, 0, 0), of face 0 near (0.333, 0.333, 0), in a rim of 3 edges that is "
               "3.65028 long\n"});
}

TEST_CASE("mesh: a cube inside out is found, and turned") {
  const std::string text = corners(0, 1) + faces(inside_out());
  check_found(examined(text),
              {"the mesh is inside out: its faces look inwards\n", "to mend: reverse all faces (--repair)\n"});
  check_repaired(text, {"6 faces reversed: faces 1 (line 9), 2 (line 10), 3 (line 11) and 3 more"});
}

TEST_CASE("mesh: a face that runs the other way is found, and turned") {
  Faces all = cube_faces;
  all[1] = reversed(all[1]);
  const std::string text = corners(0, 1) + faces(all);
  check_found(examined(text), {"1 face runs the other way than the neighbours\n", "face 2 (line 10)\n"});
  check_repaired(text, {"1 face reversed: face 2 (line 10)"});
}

TEST_CASE("mesh: a Moebius strip has two sides nowhere, and no repair says otherwise") {
  const std::string strip = "v 4 0 0\nv 1 4 1\nv -3 2 -1\nv -3 -2 1\nv 1 -4 -1\n" +
                            faces({{1, 2, 3}, {2, 3, 4}, {3, 4, 5}, {4, 5, 1}, {5, 1, 2}});
  check_found(examined(strip), {"5 open edges, in 1 rim\n", "a sheet is one-sided, as a Moebius strip\n"});
  const TextFile repaired("repaired.off", "");
  const Called call = examined(strip, {"--repair", repaired.path()});
  CHECK(call.code == findings);
  CHECK_THAT(call.out, ContainsSubstring("written, with no change") && ContainsSubstring("After that: 5 open edges"));
}

TEST_CASE("mesh: two cubes that cross are told by the first faces that meet") {
  const std::string text = corners(0, 1) + corners(0.5, 1.5) + faces(cube_faces) + faces(cube_faces, 8);
  // The lid of the first, z = 1, meets the front of the second, y = 1/2; its floor, z = 0, meets nothing.
  check_found(examined(text),
              {"faces meet beyond the vertices that both name\n", "the first pair: faces 2 and 9 (lines 18 and 25)\n"});
}

TEST_CASE("mesh: a cube in a cube is a cavity if it looks inwards") {
  const std::string vertices = corners(0, 3) + corners(1, 2);
  const Called call = examined(vertices + faces(cube_faces) + faces(cube_faces, 8));
  check_found(call, {"a part inside another looks outwards", "that of face 7 (line 23)\n"});
  CHECK_THAT(call.out, ContainsSubstring("part 2 lies inside part 1\n"));
  check_solid(examined(vertices + faces(cube_faces) + faces(inside_out(), 8)));
  // A cavity one of whose faces is turned is turned inwards again, although five of six faces would agree outwards.
  Faces cavity = cube_faces;
  cavity[0] = reversed(cavity[0]);
  check_repaired(vertices + faces(cube_faces) + faces(cavity, 8),
                 {"5 faces reversed: faces 8 (line 24), 9 (line 25), 10 (line 26) and 2 more"});
}

TEST_CASE("mesh: a face that is there twice is dropped") {
  Faces all = cube_faces;
  all.push_back({2, 6, 5, 1});  // the third face, named from its second corner on
  const std::string text = corners(0, 1) + faces(all);
  check_found(examined(text), {"a face is there twice\n", "faces 3 and 7 (lines 11 and 15)\n",
                               "4 open edges, in 1 rim\n", "4 edges are in three faces or more\n"});
  CHECK_THAT(examined(text).out, !ContainsSubstring("faces meet"));
  check_repaired(text, {"1 face dropped as repeating an earlier one: face 7 (line 15)"});
}

TEST_CASE("mesh: a face twice in opposite order may be a wall, and stays") {
  Faces all = cube_faces;
  all.push_back(reversed(all[2]));
  const std::string text = corners(0, 1) + faces(all);
  check_found(examined(text),
              {"2 faces have the same corners and look opposite ways\n", "faces 3 and 7 (lines 11 and 15)\n"});
  const TextFile repaired("repaired.obj", "");
  CHECK(examined(text, {"--repair", repaired.path()}).code == findings);
  CHECK(audit::read_mesh_file(repaired.path()).faces.size() == 7);
}

TEST_CASE("mesh: a triangle that names a corner twice is dropped, a quadrilateral shortened") {
  Faces all = cube_faces;
  all[5] = {4, 1, 5, 5, 8}, all.push_back({1, 1, 2});
  const std::string text = corners(0, 1) + faces(all);
  const Called call = examined(text);
  check_found(call, {"2 faces name a corner twice in a row\n", "faces 6 (line 14) and 7 (line 15)\n"});
  CHECK_THAT(call.out, ContainsSubstring("embedded not decided"));
  check_repaired(text, {"1 face dropped with fewer than three corners left: face 7 (line 15)",
                        "1 face left without the corners that stood twice in a row: face 6 (line 14)"});
}

TEST_CASE("mesh: a face that is not planar is told, and cut where an option says how") {
  std::string text = corners(0, 1) + faces(cube_faces);
  text.replace(text.find("v 1 1 1"), 7, "v 1 1 1.5");
  check_found(examined(text), {"1 face is not planar", "face 2 (line 10)\n", "to mend: --planar "});
  for (const char* cut : {"--cut=shortest", "--cut=fan", "--planar=0.5"}) check_solid(examined(text, {cut}));
}

TEST_CASE("mesh: a triangle without area is told by its number") {
  // Vertex 9 lies on the edge from 1 to 2, which the front keeps.
  Faces all = cube_faces;
  all[0] = {4, 3, 2, 9, 1}, all.push_back({1, 9, 2});
  check_found(examined(corners(0, 1) + "v 0.5 0 0\n" + faces(all)), {"1 triangle has no area\n", "face 7 (line 16)\n"});
}

TEST_CASE("mesh: solids that share a vertex alone are no manifold there") {
  check_found(examined("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\n" +
                       faces({{1, 3, 2}, {1, 2, 4}, {1, 4, 3}, {2, 3, 4}, {1, 5, 6}, {1, 7, 5}, {1, 6, 7}, {5, 7, 6}})),
              {"- sheets meet in 1 vertex alone\n  vertex 1 (line 1)\n"});
}

TEST_CASE("mesh: every choice of faces that are turned and of vertices that are split is mended") {
  for (unsigned turned = 0; turned < 64; ++turned) {
    Faces all = cube_faces;
    for (std::size_t i = 0; i < 6; ++i)
      if ((turned >> i & 1) != 0) all[i] = reversed(all[i]);
    for (const std::string& text : {corners(0, 1) + faces(all), split_cube(all)}) {
      const TextFile file("turned.obj", text), repaired("repaired.off", "");
      CHECK(called({"mesh", file.path(), "--repair", repaired.path()}).code == nothing_found);
      CHECK(called({"mesh", repaired.path()}).code == nothing_found);
    }
  }
}

TEST_CASE("mesh: numbers of a repaired file read back exactly") {
  const std::string text = "v 0.1 -0 5e-324\nv 1e300 0 0\nv 0 123456789.123456789 0\nv 0 0 1e-7\n" +
                           faces({{1, 3, 2}, {1, 2, 4}, {1, 4, 3}, {2, 3, 4}});
  for (const char* ending : {"obj", "off", "ply"}) {
    const TextFile file("numbers.obj", text), repaired(std::string("numbers_again.") + ending, "");
    called({"mesh", file.path(), "--repair", repaired.path()});
    CHECK(audit::read_mesh_file(repaired.path()).vertices == audit::read_mesh_file(file.path()).vertices);
  }
}

TEST_CASE("mesh: several files are a table, and one that cannot be read costs its row") {
  const TextFile cube("cube.obj", corners(0, 1) + faces(cube_faces));
  const TextFile open("open.obj", corners(0, 1) + faces({cube_faces.begin(), cube_faces.end() - 1}));
  const Called both = called({"mesh", cube.path(), open.path()});
  CHECK(both.code == findings);
  CHECK(std::count(both.out.begin(), both.out.end(), '\n') == 3);
  CHECK_THAT(both.out, StartsWith("file ") && ContainsSubstring("8      6      1  yes\n") &&
                           ContainsSubstring("8      5      1  no     4 open edges, in 1 rim\n"));
  const Called one_missing = called({"mesh", cube.path(), "/nowhere/cube.obj"});
  require_refused(one_missing, bad_usage, "/nowhere/cube.obj: cannot be read");
  CHECK_THAT(one_missing.out, ContainsSubstring("yes\n") && ContainsSubstring("cannot be read\n"));
  require_refused(called({"mesh", "/nowhere/cube.obj"}), bad_usage, "/nowhere/cube.obj: cannot be read");
}

TEST_CASE("mesh: JSON is a line for each file") {
  const TextFile open("open.obj", corners(0, 1) + faces({cube_faces.begin(), cube_faces.end() - 1}));
  const Called call = called({"mesh", "--json", open.path(), open.path()});
  CHECK(std::count(call.out.begin(), call.out.end(), '\n') == 2);
  const auto json = catalogue::parse_own_line(call.out.substr(0, call.out.find('\n')));
  CHECK(json["solid"] == false);
  CHECK(json["found"][0]["defect"] == "open_edge");
  CHECK(json["found"][0]["count"] == 4);
  CHECK(json["found"][0]["first"][0]["vertices"] == catalogue::Json::array({0, 3}));
  CHECK(json["found"][0]["first"][0]["vertex_lines"] == catalogue::Json::array({1, 4}));
}

TEST_CASE("mesh: the page holds the words and a figure with the places") {
  const TextFile page("page.html", "");
  const Called call =
      examined(corners(0, 1) + faces({cube_faces.begin(), cube_faces.end() - 1}), {"--page", page.path()});
  CHECK(call.code == findings);
  std::stringstream text;
  text << std::ifstream(page.path()).rdbuf();
  CHECK_THAT(text.str(), ContainsSubstring("4 open edges, in 1 rim") && ContainsSubstring("edge 1-4") &&
                             ContainsSubstring("data-space=") && ContainsSubstring("const viewer"));
}

TEST_CASE("mesh: meshes of others are what their names say") {
  const char* const given = std::getenv("TOUCHSTONE_DATA");
  const auto folder = std::filesystem::path(given == nullptr ? "../shared/data" : given) / "meshes/ipc";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no meshes below TOUCHSTONE_DATA or ../shared/data");
    return;
  }
  const auto of = [&](const char* name) { return called({"mesh", (folder / name).c_str()}); };
  check_solid(of("cube.ply"));
  const Called near = of("two-cubes-close.ply");
  check_solid(near);
  CHECK_THAT(near.out, ContainsSubstring("2 parts"));
  // The sums of a . (b x c) are -6 and -5.68.
  check_found(of("two-cubes-far.ply"), {"the mesh is inside out: its faces look inwards"});
  check_found(of("two-cubes-intersecting.ply"), {"faces meet beyond the vertices that both name"});
}

TEST_CASE("mesh: what cannot be done is refused in one line, and no mesh is overwritten") {
  const std::string text = corners(0, 1) + faces(inside_out());
  const TextFile cube("cube.obj", text);
  for (const char* option : {"--repair", "--page"})
    require_refused(called({"mesh", cube.path(), option, cube.path()}), bad_usage, "is the mesh that is read");
  const std::filesystem::path cube_path = cube.path();
  const std::string otherwise = (cube_path.parent_path() / "." / cube_path.filename()).string();
  require_refused(called({"mesh", cube.path(), "--repair", otherwise.c_str()}), bad_usage, "is the mesh that is read");
  CHECK(audit::read_mesh_file(cube.path()).faces[0] == std::vector<Index>{0, 1, 2, 3});
  require_refused(called({"mesh", cube.path(), "--repair", "cube.step"}), bad_usage,
                  "ends with .obj, .off, .ply or .stl");
  require_refused(called({"mesh", cube.path(), cube.path(), "--page", "x.html"}), bad_usage, "several files");
  require_refused(called({"mesh", "--merge", cube.path(), cube.path()}), bad_usage, "a number from 0 to 0.01");
  require_refused(called({"mesh", cube.path(), "--merge", "2"}), bad_usage, "a number from 0 to 0.01");
  require_refused(called({"mesh"}), bad_usage, "file");
}

}  // namespace
}  // namespace touchstone::proptests::mesh_command_tests
