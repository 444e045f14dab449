// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "audit/meshes/formats/mesh_file.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/meshes/binary.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::threemf_tests {
namespace {

using audit::MeshFile;
using audit::parse_mesh_file;
using Faces = std::vector<std::vector<Index>>;

/// The checksum of zip, bit by bit.
std::uint32_t checksum(const std::string& bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~sum;
}

/// What both records of a stored file have in common, from its flags to the length of its extra field.
std::string description(const std::string& name, const std::string& content, std::uint16_t flags, bool wide) {
  std::string bytes;
  append(bytes, flags), append(bytes, std::uint16_t{0}), append(bytes, std::uint32_t{0});
  append(bytes, checksum(content));
  for (int k = 0; k < 2; ++k) append(bytes, wide ? 0xffffffff : static_cast<std::uint32_t>(content.size()));
  append(bytes, static_cast<std::uint16_t>(name.size())), append(bytes, static_cast<std::uint16_t>(wide ? 20 : 0));
  return bytes;
}

/// The lengths in 64 bits.
std::string extra(const std::string& content) {
  std::string bytes;
  append(bytes, std::uint16_t{1}), append(bytes, std::uint16_t{16});
  for (int k = 0; k < 2; ++k) append(bytes, std::uint64_t{content.size()});
  return bytes;
}

/// An archive of files that are stored; `wide`: with the records of 64 bits.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files, bool wide = false,
                std::uint16_t flags = 0) {
  std::string all, directory;
  for (const auto& [name, content] : files) {
    const std::string described = description(name, content, flags, wide), behind = wide ? extra(content) : "";
    directory += std::string("PK\1\2\0\0\0\0", 8) + described + std::string(10, '\0');
    append(directory, static_cast<std::uint32_t>(all.size()));
    directory += name + behind;
    all += std::string("PK\3\4\0\0", 6) + described + name + behind + content;
  }
  std::string end;
  if (wide) {
    end += "PK\6\6" + std::string(20, '\0');
    for (const std::size_t number : {files.size(), files.size(), directory.size(), all.size()})
      append(end, std::uint64_t{number});
    end += std::string("PK\6\7\0\0\0\0", 8);
    append(end, std::uint64_t{all.size() + directory.size()}), append(end, std::uint32_t{1});
  }
  const std::uint16_t count = wide ? 0xffff : static_cast<std::uint16_t>(files.size());
  end += std::string("PK\5\6\0\0\0\0", 8);
  append(end, count), append(end, count), append(end, static_cast<std::uint32_t>(directory.size()));
  append(end, wide ? 0xffffffff : static_cast<std::uint32_t>(all.size())), append(end, std::uint16_t{0});
  return all + directory + end;
}

const std::string relationships =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
    R"(<Relationship Id="r" Target="/a.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
    "</Relationships>";

std::string model(const std::string& resources, const std::string& build) {
  return R"(<?xml version="1.0" encoding="UTF-8"?><model unit="inch")"
         R"( xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06")"
         R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><metadata name="Title">x</metadata>)"
         "\n<resources>\n" +
         resources + "\n</resources><build>" + build + "</build></model>";
}

const std::string triangle =
    R"(<object id="1"><mesh><vertices><vertex x="0.1" y="0" z="1e-3"/><vertex x="1" y="0" z="0"/>)"
    R"(<vertex x="0" y="-2.5" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles>)"
    R"(</mesh></object>)";
const std::string item = R"(<item objectid="1"/>)";

std::string archive(const std::string& resources, const std::string& build) {
  return zip({{"_rels/.rels", relationships}, {"a.model", model(resources, build)}});
}

MeshFile read(const std::string& resources, const std::string& build) {
  return parse_mesh_file("a.3mf", archive(resources, build));
}

std::string refusal(const std::string& bytes) {
  return refusal_of([&] { parse_mesh_file("a.3mf", bytes); });
}

std::string refused(const std::string& resources, const std::string& build) {
  return refusal(archive(resources, build));
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  REQUIRE(text.find(part) != text.npos);
  return text.replace(text.find(part), part.size(), by);
}

}  // namespace

TEST_CASE("3MF: decimals become the nearest doubles, in the file's unit") {
  const MeshFile mesh = read(triangle, item);
  CHECK(mesh.format == "3MF");
  CHECK(mesh.vertices == std::vector<Point3d>{{0.1, 0, 0.001}, {1, 0, 0}, {0, -2.5, 0}});
  CHECK(mesh.faces == Faces{{0, 1, 2}});
  CHECK(mesh.passed_over == std::map<std::string, std::size_t>{{"metadata", 1}});
  const MeshFile wide =
      parse_mesh_file("a.3mf", zip({{"_rels/.rels", relationships}, {"a.model", model(triangle, item)}}, true));
  CHECK(wide.vertices == mesh.vertices);
  CHECK(parse_mesh_file("a.obj", archive(triangle, item)).notes ==
        std::vector<std::string>{"the content is 3MF, whatever the name says"});
}

