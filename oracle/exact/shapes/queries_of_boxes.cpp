// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/queries_of_boxes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace touchstone::oracle {
namespace {

using Box = Aabb3<Rational>;

Rational square(const Rational& x) { return Rational(x * x); }
void keep_least(std::optional<Rational>& least, const Rational& one) {
  if (!least || one < *least) least = one;
}

/// A query's box and another one.
class BoxBesideBox {
 public:
  BoxBesideBox(const Box& query, const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = axes_of_boxes[k];
      const Rational between = std::max<Rational>(box.min.*axis - query.max.*axis, query.min.*axis - box.max.*axis);
      if (!lack_ || between > *lack_) lack_ = between;
      if (!apart_ && sgn(between) > 0) apart_ = k;
      corner_.push_back(std::max(query.min.*axis, box.min.*axis));
    }
  }

  /// The distance by which one must be moved along the axes for them to meet; negative: the room to spare.
  const Rational& lack() const { return *lack_; }
  bool met() const { return sgn(*lack_) <= 0; }
  Certificate proof() const {
    if (apart_) return {"gap", {{"axis", {Rational(static_cast<std::int64_t>(*apart_))}}}};
    return {"common_point", {{"point", corner_}}};
  }

 private:
  std::optional<Rational> lack_;
  std::optional<std::size_t> apart_;
  std::vector<Rational> corner_;
};

/// The distance of a point of the ray beyond a face: excess + slope t.
struct Face {
  Rational excess, slope;
};

/// A ray and one box: the faces below and above on each axis, one after another.
class BoxOnRay {
 public:
  BoxOnRay(const Ray3<Rational>& ray, const Box& box) {
    const auto& [o, d] = ray;
    const std::array direction{d.x, d.y, d.z};
    for (std::size_t k = 0; k < 3; ++k) {
      faces_.push_back({Rational(box.min.*axes_of_boxes[k] - o.*axes_of_boxes[k]), Rational(-direction[k])});
      faces_.push_back({Rational(o.*axes_of_boxes[k] - box.max.*axes_of_boxes[k]), direction[k]});
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto& [excess, slope] = faces_[i];
      if (sgn(slope) >= 0) keep_greatest(excess, {{i, 1}});
      else enter(i, Rational(excess / -slope));
      for (std::size_t j = 0; j < faces_.size() && sgn(slope) < 0; ++j) {
        const Face& left = faces_[j];
        if (sgn(left.slope) <= 0) continue;
        const Rational both = left.slope - slope, here = left.slope / both, there = -slope / both;
        keep_greatest(Rational(here * excess + there * left.excess), {{i, here}, {j, there}});
      }
    }
  }

  /// The distance by which the ray misses the box; negative: the room to spare.
  const Rational& lack() const { return *lack_; }
  bool met() const { return sgn(*lack_) <= 0; }
  /// The time at which it passes the last of the faces that it approaches, possibly before its start.
  const Rational& entry() const { return *entry_; }
  Rational first() const { return std::max(*entry_, Rational(0)); }

  Certificate proof() const {
    if (!met()) {
      std::array<std::vector<Rational>, 2> weights{std::vector<Rational>(3), std::vector<Rational>(3)};
      for (const auto& [face, weight] : weights_) weights[face % 2][face / 2] = weight;
      return {"apart", {{"below", weights[0]}, {"above", weights[1]}}};
    }
    if (sgn(*entry_) <= 0) return {"start", {}};
    return {"entry", {{"first", {*entry_}}, {"axis", {Rational(static_cast<std::int64_t>(entered_ / 2))}}}};
  }

 private:
  using Weights = std::vector<std::pair<std::size_t, Rational>>;

  void keep_greatest(const Rational& lack, const Weights& weights) {
    if (lack_ && lack <= *lack_) return;
    lack_ = lack;
    weights_ = weights;
  }
  void enter(std::size_t face, const Rational& t) {
    if (entry_ && t <= *entry_) return;
    entry_ = t;
    entered_ = face;
  }

  std::vector<Face> faces_;
  std::optional<Rational> lack_, entry_;
  Weights weights_;
  std::size_t entered_ = 0;
};

/// The change by which the second of two consecutive boxes would become the first.
Rational lead(const BoxOnRay& one, const BoxOnRay& next) {
  return sgn(next.entry()) > 0 ? Rational(next.first() - one.first()) : Rational(-one.entry());
}

