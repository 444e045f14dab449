// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/protocol.h"
#include "catalogue/rows/mixed/convex_distance.h"
#include "catalogue/rows/mixed/segment_segment_distance.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"
#include "proptests/infrastructure/judge/usual_formulas.h"
#include "report/screen/table.h"

/// Of several pairs of points that are as near as any an engine may name any, unless it declares the contract's.
namespace touchstone::proptests::nearest_pairs_tests {
namespace {

namespace rows = catalogue::rows;
using Nearest = Declaration::Nearest;

/// A question by hand.
struct Asked {
  const char *operation, *question;

  Judgement judge(const std::string& answer, Nearest nearest = Nearest::any) const {
    const Operation& asked = *find_operation(operation);
    Declaration declaration{"by hand"};
    declaration.nearest = nearest;
    return asked.examine(asked.parse(parse_line(question)))->judge_engine(parse_line(answer), declaration);
  }
  Verdict says(const std::string& answer) const { return judge(answer).verdict; }
};
std::string pair(const std::string& on_a, const std::string& on_b, const std::string& square = "1",
                 const std::string& distance = "1") {
  return R"({"on_a":)" + on_a + R"(,"on_b":)" + on_b + R"(,"squared_distance":)" + square + R"(,"distance":)" +
         distance + "}";
}

/// Two cubes of size 4, one 2 above the other and 2 aside along x.
constexpr const char* cubes =
    R"({"a":{"vertices":[[0,0,0],[4,0,0],[4,4,0],[0,4,0],[0,0,4],[4,0,4],[4,4,4],[0,4,4]],"faces":)"
    R"([[0,3,2,1],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]},)"
    R"("b":{"vertices":[[2,0,6],[6,0,6],[6,4,6],[2,4,6],[2,0,10],[6,0,10],[6,4,10],[2,4,10]],"faces":)"
    R"([[0,3,2,1],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]}})";
std::string apart(const std::string& on_a, const std::string& on_b) {
  return R"({"relation":"apart","on_a":)" + on_a + R"(,"on_b":)" + on_b + R"(,"squared_distance":4,"distance":2})";
}

/// In the middle of what is as near, where segments are parallel.
constexpr auto in_the_middle = [](const auto& a, const auto& b) {
  auto answer = robust::segment_segment_distance(a, b);
  const auto swapped = robust::segment_segment_distance({a.b, a.a}, b);
  answer.on_a = answer.on_a + 0.5 * (swapped.on_a - answer.on_a);
  answer.on_b = answer.on_b + 0.5 * (swapped.on_b - answer.on_b);
  return std::variant<ClosestPair2<double>, ClosestPair3<double>>(answer);
};

}  // namespace

TEST_CASE("nearest pairs: of parallel segments any pair across is right, and no other") {
  const Asked parallel{"segment_segment_distance", R"({"a":[[0,0],[4,0]],"b":[[1,1],[9,1]]})"};
  CHECK(parallel.says(pair("[1,0]", "[1,1]")) == Verdict::agree);
  CHECK_FALSE(parallel.judge(pair("[1,0]", "[1,1]")).breaks_tie);
  const Judgement other = parallel.judge(pair("[3,0]", "[3,1]"));
  CHECK(other.verdict == Verdict::agree);
  CHECK(other.breaks_tie);
  CHECK(parallel.says(pair("[4,0]", "[4,1]")) == Verdict::agree);
  CHECK(parallel.says(pair("[3,0]", "[2,1]")) == Verdict::algorithm);
  CHECK(parallel.says(pair("[5,0]", "[5,1]")) == Verdict::algorithm);
  CHECK(parallel.says(pair("[0,0]", "[0,1]")) == Verdict::algorithm);
  CHECK(parallel.says(pair("[3,0.5]", "[3,1]")) == Verdict::algorithm);
  CHECK(parallel.says(pair("[3,0]", "[3,1]", "2")) == Verdict::algorithm);
  CHECK(parallel.says(R"({"on_a":[3,0],"on_b":[3,1]})") == Verdict::agree);
  CHECK(parallel.says(R"({"on_a":[3,0],"on_b":[2,1]})") == Verdict::algorithm);
}

TEST_CASE("nearest pairs: segments on one line have any common point, segments that are not parallel one pair") {
  const Asked collinear{"segment_segment_distance", R"({"a":[[0,0,0],[4,4,4]],"b":[[6,6,6],[2,2,2]]})"};
  CHECK(collinear.says(pair("[3,3,3]", "[3,3,3]", "0", "0")) == Verdict::agree);
  CHECK(collinear.says(pair("[1,1,1]", "[1,1,1]", "0", "0")) == Verdict::algorithm);
  const Asked crossed{"segment_segment_distance", R"({"a":[[0,0,0],[4,0,0]],"b":[[1,-1,1],[1,1,1]]})"};
  CHECK(crossed.says(pair("[1,0,0]", "[1,0,1]")) == Verdict::agree);
  CHECK(crossed.says(pair("[2,0,0]", "[2,0,1]")) == Verdict::algorithm);
}

TEST_CASE("nearest pairs: of two cubes any points of the faces that lie across are right") {
  const Asked faces{"convex_distance", cubes};
  CHECK(faces.judge(apart("[3,1,4]", "[3,1,6]")).breaks_tie);
  for (const char* const right : {"[2,0,", "[4,4,", "[3,1,", "[3.5,2.25,"})
    CHECK(faces.says(apart(std::string(right) + "4]", std::string(right) + "6]")) == Verdict::agree);
  for (const char* const wrong : {"[1,0,", "[4,5,", "[5,1,"})
    CHECK(faces.says(apart(std::string(wrong) + "4]", std::string(wrong) + "6]")) == Verdict::algorithm);
  CHECK(faces.says(apart("[3,1,4]", "[3,2,6]")) == Verdict::algorithm);
  CHECK(faces.says(apart("[3,1,3]", "[3,1,5]")) == Verdict::algorithm);
}

TEST_CASE("nearest pairs: who declares that it names the contract's pair is wrong with another, and is told so") {
  const Asked parallel{"segment_segment_distance", R"({"a":[[0,0],[4,0]],"b":[[1,1],[9,1]]})"};
  CHECK(parallel.judge(pair("[1,0]", "[1,1]"), Nearest::named).verdict == Verdict::agree);
  const Judgement other = parallel.judge(pair("[3,0]", "[3,1]"), Nearest::named);
  CHECK(other.verdict == Verdict::algorithm);
  CHECK(other.remark == "other points than the contract names, and as near");
  const Judgement wrong = parallel.judge(pair("[3,0]", "[2,1]"), Nearest::named);
  CHECK(wrong.verdict == Verdict::algorithm);
  CHECK(wrong.remark.empty());
}

TEST_CASE("nearest pairs: words and indices are those of the solution that an engine names, not of the contract's") {
  // The middle of a cube is as near to each face.
  const Asked middle{"point_mesh_distance",
                     R"({"point":[0.5,0.5,0.5],"mesh":{"vertices":[[0,0,0],[0,0,1],[0,1,0],[0,1,1],[1,0,0],[1,0,1],)"
                     R"([1,1,0],[1,1,1]],"faces":[[0,1,3,2],[4,6,7,5],[0,4,5,1],[2,3,7,6],[0,2,6,4],[1,5,7,3]]}})"};
  const auto nearest = [](const std::string& point, const std::string& face, const std::string& part = "inside") {
    return R"({"location":"inside","nearest":{"point":)" + point + R"(,"face":)" + face + R"(,"part":")" + part +
           R"("},"squared_distance":0.25,"distance":0.5,"signed_distance":-0.5})";
  };
  CHECK(middle.says(nearest("[0,0.5,0.5]", "0")) == Verdict::agree);
  const Judgement other = middle.judge(nearest("[1,0.5,0.5]", "1"));
  CHECK(other.verdict == Verdict::agree);
  CHECK(other.breaks_tie);
  CHECK(middle.says(nearest("[0.5,0.5,1]", "5")) == Verdict::agree);
  CHECK(middle.judge(nearest("[1,0.5,0.5]", "1"), Nearest::named).verdict == Verdict::algorithm);
  CHECK(middle.says(nearest("[1,0.5,0.5]", "0")) == Verdict::algorithm);
  CHECK(middle.says(nearest("[1,0.5,0.5]", "5")) == Verdict::algorithm);
  CHECK(middle.says(nearest("[1,0.5,0.5]", "1", "edge")) == Verdict::algorithm);
  // Cubes that touch at a vertex can part in any direction between three faces.
  const Asked cornered{"penetration",
                       R"({"a":{"vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,1],[0,1,1]],"faces":)"
                       R"([[0,3,2,1],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]},)"
                       R"("b":{"vertices":[[1,1,1],[2,1,1],[2,2,1],[1,2,1],[1,1,2],[2,1,2],[2,2,2],[1,2,2]],"faces":)"
                       R"([[0,3,2,1],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]},"radius_a":0,"radius_b":0})"};
  const auto parted = [](const std::string& direction, const std::string& part) {
    return R"({"contact":"touching","depth":0,"direction":)" + direction +
           R"(,"translation":[0,0,0],"feature":{"a":")" + part + R"(","b":")" + part + R"("}})";
  };
  CHECK(cornered.says(parted("[-0.6,-0.8,0]", "edge")) == Verdict::agree);
  CHECK(cornered.says(parted("[0,0,-1]", "face")) == Verdict::agree);
  CHECK(cornered.says(parted("[-0.6,-0.8,0]", "face")) != Verdict::agree);
  CHECK(cornered.says(parted("[0,0,-1]", "edge")) != Verdict::agree);
  // Segments that cross part along both normals of their plane, those on one line in all directions across it.
  const Asked crossing{"penetration",
                       R"({"a":{"vertices":[[-5,0,0],[5,0,0]],"faces":[]},"b":{"vertices":[[0,-3,-4],[0,3,4]],)"
                       R"("faces":[]},"radius_a":1,"radius_b":0})"},
      in_line{"penetration", R"({"a":{"vertices":[[-5,0,0],[5,0,0]],"faces":[]},"b":{"vertices":[[1,0,0],[9,0,0]],)"
                             R"("faces":[]},"radius_a":1,"radius_b":0})"};
  const auto apart_by_one = [](const std::string& direction) {
    return R"({"contact":"overlapping","depth":1,"direction":)" + direction + R"(,"translation":)" + direction +
           R"(,"feature":{"a":"edge","b":"edge"}})";
  };
  CHECK(crossing.says(apart_by_one("[0,0.8,-0.6]")) == Verdict::agree);
  CHECK(crossing.judge(apart_by_one("[0,-0.8,0.6]")).breaks_tie);
  CHECK(crossing.says(apart_by_one("[0,-0.8,0.6]")) == Verdict::agree);
  CHECK(crossing.says(apart_by_one("[0,1,0]")) != Verdict::agree);
  CHECK(crossing.judge(apart_by_one("[0,-0.8,0.6]"), Nearest::named).verdict == Verdict::algorithm);
  CHECK(in_line.says(apart_by_one("[0,1,0]")) == Verdict::agree);
  CHECK(in_line.says(apart_by_one("[0,-0.6,0.8]")) == Verdict::agree);
  CHECK(in_line.says(apart_by_one("[1,0,0]")) != Verdict::agree);
}

