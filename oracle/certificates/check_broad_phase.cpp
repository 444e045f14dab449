// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "oracle/certificates/check_body_tree.h"
#include "oracle/certificates/check_pair_tree.h"
#include "oracle/certificates/check_space.h"

/// The solids of a list that meet. The checks, and why they prove it:
///
/// Each listed pair has a point in common. All solids are in the order of their lower ends on one axis: a solid after
/// the first that begins beyond a solid's upper end begins beyond it too, and has no point in common with that solid.
/// Each pair that is left is listed, or its own proof shows it to be apart; of a long list, for which these proofs
/// would be longer than anything else, the two are compared here. So no pair is missing. For a program, the commands
/// are carried out on a plain list, and each reply is proved on its own: pairs like this; whatever meets a box, a point
/// or a ray by a proof for each body, in the order of their indices; or along a tree of bodies, whose boxes are
/// computed here: what misses the box around a node misses each body of it, so that one proof is enough, and bodies
/// that are in no leaf have proofs of their own behind. A ray enters a body where it crosses the plane of a face that
/// it was beyond until then, into the body. It misses a body where the inequalities of faces, with weights that are not
/// negative, sum up to c + s t <= 0 with c > 0 and s >= 0.
namespace touchstone::certify {
namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

/// A closed ball in a radius, or a closed box.
struct Solid {
  std::optional<Ball> ball;
  Box box;  ///< a ball's: the least that holds it
};

Solid solid_ball(const json& value, const std::string& what) {
  const Ball result = ball(value, what);
  const auto& [c, r] = result;
  const Box around{{c.x - r, c.y - r, c.z - r}, {c.x + r, c.y + r, c.z + r}};
  return {result, around};
}

/// Solids from either field.
std::vector<Solid> solids(const Claim& claim) {
  const bool boxes = claim.input.is_object() && claim.input.contains("boxes");
  const std::string field = boxes ? "boxes" : "spheres";
  claim.inputs({field.c_str()});
  expect(claim.input[field].is_array(), field + ": a list");
  std::vector<Solid> found;
  for (const json& value : claim.input[field]) {
    const std::string what = field + "[" + std::to_string(found.size()) + "]";
    found.push_back(boxes ? Solid{{}, box_in_space(value, what)} : solid_ball(value, what));
  }
  return found;
}

bool holds(const Solid& solid, const Triple& p) {
  if (!solid.ball) return solid.box.holds({p.x, p.y, p.z});
  const Triple from_center = p - solid.ball->center;
  return dot(from_center, from_center) <= square(solid.ball->radius);
}

/// The truth's pairs, with a common point each.
Pairs proved_to_meet(const Claim& claim, const std::vector<Solid>& solids) {
  const json &listed = list(claim.truth, "pairs", "truth.pairs"),
             &proofs = list(claim.certificate, "meet", "certificate.meet");
  expect(listed.size() == proofs.size(), "certificate: a common point for each pair");
  Pairs pairs;
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const json& pair = listed[k];
    expect(pair.is_array() && pair.size() == 2, "truth.pairs: a list of two in each place");
    for (const json& index : pair) {
      expect(index.is_number_unsigned() && index.get<std::uint64_t>() < solids.size(), "truth.pairs: not an index");
    }
    const auto i = pair[0].get<std::size_t>(), j = pair[1].get<std::size_t>();
    expect(i < j && (pairs.empty() || *pairs.rbegin() < std::pair{i, j}), "truth: the pairs are not sorted");
    const Claim proof{claim.input, claim.truth, proofs[k]};
    proof.expect_kind("common_point");
    proof.facts({"point"});
    const Triple p = triple(proof, "point");
    expect(holds(solids[i], p) && holds(solids[j], p), "certificate: a point is not in both");
    pairs.insert({i, j});
  }
  return pairs;
}

