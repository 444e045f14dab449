// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/solid_draws.h"

#include <cstdint>
#include <utility>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/named_meshes.h"
#include "catalogue/families/numbers.h"

namespace touchstone::catalogue {
namespace {

const std::vector<Face> faces_with_dent{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};

Point3d drawn_point(DrawStream& draws, int most) {
  return {12 * small_integer(draws, most), 12 * small_integer(draws, most), 12 * small_integer(draws, most)};
}

std::vector<LatticePoint> block(std::int64_t x, std::int64_t y, std::int64_t z) {
  std::vector<LatticePoint> cells;
  for (std::int64_t i = 0; i < x * y * z; ++i) cells.push_back({i % x, i / x % y, i / (x * y)});
  return cells;
}

/// The cells of a block but for the one in the middle.
std::vector<LatticePoint> around_the_middle(std::int64_t height) {
  std::vector<LatticePoint> cells = block(3, 3, height);
  cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2));
  return cells;
}

std::vector<LatticePoint> drawn_cells(DrawStream& draws) {
  std::vector<LatticePoint> cells{{0, 0, 0}};
  for (const LatticePoint& cell : block(3, 2, 2)) {
    if (draws.coin()) cells.push_back(cell);
  }
  return cells;
}

/// Multiples of 12 stay such.
Meshd shell_in_shell(DrawStream& draws) {
  Meshd outer = lattice_polyhedron(draws), inner = outer;
  const double factor = 2 + up_to(draws, 2);
  const Point3d at = drawn_point(draws, 2);
  for (Point3d& p : outer.vertices) p = {factor * p.x, factor * p.y, factor * p.z};
  for (Point3d& p : inner.vertices) p = {p.x + at.x, p.y + at.y, p.z + at.z};
  return together(outer, inner);
}

Meshd drawn_solid(DrawStream& draws) {
  switch (draws.below(6)) {
    case 0: return dented_tetrahedron(24, {6, 6, 6});
    case 1: return cube_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    case 2: return cube_surface(around_the_middle(1));
    case 3: return cube_surface(drawn_cells(draws));
    case 4: return shell_in_shell(draws);
    default:
      return draws.one_in(4) ? cube_surface(around_the_middle(3)) : dented_tetrahedron(48, drawn_point(draws, 3));
  }
}

}  // namespace

Meshd dented_tetrahedron(double size, const Point3d& dent) {
  return {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, dent}, faces_with_dent};
}

Meshd lattice_solid(DrawStream& draws) {
  Meshd mesh = drawn_solid(draws);
  if (draws.below(4) != 3) return mesh;
  for (Face& face : mesh.faces) {
    if (draws.below(3) == 1) std::swap(face.b, face.c);
  }
  return mesh;
}

Meshd tetrahedra_together(DrawStream& draws) {
  Meshd mesh;
  const auto count = static_cast<Index>(4 + draws.below(4));
  for (Index i = 0; i < count; ++i) mesh.vertices.push_back(drawn_point(draws, 2));
  for (std::uint64_t left = 1 + draws.below(4); left > 0; --left) {
    std::vector<Index> rest;
    for (Index i = 0; i < count; ++i) rest.push_back(i);
    for (std::size_t k = 0; k < 4; ++k) std::swap(rest[k], rest[k + draws.below(count - k)]);
    const auto [a, b, c, d] = std::array{rest[0], rest[1], rest[2], rest[3]};
    for (const Face& face : {Face{a, b, c}, Face{b, a, d}, Face{c, b, d}, Face{a, c, d}}) mesh.faces.push_back(face);
  }
  return mesh;
}

Meshd sheets_at_a_vertex(DrawStream& draws) {
  Meshd mesh = dented_tetrahedron(24, {6, 6, 6});
  for (std::uint64_t left = 1 + draws.below(3); left > 0; --left) {
    const auto count = static_cast<Index>(mesh.vertices.size());
    std::array<Index, 4> at{static_cast<Index>(draws.below(count)), count, count + 1, count + 2};
    if (draws.one_in(3)) at[1] = (at[0] + 1) % count;
    for (int i = 0; i < 3; ++i) mesh.vertices.push_back(drawn_point(draws, 4));
    const auto [a, b, c, d] = at;
    for (const Face& face : {Face{a, c, b}, Face{a, b, d}, Face{a, d, c}, Face{b, c, d}}) mesh.faces.push_back(face);
  }
  return mesh;
}

