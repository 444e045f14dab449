// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/polygon_draws.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/drawn_cut.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/families/numbers.h"

namespace touchstone::catalogue {
namespace {

using Corners = std::vector<Index>;

void turn_to_begin_at(Corners& corners, std::size_t place) {
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(place), corners.end());
}

/// One ring around both, without an edge that they run along in opposite directions; empty where they have none such.
Corners united(Corners a, Corners b, std::size_t first) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::size_t at = (first + k) % a.size();
    const Index from = a[at], to = a[(at + 1) % a.size()];
    for (std::size_t l = 0; l < b.size(); ++l) {
      if (b[l] != to || b[(l + 1) % b.size()] != from) continue;
      turn_to_begin_at(a, (at + 1) % a.size());  // to ... from
      turn_to_begin_at(b, (l + 1) % b.size());   // from ... to
      a.insert(a.end(), b.begin() + 1, b.end() - 1);
      return a;
    }
  }
  return {};
}

/// A cube, and perhaps others next to it in one layer, around a hole too.
Meshd cubes_of_a_layer(DrawStream& draws) {
  std::vector<LatticePoint> cells{{0, 0, 0}};
  for (std::int64_t i = 1; i < 9; ++i) {
    if (draws.coin()) cells.push_back({i % 3, i / 3, 0});
  }
  return cube_surface(cells);
}

}  // namespace

Meshd with_polygons(const Meshd& mesh, DrawStream& draws) {
  std::vector<Corners> polygons;
  for (const Face& f : mesh.faces) polygons.push_back({f.a, f.b, f.c});
  const PolygonCutter cutter(mesh.vertices);
  const auto valid = [&cutter](const Corners& corners) {
    DrawStream simplest = DrawStream::replayed({});
    return cutter.cut(corners, simplest).has_value();
  };
  // The simplest unites all that it can.
  const std::uint64_t left_out = draws.below(3);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t j = i + 1; j < polygons.size();) {
      const std::size_t first = draws.below(3);
      Corners both = united(polygons[i], polygons[j], first);
      if (both.empty() || (left_out != 0 && draws.below(4) < left_out) || !valid(both)) {
        ++j;
        continue;
      }
      polygons[i] = std::move(both);
      polygons.erase(polygons.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
  for (Corners& corners : polygons) turn_to_begin_at(corners, draws.below(corners.size()));
  return cut_mesh(mesh.vertices, std::move(polygons), draws);
}

Meshd recut(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  return cut_mesh(std::move(mesh.vertices), std::move(mesh.polygons), draws);
}

Meshd with_fin(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  const Corners corners = mesh.polygons[draws.below(mesh.polygons.size())];
  const std::size_t first = draws.below(corners.size());
  const Index a = corners[first], b = corners[(first + (draws.one_in(4) ? 3 : 2)) % corners.size()];
  const Point3d p = mesh.vertices[a], q = mesh.vertices[b], next = mesh.vertices[corners[(first + 1) % corners.size()]];
  if (a == b) return mesh;
  const auto tip = static_cast<Index>(mesh.vertices.size());
  const auto add_in_front = [&mesh](const Face& f) {
    mesh.faces.insert(mesh.faces.begin(), f), mesh.polygons.insert(mesh.polygons.begin(), {f.a, f.b, f.c});
  };
  const auto add = [&mesh](const Face& f) { mesh.faces.push_back(f), mesh.polygons.push_back({f.a, f.b, f.c}); };
  const std::uint64_t kind = draws.below(5);
  if (kind == 4) {
    mesh.vertices.push_back(p + (p - q)), add({a, b, tip});
    return mesh;
  }
  mesh.vertices.push_back(p + 0.5 * (q - p) + 0x1p-6 * cross(next - p, q - p));
  if (kind >= 2) add_in_front({a, b, tip});
  else add({a, b, tip}), add({b, a, tip});
  return mesh;
}

Meshd with_broken_polygons(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  Corners& corners = mesh.polygons[draws.below(mesh.polygons.size())];
  const std::size_t which = draws.below(mesh.faces.size());
  Face& face = mesh.faces[which];
  switch (draws.below(7)) {
    case 0: mesh.vertices[corners[draws.below(corners.size())]].z += small_integer(draws, 2); break;
    case 1: std::swap(corners[0], corners[draws.below(corners.size())]); break;
    case 2: std::swap(face.a, face.b); break;
    case 3: face = mesh.faces[draws.below(mesh.faces.size())]; break;
    case 4: face.a = static_cast<Index>(draws.below(mesh.vertices.size())); break;
    case 5: mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(which)); break;
    default: corners[draws.below(corners.size())] = corners[0];
  }
  return mesh;
}

Meshd solid_of_polygons(DrawStream& draws) {
  Meshd mesh = draws.one_in(3) ? lattice_solid(draws) : cubes_of_a_layer(draws);
  for (std::uint64_t more = draws.below(3); more > 0; --more) mesh = with_flat_vertex(mesh, draws);
  return with_polygons(mesh, draws);
}

Meshd convex_solid_of_polygons(DrawStream& draws) {
  Meshd mesh = lattice_polyhedron(draws);
  for (std::uint64_t more = draws.below(3); more > 0; --more) mesh = with_flat_vertex(mesh, draws);
  return with_polygons(mesh, draws);
}

}  // namespace touchstone::catalogue
