// SPDX-License-Identifier: Apache-2.0
#include "program/commands/commands.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// `ask` about meshes of files, answered with the places of the file; all expected values are worked by hand.
namespace touchstone::proptests::ask_mesh_files_tests {
namespace {

/// A prism over a square with a notch, x from 1 to 2 and y from 1 to 3: 16 vertices, 24 edges, 10 faces.
const char* const notch =
    "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nv 0 0 1\nv 3 0 1\nv 3 3 1\nv 2 3 1\n"
    "v 2 1 1\nv 1 1 1\nv 1 3 1\nv 0 3 1\nf 8 7 6 5 4 3 2 1\nf 9 10 11 12 13 14 15 16\nf 1 2 10 9\nf 2 3 11 10\n"
    "f 3 4 12 11\nf 4 5 13 12\nf 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\nf 8 1 9 16\n";
/// A cube with a point in the middle of an edge: 9 vertices, 13 edges, 6 faces.
const char* const midpoint =
    "OFF\n9 6 0\n-1 -1 -1\n-1 -1 1\n-1 1 -1\n-1 1 1\n1 -1 -1\n1 -1 1\n1 1 -1\n1 1 1\n0 1 1\n4 0 1 3 2\n4 4 6 7 5\n"
    "4 0 4 5 1\n5 3 8 7 6 2\n4 0 2 6 4\n5 3 1 5 7 8\n";

/// A tetrahedron one of whose faces names a copy of the first vertex.
std::string torn(const std::string& copy) {
  return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv " + copy + "\nf 1 3 2\nf 5 2 4\nf 2 3 4\nf 1 4 3\n";
}

Called asked(const char* operation, const std::string& mesh, std::vector<const char*> options = {},
             const std::string& line = "{}", const std::string& name = "a.obj") {
  const TextFile file(name, mesh), lines("lines.jsonl", line + "\n");
  const std::string given = std::string("mesh=") + file.path();
  std::vector<const char*> words{"ask", operation, lines.path(), "--mesh", given.c_str()};
  words.insert(words.end(), options.begin(), options.end());
  return called(words);
}

std::string name_of_file() {
  const TextFile file("a.obj", "");
  return file.path();
}

}  // namespace

TEST_CASE("ask: a concave face of a file is the polygon that it is") {
  const Called complexity = asked("polyhedron_complexity", notch);
  CHECK(complexity.code == nothing_found);
  CHECK_THAT(complexity.out, ContainsSubstring("\"truth\":{\"vertices\":16,\"edges\":24,\"faces\":10,\"components\":1,"
                                               "\"euler\":\"2\",\"volume\":\"positive\",\"closed\":true"));
  CHECK_THAT(complexity.out, ContainsSubstring("\"embedded\":true,\"convex\":false"));
  CHECK_THAT(complexity.out, !ContainsSubstring("\"meshes\""));
  const Called point = asked("point_in_polyhedron", notch, {}, R"({"point":[1.5,2,1]})");
  CHECK_THAT(point.out, ContainsSubstring("\"truth\":{\"location\":\"outside\"}"));
}

TEST_CASE("ask: a cube with a point on one edge answers as a cube") {
  const Called call = asked("polyhedron_complexity", midpoint, {}, "{}", "a.off");
  CHECK_THAT(call.out, ContainsSubstring("\"truth\":{\"vertices\":9,\"edges\":13,\"faces\":6,\"components\":1,"
                                         "\"euler\":\"2\",\"volume\":\"positive\",\"closed\":true,\"oriented\":true,"
                                         "\"edge_manifold\":true,\"vertex_manifold\":true,\"embedded\":true,"
                                         "\"convex\":true"));
}

TEST_CASE("ask: witnesses are told with the places of the file, and what would close an open mesh") {
  const Called equal = asked("polyhedron_complexity", torn("0 0 0"));
  CHECK_THAT(equal.out, ContainsSubstring("\"open_edge\":[0,1]"));
  CHECK_THAT(equal.out, ContainsSubstring("\"open_edge\":\"edge from vertex 1 to vertex 2 (lines 1 and 2)\""));
  CHECK_THAT(equal.out,
             ContainsSubstring(R"("hints":["1 pair of vertices has equal positions; with --merge it is closed"])"));
  const Called near = asked("polyhedron_complexity", torn("1e-10 0 0"));
  CHECK_THAT(near.out, ContainsSubstring("\"hints\":[\"vertices 1 and 5 (lines 1 and 5) are 1e-10 apart, 1e-10 of the "
                                         "size; with --merge 1e-09 it is closed\"]"));
  const Called far = asked("polyhedron_complexity", torn("1e-3 0 0"));
  CHECK_THAT(far.out, ContainsSubstring("\"places\"") && !ContainsSubstring("\"hints\""));
}

TEST_CASE("ask: --merge closes what is torn, and says how many vertices it merged") {
  const Called equal = asked("polyhedron_complexity", torn("0 0 0"), {"--merge"});
  CHECK_THAT(equal.out, ContainsSubstring("\"closed\":true"));
  CHECK_THAT(equal.out,
             ContainsSubstring(R"("done":["1 vertex merged into others, those in equal positions; 4 vertices left"])"));
  const Called near = asked("polyhedron_complexity", torn("1e-10 0 0"), {"--merge", "1e-9"});
  CHECK_THAT(near.out, ContainsSubstring("\"closed\":true") && ContainsSubstring("the largest distance being 1e-10"));
  CHECK_THAT(asked("polyhedron_complexity", torn("1e-10 0 0"), {"--merge=0"}).out,
             ContainsSubstring("\"closed\":false") && ContainsSubstring("no vertices merged"));
  require_refused(asked("polyhedron_complexity", torn("0 0 0"), {"--merge", "0.5"}), bad_usage,
                  "--merge: expected a number from 0 to 0.01, got 0.5");
  require_refused(called({"ask", "polyhedron_complexity", "--merge"}), bad_usage, "--mesh");
}

TEST_CASE("ask: a refusal of a mesh names line, face and vertices of its file") {
  const Called open = asked("point_in_polyhedron", torn("0 0 0"), {}, R"({"point":[0,0,0]})");
  CHECK(open.code == bad_usage);
  CHECK(open.err ==
        name_of_file() +
            ":6: face 1 (mesh.faces[0]): closed: the edge from vertex 2 to vertex 1 (lines 2 and 1) must be "
            "in an even number of faces; 1 pair of vertices has equal positions; with --merge it is closed\n");
  CHECK_THAT(open.out, StartsWith(R"({"error":{"field":"mesh.faces[0]")") && ContainsSubstring("\"in_file\":"));
  const Called dent = asked("point_in_convex_polyhedron", notch, {}, R"({"point":[0,0,0]})");
  CHECK(dent.code == bad_usage);
  CHECK_THAT(dent.err, StartsWith(name_of_file() + ":") && ContainsSubstring("(mesh.faces[") &&
                           ContainsSubstring("must not lie beyond its plane") && ContainsSubstring("(line "));
  const Called point = asked("point_in_polyhedron", notch, {}, R"({"point":[0,0]})");
  CHECK_THAT(point.err, ContainsSubstring(": line 1: point"));
}

TEST_CASE("ask: faces that are not planar are cut as told, and the answer says so") {
  const std::string bent =
      "v 0 0 0\nv 1 0 0.25\nv 1 1 0\nv 0 1 0.25\nv 0.5 0.5 2\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  require_refused(asked("polyhedron_complexity", bent), bad_usage,
                  ":6: face 1 (mesh.faces[0]): planar: its corners lie "
                  "0.25 apart across it; --planar TOLERANCE or --cut");
  for (const std::vector<const char*>& how :
       {std::vector<const char*>{"--planar", "0.25"}, {"--cut", "fan"}, {"--cut", "shortest"}}) {
    const Called call = asked("polyhedron_complexity", bent, how);
    CHECK(call.code == nothing_found);
    CHECK_THAT(call.out, ContainsSubstring("\"vertices\":5,\"edges\":9,\"faces\":6") &&
                             ContainsSubstring("\"closed\":true") && ContainsSubstring("\"done\":[\"1 face cut "));
  }
}

