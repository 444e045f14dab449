// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/places.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::audit {
namespace {

using Lines = std::vector<std::size_t>;

std::string number(const MeshFile& file, std::size_t place) { return std::to_string(place + file.first_number); }

std::string in_brackets(const std::string& words) { return words.empty() ? "" : " (" + words + ")"; }

/// " (line 5)"
std::string line(const Lines& lines, std::size_t place) {
  return in_brackets(lines.empty() ? "" : "line " + std::to_string(lines[place]));
}

std::string lines_of_both(const Lines& lines, std::size_t one, std::size_t other) {
  return lines.empty() ? "" : "lines " + std::to_string(lines[one]) + " and " + std::to_string(lines[other]);
}

std::string both(const MeshFile& file, std::size_t one, std::size_t other) {
  return number(file, one) + " and " + number(file, other);
}

/// The name of a face's part; empty if the file names no parts, or only one.
std::string part_of(const MeshFile& file, std::size_t face) {
  const auto& parts = file.parts;
  const auto other_name = [&](const auto& part) { return part.second != parts[0].second; };
  if (std::none_of(parts.begin(), parts.end(), other_name)) return "";
  const auto behind = std::upper_bound(parts.begin(), parts.end(), face,
                                       [](std::size_t i, const auto& part) { return i < part.first; });
  return behind == parts.begin() ? "" : (behind - 1)->second;
}

/// " (line 12, of wing)"; in a file without lines and numbers its position: " near (1, 0.33, 0.33)".
std::string where(const MeshFile& file, std::size_t face) {
  const std::string part = part_of(file, face);
  std::string words = file.face_lines.empty() ? "" : "line " + std::to_string(file.face_lines[face]);
  if (!part.empty()) words += (words.empty() ? "of " : ", of ") + part;
  if (file.has_vertex_numbers || !words.empty()) return in_brackets(words);
  Point3d middle{0, 0, 0};
  const auto& corners = file.faces[face];
  for (const Index v : corners) {
    const Point3d& p = file.vertices[v];
    const auto share = 1 / static_cast<double>(corners.size());
    middle = {middle.x + share * p.x, middle.y + share * p.y, middle.z + share * p.z};
  }
  return fmt::format(" near ({:.3g}, {:.3g}, {:.3g})", middle.x, middle.y, middle.z);
}

}  // namespace

// Nine digits distinguish all numbers of binary32.
std::string position_in_words(const Point3d& p) { return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z); }

std::string vertex_named(const MeshFile& file, std::size_t vertex) {
  return "vertex " + (file.has_vertex_numbers ? number(file, vertex) : position_in_words(file.vertices[vertex]));
}

std::string vertex_in_words(const MeshFile& file, std::size_t vertex) {
  return vertex_named(file, vertex) + line(file.vertex_lines, vertex);
}

std::string face_in_words(const MeshFile& file, std::size_t face) {
  return "face " + number(file, face) + where(file, face);
}

std::string vertices_in_words(const MeshFile& file, std::size_t one, std::size_t other) {
  const std::string lines = in_brackets(lines_of_both(file.vertex_lines, one, other));
  if (file.has_vertex_numbers) return "vertices " + both(file, one, other) + lines;
  return "vertices " + position_in_words(file.vertices[one]) + " and " + position_in_words(file.vertices[other]) +
         lines;
}

std::string faces_in_words(const MeshFile& file, std::size_t one, std::size_t other) {
  if (file.face_lines.empty())
    return "faces " + number(file, one) + where(file, one) + " and " + number(file, other) + where(file, other);
  std::string words = lines_of_both(file.face_lines, one, other);
  const std::string part = part_of(file, one), next = part_of(file, other);
  if (!part.empty() && !next.empty()) words += ", of " + part + (part == next ? "" : " and " + next);
  return "faces " + both(file, one, other) + in_brackets(words);
}

std::string edge_in_words(const MeshFile& file, std::size_t from, std::size_t to) {
  const std::string lines = in_brackets(lines_of_both(file.vertex_lines, from, to));
  if (file.has_vertex_numbers)
    return "edge from vertex " + number(file, from) + " to vertex " + number(file, to) + lines;
  return "edge " + position_in_words(file.vertices[from]) + " - " + position_in_words(file.vertices[to]) + lines;
}

std::string apart_in_words(double apart, double size) {
  return fmt::format("{:.2g} apart, {:.2g} of the size", apart, apart / size);
}

std::string place_of_face(const MeshFile& file, std::size_t face) {
  return file.face_lines.empty() ? file.name : file.name + ":" + std::to_string(file.face_lines[face]);
}

}  // namespace touchstone::audit
