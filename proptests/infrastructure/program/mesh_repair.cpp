// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <sstream>
#include <string>

#include "audit/meshes/formats/mesh_file.h"
#include "program/commands/commands.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// `touchstone mesh --repair`: what it writes, what it leaves, and what it says of both.
namespace touchstone::proptests::mesh_repair_tests {
namespace {

/// A cube from (x, y, z) to (x + side, ...), its faces outwards or inwards; `before` vertices stand in front of its
/// own.
std::string cube(const std::array<int, 3>& from, int side, bool outwards, int before) {
  constexpr std::array<std::array<int, 3>, 8> at{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  constexpr std::array<std::array<int, 4>, 6> faces{
      {{4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}}};
  std::string text;
  for (const auto& p : at) {
    text += 'v';
    for (std::size_t k = 0; k < 3; ++k) text += ' ' + std::to_string(from[k] + side * p[k]);
    text += '\n';
  }
  for (const auto& face : faces) {
    text += 'f';
    for (std::size_t k = 0; k < 4; ++k) text += ' ' + std::to_string(face[outwards ? k : 3 - k] + before);
    text += '\n';
  }
  return text;
}

/// What --repair says, its exit code, and what `mesh` then says of the file.
struct Repair {
  Called call, again;
  std::size_t vertices, faces;
};

Repair repair(const std::string& text, const std::string& ending = "obj", std::vector<const char*> options = {}) {
  const TextFile file("broken.obj", text), written("repaired." + ending, "");
  options.insert(options.begin(), {"mesh", file.path(), "--repair", written.path()});
  Repair result{called(options), called({"mesh", written.path()}), 0, 0};
  const audit::MeshFile mesh = audit::read_mesh_file(written.path());
  result.vertices = mesh.vertices.size(), result.faces = mesh.faces.size();
  return result;
}

/// The repair is what `mesh` finds in the file.
void check(const Repair& repair, bool solid, const std::string& change) {
  INFO(repair.call.out << repair.call.err << repair.again.out);
  CHECK(repair.call.code == (solid ? nothing_found : findings));
  CHECK(repair.again.code == repair.call.code);
  CHECK_THAT(repair.call.out, ContainsSubstring(change));
  CHECK((repair.call.out.find("After that: it bounds a solid") != std::string::npos) == solid);
}

}  // namespace

TEST_CASE("mesh --repair: faces that are not planar are written as they were cut") {
  std::string bent = cube({0, 0, 0}, 1, true, 0);
  bent.replace(bent.find("v 1 1 1"), 7, "v 1 1 1.25");  // of the top, the right and the back; the latter stay planar
  for (const char* how : {"--cut=fan", "--cut=shortest", "--planar=0.25"}) {
    for (const char* ending : {"obj", "off", "ply", "stl"}) {
      const Repair made = repair(bent, ending, {how});
      check(made, true, "- 1 face cut: face 2 (line 10)\n");
      CHECK(made.faces == (ending == std::string("stl") ? 12 : 7));
    }
  }
  check(repair(bent), false, "written, with no change\n");
  // A triangle that was cut counts once where both halves are reversed.
  std::string turned = cube({0, 0, 0}, 1, false, 0);
  turned.replace(turned.find("v 1 1 1"), 7, "v 1 1 1.25");
  check(repair(turned, "obj", {"--cut=fan"}), true, "- 6 faces reversed: faces 1 (line 9), 2 (line 10), 3 (line 11)");
}

TEST_CASE("mesh --repair: closed parts that share a wall or a corner keep their own vertices") {
  const std::string one = cube({0, 0, 0}, 1, true, 0);
  for (const std::array<int, 3>& at : {std::array{1, 0, 0}, {1, 1, 0}, {1, 1, 1}}) {
    const Repair made = repair(one + cube(at, 1, true, 8));
    check(made, false, "written, with no change\nAfter that: faces meet beyond the vertices that both name\n");
    CHECK(made.vertices == 16);
  }
  // STL names positions, so that the file has what the report says.
  const Repair stl = repair(one + cube({1, 1, 1}, 1, true, 8), "stl");
  check(stl, false, "After that: sheets meet in 1 vertex alone\n");
  // The same cube twice is one solid.
  check(repair(one + cube({0, 0, 0}, 1, true, 8)), true, "- 6 faces dropped as repeating an earlier one");
  // Who asks for it gets it.
  const Repair asked = repair(one + cube({1, 1, 1}, 1, true, 8), "obj", {"--merge"});
  check(asked, false, "After that: sheets meet in 1 vertex alone\n");
  CHECK(asked.vertices == 15);
}

TEST_CASE("mesh --repair: the inverse of a hollow solid is reversed, and a mere cavity that looks outwards is not") {
  const std::string inverse = cube({0, 0, 0}, 3, false, 0) + cube({1, 1, 1}, 1, true, 8);
  check(repair(inverse), true, "- 12 faces reversed: faces 1 ");
  check(repair(cube({0, 0, 0}, 3, true, 0) + cube({1, 1, 1}, 1, true, 8)), false, "written, with no change\n");
  // A second solid, which is right, is no reason to leave the first.
  check(repair(inverse + cube({5, 0, 0}, 1, true, 16)), true, "- 12 faces reversed: faces 1 ");
  // Within the inverse one cavity looks inwards: it may be meant, and the repair is of the shell alone.
  check(repair(cube({0, 0, 0}, 9, false, 0) + cube({1, 1, 1}, 1, true, 8) + cube({4, 4, 4}, 1, false, 16)), false,
        "- 6 faces reversed: faces 1 ");
  // The shell is wrong, the cavity too, but the solid in the cavity is right: not all of it is inverse.
  check(repair(cube({0, 0, 0}, 9, false, 0) + cube({1, 1, 1}, 7, true, 8) + cube({3, 3, 3}, 1, true, 16)), false,
        "- 6 faces reversed: faces 1 ");
}

TEST_CASE("mesh --repair: open parts are joined where closed ones meet in a corner") {
  std::string apart;  // a cube of six squares that share nothing but positions
  for (const char* square : {"0 0 4 0 1 4 1 1 4 1 0 4", "0 0 5 1 0 5 1 1 5 0 1 5", "0 0 4 1 0 4 1 0 5 0 0 5",
                             "1 0 4 1 1 4 1 1 5 1 0 5", "1 1 4 0 1 4 0 1 5 1 1 5", "0 1 4 0 0 4 0 0 5 0 1 5"}) {
    std::istringstream numbers(square);
    for (std::string x, y, z; numbers >> x >> y >> z;) apart += "v " + x + ' ' + y + ' ' + z + '\n';
    apart += "f -4 -3 -2 -1\n";
  }
  const Repair made = repair(cube({0, 0, 0}, 1, true, 0) + cube({1, 1, 1}, 1, true, 8) + apart);
  check(made, false, "16 of 40 vertices merged");
  CHECK(made.vertices == 24);
}

TEST_CASE("mesh --repair: what says nothing of the surface is told not to be kept") {
  const std::string more = "o Cube\nvt 0 0\nvn 0 0 1\nusemtl red\n";
  check(repair(more + cube({0, 0, 0}, 1, false, 0)), true,
        "Not kept: materials, names, normals, texture coordinates\n");
  CHECK(repair(cube({0, 0, 0}, 1, false, 0)).call.out.find("Not kept") == std::string::npos);
}

TEST_CASE("mesh --repair: STL is written where each coordinate is a binary32, else refused") {
  check(repair(cube({0, 0, 0}, 1, false, 0), "stl"), true, "written, with these changes:\n- 6 faces reversed");
  std::string tenth = cube({0, 0, 0}, 1, true, 0);
  tenth.replace(tenth.find("v 0 0 0"), 7, "v 0.1 0 0");
  const TextFile file("tenth.obj", tenth);
  const std::string out = std::string(file.path()) + ".stl";
  require_refused(called({"mesh", file.path(), "--repair", out.c_str()}), bad_usage,
                  "STL holds numbers of binary32, and 0.1 is none, a coordinate of vertex 0 from 0; a name that ends");
  CHECK(!std::filesystem::exists(out));
}

}  // namespace touchstone::proptests::mesh_repair_tests
