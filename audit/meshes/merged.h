// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"

/// Vertices of a mesh that are one by their positions.
namespace touchstone::audit {

/// Tolerances beyond it would merge what a mesh shows.
inline constexpr double most_to_merge = 0.01;
/// Whether merging would close a mesh is told up to this tolerance; beyond it, it would rather close up what is open.
inline constexpr double most_to_suggest = 1e-4;

struct Merging {
  std::vector<Index> into;  ///< of each vertex the first of those that are one with it, which may be itself
  std::size_t merged = 0;   ///< how many are one with an earlier vertex
  double largest = 0;       ///< the largest distance of a vertex from the one that it becomes
};

/// The longest side of the box that holds the vertices, its sides along the axes.
double size_of(const std::vector<Point3d>& vertices);

/// Which vertices are one. Tolerance 0: those in equal positions. Tolerance t > 0, at most `most_to_merge`: those
/// nearer than t times the size, and those that a chain of such pairs joins (single linkage). Distances are those of
/// double arithmetic. The time is that of sorting, as long as few vertices are near one another.
Merging merging_of(const std::vector<Point3d>& vertices, double tolerance);

/// The faces of the merged mesh, over the vertices of the old one. Corners that are then named twice in a row are named
/// once; a face with fewer than three left has none.
std::vector<std::vector<Index>> faces_after(const std::vector<std::vector<Index>>& faces, const Merging& merging);

/// What merging would do to open edges.
struct MergingThatCloses {
  double tolerance;
  Merging merging;
  std::size_t open;  ///< edges that stay open
  Index one, other;  ///< vertices that become one, those farthest apart, and how far that is
  double apart;
};

/// The least of the tolerances 0, 1e-12, 1e-11, ..., 1e-4 that closes the mesh, or that leaves fewest edges open; empty
/// where none leaves fewer than `open`.
std::optional<MergingThatCloses> merging_that_closes(const std::vector<Point3d>& vertices,
                                                     const std::vector<std::vector<Index>>& faces, std::size_t open);

/// How many edges are in an odd number of faces.
std::size_t count_open_edges(const std::vector<std::vector<Index>>& faces);

/// Visits each pair of vertices nearer than t times the size that are not in one position; of equal positions only the
/// first vertex takes part. `merging_of` says of which tolerances and in what time.
using VisitPair = std::function<void(Index, Index, double distance)>;
void each_near_pair(const std::vector<Point3d>& vertices, double tolerance, const VisitPair& visit);

}  // namespace touchstone::audit
