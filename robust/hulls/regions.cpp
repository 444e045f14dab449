// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "robust/hulls/surface.h"
#include "robust/kernel/machine/parallel.h"

// A surface is cut into regions, by one coordinate, that grow at the same time, one thread each. A thread adds a point
// only if all facets below it and all around the hole are its own: so facets next to those of another region stay, and
// no thread reads what another one writes. Points that this leaves out wait for regions along another axis, and the
// last for one thread. Which facets the whole surface has does not depend on any of this (surface.h).
namespace touchstone::robust::hulls {
namespace {

/// A thread is worth making for so many points above a region's facets.
constexpr std::size_t worth_a_thread = 1U << 12, most_regions = 1U << 14;

struct Waiting {
  std::int32_t facet, points;
  bool in_turn;
  double place;
};

/// The coordinates to cut at, so that regions have about as many points each.
std::vector<double> cuts_of(std::vector<Waiting> waiting, std::size_t points, std::size_t regions) {
  std::sort(waiting.begin(), waiting.end(), [](const Waiting& a, const Waiting& b) { return a.place < b.place; });
  std::vector<double> cuts;
  std::size_t before = 0;
  for (const Waiting& each : waiting) {
    if (before >= points / regions * (cuts.size() + 1) && cuts.size() + 1 < regions) cuts.push_back(each.place);
    before += static_cast<std::size_t>(each.points);
  }
  return cuts;
}

}  // namespace

void Surface::grow(std::size_t threads) {
  for (std::size_t axis = 0; axis < 3 && grow_regions(threads, axis); ++axis) {
  }
  grow(whole_);
}

/// Gives a region the free facets that it needs, of which end_of_free is the number: two for each of its points.
void Surface::make_ready(Growth& own, std::int16_t region) {
  const auto old = std::min(static_cast<std::size_t>(own.end_of_free), whole_.free.size());
  for (std::size_t i = 0; i < old; ++i) {
    own.free.push_back(whole_.free.back());
    whole_.free.pop_back();
    regions_[static_cast<std::size_t>(own.free.back())] = region;
  }
  own.region = region, own.next_free = static_cast<std::int32_t>(regions_.size());
  own.end_of_free += own.next_free - static_cast<std::int32_t>(old);
  regions_.resize(static_cast<std::size_t>(own.end_of_free), region);
}

bool Surface::grow_regions(std::size_t threads, std::size_t axis) {
  if (threads < 2) return false;
  threads = std::min(threads, most_regions);
  std::vector<Waiting> waiting;
  std::size_t count = 0;
  const auto list = [&](const std::vector<std::int32_t>& facets_in_order, bool in_turn) {
    for (const std::int32_t f : facets_in_order) {
      if (!facet(f).alive()) continue;
      Waiting each{f, 0, in_turn, point(facet(f).corner[0])[axis]};
      for (std::int32_t q = facet(f).above; q >= 0; q = point(q).next) ++each.points;
      if (each.points > 0) waiting.push_back(each), count += static_cast<std::size_t>(each.points);
    }
  };
  list(whole_.queue, true), list(whole_.stack, false);
  const kernel::ThreadParts parts(threads, count, worth_a_thread);
  if (parts.size() < 2) return false;
  const std::vector<double> cuts = cuts_of(waiting, count, parts.size());
  const auto region_of = [&](const Facet& f) {
    const double place = point(f.corner[0])[axis];
    return static_cast<std::int16_t>(std::upper_bound(cuts.begin(), cuts.end(), place) - cuts.begin());
  };
  std::vector<Stage> latest(parts.size(), Stage::filter);
  std::vector<Growth> regions;
  for (Stage& each : latest) regions.emplace_back(Sides(sides, each)).stamp = whole_.stamp;
  for (const Waiting& each : waiting) {
    Growth& own = regions[static_cast<std::size_t>(region_of(facet(each.facet)))];
    (each.in_turn ? own.queue : own.stack).push_back(each.facet);
    own.end_of_free += 2 * each.points;
  }
  const kernel::ThreadParts old(threads, facets.size(), worth_a_thread);
  regions_.resize(facets.size());
  old.each([&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      if (facets[f].alive()) regions_[f] = region_of(facets[f]);
    }
  });
  for (std::size_t r = 0; r < regions.size(); ++r) make_ready(regions[r], static_cast<std::int16_t>(r));
  facets.resize(regions_.size()), marks_.resize(regions_.size(), 0);
  in_parallel(parts.size(), parts.size(), [&](std::size_t r) {
    const kernel::ControlWord ieee;
    Growth& own = regions[r];
    own.first_edges.resize(points.size());
    grow(own);
    std::sort(own.blocked.begin(), own.blocked.end());  // one that was blocked twice was removed, and made again
    own.blocked.erase(std::unique(own.blocked.begin(), own.blocked.end()), own.blocked.end());
    for (std::int32_t f = own.next_free; f < own.end_of_free; ++f) facet(f).corner[0] = -1, own.free.push_back(f);
  });
  whole_.queue.clear(), whole_.stack.clear();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const Growth& own = regions[r];
    whole_.stack.insert(whole_.stack.end(), own.blocked.begin(), own.blocked.end());
    whole_.free.insert(whole_.free.end(), own.free.begin(), own.free.end());
    whole_.stamp = std::max(whole_.stamp, own.stamp);
    sides.note(latest[r]);
  }
  return true;
}

}  // namespace touchstone::robust::hulls
