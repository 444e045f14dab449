// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/pipe.h"

#include <fstream>
#include <sstream>
#include <thread>

#include "catalogue/operation/operation.h"
#include "proptests/catch.h"

using namespace touchstone::audit;
using touchstone::ContainsSubstring;
using touchstone::StartsWith;

namespace {

const Operation& orientation() { return *find_operation("orientation"); }

/// Questions 0, 1, 2 ...: the number is p.x, which the engine of these tests answers.
std::vector<Question> numbered(int count) {
  std::vector<Question> questions;
  for (int i = 0; i < count; ++i) questions.push_back({{0, 0, 1, 0, static_cast<double>(i), 1}});
  return questions;
}

PipeLimits with_timeout(double seconds) {
  PipeLimits limits;
  limits.timeout = seconds;
  return limits;
}

/// Long where nothing has to time out, so that a loaded machine does not fail a test.
constexpr double patient = 60;

struct Engineered {
  PipeEngine engine;
  explicit Engineered(const std::string& arguments, const PipeLimits& limits = with_timeout(patient),
                      const std::atomic<bool>* stop = nullptr, EngineNotes* notes = nullptr)
      : engine("python3 proptests/infrastructure/engines/misbehaving.py " + arguments, limits, stop, notes) {}
};

bool echoed(const Reply& reply, double number) {
  return reply.kind == Reply::Kind::answered && read_answer_number(reply.answer, "answer") == number;
}

/// Everything was answered as asked but the questions of `lost`, whose remark holds `remark`.
void require_lost(const std::vector<Reply>& replies, const std::vector<std::size_t>& lost, const std::string& remark) {
  for (std::size_t i = 0; i < replies.size(); ++i) {
    INFO("question " << i << ": " << replies[i].remark);
    if (std::find(lost.begin(), lost.end(), i) == lost.end()) {
      REQUIRE(echoed(replies[i], static_cast<double>(i)));
    } else {
      REQUIRE(replies[i].kind == Reply::Kind::failed);
      REQUIRE_THAT(replies[i].remark, ContainsSubstring(remark));
    }
  }
}

std::string refusal_to_start(const std::string& command) {
  PipeLimits limits;
  limits.start_timeout = 0.5;
  try {
    PipeEngine engine(command, limits);
  } catch (const EngineError& error) {
    return error.what();
  }
  return "it started";
}

bool alive(const std::string& process) {
  std::string number, name, state;
  std::ifstream("/proc/" + process + "/stat") >> number >> name >> state;
  return !state.empty() && state != "Z";
}

}  // namespace

TEST_CASE("pipe: what an engine does loses the questions that it happens on, and no other") {
  constexpr double soon = 0.4;  // a question has to time out
  struct {
    const char* behaviour;
    std::vector<std::size_t> lost;
    const char* remark;
    int restarts;
    double timeout = patient;
  } const rows[]{
      {"behaves", {}, "", 0},
      {"swaps", {}, "", 0},  // answers in another order
      {"answers_at_length", {}, "", 0},
      {"counts_in_floats", {}, "", 0},  // the ids
      {"crashes 13 14 577", {13, 14, 577}, "signal 11", 5},
      {"exits 7", {7}, "exit code 1: no licence", 2},
      {"hangs 300", {300}, "no answer in 0.4 s", 2, soon},
      {"is_silent 0 599", {0, 599}, "no answer in 0.4 s", 3, soon},
      {"babbles_only 5", {5}, "no answer in 0.4 s; the last line that is no answer: have a nice day", 2, soon},
      // JSON's quotes are double ones: this is what Python prints of a dictionary.
      {"prints_python 5", {5}, "a line that is no answer", 2},
      {"indents 5", {5}, "a line that is no answer", 2},  // an answer over several lines
      {"nests 5", {5}, "line: nested at most 64 deep", 2},
      {"forgets_the_id 5", {5}, "id: missing", 2},
      {"invents_an_id 5", {5}, "was not asked", 2},
      {"answers_for_the_dead 13", {13}, "was not asked: id 2", 2},  // started anew, what its predecessor was asked
      {"leaves_half_a_line 5", {5}, "exit code 1", 2},              // which is no part of its successor's first line
      {"answers_twice 3 250 599", {3, 250, 599}, "answered twice", 0},
      {"floods 20", {20}, "without the end of a line", 2},
      {"has_an_error 4", {4}, "error: division by zero", 0},
      {"answers_nothing 4", {4}, "neither", 0},
      {"stops_reading 2", {2}, "no answer in 0.4 s", 2, soon}};
  for (const auto& [behaviour, lost, remark, restarts, timeout] : rows) {
    INFO(behaviour);
    Engineered with(behaviour, with_timeout(timeout));
    require_lost(with.engine.ask(orientation(), numbered(600)), lost, remark);
    CHECK(with.engine.restarts() == restarts);
  }
}

TEST_CASE("pipe: answers that arrive letter by letter are put together") {
  Engineered with("answers_in_pieces");
  require_lost(with.engine.ask(orientation(), numbered(40)), {}, "");
}

