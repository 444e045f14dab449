// SPDX-License-Identifier: Apache-2.0
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>

#include "audit/meshes/formats/mesh_file.h"
#include "audit/meshes/prepared.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/meshes/binary.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::read_mesh_tests {
namespace {

Meshd parse_mesh(const std::string& name, std::string_view bytes) {
  return audit::prepared(audit::parse_mesh_file(name, bytes), {}).mesh;
}

std::string refusal(const std::string& name, const std::string& bytes) {
  return refusal_of([&] { parse_mesh(name, bytes); });
}

/// A tetrahedron at the origin, as every reader should give it back.
void check_tetrahedron(const Meshd& mesh) {
  REQUIRE(mesh.vertices.size() == 4);
  CHECK(mesh.vertices[0] == Point3d{0, 0, 0});
  CHECK(mesh.vertices[3] == Point3d{0, 0, 0.5});
  CHECK(mesh.faces == std::vector<Face>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};
const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string ply_binary(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty uchar red\nproperty float x\nproperty double y\n"
                      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : corners) {
    append<std::uint8_t>(bytes, 7), append(bytes, static_cast<float>(p[0]), big), append(bytes, p[1], big);
    append(bytes, static_cast<float>(p[2]), big);
  }
  for (const auto& f : faces) {
    append<std::uint8_t>(bytes, 3);
    for (const int i : f) append(bytes, static_cast<std::int32_t>(i), big);
  }
  return bytes;
}

/// Corners in the order in which the tetrahedron above has its vertices.
std::string stl_binary(const std::string& title) {
  std::string bytes = title;
  bytes.resize(80, ' ');
  append<std::uint32_t>(bytes, 4);
  const int order[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  for (const auto& f : order) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0f);
    for (const int i : f) {
      for (const double c : corners[i]) append(bytes, static_cast<float>(c));
    }
    append<std::uint16_t>(bytes, 0);
  }
  return bytes;
}

}  // namespace

TEST_CASE("meshes: OBJ with comments, texture indices, relative indices and either line end") {
  check_tetrahedron(parse_mesh("a.OBJ",
                               "# a tetrahedron\r\nv 0 0 0\r\nv 1 -0.0 0 # corner\r\nvt 0 0\r\nv 0 +1 0 1 0 0\r\n"
                               "v 0 0 5e-1\r\n\r\nusemtl x\r\nf 1/1 3/1 2/1\r\nf 1//2 2//2 4//2\r\nf -4 -1 -2\r\n"
                               "f 2/1/2 \\\r\n  3 4\r\n"));
  CHECK(audit::parse_mesh_file("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4").faces ==
        std::vector<std::vector<Index>>{{0, 1, 2, 3}});
  CHECK(parse_mesh("a.obj", "f 1 2 3\rv 0 0 0\rv 1 0 0\rv 1 1 0").faces == std::vector<Face>{{0, 1, 2}});
}

