// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"
#include "robust/kernel/machine/large_pages.h"
#include "robust/kernel/machine/parallel.h"

namespace touchstone::robust::structures {

/// A counting sort of pairs i < j < size that arrive in any order: into ranges of i, of which each fits a cache, as
/// they come; within a range by i, and each row by j, at the end. The memory is reused.
class PairOrder {
 public:
  /// Forgets all pairs.
  void reset(std::size_t size) {
    const int width = static_cast<int>(std::bit_width(size));
    shift_ = std::max(std::min(width, 10), width - 10);
    ranges_.assign((size >> shift_) + 1, {});
    used_ = 0, free_ = last_ = nullptr;
  }

  void add(const IndexPair* pairs, const IndexPair* end) {
    for (; pairs != end; ++pairs) {
      Range& range = ranges_[pairs->i >> shift_];
      if (range.next == range.last) grow(range);
      *range.next++ = *pairs;
    }
  }

  /// Sorts them.
  void finish(std::vector<IndexPair>& result) { finish({this, 1}, result); }

  /// Sorts the pairs of all of several, which were reset to the same size, on as many threads.
  static void finish(std::span<PairOrder> orders, std::vector<IndexPair>& result) {
    const std::size_t ranges = orders[0].ranges_.size();
    std::vector<std::size_t> starts(ranges + 1);
    for (std::size_t k = 0; k < ranges; ++k) {
      starts[k + 1] = starts[k];
      for (const PairOrder& order : orders) starts[k + 1] += size_of(order.ranges_[k]);
    }
    result.clear(), result.reserve(starts[ranges]);
    kernel::in_large_pages(result.data(), starts[ranges] * sizeof(IndexPair));
    result.resize(starts[ranges]);
    std::atomic<std::size_t> next = 0;
    in_parallel(orders.size(), orders.size(), [&](std::size_t thread) {
      for (std::size_t k; (k = next.fetch_add(1, std::memory_order_relaxed)) < ranges;)
        orders[thread].sort(orders, k, {result.data() + starts[k], starts[k + 1] - starts[k]});
    });
  }

 private:
  static constexpr std::size_t of_block = 256, few = 24;
  /// Pairs, after a link to the block before it.
  struct Block {
    Block* before;
    IndexPair pairs[of_block];
  };
  struct Slab {
    std::unique_ptr<Block[]> blocks;
    std::size_t size;
  };
  struct Range {
    IndexPair *next = nullptr, *last = nullptr;  ///< in the latest block
    Block* latest = nullptr;
    std::size_t full = 0;  ///< the count of blocks before it
  };

  void grow(Range& range) {
    if (free_ == last_) {
      if (used_ == slabs_.size()) {
        const std::size_t size = slabs_.empty() ? 1 : std::min<std::size_t>(4096, 2 * slabs_.back().size);
        slabs_.push_back({std::unique_ptr<Block[]>(new Block[size]), size});
        kernel::in_large_pages(slabs_.back().blocks.get(), size * sizeof(Block));
      }
      free_ = slabs_[used_].blocks.get(), last_ = free_ + slabs_[used_].size, ++used_;
    }
    if (range.latest != nullptr) ++range.full;
    free_->before = range.latest;
    range.latest = free_++;
    range.next = range.latest->pairs, range.last = range.next + of_block;
  }

  static std::size_t size_of(const Range& range) {
    return range.latest == nullptr ? 0
                                   : of_block * range.full + static_cast<std::size_t>(range.next - range.latest->pairs);
  }

  template <class Each>
  static void each(const Range& range, const Each& each) {
    const IndexPair* end = range.next;
    for (const Block* block = range.latest; block != nullptr; block = block->before) {
      for (const IndexPair* pair = block->pairs; pair != end; ++pair) each(*pair);
      if (block->before != nullptr) end = block->before->pairs + of_block;
    }
  }

  /// Sorts the pairs of one range of all orders.
  void sort(std::span<const PairOrder> orders, std::size_t k, std::span<IndexPair> result) {
    if (result.empty()) return;
    const auto first = static_cast<Index>(k << shift_);
    rows_.assign((std::size_t{1} << shift_) + 2, 0);
    by_row_.resize(std::max(by_row_.size(), result.size()));
    for (const PairOrder& order : orders)
      each(order.ranges_[k], [&](const IndexPair& pair) { ++rows_[pair.i - first + 2]; });
    for (std::size_t r = 2; r < rows_.size(); ++r) rows_[r] += rows_[r - 1];
    for (const PairOrder& order : orders)
      each(order.ranges_[k], [&](const IndexPair& pair) { by_row_[rows_[pair.i - first + 1]++] = pair; });
    for (std::size_t r = 0; r + 1 < rows_.size(); ++r)
      sort_row(by_row_.data() + rows_[r], rows_[r + 1] - rows_[r], result.data() + rows_[r]);
  }

  /// Sorts pairs with the same i by j: usually few, which are put where so many are before them. Without branches,
  /// which would be unpredictable.
  static void sort_row(const IndexPair* row, std::size_t size, IndexPair* to) {
    if (size > few) {
      std::copy_n(row, size, to);
      return std::sort(to, to + size, [](const IndexPair& p, const IndexPair& q) { return p.j < q.j; });
    }
    for (std::size_t k = 0; k < size; ++k) {
      std::size_t before = 0;
      for (std::size_t other = 0; other < size; ++other) before += row[other].j < row[k].j ? 1 : 0;
      to[before] = row[k];
    }
  }

  int shift_ = 0;
  std::vector<Range> ranges_;
  std::vector<Slab> slabs_;
  std::vector<std::size_t> rows_;
  std::vector<IndexPair> by_row_;
  std::size_t used_ = 0;  ///< slabs
  Block *free_ = nullptr, *last_ = nullptr;
};

}  // namespace touchstone::robust::structures
