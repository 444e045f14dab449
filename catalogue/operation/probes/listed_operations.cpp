// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/listed_operations.h"

#include <array>

#include "catalogue/codec/meanings.h"

namespace touchstone::catalogue {
namespace {

Json json_of(const Time& time) {
  Json json = Json::object();
  json["robust"] = name_of(time.robust);
  json["oracle"] = name_of(time.oracle);
  json["ask"] = name_of(time.ask);
  json["reference"] = name_of(time.reference);
  return json;
}

/// As Operation::question_description, with meanings.
Json meanings_of_question(const Shape& question) {
  Json meanings = meanings_of(question);
  return question.kind == Shape::Kind::choice ? meanings["one of"] : meanings;
}

}  // namespace

const char* name_of(Kind kind) {
  constexpr std::array<const char*, 5> names{"decision", "measure", "set", "checked", "covering"};
  return names[static_cast<std::size_t>(kind)];
}

Json listed_operations() {
  Json list = Json::array();
  for (const Operation* operation : all_operations()) {
    const Metadata& metadata = operation->metadata();
    Json entry = Json::object();
    entry["name"] = metadata.name;
    entry["chapter"] = metadata.chapter;
    entry["pages"] = metadata.pages;
    entry["fields"] = metadata.fields;
    if (!metadata.other_fields.empty()) entry["other_fields"] = metadata.other_fields;
    entry["input"] = operation->question_description();
    entry["meanings"] = meanings_of_question(operation->question_shape());
    if (metadata.is_implementation()) entry["implementation_of"] = metadata.implementation_of;
    entry["words"] = operation->words();
    entry["kind"] = name_of(metadata.kind);
    entry["cost"] = metadata.cost;
    entry["time"] = json_of(metadata.time);
    entry["question"] = metadata.question;
    entry["answer"] = operation->answer_description();
    entry["families"] = operation->families();
    entry["example"] = operation->print(operation->map_centre());
    const auto [first, second] = operation->map_axes();
    entry["axes"] = {first, second};
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace touchstone::catalogue
