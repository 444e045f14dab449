// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <type_traits>

#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/fused.h"
#include "catalogue/numbers/ulps.h"
#include "geometry/answers.h"
#include "geometry/bodies.h"
#include "reference/mixed/sphere_plane.h"
#include "reference/planes/point_plane.h"
#include "reference/planes/point_plane_toi.h"
#include "reference/response/contact_state.h"
#include "reference/response/damped_reflection.h"
#include "reference/response/inelastic_collision.h"
#include "reference/response/penalty_force.h"
#include "reference/response/restitution_collision.h"
#include "reference/sweeps/swept_aabb_aabb.h"
#include "reference/sweeps/swept_sphere_plane.h"
#include "reference/sweeps/swept_sphere_sphere.h"
#include "reference/volumes/aabb_aabb.h"
#include "reference/volumes/closest_point_on_aabb.h"
#include "reference/volumes/sphere_aabb.h"
#include "reference/volumes/sphere_sphere.h"
#include "robust/mixed/sphere_plane.h"
#include "robust/planes/point_plane.h"
#include "robust/planes/point_plane_toi.h"
#include "robust/response/contact_state.h"
#include "robust/response/damped_reflection.h"
#include "robust/response/inelastic_collision.h"
#include "robust/response/penalty_force.h"
#include "robust/response/restitution_collision.h"
#include "robust/sweeps/swept_aabb_aabb.h"
#include "robust/sweeps/swept_sphere_plane.h"
#include "robust/sweeps/swept_sphere_sphere.h"
#include "robust/volumes/aabb_aabb.h"
#include "robust/volumes/closest_point_on_aabb.h"
#include "robust/volumes/sphere_aabb.h"
#include "robust/volumes/sphere_sphere.h"

/// The operations of a step, in each arithmetic: those of the catalogue, and p + t v, which a step needs throughout.
namespace touchstone::simulate {

using catalogue::Exact;

#define TOUCHSTONE_OPERATIONS_OF(module)                                                              \
  static auto point_plane(const auto&... q) { return module::point_plane(q...); }                     \
  static auto point_plane_toi(const auto&... q) { return module::point_plane_toi(q...); }             \
  static auto sphere_plane(const auto&... q) { return module::sphere_plane(q...); }                   \
  static auto sphere_sphere(const auto&... q) { return module::sphere_sphere(q...); }                 \
  static auto sphere_aabb(const auto&... q) { return module::sphere_aabb(q...); }                     \
  static auto aabb_aabb(const auto&... q) { return module::aabb_aabb(q...); }                         \
  static auto closest_point_on_aabb(const auto&... q) { return module::closest_point_on_aabb(q...); } \
  static auto swept_sphere_plane(const auto&... q) { return module::swept_sphere_plane(q...); }       \
  static auto swept_sphere_sphere(const auto&... q) { return module::swept_sphere_sphere(q...); }     \
  static auto swept_aabb_aabb(const auto&... q) { return module::swept_aabb_aabb(q...); }             \
  static auto contact_state(const auto&... q) { return module::contact_state(q...); }                 \
  static auto damped_reflection(const auto&... q) { return module::damped_reflection(q...); }         \
  static auto restitution_collision(const auto&... q) { return module::restitution_collision(q...); } \
  static auto inelastic_collision(const auto&... q) { return module::inelastic_collision(q...); }     \
  static auto penalty_force(const auto&... q) { return module::penalty_force(q...); }

/// The textbook formulas over float, double or Exact, which never rounds.
template <class Real>
struct Formulas {
  using Number = Real;
  static Real number(double x) {
    if constexpr (std::is_same_v<Real, Exact>) return Exact(catalogue::exact_value(x));
    else return static_cast<Real>(x);
  }
  static Real plus(const Real& a, const Real& t, const Real& b) { return Real(a + Real(t * b)); }
  /// The time of an event, as used in the rest of a step. It may have a root: the exact step takes the nearest double,
  /// so that its numbers stay rational.
  static Real moment(const Real& t) {
    if constexpr (std::is_same_v<Real, Exact>) return number(catalogue::nearest(t.value()));
    else return t;
  }
  TOUCHSTONE_OPERATIONS_OF(reference)
};

/// Each decision is exact, and the result of each operation is rounded once.
struct Robust {
  using Number = double;
  static double number(double x) { return x; }
  static double plus(double a, double t, double b) { return catalogue::fused(t, b, a); }
  static double moment(double t) { return t; }
  TOUCHSTONE_OPERATIONS_OF(robust)
};

#undef TOUCHSTONE_OPERATIONS_OF

/// a + t b, coordinate by coordinate.
template <class By, class Triple, class Real = typename By::Number>
Triple plus(const Triple& a, const Real& t, const Vector3<Real>& b) {
  return {By::plus(a.x, t, b.x), By::plus(a.y, t, b.y), By::plus(a.z, t, b.z)};
}

}  // namespace touchstone::simulate
