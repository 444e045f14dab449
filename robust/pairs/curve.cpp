// SPDX-License-Identifier: Apache-2.0
#include "robust/pairs/curve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/machine/large_pages.h"

namespace touchstone::robust::pairs {
namespace {

constexpr int digits = 10;  ///< of a key, on each axis
constexpr std::uint32_t cells = 1U << digits;

/// Moves ten bits to every third.
std::uint32_t spread_out(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffU;
  x = (x | x << 8) & 0x0300f00fU;
  x = (x | x << 4) & 0x030c30c3U;
  return (x | x << 2) & 0x09249249U;
}

constexpr std::uint32_t rotated(std::uint32_t three, std::uint32_t by) {
  return (three << by % 3 | three >> (3 - by % 3)) & 7;
}

/// Hilbert's curve in space, by C. Hamilton, "Compact Hilbert indices" (Dalhousie University, CS-2006-07): for each
/// corner where the curve enters a cube and axis along which it leaves, and each octant, the octant's number on the
/// curve, below the state within it.
constexpr std::array<std::uint8_t, 8 * 8 * 3> hilbert_steps() {
  std::array<std::uint8_t, 8 * 8 * 3> steps{};
  const auto gray = [](std::uint32_t i) { return i ^ i >> 1; };
  for (std::uint32_t state = 0; state < 24; ++state) {
    const std::uint32_t enters = state / 3, along = state % 3;
    for (std::uint32_t number = 0; number < 8; ++number) {
      const std::uint32_t octant = rotated(gray(number), along + 1) ^ enters;
      const std::uint32_t entry = number == 0 ? 0 : gray((number - 1) / 2 * 2);
      const std::uint32_t from = number == 0 ? 0 : number % 2 == 0 ? number - 1 : number;
      const auto axis = static_cast<std::uint32_t>(std::countr_one(from));
      const std::uint32_t next = 3 * (enters ^ rotated(entry, along + 1)) + (along + axis + 1) % 3;
      steps[8 * state + octant] = static_cast<std::uint8_t>(8 * next + number);
    }
  }
  return steps;
}

/// Two steps at once.
constexpr std::array<std::uint16_t, 8 * 8 * 8 * 3> hilbert_double_steps() {
  constexpr auto steps = hilbert_steps();
  std::array<std::uint16_t, 8 * 8 * 8 * 3> both{};
  for (std::size_t state = 0; state < 24; ++state) {
    for (std::size_t octants = 0; octants < 64; ++octants) {
      const std::uint32_t first = steps[8 * state + octants / 8], second = steps[(first & 0xf8) | octants % 8];
      both[64 * state + octants] = static_cast<std::uint16_t>((second & 0xf8) << 3 | (first & 7) << 3 | (second & 7));
    }
  }
  return both;
}

/// The number on Hilbert's curve of a cell with such interleaved coordinates.
std::uint32_t along_hilbert(std::uint32_t interleaved) {
  static_assert(digits % 2 == 0);
  static constexpr auto steps = hilbert_double_steps();
  std::uint32_t number = 0, step = 0;
  for (int shift = 3 * (digits - 2); shift >= 0; shift -= 6) {
    step = steps[(step & 0x7c0) | (interleaved >> shift & 63)];
    number = number << 6 | (step & 63);
  }
  return number;
}

Extents middles(const Aabb3d& box) {
  return {middle(box.min.x, box.max.x), middle(box.min.y, box.max.y), middle(box.min.z, box.max.z)};
}
Extents widths(const Aabb3d& box) {
  return {width(box.min.x, box.max.x), width(box.min.y, box.max.y), width(box.min.z, box.max.z)};
}

}  // namespace

Frame Curve::frame(const Placed* first, const Placed* last) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::size_t>(last - first);
  const Frame none{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, {}, count};
  const double share = 1.0 / static_cast<double>(count);
  const kernel::ThreadParts parts = this->parts(first, last);
  std::vector<Frame> frames(parts.size(), none);
  parts.each([&](std::size_t part, std::size_t from, std::size_t end) {
    Frame own = none;
    for (std::size_t i = from; i < end; ++i) {
      const Aabb3d& box = boxes_[first[i].body];
      const Extents at = middles(box), wide = widths(box);
      for (std::size_t k = 0; k < 3; ++k) {
        own.low[k] = at[k] < own.low[k] ? at[k] : own.low[k];
        own.high[k] = at[k] > own.high[k] ? at[k] : own.high[k];
        own.mean[k] += share * wide[k];
      }
    }
    frames[part] = own;
  });
  Frame all = frames[0];
  for (std::size_t part = 1; part < parts.size(); ++part) {
    for (std::size_t k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], frames[part].low[k]);
      all.high[k] = std::max(all.high[k], frames[part].high[k]);
      all.mean[k] += frames[part].mean[k];
    }
  }
  return all;
}

Extents Frame::units(const Extents& other_mean) const {
  Extents units{};
  int thin = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    units[k] = mean[k] + other_mean[k];
    if (spread(k) > 0 && units[k] < 0.25 * spread(k)) ++thin;
  }
  const double apart = thin == 0 ? 1 : std::pow(static_cast<double>(count), -1.0 / thin);
  for (std::size_t k = 0; k < 3; ++k) units[k] += apart * spread(k);
  return units;
}

