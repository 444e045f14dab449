// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/flights.h"

#include "proptests/infrastructure/simulate/scene_text.h"
#include "simulate/simulation.h"

/// Option 2 with spheres and boxes in one scene, and along parabolas.
namespace touchstone::proptests::flights_tests {
namespace {

using catalogue::Exact;
using simulate::Scene;
using simulate::Simulation;

const std::string gravity = "\"gravity\":[0,-2,0],";

Scene of(const std::string& advance, const std::string& bodies, const std::string& more = "") {
  return scene_from(scene_text(advance, more + floor_of_scene + ",\"bodies\":[" + bodies + "]"));
}
Scene falling(const std::string& timestep, const std::string& restitution, const std::string& bodies) {
  return of("\"option\":2,\"motion\":\"parabola\",\"timestep\":" + timestep, bodies,
            gravity + R"("response":{"law":"restitution","restitution":)" + restitution + "},");
}

/// After each step, what every run has: all three where all numbers are exact.
void require_states(const Scene& scene, const std::vector<std::vector<double>>& expected) {
  Simulation simulation(scene, {"float", "double", "robust"});
  for (const std::vector<double>& numbers : expected) {
    simulation.advance();
    for (std::size_t i = 0; i < simulation.size(); ++i) {
      INFO(simulation.run(i).name() << " after step " << simulation.step());
      CHECK(numbers_of(simulation.run(i).now().state) == numbers);
    }
  }
}

std::string fixed_box(const std::string& half, const std::string& position) {
  return R"({"fixed":true,"shape":{"box":{"half_extents":)" + half + R"(}},"position":)" + position + "}";
}

}  // namespace

TEST_CASE("flight: with a factor of 1/2 a particle rises to a quarter of the height, then slides") {
  const Scene scene = falling("1", "0.5", particle("[0,1,0]", "[1,0,0]"));
  // It falls for 1, rises to 1/4 for 1 in all, then to 1/16 for 1/2; all later bounces take 1/2 together.
  require_states(scene, {{1, 0, 0, 1, 1, 0}, {2, 0, 0, 1, 0.5, 0}, {3, 0, 0, 1, 0, 0}, {4, 0, 0, 1, 0, 0}});
  Simulation simulation(scene, {"float", "double", "robust"});
  const std::vector<double> rises{0.25, 0.0625, 0.015625};
  for (const double rise : rises) {
    simulation.advance();
    for (std::size_t i = 0; i < simulation.size(); ++i) {
      REQUIRE(simulation.run(i).now().impacts.size() == 1);
      CHECK(simulation.run(i).now().impacts[0].rise == rise);
      CHECK(simulation.run(i).now().drift.scheme == 0);
    }
  }
  for (std::size_t i = 0; i < simulation.size(); ++i) CHECK(simulation.run(i).drift().law == -2);  // m g h
}

TEST_CASE("flight: bounces that end within the step are one contact, and the step ends where they would have ended") {
  const Scene scene = falling("4", "0.5", particle("[0,1,0]", "[1,0,0]"));
  require_states(scene, {{4, 0, 0, 1, 0, 0}, {8, 0, 0, 1, 0, 0}});
  Simulation simulation(scene, {"robust"});
  simulation.advance();
  CHECK(simulation.run(0).now().impacts.size() == 1);
  simulation.advance();
  CHECK(simulation.run(0).now().impacts.empty());
}

TEST_CASE("flight: with a factor of 1 a particle meets the floor again and again, and keeps its height") {
  const Scene scene = falling("4", "1", particle("[0,1,0]", "[0,0,0]"));
  require_states(scene, {{0, 1, 0, 0, 0, 0}});
  Simulation simulation(scene, {"robust"});
  simulation.advance();
  CHECK(simulation.run(0).now().impacts.size() == 2);
}

TEST_CASE("flight: a ceiling is met on the way up, and a wall that the way only touches is not") {
  const std::string advance = R"("timestep":1,"option":2,"motion":"parabola")";
  const auto below = [&](const std::string& height) {
    return scene_from(scene_text(advance, gravity + R"("walls":[{"normal":[0,-1,0],"offset":)" + height +
                                              "}],\"bodies\":[" + particle("[0,0.25,0]", "[0,2,0]") + "]"));
  };
  require_states(below("1"), {{0, 0.25, 0, 0, -2, 0}});
  require_states(below("1.25"), {{0, 1.25, 0, 0, 0, 0}});
  const Scene grazing = below("1.25");
  Simulation simulation(grazing, {"robust"});
  simulation.advance();
  CHECK(simulation.run(0).now().impacts.empty());
}

TEST_CASE("flight: balls that fall together meet as if nothing fell") {
  std::string heavy = sphere(1, "[3,5,0]", "[0,0,0]");
  heavy.insert(1, "\"mass\":3,");
  require_states(falling("1", "1", sphere(1, "[0,5,0]", "[4,0,0]") + "," + heavy),
                 {{-0.5, 4, 0, -2, -2, 0, 4.5, 4, 0, 2, -2, 0}});
}

TEST_CASE("flight: in a valley of two walls a ball at rest stays, on one slope it slides") {
  const auto on = [](const std::string& walls) {
    return scene_from(scene_text(R"("timestep":1,"option":2,"motion":"parabola")",
                                 gravity + R"("response":{"law":"restitution","restitution":0},"walls":[)" + walls +
                                     "],\"bodies\":[" + particle("[0,0,0]", "[0,0,0]") + "]"));
  };
  const std::string left = R"({"normal":[1,1,0],"offset":0})", right = R"({"normal":[-1,1,0],"offset":0})";
  require_states(on(left + "," + right), {{0, 0, 0, 0, 0, 0}});
  // (0, -2) less its part along (1, 1) is (1, -1).
  require_states(on(left), {{0.5, -0.5, 0, 1, -1, 0}});
}

TEST_CASE("flight: that a body at rest and one in free fall would meet is refused, and told") {
  const Scene scene = falling("2", "0.5", sphere(1, "[0,1,0]", "[0,0,0]") + "," + sphere(1, "[0,4,0]", "[0,0,0]"));
  Simulation simulation(scene, {"double"});
  CHECK_THROWS_WITH(simulation.advance(),
                    ContainsSubstring("step 1, run double: bodies[0] and bodies[1] come near each other, one at rest"));
}

TEST_CASE("flight: a ball meets the face, the edge and the corner of a box at its moment") {
  const struct {
    double radius;
    const char *position, *velocity;
    Vector3d normal;
  } balls[]{{1, "[-6,0.5,0.5]", "[8,0,0]", {-1, 0, 0}},
            {5, "[-8,5,0.5]", "[8,0,0]", {-3, 4, 0}},
            {7, "[-7,4,7]", "[8,0,0]", {-2, 3, 6}}};
  for (const auto& [radius, position, velocity, normal] : balls) {
    for (const bool first : {true, false}) {
      const std::string ball = sphere(radius, position, velocity), box = fixed_box("[1,1,1]", "[0,0,0]");
      const Scene scene = scene_from(scene_text(R"("timestep":1,"option":2)",
                                                "\"bodies\":[" + (first ? ball + "," + box : box + "," + ball) + "]"));
      Simulation simulation(scene, {"float", "double", "robust"});
      simulation.advance();
      for (std::size_t i = 0; i < simulation.size(); ++i) {
        REQUIRE(simulation.run(i).now().impacts.size() == 1);
        const simulate::Impact& impact = simulation.run(i).now().impacts[0];
        CHECK(impact.time == 0.5);
        CHECK((first ? 1 : -1) * dot(impact.normal, normal) == dot(normal, normal));
      }
    }
  }
}

TEST_CASE("flight: a swept ball meets a box where its distance comes to its radius, and not before") {
  std::uint64_t state = 7;
  const auto drawn = [&state](int most) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(2 * most + 1)) - most;
  };
  const mpq_class near(mpz_class(1), mpz_class(1) << 1000);
  std::size_t hits = 0, misses = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::array<mpq_class, 3> center{drawn(9), drawn(9), drawn(9)}, displacement{drawn(20), drawn(20), drawn(20)},
        half{std::abs(drawn(3)), std::abs(drawn(3)), std::abs(drawn(3))};
    const mpq_class radius = std::abs(drawn(4)) + 1;
    const auto gap = [&](const mpq_class& t) {
      mpq_class sum = -radius * radius;
      for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class off = abs(center[k] + t * displacement[k]) - half[k];
        if (sgn(off) > 0) sum += off * off;
      }
      return sum;
    };
    if (sgn(gap(0)) <= 0) continue;
    const auto exact = [](const std::array<mpq_class, 3>& of) {
      return Vector3<Exact>{Exact(of[0]), Exact(of[1]), Exact(of[2])};
    };
    const Vector3<Exact> c = exact(center), h = exact(half);
    const Exact zero(0);
    const auto found = simulate::swept_sphere_aabb<Exact>(
        {{c.x, c.y, c.z}, Exact(radius)}, {{zero - h.x, zero - h.y, zero - h.z}, {h.x, h.y, h.z}}, exact(displacement));
    const bool hit = found.relation == HitRelation::hit;
    ++(hit ? hits : misses);
    const mpq_class t = hit ? found.t->value() : mpq_class(1);
    if (hit) CHECK(abs(gap(t)) < near);
    else CHECK(gap(1) > 0);
    for (int k = 0; k < 32; ++k) CHECK(gap(t * mpq_class(k, 32)) > 0);
  }
  CHECK(hits > 200);
  CHECK(misses > 200);
}

}  // namespace touchstone::proptests::flights_tests
