// SPDX-License-Identifier: Apache-2.0
#include "simulate/engine_protocol.h"

#include <algorithm>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"
#include "simulate/fields.h"

namespace touchstone::simulate {
namespace {

using catalogue::excerpt;
using catalogue::expected;
using catalogue::written;

constexpr std::size_t longest_text = 200;
constexpr const char* shapes[]{"particle", "sphere", "box"};
constexpr const char* laws[]{"restitution", "stick", "penalty"};

Json in_json(const SceneBody& body) {
  Json json{{"name", body.name}, {"shape", shapes[static_cast<std::size_t>(body.shape)]}};
  if (body.shape == Shape::sphere) json["radius"] = written(body.radius);
  if (body.shape == Shape::box) json["half_extents"] = three(body.half_extents);
  json["mass"] = written(body.mass);
  json["fixed"] = body.fixed;
  json["position"] = three(body.start.position);
  json["velocity"] = three(body.start.velocity);
  return json;
}

std::string text_of(const Json& value, const std::string& field) {
  if (!value.is_string() || catalogue::is_typed_number(value)) throw InvalidInput(field, expected("a text", value));
  return excerpt(value.get_ref<const std::string&>(), longest_text);
}

std::vector<std::string> texts_of(const Json& json, const char* field) {
  if (!json.contains(field)) return {};
  if (!json[field].is_array()) throw InvalidInput(field, expected("an array of texts", json[field]));
  std::vector<std::string> texts;
  for (const Json& text : json[field]) texts.push_back(text_of(text, field));
  return texts;
}

template <class Triple>
Triple three_of(const Json& list, const std::string& path, std::size_t first) {
  const auto number = [&](std::size_t i) {
    return catalogue::read_double(list[i], path + "[" + std::to_string(i) + "]");
  };
  return {number(first), number(first + 1), number(first + 2)};
}

std::size_t place_of(const Json& contact, const std::string& path, const char* field, std::size_t size) {
  const std::string name = catalogue::member_path(path, field);
  if (!contact.contains(field)) throw InvalidInput(name, "missing");
  const std::size_t place = catalogue::read_index(contact[field], name);
  if (place >= size) throw InvalidInput(name, expected("an integer below " + std::to_string(size), contact[field]));
  return place;
}

Impact contact_of(const Json& json, const std::string& path, const Scene& scene, const State<double>& state) {
  if (!json.is_object()) throw InvalidInput(path, expected("an object", json));
  const std::size_t body = place_of(json, path, "body", scene.bodies.size());
  if (json.contains("wall"))
    return {{true, body, place_of(json, path, "wall", scene.walls.size())}, 1, state[body].position, {}};
  const std::size_t other = place_of(json, path, "other", scene.bodies.size());
  if (other == body) throw InvalidInput(path, "a body meets another one, not itself");
  return {{false, std::min(body, other), std::max(body, other)}, 1, state[body].position, {}};
}

std::vector<std::string> needs_of(const Scene& scene) {
  std::vector<std::string> needs;
  const auto some = [&](auto holds) { return std::any_of(scene.bodies.begin(), scene.bodies.end(), holds); };
  const auto need = [&](const char* feature, bool needed) {
    if (needed) needs.emplace_back(feature);
  };
  need("particles", some([](const SceneBody& body) { return body.shape == Shape::particle; }));
  need("spheres", some([](const SceneBody& body) { return body.shape == Shape::sphere; }));
  need("boxes", some([](const SceneBody& body) { return body.shape == Shape::box; }));
  need("walls", !scene.walls.empty());
  need("fixed", some([](const SceneBody& body) { return body.fixed; }));
  need("stick", scene.settings.law == Law::stick);
  need("penalty", scene.settings.law == Law::penalty);
  need("space", !is_planar(scene));
  return needs;
}

}  // namespace

bool is_planar(const Scene& scene) {
  const bool flat = std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const SceneBody& body) {
    return body.start.position.z == 0 && body.start.velocity.z == 0;
  });
  // A wall perpendicular to the plane moves nothing out of it, and one parallel to the plane is never approached.
  return flat && scene.gravity.z == 0 && std::all_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
           const auto& [x, y, z] = wall.plane.normal;
           return z == 0 || (x == 0 && y == 0);
         });
}

