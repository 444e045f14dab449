// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/html.h"
#include "report/html_map.h"
#include "report/html_parts.h"
#include "report/wording.h"

/// Failure maps: where they are centred, and what their legends say.
namespace touchstone::proptests::maps_tests {
namespace {

std::vector<FailureMap> maps_of(const char* name) { return failure_maps(*find_operation(name), 2); }

/// Right where the first coordinate is at most 100.
class WrongFarOut : public Engine {
 public:
  const Declaration& declaration() const override { return declaration_; }
  bool supports(const std::string&) const override { return true; }
  std::vector<Reply> ask(const Operation& operation, const std::vector<Question>& questions) override {
    std::vector<Reply> replies;
    for (const Question& question : questions) {
      Json answer = operation.examine(question)->robust();
      if (question.numbers[0] > 100) answer["side"] = answer["side"] == "left" ? "right" : "left";
      replies.push_back({Reply::Kind::answered, answer, "", true, 0});
    }
    return replies;
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

TEST_CASE("maps: a coordinate that is 0 moves by the steps of the greatest number") {
  const Operation& operation = *find_operation("orientation");
  const MapGrid grid = map_grid(operation, Question{{0, 1, 12, 12, 24, 24}, {}}, {0, 1}, false);
  CHECK(grid.step.first == 0x1p-48);  // 24 is between 2^4 and 2^5
  CHECK(grid.step.second == 0x1p-52);
}

TEST_CASE("maps: each pixel has the colour that the legend gives its class, in both schemes") {
  const FailureMap map = maps_of("orientation")[0];
  std::vector<std::uint64_t> counted(map.classes.size());
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    const Image image = image_of(map, scheme);
    REQUIRE(image.pixels.size() == map.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const MapClass& entry = map.classes.at(map.pixels[i]);
      const Colour colour = image.palette.at(image.pixels[i]);
      if (image.pixels[i] / 2 != map.pixels[i]) FAIL("pixel " << i << " is of another class");
      if (colour != entry.look(scheme).ground && colour != entry.look(scheme).mark) FAIL("pixel " << i);
      if (scheme == Scheme::light) ++counted[map.pixels[i]];
    }
  }
  for (std::size_t k = 0; k < counted.size(); ++k) CHECK(counted[k] == map.classes[k].count);
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
