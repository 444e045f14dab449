// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/formats/reading.h"

/// The part of a PLY file before the values.
namespace touchstone::audit::meshes::ply {

enum class Type { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

bool integral(Type type);

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

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
};

/// "ascii", "binary, little-endian" or "binary, big-endian"
const char* spelled(Format format);

/// The header, from "ply" to "end_header".
Header read_header(Text& text);

}  // namespace touchstone::audit::meshes::ply
