// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: from the definitions: sets of vertices and edges; components by walking from face to face; at every vertex a
/// walk through its faces, which has to come past all of them. Margin: none, nothing is measured.
///
/// Certificate: "complexity": an edge or a vertex for every word that is false, `open_edge`, `turned_edge`,
/// `crowded_edge`, `pinched_vertex`, else empty lists; the rest is counted once more.
Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Meshd& mesh);
template <Exact Number>
Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Number>& mesh);

}  // namespace touchstone::oracle
