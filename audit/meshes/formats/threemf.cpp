// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "audit/meshes/formats/assembly.h"
#include "audit/meshes/formats/reading.h"
#include "audit/meshes/formats/xml.h"
#include "audit/meshes/formats/zip.h"
#include "catalogue/codec/nearest_double.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes {
namespace {

constexpr std::string_view core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";
constexpr const char* path_of_another_part = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";

/// The use of an object: by another one, which then has no mesh, or in the items to be built.
struct Placement {
  std::string object;
  ExactTransform transform;
};

struct Object {
  std::vector<Point3d> vertices;
  std::vector<std::vector<Index>> faces;
  std::vector<Placement> components;
};

/// The part of the archive that holds the model.
class Model {
 public:
  Model(const Zip& zip, const std::string& archive, const std::string& part)
      : xml_(
            archive + ": " + part, [this](const XmlElement& element) { begin(element); },
            [this](const std::string& name) { end(name); }) {
    zip.read(part, [this](std::string_view piece) { xml_.feed(piece); });
    xml_.finish();
  }

  std::map<std::string, Object> objects;
  std::vector<Placement> items;
  std::map<std::string, std::size_t> passed_over;

 private:
  const std::string& attribute(const XmlElement& element, const char* name) const {
    const auto found = element.attributes.find(name);
    if (found == element.attributes.end()) xml_.refuse(std::string("an attribute ") + name);
    return found->second;
  }

  double number(std::string_view text) const {
    const auto value = nearest_double(text);
    if (!value || !std::isfinite(*value)) xml_.refuse("finite number");
    return *value;
  }

  /// Twelve numbers: the factors of x, y, z and 1, three each.
  ExactTransform transform(const XmlElement& element) const {
    const auto found = element.attributes.find("transform");
    ExactTransform made;
    if (found == element.attributes.end()) return made;
    Text text("", found->second);
    text.next();
    if (text.words().size() != 12) xml_.refuse("a transform of 12 numbers");
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) made.rows[i][j] = number(text.words()[3 * j + i]);
    }
    return made;
  }

  Placement placement(const XmlElement& element) const {
    if (element.attributes.contains(path_of_another_part)) xml_.refuse("objects of this part only; export as one part");
    const std::string& object = attribute(element, "objectid");
    if (!objects.contains(object)) xml_.refuse("an object further above");
    return {object, transform(element)};
  }

  Object& open() {
    if (open_ == nullptr) xml_.refuse("inside an object");
    return *open_;
  }

  Index corner(const XmlElement& element, const char* name) {
    const std::string& text = attribute(element, name);
    std::size_t value = 0;
    for (const char c : text) {
      if (c < '0' || c > '9' || value >= open().vertices.size()) xml_.refuse("index of a vertex");
      value = 10 * value + static_cast<std::size_t>(c - '0');
    }
    if (text.empty() || value >= open().vertices.size()) xml_.refuse("index of a vertex");
    return static_cast<Index>(value);
  }

  void begin(const XmlElement& element) {
    if (!element.name.starts_with(core)) {
      ++passed_over[element.name.substr(element.name.find('|') + 1)];
      return;
    }
    const std::string name = element.name.substr(core.size());
    if (name == "vertex") {
      const double x = number(attribute(element, "x")), y = number(attribute(element, "y"));
      open().vertices.push_back({x, y, number(attribute(element, "z"))});
    } else if (name == "triangle") {
      const Index a = corner(element, "v1"), b = corner(element, "v2");
      open().faces.push_back({a, b, corner(element, "v3")});
    } else if (name == "object") {
      id_ = attribute(element, "id");
      if (objects.contains(id_)) xml_.refuse("an id of its own");
      made_ = {}, open_ = &made_;
    } else if (name == "component") {
      open().components.push_back(placement(element));
    } else if (name == "item") {
      items.push_back(placement(element));
    } else if (!structural(name)) {
      ++passed_over[name];
    }
  }

  /// An object is known only after its end, so that none contains itself.
  void end(const std::string& name) {
    if (open_ == nullptr || name != std::string(core) + "object") return;
    objects.emplace(id_, std::move(made_));
    open_ = nullptr;
  }

  static bool structural(std::string_view name) {
    constexpr std::array<std::string_view, 7> all{"model",     "resources",  "mesh", "vertices",
                                                  "triangles", "components", "build"};
    return std::find(all.begin(), all.end(), name) != all.end();
  }

  std::string id_;
  Object made_, *open_ = nullptr;
  XmlReader xml_;
};

/// The part of the archive that contains the model.
std::string part_of_model(const Zip& zip, const std::string& name) {
  std::string part;
  const std::string relationships = "_rels/.rels";
  if (!zip.has(relationships)) throw InvalidInput(name, "3MF: a zip archive with a file " + relationships);
  XmlReader xml(
      name + ": " + relationships,
      [&](const XmlElement& element) {
        const auto type = element.attributes.find("Type"), target = element.attributes.find("Target");
        if (type != element.attributes.end() && target != element.attributes.end() &&
            type->second.ends_with("/3dmodel"))
          part = target->second.substr(target->second.starts_with('/') ? 1 : 0);
      },
      [](const std::string&) {});
  zip.read(relationships, [&](std::string_view piece) { xml.feed(piece); });
  xml.finish();
  if (!zip.has(part)) throw InvalidInput(name, "3MF: a zip archive with a model");
  return part;
}

}  // namespace

bool is_3mf(std::string_view bytes) { return bytes.starts_with("PK\3\4"); }

MeshFile read_3mf(const std::string& name, std::string_view bytes) {
  const Zip zip(name, bytes);
  Model model(zip, name, part_of_model(zip, name));
  std::size_t size = bytes.size();
  for (const auto& [id, object] : model.objects) size += object.vertices.size() + 3 * object.faces.size();
  Assembly assembly(name, "3MF", size);
  std::vector<Placement> waiting(model.items.rbegin(), model.items.rend());
  while (!waiting.empty()) {
    const Placement placed = std::move(waiting.back());
    waiting.pop_back();
    const Object& object = model.objects.at(placed.object);
    const std::string place = "object " + placed.object;
    assembly.require_room(1 + object.components.size() + object.vertices.size() + 3 * object.faces.size());
    const std::size_t first = assembly.add_vertices(object.vertices, placed.transform, place);
    assembly.add_faces(object.faces, first, placed.transform);
    for (auto component = object.components.rbegin(); component != object.components.rend(); ++component) {
      const auto transform = composed(placed.transform, component->transform);
      if (!transform) throw InvalidInput(name + ": " + place, exact_transform_rule);
      waiting.push_back({component->object, *transform});
    }
  }
  assembly.mesh.passed_over = std::move(model.passed_over);
  return with_faces(std::move(assembly.mesh));
}

}  // namespace touchstone::audit::meshes
