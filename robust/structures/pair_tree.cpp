// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/pair_tree.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "robust/kernel/filters/control_word.h"
#include "robust/structures/box_order.h"
#include "robust/structures/pair_cut.h"
#include "robust/structures/pair_leaf.h"
#include "robust/structures/pair_order.h"

namespace touchstone::robust::structures {
namespace {

enum class Step : std::uint8_t { apart, open_first, open_second, compare };

}  // namespace

/// Requires a guard in scope, so that doubles may be compared.
class PairTree {
 public:
  explicit PairTree(PairProof* proof = nullptr) : proof_(proof) {}

  /// The boxes must stay valid until the next call.
  void make(const std::vector<Aabb3d>& boxes) {
    boxes_ = boxes.data(), size_ = boxes.size();
    cut_ = PairCut(boxes), coarse_ = {cut_.origin()};
    nodes_.clear(), leaves_.clear();
    nodes_.reserve(size_ / 2 + 8), leaves_.reserve(size_ / 4 + 8);
    if (size_ > 0) build(0, static_cast<Index>(size_));
    if (proof_ == nullptr) return;
    proof_->order = cut_.order();
    for (const Node& node : nodes_) proof_->cuts.push_back(node.cut);
  }

  void find_pairs(std::vector<IndexPair>& result) {
    const std::vector<IndexPair>& pairs = unsorted_pairs();
    order_.reset(size_);
    order_.add(pairs.data(), pairs.data() + pairs.size());
    order_.finish(result);
  }

  /// Valid until the next list.
  std::vector<IndexPair>& unsorted_pairs() {
    met_.clear();
    if (!nodes_.empty()) {
      if (proof_) within<true>(0);
      else within<false>(0);
    }
    return met_;
  }

 private:
  using Place = std::uint32_t;
  struct Node {
    Aabb3d box;
    double size;
    Place right;  ///< the second child, the first being next to its parent; for a leaf, its index among leaves
    Index cut;
    bool leaf() const { return cut == 0; }
  };

  void build(Index begin, Index end) {
    const std::size_t place = nodes_.size();
    nodes_.emplace_back();
    if (end - begin <= PairLeaf::places) {
      nodes_[place].cut = 0, nodes_[place].right = static_cast<Place>(leaves_.size());
      nodes_[place].box = add_leaf(begin, end);
    } else {
      if (end - begin <= 64) fetch(begin, end);
      const Index middle = cut_(begin, end);
      build(begin, middle);
      const std::size_t right = nodes_.size();
      build(middle, end);
      nodes_[place].cut = middle - begin, nodes_[place].right = static_cast<Place>(right);
      nodes_[place].box = least_around(nodes_[place + 1].box, nodes_[right].box);
    }
    nodes_[place].size = cut_.size(nodes_[place].box);
  }

  /// Prefetches the boxes of a small node, which are scattered in memory, while it is split.
  void fetch(Index begin, Index end) const {
    for (Index i = begin; i < end; ++i) __builtin_prefetch(&boxes_[cut_.body(i)]);
  }

  Aabb3d add_leaf(Index begin, Index end) {
    PairLeaf& leaf = leaves_.emplace_back();
    for (Index i = begin; i < end; ++i) leaf.body[i - begin] = cut_.body(i);
    return filled(leaf, end - begin);
  }
  /// The ends of that many boxes, and the least box around them.
  Aabb3d filled(PairLeaf& leaf, std::size_t taken) {
    Aabb3d box = boxes_[leaf.body[0]];
    for (std::size_t place = 0; place < taken; ++place) {
      const Aabb3d& own = boxes_[leaf.body[place]];
      box = least_around(box, own);
      const auto add = [&](std::size_t axis, double low, double high) {
        leaf.low[axis][place] = coarse_(low, axis), leaf.high[axis][place] = coarse_(high, axis);
        leaf.around.low[axis] = std::min(leaf.around.low[axis], leaf.low[axis][place]);
        leaf.around.high[axis] = std::max(leaf.around.high[axis], leaf.high[axis][place]);
      };
      add(0, own.min.x, own.max.x), add(1, own.min.y, own.max.y), add(2, own.min.z, own.max.z);
    }
    return box;
  }

