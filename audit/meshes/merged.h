// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"

/// Merges vertices of a mesh by their positions.
namespace touchstone::audit {

/// Larger tolerances would merge visible details.
inline constexpr double most_to_merge = 0.01;
/// Merging is suggested up to this tolerance; a larger one would rather close real openings.
inline constexpr double most_to_suggest = 1e-4;

struct Merging {
  std::vector<Index> into;  ///< for each vertex the first of those merged with it, which may be itself
  std::size_t merged = 0;   ///< number of vertices merged with an earlier one
  double largest = 0;       ///< the largest distance of a vertex from the one that it becomes
};

/// The longest side of the axis-aligned box around the vertices.
double size_of(const std::vector<Point3d>& vertices);

/// Determines which vertices are merged. Tolerance 0: those at equal positions. Tolerance t > 0, at most
/// `most_to_merge`: those nearer than t times the size, and those connected by a chain of such pairs (single linkage).
/// Distances are those of double arithmetic. The time is that of sorting, as long as few vertices are near one another.
Merging merging_of(const std::vector<Point3d>& vertices, double tolerance);

/// The faces of the merged mesh, over the vertices of the old one. Corners that are then repeated consecutively are
/// reduced to one; a face with fewer than three left has none.
std::vector<std::vector<Index>> faces_after(const std::vector<std::vector<Index>>& faces, const Merging& merging);

/// The effect of merging on open edges.
struct MergingThatCloses {
  double tolerance;
  Merging merging;
  std::size_t open;  ///< edges that stay open
  Index one, other;  ///< the merged vertices that are farthest apart, and their distance
  double apart;
};

/// The least of the tolerances 0, 1e-12, 1e-11, ..., 1e-4 that closes the mesh, or that leaves the fewest edges open;
/// nullopt if none leaves fewer than `open`.
std::optional<MergingThatCloses> merging_that_closes(const std::vector<Point3d>& vertices,
                                                     const std::vector<std::vector<Index>>& faces, std::size_t open);

/// The number of edges in an odd number of faces.
std::size_t count_open_edges(const std::vector<std::vector<Index>>& faces);

/// Visits each pair of vertices nearer than t times the size at different positions; of vertices at equal positions
/// only the first takes part. `merging_of` states the tolerances and the time.
using VisitPair = std::function<void(Index, Index, double distance)>;
void each_near_pair(const std::vector<Point3d>& vertices, double tolerance, const VisitPair& visit);

}  // namespace touchstone::audit
