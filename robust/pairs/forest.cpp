// SPDX-License-Identifier: Apache-2.0
#include "robust/pairs/forest.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "robust/batch/isa/filters.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/machine/large_pages.h"
#include "robust/kernel/machine/parallel.h"
#include "robust/pairs/curve.h"
#include "robust/structures/box_order.h"
#include "robust/structures/pair_leaf.h"
#include "robust/structures/pair_order.h"

namespace touchstone::robust::pairs {

using batch::isa::EightBoxes, batch::isa::EightTree, batch::isa::PairSink, batch::isa::Turns;
using structures::Coarse, structures::PairOrder;

constexpr std::size_t eight = EightBoxes::places;

/// Coarse integers of coordinates, and whether they tell all of them apart: those of a grid they do. Gives up at many
/// different coordinates, which are no grid.
class Integers {
 public:
  Integers(const Coarse& coarse, std::size_t boxes)
      : coarse_(coarse),
        most_(std::clamp<std::size_t>(boxes / 8, 12, 1024)),
        shift_(32 - static_cast<int>(std::bit_width(2 * most_))),
        seen_(std::size_t{3} << (32 - shift_)) {}

  std::int32_t operator()(double value, std::size_t axis) {
    const std::int32_t integer = coarse_(value, axis);
    if (exact_) note(value, integer, axis);
    return integer;
  }
  bool exact() const { return exact_; }

  /// Those that another thread has seen of the same boxes are distinct from these, too.
  void add(const Integers& other) {
    exact_ = exact_ && other.exact_;
    for (std::size_t k = 0; exact_ && k < other.seen_.size(); ++k)
      if (other.seen_[k].taken) note(other.seen_[k].value, other.seen_[k].integer, k / (seen_.size() / 3));
  }

 private:
  struct Seen {
    double value;
    std::int32_t integer;
    bool taken = false;
  };

  void note(double value, std::int32_t integer, std::size_t axis) {
    const std::uint32_t last = (std::uint32_t{1} << (32 - shift_)) - 1;
    Seen* const own = seen_.data() + axis * (std::size_t{last} + 1);
    std::uint32_t at = static_cast<std::uint32_t>(integer) * 0x9e3779b1U >> shift_;
    while (own[at].taken && own[at].integer != integer) at = (at + 1) & last;
    if (!own[at].taken) own[at] = {value, integer, true}, exact_ = ++distinct_[axis] < most_;
    else exact_ = own[at].value == value;
  }

  Coarse coarse_;
  std::size_t most_;
  int shift_;
  bool exact_ = true;
  std::array<std::size_t, 3> distinct_{};
  std::vector<Seen> seen_;
};

/// A tree over boxes in the order of a curve.
class Tree {
 public:
  Tree() = default;
  Tree(const Aabb3d* boxes, const Placed* placed, std::size_t count, std::vector<Integers>& integers) {
    const std::size_t leaves = (count + eight - 1) / eight;
    std::size_t nodes = leaves;
    for (std::size_t level = leaves; level > 1;) nodes += level = (level + eight - 1) / eight;
    nodes_.reset(new EightBoxes[nodes]);
    kernel::in_large_pages(nodes_.get(), nodes * sizeof(EightBoxes));
    body_.reset(new Index[eight * leaves]);
    const kernel::ThreadParts parts(integers.size(), leaves, 1U << 11);
    parts.each([&](std::size_t part, std::size_t from, std::size_t end) {
      for (std::size_t k = from; k < end; ++k) fill_leaf(boxes, placed, count, k, integers[part]);
    });
    view_.body = body_.get(), view_.levels = 1, view_.level[0] = nodes_.get();
    for (std::size_t below = leaves; below > 1; below = (below + eight - 1) / eight, ++view_.levels)
      view_.level[view_.levels] = add_level(view_.level[view_.levels - 1], below);
  }
  const EightTree& view() const { return view_; }

 private:
  static constexpr std::int32_t free = std::numeric_limits<std::int32_t>::max();

  void fill_leaf(const Aabb3d* boxes, const Placed* placed, std::size_t count, std::size_t leaf, Integers& integers) {
    EightBoxes& node = nodes_[leaf];
    for (std::size_t k = 0, place = eight * leaf; k < eight; ++k, ++place) {
      if (place + 24 < count)
        __builtin_prefetch(boxes + placed[place + 24].body), __builtin_prefetch(&boxes[placed[place + 24].body].max.z);
      const auto put = [&, k](std::size_t axis, double low, double high) {
        node.ends[axis][k] = integers(low, axis), node.ends[axis][eight + k] = ~integers(high, axis);
      };
      if (place < count) {
        const Aabb3d& box = boxes[body_[place] = placed[place].body];
        put(0, box.min.x, box.max.x), put(1, box.min.y, box.max.y), put(2, box.min.z, box.max.z);
      } else {
        body_[place] = 0;
        for (auto& ends : node.ends) ends[k] = ends[eight + k] = free;
      }
    }
  }

