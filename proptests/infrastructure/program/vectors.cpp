// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "audit/vectors/named_files.h"
#include "audit/vectors/sha256.h"
#include "audit/vectors/vectors.h"
#include "catalogue/codec/shape_json.h"
#include "catalogue/families/meshes/named_meshes.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/probes/not_finite.h"
#include "catalogue/shape/described.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

/// What the vectors in vectors/ hold.
namespace touchstone::proptests::vectors_tests {
namespace {

using Line = nlohmann::json;

/// Vectors of an operation as they stand in vectors/; the test program runs in the source folder.
std::vector<Line> stored(const std::string& operation) {
  std::ifstream in("vectors/" + operation + ".jsonl");
  std::vector<Line> lines;
  for (std::string text; std::getline(in, text);) lines.push_back(Line::parse(text));
  REQUIRE(lines.size() > 20);
  return lines;
}

std::string complaint(const Line& line) { return vector_complaint(line.dump(), "vectors"); }

/// Each of the meshes is named by a line of the operation, and none else.
void expect_named(const Operation& operation, const std::vector<NamedMesh>& meshes) {
  std::map<std::string, Line> named;
  for (const Line& line : stored(operation.name())) {
    if (line["input"]["mesh"].is_string()) named.emplace(line["input"]["mesh"], line);
  }
  CHECK(named.size() == meshes.size());
  for (const auto& [name, mesh] : meshes) {
    const Line& line = named.at("meshes/" + name + ".json");
    const Json input = without_names(parse_line(line["input"].dump()), "vectors");
    const auto [held, point] = unpacked<std::tuple<Meshd, Point3d>>(operation.parse(input));
    CHECK(one_line(to_json(held)) == one_line(to_json(mesh)));
    const auto bits = [](const Meshd& of) {
      std::vector<std::uint64_t> all;
      for (const Point3d& p : of.vertices) {
        for (const double x : {p.x, p.y, p.z}) all.push_back(std::bit_cast<std::uint64_t>(x));
      }
      return all;
    };
    CHECK(bits(held) == bits(mesh));
  }
}

}  // namespace

TEST_CASE("vectors: every operation has a vector for each of its numbers that is not finite") {
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    std::set<std::string> fields;
    for (const Line& line : stored(operation->name())) {
      if (line["family"] != "not_finite") continue;
      CHECK(line["refused"]["rule"] == "finite number");
      fields.insert(line["refused"]["field"]);
    }
    std::set<std::string> wanted;
    for (const Question& zeros : operation->zeros_of_alternatives()) {
      for (std::size_t i = 0; i < zeros.numbers.size(); ++i) {
        try {
          operation->examine(with_not_finite(*operation, zeros, i, std::nan("")));
        } catch (const InvalidInput& refused) {
          wanted.insert(refused.field());
        }
      }
      CHECK(wanted.size() >= zeros.numbers.size());
    }
    CHECK(fields == wanted);
  }
}

TEST_CASE("vectors: a mesh that a line names is the catalogue's, to the last bit") {
  expect_named(*find_operation("point_in_convex_polyhedron"), named_meshes());
  std::vector<NamedMesh> solids = named_solids();
  solids.insert(solids.end(), long_solids().begin(), long_solids().end());
  expect_named(*find_operation("point_in_polyhedron"), solids);
}

TEST_CASE("vectors: an id names the same question in every version") {
  // Ids since 0.1.0: the first digits of `sha256sum` of the input, as it is written.
  const std::map<std::string, std::string> kept{
      {R"({"p0":[-440,-4],"p1":[-391,-4],"p":[-454,-4]})", "orientation/c9a42069fb"},
      {R"({"mesh":"meshes/hollow_64.json","point":[30,30,12]})", "point_in_polyhedron/3d70177100"}};
  for (const auto& [input, id] : kept) {
    const Operation& operation = *find_operation(id.substr(0, id.find('/')));
    const Question question = operation.parse_any(without_names(parse_line(input), "vectors"));
    CHECK(Line::parse(vectors_of(operation, {question})[0])["id"] == id);
  }
}

TEST_CASE("vectors: an id that is not made of its input is refused") {
  const Line line = stored("orientation")[0];
  const std::string expected = "id is " + line["id"].dump();
  for (const char* id : {"", "orientation", "orientation/", "orientation/0001", "line_line/c9a42069fb"}) {
    Line other = line;
    other["id"] = id;
    CHECK(complaint(other) == expected);
  }
  Line without = line;
  without.erase("id");
  CHECK(complaint(without) == expected);
}

TEST_CASE("vectors: SHA-256 is that of the standard") {
  // FIPS 180-4, examples; the lengths are those around which the padding takes another block.
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace touchstone::proptests::vectors_tests
