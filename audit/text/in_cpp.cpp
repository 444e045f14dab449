// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "audit/engines/signature.h"
#include "audit/text/regression_test.h"

namespace touchstone::audit {
namespace {

std::string spelled_number(double number) {
  if (std::isinf(number)) return std::string(number < 0 ? "-" : "") + "std::numeric_limits<double>::infinity()";
  const std::string text = decimal(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// A value as a C++ expression under `using namespace touchstone`.
std::string spelled_in_cpp(const Shape& shape, Cursor<double>& at) {
  std::string parts;
  const auto add = [&](const Shape& part) { parts += (parts.empty() ? "" : ", ") + spelled_in_cpp(part, at); };
  switch (shape.kind) {
    case Shape::Kind::number: return spelled_number(*at.number++);
    case Shape::Kind::flag: return *at.word++ != 0 ? "true" : "false";
    case Shape::Kind::index: return std::to_string(*at.word++);
    case Shape::Kind::word: return shape.name + "::" + shape.words[*at.word++];
    case Shape::Kind::optional: return *at.word++ != 0 ? spelled_in_cpp(*shape.parts[0].shape, at) : "std::nullopt";
    case Shape::Kind::choice: return spelled_in_cpp(*shape.parts[*at.word++].shape, at);
    case Shape::Kind::list:
      for (Word left = *at.word++; left > 0; --left) add(*shape.parts[0].shape);
      break;
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) add(*part.shape);
  }
  return shape.name.empty() && shape.kind == Shape::Kind::record ? parts : type_text(shape) + "{" + parts + "}";
}

}  // namespace

InCpp in_cpp(const Operation& operation, const Question& question, const EncodedValue<double>& answer) {
  const Shape& asked = operation.question_shape();
  Cursor<double> of_question(question), of_answer(answer);
  InCpp result;
  result.declaration = audit::signatures(operation)[asked.kind == Shape::Kind::choice ? question.words[0] : 0].text;
  const std::string name = operation.name() + "(";
  result.declaration.insert(result.declaration.find(" " + name) + 1, "my_");
  result.call = "my_" + name + spelled_in_cpp(asked, of_question) + ")";
  result.expected = spelled_in_cpp(operation.answer_shape(), of_answer);
  return result;
}

}  // namespace touchstone::audit
