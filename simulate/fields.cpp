// SPDX-License-Identifier: Apache-2.0
#include "simulate/fields.h"

#include <algorithm>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"

namespace touchstone::simulate {

using catalogue::expected;

Fields::Fields(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
  if (!json.is_object()) throw InvalidInput(path_.empty() ? "scene" : path_, expected("an object", json));
}

bool Fields::has(const char* name) {
  if (std::find(known_.begin(), known_.end(), std::string_view(name)) == known_.end()) known_.push_back(name);
  return json_.contains(name);
}

const Json& Fields::at(const char* name) {
  if (has(name)) return json_[name];
  // A misspelled name is reported for the field that is present, and the intended one is not reported as missing.
  const std::vector<const char*> meant{name};
  for (const auto& [key, value] : json_.items())
    if (!catalogue::did_you_mean(key, meant).empty())
      throw InvalidInput(catalogue::unknown_path(path_, key), catalogue::no_such_field(key, meant));
  throw InvalidInput(path_of(name), "missing");
}

double Fields::number(const char* name) { return catalogue::read_double(at(name), path_of(name)); }
double Fields::number_or(const char* name, double usual) { return has(name) ? number(name) : usual; }

double Fields::positive(const char* name) {
  const double value = number(name);
  if (!(value > 0)) throw InvalidInput(path_of(name), expected("a number greater than 0", at(name)));
  return value;
}

double Fields::not_negative_or(const char* name, double usual) {
  const double value = number_or(name, usual);
  if (!(value >= 0)) throw InvalidInput(path_of(name), expected("a number not below 0", at(name)));
  return value;
}

double Fields::ratio(const char* name) {
  const double value = number(name);
  if (!(value >= 0 && value <= 1)) throw InvalidInput(path_of(name), expected("a number from 0 to 1", at(name)));
  return value;
}

std::uint32_t Fields::count_or(const char* name, std::uint32_t least, std::uint32_t usual) {
  if (!has(name)) return usual;
  const std::uint32_t count = catalogue::read_index(at(name), path_of(name));
  if (count < least)
    throw InvalidInput(path_of(name), expected("an integer from " + std::to_string(least) + " up", at(name)));
  return count;
}

bool Fields::flag_or(const char* name, bool usual) {
  return has(name) ? catalogue::read_flag(at(name), path_of(name)) : usual;
}

std::string Fields::text_or(const char* name, const std::string& usual) {
  if (!has(name)) return usual;
  const Json& value = at(name);
  if (!value.is_string() || catalogue::is_typed_number(value))
    throw InvalidInput(path_of(name), expected("a text", value));
  return value.get<std::string>();
}

Vector3d Fields::vector(const char* name) {
  const std::string path = path_of(name);
  const Json& three = at(name);
  catalogue::require_array(three, path, 3);
  const auto coordinate = [&](int i) { return catalogue::read_double(three[i], path + "[" + std::to_string(i) + "]"); };
  return {coordinate(0), coordinate(1), coordinate(2)};
}
Vector3d Fields::vector_or(const char* name, const Vector3d& usual) { return has(name) ? vector(name) : usual; }

std::size_t Fields::word(const char* name, const std::vector<const char*>& words) {
  const std::string word = text_or(name, "");
  if (!has(name)) at(name);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string all;
  for (const char* one : words) all += (all.empty() ? "" : " | ") + std::string(one);
  throw InvalidInput(path_of(name), expected(all, at(name)) + catalogue::did_you_mean(word, words));
}
std::size_t Fields::word_or(const char* name, const std::vector<const char*>& words, std::size_t usual) {
  return has(name) ? word(name, words) : usual;
}

void Fields::each(const char* name, const std::function<void(const Json&, const std::string&)>& visit) {
  if (!has(name)) return;
  const Json& list = at(name);
  if (!list.is_array()) throw InvalidInput(path_of(name), expected("an array", list));
  for (std::size_t i = 0; i < list.size(); ++i) visit(list[i], path_of(name) + "[" + std::to_string(i) + "]");
}

void Fields::end() const {
  for (const auto& [key, value] : json_.items())
    if (std::find(known_.begin(), known_.end(), key) == known_.end())
      throw InvalidInput(catalogue::unknown_path(path_, key), catalogue::no_such_field(key, known_));
}

}  // namespace touchstone::simulate
