// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "audit/counted.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/structures/embedded_mesh.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::audit::meshes {
namespace {

using Places = std::vector<std::size_t>;

constexpr std::size_t most_listed = 3;

/// A defect of faces alone.
FoundDefect found_faces(const Examined& examined, MeshDefect defect, const Places& faces, const std::string& what,
                        const std::string& mend) {
  FoundDefect found{defect, faces.size(), {}, what, faces_listed(examined.file, faces), mend};
  for (std::size_t k = 0; k < std::min(most_listed, faces.size()); ++k) found.first.push_back({{faces[k]}, {}});
  return found;
}

FoundDefect askew_faces(const Examined& examined, const Places& faces, double thickest) {
  const std::string verb =
      faces.size() == 1 ? " is not planar: its corners lie up to " : " are not planar: corners lie up to ";
  // Rounded to two digits it is still sufficient.
  const std::string enough = fmt::format("{:.2g}", 1.1 * thickest);
  return found_faces(examined, MeshDefect::askew_face, faces,
                     counted(faces.size(), "face") + verb + fmt::format("{:.2g}", thickest) + " apart across it",
                     "--planar " + enough + ", --cut shortest or --cut fan says how to cut them");
}

std::string are_flat(std::size_t count) {
  return counted(count, "triangle") + (count == 1 ? " has no area" : " have no area");
}

Places flat_triangles(const Examined& examined) {
  Places flat;
  const std::vector<Point3d>& vertices = examined.mesh.vertices;
  for (std::size_t i = 0; i < examined.mesh.faces.size(); ++i) {
    const Corners& f = examined.mesh.faces[i];
    if (f.size() != 3) continue;
    const Meshd alone{{vertices[f[0]], vertices[f[1]], vertices[f[2]]}, {{0, 1, 2}}, {}};
    if (robust::structures::first_flat_face(alone)) flat.push_back(examined.face_in_file[i]);
  }
  return flat;
}

bool same_corners(const Examined& examined, const PreparedMesh& cut, const IndexPair& pair) {
  Corners one = examined.mesh.faces[cut.face_in_file[pair.i]], other = examined.mesh.faces[cut.face_in_file[pair.j]];
  std::sort(one.begin(), one.end()), std::sort(other.begin(), other.end());
  return one == other;
}

/// If an edge is open, faces may meet for the same reason.
std::string mend_of_meeting(const Examined& examined, bool merging_closes) {
  if (merging_closes) return "merge first, as at the open edges; whether faces meet is decided again after that";
  return std::string("cut the faces where they cross") +
         (examined.surface.components > 1 ? ", or move the parts apart" : "") +
         (examined.surface.open.empty() ? "" : "; mend the open edges first, where that is why they meet");
}

}  // namespace

std::string faces_listed(const MeshFile& file, const std::vector<std::size_t>& faces) {
  std::string text = faces.size() == 1 ? "face " : "faces ";
  const std::size_t shown = std::min(most_listed, faces.size());
  for (std::size_t k = 0; k < shown; ++k) {
    if (k > 0) text += k + 1 == faces.size() ? " and " : ", ";
    text += face_in_words(file, faces[k]).substr(std::string("face ").size());
  }
  return faces.size() > shown ? text + fmt::format(" and {} more", grouped(faces.size() - shown)) : text;
}

std::string merging_in_words(const Merging& merging) {
  const std::string count = counted(merging.into.size(), "vertex");
  if (merging.merged == 0) return "no vertex of " + count + " merged";
  if (merging.largest == 0) return fmt::format("{} of {} merged into others in equal positions", merging.merged, count);
  return fmt::format("{} of {} merged into others, at most {:.2g} away", merging.merged, count, merging.largest);
}

std::vector<FoundDefect> defects_of_faces(const Examined& examined, const Preparation& how) {
  Places askew, no_ring, repeated;
  double thickest = 0;
  const std::vector<Point3d>& vertices = examined.mesh.vertices;
  for (std::size_t i = 0; i < examined.mesh.faces.size(); ++i) {
    const Corners& corners = examined.mesh.faces[i];
    const std::size_t face = examined.face_in_file[i];
    if (repeats_corner(corners)) {
      repeated.push_back(face);
    } else if (corners.size() > 3) {
      const auto cut = robust::kernel::cut_polygon(vertices, corners);
      const auto* defect = std::get_if<robust::kernel::PolygonDefect>(&cut);
      if (defect == nullptr) continue;
      if (*defect == robust::kernel::PolygonDefect::no_ring) {
        no_ring.push_back(face);
        continue;
      }
      const double thickness = robust::thickness(vertices, corners);
      if (how.cut != Preparation::Cut::exact || (how.planar && thickness <= *how.planar)) continue;
      askew.push_back(face), thickest = std::max(thickest, thickness);
    }
  }
  std::vector<FoundDefect> found;
  if (!askew.empty()) found.push_back(askew_faces(examined, askew, thickest));
  if (!no_ring.empty())
    found.push_back(found_faces(
        examined, MeshDefect::no_ring, no_ring,
        counted(no_ring.size(), "polygon") + (no_ring.size() == 1 ? " encloses no area, or crosses or touches itself"
                                                                  : " enclose no area, or cross or touch themselves"),
        "name the corners in their order around the area, each once"));
  if (!repeated.empty())
    found.push_back(found_faces(
        examined, MeshDefect::repeated_corner, repeated,
        counted(repeated.size(), "face") + (repeated.size() == 1 ? " names" : " name") + " a corner twice in a row",
        "name it once; a face with fewer than three corners left goes (--repair)"));
  return found;
}

std::vector<FoundDefect> defects_of_shape(const Examined& examined, const PreparedMesh& cut,
                                          const PolyhedronComplexity<double>& complexity, bool merging_closes) {
  std::vector<FoundDefect> found;
  const auto face = [&](Index named) { return examined.face_in_file[cut.face_in_file[named]]; };
  if (complexity.flat_face) {
    const Places flat = flat_triangles(examined);
    if (!flat.empty())
      found.push_back(found_faces(examined, MeshDefect::flat_face, flat, are_flat(flat.size()),
                                  "collapse an edge of each; whether faces meet elsewhere is decided after that"));
    else  // from a face that was cut
      found.push_back(found_faces(examined, MeshDefect::flat_face, {face(*complexity.flat_face)},
                                  "a triangle of the cut has no area", "another --cut"));
  }
  // Faces with the same corners are reported as such.
  if (complexity.meeting_faces && !same_corners(examined, cut, *complexity.meeting_faces)) {
    const std::size_t one = face(complexity.meeting_faces->i), other = face(complexity.meeting_faces->j);
    found.push_back({MeshDefect::meeting_faces,
                     1,
                     {{{one, other}, {}}},
                     "faces meet beyond the vertices that both name",
                     "the first pair: " + faces_in_words(examined.file, one, other),
                     mend_of_meeting(examined, merging_closes)});
  }
  return found;
}

}  // namespace touchstone::audit::meshes
