// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/signature.h"

#include "catalogue/codec/shape_json.h"
#include "catalogue/judge/compare.h"

namespace touchstone::audit {
namespace {

/// The given alternative of a shape that is a choice; otherwise the shape itself.
const Shape& alternative_of(const Shape& shape, std::size_t alternative) {
  return shape.kind == Shape::Kind::choice ? *shape.parts[alternative].shape : shape;
}

/// The shorter answers that an engine may return: "SegmentRelation", if the rest are numbers; "bool".
std::vector<std::string> shorter_answers(const Shape& answer) {
  std::vector<std::string> found;
  for (const Shape::Part& word : answer.parts) {
    bool alone = word.shape->kind == Shape::Kind::word;
    for (const Shape::Part& part : answer.parts)
      alone = alone && (part.shape == word.shape || can_be_left_out(*part.shape, true));
    if (alone) found.push_back(type_text(*word.shape));
  }
  if (has_plain_reading(answer)) found.push_back("bool");
  return found;
}

}  // namespace

std::string arguments_text(const Operation& operation, std::size_t alternative) {
  std::string text;
  for (const Shape::Part& part : alternative_of(operation.question_shape(), alternative).parts)
    text += (text.empty() ? "" : ", ") + type_text(*part.shape) + " " + part.name;
  return "(" + text + ")";
}

std::vector<Signature> signatures(const Operation& operation) {
  const Shape& question = operation.question_shape();
  const bool several = question.kind == Shape::Kind::choice;
  std::vector<Signature> found;
  for (std::size_t i = 0; i < (several ? question.parts.size() : 1); ++i) {
    const Shape& answer = several ? alternative_of(operation.answer_shape(), i) : operation.answer_shape();
    found.push_back(
        {type_text(answer) + " " + operation.name() + arguments_text(operation, i), shorter_answers(answer)});
  }
  return found;
}

}  // namespace touchstone::audit
