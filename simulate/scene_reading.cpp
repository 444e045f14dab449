// SPDX-License-Identifier: Apache-2.0
#include "simulate/scene_reading.h"

#include <algorithm>
#include <set>

#include "catalogue/codec/expected.h"
#include "geometry/validation.h"
#include "simulate/fields.h"
#include "simulate/world/overlaps.h"

namespace touchstone::simulate {
namespace {

using catalogue::expected;

void read_shape(const Json& json, const std::string& path, SceneBody& body) {
  Fields shape(json, path);
  const bool particle = shape.has("particle"), sphere = shape.has("sphere"), box = shape.has("box");
  shape.end();
  if (particle + sphere + box != 1) throw InvalidInput(path, expected("one of particle, sphere, box", json));
  Fields of(json.begin().value(), shape.path_of(json.begin().key().c_str()));
  if (sphere) {
    body.shape = Shape::sphere;
    body.radius = of.positive("radius");
  } else if (box) {
    body.shape = Shape::box;
    body.half_extents = of.vector("half_extents");
    const auto& [x, y, z] = body.half_extents;
    if (!(x >= 0 && y >= 0 && z >= 0))
      throw InvalidInput(of.path_of("half_extents"), expected("numbers not below 0", of.at("half_extents")));
  }
  of.end();
}

SceneBody read_body(const Json& json, const std::string& path) {
  Fields fields(json, path);
  SceneBody body;
  body.name = fields.text_or("name", path);
  read_shape(fields.at("shape"), fields.path_of("shape"), body);
  body.fixed = fields.flag_or("fixed", false);
  if (fields.has("mass")) body.mass = fields.positive("mass");
  const auto [x, y, z] = fields.vector("position");
  body.start = {{x, y, z}, fields.vector_or("velocity", {})};
  fields.end();
  for (const char* name : {"mass", "velocity"})
    if (body.fixed && fields.has(name)) throw InvalidInput(fields.path_of(name), "a fixed body has none");
  return body;
}

Wall read_wall(const Json& json, const std::string& path) {
  Fields fields(json, path);
  Wall wall{fields.text_or("name", path), {fields.vector("normal"), fields.number("offset")}};
  fields.end();
  validation::validate(path, wall.plane);
  return wall;
}

/// Six walls that look inwards.
void add_room(const Json& json, std::vector<Wall>& walls) {
  Fields fields(json, "room");
  const Vector3d min = fields.vector("min"), max = fields.vector("max");
  fields.end();
  const struct {
    const char* axis;
    double Vector3d::*of;
  } axes[]{{"x", &Vector3d::x}, {"y", &Vector3d::y}, {"z", &Vector3d::z}};
  for (const auto& [axis, of] : axes) {
    if (!(min.*of < max.*of)) throw InvalidInput("room", expected("min below max on each axis", json));
    Vector3d normal{};
    normal.*of = 1;
    walls.push_back({std::string("room.min.") + axis, {normal, 0 - min.*of}});
    normal.*of = -1;
    walls.push_back({std::string("room.max.") + axis, {normal, max.*of}});
  }
}

void read_response(const Json& json, Settings& settings) {
  Fields fields(json, "response");
  settings.law = static_cast<Law>(fields.word("law", {"restitution", "stick", "penalty"}));
  if (settings.law == Law::restitution) settings.restitution = fields.ratio("restitution");
  if (settings.law == Law::penalty) {
    settings.stiffness = fields.positive("stiffness");
    settings.damping = fields.not_negative_or("damping", 0);
  }
  fields.end();
}

void read_advance(const Json& json, Settings& settings) {
  Fields fields(json, "advance");
  const bool rate = fields.has("steps_per_second");
  if (rate == fields.has("timestep")) throw InvalidInput("advance", expected("timestep or steps_per_second", json));
  settings.timestep = rate ? 1.0 / fields.count_or("steps_per_second", 1, 0) : fields.positive("timestep");
  settings.steps = fields.count_or("steps", 0, 600);
  const std::vector<const char*> motions{"accelerate_then_move", "move_then_accelerate", "parabola"};
  settings.motion = static_cast<Motion>(fields.word_or("motion", motions, 0));
  settings.option = static_cast<int>(fields.count_or("option", 1, 0));
  if (settings.option != 1 && settings.option != 2)
    throw InvalidInput("advance.option", expected("1 or 2, of p. 23", fields.at("option")));
  const bool end_of_step = settings.option == 1;
  for (const char* name : {"turn", "passes"})
    if (!end_of_step && fields.has(name)) throw InvalidInput(fields.path_of(name), "is for option 1");
  if (end_of_step && fields.has("moments")) throw InvalidInput("advance.moments", "is for option 2");
  settings.turn = static_cast<Turn>(fields.word_or("turn", {"before_move", "after_move"}, 0));
  settings.passes = fields.count_or("passes", 1, 1);
  settings.moments = fields.count_or("moments", 1, 64);
  const std::vector<const char*> broad_phases{"all_pairs", "sort_and_sweep", "tree"};
  settings.broad_phase = static_cast<BroadPhase>(fields.word_or("broad_phase", broad_phases, 0));
  fields.end();
}

void require_one_name_each(const std::vector<std::string>& names, const char* list) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!taken.insert(names[i]).second)
      throw InvalidInput(std::string(list) + "[" + std::to_string(i) + "].name",
                         expected("a name that no other has", names[i]));
}

