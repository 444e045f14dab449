// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/adapter.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

#include "audit/engines/fuzz.h"
#include "audit/engines/serve.h"
#include "program/engine_main.h"
#include "proptests/catch.h"
#include "robust/lines/orientation.h"

using namespace touchstone;
using namespace touchstone::audit;

namespace {

/// One operation for each thing that may be returned.
struct Various {
  static constexpr const char* name = "various 1";
  bool segment_segment(Segment2d, Segment2d) { return true; }
  Side orientation(Point2d, Point2d, Point2d) { return Side::right; }
  std::optional<Incidence> point_on_segment(Point2d p, Segment2d) {
    if (p.x == 13) return std::nullopt;
    return Incidence::off;
  }
  RaySegment<double> ray_segment(Ray2d, Segment2d) { return {RayRelation::point, 0.5, Point2d{1, 2}, std::nullopt}; }
  Point2d line_point_at(ParametricLine2d line, double t) { return line.origin + t * line.direction; }
  Height explicit_line(double, double, Point2d) { throw std::runtime_error("vertical"); }
};

struct InFloat {
  static constexpr const char* name = "in float 1";
  static constexpr auto boundary = Boundary::open;
  static constexpr double tolerance = 1e-6;
  using number = float;
  SegmentSegment<float> segment_segment(Segment2<float> a, Segment2<float>) {
    return {SegmentRelation::point, 0.1f, 0.0f, a.a, std::nullopt};
  }
  Side orientation(Point2d, Point2d, Point2d) { return Side::left; }
};

struct Right {
  static constexpr const char* name = "right";
  static constexpr auto boundary = Boundary::closed;
  Side orientation(const Point2d& a, const Point2d& b, const Point2d& c) { return robust::orientation(a, b, c); }
  std::optional<bool> segment_segment(const Segment2d&, const Segment2d&) { return std::nullopt; }
};

struct Tree {
  static constexpr const char* name = "tree 1";
  std::vector<std::variant<PairsReply, BodiesReply, RayReply>> broad_phase(const std::vector<Aabb3d>&,
                                                                           const std::vector<Commandd>&) {
    return {};
  }
};

template <class Engine>
std::string said(const std::string& operation, const std::string& input) {
  Engine engine{};
  const Served all = served(members_of(engine));
  const ServedOperation& asked = all.operations.at(operation);
  const auto answer = asked.answer(asked.operation.parse(parse_line(input)));
  return answer ? one_line(*answer) : "unsupported";
}

struct Leftist {
  static constexpr const char* name = "leftist";
  static constexpr auto boundary = Boundary::closed;
  Side orientation(Point2d, Point2d, Point2d) { return Side::left; }
};

/// Of two operations only what is in the plane.
struct Planar {
  static constexpr const char* name = "planar 2";
  bool sphere_sphere(Circle2d, Circle2d) { return true; }
  bool aabb_aabb(const Aabb2d&, const Aabb2d&) { return true; }
  bool segments_meet(Segment2d, Segment2d) { return true; }
};

struct Thrower {
  static constexpr const char* name = "thrower";
  Side orientation(Point2d, Point2d, Point2d) { throw std::runtime_error("out of cheese"); }
};

/// How a process ends that fuzzes the engine with TOUCHSTONE_FUZZ_ONLY set (unset where nullptr), and its complaints.
struct Fuzzed {
  int status = 0;
  std::string complaint;
};
template <class Engine>
Fuzzed fuzzed_with(const char* only) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);  // Catch's would report a failed test
    dup2(ends[1], 2);
    only == nullptr ? unsetenv("TOUCHSTONE_FUZZ_ONLY") : setenv("TOUCHSTONE_FUZZ_ONLY", only, 1);
    for (unsigned i = 0; i < 2000; ++i) {
      const unsigned char bytes[] = {static_cast<unsigned char>(i), static_cast<unsigned char>(i >> 2), 7, 3};
      fuzz_engine<Engine, signatures::orientation>(bytes, sizeof bytes);
    }
    _exit(0);
  }
  close(ends[1]);
  Fuzzed fuzzed;
  char bytes[4096];
  for (ssize_t n; (n = read(ends[0], bytes, sizeof bytes)) > 0;) fuzzed.complaint.append(bytes, n);
  close(ends[0]);
  waitpid(child, &fuzzed.status, 0);
  return fuzzed;
}

