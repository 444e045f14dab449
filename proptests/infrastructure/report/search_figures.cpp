// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "catalogue/operation/truth_drawing.h"
#include "geometry/invalid_input.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/report/in_node.h"
#include "proptests/uses.h"
#include "report/figures/space_model.h"
#include "report/figures/svg.h"
#include "report/pages/html_search.h"
#include "report/parts/html_parts.h"

/// Searches in structures over bodies, as they are drawn and counted.
namespace touchstone::proptests::search_figures_tests {
namespace {

Drawing drawing_of_input(const char* operation, const std::string& input) {
  const Operation& op = *find_operation(operation);
  return op.examine(op.parse(parse_line(input)))->drawing();
}

std::string box(double x, double width = 1) {
  const std::string low = std::to_string(x), high = std::to_string(x + width);
  return R"({"min":[)" + low + R"(,0,0],"max":[)" + high + ",1,1]}";
}

/// Four cubes of side 1 along x, a gap of 9 between any two, and what is asked.
std::string four_cubes(const std::string& commands) {
  return R"({"boxes":[)" + box(0) + "," + box(10) + "," + box(20) + "," + box(30) + R"(],"commands":[)" + commands +
         "]}";
}
const std::string around_the_first = R"({"in_box":)" + box(0) + "}";

std::vector<std::string> labels(const Drawing& drawing, bool answer) {
  std::vector<std::string> found;
  for (const SpaceFigure& figure : drawing.space)
    if (!figure.node && figure.answer == answer) found.push_back(figure.label);
  return found;
}

std::size_t nodes(const Drawing& drawing, bool entered) {
  const auto counted = [entered](const auto& figure) { return figure.node && figure.node->entered == entered; };
  return static_cast<std::size_t>(std::count_if(drawing.space.begin(), drawing.space.end(), counted) +
                                  std::count_if(drawing.figures.begin(), drawing.figures.end(), counted));
}

const std::vector<std::string> structures{"bounding_volume_hierarchy", "uniform_grid", "quadtree", "octree",
                                          "bsp_tree"};

}  // namespace

TEST_CASE("search figures: what a query looks at, enters and compares is counted") {
  // The hierarchy: all; two and two; one each. The search leaves at the second cube and at the second half.
  // The grid: two cells along each axis, each with two cubes; four are at the query. The octree: the same below a root;
  // the quadtree: four of them, of which two are at the query.
  // The planes: x = 15.5 between the middles of the first and the last cube, then x = 5.5 and x = 25.5.
  const struct {
    const char *operation, *words;
    std::size_t entered, others;
  } expected[] = {
      {"bounding_volume_hierarchy",
       "In the textbook hierarchy of boxes, in double, the search for what meets in_box looked at 5 of 7 nodes and "
       "entered 3, and it compared 1 of 4 bodies.",
       3, 4},
      {"uniform_grid",
       "In the textbook uniform grid, in double, the search for what meets in_box looked at 8 of 8 cells and entered "
       "4, "
       "and it compared 2 of 4 bodies.",
       4, 4},
      {"quadtree",
       "In the textbook quadtree, in double, the search for what meets in_box looked at 5 of 5 cells and entered 3, "
       "and "
       "it compared 2 of 4 bodies.",
       3, 2},
      {"octree",
       "In the textbook octree, in double, the search for what meets in_box looked at 9 of 9 cells and entered 5, and "
       "it "
       "compared 2 of 4 bodies.",
       5, 4},
      {"bsp_tree",
       "In the textbook tree of planes, in double, the search for what meets in_box looked at 3 of 7 nodes and entered "
       "3, and it compared 1 of 4 bodies.",
       3, 4},
  };
  for (const auto& [operation, words, entered, others] : expected) {
    INFO(operation);
    const Drawing drawing = drawing_of_input(operation, four_cubes(around_the_first));
    CHECK(drawing.search == words);
    CHECK(nodes(drawing, true) == entered);
    CHECK(nodes(drawing, false) == others);
  }
}

TEST_CASE(
    "search figures: what is searched for comes first, then the bodies by name; the truth's own are drawn again") {
  const Drawing drawing = drawing_of_input("octree", four_cubes(around_the_first));
  CHECK(labels(drawing, false) == std::vector<std::string>{"in_box", "body[0]", "body[1]", "body[2]", "body[3]"});
  CHECK(labels(drawing, true) == std::vector<std::string>{""});
  CHECK(drawing.space.back().numbers != drawing.space[drawing.space.size() - 2].numbers);
  const auto met = std::find_if(drawing.space.begin(), drawing.space.end(), [](const auto& f) { return f.answer; });
  CHECK(met->numbers == std::vector<double>{0, 0, 0, 1, 1, 1});
  // Of a row without a structure the same, and no nodes.
  const Drawing plain = drawing_of_input("broad_phase", four_cubes(around_the_first));
  CHECK(labels(plain, false) == labels(drawing, false));
  CHECK(labels(plain, true) == labels(drawing, true));
  CHECK((plain.search.empty() && nodes(plain, true) + nodes(plain, false) == 0));
}

TEST_CASE("search figures: bodies keep their names when others go, come and move; the last query is drawn") {
  const Drawing drawing =
      drawing_of_input("bounding_volume_hierarchy",
                       four_cubes(R"({"ask":"pairs"},{"remove":0},{"insert":)" + box(40) + R"(},{"move":3,"box":)" +
                                  box(50) + R"(},{"at_point":[40.5,0.5,0.5]},{"remove":1})"));
  CHECK(labels(drawing, false) == std::vector<std::string>{"at_point", "body[1]", "body[2]", "body[3]", "body[4]"});
  REQUIRE(labels(drawing, true).size() == 1);
  CHECK(drawing.space.back().numbers[0] == 40);
}

TEST_CASE("search figures: a ray is also drawn as far as it goes among the bodies") {
  for (const char* operation : {"bounding_volume_hierarchy", "broad_phase"}) {
    const Drawing drawing =
        drawing_of_input(operation, four_cubes(R"({"along_ray":{"origin":[-5,0.5,0.5],"direction":[2,0,0]}})"));
    CHECK(labels(drawing, true).size() == 4);
    const auto help = std::find_if(drawing.space.begin(), drawing.space.end(),
                                   [](const auto& f) { return f.kind == SpaceFigure::Kind::segment; });
    REQUIRE(help != drawing.space.end());
    CHECK(help->label.empty());
    CHECK(help->numbers == std::vector<double>{-3, 0.5, 0.5, 31, 0.5, 0.5});
  }
}

TEST_CASE("search figures: of all pairs the search of one body is drawn, and all are counted") {
  // The second cube touches the third alone. Each of the others compares itself; these two compare each other as well.
  const std::string input =
      R"({"boxes":[)" + box(0) + "," + box(10) + "," + box(11) + "," + box(30) + R"(],"commands":[{"ask":"pairs"}]})";
  const Drawing drawing = drawing_of_input("bounding_volume_hierarchy", input);
  // Halves: {0, 1} and {2, 3}. From body 1: the root, a half, body 0 (not met), body 1, the other half, body 2, and
  // body 3 (not met); entered: the root, both halves, bodies 1 and 2.
  CHECK(drawing.search ==
        "In the textbook hierarchy of boxes, in double, the search for what meets body 1 looked at 7 of 7 nodes and "
        "entered 5, and it compared 2 of 4 bodies. All pairs took one such search for each body, 6 comparisons; the "
        "loop over all pairs takes 6.");
  CHECK(labels(drawing, false)[0] == "box of body 1");
  REQUIRE(labels(drawing, true).size() == 1);
  const auto met = std::find_if(drawing.space.begin(), drawing.space.end(), [](const auto& f) { return f.answer; });
  CHECK(met->numbers[0] == 11);
}

TEST_CASE("search figures: balls of a hierarchy") {
  // Radius 1 at 0, 10, 20 and 30. Each search enters the root, a half and its own ball.
  const Drawing drawing = drawing_of_input(
      "sphere_hierarchy", R"({"spheres":[{"center":[0,0,0],"radius":1},{"center":[10,0,0],"radius":1},)"
                          R"({"center":[20,0,0],"radius":1},{"center":[30,0,0],"radius":1}]})");
  CHECK(drawing.search ==
        "In the textbook hierarchy of spheres, in double, the search for what meets body 0 looked at 5 of 7 nodes and "
        "entered 3, and it compared 1 of 4 bodies. All pairs took one such search for each body, 4 comparisons; the "
        "loop over all pairs takes 6.");
  CHECK(drawing.space[0].numbers == std::vector<double>{15, 0, 0, 16});
  CHECK(labels(drawing, false) ==
        std::vector<std::string>{"ball of body 0", "body[0]", "body[1]", "body[2]", "body[3]"});
  const Drawing boxes = drawing_of_input("sphere_hierarchy", R"({"boxes":[)" + box(0) + "," + box(0.5) + "]}");
  CHECK(labels(boxes, true).size() == 1);
  CHECK(drawing_of_input("sphere_hierarchy", R"({"spheres":[]})").search ==
        "No body is there: the textbook hierarchy of spheres has no nodes.");
}

TEST_CASE("search figures: planes cut the box around all bodies into the parts of their tree") {
  const Drawing drawing = drawing_of_input("bsp_tree", four_cubes(around_the_first));
  // Entered ones first, from the root down: two cuts and the part of the first cube.
  const auto reaches = [](const SpaceFigure& figure, const std::vector<double>& expected) {
    std::vector<double> ends{HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < figure.numbers.size(); ++i) {
      ends[i % 3] = std::min(ends[i % 3], figure.numbers[i]);
      ends[3 + i % 3] = std::max(ends[3 + i % 3], figure.numbers[i]);
    }
    // What is drawn is rounded; by less than a step of the picture, of which there are 200,000 along all cubes.
    for (std::size_t i = 0; i < 6; ++i) CHECK(std::fabs(ends[i] - expected[i]) < 31 / 2e5);
  };
  CHECK(drawing.space[0].kind == SpaceFigure::Kind::polygon);
  reaches(drawing.space[0], {15.5, 0, 0, 15.5, 1, 1});
  reaches(drawing.space[1], {5.5, 0, 0, 5.5, 1, 1});
  REQUIRE(drawing.space[2].kind == SpaceFigure::Kind::mesh);
  reaches(drawing.space[2], {0, 0, 0, 5.5, 1, 1});
  CHECK(drawing.space[2].faces.size() == 6);
}

TEST_CASE("search figures: a quadtree is drawn in the plane, as seen along z") {
  const Drawing drawing = drawing_of_input("quadtree", four_cubes(around_the_first));
  CHECK(drawing.space.empty());
  const auto query = std::find_if(drawing.figures.begin(), drawing.figures.end(),
                                  [](const Figure& figure) { return figure.label == "in_box"; });
  REQUIRE(query != drawing.figures.end());
  CHECK(query->numbers == std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1});
  const std::string svg = drawing_svg(drawing, "");
  const auto count = [&svg](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++found;
    return found;
  };
  CHECK(count("class=\"node face\"") == 3);     // those that were entered
  CHECK(count("class=\"node stroke\"") == 20);  // four edges of five cells
  CHECK(count("class=\"node dot\"") == 0);
  // A ray that comes straight down is a point.
  const Drawing down =
      drawing_of_input("quadtree", four_cubes(R"({"along_ray":{"origin":[0.5,0.5,9],"direction":[0,0,-1]}})"));
  const auto ray = std::find_if(down.figures.begin(), down.figures.end(),
                                [](const Figure& figure) { return figure.label == "along_ray"; });
  REQUIRE(ray != down.figures.end());
  CHECK(ray->kind == Figure::Kind::point);
}

