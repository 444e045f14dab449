// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone {

/// The step of the test of two polyhedra that decides; what each means stands in
/// reference/polyhedra/polyhedron_polyhedron.h.
enum class PolyhedraStep { bounding_volumes, vertex_inside, edge_against_face };
constexpr auto words_of(PolyhedraStep) { return as_words("bounding_volumes", "vertex_inside", "edge_against_face"); }

struct PolyhedronPolyhedron {
  Contact relation;
  PolyhedraStep decided_by;
  static constexpr auto members = as_record("relation", "decided_by");
};

}  // namespace touchstone
