// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "robust/kernel/box_differences.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/volumes/aabb_aabb.h. Right for all finite doubles in every floating-point environment.
inline Contact aabb_aabb(const Aabb2d& a, const Aabb2d& b);
inline Contact aabb_aabb(const Aabb3d& a, const Aabb3d& b);

/// The same, and which stage decided: Stage::filter or Stage::exact.
inline Contact aabb_aabb(const Aabb2d& a, const Aabb2d& b, Stage& decided);
inline Contact aabb_aabb(const Aabb3d& a, const Aabb3d& b, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. The filter knows boxes that have an interior
/// and do not touch. The exact stage compares the bits as integers; there is no lattice.
inline std::optional<Contact> aabb_aabb_filter(const Aabb2d& a, const Aabb2d& b);
inline std::optional<Contact> aabb_aabb_filter(const Aabb3d& a, const Aabb3d& b);
Contact aabb_aabb_exact(const Aabb2d& a, const Aabb2d& b);
Contact aabb_aabb_exact(const Aabb3d& a, const Aabb3d& b);

/// Validation, then the exact stage.
Contact aabb_aabb_past_filter(const Aabb2d& a, const Aabb2d& b);
Contact aabb_aabb_past_filter(const Aabb3d& a, const Aabb3d& b);

template <class Box>
Contact aabb_aabb_of(const Box& a, const Box& b, Stage& decided) {
  const kernel::BoxDifferences found = kernel::differences(a, b);
  decided = Stage::filter;
  if (found.certain()) [[likely]]
    return found.contact();
  decided = Stage::exact;
  return aabb_aabb_past_filter(a, b);
}
template <class Box>
std::optional<Contact> aabb_aabb_filter_of(const Box& a, const Box& b) {
  const kernel::BoxDifferences found = kernel::differences(a, b);
  if (!found.certain()) return std::nullopt;
  return found.contact();
}

inline std::optional<Contact> aabb_aabb_filter(const Aabb2d& a, const Aabb2d& b) { return aabb_aabb_filter_of(a, b); }
inline std::optional<Contact> aabb_aabb_filter(const Aabb3d& a, const Aabb3d& b) { return aabb_aabb_filter_of(a, b); }

inline Contact aabb_aabb(const Aabb2d& a, const Aabb2d& b, Stage& decided) { return aabb_aabb_of(a, b, decided); }
inline Contact aabb_aabb(const Aabb3d& a, const Aabb3d& b, Stage& decided) { return aabb_aabb_of(a, b, decided); }

inline Contact aabb_aabb(const Aabb2d& a, const Aabb2d& b) {
  Stage ignored;
  return aabb_aabb_of(a, b, ignored);
}
inline Contact aabb_aabb(const Aabb3d& a, const Aabb3d& b) {
  Stage ignored;
  return aabb_aabb_of(a, b, ignored);
}

}  // namespace touchstone::robust
