// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/plain.h"

namespace touchstone::audit {

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

}  // namespace touchstone::audit
