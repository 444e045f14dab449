// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/pair_cut.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "robust/structures/pair_leaf.h"

namespace touchstone::robust::structures {
namespace {

constexpr std::array axes{&Point3d::x, &Point3d::y, &Point3d::z};

/// Sets of so few boxes are split so that most leaves are full.
constexpr Index few = 32, leaf = PairLeaf::places;

/// Quarters and halves, which do not overflow.
double middle(const Aabb3d& box, double Point3d::*axis) { return 0.25 * (box.min.*axis) + 0.25 * (box.max.*axis); }
double width(const Aabb3d& box, double Point3d::*axis) { return 0.5 * (box.max.*axis) - 0.5 * (box.min.*axis); }

/// The factor that scales an extent to about 1. All extents are halved: `middle` has quarters of a sum, `width` halves
/// of a difference.
double scale_for(double extent) { return extent > 0x1p-1000 ? 1 / extent : 0x1p1000; }

float to_single(double value) {
  return static_cast<float>(std::min(value, static_cast<double>(std::numeric_limits<float>::max())));
}

/// Four numbers at once, which the compiler turns into one register.
using Four = float __attribute__((vector_size(16)));

Four loaded(const void* four) {
  Four result;
  std::memcpy(&result, four, sizeof result);
  return result;
}
Four lesser(Four a, Four b) { return a < b ? a : b; }
Four greater(Four a, Four b) { return a > b ? a : b; }
void store(Four from, std::array<float, 4>& to) { std::memcpy(to.data(), &from, sizeof from); }

}  // namespace

PairCut::PairCut(const std::vector<Aabb3d>& boxes) : boxes_(&boxes) {
  items_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) items_[i].body = static_cast<Index>(i);
  if (!boxes.empty()) place_in_frame(0, static_cast<Index>(boxes.size()));
}

/// Scales middles to between 0 and 1 on each axis, and widths to the same units.
void PairCut::place_in_frame(Index begin, Index end) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool all = end - begin == items_.size();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity}, scale{};
  for (Index i = begin; i < end; ++i) {
    const Aabb3d& box = (*boxes_)[items_[i].body];
    for (std::size_t k = 0; k < 3; ++k) {
      const double here = middle(box, axes[k]);
      low[k] = here < low[k] ? here : low[k], high[k] = here > high[k] ? here : high[k];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) scale[k] = scale_for(high[k] - low[k]);
  for (Index i = begin; i < end; ++i) {
    Item& item = items_[i];
    const Aabb3d& box = (*boxes_)[item.body];
    for (std::size_t k = 0; k < 3; ++k) {
      item.middle[k] = static_cast<float>((middle(box, axes[k]) - low[k]) * scale[k]);
      item.width[k] = to_single(width(box, axes[k]) * scale[k]);
    }
  }
  if (!all) return;
  for (std::size_t k = 0; k < 3; ++k)
    origin_[k] = std::clamp(2 * std::clamp(0.0, low[k], high[k]), -0x1.fffffffffffffp1023, 0x1.fffffffffffffp1023);
  scale_ = scale;
}

PairCut::Spread PairCut::spread_of(Index begin, Index end) const {
  Four low = loaded(&items_[begin].middle), high = low, least = loaded(&items_[begin].width), most = least;
  for (Index i = begin + 1; i < end; ++i) {
    const Four middle = loaded(&items_[i].middle), width = loaded(&items_[i].width);
    low = lesser(middle, low), high = greater(middle, high);
    least = lesser(width, least), most = greater(width, most);
  }
  Spread spread;
  store(low, spread.low), store(high, spread.high), store(least, spread.least), store(most, spread.most);
  return spread;
}

/// Without branches, which would be unpredictable.
template <class Before>
Index PairCut::parted(Index begin, Index end, const Before& before) {
  Index first = begin;
  for (Index i = begin; i < end; ++i) {
    const Item item = items_[i];
    items_[i] = items_[first];
    items_[first] = item;
    first += static_cast<Index>(before(item));
  }
  return first;
}

Index PairCut::operator()(Index begin, Index end) {
  Spread spread = spread_of(begin, end);
  const auto longest = [&spread] { return std::max({spread.extent(0), spread.extent(1), spread.extent(2)}); };
  if (longest() < 0x1p-12F) place_in_frame(begin, end), spread = spread_of(begin, end);
  std::size_t axis = 0, mixed = 3;
  float best = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const float extent = spread.extent(k), score = extent / (spread.most[k] + 0x1p-10F * longest());
    if (score > best) best = score, axis = k;
    if (spread.most[k] > extent && spread.least[k] < extent / 16) mixed = k;
  }
  if (best < 1 && mixed < 3) {
    const float bound = spread.extent(mixed) / 4;
    return parted(begin, end, [&](const Item& item) { return item.width[mixed] <= bound; });
  }
  const auto at = [this](Index place) { return items_.begin() + static_cast<std::ptrdiff_t>(place); };
  const auto cut_at = [&](Index place) {
    std::nth_element(at(begin), at(place), at(end),
                     [axis](const Item& p, const Item& q) { return p.middle[axis] < q.middle[axis]; });
    return place;
  };
  if (end - begin <= few) return cut_at(begin + std::max(leaf, (end - begin + leaf) / (2 * leaf) * leaf));
  const float half = spread.low[axis] + spread.extent(axis) / 2;
  const Index middle = parted(begin, end, [&](const Item& item) { return item.middle[axis] < half; });
  if (std::min(middle - begin, end - middle) > (end - begin) / 16) return middle;
  return cut_at(begin + (end - begin) / 2);
}

std::vector<Index> PairCut::order() const {
  std::vector<Index> order;
  order.reserve(items_.size());
  for (const Item& item : items_) order.push_back(item.body);
  return order;
}

double PairCut::size(const Aabb3d& box) const {
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, width(box, axes[k]) * scale_[k]);
  return size;
}

}  // namespace touchstone::robust::structures
