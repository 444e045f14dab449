// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/contact_mesh_draws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/numbers.h"
#include "catalogue/families/reported_triangles.h"
#include "catalogue/families/triangle_draws.h"

namespace touchstone::catalogue {
namespace {

constexpr std::array<Face, 4> tetrahedron{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

Meshd cube_in_hollow(DrawStream& draws) {
  std::vector<LatticePoint> cells;
  for (std::int64_t i = 0; i < 27; ++i)
    if (i != 13) cells.push_back({i % 3, i / 3 % 3, i / 9});
  Meshd mesh = cube_surface(cells), inner = cube_surface({{0, 0, 0}});
  const double at = 12 + 3 * up_to(draws, 3), size = draws.coin() ? 1 : 0.25;
  for (Point3d& p : inner.vertices) p = {at + size * p.x, at + size * p.y, at + size * p.z};
  if (draws.coin()) std::swap(mesh, inner);
  return together(mesh, inner);
}

}  // namespace

Meshd small_lattice_faces(DrawStream& draws) {
  Meshd mesh;
  const auto count = static_cast<Index>(5 + draws.below(4));
  for (Index i = 0; i < count; ++i) mesh.vertices.push_back(small_lattice_point(draws));
  for (std::uint64_t left = 4 + draws.below(4); left > 0; --left) {
    const auto a = static_cast<Index>(draws.below(count));
    const Index b = (a + 1 + static_cast<Index>(draws.below(count - 1))) % count;
    Index c = (b + 1 + static_cast<Index>(draws.below(count - 1))) % count;
    while (c == a || c == b) c = (c + 1) % count;
    mesh.faces.push_back({a, b, c});
  }
  return mesh;
}

Meshd flat_part(DrawStream& draws) {
  const LatticePlane plane = LatticePlane::of(draws, 6);
  const Index size = 2 + static_cast<Index>(draws.below(2));
  Meshd mesh;
  for (Index i = 0; i <= size; ++i)
    for (Index j = 0; i + j <= size; ++j) mesh.vertices.push_back(plane.at(i, j));
  const auto place = [size](Index i, Index j) { return i * (size + 1) - i * (i - 1) / 2 + j; };
  for (Index i = 0; i < size; ++i) {
    for (Index j = 0; i + j < size; ++j) {
      mesh.faces.push_back({place(i, j), place(i + 1, j), place(i, j + 1)});
      if (i + j + 2 <= size) mesh.faces.push_back({place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)});
    }
  }
  if (draws.below(3) == 0) return mesh;
  Point3d& moved = mesh.vertices[draws.below(mesh.vertices.size())];
  if (draws.coin()) {
    const Vector3d normal = lattice_normal(draws, 6);
    moved = along(moved, small_integer(draws, 2), normal);
  } else {
    moved = plane.point(draws);
  }
  return mesh;
}

Meshd folded_flap(DrawStream& draws) {
  const LatticePlane plane = LatticePlane::of(draws, 6);
  Meshd mesh{{plane.at(0, 0), plane.at(4, 0), plane.at(0, 4)}, {}};
  mesh.vertices.push_back(along(plane.at(1, 1), 4, lattice_normal(draws, 6)));
  mesh.faces.assign(tetrahedron.begin(), tetrahedron.end());
  const double i = small_integer(draws, 4), j = small_integer(draws, 4);
  const Point3d tip = draws.one_in(3) ? along(plane.at(i, j), 1, lattice_normal(draws, 6)) : plane.at(i, j);
  mesh.vertices.push_back(tip);
  mesh.faces.push_back(draws.coin() ? Face{1, 0, 4} : Face{0, 1, 4});
  return mesh;
}

Meshd touching_solids(DrawStream& draws) {
  Meshd mesh{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}, {tetrahedron.begin(), tetrahedron.end()}};
  const Point3d at = draws.one_in(4) ? between_vertices(mesh, draws) : on_a_face_plane(mesh, draws);
  Meshd other{{at}, {tetrahedron.begin(), tetrahedron.end()}};
  static constexpr Vector3d outwards[]{{12, 12, 0}, {12, 0, 12}, {0, 12, 12}};
  for (const Vector3d& v : outwards) {
    const Vector3d drawn = draws.coin() ? 6.0 * lattice_normal(draws, 2) : v;
    other.vertices.push_back(at + drawn);
  }
  return together(mesh, other);
}

