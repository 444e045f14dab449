// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "audit/uses.h"
#include "geometry/polyhedra.h"

/// Meshes from files of other programs.
namespace touchstone::audit {

/// Larger files are refused: 256 MiB are some millions of triangles.
inline constexpr std::size_t most_bytes_of_a_mesh = std::size_t{256} << 20;

/// A mesh file as read: positions, faces of any number of corners, and the position of each in the file.
struct MeshFile {
  std::string name;    ///< of the file, on one line
  std::string format;  ///< "OBJ", "STL (binary)", ...
  std::vector<Point3d> vertices;
  /// The corners of each face, at least 3, as indices of vertices from 0. Nothing is cut.
  std::vector<std::vector<Index>> faces;
  /// The lines, counted from 1, of each vertex and each face; empty if the file is binary.
  std::vector<std::size_t> vertex_lines, face_lines;
  /// The number that the format gives to the first vertex and the first face: 1 in OBJ, otherwise 0.
  std::size_t first_number = 0;
  /// False for STL, glTF and 3MF: vertices are then named by their positions.
  bool has_vertex_numbers = true;
  /// The names of parts in a text (o and g of OBJ), each with its first face.
  std::vector<std::pair<std::size_t, std::string>> parts;
  /// Notes for the user about the reading, one clause each: corners that were merged, bytes after the last triangle.
  std::vector<std::string> notes;
  /// Skipped parts that do not describe the surface, by keyword or element, and their counts.
  std::map<std::string, std::size_t> passed_over;
};

/// True if the ending is that of a format of meshes.
bool named_as_mesh(const std::string& path);

/// The mesh in a file: OBJ (Wavefront), PLY (ascii, binary of either byte order), OFF, STL (ascii or binary), glTF 2.0
/// (.glb, or .gltf with buffers in base64 or in files of the same folder) or 3MF.
///
/// The content determines the format; if it does not, the ending of the name does, in any case. A name that contradicts
/// the content is noted.
///
/// A number in text becomes the double nearest to it, whatever type the file declares. STL has only corners: those with
/// equal coordinates become one vertex, in order of appearance. Normals, colours, materials, groups and other elements
/// are skipped, as are lines and points; a line of OBJ that begins with another word is refused, including curved
/// surfaces. A mesh of glTF occurs once for each node of the scene that shows it, an object of 3MF for each item that
/// builds it, with its faces reversed if it is mirrored; a transform that would round a position is refused, as are
/// compressed positions. Units, skins and animations are skipped. A text may begin with the byte order mark of UTF-8.
/// There is at least one face, all vertices are finite and all indices valid; nothing else is promised about the mesh:
/// each operation validates its own meshes.
///
/// Throws InvalidInput, whose field is the file and the position in it ("cube.obj:12", for binary "cube.stl: byte 84"),
/// if the file cannot be read, is not a regular file (a device, a pipe), is too large, breaks a rule of its format or
/// ends too early. Counts in a file are not trusted: memory is proportional to the file's size or, if parts are placed
/// many times, limited to some millions of vertices.
MeshFile read_mesh_file(const std::string& path);

/// The same for the bytes of a file of that name.
MeshFile parse_mesh_file(const std::string& name, std::string_view bytes);

/// A summary of the reading, one item per line: the format, the numbers of vertices and faces by their corners, the
/// notes, and the skipped parts.
std::vector<std::string> reading_of(const MeshFile& mesh);

}  // namespace touchstone::audit
