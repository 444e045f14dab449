// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "audit/vectors/manifest.h"
#include "audit/vectors/named_files.h"
#include "audit/vectors/sha256.h"
#include "audit/version.h"
#include "catalogue/codec/shape_json.h"
#include "catalogue/families/meshes/named_meshes.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/probes/not_finite.h"
#include "catalogue/shape/described.h"
#include "oracle/certificates/check.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// What `vectors check` says of vectors that were changed by hand.
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

TEST_CASE("vectors: a refusal of another field or rule, or of what is valid, is complained about") {
  int refusals = 0;
  for (const char* operation : {"line_line", "line_point_at", "ray_segment"}) {
    for (Line line : stored(operation)) {
      if (!line.contains("refused")) {
        line["refused"] = {{"field", "a"}, {"rule", "finite number"}};
        CHECK(complaint(line) == "not refused");
        continue;
      }
      ++refusals;
      CHECK(complaint(line).empty());
      Line other = line;
      other["refused"]["rule"] = "another rule";
      CHECK(complaint(other) == "refused otherwise");
      other = line;
      other["refused"]["field"] = "elsewhere";
      CHECK(complaint(other) == "refused otherwise");
    }
  }
  CHECK(refusals >= 10);
}

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

TEST_CASE("vectors: a truth that its certificate allows and that is not the oracle's is complained about") {
  int changed = 0;
  for (Line line : stored("parametric_circle")) {
    if (line.contains("refused") || line["certificate"]["kind"] != "enclosure") continue;
    mpq_class x(line["truth"]["point"][0].get<std::string>());
    x *= 1 + mpq_class(1, mpz_class(1) << 115);
    line["truth"]["point"][0] = x.get_str();
    const std::string said = complaint(line);
    INFO(said);
    CHECK_FALSE(said.empty());
    changed += said.starts_with("the oracle's truth is");
  }
  CHECK(changed >= 10);
}

TEST_CASE("vectors: whatever else a vector says is complained about where it is not so") {
  const auto lines = stored("segment_segment");
  const auto valid = std::find_if(lines.begin(), lines.end(), [](const Line& line) { return line.contains("truth"); });
  REQUIRE(valid != lines.end());
  CHECK(complaint(*valid).empty());
  const auto changed = [&](const char* name, const Line& value) {
    Line other = *valid;
    other[name] = value;
    return complaint(other);
  };
  CHECK(changed("family", "stranger") == "family: one of the operation's families");
  CHECK_THAT(changed("margin", "1/7919"), StartsWith("margin is "));
  CHECK_THAT(changed("flags", {"stranger"}), StartsWith("flags is "));
  CHECK_THAT(changed("rounded", {{"relation", "stranger"}}), StartsWith("rounded is "));
  CHECK_THAT(changed("as_typed", {{"relation", "point"}}), StartsWith("as_typed is "));
}

TEST_CASE("vectors: a mesh that a line names is the catalogue's, to the last bit") {
  expect_named(*find_operation("point_in_convex_polyhedron"), named_meshes());
  std::vector<NamedMesh> solids = named_solids();
  solids.insert(solids.end(), long_solids().begin(), long_solids().end());
  expect_named(*find_operation("point_in_polyhedron"), solids);
}

