// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/prepared.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "audit/counted.h"
#include "audit/meshes/askew.h"
#include "audit/meshes/formats/reading.h"
#include "audit/meshes/merged.h"
#include "catalogue/codec/json.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::audit {
namespace {

using Corners = std::vector<Index>;
constexpr std::size_t most_named = 3;

/// The rules that a face may break, worst to repair first.
enum class Defect { repeated_corner, repeated_position, no_ring, askew, crossing_projection };

std::string far(double height) {
  return height > 0 && std::isfinite(height) ? "lie " + decimal(height) + " apart across it"
                                             : "are off by what double arithmetic cannot tell";
}

/// Makes the mesh face by face, and collects its defects so that one line can report the number of faces.
class Preparing {
 public:
  Preparing(const MeshFile& file, const Preparation& how, std::string field)
      : file_(file), how_(how), field_(std::move(field)) {}

  PreparedMesh result() && {
    std::vector<Corners> faces = how_.merge ? merged() : unmerged();
    for (std::size_t i = 0; i < faces.size(); ++i) add(std::move(faces[i]), i);
    if (!defects_.empty()) refuse();
    const auto triangle = [](const Corners& corners) { return corners.size() == 3; };
    if (std::all_of(mesh().polygons.begin(), mesh().polygons.end(), triangle)) mesh().polygons.clear();
    tell_cuts();
    return std::move(made_);
  }

 private:
  Meshd& mesh() { return made_.mesh; }

  std::vector<Corners> unmerged() {
    mesh().vertices = file_.vertices;
    for (std::size_t v = 0; v < file_.vertices.size(); ++v) made_.vertex_in_file.push_back(v);
    return file_.faces;
  }

  /// Removed faces have no corners.
  std::vector<Corners> merged() {
    const Merging merging = merging_of(file_.vertices, *how_.merge);
    std::vector<Index> place(file_.vertices.size());
    for (Index v = 0; v < file_.vertices.size(); ++v) {
      if (merging.into[v] == v) {
        place[v] = static_cast<Index>(mesh().vertices.size());
        mesh().vertices.push_back(file_.vertices[v]);
        made_.vertex_in_file.push_back(v);
      } else {
        place[v] = place[merging.into[v]];
      }
    }
    tell_merging(merging);
    std::vector<Corners> faces = faces_after(file_.faces, merging);
    std::vector<std::size_t> gone, smaller;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (Index& corner : faces[i]) corner = place[corner];
      if (faces[i].size() < file_.faces[i].size()) (faces[i].empty() ? gone : smaller).push_back(i);
    }
    tell_faces(gone, "with fewer than three corners left dropped");
    tell_faces(smaller, "left without the corners that would stand twice in a row");
    return faces;
  }

  void tell_merging(const Merging& merging) {
    const std::string which =
        *how_.merge == 0 ? "in equal positions"
                         : "nearer than " + decimal(*how_.merge) + " of the size " + decimal(size_of(file_.vertices));
    if (merging.merged == 0) {
      made_.done.push_back("no vertices merged: none are " + which);
      return;
    }
    const std::string moved = merging.largest > 0 ? ", the largest distance being " + decimal(merging.largest) : "";
    made_.done.push_back(meshes::vertices(merging.merged) + " merged into others, those " + which + moved + "; " +
                         meshes::vertices(mesh().vertices.size()) + " left");
  }

  void tell_faces(const std::vector<std::size_t>& faces, const std::string& what) {
    if (faces.empty()) return;
    std::string list;
    for (std::size_t k = 0; k < std::min(faces.size(), most_named); ++k)
      list += (k == 0 ? "" : ", ") + face_in_words(file_, faces[k]);
    if (faces.size() > most_named) list += " and " + std::to_string(faces.size() - most_named) + " more";
    made_.done.push_back(counted(faces.size(), "face") + " " + what + ": " + list);
  }

  void add(Corners corners, std::size_t face) {
    if (corners.empty()) return;
    if (corners.size() == 3) return add_triangles({{corners[0], corners[1], corners[2]}}, face);
    if (in_a_row(corners, face)) return;
    auto cut = robust::kernel::cut_polygon(mesh().vertices, corners);
    if (const auto* triangles = std::get_if<std::vector<Face>>(&cut)) {
      mesh().faces.insert(mesh().faces.end(), triangles->begin(), triangles->end());
      mesh().polygons.push_back(std::move(corners));
      made_.face_in_file.push_back(face);
    } else if (std::get<robust::kernel::PolygonDefect>(cut) == robust::kernel::PolygonDefect::no_ring) {
      note(Defect::no_ring, face);
    } else {
      add_askew(corners, face);
    }
  }

