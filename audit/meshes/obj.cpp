// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/reading.h"

namespace touchstone::audit::meshes {
namespace {

/// The corners of all faces, which may name vertices that come later in the file.
struct Faces {
  std::vector<long long> corners;  ///< from 0
  std::vector<std::size_t> first, line;
};

/// "i", "i/t", "i//n" or "i/t/n": i counts from 1, or backwards from -1, the last vertex so far.
long long corner(const Text& text, std::string_view word, std::size_t vertices) {
  const long long i = text.whole(word.substr(0, word.find('/')));
  const auto defined = static_cast<long long>(vertices);
  if (i == 0 || i < -defined) text.refuse("index of a vertex");
  return i > 0 ? i - 1 : defined + i;
}

}  // namespace

Meshd read_obj(const std::string& name, std::string_view bytes) {
  Text text(name, bytes);
  Meshd mesh;
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
      mesh.vertices.push_back({x, y, z});
    } else if (keyword == "f") {
      if (words.size() < 3) text.refuse("at least 3 corners");
      faces.first.push_back(faces.corners.size()), faces.line.push_back(line);
      for (const std::string_view word : words) faces.corners.push_back(corner(text, word, mesh.vertices.size()));
    }
  }
  faces.first.push_back(faces.corners.size());
  for (std::size_t i = 0; i < faces.line.size(); ++i) {
    std::vector<Index> corners;
    for (std::size_t k = faces.first[i]; k < faces.first[i + 1]; ++k) {
      if (faces.corners[k] >= static_cast<long long>(mesh.vertices.size()))
        text.refuse(faces.line[i], "index of a vertex");
      corners.push_back(static_cast<Index>(faces.corners[k]));
    }
    add_fan(mesh, corners);
  }
  return mesh;
}

}  // namespace touchstone::audit::meshes
