// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "catalogue/figures.h"
#include "proptests/catch.h"
#include "report/answered.h"
#include "report/space_model.h"
#include "report/space_svg.h"

/// Scenes in space as the report draws them.
namespace touchstone::audit {
namespace {

template <class Shape>
void ask_for(Drawing& scene, const std::string& label, const Shape& shape) {
  draw(scene, label, shape, false);
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++times;
  return times;
}

}  // namespace

TEST_CASE("figures in space: 5e-324 beside 1e308 gives finite pixels") {
  Drawing scene;
  ask_for(scene, "a", Point3d{1e308, -1e308, 5e-324});
  ask_for(scene, "b", Sphere3d{{0, 0, 0}, 1.7e308});
  ask_for(scene, "plane", Plane3d{{5e-324, 1e308, 0}, 1e308});
  const std::string svg = space_svg(scene, "huge");
  CHECK(has_space_svg(svg));
  CHECK(times_in(svg, "nan") == 0);
  CHECK(times_in(svg, "inf") == 0);
  const SpaceModel model = space_model(scene);
  for (const SpacePoint& p : model.points) CHECK(std::hypot(p.x, p.y, p.z) <= model.reach);
}

TEST_CASE("figures in space: neighbouring doubles are two places") {
  Drawing scene;
  ask_for(scene, "a", Point3d{1, 0, 0});
  ask_for(scene, "b", Point3d{1 + 0x1p-52, 0, 0});
  const SpaceModel model = space_model(scene);
  REQUIRE(model.points.size() >= 2);
  CHECK(model.points[0].x == -steps_of_box);
  CHECK(model.points[1].x == steps_of_box);
}

TEST_CASE("figures in space: of a box from before, above and the right three faces look at the reader") {
  Drawing scene;
  ask_for(scene, "box", Aabb3d{{0, 0, 0}, {1, 1, 1}});
  CHECK(times_in(space_svg(scene, "box"), "q0 stroke hid") == 3);  // the edges of the one corner that is behind
}

TEST_CASE("figures in space: a plane without a normal, an infinite point and a face without its vertex are not drawn") {
  Drawing scene;
  ask_for(scene, "plane", Plane3d{{0, 0, 0}, 1});
  ask_for(scene, "point", Point3d{HUGE_VAL, 0, 0});
  CHECK(space_svg(scene, "nothing").empty());
  ask_for(scene, "mesh", Meshd{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 7}}});
  CHECK(space_model(scene).items.size() == 2);  // the vertices alone
}

TEST_CASE("figures in space: a wrong point is drawn beside the truth, the right one is not drawn twice") {
  Drawing scene;
  ask_for(scene, "sphere", Sphere3d{{0, 0, 0}, 1});
  draw(scene, "point", Point3d{0, 1, 0}, true);
  draw_answered(scene, Json::parse(R"({"point":[0,1,0]})"));
  CHECK(scene.space.size() == 2);
  draw_answered(scene, Json::parse(R"({"point":[0,1,0.5]})"));
  REQUIRE(scene.space.size() == 3);
  CHECK(scene.space[2].said);
}

}  // namespace touchstone::audit
