// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/by_hand.h"
#include "proptests/mandatory_number.h"
#include "proptests/uses.h"

/// What the judge says of answers made by hand.
namespace touchstone::proptests::verdicts_tests {
namespace {

constexpr const char* left = R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})";
constexpr const char* nearly_on = R"({"p0":[0,0],"p1":[1,10],"p":[0.1,1]})";  // right, by 2^-54
constexpr const char* tee = R"({"a":[[0,0],[4,0]],"b":[[1,0],[1,5]]})";
constexpr const char* cross = R"({"a":[[0,0],[4,4]],"b":[[0,4],[4,0]]})";
constexpr const char* overlapping = R"({"a":[[0,0],[4,4]],"b":[[2,2],[6,6]]})";

}  // namespace

TEST_CASE("verdicts: a decision is right, wrong by algorithm, or wrong where the formula rounds") {
  const Case certain{"orientation", left}, near{"orientation", nearly_on};
  CHECK(certain.says(R"({"side":"left"})") == "agree");
  CHECK(certain.says(R"({"side":"on"})") == "algorithm");
  CHECK(certain.says(R"({"side":"right"})") == "algorithm");
  CHECK(near.says(R"({"side":"right"})") == "agree");
  CHECK(near.says(R"({"side":"on"})") == "rounding");
  CHECK(near.says(R"({"side":"left"})") == "rounding");
}

TEST_CASE(
    "verdicts: beside a touch by less than the input's last places, rounding may be to blame whatever the formula") {
  // The formula asks for the contact at the start by the root; squares, which round to 0 here, do so too.
  const Case start{"swept_sphere_sphere",
                   R"({"a":{"center":[-1.8,0.6,0.1],"radius":1.9},"b":{"center":[0,0,0],"radius":0},)"
                   R"("velocity_a":[-1.6,-2.5,1.4],"velocity_b":[0,0,0]})"};
  CHECK(start.says(R"({"relation":"never"})") == "agree");
  CHECK(start.says(R"({"relation":"hit","t":0})") == "rounding");
  const Case boxes{"aabb_aabb", R"({"a":{"min":[0,0],"max":[0.3,1]},"b":{"min":[0.30000000000000004,0],"max":[1,1]}})"};
  CHECK(boxes.says(R"({"contact":"touching"})") == "rounding");
  const Case apart{"aabb_aabb", R"({"a":{"min":[0,0],"max":[0.3,1]},"b":{"min":[0.300000001,0],"max":[1,1]}})"};
  CHECK(apart.says(R"({"contact":"touching"})") == "algorithm");
}

TEST_CASE("verdicts: on a touch, rounding is to blame only where the plain formula in the same number type fails too") {
  // Both products of the formula are rounded, to the same double: it comes out right.
  const Case right{"orientation", R"({"p0":[0,0],"p1":[0.1,0.1],"p":[0.3,0.3]})"};
  CHECK(right.says(R"({"side":"on"})") == "agree");
  CHECK(right.says(R"({"side":"left"})") == "algorithm");
  CHECK(right.says(R"({"side":"right"})") == "algorithm");
  // On the line y = 5 x; the differences are rounded, and the formula says right.
  const Case wrong{"orientation", R"({"p0":[4,20],"p1":["-0x1.7fffffffffffcp+0","-0x1.dfffffffffffbp+2"],)"
                                  R"("p":["-0x1.0000000000008p-1","-0x1.400000000000ap+1"]})"};
  CHECK(wrong.says(R"({"side":"on"})") == "agree");
  CHECK(wrong.says(R"({"side":"left"})") == "rounding");
  CHECK(wrong.says(R"({"side":"right"})") == "rounding");
  // No touch, but nearer than the last places: other formulas round there, whatever this one does.
  const Case beside{"orientation", R"({"p0":[0,0],"p1":[0.1,0.1],"p":[0.3,0.30000000000000004]})"};
  CHECK(beside.says(R"({"side":"on"})") == "rounding");
  // In float the formula is as right as in double, so a float has no better excuse.
  const Case single{"orientation", R"({"p0":[0,0],"p1":[0.5,0.5],"p":[0.25,0.25]})", Boundary::closed, 0, true};
  CHECK(single.says(R"({"side":"left"})") == "algorithm");
}