/// Rules that concern more than one field.
void require_possible(const Scene& scene) {
  const auto named = [](const auto& list) {
    std::vector<std::string> names;
    for (const auto& one : list) names.push_back(one.name);
    return names;
  };
  require_one_name_each(named(scene.walls), "walls");
  require_one_name_each(named(scene.bodies), "bodies");
  const auto of_shape = [&](Shape shape) {
    return std::find_if(scene.bodies.begin(), scene.bodies.end(),
                        [=](const SceneBody& body) { return body.shape == shape; });
  };
  const auto none = scene.bodies.end(), sphere = of_shape(Shape::sphere), box = of_shape(Shape::box);
  const auto place = [&](auto body) { return "bodies[" + std::to_string(body - scene.bodies.begin()) + "].shape"; };
  if (scene.settings.law == Law::penalty && (sphere != none || box != none))
    throw InvalidInput(place(std::min(sphere, box)), "with the law penalty all bodies are particles (p. 72)");
  if (scene.settings.law == Law::penalty && scene.settings.option != 1)
    throw InvalidInput("advance.option", "1 with the law penalty: a spring acts for whole steps");
  const auto fixed = std::find_if(scene.bodies.begin(), none, [](const SceneBody& body) { return body.fixed; });
  if (scene.settings.option == 2 && scene.settings.motion == Motion::parabola && fixed != none)
    throw InvalidInput(
        "bodies[" + std::to_string(fixed - scene.bodies.begin()) + "].fixed",
        "none with option 2 and parabola: when a body falls onto one is a root of a polynomial of degree "
        "4; walls are for it");
  if (scene.settings.law == Law::penalty) return;  // springs let bodies in
  if (const auto wrong = overlap_at_start(scene)) throw InvalidInput(wrong->field, wrong->rule);
}

/// Replaces the typed text of numbers by numbers.
void become_numbers(Json& json) {
  if (catalogue::is_typed_number(json)) json = catalogue::written(catalogue::read_double(json, ""));
  else if (json.is_structured())
    for (Json& part : json) become_numbers(part);
}

}  // namespace

Scene read_scene(const Json& json) {
  Fields fields(json, "");
  if (fields.number("touchstone_scene") != 1)
    throw InvalidInput("touchstone_scene",
                       expected("1, the version that this program reads", json["touchstone_scene"]));
  Scene scene;
  scene.title = fields.text_or("title", "");
  scene.about = fields.text_or("about", "");
  fields.each("deck_pages", [&](const Json& page, const std::string& path) {
    scene.deck_pages.push_back(catalogue::read_index(page, path));
    if (scene.deck_pages.back() < 1 || scene.deck_pages.back() > 74)
      throw InvalidInput(path, expected("a page of the deck, 1 to 74", page));
  });
  scene.gravity = fields.vector_or("gravity", {});
  read_advance(fields.at("advance"), scene.settings);
  if (fields.has("response")) read_response(fields.at("response"), scene.settings);
  if (fields.has("room")) add_room(fields.at("room"), scene.walls);
  fields.each("walls",
              [&](const Json& wall, const std::string& path) { scene.walls.push_back(read_wall(wall, path)); });
  fields.each("bodies",
              [&](const Json& body, const std::string& path) { scene.bodies.push_back(read_body(body, path)); });
  fields.end();
  if (scene.bodies.empty()) throw InvalidInput("bodies", "at least one");
  require_possible(scene);
  scene.text = json;
  become_numbers(scene.text);
  return scene;
}

}  // namespace touchstone::simulate
