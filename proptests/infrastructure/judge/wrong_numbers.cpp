// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/by_hand.h"

/// What the judge says of numbers made by hand.
namespace touchstone::proptests::wrong_numbers_tests {
namespace {

constexpr const char* overlapping = R"({"a":[[0,0],[4,4]],"b":[[2,2],[6,6]]})";

}  // namespace

TEST_CASE("verdicts: a number is inexact as far as rounding explains it, and wrong without a digit or beyond") {
  // x is 1, between terms of 10^16, of which the last places are 2: the formula answers 0.
  const char* const cancelling = R"({"bodies":[{"mass":1,"velocity":[1e16,0,0]},{"mass":1,"velocity":[1,3,0]},)"
                                 R"({"mass":1,"velocity":[-1e16,0,0]}]})";
  const Case sum{"momentum", cancelling};
  const auto says = [&](const char* x, const char* y = "3") {
    return sum.says(std::string(R"({"momentum":[)") + x + "," + y + ",0]}");
  };
  CHECK(says("1") == "agree");
  CHECK(says("1.25") == "inexact");
  CHECK(says("0.5") == "rounding");
  CHECK(says("0") == "rounding");
  CHECK(says("2") == "rounding");
  CHECK(says("-20") == "rounding");
  CHECK(says("420") == "algorithm");
  CHECK(says("0", "3.001") == "algorithm");  // y is exact in every order
  const Judgement wrong = sum.judge(R"({"momentum":[0,3,0]})");
  REQUIRE(wrong.number);
  CHECK(wrong.number->exact == 1);
  CHECK(wrong.number->answered == 0);
  CHECK_FALSE(wrong.out_of_range);
  CHECK_FALSE(sum.judge(R"({"momentum":[1,3,0]})").number);
  const Operation& momentum = *find_operation("momentum");
  const auto examined = momentum.examine(momentum.parse(parse_line(cancelling)));
  CHECK(examined->judge_reference().verdict == Verdict::rounding);
  CHECK(examined->judge_reference().number->answered == 0);
}

TEST_CASE("verdicts: where the exact number is 0, rounding explains what it may leave behind and no more") {
  // (0.3, -0.6) . (2, 1) is 0, of doubles too; (1, 1, -2) has nothing to round.
  const Case typed{"point_plane", R"({"plane":{"normal":[2,1,0],"offset":0},"point":[0.3,-0.6,0]})"};
  CHECK(typed.says(R"({"side":"on","signed_distance":0})") == "agree");
  CHECK(typed.says(R"({"side":"on","signed_distance":1e-17})") == "inexact");
  CHECK(typed.says(R"({"side":"on","signed_distance":1e-14})") == "algorithm");
  CHECK(typed.says(R"({"side":"front","signed_distance":1e-17})") == "algorithm");  // on a touch, as ever
}

TEST_CASE("verdicts: of a number that leaves the range on the way, overflow is to blame where the formula's does too") {
  // N . N is infinite in double.
  const Case far{"point_plane", R"({"plane":{"normal":[0,"0x1p600",0],"offset":0},"point":[0,3,0]})"};
  CHECK(far.says(R"({"side":"front","signed_distance":3})") == "agree");
  const Judgement lost = far.judge(R"({"side":"front","signed_distance":0})");
  CHECK(lost.verdict == Verdict::rounding);
  CHECK(lost.out_of_range);
  // The sum itself is beyond the range, and the formula says so.
  const Case beyond{"momentum", R"({"bodies":[{"mass":1e300,"velocity":[1e300,0,0]}]})"};
  CHECK(beyond.says(R"({"momentum":["inf",0,0]})") == "agree");
  CHECK(beyond.says(R"({"momentum":[42,0,0]})") == "algorithm");
}

TEST_CASE("verdicts: a number that the formula does not have is held to its digits") {
  // Both lie on one line: the formula finds nothing, and the oracle that they share (2, 2) to (4, 4).
  const Case shared{"segment_segment", overlapping, Boundary::closed};
  const auto says = [&](const char* end) {
    return shared.says(std::string(R"({"relation":"overlap","overlap":[[2,2],[)") + end + "]]}");
  };
  CHECK(says("4,4") == "agree");
  CHECK(says("4.000000000000003,4") == "agree");
  CHECK(says("6,6") == "algorithm");
  // The unit normal is left out by the formula, and is as certain as its normal.
  const Case face{"polygon_normal", R"({"polygon":[[0,0,0],[3,0,0],[0,2,0]]})"};
  CHECK(face.says(R"({"class":"proper","normal":[0,0,6],"unit":[0,0,1]})") == "agree");
  CHECK(face.says(R"({"class":"proper","normal":[0,0,6],"unit":[1e-16,0,1]})") == "inexact");
  CHECK(face.says(R"({"class":"proper","normal":[0,0,6],"unit":[0,0,-1]})") == "algorithm");
}

TEST_CASE("verdicts: a declared tolerance is a length, and excuses a coordinate within it from being wrong") {
  const auto says = [](double tolerance) {
    return Case{"line_point_at", R"({"line":{"origin":[1,2],"direction":[3,4]},"t":2})", Boundary::closed, tolerance}
        .says(R"({"point":[7.0001,10]})");
  };
  CHECK(says(0) == "algorithm");
  CHECK(says(1e-3) == "inexact");
}

}  // namespace touchstone::proptests::wrong_numbers_tests
