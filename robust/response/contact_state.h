// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/contact_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two bodies that touch at a point separate there, stay (`resting`), or collide: by the sign of their
/// relative velocity at that point along the normal, which points from b to a.
///
/// `resting` means exactly 0; bodies that slide or roll on each other are resting. The normal may have any length but
/// 0. Right for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which
/// names the field and "finite number"; so does a normal of length 0 ("nonzero normal"). Contract:
/// reference/response/contact_state.h.
inline ContactState contact_state(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point,
                                  const Vector3d& normal);

namespace stages {

struct contact_state : Filtered<contact_state, decltype(robust::contact_state)> {
  static Perhaps<ContactState> filter(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point,
                                      const Vector3d& normal) {
    return filters::by_sign(filters::velocity_apart(a, b, point, normal), ContactState::separating,
                            ContactState::colliding);
  }
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace stages

inline ContactState contact_state(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point,
                                  const Vector3d& normal) {
  return stages::contact_state::ask(a, b, point, normal).answer;
}

}  // namespace touchstone::robust
