// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/prepared.h"
#include "geometry/complexity.h"

/// Describes a mesh and its defects, in words and in the numbers of its file.
namespace touchstone::audit {

/// The reasons why a mesh bounds no solid, the worst first: faces that are not polygons, so that nothing else can be
/// decided; duplicate faces, which cause many of the later defects; holes; places where the surface branches, meets
/// itself, or is inconsistently oriented; and defects that reversing faces repairs.
enum class MeshDefect {
  few_faces,        ///< fewer than 4
  askew_face,       ///< its corners are not coplanar
  no_ring,          ///< a face of more than three corners encloses no area, crosses or touches itself
  repeated_corner,  ///< a triangle names a vertex twice, or a face does so consecutively
  flat_face,        ///< a triangle without area
  repeated_face,    ///< the same corners in the same order as an earlier face
  opposed_face,     ///< the same corners in the opposite order
  open_edge,        ///< in an odd number of faces
  crowded_edge,     ///< in three faces or more
  pinched_vertex,   ///< sheets meet only in this vertex
  meeting_faces,    ///< they meet beyond what both share
  one_sided,        ///< no choice of orientations agrees at all edges
  turned_faces,     ///< faces with an orientation opposite to that of their neighbours
  inside_out,       ///< a component whose faces look inwards
  filled_cavity,    ///< a component inside another one that encloses the same space again
};
inline constexpr std::array defect_names{"few_faces",    "askew_face",     "no_ring",       "repeated_corner",
                                         "flat_face",    "repeated_face",  "opposed_face",  "open_edge",
                                         "crowded_edge", "pinched_vertex", "meeting_faces", "one_sided",
                                         "turned_faces", "inside_out",     "filled_cavity"};

/// Indices in the file's lists, from 0.
struct PlaceInMesh {
  std::vector<std::size_t> faces, vertices;
};

struct FoundDefect {
  MeshDefect defect;
  std::size_t count;
  std::vector<PlaceInMesh> first;  ///< at most three
  std::string what;                ///< "2 open edges"
  std::string where;               ///< "edge from vertex 1 to vertex 4 (lines 3 and 6), of face 2 (line 12)"
  std::string mend;                ///< "fill the hole"
};

struct Diagnosis {
  std::size_t vertices = 0, edges = 0, faces = 0, components = 0;
  std::map<std::size_t, std::size_t> faces_by_corners;
  std::array<double, 3> low{}, high{};  ///< the extents along x, y and z
  bool closed = false, oriented = false, edge_manifold = false, vertex_manifold = false;
  std::optional<bool> embedded, convex;  ///< nullopt if faces are not polygons
  VolumeSign volume = VolumeSign::none;
  std::vector<IndexPair> nesting;
  std::vector<FoundDefect> found;     ///< the worst first
  std::vector<std::string> notes;     ///< on harmless properties
  std::vector<std::string> done;      ///< applied before the diagnosis: merged, dropped, cut
  std::vector<std::size_t> reversed;  ///< faces that have to be reversed, if that is certain

  /// A closed surface without branches that does not meet itself, whose faces look outwards, those of cavities inwards.
  bool solid() const { return found.empty(); }
};

/// Called with the current step.
using TellStep = std::function<void(const std::string&)>;

/// Merged vertices become the first of them; faces keep their numbers. Everything is decided exactly: properties of
/// indices by counting, the others by robust::polyhedron_complexity. Only the first pair of faces that meet is found.
/// Throws InvalidInput if `how` cannot be done (merging_of).
Diagnosis diagnosed(const MeshFile& file, const Preparation& how, const TellStep& tell = {});

}  // namespace touchstone::audit
