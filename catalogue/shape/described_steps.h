// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_shapes.h"
#include "geometry/steps.h"

/// Bodies before and after a step.
namespace touchstone::catalogue {

template <class R>
struct Described<StepBody<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("inverse_mass", &StepBody<R>::inverse_mass), member("velocity", &StepBody<R>::velocity),
                 member("sphere", &StepBody<R>::sphere)};
};
template <class R>
struct Described<StepSettings<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("gravity", &StepSettings<R>::gravity), member("motion", &StepSettings<R>::motion),
                 member("restitution", &StepSettings<R>::restitution), member("timestep", &StepSettings<R>::timestep),
                 member("turn", &StepSettings<R>::turn)};
};
template <class R>
struct Described<BodyState<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("position", &BodyState<R>::position), member("velocity", &BodyState<R>::velocity)};
};
template <class R>
struct Described<NextState<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("contacts", &NextState<R>::contacts), member("bodies", &NextState<R>::bodies)};
};

template <>
struct Words<StepMotion> {
  static constexpr std::array<const char*, 3> words{"accelerate_then_move", "move_then_accelerate", "parabola"};
};
template <>
struct Words<StepTurn> {
  static constexpr std::array<const char*, 2> words{"before_move", "after_move"};
};

}  // namespace touchstone::catalogue
