// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_steps.h"
#include "geometry/impacts.h"

/// Moments within a step.
namespace touchstone::catalogue {

template <class R>
struct Described<Moment<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("t", &Moment<R>::t), member("contacts", &Moment<R>::contacts)};
};
template <class R>
struct Described<ImpactStep<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &ImpactStep<R>::relation), member("moments", &ImpactStep<R>::moments),
                 member("bodies", &ImpactStep<R>::bodies)};
};
template <>
struct Words<StepCourse> {
  static constexpr std::array<const char*, 3> words{"finished", "too_many_moments", "too_many_contacts"};
};

}  // namespace touchstone::catalogue
