// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/shape_json.h"

#include <algorithm>
#include <array>
#include <optional>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/expected.h"
#include "catalogue/codec/meanings.h"
#include "catalogue/codec/mesh_json.h"
#include "catalogue/numbers/true_number.h"

namespace touchstone::catalogue {
namespace {

template <class Real>
void leave_out(const Shape& shape, EncodedValue<Real>& encoded) {
  if (shape.kind != Shape::Kind::record) return encoded.words.push_back(0);
  for (const Shape::Part& part : shape.parts) leave_out(*part.shape, encoded);
}

void read_word(const Shape& shape, const Json& json, const std::string& path, std::vector<Word>& words) {
  std::string rule;
  for (std::size_t i = 0; i < shape.words.size(); ++i) {
    if (json.is_string() && json.get_ref<const std::string&>() == shape.words[i]) {
      words.push_back(static_cast<Word>(i));
      return;
    }
    rule += (i == 0 ? "one of " : ", ") + std::string(shape.words[i]);
  }
  const std::string nearest =
      json.is_string() && !is_typed_number(json) ? did_you_mean(json.get_ref<const std::string&>(), shape.words) : "";
  throw InvalidInput(path, expected(rule, json) + nearest);
}

/// The fields of an object in JSON.
std::vector<const char*> fields_of(const Shape& shape) {
  std::vector<const char*> names;
  for (const Shape::Part& part : shape.parts) names.push_back(part.name);
  if (shape.form == Form::mesh) names.back() = "cut";
  return names;
}

void require_known(const Shape& shape, const Json& json, const std::string& path) {
  if (!json.is_object()) throw InvalidInput(path, expected("an object like " + one_line(example_of(shape)), json));
  const std::vector<const char*> names = fields_of(shape);
  for (const auto& [key, value] : json.items()) {
    const bool known = std::any_of(names.begin(), names.end(), [&key = key](const char* name) { return key == name; });
    if (!known) throw InvalidInput(unknown_path(path, key), no_such_field(key, names));
  }
}

template <class Real>
void read_mesh(const Shape& shape, const Json& json, const std::string& path, EncodedValue<Real>& encoded,
               ReadNumber<Real> read) {
  for (const char* name : {"vertices", "faces"}) {
    if (!json.contains(name)) throw InvalidInput(member_path(path, name), "missing");
  }
  const std::size_t first = encoded.numbers.size();
  read_json(*shape.parts[0].shape, json["vertices"], member_path(path, "vertices"), encoded, read, false);
  read_faces(json, path, encoded.numbers.data() + first, (encoded.numbers.size() - first) / 3, encoded.words);
}

template <class Real>
void read_record(const Shape& shape, const Json& json, const std::string& path, EncodedValue<Real>& encoded,
                 ReadNumber<Real> read, bool partial) {
  if (shape.form == Form::bare) return read_json(*shape.parts[0].shape, json, path, encoded, read, partial);
  if (shape.form == Form::list) {
    require_array(json, path, shape.parts.size());
    for (std::size_t i = 0; i < shape.parts.size(); ++i)
      read_json(*shape.parts[i].shape, json[i], element(path, i), encoded, read, partial);
    return;
  }
  require_known(shape, json, path);
  if (shape.form == Form::mesh) return read_mesh(shape, json, path, encoded, read);
  for (const Shape::Part& part : shape.parts) {
    if (json.contains(part.name)) {
      read_json(*part.shape, json[part.name], member_path(path, part.name), encoded, read, partial);
    } else if (can_be_left_out(*part.shape, partial)) {
      leave_out(*part.shape, encoded);
    } else {
      throw InvalidInput(member_path(path, part.name), "missing");
    }
  }
}

/// True if a document has a field of an alternative, or if the alternative is not a record of fields.
bool has_a_field_of(const Shape& alternative, const Json& json) {
  if (alternative.kind != Shape::Kind::record || alternative.form != Form::record || !json.is_object()) return true;
  for (const Shape::Part& part : alternative.parts) {
    if (json.contains(part.name)) return true;
  }
  return false;
}

/// Reads the first alternative that the document fits. If it fits none, throws the complaint of the alternative that
/// was read furthest, among those that have a field of that name. A number that is not finite counts as a number: it is
/// read further than text that is not a number.
template <class Real>
void read_choice(const Shape& shape, const Json& json, const std::string& path, EncodedValue<Real>& encoded,
                 ReadNumber<Real> read, bool partial) {
  std::optional<InvalidInput> complaint;
  std::size_t furthest = 0;
  bool named = false;
  for (const Shape::Part& part : shape.parts) named = named || has_a_field_of(*part.shape, json);
  if (!named && json.is_object() && !json.empty()) {
    std::vector<const char*> names;
    for (const Shape::Part& part : shape.parts) {
      for (const Shape::Part& field : part.shape->parts) names.push_back(field.name);
    }
    const std::string& key = json.items().begin().key();
    throw InvalidInput(unknown_path(path, key), no_such_field(key, names));
  }
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    if (named && !has_a_field_of(*shape.parts[i].shape, json)) continue;
    EncodedValue<Real> tried;
    tried.words.push_back(static_cast<Word>(i));
    try {
      read_json(*shape.parts[i].shape, json, path, tried, read, partial);
      encoded.numbers.insert(encoded.numbers.end(), tried.numbers.begin(), tried.numbers.end());
      encoded.words.insert(encoded.words.end(), tried.words.begin(), tried.words.end());
      return;
    } catch (const InvalidInput& refused) {
      const std::size_t reached = 2 * tried.numbers.size() + (refused.rule() == "finite number" ? 2 : 1);
      if (reached > furthest) complaint.emplace(refused), furthest = reached;
    }
  }
  if (named || path.empty()) throw InvalidInput(*complaint);
  std::string first_fields;
  for (const Shape::Part& part : shape.parts)
    first_fields += (first_fields.empty() ? "" : ", ") + std::string(part.shape->parts[0].name);
  throw InvalidInput(path, expected("an object with one of " + first_fields, json));
}

}  // namespace

