// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "catalogue/judge/environment.h"
#include "proptests/catch.h"
#include "proptests/long_rings.h"
#include "proptests/refusal.h"
#include "proptests/solids.h"
#include "robust/batch/point_in_convex_polygon.h"
#include "robust/batch/point_in_convex_polyhedron.h"
#include "robust/batch/point_in_polygon.h"
#include "robust/batch/point_in_polyhedron.h"
#include "robust/mixed/convex_distance.h"
#include "robust/polygons/point_in_convex_polygon.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/polygons/point_in_region.h"
#include "robust/polygons/polygon_polygon.h"
#include "robust/polygons/region_region.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/polyhedra/point_mesh_distance.h"
#include "robust/polyhedra/polyhedron_polyhedron.h"
#include "robust/prepared/polygon.h"
#include "robust/prepared/solid.h"
#include "robust/sweeps/swept_convex_polyhedra.h"

/// Shapes that are validated once (robust/prepared): what small questions do not reach, for which the judge asks every
/// operation of prepared shapes too.
namespace touchstone::proptests::prepared_shapes_tests {
namespace {

using robust::ConvexPolygon, robust::ConvexSolid, robust::Polygon, robust::Region,
    robust::SimplePolygon, robust::Solid;

/// Vertices, middles of edges, both with their neighbours, and points level with vertices.
std::vector<Point2d> near_points(const Polygon2d& ring, std::size_t step) {
  std::vector<Point2d> points;
  for (std::size_t i = 0; i < ring.size(); i += step) {
    const Point2d &p = ring[i], &q = ring.next(i), middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
    for (const Point2d& at : {p, middle}) {
      points.push_back(at);
      for (const double up : {-HUGE_VAL, HUGE_VAL}) {
        points.push_back({std::nextafter(at.x, up), at.y});
        points.push_back({at.x, std::nextafter(at.y, up)});
      }
    }
    points.push_back({p.x / 2, p.y}), points.push_back({2 * p.x - 1, p.y}), points.push_back({p.y, p.x});
  }
  return points;
}

/// 1,200 vertices on the boundary of [0, 300]^2, counter-clockwise or clockwise.
Polygon2d square_of_many_vertices(bool clockwise) {
  Polygon2d ring;
  for (int i = 0; i < 1200; ++i) {
    const double along = i % 300;
    const int side = i / 300;
    ring.vertices.push_back(side == 0   ? Point2d{along, 0}
                            : side == 1 ? Point2d{300, along}
                            : side == 2 ? Point2d{300 - along, 300}
                                        : Point2d{0, 300 - along});
  }
  if (clockwise) std::reverse(ring.vertices.begin(), ring.vertices.end());
  return ring;
}

/// By its definition.
Location in_box(std::initializer_list<std::array<double, 3>> low_high_at) {
  bool on = false;
  for (const auto& [low, high, at] : low_high_at) {
    if (at < low || at > high) return Location::outside;
    on = on || at == low || at == high;
  }
  return on ? Location::boundary : Location::inside;
}

/// [0, 96]^2 x [0, 12], in 320 faces.
Meshd slab_of_many_faces() {
  std::vector<catalogue::LatticePoint> cells;
  for (std::int64_t i = 0; i < 64; ++i) cells.push_back({i % 8, i / 8, 0});
  return catalogue::cube_surface(cells);
}

template <class Answers>
void check_same(const Answers& found, const Answers& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("row " << i);
    REQUIRE(found[i] == expected[i]);
  }
}

}  // namespace

TEST_CASE("prepared shapes: a long ring locates as all of its edges do") {
  for (const Polygon2d& ring :
       {wavy_ring(17), wavy_ring(3000), random_ring(700), comb(1000, true), comb(1001, false), comb(129, true)}) {
    const Polygon polygon(ring);
    const std::vector<Point2d> points = near_points(ring, 1 + ring.size() / 200);
    std::vector<std::uint8_t> one_by_one, by_tree, over_arrays(points.size());
    for (const Point2d& p : points) {
      one_by_one.push_back(static_cast<std::uint8_t>(robust::point_in_polygon(ring, p)));
      by_tree.push_back(static_cast<std::uint8_t>(robust::point_in_polygon(polygon, p)));
    }
    check_same(by_tree, one_by_one);
    const robust::batch::Points2 columns{{&points[0].x, 2}, {&points[0].y, 2}};
    robust::batch::point_in_polygon(ring, columns, points.size(), over_arrays.data());
    check_same(over_arrays, one_by_one);
    robust::batch::point_in_polygon(polygon, columns, points.size(), over_arrays.data());
    check_same(over_arrays, one_by_one);
  }
}

