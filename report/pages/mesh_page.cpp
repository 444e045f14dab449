// SPDX-License-Identifier: Apache-2.0
#include "report/pages/mesh_page.h"

#include <fmt/format.h>

#include <optional>

#include "audit/meshes/in_words.h"
#include "report/figures/coarse_mesh.h"
#include "report/figures/space_model.h"
#include "report/parts/html_parts.h"

namespace touchstone::report {
namespace {

/// Some thousands of triangles, which a browser rotates without delay.
constexpr std::size_t most_corners_of_faces = 18000, most_corners = 100000;

void add(std::vector<double>& numbers, const Point3d& p) { numbers.insert(numbers.end(), {p.x, p.y, p.z}); }

SpaceFigure mesh_figure(const CoarseMesh& mesh) {
  SpaceFigure figure{SpaceFigure::Kind::mesh, "mesh", {}, {}};
  for (const Point3d& p : mesh.vertices) add(figure.numbers, p);
  figure.faces.assign(mesh.faces.begin(), mesh.faces.end());
  return figure;
}

/// Edges and vertices if there are any, otherwise the faces, each with its number in the file.
void add_places(Drawing& drawing, const MeshFile& file, const FoundDefect& found) {
  const auto number = [&file](std::size_t i) { return std::to_string(i + file.first_number); };
  for (const PlaceInMesh& place : found.first) {
    if (!place.vertices.empty()) {
      const bool edge = place.vertices.size() == 2;
      SpaceFigure figure{edge ? SpaceFigure::Kind::segment : SpaceFigure::Kind::point, "", {}, {}};
      figure.label = edge ? "edge " + number(place.vertices[0]) + "-" + number(place.vertices[1])
                          : "vertex " + number(place.vertices[0]);
      for (const std::size_t v : place.vertices) add(figure.numbers, file.vertices[v]);
      drawing.space.push_back(std::move(figure));
      continue;
    }
    for (const std::size_t i : place.faces) {
      SpaceFigure figure{SpaceFigure::Kind::polygon, "face " + number(i), {}, {}};
      for (const Index v : file.faces[i]) add(figure.numbers, file.vertices[v]);
      drawing.space.push_back(std::move(figure));
    }
  }
}

}  // namespace

std::string mesh_page(const MeshFile& file, const Diagnosis& diagnosis) {
  Drawing drawing;
  const CoarseMesh drawn = coarse_mesh(file, most_corners_of_faces);
  drawing.space.push_back(mesh_figure(drawn));
  for (const FoundDefect& found : diagnosis.found) add_places(drawing, file, found);
  const std::vector<std::string> lines = description_of(file, diagnosis);
  std::string body = "<header><p class=\"kicker\">touchstone mesh</p><h1>" + escaped(file.name) +
                     "</h1><p class=\"lead\">" +
                     escaped(diagnosis.solid() ? "It bounds a solid." : "It bounds no solid.") + "</p></header><main>" +
                     space_figure(drawing, file.name, std::nullopt, most_corners);
  if (drawn.cells > 0)
    body += fmt::format(
        "<p>The mesh is drawn coarser than it is, with {} of {}: vertices in one cell of its box, which has {} along "
        "each axis, are drawn as one. The places below are drawn as they are.</p>",
        grouped(drawn.faces.size()), counted(file.faces.size(), "face"), drawn.cells);
  body += "<h2>What it is</h2><ul>";
  for (const std::string& line : lines) body += "<li>" + escaped(line) + "</li>";
  body += "</ul>";
  if (!diagnosis.solid()) body += "<h2>What is wrong, the worst first</h2><ol>";
  for (const FoundDefect& found : diagnosis.found)
    body += "<li><strong>" + escaped(found.what) + "</strong>" +
            (found.where.empty() ? "" : "<br>" + escaped(found.where)) + "<br>To mend: " + escaped(found.mend) +
            "</li>";
  if (!diagnosis.solid()) body += "</ol>";
  return page(file.name, body + "</main>");
}

}  // namespace touchstone::report