TEST_CASE("verdicts: rounding is by cancellation, or by overflow and underflow") {
  const auto out = [](const char* question, const char* side, bool binary32 = false) {
    const Case asked{"orientation", question, Boundary::closed, 0, binary32};
    const Judgement foreign = asked.judge(std::string(R"({"side":")") + side + "\"}");
    const Operation& operation = *find_operation("orientation");
    const Judgement own = operation.examine(operation.parse(parse_line(question)))->judge_reference(binary32);
    REQUIRE(foreign.verdict == Verdict::rounding);
    CHECK(own.verdict == Verdict::rounding);
    CHECK(own.out_of_range == foreign.out_of_range);
    return foreign.out_of_range;
  };
  CHECK_FALSE(out(nearly_on, "on"));
  // The same, 2^200 times as large: the products are of size 2^400, and nothing leaves the range.
  CHECK_FALSE(out(R"({"p0":[0,0],"p1":["0x1p200","0x1.4p203"],"p":["0x1.999999999999ap196","0x1p200"]})", "on"));
  CHECK(out(R"({"p0":[0,0],"p1":[1e200,1e200],"p":[1e200,2e200]})", "on"));  // inf - inf
  CHECK(out(R"({"p0":[0,0],"p1":[1e-200,0],"p":[0,1e-200]})", "on"));        // 0 - 0
  CHECK(out(R"({"p0":[0,0],"p1":[1e-30,0],"p":[0,1e-30]})", "on", true));
}

TEST_CASE("verdicts: a judgement says in enumerators what was answered, and whether the question is degenerate") {
  const Case touching{"segment_segment", tee}, crossing{"segment_segment", cross};
  CHECK(touching.judge(R"({"relation":"point"})").said == "point");
  CHECK(touching.judge(R"({"relation":"overlap"})").said == "overlap");
  CHECK(touching.judge("false").said == "false");
  CHECK(touching.judge(R"({"relation":"nowhere"})").said.empty());
  CHECK(touching.judge("true").degenerate);
  CHECK(touching.judge(R"({"relation":"disjoint"})").degenerate);
  CHECK_FALSE(crossing.judge(R"({"relation":"disjoint"})").degenerate);
  const Operation& ring = *find_operation("polygon_convexity");
  const auto examined = ring.examine(ring.parse(parse_line(R"({"polygon":[[0,0],[1,0],[0,1]]})")));
  CHECK(examined->judge_reference().said == examined->outcome());
  CHECK(examined->judge_robust().said == examined->outcome());
  const Case at{"line_point_at", R"({"line":{"origin":[1,2],"direction":[3,4]},"t":2})"};
  CHECK(at.judge(R"({"point":[7,10]})").said == "value");
}

TEST_CASE("verdicts: of a list that must cover, what only touches is a convention, and what is no pair is no answer") {
  const char* const chain =
      R"({"boxes":[{"min":[0,0,0],"max":[1,1,1]},{"min":[1,0,0],"max":[2,1,1]},{"min":[0,0,0],"max":[1,1,1]}]})";
  const Case closed{"all_pairs", chain, Boundary::closed}, open{"all_pairs", chain, Boundary::open};
  CHECK(open.says(R"({"pairs":[[0,2]]})") == "convention");
  CHECK(closed.says(R"({"pairs":[[0,2]]})") == "algorithm");
  CHECK(open.says(R"({"pairs":[[0,1]]})") == "algorithm");
  CHECK(open.touch(R"({"pairs":[[0,1],[0,2],[1,2]]})") == 1);
  CHECK(closed.judge(R"({"pairs":[[0,1],[0,2],[2,0],[1,2]]})").surplus == 1);
  CHECK(closed.judge(R"({"pairs":[[0,1],[0,2],[1,2],[1,3]]})").remark ==
        "answer.pairs[3]: different places in the list");
  CHECK(closed.says(R"({"pairs":[[0,1],[0,2],[1,2],[1,1]]})") == "invalid");
}