bool Frame::turns_among(const Frame& others) const {
  const Extents alone = units({}), among = units(others.mean);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(alone[k] > 0)) continue;
    least = std::min(least, among[k] / alone[k]), most = std::max(most, among[k] / alone[k]);
  }
  return most > 8 * least;
}

Extents Frame::nearest_to_zero() const {
  constexpr double most = std::numeric_limits<double>::max();
  Extents nearest{};
  for (std::size_t k = 0; k < 3; ++k) nearest[k] = std::clamp(2 * std::clamp(0.0, low[k], high[k]), -most, most);
  return nearest;
}

/// The axis with the most units has all cells.
void Curve::set_keys(Placed* first, Placed* last, const Frame& frame, const Extents& other_mean) const {
  const Extents units = frame.units(other_mean);
  Extents share{};
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (units[k] > 0) share[k] = frame.spread(k) / units[k];
    most = std::max(most, share[k]);
  }
  Extents scale{}, up{};
  for (std::size_t k = 0; k < 3; ++k) {
    // Subnormal extents have no reciprocal.
    up[k] = frame.spread(k) < 0x1p-500 ? 0x1p600 : 1;
    const double spread = up[k] * frame.spread(k);
    if (share[k] > 0) scale[k] = 0.999 * cells * (share[k] / most) / spread;
  }
  parts(first, last).each([&](std::size_t, std::size_t from, std::size_t end) {
    for (Placed* placed = first + from; placed != first + end; ++placed) {
      const Extents at = middles(boxes_[placed->body]);
      std::uint32_t key = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto cell =
            static_cast<std::uint32_t>(static_cast<std::int32_t>((at[k] - frame.low[k]) * up[k] * scale[k]));
        key |= spread_out(cell) << k;
      }
      placed->key = along_hilbert(key);
    }
  });
}

void Curve::set_keys_by_exponent(Placed* first, Placed* last, const Frame& frame) const {
  const auto bits = [&](double at, std::size_t k) {
    return static_cast<std::uint32_t>(kernel::ordered_bits(at - frame.low[k]) >> 32);
  };
  std::array<std::uint32_t, 3> least{~0U, ~0U, ~0U};
  std::array<double, 3> scale{};
  for (const Placed* placed = first; placed != last; ++placed) {
    const Extents at = middles(boxes_[placed->body]);
    for (std::size_t k = 0; k < 3; ++k)
      if (at[k] > frame.low[k]) least[k] = std::min(least[k], bits(at[k], k));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t most = bits(frame.high[k], k);
    if (most > least[k]) scale[k] = 0.999 * cells / (most - least[k]);
  }
  for (; first != last; ++first) {
    const Extents at = middles(boxes_[first->body]);
    std::uint32_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = std::max(bits(at[k], k), least[k]) - least[k];
      key |= spread_out(static_cast<std::uint32_t>(beyond * scale[k])) << k;
    }
    first->key = along_hilbert(key);
  }
}

void Curve::sort_by_key(Placed* first, Placed* last) {
  const auto count = static_cast<std::size_t>(last - first);
  if (count < 300) {
    return std::sort(first, last, [](const Placed& a, const Placed& b) {
      return a.key < b.key || (a.key == b.key && a.body < b.body);
    });
  }
  if (sorted_.size() < count) sorted_ = kernel::zeros_in_large_pages<Placed>(count);
  const kernel::ThreadParts parts = this->parts(first, last);
  std::vector<std::array<std::uint32_t, cells>> starts(parts.size());
  Placed *from = first, *to = sorted_.data();
  for (int digit = 0; digit < 3; ++digit) {
    const auto value = [digit](const Placed& placed) { return placed.key >> (digits * digit) & (cells - 1); };
    parts.each([&](std::size_t part, std::size_t begin, std::size_t end) {
      starts[part].fill(0);
      for (std::size_t i = begin; i < end; ++i) ++starts[part][value(from[i])];
    });
    std::uint32_t start = 0;
    for (std::size_t cell = 0; cell < cells; ++cell)
      for (auto& own : starts) start += std::exchange(own[cell], start);
    parts.each([&](std::size_t part, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) to[starts[part][value(from[i])]++] = from[i];
    });
    std::swap(from, to);
  }
  std::copy_n(from, count, first);
}

/// Many boxes with the same key are arranged again in a frame of their own; if they are more than half, by exponents,
/// in case that many are close to a corner.
void Curve::arrange(Placed* first, Placed* last, const Frame& frame, const Extents& other_mean, bool by_exponent) {
  if (last - first <= 8 || std::max({frame.spread(0), frame.spread(1), frame.spread(2)}) == 0) return;
  if (by_exponent) set_keys_by_exponent(first, last, frame);
  else set_keys(first, last, frame, other_mean);
  sort_by_key(first, last);
  for (Placed* run = first; run != last;) {
    Placed* end = run + 1;
    while (end != last && end->key == run->key) ++end;
    if (end - run > 32) {
      const bool most = 2 * (end - run) > last - first;
      if (end - run < last - first) arrange(run, end, this->frame(run, end), other_mean, most && !by_exponent);
      else if (!by_exponent) arrange(run, end, frame, other_mean, true);
    }
    run = end;
  }
}

}  // namespace touchstone::robust::pairs
