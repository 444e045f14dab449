// SPDX-License-Identifier: Apache-2.0
#include "c/touchstone.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <span>

#include "audit/counting/drawn_questions.h"
#include "c/made.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/operation/probes/listed_operations.h"
#include "oracle/certificates/check.h"

namespace touchstone::c {
namespace {

/// Adds the truth, and what describes it, to a line as fields.
void add_truth(Json& line, const Examination& examination) {
  const Operation& operation = examination.operation();
  line["input"] = with_points(operation.question_shape(), operation.print(examination.question()));
  line["truth"] = examination.truth();
  line["rounded"] = answer_with_points(operation, examination.rounded_truth());
  if (examination.margin()) line["margin"] = written(*examination.margin());
  line["touch"] = examination.touch();
}

/// The names of a list with commas; none for NULL and "".
std::vector<std::string> names_in(const char* list) {
  std::vector<std::string> names;
  for (const char* at = list == nullptr ? "" : list; *at != 0; at += *at == ',') {
    const char* const begin = at;
    while (*at != 0 && *at != ',') ++at;
    names.emplace_back(begin, at);
  }
  return names;
}

std::size_t family_named(const Operation& operation, const char* name) {
  const std::string text = text_of(name, "family");
  const auto& all = operation.families();
  const auto found = std::find(all.begin(), all.end(), text);
  if (found == all.end()) throw InvalidInput("family", "there is none of the name " + text);
  return static_cast<std::size_t>(found - all.begin());
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
  const int code = robust::c::answered(error, [&] { refused = certify::refuse_text(c::text_of(claim, "claim")); });
  if (code != TOUCHSTONE_OK || !refused) return code;
  return robust::c::failed(error, TOUCHSTONE_REFUSED, "claim", *refused);
}

int touchstone_draw(const char* operation, const char* families, uint64_t cases, uint64_t seed, char** result,
                    touchstone_error* error) {
  return c::made(result, error, [&] {
    const catalogue::Operation& asked = c::operation_named(operation);
    std::string lines;
    audit::draw_questions(asked, {.families = c::names_in(families), .cases = cases, .seed = seed},
                          [&](const std::string& family, std::uint64_t index, const auto& examination) {
                            catalogue::Json line = catalogue::Json::object();
                            line["op"] = asked.name();
                            line["family"] = family;
                            line["index"] = index;
                            c::add_truth(line, examination);
                            lines += catalogue::one_line(line) + '\n';
                          });
    return lines;
  });
}

int touchstone_replay(const char* operation, const char* family, const uint8_t* bytes, size_t count, char** result,
                      touchstone_error* error) {
  return c::made(result, error, [&] {
    const catalogue::Operation& asked = c::operation_named(operation);
    const std::size_t drawn = c::family_named(asked, family);
    catalogue::DrawStream draws = catalogue::DrawStream::replayed(std::span(bytes, count));
    return catalogue::one_line(asked.print(asked.draw(draws, drawn)));
  });
}

int touchstone_operations(char** result, touchstone_error* error) {
  return c::made(result, error, [] { return catalogue::listed_operations().dump(1) + '\n'; });
}

void touchstone_free(char* result) { std::free(result); }
