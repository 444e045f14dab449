// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_body_tree.h"

#include <algorithm>
#include <set>
#include <utility>

namespace touchstone::certify {
namespace {

Rational of_axis(const Triple& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// True if a body meets a box, according to the proof.
bool proved(const Claim& proof, const Box& query, const Box& body) {
  if (proof.kind() == "common_point") {
    proof.facts({"point"});
    const Triple p = triple(proof, "point");
    expect(query.holds({p.x, p.y, p.z}) && body.holds({p.x, p.y, p.z}), "certificate: a point is not in both");
    return true;
  }
  proof.expect_kind("gap");
  proof.facts({"axis"});
  const std::size_t along = axis(proof);
  expect(query.max[along] < body.min[along] || body.max[along] < query.min[along], "certificate: a body is not apart");
  return false;
}

/// The first t at which a ray is in a body, according to the proof; empty: never.
std::optional<Rational> proved(const Claim& proof, const RayInSpace& ray, const Box& body) {
  const auto& [o, d] = ray;
  if (proof.kind() == "apart") {
    proof.facts({"below", "above"});
    const std::vector<Rational> below = proof.list("below"), above = proof.list("above");
    expect(below.size() == 3 && above.size() == 3, "certificate: a weight for each face");
    Rational sum, slope;
    for (std::size_t k = 0; k < 3; ++k) {
      expect(sgn(below[k]) >= 0 && sgn(above[k]) >= 0, "certificate: a weight is negative");
      sum += below[k] * (body.min[k] - of_axis(o, k)) + above[k] * (of_axis(o, k) - body.max[k]);
      slope += (above[k] - below[k]) * of_axis(d, k);
    }
    expect(sgn(sum) > 0 && sgn(slope) >= 0, "certificate: the weights prove nothing");
    return std::nullopt;
  }
  const bool start = proof.kind() == "start";
  expect(start || proof.kind() == "entry", wrong_kind);
  if (start) proof.facts({});
  else proof.facts({"first", "axis"});
  const Rational first = start ? Rational(0) : proof.single("first");
  expect(sgn(first) >= 0, "certificate: before the ray starts");
  const Triple p = along(o, first, d);
  expect(body.holds({p.x, p.y, p.z}), "certificate: the ray is not in the body");
  if (!start) {
    const std::size_t k = axis(proof);
    const Rational by = of_axis(d, k), at = of_axis(p, k);
    expect((sgn(by) > 0 && at == body.min[k]) || (sgn(by) < 0 && at == body.max[k]),
           "certificate: the ray does not enter there");
  }
  return first;
}

/// The bodies that a query meets, from one proof after another.
class Met {
 public:
  Met(const json& command, const json& proofs) : command_(command), proofs_(proofs) {
    if (command.contains("along_ray")) {
      ray_ = ray_in_space(command["along_ray"], "ray");
    } else if (command.contains("in_box")) {
      box_ = box_in_space(command["in_box"], "box");
    } else {
      const Triple p = point_in_space(command["at_point"], "point");
      box_ = {{p.x, p.y, p.z}, {p.x, p.y, p.z}};
    }
  }

  void look_at(std::uint64_t body, const Box& box) {
    if (const auto first = proved_first(next(), box)) met_.emplace_back(*first, body);
  }
  /// True if the next proof leaves the box open; otherwise it shows that the query misses it.
  bool opens(const Box& box) {
    const Claim proof = next();
    if (proof.kind() == "open") {
      proof.facts({});
      return true;
    }
    expect(!proved_first(proof, box), "certificate: a node is not apart");
    return false;
  }

  /// For a ray, in the order of the first t.
  std::vector<std::uint64_t> bodies() && {
    expect(used_ == proofs_.size(), "certificate: a proof for each body");
    std::sort(met_.begin(), met_.end());
    std::vector<std::uint64_t> bodies;
    for (const auto& [first, index] : met_) bodies.push_back(index);
    return bodies;
  }

 private:
  Claim next() {
    expect(used_ < proofs_.size(), "certificate: a proof for each body");
    return {command_, command_, proofs_[used_++]};
  }
  std::optional<Rational> proved_first(const Claim& proof, const Box& body) const {
    if (ray_) return proved(proof, *ray_, body);
    if (proved(proof, box_, body)) return Rational(0);
    return std::nullopt;
  }

  const json &command_, &proofs_;
  std::optional<RayInSpace> ray_;
  Box box_;
  std::size_t used_ = 0;
  std::vector<std::pair<Rational, std::uint64_t>> met_;
};

}  // namespace

std::size_t axis(const Claim& claim) {
  const Rational which = claim.single("axis");
  expect(which == 0 || which == 1 || which == 2, "certificate: not an axis");
  return which.get_num().get_ui();
}

std::size_t place(const Rational& index, std::size_t size) {
  expect(index.get_den() == 1 && sgn(index) >= 0 && index < Rational(mpz_class(size)), "certificate: not an index");
  return index.get_num().get_ui();
}

const json& list(const json& object, const char* name, const std::string& what) {
  expect(object[name].is_array(), what + ": a list");
  return object[name];
}

RayInSpace ray_in_space(const json& value, const std::string& what) {
  only(value, what, {"origin", "direction"});
  const RayInSpace result{point_in_space(value["origin"], what + ".origin"),
                          point_in_space(value["direction"], what + ".direction")};
  expect(!(result.direction == Triple{0, 0, 0}), what + ".direction: nonzero direction");
  return result;
}

/// A tree of bodies: each is in at most one leaf.
class BodyTree {
 public:
  BodyTree(const Claim& claim, std::uint64_t bodies) {
    claim.expect_kind("tree"), claim.facts({"order", "cuts"});
    for (const Rational& index : claim.list("order")) {
      order_.push_back(place(index, bodies));
      expect(in_order_.insert(order_.back()).second, "certificate: the order has a place twice");
    }
    for (const Rational& cut : claim.list("cuts")) cuts_.push_back(place(cut, order_.size() + 1));
    if (!order_.empty()) read(0, order_.size(), 0);
    expect(nodes_.size() == cuts_.size(), "certificate: the tree has too many nodes");
  }

