// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "audit/meshes/formats/mesh_file.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/meshes/binary.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::gltf_tests {
namespace {

using audit::MeshFile;
using audit::parse_mesh_file;
using Faces = std::vector<std::vector<Index>>;
using Notes = std::vector<std::string>;

const std::string square_buffer = [] {
  std::string bytes;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.1f, 1.f, 0.f, 1.f, 1.f, 0.f}) append(bytes, x);
  for (const std::uint16_t i : {0, 1, 3, 0, 3, 2}) append(bytes, i);
  for (const std::uint8_t i : {0, 1, 2, 3, 3, 1}) append(bytes, i);
  return bytes;
}();

const std::string accessors = R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},)"
                              R"({"bufferView":0,"byteOffset":48,"componentType":5123,"type":"SCALAR","count":6},)"
                              R"({"bufferView":0,"byteOffset":60,"componentType":5121,"type":"SCALAR","count":6}],)"
                              R"("bufferViews":[{"buffer":0,"byteLength":66}],"buffers":[{"byteLength":66}])";
const std::string one_node = R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])";

std::string primitives(const std::string& all) { return R"("meshes":[{"primitives":[)" + all + "]}]"; }
const std::string indexed = primitives(R"({"attributes":{"POSITION":0},"indices":1})");

std::string glb(const std::string& members, const std::string& buffer = square_buffer) {
  std::string text = R"({"asset":{"version":"2.0"},)" + members + "}", bytes = "glTF", padded = buffer;
  text.resize((text.size() + 3) / 4 * 4, ' '), padded.resize((buffer.size() + 3) / 4 * 4);
  append(bytes, std::uint32_t{2}), append(bytes, static_cast<std::uint32_t>(28 + text.size() + padded.size()));
  append(bytes, static_cast<std::uint32_t>(text.size())), bytes += "JSON" + text;
  append(bytes, static_cast<std::uint32_t>(padded.size())), bytes += std::string("BIN\0", 4) + padded;
  return bytes;
}

MeshFile read(const std::string& members) { return parse_mesh_file("a.glb", glb(members)); }

std::string refusal(const std::string& bytes, const std::string& name = "a.glb") {
  return refusal_of([&] { parse_mesh_file(name, bytes); });
}

std::string refused(const std::string& members) { return refusal(glb(members)); }

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  REQUIRE(text.find(part) != text.npos);
  return text.replace(text.find(part), part.size(), by);
}

}  // namespace

TEST_CASE("glTF: positions are the float32 numbers that are stored, and nothing is cut or merged") {
  const MeshFile mesh = read(one_node + "," + indexed + "," + accessors);
  CHECK(mesh.format == "glTF (binary)");
  CHECK(mesh.vertices == std::vector<Point3d>{{0, 0, 0}, {1, 0, 0}, {static_cast<double>(0.1f), 1, 0}, {1, 1, 0}});
  CHECK(mesh.faces == Faces{{0, 1, 3}, {0, 3, 2}});
  CHECK(mesh.first_number == 0);
  CHECK(mesh.face_lines.empty());
}

TEST_CASE("glTF: triangles without indices, strips and fans; lines and points are passed over") {
  const auto faces = [](const std::string& primitive) {
    return read(one_node + "," + primitives(R"({"attributes":{"POSITION":0},)" + primitive + "}") + "," + accessors);
  };
  CHECK(faces(R"("mode":5)").faces == Faces{{0, 1, 2}, {2, 1, 3}});
  CHECK(faces(R"("mode":6)").faces == Faces{{0, 1, 2}, {0, 2, 3}});
  const MeshFile strip = faces(R"("mode":5,"indices":2)");  // 0 1 2 3 3 1
  CHECK(strip.faces == Faces{{0, 1, 2}, {2, 1, 3}});
  CHECK(strip.notes == Notes{"strips of triangles are read as faces, without 2 triangles with a vertex named twice"});
  const MeshFile mixed =
      read(one_node + "," +
           primitives(R"({"attributes":{"POSITION":0},"mode":1},{"attributes":{"POSITION":0},"mode":0},)"
                      R"({"attributes":{"POSITION":0},"indices":1,"mode":4})") +
           "," + accessors + R"(,"materials":[{},{}])");
  CHECK(mixed.vertices.size() == 4);  // All share one accessor.
  CHECK(mixed.faces.size() == 2);
  CHECK(mixed.passed_over ==
        std::map<std::string, std::size_t>{{"line primitives", 1}, {"materials", 2}, {"point primitives", 1}});
  CHECK(refused(one_node + "," + primitives(R"({"attributes":{"POSITION":0},"mode":3})") + "," + accessors) ==
        "a.glb: at least one face: the file holds 4 vertices and 1 line");
  CHECK(refused(one_node + "," + primitives(R"({"attributes":{"POSITION":0}})") + "," + accessors) ==
        "a.glb: meshes[0].primitives[0]: three corners a triangle");
}

