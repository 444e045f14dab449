// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/passes.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "audit/reducing/mesh_parts.h"
#include "audit/reducing/reduced.h"
#include "audit/reducing/same_finding.h"
#include "audit/reducing/until.h"
#include "proptests/catch.h"
#include "proptests/solids.h"
#include "proptests/uses.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/volumes/convex_hull.h"

/// Each pass against a predicate of which the shortest question is known by hand.
namespace touchstone::proptests::reducing_passes_tests {
namespace {

/// What a predicate says of a question's values; whatever breaks the contract is refused.
template <class Value>
class Planted final : public Interest {
 public:
  Planted(const Operation& operation, std::function<bool(const Value&)> holds)
      : operation_(operation), holds_(std::move(holds)) {}
  Look look(std::size_t, const Question& question) override {
    try {
      operation_.row().robust(question, 0);
    } catch (const InvalidInput&) {
      return Look::refused;
    }
    return holds_(unpacked<Value>(question)) ? Look::holds : Look::fails;
  }

 private:
  const Operation& operation_;
  std::function<bool(const Value&)> holds_;
};

using Points = std::tuple<std::vector<Point3d>>;
using MeshAndPoint = std::tuple<Meshd, Point3d>;

struct Outcome {
  Question question;
  bool better;
  std::uint64_t candidates;
};
template <class Value>
Outcome after(bool (*pass)(Search&), const char* name, const Value& value, std::function<bool(const Value&)> holds,
              int jobs = 1) {
  const Operation& operation = *find_operation(name);
  Planted<Value> planted(operation, std::move(holds));
  SearchOptions options;
  options.jobs = jobs;
  Search search(operation, packed(value), planted, options);
  REQUIRE(search.holds(search.best()));
  const bool better = pass(search);
  return {search.best(), better, search.candidates()};
}

/// `rings` rings of as many vertices, and two poles.
Meshd ball(Index rings) {
  Meshd mesh;
  const double step = std::numbers::pi / (rings + 1);
  mesh.vertices.push_back({0.01, 0.02, 1});
  for (Index i = 1; i <= rings; ++i)
    for (Index k = 0; k < rings; ++k) {
      const double down = step * i, round = 2 * std::numbers::pi * k / rings;
      mesh.vertices.push_back({std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down)});
    }
  mesh.vertices.push_back({0.02, 0.01, -1});
  const auto last = static_cast<Index>(mesh.vertices.size() - 1);
  const auto at = [rings](Index ring, Index k) { return 1 + ring * rings + k % rings; };
  for (Index k = 0; k < rings; ++k) {
    mesh.faces.push_back({0, at(0, k), at(0, k + 1)});
    mesh.faces.push_back({last, at(rings - 1, k + 1), at(rings - 1, k)});
    for (Index i = 0; i + 1 < rings; ++i) {
      mesh.faces.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      mesh.faces.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  }
  return mesh;
}

double farthest(const Meshd& mesh) {
  double x = 0;
  for (const Face& face : mesh.faces)
    for (const Index v : {face.a, face.b, face.c}) x = std::max(x, mesh.vertices[v].x);
  return x;
}

}  // namespace

TEST_CASE("reduce: of a list the elements stay that are needed, wherever they stand") {
  std::vector<Point3d> points;
  for (int i = 0; i < 500; ++i) points.push_back({i + 0.5, i * i / 7.0, 3.0 - i});
  const auto holds = [](const Points& question) {
    int found = 0;
    for (const Point3d& p : std::get<0>(question)) found += p.x == 17.5 || p.x == 18.5 || p.x == 444.5;
    return found == 3;
  };
  const Outcome outcome = after<Points>(reducing::drop_elements, "convex_hull", {points}, holds);
  CHECK(outcome.better);
  CHECK(unpacked<Points>(outcome.question) == Points{{points[17], points[18], points[444]}});
  CHECK(outcome.candidates < 200);  // of 2^500
}

TEST_CASE("reduce: numbers become 0, small, short in decimal or in binary, whichever holds") {
  using Question4 = std::tuple<Point2d, Point2d, Point2d>;
  const Question4 question{{0.123456, -17.75}, {1234.5678, 1e-9}, {0.7123, 0.3}};
  const auto holds = [](const Question4& q) {
    const auto& [p0, p1, p] = q;
    return p0.y < -3 && p1.x > 1000 && p.x > 0.7 && p.x < 0.74 && p.y > 0.125 && p.y < 0.375;
  };
  const Outcome outcome = after<Question4>(reducing::shorten_numbers, "orientation", question, holds);
  const auto [p0, p1, p] = unpacked<Question4>(outcome.question);
  CHECK((p0 == Point2d{0, -4}));     // the first integer below -3
  CHECK((p1 == Point2d{1024, 0}));   // one bit; one decimal digit, 1000, does not hold
  CHECK((p == Point2d{0.71, 0.3}));  // one digit, 0.7, does not hold
}

TEST_CASE("reduce: a place comes to the origin, and lengths to 1, where that changes nothing that matters") {
  using Question3 = std::tuple<Point2d, Point2d, Point2d>;
  const Question3 question{{1024, 2048}, {1088, 2048}, {1024, 2176}};
  // A triangle of that shape: twice as high as wide.
  const auto holds = [](const Question3& q) {
    const auto& [p0, p1, p] = q;
    return p1.y == p0.y && p.x == p0.x && p1.x > p0.x && p.y - p0.y == 2 * (p1.x - p0.x);
  };
  const Outcome outcome = after<Question3>(reducing::reduce_frame, "orientation", question, holds);
  CHECK(unpacked<Question3>(outcome.question) == Question3{{0, 0}, {1, 0}, {0, 2}});
}

TEST_CASE("reduce: a closed mesh stays closed and becomes a tetrahedron") {
  const Meshd mesh = ball(24);
  REQUIRE(mesh.faces.size() == 1152);
  const auto holds = [](const MeshAndPoint& question) {
    const auto& [left, point] = question;
    return farthest(left) > 0.99 && robust::point_in_polyhedron(left, point) == Location::inside;
  };
  const Outcome outcome =
      after<MeshAndPoint>(reducing::reduce_meshes, "point_in_polyhedron", {mesh, {0.1, 0.2, 0.3}}, holds);
  const Meshd left = std::get<0>(unpacked<MeshAndPoint>(outcome.question));
  CHECK(left.faces.size() == 4);
  CHECK(left.vertices.size() == 4);
  CHECK(farthest(left) > 0.99);
  CHECK(outcome.candidates < 300);
}

TEST_CASE("reduce: of the parts of a mesh that one stays which matters") {
  const Meshd mesh =
      solids::together(solids::together(ball(6), solids::mapped(ball(6), 1, 5)), solids::mapped(ball(6), 1, 10));
  const auto holds = [](const MeshAndPoint& question) {
    const Meshd& left = std::get<0>(question);
    return std::any_of(left.vertices.begin(), left.vertices.end(),
                       [](const Point3d& p) { return p.z > 5 && p.z < 7; }) &&
           left.faces.size() >= 72 && left.vertices.size() >= 38;
  };
  const Outcome outcome =
      after<MeshAndPoint>(reducing::reduce_meshes, "point_in_polyhedron", {mesh, {0.1, 0.2, 0.3}}, holds);
  const Meshd left = std::get<0>(unpacked<MeshAndPoint>(outcome.question));
  CHECK(left.faces.size() == 72);
  CHECK(left.vertices.size() == 38);
  CHECK(left.vertices[0] == Point3d{5.01, 5.02, 6});
}

TEST_CASE("reduce: of a mesh that need not be closed single faces are left") {
  using OneMesh = std::tuple<Meshd>;
  const auto holds = [](const OneMesh& question) {
    int found = 0;
    const Meshd& mesh = std::get<0>(question);
    for (const Face& face : mesh.faces)
      found += mesh.vertices[face.a].z == 1 || mesh.vertices[face.b].z == -1 || mesh.vertices[face.a].z == -1;
    return found >= 2;
  };
  const Outcome outcome = after<OneMesh>(reducing::reduce_meshes, "polyhedron_complexity", {ball(12)}, holds);
  CHECK(std::get<0>(unpacked<OneMesh>(outcome.question)).faces.size() == 4);  // the contract wants no fewer
}

TEST_CASE("reduce: convex meshes stay convex") {
  const auto holds = [](const MeshAndPoint& question) { return farthest(std::get<0>(question)) > 0.5; };
  const Meshd hull = [] {
    Meshd mesh = ball(8);
    const ConvexHull found = robust::convex_hull(mesh.vertices);
    mesh.faces = *found.faces;
    return mesh;
  }();
  const Outcome outcome =
      after<MeshAndPoint>(reducing::reduce_meshes, "point_in_convex_polyhedron", {hull, {0.1, 0.2, 0.3}}, holds);
  CHECK(std::get<0>(unpacked<MeshAndPoint>(outcome.question)).faces.size() == 4);
}

TEST_CASE("reduce: who refers to an element that goes, goes, and the other places are counted anew") {
  const Operation& operation = *find_operation("simultaneous_collisions");
  const Question question = operation.parse(parse_line(
      R"({"bodies":[{"inverse_mass":1,"velocity":[1,0,0]},{"inverse_mass":1,"velocity":[2,0,0]},)"
      R"({"inverse_mass":1,"velocity":[3,0,0]},{"inverse_mass":1,"velocity":[4,0,0]}],"e":1,)"
      R"("contacts":[{"a":0,"b":1,"normal":[1,0,0]},{"a":1,"b":3,"normal":[0,1,0]},{"a":2,"b":3,"normal":[0,0,1]}]})"));
  /// Two bodies of these velocities touch.
  struct Touching final : Interest {
    Look look(std::size_t, const Question& asked) override {
      try {
        find_operation("simultaneous_collisions")->row().robust(asked, 0);
      } catch (const InvalidInput&) {
        return Look::refused;  // a place that is none
      }
      const Json json = find_operation("simultaneous_collisions")->print(asked);
      for (const Json& contact : json["contacts"]) {
        const Json &a = json["bodies"][contact["a"].get<std::size_t>()],
                   &b = json["bodies"][contact["b"].get<std::size_t>()];
        if (a["velocity"][0] == 2 && b["velocity"][0] == 4) return Look::holds;
      }
      return Look::fails;
    }
  } touching;
  Search search(operation, question, touching, {});
  CHECK(reducing::drop_elements(search));
  CHECK(one_line(operation.print(search.best())) ==
        R"({"bodies":[{"inverse_mass":1,"velocity":[2,0,0]},{"inverse_mass":1,"velocity":[4,0,0]}],)"
        R"("contacts":[{"a":0,"b":1,"normal":[0,1,0]}],"e":1})");
}

TEST_CASE("reduce: what is found does not depend on the jobs") {
  const auto holds = [](const MeshAndPoint& question) {
    const Meshd& mesh = std::get<0>(question);
    return farthest(mesh) > 0.6 && std::get<1>(question).x > 0.05 && mesh.vertices[mesh.faces[0].a].z < 0.9;
  };
  Meshd mesh = ball(12);
  std::swap(mesh.faces[0], mesh.faces[100]);
  const Operation& operation = *find_operation("point_in_polyhedron");
  Planted<MeshAndPoint> planted(operation, holds);
  const Question question = packed(MeshAndPoint{mesh, {0.1, 0.2, 0.3}});
  std::vector<Reduced> found;
  for (const int jobs : {1, 2, 5}) {
    SearchOptions options;
    options.jobs = jobs;
    found.push_back(reduced(operation, question, planted, options));
    CHECK(found.back().finished);
    CHECK(found.back().question == found.front().question);
    CHECK(found.back().candidates == found.front().candidates);
  }
  CHECK(std::get<0>(unpacked<MeshAndPoint>(found[0].question)).faces.size() == 4);
}

TEST_CASE("reduce: a search that is stopped keeps what it has") {
  const auto always = [](const Points&) { return true; };
  const Operation& operation = *find_operation("convex_hull");
  Planted<Points> planted(operation, always);
  const std::atomic<bool> stop = true;
  SearchOptions options;
  options.stop = &stop;
  const Question question = packed(Points{{{1, 2, 3}, {4, 5, 7}}});
  const Reduced found = reduced(operation, question, planted, options);
  CHECK_FALSE(found.finished);
  CHECK(found.question == question);
  CHECK(found.candidates == 0);
}

TEST_CASE("reduce: lengths become integers, and lists are turned where their order matters") {
  const auto three_quarters = [](const Points& question) {
    int exponent = 0;
    return std::frexp(std::get<0>(question)[0].x, &exponent) == 0.75;
  };
  const Outcome scaled =
      after<Points>(reducing::reduce_frame, "convex_hull", {{{0.75, 0, 0}, {0, 0, 0}}}, three_quarters);
  CHECK(unpacked<Points>(scaled.question) == Points{{{3, 0, 0}, {0, 0, 0}}});
  // 2, 1, 3, 4 around a circle, whichever way round: 1, 2, 4, 3 is the first of these.
  const auto around = [](const Points& question) {
    const std::vector<Point3d>& points = std::get<0>(question);
    const auto at = [&](double x) {
      return std::find_if(points.begin(), points.end(), [x](const Point3d& p) { return p.x == x; }) - points.begin();
    };
    const auto neighbours = [&](double a, double b) { return std::abs(at(a) - at(b)) % 2 == 1; };
    return points.size() == 4 && std::max({at(1), at(2), at(3), at(4)}) < 4 && neighbours(2, 1) && neighbours(1, 3) &&
           neighbours(3, 4) && neighbours(4, 2);
  };
  const Outcome turned =
      after<Points>(reducing::reduce_frame, "convex_hull", {{{2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}}}, around);
  CHECK(unpacked<Points>(turned.question) == Points{{{1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {3, 0, 0}}});
}

TEST_CASE("reduce: numbers that have to be equal become shorter together") {
  using Question3 = std::tuple<Point2d, Point2d, Point2d>;
  const auto equal = [](const Question3& q) {
    const auto& [p0, p1, p] = q;
    return p0.x == p1.x && p0.x > 5.25 && p.y == 9.7;
  };
  const Outcome outcome =
      after<Question3>(reducing::shorten_numbers, "orientation", {{17.3, 1}, {17.3, 0}, {0, 9.7}}, equal);
  CHECK(unpacked<Question3>(outcome.question) == Question3{{6, 1}, {6, 0}, {0, 9.7}});
}

TEST_CASE("reduce: a question of ordinary size is shorter than one of extreme size") {
  const Operation& operation = *find_operation("orientation");
  CHECK(shorter(operation, {{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, {}}, {{1e-200, 0, 0, 0, 0, 0}, {}}));
  CHECK_FALSE(shorter(operation, {{1e-200, 0, 0, 0, 0, 0}, {}}, {{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, {}}));
}

TEST_CASE("reduce: a question gets no degenerate feature that it did not have, unless that is allowed") {
  const Operation& operation = *find_operation("orientation");
  using Question3 = std::tuple<Point2d, Point2d, Point2d>;
  Planted<Question3> always(operation, [](const Question3&) { return true; });
  SearchOptions options;
  const Question question = packed(Question3{{0.5, 0.25}, {3.5, 1.25}, {1, 7}});
  const auto side = [&] {
    return operation.row().robust(reduced(operation, question, always, options).question, 0).words;
  };
  CHECK(side() != std::vector<Word>{1});  // left, on, right
  options.allow_degenerate = true;
  CHECK(side() == std::vector<Word>{1});
}

TEST_CASE("reduce: of three faces that merging makes equal one stays") {
  // 3, 4 and 5 become 2.
  const reducing::FacesOfMesh fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {0, 4, 0}},
                                  {{0, 1, 3}, {1, 0, 4}, {0, 1, 5}}};
  const reducing::FacesOfMesh one = reducing::merged(fan, {0, 1, 2, 2, 2, 2});
  CHECK(one.faces.size() == 1);
  CHECK(one.vertices.size() == 3);
  CHECK(reducing::merged(fan, {0, 1, 2, 2, 2, 5}).faces == std::vector<meshes::Corners>{{0, 1, 3}});  // 2 stays
}

TEST_CASE("reduce: a vertex that is dropped moves the indices of those behind it alone") {
  const reducing::FacesOfMesh mesh{{{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 3}}};
  const reducing::FacesOfMesh left = reducing::without_vertices(mesh, {false, true, false, false});
  CHECK(left.vertices == std::vector<Point3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(left.faces == std::vector<meshes::Corners>{{0, 1, 2}});
}

TEST_CASE("reduce --until: a question outside the contract is not asked, unless that is allowed") {
  const Operation& operation = *find_operation("convex_hull");
  const Question none = operation.parse_any(parse_line(R"({"points":[]})"));
  CHECK(Until(operation, "true", 10, false).look(0, none) == Look::refused);
  CHECK(Until(operation, "true", 10, true).look(0, none) == Look::holds);
  CHECK(Until(operation, "exit 10", 10, true).look(0, none) == Look::fails);
}

TEST_CASE("reduce: complaints are the same whatever numbers they name; exit codes and signals are not") {
  CHECK(reason_of("vertex 12 of 400: no face") == reason_of("vertex 7 of 9: no face"));
  CHECK(reason_of("vertex 12 of 400: no face") != reason_of("vertex 12 of 400: no edge"));
  CHECK(reason_of("exit code 1: out of memory") == reason_of("exit code 1: KeyError: 5"));
  CHECK(reason_of("exit code 1") != reason_of("exit code 2"));
  CHECK(reason_of("signal 6 (Aborted)") != reason_of("signal 11 (Segmentation fault)"));
}

TEST_CASE("reduce: a finding stays the same answer to the same truth, unless any will do") {
  const Operation& operation = *find_operation("orientation");
  /// Says `left` of everything.
  struct Left final : Respondent {
    Declaration declared{"left", Declaration::Boundary::closed, false, 0};
    const Declaration& declaration() const override { return declared; }
    Reply reply(std::size_t, const Operation&, const Question&) override {
      Reply reply;
      reply.answer = parse_line(R"({"side":"left"})");
      return reply;
    }
    Judgement judgement(const Reply& reply, const Examination& examination) const override {
      return examination.judge_engine(reply.answer, declared);
    }
  } left;
  const Question on{{0, 0, 1, 0, 2, 0}, {}}, to_the_right{{0, 0, 1, 0, 0, -1}, {}}, to_the_left{{0, 0, 1, 0, 0, 1}, {}};
  for (const bool any_answer : {false, true}) {
    SameFinding same(operation, left, {any_answer, false});
    CHECK(same.begin(to_the_left) == "left is right on it");
    REQUIRE(same.begin(on).empty());
    CHECK(same.look(0, {{0, 0, 3, 3, 5, 5}, {}}) == Look::holds);
    CHECK(same.look(0, to_the_left) == Look::fails);
    CHECK(same.look(0, to_the_right) == (any_answer ? Look::holds : Look::fails));
    // Nearer to the line than the formula's rounding, where the cause is another.
    REQUIRE(same.begin(to_the_right).empty());
    CHECK(same.look(0, {{-1, 0, 0x1p53 - 1, 0x1p53, 0x1p53, 0x1p53}, {}}) == Look::fails);
  }
}

}  // namespace touchstone::proptests::reducing_passes_tests