  const EightBoxes* add_level(const EightBoxes* below, std::size_t count) {
    EightBoxes* const level = const_cast<EightBoxes*>(below) + count;
    for (std::size_t k = 0; k < (count + eight - 1) / eight * eight; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::int32_t low = free, other_high = free;
        if (k < count) {
          for (std::size_t place = 0; place < eight; ++place) {
            low = std::min(low, below[k].ends[axis][place]);
            other_high = std::min(other_high, below[k].ends[axis][eight + place]);
          }
        }
        level[k / eight].ends[axis][k % eight] = low, level[k / eight].ends[axis][eight + k % eight] = other_high;
      }
    }
    return level;
  }

  std::unique_ptr<EightBoxes[]> nodes_;  ///< the leaves, and one level after another
  std::unique_ptr<Index[]> body_;
  EightTree view_{};
};

/// Puts pairs into a small memory, and from there into their order.
class Sink : public PairSink {
 public:
  explicit Sink(PairOrder& order) : PairSink{nullptr, nullptr, empty}, order_(order) {
    next = memory_.data(), last = next + memory_.size() - room;
  }
  static void empty(PairSink& sink) {
    Sink& own = static_cast<Sink&>(sink);
    own.order_.add(own.memory_.data(), own.next);
    own.next = own.memory_.data();
  }

 private:
  std::array<IndexPair, 2048> memory_;
  PairOrder& order_;
};

static batch::isa::JoinPairs& joiner(batch::Instructions at_most) {
  const batch::isa::Filters* const here = batch::isa::filters_here(static_cast<int>(at_most));
  return here != nullptr ? *here->join_pairs : *batch::isa::portable_filters.join_pairs;
}

constexpr std::size_t size_classes = 27;

/// On each axis small, large, or longer than that.
static std::size_t size_class(const Aabb3d& box, const Extents& most_of_small) {
  const auto level = [](double wide, double small) { return wide <= small ? 0U : wide <= 8 * small ? 1U : 2U; };
  return level(width(box.min.x, box.max.x), most_of_small[0]) +
         3 * level(width(box.min.y, box.max.y), most_of_small[1]) +
         9 * level(width(box.min.z, box.max.z), most_of_small[2]);
}

/// A tree for each class of boxes of like size: otherwise a large box among small ones would make their node large.
class Forest {
 public:
  Forest(const std::vector<Aabb3d>& boxes, std::size_t threads, batch::isa::JoinPairs& join_pairs)
      : join_pairs_(join_pairs),
        boxes_(boxes.data()),
        parts_(parts_of(threads, boxes.size())),
        placed_(in_list_order(boxes.size())),
        curve_(boxes_, parts_.size()),
        all_(frame_of(0, placed_.size())),
        integers_(parts_.size(), Integers({all_.nearest_to_zero()}, placed_.size())) {
    if (placed_.size() <= 2 * eight) {
      classes_.push_back({0, all_, {boxes_, placed_.data(), placed_.size(), integers_}});
      return;
    }
    std::size_t from = 0;
    for (const std::size_t end : parted()) {
      if (end > from) add_class(from, end - from == placed_.size() ? all_ : frame_of(from, end));
      from = end;
    }
  }

  /// Keeps the order, and the classes, for the same number of boxes at new positions.
  void refit(const std::vector<Aabb3d>& boxes) {
    boxes_ = boxes.data(), curve_ = Curve(boxes_, parts_.size());
    integers_.assign(parts_.size(), Integers({all_.nearest_to_zero()}, placed_.size()));
    for (Class& of : classes_) of.tree = {boxes_, placed_.data() + of.from, of.frame.count, integers_};
  }

  std::size_t size() const { return placed_.size(); }

  void find_pairs(std::vector<IndexPair>& result) {
    std::vector<PairOrder> orders(parts_.size());
    for (PairOrder& order : orders) order.reset(placed_.size());
    for (std::size_t a = 0; a < classes_.size(); ++a) {
      join(classes_[a].tree, classes_[a].tree, orders);
      for (std::size_t b = a + 1; b < classes_.size(); ++b) {
        if (are_across(classes_[a].frame, classes_[b].frame))
          join(made(classes_[a], classes_[b].frame.mean), made(classes_[b], classes_[a].frame.mean), orders);
        else join(classes_[a].tree, classes_[b].tree, orders);
      }
    }
    PairOrder::finish(orders, result);
  }

 private:
  struct Class {
    std::size_t from;
    Frame frame;
    Tree tree;
  };

  static std::vector<Placed> in_list_order(std::size_t count) {
    auto placed = kernel::zeros_in_large_pages<Placed>(count);
    for (std::size_t i = 0; i < count; ++i) placed[i].body = static_cast<Index>(i);
    return placed;
  }
  Frame frame_of(std::size_t from, std::size_t end) const {
    return curve_.frame(placed_.data() + from, placed_.data() + end);
  }