TEST_CASE("verdicts: what an engine lists beyond the truth is wrong where it declares exact pairs, else counted") {
  const Operation& pairs = *find_operation("all_pairs");
  const auto judged = [&](const char* question, const char* answer, Declaration::Pairs promised) {
    Declaration declaration{"by hand", Boundary::closed};
    declaration.pairs = promised;
    return pairs.examine(pairs.parse(parse_line(question)))->judge_engine(parse_line(answer), declaration);
  };
  constexpr auto exact = Declaration::Pairs::exact, conservative = Declaration::Pairs::conservative;
  const char* const far = R"({"spheres":[{"center":[0,0,0],"radius":1},{"center":[1,0,0],"radius":1},)"
                          R"({"center":[9,0,0],"radius":1},{"center":[0,9,0],"radius":1}]})";
  const char *const everything = R"({"pairs":[[0,1],[0,2],[0,3],[1,2],[1,3],[2,3]]})", *const right =
                                                                                           R"({"pairs":[[0,1]]})";
  const Judgement counted = judged(far, everything, conservative), wrong = judged(far, everything, exact);
  CHECK(counted.verdict == Verdict::agree);
  CHECK(counted.surplus == 5);
  CHECK(counted.apart == 5);
  CHECK(wrong.verdict == Verdict::algorithm);
  CHECK(wrong.remark == "it lists what does not meet");
  CHECK(wrong.surplus == 5);
  CHECK(judged(far, right, exact).verdict == Verdict::agree);
  CHECK(judged(far, right, exact).apart == 5);
  CHECK(judged(far, R"({"pairs":[]})", exact).verdict == Verdict::algorithm);
  // As doubles, 0.5 + 0.6 = 1.1 - 2^-53, which rounds to 1.1.
  const char* const near = R"({"spheres":[{"center":[0,0,0],"radius":0.5},{"center":[1.1,0,0],"radius":0.6}]})";
  CHECK(judged(near, right, exact).verdict == Verdict::rounding);
  CHECK(judged(near, right, conservative).verdict == Verdict::agree);
}

TEST_CASE("verdicts: where the formula divides by an exact 0, nothing was rounded") {
  const Case apart{"point_on_segment", R"({"point":[1,1],"segment":[[0,0],[0,0]]})"},
      inside{"point_on_segment", R"({"point":[0,1],"segment":[[0,0],[0,2]]})"};
  CHECK(apart.says(R"({"relation":"off"})") == "agree");
  CHECK(apart.says(R"({"relation":"on"})") == "algorithm");
  CHECK(inside.says(R"({"relation":"off"})") == "algorithm");
}

TEST_CASE("verdicts: words that are no JSON numbers lose the answer they stand in and nothing else") {
  const Case at{"line_point_at", R"({"line":{"origin":[1,2],"direction":[3,4]},"t":2})"};
  for (const char* numbers : {"[NaN,10]", "[7,Infinity]", "[-Infinity,10]", "[-1e999,10]", R"(["nan",10])"}) {
    const Judgement judged = at.judge(R"({"point":)" + std::string(numbers) + "}");
    CHECK(name_of(judged.verdict) == std::string("invalid"));
    CHECK(judged.remark == "NaN or infinity where the truth is finite");
  }
  for (const char* numbers : {"[0x10,1]", "[01,1]", "[1.5.2,1]", "[--1,1]", "[+1,1]", "[.5,1]", "[Nan,1]"}) {
    const std::string typed = numbers, first = typed.substr(1, typed.find(',') - 1);
    const Judgement judged = at.judge(R"({"point":)" + typed + "}");
    CHECK(name_of(judged.verdict) == std::string("invalid"));
    CHECK(judged.remark == "answer.point[0]: expected a number, got " + first);
  }
  CHECK_THAT(at.judge(R"({"point":[null,1]})").remark, ContainsSubstring(R"(send "nan")"));
}

