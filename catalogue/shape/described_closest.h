// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_triangles.h"
#include "geometry/closest.h"

namespace touchstone::catalogue {

template <class R>
struct Described<ClosestPoint2<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("point", &ClosestPoint2<R>::point),
                                             member("squared_distance", &ClosestPoint2<R>::squared_distance),
                                             member("distance", &ClosestPoint2<R>::distance)};
};
template <class R>
struct Described<ClosestPoint3<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("point", &ClosestPoint3<R>::point),
                                             member("squared_distance", &ClosestPoint3<R>::squared_distance),
                                             member("distance", &ClosestPoint3<R>::distance)};
};
template <class R>
struct Described<ClosestPair2<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{
      member("on_a", &ClosestPair2<R>::on_a), member("on_b", &ClosestPair2<R>::on_b),
      member("squared_distance", &ClosestPair2<R>::squared_distance), member("distance", &ClosestPair2<R>::distance)};
};
template <class R>
struct Described<ClosestPair3<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{
      member("on_a", &ClosestPair3<R>::on_a), member("on_b", &ClosestPair3<R>::on_b),
      member("squared_distance", &ClosestPair3<R>::squared_distance), member("distance", &ClosestPair3<R>::distance)};
};
template <class R>
struct Described<ConvexDistance<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{
      member("relation", &ConvexDistance<R>::relation), member("on_a", &ConvexDistance<R>::on_a),
      member("on_b", &ConvexDistance<R>::on_b), member("squared_distance", &ConvexDistance<R>::squared_distance),
      member("distance", &ConvexDistance<R>::distance)};
};
template <>
struct Words<ConvexRelation> {
  static constexpr std::array<const char*, 2> words{"apart", "meeting"};
  static constexpr ConvexRelation no = ConvexRelation::apart;
};

}  // namespace touchstone::catalogue
