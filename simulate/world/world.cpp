// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/world.h"

#include <algorithm>

#include "simulate/world/flights.h"
#include "simulate/world/near_pairs.h"

namespace touchstone::simulate {
namespace {

template <class Real>
Exact in_exact(const Real& x) {
  if constexpr (std::is_same_v<Real, Exact>) return x;
  else return Exact(catalogue::exact_value(static_cast<double>(x)));
}

template <class Real>
double in_double(const Real& x) {
  if constexpr (std::is_same_v<Real, Exact>) return catalogue::nearest(x.value());
  else return static_cast<double>(x);
}

bool all_finite(const std::vector<Aabb3d>& boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [](const Aabb3d& box) {
    const auto& [low, high] = box;
    return std::isfinite(low.x) && std::isfinite(low.y) && std::isfinite(low.z) && std::isfinite(high.x) &&
           std::isfinite(high.y) && std::isfinite(high.z);
  });
}

template <class Real>
bool is_zero(const Vector3<Real>& v) {
  return v.x == Real(0) && v.y == Real(0) && v.z == Real(0);
}

}  // namespace

HeightOfBoxes::HeightOfBoxes(const Plane3d& wall, double largest_end) : wall_(wall) {
  const auto lower_end = [](double along) { return along > 0 ? &Aabb3d::min : &Aabb3d::max; };
  const Vector3d& n = wall.normal;
  x_ = lower_end(n.x), y_ = lower_end(n.y), z_ = lower_end(n.z);
  error_ = 0x1p-19 * (std::abs(wall.offset) + (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) * largest_end) + 0x1p-100;
}

template <class Real>
Vector3<Real> way_out(const Aabb3<Real>& a, const Aabb3<Real>& b) {
  std::optional<Exact> least;
  Vector3<Real> displacement{Real(0), Real(0), Real(0)};
  const auto look = [&](Real Point3<Real>::*axis, Real Vector3<Real>::*along) {
    const Exact up = in_exact(b.max.*axis) - in_exact(a.min.*axis),
                down = in_exact(a.max.*axis) - in_exact(b.min.*axis);
    const bool upwards = up <= down;
    const Exact& depth = upwards ? up : down;
    if (least && *least <= depth) return;
    least = depth;
    displacement = {Real(0), Real(0), Real(0)};
    displacement.*along = upwards ? Real(1) : Real(-1);
  };
  look(&Point3<Real>::x, &Vector3<Real>::x);
  look(&Point3<Real>::y, &Vector3<Real>::y);
  look(&Point3<Real>::z, &Vector3<Real>::z);
  return displacement;
}

template <class By>
World<By>::World(const Scene& scene)
    : settings_(scene.settings),
      gravity_(catalogue::converted<Real>(scene.gravity, By::number)),
      timestep_(By::number(scene.settings.timestep)),
      restitution_(By::number(scene.settings.restitution)) {
  for (const SceneBody& body : scene.bodies)
    solids_.push_back({body.shape, body.fixed, By::number(body.mass), By::number(body.radius),
                       catalogue::converted<Real>(body.half_extents, By::number)});
  for (const Wall& wall : scene.walls) walls_.push_back(catalogue::converted<Real>(wall.plane, By::number));
}

template <class By>
std::vector<Touch> World<By>::all_touches() const {
  std::vector<Touch> touches;
  for (std::size_t i = 0; i < bodies(); ++i)
    for (std::size_t j = i + 1; j < bodies(); ++j)
      if (!solids_[i].fixed || !solids_[j].fixed) touches.push_back({false, i, j});
  for (std::size_t i = 0; i < bodies(); ++i)
    for (std::size_t w = 0; w < walls() && !solids_[i].fixed; ++w) touches.push_back({true, i, w});
  return touches;
}

template <class By>
const std::vector<Touch>& World<By>::touches(const State<Real>& from, const State<Real>& to, Nearby& nearby) const {
  return touches(from, to, nearby, settings_.broad_phase);
}