TEST_CASE("verdicts: a declared tolerance forgives what lies within it, and nothing else") {
  // The margin is an area, 2^-54 = 5.6e-17; the greatest coordinate is 10.
  const auto with = [](double tolerance) {
    return Case{"orientation", nearly_on, Boundary::closed, tolerance}.says(R"({"side":"on"})");
  };
  CHECK(with(0) == "rounding");
  CHECK(with(5e-18) == "rounding");
  CHECK(with(6e-18) == "tolerance");
  CHECK(with(1e-9) == "tolerance");
  CHECK(Case{"orientation", left, Boundary::closed, 1e-9}.says(R"({"side":"on"})") == "algorithm");
  CHECK(Case{"orientation", left, Boundary::closed, 1e-9}.says(R"({"side":"left"})") == "agree");
}

TEST_CASE("verdicts: among coordinates below 1 an area is compared with the tolerance itself") {
  // The margin is 2^-1 * 2^-40.
  const char* const small = R"({"p0":[0,0],"p1":[0.5,0],"p":[0,"0x1p-40"]})";
  const auto with = [&](double tolerance) {
    return Case{"orientation", small, Boundary::closed, tolerance}.says(R"({"side":"on"})");
  };
  CHECK(with(0x1p-41) == "tolerance");
  CHECK(with(0x1.fffffffffffffp-42) == "algorithm");
}

TEST_CASE("verdicts: a binary32 engine is blamed for rounding where binary32 rounds, others only where binary64 does") {
  // 16777215 * 16777213 - 16777214^2 = -1: products of 48 bits.
  Case engine{"orientation", R"({"p0":[0,0],"p1":[16777215,16777214],"p":[16777214,16777213]})"};
  CHECK(engine.says(R"({"side":"right"})") == "agree");
  CHECK(engine.says(R"({"side":"on"})") == "algorithm");
  engine.binary32 = true;
  CHECK(engine.says(R"({"side":"right"})") == "agree");
  CHECK(engine.says(R"({"side":"on"})") == "rounding");
}

TEST_CASE("verdicts: a touch answered as open sets do is a convention, unless closed sets were declared") {
  const Case closed{"segment_segment", tee, Boundary::closed}, open{"segment_segment", tee, Boundary::open},
      unspecified{"segment_segment", tee};
  const std::string disjoint = R"({"relation":"disjoint"})", point = R"({"relation":"point"})",
                    overlap = R"({"relation":"overlap"})";
  CHECK(closed.says(disjoint) == "algorithm");
  CHECK(open.says(disjoint) == "convention");
  CHECK(unspecified.says(disjoint) == "convention");
  for (const Case& engine : {closed, open, unspecified}) {
    CHECK(engine.says(point) == "agree");
    CHECK(engine.says(overlap) == "algorithm");
    CHECK(engine.touch(point) == 1);
    CHECK(engine.touch(disjoint) == -1);
    CHECK(engine.touch(overlap) == 0);
  }
  const Case crossing{"segment_segment", cross, Boundary::open};
  CHECK(crossing.says(disjoint) == "algorithm");  // no touch, no excuse
  CHECK(crossing.touch(point) == 0);
  CHECK(Case{"implicit_circle", R"({"circle":{"center":[0,0],"radius":5},"point":[3,4]})", Boundary::open}.says(
            R"({"location":"outside"})") == "convention");
  CHECK(Case{"implicit_circle", R"({"circle":{"center":[0,0],"radius":5},"point":[3,4]})", Boundary::open}.says(
            R"({"location":"inside"})") == "algorithm");
}