TEST_CASE("search figures: no bodies, one, and many that are equal") {
  for (const std::string& operation : structures) {
    INFO(operation);
    const Drawing none = drawing_of_input(operation.c_str(), R"({"boxes":[],"commands":[{"ask":"pairs"}]})");
    CHECK_THAT(none.search, ContainsSubstring("No body is there: "));
    CHECK((none.space.empty() && none.figures.empty()));
    CHECK_THAT(search_caption(none), ContainsSubstring("No body is there: "));
    const Drawing asked = drawing_of_input(operation.c_str(), R"({"boxes":[],"commands":[)" + around_the_first + "]}");
    CHECK(asked.space.size() + asked.figures.size() == 1);
    const Drawing one =
        drawing_of_input(operation.c_str(), R"({"boxes":[)" + box(0) + R"(],"commands":[{"ask":"pairs"}]})");
    CHECK_THAT(one.search, ContainsSubstring("looked at 1 of 1 ") && ContainsSubstring(" compared 1 of 1 body."));
    CHECK_THAT(one.search, ContainsSubstring("1 comparison; the loop over all pairs takes 0."));
    const Drawing unasked = drawing_of_input(operation.c_str(), R"({"boxes":[)" + box(0) + R"(],"commands":[]})");
    CHECK(unasked.search.empty());
    CHECK(search_caption(unasked).empty());
  }
  std::string equal = box(0);
  for (int i = 1; i < 20; ++i) equal += "," + box(0);
  // Each is in every cell: 1 + 8 + 64 + 512 + 4096 of them.
  const Drawing drawing = drawing_of_input("octree", R"({"boxes":[)" + equal + R"(],"commands":[{"ask":"pairs"}]})");
  CHECK_THAT(drawing.search,
             ContainsSubstring("looked at 4681 of 4681 cells and entered 4681, and it compared 20 of 20"));
  CHECK_THAT(drawing.search, ContainsSubstring(" more are not drawn."));
  CHECK(nodes(drawing, true) == 160);
  CHECK(labels(drawing, true).size() == 19);
  CHECK(drawing_of_input("bsp_tree", R"({"boxes":[)" + equal + R"(],"commands":[{"ask":"pairs"}]})")
            .search.find("looked at 1 of 1 node ") != std::string::npos);
}

