// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "audit/meshes/formats/mesh_file.h"
#include "audit/meshes/formats/places.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/meshes/binary.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::habits_tests {
namespace {

using audit::MeshFile;
using audit::parse_mesh_file;
using audit::reading_of;
using Faces = std::vector<std::vector<Index>>;
using Notes = std::vector<std::string>;

std::string refusal(const std::string& name, const std::string& bytes) {
  return refusal_of([&] { parse_mesh_file(name, bytes); });
}

/// The triangle (0,0,0), (1,0,0), (0,1,0) `count` times, each with `attribute` and that many bytes behind it.
std::string stl(const std::string& title, std::uint32_t count, std::uint32_t header_count, std::uint16_t attribute = 0,
                bool attributes = false) {
  std::string bytes = title;
  bytes.resize(80, ' ');
  append(bytes, header_count);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(bytes, x);
    append(bytes, attribute);
    if (attributes) bytes.append(attribute, 'c');
  }
  return bytes;
}

const std::string merged_three = "3 corners merged into 3 vertices where positions are equal";
const std::string merged_six = "6 corners merged into 3 vertices where positions are equal";

const std::string ply_vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string four_rows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

}  // namespace

TEST_CASE("habits: the first count of OFF may stand directly behind the keyword") {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* header : {"OFF3 1 0\n", "OFF3 1\n", "COFF3 1 0\n", "OFF 3 1 0\n", "OFF\n3 1 0\n"})
    CHECK(parse_mesh_file("a.off", header + body).faces == Faces{{0, 1, 2}});
  CHECK(refusal("a.off", "OFF3\n" + body) == "a.off:1: counts of vertices and faces");
  CHECK(refusal("a.off", "OFFX 3 1\n" + body) == "a.off:1: OFF in the first line");
  CHECK(refusal("a.off", "OFF-3 1 0\n" + body) == "a.off:1: OFF in the first line");
  CHECK(refusal("a.off", "OFF4 1 0\n" + body) == "a.off:5: the file ends before the declared number of faces");
}

TEST_CASE("habits: binary STL may begin with solid and hold colours") {
  for (const char* title : {"solid", "solid x\nfacet normal 0 0 1\n", "", "COLOR=abcd"}) {
    const MeshFile read = parse_mesh_file("a.stl", stl(title, 2, 2, 0xffff));
    CHECK(read.format == "STL (binary)");
    CHECK(read.faces == Faces{{0, 1, 2}, {0, 1, 2}});
    CHECK(read.notes == Notes{merged_six});
  }
}

TEST_CASE("habits: bytes behind a triangle of binary STL are passed over where its attribute counts them") {
  const MeshFile read = parse_mesh_file("a.stl", stl("solid", 2, 2, 7, true));
  CHECK(read.faces == Faces{{0, 1, 2}, {0, 1, 2}});
  CHECK(read.notes == Notes{"bytes behind each triangle passed over", merged_six});
  CHECK(parse_mesh_file("a.stl", stl("", 50, 0, 7, true)).faces == Faces(50, {0, 1, 2}));
  CHECK(parse_mesh_file("a.stl", stl("", 2, 2, 300, true)).faces == Faces{{0, 1, 2}, {0, 1, 2}});
  CHECK(refusal("a.stl", stl("", 2, 2, 7, true) + "\n")
            .ends_with(": nothing behind the last triangle, or behind each as many bytes as its attribute counts"));
  CHECK(refusal("a.stl", stl("", 2, 2, 7, true) + std::string(50, 'x')) ==
        "a.stl: byte 182: as many triangles as the header counts, 2: there is room for 3");
}

