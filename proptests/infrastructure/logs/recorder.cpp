// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <csignal>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

#include "audit/counting/audit_run.h"
#include "c/record.h"
#include "catalogue/codec/plain.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/logs/read_log.h"

namespace touchstone::proptests::recorder_tests {
namespace {

using namespace audit;
using Kind = RecordedAnswer::Kind;

/// What was recorded by `run` in a log with these options.
template <class Run>
ReadLog recorded_by(const RecordingOptions& options, const Run& run) {
  const TextFile file("recorded", "");
  {
    const Recording recording(file.path(), options);
    run();
  }
  return ReadLog(file);
}

const Segment2d a{{0, 0}, {2, 0}};

constexpr int line_of_meets = __LINE__ + 3;
bool meets(double x) {
  const Segment2d b{{x, -1}, {x, 1}};
  return record(
      "segment_segment", [&] { return x <= 2; }, a, b);
}

TEST_CASE("recorder: a call is read as it was made, with its site, its number type and whatever it answered") {
  const auto log = recorded_by({.engine = "a \"game\"", .boundary = "closed", .tolerance = 0.125}, [] {
    CHECK(meets(1));
    CHECK_FALSE(meets(3));
    const Segment2<float> narrow{{0.1f, 0}, {1, 0}};
    CHECK(record(
              "segment_segment", [] { return SegmentRelation::overlap; }, narrow, narrow) == SegmentRelation::overlap);
    CHECK(record(
              "segment_segment",
              [] {
                return SegmentSegment<double>{SegmentRelation::point, 0.5, 0.25, Point2d{1, 2}, {}};
              },
              a, a)
              .ta == 0.5);
    CHECK_FALSE(record(
        "segment_segment", [] { return std::optional<bool>(); }, a, a));
    CHECK(record(
              "segment_segment", [] { return std::optional<bool>(true); }, a, a) == true);
    CHECK_THROWS_WITH(record(
                          "segment_segment", []() -> bool { throw std::runtime_error("no \"memory\""); }, a, a),
                      "no \"memory\"");
  });
  REQUIRE(log.account.header.declaration.engine == "a \"game\"");
  REQUIRE(log.account.header.declaration.boundary == Declaration::Boundary::closed);
  REQUIRE(log.account.header.declaration.tolerance == 0.125);
  REQUIRE(log.account.remarks.empty());
  REQUIRE(log.account.refused.empty());
  REQUIRE(log.account.end == LogEnd{6, 6, 0, 0});
  REQUIRE(log.calls.size() == 6);
  REQUIRE(log.calls[0].question == Question{{0, 0, 2, 0, 1, -1, 1, 1}, {}});
  REQUIRE(log.calls[0].answer.kind == Kind::plain);
  REQUIRE(log.calls[0].answer.value.words == std::vector<Word>{1});
  REQUIRE(log.calls[1].answer.value.words == std::vector<Word>{0});
  REQUIRE_THAT(log.account.sites[log.calls[0].site], EndsWith("recorder.cpp:" + std::to_string(line_of_meets)));
  REQUIRE(log.calls[2].binary32);
  REQUIRE(log.calls[2].question.numbers[0] == double{0.1f});
  const auto text = [&](std::size_t i) {
    return one_line(plain(answer_json(*log.calls[i].operation, log.calls[i].answer)));
  };
  REQUIRE(text(2) == R"({"relation":"overlap"})");
  REQUIRE(text(3) == R"({"relation":"point","ta":0.5,"tb":0.25,"point":[1,2]})");
  REQUIRE(text(4) == "true");
  REQUIRE(log.calls[5].answer.kind == Kind::error);
  REQUIRE(log.calls[5].answer.text == "no \"memory\"");
}

TEST_CASE("recorder: functions of one type, called in several places, have a site for each") {
  const auto log = recorded_by({}, [] {
    const std::function<bool()> yes = [] { return true; };
    for (int i = 0; i < 2; ++i) {
      CHECK(record("segment_segment", yes, a, a));
      CHECK(record("swept_segment", yes, a, a));
      CHECK(record("segment_segment", yes, a, a));
    }
    const double numbers[8] = {0, 0, 2, 0, 1, -1, 1, 1};
    TOUCHSTONE_RECORD_DOUBLES("segment_segment", numbers, 8, TOUCHSTONE_RECORD_FLAG, 1 << 4);
  });
  std::map<std::string, int> places;
  for (const RecordedCall& call : log.calls) ++places[log.account.sites[call.site]];
  REQUIRE(places.size() == 3);
  for (const auto& [place, calls] : places) CHECK(calls <= 2);
  // Of the four calls in two places, and of the flag that is 16, the answer is true.
  REQUIRE(log.calls.size() == 5);
  for (const RecordedCall& call : log.calls) CHECK(call.answer.value.words == std::vector<Word>{1});
  CHECK(log.account.refused.size() == 1);  // there is no swept_segment, and it is named as it was called
}

TEST_CASE("recorder: every call of every thread is written once, also of threads that ended before the log") {
  constexpr int threads = 4, each = 5000;
  const auto log = recorded_by({}, [] {
    std::vector<std::thread> running;
    for (int t = 0; t < threads; ++t) {
      running.emplace_back([t] {
        for (int i = 0; i < each; ++i) meets(t * each + i);
      });
    }
    for (std::thread& thread : running) thread.join();
  });
  REQUIRE(log.account.remarks.empty());
  REQUIRE(log.account.end == LogEnd{threads * each, threads * each, 0, 0});
  std::set<double> seen;
  for (const RecordedCall& call : log.calls) seen.insert(call.question.numbers[4]);
  REQUIRE(seen.size() == threads * each);
  REQUIRE(*seen.rbegin() == threads * each - 1);
  REQUIRE(log.calls.size() == threads * each);
}

TEST_CASE("recorder: a log that is closed while other threads call is whole") {
  std::atomic<bool> over{false};
  std::vector<std::thread> running;
  const auto log = recorded_by({}, [&] {
    for (int t = 0; t < 2; ++t) {
      running.emplace_back([&] {
        while (!over) meets(1);
      });
    }
    for (int i = 0; i < 20000; ++i) meets(0);
  });
  over = true;
  for (std::thread& thread : running) thread.join();
  REQUIRE(log.account.remarks.empty());
  REQUIRE(log.calls.size() == log.account.end.written);
  REQUIRE(log.account.end.written >= 20000);
}

TEST_CASE("recorder: of so many calls one is written on average, the first of a site and near ones always") {
  const auto log = recorded_by({.one_in = 10, .first = 5, .near = 0.5}, [] {
    for (int i = 0; i < 10000; ++i) {
      record_nearness(i % 1000 == 999 ? 0.25 : 2);
      meets(i);
    }
    record_nearness(0.5);  // no nearer than the bound
    meets(-1);
  });
  const LogEnd& end = log.account.end;
  REQUIRE(end.seen == 10001);
  REQUIRE(end.lost == 0);
  REQUIRE(end.written + end.sampled_out == end.seen);
  REQUIRE(log.calls.size() == end.written);
  // 15 for certain; the others follow each other at distances of 1 to 19, each as likely: five times their standard
  // deviation, 5.5, for each of a thousand, is 5 * 5.5 * sqrt(1000) = 870 calls of 10,000.
  REQUIRE(end.written > 15 + 900);
  REQUIRE(end.written < 15 + 1100);
  std::set<double> written;
  for (const RecordedCall& call : log.calls) written.insert(call.question.numbers[4]);
  for (const double certain : {0, 1, 2, 3, 4, 999, 1999, 9999}) REQUIRE(written.contains(certain));
}

TEST_CASE("recorder: a file stays within its bound, and what is lost is told") {
  const auto log = recorded_by({.most_bytes = 200'000}, [] {
    for (int i = 0; i < 10000; ++i) meets(i);
  });
  REQUIRE(log.bytes <= 200'000);
  REQUIRE(log.account.remarks.empty());
  REQUIRE(log.account.end.seen == 10000);
  REQUIRE(log.account.end.written == log.calls.size());
  REQUIRE(log.account.end.written > 1000);
  REQUIRE(log.account.end.written + log.account.end.lost == 10000);
}

TEST_CASE("recorder: a killed process loses what was in its buffers, and the log has no end mark") {
  const TextFile file("killed", "");
  const pid_t child = fork();
  if (child == 0) {
    const Recording recording(file.path());
    for (int i = 0; i < 5000; ++i) meets(i);
    std::raise(SIGKILL);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  const ReadLog log(file);
  REQUIRE(log.account.cut == 1);
  REQUIRE_THAT(log.account.remarks.at(0), ContainsSubstring("no end mark"));
  REQUIRE(log.calls.size() > 5000 - touchstone_record_block_ / 64);
  REQUIRE(log.calls.size() < 5000);
  for (std::size_t i = 0; i < log.calls.size(); ++i)
    REQUIRE(log.calls[i].question.numbers[4] == static_cast<double>(i));
}

TEST_CASE("recorder: a process that forks keeps its log, and the child writes nothing into it") {
  const auto log = recorded_by({}, [] {
    meets(1);
    const pid_t child = fork();
    if (child == 0) {
      meets(2);
      touchstone_record_close();
      _exit(0);
    }
    waitpid(child, nullptr, 0);
    meets(3);
  });
  REQUIRE(log.calls.size() == 2);
  REQUIRE(log.account.end == LogEnd{2, 2, 0, 0});
}

TEST_CASE("recorder: where nothing is open, calls go on; a file that cannot be written is named") {
  CHECK(meets(1));
  REQUIRE_THROWS_WITH(Recording("no such folder/log"), ContainsSubstring("no such folder/log"));
  REQUIRE(touchstone_record_close() == 0);
}

TEST_CASE("recorder: what C writes of any question of any operation, without knowing it, is read to the bit") {
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    std::vector<Question> questions;
    for (std::size_t family = 0; family < operation->families().size(); ++family) {
      DrawStream draws = case_draws(*operation, family, 2, 0);
      questions.push_back(operation->draw(draws, family));
    }
    const bool alternatives = operation->question_shape().kind == Shape::Kind::choice;
    const auto log = recorded_by({}, [&] {
      touchstone_record_site site{operation->metadata().name, "here:1", sizeof(double), TOUCHSTONE_RECORD_FLAG, 0, 0};
      const std::uint32_t yes = 1;
      const touchstone_record_value answer{nullptr, 0, &yes, 1};
      for (const Question& question : questions) {
        const std::size_t left_out = alternatives ? 1 : 0;
        const touchstone_record_value value{question.numbers.data(), question.numbers.size(),
                                            question.words.data() + left_out, question.words.size() - left_out};
        REQUIRE(touchstone_record_wants(&site) != 0);
        touchstone_record_call(&site, &value, &answer, nullptr);
      }
    });
    INFO(operation->name());
    REQUIRE(log.account.refused.empty());
    REQUIRE(log.calls.size() == questions.size());
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const bool empty_lists = alternatives && questions[i].numbers.empty();  // of which alternative, nobody can tell
      REQUIRE((log.calls[i].question.words == questions[i].words || empty_lists));
      REQUIRE(std::equal(
          questions[i].numbers.begin(), questions[i].numbers.end(), log.calls[i].question.numbers.begin(),
          [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }));
    }
  }
}

}  // namespace
}  // namespace touchstone::proptests::recorder_tests
