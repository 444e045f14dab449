// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "audit/meshes/formats/reading.h"

/// The two halves of a glTF file: JSON that describes the layout, and buffers of bytes.
namespace touchstone::audit::meshes::gltf {

/// A value in the JSON, which a refusal names as "accessors[3].count".
class Value {
 public:
  Value(const std::string& file, const nlohmann::json& json, std::string path = "")
      : file_(&file), json_(&json), path_(std::move(path)) {}

  bool has(const char* key) const { return json_->is_object() && json_->contains(key); }
  Value operator[](const char* key) const;
  Value operator[](std::size_t i) const;
  /// The number of values in an array.
  std::size_t size() const;
  /// An integer from 0 to 2^32 - 1.
  std::size_t integer() const;
  std::size_t integer(const char* key, std::size_t otherwise) const {
    return has(key) ? (*this)[key].integer() : otherwise;
  }
  double number() const;
  const std::string& text() const;

  const std::string& path() const { return path_; }
  [[noreturn]] void refuse(const std::string& rule) const;

 private:
  const std::string* file_;
  const nlohmann::json* json_;
  std::string path_;
};

struct Document {
  std::string name, format;
  nlohmann::json json;
  std::string binary;  ///< the data after the JSON of a .glb file
  std::vector<std::string> buffers;

  Value root() const { return {name, json}; }
};

/// For either form, with all buffers.
Document read_document(const std::string& name, std::string_view bytes, const ReadSibling& read_sibling);

/// Elements of `size` bytes in a buffer.
struct Elements {
  std::string_view bytes;
  std::size_t count, stride;
};
Elements elements_of(const Document& document, const Value& accessor, std::size_t size);

}  // namespace touchstone::audit::meshes::gltf