bool can_be_left_out(const Shape& shape, bool partial) {
  switch (shape.kind) {
    case Shape::Kind::optional: return true;
    case Shape::Kind::number: return partial;
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) {
        if (!can_be_left_out(*part.shape, partial)) return false;
      }
      return true;
    default: return false;
  }
}

template <class Real>
Json json_of(const Shape& shape, Cursor<Real>& at, WriteNumber<Real> write) {
  switch (shape.kind) {
    case Shape::Kind::number: return write(*at.number++);
    case Shape::Kind::word: return shape.words[*at.word++];
    case Shape::Kind::flag: return *at.word++ != 0;
    case Shape::Kind::index: return *at.word++;
    case Shape::Kind::choice: {
      const Word which = *at.word++;
      return json_of(*shape.parts[which].shape, at, write);
    }
    case Shape::Kind::optional: return *at.word++ != 0 ? json_of(*shape.parts[0].shape, at, write) : Json(nullptr);
    case Shape::Kind::list: {
      Json list = Json::array();
      for (Word left = *at.word++; left > 0; --left) list.push_back(json_of(*shape.parts[0].shape, at, write));
      return list;
    }
    case Shape::Kind::record: break;
  }
  if (shape.form == Form::bare) return json_of(*shape.parts[0].shape, at, write);
  Json record = shape.form == Form::list ? Json::array() : Json::object();
  for (const Shape::Part& part : shape.parts) {
    const bool left_out = part.shape->kind == Shape::Kind::optional && *at.word == 0;
    Json value = json_of(*part.shape, at, write);
    if (left_out) continue;
    if (shape.form == Form::list) record.push_back(std::move(value));
    else record[part.name] = std::move(value);
  }
  return shape.form == Form::mesh ? with_polygons_as_faces(std::move(record)) : record;
}

