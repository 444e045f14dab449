// SPDX-License-Identifier: Apache-2.0
//
// Convex hulls of many points in space: robust, CGAL's convex_hull_3 with the kernel Epick, and qhull, all from one
// list of points, in processor time.
//
// bench/hulls --verify compares the numbers of faces that robust and CGAL find (for points whose faces are triangles)
// without timing.

// CGAL as peer: the same hulls by the library that people use for them.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <benchmark/benchmark.h>
#if __has_include(<libqhull_r/qhull_ra.h>)
#define TOUCHSTONE_QHULL
extern "C" {
#include <libqhull_r/qhull_ra.h>
}
#endif

#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "catalogue/families/draw_stream.h"
#include "catalogue/families/numbers.h"
#include "robust/volumes/convex_hull.h"

namespace touchstone::bench {
namespace {

using Points = std::vector<Point3d>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A set of n points: uniform in a ball, on a sphere, in a box and on its faces; on a grid of 100^3; around twenty
/// centres; on a cylinder; in a plane, exactly or up to rounding; on a line; rotated so that faces are flat up to
/// rounding.
Points cloud(const std::string& set, std::size_t n) {
  catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, set.c_str(), 0));
  const auto number = [&draws] { return catalogue::ordinary(draws); };
  const auto normal = [&] {
    const double radius = std::sqrt(-2 * std::log(1 - (number() + 1) / 2 + 1e-300));
    return radius * std::cos(std::numbers::pi * number());
  };
  const auto centre = [&draws](std::size_t k) {
    return static_cast<double>((draws.below(1000) + 37 * k) % 997) / 500 - 1;
  };
  Points centres, points;
  for (std::size_t k = 0; k < 20; ++k) {
    const double x = centre(k), y = centre(2 * k);
    centres.push_back({x, y, centre(3 * k)});
  }
  while (points.size() < n) {
    const double x = number(), y = number(), z = number(), square = x * x + y * y + z * z;
    const auto thousandth = [](double t) { return std::floor(1000 * t); };
    if (set == "ball") {
      if (square <= 1) points.push_back({x, y, z});
    } else if (set == "sphere") {
      const double u = normal(), v = normal(), w = normal(), length = std::sqrt(u * u + v * v + w * w);
      points.push_back({u / length, v / length, w / length});
    } else if (set == "box") {
      points.push_back({x, y, z});
    } else if (set == "grid") {
      points.push_back({std::floor(50 * x), std::floor(50 * y), std::floor(50 * z)});
    } else if (set == "clusters") {
      const Point3d& c = centres[draws.below(centres.size())];
      const double u = normal(), v = normal();
      points.push_back({c.x + 0.02 * u, c.y + 0.02 * v, c.z + 0.02 * normal()});
    } else if (set == "box_faces" || set == "turned_box_faces") {
      double p[3] = {x, y, z};
      p[draws.below(3)] = draws.below(2) == 1 ? 1 : -1;
      if (set == "box_faces") points.push_back({p[0], p[1], p[2]});
      else
        points.push_back({0.6 * p[0] - 0.8 * p[1], 0.28 * (0.8 * p[0] + 0.6 * p[1]) - 0.96 * p[2],
                          0.96 * (0.8 * p[0] + 0.6 * p[1]) + 0.28 * p[2]});
    } else if (set == "cylinder") {
      points.push_back({std::cos(std::numbers::pi * x), std::sin(std::numbers::pi * x), y});
    } else if (set == "plane") {
      points.push_back({thousandth(x), thousandth(y), thousandth(x) + 2 * thousandth(y)});
    } else if (set == "nearly_plane") {
      points.push_back({x, y, 0.3 * x + 0.7 * y});
    } else {
      points.push_back({thousandth(x), 3 * thousandth(x), -7 * thousandth(x)});
    }
  }
  return points;
}

constexpr const char* sets[] = {"ball",     "grid",  "clusters",     "sphere", "box", "box_faces", "turned_box_faces",
                                "cylinder", "plane", "nearly_plane", "line"};

/// Keeps only the most recent cloud.
const Points& cloud_of(const std::string& set, std::size_t n) {
  static std::string made;
  static Points points;
  const std::string name = set + std::to_string(n);
  if (made != name) points = cloud(set, n), made = name;
  return points;
}

std::size_t faces_by_cgal(const Points& points) {
  std::vector<Epick::Point_3> theirs;
  theirs.reserve(points.size());
  for (const Point3d& p : points) theirs.emplace_back(p.x, p.y, p.z);
  CGAL::Surface_mesh<Epick::Point_3> mesh;
  CGAL::convex_hull_3(theirs.begin(), theirs.end(), mesh);
  return mesh.number_of_faces();
}

#ifdef TOUCHSTONE_QHULL
/// Returns 0 if it gives no hull ("initial simplex is flat").
std::size_t faces_by_qhull(const Points& points) {
  static std::FILE* const nowhere = std::fopen("/dev/null", "w");
  std::vector<double> theirs;
  theirs.reserve(3 * points.size());
  for (const Point3d& p : points) theirs.insert(theirs.end(), {p.x, p.y, p.z});
  qhT qhull{};
  qh_zero(&qhull, nowhere);
  char command[] = "qhull";
  const int failed =
      qh_new_qhull(&qhull, 3, static_cast<int>(points.size()), theirs.data(), False, command, nullptr, nowhere);
  const std::size_t faces = failed == 0 ? static_cast<std::size_t>(qhull.num_facets) : 0;
  qh_freeqhull(&qhull, qh_ALL);
  return faces;
}
#endif

template <std::size_t threads>
std::size_t faces_by_robust(const Points& points) {
  const ConvexHull hull = robust::convex_hull(points, threads);
  return hull.faces ? hull.faces->size() : hull.dimension;
}

auto add(const std::string& set, std::size_t n, const char* name, std::size_t (*faces)(const Points&)) {
  return benchmark::RegisterBenchmark(("convex_hull_" + std::to_string(n) + "/" + set + "/" + name).c_str(),
                                      [=](benchmark::State& state) {
                                        const Points& points = cloud_of(set, n);
                                        std::size_t found = 0;
                                        for (auto _ : state) found = faces(points);
                                        state.SetItemsProcessed(state.iterations());
                                        state.SetLabel(std::to_string(found));
                                      });
}

bool verified() {
  bool held = true;
  for (const char* set : {"ball", "clusters", "sphere", "box", "cylinder"}) {
    const Points& points = cloud_of(set, 100'000);
    const std::size_t ours = faces_by_robust<1>(points), theirs = faces_by_cgal(points);
    std::printf("%-10s %zu faces, by CGAL %zu\n", set, ours, theirs);
    held = held && ours == theirs;
  }
  return held;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  if (argc == 2 && std::strcmp(argv[1], "--verify") == 0) return verified() ? 0 : 1;
  for (const char* set : sets) {
    for (const std::size_t n : {100'000u, 1'000'000u}) {
      add(set, n, "robust", faces_by_robust<1>);
      if (n < 1'000'000) continue;
      add(set, n, "epick", faces_by_cgal);
      add(set, n, "robust_2_threads", faces_by_robust<2>)->UseRealTime();  // compare with its `Time`, not `CPU`
#ifdef TOUCHSTONE_QHULL
      add(set, n, "qhull", faces_by_qhull);
#endif
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
