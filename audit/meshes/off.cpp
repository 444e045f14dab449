// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "audit/meshes/reading.h"

namespace touchstone::audit::meshes {
namespace {

/// The keyword may have letters in front for what else a vertex line holds behind its position.
bool supported(std::string_view keyword) {
  for (const char* known : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"}) {
    if (keyword == known) return true;
  }
  return false;
}

std::vector<Index> corners_of(const Text& text, std::size_t vertices) {
  const std::vector<std::string_view>& words = text.words();
  const long long count = text.whole(words[0]);
  if (count < 3) text.refuse("at least 3 corners");
  if (count > static_cast<long long>(words.size()) - 1) text.refuse("as many corners as it says");
  std::vector<Index> corners;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(count); ++k) {
    const long long i = text.whole(words[k]);
    if (i < 0 || i >= static_cast<long long>(vertices)) text.refuse("index of a vertex");
    corners.push_back(static_cast<Index>(i));
  }
  return corners;
}

}  // namespace

MeshFile read_off(const std::string& name, std::string_view bytes) {
  Text text(name, bytes);
  if (!text.next_words('#') || !supported(text.words()[0])) text.refuse("OFF in the first line");
  std::size_t skipped = 1;
  if (text.words().size() > 1 && text.words()[1] == "BINARY") text.refuse("OFF as text");
  if (text.words().size() == 1) {
    skipped = 0;
    if (!text.next_words('#')) text.refuse("counts of vertices and faces");
  }
  if (text.words().size() < skipped + 2) text.refuse("counts of vertices and faces");
  const std::array<long long, 2> counts{text.whole(text.words()[skipped]), text.whole(text.words()[skipped + 1])};
  if (counts[0] < 0 || counts[1] < 0) text.refuse("counts of vertices and faces");
  MeshFile mesh;
  mesh.name = name, mesh.format = "OFF";
  for (long long i = 0; i < counts[0]; ++i) {
    if (!text.next_words('#')) text.refuse("as many vertices as it says: the file ends too early");
    mesh.vertices.push_back(text.position(0)), mesh.vertex_lines.push_back(text.number());
  }
  for (long long i = 0; i < counts[1]; ++i) {
    if (!text.next_words('#')) text.refuse("as many faces as it says: the file ends too early");
    mesh.faces.push_back(corners_of(text, mesh.vertices.size())), mesh.face_lines.push_back(text.number());
  }
  if (text.next_words('#')) text.refuse("nothing behind the last face");
  return mesh;
}

}  // namespace touchstone::audit::meshes
