// SPDX-License-Identifier: Apache-2.0
//
// Tests whether a mesh of a thousand to a million faces is embedded: robust's polyhedron_complexity with all its other
// answers, and CGAL's does_self_intersect with the kernel Epick, on one mesh, in processor time.
//
// bench/meshes --verify compares their answers without timing.

// CGAL as peer: the same question by the library that people use for it.
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "bench/globes.h"
#include "robust/polyhedra/polyhedron_complexity.h"

namespace touchstone::bench {
namespace {

bool embedded_by_robust(const Meshd& mesh) { return robust::polyhedron_complexity(mesh).embedded; }
bool embedded_by_cgal(const Surface& surface) {
  return !CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Sequential_tag>(surface);
}

template <class Mesh>
void add(const std::string& group, const char* name, const Mesh& mesh, bool (*embedded)(const Mesh&)) {
  benchmark::RegisterBenchmark((group + name).c_str(), [=](benchmark::State& state) {
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
  for (const auto& [faces, n] : sizes) {
    for (const char* set : sets) {
      const touchstone::Meshd mesh = mesh_of(set, n);
      const Surface surface = theirs(mesh);
      if (verify) {
        const bool ours = embedded_by_robust(mesh), by_cgal = embedded_by_cgal(surface);
        std::printf("%-12s of %zu faces: robust %d, CGAL %d\n", set, faces, ours, by_cgal);
        held = held && ours == by_cgal;
      } else {
        const std::string group = "polyhedron_complexity_" + std::to_string(faces) + "/" + set + "/";
        add(group, "robust", mesh, embedded_by_robust), add(group, "epick", surface, embedded_by_cgal);
      }
    }
  }
  if (verify) return held ? 0 : 1;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