  static Aabb3d least_around(const Aabb3d& a, const Aabb3d& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
  }
  static bool apart(const Aabb3d& a, const Aabb3d& b) {
    // A single branch: the axis on which two nodes are apart is unpredictable.
    return (static_cast<int>(a.max.x < b.min.x) | static_cast<int>(b.max.x < a.min.x) |
            static_cast<int>(a.max.y < b.min.y) | static_cast<int>(b.max.y < a.min.y) |
            static_cast<int>(a.max.z < b.min.z) | static_cast<int>(b.max.z < a.min.z)) != 0;
  }

  void compare(const PairLeaf& one, std::size_t place, const PairLeaf& other, unsigned among) {
    const CoarseBox box = one.box(place);
    unsigned candidates = may_meet(other, box) & among;
    if (candidates == 0) return;
    const unsigned surely = surely_meet_or_apart(other, box);
    const Index i = one.body[place];
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto k = static_cast<unsigned>(std::countr_zero(candidates));
      const Index j = other.body[k];
      if ((surely >> k & 1U) != 0 || meet(boxes_[i], boxes_[j])) met_.push_back({std::min(i, j), std::max(i, j)});
    }
  }

  void step(Step taken) {
    if (steps_ % 4 == 0) proof_->steps.push_back(0);
    proof_->steps.back() |= static_cast<std::uint8_t>(static_cast<unsigned>(taken) << (2 * (steps_++ % 4)));
  }

  template <bool proved>
  void within(Place node) {
    const Node& n = nodes_[node];
    if (!n.leaf()) {
      within<proved>(node + 1), within<proved>(n.right), between<proved>(node + 1, n.right);
      return;
    }
    const PairLeaf& leaf = leaves_[n.right];
    for (std::size_t i = 0; i < PairLeaf::places; ++i) compare(leaf, i, leaf, 0xfeU << i & 0xffU);
  }

  template <bool proved>
  void between(Place one, Place other) {
    const Node &a = nodes_[one], &b = nodes_[other];
    const auto taken = [&](Step what) {
      if constexpr (proved) step(what);
    };
    if (apart(a.box, b.box)) {
      taken(Step::apart);
    } else if (a.leaf() && b.leaf()) {
      taken(Step::compare);
      const PairLeaf &left = leaves_[a.right], &right = leaves_[b.right];
      for (unsigned open = may_meet(left, right.around); open != 0; open &= open - 1)
        compare(left, static_cast<std::size_t>(std::countr_zero(open)), right, 0xffU);
    } else if (b.leaf() || (!a.leaf() && a.size >= b.size)) {
      taken(Step::open_first);
      between<proved>(one + 1, other), between<proved>(a.right, other);
    } else {
      taken(Step::open_second);
      between<proved>(one, other + 1), between<proved>(one, b.right);
    }
  }

  const Aabb3d* boxes_ = nullptr;
  std::size_t size_ = 0;
  PairProof* proof_;
  PairCut cut_;
  Coarse coarse_;
  std::vector<Node> nodes_;  ///< in preorder
  std::vector<PairLeaf> leaves_;
  std::vector<IndexPair> met_;
  PairOrder order_;
  std::size_t steps_ = 0;
};

std::vector<IndexPair> tree_pairs(const std::vector<Aabb3d>& boxes, PairProof* proof) {
  const kernel::ControlWord guard;
  if (proof) *proof = {};
  std::vector<IndexPair> pairs;
  PairTree tree(proof);
  tree.make(boxes);
  tree.find_pairs(pairs);
  return pairs;
}

std::vector<IndexPair> unsorted_tree_pairs(const std::vector<Aabb3d>& boxes) {
  const kernel::ControlWord guard;
  PairTree tree;
  tree.make(boxes);
  return std::move(tree.unsorted_pairs());
}

}  // namespace touchstone::robust::structures