TEST_CASE("search figures: planes as boxes that reach to the greatest double are drawn within the frame") {
  const std::string most = "1.7976931348623157e308";
  const std::string all =
      R"({"min":[-M,-M,-M],"max":[M,M,M]},{"min":[-M,-M,-M],"max":[0,M,M]},{"min":[0,0,0],"max":[1,1,1]})";
  std::string input = R"({"boxes":[)" + all + R"(],"commands":[{"at_point":[0,0,0]}]})";
  for (std::size_t at; (at = input.find('M')) != std::string::npos;) input.replace(at, 1, most);
  for (const std::string& operation : structures) {
    INFO(operation);
    const Drawing drawing = drawing_of_input(operation.c_str(), input);
    CHECK_THAT(drawing.search, ContainsSubstring(" of 3 bodies."));
    const std::string svg = drawing_svg(drawing, "");
    CHECK_THAT(svg, !ContainsSubstring("nan") && !ContainsSubstring("inf"));
    if (drawing.space.empty()) continue;
    const Json model = space_model(drawing, "");
    std::size_t bodies = 0;
    for (const Json& figure : model["figures"]) {
      bodies += figure["label"].get<std::string>().rfind("body[", 0) == 0;
      for (const Json& point : figure["points"])
        for (const Json& coordinate : point) CHECK(std::abs(coordinate.get<int>()) <= 100000);
    }
    CHECK(bodies == 3);
  }
}

