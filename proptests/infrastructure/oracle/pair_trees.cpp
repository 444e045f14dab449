// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "bench/box_sets.h"
#include "oracle/certificates/check.h"
#include "oracle/certificates/check_packed.h"
#include "oracle/certificates/check_pair_tree.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"
#include "robust/broad_phase/all_pairs.h"
#include "robust/pairs/forest.h"

/// All pairs of boxes and the certificate that none is missing: against brute force, and against tampering.
namespace touchstone::proptests::pair_trees_tests {
namespace {

using bench::box_set;
using bench::box_sets;
using bench::BoxNumbers;
using Boxes = std::vector<Aabb3d>;
using Pairs = std::vector<IndexPair>;
using Proof = robust::PairsWithCertificate;

bool overlap(double low, double high, double other_low, double other_high) {
  return low <= other_high && other_low <= high;
}
bool meet(const Aabb3d& a, const Aabb3d& b) {
  return overlap(a.min.x, a.max.x, b.min.x, b.max.x) && overlap(a.min.y, a.max.y, b.min.y, b.max.y) &&
         overlap(a.min.z, a.max.z, b.min.z, b.max.z);
}

Pairs by_brute_force(const Boxes& boxes) {
  Pairs pairs;
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index j = i + 1; j < boxes.size(); ++j)
      if (meet(boxes[i], boxes[j])) pairs.push_back({i, j});
  return pairs;
}

std::vector<double> numbers_of(const Boxes& boxes) {
  std::vector<double> numbers;
  for (const auto& [p, q] : boxes) numbers.insert(numbers.end(), {p.x, p.y, p.z, q.x, q.y, q.z});
  return numbers;
}
std::vector<std::uint32_t> indices_of(const Pairs& pairs) {
  std::vector<std::uint32_t> indices;
  for (const IndexPair& pair : pairs) indices.insert(indices.end(), {pair.i, pair.j});
  return indices;
}

/// "" if the claim is accepted.
std::string verdict(const Boxes& boxes, const Pairs& pairs, const Proof& proof) {
  try {
    const auto numbers = numbers_of(boxes);
    const auto indices = indices_of(pairs);
    certify::check_pair_tree(certify::PairTreeClaim{numbers, indices, proof.order, proof.cuts, proof.steps});
    return "";
  } catch (const certify::Refusal& refusal) {
    return refusal.what();
  }
}

nlohmann::json claim_of(const Boxes& boxes, const Pairs& pairs, const Proof& proof) {
  using certify::packed;
  return {{"op", "all_pairs"},
          {"input", {{"boxes", packed(numbers_of(boxes))}}},
          {"truth", {{"pairs", packed(indices_of(pairs))}}},
          {"certificate",
           {{"kind", "tree"},
            {"order", packed(proof.order)},
            {"cuts", packed(proof.cuts)},
            {"steps", packed(proof.steps)}}}};
}

template <class List>
auto& any_of(List& list, BoxNumbers& draw) {
  return list[draw.below(list.size())];
}

/// One change of the certificate, which may leave it valid.
void bend(Proof& proof, BoxNumbers& draw) {
  auto& [pairs, order, cuts, steps] = proof;
  switch (draw.below(8)) {
    case 0:
      if (!steps.empty()) any_of(steps, draw) ^= static_cast<std::uint8_t>(1 + draw.below(255));
      break;
    case 1:
      if (!steps.empty()) any_of(steps, draw) &= static_cast<std::uint8_t>(~(3U << (2 * draw.below(4))));
      break;
    case 2: any_of(cuts, draw) += static_cast<Index>(draw.below(5)) - 2; break;
    case 3:
    case 4: {
      Index &one = any_of(order, draw), &other = any_of(order, draw);
      if (draw.below(4) == 0) one = other;
      else std::swap(one, other);
      break;
    }
    case 5: {
      const std::size_t from = draw.below(order.size()), to = draw.below(order.size());
      for (std::size_t k = 0; k < 8 && from + k < order.size() && to + k < order.size(); ++k)
        std::swap(order[from + k], order[to + k]);
      break;
    }
    case 6: {
      Index &one = any_of(cuts, draw), &other = any_of(cuts, draw);
      std::swap(one, other);
      break;
    }
    default: {
      const std::size_t which = draw.below(3);
      if (which == 0 && !order.empty()) order.pop_back();
      if (which == 1 && !cuts.empty()) cuts.pop_back();
      if (which == 2 && !steps.empty()) steps.pop_back();
    }
  }
  if (order.empty()) order.push_back(0);
  if (cuts.empty()) cuts.push_back(0);
}

void sort(Pairs& pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const IndexPair& p, const IndexPair& q) {
    return std::pair{p.i, p.j} < std::pair{q.i, q.j};
  });
}