const Meshd& named_solid(DrawStream& draws) {
  const auto& all = named_solids();
  return all[draws.below(all.size())].mesh;
}

const Meshd& long_solid(DrawStream& draws) {
  const auto& all = long_solids();
  return all[draws.below(all.size())].mesh;
}

Meshd with_needless_faces(Meshd mesh, DrawStream& draws) {
  const std::size_t which = draws.below(mesh.faces.size());
  const Face face = mesh.faces[which];
  const auto added = static_cast<Index>(mesh.vertices.size());
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b];
  switch (draws.below(4)) {
    case 0: mesh.faces.insert(mesh.faces.end(), {face, face}); return mesh;
    case 1: {  // over a segment that goes beyond the face, or a point
      const double t = small_integer(draws, 2);
      const Point3d beyond = a + t * (b - a);
      mesh.vertices.push_back(beyond);
      mesh.faces.insert(mesh.faces.end(), {{face.a, face.b, added}, {face.a, face.b, added}});
      return mesh;
    }
    case 2: {  // anywhere
      const Point3d anywhere = drawn_point(draws, 4);
      mesh.vertices.push_back(anywhere);
      mesh.faces.insert(mesh.faces.end(), {{face.a, face.b, added}, {added, face.b, face.a}});
      return mesh;
    }
    default: {
      const Point3d middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
      mesh.vertices.push_back(middle);
      mesh.faces[which] = {face.a, added, face.c};
      mesh.faces.insert(mesh.faces.end(), {{added, face.b, face.c}, {face.a, face.b, added}});
      return mesh;
    }
  }
}

Meshd with_face_listed_twice(Meshd mesh, DrawStream& draws) {
  Face face = mesh.faces[draws.below(mesh.faces.size())];
  if (const std::uint64_t kind = draws.below(3); kind > 0) {
    const auto added = static_cast<Index>(mesh.vertices.size());
    face = {added, added + 1, added + 2};
    const Point3d p = drawn_point(draws, 3), q = drawn_point(draws, 3);
    const double t = small_integer(draws, 2);
    mesh.vertices.insert(mesh.vertices.end(), {p, q, kind == 1 ? drawn_point(draws, 3) : p + t * (q - p)});
  }
  Face again = face;
  for (std::uint64_t left = draws.below(3); left > 0; --left) again = {again.b, again.c, again.a};
  if (draws.coin()) std::swap(again.b, again.c);
  mesh.faces.insert(mesh.faces.end(), {face, again});
  return mesh;
}

Meshd opened(Meshd mesh, DrawStream& draws) {
  const std::size_t which = draws.below(mesh.faces.size());
  const Face face = mesh.faces[which];
  switch (draws.below(6)) {
    case 0: mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(which)); break;
    case 1: mesh.faces.push_back(face); break;
    case 2: mesh.faces[which].b = face.a; break;
    case 3: mesh.faces = {face, face}; break;
    case 4: break;
    default:  // closed in space, but not by its vertices: one of them is two
      mesh.vertices.push_back(mesh.vertices[face.a]);
      mesh.faces[which].a = static_cast<Index>(mesh.vertices.size() - 1);
  }
  return mesh;
}

Meshd ordinary_solid(DrawStream& draws) {
  Meshd mesh;
  while (mesh.vertices.size() < 5) mesh.vertices.push_back({ordinary(draws), ordinary(draws), ordinary(draws)});
  make_solid(mesh);
  return mesh;
}

void make_solid(Meshd& mesh) {
  if (mesh.vertices.size() < 5) return make_tetrahedron(mesh);
  mesh.vertices.resize(5);
  mesh.faces = faces_with_dent, mesh.polygons.clear();
}

}  // namespace touchstone::catalogue
