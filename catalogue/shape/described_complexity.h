// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described.h"
#include "geometry/complexity.h"

namespace touchstone::catalogue {

template <class R>
struct Described<PolyhedronComplexity<R>> {
  using Self = PolyhedronComplexity<R>;
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("vertices", &Self::vertices),
                                             member("edges", &Self::edges),
                                             member("faces", &Self::faces),
                                             member("components", &Self::components),
                                             member("euler", &Self::euler),
                                             member("closed", &Self::closed),
                                             member("oriented", &Self::oriented),
                                             member("edge_manifold", &Self::edge_manifold),
                                             member("vertex_manifold", &Self::vertex_manifold)};
};

}  // namespace touchstone::catalogue
