// SPDX-License-Identifier: Apache-2.0
//
// The distance of two convex solids of 8 to 100 vertices, with nearest points: robust's, with and without its convexity
// test of the meshes, and FCL's GJK with libccd, on the same shapes, whose objects are made beforehand. And how deep
// two of them overlap: robust's, and FCL's with libccd, which finds a depth that need not be the least.
//
// bench/distances --verify compares distances and depths without timing.

#include <benchmark/benchmark.h>
#include <fcl/fcl.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "robust/kernel/solids/solid_distance.h"
#include "robust/mixed/convex_distance.h"
#include "robust/mixed/penetration.h"
#include "robust/prepared/solid.h"
#include "robust/volumes/convex_hull.h"

namespace touchstone::bench {
namespace {

/// Random points on a sphere, and the faces of their hull.
Meshd ball(std::size_t count, const Point3d& center, std::mt19937_64& bits) {
  const auto unit = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  Meshd mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const double height = 2 * unit() - 1, angle = 2 * std::numbers::pi * unit(), r = std::sqrt(1 - height * height);
    mesh.vertices.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle), center.z + height});
  }
  mesh.faces = robust::convex_hull(mesh.vertices).faces.value();
  return mesh;
}

struct Pair {
  Meshd a, b;
  std::unique_ptr<fcl::CollisionObjectd> first, second;
  std::unique_ptr<robust::ConvexSolid> solid_a, solid_b;
};

std::unique_ptr<fcl::CollisionObjectd> theirs(const Meshd& mesh) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Point3d& p : mesh.vertices) vertices->emplace_back(p.x, p.y, p.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (const Face& f : mesh.faces)
    faces->insert(faces->end(), {3, static_cast<int>(f.a), static_cast<int>(f.b), static_cast<int>(f.c)});
  return std::make_unique<fcl::CollisionObjectd>(
      std::make_shared<fcl::Convexd>(vertices, static_cast<int>(mesh.faces.size()), faces));
}

/// Solids whose middles are about so far apart; they have a radius of 1.
std::vector<Pair> pairs_of(std::size_t count, double far) {
  std::mt19937_64 bits(1);
  std::vector<Pair> pairs;
  for (int i = 0; i < 64; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(bits() >> 11) * 0x1p-53;
    Pair pair{ball(count, {0, 0, 0}, bits),
              ball(count, {far * std::cos(turn), far * std::sin(turn), 0.5}, bits),
              {},
              {},
              {},
              {}};
    pair.first = theirs(pair.a), pair.second = theirs(pair.b);
    pair.solid_a = std::make_unique<robust::ConvexSolid>(pair.a);
    pair.solid_b = std::make_unique<robust::ConvexSolid>(pair.b);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

double by_robust(const Pair& pair) { return robust::convex_distance(pair.a, pair.b).distance; }
double by_robust_of_valid(const Pair& pair) { return robust::kernel::distance_of_solids(pair.a, pair.b).distance; }
double by_fcl(const Pair& pair) {
  fcl::DistanceRequestd request(true);
  fcl::DistanceResultd result;
  return fcl::distance(pair.first.get(), pair.second.get(), request, result);
}

double depth_by_robust(const Pair& pair) { return robust::penetration(pair.a, pair.b, 0, 0).depth; }
double depth_by_robust_of_valid(const Pair& pair) {
  return robust::penetration(*pair.solid_a, *pair.solid_b, 0, 0).depth;
}
double depth_by_fcl(const Pair& pair) {
  const fcl::CollisionRequestd request(1, true);
  fcl::CollisionResultd result;
  fcl::collide(pair.first.get(), pair.second.get(), request, result);
  return result.numContacts() == 0 ? 0 : result.getContact(0).penetration_depth;
}

void add(const std::string& name, const std::vector<Pair>& pairs, double (*ask)(const Pair&)) {
  benchmark::RegisterBenchmark(name.c_str(), [&pairs, ask](benchmark::State& state) {
    std::size_t next = 0;
    for (auto _ : state) benchmark::DoNotOptimize(ask(pairs[next++ % pairs.size()]));
    state.SetItemsProcessed(state.iterations());
  });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  const bool verify = argc == 2 && std::strcmp(argv[1], "--verify") == 0;
  static std::vector<std::vector<Pair>> sets, overlapping;
  const std::size_t counts[] = {8, 32, 100};
  for (const std::size_t count : counts)
    sets.push_back(pairs_of(count, 3)), overlapping.push_back(pairs_of(count, 0.25));
  for (std::size_t i = 0; i < sets.size(); ++i) {
    double most = 0;
    for (const Pair& pair : sets[i]) most = std::fmax(most, std::fabs(by_fcl(pair) / by_robust(pair) - 1));
    if (verify) std::printf("%3zu vertices: FCL is off by %.3g of the distance at most\n", counts[i], most);
    const std::string name = "convex_distance_" + std::to_string(counts[i]) + "/";
    add(name + "robust", sets[i], by_robust), add(name + "robust_of_valid", sets[i], by_robust_of_valid);
    add(name + "fcl", sets[i], by_fcl);
    double deepest = 0;
    for (const Pair& pair : overlapping[i])
      deepest = std::fmax(deepest, std::fabs(depth_by_fcl(pair) / depth_by_robust(pair) - 1));
    if (verify) std::printf("%3zu vertices: FCL is off by %.3g of the depth at most\n", counts[i], deepest);
    const std::string depth = "penetration_" + std::to_string(counts[i]) + "/";
    add(depth + "robust", overlapping[i], depth_by_robust);
    add(depth + "robust_of_valid", overlapping[i], depth_by_robust_of_valid);
    add(depth + "fcl", overlapping[i], depth_by_fcl);
  }
  if (verify) return 0;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