TEST_CASE("nearest pairs: an engine that breaks ties its own way has no findings, and the table says how often") {
  const Tally any = audited<rows::segment_segment_distance>(in_the_middle);
  const Cell total = any.operations[0].total();
  CHECK(total.other_nearest > 20);
  CHECK(total.count(Verdict::algorithm) == 0);
  CHECK_THAT(report::text_table(any, report::Detail::operations),
             ContainsSubstring("other points, as near as the contract's"));
  const Cell named =
      audited<rows::segment_segment_distance>(in_the_middle, {.nearest = Nearest::named}).operations[0].total();
  CHECK(named.other_nearest == 0);
  CHECK(named.count(Verdict::algorithm) >= total.other_nearest);
}

TEST_CASE("nearest pairs: the declaration is read, written, and refused where it is no word of it") {
  const auto declared = [](const std::string& field) {
    return read_hello(R"({"engine":"e","ops":[])" + field + "}").declaration.nearest;
  };
  CHECK(declared("") == Nearest::any);
  CHECK(declared(R"(,"nearest":"any")") == Nearest::any);
  CHECK(declared(R"(,"nearest":"named")") == Nearest::named);
  CHECK_THROWS_WITH(declared(R"(,"nearest":"first")"), ContainsSubstring("nearest: expected one of any, named"));
  Hello hello;
  hello.declaration.engine = "e", hello.declaration.nearest = Nearest::named;
  CHECK(read_hello(written_hello(hello)).declaration.nearest == Nearest::named);
}

}  // namespace touchstone::proptests::nearest_pairs_tests
