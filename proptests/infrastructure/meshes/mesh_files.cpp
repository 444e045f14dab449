// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/mesh_file.h"
#include "proptests/catch.h"

namespace touchstone::proptests::mesh_files_tests {
namespace {

using audit::MeshFile;
using audit::parse_mesh_file;
using Faces = std::vector<std::vector<Index>>;
using Lines = std::vector<std::size_t>;
using Notes = std::vector<std::string>;

}  // namespace

TEST_CASE("mesh files: OBJ keeps faces of any number of corners, and the lines on which things stand") {
  const MeshFile read = parse_mesh_file("a\tb.obj",
                                        "# a square and a triangle\nv 0 0 0\nv 1 0 0\n\nv 1 1 0\nv 0 1 0\nf 1 2 \\\n"
                                        "3 4\no x\nf 4 2 1\n");
  CHECK(read.name == "a?b.obj");
  CHECK(read.format == "OBJ");
  CHECK(read.faces == Faces{{0, 1, 2, 3}, {3, 1, 0}});
  CHECK(read.vertex_lines == Lines{2, 3, 5, 6});
  CHECK(read.face_lines == Lines{7, 10});
  CHECK(read.first_number == 1);
}

TEST_CASE("mesh files: OFF keeps faces of any number of corners, and the lines on which things stand") {
  const MeshFile read = parse_mesh_file(
      "a.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n# comment\n1 1 0\n0 1 0\n0 0 1\n\n5 0 1 2 3 4 255 0 0\n3 0 1 2");
  CHECK(read.format == "OFF");
  CHECK(read.faces == Faces{{0, 1, 2, 3, 4}, {0, 1, 2}});
  CHECK(read.vertex_lines == Lines{3, 4, 6, 7, 8});
  CHECK(read.face_lines == Lines{10, 11});
  CHECK(read.first_number == 0);
}

TEST_CASE("mesh files: PLY keeps faces of any number of corners; binary files have no lines") {
  const std::string counts =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar uchar vertex_indices\nend_header\n";
  const MeshFile text = parse_mesh_file(
      "a.ply", "ply\nformat ascii 1.0\n" + counts + "0 0 0\n\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n");
  CHECK(text.format == "PLY (ascii)");
  CHECK(text.faces == Faces{{0, 1, 2, 3}, {0, 1, 2}});
  CHECK(text.vertex_lines == Lines{10, 12, 13, 14});
  CHECK(text.face_lines == Lines{15, 16});
  const MeshFile binary =
      parse_mesh_file("a.ply", "ply\nformat binary_big_endian 1.0\n" + counts + std::string(4 * 12, '\0') + "\x04" +
                                   std::string("\0\1\2\3\3\0\1\2", 8));
  CHECK(binary.format == "PLY (binary, big-endian)");
  CHECK(binary.faces == Faces{{0, 1, 2, 3}, {0, 1, 2}});
  CHECK(binary.vertex_lines.empty());
  CHECK(binary.face_lines.empty());
}

TEST_CASE("mesh files: STL tells how many corners became one vertex") {
  const MeshFile read =
      parse_mesh_file("a.stl",
                      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                      "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
                      "vertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid\n");
  CHECK(read.format == "STL (ascii)");
  CHECK(read.faces == Faces{{0, 1, 2, 3}, {0, 3, 4}});
  CHECK(read.vertex_lines == Lines{4, 5, 6, 7, 14});
  CHECK(read.face_lines == Lines{2, 10});
  CHECK(read.notes == Notes{"7 corners merged into 5 vertices where positions are equal"});
}

}  // namespace touchstone::proptests::mesh_files_tests
