// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/reading.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "audit/counted.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/nearest_double.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes {
namespace {

std::string got(std::string_view word) { return '"' + catalogue::excerpt(word, 20) + '"'; }

}  // namespace

std::string_view without_mark(std::string_view bytes) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
  return bytes;
}

void Text::refuse(std::size_t line, const std::string& rule) const {
  throw InvalidInput(name_ + ":" + std::to_string(line), rule);
}

bool Text::next(char comment) {
  words_.clear(), used_ = 0;
  if (rest_.empty()) return false;
  ++number_;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end);
  if (rest_.starts_with("\r\n")) rest_.remove_prefix(2);
  else if (!rest_.empty()) rest_.remove_prefix(1);
  split(comment);
  return true;
}

bool Text::next_words(char comment) {
  while (next(comment)) {
    if (!words_.empty()) return true;
  }
  return false;
}

void Text::split(char comment) {
  std::string_view left = comment == '\0' ? line_ : line_.substr(0, std::min(line_.find(comment), line_.size()));
  const char* const blank = " \t\v\f";
  for (;;) {
    const std::size_t start = left.find_first_not_of(blank);
    if (start == std::string_view::npos) return;
    const std::size_t length = std::min(left.find_first_of(blank, start), left.size()) - start;
    words_.push_back(left.substr(start, length));
    left.remove_prefix(start + length);
  }
}

std::string_view Text::word() {
  if (words_left() == 0 && !next_words('\0')) refuse("the file ends before the declared number of values");
  return words_[used_++];
}

double Text::number(std::string_view word) const {
  const auto value = nearest_double(word);
  if (!value) {
    std::string spelled;
    for (const char c : word.substr(word.starts_with('-') || word.starts_with('+'), 3))
      spelled += static_cast<char>(c | 0x20);
    if (spelled == "nan" || spelled == "inf") refuse("finite number");
    refuse("number: got " + got(word));
  }
  if (std::isinf(*value)) refuse("finite number");
  return *value;
}

long long Text::whole(std::string_view word) const {
  const std::string_view written = word;
  if (word.starts_with('+')) word.remove_prefix(1);
  long long value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) refuse("an integer of less than 64 bits");
  if (error != std::errc() || stop != word.data() + word.size()) refuse("an integer, got " + got(written));
  return value;
}

Point3d Text::position(std::size_t skipped) const {
  if (words_.size() < skipped + 3) refuse("three coordinates");
  const double x = number(words_[skipped]), y = number(words_[skipped + 1]), z = number(words_[skipped + 2]);
  return {x, y, z};
}

std::string lower(std::string_view word) {
  std::string made(word);
  for (char& c : made) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return made;
}

std::string vertices(std::size_t count) { return grouped(count) + (count == 1 ? " vertex" : " vertices"); }

std::string index_of_a_vertex(long long got, std::size_t count, std::size_t first_number) {
  return "index of a vertex: got " + std::to_string(got) + " of " + vertices(count) + ", counted from " +
         std::to_string(first_number);
}

std::size_t append_strip(const std::vector<Index>& strip, std::vector<std::vector<Index>>& faces) {
  std::size_t left_out = 0;
  for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
    const Index a = strip[k + k % 2], b = strip[k + 1 - k % 2], c = strip[k + 2];
    if (a == b || b == c || c == a) ++left_out;
    else faces.push_back({a, b, c});
  }
  return left_out;
}

std::string strips_as_faces(std::size_t left_out) {
  return "strips of triangles are read as faces" +
         (left_out == 0 ? "" : ", without " + counted(left_out, "triangle") + " with a vertex named twice");
}

MeshFile with_faces(MeshFile mesh, std::size_t lines) {
  if (!mesh.faces.empty()) return mesh;
  std::string held = "nothing";
  if (lines > 0) held = vertices(mesh.vertices.size()) + " and " + counted(lines, "line");
  else if (!mesh.vertices.empty()) held = counted(mesh.vertices.size(), "point");
  throw InvalidInput(mesh.name, "at least one face: the file holds " + held);
}

}  // namespace touchstone::audit::meshes