TEST_CASE("prepared shapes: a square of many vertices holds what its coordinates say") {
  std::vector<Point2d> points;
  for (const double x : {-1.0, -5e-324, 0.0, 5e-324, 1.0, 149.5, 299.0, 300.0, std::nextafter(300.0, 301), 1e300})
    for (const double y : {-1e300, -5e-324, -0.0, 1.0, 0.5, 150.0, std::nextafter(300.0, 0), 300.0, 301.0})
      points.push_back({x, y});
  std::vector<std::uint8_t> expected, found(points.size());
  for (const Point2d& p : points) expected.push_back(static_cast<std::uint8_t>(in_box({{0, 300, p.x}, {0, 300, p.y}})));
  const robust::batch::Points2 columns{{&points[0].x, 2}, {&points[0].y, 2}};
  for (const bool clockwise : {false, true}) {
    const Polygon2d ring = square_of_many_vertices(clockwise);
    robust::batch::point_in_convex_polygon(ring, columns, points.size(), found.data());
    check_same(found, expected);
    robust::batch::point_in_convex_polygon(ConvexPolygon(ring), columns, points.size(), found.data());
    check_same(found, expected);
    CHECK(SimplePolygon(ring).ring().size() == 1200);
    const SimplePolygon one(ring);
    Polygon2d moved = ring;
    const auto contact_at = [&](double x, double y) {
      for (std::size_t i = 0; i < moved.size(); ++i) moved.vertices[i] = {ring[i].x + x, ring[i].y + y};
      CHECK(robust::polygon_polygon(one, SimplePolygon(moved)) == robust::polygon_polygon(ring, moved));
      return robust::polygon_polygon(one, SimplePolygon(moved));
    };
    CHECK(contact_at(299, 0.5) == Contact::overlapping);
    CHECK(contact_at(300, 0.5) == Contact::touching);
    CHECK(contact_at(300, -300) == Contact::touching);
    CHECK(contact_at(300, 300.5) == Contact::disjoint);
    CHECK(contact_at(0, 0) == Contact::overlapping);
  }
}

TEST_CASE("prepared shapes: a region with holes of many vertices holds what its coordinates say") {
  // [0, 300]^2 without the open insides of [100, 175]^2 and [175, 250]^2, which touch in a corner.
  for (const bool clockwise : {false, true}) {
    const Polygon2d ring = square_of_many_vertices(clockwise), other = square_of_many_vertices(!clockwise);
    const auto smaller = [&other](double at, double size) {
      Polygon2d made = other;
      for (Point2d& p : made.vertices) p = {at + size / 300 * p.x, at + size / 300 * p.y};
      return made;
    };
    const Region2d given{ring, {smaller(100, 75), smaller(175, 75)}};
    const Region region(given);
    CHECK(region.rings().size() == 3);
    for (const double x : {-1.0, 0.0, 50.0, 100.0, std::nextafter(100.0, 101), 140.0, 175.0, 200.0, 250.0, 300.0})
      for (const double y : {-1.0, 0.0, 50.0, 100.0, 140.0, 175.0, std::nextafter(175.0, 176), 200.0, 300.0}) {
        Location expected = in_box({{0, 300, x}, {0, 300, y}});
        for (const double low : {100.0, 175.0}) {
          const Location in_hole = in_box({{low, low + 75, x}, {low, low + 75, y}});
          if (in_hole == Location::boundary) expected = Location::boundary;
          if (in_hole == Location::inside) expected = Location::outside;
        }
        INFO(x << " " << y);
        CHECK(robust::point_in_region(region, {x, y}) == expected);
        CHECK(robust::point_in_region(given, {x, y}) == expected);
      }
    const auto contact_with = [&](double at, double size) {
      const Region2d square{smaller(at, size), {}};
      const Contact found = robust::region_region(region, Region(square, "b"));
      CHECK(robust::region_region(square, given) == found);
      return found;
    };
    CHECK(contact_with(100, 75) == Contact::touching);
    CHECK(contact_with(100, 37.5) == Contact::touching);
    CHECK(contact_with(120, 37.5) == Contact::disjoint);
    CHECK(contact_with(120, 75) == Contact::overlapping);
    CHECK(contact_with(10, 37.5) == Contact::overlapping);
    CHECK(contact_with(300, 75) == Contact::touching);
    CHECK(contact_with(301, 75) == Contact::disjoint);
  }
}

