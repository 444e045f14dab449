// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/gltf_document.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "audit/meshes/formats/bytes.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes::gltf {
namespace {

constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;

int value_of(std::string_view digits, char c) {
  const std::size_t at = digits.find(c);
  return at == digits.npos ? -1 : static_cast<int>(at);
}

std::string from_base64(const Value& uri, std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = value_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/", c);
    if (digit < 0) uri.refuse("base64");
    bits = bits << 6 | static_cast<std::uint32_t>(digit), count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return bytes;
}

/// The name of a file in the same folder or below, with %20 and similar sequences decoded.
std::string file_of(const Value& uri, std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    const std::string_view digits = "0123456789abcdef";
    const std::string pair = lower(text.substr(i + 1, 2));
    if (pair.size() < 2 || value_of(digits, pair[0]) < 0 || value_of(digits, pair[1]) < 0) uri.refuse("a file's name");
    name += static_cast<char>(value_of(digits, pair[0]) * 16 + value_of(digits, pair[1]));
    i += 2;
  }
  if (name.empty() || name[0] == '/' || name.find("..") != name.npos ||
      name.find_first_of(std::string_view(":\\\0", 3)) != name.npos)
    uri.refuse("data in base64, or a file in the same folder");
  return name;
}

std::string buffer_bytes(const Document& document, const Value& buffer, std::size_t i,
                         const ReadSibling& read_sibling) {
  if (!buffer.has("uri")) {
    if (i > 0 || document.binary.empty()) buffer.refuse("a uri, or the bytes in a .glb file");
    return document.binary;
  }
  const Value uri = buffer["uri"];
  const std::string_view text = uri.text();
  if (!text.starts_with("data:")) return read_sibling(file_of(uri, text));
  const std::size_t comma = text.find(',');
  if (comma == text.npos || !text.substr(0, comma).ends_with(";base64")) uri.refuse("data in base64");
  return from_base64(uri, text.substr(comma + 1));
}

}  // namespace

void Value::refuse(const std::string& rule) const {
  throw InvalidInput(path_.empty() ? *file_ : *file_ + ": " + path_, rule);
}

Value Value::operator[](const char* key) const {
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (!has(key)) throw InvalidInput(*file_ + ": " + path, "missing");
  return {*file_, (*json_)[key], path};
}

Value Value::operator[](std::size_t i) const {
  if (i >= size()) refuse("an entry [" + std::to_string(i) + "]");
  return {*file_, (*json_)[i], path_ + "[" + std::to_string(i) + "]"};
}

std::size_t Value::size() const {
  if (!json_->is_array()) refuse("an array");
  return json_->size();
}

std::size_t Value::integer() const {
  if (!json_->is_number_unsigned() || json_->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    refuse("an integer from 0 to 2^32 - 1");
  return json_->get<std::size_t>();
}

double Value::number() const {
  if (!json_->is_number() || !std::isfinite(json_->get<double>())) refuse("finite number");
  return json_->get<double>();
}

const std::string& Value::text() const {
  if (!json_->is_string()) refuse("a string");
  return json_->get_ref<const std::string&>();
}

Document read_document(const std::string& name, std::string_view bytes, const ReadSibling& read_sibling) {
  Document document;
  document.name = name, document.format = "glTF";
  std::string_view text = without_mark(bytes);
  if (bytes.starts_with("glTF")) {
    Bytes file(name, bytes, std::endian::little);
    document.format = "glTF (binary)";
    file.skip(4);
    if (file.number<std::uint32_t>() != 2) file.refuse("glTF of version 2");
    if (file.number<std::uint32_t>() > bytes.size()) file.refuse("the file ends before the declared number of bytes");
    const auto length = file.number<std::uint32_t>();
    if (file.number<std::uint32_t>() != json_chunk) file.refuse("JSON as the first chunk");
    text = file.take(length);
    if (file.left() >= 8) {
      const auto behind = file.number<std::uint32_t>();
      if (file.number<std::uint32_t>() == binary_chunk) document.binary = file.take(behind);
    }
  }
  try {
    document.json = nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput(name, "JSON as glTF 2.0 has it");
  }
  const Value root = document.root();
  if (!root["asset"]["version"].text().starts_with("2.")) root["asset"]["version"].refuse("glTF of version 2");
  for (std::size_t i = 0; root.has("extensionsRequired") && i < root["extensionsRequired"].size(); ++i) {
    const Value extension = root["extensionsRequired"][i];
    const std::string_view needed = extension.text();
    if (!needed.starts_with("KHR_materials_") && !needed.starts_with("KHR_texture_") &&
        !needed.starts_with("KHR_lights_"))
      extension.refuse("no extension that positions need (compression, quantization); export without it");
  }
  for (std::size_t i = 0; root.has("buffers") && i < root["buffers"].size(); ++i) {
    const Value buffer = root["buffers"][i];
    document.buffers.push_back(buffer_bytes(document, buffer, i, read_sibling));
    if (buffer["byteLength"].integer() > document.buffers.back().size())
      buffer["byteLength"].refuse("no more than the buffer has, " + std::to_string(document.buffers.back().size()));
  }
  return document;
}

Elements elements_of(const Document& document, const Value& accessor, std::size_t size) {
  if (accessor.has("sparse")) accessor["sparse"].refuse("no sparse accessor; export without it");
  const Value view = document.root()["bufferViews"][accessor["bufferView"].integer()];
  const std::size_t buffer = view["buffer"].integer(), begin = view.integer("byteOffset", 0);
  const std::size_t length = view["byteLength"].integer(), stride = view.integer("byteStride", size);
  document.root()["buffers"][buffer];  // refuses a missing buffer
  const std::string_view bytes = document.buffers[buffer];
  if (begin > bytes.size() || length > bytes.size() - begin) view.refuse("inside its buffer");
  const std::size_t offset = accessor.integer("byteOffset", 0), count = accessor["count"].integer();
  if (stride < size) view["byteStride"].refuse("at least " + std::to_string(size));
  if (count > 0 && (offset > length || size > length - offset || count - 1 > (length - offset - size) / stride))
    accessor.refuse("inside its bufferView");
  return {count == 0 ? std::string_view() : bytes.substr(begin + offset, length - offset), count, stride};
}

}  // namespace touchstone::audit::meshes::gltf