TEST_CASE("ask: --mesh needs no field where an operation has one mesh, and says the fields where it has two") {
  const std::string with_field = asked("polyhedron_complexity", torn("0 0 0"), {"--merge"}).out;
  const TextFile file("a.obj", torn("0 0 0")), line("line.jsonl", "{}\n");
  CHECK(called({"ask", "polyhedron_complexity", line.path(), "--mesh", file.path(), "--merge"}).out == with_field);
  require_refused(called({"ask", "polyhedron_polyhedron", line.path(), "--mesh", file.path()}), bad_usage,
                  "--mesh: expected field=FILE with field a or b, got ");
  require_refused(called({"ask", "segment_segment", line.path(), "--mesh", file.path()}), bad_usage,
                  "--mesh: segment_segment has no field that is a mesh, got ");
  require_refused(called({"certify", line.path(), "--mesh", file.path()}), bad_usage,
                  "--mesh: expected field=FILE, got");
}

TEST_CASE("ask: --truth names the file of a mesh instead of repeating the mesh") {
  const Called call = asked("polyhedron_complexity", torn("0 0 0"), {"--merge", "--truth"});
  CHECK_THAT(call.out, ContainsSubstring(R"("input":{"mesh":")" + name_of_file() + "\"}") &&
                           ContainsSubstring("\"closed\":true"));
}

TEST_CASE("ask: --verbose tells what was read and made of a mesh") {
  const Called call = asked("polyhedron_complexity", torn("0 0 0") + "vn 0 0 1\n", {"--merge", "--verbose"});
  CHECK_THAT(call.err, ContainsSubstring("OBJ: 5 vertices, 4 faces of 3 corners\n") &&
                           ContainsSubstring("passed over: 1 vn\n") &&
                           ContainsSubstring("1 vertex merged into others"));
}

TEST_CASE("certify: the line of a merged mesh is certified, as a claim about its file and about no other") {
  const std::string text = torn("0 0 0");
  const std::string said = asked("polyhedron_complexity", text, {"--merge"}).out;
  const TextFile line("line.jsonl", said), file("mesh.obj", text), other("other.obj", torn("0 0 0.5"));
  CHECK(called({"certify", line.path()}).out == "1 certificates, 0 refused\n");
  const auto about = [](const TextFile& claim, const TextFile& mesh, const std::vector<const char*>& how) {
    const std::string named = std::string("mesh=") + mesh.path();
    std::vector<const char*> words = {"certify", claim.path(), "--mesh", named.c_str()};
    words.insert(words.end(), how.begin(), how.end());
    return called(words);
  };
  CHECK(about(line, file, {"--merge"}).out == "1 certificates, 0 refused\n");
  for (const Called& call : {about(line, file, {}), about(line, other, {"--merge"})}) {
    CHECK(call.code == findings);
    CHECK_THAT(call.err, ContainsSubstring("line 1: input.mesh is not the mesh of "));
  }
  const std::size_t from = said.find("\"mesh\":"), to = said.find("},\"truth\"");
  const TextFile without("without.jsonl", std::string(said).erase(from, to - from));
  CHECK(about(without, file, {"--merge"}).out == "1 certificates, 0 refused\n");
  CHECK(about(without, other, {"--merge"}).code == findings);
}

}  // namespace touchstone::proptests::ask_mesh_files_tests