TEST_CASE("pipe: numbers arrive as the doubles that they are") {
  Engineered with("prints_hexadecimal");
  std::vector<Question> questions;
  const std::vector<double> numbers{
      0.1, 1.0 / 3, 5e-324, -0.0, 1.7976931348623157e308, 9007199254740993.0, -1e22, 2.2250738585072009e-308};
  for (const double number : numbers) questions.push_back({{0, 0, 1, 0, number, 1}});
  const auto replies = with.engine.ask(orientation(), questions);
  for (std::size_t i = 0; i < numbers.size(); ++i) REQUIRE(echoed(replies[i], numbers[i]));
}

TEST_CASE("pipe: an engine that dies now and then but never twice on the same question loses none") {
  Engineered with("dies_after_ten");
  with.engine.ask(orientation(), numbered(1));
  require_lost(with.engine.ask(orientation(), numbered(100)), {}, "");
  REQUIRE(with.engine.restarts() > 5);
}

TEST_CASE("pipe: a line that is not about a question costs neither the question nor a restart") {
  // 600 lines before 600 answers: a word, a list, and an object that a debugger would print.
  for (const char* behaviour : {"babbles", "lists", "prints_objects"}) {
    EngineNotes notes;
    Engineered with(behaviour, with_timeout(patient), nullptr, &notes);
    INFO(behaviour);
    require_lost(with.engine.ask(orientation(), numbered(600)), {}, "");
    CHECK(with.engine.restarts() == 0);
    CHECK(notes.restarts() == 0);
    CHECK(notes.stray_lines() == 600);
    std::ostringstream printed;
    notes.tell(printed);
    CHECK_THAT(printed.str(),
               StartsWith("touchstone: engine: 600 lines of its standard output that are no answer, the last: "));
  }
}

TEST_CASE("pipe: it is told how often an engine was started anew, and why the last time") {
  EngineNotes notes;
  Engineered with("exits 7", with_timeout(patient), nullptr, &notes);
  require_lost(with.engine.ask(orientation(), numbered(600)), {7}, "no licence");
  std::ostringstream printed;
  notes.tell(printed);
  CHECK(printed.str() == "touchstone: engine: restarted 2 times, the last time for: exit code 1: no licence\n");
}

TEST_CASE("pipe: names of the first line that nobody knows are told, with what may have been meant") {
  EngineNotes notes;
  const PipeEngine engine(
      R"(echo '{"engine":"e","ops":["orientaton","orientation","juggle"],"boundry":"closed","new":1}'; cat)",
      PipeLimits{}, nullptr, &notes);
  CHECK(engine.supports("orientation"));
  std::ostringstream printed;
  notes.tell(printed);
  for (const char* line :
       {"first line: boundry: no such field (did you mean \"boundary\"?), ignored\n",
        "first line: new: no such field, ignored\n",
        "first line: ops: orientaton: no operation of the catalogue (did you mean \"orientation\"?), "
        "never asked\n",
        "first line: ops: juggle: no operation of the catalogue, never asked\n"})
    CHECK_THAT(printed.str(), ContainsSubstring(line));
  std::ostringstream briefly;
  notes.tell(briefly, false);
  CHECK(briefly.str() ==
        "touchstone: engine: first line: boundry: no such field (did you mean \"boundary\"?), ignored; --verbose tells "
        "3 more\n");
}

TEST_CASE("pipe: unsupported is an answer") {
  Engineered with("does_not_support 1");
  const auto replies = with.engine.ask(orientation(), numbered(3));
  REQUIRE(replies[1].kind == Reply::Kind::unsupported);
  REQUIRE(echoed(replies[2], 2));
}

TEST_CASE("pipe: a flood of complaints on standard error does not stand in the way") {
  Engineered with("complains_at_length");
  require_lost(with.engine.ask(orientation(), numbered(40)), {}, "");
}

TEST_CASE("pipe: an engine that dies on every question is given up, and asked again in the next operation") {
  PipeLimits limits = with_timeout(patient);
  limits.restarts_in_a_row = 5;
  Engineered with("crashes", limits);
  const auto replies = with.engine.ask(orientation(), numbered(2000));
  REQUIRE(replies[0].asked);
  REQUIRE_THAT(replies[0].remark, ContainsSubstring("signal 11"));
  REQUIRE_FALSE(replies[1999].asked);
  REQUIRE(replies[1999].kind == Reply::Kind::failed);
  REQUIRE_THAT(replies[1999].remark, StartsWith("given up after 5 restarts in a row, the last for: signal 11"));
  REQUIRE(with.engine.restarts() == 5);
  REQUIRE_FALSE(with.engine.ask(orientation(), numbered(1))[0].asked);
  REQUIRE(with.engine.ask(*find_operation("explicit_line"), {{{1, 0, 3, 4}}})[0].asked);
}

TEST_CASE("pipe: restarts with answers between them are not in a row") {
  PipeLimits limits = with_timeout(patient);
  limits.restarts_in_a_row = 4;
  Engineered with("crashes 13 200 577", limits);
  require_lost(with.engine.ask(orientation(), numbered(600)), {13, 200, 577}, "signal 11");
  REQUIRE(with.engine.restarts() > 4);
}

