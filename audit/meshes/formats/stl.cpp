// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>

#include "audit/counted.h"
#include "audit/meshes/formats/bytes.h"
#include "audit/meshes/formats/reading.h"

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
      mesh.notes.push_back(counted(mesh.vertices.size() + repeated_, "corner") + " merged into " +
                           vertices(mesh.vertices.size()) + " where positions are equal");
    return std::move(mesh);
  }

  MeshFile mesh;

 private:
  std::size_t repeated_ = 0;
  std::map<std::array<std::uint64_t, 3>, Index> places_;
};

/// Text contains no NUL, and a binary file has one in the number of its triangles or in the first triangle. The
/// beginning of a file does not decide: many binary files begin with "solid".
bool binary(std::string_view bytes) {
  return bytes.size() >= header && bytes.substr(0, header + triangle).find('\0') != bytes.npos;
}

bool begins_with_solid(std::string_view bytes) {
  const std::string_view text = without_mark(bytes);
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return lower(text.substr(start, 5)) == "solid";
}

/// The number of triangles if each is followed by as many bytes as its last two say, and nothing else remains.
std::optional<std::uint64_t> triangles_with_attributes(std::string_view all) {
  std::size_t at = header;
  std::uint64_t count = 0;
  for (; all.size() - at >= triangle; ++count) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(all[at + triangle - 2 + k]); };
    const std::size_t length = triangle + byte(0) + 256u * byte(1);
    if (length > all.size() - at) return std::nullopt;
    at += length;
  }
  return at == all.size() ? std::optional(count) : std::nullopt;
}

struct Layout {
  std::uint32_t counted;    ///< by the header
  std::uint64_t triangles;  ///< the number that the file should hold
  bool attributes;          ///< true if bytes follow each
};

Layout layout_of(std::string_view all) {
  Bytes bytes("", all, std::endian::little, header - 4);
  const auto count = bytes.number<std::uint32_t>();
  const std::uint64_t left = all.size() - header, triangles = count > 0 ? count : left / triangle;
  if (count > 0 && left <= triangle * triangles) return {count, triangles, false};
  const auto found = triangles_with_attributes(all);
  if (!found || (count > 0 && *found != count)) return {count, triangles, false};
  return {count, *found, left != triangle * *found};
}

MeshFile read_binary(const std::string& name, std::string_view all) {
  Bytes bytes(name, all, std::endian::little);
  bytes.skip(header - 4), bytes.skip(4);
  const Layout layout = layout_of(all);
  const std::size_t room = (all.size() - header) / triangle;
  if (!layout.attributes && layout.triangles > room)
    bytes.refuse(grouped(layout.triangles) + " triangles, as the header says: the file holds " + grouped(room) +
                 " and ends too early");
  Merged merged;
  MeshFile& mesh = merged.mesh;
  mesh.name = name, mesh.format = "STL (binary)", mesh.has_vertex_numbers = false;
  bool any_attribute = false;
  for (std::uint64_t i = 0; i < layout.triangles; ++i) {
    bytes.skip(12);  // the normal
    std::vector<Index> corners;
    for (int k = 0; k < 3; ++k) {
      const double x = bytes.finite<float>(), y = bytes.finite<float>(), z = bytes.finite<float>();
      corners.push_back(merged.add({x, y, z}));
    }
    const auto attribute = bytes.number<std::uint16_t>();
    any_attribute = any_attribute || attribute != 0;
    if (layout.attributes) bytes.skip(attribute);
    mesh.faces.push_back(std::move(corners));
  }
  if (layout.counted < layout.triangles)
    mesh.notes.push_back("the header counts no triangles, but the file holds " + std::to_string(layout.triangles));
  if (layout.attributes) mesh.notes.push_back("bytes behind each triangle passed over");
  if (bytes.left() >= triangle)
    bytes.refuse("as many triangles as the header counts, " + grouped(layout.counted) + ": there is room for " +
                 grouped(room));
  if (bytes.left() > 0 && any_attribute && !layout.attributes)
    bytes.refuse("nothing behind the last triangle, or behind each as many bytes as its attribute counts");
  if (bytes.left() > 0) mesh.notes.push_back(counted(bytes.left(), "byte") + " behind the last triangle passed over");
  return merged.done();
}

/// Accepts in one word what is also written in two, and a name directly after it.
std::string keyword_of(const std::vector<std::string_view>& words) {
  const std::string first = lower(words[0]);
  if (first == "end" && words.size() > 1) return first + lower(words[1]);
  for (const char* named : {"endsolid", "solid"}) {
    if (first.starts_with(named)) return named;
  }
  return first.starts_with('#') || first.starts_with(';') || first.starts_with("//") ? "#" : first;
}

/// solid NAME, (facet normal N, outer loop, vertex P and so on, endloop, endfacet) again and again, endsolid NAME.
MeshFile read_text(const std::string& name, std::string_view all) {
  Text text(name, all);
  Merged merged;
  MeshFile& mesh = merged.mesh;
  mesh.name = name, mesh.format = "STL (ascii)", mesh.has_vertex_numbers = false;
  std::vector<Index> loop;
  std::size_t facet = 0;      // the line on which the most recent one begins
  std::string open = "file";  // the innermost open block
  const auto expect_open = [&](const char* wanted) {
    if (open != wanted) text.refuse("in the order solid, facet, outer loop, vertex, endloop, endfacet, endsolid");
  };
  while (text.next_words('\0')) {
    const std::string keyword = keyword_of(text.words());
    if (keyword == "#") ++mesh.passed_over["comments"];
    else if (keyword == "solid") expect_open("file"), open = "solid";
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

bool is_stl(std::string_view bytes) {
  if (!binary(bytes)) return begins_with_solid(bytes);
  const Layout layout = layout_of(bytes);
  const std::uint64_t needed = header + triangle * layout.triangles;
  return layout.triangles > 0 && (layout.attributes || (bytes.size() >= needed && bytes.size() - needed < triangle));
}

MeshFile read_stl(const std::string& name, std::string_view bytes) {
  const bool text = !binary(bytes) && (bytes.size() >= header || begins_with_solid(bytes));
  return with_faces(text ? read_text(name, bytes) : read_binary(name, bytes));
}

}  // namespace touchstone::audit::meshes
