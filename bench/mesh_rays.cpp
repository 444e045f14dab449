// SPDX-License-Identifier: Apache-2.0
//
// Many rays on one mesh of a thousand to a million faces: robust::Surface, which finds the first face, t and point
// correctly rounded, and the number of faces that are met; CGAL's AABB_tree with the kernel Epick, which finds the
// first face and counts in two calls; and Embree in floats with its robust flag, which finds the first face. `any` is
// whether there is one at all. Processor time; trees are made before; `made` is how long ours takes to make.
//
// bench/mesh_rays --verify compares the counts without timing.

// CGAL as peer: the same question by the library that people use for it.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <deque>
#include <string>
#include <vector>

#ifdef TOUCHSTONE_BENCH_EMBREE
#include "bench/embree_peer.h"
#endif
#include "bench/globes.h"
#include "catalogue/families/numbers.h"
#include "robust/polyhedra/ray_mesh.h"
#include "robust/prepared/surface.h"

namespace touchstone::bench {
namespace {

using catalogue::DrawStream;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Epick, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

struct Rays {
  std::vector<Ray3d> ours;
  std::vector<Epick::Ray_3> theirs;
};

/// From points around the mesh to points within it, in directions of any length.
Rays drawn_rays(std::size_t count) {
  DrawStream draws = DrawStream::seeded(1);
  Rays rays;
  const auto point = [&draws](double size) {
    const double x = catalogue::ordinary(draws), y = catalogue::ordinary(draws), z = catalogue::ordinary(draws);
    return Point3d{size * x, size * y, size * z};
  };
  while (rays.ours.size() < count) {
    const Point3d from = point(3), to = point(1);
    const Vector3d v = to - from;
    rays.ours.push_back({from, v});
    rays.theirs.emplace_back(Epick::Point_3(from.x, from.y, from.z), Epick::Vector_3(v.x, v.y, v.z));
  }
  return rays;
}

struct Mesh {
  Meshd ours;
  Surface theirs;
  Tree tree;

  Mesh(const char* set, Index n) : ours(mesh_of(set, n)), theirs(bench::theirs(ours)) {
    tree.insert(faces(theirs).first, faces(theirs).second, theirs);
    tree.build();
  }
};

template <class Ray, class Cast>
void add(const std::string& name, const std::vector<Ray>& rays, const Cast& cast) {
  benchmark::RegisterBenchmark(name.c_str(), [&rays, cast](benchmark::State& state) {
    std::size_t i = 0, met = 0;
    for (auto _ : state) {
      met += cast(rays[i]);
      i = i + 1 < rays.size() ? i + 1 : 0;
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["met"] = static_cast<double>(met) / static_cast<double>(state.iterations());
  });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  namespace robust = touchstone::robust;
  const bool verify = argc == 2 && std::strcmp(argv[1], "--verify") == 0;
  const Rays rays = drawn_rays(verify ? 20000 : 4096);
  std::deque<Mesh> meshes;
  std::deque<robust::Surface> trees;
#ifdef TOUCHSTONE_BENCH_EMBREE
  std::deque<EmbreeMesh> by_embree;
#endif
  std::size_t different = 0;
  const auto first_by_cgal = [](const Mesh& mesh, const auto& ray) {
    return mesh.tree.first_intersection(ray).has_value() ? 1U : 0U;
  };
  for (const auto& [faces, n] : sizes) {
    for (const char* set : sets) {
      const Mesh& mesh = meshes.emplace_back(set, n);
      const robust::Surface& tree = trees.emplace_back(mesh.ours);
      if (verify) {
        for (std::size_t i = 0; i < rays.ours.size(); ++i)
          different += robust::ray_mesh(rays.ours[i], tree).faces_met !=
                       mesh.tree.number_of_intersected_primitives(rays.theirs[i]);
        continue;
      }
      const std::string name = "ray_mesh_" + std::to_string(faces) + "/" + set;
      add(name + "/robust", rays.ours, [&tree](const auto& ray) { return robust::ray_mesh(ray, tree).faces_met; });
      add(name + "/any", rays.ours, [&tree](const auto& ray) {
        return robust::ray_mesh_relation(ray, tree) == touchstone::PassageRelation::hit ? 1U : 0U;
      });
#ifdef TOUCHSTONE_BENCH_EMBREE
      const EmbreeMesh& embree = by_embree.emplace_back(mesh.ours);
      add(name + "/embree", rays.ours, [&embree](const auto& ray) { return embree.first(ray) ? 1U : 0U; });
      add(name + "/embree_any", rays.ours, [&embree](const auto& ray) { return embree.any(ray) ? 1U : 0U; });
#endif
      add(name + "/epick_first", rays.theirs,
          [&mesh, first_by_cgal](const auto& ray) { return first_by_cgal(mesh, ray); });
      add(name + "/epick", rays.theirs, [&mesh, first_by_cgal](const auto& ray) {
        return first_by_cgal(mesh, ray) * mesh.tree.number_of_intersected_primitives(ray);
      });
      benchmark::RegisterBenchmark((name + "/made").c_str(), [&mesh](benchmark::State& state) {
        for (auto _ : state) benchmark::DoNotOptimize(robust::Surface(mesh.ours));
      });
    }
  }
  if (verify) {
    std::printf("%zu counts differ\n", different);
    return different > 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
