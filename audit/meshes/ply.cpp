// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>

#include "audit/meshes/bytes.h"
#include "audit/meshes/reading.h"

namespace touchstone::audit::meshes {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string name;
  long long count;
  std::vector<Property> properties;
  std::size_t line;
};

enum class Format { ascii, little, big };

const char* spelled(Format format) {
  if (format == Format::ascii) return "ascii";
  return format == Format::little ? "binary, little-endian" : "binary, big-endian";
}

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
};

bool whole(Type type) { return type != Type::float32 && type != Type::float64; }

Type type_of(const Text& text, std::string_view word) {
  constexpr std::array<std::array<const char*, 2>, 8> names{{{"char", "int8"},
                                                             {"uchar", "uint8"},
                                                             {"short", "int16"},
                                                             {"ushort", "uint16"},
                                                             {"int", "int32"},
                                                             {"uint", "uint32"},
                                                             {"float", "float32"},
                                                             {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (word == names[i][0] || word == names[i][1]) return static_cast<Type>(i);
  }
  text.refuse("type of a property: char, uchar, short, ushort, int, uint, float, double or as int8");
}

Property property_of(const Text& text) {
  const auto& words = text.words();
  if (words.size() == 5 && words[1] == "list") {
    const Type count = type_of(text, words[2]), type = type_of(text, words[3]);
    if (!whole(count)) text.refuse("whole numbers as the counts of a list");
    return {std::string(words[4]), type, count};
  }
  if (words.size() != 3) text.refuse("property TYPE NAME or property list TYPE TYPE NAME");
  return {std::string(words[2]), type_of(text, words[1]), std::nullopt};
}

Header read_header(Text& text) {
  if (!text.next() || text.line() != "ply") text.refuse("ply in the first line");
  Header header;
  bool formatted = false;
  for (;;) {
    if (!text.next()) text.refuse("end_header: the file ends too early");
    const auto& words = text.words();
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() == 3) {
      formatted = true;
      if (words[1] == "ascii") header.format = Format::ascii;
      else if (words[1] == "binary_little_endian") header.format = Format::little;
      else if (words[1] == "binary_big_endian") header.format = Format::big;
      else text.refuse("format ascii, binary_little_endian or binary_big_endian");
    } else if (words[0] == "element" && words.size() == 3) {
      const long long count = text.whole(words[2]);
      if (count < 0) text.refuse("count >= 0");
      header.elements.push_back({std::string(words[1]), count, {}, text.number()});
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(text));
    } else {
      text.refuse("format, element, property, comment, obj_info or end_header");
    }
  }
  if (!formatted) text.refuse("a line with the format");
  return header;
}

/// The values behind the header, one after another, in either form.
class Values {
 public:
  virtual ~Values() = default;
  virtual double number(Type type) = 0;
  virtual long long whole(Type type) = 0;
  virtual void skip(Type type) = 0;
  /// To the row of an element; the line on which it begins, where there are lines.
  virtual std::optional<std::size_t> begin_row() = 0;
  virtual bool done() = 0;
  [[noreturn]] virtual void refuse(const std::string& rule) = 0;
};

class TextValues : public Values {
 public:
  explicit TextValues(Text& text) : text_(text) {}
  double number(Type) override { return text_.number(text_.word()); }
  long long whole(Type) override { return text_.whole(text_.word()); }
  void skip(Type) override { text_.word(); }
  std::optional<std::size_t> begin_row() override {
    text_.more_words();
    return text_.number();
  }
  bool done() override { return !text_.more_words(); }
  [[noreturn]] void refuse(const std::string& rule) override { text_.refuse(rule); }

 private:
  Text& text_;
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
      default: return bytes_.number<std::uint32_t>();
    }
  }
  void skip(Type type) override {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    bytes_.skip(sizes[static_cast<std::size_t>(type)]);
  }
  std::optional<std::size_t> begin_row() override { return std::nullopt; }
  bool done() override { return bytes_.done(); }
  [[noreturn]] void refuse(const std::string& rule) override { bytes_.refuse(rule); }

 private:
  Bytes bytes_;
};

/// The property of that name, a list or not.
std::size_t place_of(const Text& text, const Element& element, std::initializer_list<const char*> names, bool list) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const Property& property = element.properties[i];
    for (const char* name : names) {
      if (property.name != name || property.count.has_value() != list) continue;
      if (list && !whole(property.type)) text.refuse(element.line, "whole numbers as indices");
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

void read_faces(const Text& text, Values& values, const Element& element, MeshFile& mesh) {
  const std::size_t place = place_of(text, element, {"vertex_indices", "vertex_index"}, true);
  for (long long row = 0; row < element.count; ++row) {
    if (const auto line = values.begin_row()) mesh.face_lines.push_back(*line);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (i != place) {
        skip(values, property);
        continue;
      }
      const long long count = count_of(values, *property.count);
      if (count < 3) values.refuse("at least 3 corners");
      std::vector<Index> corners;
      for (long long k = 0; k < count; ++k) {
        const long long index = values.whole(property.type);
        if (index < 0 || index >= static_cast<long long>(mesh.vertices.size())) values.refuse("index of a vertex");
        corners.push_back(static_cast<Index>(index));
      }
      mesh.faces.push_back(std::move(corners));
    }
  }
}

MeshFile read_body(const Text& text, const Header& header, Values& values) {
  MeshFile mesh;
  mesh.name = text.name(), mesh.format = "PLY (" + std::string(spelled(header.format)) + ")";
  bool vertices = false;
  for (const Element& element : header.elements) {
    // Every row takes a byte or a word at least, so that no count outlasts the file.
    if (element.count > 0 && element.properties.empty()) text.refuse(element.line, "an element with properties");
    if (element.name == "vertex") {
      if (vertices) text.refuse(element.line, "element vertex once");
      vertices = true, read_vertices(text, values, element, mesh);
    } else if (element.name == "face") {
      if (!vertices) text.refuse(element.line, "element vertex before element face");
      read_faces(text, values, element, mesh);
    } else {
      for (long long row = 0; row < element.count; ++row) {
        for (const Property& property : element.properties) skip(values, property);
      }
    }
  }
  if (!vertices) text.refuse("element vertex");
  if (!values.done()) values.refuse("nothing behind the last element");
  return mesh;
}

}  // namespace

MeshFile read_ply(const std::string& name, std::string_view bytes) {
  Text text(name, bytes);
  const Header header = read_header(text);
  if (header.format == Format::ascii) {
    TextValues values(text);
    text.next();
    return read_body(text, header, values);
  }
  const std::endian order = header.format == Format::little ? std::endian::little : std::endian::big;
  BinaryValues values(Bytes(name, bytes, order, bytes.size() - text.rest().size()));
  return read_body(text, header, values);
}

}  // namespace touchstone::audit::meshes
