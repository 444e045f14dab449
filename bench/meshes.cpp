// SPDX-License-Identifier: Apache-2.0
//
// Tests whether a mesh of many faces is embedded: robust's polyhedron_complexity with all its other answers, and CGAL's
// does_self_intersect with the kernel Epick, on one mesh, in processor time.
//
// bench/meshes --verify compares their answers without timing.

// CGAL as peer: the same question by the library that people use for it.
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "bench/globes.h"
#include "robust/polyhedra/polyhedron_complexity.h"

namespace touchstone::bench {
namespace {

/// A sphere; a sphere with bumps; and the sphere's points moved out to a cube, with faces that are flat and oblique up
/// to rounding.
Meshd mesh_of(const std::string& set, Index n) {
  return globe(n, [&set](double height, double angle) {
    if (set == "bumps") return on_sphere(height, angle, 1 + 0.2 * std::sin(7 * height) * std::sin(5 * angle));
    const Point3d p = on_sphere(height, angle, 1);
    if (set == "sphere") return p;
    const double size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const Point3d q{p.x / size, p.y / size, p.z / size};
    return Point3d{0.6 * q.x - 0.8 * q.y, 0.28 * (0.8 * q.x + 0.6 * q.y) - 0.96 * q.z,
                   0.96 * (0.8 * q.x + 0.6 * q.y) + 0.28 * q.z};
  });
}

constexpr const char* sets[] = {"sphere", "bumps", "turned_cube"};

bool embedded_by_robust(const Meshd& mesh) { return robust::polyhedron_complexity(mesh).embedded; }
bool embedded_by_cgal(const Surface& surface) {
  return !CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Sequential_tag>(surface);
}

template <class Mesh>
void add(const std::string& set, const char* name, const Mesh& mesh, bool (*embedded)(const Mesh&)) {
  benchmark::RegisterBenchmark(("polyhedron_complexity_100000/" + set + "/" + name).c_str(),
                               [=](benchmark::State& state) {
                                 bool found = false;
                                 for (auto _ : state) found = embedded(mesh);
                                 state.SetItemsProcessed(state.iterations());
                                 state.SetLabel(found ? "embedded" : "not");
                               });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  const bool verify = argc == 2 && std::strcmp(argv[1], "--verify") == 0;
  bool held = true;
  for (const char* set : sets) {
    const touchstone::Meshd mesh = mesh_of(set, 158);  // 99,224 faces
    const Surface surface = theirs(mesh);
    if (verify) {
      const bool ours = embedded_by_robust(mesh), by_cgal = embedded_by_cgal(surface);
      std::printf("%-12s robust %d, CGAL %d\n", set, ours, by_cgal);
      held = held && ours == by_cgal;
    } else {
      add(set, "robust", mesh, embedded_by_robust), add(set, "epick", surface, embedded_by_cgal);
    }
  }
  if (verify) return held ? 0 : 1;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
