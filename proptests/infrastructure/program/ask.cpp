// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/json.h"
#include "proptests/infrastructure/program/called.h"

/// What `ask` evaluates, and what it leaves out.
namespace touchstone::proptests::ask_tests {
namespace {

using catalogue::Json;
using program::bad_usage;
using program::nothing_found;

Json asked(const char* operation, const Json& question, std::vector<const char*> options = {}) {
  const TextFile file("question.jsonl", question.dump());
  std::vector<const char*> arguments{"ask", operation, file.path()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Called call = called(arguments);
  INFO(call.err);
  CHECK(call.code == nothing_found);
  return Json::parse(call.out);
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// Of radius 1, each far from all others.
Json balls(int count) {
  Json balls = Json::array();
  for (int i = 0; i < count; ++i) balls.push_back({{"center", {0, 100 * (i + 1), 0}}, {"radius", 1}});
  return balls;
}

/// And two whose squared distance, 32.49 before 0.1 is rounded to doubles, exceeds the square of 5.7 in doubles, which
/// exactly it does not.
Json with_lost_pair(Json spheres) {
  spheres.push_back({{"center", {0, 0, 0}}, {"radius", 4.3}});
  spheres.push_back({{"center", {3.8, 1.9, 3.8}}, {"radius", 1.4}});
  return spheres;
}

}  // namespace

TEST_CASE("ask --truth: the truth and its margin, and nothing else") {
  const Json question{{"a", {{0, 0}, {2, 0}}}, {"b", {{1, 0}, {3, 0}}}};
  const Json alone = asked("segment_segment", question, {"--truth"}), all = asked("segment_segment", question);
  CHECK(keys_of(alone) == std::vector<std::string>{"op", "input", "truth", "margin"});
  for (const auto& [key, value] : alone.items()) CHECK(value == all[key]);
  require_refused(called({"ask", "segment_segment", "--truth", "--as", "pytest"}), bad_usage, "--as");
}

TEST_CASE("ask: a formula of too many steps is not evaluated") {
  // 4096^2 = 2^24
  CHECK(asked("all_pairs", {{"spheres", balls(4096)}})["reference"]["verdict"] == "agree");
  const Json line = asked("all_pairs", {{"spheres", balls(4097)}});
  CHECK(line["reference"] == Json{{"not_evaluated", "16785409 steps (n^2, n = 4097)"}});
  CHECK(line["robust"]["verdict"] == "agree");
  CHECK(line["truth"] == Json{{"pairs", Json::array()}});
}

TEST_CASE("ask: the cause of an error is not sought in too many steps, and the error is told") {
  // 256^2 = 2^16
  const Json small = asked("all_pairs", {{"spheres", with_lost_pair(balls(254))}})["reference"];
  CHECK(small["cause"] == "rounding");
  const Json line = asked("all_pairs", {{"spheres", with_lost_pair(balls(255))}});
  const Json& reference = line["reference"];
  CHECK(keys_of(reference) == std::vector<std::string>{"answer", "verdict", "cause_not_evaluated"});
  CHECK(reference["verdict"] == "wrong");
  CHECK(reference["cause_not_evaluated"] == "66049 steps (n^2, n = 257)");
  CHECK(reference["answer"] != line["robust"]["answer"]);
}

}  // namespace touchstone::proptests::ask_tests