template <class Real>
void read_json(const Shape& shape, const Json& json, const std::string& path, EncodedValue<Real>& encoded,
               ReadNumber<Real> read, bool partial) {
  switch (shape.kind) {
    case Shape::Kind::number:
      if (partial) encoded.words.push_back(1);
      encoded.numbers.push_back(read(json, path));
      return;
    case Shape::Kind::word: return read_word(shape, json, path, encoded.words);
    case Shape::Kind::flag: encoded.words.push_back(read_flag(json, path)); return;
    case Shape::Kind::index: encoded.words.push_back(read_index(json, path)); return;
    case Shape::Kind::optional:
      encoded.words.push_back(1);
      return read_json(*shape.parts[0].shape, json, path, encoded, read, partial);
    case Shape::Kind::list:
      if (!json.is_array()) throw InvalidInput(path, expected("an array", json));
      encoded.words.push_back(static_cast<Word>(json.size()));
      for (std::size_t i = 0; i < json.size(); ++i)
        read_json(*shape.parts[0].shape, json[i], element(path, i), encoded, read, partial);
      return;
    case Shape::Kind::choice: return read_choice(shape, json, path, encoded, read, partial);
    case Shape::Kind::record: return read_record(shape, json, path, encoded, read, partial);
  }
}

namespace {

/// The text that stands for a number: "number", or its meaning.
using NameNumber = const char* (*)(Meaning);

Json described(const Shape& shape, NameNumber name) {
  switch (shape.kind) {
    case Shape::Kind::number: return name(shape.meaning);
    case Shape::Kind::flag: return "true | false";
    case Shape::Kind::index: return "index";
    case Shape::Kind::optional: return described(*shape.parts[0].shape, name);
    case Shape::Kind::list: return Json::array({described(*shape.parts[0].shape, name), "..."});
    case Shape::Kind::word: {
      std::string words;
      for (const char* word : shape.words) words += (words.empty() ? "" : " | ") + std::string(word);
      return words;
    }
    case Shape::Kind::choice: {
      Json alternatives = Json::object();
      for (const Shape::Part& part : shape.parts) alternatives["one of"].push_back(described(*part.shape, name));
      return alternatives;
    }
    case Shape::Kind::record: break;
  }
  if (shape.form == Form::bare) return described(*shape.parts[0].shape, name);
  Json record = shape.form == Form::list ? Json::array() : Json::object();
  for (const Shape::Part& part : shape.parts) {
    if (shape.form == Form::list) record.push_back(described(*part.shape, name));
    else
      record[std::string(part.name) + (part.shape->kind == Shape::Kind::optional ? "?" : "")] =
          described(*part.shape, name);
  }
  if (shape.form == Form::mesh) {
    record["faces"] = std::move(record["polygons"]);
    record["cut?"] = described(*shape.parts[1].shape, name);
    record.erase("polygons");
  }
  return record;
}

}  // namespace

Json json_of(const Shape& shape) {
  return described(shape, [](Meaning) { return "number"; });
}

Json meanings_of(const Shape& shape) {
  return described(shape, [](Meaning meaning) {
    constexpr std::array<const char*, 4> names{"number", "place", "direction", "length"};
    return names[static_cast<std::size_t>(meaning)];
  });
}

template Json json_of(const Shape&, Cursor<double>&, WriteNumber<double>);
template Json json_of(const Shape&, Cursor<mpq_class>&, WriteNumber<mpq_class>);
template Json json_of(const Shape&, Cursor<TrueNumber>&, WriteNumber<TrueNumber>);
template void read_json(const Shape&, const Json&, const std::string&, EncodedValue<double>&, ReadNumber<double>, bool);
template void read_json(const Shape&, const Json&, const std::string&, EncodedValue<mpq_class>&, ReadNumber<mpq_class>,
                        bool);

}  // namespace touchstone::catalogue
