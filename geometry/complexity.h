// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polygons.h"
#include "geometry/volumes.h"

namespace touchstone {

/// `none` where faces do not enclose a volume: the mesh is open, or is not oriented.
enum class VolumeSign { none, negative, zero, positive };
constexpr auto words_of(VolumeSign) { return as_words("none", "negative", "zero", "positive"); }

/// A face whose plane has vertices on both sides: the first vertex that is not on it, and the first on the other side.
struct SplittingFace {
  Index face, one, other;
  static constexpr auto members = as_record("face", "one", "other");
  friend bool operator==(const SplittingFace&, const SplittingFace&) = default;
};

/// The parts of a mesh, and whether it is a surface and encloses a volume. The words are defined in
/// reference/polyhedra/polyhedron_complexity.h. After the words come their witnesses, each present if its word is
/// false.
template <class Real>
struct PolyhedronComplexity {
  Index vertices, edges, faces, components;
  Real euler;  ///< vertices - edges + faces, which may be negative
  VolumeSign volume;
  bool closed, oriented, edge_manifold, vertex_manifold, embedded, convex;
  std::optional<IndexPair> open_edge, turned_edge, crowded_edge;
  std::optional<Index> pinched_vertex, flat_face;
  std::optional<IndexPair> meeting_faces;
  std::optional<SplittingFace> splitting_face;
  /// Component i contains component j, in ascending order.
  std::optional<std::vector<IndexPair>> nesting;
  static constexpr auto members =
      as_record("vertices", "edges", "faces", "components", "euler", "volume", "closed", "oriented", "edge_manifold",
                "vertex_manifold", "embedded", "convex", "open_edge", "turned_edge", "crowded_edge", "pinched_vertex",
                "flat_face", "meeting_faces", "splitting_face", "nesting");
  friend bool operator==(const PolyhedronComplexity&, const PolyhedronComplexity&) = default;
};

}  // namespace touchstone