/// Lists that are not the truth.
std::vector<Pairs> wrong_lists(const Boxes& boxes, const Pairs& truth, BoxNumbers& draw) {
  std::vector<Pairs> wrong;
  const auto add = [&](Pairs pairs) {
    if (pairs != truth) wrong.push_back(std::move(pairs));
  };
  if (!truth.empty()) {
    Pairs pairs = truth;
    pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(draw.below(pairs.size())));
    add(pairs), pairs = truth;
    any_of(pairs, draw) = any_of(truth, draw), sort(pairs);
    add(pairs), pairs = truth;
    pairs.push_back(any_of(truth, draw)), sort(pairs);
    add(pairs), pairs = truth;
    std::reverse(pairs.begin(), pairs.end());
    add(pairs), pairs = truth;
    IndexPair& pair = any_of(pairs, draw);
    std::swap(pair.i, pair.j);
    add(pairs);
  }
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<Index>(draw.below(boxes.size())), j = static_cast<Index>(draw.below(boxes.size()));
    if (i >= j || meet(boxes[i], boxes[j])) continue;
    Pairs pairs = truth;
    pairs.push_back({i, j}), sort(pairs);
    add(pairs), pairs = truth;
    if (!pairs.empty()) any_of(pairs, draw) = {i, j}, sort(pairs);
    add(pairs);
  }
  return wrong;
}

}  // namespace

TEST_CASE("pairs of boxes: those that brute force finds, with a certificate that holds") {
  std::size_t found = 0;
  for (const char* set : box_sets) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      BoxNumbers draw(seed);
      const std::size_t n = seed < 20 ? seed : seed == 59 ? 1500 : 20 + draw.below(300);
      const Boxes boxes = box_set(set, n, seed);
      const Pairs truth = by_brute_force(boxes);
      const Proof proof = robust::pairs_with_certificate(boxes);
      CAPTURE(set, seed, n);
      CHECK(proof.pairs == truth);
      CHECK(robust::all_pairs(boxes) == truth);
      CHECK(verdict(boxes, truth, proof) == "");
      found += truth.size();
    }
  }
  CHECK(found > 1'000'000);
}

TEST_CASE("pairs of boxes: every instruction set finds those that brute force finds") {
  for (const char* set : box_sets) {
    for (const std::size_t n : {2U, 9U, 16U, 17U, 64U, 65U, 700U}) {
      const Boxes boxes = box_set(set, n, 7);
      const Pairs truth = by_brute_force(boxes);
      for (const auto most : {robust::batch::Instructions::portable, robust::batch::Instructions::avx2,
                              robust::batch::Instructions::avx512}) {
        CAPTURE(set, n, most);
        CHECK(robust::pairs::forest_pairs(boxes, 1, most) == truth);
      }
    }
  }
}

TEST_CASE("pairs of boxes: threads change nothing") {
  for (const char* set : {"uniform", "clustered", "six_orders", "one_huge", "lattice", "sticks", "duplicates"}) {
    const Boxes boxes = box_set(set, 70'000, 11);
    const Pairs alone = robust::all_pairs(boxes);
    for (const std::size_t threads : {0U, 2U, 3U, 4U}) {
      CAPTURE(set, threads);
      CHECK(robust::all_pairs(boxes, threads) == alone);
    }
  }
}

TEST_CASE("pairs of boxes: threads agree whether coarse integers tell all coordinates apart") {
  // A grid of boxes that touch, for one thread; another far away, for the next, whose boxes are a bit apart.
  Boxes boxes;
  for (const double far : {0.0, 1024.0}) {
    const double gap = far == 0 ? 0 : 0x1p-30;
    for (int i = 0; i < 27'000; ++i) {
      const Point3d p{far + i % 30, static_cast<double>(i / 30 % 30), static_cast<double>(i / 900)};
      boxes.push_back({{p.x + gap, p.y + gap, p.z + gap}, {p.x + 1, p.y + 1, p.z + 1}});
    }
  }
  const Pairs alone = robust::all_pairs(boxes);
  CHECK(alone.size() == 3 * 29 * 30 * 30 + 6 * 29 * 29 * 30 + 4 * 29 * 29 * 29);
  for (const std::size_t threads : {2U, 3U}) CHECK(robust::all_pairs(boxes, threads) == alone);
}

TEST_CASE("pairs of boxes: small and large ones, far from 0, and many that touch or are a bit apart") {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    BoxNumbers draw(seed);
    const std::size_t n = 2 + draw.below(200), cells = 1 + draw.below(30);
    const double unit = std::ldexp(1.0, static_cast<int>(draw.below(3)) * 500 - 500);
    const double from = draw.below(2) == 0 ? 0 : 0x1p40 * unit, gap = draw.below(2) == 0 ? 0 : 0x1p-12 * unit;
    Boxes boxes;
    for (std::size_t i = 0; i < n; ++i) {
      std::array<double, 6> ends{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t wide = draw.below(8) == 0 ? draw.below(2 * cells) : draw.below(2);
        ends[k] = from + unit * static_cast<double>(draw.below(cells));
        ends[3 + k] = ends[k] + unit * static_cast<double>(wide);
        if (draw.below(2) == 0) ends[k] += gap;
      }
      for (std::size_t k = 0; k < 3; ++k) ends[3 + k] = std::max(ends[k], ends[3 + k]);
      boxes.push_back({{ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]}});
    }
    const Pairs truth = by_brute_force(boxes);
    CAPTURE(seed, n, cells);
    CHECK(robust::all_pairs(boxes) == truth);
    found += truth.size();
  }
  CHECK(found > 10'000);
}