template <class By>
const std::vector<Touch>& World<By>::touches(const State<Real>& from, const State<Real>& to, Nearby& nearby,
                                             BroadPhase broad_phase, const Vector3d& sag) const {
  auto& [boxes, heights, forest, touches] = nearby;
  if (broad_phase == BroadPhase::all_pairs) return touches = all_touches();
  boxes.clear(), heights.clear(), touches.clear();
  double largest_end = 0;
  for (std::size_t i = 0; i < bodies(); ++i) {
    Aabb3d box{};
    const auto take = [&](double Point3d::*axis, const Real& a, const Real& b, const Real& half, double off) {
      const double x = in_double(a), y = in_double(b), reach = in_double(solids_[i].radius) + in_double(half) + off;
      const double wider = reach + 0x1p-20 * (std::max(std::abs(x), std::abs(y)) + reach) + 0x1p-140;
      box.min.*axis = std::min(x, y) - wider, box.max.*axis = std::max(x, y) + wider;
      largest_end = std::max({largest_end, -(box.min.*axis), box.max.*axis});
    };
    const Point3<Real>&a = from[i].position, &b = to[i].position;
    const Vector3<Real>& half = solids_[i].half_extents;
    take(&Point3d::x, a.x, b.x, half.x, sag.x), take(&Point3d::y, a.y, b.y, half.y, sag.y);
    take(&Point3d::z, a.z, b.z, half.z, sag.z);
    boxes.push_back(box);
  }
  const auto add = [this, &list = touches](std::size_t i, std::size_t j) {
    if (!solids_[i].fixed || !solids_[j].fixed) list.push_back({false, i, j});
  };
  if (broad_phase == BroadPhase::tree && all_finite(boxes)) {
    for (const auto& [i, j] : forest.pairs(boxes)) add(i, j);
  } else {
    for (const auto& [i, j] : near_pairs(boxes)) add(i, j);
  }
  for (const Plane<Real>& wall : walls_)
    heights.emplace_back(catalogue::converted<double>(wall, in_double<Real>), largest_end);
  for (std::size_t i = 0; i < bodies(); ++i)
    for (std::size_t w = 0; w < walls() && !solids_[i].fixed; ++w)
      if (heights[w].may_reach(boxes[i])) touches.push_back({true, i, w});
  return touches;
}

template <class By>
Aabb3<typename By::Number> World<By>::box(std::size_t body, const State<Real>& at) const {
  const Vector3<Real>& half = solids_[body].half_extents;
  return {simulate::plus<By>(at[body].position, Real(-1), half), simulate::plus<By>(at[body].position, Real(1), half)};
}

template <class By>
Point3<typename By::Number> World<By>::deepest(const Touch& touch, const State<Real>& at) const {
  const Vector3<Real>& n = walls_[touch.other].normal;
  const auto side = [](const Real& along, const Real& half) { return along > Real(0) ? Real(-half) : half; };
  const Vector3<Real>& half = solids_[touch.body].half_extents;
  return simulate::plus<By>(at[touch.body].position, Real(1),
                            Vector3<Real>{side(n.x, half.x), side(n.y, half.y), side(n.z, half.z)});
}

template <class By>
bool World<By>::meet(const Touch& touch, const State<Real>& at, Log* log) const {
  const auto [wall, i, j] = touch;
  const auto asked = [&](const char* operation, std::initializer_list<const char*> names, const auto& answer,
                         const auto&... part) { return logged<Real>(log, touch, operation, names, answer, part...); };
  if (wall && solids_[i].shape == Shape::sphere) {
    const Sphere3<Real> a = ball(i, at);
    const Plane<Real>& b = walls_[j];
    return asked("sphere_plane", {"sphere", "plane"}, By::sphere_plane(a, b), a, b) != Contact::disjoint;
  }
  if (wall) {
    const Point3<Real> p = deepest(touch, at);
    const Plane<Real>& b = walls_[j];
    return asked("point_plane", {"plane", "point"}, By::point_plane(b, p), b, p).side != PlaneSide::front;
  }
  if (boxes(touch)) {
    const Aabb3<Real> a = box(i, at), b = box(j, at);
    return asked("aabb_aabb", {"a", "b"}, By::aabb_aabb(a, b), a, b) != Contact::disjoint;
  }
  if (solids_[i].shape == Shape::box || solids_[j].shape == Shape::box) {
    const bool first = solids_[i].shape == Shape::box;
    const Sphere3<Real> a = ball(first ? j : i, at);
    const Aabb3<Real> b = box(first ? i : j, at);
    return asked("sphere_aabb", {"sphere", "aabb"}, By::sphere_aabb(a, b), a, b) != Contact::disjoint;
  }
  const Sphere3<Real> a = ball(i, at), b = ball(j, at);
  return asked("sphere_sphere", {"a", "b"}, By::sphere_sphere(a, b), a, b) != Contact::disjoint;
}

