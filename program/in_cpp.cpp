// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "audit/engines/signature.h"
#include "catalogue/catalogue.h"
#include "program/regression_test.h"

namespace touchstone::program {
namespace {

std::string spelled_number(double number) {
  if (std::isinf(number)) return std::string(number < 0 ? "-" : "") + "std::numeric_limits<double>::infinity()";
  const std::string text = decimal(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// A value as C++ with `using namespace touchstone` reads it.
template <class T>
std::string spelled_in_cpp(const T& value) {
  if constexpr (Enumeration<T>) {
    return type_text<T>() + "::" + Words<T>::words[static_cast<std::size_t>(value)];
  } else if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (Plain<T>) {
    return std::to_string(value);
  } else if constexpr (is_optional<T>) {
    return value ? spelled_in_cpp(*value) : "std::nullopt";
  } else if constexpr (is_variant<T>) {
    return std::visit([](const auto& alternative) { return spelled_in_cpp(alternative); }, value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return spelled_number(value);
  } else {
    std::string parts;
    const auto add = [&parts](const auto& part) { parts += (parts.empty() ? "" : ", ") + spelled_in_cpp(part); };
    if constexpr (is_vector<T>) {
      for (const auto& element : value) add(element);
    } else {
      for_each_member<T>([&](const auto& member) { add(value.*member.pointer); });
    }
    return type_text<T>() + "{" + parts + "}";
  }
}

template <class Row>
InCpp in_cpp_of_row(const Operation& operation, const Question& encoded, const EncodedValue<double>& answer) {
  const alternatives_t<typename Row::Question> question = unpacked<typename Row::Question>(encoded);
  InCpp result;
  result.declaration = signature_texts<Row>()[question.index()].text;
  const std::string name = operation.name() + "(";
  result.declaration.insert(result.declaration.find(" " + name) + 1, "my_");
  result.call = "my_" + name;
  std::visit(
      [&](const auto& alternative) {
        std::apply(
            [&](const auto&... value) {
              std::size_t at = 0;
              ((result.call += (at++ == 0 ? "" : ", ") + spelled_in_cpp(value)), ...);
            },
            alternative);
      },
      question);
  result.call += ")";
  result.expected = spelled_in_cpp(unpacked<answer_t<Row>>(answer));
  return result;
}

}  // namespace

InCpp in_cpp(const Operation& operation, const Question& question, const EncodedValue<double>& answer) {
  InCpp result;
  for_each_row([&]<class Row>() {
    if (operation.name() == Row::metadata().name) result = in_cpp_of_row<Row>(operation, question, answer);
  });
  return result;
}

}  // namespace touchstone::program
