// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_shapes.h"
#include "geometry/complexity.h"

namespace touchstone::catalogue {

template <>
struct Words<VolumeSign> {
  static constexpr std::array<const char*, 4> words{"none", "negative", "zero", "positive"};
};
template <>
struct Described<SplittingFace> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("face", &SplittingFace::face), member("one", &SplittingFace::one),
                                             member("other", &SplittingFace::other)};
};
template <class R>
struct Described<PolyhedronComplexity<R>> {
  using Self = PolyhedronComplexity<R>;
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("vertices", &Self::vertices),
                                             member("edges", &Self::edges),
                                             member("faces", &Self::faces),
                                             member("components", &Self::components),
                                             member("euler", &Self::euler),
                                             member("volume", &Self::volume),
                                             member("closed", &Self::closed),
                                             member("oriented", &Self::oriented),
                                             member("edge_manifold", &Self::edge_manifold),
                                             member("vertex_manifold", &Self::vertex_manifold),
                                             member("embedded", &Self::embedded),
                                             member("convex", &Self::convex),
                                             member("open_edge", &Self::open_edge),
                                             member("turned_edge", &Self::turned_edge),
                                             member("crowded_edge", &Self::crowded_edge),
                                             member("pinched_vertex", &Self::pinched_vertex),
                                             member("flat_face", &Self::flat_face),
                                             member("meeting_faces", &Self::meeting_faces),
                                             member("splitting_face", &Self::splitting_face),
                                             member("nesting", &Self::nesting)};
};

}  // namespace touchstone::catalogue