TEST_CASE("glTF: nodes move positions, exactly") {
  const auto with_nodes = [](const std::string& nodes) {
    return R"("scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "]," + indexed + "," + accessors;
  };
  const double tenth = static_cast<double>(0.1f);
  const MeshFile chain = read(with_nodes(R"({"translation":[8,0,0.5],"children":[1]},{"scale":[2,4,1],"mesh":0})"));
  CHECK(chain.vertices == std::vector<Point3d>{{8, 0, 0.5}, {10, 0, 0.5}, {8 + 2 * tenth, 4, 0.5}, {10, 4, 0.5}});
  CHECK(chain.faces == Faces{{0, 1, 3}, {0, 3, 2}});
  const MeshFile half_turn = read(with_nodes(R"({"mesh":0,"rotation":[0,0,-1,0]})"));
  CHECK(half_turn.vertices[2] == Point3d{-tenth, -1, 0});
  CHECK(half_turn.faces == Faces{{0, 1, 3}, {0, 3, 2}});
  // x to z, y to x, z to y
  const MeshFile permuted = read(with_nodes(R"({"mesh":0,"matrix":[0,0,1,0, 1,0,0,0, 0,1,0,0, 0,0,7,1]})"));
  CHECK(permuted.vertices[2] == Point3d{1, 0, 7 + tenth});
  CHECK(permuted.faces == Faces{{0, 1, 3}, {0, 3, 2}});
  const MeshFile mirrored = read(with_nodes(R"({"mesh":0,"scale":[1,-1,1]})"));
  CHECK(mirrored.vertices[3] == Point3d{1, -1, 0});
  CHECK(mirrored.faces == Faces{{3, 1, 0}, {2, 3, 0}});
  const std::string rule = "a transform that keeps all positions doubles; apply it in the program that exports";
  CHECK(refused(with_nodes(R"({"children":[1]},{"mesh":0,"scale":[0.1,1,1]})")) == "a.glb: nodes[1]: " + rule);
  CHECK(refused(with_nodes(R"({"mesh":0,"translation":[1e300,0,0]})")) == "a.glb: nodes[0]: " + rule);
  CHECK(refused(with_nodes(R"({"scale":[0.1,1,1],"children":[1]},{"mesh":0,"scale":[0.1,1,1]})")) ==
        "a.glb: nodes[1]: " + rule);
  CHECK(refused(with_nodes(R"({"mesh":0,"scale":[1e300,1,1],"translation":[1e-300,0,0]})")) ==
        "a.glb: nodes[0]: " + rule);
  CHECK(refused(with_nodes(R"({"mesh":0,"rotation":[0.7071068,0,0,0.7071068]})"))
            .starts_with("a.glb: nodes[0].rotation: none, or a half turn about an axis"));
  CHECK(refused(with_nodes(R"({"mesh":0,"rotation":[1,0,0,1]})")).starts_with("a.glb: nodes[0].rotation: none"));
  CHECK(refused(with_nodes(R"({"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]})")) ==
        "a.glb: nodes[0].matrix: a last row of 0 0 0 1");
  CHECK(refused(with_nodes(R"({"mesh":0,"children":[0]})")) == "a.glb: nodes[0]: a node with at most one parent");
}

TEST_CASE("glTF: a mesh is there once for each node that shows it, within a limit") {
  const std::string two =
      R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[2,0,0]}],)" + indexed;
  const MeshFile placed = read(two + "," + accessors);
  CHECK(placed.vertices.size() == 8);
  CHECK(placed.faces == Faces{{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}});
  const MeshFile unseen =
      read(replaced(one_node + "," + indexed, "}]}]", R"(}]},{"primitives":[]}])") + "," + accessors);
  CHECK(unseen.notes == Notes{"the scene does not show 1 of 2 meshes"});
  CHECK(read(indexed + "," + accessors).faces.size() == 2);  // No scene: all meshes.
  // 3,000 points, placed by each of 2,000 nodes
  std::string nodes = R"("scenes":[{"nodes":[0)", list = R"("nodes":[{"mesh":0})";
  for (int i = 1; i < 2000; ++i) nodes += "," + std::to_string(i), list += R"(,{"mesh":0})";
  const std::string many = R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3000}],)"
                           R"("bufferViews":[{"buffer":0,"byteLength":36000}],"buffers":[{"byteLength":36000}])";
  CHECK(refusal(glb(nodes + "]}]," + list + "]," + primitives(R"({"attributes":{"POSITION":0}})") + "," + many,
                    std::string(36000, '\0'))) ==
        "a.glb: at most 4,194,304 vertices and corners where all parts are placed");
}

