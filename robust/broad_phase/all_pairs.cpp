// SPDX-License-Identifier: Apache-2.0
#include "robust/broad_phase/all_pairs.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "robust/kernel/machine/parallel.h"
#include "robust/kernel/shapes/spheres.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/pairs/forest.h"
#include "robust/structures/pair_tree.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::robust {
namespace {

template <class Solid>
void validate(const char* field, const std::vector<Solid>& solids, std::size_t threads = 1) {
  std::atomic<bool> valid = true;
  kernel::ThreadParts(threads, solids.size(), 1U << 16).each([&](std::size_t, std::size_t first, std::size_t last) {
    const Solid* const own = solids.data();
    if (!std::all_of(own + first, own + last, [](const Solid& solid) { return kernel::valid(solid); })) valid = false;
  });
  if (!valid) validation::validate(field, solids);
}

}  // namespace

Decided<std::vector<IndexPair>> stages::all_pairs::ask(const std::vector<Sphere3d>& spheres) {
  validate("spheres", spheres);
  Stage latest = Stage::filter;
  const auto meet = [&latest](const Sphere3d& a, const Sphere3d& b) {
    return kernel::Reach::ask(a, b).noting(latest) >= 0;
  };
  auto pairs = structures::swept_pairs(spheres, meet);
  return {std::move(pairs), latest};
}

Decided<std::vector<IndexPair>> stages::all_pairs::ask(const std::vector<Aabb3d>& boxes, std::size_t threads) {
  if (threads == 0) threads = threads_of_machine();
  validate("boxes", boxes, threads);
  return {pairs::forest_pairs(boxes, threads), Stage::filter};
}

std::vector<IndexPair> all_pairs(const std::vector<Sphere3d>& spheres) {
  return stages::all_pairs::ask(spheres).answer;
}
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes) { return stages::all_pairs::ask(boxes).answer; }
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes, std::size_t threads) {
  return stages::all_pairs::ask(boxes, threads).answer;
}

PairsWithCertificate pairs_with_certificate(const std::vector<Aabb3d>& boxes) {
  validate("boxes", boxes);
  PairsWithCertificate result;
  structures::PairProof proof;
  result.pairs = structures::tree_pairs(boxes, &proof);
  result.order = std::move(proof.order), result.cuts = std::move(proof.cuts), result.steps = std::move(proof.steps);
  return result;
}

}  // namespace touchstone::robust
