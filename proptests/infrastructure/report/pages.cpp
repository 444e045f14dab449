// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include "audit/counting/audit_run.h"
#include "catalogue/draw/figures.h"
#include "proptests/catch.h"
#include "proptests/golden.h"
#include "proptests/uses.h"
#include "report/figures/svg.h"
#include "report/pages/contract.h"
#include "report/pages/html.h"
#include "report/pages/html_compare.h"
#include "report/pages/html_confusion.h"
#include "report/pages/html_finding.h"
#include "report/pages/html_footer.h"
#include "report/parts/html_parts.h"
#include "report/words/answered.h"
#include "report/words/phrases.h"

/// What the pages of a report say, from tallies made by hand.
namespace touchstone::proptests::pages_tests {
namespace {

const Question below_line{{0, 0, 2, 0, 1, -1}, {}};  // truth: right

Finding finding(const Question& question, Verdict verdict, const Json& answer) {
  Finding found;
  found.question = question;
  found.judgement.verdict = verdict;
  found.answer = answer;
  return found;
}

/// 90 right, 10 wrong: 5 by cancellation at ordinary size, 5 by underflow or overflow at extreme size.
Cell cell_of_orientation() {
  Cell cell;
  cell.outcomes[{Verdict::agree, "left", "left"}].cases = {90, 0};
  OutcomeCount& wrong = cell.outcomes[{Verdict::rounding, "right", "on"}];
  wrong.cases = {5, 5};
  wrong.out_of_range = {0, 5};
  wrong.example = finding(below_line, Verdict::rounding, {{"side", "on"}});
  return cell;
}

Tally tally_of(std::vector<std::pair<std::string, Cell>> cells) {
  Tally tally;
  tally.declaration = reference_declaration();
  tally.seed = 1;
  tally.cases = 100;
  for (auto& [name, cell] : cells) tally.operations.push_back({name, {{"collinear", cell}}});
  return tally;
}

std::size_t place_of(const std::string& page, const std::string& part) {
  INFO(part);
  const std::size_t at = page.find(part);
  REQUIRE(at != std::string::npos);
  return at;
}

/// What people read of a page, a block a line: without styles, scripts, drawings, contracts and the footer.
std::string outline(std::string page) {
  const auto cut = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = page.find(from, at)) != std::string::npos; ++at)
      page.erase(at, page.find(to, at) + to.size() - at);
  };
  cut("<style", "</style>"), cut("<script", "</script>"), cut("<footer", "</footer>");
  cut("<div class=\"view\">", "</div>"), cut("<div class=\"card contract\">", "</details></div>");
  for (const char* block : {"<h1", "<h2", "<h3", "<p", "<tr", "<div", "<section", "<details", "<li"})
    for (std::size_t at = 0; (at = page.find(block, at)) != std::string::npos; at += 2)
      if (at > 0 && page[at - 1] != '\n') page.insert(at, 1, '\n');
  return page + '\n';
}

}  // namespace

TEST_CASE("pages: the index: how much is wrong, at which size and why, the worst operation first, and the gate") {
  Cell right;
  right.outcomes[{Verdict::agree, "above", "above"}].cases = {100, 0};
  const Tally tally = tally_of({{"point_ground_plane", right}, {"orientation", cell_of_orientation()}});
  // Where nothing fails there is no map.
  const std::string page =
      index_page(tally, {{"point_ground_plane", failure_maps(*find_operation("point_ground_plane"), 2)}},
                 {"", nullptr, "gate: failed: 1 new finding\n  a < b\n"});
  check_golden("report/golden/index.html", outline(page));
}

TEST_CASE("pages: an operation: its contract, truth against answer, and an example of each way to fail") {
  Cell boxes, numbers;
  boxes.outcomes[{Verdict::agree, "apart", "no"}].cases = {7, 0};
  boxes.outcomes[{Verdict::algorithm, "apart", "yes"}].cases = {3, 0};
  numbers.outcomes[{Verdict::inexact, "value", "value"}].cases = {1, 0};
  check_golden("report/golden/orientation.html",
               outline(operation_page(tally_of({{"orientation", cell_of_orientation()}}), 0, {})));
  // A plain yes or no is right where it was judged right.
  check_golden("report/golden/yes_or_no.html", outline(confusion_matrix(*find_operation("aabb_aabb"), boxes, "e")));
  CHECK(confusion_matrix(*find_operation("line_point_at"), numbers, "the formula").empty());
}

