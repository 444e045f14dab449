// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstring>
#include <tuple>

#include "robust/batch/isa/filters.h"
#include "robust/batch/isa/rows.h"

/// Runs rows in chunks through a filter, and the rows that it leaves through the stages of one question.
namespace touchstone::robust::batch::isa {

/// The largest number of chunks filtered before their undecided rows are decided: their numbers are still in the cache.
inline constexpr std::size_t most_chunks = 64;
/// The number of chunks at a time if columns are copied.
inline constexpr std::size_t copied_chunks = 4;

/// Feeds columns to a filter, contiguous ones in place and others copied, part after part.
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

  /// Prepares the rows from `first` on, `count` at most and perhaps fewer; returns the number of rows.
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

/// The rows that a filter left. If a chunk has many, the second stage takes them in place; otherwise they are packed
/// into full chunks. Rows that the second stage leaves are decided one by one, in order.
template <class PastFilter, class... Operands>
class Left {
 public:
  static constexpr std::size_t columns = Flat<Operands...>::size;

  Left(SecondStage* close, const Shared& shared, const PastFilter& past_filter, std::uint8_t* answers,
       const Operands&... operands)
      : close_(close), shared_(shared), past_filter_(past_filter), answers_(answers), operands_(operands...) {}

  /// Adds the rows of chunk n of the feed, whose first row is `first`.
  void add(const Feed<columns>& feed, std::size_t n, std::size_t first, std::uint64_t rows) {
    if (close_ == nullptr) return decide(first, rows);
    std::array<const double*, columns> starts;
    for (std::size_t k = 0; k < columns; ++k) starts[k] = feed.starts()[k] + n * feed.steps()[k];
    if (std::popcount(rows) >= many) {
      const std::uint64_t open = close_(starts.data(), rows, shared_, answers_ + first);
      if (open == 0) return;
      flush();
      return decide(first, open);
    }
    for (; rows != 0; rows &= rows - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rows));
      for (std::size_t k = 0; k < columns; ++k) packed_[k][size_] = starts[k][i];
      rows_[size_++] = first + i;
      if (size_ == chunk) flush();
    }
  }

  void flush() {
    if (size_ == 0) return;
    std::array<const double*, columns> starts;
    for (std::size_t k = 0; k < columns; ++k) {
      starts[k] = packed_[k];
      std::fill(packed_[k] + size_, packed_[k] + chunk, packed_[k][0]);
    }
    std::uint8_t found[chunk];
    const std::uint64_t open = close_(starts.data(), ~std::uint64_t{0} >> (chunk - size_), shared_, found);
    for (std::size_t n = 0; n < size_; ++n) {
      if ((open >> n & 1) == 0) answers_[rows_[n]] = found[n];
      else decide(rows_[n], 1);
    }
    size_ = 0;
  }

 private:
  /// A sixth of a chunk: packing a row costs about as much as deciding six in place.
  static constexpr int many = 11;

  void decide(std::size_t first, std::uint64_t rows) {
    for (; rows != 0; rows &= rows - 1) {
      const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(rows));
      std::apply([&](const auto&... operands) { answers_[i] = decided(past_filter_, i, operands...); }, operands_);
    }
  }

  SecondStage* close_;
  const Shared& shared_;
  const PastFilter& past_filter_;
  std::uint8_t* answers_;
  std::tuple<const Operands&...> operands_;
  std::size_t size_ = 0, rows_[chunk];
  alignas(64) double packed_[columns][chunk];
};

/// Members of Filters: the filter, and the second stage.
struct Which {
  Filter* Filters::*filter;
  SecondStage* Filters::*close = &Filters::none;
};

/// Filters all rows if the filter is valid here, then applies the second stage and past_filter(operands...) to the
/// undecided rows; otherwise calls decide(operands...) for each row.
template <class Decide, class PastFilter, class... Operands>
void run(Which which, const Shared& shared, const Limits& limits, const Decide& decide, const PastFilter& past_filter,
         std::size_t count, std::uint8_t* answers, const Operands&... operands) {
  if (count == 0) return;
  const Filters* const filters = filters_here(static_cast<int>(limits.at_most));
  if (filters == nullptr) return decide_each(limits, decide, count, answers, operands...);
  Filter* const filter = filters->*which.filter;
  parts_of(limits, count).each([&](std::size_t, std::size_t first, std::size_t end) {
    Feed<Flat<Operands...>::size> feed(Flat<Operands...>(operands...).columns);
    Left<PastFilter, Operands...> left(filters->*which.close, shared, past_filter, answers, operands...);
    std::uint64_t unknown[most_chunks];
    while (first < end) {
      const std::size_t rows = feed.take(first, end - first), chunks = (rows + chunk - 1) / chunk;
      const std::size_t full = rows / chunk * chunk;
      if (full == rows) {
        filter(feed.starts(), feed.steps(), chunks, shared, answers + first, unknown);
      } else {  // nothing is written past the last answer
        std::uint8_t all[copied_chunks * chunk];
        filter(feed.starts(), feed.steps(), chunks, shared, all, unknown);
        std::memcpy(answers + first, all, rows);
        unknown[chunks - 1] &= (std::uint64_t{1} << (rows - full)) - 1;
      }
      for (std::size_t n = 0; n < chunks; ++n)
        if (unknown[n] != 0) left.add(feed, n, first + n * chunk, unknown[n]);
      first += rows;
    }
    left.flush();
  });
}
template <class Decide, class PastFilter, class... Operands>
void run(Which which, const Limits& limits, const Decide& decide, const PastFilter& past_filter, std::size_t count,
         std::uint8_t* answers, const Operands&... operands) {
  run(which, Shared{}, limits, decide, past_filter, count, answers, operands...);
}

}  // namespace touchstone::robust::batch::isa