  void add_class(std::size_t from, const Frame& frame) {
    classes_.push_back({from, frame, made({from, frame, {}}, {})});
  }

  /// In an order that suits comparison with boxes of such mean widths.
  Tree made(const Class& of, const Extents& other_mean) {
    Placed* const first = placed_.data() + of.from;
    curve_.arrange(first, first + of.frame.count, of.frame, other_mean);
    return {boxes_, first, of.frame.count, integers_};
  }

  /// Returns whether the boxes of two classes are long on different axes, and in neither class few.
  static bool are_across(const Frame& a, const Frame& b) {
    if (std::min(a.count, b.count) < std::max(eight, std::max(a.count, b.count) / 16)) return false;
    return a.turns_among(b) || b.turns_among(a);
  }

  void join(const Tree& one, const Tree& other, std::vector<PairOrder>& orders) {
    for (std::size_t part = 1; part < integers_.size(); ++part) integers_[0].add(integers_[part]);
    const Aabb3d* const boxes = integers_[0].exact() ? nullptr : boxes_;
    std::atomic<std::size_t> next = 0;
    in_parallel(orders.size(), orders.size(), [&](std::size_t thread) {
      const kernel::ControlWord guard;
      Sink sink(orders[thread]);
      Turns turns(next);
      join_pairs_(one.view(), other.view(), boxes, sink, orders.size() > 1 ? &turns : nullptr);
      Sink::empty(sink);
    });
  }

  /// Parts the boxes into classes; returns their ends.
  std::array<std::size_t, size_classes> parted() {
    Extents most_of_small{};
    int axes = 0;
    for (std::size_t k = 0; k < 3; ++k) axes += all_.spread(k) > 0 ? 1 : 0;
    const double apart = axes == 0 ? 1 : std::pow(static_cast<double>(placed_.size()), -1.0 / axes);
    for (std::size_t k = 0; k < 3; ++k) most_of_small[k] = std::min(5 * apart, 1.0) * all_.spread(k);
    std::vector<std::uint8_t> of(placed_.size());
    std::vector<std::array<std::size_t, size_classes>> starts(parts_.size());
    parts_.each([&](std::size_t part, std::size_t first, std::size_t last) {
      std::array<std::size_t, size_classes> counts{};
      for (std::size_t i = first; i < last; ++i)
        ++counts[of[i] = static_cast<std::uint8_t>(size_class(boxes_[i], most_of_small))];
      starts[part] = counts;
    });
    std::size_t start = 0;
    for (std::size_t c = 0; c < size_classes; ++c)
      for (auto& own : starts) start += std::exchange(own[c], start);
    parts_.each([&](std::size_t part, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) placed_[starts[part][of[i]]++].body = static_cast<Index>(i);
    });
    return starts.back();
  }

  batch::isa::JoinPairs& join_pairs_;
  const Aabb3d* boxes_;
  kernel::ThreadParts parts_;
  std::vector<Placed> placed_;
  Curve curve_;
  Frame all_;
  std::vector<Integers> integers_;  ///< of each thread
  std::vector<Class> classes_;
};

constexpr std::size_t few = 4;

static void find_pairs_of_few(const std::vector<Aabb3d>& boxes, std::vector<IndexPair>& pairs) {
  pairs.clear();
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index j = i + 1; j < boxes.size(); ++j)
      if (structures::meet(boxes[i], boxes[j])) pairs.push_back({i, j});
}

std::vector<IndexPair> forest_pairs(const std::vector<Aabb3d>& boxes, std::size_t threads,
                                    batch::Instructions at_most) {
  const kernel::ControlWord guard;
  std::vector<IndexPair> pairs;
  if (boxes.size() <= few) find_pairs_of_few(boxes, pairs);
  else Forest(boxes, threads, joiner(at_most)).find_pairs(pairs);
  return pairs;
}

KeptForest::KeptForest() = default;
KeptForest::KeptForest(KeptForest&&) noexcept = default;
KeptForest& KeptForest::operator=(KeptForest&&) noexcept = default;
KeptForest::~KeptForest() = default;

const std::vector<IndexPair>& KeptForest::pairs(const std::vector<Aabb3d>& boxes) {
  constexpr unsigned most_refits = 3;
  const kernel::ControlWord guard;
  if (boxes.size() <= few) {
    find_pairs_of_few(boxes, pairs_);
    return pairs_;
  }
  if (forest_ && forest_->size() == boxes.size() && refits_ < most_refits) {
    forest_->refit(boxes), ++refits_;
  } else {
    forest_ = std::make_unique<Forest>(boxes, 1, joiner(batch::Instructions::avx512)), refits_ = 0;
  }
  forest_->find_pairs(pairs_);
  return pairs_;
}

}  // namespace touchstone::robust::pairs
