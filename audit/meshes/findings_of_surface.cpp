// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "audit/counted.h"
#include "audit/meshes/findings.h"
#include "audit/meshes/repeated_faces.h"
#include "audit/meshes/rims.h"

namespace touchstone::audit::meshes {
namespace {

using Places = std::vector<std::size_t>;

constexpr std::size_t most_places = 3;
constexpr const char* drop_repeated = "drop the repeated faces first (--repair)";

FoundDefect found_edges(const Examined& examined, MeshDefect defect, const std::vector<EdgeOfFile>& edges,
                        const std::string& what, const std::string& mend) {
  const EdgeOfFile& first = edges[0];
  FoundDefect found{defect, edges.size(), {}, what, edges.size() > 1 ? "the first: " : "", mend};
  found.where += edge_in_words(examined.file, first.low, first.high) + ", of " +
                 face_in_words(examined.file, examined.face_in_file[first.face]);
  for (std::size_t k = 0; k < std::min(most_places, edges.size()); ++k)
    found.first.push_back({{examined.face_in_file[edges[k].face]}, {edges[k].low, edges[k].high}});
  return found;
}

FoundDefect found_pairs(const Examined& examined, MeshDefect defect,
                        const std::vector<std::pair<std::size_t, std::size_t>>& pairs, const std::string& what,
                        const std::string& mend) {
  FoundDefect found{defect, pairs.size(), {}, what, pairs.size() > 1 ? "the first: " : "", mend};
  for (std::size_t k = 0; k < std::min(most_places, pairs.size()); ++k)
    found.first.push_back({{examined.face_in_file[pairs[k].second], examined.face_in_file[pairs[k].first]}, {}});
  found.where += faces_in_words(examined.file, found.first[0].faces[0], found.first[0].faces[1]);
  return found;
}

std::string after_merging(std::size_t open) {
  return open == 0 ? "no edge is open" : open == 1 ? "1 edge is open" : fmt::format("{} edges are open", open);
}

/// The T-junction that is reported, and the number of rims that have one.
struct TJunctions {
  std::optional<TJunction> first;
  std::size_t count = 0;
};

TJunctions t_junctions(const Examined& examined, const std::vector<Rim>& rims) {
  TJunctions found;
  for (const Rim& rim : rims) {
    const auto junction = t_junction(rim, examined.surface.open, examined.mesh.vertices);
    if (!junction) continue;
    ++found.count;
    if (!found.first) found.first = junction;
  }
  return found;
}

/// "in 3 rims", and the number of which the rest is reported.
std::string in_rims(std::size_t rims, std::size_t junctions) {
  std::string text = "in " + counted(rims, "rim");
  if (junctions == 0) return text;
  if (rims == 1) return text + ": a T-junction";
  if (junctions == rims) return text + ", all of them T-junctions";
  return text + fmt::format(", {} of them ", junctions) + (junctions == 1 ? "a T-junction" : "T-junctions");
}

/// "vertex 9 (line 9) at (0.5, 0, 0) lies on the edge from vertex 1 to vertex 2 (lines 1 and 2), of face 3 (line 12)"
std::string in_words(const Examined& examined, const TJunction& junction) {
  const MeshFile& file = examined.file;
  return vertex_in_words(file, junction.vertex) +
         (file.has_vertex_numbers ? " at " + position_in_words(file.vertices[junction.vertex]) : "") + " lies on the " +
         edge_in_words(file, junction.edge.low, junction.edge.high) + ", of " +
         face_in_words(file, examined.face_in_file[junction.edge.face]);
}

/// The effect of merging on open edges; empty if there is none.
std::string merging_mends(const Examined& examined) {
  const std::vector<Point3d>& vertices = examined.mesh.vertices;
  const auto closes = merging_that_closes(vertices, examined.mesh.faces, examined.surface.open.size());
  if (!closes) return "";
  if (closes->tolerance == 0)
    return merge_them + fmt::format("{} have {} positions; with --merge {}", counted(vertices.size(), "vertex"),
                                    vertices.size() - closes->merging.merged, after_merging(closes->open));
  return merge_them +
         fmt::format("{} are {}; with --merge {:g} {}", vertices_in_words(examined.file, closes->one, closes->other),
                     apart_in_words(closes->apart, size_of(vertices)), closes->tolerance, after_merging(closes->open));
}

FoundDefect open_edges(const Examined& examined, bool repeated) {
  const std::vector<EdgeOfFile>& open = examined.surface.open;
  const std::vector<Rim> rims = rims_of(open, examined.mesh.vertices);
  const TJunctions junctions = t_junctions(examined, rims);
  std::string mend = merging_mends(examined);
  if (mend.empty() && repeated) mend = drop_repeated;
  if (mend.empty() && junctions.first) {
    mend = junctions.count == 1 ? "split that face there" : "split the faces there";
    if (junctions.count < rims.size()) mend += "; fill the other holes, or close their rims";
  }
  if (mend.empty()) mend = rims.size() == 1 ? "fill the hole, or close the rim" : "fill the holes, or close the rims";
  FoundDefect found = found_edges(
      examined, MeshDefect::open_edge, open,
      fmt::format("{}, {}", counted(open.size(), "open edge"), in_rims(rims.size(), junctions.count)), mend);
  if (junctions.first) {
    found.where = (junctions.count > 1 ? "the first: " : "") + in_words(examined, *junctions.first);
  } else if (rims.size() > 1 || !examined.file.has_vertex_numbers) {
    found.where +=
        fmt::format(", in a rim of {} that is {:.6g} long", counted(rims[0].edges.size(), "edge"), rims[0].length);
  }
  return found;
}

FoundDefect pinched_vertices(const Examined& examined, const std::vector<Index>& pinched) {
  FoundDefect found{MeshDefect::pinched_vertex,
                    pinched.size(),
                    {},
                    pinched.size() == 1 ? "sheets meet in 1 vertex alone"
                                        : fmt::format("sheets meet in {} vertices alone", pinched.size()),
                    (pinched.size() > 1 ? "the first: " : "") + vertex_in_words(examined.file, pinched[0]),
                    "give each sheet a vertex of its own there, and move them apart"};
  for (std::size_t k = 0; k < std::min(most_places, pinched.size()); ++k) found.first.push_back({{}, {pinched[k]}});
  return found;
}

FoundDefect found_sheets(const Examined& examined, MeshDefect defect, const Places& firsts, const std::string& what,
                         const std::string& mend) {
  Places faces;
  for (const std::size_t i : firsts) faces.push_back(examined.face_in_file[i]);
  FoundDefect found{defect, firsts.size(), {}, what, "that of " + faces_listed(examined.file, faces), mend};
  for (std::size_t k = 0; k < std::min(most_places, faces.size()); ++k) found.first.push_back({{faces[k]}, {}});
  return found;
}

}  // namespace

std::vector<FoundDefect> defects_of_surface(const Examined& examined) {
  std::vector<FoundDefect> found;
  const Surface& surface = examined.surface;
  const std::size_t faces = examined.mesh.faces.size();
  if (faces < 4)
    found.push_back({MeshDefect::few_faces,
                     faces,
                     {},
                     counted(faces, "face") + ", and a solid has at least 4",
                     "",
                     "add the others"});
  const RepeatedFaces repeated = repeated_faces(examined.mesh.faces);
  if (!repeated.same.empty())
    found.push_back(found_pairs(examined, MeshDefect::repeated_face, repeated.same,
                                repeated.same.size() == 1 ? "a face is there twice"
                                                          : counted(repeated.same.size(), "face") + " are there again",
                                "drop the later ones (--repair)"));
  if (!repeated.opposed.empty())
    found.push_back(found_pairs(examined, MeshDefect::opposed_face, repeated.opposed,
                                repeated.opposed.size() == 1
                                    ? "2 faces have the same corners and look opposite ways"
                                    : counted(repeated.opposed.size(), "face") +
                                          " have the corners of an earlier one and look the opposite way",
                                "drop one of each two, or both where they are a wall between two cells"));
  if (!surface.open.empty()) found.push_back(open_edges(examined, !repeated.same.empty()));
  if (!surface.crowded.empty())
    found.push_back(found_edges(examined, MeshDefect::crowded_edge, surface.crowded,
                                counted(surface.crowded.size(), "edge") +
                                    (surface.crowded.size() == 1 ? " is" : " are") + " in three faces or more",
                                repeated.same.empty()
                                    ? "delete inner faces, or split the vertices there and move the sheets apart"
                                    : drop_repeated));
  // A pinched vertex at a crowded edge is reported with it.
  if (!surface.pinched.empty() && surface.crowded.empty()) found.push_back(pinched_vertices(examined, surface.pinched));
  return found;
}

std::vector<FoundDefect> defects_of_turning(const Examined& examined, const Turning& turning) {
  std::vector<FoundDefect> found;
  const Surface& surface = examined.surface;
  Places one_sided;
  for (std::size_t i = 0; i < surface.sheet.size(); ++i)
    if (surface.one_sided[surface.sheet[i]] && std::none_of(one_sided.begin(), one_sided.end(), [&](std::size_t j) {
          return surface.sheet[j] == surface.sheet[i];
        }))
      one_sided.push_back(i);
  if (!one_sided.empty())
    found.push_back(found_sheets(examined, MeshDefect::one_sided, one_sided,
                                 one_sided.size() == 1
                                     ? "a sheet is one-sided, as a Moebius strip"
                                     : counted(one_sided.size(), "sheet") + " are one-sided, as Moebius strips",
                                 "no reversing of faces mends it: cut it open where it twists"));
  if (!turning.turned.empty()) {
    Places faces;
    for (const std::size_t i : turning.turned) faces.push_back(examined.face_in_file[i]);
    FoundDefect turned{
        MeshDefect::turned_faces,
        faces.size(),
        {},
        counted(faces.size(), "face") + (faces.size() == 1 ? " runs" : " run") + " the other way than the neighbours",
        faces_listed(examined.file, faces),
        "reverse " + std::string(faces.size() == 1 ? "it" : "them") + " (--repair)"};
    for (std::size_t k = 0; k < std::min(most_places, faces.size()); ++k) turned.first.push_back({{faces[k]}, {}});
    found.push_back(std::move(turned));
  } else if (!surface.turned.empty() && one_sided.empty()) {
    found.push_back(found_edges(examined, MeshDefect::turned_faces, surface.turned,
                                counted(surface.turned.size(), "edge") +
                                    (surface.turned.size() == 1 ? " has" : " have") +
                                    " more faces one way than the other",
                                "mend the edges in three faces or more first"));
  }
  const std::size_t inside_out = turning.inside_out.size(), filled = turning.filled_cavity.size();
  if (inside_out > 0) {
    const bool all = turning.outwards.size() == examined.mesh.faces.size();
    found.push_back(
        found_sheets(examined, MeshDefect::inside_out, turning.inside_out,
                     all ? "the mesh is inside out: its faces look inwards"
                         : counted(inside_out, "part") + (inside_out == 1 ? " is inside out" : " are inside out"),
                     all ? "reverse all faces (--repair)"
                         : fmt::format("reverse its {} (--repair)", counted(turning.outwards.size(), "face"))));
    if (all && inside_out == 1) found.back().where.clear();
  }
  if (filled > 0)
    found.push_back(found_sheets(
        examined, MeshDefect::filled_cavity, turning.filled_cavity,
        filled == 1 ? "a part inside another looks outwards: it encloses what is enclosed already"
                    : counted(filled, "part") + " inside another look outwards: they enclose what is enclosed already",
        "reverse its faces if it is a cavity, else delete it"));
  return found;
}

}  // namespace touchstone::audit::meshes
