// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <map>

#include "audit/counted.h"
#include "audit/meshes/formats/assembly.h"
#include "audit/meshes/formats/bytes.h"
#include "audit/meshes/formats/gltf_document.h"
#include "audit/meshes/formats/reading.h"

namespace touchstone::audit::meshes {
namespace {

using gltf::Document, gltf::Elements, gltf::Value;
using FaceList = std::vector<std::vector<Index>>;

/// Numbers of glTF's types of components and modes of primitives.
constexpr std::size_t uint8 = 5121, uint16 = 5123, uint32 = 5125, float32 = 5126;
constexpr std::size_t points = 0, triangles = 4, strip = 5, fan = 6;

class Scene {
 public:
  Scene(const Document& document, std::size_t bytes)
      : document_(document),
        assembly_(document.name, document.format, bytes),
        seen_(count("nodes")),
        placed_(count("meshes")) {}

  MeshFile read() {
    const Value root = document_.root();
    if (count("scenes") > 0) {
      const Value scene = root["scenes"][root.integer("scene", 0)];
      if (scene.has("nodes")) add_nodes(scene["nodes"], {});
    } else {
      for (std::size_t i = 0; i < placed_.size(); ++i) add_mesh(i, {}, "meshes[" + std::to_string(i) + "]");
    }
    MeshFile& mesh = assembly_.mesh;
    if (const auto unplaced = std::count(placed_.begin(), placed_.end(), false); unplaced > 0)
      mesh.notes.push_back("the scene does not show " + std::to_string(unplaced) + " of " +
                           std::to_string(placed_.size()) + " meshes");
    if (strips_) mesh.notes.push_back(strips_as_faces(left_out_));
    for (const char* other : {"animations", "cameras", "images", "materials", "skins", "textures"}) {
      if (count(other) > 0) mesh.passed_over[other] = count(other);
    }
    const std::size_t lines = mesh.passed_over.contains("line primitives") ? mesh.passed_over["line primitives"] : 0;
    return with_faces(std::move(mesh), lines);
  }

 private:
  std::size_t count(const char* key) const {
    const Value root = document_.root();
    return root.has(key) ? root[key].size() : 0;
  }

  /// Adds nodes and all their descendants, each of which occurs once: glTF has trees.
  void add_nodes(const Value& nodes, const ExactTransform& above) {
    std::vector<std::pair<std::size_t, ExactTransform>> waiting;
    const auto wait = [&](const Value& list, const ExactTransform& transform) {
      for (std::size_t i = list.size(); i-- > 0;) waiting.emplace_back(list[i].integer(), transform);
    };
    wait(nodes, above);
    while (!waiting.empty()) {
      const auto [i, outer] = std::move(waiting.back());
      waiting.pop_back();
      const Value node = document_.root()["nodes"][i];
      if (seen_[i]) node.refuse("a node with at most one parent");
      seen_[i] = true;
      const auto transform = composed(outer, transform_of(node));
      if (!transform) node.refuse(exact_transform_rule);
      if (node.has("mesh")) add_mesh(node["mesh"].integer(), *transform, node.path());
      if (node.has("children")) wait(node["children"], *transform);
    }
  }

  static std::vector<double> numbers(const Value& list, std::size_t size) {
    if (list.size() != size) list.refuse(std::to_string(size) + " numbers");
    std::vector<double> found;
    for (std::size_t i = 0; i < size; ++i) found.push_back(list[i].number());
    return found;
  }

