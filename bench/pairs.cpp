// SPDX-License-Identifier: Apache-2.0
//
// All pairs of boxes that meet: robust's sorted list, the list with its certificate, the check of the certificate, and
// CGAL's box_self_intersection_d, which only counts, in processor time; and a BoxTree in which a tenth of the boxes has
// moved.
//
// bench/pairs --verify compares the counts, and the lists with and without a certificate, checks the certificates and
// prints their size, without timing.
// TOUCHSTONE_BOXES=FILE adds the boxes of a real scene: one a line, "min.x min.y min.z max.x max.y max.z".

// CGAL as peer: the same question by the library that people use for it.
#include <CGAL/box_intersection_d.h>
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "bench/box_sets.h"
#include "oracle/certificates/check_pair_tree.h"
#include "robust/broad_phase/all_pairs.h"
#include "robust/structures/box_tree.h"

namespace touchstone::bench {
namespace {

using Boxes = std::vector<Aabb3d>;
using Proof = robust::PairsWithCertificate;

std::size_t counted_by_cgal(const Boxes& boxes) {
  using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Aabb3d*>;
  std::vector<Box> theirs;
  theirs.reserve(boxes.size());
  for (const Aabb3d& box : boxes) {
    const auto& [p, q] = box;
    theirs.emplace_back(CGAL::Bbox_3(p.x, p.y, p.z, q.x, q.y, q.z), &box);
  }
  std::vector<const Box*> pointers;
  pointers.reserve(boxes.size());
  for (const Box& box : theirs) pointers.push_back(&box);
  std::size_t count = 0;
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), [&count](const Box*, const Box*) { ++count; });
  return count;
}

/// Throws if the proof does not hold.
void check(const Boxes& boxes, const Proof& proof) {
  static_assert(sizeof(Aabb3d) == 6 * sizeof(double) && sizeof(IndexPair) == 2 * sizeof(std::uint32_t));
  certify::check_pair_tree(certify::PairTreeClaim{{&boxes[0].min.x, 6 * boxes.size()},
                                                  {&proof.pairs.data()->i, 2 * proof.pairs.size()},
                                                  proof.order,
                                                  proof.cuts,
                                                  proof.steps});
}

double bytes_a_box(const Proof& proof) {
  const std::size_t bytes = 4 * proof.order.size() + 4 * proof.cuts.size() + proof.steps.size();
  return static_cast<double>(bytes) / static_cast<double>(proof.order.size());
}

robust::BoxTree tree_of(const Boxes& boxes) {
  robust::BoxTree tree;
  for (const Aabb3d& box : boxes) tree.insert(box);
  return tree;
}

/// Moves a tenth of the bodies by up to half their size, back and forth.
void move_some(robust::BoxTree& tree, const Boxes& boxes, bool forth) {
  BoxNumbers draw(1);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (draw.below(10) > 0) continue;
    Aabb3d box = boxes[i];
    const double by = forth ? 0.5 * draw.unit() * (box.max.x - box.min.x) : 0;
    box.min.x += by, box.max.x += by;
    tree.move(static_cast<Index>(i), box);
  }
}

constexpr const char* scene = "scene";

/// Throws if a line is not a box.
Boxes boxes_of_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  Boxes boxes;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream words(line);
    Aabb3d box;
    std::string more;
    for (double* x : {&box.min.x, &box.min.y, &box.min.z, &box.max.x, &box.max.y, &box.max.z}) words >> *x;
    if (!words || words >> more || box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z)
      throw std::runtime_error(path + ":" + std::to_string(number) + ": six numbers, min <= max");
    boxes.push_back(box);
  }
  if (boxes.empty()) throw std::runtime_error(path + ": at least one box");
  return boxes;
}

/// Made on first use and replaced when another list is asked for: a list of a million takes long to draw.
const Boxes& boxes_of(const std::string& set, std::size_t n) {
  static std::string held;
  static Boxes boxes;
  const std::string name = set + std::to_string(n);
  if (held != name)
    boxes = set == scene ? boxes_of_file(std::getenv("TOUCHSTONE_BOXES")) : box_set(set, n, 3), held = name;
  return boxes;
}

