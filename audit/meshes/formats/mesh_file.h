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

/// Meshes from files that other programs wrote.
namespace touchstone::audit {

/// Larger files are refused: 256 MiB are some millions of triangles.
inline constexpr std::size_t most_bytes_of_a_mesh = std::size_t{256} << 20;

/// A mesh file as it is read: positions, faces of any number of corners, and where in the file each stands.
struct MeshFile {
  std::string name;    ///< of the file, on one line
  std::string format;  ///< "OBJ", "STL (binary)", ...
  std::vector<Point3d> vertices;
  /// The corners of each face, at least 3, as indices of vertices from 0. Nothing is cut.
  std::vector<std::vector<Index>> faces;
  /// The lines, counted from 1, on which each vertex and each face stands; empty where the file is binary.
  std::vector<std::size_t> vertex_lines, face_lines;
  /// The number that the format gives to the first vertex and the first face: 1 in OBJ, 0 elsewhere.
  std::size_t first_number = 0;
  /// False of STL, glTF and 3MF: vertices are then told by their positions.
  bool has_vertex_numbers = true;
  /// What a text calls its parts (o and g of OBJ), each with the first face that is in it.
  std::vector<std::pair<std::size_t, std::string>> parts;
  /// What a user should know of the reading, one clause each: corners that were merged, bytes behind the last triangle.
  std::vector<std::string> notes;
  /// What says nothing of the surface, by keyword or element, and how often it was there.
  std::map<std::string, std::size_t> passed_over;
};

/// The mesh in a file: OBJ (Wavefront), PLY (ascii, binary of either byte order), OFF, STL (ascii or binary), glTF 2.0
/// (.glb, or .gltf with buffers in base64 or in files of the same folder) or 3MF.
///
/// The content tells the format; where it does not, the ending of the name does, in capitals or not. A name that says
/// something else than the content is noted.
///
/// A number in text becomes the double nearest to it, whatever type the file declares. STL has no vertices but only
/// corners: those with equal coordinates become one vertex, in order of appearance. Normals, colours, materials, groups
/// and other elements are passed over, lines and points too; a line of OBJ that begins with another word is refused,
/// curved surfaces with it. A mesh of glTF is there once for each node of the scene that shows it, an object of 3MF for
/// each item that builds it, its faces reversed where it is mirrored; a transform by which a position would be rounded
/// is refused, as are compressed positions. Units, skins and animations are passed over. A text may
/// begin with the byte order mark of UTF-8. There is at least one face, all vertices are finite and all indices those
/// of vertices; nothing else is promised of the mesh: which meshes an operation takes is its own affair.
///
/// Throws InvalidInput, the field being the file and where in it ("cube.obj:12", for binary "cube.stl: byte 84"), where
/// the file cannot be read, is no regular file (a device, a pipe), is too large, breaks a rule of its format or ends
/// too early. No count in a file is taken on trust: memory is in proportion to the file's size or, where parts are
/// placed many times, to some millions of vertices.
MeshFile read_mesh_file(const std::string& path);

/// The same of the bytes of a file of that name.
MeshFile parse_mesh_file(const std::string& name, std::string_view bytes);

/// What was read, a line each: the format, how many vertices and faces of how many corners, the notes, and what was
/// passed over.
std::vector<std::string> reading_of(const MeshFile& mesh);

}  // namespace touchstone::audit
