// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_answers.h"
#include "catalogue/shape/described_triangles.h"
#include "geometry/rays.h"

namespace touchstone::catalogue {

template <class R>
struct Described<Ray3<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("origin", &Ray3<R>::origin), member("direction", &Ray3<R>::direction)};
};
template <class R>
struct Described<LinePlane<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &LinePlane<R>::relation), member("t", &LinePlane<R>::t),
                                             member("point", &LinePlane<R>::point)};
};
template <class R>
struct Described<RayTriangle<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &RayTriangle<R>::relation), member("t", &RayTriangle<R>::t),
                 member("point", &RayTriangle<R>::point), member("location", &RayTriangle<R>::location)};
};
template <class R>
struct Described<Passage<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &Passage<R>::relation),
                                             member("first", &Passage<R>::first), member("last", &Passage<R>::last)};
};
template <>
struct Words<LinePlaneRelation> {
  static constexpr std::array<const char*, 3> words{"none", "point", "inside"};
  static constexpr LinePlaneRelation no = LinePlaneRelation::none;
};

template <>
struct Words<PassageRelation> {
  static constexpr std::array<const char*, 2> words{"none", "hit"};
  static constexpr PassageRelation no = PassageRelation::none;
};

}  // namespace touchstone::catalogue