TEST_CASE("habits: bytes behind the last triangle of binary STL are noted, fewer than a triangle's") {
  for (const std::string& behind : {std::string("\n"), std::string("\0", 1), std::string(49, 'x')}) {
    const MeshFile read = parse_mesh_file("a.stl", stl("solid", 1, 1) + behind);
    CHECK(read.faces == Faces{{0, 1, 2}});
    CHECK(parse_mesh_file("a.dat", stl("solid", 1, 1) + behind).faces == Faces{{0, 1, 2}});
    CHECK(read.notes.front() == (behind.size() == 1 ? "1 byte behind the last triangle passed over"
                                                    : "49 bytes behind the last triangle passed over"));
  }
  CHECK(refusal("a.stl", stl("", 3, 1)) ==
        "a.stl: byte 132: as many triangles as the header counts, 1: there is room for 3");
  CHECK(refusal("a.stl", stl("", 3, 4)) ==
        "a.stl: byte 80: 4 triangles, as the header says: the file holds 3 and ends too early");
  CHECK(refusal("a.stl", stl("", 3, 0xfffffffe)) ==
        "a.stl: byte 80: 4,294,967,294 triangles, as the header says: the file holds 3 and ends too early");
}

TEST_CASE("habits: triangles of binary STL that its header does not count are read and noted") {
  const MeshFile read = parse_mesh_file("a.stl", stl("solid", 2, 0) + "\n");
  CHECK(read.faces == Faces{{0, 1, 2}, {0, 1, 2}});
  CHECK(read.notes == Notes{"the header counts no triangles, but the file holds 2",
                            "1 byte behind the last triangle passed over", merged_six});
  CHECK(refusal("a.stl", stl("", 0, 0)) == "a.stl: at least one face: the file holds nothing");
}

TEST_CASE("habits: words of ascii STL may be apart, together with a name, or behind comments") {
  const std::string three = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  const MeshFile read =
      parse_mesh_file("a.stl", "# by hand\nsolidNAME\nfacet normal 0 0 1\nouter loop\n; corners\n" + three +
                                   "end loop\nend facet\nEND SOLID\n// another one\nsolid b\nfacet\nouter loop\n" +
                                   three + "endloop\nendfacet\nendsolidNAME\n");
  CHECK(read.faces == Faces{{0, 1, 2}, {0, 1, 2}});
  CHECK(read.vertex_lines == std::vector<std::size_t>{6, 7, 8});
  CHECK(read.face_lines == std::vector<std::size_t>{3, 14});
  CHECK(reading_of(read) ==
        Notes{"STL (ascii): 3 vertices, 2 faces of 3 corners", merged_six, "passed over: 3 comments"});
  CHECK(refusal("a.stl", "solid\nend\n").starts_with("a.stl:2: solid, facet, outer loop"));
}