TEST_CASE("pipe: an engine that dies too often in an operation is given up") {
  PipeLimits limits = with_timeout(patient);
  limits.restarts = 4;
  Engineered with("crashes 1 3 5 7 9 11", limits);
  const auto replies = with.engine.ask(orientation(), numbered(600));
  REQUIRE(echoed(replies[2], 2));
  REQUIRE_THAT(replies[599].remark, StartsWith("given up after 4 restarts in this operation, the last for: signal 11"));
}

TEST_CASE("pipe: an engine that hangs on every question is given up") {
  PipeLimits limits = with_timeout(0.2);
  limits.timeouts = 3;
  Engineered with("hangs", limits);
  const auto replies = with.engine.ask(orientation(), numbered(2000));
  REQUIRE(replies[0].remark == "no answer in 0.2 s");
  REQUIRE(replies[1999].remark ==
          "given up after 3 questions without an answer in time, the last for: no answer in 0.2 s");
}

TEST_CASE("pipe: an interrupt ends the asking at once, and what was not asked says so") {
  std::atomic<bool> stop{false};
  Engineered with("hangs 100", with_timeout(patient), &stop);
  std::thread interrupt([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stop = true;
  });
  const auto replies = with.engine.ask(orientation(), numbered(600));
  interrupt.join();
  REQUIRE(echoed(replies[0], 0));
  REQUIRE_FALSE(replies[599].asked);
  REQUIRE(replies[599].remark == "interrupted");
}

TEST_CASE("pipe: an engine that hangs is not waited for when the time is over, and answers again afterwards") {
  Engineered with("hangs 100");
  int looked = 0;
  with.engine.ask_until([&] { return ++looked > 3; });
  const auto late = with.engine.ask(orientation(), numbered(600));
  REQUIRE_FALSE(late[599].asked);
  with.engine.ask_until([] { return true; });
  for (const Reply& reply : with.engine.ask(orientation(), numbered(3))) REQUIRE_FALSE(reply.asked);
  with.engine.ask_until(nullptr);
  require_lost(with.engine.ask(orientation(), numbered(3)), {}, "");
}

TEST_CASE("pipe: what the engine started dies with it") {
  std::string child;
  {
    const PipeEngine engine(R"(sleep 600 & echo "{\"engine\":\"$!\",\"ops\":[]}"; cat)", PipeLimits{});
    child = engine.declaration().engine;
    REQUIRE(alive(child));
  }
  for (int i = 0; i < 100 && alive(child); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE_FALSE(alive(child));
}

TEST_CASE("pipe: an engine that does not start is one line of explanation, which names the field of a first line") {
  const auto says = [](const std::string& line) { return "echo '" + line + "'; sleep 5"; };
  const std::pair<std::string, std::string> rows[]{
      {"no_such_engine_here", "not found"},
      {"no_such_engine_here", "exit code 127"},
      {"exit 3", "it said nothing and ended: exit code 3"},
      {"sleep 5", "no first line in 0.5 s"},
      {"head -c 3000000 /dev/zero; sleep 5", "first line does not end"},
      {says("hello"), R"(first line: expected {"engine":"NAME","ops":["OPERATION",...]}, got hello)"},
      {says("[]"), R"("ops":["OPERATION",...]}, got [])"},
      {says(R"({"ops":[]})"), "engine: missing"},
      {says(R"({"engine":"e"})"), "ops: missing"},
      {says(R"({"engine":1,"ops":[]})"), "engine: expected text, got 1"},
      {says(R"({"engine":"e","ops":[1]})"), "ops: expected text, got 1"},
      {says(R"({"engine":"e","ops":[],"boundary":"half"})"),
       R"(boundary: expected one of closed, open, unspecified, got "half")"},
      {says(R"({"engine":"e","ops":[],"number":"f32"})"), R"(number: expected one of binary64, binary32, got "f32")"},
      {says(R"({"engine":"e","ops":[],"tolerance":-1})"), "tolerance: expected a number >= 0, got -1"}};
  for (const auto& [command, explanation] : rows) {
    const std::string refused = refusal_to_start(command);
    INFO(command);
    CHECK_THAT(refused, ContainsSubstring(explanation));
    CHECK(refused.find('\n') == std::string::npos);
  }
}

TEST_CASE("pipe: what an engine declares is known") {
  const PipeEngine engine(
      R"(echo '{"engine":"e 2","ops":["orientation","juggle"],"number":"binary32","boundary":"open",)"
      R"("tolerance":1e-9,"new":1}'; cat)",
      PipeLimits{});
  REQUIRE(engine.declaration().engine == "e 2");
  REQUIRE(engine.declaration().binary32);
  REQUIRE(engine.declaration().boundary == Declaration::Boundary::open);
  REQUIRE(engine.declaration().tolerance == 1e-9);
  REQUIRE(engine.supports("orientation"));
  REQUIRE_FALSE(engine.supports("segment_segment"));
}
