// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/ply_header.h"

#include <array>

namespace touchstone::audit::meshes::ply {
namespace {

Type type_of(const Text& text, std::string_view word) {
  constexpr std::array<std::array<const char*, 2>, 10> names{{{"char", "int8"},
                                                              {"uchar", "uint8"},
                                                              {"short", "int16"},
                                                              {"ushort", "uint16"},
                                                              {"int", "int32"},
                                                              {"uint", "uint32"},
                                                              {"int64", "int64"},
                                                              {"uint64", "uint64"},
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
    if (!integral(count)) text.refuse("an integer type for the counts of a list");
    return {std::string(words[4]), type, count};
  }
  if (words.size() != 3) text.refuse("property TYPE NAME or property list TYPE TYPE NAME");
  return {std::string(words[2]), type_of(text, words[1]), std::nullopt};
}

}  // namespace

bool integral(Type type) { return type != Type::float32 && type != Type::float64; }

const char* spelled(Format format) {
  if (format == Format::ascii) return "ascii";
  return format == Format::little ? "binary, little-endian" : "binary, big-endian";
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

}  // namespace touchstone::audit::meshes::ply