TEST_CASE("pairs of boxes: no wrong list has a certificate, however it is bent") {
  std::size_t refused = 0, bent_and_right = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    BoxNumbers draw(seed);
    const char* const set = box_sets[draw.below(box_sets.size())];
    const Boxes boxes = box_set(set, 12 + draw.below(120), seed);
    const Proof proof = robust::pairs_with_certificate(boxes);
    const std::vector<Pairs> wrong = wrong_lists(boxes, proof.pairs, draw);
    for (const Pairs& pairs : wrong) CHECK(verdict(boxes, pairs, proof) != "");
    for (int k = 0; k < 4; ++k) {
      Proof bent = proof;
      for (std::size_t times = 1 + draw.below(3); times > 0; --times) bend(bent, draw);
      for (const Pairs& pairs : wrong) {
        CAPTURE(set, seed);
        CHECK(verdict(boxes, pairs, bent) != "");
        ++refused;
      }
      if (verdict(boxes, proof.pairs, bent).empty()) ++bent_and_right;
    }
    Boxes moved = boxes;  // under the list
    any_of(moved, draw) = any_of(boxes, draw);
    if (by_brute_force(moved) != proof.pairs) CHECK(verdict(moved, proof.pairs, proof) != "");
  }
  CHECK(refused > 10'000);
  CHECK(bent_and_right < 2'000);
}

TEST_CASE("pairs of boxes: a tree may be 4096 deep and no deeper") {
  const auto verdict_of_depth = [](Index depth) {
    Boxes boxes;
    Proof proof;
    for (Index k = 0; k <= depth; ++k) {
      const double x = 2.0 * k;
      boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}}), proof.order.push_back(k);
      if (k < depth) proof.cuts.insert(proof.cuts.end(), {1, 0});
    }
    proof.cuts.push_back(0);
    proof.steps.assign((depth + 3) / 4, 0);
    return verdict(boxes, {}, proof);
  };
  CHECK(verdict_of_depth(4096) == "");
  CHECK(verdict_of_depth(4097) == "certificate: the tree is too deep");
}

TEST_CASE("pairs of boxes: both checkers judge claims alike, the true, the wrong and the bent") {
  std::vector<std::string> claims, verdicts;
  const auto show = [&](const nlohmann::json& claim) {
    claims.push_back(claim.dump()), verdicts.push_back(certify::refuse(claim).value_or("accepted"));
  };
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    BoxNumbers draw(seed);
    const Boxes boxes =
        box_set(box_sets[seed % box_sets.size()], draw.below(4) == 0 ? seed % 3 : 9 + draw.below(60), seed);
    const Proof proof = robust::pairs_with_certificate(boxes);
    show(claim_of(boxes, proof.pairs, proof));
    CHECK(verdicts.back() == "accepted");
    if (boxes.empty()) continue;
    for (const Pairs& pairs : wrong_lists(boxes, proof.pairs, draw)) show(claim_of(boxes, pairs, proof));
    for (int k = 0; k < 6; ++k) {
      Proof bent = proof;
      bend(bent, draw);
      show(claim_of(boxes, proof.pairs, bent));
      nlohmann::json broken = claims.empty() ? nlohmann::json() : claim_of(boxes, proof.pairs, proof);
      auto& field = draw.below(2) == 0 ? broken["certificate"]["cuts"] : broken["input"]["boxes"];
      std::string text = field.get<std::string>();
      text[draw.below(text.size())] = "A=/-\n"[draw.below(5)];
      field = text;
      show(broken);
    }
  }
  CHECK(claims.size() > 1'500);
  const LinesInFile all_claims("pairs.jsonl", claims), all_verdicts("verdicts.txt", verdicts);
  CHECK(python_finds_nothing("proptests/infrastructure/oracle/checkers_agree.py " + all_claims.path() + " " +
                             all_verdicts.path()));
}

}  // namespace touchstone::proptests::pair_trees_tests
