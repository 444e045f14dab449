// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstring>
#include <tuple>

#include "robust/batch/isa/filters.h"
#include "robust/batch/isa/rows.h"

/// Rows in chunks through a filter, and what it leaves through the stages of one question.
namespace touchstone::robust::batch::isa {

/// At most so many chunks are filtered before what they leave is decided: their numbers are still in the cache.
inline constexpr std::size_t most_chunks = 64;
/// So many at a time, where columns are copied.
inline constexpr std::size_t copied_chunks = 4;

/// Columns as a filter reads them, contiguous ones in place and others copied, part after part.
template <std::size_t size>
class Feed {
 public:
  explicit Feed(const std::array<Column, size>& columns) : columns_(columns) {
    for (std::size_t k = 0; k < size; ++k) {
      steps_[k] = columns[k].stride == 0 ? 0 : chunk;
      in_place_ = in_place_ && (columns[k].stride == 0 || columns[k].stride == 1);
      if (columns[k].stride == 0) std::fill_n(copies_[k], chunk, *columns[k].data);
    }
  }

  /// Makes the rows from `first` on ready, `count` at most and perhaps fewer; returns how many.
  std::size_t take(std::size_t first, std::size_t count) {
    const bool direct = in_place_ && count >= chunk;
    const std::size_t rows =
        direct ? std::min(count / chunk, most_chunks) * chunk : std::min(count, copied_chunks * chunk);
    const std::size_t padded = (rows + chunk - 1) / chunk * chunk;
    for (std::size_t k = 0; k < size; ++k) {
      const Column& column = columns_[k];
      starts_[k] = copies_[k];
      if (column.stride == 0) continue;
      if (direct) {
        starts_[k] = column.data + first;
        continue;
      }
      for (std::size_t i = 0; i < rows; ++i) copies_[k][i] = row(column, first + i);
      std::fill(copies_[k] + rows, copies_[k] + padded, copies_[k][rows - 1]);
    }
    return rows;
  }

  const double* const* starts() const { return starts_.data(); }
  const std::size_t* steps() const { return steps_.data(); }

 private:
  std::array<Column, size> columns_;
  std::array<const double*, size> starts_;
  std::array<std::size_t, size> steps_;
  bool in_place_ = true;
  alignas(64) double copies_[size][copied_chunks * chunk];
};

/// Rows that a filter left, packed to a chunk for the second stage; then what that leaves, one by one and in order.
template <class PastFilter, class... Operands>
class Left {
 public:
  static constexpr std::size_t columns = Flat<Operands...>::size;

  Left(Filter* close, const PastFilter& past_filter, std::uint8_t* answers, const Operands&... operands)
      : close_(close), past_filter_(past_filter), answers_(answers), flat_(operands...), operands_(operands...) {}

  void add(std::size_t i) {
    if (close_ == nullptr) return decide(i);
    for (std::size_t k = 0; k < columns; ++k) packed_[k][size_] = row(flat_.columns[k], i);
    rows_[size_++] = i;
    if (size_ == chunk) flush();
  }

  void flush() {
    if (size_ == 0) return;
    std::array<const double*, columns> starts;
    std::array<std::size_t, columns> steps{};
    for (std::size_t k = 0; k < columns; ++k) {
      starts[k] = packed_[k];
      std::fill(packed_[k] + size_, packed_[k] + chunk, packed_[k][0]);
    }
    std::uint8_t found[chunk];
    std::uint64_t unknown = 0;
    close_(starts.data(), steps.data(), 1, Shared{}, found, &unknown);
    for (std::size_t n = 0; n < size_; ++n) {
      if ((unknown >> n & 1) == 0) answers_[rows_[n]] = found[n];
      else decide(rows_[n]);
    }
    size_ = 0;
  }

 private:
  void decide(std::size_t i) {
    std::apply([&](const auto&... operands) { answers_[i] = decided(past_filter_, i, operands...); }, operands_);
  }

  Filter* close_;
  const PastFilter& past_filter_;
  std::uint8_t* answers_;
  Flat<Operands...> flat_;
  std::tuple<const Operands&...> operands_;
  std::size_t size_ = 0, rows_[chunk];
  alignas(64) double packed_[columns][chunk];
};

/// Members of Filters: the filter, and the stage for what it leaves.
struct Which {
  Filter *Filters::*filter, *Filters::*close = &Filters::none;
};

/// A filter for all rows where it holds, then the second stage and past_filter(operands...) for those that it does not
/// decide; elsewhere decide(operands...) for each row.
template <class Decide, class PastFilter, class... Operands>
void run(Which which, const Shared& shared, Instructions at_most, const Decide& decide, const PastFilter& past_filter,
         std::size_t count, std::uint8_t* answers, const Operands&... operands) {
  if (count == 0) return;
  const Filters* const filters = filters_here(static_cast<int>(at_most));
  if (filters == nullptr) return decide_each(decide, count, answers, operands...);
  Filter* const filter = filters->*which.filter;
  Feed<Flat<Operands...>::size> feed(Flat<Operands...>(operands...).columns);
  Left<PastFilter, Operands...> left(filters->*which.close, past_filter, answers, operands...);
  std::uint64_t unknown[most_chunks];
  for (std::size_t first = 0; first < count;) {
    const std::size_t rows = feed.take(first, count - first), chunks = (rows + chunk - 1) / chunk;
    const std::size_t full = rows / chunk * chunk;
    if (full == rows) {
      filter(feed.starts(), feed.steps(), chunks, shared, answers + first, unknown);
    } else {  // nothing is written behind the last answer
      std::uint8_t all[copied_chunks * chunk];
      filter(feed.starts(), feed.steps(), chunks, shared, all, unknown);
      std::memcpy(answers + first, all, rows);
      unknown[chunks - 1] &= (std::uint64_t{1} << (rows - full)) - 1;
    }
    for (std::size_t n = 0; n < chunks; ++n)
      for (std::uint64_t bits = unknown[n]; bits != 0; bits &= bits - 1)
        left.add(first + n * chunk + static_cast<std::size_t>(std::countr_zero(bits)));
    first += rows;
  }
  left.flush();
}
template <class Decide, class PastFilter, class... Operands>
void run(Which which, Instructions at_most, const Decide& decide, const PastFilter& past_filter, std::size_t count,
         std::uint8_t* answers, const Operands&... operands) {
  run(which, Shared{}, at_most, decide, past_filter, count, answers, operands...);
}

}  // namespace touchstone::robust::batch::isa