TEST_CASE("verdicts: plain true and false answer whether they meet") {
  const Case closed{"segment_segment", tee, Boundary::closed}, open{"segment_segment", tee, Boundary::open},
      overlap{"segment_segment", overlapping, Boundary::open};
  CHECK(closed.says("true") == "agree");
  CHECK(closed.says("false") == "algorithm");
  CHECK(open.says("true") == "agree");
  CHECK(open.says("false") == "convention");
  CHECK(open.touch("true") == 1);
  CHECK(open.touch("false") == -1);
  CHECK(overlap.says("true") == "agree");
  CHECK(overlap.says("false") == "algorithm");
  CHECK(Case{"orientation", left}.says("true") == "invalid");
  CHECK(Case{"line_point_at", R"({"line":{"origin":[1,2],"direction":[3,4]},"t":2})"}.says("false") == "invalid");
}

TEST_CASE("verdicts: numbers are held to the stated bound; an engine may leave them out") {
  const Case at{"line_point_at", R"({"line":{"origin":[1,2],"direction":[3,4]},"t":2})"};  // (7, 10), bound 2
  const Judgement exact = at.judge(R"({"point":[7,10]})"),
                  one_off = at.judge(R"({"point":["0x1.c000000000001p+2",10]})");
  CHECK(name_of(exact.verdict) == std::string("agree"));
  CHECK(exact.ulps == 0);
  CHECK(name_of(one_off.verdict) == std::string("agree"));
  CHECK(one_off.ulps == 1);
  CHECK(at.says(R"({"point":["0x1.c000000000002p+2",10]})") == "agree");
  CHECK(at.judge(R"({"point":["0x1.c000000000003p+2",10]})").ulps == 3);
  CHECK(at.says(R"({"point":["0x1.c000000000003p+2",10]})") == "inexact");
  CHECK(at.says(R"({"point":[7,11]})") == "algorithm");

  const Case touch{"segment_segment", tee, Boundary::closed};
  CHECK(touch.says(R"({"relation":"point","ta":0.25,"tb":0,"point":[1,0]})") == "agree");
  CHECK(touch.says(R"({"relation":"point","ta":0.25})") == "agree");
  CHECK(touch.says(R"({"relation":"point","ta":0.26,"tb":0,"point":[1,0]})") == "algorithm");
  CHECK(touch.says(R"({"relation":"disjoint","ta":0.25})") == "algorithm");
}

TEST_CASE("verdicts: NaN, an infinity where the truth is finite, and what is no valid answer are invalid") {
  const Case at{"line_point_at", R"({"line":{"origin":[1,2],"direction":[3,4]},"t":2})"};
  CHECK(at.says(R"({"point":["nan",10]})") == "invalid");
  CHECK(at.says(R"({"point":[7,"-inf"]})") == "invalid");
  CHECK(at.says(R"({"point":[7,1e999]})") == "invalid");
  CHECK(at.says(R"({"point":[7]})") == "invalid");
  CHECK(at.says(R"({"point":[7,10,0]})") == "invalid");
  CHECK(at.says(R"({"point":[7,"ten"]})") == "invalid");
  CHECK(at.says("{}") == "invalid");
  CHECK(at.says("[7,10]") == "invalid");
  CHECK(at.says("null") == "invalid");
  const Case beyond{"line_point_at", R"({"line":{"origin":[1e308,0],"direction":[1e308,1]},"t":1})"};
  CHECK(beyond.says(R"({"point":["inf",1]})") == "agree");
  CHECK(beyond.says(R"({"point":["-inf",1]})") == "invalid");

  const Case side{"orientation", left};
  CHECK(side.judge(R"({"side":"up"})").remark == R"(answer.side: expected one of left, on, right, got "up")");
  CHECK(side.judge(R"({"side":"left","sure":true})").remark == "answer.sure: no such field; expected side");
  CHECK(side.judge("{}").remark == "answer.side: missing");
  for (const char* answer :
       {R"({"side":"up"})", R"({"side":"left","sure":true})", "{}", "[]", "null", "1", "\"left\""}) {
    INFO(answer);
    CHECK(side.says(answer) == "invalid");
  }
}

