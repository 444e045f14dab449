// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/closest.h"
#include "robust/kernel/enclosed/nearest_parts.h"
#include "robust/kernel/filters/staged.h"

/// Answers from the parts that nearest_parts.h finds.
namespace touchstone::robust {

namespace filters {

/// The contact of two shapes, one or both of them grown by a radius, as in kernel::contact; empty if it is not certain.
/// Radii are `moderate` and not negative.
Perhaps<Contact> contact(const Parts& parts, double radius_of_a, double radius_of_b, bool interiors);
template <class A, class B>
Perhaps<Contact> contact(const A& a, double radius_of_a, const B& b, double radius_of_b, bool interiors) {
  if (!(moderate(a) & moderate(b) & moderate(radius_of_a) & moderate(radius_of_b))) return std::nullopt;
  return contact(nearest_parts(a, b), radius_of_a, radius_of_b, interiors);
}

}  // namespace filters

namespace kernel {

/// The same contact, with one and a half times the precision. Polynomials of degree 6 in `moderate` numbers have heads
/// and tails that are multiples of 2^-492; an error of one of degree 3 is 0 or at least 2^-324, so that no product of
/// two errors underflows. Not proved by machine.
Perhaps<Contact> close_contact(const filters::Parts& parts, double radius_of_a, double radius_of_b, bool interiors);
template <class A, class B>
Perhaps<Contact> close_contact(const A& a, double radius_of_a, const B& b, double radius_of_b, bool interiors) {
  using filters::moderate;
  if (!(moderate(a) & moderate(b) & moderate(radius_of_a) & moderate(radius_of_b))) return std::nullopt;
  return close_contact(filters::nearest_parts(a, b), radius_of_a, radius_of_b, interiors);
}

/// Empty if a part or a number is unknown.
Perhaps<ClosestPair3<double>> closest_pair(const filters::Parts& parts);
Perhaps<ClosestPoint3<double>> closest_point(const filters::Parts& parts);

}  // namespace kernel

}  // namespace touchstone::robust