TEST_CASE("prepared shapes: a solid of many faces holds what its coordinates say") {
  const Meshd slab = slab_of_many_faces();
  REQUIRE(slab.faces.size() == 320);
  std::vector<Point3d> points;
  for (const double x : {-1.0, 0.0, 5e-324, 12.0, 40.5, 96.0, 97.0})
    for (const double y : {-5e-324, 0.0, 1.0, 48.0, std::nextafter(96.0, 0), 96.0})
      for (const double z : {-1.0, 0.0, 6.0, 12.0, std::nextafter(12.0, 13)}) points.push_back({x, y, z});
  std::vector<std::uint8_t> expected, found(points.size());
  for (const Point3d& p : points)
    expected.push_back(static_cast<std::uint8_t>(in_box({{0, 96, p.x}, {0, 96, p.y}, {0, 12, p.z}})));
  const robust::batch::Points3 columns{{&points[0].x, 3}, {&points[0].y, 3}, {&points[0].z, 3}};
  robust::batch::point_in_polyhedron(slab, columns, points.size(), found.data());
  check_same(found, expected);
  robust::batch::point_in_convex_polyhedron(slab, columns, points.size(), found.data());
  check_same(found, expected);
  robust::batch::point_in_convex_polyhedron(ConvexSolid(slab), columns, points.size(), found.data());
  check_same(found, expected);
}

TEST_CASE("prepared shapes: a slab of many faces is as far as its coordinates say, by a tree or not") {
  const Meshd slab = slab_of_many_faces();
  const Solid solid(slab);
  const double ends[][2]{{0, 96}, {0, 96}, {0, 12}};
  for (const double x : {-3.0, 0.0, 1.5, 40.5, 96.0, 1000.0})
    for (const double y : {-4.0, 0.0, 2.5, 47.75, 95.0, 99.0})
      for (const double z : {-12.0, 0.0, 0.25, 6.0, 12.0, 16.0}) {
        const double at[]{x, y, z};
        double square = 0, within = 96;
        for (int axis = 0; axis < 3; ++axis) {
          const double beyond = std::max({0.0, ends[axis][0] - at[axis], at[axis] - ends[axis][1]});
          square += beyond * beyond;
          within = std::min({within, at[axis] - ends[axis][0], ends[axis][1] - at[axis]});
        }
        if (square == 0) square = within * within;
        const auto found = robust::point_mesh_distance({x, y, z}, solid),
                   raw = robust::point_mesh_distance({x, y, z}, slab);
        INFO(x << " " << y << " " << z);
        REQUIRE(found.squared_distance == square);
        REQUIRE(found.location == in_box({{0, 96, x}, {0, 96, y}, {0, 12, z}}));
        REQUIRE((found.nearest.face == raw.nearest.face && found.signed_distance == raw.signed_distance));
      }
}

TEST_CASE("prepared shapes: rows that are refused are named over many faces too") {
  const Meshd slab = slab_of_many_faces();
  const Polygon2d square = square_of_many_vertices(false);
  const double numbers[] = {1, 1, 1, 1, std::numeric_limits<double>::infinity(), 1};
  std::uint8_t found[2];
  const auto column = [&numbers](std::ptrdiff_t k, std::ptrdiff_t stride) {
    return robust::batch::Column{numbers + k, stride};
  };
  const std::string of_solid = refusal_of([&] {
    robust::batch::point_in_polyhedron(slab, {column(0, 3), column(1, 3), column(2, 3)}, 2, found);
  });
  CHECK(of_solid == "questions[1].point[1]: finite number");
  const std::string of_polygon = refusal_of([&] {
    robust::batch::point_in_polygon(square, {column(0, 4), column(1, 3)}, 2, found);
  });
  CHECK(of_polygon == "questions[1].point[0]: finite number");
}

