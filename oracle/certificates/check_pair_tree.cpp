// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_pair_tree.h"

#include <cmath>
#include <vector>

#include "oracle/certificates/check_packed.h"

/// The boxes of a long list that meet. The checks compare only doubles, which is exact. The checks, and why they prove
/// it:
///
/// The pairs are sorted, so that none is listed twice, and each of them meets. The order names each box once. A cut
/// divides the boxes of a node into two parts that are not empty; so each box is in one leaf. The box around each node
/// is computed here, the claim has no say in it. Then the pairs within a node are those within its first child, within
/// its second, and across the two; across two nodes that are apart no pair meets; across others, one of them is opened,
/// whose children have all its boxes, or both are leaves and every pair is compared. So every pair of the list is
/// settled once, and those that meet are counted. They are as many as are listed, and all listed ones meet: none is
/// missing.
namespace touchstone::certify {
namespace {

struct PairBox {
  double min[3], max[3];
};

bool meet(const PairBox& a, const PairBox& b) {
  // A single branch: the axis on which two boxes are apart is unpredictable.
  return (static_cast<int>(a.min[0] <= b.max[0]) & static_cast<int>(b.min[0] <= a.max[0]) &
          static_cast<int>(a.min[1] <= b.max[1]) & static_cast<int>(b.min[1] <= a.max[1]) &
          static_cast<int>(a.min[2] <= b.max[2]) & static_cast<int>(b.min[2] <= a.max[2])) != 0;
}

void enlarge(PairBox& box, const PairBox& by) {
  for (int k = 0; k < 3; ++k) {
    box.min[k] = by.min[k] < box.min[k] ? by.min[k] : box.min[k];
    box.max[k] = by.max[k] > box.max[k] ? by.max[k] : box.max[k];
  }
}

/// Builds no text for each, which would be slow for a million boxes.
template <class Reason>
void expect_of(bool holds, const Reason& reason) {
  if (!holds) throw Refusal(reason());
}

class PairTreeCheck {
 public:
  explicit PairTreeCheck(const PairTreeClaim& claim) : claim_(claim), size_(claim.boxes.size() / 6) {
    expect(claim.boxes.size() % 6 == 0, "boxes: six numbers a box");
    expect_valid();
  }

  void check() {
    expect_pairs_meet();
    read_order();
    if (size_ > 0) {
      nodes_.reserve(claim_.cuts.size());
      read_tree(0, size_, 0);
    }
    expect(nodes_.size() == claim_.cuts.size(), "certificate: the tree has too many nodes");
    if (size_ > 0) search_within(0);
    expect((step_ + 3) / 4 == claim_.steps.size() && (step_ % 4 == 0 || claim_.steps.back() >> (2 * (step_ % 4)) == 0),
           "certificate: too many steps");
    expect(found_ == claim_.pairs.size() / 2, "truth: a pair is missing");
  }

 private:
  static constexpr std::size_t largest_leaf = 16, deepest = 4096;
  struct Node {
    PairBox box;
    std::uint32_t begin, end, second;  ///< the first child is the next node; second == 0: a leaf
  };

  PairBox box(std::size_t i) const {
    const double* n = &claim_.boxes[6 * i];
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  }

  void expect_valid() const {
    const auto named = [](std::size_t n, const char* end, const char* rule) {
      return "boxes[" + std::to_string(n / 6) + "]." + end + "[" + std::to_string(n % 3) + "]: " + rule;
    };
    for (std::size_t n = 0; n < claim_.boxes.size(); ++n)
      expect_of(std::isfinite(claim_.boxes[n]), [&] { return named(n, n % 6 < 3 ? "min" : "max", "finite number"); });
    for (std::size_t n = 0; n < claim_.boxes.size(); ++n)
      expect_of(n % 6 < 3 || claim_.boxes[n - 3] <= claim_.boxes[n], [&] { return named(n, "max", "min <= max"); });
  }

  void expect_pairs_meet() const {
    expect(claim_.pairs.size() % 2 == 0, "truth.pairs: two indices a pair");
    for (std::size_t k = 0; k < claim_.pairs.size(); k += 2) {
      const std::uint32_t i = claim_.pairs[k], j = claim_.pairs[k + 1];
      if (i >= size_ || j >= size_) throw Refusal("truth.pairs: not an index");
      const bool later = k == 0 || claim_.pairs[k - 2] < i || (claim_.pairs[k - 2] == i && claim_.pairs[k - 1] < j);
      if (i >= j || !later) throw Refusal("truth: the pairs are not sorted");
      if (!meet(box(i), box(j))) throw Refusal("truth: a pair does not meet");
    }
  }

