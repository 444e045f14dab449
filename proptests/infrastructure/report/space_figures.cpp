// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "catalogue/draw/figures.h"
#include "catalogue/draw/motions.h"
#include "catalogue/numbers/ulps.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/report/in_node.h"
#include "proptests/uses.h"
#include "report/figures/space_model.h"
#include "report/parts/html_parts.h"
#include "report/words/answered.h"

/// Scenes in space as a page holds them; what its script draws of them: viewer.mjs.
namespace touchstone::proptests::space_figures_tests {
namespace {

template <class Shape>
void ask_for(Drawing& scene, const std::string& label, const Shape& shape) {
  draw(scene, label, shape, false);
}

Drawing every_kind() {
  Drawing scene;
  ask_for(scene, "p", Point3d{1, 2, 3});
  ask_for(scene, "v", Vector3d{1, 0, 0});
  ask_for(scene, "plane", Plane3d{{0, 1, 0}, -1});
  ask_for(scene, "polygon", Polygon3d{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}});
  ask_for(scene, "box", Aabb3d{{0, 0, 0}, {1, 1, 1}});
  ask_for(scene, "sphere", Sphere3d{{0, 0, 0}, 1});
  ask_for(scene, "mesh", Meshd{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  scene.space.push_back({SpaceFigure::Kind::segment, "segment", {0, 0, 0, 1, 1, 1}});
  draw(scene, "point", Point3d{0, 1, 0}, true);
  return scene;
}

}  // namespace

TEST_CASE("figures in space: between 5e-324 and 1.7e308 every point is within the box of steps") {
  Drawing scene;
  ask_for(scene, "a", Point3d{1e308, -1e308, 5e-324});
  ask_for(scene, "b", Sphere3d{{0, 0, 0}, 1.7e308});
  ask_for(scene, "plane", Plane3d{{5e-324, 1e308, 0}, 1e308});
  const Json model = space_model(scene, "huge");
  REQUIRE(model["figures"].size() == 3);
  CHECK(model["figures"][1]["radius"] == 100000);
  for (const Json& figure : model["figures"])
    for (const Json& point : figure["points"])
      for (const Json& coordinate : point) CHECK(std::abs(coordinate.get<int>()) <= 100000);
}

TEST_CASE("figures in space: a mesh without faces is the point, the segment or the triangle of its vertices") {
  Drawing scene;
  std::vector<Point3d> vertices;
  for (const double x : {0, 1, 2}) {
    vertices.push_back({x, x * x, 0});
    ask_for(scene, "core", Meshd{vertices, {}, {}});
  }
  REQUIRE(scene.space.size() == 3);
  CHECK(scene.space[0].kind == SpaceFigure::Kind::point);
  CHECK(scene.space[1].kind == SpaceFigure::Kind::polygon);
  CHECK(scene.space[1].numbers == std::vector<double>{0, 0, 0, 1, 1, 0});
  CHECK(scene.space[2].kind == SpaceFigure::Kind::polygon);
  CHECK(scene.space[2].numbers == std::vector<double>{0, 0, 0, 1, 1, 0, 2, 4, 0});
}

TEST_CASE("figures in space: a body that moves says where it is before and after, in the scene's steps") {
  Drawing scene;
  ask_for(scene, "still", Point3d{-1, 0, 0});
  ask_for(scene, "a", Point3d{1, 0, 0});
  let_move(scene, {1, 0, 0}, {0, 0.5, 0});
  ask_for(scene, "overflows", Point3d{1, 0, 0});
  let_move(scene, {0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0});
  ask_for(scene, "gets far away", Point3d{1, 0, 0});
  let_move(scene, {0, 0, 0}, {0, 0, 1e300});
  ask_for(scene, "does not move", Point3d{1, 0, 0});
  let_move(scene, {0, 0, 0}, {0, 0, 0});
  const Json figures = space_model(scene, "moving")["figures"];
  CHECK(figures[1]["moves"] == Json({{-100000, 0, 0}, {0, 50000, 0}}));
  for (const std::size_t i : {0, 2, 3, 4}) CHECK(!figures[i].contains("moves"));
}

TEST_CASE("figures in space: a swept body and its velocity move on, a bounce turns") {
  Drawing sweep, bounce;
  draw_sweep(sweep, "ball", Sphere3d{{0, 0, 0}, 1}, Vector3d{2, 0, 0}, std::optional(0.5));
  REQUIRE(sweep.space.front().moves);
  CHECK(sweep.space.front().moves->at_minus_1 == std::array<double, 3>{0, 0, 0});
  CHECK(sweep.space.front().moves->at_1 == std::array<double, 3>{2, 0, 0});
  draw_bounce(bounce, {1, -2, 0}, {0, 1, 0}, {1, 2, 0});
  REQUIRE(bounce.space.front().moves);
  CHECK(bounce.space.front().moves->at_minus_1 == std::array<double, 3>{-1, 2, 0});
  CHECK(bounce.space.front().moves->at_1 == std::array<double, 3>{1, 2, 0});
}

TEST_CASE("figures in space: neighbouring doubles are two places") {
  Drawing scene;
  ask_for(scene, "a", Point3d{1, 0, 0});
  ask_for(scene, "b", Point3d{1 + 0x1p-52, 0, 0});
  const Json model = space_model(scene, "near");
  CHECK(model["figures"][0]["points"] == Json({{-100000, 0, 0}}));
  CHECK(model["figures"][1]["points"] == Json({{100000, 0, 0}}));
  CHECK(model["spans"][0] == "x: 1 \u00b1 1.1e-16");
}

TEST_CASE(
    "figures in space: a plane is shown where it is nearest to the rest, its normal of one length for all sizes") {
  for (const double size : {1.0, 1e300, 0x1p-1074}) {
    Drawing scene;
    ask_for(scene, "a", Point3d{-1, 0, 0});
    ask_for(scene, "b", Point3d{1, 2, 0});
    ask_for(scene, "plane", Plane3d{{0, -size, 0}, 0});
    CHECK(space_model(scene, "")["figures"][2]["points"] == Json({{0, -100000, 0}, {0, -140000, 0}}));
  }
}

TEST_CASE("figures in space: a thin scene is stretched and says so, one with a sphere is not and has a bar") {
  Drawing scene;
  ask_for(scene, "box", Aabb3d{{0, 0, 0}, {100, 1, 100}});
  const Json thin = space_model(scene, "");
  CHECK(thin["remarks"] == Json({"y stretched 50 times"}));  // to half of the longest side
  CHECK_FALSE(thin.contains("bar"));
  ask_for(scene, "sphere", Sphere3d{{50, 0, 50}, 50});
  const Json round = space_model(scene, "");
  CHECK(round["remarks"].empty());
  CHECK(round["bar"] == Json({40000.0, "20"}));
}

TEST_CASE("figures in space: a gap too narrow to be seen is magnified, a touch and a gap that is seen are not") {
  const auto words = [](const auto& a, const auto& b, const mpq_class& least = 0) {
    Drawing scene;
    ask_for(scene, "a", a);
    ask_for(scene, "b", b);
    const Json model = space_model(scene, "", least);
    CHECK_FALSE(space_model(scene, "").contains("lens"));
    return model.contains("lens") ? model["lens"]["spans"][0].get<std::string>() : "";
  };
  const double hair = 0x1p-40;  // 9.09e-13
  const Sphere3d ball{{0, 0, 0}, 1};
  const Triangle3d triangle{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}};
  const Aabb3d cube{{0, 0, 0}, {1, 1, 1}};
  const std::string around_a = "around a, 7.28e-12 wide; gap 9.09e-13",
                    around_b = "around b, 7.28e-12 wide; gap 9.09e-13";
  CHECK(words(ball, Sphere3d{{0, 3 + hair, 0}, 2}) == around_a);
  CHECK(words(ball, Sphere3d{{0, 3, 0}, 2}).empty());
  CHECK(words(ball, Sphere3d{{0, 4, 0}, 2}).empty());
  CHECK(words(ball, Plane3d{{0, 2, 0}, 2 - 2 * hair}) == around_a);  // it cuts the ball a hair above its lowest point
  CHECK(words(Plane3d{{0, 1, 0}, 1 + hair}, ball) == around_b);
  CHECK(words(triangle, Point3d{3, 0, 3}).empty());
  CHECK(words(triangle, Segment3d{{1, hair, 1}, {1, 4, 1}}) == around_a);
  // Two edges that cross; the normal of both is (1, -1, -2), so the gap is 2 / sqrt(6) of a hair.
  CHECK(words(Segment3d{{-1, -1, 0}, {1, 1, 0}}, Segment3d{{-1, 1, -1 + hair}, {1, -1, 1 + hair}}) ==
        "around a, 5.94e-12 wide; gap 7.43e-13");
  // Of a flat scene its height is stretched, and the gap is seen.
  CHECK(words(triangle, Point3d{1, hair, 1}).empty());
  CHECK(words(cube, Aabb3d{{1 + hair, 0.5, 0.5}, {2, 2, 2}}) == around_a);
  CHECK(words(cube, Aabb3d{{1, 0.5, 0.5}, {2, 2, 2}}).empty());
  CHECK(words(ball, Point3d{0, -1 - hair, 0}) == around_a);
  // A gap that is narrower than what decides is an accident.
  CHECK(words(ball, Point3d{0, -1 - hair, 0}, exact_value(hair / 2)) == around_a);
  CHECK(words(ball, Point3d{0, -1 - hair, 0}, exact_value(2 * hair)).empty());
}

TEST_CASE("figures in space: a lens shows what is around the gap, level with the screen") {
  Drawing scene;
  ask_for(scene, "plane", Plane3d{{0, 1, 0}, 0});
  ask_for(scene, "far", Point3d{5, 5, 5});
  ask_for(scene, "near", Point3d{1, 0x1p-40, 1});
  const Json model = space_model(scene, "", mpq_class(0)), lens = model["lens"];
  CHECK(lens["mark"] == model["figures"][2]["points"][0]);
  CHECK(lens["figures"][1]["points"].empty());  // out of its sight
  CHECK(lens["figures"][2]["points"] == Json({{0, 0, 0}}));
  for (const Json& corner : lens["figures"][0]["points"]) CHECK(corner[1] == -25000);  // a gap of four to its border
  CHECK(lens["turn"]["sinPitch"] == 0.0);                                              // the gap is upright
}

TEST_CASE("figures in space: a plane without a normal and an infinite point are not drawn") {
  Drawing scene;
  ask_for(scene, "plane", Plane3d{{0, 0, 0}, 1});
  ask_for(scene, "point", Point3d{HUGE_VAL, 0, 0});
  CHECK(space_figure(scene, "nothing").empty());
}

TEST_CASE("figures in space: a page says in words what its script draws, and has the script with it") {
  const std::string html = page("figures", space_figure(every_kind(), "every kind"));
  CHECK_THAT(html, ContainsSubstring("<noscript><p>In space: point p, arrow v, plane plane, polygon polygon, box box, "
                                     "sphere sphere, mesh mesh, segment segment, truth: point point; x: -1 to 1"));
  CHECK_THAT(html, ContainsSubstring("; p: (1, 2, 3)"));
  if (!there_is_node()) return;
  const std::vector<Json> drawn = lines_of_node("drawn_page.mjs", html, {});
  REQUIRE(drawn.size() == 1);
  const std::string svg = drawn[0];
  for (const char* label : {"p", "v", "plane", "polygon", "box", "sphere", "mesh", "segment", "truth: point"})
    CHECK_THAT(svg, ContainsSubstring(std::string(">") + label + "</text>"));
  CHECK_THAT(svg, ContainsSubstring("<title>every kind</title>"));
  CHECK_THAT(svg, !ContainsSubstring("NaN"));
}

TEST_CASE("figures in space: a wrong point is drawn beside the truth, the right one is not drawn twice") {
  const Operation& operation = *find_operation("closest_point_on_aabb");
  Drawing scene;
  ask_for(scene, "sphere", Sphere3d{{0, 0, 0}, 1});
  draw(scene, "point", Point3d{0, 1, 0}, true);
  const Question question{{-1, -1, -1, 1, 1, 1, 0, 2, 0}, {1}};
  draw_answered(scene, operation, Json::parse(R"({"point":[0,1,0]})"), question);
  CHECK(scene.space.size() == 2);
  draw_answered(scene, operation, Json::parse(R"({"point":[0,1,0.5]})"), question);
  REQUIRE(scene.space.size() == 3);
  CHECK(scene.space[2].said);
}

}  // namespace touchstone::proptests::space_figures_tests
