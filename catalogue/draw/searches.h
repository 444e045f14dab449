// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "catalogue/draw/structure_nodes.h"
#include "geometry/commands.h"

/// A search in a textbook structure, drawn to help: its nodes, what is searched for, and the bodies.
namespace touchstone::catalogue {

/// What a structure and its nodes are called.
struct StructureWords {
  const char *structure, *node, *nodes;
};

/// What a search did.
struct Search {
  StructureNodes nodes;                ///< all, those of a tree from the root down
  std::map<const void*, bool> passed;  ///< whether it went on to what is in them
  std::set<Index> compared;
};

inline Index index_of(Index body) { return body; }
inline Index index_of(const ::touchstone::reference::IndexedBox<double>& body) { return body.index; }

/// The search for one thing. `all` is the box around all bodies.
template <class Structure, class Query>
Search searched(const Structure& structure, const Aabb3d& all, const Query& query) {
  Search search{nodes_of(structure, all), {}, {}};
  structure.search(
      query, [&](const auto& body) { search.compared.insert(index_of(body)); },
      [&](const auto& node, bool entered) { search.passed[&node] = entered; });
  return search;
}

/// How many comparisons with bodies it takes.
template <class Structure, class Query>
std::size_t comparisons_of(const Structure& structure, const Query& query) {
  std::size_t comparisons = 0;
  structure.search(query, [&comparisons](const auto&) { ++comparisons; });
  return comparisons;
}

/// The searches for all pairs, one for each body. A body that is in several nodes may be compared several times.
struct SearchesForPairs {
  std::size_t bodies = 0, comparisons = 0;
};

/// The nodes, those that were entered first where there are too many; and in words what was passed. `sought`: "what
/// meets in_box".
void draw_search(Drawing& drawing, const Search& search, const StructureWords& words, const std::string& sought,
                 std::size_t bodies, const std::optional<SearchesForPairs>& pairs);
/// The same where there is no body.
void draw_no_search(Drawing& drawing, const StructureWords& words);

/// A body in the colour that all bodies have, and again in that of the truth where it is `met`.
void draw_body(Drawing& drawing, Index index, const SpaceFigure& volume, bool met);

/// The box, point or ray of a query; a ray also as far as it goes within `all`. None of `pairs`.
void draw_query(Drawing& drawing, const Commandd& query, const Aabb3d& all);
/// What a query asks for: "what meets in_box". Not of `pairs`.
std::string sought_by(const Commandd& query);

/// The drawing as seen along z, as figures in the plane.
void seen_from_above(Drawing& drawing);

/// The bodies that are in a pair with this one.
std::set<Index> partners_of(Index body, const std::vector<IndexPair>& pairs);
/// The first body of the first pair, or else `other`.
Index told_of(const std::vector<IndexPair>& pairs, Index other);
/// The bodies of a reply; to `pairs`, those that meet `searched`.
std::set<Index> replied(const QueryReply& reply, Index searched);

/// Bodies alone; with a query and which of them its reply names.
void draw_bodies(Drawing& drawing, const ::touchstone::reference::IndexedBoxes<double>& bodies);
void draw_bodies(Drawing& drawing, const ::touchstone::reference::IndexedBoxes<double>& bodies, const Commandd& query,
                 const QueryReply& reply);

/// Bodies, the last query of a program, its reply, and what the structure does to find it; of `pairs` the search for
/// what meets one of them.
template <class Structure>
void draw_in_structure(Drawing& drawing, const StructureWords& words,
                       const ::touchstone::reference::IndexedBoxes<double>& bodies, const Commandd& query,
                       const QueryReply& reply) {
  namespace reference = ::touchstone::reference;
  if (bodies.empty()) {
    draw_query(drawing, query, {});
    return draw_no_search(drawing, words);
  }
  const Structure structure(bodies);
  const Aabb3d all = reference::around(bodies);
  const auto show = [&](const auto& of, const std::string& sought,
                        const std::optional<SearchesForPairs>& pairs = std::nullopt) {
    draw_search(drawing, searched(structure, all, of), words, sought, bodies.size(), pairs);
  };
  Index one = bodies[0].index;
  if (const auto* box = std::get_if<InBoxd>(&query)) {
    show(reference::BoxQuery<double>{box->box}, sought_by(query));
  } else if (const auto* at = std::get_if<AtPointd>(&query)) {
    show(reference::BoxQuery<double>{reference::box_of(at->point)}, sought_by(query));
  } else if (const auto* along = std::get_if<AlongRayd>(&query)) {
    show(reference::RayQuery<double>{along->ray}, sought_by(query));
  } else {
    if (const auto* pairs = std::get_if<PairsReply>(&reply)) one = told_of(pairs->pairs, one);
    SearchesForPairs both{bodies.size()};
    Aabb3d box{};
    for (const auto& body : bodies) {
      both.comparisons += comparisons_of(structure, reference::BoxQuery<double>{body.box});
      if (body.index == one) box = body.box;
    }
    show(reference::BoxQuery<double>{box}, "what meets body " + std::to_string(one), both);
    SpaceFigure figure = volume_figure(box);
    figure.label = "box of body " + std::to_string(one);
    drawing.space.push_back(std::move(figure));
  }
  draw_query(drawing, query, all);
  const std::set<Index> met = replied(reply, one);
  for (const auto& [index, box] : bodies) draw_body(drawing, index, volume_figure(box), met.count(index) > 0);
}

/// The same of a list of solids in a hierarchy of spheres, which is searched by the ball around one of them.
template <class Solid>
void draw_in_balls(Drawing& drawing, const StructureWords& words, const std::vector<Solid>& solids,
                   const std::vector<IndexPair>& truth) {
  namespace reference = ::touchstone::reference;
  if (solids.empty()) return draw_no_search(drawing, words);
  std::vector<std::pair<Index, Solid>> in_order;
  for (Index i = 0; i < solids.size(); ++i) in_order.emplace_back(i, solids[i]);
  const reference::SphereHierarchy<double, Solid> hierarchy(in_order);
  const Index one = told_of(truth, 0);
  SearchesForPairs pairs{solids.size()};
  for (const Solid& solid : solids) pairs.comparisons += comparisons_of(hierarchy, reference::ball_around(solid));
  const Sphere3d ball = reference::ball_around(solids[one]);
  const std::string name = "body " + std::to_string(one);
  draw_search(drawing, searched(hierarchy, Aabb3d{}, ball), words, "what meets " + name, solids.size(), pairs);
  SpaceFigure sought = volume_figure(ball);
  sought.label = "ball of " + name;
  drawing.space.push_back(std::move(sought));
  const std::set<Index> met = partners_of(one, truth);
  for (Index i = 0; i < solids.size(); ++i) draw_body(drawing, i, volume_figure(solids[i]), met.count(i) > 0);
}

}  // namespace touchstone::catalogue
