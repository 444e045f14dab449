// SPDX-License-Identifier: Apache-2.0
#include "simulate/scene.h"

#include "catalogue/codec/expected.h"
#include "catalogue/codec/shape_json.h"
#include "geometry/validation.h"

namespace touchstone::catalogue {

template <class R>
struct Described<simulate::Particle<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("position", &simulate::Particle<R>::position),
                                             member("velocity", &simulate::Particle<R>::velocity)};
};

}  // namespace touchstone::catalogue

namespace touchstone::simulate {

Scene read_scene(const Json& json) {
  using Fields = std::tuple<double, double, std::vector<Plane3d>, State<double>>;
  catalogue::Shape shape = catalogue::shape_of<Fields>();
  std::size_t part = 0;
  for (const char* name : {"touchstone_scene", "timestep", "walls", "particles"}) shape.parts[part++].name = name;
  if (!json.is_object()) throw InvalidInput("scene", catalogue::expected("an object", json));
  catalogue::EncodedValue<double> encoded;
  catalogue::read_json(shape, json, "", encoded, catalogue::read_double);
  auto [version, timestep, walls, particles] = catalogue::unpacked<Fields>(encoded);
  if (version != 1) throw InvalidInput("touchstone_scene", "1, the version that this program reads");
  if (!(timestep > 0)) throw InvalidInput("timestep", "greater than 0");
  for (std::size_t i = 0; i < walls.size(); ++i) validation::validate("walls[" + std::to_string(i) + "]", walls[i]);
  return {timestep, std::move(walls), std::move(particles)};
}

}  // namespace touchstone::simulate