template <class Engine>
void require_stopped(const char* only, const char* words) {
  const Fuzzed fuzzed = fuzzed_with<Engine>(only);
  INFO(fuzzed.complaint);
  REQUIRE(WIFSIGNALED(fuzzed.status));
  REQUIRE(WTERMSIG(fuzzed.status) == SIGABRT);
  REQUIRE_THAT(fuzzed.complaint, ContainsSubstring(words));
}

template <class Engine>
void require_undisturbed(const char* only) {
  const Fuzzed fuzzed = fuzzed_with<Engine>(only);
  INFO(fuzzed.complaint);
  REQUIRE(fuzzed.status == 0);
  REQUIRE(fuzzed.complaint.empty());
}

const char* const segments = R"({"a":[[0.1,0],[2,0]],"b":[[1,0],[3,0]]})";

}  // namespace

TEST_CASE("adapter: an engine has the operations that it has functions for") {
  Various engine;
  const std::set<std::string> expected{"segment_segment", "orientation",   "point_on_segment",
                                       "ray_segment",     "line_point_at", "explicit_line"};
  REQUIRE(served(members_of(engine)).hello.operations == expected);
}

TEST_CASE("adapter: an engine of an operation does not claim its methods, so nobody complains of them") {
  Tree engine;
  const Hello hello = served(members_of(engine)).hello;
  REQUIRE(hello.operations == std::set<std::string>{"broad_phase"});
  REQUIRE(read_hello(written_hello(hello)).remarks.empty());
}

TEST_CASE("adapter: above the table stand the operations found, the overloads not found, and how many there are else") {
  Planar engine;
  const Served all = served(members_of(engine));
  REQUIRE(all.left_out == std::vector<std::string>{"sphere_sphere(Sphere3<double> a, Sphere3<double> b)",
                                                   "aabb_aabb(Aabb3<double> a, Aabb3<double> b)"});
  const std::map<std::string, std::set<std::size_t>> in_plane{{"aabb_aabb", {0}}, {"sphere_sphere", {0}}};
  REQUIRE(all.hello.declaration.alternatives == in_plane);
  REQUIRE(read_hello(written_hello(all.hello)).declaration.alternatives == in_plane);
  std::size_t operations = 0;
  for (const Operation* operation : all_operations()) operations += operation->metadata().is_implementation() ? 0 : 1;
  const std::string text = program::operations_found(all);
  REQUIRE_THAT(text, StartsWith("planar 2 has 2 of " + std::to_string(operations) +
                                " operations: sphere_sphere, aabb_aabb\nNo overload found: "
                                "sphere_sphere(Sphere3<double> a, Sphere3<double> b),\n    aabb_aabb("));
  const std::string others = std::to_string(operations - all.operations.size());
  REQUIRE_THAT(text,
               ContainsSubstring("\nNo member function of " + others + " other names: touchstone ops lists them\n"));
  REQUIRE(program::operations_found(all, false) ==
          "planar 2 has 2 of " + std::to_string(operations) +
              " operations, 2 overloads are not found; --verbose names them\n");
  // What is short enough is named.
  Served most = all;
  for (const Operation* operation : all_operations())
    if (!operation->metadata().is_implementation() && operation->name() != "orientation")
      most.hello.operations.insert(operation->name());
  for (const std::string& name : most.hello.operations)
    most.operations.emplace(name, ServedOperation{*find_operation(name), QuestionText(*find_operation(name)), nullptr});
  REQUIRE_THAT(program::operations_found(most),
               ContainsSubstring("\nNo member function of these names: orientation\n"));
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    REQUIRE(end - at <= 100);
}