TEST_CASE("verdicts: numbers of a binary32 engine are held against binary32") {
  // 3 * 0.1f is no float: the nearest is 0.3f + 1 unit, 0.30000001192092896.
  Case engine{"line_point_at", R"({"line":{"origin":[0,0],"direction":["0x1.99999ap-4",1]},"t":3})"};
  const std::string answer = R"({"point":["0x1.333334p-2",3]})";
  CHECK(engine.says(answer) == "algorithm");  // seven digits, of an engine that says it works in double
  engine.binary32 = true;
  CHECK(engine.judge(answer).ulps == 0);
  CHECK(engine.says(answer) == "agree");
}

TEST_CASE("verdicts: the slide's formula is judged by running it again in exact arithmetic") {
  const auto reference = [](const char* operation, const char* question, bool binary32 = false) {
    const Operation& asked = *find_operation(operation);
    return std::string(name_of(asked.examine(asked.parse(parse_line(question)))->judge_reference(binary32).verdict));
  };
  CHECK(reference("orientation", left) == "agree");
  CHECK(reference("orientation", nearly_on) == "rounding");
  CHECK(reference("segment_segment", overlapping) == "algorithm");
  CHECK(reference("segment_segment", tee) == "agree");
  CHECK(reference("line_point_at", R"({"line":{"origin":[-1e308,0],"direction":[1e308,1]},"t":2})") == "invalid");
  // 2^24 + 1 is a double, and no float.
  CHECK(reference("explicit_line", R"({"slope":1,"intercept":16777216,"point":[1,16777217]})") == "agree");
  CHECK(reference("explicit_line", R"({"slope":1,"intercept":16777216,"point":[1,16777216]})") == "agree");
  CHECK(reference("explicit_line", R"({"slope":1,"intercept":16777216,"point":[1,16777216]})", true) == "rounding");
}

TEST_CASE("verdicts: robust agrees where the formula does not") {
  for (const auto& [operation, question] :
       {std::pair{"orientation", nearly_on}, {"segment_segment", overlapping}, {"segment_segment", tee}}) {
    const Operation& asked = *find_operation(operation);
    CHECK(name_of(asked.examine(asked.parse(parse_line(question)))->judge_robust().verdict) == std::string("agree"));
  }
}

TEST_CASE("verdicts: an engine may leave out every number, also one that is always there, but not the word") {
  const Examination examination(operation_of_row<proptests::mandatory_number>(), {{0, 3}, {}});
  const auto judged = [&](const char* answer) {
    return examination.judge_engine(parse_line(answer), Declaration{"by hand"});
  };
  CHECK(judged(R"({"side":"front","signed_distance":3})").verdict == Verdict::agree);
  CHECK(judged(R"({"side":"front","signed_distance":4})").verdict == Verdict::algorithm);
  CHECK(judged(R"({"side":"front","signed_distance":"nan"})").verdict == Verdict::invalid);
  CHECK(judged(R"({"side":"front"})").verdict == Verdict::agree);
  CHECK(judged(R"({"side":"front"})").ulps == 0);
  CHECK(judged(R"({"side":"back"})").verdict == Verdict::algorithm);
  CHECK(judged(R"({"side":"back","signed_distance":3})").verdict == Verdict::algorithm);
  CHECK(judged(R"({"signed_distance":3})").remark == "answer.side: missing");
  CHECK(judged(R"({"side":"front","distance":3})").verdict == Verdict::invalid);
}

}  // namespace touchstone::proptests::verdicts_tests