  /// A matrix by columns, or a scale, then a rotation, then a translation.
  static ExactTransform transform_of(const Value& node) {
    ExactTransform made;
    if (node.has("matrix")) {
      const auto m = numbers(node["matrix"], 16);
      if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) node["matrix"].refuse("a last row of 0 0 0 1");
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) made.rows[i][j] = m[4 * j + i];
      }
      return made;
    }
    const auto t = node.has("translation") ? numbers(node["translation"], 3) : std::vector<double>(3, 0);
    const auto s = node.has("scale") ? numbers(node["scale"], 3) : std::vector<double>(3, 1);
    const auto q = node.has("rotation") ? numbers(node["rotation"], 4) : std::vector<double>{0, 0, 0, 1};
    const auto one = std::find_if(q.begin(), q.end(), [](double c) { return c == 1 || c == -1; });
    if (one == q.end() || std::count(q.begin(), q.end(), 0) != 3)
      node["rotation"].refuse(
          "none, or a half turn about an axis: other rotations do not keep positions exact; apply it in the program "
          "that exports");
    const auto axis = static_cast<std::size_t>(one - q.begin());
    for (std::size_t i = 0; i < 3; ++i) {
      made.rows[i][i] = axis == 3 || axis == i ? s[i] : -s[i];
      made.rows[i][3] = t[i];
    }
    return made;
  }

  void add_mesh(std::size_t i, const ExactTransform& transform, const std::string& placed_by) {
    const Value primitives = document_.root()["meshes"][i]["primitives"];
    placed_[i] = true;
    struct Added {
      std::size_t first, count;
    };
    std::map<std::size_t, Added> added;  // by accessor, which primitives may share
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      const Value primitive = primitives[k];
      const std::size_t mode = primitive.integer("mode", triangles);
      if (mode > fan) primitive["mode"].refuse("an integer from 0 to 6");
      const std::size_t accessor = primitive["attributes"]["POSITION"].integer();
      auto vertices = added.find(accessor);
      if (vertices == added.end()) {
        const std::vector<Point3d> positions = positions_of(accessor);
        const std::size_t first = assembly_.add_vertices(positions, transform, placed_by);
        vertices = added.emplace(accessor, Added{first, positions.size()}).first;
      }
      if (mode < triangles) ++assembly_.mesh.passed_over[mode == points ? "point primitives" : "line primitives"];
      else assembly_.add_faces(faces_of(primitive, mode, vertices->second.count), vertices->second.first, transform);
    }
  }

  Bytes element(const Value& accessor, const Elements& elements, std::size_t i) const {
    return {document_.name + ": " + accessor.path(), elements.bytes, std::endian::little, i * elements.stride};
  }

  std::vector<Point3d> positions_of(std::size_t i) {
    const Value accessor = document_.root()["accessors"][i];
    if (accessor["componentType"].integer() != float32 || accessor["type"].text() != "VEC3")
      accessor.refuse("positions of three float32 numbers each");
    const Elements elements = gltf::elements_of(document_, accessor, 12);
    assembly_.require_room(elements.count);
    std::vector<Point3d> positions;
    for (std::size_t k = 0; k < elements.count; ++k) {
      Bytes bytes = element(accessor, elements, k);
      const double x = bytes.finite<float>(), y = bytes.finite<float>(), z = bytes.finite<float>();
      positions.push_back({x, y, z});
    }
    return positions;
  }

  static std::size_t index_at(Bytes bytes, std::size_t type) {
    if (type == uint8) return bytes.number<std::uint8_t>();
    return type == uint16 ? std::size_t{bytes.number<std::uint16_t>()} : bytes.number<std::uint32_t>();
  }

  std::vector<Index> indices_of(const Value& primitive, std::size_t vertices) {
    std::vector<Index> indices;
    if (!primitive.has("indices")) {
      assembly_.require_room(vertices);
      for (std::size_t k = 0; k < vertices; ++k) indices.push_back(static_cast<Index>(k));
      return indices;
    }
    const Value accessor = document_.root()["accessors"][primitive["indices"].integer()];
    const std::size_t type = accessor["componentType"].integer();
    if ((type != uint8 && type != uint16 && type != uint32) || accessor["type"].text() != "SCALAR")
      accessor.refuse("indices of uint8, uint16 or uint32");
    const Elements elements = gltf::elements_of(document_, accessor, type == uint8 ? 1 : type == uint16 ? 2 : 4);
    assembly_.require_room(elements.count);
    for (std::size_t k = 0; k < elements.count; ++k) {
      const std::size_t index = index_at(element(accessor, elements, k), type);
      if (index >= vertices) accessor.refuse("indices of vertices");
      indices.push_back(static_cast<Index>(index));
    }
    return indices;
  }

  FaceList faces_of(const Value& primitive, std::size_t mode, std::size_t vertices) {
    const std::vector<Index> indices = indices_of(primitive, vertices);
    FaceList faces;
    if (mode == strip) {
      strips_ = true;
      left_out_ += append_strip(indices, faces);
      return faces;
    }
    if (mode == triangles && indices.size() % 3 != 0) primitive.refuse("three corners a triangle");
    const std::size_t step = mode == triangles ? 3 : 1;
    for (std::size_t k = 0; k + 2 < indices.size(); k += step)
      faces.push_back({indices[mode == fan ? 0 : k], indices[k + 1], indices[k + 2]});
    return faces;
  }

  const Document& document_;
  Assembly assembly_;
  std::vector<bool> seen_, placed_;
  bool strips_ = false;
  std::size_t left_out_ = 0;
};

}  // namespace

/// For either form: the binary one has a mark of its own, the other is an object of JSON.
bool is_gltf(std::string_view bytes) {
  const std::string_view text = without_mark(bytes);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return bytes.starts_with("glTF") || (start != text.npos && text[start] == '{' && text.find("\"asset\"") != text.npos);
}

MeshFile read_gltf(const std::string& name, std::string_view bytes, const ReadSibling& read_sibling) {
  const Document document = gltf::read_document(name, bytes, read_sibling);
  std::size_t size = bytes.size();
  for (const std::string& buffer : document.buffers) size += buffer.size();
  return Scene(document, size).read();
}

}  // namespace touchstone::audit::meshes