  void read_order() {
    std::vector<bool> seen(size_);
    ordered_.reserve(size_);
    for (const std::uint32_t i : claim_.order) {
      if (i >= size_) throw Refusal("certificate: not an index");
      if (seen[i]) throw Refusal("certificate: the order has a place twice");
      seen[i] = true;
      ordered_.push_back(box(i));
    }
    expect(ordered_.size() == size_, "certificate: the order is not of all");
  }

  void read_tree(std::size_t begin, std::size_t end, std::size_t depth) {
    const std::size_t place = nodes_.size();
    if (place >= claim_.cuts.size()) throw Refusal("certificate: the tree has too few nodes");
    if (depth > deepest) throw Refusal("certificate: the tree is too deep");
    const std::size_t cut = claim_.cuts[place];
    nodes_.push_back({ordered_[begin], static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), 0});
    if (cut == 0) {
      if (end - begin > largest_leaf) throw Refusal("certificate: a leaf of more than 16 boxes");
      for (std::size_t i = begin + 1; i < end; ++i) enlarge(nodes_[place].box, ordered_[i]);
      return;
    }
    if (cut >= end - begin) throw Refusal("certificate: a node without boxes");
    read_tree(begin, begin + cut, depth + 1);
    const std::size_t second = nodes_.size();
    nodes_[place].second = static_cast<std::uint32_t>(second);
    read_tree(begin + cut, end, depth + 1);
    nodes_[place].box = nodes_[place + 1].box;
    enlarge(nodes_[place].box, nodes_[second].box);
  }

  void search_within(std::size_t place) {
    const Node& node = nodes_[place];
    if (node.second != 0) {
      search_within(place + 1), search_within(node.second), search_across(place + 1, node.second);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      for (std::size_t j = i + 1; j < node.end; ++j) found_ += meet(ordered_[i], ordered_[j]);
  }

  unsigned next_step() {
    if (step_ / 4 >= claim_.steps.size()) throw Refusal("certificate: too few steps");
    const unsigned step = claim_.steps[step_ / 4] >> (2 * (step_ % 4)) & 3U;
    ++step_;
    return step;
  }

  void search_across(std::size_t one, std::size_t other) {
    const Node &a = nodes_[one], &b = nodes_[other];
    const unsigned step = next_step();
    if (step == 0) {
      if (meet(a.box, b.box)) throw Refusal("certificate: nodes are not apart");
    } else if (step == 1) {
      if (a.second == 0) throw Refusal("certificate: a leaf is opened");
      search_across(one + 1, other), search_across(a.second, other);
    } else if (step == 2) {
      if (b.second == 0) throw Refusal("certificate: a leaf is opened");
      search_across(one, other + 1), search_across(one, b.second);
    } else {
      if (a.second != 0 || b.second != 0) throw Refusal("certificate: a node is no leaf");
      for (std::size_t i = a.begin; i < a.end; ++i) {
        if (!meet(ordered_[i], b.box)) continue;
        for (std::size_t j = b.begin; j < b.end; ++j) found_ += meet(ordered_[i], ordered_[j]);
      }
    }
  }

  PairTreeClaim claim_;
  std::size_t size_;
  std::vector<PairBox> ordered_;
  std::vector<Node> nodes_;  ///< in preorder
  std::size_t step_ = 0, found_ = 0;
};

}  // namespace

void check_pair_tree(const PairTreeClaim& claim) { PairTreeCheck(claim).check(); }

void check_pair_tree(const Claim& claim) {
  claim.inputs({"boxes"});
  const std::vector<double> boxes = packed_doubles(claim.input["boxes"], "boxes");
  const PairTreeClaim only_boxes{boxes, {}, {}, {}, {}};
  const PairTreeCheck valid{only_boxes};
  claim.answers({"pairs"});
  claim.facts({"order", "cuts", "steps"});
  const std::vector<std::uint32_t> pairs = packed_indices(claim.truth["pairs"], "truth.pairs"),
                                   order = packed_indices(claim.certificate["order"], "certificate.order"),
                                   cuts = packed_indices(claim.certificate["cuts"], "certificate.cuts");
  const std::vector<std::uint8_t> steps = packed_bytes(claim.certificate["steps"], "certificate.steps");
  check_pair_tree(PairTreeClaim{boxes, pairs, order, cuts, steps});
}

}  // namespace touchstone::certify
