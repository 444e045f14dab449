// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/plain.h"

#include <algorithm>

#include "catalogue/codec/excerpt.h"

namespace touchstone::catalogue {
namespace {

/// Whether brackets stand in brackets more often than that.
bool nested_deeper(const Json& value, int depth) {
  return value.is_structured() && (depth == 0 || std::any_of(value.begin(), value.end(), [depth](const Json& part) {
                                     return nested_deeper(part, depth - 1);
                                   }));
}

}  // namespace

Json plain(const Json& answer) {
  if (is_typed_number(answer)) {
    try {
      return written(read_answer_number(answer, "answer"));
    } catch (const InvalidInput&) {
      return typed_text(answer);  // what stands where a number may, and is none
    }
  }
  if (!answer.is_structured()) return answer;
  Json result = answer;
  for (Json& part : result) part = plain(part);
  return result;
}

Json kept(const Json& answer) {
  constexpr std::size_t most = 4096;
  constexpr int most_nested = 32;  // a file that holds it is read back, nested at most 64 deep
  Json result = plain(answer);
  const std::string text = one_line(result);
  return text.size() > most || nested_deeper(result, most_nested) ? Json(excerpt(text, most)) : result;
}

}  // namespace touchstone::catalogue