TEST_CASE("habits: what stands behind the declared values of a row of ascii PLY is noted") {
  const std::string header =
      "ply\nformat ascii 1.0\n" + ply_vertices + "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const MeshFile read =
      parse_mesh_file("a.ply", header + "0 0 0 255 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 7\n3 0\n2 3 7 7 7\n");
  CHECK(read.vertices == std::vector<Point3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(read.faces == Faces{{0, 1, 2}, {0, 2, 3}});
  CHECK(read.face_lines == std::vector<std::size_t>{14, 15});
  CHECK(read.notes ==
        Notes{"3 rows longer than the header says, the first on line 10: the rest of each is passed over"});
  CHECK(refusal("a.ply", header + "0 0 0 1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n") ==
        "a.ply:14: the file ends before the declared number of values");
}

TEST_CASE("habits: strips of PLY become triangles that all face the same side") {
  const MeshFile read =
      parse_mesh_file("a.ply", "ply\nformat ascii 1.0\n" + ply_vertices +
                                   "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                                   four_rows + "10 0 1 3 2 -1 0 3 1 1 2\n");
  // 0 1 3, then 1 3 2 turned: 3 1 2; behind -1 anew: 0 3 1, then 3 1 1 and 1 1 2, which are no triangles
  CHECK(read.faces == Faces{{0, 1, 3}, {3, 1, 2}, {0, 3, 1}});
  CHECK(read.face_lines == std::vector<std::size_t>{14, 14, 14});
  CHECK(read.notes == Notes{"strips of triangles are read as faces, without 2 triangles with a vertex named twice"});
  CHECK(refusal("a.ply", "ply\nformat ascii 1.0\n" + ply_vertices +
                             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + four_rows +
                             "3 0 1 -2\n") == "a.ply:14: index of a vertex: got -2 of 4 vertices, counted from 0");
}

TEST_CASE("habits: strips of PLY may have an odd number of vertices, and each row a line of its own") {
  const MeshFile read =
      parse_mesh_file("a.ply", "ply\nformat ascii 1.0\n" + ply_vertices +
                                   "element tristrips 2\nproperty list int int vertex_indices\nend_header\n" +
                                   four_rows + "7 0 1 3 -1 0 3 1\n3 1 2 3\n");
  CHECK(read.faces == Faces{{0, 1, 3}, {0, 3, 1}, {1, 2, 3}});
  CHECK(read.face_lines == std::vector<std::size_t>{14, 14, 15});
}

TEST_CASE("habits: PLY has integers of 64 bits, too") {
  for (const bool big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                        "_endian 1.0\nelement vertex 3\nproperty int64 x\nproperty uint64 y\nproperty float z\n"
                        "element face 1\nproperty list uint64 int64 vertex_indices\nend_header\n";
    for (const std::int64_t x : {std::int64_t{-5}, std::int64_t{1}, (std::int64_t{1} << 53) + 1})
      append(bytes, x, big), append(bytes, std::uint64_t{3}, big), append(bytes, 0.5f, big);
    append(bytes, std::uint64_t{3}, big);
    std::string negative = bytes;
    for (const std::int64_t i : {0, 1, 2}) append(bytes, i, big), append(negative, -i, big);
    const MeshFile read = parse_mesh_file("a.ply", bytes);
    CHECK(read.vertices == std::vector<Point3d>{{-5, 3, 0.5}, {1, 3, 0.5}, {0x1p53, 3, 0.5}});
    CHECK(read.faces == Faces{{0, 1, 2}});
    CHECK(refusal("a.ply", negative).ends_with("index of a vertex: got -1 of 3 vertices, counted from 0"));
    CHECK(refusal("a.ply", bytes.substr(0, bytes.size() - 1)).ends_with("the file ends too early"));
    CHECK(parse_mesh_file("a.ply", bytes + "\r\n").faces.size() == 1);
  }
  CHECK(parse_mesh_file("a.ply", "ply\nformat ascii 1.0\n" + ply_vertices +
                                     "element face 1\nproperty list int64 uint64 vertex_indices\nend_header\n" +
                                     four_rows + "3 0 1 2\n")
            .faces == Faces{{0, 1, 2}});
  std::string passed_over = "ply\nformat binary_little_endian 1.0\n" + ply_vertices +
                            "property int64 time\nelement face 1\nproperty list int int vertex_indices\nend_header\n";
  for (const float x : {0.f, 1.f, 2.f, 3.f})
    append(passed_over, x), append(passed_over, x), append(passed_over, 0.f), append(passed_over, std::int64_t{-1});
  for (const std::int32_t i : {3, 0, 1, 2}) append(passed_over, i);
  CHECK(parse_mesh_file("a.ply", passed_over).vertices ==
        std::vector<Point3d>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}});
}

TEST_CASE("habits: what OBJ says besides the surface is counted") {
  const MeshFile read =
      parse_mesh_file("a.obj",
                      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvw 0 0 0.5 1 0.5\nvw 1 0 1\n"
                      "t crease 2/1/0 0 1 2.0\nt interpolateboundary 1/0/0 1\nl 1 2\nv 9 9 9\nf 1 2 3\n");
  CHECK(reading_of(read) ==
        Notes{"OBJ: 4 vertices, 1 face of 3 corners", "1 vertex in no face", "passed over: 1 l, 1 mtllib, 2 t, 2 vw"});
}

