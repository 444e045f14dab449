// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "catalogue/shape/walk.h"
#include "robust/pairs/forest.h"
#include "simulate/world/log.h"
#include "simulate/world/scene.h"

/// The bodies and walls of a scene in one arithmetic, and the questions about two of them.
namespace touchstone::simulate {

template <class Real>
struct Solid {
  Shape shape;
  bool fixed;
  Real mass, radius;
  Vector3<Real> half_extents;
};

/// The heights of boxes over a wall, in double.
class HeightOfBoxes {
 public:
  /// `largest_end`: no end of a box is farther from 0.
  HeightOfBoxes(const Plane3d& wall, double largest_end);

  /// False only where n . p + d > 0 for every p of the box, by so much that float's formula for a sphere or a corner in
  /// it says so too: their distances from 0 are wrong by less than 2^-20 of the sum of the absolute values of their
  /// terms (their contracts: fewer than 16 roundings of 2^-24), and `error_` is twice that at least. Where something is
  /// beyond the range the comparison is false, and the answer true.
  bool may_reach(const Aabb3d& box) const {
    const Vector3d& n = wall_.normal;
    const double low = wall_.offset + n.x * (box.*x_).x + n.y * (box.*y_).y + n.z * (box.*z_).z;
    return !(low > error_);
  }

 private:
  Plane3d wall_;
  Point3d Aabb3d::*x_, Aabb3d::*y_, Aabb3d::*z_;  ///< the end that is lower over the wall
  double error_;
};

/// The data that a broad phase keeps from one step to the next: memory, and trees of boxes. No answer depends on it.
struct Nearby {
  std::vector<Aabb3d> boxes;
  std::vector<HeightOfBoxes> heights;  ///< over each wall
  robust::pairs::KeptForest forest;
  std::vector<Touch> touches;
};

template <class By>
class World {
 public:
  using Real = typename By::Number;

  explicit World(const Scene& scene);

  const Settings& settings() const { return settings_; }
  std::size_t bodies() const { return solids_.size(); }
  std::size_t walls() const { return walls_.size(); }
  const Solid<Real>& solid(std::size_t body) const { return solids_[body]; }
  const Plane<Real>& wall(std::size_t wall) const { return walls_[wall]; }
  const Vector3<Real>& gravity() const { return gravity_; }
  const Real& timestep() const { return timestep_; }
  const Real& restitution() const { return restitution_; }

  /// All pairs i < j that are not both fixed (p. 56), then bodies and walls; of these, pairs whose boxes meet between
  /// the two states, and walls that a box reaches, if the scene has a broad phase; all otherwise. The boxes are wider
  /// than the bodies by 2^-20 of their coordinates, which exceeds the error of float's formulas for two bodies at rest
  /// (their contracts), so that with option 1 the steps are the same. Formulas for moving bodies may report contacts
  /// far off: these are not asked then. The list is valid until the next call with `nearby`.
  const std::vector<Touch>& touches(const State<Real>& from, const State<Real>& to, Nearby& nearby) const;
  /// The same as if the scene had that broad phase. `sag`: the distance that a body may have from the straight path
  /// between the two.
  const std::vector<Touch>& touches(const State<Real>& from, const State<Real>& to, Nearby& nearby,
                                    BroadPhase broad_phase, const Vector3d& sag = {}) const;

  /// True if they have a common point in these positions (p. 22, 44-50).
  bool meet(const Touch& touch, const State<Real>& at, Log* log) const;
  /// The time at which they first meet if they fly on for `time` (p. 23, 51), as a fraction of it. For two that do not
  /// meet yet.
  FirstContact<Real> first_meeting(const Touch& touch, const State<Real>& state, const Real& time, Log* log) const;
  /// The same for a body on a parabola and a wall, considering only the times at which it falls towards the wall. It
  /// may touch it at first, and rise.
  FirstContact<Real> first_fall(const Touch& touch, const State<Real>& state, const Vector3<Real>& acceleration,
                                const Real& time) const;
  /// True if they touch at a wall, move along it, and gravity presses them to it.
  bool rests(const Touch& touch, const State<Real>& state) const;
  /// True if all further bounces from that wall fit into that time: with restitution e below 1 they are infinitely
  /// many, each e times as long as the one before.
  bool comes_to_rest(const Touch& touch, const State<Real>& state, const Vector3<Real>& acceleration,
                     const Real& time) const;
  /// The height above a wall to which the velocity brings the body before gravity makes it fall back; 0 if it does not.
  /// For people: in doubles.
  double rise(const Touch& touch, const State<Real>& state) const;
  /// Gravity minus the part that carrying walls take.
  Vector3<Real> carried(const std::vector<std::size_t>& walls) const;
  /// The direction in which the body leaves the other one or the wall; nullopt if it has none, because centers
  /// coincide.
  std::optional<Vector3<Real>> normal(const Touch& touch, const State<Real>& at) const;
  /// True if they approach along the normal (p. 74).
  bool approach(const Touch& touch, const State<Real>& state, const Vector3<Real>& normal, Log* log) const;
  /// Velocities after the contact (p. 67-71).
  void respond(const Touch& touch, State<Real>& state, const Vector3<Real>& normal) const;

 private:
  std::vector<Touch> all_touches() const;
  Sphere3<Real> ball(std::size_t body, const State<Real>& at) const {
    return {at[body].position, solids_[body].radius};
  }
  Aabb3<Real> box(std::size_t body, const State<Real>& at) const;
  /// The corner that lies deepest behind a wall; for a particle, itself.
  Point3<Real> deepest(const Touch& touch, const State<Real>& at) const;
  bool boxes(const Touch& touch) const {
    return solids_[touch.body].shape == Shape::box && solids_[touch.other].shape == Shape::box;
  }

  Settings settings_;
  Vector3<Real> gravity_;
  Real timestep_, restitution_;
  std::vector<Solid<Real>> solids_;
  std::vector<Plane<Real>> walls_;
};

/// The axis on which two boxes overlap least, decided exactly, and the side on which a is.
template <class Real>
Vector3<Real> way_out(const Aabb3<Real>& a, const Aabb3<Real>& b);

extern template class World<Formulas<float>>;
extern template class World<Formulas<double>>;
extern template class World<Formulas<Exact>>;
extern template class World<Robust>;

}  // namespace touchstone::simulate
