// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/html.h"
#include "report/pages/html_map.h"
#include "report/parts/html_parts.h"
#include "report/words/wording.h"

/// Failure maps: where they are centred, and what their legends say.
namespace touchstone::proptests::maps_tests {
namespace {

std::vector<FailureMap> maps_of(const char* name) { return failure_maps(*find_operation(name), 2); }

/// Right where the first coordinate is at most 100.
class WrongFarOut : public Engine {
 public:
  const Declaration& declaration() const override { return declaration_; }
  bool supports(const std::string&) const override { return true; }
  void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) override {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      Json answer = operation.examine(questions[i])->robust();
      if (questions[i].numbers[0] > 100) answer["side"] = answer["side"] == "left" ? "right" : "left";
      take(i, {Reply::Kind::answered, answer, "", true, 0});
    }
  }

 private:
  Declaration declaration_{"wrong far out", Declaration::Boundary::closed, false, 0};
};

}  // namespace

TEST_CASE("maps: where nothing fails around an operation's own centre, the map is around a finding") {
  const Operation& operation = *find_operation("orientation");
  WrongFarOut engine;
  const Question finding{{100, 0.5, 12, 12, 24, 24}, {}}, right{{50, 0.5, 12, 12, 24, 24}, {}};
  CHECK(failing_grid(operation, false, &engine, {right, finding}).centre == finding);
  CHECK(failing_grid(operation, false, nullptr, {right, finding}).centre == operation.map_centre());
  const auto maps = failure_maps(operation, 1, false, &engine, {right, finding});
  REQUIRE(maps.size() == 3);
  CHECK(&subject_of(maps) == &maps[2]);
  CHECK(maps[2].findings() == 127 * 256);  // to the right of the middle
  CHECK(maps[0].findings() == 0);
}

TEST_CASE("maps: a centre that shows failures is kept") {
  const Operation& operation = *find_operation("orientation");
  CHECK(failing_grid(operation).centre == operation.map_centre());
}

TEST_CASE("maps: a map lies within the contract where it can") {
  // Around a radius of 0, or a slab of no width, half of all questions would be refused.
  for (const char* name : {"swept_sphere_sphere", "kdop_kdop"}) {
    INFO(name);
    const Operation& operation = *find_operation(name);
    const MapGrid grid = failing_grid(operation, false, nullptr, {}, MapEffort{16});
    int refused = 0, all = 0;
    for (int row = 3; row < MapGrid::side; row += 16) {
      for (int column = 3; column < MapGrid::side; column += 16) {
        ++all;
        try {
          operation.examine(grid.at(column, row));
        } catch (const InvalidInput&) {
          ++refused;
        }
      }
    }
    CHECK(8 * refused <= all);
  }
}

TEST_CASE("maps: a coordinate that is 0 moves by the steps of the greatest number") {
  const Operation& operation = *find_operation("orientation");
  const MapGrid grid = map_grid(operation, Question{{0, 1, 12, 12, 24, 24}, {}}, {0, 1}, false);
  CHECK(grid.step.first == 0x1p-48);  // 24 is between 2^4 and 2^5
  CHECK(grid.step.second == 0x1p-52);
}

TEST_CASE("maps: a coarse map asks fewer questions, those that a fine one asks too, the middle among them") {
  const Operation& operation = *find_operation("orientation");
  const FailureMap fine = maps_of("orientation")[0];
  for (const int side : {16, 64}) {
    const auto maps = failure_maps(operation, 2, false, nullptr, {}, {side});
    const FailureMap& coarse = maps[0];
    REQUIRE(coarse.squares.size() == static_cast<std::size_t>(side * side));
    CHECK(coarse.grid.at(column_of(side / 2, side), row_of(side / 2 - 1, side)) == operation.map_centre());
    const Image image = image_of(coarse);
    CHECK(image.pixels.size() == 256 * 256);
    const int wide = 256 / side;
    std::set<int> places;  // among stripes half as wide as a square
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const int x = column_of(column, side), y = row_of(row, side);
        REQUIRE((x / wide == column && y / wide == row));
        places.insert(x % (wide / 2));
        const MapClass &of_coarse = coarse.classes.at(coarse.squares[static_cast<std::size_t>(row * side + column)]),
                       &of_fine = fine.classes.at(fine.squares[static_cast<std::size_t>(y * 256 + x)]);
        if (of_coarse.verdict != of_fine.verdict || of_coarse.said != of_fine.said) FAIL(column << ", " << row);
      }
    }
    CHECK(places.size() == static_cast<std::size_t>(wide / 2));
  }
}

