// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
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

/// The bodies of a scene at one time, in the order of the scene.
template <class Real>
using State = std::vector<Particle<Real>>;

/// Boxes keep their axes along x, y and z: nothing rotates.
enum class Shape { particle, sphere, box };

struct SceneBody {
  std::string name;  ///< "bodies[3]" if the scene gives none
  Shape shape = Shape::particle;
  double radius = 0;        ///< for a sphere
  Vector3d half_extents{};  ///< for a box
  bool fixed = false;       ///< never moves; nothing changes its velocity, 0
  double mass = 1;          ///< greater than 0
  Particle<double> start{};
};

/// Solid where normal . p + offset <= 0.
struct Wall {
  std::string name;  ///< "walls[0]" if the scene gives none
  Plane3d plane;
};

/// The integration of gravity in a step of length h. The deck has no rule for it (p. 9: p + t v), so a scene selects
/// one. Each is listed with the energy that one free step gains, per unit of mass.
enum class Motion {
  accelerate_then_move,  ///< v += h g, p += h v: -h^2 g.g / 2
  move_then_accelerate,  ///< p += h v, v += h g: +h^2 g.g / 2
  parabola,              ///< p += h (v + h g / 2), v += h g: 0
};

/// With option 1: whether velocities change before the bodies move to where contacts were found, or after.
enum class Turn { before_move, after_move };

/// The effect of a contact.
enum class Law {
  restitution,  ///< p. 67-71: the normal part of the relative velocity becomes -e times what it was
  stick,        ///< p. 70: bodies have a common velocity from then on; at a wall it is 0
  penalty,      ///< p. 72-73: walls are springs with dampers, for particles only
};

/// The pairs that are tested: all (p. 56), or those whose boxes meet, found by sort and sweep along x (p. 55) or by a
/// tree of boxes. The steps are the same.
enum class BroadPhase : std::uint8_t { all_pairs, sort_and_sweep, tree };

struct Settings {
  double timestep = 0;
  std::uint64_t steps = 600;  ///< unless the command gives a number
  Motion motion = Motion::accelerate_then_move;
  int option = 1;  ///< of p. 23: 1 tests for contacts at the end of the step, 2 finds the time of impact
  Turn turn = Turn::before_move;
  std::uint32_t passes = 1;    ///< option 1: number of passes over all contacts in a step, in their order
  std::uint32_t moments = 64;  ///< option 2: contacts in one step; a step that needs more is refused
  BroadPhase broad_phase = BroadPhase::all_pairs;
  Law law = Law::restitution;
  double restitution = 1;
  double stiffness = 0, damping = 0;
};

/// Metres, kilograms and seconds, or any other consistent units; y is up.
struct Scene {
  std::string title, about;
  std::vector<std::uint32_t> deck_pages;
  Vector3d gravity{};
  Settings settings;
  std::vector<Wall> walls;
  std::vector<SceneBody> bodies;
  Json text;  ///< as read

  State<double> start() const;
};

}  // namespace touchstone::simulate
