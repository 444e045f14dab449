// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cstdint>
#include <map>

#include "audit/meshes/bytes.h"
#include "audit/meshes/reading.h"

namespace touchstone::audit::meshes {
namespace {

constexpr std::size_t header = 84, triangle = 50;

/// One vertex for all corners with equal coordinates; zeros are equal whatever their sign.
class Merged {
 public:
  Index add(const Point3d& p) {
    const auto key = [](double x) { return x == 0 ? std::uint64_t{0} : std::bit_cast<std::uint64_t>(x); };
    const auto [place, fresh] =
        places_.try_emplace({key(p.x), key(p.y), key(p.z)}, static_cast<Index>(mesh.vertices.size()));
    if (fresh) mesh.vertices.push_back(p);
    else ++repeated_;
    return place->second;
  }

  MeshFile done() {
    if (repeated_ > 0)
      mesh.notes.push_back(std::to_string(mesh.vertices.size() + repeated_) + " corners have " +
                           std::to_string(mesh.vertices.size()) +
                           " different positions: those with equal positions are one vertex");
    return std::move(mesh);
  }

  MeshFile mesh;

 private:
  std::size_t repeated_ = 0;
  std::map<std::array<std::uint64_t, 3>, Index> places_;
};

MeshFile read_binary(const std::string& name, std::string_view all) {
  Bytes bytes(name, all, std::endian::little);
  bytes.skip(header - 4);
  const auto count = bytes.number<std::uint32_t>();
  Merged merged;
  merged.mesh.name = name, merged.mesh.format = "STL (binary)";
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes.skip(12);  // the normal
    std::vector<Index> corners;
    for (int k = 0; k < 3; ++k) {
      const double x = bytes.finite<float>(), y = bytes.finite<float>(), z = bytes.finite<float>();
      corners.push_back(merged.add({x, y, z}));
    }
    bytes.skip(2);
    merged.mesh.faces.push_back(std::move(corners));
  }
  if (!bytes.done()) bytes.refuse("nothing behind the last triangle");
  return merged.done();
}

std::string lower(std::string_view word) {
  std::string made(word);
  for (char& c : made) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return made;
}

/// solid NAME, (facet normal N, outer loop, vertex P and so on, endloop, endfacet) again and again, endsolid NAME.
MeshFile read_text(const std::string& name, std::string_view all) {
  Text text(name, all);
  Merged merged;
  MeshFile& mesh = merged.mesh;
  mesh.name = name, mesh.format = "STL (ascii)";
  std::vector<Index> loop;
  std::size_t facet = 0;      // the line on which the last one begins
  std::string open = "file";  // what stands open
  const auto expect_open = [&](const char* wanted) {
    if (open != wanted) text.refuse("in the order solid, facet, outer loop, vertex, endloop, endfacet, endsolid");
  };
  while (text.next_words('\0')) {
    const std::string keyword = lower(text.words()[0]);
    if (keyword == "solid") expect_open("file"), open = "solid";
    else if (keyword == "facet") expect_open("solid"), open = "facet", facet = text.number();
    else if (keyword == "outer") expect_open("facet"), open = "loop", loop.clear();
    else if (keyword == "vertex") {
      expect_open("loop"), loop.push_back(merged.add(text.position(1)));
      if (mesh.vertex_lines.size() < mesh.vertices.size()) mesh.vertex_lines.push_back(text.number());
    } else if (keyword == "endloop") {
      expect_open("loop"), open = "looped";
      if (loop.size() < 3) text.refuse("at least 3 corners");
      mesh.faces.push_back(std::move(loop)), mesh.face_lines.push_back(facet);
    } else if (keyword == "endfacet") expect_open("looped"), open = "solid";
    else if (keyword == "endsolid") expect_open("solid"), open = "file";
    else text.refuse("solid, facet, outer loop, vertex, endloop, endfacet or endsolid");
  }
  if (open != "file") text.refuse("endsolid: the file ends too early");
  return merged.done();
}

}  // namespace

/// Binary files may begin with "solid" as well: their length tells.
MeshFile read_stl(const std::string& name, std::string_view bytes) {
  if (bytes.size() >= header) {
    Bytes count(name, bytes, std::endian::little);
    count.skip(header - 4);
    if (bytes.size() == header + std::uint64_t{triangle} * count.number<std::uint32_t>())
      return read_binary(name, bytes);
  }
  const std::string_view text = without_mark(bytes);
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return lower(text.substr(start, 5)) == "solid" ? read_text(name, bytes) : read_binary(name, bytes);
}

}  // namespace touchstone::audit::meshes
