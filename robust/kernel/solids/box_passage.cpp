// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/box_passage.h"

#include <algorithm>
#include <limits>

#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/triangle_clip.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust::kernel {
namespace {

/// The numbers of one axis: `to` is the end of a segment, or the direction of a ray.
struct Axis {
  double from, to, min, max;

  bool zero_displacement(bool ends) const { return ends ? validation::same(from, to) : validation::zero(to); }
};

/// On the lattice: distance / speed, or 1 / 0, which is later than all others. Both are differences, so below 2^62.
struct Time {
  std::int64_t distance, speed;
  friend bool operator<(const Time& s, const Time& t) {
    return multiply(s.distance, t.speed) < multiply(t.distance, s.speed);
  }
};

std::array<Axis, 3> axes_of(const Line& line, const Box& box) {
  const auto& [from, to, ends] = line;
  return {{{from.x, to.x, box.min.x, box.max.x},
           {from.y, to.y, box.min.y, box.max.y},
           {from.z, to.z, box.min.z, box.max.z}}};
}

}  // namespace

Perhaps<Passage<double>> BoxPassage::filter(const Line& line, const Box& box) {
  for (const auto& [from, to, min, max] : axes_of(line, box)) {
    const bool rises = !sign_bit(to) && !validation::zero(to), falls = sign_bit(to) && !validation::zero(to);
    const bool stays_below = line.ends ? to < min : !rises, stays_above = line.ends ? to > max : !falls;
    if ((from < min && stays_below) || (from > max && stays_above)) return no_passage;
  }
  return std::nullopt;
}

Perhaps<Passage<double>> BoxPassage::enclosed(const Line& line, const Box& box) {
  if (!rounds_to_nearest()) return std::nullopt;
  double first = 0, last = line.ends ? 1 : std::numeric_limits<double>::infinity();
  bool moves = false;
  for (const auto& [from, to, min, max] : axes_of(line, box)) {
    if (!in_window(Two(from, to), Two(min, max))) return std::nullopt;
    const Pair<double> displacement = line.ends ? difference(to, from) : Pair<double>{to, 0};
    if (displacement.high == 0) {
      if (from < min || max < from) return no_passage;
      continue;
    }
    moves = true;
    const Divisor<double> speed(Enclosed<double>{displacement.high, displacement.low, 0});
    const auto time = [&speed, from = from](double side) {
      const Pair<double> gap = difference(side, from);
      return rounded(Enclosed<double>{gap.high, gap.low, 0} / speed);
    };
    const auto entry = time(displacement.high > 0 ? min : max), exit = time(displacement.high > 0 ? max : min);
    if (!entry || !exit) return std::nullopt;
    first = std::max(first, *entry), last = std::min(last, *exit);
  }
  if (last < first) return no_passage;
  if (!moves || !(first < last)) return std::nullopt;
  return Passage<double>{PassageRelation::hit, first, last};
}

/// The differences of each axis in a unit of its own: t is dimensionless.
Passage<double> BoxPassage::exact(const Line& line, const Box& box) {
  Clipped part = line.ends ? Clipped{} : Clipped::ray();
  bool moves = false;
  for (const Axis& axis : axes_of(line, box)) {
    const auto n = integers_of(axis.from, axis.to, axis.min, axis.max).at;
    const mpz_class &from = n[0], &min = n[2], &max = n[3], to = line.ends ? n[1] : mpz_class(from + n[1]);
    part.keep(from - min, to - min), part.keep(max - from, max - to);
    moves = moves || !axis.zero_displacement(line.ends);
  }
  return rounded_passage(part, moves);
}

Passage<double> rounded_passage(const Clipped& part, bool moves) {
  if (part.empty) return no_passage;
  if (!moves) return {PassageRelation::hit, 0.0, 0.0};
  const auto rounded = [](const Clipped::Parameter& t) { return round_quotient(t.numerator, t.denominator); };
  return {PassageRelation::hit, rounded(part.first), rounded(part.last)};
}

Perhaps<PassageRelation> box_relation_on_lattice(const Line& line, const Box& box) {
  Time start{0, 1}, end{1, line.ends ? 1 : 0};
  for (const auto& [from, to, min, max] : axes_of(line, box)) {
    const auto lattice = lattice_of(from, to, min, max);
    if (!lattice) return std::nullopt;
    const auto& n = lattice->at;
    const std::int64_t displacement = line.ends ? n[1] - n[0] : n[1], to_min = n[2] - n[0], to_max = n[3] - n[0];
    if (displacement == 0) {
      if (to_min > 0 || to_max < 0) return PassageRelation::none;
      continue;
    }
    const Time entry = displacement > 0 ? Time{to_min, displacement} : Time{-to_max, -displacement};
    const Time exit = displacement > 0 ? Time{to_max, displacement} : Time{-to_min, -displacement};
    if (start < entry) start = entry;
    if (exit < end) end = exit;
  }
  return end < start ? PassageRelation::none : PassageRelation::hit;
}

}  // namespace touchstone::robust::kernel
