// SPDX-License-Identifier: Apache-2.0
#include "report/mesh_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "audit/meshes/in_words.h"
#include "report/html_parts.h"
#include "report/space_model.h"

namespace touchstone::report {
namespace {

/// A figure of more corners is not drawn whole (space_model.h).
constexpr std::size_t most_corners = 2000;

void add(std::vector<double>& numbers, const Point3d& p) { numbers.insert(numbers.end(), {p.x, p.y, p.z}); }

/// The faces, as many as there is room for: those that defects name first, then those that share vertices with them, in
/// the order of the file.
std::vector<std::size_t> faces_drawn(const MeshFile& file, const Diagnosis& diagnosis) {
  std::vector<bool> near(file.vertices.size()), named(file.faces.size());
  for (const FoundDefect& found : diagnosis.found) {
    for (const PlaceInMesh& place : found.first) {
      for (const std::size_t v : place.vertices) near[v] = true;
      for (const std::size_t i : place.faces) {
        named[i] = true;
        for (const Index v : file.faces[i]) near[v] = true;
      }
    }
  }
  std::vector<std::size_t> order(file.faces.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto rank = [&](std::size_t i) {
    const auto& corners = file.faces[i];
    return named[i] ? 0 : std::any_of(corners.begin(), corners.end(), [&](Index v) { return near[v]; }) ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return rank(i) < rank(j); });
  std::vector<std::size_t> drawn;
  std::size_t corners = 0;
  for (const std::size_t i : order) {
    corners += 2 * file.faces[i].size() + 1;
    if (corners > most_corners) break;
    drawn.push_back(i);
  }
  return drawn;
}

SpaceFigure mesh_figure(const MeshFile& file, const std::vector<std::size_t>& faces) {
  SpaceFigure figure{SpaceFigure::Kind::mesh, "mesh", {}, {}};
  std::map<Index, std::uint32_t> place;
  for (const std::size_t i : faces) {
    std::vector<std::uint32_t>& corners = figure.faces.emplace_back();
    for (const Index v : file.faces[i]) {
      const auto [at, fresh] = place.emplace(v, static_cast<std::uint32_t>(place.size()));
      if (fresh) add(figure.numbers, file.vertices[v]);
      corners.push_back(at->second);
    }
  }
  return figure;
}

/// Edges and vertices where there are any, else the faces, each with the number that the file gives it.
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
  const std::vector<std::size_t> faces = faces_drawn(file, diagnosis);
  drawing.space.push_back(mesh_figure(file, faces));
  for (const FoundDefect& found : diagnosis.found) add_places(drawing, file, found);
  const std::vector<std::string> lines = description_of(file, diagnosis);
  std::string body = "<header><p class=\"kicker\">touchstone mesh</p><h1>" + escaped(file.name) +
                     "</h1><p class=\"lead\">" +
                     escaped(diagnosis.solid() ? "It bounds a solid." : "It bounds no solid.") + "</p></header><main>" +
                     space_figure(drawing, file.name);
  if (faces.size() < file.faces.size())
    body += fmt::format("<p>{} of {} are drawn, those of the places below first.</p>", grouped(faces.size()),
                        counted(file.faces.size(), "face"));
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