std::string engine_greeting(const Scene& scene) {
  const Settings& settings = scene.settings;
  Json json{{"title", scene.title},
            {"planar", is_planar(scene)},
            {"gravity", three(scene.gravity)},
            {"timestep", written(settings.timestep)},
            {"option", settings.option},
            {"law", laws[static_cast<std::size_t>(settings.law)]}};
  if (settings.law == Law::restitution) json["restitution"] = written(settings.restitution);
  if (settings.law == Law::penalty) {
    json["stiffness"] = written(settings.stiffness);
    json["damping"] = written(settings.damping);
  }
  json["walls"] = Json::array();
  for (const auto& [name, plane] : scene.walls)
    json["walls"].push_back({{"name", name}, {"normal", three(plane.normal)}, {"offset", written(plane.offset)}});
  json["bodies"] = Json::array();
  for (const SceneBody& body : scene.bodies) json["bodies"].push_back(in_json(body));
  return catalogue::one_line(Json{{"touchstone", 1}, {"simulate", 1}, {"scene", json}});
}

std::string engine_question(std::uint64_t step) { return catalogue::one_line(Json{{"step", step}}); }

EngineHello read_engine_hello(const std::string& line) {
  const Json json = catalogue::parse_line(line);
  if (!json.is_object()) throw InvalidInput("line", expected("one JSON object", json));
  if (json.contains("error")) throw InvalidInput("error", excerpt(catalogue::one_line(json["error"]), longest_text));
  if (!json.contains("engine")) throw InvalidInput("engine", "missing");
  const std::vector<const char*> fields{"engine", "number", "cannot", "thresholds", "unsupported"};
  for (const auto& [key, value] : json.items())
    if (std::find(fields.begin(), fields.end(), key) == fields.end())
      throw InvalidInput(catalogue::unknown_path("", key), catalogue::no_such_field(key, fields));
  EngineHello hello;
  hello.engine = text_of(json["engine"], "engine");
  if (hello.engine.empty()) throw InvalidInput("engine", expected("a name", json["engine"]));
  if (json.contains("number")) {
    if (json["number"] != "binary32" && json["number"] != "binary64")
      throw InvalidInput("number", expected("binary64 or binary32", json["number"]));
    hello.binary32 = json["number"] == "binary32";
  }
  hello.cannot = texts_of(json, "cannot");
  for (const std::string& feature : hello.cannot)
    if (std::find(engine_features.begin(), engine_features.end(), feature) == engine_features.end())
      throw InvalidInput("cannot",
                         feature + ": no feature of scenes" + catalogue::did_you_mean(feature, engine_features));
  hello.thresholds = texts_of(json, "thresholds");
  if (json.contains("unsupported")) hello.unsupported = text_of(json["unsupported"], "unsupported");
  return hello;
}

EngineStep read_engine_step(const std::string& line, const Scene& scene, std::uint64_t step) {
  const Json json = catalogue::parse_line(line);
  if (!json.is_object()) throw InvalidInput("line", expected("one JSON object", json));
  if (json.contains("error")) throw InvalidInput("error", excerpt(catalogue::one_line(json["error"]), longest_text));
  for (const char* field : {"step", "bodies"})
    if (!json.contains(field)) throw InvalidInput(field, "missing");
  if (catalogue::read_double(json["step"], "step") != static_cast<double>(step))
    throw InvalidInput("step", expected(std::to_string(step), json["step"]));
  const Json& bodies = json["bodies"];
  catalogue::require_array(bodies, "bodies", scene.bodies.size());
  EngineStep answer;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string path = "bodies[" + std::to_string(i) + "]";
    catalogue::require_array(bodies[i], path, 6);
    const auto position = three_of<Point3d>(bodies[i], path, 0);
    answer.state.push_back({position, three_of<Vector3d>(bodies[i], path, 3)});
  }
  answer.tells_contacts = json.contains("contacts");
  if (!answer.tells_contacts) return answer;
  const Json& contacts = json["contacts"];
  if (!contacts.is_array()) throw InvalidInput("contacts", expected("an array", contacts));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    answer.impacts.push_back(contact_of(contacts[i], "contacts[" + std::to_string(i) + "]", scene, answer.state));
  return answer;
}

std::string lacking(const EngineHello& hello, const Scene& scene) {
  if (!hello.unsupported.empty()) return hello.unsupported;
  std::string all;
  for (const std::string& need : needs_of(scene))
    if (std::find(hello.cannot.begin(), hello.cannot.end(), need) != hello.cannot.end())
      all += (all.empty() ? "" : ", ") + need;
  return all;
}

}  // namespace touchstone::simulate