/// The bodies of a tree as a query finds them. A box around bodies lacks no more than they do.
template <class Seen, class Query>
class Search {
 public:
  Search(const Query& query, const BodyTree& tree, const Bodies& bodies, std::optional<Rational>& margin)
      : query_(query), tree_(tree), bodies_(bodies), margin_(margin) {
    if (!tree.nodes().empty() && tree.nodes()[0].box) below(0);
    for (const Index body : tree.others()) look_at(body);
    std::sort(met_.begin(), met_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  /// The bodies met, by index.
  std::vector<std::pair<Index, Seen>> met() && { return std::move(met_); }

 private:
  void look_at(Index body) {
    const auto at = bodies_.find(body);
    if (at == bodies_.end()) return;
    Seen seen(query_, at->second);
    keep_least(margin_, square(seen.lack()));
    if (seen.met()) met_.emplace_back(body, std::move(seen));
  }

  void below(std::size_t place) {
    const BodyTree::Node& node = tree_.nodes()[place];
    if (node.second == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i) look_at(tree_.order()[i]);
      return;
    }
    std::vector<std::pair<Rational, std::size_t>> children;
    for (const std::size_t child : {place + 1, node.second})
      if (const auto& box = tree_.nodes()[child].box) children.emplace_back(Seen(query_, *box).lack(), child);
    std::stable_sort(children.begin(), children.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [lack, child] : children) {
      const bool too_far = sgn(lack) > 0 && margin_ && square(lack) > *margin_;
      if (!too_far) below(child);
    }
  }

  const Query& query_;
  const BodyTree& tree_;
  const Bodies& bodies_;
  std::optional<Rational>& margin_;
  std::vector<std::pair<Index, Seen>> met_;
};

/// The proofs of a traversal from a node on: one for a node that the query misses, and `open` for others, followed by
/// the children's.
template <class Seen, class Query>
void prove(const Query& query, const BodyTree& tree, const Bodies& bodies, std::size_t place,
           std::vector<Certificate>& proofs) {
  const BodyTree::Node& node = tree.nodes()[place];
  if (!node.box) return;
  if (node.second == 0) {
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (const auto body = bodies.find(tree.order()[i]); body != bodies.end())
        proofs.push_back(Seen(query, body->second).proof());
    return;
  }
  const Seen seen(query, *node.box);
  proofs.push_back(seen.met() ? Certificate{"open", {}} : seen.proof());
  if (!seen.met()) return;
  prove<Seen>(query, tree, bodies, place + 1, proofs);
  prove<Seen>(query, tree, bodies, node.second, proofs);
}

template <class Seen, class Query>
std::vector<Certificate> all_proofs(const Query& query, const BodyTree& tree, const Bodies& bodies) {
  std::vector<Certificate> proofs;
  if (!tree.nodes().empty()) prove<Seen>(query, tree, bodies, 0, proofs);
  for (const Index body : tree.others()) proofs.push_back(Seen(query, bodies.at(body)).proof());
  return proofs;
}

}  // namespace

std::vector<Index> met_by(const Box& query, const BodyTree& tree, const Bodies& bodies,
                          std::optional<Rational>& margin) {
  std::vector<Index> found;
  for (const auto& [body, seen] : Search<BoxBesideBox, Box>(query, tree, bodies, margin).met()) found.push_back(body);
  return found;
}

std::vector<Index> met_by(const Ray3<Rational>& ray, const BodyTree& tree, const Bodies& bodies,
                          std::optional<Rational>& margin) {
  auto met = Search<BoxOnRay, Ray3<Rational>>(ray, tree, bodies, margin).met();
  std::stable_sort(met.begin(), met.end(),
                   [](const auto& a, const auto& b) { return a.second.first() < b.second.first(); });
  const auto& d = ray.direction;
  const Rational unit = std::max({Rational(abs(d.x)), Rational(abs(d.y)), Rational(abs(d.z))});
  std::vector<Index> found;
  for (std::size_t k = 0; k < met.size(); ++k) {
    found.push_back(met[k].first);
    if (k > 0) keep_least(margin, square(Rational(unit * lead(met[k - 1].second, met[k].second))));
  }
  return found;
}

std::vector<Certificate> proofs_of(const Box& query, const BodyTree& tree, const Bodies& bodies) {
  return all_proofs<BoxBesideBox>(query, tree, bodies);
}
std::vector<Certificate> proofs_of(const Ray3<Rational>& ray, const BodyTree& tree, const Bodies& bodies) {
  return all_proofs<BoxOnRay>(ray, tree, bodies);
}

bool in_interior(const Point3<Rational>& point, const Box& box) {
  return sgn(BoxBesideBox({point, point}, box).lack()) < 0;
}
bool in_interior(const Ray3<Rational>& ray, const Box& box) { return sgn(BoxOnRay(ray, box).lack()) < 0; }

}  // namespace touchstone::oracle
