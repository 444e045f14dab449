// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/plain.h"

#include "catalogue/codec/excerpt.h"

namespace touchstone::catalogue {

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
  Json result = plain(answer);
  const std::string text = one_line(result);
  return text.size() > most ? Json(excerpt(text, most)) : result;
}

}  // namespace touchstone::catalogue