TEST_CASE("vectors: a mesh file that was changed is complained about, even where every answer stays the same") {
  const std::string folder =
      (std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_vectors")).string();
  const std::string name = "meshes/geodesic_66.json", file = folder + "/" + name;
  std::filesystem::create_directories(folder + "/meshes");
  std::ifstream original("vectors/" + name);
  const Line mesh = Line::parse(original);
  std::vector<Line> lines = stored("point_in_convex_polyhedron");
  std::erase_if(lines, [&](const Line& line) { return line["input"]["mesh"] != name; });
  REQUIRE(lines.size() >= 4);
  const auto complaints = [&](const Line& changed) {
    std::ofstream(file) << changed;
    std::set<std::string> said;
    for (const Line& line : lines) said.insert(vector_complaint(line.dump(), folder));
    return said;
  };
  CHECK(complaints(mesh) == std::set<std::string>{""});
  const std::set<std::string> another{"mesh: " + name + " is not the mesh of that name"};
  Line turned = mesh;
  std::rotate(turned["faces"][100].begin(), turned["faces"][100].begin() + 1, turned["faces"][100].end());
  CHECK(complaints(turned) == another);
  Line unused = mesh;
  unused["vertices"].push_back({0, 0, 0});
  CHECK(complaints(unused) == another);
  Line moved = mesh;
  moved["vertices"][9][0] = std::nextafter(moved["vertices"][9][0].get<double>(), 0);
  CHECK(complaints(moved).count("") == 0);
  Line open = mesh;
  open["faces"].erase(7);
  const auto of_open = complaints(open);
  REQUIRE(of_open.size() == 1);
  CHECK_THAT(*of_open.begin(), ContainsSubstring("closed: edge"));
  const std::string one_vector = folder + "/x.jsonl";
  std::ofstream(one_vector) << lines[0] << '\n';
  std::ofstream(file) << mesh;
  CHECK(called({"certify", one_vector.c_str()}).out == "1 certificates, 0 refused\n");
  CHECK(called({"vectors", "check", folder.c_str()}).out == "1 vectors, 0 refused\n");
  std::filesystem::remove(file);
  const std::string missing = "touchstone: " + one_vector + ": line 1: mesh: " + name + ": a file that can be read\n";
  CHECK(called({"certify", one_vector.c_str()}).err == missing);
  CHECK(called({"vectors", "check", folder.c_str()}).err == missing);
  Line unknown = lines[0];
  CHECK(vector_complaint(unknown.dump(), folder) == "mesh: " + name + ": a file that can be read");
  unknown["input"]["mesh"] = "meshes/../" + name;
  CHECK_THAT(vector_complaint(unknown.dump(), folder), StartsWith("mesh: a file meshes/NAME.json"));
  unknown["input"]["mesh"] = "meshes/mine.json";  // holds, and its certificate too, but vectors name only ours
  std::ofstream(folder + "/meshes/mine.json") << mesh;
  CHECK(vector_complaint(unknown.dump(), folder) == "mesh: meshes/mine.json is not the mesh of that name");
  CHECK(!certify::refuse_text(unknown.dump(), folder));
  std::filesystem::remove_all(folder);
}

TEST_CASE("vectors: those of one operation are written alone, as they stand among all") {
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_one_operation");
  CHECK(called({"vectors", "write", folder.c_str(), "--ops", "orientation"}).code == 0);
  std::set<std::string> written;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) written.insert(entry.path().filename());
  CHECK(written == std::set<std::string>{"manifest.json", "meshes", "orientation.jsonl", "schema.json", "schemas"});
  const auto text_of = [](const std::filesystem::path& path) {
    std::ifstream in(path);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  for (const char* name : {"orientation.jsonl", "schema.json", "schemas/orientation.json"})
    CHECK(text_of(folder / name) == text_of(std::filesystem::path("vectors") / name));
  const Line part = Line::parse(text_of(folder / "manifest.json")),
             whole = Line::parse(text_of("vectors/manifest.json"));
  CHECK(part["files"]["orientation.jsonl"] == whole["files"]["orientation.jsonl"]);
  CHECK(part["vectors"] == part["files"]["orientation.jsonl"]["vectors"]);
  std::filesystem::remove_all(folder);
  require_refused(called({"vectors", "write", folder.c_str(), "--ops", "orientaton"}), 2, "orientaton");
  CHECK(!std::filesystem::exists(folder));
}

TEST_CASE("vectors: an id is the operation's name and the line's number") {
  std::uint64_t number = 0;
  for (const Line& line : stored("orientation")) {
    const std::string digits = std::to_string(++number);
    CHECK(line["id"] == "orientation/" + std::string(4 - digits.size(), '0') + digits);
  }
  const Line line = stored("orientation")[0];
  for (const char* id : {"", "orientation", "orientation/", "orientation/1", "orientation/00001", "orientation/000x",
                         "line_line/0001", "orientation/-001"}) {
    Line other = line;
    other["id"] = id;
    CHECK(complaint(other) == "id: like orientation/0001");
  }
  Line without = line;
  without.erase("id");
  CHECK(complaint(without) == "id: like orientation/0001");
}

TEST_CASE("vectors: SHA-256 is that of the standard") {
  // FIPS 180-4, examples; the lengths are those around which the padding takes another block.
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("vectors: the manifest counts the lines and tells a file that is missing, strange or changed") {
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_manifest");
  REQUIRE(called({"vectors", "write", folder.c_str(), "--ops", "reflect_wall"}).code == 0);
  CHECK(called({"vectors", "check", folder.c_str()}).code == 0);
  const std::string all = std::to_string(stored("reflect_wall").size()) + " vectors, 0 refused\n";
  CHECK(called({"vectors", "check", folder.c_str(), "--ops", "reflect_wall"}).out == all);
  CHECK(called({"vectors", "check", folder.c_str(), "--ops", "orientation"}).code == 2);  // no file of it is there
  CHECK(manifest_complaints(folder.string()).empty());
  std::ifstream manifest_file(folder / "manifest.json");
  const Line manifest = Line::parse(manifest_file);
  CHECK(manifest["generator"] == std::string("touchstone ") + version_number);
  CHECK(manifest["seed"] == 1);
  std::uint64_t lines = 0, refused = 0;
  for (const Line& line : stored("reflect_wall")) ++lines, refused += line.contains("refused");
  const Line& entry = manifest["files"]["reflect_wall.jsonl"];
  CHECK(entry["vectors"] == lines);
  CHECK(entry["refused"] == refused);
  CHECK(entry["bytes"] == std::filesystem::file_size(folder / "reflect_wall.jsonl"));

  std::ofstream(folder / "reflect_wall.jsonl", std::ios::app) << stored("reflect_wall")[0] << '\n';
  std::ofstream(folder / "mine.jsonl") << "";
  std::filesystem::remove(folder / "schema.json");
  const auto complaints = manifest_complaints(folder.string());
  REQUIRE(complaints.size() == 3);
  CHECK(complaints[0] == "reflect_wall.jsonl: vectors is " + std::to_string(lines + 1) + ", manifest.json says " +
                             std::to_string(lines));
  CHECK(complaints[1] == "schema.json: missing, manifest.json lists it");
  CHECK(complaints[2] == "mine.jsonl: not in manifest.json");
  const Called check = called({"vectors", "check", folder.c_str()});
  CHECK(check.code == 1);
  CHECK_THAT(check.err, ContainsSubstring("schema.json: missing") && ContainsSubstring("id: no other line's"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("vectors: what is no vector is complained about") {
  CHECK(vector_complaint("nonsense", "vectors") == "line: one JSON object");
  CHECK(vector_complaint("[]", "vectors") == "line: one JSON object");
  CHECK(vector_complaint("{}", "vectors") == "touchstone: version 1");
  CHECK(vector_complaint(R"({"touchstone":2})", "vectors") == "touchstone: version 1");
  CHECK(vector_complaint(R"({"touchstone":1,"op":"rotation"})", "vectors") == "op: an operation of the catalogue");
  CHECK(vector_complaint(R"({"touchstone":1,"op":7})", "vectors") == "op: an operation of the catalogue");
}

}  // namespace touchstone::proptests::vectors_tests