TEST_CASE("pages: before and after a fix, what changed most first") {
  Cell fixed, worse = cell_of_orientation();
  fixed.outcomes[{Verdict::agree, "left", "left"}].cases = {100, 0};
  worse.outcomes[{Verdict::algorithm, "on", "left"}].cases = {1, 0};
  const Tally before = tally_of({{"point_on_segment", cell_of_orientation()}, {"orientation", cell_of_orientation()}}),
              after = tally_of({{"point_on_segment", worse}, {"orientation", fixed}, {"line_line", fixed}});
  Tally other = before;
  other.seed = 2;
  CHECK(comparison(before, after, "line_line").empty());
  check_golden("report/golden/before_and_now.html", outline(comparison(before, after)) +
                                                        outline(comparison(before, after, "orientation")) +
                                                        outline(comparison(other, after)));
  CHECK_THAT(index_page(after, {}, {"", &before}), ContainsSubstring("Before and now"));
}

TEST_CASE("pages: an engine is called by its name, and where nothing is wrong the headline says none") {
  Cell right;
  right.outcomes[{Verdict::agree, "left", "left"}].cases = {7, 0};
  Tally tally = tally_of({{"orientation", right}});
  tally.declaration = {"my engine 1.0", Declaration::Boundary::closed, true, 0};
  CHECK_THAT(index_page(tally, {}),
             ContainsSubstring("<h1>my engine 1.0 in float: none of 7 hard questions wrong</h1>"));
}

