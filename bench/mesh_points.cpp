// SPDX-License-Identifier: Apache-2.0
//
// Many points and one mesh of 82,368 faces: robust::Solid, for which point_mesh_distance finds the nearest point, both
// distances correctly rounded, the sign and the feature; and CGAL's AABB_tree with the kernel Epick, which finds a
// nearest point, or the squared distance, in doubles, and the side of the point in a call of its own. Processor time;
// trees are made before.
//
// bench/mesh_points --verify compares the squared distances without timing.

// CGAL as peer: the same question by the library that people use for it.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <string>
#include <vector>

#include "bench/globes.h"
#include "catalogue/families/numbers.h"
#include "robust/polyhedra/point_mesh_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::bench {
namespace {

using catalogue::DrawStream;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Epick, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

struct Points {
  std::vector<Point3d> ours;
  std::vector<Epick::Point_3> theirs;
};

/// Around the mesh and within it; or within a thousandth of its vertices.
Points drawn_points(std::size_t count, const Meshd& mesh, bool near) {
  DrawStream draws = DrawStream::seeded(1);
  Points points;
  while (points.ours.size() < count) {
    const double x = catalogue::ordinary(draws), y = catalogue::ordinary(draws), z = catalogue::ordinary(draws);
    const Vector3d v{x, y, z};
    const Point3d p = near ? mesh.vertices[draws.below(mesh.vertices.size())] + 1e-3 * v : Point3d{0, 0, 0} + 2.0 * v;
    points.ours.push_back(p);
    points.theirs.emplace_back(p.x, p.y, p.z);
  }
  return points;
}

struct Mesh {
  robust::Solid ours;
  Surface theirs;
  Tree tree;
  CGAL::Side_of_triangle_mesh<Surface, Epick> side;

  explicit Mesh(const char* set) : ours(mesh_of(set, 144)), theirs(bench::theirs(ours.mesh())), side(theirs) {
    tree.insert(faces(theirs).first, faces(theirs).second, theirs);
    tree.build();
    tree.accelerate_distance_queries();
    side(Epick::Point_3(0, 0, 0));
  }
};

template <class Point, class Ask>
void add(const std::string& name, const std::vector<Point>& points, const Ask& ask) {
  benchmark::RegisterBenchmark(name.c_str(), [&points, ask](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(ask(points[i]));
      i = i + 1 < points.size() ? i + 1 : 0;
    }
    state.SetItemsProcessed(state.iterations());
  });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  namespace robust = touchstone::robust;
  const bool verify = argc == 2 && std::strcmp(argv[1], "--verify") == 0;
  std::deque<Mesh> meshes;
  std::deque<Points> all;
  std::size_t different = 0;
  for (const char* set : sets) {
    const Mesh& mesh = meshes.emplace_back(set);
    for (const bool near : {false, true}) {
      const Points& points = all.emplace_back(drawn_points(verify ? 20000 : 4096, mesh.ours.mesh(), near));
      if (verify) {
        // Theirs is computed from a point of doubles: off by a few 2^-53 of the mesh's extent, in length.
        for (std::size_t i = 0; i < points.ours.size(); ++i) {
          const double exact = robust::point_mesh_distance(points.ours[i], mesh.ours).distance,
                       computed = std::sqrt(mesh.tree.squared_distance(points.theirs[i]));
          different += std::fabs(exact - computed) > 0x1p-40;
        }
        continue;
      }
      const std::string name = std::string("point_mesh_distance_82368/") + set + (near ? "/near" : "/around");
      add(name + "/robust", points.ours,
          [&mesh](const auto& p) { return robust::point_mesh_distance(p, mesh.ours).signed_distance; });
      add(name + "/epick_point", points.theirs, [&mesh](const auto& p) { return mesh.tree.closest_point(p).x(); });
      add(name + "/epick_side", points.theirs, [&mesh](const auto& p) { return mesh.side(p); });
    }
  }
  if (verify) {
    std::printf("%zu distances differ\n", different);
    return different > 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
