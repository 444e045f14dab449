// SPDX-License-Identifier: Apache-2.0
#include <mutex>

#include "audit/against/engines_apart.h"
#include "audit/counting/audit_run.h"
#include "catalogue/operation/probes/fitted.h"
#include "proptests/infrastructure/program/called.h"

namespace touchstone::proptests::against_tests {
namespace {

using namespace audit;

/// Answers as a function does, within this process.
class Planted final : public Engine {
 public:
  using Answer = std::function<Reply(const Operation&, const Question&)>;
  Planted(Declaration declaration, Answer answer) : declaration_(std::move(declaration)), answer_(std::move(answer)) {}
  const Declaration& declaration() const override { return declaration_; }
  bool supports(const std::string&) const override { return true; }
  void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) override {
    for (std::size_t i = 0; i < questions.size(); ++i) take(i, answer_(operation, questions[i]));
  }

 private:
  Declaration declaration_;
  Answer answer_;
};

Reply answered(const std::string& answer) {
  Reply reply;
  reply.answer = parse_line(answer);
  return reply;
}

Reply failed(bool asked = true) {
  Reply reply;
  reply.kind = Reply::Kind::failed;
  reply.asked = asked;
  return reply;
}

Reply right(const Operation& operation, const Question& question) {
  return answered(one_line(operation.answer_json(operation.row().robust(question, 0))));
}

AgainstOptions options_of(const Planted::Answer& first, const Planted::Answer& second,
                          const Declaration& declared = {}) {
  AgainstOptions options;
  options.operations = {find_operation("orientation"), find_operation("segment_segment")};
  options.engines = [=] {
    return EnginePair{std::make_unique<Planted>(Declaration{}, first), std::make_unique<Planted>(declared, second)};
  };
  return options;
}

std::vector<PartedOperation> of_log(const std::string& log, const AgainstOptions& options) {
  const TextFile file("against", log);
  return log_against({file.path()}, options, false);
}

using Verdicts = std::pair<Verdict, Verdict>;
const std::string left = R"({"op":"orientation","input":{"p0":[0,0],"p1":[2,1],"p":[0,5]},"answer":{"side":"left"}})"
                         "\n";

}  // namespace

TEST_CASE("against: two answers are the same to the bit of every number, however they are written") {
  const Operation& operation = *find_operation("segment_segment");
  const Reply point = answered(R"({"relation":"point","ta":0.5,"tb":0.5,"point":[1,0]})");
  CHECK(same_reply(operation, point, answered(R"({"point":[1.0,0e1],"tb":5e-1,"relation":"point","ta":0.50})")));
  CHECK_FALSE(
      same_reply(operation, point, answered(R"({"relation":"point","ta":0.5000000000000001,"tb":0.5,"point":[1,0]})")));
  CHECK_FALSE(same_reply(operation, point, answered(R"({"relation":"point","ta":0.5})")));
  CHECK_FALSE(same_reply(operation, point, answered("true")));
  CHECK_FALSE(same_reply(operation, point, failed()));
  CHECK(same_reply(operation, failed(), failed()));
  CHECK_FALSE(same_reply(operation, answered(R"("yes")"), answered(R"("no")")));
}

TEST_CASE("against: every call of a log is asked that the operations have and the contract allows") {
  const std::string touch = R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,0],[1,1]]},"answer":false})"
                            "\n",
                    outside = R"({"op":"orientation","input":{"p0":["nan",0],"p1":[2,1],"p":[0,5]},"answer":true})"
                              "\n";
  AgainstOptions options = options_of(right, right);
  const auto both = of_log(left + outside + touch + left, options);
  REQUIRE(both.size() == 2);
  CHECK(both[0].operation == "segment_segment");
  CHECK(both[0].asked == 1);
  CHECK(both[0].count() == 1);
  CHECK(both[1].asked == 2);
  CHECK(both[1].count() == 0);
  options.operations = {find_operation("orientation")};
  CHECK(of_log(left + touch, options).size() == 1);
  // No engine that was given up has answered anything.
  for (const PartedOperation& one :
       of_log(left + left, options_of(right, [](const auto&, const auto&) { return failed(false); }))) {
    CHECK(one.asked == 0);
    CHECK(one.not_asked == 2);
    CHECK(one.count() == 0);
  }
}