/// The pairs with a proof of their own that they are apart.
Pairs proved_apart(const Claim& claim, const std::vector<Solid>& solids) {
  Pairs pairs;
  for (const json& written : list(claim.certificate, "apart", "certificate.apart")) {
    const Claim proof{claim.input, claim.truth, written};
    const bool distance = proof.kind() == "distance";
    expect(distance || proof.kind() == "gap", wrong_kind);
    if (distance) proof.facts({"pair", "squared_distance"});
    else proof.facts({"pair", "axis"});
    const Pair named = proof.pair("pair");
    const std::size_t i = place(named.x, solids.size()), j = place(named.y, solids.size());
    expect(i < j, "certificate: not a pair i < j");
    const Solid &a = solids[i], &b = solids[j];
    if (distance) {
      expect(a.ball.has_value(), wrong_kind);
      const Triple between = b.ball->center - a.ball->center;
      const Rational squared = dot(between, between);
      expect(proof.single("squared_distance") == squared, "certificate: the squared distance is wrong");
      expect(squared > square(Rational(a.ball->radius + b.ball->radius)), "certificate: a pair is not apart");
    } else {
      const std::size_t along = axis(proof);
      expect(a.box.max[along] < b.box.min[along] || b.box.max[along] < a.box.min[along],
             "certificate: a pair is not apart");
    }
    expect(pairs.insert({i, j}).second, "certificate: a pair is listed twice");
  }
  return pairs;
}

bool are_apart(const Solid& a, const Solid& b) {
  if (a.ball) {
    const Triple between = b.ball->center - a.ball->center;
    return dot(between, between) > square(Rational(a.ball->radius + b.ball->radius));
  }
  for (std::size_t along = 0; along < 3; ++along)
    if (a.box.max[along] < b.box.min[along] || b.box.max[along] < a.box.min[along]) return true;
  return false;
}

bool of_kind_tree(const json& certificate) {
  return certificate.is_object() && certificate.contains("kind") && certificate["kind"] == "tree";
}

void check_all_pairs(const Claim& claim) {
  if (of_kind_tree(claim.certificate)) return check_pair_tree(claim);
  const std::vector<Solid> all = solids(claim);
  claim.answers({"pairs"});
  const bool compares = claim.kind() == "compared_sweep";
  if (!compares) claim.expect_kind("sweep");
  compares ? claim.facts({"axis", "order", "meet"}) : claim.facts({"axis", "order", "meet", "apart"});
  const Pairs meeting = proved_to_meet(claim, all), apart = compares ? Pairs() : proved_apart(claim, all);
  const std::size_t along = axis(claim);
  std::vector<std::size_t> order;
  std::set<std::size_t> seen;
  for (const Rational& index : claim.list("order")) {
    order.push_back(place(index, all.size()));
    expect(seen.insert(order.back()).second, "certificate: the order has a place twice");
  }
  expect(order.size() == all.size(), "certificate: the order is not of all");
  for (std::size_t p = 1; p < order.size(); ++p) {
    expect(all[order[p - 1]].box.min[along] <= all[order[p]].box.min[along],
           "certificate: the order is not that of the axis");
  }
  for (std::size_t p = 0; p < order.size(); ++p) {
    for (std::size_t q = p + 1; q < order.size() && all[order[q]].box.min[along] <= all[order[p]].box.max[along]; ++q) {
      const std::pair<std::size_t, std::size_t> pair = std::minmax({order[p], order[q]});
      const bool asunder = compares ? are_apart(all[pair.first], all[pair.second]) : apart.count(pair) == 1;
      expect((meeting.count(pair) == 1) != asunder, "certificate: a pair is left open");
    }
  }
}

/// A body by its index.
template <class Map>
auto there(Map& bodies, const json& index, const std::string& what) {
  const auto body = index.is_number_unsigned() ? bodies.find(index.get<std::uint64_t>()) : bodies.end();
  expect(body != bodies.end(), what + ": index of a body that is there");
  return body;
}

/// Boxed bodies by their indices, as commands create them. A command has one of these names.
class World {
 public:
  explicit World(const Claim& claim) {
    for (const json& box : list(claim.input, "boxes", "boxes"))
      insert(box, "boxes[" + std::to_string(bodies_.next) + "]");
  }

  /// Returns true if the command is a query.
  bool carry_out(const json& command, const std::string& what) {
    expect(command.is_object(), what + ": a command");
    if (command.contains("insert")) {
      only(command, what, {"insert"}), insert(command["insert"], what + ".insert");
      ++bodies_.changes;
    } else if (command.contains("move")) {
      only(command, what, {"move", "box"});
      BoxedBody& body = there(bodies_.there, command["move"], what + ".move")->second;
      body = {command["box"], box_in_space(command["box"], what + ".box")};
      ++bodies_.changes;
    } else if (command.contains("remove")) {
      only(command, what, {"remove"}), bodies_.there.erase(there(bodies_.there, command["remove"], what + ".remove"));
      ++bodies_.changes;
    } else {
      query(command, what);
      return true;
    }
    return false;
  }

