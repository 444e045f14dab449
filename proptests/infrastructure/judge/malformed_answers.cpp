// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "proptests/each_operation.h"
#include "proptests/uses.h"

/// What is no answer to an operation, of every operation: the verdict is `invalid`, and the remark names the place.
namespace touchstone::proptests::malformed_answers_tests {
namespace {

/// Values as an engine may send them, none of which is one of our enumerators.
std::vector<Json> junk() {
  std::string deep = "0";
  for (int i = 0; i < 50; ++i) deep = "[" + deep + "]";
  std::vector<Json> values;
  for (const std::string text :
       {R"(null)", R"(true)", R"(0.5)", R"(-1)", R"(1e999)", R"(0x1)", R"("")", R"("no_such_word")", R"("0x")",
        R"("\u0001")", R"([])", R"([[]])", R"([null])", R"([0,0,0,0,0,0,0])", R"([{"a":[true]}])", R"({})",
        R"({"":null})", R"({"no_field":{"no_field":[0]}})"}) {
    values.push_back(parse_line(text));
  }
  values.push_back(parse_line(deep));
  return values;
}

bool is_number(const Json& value) {
  if (!value.is_string()) return false;
  const std::string text = is_typed_number(value) ? typed_text(value) : value.get<std::string>();
  if (is_typed_number(value)) return text != "0x1";
  return text == "inf" || text == "-inf" || text == "nan";
}

/// Whether a value may be left out: what is optional, a number, and what is made of such.
bool may_be_missing(const Json& description) {
  if (description.is_string()) return description == "number";
  if (description.is_array() && description.back() == "...") return false;
  if (description.contains("one of")) return false;
  return std::all_of(description.items().begin(), description.items().end(),
                     [](const auto& part) { return part.key().ends_with('?') || may_be_missing(part.value()); });
}

/// Whether a value is of the form that `touchstone ops --json` promises: "number", "left | right", ["number", "..."].
bool fits(const Json& description, const Json& value, bool partial) {
  if (description == "number") return is_number(value);
  if (description == "index")
    return is_typed_number(value) && typed_text(value).find_first_of("-.x") == std::string::npos &&
           typed_text(value) != "1e999";
  if (description == "true | false") return value.is_boolean();
  if (description.is_string())
    return value.is_string() && !is_typed_number(value) && value != "" && value != "no_such_word" && value != "0x" &&
           value != "\x01" &&
           (" " + description.get<std::string>() + " ").find(" " + value.get<std::string>() + " ") != std::string::npos;
  if (description.is_array()) {
    const bool list = description.back() == "...";
    if (!value.is_array() || (!list && value.size() != description.size())) return false;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!fits(description[list ? 0 : i], value[i], partial)) return false;
    }
    return true;
  }
  if (description.contains("one of"))
    return std::any_of(description["one of"].begin(), description["one of"].end(),
                       [&](const Json& one) { return fits(one, value, partial); });
  if (!value.is_object()) return false;
  for (const auto& [key, part] : value.items()) {
    const char* const as_named = description.contains(key) ? "" : "?";
    if (!description.contains(key + as_named) || !fits(description[key + as_named], part, partial)) return false;
  }
  return std::all_of(description.items().begin(), description.items().end(), [&](const auto& part) {
    return part.key().ends_with('?') || value.contains(part.key()) || (partial && may_be_missing(part.value()));
  });
}

struct Spoilt {
  Json answer;
  std::string place;  ///< what the remark has to begin with
};

/// The answer with the value at each of its places replaced, each field left out, and a field more in each object.
void spoil(const Json& whole, const Json::json_pointer& at, const std::string& place, std::vector<Spoilt>& all) {
  const auto with = [&](const std::string& where, const auto& change) {
    all.push_back({whole, where});
    change(all.back().answer[at]);
  };
  for (const Json& value : junk()) with(place, [&](Json& part) { part = value; });
  const Json& here = whole[at];
  if (here.is_object()) {
    with(place + ".surplus", [](Json& part) { part["surplus"] = 1; });
    for (const auto& [key, part] : here.items()) {
      const std::string name = key;
      with(place + "." + name, [&](Json& object) { object.erase(name); });
      spoil(whole, at / name, place + "." + name, all);
    }
  } else if (here.is_array()) {
    with(place, [](Json& part) { part.push_back(Json::array()); });
    if (!here.empty()) with(place, [](Json& part) { part.erase(part.size() - 1); });
    for (std::size_t i = 0; i < std::min<std::size_t>(here.size(), 2); ++i)
      spoil(whole, at / i, place + "[" + std::to_string(i) + "]", all);
  }
}

}  // namespace

EACH_OPERATION("what is no answer is invalid, with a remark that names the place, wherever it is spoilt") {
  const auto examination = operation.examine(operation.map_centre());
  const Json right = parse_line(one_line(examination->rounded_truth()));
  const Json description = operation.answer_description();
  const bool partial = operation.row().defect == nullptr;
  std::vector<Spoilt> all;
  spoil(right, Json::json_pointer(), "answer", all);
  std::size_t malformed = 0;
  for (const Spoilt& spoilt : all) {
    INFO(one_line(spoilt.answer));
    const Judgement judged = examination->judge_engine(spoilt.answer, Declaration{"by hand"});
    const bool plain = spoilt.answer.is_boolean() && has_plain_reading(operation.answer_shape());
    if (plain || fits(description, spoilt.answer, partial)) continue;
    ++malformed;
    CHECK(judged.verdict == Verdict::invalid);
    // An object that is left without a field may have been meant as any of some.
    const std::string whole = spoilt.place.substr(0, spoilt.place.rfind('.'));
    const bool any_of_some = judged.remark.starts_with(whole + ": expected an object with one of ");
    CHECK((judged.remark.starts_with(spoilt.place) || any_of_some));
  }
  CHECK(malformed > all.size() / 3);
}

}  // namespace touchstone::proptests::malformed_answers_tests