TEST_CASE("search figures: a program that is refused has no search") {
  const Operation& operation = *find_operation("octree");
  const Question question = operation.parse(parse_line(four_cubes(R"({"remove":0},{"remove":0},{"ask":"pairs"})")));
  try {
    operation.examine(question)->drawing();
    FAIL("not refused");
  } catch (const InvalidInput& refused) {
    const Drawing drawing = drawing_of_refused(operation, question, refused);
    CHECK(search_caption(drawing).empty());
    CHECK(nodes(drawing, true) + nodes(drawing, false) == 0);
  }
}

TEST_CASE("search figures: a page says what its lines mean, and its script draws the nodes") {
  const Drawing drawing = drawing_of_input("octree", four_cubes(around_the_first));
  const std::string caption = search_caption(drawing);
  for (const char* words : {"looked at 9 of 9 cells", ">in_box<", ">a body<", ">which it meets, by the truth<",
                            ">a part of the structure, thinner the deeper<", ">entered by the search<"})
    CHECK_THAT(caption, ContainsSubstring(words));
  const std::string far_away = R"({"in_box":)" + box(-5) + "}";
  CHECK_THAT(search_caption(drawing_of_input("octree", four_cubes(far_away))), !ContainsSubstring("by the truth"));
  const std::string html = page("search", space_figure(drawing, "a search"));
  CHECK_THAT(html, ContainsSubstring(
                       "<noscript><p>In space: 9 \u00d7 node, box in_box, box body, truth: box, 3 \u00d7 box body; "));
  CHECK_THAT(html, ContainsSubstring("looked at 9 of 9 cells"));
  if (!there_is_node()) return;
  const std::string svg = lines_of_node("drawn_page.mjs", html, {})[0];
  CHECK_THAT(svg, ContainsSubstring("class=\"node face\"") && ContainsSubstring("class=\"node stroke\""));
}

TEST_CASE("search figures: an operation's page has a search for each sort of query") {
  const std::string section = search_section(*find_operation("quadtree"));
  for (const char* query : {">in_box<", ">at_point<", ">along_ray<", ">box of body "})
    CHECK_THAT(section, ContainsSubstring(query));
  CHECK(search_section(*find_operation("orientation")).empty());
  CHECK(search_section(*find_operation("broad_phase")).empty());
}

}  // namespace touchstone::proptests::search_figures_tests
