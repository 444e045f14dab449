// SPDX-License-Identifier: Apache-2.0
#include "c/touchstone.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sstream>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/operation/probes/explained.h"
#include "oracle/certificates/check.h"
#include "program/commands/drawn_questions.h"
#include "robust/c/answered.h"

namespace touchstone::c {
namespace {

using namespace catalogue;

/// Prints every number of the catalogue's output with a point or an exponent, so that none reads as an index.
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

const Operation& operation_named(const char* name) {
  if (name == nullptr) throw InvalidInput("operation", "missing");
  if (const Operation* found = find_operation(name)) return *found;
  std::vector<std::string> known;
  for (const Operation* operation : all_operations()) known.push_back(operation->name());
  throw InvalidInput("operation", "there is none of the name " + std::string(name) + did_you_mean(name, known));
}

Question question_of(const Operation& operation, const char* text) {
  if (text == nullptr) throw InvalidInput("question", "missing");
  return operation.parse(parse_line(text));
}

/// Adds the truth, and what describes it, to a line as fields.
void add_truth(Json& line, const Examination& examination) {
  const Operation& operation = examination.operation();
  line["input"] = with_points(operation.question_shape(), operation.print(examination.question()));
  line["truth"] = examination.truth();
  line["rounded"] = answer_with_points(operation, examination.rounded_truth());
  if (examination.margin()) line["margin"] = written(*examination.margin());
  line["touch"] = examination.touch();
}

char* copied(const std::string& text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

/// Stores in *result the text that `make` returns.
template <class Make>
int made(char** result, touchstone_error* error, const Make& make) {
  if (result != nullptr) *result = nullptr;
  return robust::c::answered(error, [&] {
    if (result == nullptr) throw InvalidInput("result", "missing");
    *result = copied(make());
  });
}

}  // namespace
}  // namespace touchstone::c

using namespace touchstone;

int touchstone_answer(const char* operation, const char* question, char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const catalogue::Operation& asked = c::operation_named(operation);
    const auto answer = asked.row().robust(c::question_of(asked, question), 0);
    return catalogue::one_line(c::answer_with_points(asked, asked.answer_json(answer)));
  });
}

int touchstone_truth(const char* operation, const char* question, char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const catalogue::Operation& asked = c::operation_named(operation);
    const auto examination = asked.examine(c::question_of(asked, question));
    catalogue::Json line = catalogue::Json::object();
    line["op"] = asked.name();
    c::add_truth(line, *examination);
    line["certificate"] = catalogue::certificate_json(examination->certificate());
    return catalogue::one_line(line);
  });
}

int touchstone_ask(const char* operation, const char* question, char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const catalogue::Operation& asked = c::operation_named(operation);
    return catalogue::one_line(catalogue::explained(*asked.examine(c::question_of(asked, question))));
  });
}

int touchstone_certify(const char* claim, touchstone_error* error) {
  std::optional<std::string> refused;
  const int code = robust::c::answered(error, [&] {
    if (claim == nullptr) throw InvalidInput("claim", "missing");
    refused = certify::refuse_text(claim);
  });
  if (code != TOUCHSTONE_OK || !refused) return code;
  return robust::c::failed(error, TOUCHSTONE_REFUSED, "claim", *refused);
}

int touchstone_draw(const char* operation, const char* families, uint64_t cases, uint64_t seed, char** result,
                    touchstone_error* error) {
  return c::made(result, error, [&] {
    const program::DrawCommand command{.operation = c::operation_named(operation).name(),
                                       .families = families == nullptr ? "" : families,
                                       .cases = cases,
                                       .seed = seed};
    std::string lines;
    try {
      program::draw_questions(command, [&](const std::string& family, std::uint64_t index, const auto& examination) {
        catalogue::Json line = catalogue::Json::object();
        line["op"] = command.operation;
        line["family"] = family;
        line["index"] = index;
        c::add_truth(line, examination);
        lines += catalogue::one_line(line) + '\n';
      });
    } catch (const program::UsageError& wrong) {
      throw InvalidInput("families", wrong.what());
    }
    return lines;
  });
}

int touchstone_operations(char** result, touchstone_error* error) {
  return c::made(result, error, [] {
    std::ostringstream list;
    program::ops_command(/*json=*/true, list);
    return list.str();
  });
}

void touchstone_free(char* result) { std::free(result); }
