// SPDX-License-Identifier: Apache-2.0
#include "robust/rings/sweep.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

#include "robust/lines/orientation.h"
#include "robust/lines/segment_segment.h"
#include "robust/rings/chains.h"

namespace touchstone::robust {
namespace {

/// The sweep of Shamos and Hoey: a line moves over the plane by x, at equal x by y (as if it were slightly tilted), and
/// keeps the edges that it cuts in upward order. That order holds as long as no two edges have met, and before two
/// edges meet they are neighbours in it. So it is enough to compare edges that become neighbours, and each vertex with
/// the edge above it where its edges begin. The edges of a ring that share a vertex meet there; they must not meet
/// elsewhere.
class Sweep {
 public:
  Sweep(const Polygon2d& ring, Chains* chains)
      : ring_(ring),
        size_(ring.size()),
        chains_(chains),
        order_(size_),
        rank_(size_),
        places_(size_),
        cut_(Upwards{this}) {
    std::iota(order_.begin(), order_.end(), Index{0});
    std::sort(order_.begin(), order_.end(), [&](Index i, Index j) {
      return ring_[i].x < ring_[j].x || (ring_[i].x == ring_[j].x && ring_[i].y < ring_[j].y);
    });
    for (Index k = 0; k < size_; ++k) rank_[order_[k]] = k;
  }

  bool simple() {
    for (std::size_t k = 1; k < size_; ++k) {
      if (ring_[order_[k - 1]] == ring_[order_[k]]) return false;
    }
    return std::all_of(order_.begin(), order_.end(), [&](Index v) { return passes(v); });
  }

  Stage latest() const { return latest_; }

 private:
  /// Edge i goes from vertex i to the next; in the order it may replace the edge before it.
  struct Cut {
    mutable Index edge;
    bool floor;
    mutable Chains::Chain chain{};  ///< that of a floor
  };
  struct Upwards {
    using is_transparent = void;
    const Sweep* sweep;
    bool operator()(const Cut& a, const Cut& b) const { return sweep->below(a.edge, b.edge); }
    bool operator()(const Cut& a, const Point2d& p) const { return sweep->side_of(a.edge, p) == Side::left; }
  };
  using Status = std::set<Cut, Upwards>;
  using Place = Status::const_iterator;

  Index end(Index edge) const { return edge + 1 == size_ ? 0 : edge + 1; }
  bool forward(Index edge) const { return rank_[edge] < rank_[end(edge)]; }
  Index first(Index edge) const { return forward(edge) ? edge : end(edge); }
  Index last(Index edge) const { return forward(edge) ? end(edge) : edge; }

  Side side_of(Index edge, const Point2d& p) const {
    return stages::orientation::ask(ring_[first(edge)], ring_[last(edge)], p).noting(latest_);
  }

  /// Orders two edges, one of which begins now: its start is above or below the other, or they begin together.
  bool below(Index a, Index b) const {
    const Index start_a = first(a), start_b = first(b);
    if (start_a == start_b) return side_of(b, ring_[last(a)]) == Side::right;
    return rank_[start_a] < rank_[start_b] ? side_of(a, ring_[start_b]) == Side::left
                                           : side_of(b, ring_[start_a]) == Side::right;
  }

  /// Tests two neighbours in the order, b above a. Edges of one vertex meet nowhere else: an edge that begins on
  /// another edge, or in its direction at a common start, was refused there.
  bool meet(Index a, Index b) const {
    const auto &p = ring_[a], &q = ring_[end(a)], &r = ring_[b], &s = ring_[end(b)];
    if (std::max(p.y, q.y) < std::min(r.y, s.y) || end(a) == b || end(b) == a) return false;
    const Segment2d one{p, q}, other{r, s};
    const SegmentRelation found = stages::segment_segment::decision::ask(one, other).noting(latest_);
    return found != SegmentRelation::disjoint;
  }

  bool apart_from_below(Place place) const {
    return place == cut_.begin() || !meet(std::prev(place)->edge, place->edge);
  }
  bool apart_from_above(Place place) const {
    return std::next(place) == cut_.end() || !meet(place->edge, std::next(place)->edge);
  }

  /// Inserts vertex v into the order; returns false if an edge meets another.
  bool passes(Index v) {
    const Index out = v, in = v == 0 ? static_cast<Index>(size_ - 1) : v - 1;
    const bool out_begins = forward(out), in_begins = !forward(in);
    if (out_begins && in_begins) return begin(v, in, out);
    if (!out_begins && !in_begins) return finish(v, in, out);
    return go_on(v, out_begins ? in : out, out_begins ? out : in);
  }

  bool go_on(Index v, Index old, Index now) {
    const Place place = places_[now] = places_[old];
    place->edge = now;
    if (!apart_from_below(place) || !apart_from_above(place)) return false;
    if (chains_ == nullptr) return true;
    if (place->floor) {
      chains_->join_below(place->chain, v);
    } else {
      chains_->join_above(std::prev(place)->chain, v);
    }
    return true;
  }

  bool begin(Index v, Index in, Index out) {
    const Place above = cut_.lower_bound(ring_[v]);
    if (above != cut_.end() && side_of(above->edge, ring_[v]) == Side::on) return false;
    const Side turn = side_of(in, ring_[last(out)]);
    if (turn == Side::on) return false;  // both go the same way
    const Index lower = turn == Side::left ? in : out, upper = turn == Side::left ? out : in;
    const bool inside = above != cut_.end() && !above->floor;
    const Place high = places_[upper] = cut_.emplace_hint(above, Cut{upper, inside});
    const Place low = places_[lower] = cut_.emplace_hint(high, Cut{lower, !inside});
    if (!apart_from_below(low) || !apart_from_above(high)) return false;
    if (chains_ == nullptr) return true;
    if (inside) {
      high->chain = chains_->split(std::prev(low)->chain, v);
    } else {
      low->chain = chains_->alone(v);
    }
    return true;
  }

  bool finish(Index v, Index in, Index out) {
    Place low = places_[in], high = places_[out];
    if (std::next(low) != high) std::swap(low, high);
    if (std::next(low) != high) return false;
    if (chains_ != nullptr) {
      if (low->floor) {
        chains_->close(low->chain, v);
      } else {
        chains_->unite(std::prev(low)->chain, high->chain, v);
      }
    }
    const Place above = cut_.erase(low, std::next(high));
    return above == cut_.end() || apart_from_below(above);
  }

  const Polygon2d& ring_;
  std::size_t size_;
  Chains* chains_;
  std::vector<Index> order_, rank_;
  std::vector<Place> places_;
  Status cut_;
  mutable Stage latest_ = Stage::filter;
};

}  // namespace

bool simple_by_sweep(const Polygon2d& ring) { return Sweep(ring, nullptr).simple(); }

std::optional<Decided<std::vector<std::vector<Index>>>> triangulated_by_sweep(const Polygon2d& ring) {
  Chains chains(ring);
  Sweep sweep(ring, &chains);
  if (!sweep.simple()) return std::nullopt;
  return Decided<std::vector<std::vector<Index>>>{std::move(chains.triangles()),
                                                  std::max(sweep.latest(), chains.latest())};
}

}  // namespace touchstone::robust
