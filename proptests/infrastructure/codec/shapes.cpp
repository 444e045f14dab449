// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>

#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::shapes_tests {
namespace {

using catalogue::Json;

std::vector<std::uint64_t> bits_of(const Question& question) {
  std::vector<std::uint64_t> bits(question.words.begin(), question.words.end());
  for (const double number : question.numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

Question read_again(const Operation& operation, const Json& printed) {
  return operation.parse(catalogue::parse_line(catalogue::one_line(printed)));
}

std::string refusal(const Operation& operation, const Json& input) {
  return refusal_of([&] { read_again(operation, input); });
}

/// Every value inside a document, with its path as refusals spell it.
void for_each_value(Json& value, const std::string& path, const std::function<void(Json&, const std::string&)>& visit) {
  if (value.is_object()) {
    for (auto& [key, part] : value.items()) for_each_value(part, catalogue::member_path(path, key.c_str()), visit);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      for_each_value(value[i], path + "[" + std::to_string(i) + "]", visit);
  }
  visit(value, path);
}

/// No list is empty: an element shows what it holds.
Json simplest(const Operation& operation) {
  Question question = operation.zeros(std::max<std::size_t>(operation.metadata().list_length, 1));
  for (double& number : question.numbers) number = 1.5;
  return operation.print(question);
}

/// Those that the simplest question leaves out.
std::size_t optional_fields(const Operation& operation) {
  const auto& parts = operation.question_shape().parts;
  return static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](const catalogue::Shape::Part& part) {
    return part.shape->kind == catalogue::Shape::Kind::optional;
  }));
}

/// Calls test(document, path) for every value of the simplest question with that value replaced by `change`.
void with_each_changed(const Operation& operation, const std::function<bool(Json&)>& change,
                       const std::function<void(const Json&, const std::string&)>& test) {
  Json document = simplest(operation);
  std::size_t tests = 0;
  for_each_value(document, "", [&](Json& value, const std::string& path) {
    const Json before = value;
    if (!change(value)) return;
    INFO(catalogue::one_line(document));
    test(document, path), ++tests;
    value = before;
  });
  CHECK(tests > 0);
}

}  // namespace

EACH_OPERATION("a question of any family reads back from its decimals and from its hexadecimal strings") {
  never(
      operation, "read back",
      [&](const Question& question) -> std::string {
        const auto bits = bits_of(question);
        // An empty list is one of points of the plane as well as of space.
        if (operation.question_shape().kind == catalogue::Shape::Kind::choice &&
            catalogue::one_line(operation.print(question)).find("[]") != std::string::npos)
          return "";
        if (bits_of(read_again(operation, operation.print(question))) != bits)
          return "the decimals are another question";
        if (bits_of(read_again(operation, operation.print_hexadecimal(question))) != bits)
          return "the hexadecimals are another question";
        return "";
      },
      4);
}

EACH_OPERATION("an answer reads back, infinities too") {
  const catalogue::Shape& shape = operation.answer_shape();
  never(
      operation, "answers read back",
      [&](const Question& question) -> std::string {
        catalogue::EncodedValue<double> answer, again;
        try {
          answer = operation.row().robust(question, 0);
        } catch (const InvalidInput&) {
          return "";
        }
        const Json json =
            catalogue::json_of<double>(shape, answer, [](const double& n) { return catalogue::written(n); });
        catalogue::read_json<double>(shape,
                                     catalogue::parse_line(catalogue::one_line(Json{{"answer", json}}))["answer"],
                                     "answer", again, catalogue::read_answer_number);
        return bits_of(answer) == bits_of(again) && answer.words == again.words
                   ? ""
                   : "another answer: " + catalogue::one_line(json);
      },
      4);
}

EACH_OPERATION("a missing field is named") {
  Json document = simplest(operation);
  std::size_t fields = 0;
  for_each_value(document, "", [&](Json& value, const std::string& path) {
    if (!value.is_object()) return;
    const Json before = value;
    for (const auto& [key, part] : before.items()) {
      value.erase(key);
      const std::string said = refusal(operation, document);
      // An object that is left without a field may have been meant as any of some.
      const bool any_of_some = value.empty() && said.starts_with(path + ": expected an object with one of " + key);
      CHECK((said == catalogue::member_path(path, key.c_str()) + ": missing" || any_of_some));
      value = before, ++fields;
    }
  });
  CHECK(fields >= operation.metadata().fields.size() - optional_fields(operation));
}

