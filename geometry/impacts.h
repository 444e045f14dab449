// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/steps.h"

namespace touchstone {

/// The extent to which a step is answered: to its end; or not, since it has more than sixteen moments, or a moment that
/// is no rational number with more than six contacts of connected bodies.
enum class StepCourse { finished, too_many_moments, too_many_contacts };
constexpr auto words_of(StepCourse) { return as_words("finished", "too_many_moments", "too_many_contacts"); }
inline constexpr std::size_t most_moments = 16, most_contacts_at_a_root = 6;

/// When bodies collide within a step, t = 0 its start and t = 1 its end; contacts as in NextState.
template <class Real>
struct Moment {
  Real t;
  std::vector<IndexPair> contacts;
  static constexpr auto members = as_record("t", "contacts");
};

/// The moments in their order, the one of too many contacts the last; and where the step is finished the state at its
/// end.
template <class Real>
struct ImpactStep {
  StepCourse relation;
  std::vector<Moment<Real>> moments;
  std::optional<std::vector<BodyState<Real>>> bodies;
  static constexpr auto members = as_record("relation", "moments", "bodies");
};
using ImpactStepd = ImpactStep<double>;

}  // namespace touchstone
