// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"

/// Shared by the readers of mesh files.
namespace touchstone::audit::meshes {

/// The bytes after the byte order mark with which some programs begin a text in UTF-8.
std::string_view without_mark(std::string_view bytes);

/// The text of a file, line by line; a line ends with LF, CR LF or CR.
class Text {
 public:
  Text(std::string name, std::string_view bytes) : name_(std::move(name)), rest_(without_mark(bytes)) {}

  /// Moves to the next line, whose words are those before `comment`; returns false after the last.
  bool next(char comment = '\0');
  /// Moves to the next line that holds a word.
  bool next_words(char comment);
  /// The next word of this line or, after its end, of the following ones; refuses the end of the file.
  std::string_view word();
  /// The number of words left on this line.
  std::size_t words_left() const { return words_.size() - used_; }

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view line() const { return line_; }
  std::string_view rest() const { return rest_; }

  [[noreturn]] void refuse(const std::string& rule) const { refuse(number_ == 0 ? 1 : number_, rule); }
  [[noreturn]] void refuse(std::size_t line, const std::string& rule) const;
  std::size_t number() const { return number_; }
  const std::string& name() const { return name_; }

  /// The nearest double, and an integer.
  double number(std::string_view word) const;
  long long whole(std::string_view word) const;
  /// The vertex given by the three words after `skipped` ones.
  Point3d position(std::size_t skipped) const;

 private:
  void split(char comment);

  std::string name_;
  std::string_view rest_, line_;
  std::vector<std::string_view> words_;
  std::size_t number_ = 0, used_ = 0;
};

/// The content of a file in the same folder, by its name; refuses files that cannot be read.
using ReadSibling = std::function<std::string(const std::string& name)>;

/// ASCII letters in lower case.
std::string lower(std::string_view word);

/// "1 vertex", "1,234 vertices"
std::string vertices(std::size_t count);

/// The rule of an index that names no vertex: "index of a vertex: got 5 of 4 vertices, counted from 0".
std::string index_of_a_vertex(long long got, std::size_t count, std::size_t first_number = 0);

/// Appends the triangles of a strip, whose orientations alternate, so that all face the same side. A strip repeats a
/// vertex where it turns or jumps: degenerate triangles are left out. Returns their number.
std::size_t append_strip(const std::vector<Index>& strip, std::vector<std::vector<Index>>& faces);

/// The note on strips that became faces, with the number of those left out.
std::string strips_as_faces(std::size_t left_out);

/// The mesh, if it has faces; otherwise refuses it, and says what the file holds instead.
MeshFile with_faces(MeshFile mesh, std::size_t lines = 0);

/// True if the content is of that format, and certainly not of those that meshes.cpp tries later.
bool is_3mf(std::string_view bytes);
bool is_gltf(std::string_view bytes);
bool is_obj(std::string_view bytes);
bool is_off(std::string_view bytes);
bool is_ply(std::string_view bytes);
bool is_stl(std::string_view bytes);

MeshFile read_3mf(const std::string& name, std::string_view bytes);
MeshFile read_gltf(const std::string& name, std::string_view bytes, const ReadSibling& read_sibling);
MeshFile read_obj(const std::string& name, std::string_view bytes);
MeshFile read_off(const std::string& name, std::string_view bytes);
MeshFile read_ply(const std::string& name, std::string_view bytes);
MeshFile read_stl(const std::string& name, std::string_view bytes);

}  // namespace touchstone::audit::meshes
