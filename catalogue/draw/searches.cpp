// SPDX-License-Identifier: Apache-2.0
#include "catalogue/draw/searches.h"

#include <algorithm>
#include <cmath>

namespace touchstone::catalogue {
namespace {

/// More would cover one another, and a page with many such figures would be slow to rotate.
constexpr std::size_t most_nodes = 160, most_corners = 1500;

std::string counted(std::size_t n, const char* one, const char* more) {
  return std::to_string(n) + " " + (n == 1 ? one : more);
}

/// The parameter at which a ray leaves a box for good, as a multiple of its direction.
double last_parameter(const Ray3d& ray, const Aabb3d& box) {
  double last = HUGE_VAL;
  const auto leave = [&last](double origin, double direction, double low, double high) {
    if (direction != 0) last = std::min(last, ((direction > 0 ? high : low) - origin) / direction);
  };
  const auto& [o, v] = ray;
  leave(o.x, v.x, box.min.x, box.max.x), leave(o.y, v.y, box.min.y, box.max.y), leave(o.z, v.z, box.min.z, box.max.z);
  return last;
}

}  // namespace

void draw_search(Drawing& drawing, const Search& search, const StructureWords& words, const std::string& sought,
                 std::size_t bodies, const std::optional<SearchesForPairs>& pairs) {
  std::vector<SpaceFigure> drawn;
  for (const auto& [node, depth, figure] : search.nodes) {
    const auto passed = search.passed.find(node);
    if (figure.numbers.empty()) continue;
    drawn.push_back(figure);
    drawn.back().node = Passed{depth, passed != search.passed.end() && passed->second};
  }
  std::stable_sort(drawn.begin(), drawn.end(), [](const SpaceFigure& a, const SpaceFigure& b) {
    return a.node->entered != b.node->entered ? a.node->entered : a.node->depth < b.node->depth;
  });
  std::size_t kept = 0;
  for (std::size_t corners = 0; kept < std::min(drawn.size(), most_nodes); ++kept) {
    corners += drawn[kept].numbers.size() / 3;
    if (corners > most_corners) break;
    drawing.space.push_back(drawn[kept]);
  }
  const std::size_t left_out = drawn.size() - kept;

  const auto entered = static_cast<std::size_t>(
      std::count_if(search.passed.begin(), search.passed.end(), [](const auto& node) { return node.second; }));
  drawing.search = std::string("In the textbook ") + words.structure + ", in double, the search for " + sought +
                   " looked at " + std::to_string(search.passed.size()) + " of " +
                   counted(search.nodes.size(), words.node, words.nodes) + " and entered " + std::to_string(entered) +
                   ", and it compared " + std::to_string(search.compared.size()) + " of " +
                   counted(bodies, "body", "bodies") + ".";
  if (pairs) {
    drawing.search += " All pairs took one such search for each body, " +
                      counted(pairs->comparisons, "comparison", "comparisons") + "; the loop over all pairs takes " +
                      std::to_string(pairs->bodies * (pairs->bodies - 1) / 2) + ".";
  }
  if (left_out > 0) drawing.search += " " + counted(left_out, words.node, words.nodes) + " more are not drawn.";
}

void draw_no_search(Drawing& drawing, const StructureWords& words) {
  drawing.search = std::string("No body is there: the textbook ") + words.structure + " has no " + words.nodes + ".";
}

void draw_body(Drawing& drawing, Index index, const SpaceFigure& volume, bool met) {
  SpaceFigure figure = volume;
  figure.label = "body[" + std::to_string(index) + "]";
  drawing.space.push_back(figure);
  if (!met) return;
  figure.label.clear();
  figure.answer = true;
  drawing.space.push_back(std::move(figure));
}

void draw_query(Drawing& drawing, const Commandd& query, const Aabb3d& all) {
  const std::vector<std::string> notes = drawing.notes;
  if (const auto* box = std::get_if<InBoxd>(&query)) draw(drawing, "in_box", box->box, false);
  if (const auto* at = std::get_if<AtPointd>(&query)) draw(drawing, "at_point", at->point, false);
  if (const auto* along = std::get_if<AlongRayd>(&query)) {
    draw(drawing, "along_ray", along->ray, false);
    const auto& [origin, direction] = along->ray;
    const double last = last_parameter(along->ray, all);
    if (last > 1 && std::isfinite(last)) {
      drawing.space.push_back(
          {SpaceFigure::Kind::segment, "", coordinates_of({origin + direction, origin + last * direction}), {}});
    }
  }
  drawing.notes = notes;  // the input contains its numbers
}

void draw_bodies(Drawing& drawing, const ::touchstone::reference::IndexedBoxes<double>& bodies) {
  for (const auto& [index, box] : bodies) draw_body(drawing, index, volume_figure(box), false);
}

void draw_bodies(Drawing& drawing, const ::touchstone::reference::IndexedBoxes<double>& bodies, const Commandd& query,
                 const QueryReply& reply) {
  draw_query(drawing, query, bodies.empty() ? Aabb3d{} : ::touchstone::reference::around(bodies));
  // For `pairs`: any body that is in a pair.
  std::set<Index> met;
  if (const auto* found = std::get_if<PairsReply>(&reply)) {
    for (const auto& [i, j] : found->pairs) met.insert(i), met.insert(j);
  } else {
    met = replied(reply, 0);
  }
  for (const auto& [index, box] : bodies) draw_body(drawing, index, volume_figure(box), met.count(index) > 0);
}

std::string sought_by(const Commandd& query) {
  if (std::holds_alternative<InBoxd>(query)) return "what meets in_box";
  if (std::holds_alternative<AtPointd>(query)) return "what holds at_point";
  return "what along_ray meets";
}

void seen_from_above(Drawing& drawing) {
  for (const SpaceFigure& figure : drawing.space) {
    const std::vector<double>& n = figure.numbers;
    Figure flat{Figure::Kind::point, figure.label, {}, figure.answer, figure.said, figure.node};
    if (figure.kind == SpaceFigure::Kind::box) {
      flat.kind = Figure::Kind::polygon;
      flat.numbers = {n[0], n[1], n[3], n[1], n[3], n[4], n[0], n[4]};
    } else if (figure.kind == SpaceFigure::Kind::arrow && (n[0] != n[3] || n[1] != n[4])) {
      flat.kind = Figure::Kind::ray;
      flat.numbers = {n[0], n[1], n[3], n[4]};
    } else if (figure.kind == SpaceFigure::Kind::point || figure.kind == SpaceFigure::Kind::arrow) {
      flat.numbers = {n[0], n[1]};
    } else {
      continue;  // a ray is drawn to where it ends
    }
    drawing.figures.push_back(std::move(flat));
  }
  drawing.space.clear();
}

std::set<Index> partners_of(Index body, const std::vector<IndexPair>& pairs) {
  std::set<Index> partners;
  for (const auto& [i, j] : pairs) {
    if (i == body) partners.insert(j);
    if (j == body) partners.insert(i);
  }
  return partners;
}

Index first_of_pairs(const std::vector<IndexPair>& pairs, Index other) { return pairs.empty() ? other : pairs[0].i; }

std::set<Index> replied(const QueryReply& reply, Index searched) {
  if (const auto* pairs = std::get_if<PairsReply>(&reply)) return partners_of(searched, pairs->pairs);
  const auto* met = std::get_if<BodiesReply>(&reply);
  const std::vector<Index>& bodies = met != nullptr ? met->bodies : std::get<RayReply>(reply).in_order;
  return {bodies.begin(), bodies.end()};
}

}  // namespace touchstone::catalogue
