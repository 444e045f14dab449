// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/capsule_capsule.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/contact_of_nearest.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Contact> truth_capsule_capsule(const Capsule3<Number>& a, const Capsule3<Number>& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validation::validate("a", a), validation::validate("b", b);
  const auto ends = [](const Segment3<Number>& s) { return Hull{exact(s.a), exact(s.b)}; };
  const NearestPair nearest = nearest_pair(ends(a.segment), ends(b.segment));
  return contact_of_nearest(nearest.squared_distance, {exact(a.radius), exact(b.radius)},
                            {{"on_a", nearest.weights_of_a}, {"on_b", nearest.weights_of_b}});
}

}  // namespace

Truth<Contact> capsule_capsule(const Capsule3d& a, const Capsule3d& b) { return truth_capsule_capsule(a, b); }

template <Exact Number>
Truth<Contact> capsule_capsule(const Capsule3<Number>& a, const Capsule3<Number>& b) {
  return truth_capsule_capsule(a, b);
}
template Truth<Contact> capsule_capsule(const Capsule3<Rational>&, const Capsule3<Rational>&);

}  // namespace touchstone::oracle