template <class By>
FirstContact<typename By::Number> World<By>::first_meeting(const Touch& touch, const State<Real>& state,
                                                           const Real& time, Log* log) const {
  const auto [wall, i, j] = touch;
  const Vector3<Real> displacement = time * state[i].velocity;
  const auto asked = [&](const char* operation, std::initializer_list<const char*> names, const auto& answer,
                         const auto&... part) { return logged<Real>(log, touch, operation, names, answer, part...); };
  if (wall && solids_[i].shape == Shape::sphere) {
    const Sphere3<Real> a = ball(i, state);
    const Plane<Real>& b = walls_[j];
    return asked("swept_sphere_plane", {"sphere", "velocity", "plane"}, By::swept_sphere_plane(a, displacement, b), a,
                 displacement, b);
  }
  if (wall) {
    const Point3<Real> start = deepest(touch, state), end = simulate::plus<By>(start, time, state[i].velocity);
    const Plane<Real>& b = walls_[j];
    const auto answer = By::point_plane_toi(b, start, end);
    const auto hit = asked("point_plane_toi", {"plane", "start", "end"}, answer, b, start, end).option_2;
    return {hit.relation, hit.t};
  }
  const Vector3<Real> other = time * state[j].velocity;
  if (solids_[i].shape != Shape::box && solids_[j].shape != Shape::box) {
    const Sphere3<Real> a = ball(i, state), b = ball(j, state);
    return asked("swept_sphere_sphere", {"a", "b", "velocity_a", "velocity_b"},
                 By::swept_sphere_sphere(a, b, displacement, other), a, b, displacement, other);
  }
  const bool first = solids_[i].shape == Shape::sphere;
  if (first || solids_[j].shape == Shape::sphere) {
    const auto sweep = [](const auto& ball, const auto& box, const auto& by) {
      return swept_sphere_aabb(ball, box, by);
    };
    return by<By>(sweep, ball(first ? i : j, state), box(first ? j : i, state),
                  first ? displacement - other : other - displacement);
  }
  // A particle is a flat box here.
  const Aabb3<Real> a = box(i, state), b = box(j, state);
  const Vector3<Real> relative = displacement - other;
  return asked("swept_aabb_aabb", {"a", "b", "velocity"}, By::swept_aabb_aabb(a, b, relative), a, b, relative);
}

template <class By>
FirstContact<typename By::Number> World<By>::first_fall(const Touch& touch, const State<Real>& state,
                                                        const Vector3<Real>& acceleration, const Real& time) const {
  const auto fall = [](const auto& ball, const auto& velocity, const auto& pull, const auto& flight, const auto& wall) {
    return simulate::first_fall(height_over(ball, velocity, pull, flight, wall));
  };
  const bool round = solids_[touch.body].shape == Shape::sphere;
  const Sphere3<Real> lowest = round ? ball(touch.body, state) : Sphere3<Real>{deepest(touch, state), Real(0)};
  return by<By>(fall, lowest, state[touch.body].velocity, acceleration, time, walls_[touch.other]);
}

template <class By>
bool World<By>::rests(const Touch& touch, const State<Real>& state) const {
  if (!touch.wall || !meet(touch, state, nullptr)) return false;
  const Vector3<Real> none{Real(0), Real(0), Real(0)};
  const Point3<Real> at{Real(0), Real(0), Real(0)};
  const auto along = [&](const Vector3<Real>& v) {
    return By::contact_state(MovingBody<Real>{at, v, none}, MovingBody<Real>{at, none, none}, at,
                             walls_[touch.other].normal);
  };
  return along(state[touch.body].velocity) == ContactState::resting && along(gravity_) == ContactState::colliding;
}