  void look(const BoxedBodies& bodies, Met& met) {
    if (fitted_ != bodies.changes) fit(bodies), fitted_ = bodies.changes;
    if (!nodes_.empty()) look_below(0, bodies, met);
    for (const auto& [index, body] : bodies.there)
      if (!in_order_.contains(index)) met.look_at(index, body.box);
  }

 private:
  static constexpr std::size_t deepest = 4096;
  struct Node {
    std::size_t begin, end, second = 0;  ///< the first child is the next node; second == 0: a leaf
    std::optional<Box> box{};            ///< none if no body is there
  };

  void read(std::size_t begin, std::size_t end, std::size_t depth) {
    const std::size_t at = nodes_.size();
    expect(at < cuts_.size(), "certificate: the tree has too few nodes");
    expect(depth <= deepest, "certificate: the tree is too deep");
    const std::size_t cut = cuts_[at];
    nodes_.push_back({begin, end});
    if (cut == 0) return;
    expect(cut < end - begin, "certificate: a node without bodies");
    read(begin, begin + cut, depth + 1);
    nodes_[at].second = nodes_.size();
    read(begin + cut, end, depth + 1);
  }

  static void enlarge(std::optional<Box>& around, const Box& box) {
    if (!around) around = box;
    for (std::size_t k = 0; k < 3; ++k) {
      around->min[k] = std::min(around->min[k], box.min[k]);
      around->max[k] = std::max(around->max[k], box.max[k]);
    }
  }
  void fit(const BoxedBodies& bodies) {
    for (std::size_t at = nodes_.size(); at-- > 0;) {
      Node& node = nodes_[at];
      node.box.reset();
      for (const std::size_t child : {at + 1, node.second})
        if (node.second != 0 && nodes_[child].box) enlarge(node.box, *nodes_[child].box);
      for (std::size_t i = node.begin; i < node.end && node.second == 0; ++i)
        if (const auto body = bodies.there.find(order_[i]); body != bodies.there.end())
          enlarge(node.box, body->second.box);
    }
  }
  void look_below(std::size_t at, const BoxedBodies& bodies, Met& met) const {
    const Node& node = nodes_[at];
    if (!node.box) return;
    if (node.second != 0) {
      if (met.opens(*node.box)) look_below(at + 1, bodies, met), look_below(node.second, bodies, met);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (const auto body = bodies.there.find(order_[i]); body != bodies.there.end())
        met.look_at(body->first, body->second.box);
  }

  std::vector<std::uint64_t> order_;
  std::set<std::uint64_t> in_order_;
  std::vector<std::size_t> cuts_;
  std::vector<Node> nodes_;  ///< in preorder
  std::optional<std::size_t> fitted_;
};

BodyTrees::BodyTrees(const Claim& claim) : claim_(claim) {
  if (claim.certificate.contains("trees")) trees_.resize(list(claim.certificate, "trees", "certificate.trees").size());
}
BodyTrees::~BodyTrees() = default;

BodyTree& BodyTrees::named(const Claim& query, const BoxedBodies& bodies) {
  const std::size_t which = place(query.single("tree"), trees_.size());
  std::unique_ptr<BodyTree>& tree = trees_[which];
  if (!tree)
    tree =
        std::make_unique<BodyTree>(Claim{claim_.input, claim_.truth, claim_.certificate["trees"][which]}, bodies.next);
  return *tree;
}

void BodyTrees::expect_used() const {
  for (const auto& tree : trees_) expect(tree != nullptr, "certificate: a tree of no query");
}

std::vector<std::uint64_t> met_bodies(const Claim& query, const BoxedBodies& bodies, BodyTrees& trees) {
  const bool by_tree = query.kind() == "by_tree";
  expect(by_tree || query.kind() == (query.input.contains("along_ray") ? "each_along" : "each_body"), wrong_kind);
  by_tree ? query.facts({"tree", "each"}) : query.facts({"each"});
  const json& proofs = list(query.certificate, "each", "certificate.each");
  expect(by_tree || proofs.size() == bodies.there.size(), "certificate: a proof for each body");
  Met met(query.input, proofs);
  if (by_tree) trees.named(query, bodies).look(bodies, met);
  else
    for (const auto& [index, body] : bodies.there) met.look_at(index, body.box);
  return std::move(met).bodies();
}

}  // namespace touchstone::certify