EACH_OPERATION("a field that is not known is named") {
  with_each_changed(
      operation, [](Json& value) { return value.is_object() ? (value["stranger"] = 1, true) : false; },
      [&](const Json& document, const std::string& path) {
        CHECK_THAT(refusal(operation, document),
                   StartsWith(catalogue::member_path(path, "stranger") + ": no such field; expected "));
      });
}

/// In these documents lists of points have one or at least three; a point of space holds numbers, a segment two points.
bool is_list(const Json& array) {
  return array[0].is_object() || array.size() == 1 || (array.size() > 2 && array[0].is_array());
}

EACH_OPERATION("an array of another size, and what is no array, is refused by its path; a list may have any length") {
  std::string rule;
  const auto change_by = [&rule](const std::function<void(Json&)>& change, bool to_an_array) {
    return [&rule, change, to_an_array](Json& value) {
      if (!value.is_array()) return false;
      rule = is_list(value) ? to_an_array ? "accepted" : ": expected an array"
                            : ": expected an array of " + std::to_string(value.size());
      return change(value), true;
    };
  };
  // Where the same field is read in the plane and in space, what is of neither size is refused as either.
  const bool ambiguous =
      operation.question_shape().kind == catalogue::Shape::Kind::choice && operation.metadata().other_fields.empty();
  const auto refused = [&](const Json& document, const std::string& path) {
    // The only arrays of three vectors that are no lists; a and b of two triangles are such too.
    if (path.ends_with("half_axes") || path.ends_with("inertia") || path.ends_with("triangle") ||
        std::string(operation.name()).starts_with("triangle_triangle"))
      rule = ": expected an array of 3";
    if (path.find(".faces[") != std::string::npos) {  // of a mesh: polygons of any number of corners, but not of these
      CHECK_THAT(refusal(operation, document), StartsWith(path + ": "));
      return;
    }
    if (ambiguous && rule != "accepted") {
      CHECK(refusal(operation, document).find(": expected an array") != std::string::npos);
      return;
    }
    if (rule == "accepted") CHECK(refusal(operation, document) == rule);
    else CHECK_THAT(refusal(operation, document), StartsWith(path + rule + ", got "));
  };
  with_each_changed(operation, change_by([](Json& value) { value.push_back(Json(value[0])); }, true), refused);
  with_each_changed(operation, change_by([](Json& value) { value.erase(value.size() - 1); }, true), refused);
  with_each_changed(operation, change_by([](Json& value) { value = Json::array(); }, true), refused);
  with_each_changed(operation, change_by([](Json& value) { value = 7; }, false), refused);
}

EACH_OPERATION("what should be a number is refused by its path, wherever it stands") {
  for (const Json& wrong : {Json(nullptr), Json(true), Json("one"), Json::array({1}), Json::object({{"x", 1}})}) {
    with_each_changed(
        operation, [&](Json& value) { return value.is_number() ? (value = wrong, true) : false; },
        [&](const Json& document, const std::string& path) {
          CHECK_THAT(refusal(operation, document), StartsWith(path + ": expected a number, got "));
        });
  }
  for (const Json& wrong : {Json("nan"), Json("-inf"), Json("0x1p+1024")}) {
    with_each_changed(
        operation, [&](Json& value) { return value.is_number() ? (value = wrong, true) : false; },
        [&](const Json& document, const std::string& path) {
          CHECK(refusal(operation, document) == path + ": finite number");
        });
  }
}

EACH_OPERATION("what is no object is refused as the input") {
  for (const Json& wrong : {Json::array(), Json(1), Json("orientation"), Json(nullptr)}) {
    CHECK_THAT(refusal(operation, wrong),
               StartsWith("input: expected an object like {\"") && ContainsSubstring(", got " + wrong.dump()));
  }
}

TEST_CASE("words: an answer's word is one of its enumeration's, letter by letter") {
  const auto side = [](const char* json) -> std::string {
    Side read{};
    try {
      catalogue::read(catalogue::parse_line(std::string("{\"side\":") + json + "}")["side"], "side", read,
                      catalogue::read_double);
      return catalogue::Words<Side>::words[static_cast<std::size_t>(read)];
    } catch (const InvalidInput& refused) {
      return refused.what();
    }
  };
  CHECK(side("\"left\"") == "left");
  CHECK(side("\"on\"") == "on");
  CHECK(side("\"right\"") == "right");
  for (const char* wrong : {"\"Left\"", "\"\"", "1", "null", "\"lef\"", "\"left \""})
    CHECK_THAT(side(wrong), StartsWith("side: expected one of left, on, right, got "));
}

}  // namespace touchstone::proptests::shapes_tests
