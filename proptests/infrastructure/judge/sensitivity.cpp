// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/sensitivity.h"

#include <cmath>

#include "proptests/catch.h"

namespace touchstone::proptests::sensitivity_tests {
namespace {

std::vector<catalogue::Sensitivity> asked(const char* operation, const char* input) {
  const catalogue::Operation& known = *catalogue::find_operation(operation);
  return catalogue::sensitivities(known, known.parse(catalogue::parse_line(input)));
}

/// A slope is off by 2^-21: two doubles are rounded, and their difference is taken over 2^-32. What bends adds less,
/// and no question here has more than 13 numbers.
void near(double number, double expected) { CHECK(std::fabs(number - expected) < 0x1p-17); }

}  // namespace

// A product of k numbers has the condition k: each of them moves it as much as it is moved.
TEST_CASE("sensitivity: of products it is the number of factors, of a sum that cancels what was cancelled") {
  const auto one = asked("momentum", R"({"bodies":[{"mass":3,"velocity":[5,0,-0.1]}]})");
  REQUIRE(one.size() == 2);  // a component that is 0 has none
  near(one[0].condition, 2), near(one[1].condition, 2);
  const auto energy = asked("kinetic_energy", R"({"bodies":[{"mass":3,"velocity":[5,0,0]}]})");
  REQUIRE(energy.size() == 1);
  near(energy[0].condition, 3);
  CHECK(energy[0].ulps == 0);

  // 1 - (1 - 2^-20): two products of size 1, and 2^-20 is left.
  const auto rest = asked(
      "momentum", R"({"bodies":[{"mass":1,"velocity":[1,0,0]},{"mass":1,"velocity":[-0.99999904632568359375,0,0]}]})");
  REQUIRE(rest.size() == 1);
  near(rest[0].condition, 2 * (0x1p20 + 0x1p20 - 1));
}

TEST_CASE("sensitivity: a number at the edge of what is valid is moved to the other side") {
  // v1' = v1 - (1 + e) m2 (v1 - v2) / (m1 + m2) = -1. Its derivatives by v1, v2, e, m1, m2 are 0, 1, -1, 1 and -1, and
  // the normal's length cancels. Of v2' the same, with the bodies exchanged. e can only become less.
  const auto found =
      asked("restitution_collision", R"({"masses":[1,1],"velocities":[[1,0,0],[-1,0,0]],"normal":[1,0,0],"e":1})");
  REQUIRE(found.size() == 2);
  near(found[0].condition, 4), near(found[1].condition, 4);
}

TEST_CASE("sensitivity: what has words has none, what is refused is refused") {
  CHECK(asked("orientation", R"({"p0":[0,0],"p1":[1,0],"p":[0.1,0.2]})").empty());
  CHECK_THROWS_AS(asked("momentum", R"({"bodies":[{"mass":-1,"velocity":[1,0,0]}]})"), InvalidInput);
}

}  // namespace touchstone::proptests::sensitivity_tests
