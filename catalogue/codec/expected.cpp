// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/expected.h"

#include <cstring>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/shape_json.h"

namespace touchstone::catalogue {
namespace {

constexpr std::size_t most_shown = 60;

/// Appends the value with numbers as they were typed. Stops soon after more has been written than is kept.
void append(const Json& value, std::string& text) {
  if (text.size() > most_shown) return;
  if (is_typed_number(value)) {
    text += typed_text(value).substr(0, most_shown);
  } else if (value.is_string()) {
    text += one_line(value.get_ref<const std::string&>().substr(0, 2 * most_shown));
  } else if (!value.is_structured()) {
    text += one_line(value);
  } else {
    text += value.is_array() ? '[' : '{';
    bool first = true;
    for (const auto& [key, part] : value.items()) {
      if (!first) text += ',';
      if (value.is_object()) text += one_line(key.substr(0, most_shown)) + ":";
      append(part, text);
      first = false;
      if (text.size() > most_shown) return;
    }
    text += value.is_array() ? ']' : '}';
  }
}

}  // namespace

std::string expected(const std::string& what, const Json& got) {
  std::string text;
  append(got, text);
  if (text.size() > most_shown) text = excerpt(text.substr(0, most_shown), most_shown) + "...";
  return "expected " + what + ", got " + excerpt(text, 2 * most_shown);
}

std::string no_such_field(const std::string& key, const std::vector<const char*>& names) {
  std::string all;
  for (const char* name : names) all += (all.empty() ? "; expected " : ", ") + std::string(name);
  return "no such field" + did_you_mean(key, names) + all;
}

std::string why_of(int error) {
  std::string reason = std::strerror(error);
  if (!reason.empty() && reason[0] >= 'A' && reason[0] <= 'Z') reason[0] = static_cast<char>(reason[0] - 'A' + 'a');
  return reason;
}

Json example_of(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::number:
    case Shape::Kind::index: return 0;
    case Shape::Kind::flag: return false;
    case Shape::Kind::word: return json_of(shape);
    case Shape::Kind::optional:
    case Shape::Kind::choice: return example_of(*shape.parts[0].shape);
    case Shape::Kind::list: return Json::array({example_of(*shape.parts[0].shape)});
    case Shape::Kind::record: break;
  }
  if (shape.form == Form::bare) return example_of(*shape.parts[0].shape);
  Json record = shape.form == Form::list ? Json::array() : Json::object();
  for (const Shape::Part& part : shape.parts) {
    if (part.shape->kind == Shape::Kind::optional) continue;
    if (shape.form == Form::list) record.push_back(example_of(*part.shape));
    else record[part.name] = example_of(*part.shape);
  }
  if (shape.form == Form::mesh) record.erase("polygons");
  return record;
}

}  // namespace touchstone::catalogue