TEST_CASE("glTF: what does not hold together is refused by its name") {
  const std::string good = one_node + "," + indexed + "," + accessors;
  const auto bad = [&](const std::string& part, const std::string& by) { return refused(replaced(good, part, by)); };
  CHECK(bad(R"("count":4)", R"("count":4294967295)") == "a.glb: accessors[0]: inside its bufferView");
  CHECK(bad(R"("count":4)", R"("count":4294967296)") == "a.glb: accessors[0].count: an integer from 0 to 2^32 - 1");
  CHECK(bad(R"("count":4)", R"("count":-4)") == "a.glb: accessors[0].count: an integer from 0 to 2^32 - 1");
  CHECK(bad(R"("count":4)", R"("count":3)") == "a.glb: accessors[1]: indices of vertices");
  CHECK(bad(R"("count":6)", R"("count":5)") == "a.glb: meshes[0].primitives[0]: three corners a triangle");
  CHECK(bad(R"("byteOffset":48)", R"("byteOffset":55)") == "a.glb: accessors[1]: inside its bufferView");
  CHECK(bad(R"("buffer":0)", R"("buffer":1)") == "a.glb: buffers: an entry [1]");
  CHECK(bad(R"("byteLength":66}],"buffers")", R"("byteLength":69}],"buffers")") ==
        "a.glb: bufferViews[0]: inside its buffer");
  CHECK(bad(R"("buffers":[{"byteLength":66})", R"("buffers":[{"byteLength":69})") ==
        "a.glb: buffers[0].byteLength: no more than the buffer has, 68");
  CHECK(bad("5126", "5123") == "a.glb: accessors[0]: positions of three float32 numbers each");
  CHECK(bad("5123", "5126") == "a.glb: accessors[1]: indices of uint8, uint16 or uint32");
  CHECK(bad(R"("indices":1)", R"("indices":7)") == "a.glb: accessors: an entry [7]");
  CHECK(bad(R"("mesh":0)", R"("mesh":1)") == "a.glb: meshes: an entry [1]");
  CHECK(bad(R"("POSITION":0)", R"("NORMAL":0)") == "a.glb: meshes[0].primitives[0].attributes.POSITION: missing");
  CHECK(bad(R"("bufferView":0,"componentType":5126)", R"("componentType":5126)") ==
        "a.glb: accessors[0].bufferView: missing");
  CHECK(bad(R"("count":4)", R"("count":4,"sparse":{})") ==
        "a.glb: accessors[0].sparse: no sparse accessor; export without it");
  CHECK(
      refused(good + R"(,"extensionsRequired":["KHR_materials_unlit","KHR_draco_mesh_compression"])") ==
      "a.glb: extensionsRequired[1]: no extension that positions need (compression, quantization); export without it");
  CHECK(refusal(R"({"asset":{"version":"1.0"}})") == "a.glb: asset.version: glTF of version 2");
  CHECK(refusal(R"({"asset":)") == "a.glb: JSON as glTF 2.0 has it");
  CHECK(refusal(replaced(glb(good), std::string("glTF\2"), std::string("glTF\1"))) ==
        "a.glb: byte 4: glTF of version 2");
  std::string nan = square_buffer;
  nan.replace(4, 4, "\xff\xff\xff\x7f");
  CHECK(refusal(glb(good, nan)) == "a.glb: accessors[0]: byte 4: finite number");
  const std::string whole = glb(good);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string cut = refusal(whole.substr(0, length));
    CHECK((cut.starts_with("a.glb") && cut.find('\n') == cut.npos));
  }
}

TEST_CASE("glTF: buffers are in base64 or in files of the same folder") {
  const auto with_uri = [](const std::string& uri) {
    return R"({"asset":{"version":"2.0"},)" + one_node + "," + primitives(R"({"attributes":{"POSITION":0}})") +
           R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,)"
           R"("byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
           uri + "\"}]}";
  };
  // 0 0 0, 1 0 0, 0 1 0; 1 is 00 00 80 3f
  const std::string zero(16, 'A'), base64 = zero + "AACAPwAAAAAAAAAA" + "AAAAAAAAgD8AAAAA";
  const MeshFile mesh = parse_mesh_file("a.gltf", with_uri("data:application/octet-stream;base64," + base64));
  CHECK(mesh.format == "glTF");
  CHECK(mesh.vertices == std::vector<Point3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(refusal(with_uri("data:;base64,A*"), "a.gltf") == "a.gltf: buffers[0].uri: base64");
  CHECK(refusal(with_uri("data:,x"), "a.gltf") == "a.gltf: buffers[0].uri: data in base64");
  CHECK(refusal(with_uri("a%20b.bin"), "a.gltf") == "a.gltf: all in one file: a b.bin is not at hand");
  CHECK(refusal(with_uri("a%2"), "a.gltf") == "a.gltf: buffers[0].uri: a file's name");
  for (const char* elsewhere :
       {"../a.bin", "/a.bin", "%2e%2e/a.bin", "https://example.org/a.bin", "file:a.bin", "", "a%00"})
    CHECK(refusal(with_uri(elsewhere), "a.gltf") ==
          "a.gltf: buffers[0].uri: data in base64, or a file in the same folder");
}

}  // namespace touchstone::proptests::gltf_tests
