// SPDX-License-Identifier: Apache-2.0
#include "proptests/infrastructure/simulate/scene_text.h"
#include "report/pages/simulation_page.h"

namespace touchstone::proptests::pages_tests {
namespace {

using catalogue::Json;
using simulate::Recording;
using simulate::Scene;
using simulate::Simulation;

Recording recorded(const Scene& scene, std::uint64_t steps, const std::vector<std::string>& runs) {
  Simulation simulation(scene, runs);
  Recording recording(simulation);
  recording.add(simulation);
  while (simulation.step() < steps) simulation.advance(), recording.add(simulation);
  return recording;
}

Scene falling(const std::string& title = "A fall") {
  return scene_from(scene_text(
      R"("timestep":0.5,"option":1)",
      "\"title\":\"" + title + "\"," + floor_of_scene + ",\"bodies\":[" + particle("[0,1,0]", "[1,-1,0]") + "]"));
}

}  // namespace

TEST_CASE("page: what the player is given is what the runs did") {
  const Scene scene = falling();
  const Json data = report::player_data(recorded(scene, 3, {"double", "robust"}));
  CHECK(data["timestep"] == 0.5);
  CHECK(data["stride"] == 1);
  CHECK(data["bodies"][0]["shape"] == "particle");
  CHECK(data["walls"][0]["normal"] == Json({0, 2, 0}));
  REQUIRE(data["runs"].size() == 2);
  const Json& run = data["runs"][0];
  CHECK(run["frames"] ==
        Json({{0, 1, 0, 1, -1, 0}, {0.5, 0.5, 0, 1, -1, 0}, {1, 1, 0, 1, 1, 0}, {1.5, 1.5, 0, 1, 1, 0}}));
  CHECK(run["contacts"] == Json({Json::array(), Json::array(), Json::array({{1, 0, 0}}), Json::array()}));
  CHECK(run["energy"] == Json({1, 1, 1, 1}));
  CHECK(run["momentum"][3] == Json({1, 1, 0}));
  CHECK(data["distances"][0]["values"] == Json({0, 0, 0, 0}));
  CHECK(data["partings"].empty());
}

TEST_CASE("page: of a long run every second step is shown, with the contacts of both") {
  const Scene scene = falling();
  const Json data = report::player_data(recorded(scene, 2500, {"double"}));
  CHECK(data["stride"] == 2);
  CHECK(data["runs"][0]["frames"].size() == 1251);
  CHECK(data["runs"][0]["contacts"][1].size() == 1);
  CHECK(data["distances"].empty());
}

TEST_CASE("page: it stands alone, carries its scripts, and a title is no markup") {
  const Scene scene = falling("<b>&");
  const std::string page = report::simulation_page(recorded(scene, 2, {"float", "robust"}));
  CHECK(page.find("<b>&</h1>") == std::string::npos);
  CHECK(page.find("const viewer = (() => {") != std::string::npos);
  CHECK(page.find("const player = (() => {") != std::string::npos);
  CHECK(page.find("data-player=\"") != std::string::npos);
  for (const char* fetched : {"src=\"http", "href=\"http", "@import", "url("})
    CHECK(page.find(fetched) == std::string::npos);
  CHECK(page == report::simulation_page(recorded(scene, 2, {"float", "robust"})));
}

}  // namespace touchstone::proptests::pages_tests
