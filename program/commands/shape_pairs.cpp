// SPDX-License-Identifier: Apache-2.0
#include "program/commands/shape_pairs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::program {
namespace {

using Names = std::vector<std::string>;

const std::array<std::pair<const char*, Names>, 2> tables{{
    {"In space",
     {"Point3", "Segment3", "Ray3", "Plane", "Triangle3", "Sphere3", "Aabb3", "Obb3", "Capsule3", "Kdop3", "Mesh"}},
    {"In the plane", {"Point2", "Segment2", "Ray2", "Line2", "Circle2", "Aabb2", "Polygon2"}},
}};

/// "Segment3<double>" is a segment.
std::string name_in(const std::string& type) { return type.substr(0, type.find('<')); }

std::string label_of(std::string name) {
  if (std::isdigit(static_cast<unsigned char>(name.back()))) name.pop_back();
  for (char& letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return name;
}

/// The arguments of a question that are among those shapes.
Names shapes_in(const Shape& question, const Names& among) {
  Names found;
  for (const Shape::Part& part : question.parts) {
    const std::string name = name_in(type_text(*part.shape));
    if (std::find(among.begin(), among.end(), name) != among.end()) found.push_back(name);
  }
  return found;
}

/// The kind of question that an operation answers about two shapes, by the type of its answer.
std::string question_about(const Operation& operation) {
  const Shape& answer = operation.answer_shape();
  const std::string type = name_in(type_text(answer.kind == Shape::Kind::choice ? *answer.parts[0].shape : answer));
  if (type == "FirstContact" || type == "FirstFaceContact") return "sweep";
  if (type == "Penetration") return "depth";
  const bool nearest =
      type.starts_with("Closest") || type.ends_with("Distance") || type == "Point2" || type == "Point3";
  return nearest ? "distance" : "contact";
}

/// Each cell of a table: links to the operations.
std::map<std::pair<std::string, std::string>, std::string> cells_of(const Names& shapes) {
  std::map<std::pair<std::string, std::string>, std::string> cells;
  for (const Operation* operation : all_operations()) {
    const Metadata& metadata = operation->metadata();
    if (metadata.is_implementation() || std::string(metadata.chapter) == "response") continue;
    const Shape& question = operation->question_shape();
    const bool several = question.kind == Shape::Kind::choice;
    for (std::size_t i = 0; i < (several ? question.parts.size() : 1); ++i) {
      const Names found = shapes_in(several ? *question.parts[i].shape : question, shapes);
      if (found.size() != 2) continue;
      const std::string link = "[" + question_about(*operation) + "](#" + operation->name() + ")";
      for (const auto& cell : {std::pair(found[0], found[1]), std::pair(found[1], found[0])}) {
        std::string& text = cells[cell];
        if (text.find(link) == std::string::npos) text += (text.empty() ? "" : ", ") + link;
      }
    }
  }
  return cells;
}

}  // namespace

void print_shape_pairs(std::ostream& out) {
  out << R"(
## Shape against shape

A cell links to the operations on two shapes: *contact* is whether or where they meet; *distance*, which of their points
are nearest; *depth*, how deep they overlap; *sweep*, when they first meet while they move. An empty cell is a pair that
no operation takes.
)";
  for (const auto& [title, shapes] : tables) {
    out << "\n| " << title << " |";
    for (const std::string& shape : shapes) out << ' ' << label_of(shape) << " |";
    out << "\n|---|";
    for (std::size_t i = 0; i < shapes.size(); ++i) out << "---|";
    const auto cells = cells_of(shapes);
    for (const std::string& row : shapes) {
      out << "\n| **" << label_of(row) << "** |";
      for (const std::string& column : shapes) {
        const auto cell = cells.find({row, column});
        out << (cell == cells.end() ? " " : " " + cell->second + " ") << '|';
      }
    }
    out << '\n';
  }
}

}  // namespace touchstone::program
