// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/minkowski/difference_faces.h"

#include <cmath>

#include "catalogue/families/meshes/mesh_draws.h"
#include "proptests/catch.h"
#include "robust/kernel/minkowski/least_overlap.h"
#include "robust/volumes/convex_hull.h"

/// The least overlap by the polytope that grows, and by all faces and pairs of edges.
namespace touchstone::proptests::difference_face_tests {
namespace {

using catalogue::DrawStream;
using robust::kernel::CoreOverlap;

/// The square of the overlap.
mpq_class square_of(const CoreOverlap& found) {
  const mpz_class length = dot(found.direction, found.direction) * found.total * found.total;
  mpq_class square(mpz_class(found.height * found.height), length);
  square.canonicalize();
  const int twice = 2 * found.exponent;
  if (twice < 0) mpq_div_2exp(square.get_mpq_t(), square.get_mpq_t(), static_cast<mp_bitcnt_t>(-twice));
  else mpq_mul_2exp(square.get_mpq_t(), square.get_mpq_t(), static_cast<mp_bitcnt_t>(twice));
  return square;
}

Meshd moved(Meshd mesh, const Vector3d& by) {
  for (Point3d& p : mesh.vertices) p = p + by;
  return mesh;
}

/// The hull of random points in a cube.
Meshd round_mesh(DrawStream& draws, std::size_t count) {
  Meshd mesh;
  const auto coordinate = [&] { return static_cast<double>(draws.below(1 << 20)) * 0x1p-19 - 1; };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    mesh.vertices.push_back({x, y, z});
  }
  mesh.faces = robust::convex_hull(mesh.vertices).faces.value();
  return mesh;
}

/// True if the polytope finds faces; what it finds is the least.
bool finds_the_least(const Meshd& a, const Meshd& b) {
  const auto faces = robust::kernel::nearest_difference_faces(a, b);
  if (!faces) return false;
  const auto found = robust::kernel::least_of_faces(a, b, *faces);
  if (!found) return false;
  const CoreOverlap least = robust::kernel::least_overlap(a, b);
  CHECK(square_of(*found) == square_of(least));
  CHECK(found->of_a == least.of_a);
  CHECK(found->of_b == least.of_b);
  return true;
}

}  // namespace

TEST_CASE("difference faces: where interiors meet they are found, and the least overlap is that of all directions") {
  DrawStream draws = DrawStream::seeded(1);
  for (int i = 0; i < 40; ++i) {
    const Meshd a = round_mesh(draws, 8 + draws.below(40)), b = round_mesh(draws, 8 + draws.below(40));
    CHECK(finds_the_least(a, moved(b, {0.25 * static_cast<double>(draws.below(4)), 0.125, 0})));
  }
}

TEST_CASE("difference faces: of lattice solids, many directions of which are as deep, all are found") {
  DrawStream draws = DrawStream::seeded(2);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const Meshd a = catalogue::lattice_polyhedron(draws);
    const double x = static_cast<double>(draws.below(5)) - 2, y = static_cast<double>(draws.below(5)) - 2;
    found +=
        static_cast<int>(finds_the_least(a, moved(i % 2 == 0 ? a : catalogue::lattice_polyhedron(draws), {x, y, 0})));
  }
  CHECK(found > 50);
}

TEST_CASE("difference faces: far from the origin, where rounding names wrong vertices, the least is found or nothing") {
  DrawStream draws = DrawStream::seeded(4);
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    Meshd a;
    const double far = std::ldexp(1.0, 16 + static_cast<int>(draws.below(12)));
    const auto part = [&] { return (static_cast<double>(draws.below(6001)) - 3000) / 1000; };
    for (int k = 0; k < 3; ++k) {
      const double x = part(), y = part(), z = part();
      a.vertices.push_back({far + x, far + y, far + z}), a.vertices.push_back({far - x, far - y, far - z});
    }
    const auto faces = robust::convex_hull(a.vertices).faces;
    if (!faces || a.vertices.size() != 6) continue;
    a.faces = *faces;
    found += static_cast<int>(finds_the_least(a, catalogue::relisted(a, draws)));
  }
  CHECK(found > 1000);
}

TEST_CASE("difference faces: none where solids touch or are apart, or numbers are huge") {
  DrawStream draws = DrawStream::seeded(3);
  const Meshd a = round_mesh(draws, 20);
  CHECK(!robust::kernel::nearest_difference_faces(a, moved(a, {3, 0, 0})));
  CHECK(!robust::kernel::nearest_difference_faces(a, moved(a, {0x1p40, 0, 0})));
  const Meshd cube = [] {
    Meshd mesh;
    for (int i = 0; i < 8; ++i)
      mesh.vertices.push_back(
          {static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
    mesh.faces = robust::convex_hull(mesh.vertices).faces.value();
    return mesh;
  }();
  CHECK(!robust::kernel::nearest_difference_faces(cube, moved(cube, {1, 0, 0})));
  CHECK(!robust::kernel::nearest_difference_faces(cube, moved(cube, {1, 1, 1})));
  CHECK(robust::kernel::nearest_difference_faces(cube, cube).has_value());
}

}  // namespace touchstone::proptests::difference_face_tests
