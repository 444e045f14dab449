// SPDX-License-Identifier: Apache-2.0
#include "proptests/infrastructure/simulate/scene_text.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::scene_files_tests {
namespace {

std::string refusal_of(const std::string& scene) {
  return proptests::refusal_of([&] { scene_from(scene); });
}

const std::string step = R"("timestep":0.5,"option":1)";
const std::string body = particle("[0,1,0]", "[0,0,0]");

std::string with_body(const std::string& one) { return scene_text(step, "\"bodies\":[" + one + "]"); }
std::string with_advance(const std::string& advance) { return scene_text(advance, "\"bodies\":[" + body + "]"); }
std::string with(const std::string& field) { return scene_text(step, field + ",\"bodies\":[" + body + "]"); }

}  // namespace

TEST_CASE("scene files: what is left out has its default") {
  const simulate::Scene scene = scene_from(with_body(R"({"shape":{"particle":{}},"position":[0,"0x1.8p+0",0]})"));
  CHECK(scene.settings.steps == 600);
  CHECK(scene.settings.motion == simulate::Motion::accelerate_then_move);
  CHECK(scene.settings.turn == simulate::Turn::before_move);
  CHECK(scene.settings.law == simulate::Law::restitution);
  CHECK(scene.settings.restitution == 1);
  CHECK(scene.gravity.y == 0);
  REQUIRE(scene.bodies.size() == 1);
  CHECK(scene.bodies[0].name == "bodies[0]");
  CHECK(scene.bodies[0].mass == 1);
  CHECK(!scene.bodies[0].fixed);
  CHECK(numbers_of(scene.start()) == std::vector<double>{0, 1.5, 0, 0, 0, 0});
}

TEST_CASE("scene files: a rate of steps is the double nearest to its reciprocal") {
  CHECK(scene_from(with_advance(R"("steps_per_second":60,"option":2)")).settings.timestep == 1.0 / 60);
}

TEST_CASE("scene files: a room is six walls that look inwards") {
  const simulate::Scene scene = scene_from(with(R"("room":{"min":[-1,-2,-3],"max":[4,5,6]})"));
  REQUIRE(scene.walls.size() == 6);
  CHECK(scene.walls[2].name == "room.min.y");
  CHECK(scene.walls[2].plane.normal.y == 1);
  CHECK(scene.walls[2].plane.offset == 2);
  CHECK(scene.walls[5].plane.normal.z == -1);
  CHECK(scene.walls[5].plane.offset == 6);
}

TEST_CASE("scene files: what is wrong is told by place, rule and what was found") {
  const std::pair<std::string, std::string> wrong[]{
      {"[]", "scene: expected an object, got []"},
      {R"({"touchstone_scene":2})", "touchstone_scene: expected 1, the version that this program reads, got 2"},
      {R"({"touchstone_scene":1})", "advance: missing"},
      {R"({"touchstone_scene":1,"advnace":{}})",
       R"(advnace: no such field (did you mean "advance"?); expected advance)"},
      {scene_text(step, "\"bodies\":[]"), "bodies: at least one"},
      {with("\"gravty\":[0,0,0]"), R"(gravty: no such field (did you mean "gravity"?); expected touchstone_scene, )"
                                   "title, about, deck_pages, gravity, advance, response, room, walls, bodies"},
      {with("\"gravity\":[0,0]"), "gravity: expected an array of 3, got [0,0]"},
      {with("\"gravity\":[0,\"x\",0]"), "gravity[1]: expected a number, got \"x\""},
      {with("\"gravity\":[0,1e999,0]"), "gravity[1]: finite number"},
      {with("\"deck_pages\":[75]"), "deck_pages[0]: expected a page of the deck, 1 to 74, got 75"},
      {with_advance(R"("option":1)"), R"(advance: expected timestep or steps_per_second, got {"option":1})"},
      {with_advance(R"("timestep":0,"option":1)"), "advance.timestep: expected a number greater than 0, got 0"},
      {with_advance(R"("steps_per_second":0,"option":1)"),
       "advance.steps_per_second: expected an integer from 1 up, got 0"},
      {with_advance(R"("timestep":1,"option":3)"), "advance.option: expected 1 or 2, of p. 23, got 3"},
      {with_advance(R"("timestep":1,"option":2,"turn":"before_move")"), "advance.turn: is for option 1"},
      {with_advance(R"("timestep":1,"option":1,"moments":3)"), "advance.moments: is for option 2"},
      {with_advance(R"("timestep":1,"option":1,"motion":"parabel")"),
       "advance.motion: expected accelerate_then_move | move_then_accelerate | parabola, got \"parabel\" "
       R"((did you mean "parabola"?))"},
      {with(R"("response":{"law":"restitution","restitution":1.5})"),
       "response.restitution: expected a number from 0 to 1, got 1.5"},
      {with(R"("response":{"law":"penalty"})"), "response.stiffness: missing"},
      {with(R"("response":{"law":"stick","restitution":1})"), "response.restitution: no such field; expected law"},
      {with(R"("walls":[{"normal":[0,0,0],"offset":0}])"), "walls[0].normal: nonzero normal"},
      {with(R"("room":{"min":[0,0,0],"max":[1,1,0]})"),
       R"(room: expected min below max on each axis, got {"min":[0,0,0],"max":[1,1,0]})"},
      {with_body(R"({"shape":{"sphere":{"radius":0}},"position":[0,0,0]})"),
       "bodies[0].shape.sphere.radius: expected a number greater than 0, got 0"},
      {with_body(R"({"shape":{"sphere":{}},"position":[0,0,0]})"), "bodies[0].shape.sphere.radius: missing"},
      {with_body(R"({"shape":{"spere":{"radius":1}},"position":[0,0,0]})"),
       R"(bodies[0].shape.spere: no such field (did you mean "sphere"?); expected particle, sphere, box)"},
      {with_body(R"({"shape":{},"position":[0,0,0]})"),
       "bodies[0].shape: expected one of particle, sphere, box, got {}"},
      {with_body(R"({"shape":{"box":{"half_extents":[1,-1,1]}},"position":[0,0,0]})"),
       "bodies[0].shape.box.half_extents: expected numbers not below 0, got [1,-1,1]"},
      {with_body(R"({"shape":{"particle":{}},"position":[0,0,0],"mass":0})"),
       "bodies[0].mass: expected a number greater than 0, got 0"},
      {with_body(R"({"shape":{"particle":{}},"position":[0,0,0],"fixed":true,"velocity":[0,0,0]})"),
       "bodies[0].velocity: a fixed body has none"},
      {with_body(R"({"name":"a","shape":{"particle":{}},"position":[0,0,0]},)"
                 R"({"name":"a","shape":{"particle":{}},"position":[1,0,0]})"),
       "bodies[1].name: expected a name that no other has, got \"a\""}};
  for (const auto& [scene, refusal] : wrong) CHECK(refusal_of(scene) == refusal);
}