TEST_CASE("pages: a report can be read before the first map is made, then the worst operation has its map first") {
  Cell right;
  right.outcomes[{Verdict::agree, "above", "above"}].cases = {100, 0};
  const Tally tally = tally_of({{"point_ground_plane", right}, {"orientation", cell_of_orientation()}});
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / "touchstone_pages_in_order";
  const auto bytes = [&](const char* name) {
    std::ifstream file(directory / name);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  std::vector<std::string> order;
  ReportNotes notes;
  notes.progress = [&](const std::string& name, std::size_t, std::size_t all) {
    CHECK(all == 2);
    if (order.empty()) {
      CHECK_THAT(bytes("index.html"), ContainsSubstring("</html>") && !ContainsSubstring("class=\"gallery\""));
      CHECK_THAT(bytes("orientation.html"),
                 ContainsSubstring("\u201con it\u201d where the truth") && !ContainsSubstring(map_opening));
      CHECK_THAT(bytes("point_ground_plane.html"), ContainsSubstring("</html>"));
    }
    if (order.empty() || order.back() != name) order.push_back(name);
  };
  write_report(tally, directory, 1, nullptr, notes);
  CHECK(order == std::vector<std::string>{"orientation", "point_ground_plane"});
  CHECK_THAT(bytes("index.html"), ContainsSubstring("class=\"gallery\""));
  CHECK_THAT(bytes("orientation.html"),
             ContainsSubstring(map_opening) && ContainsSubstring("Each square of 16 \u00d7 16 pixels is one question"));
  // With seconds that are over at once, no map at all; with many, the whole grid.
  notes.seconds = 1e-9, notes.progress = nullptr;
  write_report(tally, directory, 1, nullptr, notes);
  CHECK(bytes("orientation.html").find(map_opening) == std::string::npos);
  notes.seconds = 600;
  write_report(tally, directory, 2, nullptr, notes);
  CHECK_THAT(bytes("orientation.html"), ContainsSubstring("Each pixel is one question"));
  std::filesystem::remove_all(directory);
}

TEST_CASE("pages: of a run that goes on, the index says how far it is, and the last operation has its page") {
  Tally tally = tally_of({{"orientation", cell_of_orientation()}});
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / "touchstone_pages_so_far";
  const auto bytes = [&](const char* name) {
    std::ifstream file(directory / name);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string so_far = "The audit goes on: 1 of 2 operations are counted so far.";
  write_so_far(tally, directory, {.expected = 2});
  CHECK_THAT(bytes("index.html"), ContainsSubstring(so_far) && ContainsSubstring("href=\"orientation.html\""));
  CHECK_THAT(bytes("orientation.html"), ContainsSubstring("\u201con it\u201d where the truth"));
  tally.operations.push_back(tally_of({{"line_line", {}}}).operations[0]);
  write_so_far(tally, directory, {.expected = 2});
  CHECK_THAT(bytes("line_line.html"), ContainsSubstring("</html>"));
  write_report(tally, directory, 1);
  CHECK_THAT(bytes("index.html"), !ContainsSubstring("The audit goes on"));
  std::filesystem::remove_all(directory);
}

TEST_CASE("pages: an operation's page quotes its contract, formulas on lines of their own") {
  const Tally tally = tally_of({{"orientation", cell_of_orientation()}});
  const std::string page = operation_page(tally, 0, {});
  const std::size_t formula = place_of(page, "<p>Deck p. 16-17:</p><div class=\"formula\"><math");
  CHECK(formula < place_of(page, "<p>left where E &gt; 0, right where E &lt; 0, on where E = 0.</p><details>"));
  CHECK(place_of(page, "<h2>Contract</h2>") < place_of(page, "<h2>How it fails"));
  CHECK(place_of(page, "How it fails") < place_of(page, "For comparison: a case where the formula is right"));
  CHECK(paragraph("`none` if a < b") == "<p><code>none</code> if a &lt; b</p>");
  CHECK(paragraph("As\nsaid:\n    a < 1\nand so on.") ==
        "<p>As\nsaid:</p><div class=\"formula\"><math "
        "display=\"block\"><mi>a</mi><mo>&lt;</mo><mn>1</mn></math></div><p>and so on.</p>");
  for (const Operation* operation : all_operations()) {
    INFO(operation->name());
    const auto contract = contract_of(operation->name());
    REQUIRE(contract.size() >= 2);
    CHECK(contract[0].find("///") == std::string::npos);
  }
  CHECK(contract_of("no_such_operation").empty());
}

TEST_CASE("pages: what no page of the deck asks is not laid to the deck") {
  CHECK(pages_in_words(*find_operation("orientation")) == "deck p. 16-17");
  CHECK(pages_in_words(*find_operation("sphere_plane")) ==
        "no page of the deck; what it is made of is taught there on p. 22, 44");
}

TEST_CASE("pages: the index can be read in the order of the deck, and every cell of its table has a key to sort by") {
  const Tally tally = tally_of({{"sphere_plane", {}}, {"momentum", {}}, {"orientation", cell_of_orientation()}});
  const std::string page = index_page(tally, {});
  const std::size_t by_deck = place_of(page, "In the order of the deck");
  const std::string list = page.substr(by_deck);
  CHECK(place_of(list, "<h3>lines</h3>") < place_of(list, "orientation.html"));
  CHECK(place_of(list, "orientation.html") < place_of(list, "<h3>response</h3>"));
  CHECK(place_of(list, "momentum.html") < place_of(list, "<h3>mixed</h3>"));
  CHECK_THAT(list, ContainsSubstring("<span class=\"quiet\">deck p. 16-17</span>"));
  std::size_t keys = 0;
  for (std::size_t at = 0; (at = page.find(" data-sort=\"", at)) != std::string::npos; ++at) ++keys;
  CHECK(keys == 3 * 6 + 4);  // the row of sums has no name and no place
  CHECK_THAT(page, ContainsSubstring("querySelectorAll('table.sortable')"));
}

TEST_CASE("pages: the counts at the top stand in rows of equal length, or one less") {
  // 3 tiles always, and as many as there are verdicts: 7 are 4 and 3, not 6 and 1.
  Cell cell = cell_of_orientation();
  const auto columns = [&] { return index_page(tally_of({{"orientation", cell}}), {}); };
  CHECK_THAT(columns(), ContainsSubstring("style=\"--columns:5;--fewer:3\""));
  cell.outcomes[{Verdict::algorithm, "right", "on"}].cases = {1, 0};
  cell.outcomes[{Verdict::inexact, "right", "right"}].cases = {1, 0};
  CHECK_THAT(columns(), ContainsSubstring("style=\"--columns:4;--fewer:4\""));
}

TEST_CASE("pages: a wrong point is drawn beside the right one, the same figure without it") {
  Cell cell;
  OutcomeCount& wrong = cell.outcomes[{Verdict::inexact, "point", "point"}];
  wrong.cases = {1, 0};
  wrong.example = finding({{0, 0, 2, 2, 0, 2, 2, 0}, {}}, Verdict::inexact,
                          Json::parse(R"({"relation":"point","ta":0.5,"tb":0.5,"point":[1,1.5]})"));
  const std::string page = operation_page(tally_of({{"segment_segment", cell}}), 0, {});
  const std::size_t right = place_of(page, "Truth:</b>"), beside = place_of(page, "<div class=\"beside\">");
  CHECK(beside < right);
  const std::string first = page.substr(beside, right - beside),
                    second = page.substr(right, place_of(page, "Formula:</b>") - right);
  CHECK(first.find(">truth: point<") != std::string::npos);
  CHECK(first.find(">answered<") == std::string::npos);
  CHECK(second.find(">truth: point<") == std::string::npos);
  CHECK(second.find(">answered<") != std::string::npos);
}

TEST_CASE("pages: pieces that were answered are drawn at the polygon's vertices, none where an index is too great") {
  const Operation& operation = *find_operation("triangulate_polygon");
  const Question question{{0, 0, 4, 0, 4, 4, 0, 4}, {4}};
  for (const auto& [answer, drawn] :
       {std::pair(R"({"triangles":[[0,1,2],[0,2,3]]})", 2), std::pair(R"({"triangles":[[0,1,4]]})", 0)}) {
    Drawing scene;
    scene.figures.push_back({Figure::Kind::polygon, "polygon", {0, 0, 4, 0, 4, 4, 0, 4}});
    draw_answered(scene, operation, Json::parse(answer), question);
    REQUIRE(scene.figures.size() == 1u + static_cast<std::size_t>(drawn));
    if (drawn > 0) CHECK(scene.figures[1].numbers == std::vector<double>{0, 0, 4, 0, 4, 4});
  }
}

TEST_CASE("pages: bodies move as the truth has them, and beside it as was answered") {
  // Equal masses, head on: the first stops. What was answered lets both pass.
  const Operation& operation = *find_operation("elastic_collision");
  const Question question =
      operation.parse(parse_line(R"({"masses":[1,1],"velocities":[[1,0,0],[0,0,0]],"normal":[1,0,0]})"));
  const auto after = [](const Drawing& drawing) {
    for (const SpaceFigure& figure : drawing.space)
      if (figure.label == "a" && figure.moves) return figure.moves->at_1;
    return std::array<double, 3>{-1, -1, -1};
  };
  Drawing drawing = operation.examine(question)->drawing();
  CHECK(after(drawing) == std::array<double, 3>{0, 0, 0});
  Drawing none = drawing;
  draw_answered(drawing, operation, Json::parse(R"({"velocities":[[1,0,0],[0,0,0]]})"), question);
  CHECK(after(drawing) == std::array<double, 3>{1, 0, 0});
  draw_answered(none, operation, Json::parse(R"("no answer")"), question);
  CHECK(after(none) == std::array<double, 3>{-1, -1, -1});
}

TEST_CASE("pages: a sweep is drawn at its start, at first contact and at its end, and at the time that was answered") {
  const Operation& operation = *find_operation("swept_sphere_sphere");
  // From x = -10 towards a ball around the origin, both of radius 1: they touch at x = -2, after 8 of 16.
  const Question question{{-10, 0, 0, 1, 0, 0, 0, 1, 16, 0, 0, 0, 0, 0}, {}};
  Drawing drawing = operation.examine(question)->drawing();
  const auto spheres = [&](bool answer, bool said) {
    std::vector<double> places;
    for (const SpaceFigure& figure : drawing.space) {
      if (figure.kind == SpaceFigure::Kind::sphere && figure.answer == answer && figure.said == said)
        places.push_back(figure.numbers[0]);
    }
    return places;
  };
  CHECK(spheres(false, false) == std::vector<double>{-10, 6, 0});
  CHECK(spheres(true, false) == std::vector<double>{-2});
  const auto arrow = std::find_if(drawing.space.begin(), drawing.space.end(),
                                  [](const SpaceFigure& figure) { return figure.kind == SpaceFigure::Kind::arrow; });
  REQUIRE(arrow != drawing.space.end());
  CHECK(arrow->label == "velocity of a");
  CHECK(arrow->numbers == std::vector<double>{-10, 0, 0, 6, 0, 0});
  draw_answered(drawing, operation, Json::parse(R"({"relation":"hit","t":0.25})"), question);
  CHECK(spheres(false, true) == std::vector<double>{-6});
}

TEST_CASE("pages: a narrow gap to a point is magnified, none to a vector or to a line that only helps") {
  const auto magnified = [](Figure::Kind kind, const char* label, std::vector<double> numbers) {
    Drawing drawing;
    drawing.figures.push_back({Figure::Kind::polygon, "polygon", {0, 0, 4, 0, 4, 4, 0, 4}});
    drawing.figures.push_back({kind, label, std::move(numbers)});
    return drawing_svg(drawing, "").find("; gap ") != std::string::npos;
  };
  CHECK(magnified(Figure::Kind::point, "point", {1, 0x1p-30}));
  CHECK(!magnified(Figure::Kind::arrow, "velocity", {2, 2, 1, 0x1p-30}));
  CHECK(!magnified(Figure::Kind::segment, "", {2, 2, 1, 0x1p-30}));
}

TEST_CASE("pages: velocities after an impact stand at the bodies, those that were answered too") {
  const Operation& operation = *find_operation("elastic_collision");
  // a comes from the left and stops, b goes on: equal masses, along x.
  const Question question{{1, 1, 3, 0, 0, 0, 0, 0, 1, 0, 0}, {}};
  Drawing drawing = operation.examine(question)->drawing();
  const auto arrows = [&](bool answer, bool said) {
    std::vector<std::vector<double>> places;
    for (const SpaceFigure& figure : drawing.space) {
      if (figure.kind == SpaceFigure::Kind::arrow && figure.answer == answer && figure.said == said)
        places.push_back({figure.numbers[0], figure.numbers[3]});
    }
    return places;
  };
  using Places = std::vector<std::vector<double>>;
  CHECK(arrows(false, false) == Places{{-1, 2}, {1, 1}, {0, 1}});  // before; the normal at the contact
  CHECK(arrows(true, false) == Places{{-1, -1}, {1, 4}});          // after, once each
  draw_answered(drawing, operation, Json::parse(R"({"velocities":[[1,0,0],[2,0,0]]})"), question);
  CHECK(arrows(false, true) == Places{{-1, 0}, {1, 3}});
}

TEST_CASE("pages: momenta are drawn head to tail, a bounce at the body") {
  const auto arrows = [](const char* operation, const Question& question) {
    std::vector<std::vector<double>> found;
    const auto examination = find_operation(operation)->examine(question);
    for (const SpaceFigure& figure : examination->drawing().space) {
      if (figure.kind == SpaceFigure::Kind::arrow) found.push_back(figure.numbers);
    }
    return found;
  };
  using Arrows = std::vector<std::vector<double>>;
  // Two bodies, mass and velocity of each: 2 (1, 0, 0) + 3 (0, 1, 0).
  CHECK(arrows("momentum", {{2, 1, 0, 0, 3, 0, 1, 0}, {2}}) ==
        Arrows{{0, 0, 0, 2, 0, 0}, {2, 0, 0, 2, 3, 0}, {0, 0, 0, 2, 3, 0}});
  // Down and forwards onto a floor: the velocity before ends at the body, the one after starts there.
  CHECK(arrows("reflect_plane", {{1, -2, 0, 0, 1, 0}, {}}) == Arrows{{-1, 2, 0, 0, 0, 0}, {0, 0, 0, 1, 2, 0}});
  // A body at rest has no velocity before; the one after is the truth, and drawn.
  CHECK(arrows("reflect_plane", {{0, 0, 0, 0, 1, 0}, {}}) == Arrows{{0, 0, 0, 0, 0, 0}});
}

TEST_CASE("pages: a gap is magnified only on request") {
  Drawing drawing;
  drawing.figures.push_back({Figure::Kind::polygon, "polygon", {0, 0, 4, 0, 4, 4, 0, 4}});
  drawing.figures.push_back({Figure::Kind::point, "point", {1, 0x1p-30}});
  CHECK(drawing_svg(drawing, "", mpq_class(0)).find("; gap ") != std::string::npos);
  CHECK(drawing_svg(drawing, "", std::nullopt).find("; gap ") == std::string::npos);
}

TEST_CASE("pages: the footer holds the versions and the command that gives the same") {
  Tally tally = tally_of({{"orientation", cell_of_orientation()}});
  CHECK(audit_command_of(tally, {}) == "touchstone audit --ops orientation --cases 100 --seed 1 --report DIR");
  CHECK(audit_command_of(tally, {"touchstone audit --seed 7", nullptr}) == "touchstone audit --seed 7");
  tally.repeat.options = "--engine 'python3 engine.py'";
  CHECK_THAT(audit_command_of(tally, {}), StartsWith("touchstone audit --engine 'python3 engine.py' --ops"));
  tally.repeat.program = "build/release/touchstone";
  CHECK_THAT(audit_command_of(tally, {}), StartsWith("build/release/touchstone audit --engine"));
  const std::string page = index_page(tally, {});
  CHECK_THAT(page.substr(place_of(page, "<footer>")), ContainsSubstring(versions()));
  CHECK_THAT(versions(), ContainsSubstring("GMP ") && ContainsSubstring("MPFR "));
}

}  // namespace touchstone::proptests::pages_tests