template <class Work>
void add(const char* set, std::size_t n, const char* name, const Work& work) {
  const std::string group = "all_pairs_" + std::to_string(n) + "/" + set + "/" + name;
  benchmark::RegisterBenchmark(group.c_str(), [=](benchmark::State& state) {
    const Boxes& boxes = boxes_of(set, n);
    work(state, boxes);
    state.SetItemsProcessed(state.iterations());
  });
}

void add_all(const char* set, std::size_t n) {
  add(set, n, "robust", [](benchmark::State& state, const Boxes& boxes) {
    std::size_t count = 0;
    for (auto _ : state) count = robust::all_pairs(boxes).size();
    state.SetLabel(std::to_string(count));
  });
  add(set, n, "certificate", [](benchmark::State& state, const Boxes& boxes) {
    double bytes = 0;
    for (auto _ : state) bytes = bytes_a_box(robust::pairs_with_certificate(boxes));
    char label[32];
    std::snprintf(label, sizeof label, "%.1f", bytes);
    state.SetLabel(label);
  });
  add(set, n, "check", [](benchmark::State& state, const Boxes& boxes) {
    const Proof proof = robust::pairs_with_certificate(boxes);
    for (auto _ : state) check(boxes, proof);
  });
  add(set, n, "cgal", [](benchmark::State& state, const Boxes& boxes) {
    std::size_t count = 0;
    for (auto _ : state) count = counted_by_cgal(boxes);
    state.SetLabel(std::to_string(count));
  });
  if (std::strcmp(set, "uniform") != 0) return;
  add(set, n, "tree_anew", [](benchmark::State& state, const Boxes& boxes) {
    for (auto _ : state) benchmark::DoNotOptimize(tree_of(boxes).pairs());
  });
  add(set, n, "tree_moved", [](benchmark::State& state, const Boxes& boxes) {
    robust::BoxTree tree = tree_of(boxes);
    bool forth = false;
    for (auto _ : state) {
      move_some(tree, boxes, forth = !forth);
      benchmark::DoNotOptimize(tree.pairs());
    }
  });
}

constexpr std::array timed_sets{"uniform", "clustered", "six_orders", "nine_orders", "one_huge",
                                "lattice", "nested",    "sticks",     "flat",        "duplicates"};
/// The longest list: sticks take n^1.5, and the more boxes lie in one plane, the more often they meet.
std::size_t most(const std::string& set) { return set == "flat" || set == "sticks" ? 100'000 : 1'000'000; }

bool verified(const char* set, std::size_t n) {
  const Boxes& boxes = boxes_of(set, n);
  const Proof proof = robust::pairs_with_certificate(boxes);
  check(boxes, proof);
  const std::size_t by_cgal = counted_by_cgal(boxes);
  const bool same = robust::all_pairs(boxes) == proof.pairs;
  std::printf("%-12s %8zu boxes, pairs: robust %zu, CGAL %zu; certificate %.1f bytes a box; without it %s\n", set, n,
              proof.pairs.size(), by_cgal, bytes_a_box(proof), same ? "the same" : "OTHER PAIRS");
  return same && proof.pairs.size() == by_cgal;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  const bool verify = argc == 2 && std::strcmp(argv[1], "--verify") == 0;
  bool held = true;
  for (const char* set : timed_sets) {
    for (std::size_t n = 10'000; n <= most(set); n *= 10) {
      if (verify) held = verified(set, n) && held;
      else add_all(set, n);
    }
  }
  if (const char* file = std::getenv("TOUCHSTONE_BOXES")) {
    try {
      const std::size_t n = boxes_of_file(file).size();
      if (verify) held = verified(scene, n) && held;
      else add_all(scene, n);
    } catch (const std::runtime_error& error) {
      std::fprintf(stderr, "bench/pairs: %s\n", error.what());
      return 2;
    }
  }
  if (verify) return held ? 0 : 1;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