TEST_CASE("habits: a face of OBJ belongs to the part whose name stands last before it") {
  const MeshFile read =
      parse_mesh_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no wing\nf 1 2 3\no tail\nf 3 2 1\nf 1 3 2\n");
  CHECK(audit::face_in_words(read, 0) == "face 1 (line 5, of wing)");
  CHECK(audit::face_in_words(read, 1) == "face 2 (line 7, of tail)");
  CHECK(audit::face_in_words(read, 2) == "face 3 (line 8, of tail)");
}

TEST_CASE("habits: files of points or lines are told to be that") {
  CHECK(refusal("a.obj", "v 0 0 0\nv 1 0 0\np 1 2\n") == "a.obj: at least one face: the file holds 2 points");
  CHECK(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n") ==
        "a.obj: at least one face: the file holds 3 vertices and 1 line");
  CHECK(refusal("a.obj", "# nothing\n") == "a.obj: at least one face: the file holds nothing");
  CHECK(refusal("a.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n") == "a.off: at least one face: the file holds 2 points");
  CHECK(refusal("a.off", "OFF\n2 2 0\n0 0 0\n1 0 0\n2 0 1\n2 1 0\n") ==
        "a.off: at least one face: the file holds 2 vertices and 2 lines");
  CHECK(refusal("a.off", "OFF\n2 2 0\n0 0 0\n1 0 0\n2 0 1\n3 0 1 1\n") == "a.off:5: at least 3 corners");
  CHECK(refusal("a.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n0\n") == "a.off:5: at least 3 corners");
  CHECK(refusal("a.ply", "ply\nformat ascii 1.0\n" + ply_vertices + "end_header\n" + four_rows) ==
        "a.ply: at least one face: the file holds 4 points");
  CHECK(refusal("a.ply", "ply\nformat ascii 1.0\n" + ply_vertices +
                             "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" + four_rows +
                             "0 1\n") == "a.ply: at least one face: the file holds 4 vertices and 1 line");
  CHECK(refusal("a.stl", "solid nothing\nendsolid nothing\n") == "a.stl: at least one face: the file holds nothing");
}

TEST_CASE("habits: the content decides, and a name that says something else is noted") {
  const std::string off = "# text\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                    obj = "o x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string ascii =
      "solid x\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  const std::string ply = "ply\nformat ascii 1.0\n" + ply_vertices +
                          "element face 1\nproperty list int int vertex_indices\nend_header\n" + four_rows +
                          "3 0 1 2\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"OFF", off}, {"OBJ", obj}, {"PLY (ascii)", ply}, {"STL (ascii)", ascii}, {"STL (binary)", stl("x", 1, 1)}};
  for (const auto& [format, bytes] : files) {
    for (const char* name : {"a.obj", "a.OFF", "a.ply", "a.stl", "a", "a.txt"}) {
      INFO(format << " named " << name);
      const MeshFile read = parse_mesh_file(name, bytes);
      CHECK(read.format == format);
      CHECK(read.faces == Faces{{0, 1, 2}});
      std::string ending(name + std::min<std::size_t>(2, std::string(name).size()));
      for (char& c : ending) c &= ~0x20;
      const bool noted =
          !read.notes.empty() && read.notes[0] == "the content is " + format + ", whatever the name says";
      CHECK(noted == (ending != "" && ending != "TXT" && !format.starts_with(ending)));
    }
  }
  CHECK(refusal("a.dat", "x y z\n") ==
        "a.dat: OBJ, PLY, OFF, STL, glTF or 3MF: neither its content nor its name tells that it is one");
}

TEST_CASE("habits: binary files that are cut anywhere are refused in one line") {
  for (const std::uint16_t attribute : {std::uint16_t{0}, std::uint16_t{5}, std::uint16_t{60}}) {
    const std::string bytes = stl("solid", 3, 3, attribute, true);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      if (length == 84 + 3 * 50) continue;  // what the header promises, of a file without such bytes
      const std::string refused = refusal("a.stl", bytes.substr(0, length));
      INFO(length << ": " << refused);
      CHECK(refused.starts_with("a.stl"));
      CHECK(refused.find('\n') == refused.npos);
    }
  }
}

}  // namespace touchstone::proptests::habits_tests
