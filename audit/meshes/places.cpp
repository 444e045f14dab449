// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/places.h"

namespace touchstone::audit {
namespace {

using Lines = std::vector<std::size_t>;

std::string number(const MeshFile& file, std::size_t place) { return std::to_string(place + file.first_number); }

std::string line(const Lines& lines, std::size_t place) {
  return lines.empty() ? "" : " (line " + std::to_string(lines[place]) + ")";
}

std::string lines_of_both(const Lines& lines, std::size_t one, std::size_t other) {
  if (lines.empty()) return "";
  return " (lines " + std::to_string(lines[one]) + " and " + std::to_string(lines[other]) + ")";
}

std::string both(const MeshFile& file, std::size_t one, std::size_t other) {
  return number(file, one) + " and " + number(file, other);
}

}  // namespace

std::string vertex_in_words(const MeshFile& file, std::size_t vertex) {
  return "vertex " + number(file, vertex) + line(file.vertex_lines, vertex);
}

std::string face_in_words(const MeshFile& file, std::size_t face) {
  return "face " + number(file, face) + line(file.face_lines, face);
}

std::string vertices_in_words(const MeshFile& file, std::size_t one, std::size_t other) {
  return "vertices " + both(file, one, other) + lines_of_both(file.vertex_lines, one, other);
}

std::string faces_in_words(const MeshFile& file, std::size_t one, std::size_t other) {
  return "faces " + both(file, one, other) + lines_of_both(file.face_lines, one, other);
}

std::string edge_in_words(const MeshFile& file, std::size_t from, std::size_t to) {
  return "edge from vertex " + number(file, from) + " to vertex " + number(file, to) +
         lines_of_both(file.vertex_lines, from, to);
}

std::string place_of_face(const MeshFile& file, std::size_t face) {
  return file.face_lines.empty() ? file.name : file.name + ":" + std::to_string(file.face_lines[face]);
}

}  // namespace touchstone::audit
