// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

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

  /// Sorts them, and forgets them.
  void finish(std::vector<IndexPair>& result) {
    std::size_t count = 0;
    for (const Range& range : ranges_) count += size_of(range);
    result.clear(), result.reserve(count);
    for (std::size_t k = 0; k < ranges_.size(); ++k) append(ranges_[k], static_cast<Index>(k << shift_), result);
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
        const std::size_t size = slabs_.empty() ? 1 : std::min<std::size_t>(512, 2 * slabs_.back().size);
        slabs_.push_back({std::unique_ptr<Block[]>(new Block[size]), size});
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

  void append(const Range& range, Index first, std::vector<IndexPair>& result) {
    const std::size_t count = size_of(range);
    if (count == 0) return;
    rows_.assign((std::size_t{1} << shift_) + 2, 0);
    by_row_.resize(std::max(by_row_.size(), count)), sorted_.resize(by_row_.size());
    each(range, [&](const IndexPair& pair) { ++rows_[pair.i - first + 2]; });
    for (std::size_t r = 2; r < rows_.size(); ++r) rows_[r] += rows_[r - 1];
    each(range, [&](const IndexPair& pair) { by_row_[rows_[pair.i - first + 1]++] = pair; });
    for (std::size_t r = 0; r + 1 < rows_.size(); ++r)
      sort_row(by_row_.data() + rows_[r], rows_[r + 1] - rows_[r], sorted_.data() + rows_[r]);
    result.insert(result.end(), sorted_.begin(), sorted_.begin() + static_cast<std::ptrdiff_t>(count));
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
  std::vector<IndexPair> by_row_, sorted_;
  std::size_t used_ = 0;  ///< slabs
  Block *free_ = nullptr, *last_ = nullptr;
};

}  // namespace touchstone::robust::structures