Meshd fans_at_a_vertex(DrawStream& draws) {
  Meshd mesh{{{0, 0, 0}}, {}};
  const auto count = static_cast<Index>(4 + draws.below(5));
  for (Index i = 0; i < count; ++i) {
    const double x = small_integer(draws, 1), y = small_integer(draws, 1), z = small_integer(draws, 1);
    const double size = one_to(draws, 3);
    mesh.vertices.push_back({size * x, size * y, size * z});
  }
  for (std::uint64_t left = 4 + draws.below(2); left > 0; --left) {
    const auto a = 1 + static_cast<Index>(draws.below(count));
    const Index b = 1 + (a + static_cast<Index>(draws.below(count - 1))) % count;
    mesh.faces.push_back({0, a, b});
  }
  return mesh;
}

Meshd convex_at_a_vertex(DrawStream& draws) {
  Meshd mesh{{{0, 0, 0}}, {}};
  for (const double side : {12.0, -12.0}) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    const auto length = [&draws, side] { return side * one_to(draws, 3); };
    const double x = length(), y = length(), z = length();
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {0, y, 0}, {0, 0, z}});
    // In the octant of negative numbers the same faces are turned inside out.
    const bool turned = (side < 0) != (draws.one_in(4));
    const std::array<Index, 4> at{0, first, first + 1, first + 2};
    for (Face face : tetrahedron) {
      if (turned) std::swap(face.b, face.c);
      mesh.faces.push_back({at[face.a], at[face.b], at[face.c]});
    }
  }
  return relisted(mesh, draws);
}

Meshd nested_shells(DrawStream& draws) {
  if (draws.one_in(4)) return cube_in_hollow(draws);
  const Meshd shape = around_the_mean(lattice_polyhedron(draws));
  Meshd mesh;
  for (std::uint64_t left = 1 + draws.below(4); left > 0; --left) {
    const double size = one_to(draws, 4);
    Meshd shell = shape;
    const Vector3d away = draws.one_in(4) ? 48.0 * lattice_normal(draws, 4) : Vector3d{0, 0, 0};
    for (Point3d& p : shell.vertices) p = Point3d{size * p.x, size * p.y, size * p.z} + away;
    if (draws.one_in(3)) turn_inside_out(shell);
    mesh = together(mesh, shell);
  }
  return mesh;
}

Meshd with_repeated_vertices(const Meshd& mesh, DrawStream& draws) {
  Meshd repeated = mesh;
  const bool all = !draws.coin();
  for (Face& f : repeated.faces) {
    if (!all && draws.below(4) != 3) continue;
    for (Index* corner : {&f.a, &f.b, &f.c}) {
      repeated.vertices.push_back(repeated.vertices[*corner]);
      *corner = static_cast<Index>(repeated.vertices.size() - 1);
    }
  }
  return repeated;
}

Meshd reported_faces(DrawStream& draws) {
  const auto [a, b] = reported_triangles(draws);
  Meshd mesh{{{5000, 0, 0}, {5012, 0, 0}, {5000, 12, 0}, {5000, 0, 12}}, {tetrahedron.begin(), tetrahedron.end()}};
  for (const Triangle3d& t : {a, b}) {
    std::array<Index, 3> corners{};
    std::size_t k = 0;
    for (const Point3d& p : {t.a, t.b, t.c}) {
      const auto found = std::find(mesh.vertices.begin(), mesh.vertices.end(), p);
      corners[k++] = static_cast<Index>(found - mesh.vertices.begin());
      if (found == mesh.vertices.end()) mesh.vertices.push_back(p);
    }
    mesh.faces.push_back({corners[0], corners[1], corners[2]});
  }
  return mesh;
}

Meshd with_stretched_axes(Meshd mesh, DrawStream& draws) {
  Stretch{draws}(mesh);
  return mesh;
}

}  // namespace touchstone::catalogue