TEST_CASE("maps: how many questions follows from those of the audit, at least 16 x 16, at most the whole grid") {
  for (const auto& [cases, side] : {std::pair(1, 16),
                                    {60, 16},
                                    {1023, 16},
                                    {1024, 32},
                                    {2000, 32},
                                    {4096, 64},
                                    {20000, 128},
                                    {65536, 256},
                                    {200000, 256}})
    CHECK(MapEffort::of(static_cast<std::uint64_t>(cases)).side == side);
}

TEST_CASE("maps: an engine is asked for a coarse map no more than five times its squares") {
  class Counting : public WrongFarOut {
   public:
    void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) override {
      asked += questions.size();
      WrongFarOut::ask_each(operation, questions, take);
    }
    std::size_t asked = 0;
  } engine;
  const Question nowhere_wrong{{50, 0.5, 12, 12, 24, 24}, {}};
  failure_maps(*find_operation("orientation"), 1, false, &engine, {nowhere_wrong, nowhere_wrong}, {16});
  CHECK(engine.asked <= 5 * 256);
}

TEST_CASE("maps: what is abandoned is empty") {
  CHECK(failure_maps(*find_operation("orientation"), 1, false, nullptr, {}, {16, [] { return false; }}).empty());
}

TEST_CASE("maps: each pixel has the colour that the legend gives its class, in both schemes") {
  const FailureMap map = maps_of("orientation")[0];
  std::vector<std::uint64_t> counted(map.classes.size());
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    const Image image = image_of(map, scheme);
    REQUIRE(image.pixels.size() == map.squares.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const MapClass& entry = map.classes.at(map.squares[i]);
      const Colour colour = image.palette.at(image.pixels[i]);
      if (image.pixels[i] / 2 != map.squares[i]) FAIL("pixel " << i << " is of another class");
      if (colour != entry.look(scheme).ground && colour != entry.look(scheme).mark) FAIL("pixel " << i);
      if (scheme == Scheme::light) ++counted[map.squares[i]];
    }
  }
  for (std::size_t k = 0; k < counted.size(); ++k) CHECK(counted[k] == map.classes[k].count);
}

TEST_CASE("maps: numbers are shown by the digits that they lost, in the order of the scale") {
  const FailureMap map = failure_maps(*find_operation("line_point_at"), 2)[0];
  std::vector<std::string> said;
  for (const MapClass& entry : map.classes) {
    if (entry.verdict == Verdict::inexact) said.push_back(entry.said);
  }
  REQUIRE(said.size() >= 2);
  const std::vector<std::string> scale{"up to 1 digit lost",      "1 to 2 digits lost",  "2 to 4 digits lost",
                                       "4 to 7 digits lost",      "7 to 10 digits lost", "10 to 15 digits lost",
                                       "more than 15 digits lost"};
  auto at = scale.begin();
  for (const std::string& words : said) {
    at = std::find(at, scale.end(), words);
    INFO(words);
    REQUIRE(at != scale.end());
  }
}

TEST_CASE("maps: the legend speaks in words") {
  const Operation& operation = *find_operation("orientation");
  CHECK(class_in_words(operation, {Verdict::agree, "left", 1, {}}) == "right: left of the line");
  CHECK(class_in_words(operation, {Verdict::rounding, "on", 1, {}}) == "wrong by rounding: on it");
  CHECK(class_in_words(operation, {Verdict::invalid, "", 1, {}}) == "invalid answer");
  const std::string page = map_page(operation, maps_of("orientation"));
  CHECK(page.find(map_opening) != std::string::npos);
  for (const char* words : {"right: left of the line", "right: right of the line", "wrong by rounding: on it"})
    CHECK_THAT(page, ContainsSubstring(words));
}

}  // namespace touchstone::proptests::maps_tests