  void check(const json& command, const json& reply, const json& certificate, BodyTrees& trees) const {
    if (command.contains("ask")) return check_pairs(reply, certificate);
    const char* const name = command.contains("along_ray") ? "in_order" : "bodies";
    only(reply, "truth.replies", {name});
    std::vector<std::uint64_t> expected;
    for (const json& index : list(reply, name, std::string("truth.") + name))
      expected.push_back(there(bodies_.there, index, std::string("truth.") + name)->first);
    expect(met_bodies({command, reply, certificate}, bodies_, trees) == expected,
           "truth: not the bodies that are proved");
  }

 private:
  static void query(const json& command, const std::string& what) {
    if (command.contains("in_box")) {
      only(command, what, {"in_box"}), box_in_space(command["in_box"], what + ".in_box");
    } else if (command.contains("at_point")) {
      only(command, what, {"at_point"}), point_in_space(command["at_point"], what + ".at_point");
    } else if (command.contains("along_ray")) {
      only(command, what, {"along_ray"}), ray_in_space(command["along_ray"], what + ".along_ray");
    } else {
      only(command, what, {"ask"}), expect(command["ask"] == "pairs", what + ".ask: pairs");
    }
  }

  /// The reply must be that of all_pairs, with the existing bodies at their positions in the list.
  void check_pairs(const json& reply, const json& certificate) const {
    only(reply, "truth.replies", {"pairs"});
    json input{{"boxes", json::array()}}, truth{{"pairs", list(reply, "pairs", "truth.pairs")}};
    for (const auto& [index, body] : bodies_.there) input["boxes"].push_back(body.written);
    for (json& pair : truth["pairs"]) {
      expect(pair.is_array() && pair.size() == 2, "truth.pairs: a list of two in each place");
      for (json& index : pair) {
        index =
            static_cast<std::size_t>(std::distance(bodies_.there.begin(), there(bodies_.there, index, "truth.pairs")));
      }
    }
    check_all_pairs({input, truth, certificate});
  }

  void insert(const json& box, const std::string& what) {
    bodies_.there.emplace(bodies_.next++, BoxedBody{box, box_in_space(box, what)});
  }

  BoxedBodies bodies_;
};

void check_broad_phase(const Claim& claim) {
  claim.inputs({"boxes", "commands"});
  // Calls see(world, command) at each query.
  const auto carry_out = [&claim](const auto& see) {
    World world(claim);
    std::size_t count = 0;
    for (const json& command : list(claim.input, "commands", "commands"))
      if (world.carry_out(command, "commands[" + std::to_string(count++) + "]")) see(world, command);
  };
  std::size_t queries = 0;
  carry_out([&queries](const World&, const json&) { ++queries; });
  claim.answers({"replies"});
  claim.expect_kind("replies");
  if (claim.certificate.contains("trees")) claim.facts({"replies", "trees"});
  else claim.facts({"replies"});
  const json &replies = list(claim.truth, "replies", "truth.replies"),
             &proofs = list(claim.certificate, "replies", "certificate.replies");
  expect(queries == replies.size() && queries == proofs.size(), "certificate: a reply and its proof for each query");
  queries = 0;
  BodyTrees trees(claim);
  carry_out([&](const World& world, const json& command) {
    world.check(command, replies[queries], proofs[queries], trees), ++queries;
  });
  trees.expect_used();
}

}  // namespace

/// The answers of other structures are proved in the same way.
Checks checks_of_broad_phase() {
  return {{"all_pairs", check_all_pairs},      {"sphere_hierarchy", check_all_pairs},
          {"broad_phase", check_broad_phase},  {"bounding_volume_hierarchy", check_broad_phase},
          {"uniform_grid", check_broad_phase}, {"quadtree", check_broad_phase},
          {"octree", check_broad_phase},       {"bsp_tree", check_broad_phase}};
}

}  // namespace touchstone::certify
