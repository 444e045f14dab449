// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_shapes.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue {

template <class R>
struct Described<Segment3<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("a", &Segment3<R>::a), member("b", &Segment3<R>::b)};
};
template <class R>
struct Described<Triangle3<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members =
      std::tuple{member("a", &Triangle3<R>::a), member("b", &Triangle3<R>::b), member("c", &Triangle3<R>::c)};
};
template <class R>
struct Described<SegmentTriangle<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &SegmentTriangle<R>::relation), member("t", &SegmentTriangle<R>::t),
                 member("point", &SegmentTriangle<R>::point), member("overlap", &SegmentTriangle<R>::overlap)};
};
template <>
struct Words<SegmentTriangleRelation> {
  static constexpr std::array<const char*, 3> words{"none", "point", "segment"};
  static constexpr SegmentTriangleRelation no = SegmentTriangleRelation::none;
};
template <>
struct Words<TriangleTriangleRelation> {
  static constexpr std::array<const char*, 4> words{"none", "point", "segment", "area"};
  static constexpr TriangleTriangleRelation no = TriangleTriangleRelation::none;
};

}  // namespace touchstone::catalogue
