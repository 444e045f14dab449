// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/codec/json.h"
#include "geometry/space.h"

/// A scene in three arithmetics side by side: the one module that may hold the textbook formulas and robust together.
namespace touchstone::simulate {

using catalogue::Json;

template <class Real>
struct Particle {
  Point3<Real> position;
  Vector3<Real> velocity;
};

template <class Real>
using State = std::vector<Particle<Real>>;

/// Particles that fly without forces, and walls that they bounce off. Any units; y is up.
struct Scene {
  double timestep;             ///< greater than 0
  std::vector<Plane3d> walls;  ///< solid where N . p + d <= 0
  State<double> particles;
};

/// {"touchstone_scene":1,"timestep":0.5,"walls":[...],"particles":[{"position":[..],"velocity":[..]}]}. Throws
/// InvalidInput, which names the field and the rule.
Scene read_scene(const Json& json);

}  // namespace touchstone::simulate
