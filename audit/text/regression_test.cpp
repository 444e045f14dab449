// SPDX-License-Identifier: Apache-2.0
#include "audit/text/regression_test.h"

#include "catalogue/codec/excerpt.h"
#include "catalogue/judge/compare.h"

namespace touchstone::audit {
namespace {

/// The literals that differ from JSON in Python, JavaScript or serde_json.
struct Literals {
  const char *yes, *no, *infinity, *minus_infinity;
  bool rust = false;
};
constexpr Literals python{"True", "False", "float(\"inf\")", "-float(\"inf\")"},
    javascript{"true", "false", "Infinity", "-Infinity"}, rust{"true", "false", "\"inf\"", "\"-inf\"", true};

/// Precedes a number's digits; no enumerator begins with it.
constexpr char number_mark = '#';
/// A number with its point: Python distinguishes integers, and their arithmetic differs.
Json marked(const double& number) {
  const std::string text = decimal(number);
  const bool whole = text.find_first_of(".ein") == std::string::npos;  // not inf, nor nan
  return number_mark + text + (whole ? ".0" : "");
}

std::string literal(const Json& value, const Literals& literals) {
  if (value.is_boolean()) return value.get<bool>() ? literals.yes : literals.no;
  if (value.is_string() && value.get<std::string>().starts_with(number_mark)) {
    const std::string digits = value.get<std::string>().substr(1);
    if (digits == "inf") return literals.infinity;
    return digits == "-inf" ? literals.minus_infinity : digits;
  }
  if (!value.is_structured()) return one_line(value);
  // On a longer list the macro json! recurses beyond the compiler's limit.
  const bool vector = literals.rust && value.is_array() && value.flatten().size() > 24;
  std::string parts;
  for (const auto& [name, part] : value.items()) {
    parts += parts.empty() ? "" : ", ";
    if (value.is_object()) parts += "\"" + name + "\": ";
    const std::string text = literal(part, literals);
    parts += vector ? "json!(" + text + ")" : text;
  }
  if (vector) return "vec![" + parts + "]";
  return value.is_object() ? "{" + parts + "}" : "[" + parts + "]";
}

/// A right answer in doubles, in the form of Examination::rounded_truth.
const EncodedValue<double>& right_answer(const Examination& examination) {
  const auto defect = examination.row().defect;
  const bool nearest = defect == nullptr || defect(examination.question(), examination.nearest_truth()).empty();
  return nearest ? examination.nearest_truth() : examination.robust_answer();
}

std::string boundary_in_words(const Examination& examination) {
  if (examination.touch())
    return "Boundary: the shapes touch, which is contact for closed sets; if yours are open sets, expect the other "
           "answer.";
  return examination.margin() ? "Boundary: closed sets, touching is contact; open sets have the same answer here." : "";
}

std::string comparison_in_words(const Examination& examination) {
  const Kind kind = examination.operation().metadata().kind;
  if (kind == Kind::checked)
    return "Many answers are right, and this is one of them: replace the comparison by the rule of the contract.";
  const bool numbers = !examination.nearest_truth().numbers.empty();
  std::string text =
      numbers ? "Numbers are the doubles nearest to the exact ones; allow yours the error that you promise." : "";
  if (examination.row().as_near != nullptr && numbers)
    text += " Where others are as near, this is the one that the contract names: if yours promises none, compare how "
            "far it is, or how deep, and not where.";
  if (kind == Kind::covering)
    text += "A list that holds more is right too if yours is conservative; so is another order.";
  if (kind == Kind::set) text += std::string(text.empty() ? "" : " ") + "Another order is right too.";
  return text;
}

constexpr std::size_t most_of_a_comment = 1000;

std::string comments(const Examination& examination, const Json& engine, const std::string& mark) {
  const Operation& operation = examination.operation();
  std::string text;
  const auto add = [&](const std::string& line) {
    if (!line.empty()) text += mark + " " + excerpt(line, most_of_a_comment) + "\n";
  };
  add(operation.metadata().question);
  add("Exact: " + one_line(examination.truth()));
  add(boundary_in_words(examination));
  add(comparison_in_words(examination));
  if (!engine.is_null())
    add(engine["name"].get<std::string>() + " answers " + one_line(engine["answer"]) + ": " +
        engine["verdict"].get<std::string>());
  return text;
}

/// The fields of a question as named parameters; combined if its alternatives have different ones.
std::string parameters(const Operation& operation, bool pytest) {
  if (!operation.metadata().other_fields.empty()) return pytest ? "**question" : "...question";
  const Json described = operation.question_description();
  std::string fields;
  for (const auto& [name, shape] : (described.is_array() ? described[0] : described).items()) {
    const bool may_be_left_out = name.ends_with("?");
    fields += (fields.empty() ? "" : ", ") + name.substr(0, name.size() - (may_be_left_out ? 1 : 0));
    if (may_be_left_out && pytest) fields += "=None";
  }
  return fields;
}

constexpr const char* to_be_written = "call your implementation here";

}  // namespace

std::string test_file(const std::string& framework) {
  const char* const ending = framework == "pytest" ? ".py"
                             : framework == "jest" ? ".test.js"
                             : framework == "rust" ? ".rs"
                                                   : ".cpp";
  return "test_" + framework + ending;
}

std::string RegressionTests::next(const Examination& examination, const Json& engine) {
  const Operation& operation = examination.operation();
  const std::string name = operation.name() + "_" + std::to_string(++count_), mine = "my_" + operation.name();
  const auto once = [this](const std::string& text) { return printed_.insert(text).second ? text : std::string(); };
  const bool pytest = framework_ == "pytest";
  if (framework_ == "catch2" || framework_ == "gtest") {
    const bool catch2 = framework_ == "catch2";
    const InCpp cpp = in_cpp(operation, examination.question(), right_answer(examination));
    std::string text =
        once(std::string(catch2 ? "#if __has_include(<catch2/catch_all.hpp>)\n#include <catch2/catch_all.hpp>\n#else\n"
                                  "#include <catch2/catch.hpp>\n#endif\n"
                                : "#include <gtest/gtest.h>\n") +
             "#include <touchstone/catalogue/shape/described_all.h>\n#include "
             "<touchstone/catalogue/shape/encoded_value.h>\n\n#include <limits>\n#include <stdexcept>\n\n"
             "using namespace touchstone;\n");
    text += once("\n" + cpp.declaration + " {\n  throw std::logic_error(\"" + to_be_written + "\");\n}\n");
    text += "\n" + comments(examination, engine, "//");
    text += catch2 ? "TEST_CASE(\"" + name + "\") {\n" : "TEST(touchstone, " + name + ") {\n";
    text += "  const auto answer = " + cpp.call + ";\n  const auto expected = " + cpp.expected + ";\n";
    return text + "  " + (catch2 ? "CHECK" : "EXPECT_TRUE") +
           "(catalogue::packed(answer) == catalogue::packed(expected));\n}\n";
  }
  const bool in_rust = framework_ == "rust";
  const Literals& literals = pytest ? python : in_rust ? rust : javascript;
  const Json input = json_of<double>(operation.question_shape(), examination.question(), marked);
  Json expected = json_of<double>(operation.answer_shape(), right_answer(examination), marked);
  const std::string bare = operation.metadata().answer;
  if (!bare.empty()) expected = Json{{bare, expected}};
  // An engine that answers true or false is tested for that.
  const auto plainly = yes_or_no(operation.answer_shape(), right_answer(examination).words);
  if (plainly && engine.is_object() && engine["answer"].is_boolean()) expected = *plainly;
  if (in_rust) {
    std::string text = once("use serde_json::{json, Value};\n");
    text +=
        once("\nfn " + mine + "(question: &Value) -> Value {\n    panic!(\"" + to_be_written + ": {question}\")\n}\n");
    text += "\n" + comments(examination, engine, "//") + "#[test]\nfn " + name + "() {\n";
    text += "    let question = json!(" + literal(input, literals) + ");\n";
    text += "    let expected = json!(" + literal(expected, literals) + ");\n";
    return text + "    assert_eq!(" + mine + "(&question), expected);\n}\n";
  }
  const std::string fields = parameters(operation, pytest);
  if (pytest) {
    std::string text =
        once("def " + mine + "(" + fields + "):\n    raise NotImplementedError(\"" + to_be_written + "\")\n");
    text += "\n\n" + comments(examination, engine, "#") + "def test_" + name + "():\n";
    text += "    question = " + literal(input, literals) + "\n    expected = " + literal(expected, literals) + "\n";
    return text + "    assert " + mine + "(**question) == expected\n";
  }
  std::string text =
      once("function " + mine + "({ " + fields + " }) {\n  throw new Error(\"" + to_be_written + "\");\n}\n");
  text += "\n" + comments(examination, engine, "//") + "test(\"" + name + "\", () => {\n";
  text +=
      "  const question = " + literal(input, literals) + ";\n  const expected = " + literal(expected, literals) + ";\n";
  return text + "  expect(" + mine +
         "(question)).toEqual(expected); // toEqual tells -0 from 0, which are the same answer\n});\n";
}

}  // namespace touchstone::audit
