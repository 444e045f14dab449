// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "audit/meshes/formats/reading.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/nearest_double.h"

namespace touchstone::audit::meshes {
namespace {

/// Keywords of lines that do not describe the surface: texture coordinates, normals, groups, names, lines and points,
/// materials, weights of bones (vw, tinyobj), creases of subdivision (t, OpenSubdiv), and display settings. Curved
/// surfaces are not among them: a mesh without them would be a different one.
bool passed_over(std::string_view keyword) {
  constexpr std::array<std::string_view, 21> all{
      "vt",     "vn",     "vp",     "vw",     "g",     "s",        "mg",       "o",   "l",          "p",        "t",
      "usemtl", "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj"};
  return std::find(all.begin(), all.end(), keyword) != all.end();
}

/// The corners of all faces, which may name vertices that come later in the file.
struct Faces {
  std::vector<long long> corners;  ///< from 0
  std::vector<std::size_t> first;
};

/// "i", "i/t", "i//n" or "i/t/n": i counts from 1, or backwards from -1, the last vertex so far.
long long corner(const Text& text, std::string_view word, std::size_t vertices) {
  const long long i = text.whole(word.substr(0, word.find('/')));
  const auto defined = static_cast<long long>(vertices);
  if (i == 0) text.refuse("index of a vertex: got 0, and OBJ counts from 1");
  if (i < -defined) text.refuse(index_of_a_vertex(i, vertices, 1) + ", or backwards from -1");
  return i > 0 ? i - 1 : defined + i;
}

}  // namespace

/// True if the first line that is not skipped holds three numbers or three corners.
bool is_obj(std::string_view bytes) {
  Text text("", bytes);
  while (text.next_words('#')) {
    const auto& words = text.words();
    if (passed_over(words[0])) continue;
    return words.size() > 3 && (words[0] == "v" ? nearest_double(words[1]).has_value() : words[0] == "f");
  }
  return false;
}

MeshFile read_obj(const std::string& name, std::string_view bytes) {
  Text text(name, bytes);
  MeshFile mesh;
  mesh.name = name, mesh.format = "OBJ", mesh.first_number = 1;
  Faces faces;
  while (text.next_words('#')) {
    const std::size_t line = text.number();
    const std::string_view keyword = text.words()[0];
    std::vector<std::string_view> words(text.words().begin() + 1, text.words().end());
    const auto continued = [](const std::vector<std::string_view>& all) {
      return !all.empty() && all.back().ends_with('\\');
    };
    while (continued(words)) {
      words.back().remove_suffix(1);
      if (words.back().empty()) words.pop_back();
      if (!text.next_words('#')) text.refuse("a line behind the backslash");
      words.insert(words.end(), text.words().begin(), text.words().end());
    }
    if (keyword == "v") {
      if (words.size() < 3) text.refuse("three coordinates");
      const double x = text.number(words[0]), y = text.number(words[1]), z = text.number(words[2]);
      mesh.vertices.push_back({x, y, z}), mesh.vertex_lines.push_back(line);
    } else if (keyword == "f") {
      if (words.size() < 3) text.refuse("at least 3 corners");
      faces.first.push_back(faces.corners.size()), mesh.face_lines.push_back(line);
      for (const std::string_view word : words) faces.corners.push_back(corner(text, word, mesh.vertices.size()));
    } else if (passed_over(keyword)) {
      ++mesh.passed_over[std::string(keyword)];
      if ((keyword == "o" || keyword == "g") && !words.empty())
        mesh.parts.emplace_back(mesh.face_lines.size(), catalogue::excerpt(words[0], 40));
    } else {
      text.refuse(line, "v, f or another keyword of polygons in OBJ, got " + catalogue::excerpt(keyword, 20));
    }
  }
  faces.first.push_back(faces.corners.size());
  for (std::size_t i = 0; i < mesh.face_lines.size(); ++i) {
    std::vector<Index> corners;
    for (std::size_t k = faces.first[i]; k < faces.first[i + 1]; ++k) {
      if (faces.corners[k] >= static_cast<long long>(mesh.vertices.size()))
        text.refuse(mesh.face_lines[i], index_of_a_vertex(faces.corners[k] + 1, mesh.vertices.size(), 1));
      corners.push_back(static_cast<Index>(faces.corners[k]));
    }
    mesh.faces.push_back(std::move(corners));
  }
  const std::size_t lines = mesh.passed_over.contains("l") ? mesh.passed_over["l"] : 0;
  return with_faces(std::move(mesh), lines);
}

}  // namespace touchstone::audit::meshes
