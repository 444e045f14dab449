// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "audit/counting/audit_run.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/logs/read_log.h"

namespace touchstone::proptests::log_forms_tests {
namespace {

using namespace audit;
using Kind = RecordedAnswer::Kind;
using Writer = std::unique_ptr<LogWriter> (*)(std::ostream&);

/// To the bit; NaN is NaN, of which JSON has one.
bool same(const EncodedValue<double>& a, const EncodedValue<double>& b) {
  return a.words == b.words &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(), [](double x, double y) {
           return (std::isnan(x) && std::isnan(y)) ||
                  std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
         });
}

bool same(const RecordedCall& a, const RecordedCall& b) {
  return a.operation == b.operation && same(a.question, b.question) && a.answer.kind == b.answer.kind &&
         same(a.answer.value, b.answer.value) && a.answer.text == b.answer.text && a.binary32 == b.binary32 &&
         a.ordinal == b.ordinal;
}

/// The right answer without the last field that can be left out, if there is one.
RecordedAnswer incomplete(const Operation& operation, Json answer) {
  const char* const name = operation.metadata().answer;
  Json& fields = name[0] == 0 ? answer : answer[name];
  if (fields.is_object() && fields.size() > 1) fields.erase(std::prev(fields.end()).key());
  return recorded_answer(operation, parse_line(one_line(answer)));
}

RecordedAnswer answer_of_kind(const Operation& operation, const Question& question, std::uint64_t i) {
  if (i % 5 == 0) return recorded_answer(operation, i % 2 == 0);
  if (i % 5 == 1) return recorded_answer(operation, Json{{"no_such_field", "text of its own \"\\\u00e9\n"}});
  if (i % 5 == 2) return {Kind::error, {}, "division by zero, \"quoted\"\n"};
  RecordedAnswer whole{Kind::whole, {}, ""};
  try {
    whole.value = operation.row().robust(question, 0);
  } catch (const InvalidInput& refused) {
    return {Kind::error, {}, refused.what()};
  }
  return i % 5 == 3 ? whole : incomplete(operation, operation.answer_json(whole.value));
}

/// Calls of all families; every other pair of them in float.
std::vector<RecordedCall> drawn_calls(const Operation& operation, std::uint64_t of_each_family) {
  std::vector<RecordedCall> calls;
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    for (std::uint64_t i = 0; i < of_each_family; ++i) {
      DrawStream draws = case_draws(operation, family, 1, i);
      RecordedCall call;
      call.operation = &operation;
      call.ordinal = calls.size();
      call.binary32 = call.ordinal % 4 > 1;
      call.question = operation.draw(draws, family);
      call.answer = answer_of_kind(operation, call.question, i + family);
      if (call.ordinal % 4 == 2) call.question = operation.in_binary32(call.question);
      calls.push_back(std::move(call));
    }
  }
  return calls;
}

std::string site_of(const RecordedCall& call) {
  return call.ordinal % 3 == 0 ? "" : "a \"b\".c:" + std::to_string(call.ordinal % 7);
}

constexpr LogEnd some_end{1000, 900, 60, 40};

std::string written_by(Writer writer, const std::vector<RecordedCall>& calls) {
  std::ostringstream out;
  const auto log = writer(out);
  log->header(read_log_header(parse_line(R"({"touchstone_log":1,"engine":"e\u00e9","sampled":{"one_in":3}})")));
  for (const RecordedCall& call : calls) log->write(call, site_of(call));
  log->end(some_end);
  return out.str();
}

std::string converted(const std::string& bytes, Writer writer) {
  const ReadLog log(bytes);
  REQUIRE(log.account.refused.empty());
  REQUIRE(log.account.remarks.empty());
  std::ostringstream out;
  const auto to = writer(out);
  to->header(log.account.header);
  for (const RecordedCall& call : log.calls) to->write(call, log.account.sites[call.site]);
  to->end(log.account.end);
  return out.str();
}

TEST_CASE("logs: calls of every family of every operation are the same in both forms, there and back to the byte") {
  std::map<Kind, std::uint64_t> kinds;
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    INFO(operation->name());
    const std::vector<RecordedCall> calls = drawn_calls(*operation, 5);
    const std::string lines = written_by(json_writer, calls), binary = written_by(binary_writer, calls);
    for (const std::string& bytes : {lines, binary}) {
      const ReadLog read(bytes);
      CHECK(read.account.refused.empty());
      for (const auto& [reason, refused] : read.account.refused) FAIL_CHECK(refused.first);
      REQUIRE(read.calls.size() == calls.size());
      for (std::size_t i = 0; i < calls.size(); ++i) {
        INFO(one_line(operation->print(calls[i].question))
             << " " << one_line(answer_json(*operation, calls[i].answer)));
        ++kinds[calls[i].answer.kind];
        REQUIRE(same(read.calls[i], calls[i]));
        REQUIRE(read.account.sites[read.calls[i].site] == site_of(calls[i]));
      }
      REQUIRE(read.account.end == some_end);
      REQUIRE(read.account.header.declaration.engine == "e\u00e9");
    }
    REQUIRE((converted(lines, binary_writer) == binary));
    REQUIRE((converted(binary, json_writer) == lines));
  }
  REQUIRE(kinds.size() == 5);
}

TEST_CASE("logs: numbers beyond the contract are kept, and the sign of zero") {
  const Operation& orientation = *find_operation("orientation");
  constexpr double infinite = std::numeric_limits<double>::infinity();
  RecordedCall call;
  call.operation = &orientation;
  call.question.numbers = {std::nan(""), infinite, -infinite, -0.0, 0.0, 0x1p-1074};
  call.answer = recorded_answer(orientation, true);
  for (Writer writer : {json_writer, binary_writer}) {
    const ReadLog read(written_by(writer, {call}));
    REQUIRE(read.calls.size() == 1);
    REQUIRE(same(read.calls[0], call));
  }
}

TEST_CASE("logs: a pair of segments takes at most 1.2 times the bytes of its numbers in the binary form") {
  const Operation& segments = *find_operation("segment_segment");
  RecordedCall call;
  call.operation = &segments;
  call.question = segments.zeros();
  call.answer = recorded_answer(segments, true);
  for (const bool floats : {false, true}) {
    call.binary32 = floats;
    const std::size_t thousand = written_by(binary_writer, std::vector<RecordedCall>(1000, call)).size(),
                      two = written_by(binary_writer, std::vector<RecordedCall>(2000, call)).size();
    REQUIRE(static_cast<double>(two - thousand) <= 1.2 * 1000 * 8 * (floats ? 4 : 8));
  }
}

}  // namespace
}  // namespace touchstone::proptests::log_forms_tests
