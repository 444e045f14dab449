// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/infrastructure/report/in_node.h"
#include "proptests/uses.h"
#include "report/maps/map_image.h"
#include "report/pages/html.h"
#include "report/words/phrases.h"
#include "report/words/wording.h"

/// The script of a page with failure maps, run in node: what it shows of a pixel is what the catalogue says of it.
namespace touchstone::proptests::page_script_tests {
namespace {

/// What the page shows at first and after each step.
std::vector<Json> shown(const std::string& page, const std::string& hash, const std::vector<std::string>& steps) {
  std::vector<std::string> arguments{hash};
  arguments.insert(arguments.end(), steps.begin(), steps.end());
  return lines_of_node("page_script.mjs", page, arguments);
}

void check_pixel(const Json& seen, const Operation& operation, const MapGrid& grid, int column, int row) {
  INFO("pixel " << column << ", " << row << ": " << seen.dump());
  const Question question = grid.at(column, row);
  const auto examination = operation.examine(question);
  CHECK(seen["input"] == one_line(operation.print(question)));
  CHECK(seen["repeat"] == repeat_command(operation, question, Speaker::reference, {}));
  const std::string truth = phrase(operation, examination->outcome());
  const std::string formula = phrase(operation, word_in(examination->reference()));
  const auto& answers = seen["answers"];
  REQUIRE(answers.size() == 3);
  CHECK(answers[0] == Json({"truth, exact", truth, ""}));
  CHECK(answers[1][1] == formula);
  CHECK(answers[1][2] == name_of(examination->judge_reference().verdict));
  CHECK(answers[2] == Json({"robust", truth, "agree"}));
}

}  // namespace

TEST_CASE("page script: a click, a key, a drag and a link choose a pixel, and what is shown of it is true") {
  if (!there_is_node()) return;
  const Operation& operation = *find_operation("orientation");
  const auto maps = failure_maps(operation, 2);
  const MapGrid& grid = maps[0].grid;
  const auto seen = shown(map_page(operation, maps), "#map=130,127",
                          {"key ArrowRight", "key ArrowUp shift", "click 0 401 81", "click 1 -30 600", "drag 30 -20"});
  REQUIRE(seen.size() == 6);
  check_pixel(seen[0], operation, grid, 130, 127);
  CHECK(seen[0]["scrolled"] == true);
  check_pixel(seen[1], operation, grid, 131, 127);
  check_pixel(seen[2], operation, grid, 131, 111);
  check_pixel(seen[3], operation, grid, 200, 40);              // a map of 512 pixels shows 256
  check_pixel(seen[4], operation, grid, 0, 255);               // beyond the edge is the edge
  check_pixel(seen[5], operation, grid, 3, 253);               // a lens of 150 pixels shows 15
  CHECK(seen[3]["cross"][1] == Json({"78.320%", "15.820%"}));  // (200 + 1/2) / 256
}

TEST_CASE("page script: it begins where the formula fails") {
  if (!there_is_node()) return;
  const Operation& operation = *find_operation("orientation");
  const auto seen = shown(map_page(operation, failure_maps(operation, 2)), "", {});
  REQUIRE(seen.size() == 1);
  CHECK(seen[0]["scrolled"] == false);
  CHECK(seen[0]["answers"][1][2] == "rounding");
  CHECK(seen[0]["answers"][0][1] != seen[0]["answers"][1][1]);
}

}  // namespace touchstone::proptests::page_script_tests
