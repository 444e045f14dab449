// SPDX-License-Identifier: Apache-2.0
#include "c/made.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include "catalogue/codec/did_you_mean.h"

namespace touchstone::c {

const Operation& operation_named(const char* name) {
  const std::string text = text_of(name, "operation");
  if (const Operation* found = find_operation(text)) return *found;
  std::vector<std::string> known;
  for (const Operation* operation : all_operations()) known.push_back(operation->name());
  throw InvalidInput("operation", "there is none of the name " + text + did_you_mean(text, known));
}

std::string text_of(const char* text, const char* argument) {
  if (text == nullptr) throw InvalidInput(argument, "missing");
  return text;
}

Question question_of(const Operation& operation, const char* text) {
  return operation.parse(parse_line(text_of(text, "question")));
}

Json with_points(const Shape& shape, const Json& printed) {
  EncodedValue<double> encoded;
  read_json<double>(shape, parse_line(one_line(printed)), "", encoded, read_answer_number);
  return json_of<double>(shape, encoded,
                         [](const double& number) { return std::isfinite(number) ? Json(number) : written(number); });
}

Json answer_with_points(const Operation& operation, Json printed) {
  const char* const name = operation.metadata().answer;
  if (name[0] == 0) return with_points(operation.answer_shape(), printed);
  printed[name] = with_points(operation.answer_shape(), printed[name]);
  return printed;
}

char* copied(const std::string& text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace touchstone::c