TEST_CASE("against: each of the two is judged by its own declaration") {
  Declaration closed;
  closed.boundary = Declaration::Boundary::closed;
  const std::string header = R"({"touchstone_log":1,"boundary":"open"})"
                             "\n";
  const auto touching =
      of_log(header + R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,0],[1,1]]},"answer":false})"
                      "\n",
             options_of(right, right, closed));
  CHECK(touching.at(0).parted.count(Verdicts{Verdict::convention, Verdict::agree}) == 1);
  // A third, rounded to float and to double.
  const auto third =
      of_log(R"({"op":"segment_segment","input":{"a":[[0,0],[3,0]],"b":[[1,-1],[1,1]]},"answer":)"
             R"({"relation":"point","ta":0.3333333432674408,"tb":0.5,"point":[1,0]},"number":"binary32"})"
             "\n",
             options_of(right, right, closed));
  CHECK(third.at(0).parted.count(Verdicts{Verdict::agree, Verdict::agree}) == 1);
}

TEST_CASE("against: all questions that part are counted, and the smallest of a kind is kept, with its place") {
  const Operation& operation = *find_operation("orientation");
  // Wrong right of x = 5 alone.
  const auto wrong_far = [&](const Operation& asked, const Question& question) {
    return question.numbers[4] > 5 ? answered(R"({"side":"on"})") : right(asked, question);
  };
  std::mutex mutex;
  std::vector<Question> parted;
  const auto first = [&](const Operation& asked, const Question& question) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (one_line(right(asked, question).answer) != one_line(wrong_far(asked, question).answer))
      parted.push_back(question);
    return right(asked, question);
  };
  AgainstOptions options = options_of(first, wrong_far);
  options.operations = {&operation};
  options.cases = 600, options.jobs = 2;
  const PartedOperation found = ask_against(options, false).at(0);
  CHECK(found.count() == parted.size());
  REQUIRE(!parted.empty());
  const auto smallest = *std::min_element(parted.begin(), parted.end(), audit::smaller);
  bool is_kept = false;
  for (const auto& [verdicts, kind] : found.parted) {
    const Parting& shown = *kind.smallest;
    is_kept = is_kept || shown.question == smallest;
    const auto family = std::find(operation.families().begin(), operation.families().end(), shown.family);
    REQUIRE(family != operation.families().end());
    const auto place = static_cast<std::size_t>(family - operation.families().begin());
    DrawStream draws = case_draws(operation, place, options.seed, shown.index);
    CHECK(catalogue::fitted(operation, operation.draw(draws, place), Declaration{}) == shown.question);
  }
  CHECK(is_kept);
  options.seconds_to_reduce = 5;
  const PartedOperation reduced = ask_against(options, false).at(0);
  for (const auto& [verdicts, kind] : reduced.parted) CHECK(kind.smallest->question.numbers[4] > 5);
}

TEST_CASE("judge --against: who is right is counted once, and an engine that has no answer is not") {
  // p is left of the line, and the engine says so where p.y is 1; it has no answer where it is 2, and is wrong at 3.
  const char* const engine = R"(read greeting; echo '{"engine":"planted","ops":["orientation"]}'
while read -r q; do id=${q#*:}; id=${id%%,*}; case "$q" in *,1]*) a='"answer":{"side":"left"}';;
*,2]*) a='"unsupported":true';; *) a='"answer":{"side":"on"}';; esac; echo "{\"id\":$id,$a}"; done)";
  const auto call = [](int y, const std::string& side) {
    return R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0],"p":[0,)" + std::to_string(y) +
           R"(]},"answer":{"side":")" + side + "\"}}\n";
  };
  const TextFile log("log", call(1, "left") + call(1, "right") + call(1, "right") + call(2, "left") + call(2, "right") +
                                call(3, "right") + call(3, "left") + call(3, "left"));
  const Called judged = called({"judge", log.path(), "--against", engine});
  CHECK(judged.code == 1);
  // 3 x first: one at 2, two at 3; 2 x second; neither: one at 2, one at 3.
  CHECK_THAT(judged.out,
             ContainsSubstring(
                 "orientation             8             7             3             2             0             2\n"));
  const TextFile empty("empty", "");
  require_refused(called({"judge", empty.path(), "--against", engine}), 2, "no question was asked that both answer");
}

}  // namespace touchstone::proptests::against_tests
