// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "audit/counted.h"
#include "audit/meshes/formats/bytes.h"
#include "audit/meshes/formats/ply_header.h"

namespace touchstone::audit::meshes {
namespace {

using ply::Element, ply::Property, ply::Type;

/// The values after the header, one after another, in either form.
class Values {
 public:
  virtual ~Values() = default;
  virtual double number(Type type) = 0;
  virtual long long whole(Type type) = 0;
  virtual void skip(Type type) = 0;
  /// Moves to the next row of an element; returns the line on which it begins, if there are lines.
  virtual std::optional<std::size_t> begin_row() = 0;
  /// True if the file ends here.
  virtual bool done() = 0;
  /// The skipped data that is not a property of an element.
  virtual std::string passed_over() const = 0;
  [[noreturn]] virtual void refuse(const std::string& rule) = 0;
};

/// A row begins on a new line, and may continue on further lines.
class TextValues : public Values {
 public:
  explicit TextValues(Text& text) : text_(text) {}
  double number(Type) override { return text_.number(text_.word()); }
  long long whole(Type) override { return text_.whole(text_.word()); }
  void skip(Type) override { text_.word(); }
  std::optional<std::size_t> begin_row() override {
    end_row();
    if (!text_.next_words('\0')) text_.refuse("the file ends before the declared number of values");
    in_row_ = true;
    return text_.number();
  }
  bool done() override {
    end_row();
    return !text_.next_words('\0');
  }
  std::string passed_over() const override {
    if (longer_ == 0) return "";
    return counted(longer_, "row") + " longer than the header says, the first on line " +
           std::to_string(first_longer_) + ": the rest of each is passed over";
  }
  [[noreturn]] void refuse(const std::string& rule) override { text_.refuse(rule); }

 private:
  void end_row() {
    if (in_row_ && text_.words_left() > 0 && longer_++ == 0) first_longer_ = text_.number();
    in_row_ = false;
  }

  Text& text_;
  bool in_row_ = false;
  std::size_t longer_ = 0, first_longer_ = 0;
};

class BinaryValues : public Values {
 public:
  explicit BinaryValues(Bytes bytes) : bytes_(std::move(bytes)) {}
  double number(Type type) override {
    if (type == Type::float32) return bytes_.finite<float>();
    if (type == Type::float64) return bytes_.finite<double>();
    return static_cast<double>(whole(type));
  }
  long long whole(Type type) override {
    switch (type) {
      case Type::int8: return bytes_.number<std::int8_t>();
      case Type::uint8: return bytes_.number<std::uint8_t>();
      case Type::int16: return bytes_.number<std::int16_t>();
      case Type::uint16: return bytes_.number<std::uint16_t>();
      case Type::int32: return bytes_.number<std::int32_t>();
      case Type::uint32: return bytes_.number<std::uint32_t>();
      case Type::int64: return bytes_.number<std::int64_t>();
      default: break;
    }
    const auto value = bytes_.number<std::uint64_t>();
    if (value > std::uint64_t{std::numeric_limits<long long>::max()}) refuse("an integer of less than 64 bits");
    return static_cast<long long>(value);
  }
  void skip(Type type) override {
    constexpr std::array<std::size_t, 10> sizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    bytes_.skip(sizes[static_cast<std::size_t>(type)]);
  }
  std::optional<std::size_t> begin_row() override { return std::nullopt; }
  bool done() override { return bytes_.blank(); }
  std::string passed_over() const override { return ""; }
  [[noreturn]] void refuse(const std::string& rule) override { bytes_.refuse(rule); }

 private:
  Bytes bytes_;
};

/// The index of the property of that name, a list or not.
std::size_t place_of(const Text& text, const Element& element, std::initializer_list<const char*> names, bool list) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const Property& property = element.properties[i];
    for (const char* name : names) {
      if (property.name != name || property.count.has_value() != list) continue;
      if (list && !ply::integral(property.type)) text.refuse(element.line, "an integer type for indices");
      return i;
    }
  }
  text.refuse(element.line, list ? "a list vertex_indices" : std::string("a property ") + *names.begin());
}

long long count_of(Values& values, Type type) {
  const long long count = values.whole(type);
  if (count < 0) values.refuse("count >= 0");
  return count;
}

void skip(Values& values, const Property& property) {
  const long long count = property.count ? count_of(values, *property.count) : 1;
  for (long long k = 0; k < count; ++k) values.skip(property.type);
}

