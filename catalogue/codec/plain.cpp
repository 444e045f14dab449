// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/plain.h"

#include <algorithm>

#include "catalogue/codec/excerpt.h"

namespace touchstone::catalogue {
namespace {

/// True if brackets are nested more than `depth` deep.
bool nested_deeper(const Json& value, int depth) {
  return value.is_structured() && (depth == 0 || std::any_of(value.begin(), value.end(), [depth](const Json& part) {
                                     return nested_deeper(part, depth - 1);
                                   }));
}

/// Appends one_line(plain(answer)), without copying an answer that may be long.
void append_plain(const Json& answer, std::string& text) {
  if (!answer.is_structured()) {
    text += one_line(plain(answer));
    return;
  }
  text += answer.is_array() ? '[' : '{';
  bool first = true;
  for (auto part = answer.begin(); part != answer.end(); ++part, first = false) {
    if (!first) text += ',';
    if (answer.is_object()) text += one_line(part.key()) + ':';
    append_plain(*part, text);
  }
  text += answer.is_array() ? ']' : '}';
}

}  // namespace

Json plain(const Json& answer) {
  if (is_typed_number(answer)) {
    try {
      return written(read_answer_number(answer, "answer"));
    } catch (const InvalidInput&) {
      return typed_text(answer);  // text in the place of a number
    }
  }
  if (!answer.is_structured()) return answer;
  Json result = answer.is_array() ? Json::array() : Json::object();
  for (auto part = answer.begin(); part != answer.end(); ++part) {
    if (answer.is_array()) result.push_back(plain(*part));
    else result[part.key()] = plain(*part);
  }
  return result;
}

Json kept(const Json& answer) {
  constexpr std::size_t most = 4096;
  constexpr int most_nested = 32;  // a file that holds it is parsed again, nested at most 64 deep
  std::string text;
  append_plain(answer, text);
  return text.size() > most || nested_deeper(answer, most_nested) ? Json(excerpt(text, most)) : plain(answer);
}

}  // namespace touchstone::catalogue