TEST_CASE("3MF: items and components place objects, exactly") {
  // x to y, y to z, z to x, and moved
  const MeshFile moved =
      read(replaced(triangle, "1e-3", "0.5"), item + R"(<item objectid="1" transform="0 1 0 0 0 1 1 0 0 8 0 0"/>)");
  CHECK(moved.vertices[4] == Point3d{8, 1, 0});
  CHECK(moved.vertices[5] == Point3d{8, 0, -2.5});
  CHECK(moved.faces == Faces{{0, 1, 2}, {3, 4, 5}});
  const MeshFile mirrored = read(triangle, R"(<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)");
  CHECK(mirrored.vertices[1] == Point3d{-1, 0, 0});
  CHECK(mirrored.faces == Faces{{2, 1, 0}});
  // Half as large, then moved by 2: 2 + 1/2.
  const std::string pair =
      triangle + R"(<object id="two"><components><component objectid="1" transform=".5 0 0 0 .5 0 0 0 .5 0 0 0"/>)"
                 R"(<component objectid="1"/></components></object>)";
  const MeshFile parts =
      read(replaced(pair, "0.1", "0.25"), R"(<item objectid="two" transform="1 0 0 0 1 0 0 0 1 2 0 0"/>)");
  CHECK(parts.vertices[1] == Point3d{2.5, 0, 0});
  CHECK(parts.vertices[2] == Point3d{2, -1.25, 0});
  CHECK(parts.vertices[4] == Point3d{3, 0, 0});
  CHECK(parts.faces == Faces{{0, 1, 2}, {3, 4, 5}});
  CHECK(refused(triangle, R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/>)") ==
        "a.3mf: object 1: a transform that keeps all positions doubles; apply it in the program that exports");
}

TEST_CASE("3MF: parts within parts within parts are refused beyond a limit") {
  std::string objects = triangle;
  for (int i = 2; i < 60; ++i) {
    const std::string below = R"(<component objectid=")" + std::to_string(i - 1) + "\"/>";
    objects += "<object id=\"" + std::to_string(i) + "\"><components>" + below + below + "</components></object>";
  }
  CHECK(refused(objects, R"(<item objectid="59"/>)") ==
        "a.3mf: at most 4,194,304 vertices and corners where all parts are placed");
}

TEST_CASE("3MF: what does not hold together is refused, in one line") {
  const auto bad = [](const std::string& part, const std::string& by) {
    return refused(replaced(triangle, part, by), item);
  };
  CHECK(bad(R"(v3="2")", R"(v3="3")") == "a.3mf: a.model:3: index of a vertex");
  CHECK(bad(R"(v3="2")", R"(v3="-1")") == "a.3mf: a.model:3: index of a vertex");
  CHECK(bad(R"(v3="2")", R"(v3="")") == "a.3mf: a.model:3: index of a vertex");
  CHECK(bad(R"(v3="2")", R"(v3="99999999999999999999999999")") == "a.3mf: a.model:3: index of a vertex");
  CHECK(bad(R"(v3="2")", "") == "a.3mf: a.model:3: an attribute v3");
  CHECK(bad(R"(x="0.1")", R"(x="nan")") == "a.3mf: a.model:3: finite number");
  CHECK(bad(R"(x="0.1")", R"(x="1e999")") == "a.3mf: a.model:3: finite number");
  CHECK(bad("<mesh>", "<mesh") == "a.3mf: a.model:3: XML: not well-formed (invalid token)");
  CHECK(refused(triangle + triangle, item) == "a.3mf: a.model:3: an id of its own");
  CHECK(refused("", item) == "a.3mf: a.model:4: an object further above");
  CHECK(refused(R"(<object id="1"><components><component objectid="1"/></components></object>)", item) ==
        "a.3mf: a.model:3: an object further above");
  CHECK(refused(R"(<vertex x="0" y="0" z="0"/>)", "") == "a.3mf: a.model:3: inside an object");
  CHECK(refused(triangle, R"(<item objectid="1" transform="1 0 0"/>)") ==
        "a.3mf: a.model:4: a transform of 12 numbers");
  CHECK(refused(triangle, R"(<item objectid="1" p:path="/b.model"/>)") ==
        "a.3mf: a.model:4: objects of this part only; export as one part");
  CHECK(refused(triangle, "") == "a.3mf: at least one face: the file holds nothing");
  const auto with_model = [](const std::string& text) {
    return zip({{"_rels/.rels", relationships}, {"a.model", text}});
  };
  CHECK(refusal(with_model("<!DOCTYPE model [<!ENTITY a \"b\">]><model/>")) ==
        "a.3mf: a.model:1: XML without a document type");
  CHECK(refusal(with_model("")) == "a.3mf: a.model:1: XML: no element found");
  CHECK(refusal(zip({{"_rels/.rels", relationships}})) == "a.3mf: 3MF: a zip archive with a model");
  CHECK(refusal(zip({{"a.model", model(triangle, item)}})) == "a.3mf: 3MF: a zip archive with a file _rels/.rels");
  CHECK(refusal(zip({{"a", ""}, {"a", ""}})) == "a.3mf: a: in the archive only once");
  CHECK(refusal(zip({{"_rels/.rels", relationships}, {"a.model", ""}}, false, 1)) ==
        "a.3mf: _rels/.rels: not encrypted");
  CHECK(refusal(replaced(archive(triangle, item), "-2.5", "-2.6")) ==
        "a.3mf: a.model: intact: its checksum or length differs");
  for (const bool wide : {false, true}) {
    const std::string whole = zip({{"_rels/.rels", relationships}, {"a.model", model(triangle, item)}}, wide);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const std::string cut = refusal(whole.substr(0, length));
      CHECK((cut.starts_with("a.3mf") && cut.find('\n') == cut.npos));
    }
  }
}

}  // namespace touchstone::proptests::threemf_tests