void read_vertices(const Text& text, Values& values, const Element& element, MeshFile& mesh) {
  const std::array<std::size_t, 3> places{place_of(text, element, {"x"}, false), place_of(text, element, {"y"}, false),
                                          place_of(text, element, {"z"}, false)};
  for (long long row = 0; row < element.count; ++row) {
    if (const auto line = values.begin_row()) mesh.vertex_lines.push_back(*line);
    std::array<double, 3> position{};
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const auto axis = std::find(places.begin(), places.end(), i);
      if (axis == places.end()) skip(values, element.properties[i]);
      else position[static_cast<std::size_t>(axis - places.begin())] = values.number(element.properties[i].type);
    }
    mesh.vertices.push_back({position[0], position[1], position[2]});
  }
}

/// Reads the list of indices in each row, and where the row begins. Other properties are skipped.
template <class TakeIndices>
void each_list(const Text& text, Values& values, const Element& element, TakeIndices take) {
  const std::size_t place = place_of(text, element, {"vertex_indices", "vertex_index"}, true);
  for (long long row = 0; row < element.count; ++row) {
    const auto line = values.begin_row();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (i != place) skip(values, property);
      else take(count_of(values, *property.count), property.type, line);
    }
  }
}

Index index_of(Values& values, long long index, const MeshFile& mesh) {
  if (index < 0 || index >= static_cast<long long>(mesh.vertices.size()))
    values.refuse(index_of_a_vertex(index, mesh.vertices.size()));
  return static_cast<Index>(index);
}

void read_faces(const Text& text, Values& values, const Element& element, MeshFile& mesh) {
  each_list(text, values, element, [&](long long count, Type type, std::optional<std::size_t> line) {
    if (count < 3) values.refuse("at least 3 corners");
    std::vector<Index> corners;
    for (long long k = 0; k < count; ++k) corners.push_back(index_of(values, values.whole(type), mesh));
    mesh.faces.push_back(std::move(corners));
    if (line) mesh.face_lines.push_back(*line);
  });
}

/// Each row holds strips of triangles, one after another, separated by -1.
void read_strips(const Text& text, Values& values, const Element& element, MeshFile& mesh) {
  std::size_t left_out = 0;
  each_list(text, values, element, [&](long long count, Type type, std::optional<std::size_t> line) {
    std::vector<Index> strip;
    for (long long k = 0; k < count; ++k) {
      const long long index = values.whole(type);
      if (index != -1) strip.push_back(index_of(values, index, mesh));
      if (index != -1 && k + 1 < count) continue;
      left_out += append_strip(strip, mesh.faces);
      strip.clear();
    }
    if (line) mesh.face_lines.resize(mesh.faces.size(), *line);
  });
  mesh.notes.push_back(strips_as_faces(left_out));
}

MeshFile read_body(const Text& text, const ply::Header& header, Values& values) {
  MeshFile mesh;
  mesh.name = text.name(), mesh.format = "PLY (" + std::string(spelled(header.format)) + ")";
  bool vertices = false;
  for (const Element& element : header.elements) {
    // Every row takes at least a byte or a word, so that no count exceeds the file.
    if (element.count > 0 && element.properties.empty()) text.refuse(element.line, "an element with properties");
    if (element.name == "vertex") {
      if (vertices) text.refuse(element.line, "element vertex once");
      vertices = true, read_vertices(text, values, element, mesh);
    } else if (element.name == "face" || element.name == "tristrips") {
      if (!vertices) text.refuse(element.line, "element vertex before element " + element.name);
      (element.name == "face" ? read_faces : read_strips)(text, values, element, mesh);
    } else {
      if (element.count > 0) mesh.passed_over[element.name] += static_cast<std::size_t>(element.count);
      for (long long row = 0; row < element.count; ++row) {
        values.begin_row();
        for (const Property& property : element.properties) skip(values, property);
      }
    }
  }
  if (!vertices) text.refuse("element vertex");
  if (!values.done()) values.refuse("nothing behind the last element");
  if (const std::string over = values.passed_over(); !over.empty()) mesh.notes.push_back(over);
  const std::size_t edges = mesh.passed_over.contains("edge") ? mesh.passed_over["edge"] : 0;
  return with_faces(std::move(mesh), edges);
}

}  // namespace

bool is_ply(std::string_view bytes) {
  Text text("", bytes);
  return text.next() && text.line() == "ply";
}

MeshFile read_ply(const std::string& name, std::string_view bytes) {
  Text text(name, bytes);
  const ply::Header header = ply::read_header(text);
  if (header.format == ply::Format::ascii) {
    TextValues values(text);
    return read_body(text, header, values);
  }
  const std::endian order = header.format == ply::Format::little ? std::endian::little : std::endian::big;
  BinaryValues values(Bytes(name, bytes, order, bytes.size() - text.rest().size()));
  return read_body(text, header, values);
}

}  // namespace touchstone::audit::meshes
