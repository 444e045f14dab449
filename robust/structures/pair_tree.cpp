// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/pair_tree.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "robust/kernel/control_word.h"
#include "robust/structures/box_order.h"
#include "robust/structures/pair_cut.h"
#include "robust/structures/pair_leaf.h"

namespace touchstone::robust::structures {
namespace {

/// Pairs of the same i by j: few as a rule.
void sort_row(IndexPair* row, std::size_t size) {
  const auto before = [](const IndexPair& p, const IndexPair& q) { return p.j < q.j; };
  if (size > 24) return std::sort(row, row + size, before);
  for (std::size_t k = 1; k < size; ++k) {
    const IndexPair pair = row[k];
    std::size_t to = k;
    for (; to > 0 && before(pair, row[to - 1]); --to) row[to] = row[to - 1];
    row[to] = pair;
  }
}

/// A counting sort of pairs i < j < size: into stretches of i that a cache holds, there by i, and each row by j.
std::vector<IndexPair> sorted(const std::vector<IndexPair>& pairs, std::size_t size) {
  const int shift = std::max(0, static_cast<int>(std::bit_width(size)) - 10);
  std::vector<std::size_t> stretch((size >> shift) + 2);
  for (const IndexPair& pair : pairs) ++stretch[(pair.i >> shift) + 1];
  for (std::size_t k = 1; k < stretch.size(); ++k) stretch[k] += stretch[k - 1];
  std::vector<IndexPair> parted(pairs.size()), result(pairs.size());
  std::vector<std::size_t> next(stretch);
  for (const IndexPair& pair : pairs) parted[next[pair.i >> shift]++] = pair;
  std::vector<std::size_t> row;
  for (std::size_t k = 0; k + 1 < stretch.size(); ++k) {
    const auto first = static_cast<Index>(k << shift);
    row.assign((std::size_t{1} << shift) + 2, 0);
    for (std::size_t p = stretch[k]; p < stretch[k + 1]; ++p) ++row[parted[p].i - first + 2];
    row[0] = row[1] = stretch[k];
    for (std::size_t r = 2; r < row.size(); ++r) row[r] += row[r - 1];
    for (std::size_t p = stretch[k]; p < stretch[k + 1]; ++p) result[row[parted[p].i - first + 1]++] = parted[p];
    for (std::size_t r = 0; r + 1 < row.size(); ++r) sort_row(result.data() + row[r], row[r + 1] - row[r]);
  }
  return result;
}

enum class Step : std::uint8_t { apart, open_first, open_second, compare };

/// In scope of a guard, so that doubles may be compared.
class PairTree {
 public:
  PairTree(const std::vector<Aabb3d>& boxes, PairProof* proof)
      : boxes_(boxes), proof_(proof), cut_(boxes), coarse_{cut_.origin()} {
    nodes_.reserve(boxes.size() / 2 + 8), leaves_.reserve(boxes.size() / 4 + 8);
    if (!boxes.empty()) build(0, static_cast<Index>(boxes.size()));
    if (proof_) {
      proof_->order = cut_.order();
      for (const Node& node : nodes_) proof_->cuts.push_back(node.cut);
    }
    cut_ = {};
  }

  std::vector<IndexPair> pairs() {
    if (nodes_.empty()) return {};
    if (proof_) within<true>(0);
    else within<false>(0);
    return sorted(met_, boxes_.size());
  }

 private:
  using Place = std::uint32_t;
  struct Node {
    Aabb3d box;
    double size;
    Place right;  ///< the second child, the first being next to its parent; of a leaf, its place among leaves
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

  /// The boxes of a small node, which lie anywhere, on their way to the cache while it is cut.
  void fetch(Index begin, Index end) const {
    for (Index i = begin; i < end; ++i) __builtin_prefetch(&boxes_[cut_.body(i)]);
  }

  Aabb3d add_leaf(Index begin, Index end) {
    PairLeaf& leaf = leaves_.emplace_back();
    Aabb3d box = boxes_[cut_.body(begin)];
    for (Index i = begin; i < end; ++i) {
      const std::size_t place = i - begin;
      const Aabb3d& own = boxes_[leaf.body[place] = cut_.body(i)];
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
    // One branch: nobody can predict on which axis two nodes are apart.
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

  const std::vector<Aabb3d>& boxes_;
  PairProof* proof_;
  PairCut cut_;
  Coarse coarse_;
  std::vector<Node> nodes_;  ///< in preorder
  std::vector<PairLeaf> leaves_;
  std::vector<IndexPair> met_;
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<IndexPair> tree_pairs(const std::vector<Aabb3d>& boxes, PairProof* proof) {
  const kernel::ControlWord guard;
  if (proof) *proof = {};
  return PairTree(boxes, proof).pairs();
}

}  // namespace touchstone::robust::structures
