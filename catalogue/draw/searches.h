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

/// A search in a textbook structure as an auxiliary drawing: its nodes, the query, and the bodies.
namespace touchstone::catalogue {

/// The names of a structure and its nodes.
struct StructureWords {
  const char *structure, *node, *nodes;
};

/// The course of a search.
struct Search {
  StructureNodes nodes;                ///< all, those of a tree from the root down
  std::map<const void*, bool> passed;  ///< true if the search continued inside
  std::set<Index> compared;
};

inline Index index_of(Index body) { return body; }
inline Index index_of(const ::touchstone::reference::IndexedBox<double>& body) { return body.index; }

/// Runs the search for one query. `all` is the box around all bodies.
template <class Structure, class Query>
Search searched(const Structure& structure, const Aabb3d& all, const Query& query) {
  Search search{nodes_of(structure, all), {}, {}};
  structure.search(
      query, [&](const auto& body) { search.compared.insert(index_of(body)); },
      [&](const auto& node, bool entered) { search.passed[&node] = entered; });
  return search;
}

/// The number of comparisons with bodies that it takes.
template <class Structure, class Query>
std::size_t comparisons_of(const Structure& structure, const Query& query) {
  std::size_t comparisons = 0;
  structure.search(query, [&comparisons](const auto&) { ++comparisons; });
  return comparisons;
}

/// The searches for all pairs, one for each body. A body in several nodes may be compared several times.
struct SearchesForPairs {
  std::size_t bodies = 0, comparisons = 0;
};

/// Draws the nodes, starting with those that were entered if there are too many, and describes the nodes passed in
/// words. `sought`: "what meets in_box".
void draw_search(Drawing& drawing, const Search& search, const StructureWords& words, const std::string& sought,
                 std::size_t bodies, const std::optional<SearchesForPairs>& pairs);
/// The same if there is no body.
void draw_no_search(Drawing& drawing, const StructureWords& words);

/// Draws a body in the colour that all bodies have, and again in that of the truth if it is `met`.
void draw_body(Drawing& drawing, Index index, const SpaceFigure& volume, bool met);

/// Draws the box, point or ray of a query; a ray also to where it leaves `all`. Draws nothing for `pairs`.
void draw_query(Drawing& drawing, const Commandd& query, const Aabb3d& all);
/// The goal of a query in words: "what meets in_box". Not for `pairs`.
std::string sought_by(const Commandd& query);

/// Turns the drawing, as seen along z, into figures in the plane.
void seen_from_above(Drawing& drawing);

/// The bodies that are in a pair with this one.
std::set<Index> partners_of(Index body, const std::vector<IndexPair>& pairs);
/// The first body of the first pair, or else `other`.
Index first_of_pairs(const std::vector<IndexPair>& pairs, Index other);
/// The bodies of a reply; to `pairs`, those that meet `searched`.
std::set<Index> replied(const QueryReply& reply, Index searched);

/// Draws bodies alone; with a query and the bodies that its reply names.
void draw_bodies(Drawing& drawing, const ::touchstone::reference::IndexedBoxes<double>& bodies);
void draw_bodies(Drawing& drawing, const ::touchstone::reference::IndexedBoxes<double>& bodies, const Commandd& query,
                 const QueryReply& reply);

/// Draws bodies, the last query of a program, its reply, and the search of the structure for it; for `pairs` the search
/// for the bodies that meet one of them.
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
    if (const auto* pairs = std::get_if<PairsReply>(&reply)) one = first_of_pairs(pairs->pairs, one);
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

/// The same for a list of solids in a hierarchy of spheres, which is searched by the ball around one of them.
template <class Solid>
void draw_in_balls(Drawing& drawing, const StructureWords& words, const std::vector<Solid>& solids,
                   const std::vector<IndexPair>& truth) {
  namespace reference = ::touchstone::reference;
  if (solids.empty()) return draw_no_search(drawing, words);
  std::vector<std::pair<Index, Solid>> in_order;
  for (Index i = 0; i < solids.size(); ++i) in_order.emplace_back(i, solids[i]);
  const reference::SphereHierarchy<double, Solid> hierarchy(in_order);
  const Index one = first_of_pairs(truth, 0);
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
