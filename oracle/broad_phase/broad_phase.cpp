// SPDX-License-Identifier: Apache-2.0
#include "oracle/broad_phase/broad_phase.h"

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "geometry/validation.h"
#include "geometry/validation_of_commands.h"
#include "oracle/broad_phase/all_pairs.h"
#include "oracle/exact/shapes/queries_of_boxes.h"

namespace touchstone::oracle {
namespace {

/// The existing bodies, and a tree of them, which is rebuilt once the commands since then have changed more than half
/// as many bodies as it holds. Bodies of a single leaf need no tree.
class World {
 public:
  void insert(Aabb3<Rational> box) { bodies_.emplace(next_++, std::move(box)), change(); }
  void move(Index body, Aabb3<Rational> box) { bodies_.at(body) = std::move(box), change(); }
  void remove(Index body) { bodies_.erase(body), change(); }

  const Bodies& bodies() const { return bodies_; }
  bool of_one_leaf() const { return bodies_.size() <= BodyTree::largest_leaf; }
  const BodyTree& tree() {
    if (of_one_leaf()) return leaf_.emplace(bodies_);
    if (!tree_ || 2 * changes_ > tree_->order().size()) {
      tree_.emplace(bodies_), ++trees_;
      changes_ = 0;
    } else if (is_changed_) {
      tree_->refit(bodies_);
    }
    is_changed_ = false;
    return *tree_;
  }
  /// The number of trees with more than a leaf so far.
  std::size_t trees() const { return trees_; }

 private:
  void change() { ++changes_, is_changed_ = true; }

  Bodies bodies_;
  Index next_ = 0;
  std::optional<BodyTree> leaf_, tree_;
  std::size_t changes_ = 0, trees_ = 0;
  bool is_changed_ = false;
};

/// Carries out commands. Queries are passed to `asked`: pairs(world), and met(world, query, empty reply).
template <class Number, class Asked>
struct CarryOut {
  World& world;
  Asked& asked;

  void operator()(const Insert<Number>& command) const { world.insert(exact(command.box)); }
  void operator()(const Move<Number>& command) const { world.move(command.body, exact(command.box)); }
  void operator()(const Remove& command) const { world.remove(command.body); }
  void operator()(const Ask&) const { asked.pairs(world); }
  void operator()(const InBox<Number>& query) const { asked.met(world, exact(query.box), BodiesReply{}); }
  void operator()(const AtPoint<Number>& query) const {
    asked.met(world, Aabb3<Rational>{exact(query.point), exact(query.point)}, BodiesReply{});
  }
  void operator()(const AlongRay<Number>& query) const { asked.met(world, exact(query.ray), RayReply{}); }
};

template <class Number, class Asked>
Asked carried_out(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands) {
  World world;
  Asked asked;
  const CarryOut<Number, Asked> carry_out{world, asked};
  for (const Aabb3<Number>& box : boxes) carry_out(Insert<Number>{box});
  for (const Command<Number>& command : commands) std::visit(carry_out, command);
  return asked;
}

Truth<std::vector<IndexPair>> pairs_of(const World& world) {
  std::vector<Aabb3<Rational>> boxes;
  for (const auto& [body, box] : world.bodies()) boxes.push_back(box);
  return all_pairs(boxes);
}

struct Answers {
  Replies replies;
  std::optional<Rational> margin;

  void pairs(const World& world) {
    std::vector<Index> body;
    for (const auto& [index, box] : world.bodies()) body.push_back(index);
    auto [pairs, least, certificate] = pairs_of(world);
    for (IndexPair& pair : pairs) pair = {body[pair.i], body[pair.j]};
    if (least && (!margin || *least < *margin)) margin = std::move(least);
    replies.push_back(PairsReply{std::move(pairs)});
  }
  template <class Query, class Reply>
  void met(World& world, const Query& query, const Reply&) {
    replies.push_back(Reply{met_by(query, world.tree(), world.bodies(), margin)});
  }
};

struct Proofs {
  std::vector<Certificate> replies, trees;

  void pairs(const World& world) { replies.push_back(pairs_of(world).certificate()); }
  template <class Query, class Reply>
  void met(World& world, const Query& query, const Reply&) {
    const BodyTree& tree = world.tree();
    Certificate reply{"by_tree", {}, {{"each", proofs_of(query, tree, world.bodies())}}};
    if (world.of_one_leaf()) {
      reply.kind = std::is_same_v<Reply, RayReply> ? "each_along" : "each_body";
    } else {
      if (trees.size() < world.trees()) trees.push_back(tree.certificate());
      reply.facts = {{"tree", {Rational(static_cast<std::uint64_t>(trees.size() - 1))}}};
    }
    replies.push_back(std::move(reply));
  }

  Certificate certificate() && {
    Certificate all{"replies", {}, {{"replies", std::move(replies)}}};
    if (!trees.empty()) all.parts.emplace_back("trees", std::move(trees));
    return all;
  }
};

}  // namespace

template <Exact Number>
Truth<Replies> broad_phase(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands) {
  validation::validate_program(boxes, commands);
  Answers found = carried_out<Number, Answers>(boxes, commands);
  return {std::move(found.replies), std::move(found.margin),
          [boxes, commands] { return carried_out<Number, Proofs>(boxes, commands).certificate(); }};
}
template Truth<Replies> broad_phase(const std::vector<Aabb3d>&, const std::vector<Command<double>>&);
template Truth<Replies> broad_phase(const std::vector<Aabb3<Rational>>&, const std::vector<Command<Rational>>&);

}  // namespace touchstone::oracle