TEST_CASE("scene files: bodies may touch at the start, and not overlap; a subnormal overlap is one") {
  const auto at = [](const std::string& y) {
    return scene_text(step, floor_of_scene + ",\"bodies\":[" + sphere(1, "[0," + y + ",0]", "[0,0,0]") + "]");
  };
  CHECK(refusal_of(at("1")) == "accepted");
  CHECK(refusal_of(at("0.9999999999999999")) == "bodies[0].position: overlaps floor at the start");
  const std::string on_floor = ",\"bodies\":[" + particle("[0,0,0]", "[0,0,0]") + "]";
  CHECK(refusal_of(scene_text(step, floor_of_scene + on_floor)) == "accepted");
  const std::string under_floor = ",\"bodies\":[" + particle("[0,-5e-324,0]", "[0,0,0]") + "]";
  CHECK(refusal_of(scene_text(step, floor_of_scene + under_floor)) ==
        "bodies[0].position: overlaps floor at the start");
  const auto two = [](const std::string& x) {
    return with_body(sphere(0.5, "[0,0,0]", "[0,0,0]") + "," + sphere(0.5, "[" + x + ",0,0]", "[0,0,0]"));
  };
  CHECK(refusal_of(two("1")) == "accepted");
  CHECK(refusal_of(two("0.9999999999999999")) == "bodies[1].position: overlaps bodies[0] at the start");
}

TEST_CASE("scene files: of many bodies only those that are near each other are compared for an overlap") {
  // All pairs of these would take minutes.
  constexpr int n = 30'000;
  const auto text = [](int last) {
    std::string balls;
    for (int i = 0; i <= n; ++i) {
      const int at = i < n ? i : last;
      balls += (i == 0 ? "" : ",") +
               sphere(0.25, "[" + std::to_string(at % 100) + "," + std::to_string(at / 100) + ",0]", "[0,0,0]");
    }
    return scene_text(step, "\"bodies\":[" + balls + "]");
  };
  CHECK(refusal_of(text(n)) == "accepted");
  CHECK(refusal_of(text(777)) == "bodies[30000].position: overlaps bodies[777] at the start");
}

TEST_CASE("scene files: springs hold particles alone; with option 2 and parabola no body is fixed") {
  const std::string ball = sphere(1, "[0,5,0]", "[0,0,0]");
  const std::string box = R"({"shape":{"box":{"half_extents":[1,1,1]}},"position":[9,9,9]})";
  CHECK(refusal_of(
            scene_text(step, R"("response":{"law":"penalty","stiffness":9},"bodies":[)" + body + "," + ball + "]")) ==
        "bodies[1].shape: with the law penalty all bodies are particles (p. 72)");
  CHECK(refusal_of(scene_text(R"("timestep":1,"option":2)", "\"bodies\":[" + ball + "," + box + "]")) == "accepted");
  const std::string still = R"({"fixed":true,"shape":{"particle":{}},"position":[0,0,0]})";
  CHECK(refusal_of(
            scene_text(R"("timestep":1,"option":2,"motion":"parabola")", "\"bodies\":[" + ball + "," + still + "]")) ==
        "bodies[1].fixed: none with option 2 and parabola: when a body falls onto one is a root of a polynomial of "
        "degree 4; walls are for it");
  CHECK(refusal_of(with_body(ball + "," + box)) == "accepted");
}

}  // namespace touchstone::proptests::scene_files_tests
