// SPDX-License-Identifier: Apache-2.0
#include "simulate/step.h"

#include <cmath>

#include "catalogue/shape/walk.h"
#include "geometry/answers.h"
#include "reference/planes/point_plane.h"
#include "reference/response/contact_state.h"
#include "reference/response/reflect_plane.h"
#include "robust/planes/point_plane.h"
#include "robust/response/contact_state.h"
#include "robust/response/reflect_plane.h"

namespace touchstone::simulate {
namespace {

template <class Real>
struct Formulas {
  using Number = Real;
  static Point3<Real> moved(const Particle<Real>& p, Real time) { return p.position + time * p.velocity; }
  static auto point_plane(const auto&... q) { return reference::point_plane(q...); }
  static auto contact_state(const auto&... q) { return reference::contact_state(q...); }
  static auto reflect_plane(const auto&... q) { return reference::reflect_plane(q...); }
};

struct Robust {
  using Number = double;
  /// The one operation that the catalogue does not have: each coordinate of p + t v rounded once.
  static Point3d moved(const Particle<double>& p, double time) {
    const auto& [x, v] = p;
    return {std::fma(time, v.x, x.x), std::fma(time, v.y, x.y), std::fma(time, v.z, x.z)};
  }
  static auto point_plane(const auto&... q) { return robust::point_plane(q...); }
  static auto contact_state(const auto&... q) { return robust::contact_state(q...); }
  static auto reflect_plane(const auto&... q) { return robust::reflect_plane(q...); }
};

template <class By>
bool collides(const Plane<typename By::Number>& wall, const Particle<typename By::Number>& p,
              const Point3<typename By::Number>& end) {
  using Real = typename By::Number;
  if (By::point_plane(wall, end).side == PlaneSide::front) return false;
  const MovingBody<Real> particle{p.position, p.velocity, {}}, at_rest{p.position, {}, {}};
  return By::contact_state(particle, at_rest, p.position, wall.normal) == ContactState::colliding;
}

template <class By>
State<typename By::Number> step(const Scene& scene, State<typename By::Number> state) {
  using Real = typename By::Number;
  const auto number = [](double x) { return static_cast<Real>(x); };
  const Real time = number(scene.timestep);
  for (Particle<Real>& p : state) {
    for (const Plane3d& given : scene.walls) {
      const auto wall = catalogue::converted<Real>(given, number);
      if (collides<By>(wall, p, By::moved(p, time))) p.velocity = By::reflect_plane(p.velocity, wall.normal);
    }
    p.position = By::moved(p, time);
  }
  return state;
}

}  // namespace

template <class Real>
State<Real> step_by_formulas(const Scene& scene, const State<Real>& state) {
  return step<Formulas<Real>>(scene, state);
}
template State<float> step_by_formulas(const Scene&, const State<float>&);
template State<double> step_by_formulas(const Scene&, const State<double>&);

State<double> step_by_robust(const Scene& scene, const State<double>& state) { return step<Robust>(scene, state); }

}  // namespace touchstone::simulate