TEST_CASE("prepared shapes: what breaks a rule is refused as the operations refuse it") {
  const Polygon2d two{{{0, 0}, {1, 0}}}, crossed{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
      dented{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, flat{{{0, 0}, {1, 0}, {2, 0}}},
      infinite{{{0, 0}, {1, 0}, {HUGE_VAL, 1}}};
  for (const Polygon2d& ring : {two, infinite}) {
    const std::string said = refusal_of([&] { robust::point_in_polygon(ring, Point2d{0, 0}); });
    CHECK(said != "accepted");
    CHECK(refusal_of([&] { Polygon{ring}; }) == said);
    CHECK(refusal_of([&] { SimplePolygon{ring}; }) == said);
  }
  for (const Polygon2d& ring : {crossed, dented, flat}) {
    CHECK(refusal_of([&] { Polygon{ring}; }) == "accepted");
    const std::string said = refusal_of([&] { robust::point_in_convex_polygon(ring, Point2d{0, 0}); });
    CHECK(said != "accepted");
    CHECK(refusal_of([&] { ConvexPolygon{ring}; }) == said);
  }
  CHECK(refusal_of([&] { SimplePolygon(dented, "a"); }) == "accepted");
  for (const Polygon2d& ring : {crossed, flat, two})
    CHECK(refusal_of([&] { SimplePolygon(ring, "a"); }) == refusal_of([&] { robust::polygon_polygon(ring, dented); }));
  CHECK(refusal_of([&] { robust::point_in_polygon(Polygon(dented), Point2d{NAN, 0}); }) == "point[0]: finite number");

  const Region2d beyond{dented, {dented}}, of_crossed{crossed, {}}, of_infinite{dented, {infinite}};
  for (const Region2d& region : {beyond, of_crossed, of_infinite}) {
    const std::string said = refusal_of([&] { robust::point_in_region(region, Point2d{0, 0}); });
    CHECK(said.substr(0, 6) == "region");
    CHECK(refusal_of([&] { Region{region}; }) == said);
    CHECK(refusal_of([&] { Region(region, "a"); }) ==
          refusal_of([&] { robust::region_region(region, Region2d{dented, {}}); }));
  }
  CHECK(refusal_of([&] {
          robust::point_in_region(Region(Region2d{dented, {}}), Point2d{0, NAN});
        }) == "point[1]: finite number");

  Meshd open = solids::cube, infinite_mesh = solids::cube;
  open.faces.pop_back(), infinite_mesh.vertices[3].z = HUGE_VAL;
  for (const Meshd& mesh : {open, infinite_mesh}) {
    const std::string said = refusal_of([&] { robust::point_in_polyhedron(mesh, Point3d{0, 0, 0}); });
    CHECK(said != "accepted");
    CHECK(refusal_of([&] { Solid{mesh}; }) == said);
  }
  CHECK(refusal_of([&] { Solid{solids::angle}; }) == "accepted");
  CHECK(refusal_of([&] { ConvexSolid(solids::angle, "b"); }) ==
        refusal_of([&] { robust::convex_distance(solids::cube, solids::angle); }));
  CHECK(refusal_of([&] { ConvexSolid(solids::angle, "b"); }) != "accepted");
  for (const auto& refused : {refusal_of([&] { Polygon(two, "x"); }), refusal_of([&] { SimplePolygon(crossed, "x"); }),
                              refusal_of([&] { ConvexPolygon(dented, "x"); }), refusal_of([&] { Solid(open, "x"); }),
                              refusal_of([&] { ConvexSolid(infinite_mesh, "x"); })})
    CHECK(refused.substr(0, 1) == "x");
  const ConvexSolid cube(solids::cube);
  CHECK(refusal_of([&] {
          robust::swept_convex_polyhedra(cube, cube, Vector3d{0, 0, NAN});
        }) == "velocity[2]: finite number");
  CHECK(refusal_of([&] {
          robust::point_in_polyhedron(Solid(solids::cube), Point3d{0, NAN, 0});
        }) == "point[1]: finite number");
}

TEST_CASE("prepared shapes: they may be made and asked in different environments") {
  // On a face at 1 + 2^-30, which is no float; beyond the greatest float; below the least normal one.
  struct Asked {
    Point3d low, high, at;
    Location location;
  };
  const double beside = 1 + 0x1p-30;
  const Asked cases[] = {{{0, 0, 0}, {beside, beside, beside}, {beside, 0.5, 0.4}, Location::boundary},
                         {{0, 0, 0}, {beside, beside, beside}, {0.5, beside, 0.4}, Location::boundary},
                         {{1e300, 1e300, 1e300}, {2e300, 2e300, 2e300}, {1.5e300, 1.4e300, 1.3e300}, Location::inside},
                         {{1e-40, 1e-40, 1e-40}, {3e-40, 3e-40, 3e-40}, {2e-40, 1.4e-40, 1.3e-40}, Location::inside},
                         {{0, 0, 0}, {5e-324, 5e-324, 5e-324}, {5e-324, 0, 0}, Location::boundary}};
  using catalogue::in_environment;
  for (const auto& [low, high, at, location] : cases) {
    const Meshd mesh = solids::mesh_of({low, high}),
                next = solids::mesh_of({{high.x, low.y, low.z}, {2 * high.x, high.y, high.z}});
    for (std::size_t made = 0; made < catalogue::environment_count; ++made) {
      const ConvexSolid solid = in_environment(made, mesh, [](const Meshd& of) { return ConvexSolid(of); });
      for (std::size_t asked = 0; asked < catalogue::environment_count; ++asked) {
        INFO(catalogue::environment_name(made) << ", " << catalogue::environment_name(asked));
        const auto locate = [&solid](const Point3d& p) { return robust::point_in_convex_polyhedron(solid, p); };
        const auto meet = [&solid](const Meshd& of) {
          return robust::polyhedron_polyhedron(solid, Solid(of)).relation;
        };
        CHECK(in_environment(asked, at, locate) == location);
        CHECK(in_environment(asked, next, meet) == Contact::touching);
      }
    }
  }
}

TEST_CASE("prepared shapes: copies answer when what they were made of is gone") {
  std::vector<Solid> solids;
  std::vector<Polygon> polygons;
  {
    const Solid solid(solids::ring);
    const Polygon polygon(comb(100, true));
    solids.assign(3, solid), polygons.assign(3, polygon);
  }
  const Solid moved = std::move(solids[0]);
  CHECK(robust::point_in_polyhedron(moved, Point3d{6, 6, 6}) == Location::inside);
  CHECK(robust::point_in_polyhedron(solids[1], Point3d{18, 18, 6}) == Location::outside);  // the hole
  CHECK(robust::polyhedron_polyhedron(moved, solids[2]).relation == Contact::overlapping);
  CHECK(robust::point_in_polygon(polygons[2], Point2d{0.5, 50}) == Location::inside);
}

TEST_CASE("prepared shapes: a convex solid whose faces are there twice has the inside of one") {
  Meshd twice = solids::cube;
  const auto count = static_cast<Index>(twice.vertices.size());
  for (Index i = 0; i < count; ++i) twice.vertices.push_back(solids::cube.vertices[i]);
  for (const auto& [a, b, c] : solids::cube.faces) twice.faces.push_back({a + count, b + count, c + count});
  const Point3d &p = twice.vertices[0], &q = twice.vertices[1];
  for (const Meshd& mesh : {solids::cube, twice}) {
    Point3d middle{0, 0, 0};
    for (Index i = 0; i < count; ++i) middle = middle + 1.0 / count * (mesh.vertices[i] - Point3d{0, 0, 0});
    std::uint8_t found = 0;
    robust::batch::point_in_convex_polyhedron(ConvexSolid(mesh), {&middle.x, &middle.y, &middle.z}, 1, &found);
    CHECK(found == static_cast<std::uint8_t>(Location::inside));
    CHECK(robust::point_in_convex_polyhedron(ConvexSolid(mesh), middle) == Location::inside);
    CHECK(robust::point_in_convex_polyhedron(ConvexSolid(mesh), p) == Location::boundary);
    CHECK(robust::point_in_convex_polyhedron(ConvexSolid(mesh), q + 2.0 * (q - middle)) == Location::outside);
  }
}

}  // namespace touchstone::proptests::prepared_shapes_tests
