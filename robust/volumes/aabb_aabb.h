// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/box_differences.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two axis-aligned boxes, as closed solids, are `disjoint`, only touch or overlap; in the plane and in
/// space.
///
/// A common corner, edge or face is `touching`. A box with min == max on an axis has no interior: it can only touch.
/// Right for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does min > max ("min <= max"). Contract: reference/volumes/aabb_aabb.h.
inline Contact aabb_aabb(const Aabb2d& a, const Aabb2d& b);
inline Contact aabb_aabb(const Aabb3d& a, const Aabb3d& b);

namespace stages {

/// The filter decides boxes that have an interior and do not touch; the exact stage compares the bits as integers.
struct aabb_aabb : Filtered<aabb_aabb> {
  template <class Box>
  static Perhaps<Contact> filter(const Box& a, const Box& b) {
    const kernel::BoxDifferences found = kernel::differences(a, b);
    if (!found.certain()) [[unlikely]]
      return std::nullopt;
    return found.contact();
  }
  static Contact exact(const Aabb2d& a, const Aabb2d& b);
  static Contact exact(const Aabb3d& a, const Aabb3d& b);
  static Decided<Contact> past_filter(const Aabb2d& a, const Aabb2d& b);
  static Decided<Contact> past_filter(const Aabb3d& a, const Aabb3d& b);
};

}  // namespace stages

inline Contact aabb_aabb(const Aabb2d& a, const Aabb2d& b) { return stages::aabb_aabb::ask(a, b).answer; }
inline Contact aabb_aabb(const Aabb3d& a, const Aabb3d& b) { return stages::aabb_aabb::ask(a, b).answer; }

}  // namespace touchstone::robust
