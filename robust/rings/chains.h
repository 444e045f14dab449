// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/polygons.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust {

/// The chains of vertices from which a sweep cuts triangles (robust/rings/sweep.h), from bottom to top, with the rest
/// of the inside to their right.
class Chains {
 public:
  /// The ends and the latest vertex, as links.
  struct Chain {
    Index bottom, top, latest;
  };

  explicit Chains(const Polygon2d& ring) : ring_(ring) {
    triangles_.reserve(ring.size() - 2);
    links_.reserve(ring.size() + ring.size() / 2);
  }

  Chain alone(Index v) {
    const Index link = linked(v);
    return {link, link, link};
  }

  /// Makes v the lower end.
  void join_below(Chain& chain, Index v) {
    const Index link = linked(v);
    Index a = chain.bottom;
    for (; links_[a].up != none && cut(links_[a].vertex, v, links_[links_[a].up].vertex); a = links_[a].up) {
    }
    connect(link, a);
    links_[link].down = none;
    if (links_[a].up == none) chain.top = a;
    chain.bottom = chain.latest = link;
  }

  /// Makes v the upper end.
  void join_above(Chain& chain, Index v) {
    const Index link = linked(v);
    Index a = chain.top;
    for (; links_[a].down != none && cut(links_[links_[a].down].vertex, v, links_[a].vertex); a = links_[a].down) {
    }
    connect(a, link);
    links_[link].up = none;
    chain.top = chain.latest = link;
  }

  /// Keeps the chain up to its latest vertex and then v; returns v, then the chain from its latest vertex on.
  Chain split(Chain& chain, Index v) {
    const Index again = linked(links_[chain.latest].vertex), up = links_[chain.latest].up;
    Chain upper{again, up == none ? again : chain.top, again};
    if (up != none) connect(again, up);
    links_[chain.latest].up = none;
    chain.top = chain.latest;
    join_above(chain, v), join_below(upper, v);
    return upper;
  }

  /// v joins the lower chain above and the upper one below, and they become one, the lower.
  void unite(Chain& lower, Chain& upper, Index v) {
    join_above(lower, v), join_below(upper, v);
    connect(lower.top, links_[upper.bottom].up);
    lower.top = upper.top;
  }

  /// v joins both ends.
  void close(const Chain& chain, Index v) {
    for (Index a = chain.bottom; links_[a].up != none; a = links_[a].up) {
      triangles_.push_back({links_[a].vertex, v, links_[links_[a].up].vertex});
    }
  }

  std::vector<std::vector<Index>>& triangles() { return triangles_; }
  Stage latest() const { return latest_; }

 private:
  static constexpr Index none = ~Index{0};
  struct Link {
    Index vertex, down, up;
  };

  Index linked(Index v) {
    links_.push_back({v, none, none});
    return static_cast<Index>(links_.size() - 1);
  }
  void connect(Index down, Index up) { links_[down].up = up, links_[up].down = down; }

  /// Cuts the triangle off if it turns left.
  bool cut(Index lower, Index v, Index upper) {
    const bool left = stages::orientation::ask(ring_[lower], ring_[v], ring_[upper]).noting(latest_) == Side::left;
    if (left) triangles_.push_back({lower, v, upper});
    return left;
  }

  const Polygon2d& ring_;
  std::vector<Link> links_;
  std::vector<std::vector<Index>> triangles_;
  Stage latest_ = Stage::filter;
};

}  // namespace touchstone::robust