  void add_askew(const Corners& corners, std::size_t face) {
    const double height = robust::thickness(mesh().vertices, corners);
    const bool thin = how_.planar && height <= *how_.planar;
    if (!thin && how_.cut == Preparation::Cut::exact) return note(Defect::askew, face, height);
    std::optional<std::vector<Face>> triangles;
    if (thin) {
      triangles = cut_as_projected(mesh().vertices, corners);
    } else if (how_.cut == Preparation::Cut::shortest) {
      triangles = cut_along_shortest(mesh().vertices, corners);
    } else {
      triangles = cut_as_fan(corners);
    }
    if (!triangles) return note(Defect::crossing_projection, face);
    auto& [count, most] = thin ? projected_ : cut_;
    ++count, most = std::max(most, height);
    add_triangles(*triangles, face);
  }

  void add_triangles(const std::vector<Face>& triangles, std::size_t face) {
    for (const Face& f : triangles) {
      mesh().faces.push_back(f);
      mesh().polygons.push_back({f.a, f.b, f.c});
      made_.face_in_file.push_back(face);
    }
  }

  /// True if two consecutive corners are the same, or at the same position; notes it.
  bool in_a_row(const Corners& corners, std::size_t face) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index one = corners[k], next = corners[(k + 1) % corners.size()];
      if (!(mesh().vertices[one] == mesh().vertices[next])) continue;
      if (defects_.empty()) row_ = {made_.vertex_in_file[one], made_.vertex_in_file[next]};
      note(one == next ? Defect::repeated_corner : Defect::repeated_position, face);
      return true;
    }
    return false;
  }

  void note(Defect defect, std::size_t face, double height = 0) {
    if (defects_.empty()) first_ = {defect, face, height};
    auto& [count, worst, most] = defects_[defect];
    if (count++ == 0 || height > most) worst = face, most = height;
  }

  void tell_cuts() {
    const auto tell = [&](const std::pair<std::size_t, double>& cut, const std::string& how) {
      const auto& [count, most] = cut;
      if (count == 0) return;
      made_.done.push_back(counted(count, "face") + " cut " + how + ": the corners are not in one plane but up to " +
                           decimal(most) + " apart across it");
    };
    tell(projected_, "as seen along an axis");
    tell(cut_, how_.cut == Preparation::Cut::fan ? "as a fan from the first corner" : "along shortest diagonals");
  }

  [[noreturn]] void refuse() const {
    const auto& [defect, face, height] = first_;
    const auto& [count, worst, most] = defects_.at(defect);
    const std::string others = count == 1 ? "" : "; so it is with " + counted(count - 1, "face") + " more";
    std::string rule;
    switch (defect) {
      case Defect::repeated_corner:
        rule = "names " + vertex_in_words(file_, row_.first) +
               " twice in a row; drop one of the two corners, or --merge does";
        break;
      case Defect::repeated_position:
        rule = vertices_in_words(file_, row_.first, row_.second) +
               ", corners in a row, have one position; drop one of the two corners, or --merge does";
        break;
      case Defect::no_ring: rule = "a polygon that encloses one area and does not cross itself"; break;
      case Defect::askew:
        rule = "planar: its corners " + far(height);
        if (count > 1) {
          rule += ", and " + counted(count - 1, "face") + " more " + (count == 2 ? "is" : "are") +
                  " not planar, the worst " + face_in_words(file_, worst) + ", by " + decimal(most);
        }
        rule += "; --planar TOLERANCE or --cut fan|shortest makes a solid of ";
        refuse(face, rule + (count == 1 ? "it" : "them"));
      case Defect::crossing_projection:
        rule = "planar: it is not, and as seen along an axis it crosses itself or encloses no area; --cut fan cuts it";
        break;
    }
    refuse(face, rule + others);
  }
  [[noreturn]] void refuse(std::size_t face, const std::string& rule) const {
    const std::string named = field_ + ".faces[" + std::to_string(face) + "]";
    const std::string number = "face " + std::to_string(face + file_.first_number);
    throw InvalidInput(place_of_face(file_, face), number + " (" + named + "): " + rule);
  }

  struct First {
    Defect defect;
    std::size_t face;
    double height;
  };
  struct Found {
    std::size_t count = 0, worst = 0;
    double most = 0;
  };

  const MeshFile& file_;
  const Preparation& how_;
  std::string field_;
  PreparedMesh made_;
  First first_{};
  std::map<Defect, Found> defects_;
  std::pair<std::size_t, std::size_t> row_;             ///< vertices of the first refused face
  std::pair<std::size_t, double> projected_{}, cut_{};  ///< the number of faces, and the largest thickness
};

}  // namespace

PreparedMesh prepared(const MeshFile& file, const Preparation& how, const std::string& field) {
  return Preparing(file, how, field).result();
}

}  // namespace touchstone::audit