template <class By>
bool World<By>::comes_to_rest(const Touch& touch, const State<Real>& state, const Vector3<Real>& acceleration,
                              const Real& time) const {
  const auto end = [](const auto&... part) { return bounces_end(part...); };
  const Real bounce = settings_.law == Law::stick ? Real(0) : restitution_;
  const Vector3<Real>& normal = walls_[touch.other].normal;
  if constexpr (std::is_same_v<By, Robust>) {
    const auto exact = [](const auto& part) { return catalogue::converted<Exact>(part, Formulas<Exact>::number); };
    return end(exact(state[touch.body].velocity), exact(acceleration), exact(normal), exact(bounce), exact(time));
  } else {
    return end(state[touch.body].velocity, acceleration, normal, bounce, time);
  }
}

template <class By>
double World<By>::rise(const Touch& touch, const State<Real>& state) const {
  if (!touch.wall) return 0;
  const auto doubles = [](const Vector3<Real>& v) { return Vector3d{in_double(v.x), in_double(v.y), in_double(v.z)}; };
  const Vector3d normal = doubles(walls_[touch.other].normal);
  const double speed = dot(normal, doubles(state[touch.body].velocity)), pull = -dot(normal, doubles(gravity_));
  return speed > 0 && pull > 0 ? speed * speed / (2 * pull * std::sqrt(dot(normal, normal))) : 0;
}

template <class By>
Vector3<typename By::Number> World<By>::carried(const std::vector<std::size_t>& walls) const {
  std::vector<Vector3<Real>> normals;
  for (const std::size_t wall : walls) normals.push_back(walls_[wall].normal);
  return by<By>([](const auto& pull, const auto& all) { return nearest_not_into(pull, all); }, gravity_, normals);
}

template <class By>
std::optional<Vector3<typename By::Number>> World<By>::normal(const Touch& touch, const State<Real>& at) const {
  const auto [wall, i, j] = touch;
  if (wall) return walls_[j].normal;
  const auto flat = [&](std::size_t body) { return solids_[body].shape != Shape::sphere; };
  const bool some_box = solids_[i].shape == Shape::box || solids_[j].shape == Shape::box;
  if (boxes(touch) || (settings_.option == 2 && some_box && flat(i) && flat(j))) return way_out(box(i, at), box(j, at));
  Vector3<Real> displacement = at[i].position - at[j].position;
  if (solids_[j].shape == Shape::box) {
    displacement = at[i].position - By::closest_point_on_aabb(at[i].position, box(j, at));
  } else if (solids_[i].shape == Shape::box) {
    displacement = By::closest_point_on_aabb(at[j].position, box(i, at)) - at[j].position;
  }
  if (is_zero(displacement)) return std::nullopt;
  return displacement;
}

template <class By>
bool World<By>::approach(const Touch& touch, const State<Real>& state, const Vector3<Real>& normal, Log* log) const {
  const Vector3<Real> none{Real(0), Real(0), Real(0)};
  const Point3<Real> at{Real(0), Real(0), Real(0)};  // nothing rotates: the contact point does not matter
  const MovingBody<Real> a{at, state[touch.body].velocity, none};
  const MovingBody<Real> b{at, touch.wall ? none : state[touch.other].velocity, none};
  return logged<Real>(log, touch, "contact_state", {"a", "b", "point", "normal"}, By::contact_state(a, b, at, normal),
                      a, b, at, normal) == ContactState::colliding;
}

template <class By>
void World<By>::respond(const Touch& touch, State<Real>& state, const Vector3<Real>& normal) const {
  const auto [wall, i, j] = touch;
  const bool stick = settings_.law == Law::stick;
  const auto bounce = [&](std::size_t body, const Vector3<Real>& n) {
    Vector3<Real>& v = state[body].velocity;
    v = stick ? Vector3<Real>{Real(0), Real(0), Real(0)} : By::damped_reflection(v, n, restitution_);
  };
  if (wall || solids_[j].fixed) return bounce(i, normal);
  if (solids_[i].fixed) return bounce(j, normal);
  const Masses<Real> masses{solids_[i].mass, solids_[j].mass};
  const Velocities<Real> before{state[i].velocity, state[j].velocity};
  if (stick) {
    state[i].velocity = state[j].velocity = By::inelastic_collision(masses, before);
    return;
  }
  const auto after = By::restitution_collision(masses, before, normal, restitution_);
  state[i].velocity = after.first;
  state[j].velocity = after.second;
}

template class World<Formulas<float>>;
template class World<Formulas<double>>;
template class World<Formulas<Exact>>;
template class World<Robust>;

}  // namespace touchstone::simulate