TEST_CASE("meshes: a byte order mark in front of a text is no part of it") {
  const std::string mark = "\xef\xbb\xbf";
  const Meshd obj = parse_mesh("a.obj", mark + "v 7 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  REQUIRE(obj.vertices.size() == 3);
  CHECK(obj.vertices[0] == Point3d{7, 0, 0});
  CHECK(parse_mesh("a.off", mark + "OFF\n1 1\n7 0 0\n3 0 0 0\n").vertices[0].x == 7);
  CHECK(parse_mesh("a.stl", mark + "solid x\nfacet\nouter loop\nvertex 7 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                                   "endfacet\nendsolid\n")
            .vertices[0]
            .x == 7);
  CHECK(parse_mesh(
            "a.ply",
            mark + "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 1\nproperty list int int vertex_index\nend_header\n7 0 0\n3 0 0 0\n")
            .vertices[0]
            .x == 7);
  CHECK(refusal("a.obj", "v 0 0 0\n" + mark + "v 7 0 0\n") ==
        "a.obj:2: v, f or another keyword of polygons in OBJ, got " + mark + "v");
}

TEST_CASE("meshes: a line of OBJ is read, known to say nothing of the surface, or refused") {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(parse_mesh("a.obj", three + "mtllib a b\no x\ng x y\ns off\nvn 0 0 1\nvt 0 0\nusemtl y\nl 1 2\np 1\nf 1 2 3\n")
            .faces.size() == 1);
  for (const char* unknown : {"V", "vertex", "fo", "call", "surf", "curv2", "xyz", "0", "\"v\"", "v,"})
    CHECK(refusal("a.obj", three + "\n" + unknown + " 0 0 0\nf 1 2 3\n") ==
          "a.obj:5: v, f or another keyword of polygons in OBJ, got " + std::string(unknown));
  CHECK(refusal("a.obj", "\x1b[2J 0 0 0\n") == "a.obj:1: v, f or another keyword of polygons in OBJ, got \\x1b[2J");
}

TEST_CASE("meshes: what is no regular file is refused before it is read, and a file that is too large") {
  const auto path = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_endless.obj");
  const auto refused = [&] {
    try {
      audit::read_mesh_file(path.string());
      return std::string("accepted");
    } catch (const InvalidInput& refused) {
      return refused.rule();
    }
  };
  std::filesystem::create_symlink("/dev/zero", path);
  CHECK(refused() == "cannot be read: it is no file");
  std::filesystem::remove(path);
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  CHECK(refused() == "cannot be read: it is no file");
  std::filesystem::remove(path);
  CHECK(refused() == "cannot be read: no such file or directory");
  std::ofstream(path) << "v 1 2 3\nf 1 1 1\n";
  CHECK(refused() == "accepted");
  std::filesystem::resize_file(path, audit::most_bytes_of_a_mesh + 1);
  CHECK(refused() == "at most 256 MiB");
  std::filesystem::remove(path);
}

TEST_CASE("meshes: OFF with comments, colours and the counts in the first line") {
  const std::string body =
      "0 0 0\n1 0 0 255 0 0\n# comment\n\n0 1 0\n0 0 .5\n3 0 2 1\n3 0 1 3 0.5 0.5 0.5\n3 0 3 2\n3 1 2 3\n";
  check_tetrahedron(parse_mesh("a.off", "OFF\n4 4 6\n" + body));
  check_tetrahedron(parse_mesh("a.off", "COFF 4 4 # counts\n" + body));
}

TEST_CASE("meshes: PLY as text and in both byte orders") {
  check_tetrahedron(parse_mesh("a.ply",
                               "ply\r\nformat ascii 1.0\r\ncomment x\r\nelement vertex 4\r\nproperty float x\r\n"
                               "property float y\r\nproperty float z\r\nproperty list uchar float weights\r\n"
                               "element face 4\r\nproperty list uchar uint vertex_index\r\nelement edge 1\r\n"
                               "property int a\r\nend_header\r\n0 0 0 0\r\n1 0 0 2 nan 7\r\n0 1 0 0\r\n0 0 0.5 0\r\n"
                               "3 0 2 1\r\n3 0 1 3\r\n3 0 3 2\r\n3 1 2 3\r\n5\r\n"));
  check_tetrahedron(parse_mesh("a.ply", ply_binary(false)));
  check_tetrahedron(parse_mesh("a.ply", ply_binary(true)));
}

TEST_CASE("meshes: STL as text and binary, equal corners are one vertex") {
  const std::string facet = "facet normal 0 0 1\n outer loop\n", end = "endloop\nendfacet\n";
  const Meshd text = parse_mesh("a.stl", "solid my solid\n" + facet + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" +
                                             end + "FACET\nOUTER LOOP\nvertex -0 1 0\nvertex 1 0 0\nvertex 1 1 0\n" +
                                             end + "endsolid my solid\n");
  CHECK(text.vertices.size() == 4);
  CHECK(text.faces == std::vector<Face>{{0, 1, 2}, {2, 1, 3}});
  for (const char* title : {"made by hand", "solid but binary"}) {
    const Meshd mesh = parse_mesh("a.stl", stl_binary(title));
    REQUIRE(mesh.vertices.size() == 4);
    CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  }
}

TEST_CASE("meshes: numbers are the nearest doubles, however small or long") {
  const auto x = [](const std::string& number) {
    return parse_mesh("a.obj", "v " + number + " 0 0\nf 1 1 1").vertices[0].x;
  };
  CHECK(x("0.1") == 0.1);
  CHECK(x("-15554.2597999999998137355") == -15554.2598);
  CHECK(x("1e-400") == 0);
  CHECK(x("1." + std::string(400, '0') + "e-99999999999999999999") == 0);
  CHECK(x("0." + std::string(400, '0') + "1") == 0);
  CHECK(x("0." + std::string(400, '0') + "1e401") == 1);
  CHECK(x("0e999999999999999999999") == 0);
  CHECK(x("4.9406564584124654e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(x("340282346999999984391321947108527833088.0000000000000000000") == 340282346999999984391321947108527833088.0);
  CHECK(std::signbit(x("-0.0")));
  for (const char* huge : {"1e309", "-1e999999999999999999999", "nan", "-Infinity", "NaN(1)"})
    CHECK(refusal("a.obj", "v 0 0 " + std::string(huge)) == "a.obj:1: finite number");
  for (const char* none : {"x", "1e", "1.2.3", "--1", "+-1", "0x1p3", "1,5", ".", "-"})
    CHECK(refusal("a.obj", "\nv 0 0 " + std::string(none)) == std::string("a.obj:2: number: got \"") + none + "\"");
  CHECK(refusal("a.obj", "v 0 0 1" + std::string(400, '0')) == "a.obj:1: finite number");
}

TEST_CASE("meshes: a refusal names the file, the place and the rule in one line") {
  CHECK(refusal("a.txt", "") ==
        "a.txt: OBJ, PLY, OFF, STL, glTF or 3MF: neither its content nor its name tells that it is one");
  CHECK(refusal("a\nb.obj", "v 0") == "a?b.obj:1: three coordinates");
  CHECK_THROWS_AS(audit::read_mesh_file("/no/such/file.obj"), InvalidInput);
  CHECK_THROWS_AS(audit::read_mesh_file("."), InvalidInput);
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* index : {"4", "4294967297", "9223372036854775807"})
    CHECK(refusal("a.obj", three + "f 1 2 " + index) ==
          std::string("a.obj:4: index of a vertex: got ") + index + " of 3 vertices, counted from 1");
  CHECK(refusal("a.obj", three + "f 1 2 -4") ==
        "a.obj:4: index of a vertex: got -4 of 3 vertices, counted from 1, or backwards from -1");
  CHECK(refusal("a.obj", three + "f 1 2 0") == "a.obj:4: index of a vertex: got 0, and OBJ counts from 1");
  CHECK(refusal("a.obj", three + "f 1 2 99999999999999999999") == "a.obj:4: an integer of less than 64 bits");
  CHECK(refusal("a.obj", three + "f 1 2 x/1") == "a.obj:4: an integer, got \"x\"");
  CHECK(refusal("a.obj", three + "f 1 2 /1") == "a.obj:4: an integer, got \"\"");
  CHECK(refusal("a.obj", "v 0,0 0,0 0,0\nf 1 1 1") == "a.obj:1: number: got \"0,0\"");
  CHECK(refusal("a.obj", three + "f 1 2") == "a.obj:4: at least 3 corners");
  CHECK(refusal("a.obj", three + "f 1 2 \\") == "a.obj:4: a line behind the backslash");
  CHECK(refusal("a.off", "") == "a.off:1: OFF in the first line");
  CHECK(refusal("a.off", "OFF BINARY\n") == "a.off:1: OFF as text");
  CHECK(refusal("a.off", "OFF\n3") == "a.off:2: counts of vertices and faces");
  CHECK(refusal("a.off", "OFF\n-3 1") == "a.off:2: counts of vertices and faces");
  CHECK(refusal("a.off", "OFF\n9000000000000000000 1\n0 0 0\n") ==
        "a.off:3: the file ends before the declared number of vertices");
  CHECK(refusal("a.off", "OFF\n1 9000000000000000000\n0 0 0\n") ==
        "a.off:3: the file ends before the declared number of faces");
  CHECK(refusal("a.off", "OFF\n1 1\n0 0 0\n9000000000000000000 0 0 0\n") ==
        "a.off:4: the line ends before the declared number of corners");
  CHECK(refusal("a.off", "OFF\n1 1\n0 0 0\n3 0 0 1\n") ==
        "a.off:4: index of a vertex: got 1 of 1 vertex, counted from 0");
  CHECK(refusal("a.off", "OFF\n1 0\n0 0 0\n3 0 0 0\n") == "a.off:4: nothing behind the last face");
}

TEST_CASE("meshes: hostile PLY and STL files are refused, whatever they count") {
  const std::string head = "ply\nformat ascii 1.0\n", xyz = "property float x\nproperty float y\nproperty float z\n";
  CHECK(refusal("a.ply", "PLY\n") == "a.ply:1: ply in the first line");
  CHECK(refusal("a.ply", "ply\nelement vertex 0\n" + xyz + "end_header\n") == "a.ply:6: a line with the format");
  CHECK(refusal("a.ply", "ply\nformat ascii 1.0\n") == "a.ply:2: end_header: the file ends too early");
  CHECK(refusal("a.ply", head + "element vertex 0\nproperty float y\nend_header\n") == "a.ply:3: a property x");
  CHECK(refusal("a.ply", head + "element nothing 9000000000000000000\nend_header\n") ==
        "a.ply:3: an element with properties");
  CHECK(refusal("a.ply", head + "element vertex 9000000000000000000\n" + xyz + "end_header\n1 2 3\n") ==
        "a.ply:8: the file ends before the declared number of values");
  CHECK(refusal("a.ply", head + "element vertex -1\n") == "a.ply:3: count >= 0");
  CHECK(refusal("a.ply", head + "element vertex 1\nproperty quad x\n").starts_with("a.ply:4: type of a property"));
  CHECK(refusal("a.ply", head + "element vertex 1\nproperty list float int x\n") ==
        "a.ply:4: an integer type for the counts of a list");
  CHECK(refusal("a.ply", head + "element vertex 0\n" + xyz + "end_header\n1\n") ==
        "a.ply:8: nothing behind the last element");
  const std::string face = "element face 1\nproperty list char int vertex_indices\n";
  CHECK(refusal("a.ply", head + face + "element vertex 0\n" + xyz + "end_header\n") ==
        "a.ply:3: element vertex before element face");
  const std::string one = head + "element vertex 1\n" + xyz + face + "end_header\n0 0 0\n";
  CHECK(refusal("a.ply", one + "2 0 0\n") == "a.ply:11: at least 3 corners");
  CHECK(refusal("a.ply", one + "-1\n") == "a.ply:11: count >= 0");
  CHECK(refusal("a.ply", one + "3 0 0 -1\n") == "a.ply:11: index of a vertex: got -1 of 1 vertex, counted from 0");
  CHECK(refusal("a.ply", one + "9000000000000000000 0 0 0\n") ==
        "a.ply:11: the file ends before the declared number of values");
  for (const bool big : {false, true}) {
    const std::string whole = ply_binary(big);
    for (std::size_t length = 0; length < whole.size(); ++length)
      CHECK(refusal("a.ply", whole.substr(0, length)).starts_with("a.ply:"));
    CHECK(refusal("a.ply", whole + "x").ends_with("nothing behind the last element"));
  }
  const std::string stl = stl_binary("x");
  for (std::size_t length = 0; length < stl.size(); ++length)
    CHECK(refusal("a.stl", stl.substr(0, length)).ends_with("ends too early"));
  CHECK(refusal("a.stl", stl + std::string(50, 'x')) ==
        "a.stl: byte 282: as many triangles as the header counts, 4: there is room for 5");
  std::string nan = stl;
  nan.replace(96, 4, "\xff\xff\xff\x7f");
  CHECK(refusal("a.stl", nan) == "a.stl: byte 96: finite number");
  CHECK(refusal("a.stl", "solid x\nfacet\n") == "a.stl:2: endsolid: the file ends too early");
  CHECK(refusal("a.stl", "solid x\nvertex 0 0 0\n").starts_with("a.stl:2: in the order"));
  CHECK(refusal("a.stl", "solid x\nfacet\nouter loop\nvertex 0 0\n") == "a.stl:4: three coordinates");
  CHECK(refusal("a.stl", "solid x\nfacet\nouter loop\nendloop\n") == "a.stl:4: at least 3 corners");
}

}  // namespace touchstone::proptests::read_mesh_tests