TEST_CASE("adapter: a truth value, a word, a whole answer and nothing are answers") {
  REQUIRE(said<Various>("segment_segment", segments) == "true");
  REQUIRE(said<Various>("orientation", R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})") == R"({"side":"right"})");
  REQUIRE(said<Various>("point_on_segment", R"({"point":[0,0],"segment":[[0,0],[1,0]]})") == R"({"relation":"off"})");
  REQUIRE(said<Various>("point_on_segment", R"({"point":[13,0],"segment":[[0,0],[1,0]]})") == "unsupported");
  REQUIRE(said<Various>("ray_segment", R"({"ray":{"origin":[0,0],"direction":[1,0]},"segment":[[0,0],[1,0]]})") ==
          R"({"relation":"point","t":0.5,"point":[1,2]})");
  REQUIRE(said<Various>("line_point_at", R"({"line":{"origin":[0,0],"direction":[1,2]},"t":2})") ==
          R"({"point":[2,4]})");
  REQUIRE_THROWS_WITH(said<Various>("explicit_line", R"({"slope":1,"intercept":0,"point":[0,0]})"), "vertical");
}

TEST_CASE("adapter: a word alone is an answer where the number is always there") {
  const MemberAnswer said = engine_answer<PointPlane<double>>(PlaneSide::front);
  REQUIRE(said.kind == MemberAnswer::Kind::word);
  REQUIRE(said.field == std::string("side"));
  REQUIRE(said.value == packed(PlaneSide::front));
}

TEST_CASE("adapter: an engine in float gets float shapes where it takes them, doubles elsewhere") {
  REQUIRE(said<InFloat>("segment_segment", segments) ==
          R"({"relation":"point","ta":0.10000000149011612,"tb":0,"point":[0.10000000149011612,0]})");
  REQUIRE(said<InFloat>("orientation", R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})") == R"({"side":"left"})");
}

TEST_CASE("adapter: what an engine declares is what its first line says, and reads back") {
  InFloat engine;
  const std::string line = written_hello(served(members_of(engine)).hello);
  REQUIRE(line ==
          "{\"engine\":\"in float 1\",\"ops\":[\"orientation\",\"segment_segment\"],\"number\":\"binary32\","
          "\"boundary\":\"open\",\"tolerance\":1e-06}\n");
  const Hello read = read_hello(line);
  REQUIRE(read.declaration.boundary == Boundary::open);
  REQUIRE(read.declaration.binary32);
  REQUIRE(read.declaration.tolerance == 1e-6);
}

TEST_CASE("adapter: a fuzz target lets right answers and unsupported questions pass") {
  for (unsigned i = 0; i < 2000; ++i) {
    const unsigned char bytes[] = {static_cast<unsigned char>(i), static_cast<unsigned char>(i * 7),
                                   static_cast<unsigned char>(i >> 3), 5, 6};
    REQUIRE((fuzz_engine<Right, signatures::orientation>(bytes, sizeof bytes)) == 0);
    REQUIRE((fuzz_engine<Right, signatures::segment_segment>(bytes, sizeof bytes)) == -1);
  }
}

TEST_CASE("adapter: a fuzz target aborts on a finding with the verdict, the input, the answer and the truth") {
  require_stopped<Leftist>(nullptr, "leftist: orientation (");
  require_stopped<Leftist>("", R"(it says {"side":"left"}, the truth is {"side":")");
  require_stopped<Thrower>(nullptr, R"(thrower: orientation (invalid: out of cheese) on {"p0":["-)");
}

TEST_CASE("adapter: TOUCHSTONE_FUZZ_ONLY names the verdicts that abort") {
  require_stopped<Leftist>("algorithm", "leftist: orientation (algorithm)");
  require_stopped<Leftist>("rounding", "leftist: orientation (rounding)");
  require_stopped<Leftist>("invalid,algorithm", "leftist: orientation (algorithm)");
  require_undisturbed<Leftist>("invalid");
  require_undisturbed<Thrower>("rounding,algorithm,inexact,unsupported");
}

TEST_CASE("adapter: a name in TOUCHSTONE_FUZZ_ONLY that would never abort is refused") {
  for (const char* only : {"agree", "algoritm", "algorithm, invalid", "algorithm,,invalid"}) {
    const Fuzzed fuzzed = fuzzed_with<Leftist>(only);
    INFO(only << ": " << fuzzed.complaint);
    REQUIRE(WIFEXITED(fuzzed.status));
    REQUIRE(WEXITSTATUS(fuzzed.status) == 2);
    REQUIRE_THAT(fuzzed.complaint, StartsWith("TOUCHSTONE_FUZZ_ONLY: verdicts separated by commas"));
  }
}
