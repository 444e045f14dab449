// SPDX-License-Identifier: Apache-2.0
//
// Many questions about one shape: robust asked with raw data, which is validated in each call; with a shape that was
// validated once; and CGAL.
//
// bench/prepared --verify compares the answers without timing.

// CGAL as peer: the same questions to the library that people use for them.
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/globes.h"
#include "catalogue/families/draw_stream.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/polygons/polygon_polygon.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/polyhedra/polyhedron_polyhedron.h"
#include "robust/prepared/polygon.h"
#include "robust/prepared/solid.h"

namespace touchstone::bench {
namespace {

/// The same question to each peer: word i of the answers to question i.
struct Comparison {
  std::string group;
  int questions, questions_of_raw;  ///< raw calls may be too slow for all of them
  std::function<int(int)> raw, prepared, cgal;
  std::function<void()> make;  ///< the prepared shape, from raw data
  /// On two threads, where the operation takes them.
  std::function<int(int)> raw_on_two = {}, prepared_on_two = {};
};

template <class Point>
const Point& at(const std::vector<Point>& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

int location(CGAL::Bounded_side side) { return 1 - static_cast<int>(side); }

double unit(catalogue::DrawStream& draws) { return static_cast<double>(draws.below(1 << 30)) * 0x1p-30; }

/// A star of so many vertices around the origin, its radii between 1/2 and 1.
Polygon2d star(std::size_t vertices, catalogue::DrawStream& draws) {
  Polygon2d ring;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(vertices);
    const double radius = 0.5 + unit(draws) / 2;
    ring.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

std::vector<Epick::Point_2> points_of(const Polygon2d& ring) {
  std::vector<Epick::Point_2> points;
  for (const Point2d& p : ring.vertices) points.emplace_back(p.x, p.y);
  return points;
}

Comparison points_and_polygon(std::size_t vertices) {
  constexpr int questions = 1000;
  auto draws = catalogue::DrawStream::seeded(vertices);
  const Polygon2d ring = star(vertices, draws);
  std::vector<Point2d> points;
  for (int i = 0; i < questions; ++i) points.push_back({2 * unit(draws) - 1, 2 * unit(draws) - 1});
  const robust::Polygon polygon(ring);
  return {"prepared_point_in_polygon_" + std::to_string(vertices) + "/star", questions, questions,
          [=](int i) { return static_cast<int>(robust::point_in_polygon(ring, at(points, i))); },
          [=](int i) { return static_cast<int>(robust::point_in_polygon(polygon, at(points, i))); },
          [=, points_of_ring = points_of(ring)](int i) {
            const Epick::Point_2 p(at(points, i).x, at(points, i).y);
            return location(CGAL::bounded_side_2(points_of_ring.begin(), points_of_ring.end(), p, Epick()));
          },
          [=] { benchmark::DoNotOptimize(robust::Polygon(ring)); }};
}

Meshd sphere(Index n, double radius, const Vector3d& by) {
  return globe(n, [=](double height, double angle) { return on_sphere(height, angle, radius) + by; });
}

Comparison points_and_solid(Index n) {
  constexpr int questions = 1000, of_raw = 20;
  auto draws = catalogue::DrawStream::seeded(n);
  const Meshd mesh = sphere(n, 1, {0, 0, 0});
  std::vector<Point3d> points;
  for (int i = 0; i < questions; ++i)
    points.push_back({2 * unit(draws) - 1, 2 * unit(draws) - 1, 2 * unit(draws) - 1});
  const robust::Solid solid(mesh);
  using Side = CGAL::Side_of_triangle_mesh<Surface, Epick>;
  const auto surface = std::make_shared<Surface>(theirs(mesh));
  const auto side = std::make_shared<Side>(*surface);
  return {"prepared_point_in_polyhedron_" + std::to_string(mesh.faces.size()) + "/sphere", questions, of_raw,
          [=](int i) { return static_cast<int>(robust::point_in_polyhedron(mesh, at(points, i))); },
          [=](int i) { return static_cast<int>(robust::point_in_polyhedron(solid, at(points, i))); },
          [points, surface, side](int i) {  // side refers to surface
            const Point3d& p = at(points, i);
            return location((*side)({p.x, p.y, p.z}));
          },
          [=] { benchmark::DoNotOptimize(robust::Solid(mesh)); }};
}

/// Two spheres: side by side, so that they overlap; or one within the other, with a gap of a hundredth.
Comparison two_solids(Index n, bool nested) {
  const Meshd a = sphere(n, 1, {0, 0, 0}),
              b = nested ? sphere(n, 0.99, {0, 0, 0}) : sphere(n, 1, {1.1, 0.3, 0.2});
  const robust::Solid prepared_a(a), prepared_b(b);
  const auto meet = [](const PolyhedronPolyhedron& found) {
    return static_cast<int>(found.relation != Contact::disjoint);
  };
  return {"prepared_polyhedron_polyhedron_" + std::to_string(a.faces.size()) + (nested ? "/nested" : "/overlapping"), 1,
          1, [=](int) { return meet(robust::polyhedron_polyhedron(a, b)); },
          [=](int) { return meet(robust::polyhedron_polyhedron(prepared_a, prepared_b)); },
          [=, in_a = theirs(a), in_b = theirs(b)](int) {
            const auto parameters = CGAL::Polygon_mesh_processing::parameters::do_overlap_test_of_bounded_sides(true);
            return static_cast<int>(CGAL::Polygon_mesh_processing::do_intersect(in_a, in_b, parameters, parameters));
          },
          [=] { benchmark::DoNotOptimize(robust::Solid(a)); },
          [=](int) { return meet(robust::polyhedron_polyhedron(a, b, 2)); },
          [=](int) { return meet(robust::polyhedron_polyhedron(prepared_a, prepared_b, 2)); }};
}

/// Two stars, of which the second is smaller and off the first one's middle.
Comparison two_polygons(std::size_t vertices) {
  auto draws = catalogue::DrawStream::seeded(vertices);
  const Polygon2d a = star(vertices, draws);
  Polygon2d b = star(vertices, draws);
  for (Point2d& p : b.vertices) p = {p.x / 4 + 1.3, p.y / 4};
  const robust::SimplePolygon prepared_a(a), prepared_b(b);
  return {"prepared_polygon_polygon_" + std::to_string(vertices) + "/apart", 1, 1,
          [=](int) { return static_cast<int>(robust::polygon_polygon(a, b)); },
          [=](int) { return static_cast<int>(robust::polygon_polygon(prepared_a, prepared_b)); },
          {},
          [=] { benchmark::DoNotOptimize(robust::SimplePolygon(a)); }};
}

std::vector<std::function<Comparison()>> comparisons() {
  return {[] { return points_and_polygon(16); },      [] { return points_and_polygon(1000); },
          [] { return points_and_polygon(100000); },  [] { return points_and_solid(5); },
          [] { return points_and_solid(143); },       [] { return two_solids(143, false); },
          [] { return two_solids(143, true); },       [] { return two_polygons(1000); }};
}

void add(const Comparison& made) {
  const auto timed = [&made](const char* name, int questions, const std::function<int(int)>& ask) {
    return benchmark::RegisterBenchmark((made.group + "/" + name).c_str(), [=](benchmark::State& state) {
      int total = 0;
      for (auto _ : state)
        for (int i = 0; i < questions; ++i) total += ask(i);
      benchmark::DoNotOptimize(total);
      state.SetItemsProcessed(state.iterations() * questions);
    });
  };
  timed("robust", made.questions_of_raw, made.raw), timed("prepared", made.questions, made.prepared);
  if (made.cgal) timed("epick", made.questions, made.cgal);
  timed("made", 1, [make = made.make](int) { return make(), 0; });
  if (!made.raw_on_two) return;
  timed("robust_2_threads", 1, made.raw_on_two)->UseRealTime();  // compare with its `Time`, not `CPU`
  timed("prepared_2_threads", 1, made.prepared_on_two)->UseRealTime();
}

bool verified(const Comparison& made) {
  int wrong = 0, wrong_of_cgal = 0;
  for (int i = 0; i < made.questions_of_raw; ++i) wrong += made.prepared(i) != made.raw(i);
  if (made.raw_on_two) wrong += (made.raw_on_two(0) != made.raw(0)) + (made.prepared_on_two(0) != made.raw(0));
  for (int i = 0; made.cgal && i < made.questions; ++i) wrong_of_cgal += made.cgal(i) != made.prepared(i);
  std::printf("%-50s prepared against raw %d differ, against CGAL %d\n", made.group.c_str(), wrong, wrong_of_cgal);
  return wrong + wrong_of_cgal == 0;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  const bool verify = argc == 2 && std::strcmp(argv[1], "--verify") == 0;
  bool held = true;
  for (const auto& make : comparisons()) {
    const Comparison made = make();
    if (verify) held = verified(made) && held;
    else add(made);
  }
  if (verify) return held ? 0 : 1;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
