// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_answers.h"
#include "geometry/solids.h"

namespace touchstone::catalogue {

template <>
struct Words<PolyhedraStep> {
  static constexpr std::array<const char*, 3> words{"bounding_volumes", "vertex_inside", "edge_against_face"};
};
template <>
struct Described<PolyhedronPolyhedron> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &PolyhedronPolyhedron::relation),
                                             member("decided_by", &PolyhedronPolyhedron::decided_by)};
};

}  // namespace touchstone::catalogue
