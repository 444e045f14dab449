// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/cloud_draws.h"

#include <algorithm>
#include <cmath>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/rings.h"
#include "catalogue/families/space_draws.h"

namespace touchstone::catalogue {
namespace {

using Points = std::vector<Point3d>;

Point3d times(double factor, const Point3d& p) { return {factor * p.x, factor * p.y, factor * p.z}; }

Point3d on_grid(DrawStream& c, int most) {
  return {small_integer(c, most), small_integer(c, most), small_integer(c, most)};
}

/// x y z, y z x or z x y.
Point3d axes_turned(const Point3d& p, DrawStream& c) {
  switch (c.below(3)) {
    case 1: return {p.y, p.z, p.x};
    case 2: return {p.z, p.x, p.y};
    default: return p;
  }
}

/// A lattice point on the sphere of radius 9.
Point3d on_a_sphere(DrawStream& c) {
  static constexpr std::array<Point3d, 4> octant{{{0, 0, 9}, {1, 4, 8}, {4, 4, 7}, {3, 6, 6}}};
  const Point3d p = axes_turned(octant[c.below(4)], c);
  const double x = c.coin() ? -p.x : p.x, y = c.coin() ? -p.y : p.y;
  const Point3d q{x, y, c.coin() ? -p.z : p.z};
  return c.coin() ? Point3d{q.y, q.x, q.z} : q;
}

Points few(DrawStream& c) {
  Points points{lattice_point_in_space(c)};
  for (std::uint64_t more = c.below(4); more > 0; --more) points.push_back(lattice_point_in_space(c));
  return points;
}

Points all_equal(DrawStream& c) {
  const Point3d p = lattice_point_in_space(c);
  Points points(1 + c.below(6), p);
  if (points[0].y == 0 && c.coin()) points.back().y = -0.0;
  return points;
}

Points collinear(DrawStream& c) {
  const Point3d p = lattice_point_in_space(c);
  const Vector3d v = lattice_normal(c);
  return one_by_one(c, 12, [&](DrawStream& d) { return p + small_integer(d) * v; });
}

Points across_an_axis(DrawStream& c) {
  const double height = integer(c, 20);
  Points points = one_by_one(c, 24, [&](DrawStream& d) {
    const double x = small_integer(d), y = small_integer(d);
    return Point3d{x, y, height};
  });
  const std::uint64_t turn = c.below(3);
  for (Point3d& p : points) p = turn == 0 ? p : turn == 1 ? Point3d{p.y, p.z, p.x} : Point3d{p.z, p.x, p.y};
  return points;
}

/// Integers of that many bits or a few less, and their multiples.
Points tilted(DrawStream& c, int bits, std::size_t most) {
  const Point3d p = lattice_point_in_space(c, bits);
  const Vector3d v = lattice_normal(c, bits), w = lattice_normal(c, bits);
  return one_by_one(c, most, [&](DrawStream& d) {
    const double i = small_integer(d, 4), j = small_integer(d, 4);
    return p + i * v + j * w;
  });
}

Points in_a_tilted_plane(DrawStream& c) { return tilted(c, 20, 24); }

Points one_beside_a_plane(DrawStream& c) {
  Points points = tilted(c, 16, 24);
  const Vector3d off{small_integer(c, 1), small_integer(c, 1), small_integer(c, 1)};
  points.push_back(points[0] + off);
  return shuffled(points, c);
}

/// Planes at the ends of the lattices on which determinants need 53 and 123 bits.
Points planes_at_a_seam(DrawStream& c) {
  const int seam = c.coin() ? 36 : 13, bits = seam + integer_in(c, 0, 4);
  Points points = tilted(c, bits, 12);
  for (std::uint64_t more = 1 + c.below(3); more > 0; --more) {
    const Vector3d off{small_integer(c, 1), small_integer(c, 1), small_integer(c, 1)};
    const Point3d p = points[c.below(points.size())];
    points.push_back(p + off);
  }
  points.push_back({std::ldexp(1, bits + 3), 0, 0});
  return shuffled(points, c);
}

Points small_grid(DrawStream& c) {
  const int most = integer_in(c, 1, 2);
  return one_by_one(c, 24, [most](DrawStream& d) { return on_grid(d, most); });
}

Points cospherical(DrawStream& c) { return one_by_one(c, 24, on_a_sphere); }

Points prism(DrawStream& c) {
  Polygon2d ring = convex_ring(c);
  for (Point2d& p : ring.vertices) p = {4 * p.x, 4 * p.y};
  for (std::uint64_t more = c.below(3); more > 0; --more) ring = with_flat_vertex(ring, c);
  const double height = 1 + std::fabs(integer(c, 12));
  Points points;
  for (const Point2d& p : ring.vertices) points.insert(points.end(), {{p.x, p.y, 0}, {p.x, p.y, height}});
  return shuffled(points, c);
}

/// The middle of two, and of the middle and a third: on edges, on faces and inside. Exact, because corners are
/// multiples of 12.
Points between_corners(DrawStream& c) {
  Points points = lattice_polyhedron(c).vertices;
  const std::size_t corners = points.size();
  for (std::uint64_t more = 1 + c.below(12); more > 0; --more) {
    const Point3d p = points[c.below(corners)], q = points[c.below(corners)], r = points[c.below(corners)];
    const Point3d middle{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    if (c.coin()) points.push_back(middle);
    else points.push_back({(middle.x + r.x) / 2, (middle.y + r.y) / 2, (middle.z + r.z) / 2});
  }
  return shuffled(points, c);
}

Points repeated(DrawStream& c) { return shuffled(with_repeated(lattice_polyhedron(c).vertices, 8, c), c); }

Points mapped(DrawStream& c) {
  Meshd mesh = lattice_polyhedron(c);
  map_linearly(c, mesh);
  return mesh.vertices;
}

Points tiny_beside_huge(DrawStream& c) {
  return one_by_one(c, 12, [](DrawStream& d) {
    static constexpr std::array<int, 5> exponents{0, 60, -60, 1000, -1074};
    const Point3d p = lattice_point_in_space(d, 10);
    return scaled(p, exponents[d.below(5)]);
  });
}

Points subnormal(DrawStream& c) {
  Points points = tilted(c, 20, 12);
  points.push_back(lattice_point_in_space(c, 20));
  for (Point3d& p : points) p = scaled(p, -1074);
  return points;
}

/// All 53 bits, and exactly in one plane.
Points long_plane(DrawStream& c) {
  Points points = one_by_one(c, 12, [](DrawStream& d) {
    const double x = ordinary(d), y = ordinary(d);
    return Point3d{x, y, -(x + y)};
  });
  if (c.coin()) points.push_back(on_grid(c, 1));
  return points;
}

Points computed(DrawStream& c) {
  Points points = prism(c);
  std::vector<Point2d> projected;
  for (const Point3d& p : points) projected.push_back({p.x, p.y});
  compute(projected, c);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].x = projected[i].x, points[i].y = projected[i].y;
  return points;
}

/// Lists long enough for far points to be looked for.
std::uint64_t many(DrawStream& c) { return 32 + c.below(12); }

Points many_on_a_grid(DrawStream& c) {
  const int most = integer_in(c, 2, 41), inner = 1 + most / 3;
  Points points;
  for (std::uint64_t left = many(c); left > 0; --left) points.push_back(on_grid(c, c.one_in(4) ? most : inner));
  return points;
}

/// A sphere, and most points within it.
Points many_cospherical(DrawStream& c) {
  Points points;
  const double factor = 2 + 2 * static_cast<double>(c.below(1 << 20));
  for (std::uint64_t left = many(c); left > 0; --left) {
    const Point3d p = on_a_sphere(c);
    points.push_back(times(c.one_in(4) ? factor : factor / 2, p));
  }
  return points;
}

/// A box, and points of its faces or an ulp away from them.
Points many_beside_faces(DrawStream& c) {
  Points points;
  for (const double x : {-0.3, 0.7})
    for (const double y : {-0.1, 0.9})
      for (const double z : {-0.2, 0.8}) points.push_back({x, y, z});
  for (std::uint64_t left = many(c); left > 0; --left) {
    const double u = up_to(c, 99) / 100, v = up_to(c, 99) / 100;
    const int ulps = static_cast<int>(small_integer(c, 1));
    const double on = moved_by_ulps(c.coin() ? 0.7 : -0.3, ulps);
    points.push_back(c.one_in(5) ? Point3d{on, u - 0.1, v - 0.2} : Point3d{u - 0.3, v - 0.1, 0.3});
  }
  return shuffled(points, c);
}

/// As thin as a leaf, or as a hair, tilted: far points are not fat enough.
Points many_in_a_leaf(DrawStream& c) {
  Points points;
  const int thickness = integer_in(c, 0, 29);
  for (std::uint64_t left = many(c); left > 0; --left) {
    const double x = small_integer(c, 100), y = small_integer(c, 100);
    points.push_back({x, y, x + y + std::ldexp(small_integer(c, 1), -thickness)});
  }
  return points;
}

/// All bits, far from the origin or around it; most points near the middle.
Points many_random(DrawStream& c) {
  const double where = c.coin() ? 100 : 0;
  Points points;
  for (std::uint64_t left = many(c); left > 0; --left) {
    const double size = c.one_in(4) ? 1 : 0.5, x = size * ordinary(c), y = size * ordinary(c);
    points.push_back({where + x, y, size * ordinary(c)});
  }
  return points;
}

/// As a question.
template <Points (*draw)(DrawStream&)>
std::tuple<Points> asked(DrawStream& c) {
  return {draw(c)};
}

}  // namespace

void cloud_cases(HardCases<std::tuple<Points>>& add) {
  add("few", asked<few>);
  add("all_equal", asked<all_equal>);
  add("collinear", asked<collinear>);
  add("across_an_axis", asked<across_an_axis>);
  add("in_a_tilted_plane", asked<in_a_tilted_plane>);
  add("one_beside_a_plane", asked<one_beside_a_plane>);
  add("planes_at_a_seam", asked<planes_at_a_seam>);
  add("small_grid", asked<small_grid>);
  add("cospherical", asked<cospherical>);
  add("prism", asked<prism>);
  add("between_corners", asked<between_corners>);
  add("repeated", asked<repeated>);
  add("mapped", asked<mapped>);
  add("tiny_beside_huge", asked<tiny_beside_huge>);
  add("subnormal", asked<subnormal>);
  add("long_plane", asked<long_plane>);
}

void large_cloud_cases(HardCases<std::tuple<Points>>& add) {
  add("computed", asked<computed>);
  add("many_on_a_grid", asked<many_on_a_grid>);
  add("many_cospherical", asked<many_cospherical>);
  add("many_beside_faces", asked<many_beside_faces>);
  add("many_in_a_leaf", asked<many_in_a_leaf>);
  add("many_random", asked<many_random>);
}

}  // namespace touchstone::catalogue
