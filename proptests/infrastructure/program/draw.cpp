// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "program/commands/commands.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// touchstone draw: questions with their truth, for tests in any language.
namespace touchstone::proptests::draw_tests {
namespace {

std::vector<Json> drawn(const std::vector<const char*>& arguments) {
  std::vector<const char*> all{"draw"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Called call = called(all);
  INFO(call.err);
  REQUIRE(call.code == nothing_found);
  std::vector<Json> lines;
  std::istringstream text(call.out);
  for (std::string line; std::getline(text, line);) lines.push_back(parse_own_line(line));
  return lines;
}

}  // namespace

TEST_CASE("draw: as many lines as asked for, families in turn, each with the truth that ask gives") {
  const auto lines = drawn({"segment_segment", "--families", "collinear,shared_end", "--cases", "9"});
  REQUIRE(lines.size() == 9);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Json& line = lines[i];
    CHECK(line["op"] == "segment_segment");
    CHECK(line["family"] == (i % 2 == 0 ? "shared_end" : "collinear"));
    CHECK(line["index"] == i / 2);
    const TextFile question("drawn.jsonl", line["input"].dump() + "\n");
    const Json asked = parse_own_line(called({"ask", "segment_segment", question.path()}).out);
    CHECK(line["truth"] == asked["truth"]);
    CHECK(line["margin"] == asked["margin"]);
    // An end of both is a touch; of two segments on one line more may be common.
    if (line["truth"]["relation"] == "point") CHECK(line["touch"] == true);
    if (line["truth"]["relation"] == "overlap") CHECK(line["touch"] == false);
  }
}

TEST_CASE("draw: beside the truth stands what its numbers round to; there is a margin where something is decided") {
  for (const Json& line : drawn({"line_point_at", "--cases", "20"})) {
    CHECK(line["truth"]["point"][0].is_string());
    const Json& rounded = line["rounded"]["point"][0];
    CHECK((rounded.is_number() || rounded == "inf" || rounded == "-inf"));  // beyond the greatest double
  }
  for (const Json& line : drawn({"momentum", "--cases", "20"})) CHECK_FALSE(line.contains("margin"));
}

TEST_CASE("draw: what is outside the contract is not printed, and does not count") {
  for (const Operation* operation : {find_operation("interior_angles"), find_operation("point_in_convex_polyhedron")}) {
    const auto lines = drawn({operation->metadata().name, "--families", "any_bits,grid", "--cases", "40"});
    CHECK(lines.size() == 40);
  }
}

TEST_CASE("draw: the same seed gives the same bytes, another one others") {
  const auto text = [](const char* seed) {
    return called({"draw", "orientation", "--cases", "50", "--seed", seed}).out;
  };
  CHECK(text("1") == text("1"));
  CHECK(text("1") != text("2"));
}

TEST_CASE("draw: numbers are exact in float where that is asked for") {
  for (const Json& line : drawn({"orientation", "--cases", "100", "--binary32"})) {
    for (const char* point : {"p0", "p1", "p"}) {
      for (const Json& number : line["input"][point]) {
        const auto value = number.get<double>();
        CHECK(static_cast<double>(static_cast<float>(value)) == value);
      }
    }
  }
}

TEST_CASE("draw: of ordinary size where that is asked for") {
  const auto greatest = [](const std::vector<Json>& lines) {
    double most = 0;
    for (const Json& line : lines) {
      for (const double number : find_operation("orientation")->parse(parse_line(line["input"].dump())).numbers)
        most = std::max(most, std::fabs(number));
    }
    return most;
  };
  CHECK(greatest(drawn({"orientation", "--cases", "500"})) > 0x1p100);
  CHECK(greatest(drawn({"orientation", "--cases", "500", "--range", "ordinary"})) <= 0x1p100);
  // mixed_exponents has hardly one: it is left out, unless it is asked for by name.
  require_refused(called({"draw", "orientation", "--families", "mixed_exponents", "--range", "ordinary"}), bad_usage,
                  "--families mixed_exponents: none of 1000 questions is within the contract of orientation and of "
                  "ordinary size");
}

TEST_CASE("draw: an operation or a family that is none is named in one line") {
  require_refused(called({"draw", "orientatoin"}), bad_usage, "orientatoin");
  require_refused(called({"draw", "orientation", "--families", "collinear,shared"}), bad_usage,
                  "--families shared: orientation has no such family; touchstone ops --json lists them");
  require_refused(called({"draw", "orientation", "--families", "colinear"}), bad_usage,
                  "--families colinear: orientation has no such family (did you mean \"collinear\"?)");
  require_refused(called({"draw", "orientation", "--cases", "0"}), bad_usage, "an integer from 1 to");
}

}  // namespace touchstone::proptests::draw_tests
