// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include <cstring>

#include "robust/batch/isa/eight_boxes.h"
#include "robust/batch/isa/lanes.h"
#include "robust/kernel/filters/processor.h"

namespace touchstone::robust::batch::isa {
namespace {

#if TOUCHSTONE_LANES == 8

/// One of eight boxes, to be compared with eight others: its ends swapped and complemented, so that boxes meet if no
/// integer of theirs is greater.
struct Probe {
  __m512i ends[3];
};

class Probes {
 public:
  explicit Probes(const EightBoxes& eight) {
    for (std::size_t k = 0; k < 3; ++k) ends_[k] = ~_mm512_load_si512(eight.ends[k]);
  }
  Probe operator[](unsigned place) const {
    const __m512i swapped = _mm512_setr_epi32(8, 8, 8, 8, 8, 8, 8, 8, 0, 0, 0, 0, 0, 0, 0, 0);
    const __m512i from = _mm512_add_epi32(swapped, _mm512_set1_epi32(static_cast<int>(place)));
    return {{_mm512_permutexvar_epi32(from, ends_[0]), _mm512_permutexvar_epi32(from, ends_[1]),
             _mm512_permutexvar_epi32(from, ends_[2])}};
  }

 private:
  __m512i ends_[3];
};

/// A bit for each of eight boxes that may meet it: the others certainly do not.
inline unsigned may_meet(const EightBoxes& eight, const Probe& probe) {
  __mmask16 within = 0xffff;
  for (std::size_t k = 0; k < 3; ++k)
    within = _mm512_mask_cmple_epi32_mask(within, _mm512_load_si512(eight.ends[k]), probe.ends[k]);
  return within & static_cast<unsigned>(within) >> 8;
}

/// A bit for each of those that certainly do, and for some that certainly do not.
inline unsigned surely_meet(const EightBoxes& eight, const Probe& probe) {
  __mmask16 within = 0xffff;
  for (std::size_t k = 0; k < 3; ++k)
    within = _mm512_mask_cmplt_epi32_mask(within, _mm512_load_si512(eight.ends[k]), probe.ends[k]);
  return within & static_cast<unsigned>(within) >> 8;
}

/// put_pairs has no branch here: to put no pairs costs less than to ask whether there are any.
constexpr bool packs_pairs = true;

inline IndexPair* put_pairs(IndexPair* to, Index i, const Index* body, unsigned which) {
  __m256i other;
  std::memcpy(&other, body, sizeof other);
  const __m256i own = _mm256_set1_epi32(static_cast<int>(i));
  const __m512i lesser = _mm512_cvtepu32_epi64(_mm256_min_epu32(own, other));
  const __m512i greater = _mm512_cvtepu32_epi64(_mm256_max_epu32(own, other));
  const __m512i pairs = _mm512_or_si512(lesser, _mm512_slli_epi64(greater, 32));
  const __m512i packed = _mm512_maskz_compress_epi64(static_cast<__mmask8>(which), pairs);
  std::memcpy(to, &packed, sizeof packed);
  return to + __builtin_popcount(which);
}

#else

#if TOUCHSTONE_LANES == 4 && defined(__AVX2__)
__extension__ typedef int Part __attribute__((vector_size(32)));
inline unsigned signs(Part part) {
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<__m256>(part)));
}
#else
using Part = kernel::processor::FourIntegers;
inline unsigned signs(Part part) {
  return kernel::processor::signs(reinterpret_cast<kernel::processor::TwoBits>(part));
}
#endif

struct Probe {
  std::int32_t high[3], other_low[3];
};

class Probes {
 public:
  explicit Probes(const EightBoxes& eight) : eight_(&eight) {}
  Probe operator[](unsigned place) const {
    Probe probe;
    for (std::size_t k = 0; k < 3; ++k)
      probe.high[k] = ~eight_->ends[k][8 + place], probe.other_low[k] = ~eight_->ends[k][place];
    return probe;
  }

 private:
  const EightBoxes* eight_;
};

/// A bit for each of eight boxes of which no integer is `outside` of the probe's.
template <class Outside>
[[gnu::always_inline]] inline unsigned none_outside(const EightBoxes& eight, const Probe& probe,
                                                    const Outside& outside) {
  constexpr unsigned lanes_of_part = sizeof(Part) / sizeof(std::int32_t);
  unsigned found = 0;
  for (unsigned from = 0; from < EightBoxes::places; from += lanes_of_part) {
    Part any{};
    for (std::size_t k = 0; k < 3; ++k) {
      Part low, high;
      std::memcpy(&low, &eight.ends[k][from], sizeof low);
      std::memcpy(&high, &eight.ends[k][from + EightBoxes::places], sizeof high);
      any |= outside(low, Part{} + probe.high[k]) | outside(high, Part{} + probe.other_low[k]);
    }
    found |= signs(any) << from;
  }
  return ~found & 0xffU;
}

inline unsigned may_meet(const EightBoxes& eight, const Probe& probe) {
  return none_outside(eight, probe, [](Part a, Part b) { return a > b; });
}
inline unsigned surely_meet(const EightBoxes& eight, const Probe& probe) {
  return none_outside(eight, probe, [](Part a, Part b) { return a >= b; });
}

constexpr bool packs_pairs = false;

inline IndexPair* put_pairs(IndexPair* to, Index i, const Index* body, unsigned which) {
  for (; which != 0; which &= which - 1) {
    const Index j = body[__builtin_ctz(which)];
    *to++ = i < j ? IndexPair{i, j} : IndexPair{j, i};
  }
  return to;
}

#endif

