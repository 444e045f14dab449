// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "audit/meshes/formats/reading.h"

namespace touchstone::audit::meshes {
namespace {

/// The length of the keyword at the start of a word: letters before it tell what a vertex line holds after its
/// position. If text follows directly it is the first count, as in all of ModelNet.
std::size_t keyword_length(std::string_view word) {
  for (const std::string_view known : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"}) {
    if (word.starts_with(known) && word.find_first_not_of("0123456789", known.size()) == word.npos) return known.size();
  }
  return 0;
}

std::vector<Index> corners_of(const Text& text, std::size_t vertices) {
  const std::vector<std::string_view>& words = text.words();
  const long long count = text.whole(words[0]);
  if (count < 1) text.refuse("at least 3 corners");
  if (count > static_cast<long long>(words.size()) - 1)
    text.refuse("the line ends before the declared number of corners");
  std::vector<Index> corners;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(count); ++k) {
    const long long i = text.whole(words[k]);
    if (i < 0 || i >= static_cast<long long>(vertices)) text.refuse(index_of_a_vertex(i, vertices));
    corners.push_back(static_cast<Index>(i));
  }
  return corners;
}

}  // namespace

bool is_off(std::string_view bytes) {
  Text text("", bytes);
  return text.next_words('#') && keyword_length(text.words()[0]) > 0;
}

MeshFile read_off(const std::string& name, std::string_view bytes) {
  Text text(name, bytes);
  const std::size_t keyword = text.next_words('#') ? keyword_length(text.words()[0]) : 0;
  if (keyword == 0) text.refuse("OFF in the first line");
  std::vector<std::string_view> header = text.words();
  header[0].remove_prefix(keyword);
  if (header[0].empty()) header.erase(header.begin());
  if (!header.empty() && header[0] == "BINARY") text.refuse("OFF as text");
  if (header.empty() && text.next_words('#')) header = text.words();
  if (header.size() < 2) text.refuse("counts of vertices and faces");
  const std::array<long long, 2> counts{text.whole(header[0]), text.whole(header[1])};
  if (counts[0] < 0 || counts[1] < 0) text.refuse("counts of vertices and faces");
  MeshFile mesh;
  mesh.name = name, mesh.format = "OFF";
  for (long long i = 0; i < counts[0]; ++i) {
    if (!text.next_words('#')) text.refuse("the file ends before the declared number of vertices");
    mesh.vertices.push_back(text.position(0)), mesh.vertex_lines.push_back(text.number());
  }
  std::size_t lines = 0, first_line = 0;  // rows of two corners or of one
  for (long long i = 0; i < counts[1]; ++i) {
    if (!text.next_words('#')) text.refuse("the file ends before the declared number of faces");
    std::vector<Index> corners = corners_of(text, mesh.vertices.size());
    if (corners.size() < 3) {
      if (lines++ == 0) first_line = text.number();
      continue;
    }
    mesh.faces.push_back(std::move(corners)), mesh.face_lines.push_back(text.number());
  }
  if (text.next_words('#')) text.refuse("nothing behind the last face");
  if (lines > 0 && !mesh.faces.empty()) text.refuse(first_line, "at least 3 corners");
  return with_faces(std::move(mesh), lines);
}

}  // namespace touchstone::audit::meshes