inline int within_ends(double low, double high, double other_low, double other_high) {
  return static_cast<int>(low <= other_high) & static_cast<int>(other_low <= high);
}
inline bool meet_by_doubles(const Aabb3d& a, const Aabb3d& b) {
  return (within_ends(a.min.x, a.max.x, b.min.x, b.max.x) & within_ends(a.min.y, a.max.y, b.min.y, b.max.y) &
          within_ends(a.min.z, a.max.z, b.min.z, b.max.z)) != 0;
}

/// Not apart from anything but free places.
constexpr EightBoxes boundless() {
  EightBoxes eight{};
  for (auto& ends : eight.ends)
    for (std::int32_t& end : ends) end = std::int32_t{-0x7fffffff};
  return eight;
}
constexpr EightBoxes everywhere = boundless();

/// Compares nodes with nodes of the same level; opens the higher one first. `exact` if integers are equal only where
/// coordinates are. With turns, what is to be done of nodes on one level is a part.
template <bool exact>
class Join {
 public:
  Join(const EightTree& one, const EightTree& other, const Aabb3d* boxes, PairSink& sink, Turns* turns)
      : one_(one), other_(other), boxes_(boxes), sink_(sink), turns_(turns) {
    const std::size_t highest = (one.levels > other.levels ? one.levels : other.levels) - 1;
    if (turns != nullptr) level_of_parts_ = highest < 3 ? highest : 3;
  }

  void whole() {
    if (one_.body == other_.body) return within(one_.levels - 1, 0);
    const Node a{one_.levels - 1, 0}, b{other_.levels - 1, 0};
    const Probe around = Probes(everywhere)[0];
    between(a, around, b, around);
  }

 private:
  struct Node {
    std::size_t level, place;
    Node child(unsigned k) const { return {level - 1, EightBoxes::places * place + k}; }
  };
  static unsigned taken(unsigned& bits) {
    const auto first = static_cast<unsigned>(__builtin_ctz(bits));
    bits &= bits - 1;
    return first;
  }

  /// Returns whether this level is one of parts, and another thread does this one.
  bool left_to_others(std::size_t level) { return level == level_of_parts_ && !turns_->own(); }

  void within(std::size_t level, std::size_t place) {
    if (left_to_others(level)) return;
    const EightBoxes& eight = one_.level[level][place];
    const Probes probes(eight);
    if (level == 0) {
      make_room();
      for (unsigned k = 0; k < 7; ++k) row(eight, probes[k], place, k, place, 0xfeU << k & 0xffU);
      return;
    }
    const Node node{level, place};
    for (unsigned k = 0; k < EightBoxes::places; ++k) {
      const Probe probe = probes[k];
      unsigned met = may_meet(eight, probe) >> k;
      if ((met & 1) == 0) break;  // a free place
      within(level - 1, node.child(k).place);
      for (met = (met & ~1U) << k; met != 0;) {
        const unsigned other = taken(met);
        between(node.child(k), probe, node.child(other), probes[other]);
      }
    }
  }

  void between(const Node& a, const Probe& around_a, const Node& b, const Probe& around_b) {
    if (left_to_others(a.level > b.level ? a.level : b.level)) return;
    const EightBoxes &left = one_.level[a.level][a.place], &right = other_.level[b.level][b.place];
    if (a.level < b.level) {
      const Probes probes(right);
      for (unsigned open = may_meet(right, around_a); open != 0;) {
        const unsigned k = taken(open);
        between(a, around_a, b.child(k), probes[k]);
      }
      return;
    }
    unsigned rows = may_meet(left, around_b);
    if (rows == 0) return;
    const Probes probes(left);
    if (a.level > b.level) {
      while (rows != 0) {
        const unsigned k = taken(rows);
        between(a.child(k), probes[k], b, around_b);
      }
    } else if (a.level == 0) {
      make_room();
      while (rows != 0) {
        const unsigned k = taken(rows);
        row(right, probes[k], a.place, k, b.place, 0xffU);
      }
    } else {
      const Probes others(right);
      while (rows != 0) {
        const unsigned k = taken(rows);
        const Probe probe = probes[k];
        for (unsigned met = may_meet(right, probe); met != 0;) {
          const unsigned other = taken(met);
          between(a.child(k), probe, b.child(other), others[other]);
        }
      }
    }
  }

  void make_room() {
    if (sink_.next > sink_.last) sink_.flush(sink_);
  }

  [[gnu::always_inline]] void row(const EightBoxes& right, const Probe& probe, std::size_t leaf, unsigned k,
                                  std::size_t other_leaf, unsigned among) {
    unsigned met = may_meet(right, probe) & among;
    if (!packs_pairs && met == 0) return;
    const Index i = one_.body[EightBoxes::places * leaf + k];
    const Index* const others = other_.body + EightBoxes::places * other_leaf;
    if constexpr (!exact) {
      for (unsigned unsure = met & ~surely_meet(right, probe); unsure != 0;) {
        const unsigned other = taken(unsure);
        if (!meet_by_doubles(boxes_[i], boxes_[others[other]])) met &= ~(1U << other);
      }
    }
    sink_.next = put_pairs(sink_.next, i, others, met);
  }

  const EightTree &one_, &other_;
  const Aabb3d* boxes_;
  PairSink& sink_;
  Turns* turns_;
  std::size_t level_of_parts_ = EightTree::most_levels;
};

void join_pairs(const EightTree& one, const EightTree& other, const Aabb3d* boxes, PairSink& sink, Turns* turns) {
  if (boxes == nullptr) Join<true>(one, other, boxes, sink, turns).whole();
  else Join<false>(one, other, boxes, sink, turns).whole();
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
