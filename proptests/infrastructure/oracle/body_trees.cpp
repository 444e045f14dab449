// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "catalogue/operation/probes/explained.h"
#include "oracle/broad_phase/broad_phase.h"
#include "oracle/certificates/check.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"
#include "robust/broad_phase/broad_phase.h"

/// Queries of so many bodies that they are proved along a tree: right, in few proofs, and refused where tampered with.
namespace touchstone::proptests::body_trees_tests {
namespace {

using catalogue::DrawStream;
using nlohmann::json;
using oracle::Certificate;
using oracle::Rational;
using Boxes = std::vector<Aabb3d>;
using Commands = std::vector<Commandd>;

struct Program {
  Boxes boxes;
  Commands commands;
};

double coordinate(DrawStream& draws, double room) { return static_cast<double>(draws.below(64)) * room / 64; }
Point3d point(DrawStream& draws, double room) {
  const double x = coordinate(draws, room), y = coordinate(draws, room);
  return {x, y, coordinate(draws, room)};
}
Aabb3d box(DrawStream& draws, double room) {
  const Point3d low = point(draws, room);
  const auto size = [&draws] { return static_cast<double>(draws.below(5)) / 4; };
  const double x = low.x + size(), y = low.y + size();
  return {low, {x, y, low.z + size()}};
}

/// Queries of all sorts but pairs, and between them bodies that move, go and come.
Program program(std::uint64_t seed, std::size_t bodies, std::size_t commands, bool with_rays) {
  DrawStream draws = DrawStream::seeded(seed);
  const double room = 8;
  Program made;
  std::vector<Index> there;
  for (Index i = 0; i < bodies; ++i) made.boxes.push_back(box(draws, room)), there.push_back(i);
  auto next = static_cast<Index>(bodies);
  while (made.commands.size() < commands) {
    switch (draws.below(8)) {
      case 0: made.commands.emplace_back(Insertd{box(draws, room)}), there.push_back(next++); break;
      case 1: made.commands.emplace_back(Moved{there[draws.below(there.size())], box(draws, room)}); break;
      case 2: {
        const auto gone = there.begin() + static_cast<std::ptrdiff_t>(draws.below(there.size()));
        made.commands.emplace_back(Remove{*gone}), there.erase(gone);
        break;
      }
      case 3:
      case 4: made.commands.emplace_back(InBoxd{box(draws, room)}); break;
      case 5:
        if (with_rays) {
          const Point3d to = point(draws, room);
          made.commands.emplace_back(AlongRayd{{point(draws, room), {to.x - 4, to.y - 4, to.z - 3.9375}}});
          break;
        }
        [[fallthrough]];
      default: made.commands.emplace_back(AtPointd{point(draws, room)});
    }
  }
  return made;
}

bool meet(const Aabb3d& a, const Aabb3d& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

const catalogue::Operation& operation() { return *catalogue::find_operation("broad_phase"); }

json written(const Aabb3d& box) {
  return {{"min", {box.min.x, box.min.y, box.min.z}}, {"max", {box.max.x, box.max.y, box.max.z}}};
}
json written(const Commandd& command) {
  if (const auto* insert = std::get_if<Insertd>(&command)) return {{"insert", written(insert->box)}};
  if (const auto* move = std::get_if<Moved>(&command)) return {{"move", move->body}, {"box", written(move->box)}};
  if (const auto* remove = std::get_if<Remove>(&command)) return {{"remove", remove->body}};
  if (const auto* in = std::get_if<InBoxd>(&command)) return {{"in_box", written(in->box)}};
  if (const auto* at = std::get_if<AtPointd>(&command)) return {{"at_point", {at->point.x, at->point.y, at->point.z}}};
  const auto& [o, d] = std::get<AlongRayd>(command).ray;
  return {{"along_ray", {{"origin", {o.x, o.y, o.z}}, {"direction", {d.x, d.y, d.z}}}}};
}
json claim_of(const Program& program) {
  json input{{"boxes", json::array()}, {"commands", json::array()}};
  for (const Aabb3d& box : program.boxes) input["boxes"].push_back(written(box));
  for (const Commandd& command : program.commands) input["commands"].push_back(written(command));
  const auto question = operation().parse(catalogue::parse_line(input.dump()));
  return catalogue::claim_of(*operation().examine(question));
}

std::string verdict(const json& claim) { return certify::refuse(claim).value_or("accepted"); }

bool python_says(const json& claim, const std::string& words) {
  // The script wants twenty claims.
  const LinesInFile claims("body_trees.jsonl", std::vector(20, claim.dump())),
      verdicts("body_trees.txt", std::vector(20, words));
  return python_finds_nothing("proptests/infrastructure/oracle/checkers_agree.py " + claims.path() + " " +
                              verdicts.path());
}

std::size_t size_of(const Certificate& certificate) {
  std::size_t size = 1;
  for (const auto& [name, proofs] : certificate.parts)
    for (const Certificate& proof : proofs) size += size_of(proof);
  return size;
}

}  // namespace

TEST_CASE("queries by a tree: the bodies that brute force finds, and the least margin of each body alone") {
  const auto [boxes, commands] = program(1, 100, 400, false);
  const auto truth = oracle::broad_phase(boxes, commands);
  std::vector<std::optional<Aabb3d>> there(boxes.begin(), boxes.end());
  std::optional<Rational> least;
  std::size_t query = 0;
  for (const Commandd& command : commands) {
    if (const auto* insert = std::get_if<Insertd>(&command)) there.emplace_back(insert->box);
    else if (const auto* move = std::get_if<Moved>(&command)) there[move->body] = move->box;
    else if (const auto* remove = std::get_if<Remove>(&command)) there[remove->body].reset();
    if (!is_query(command)) continue;
    const auto* at = std::get_if<AtPointd>(&command);
    const Aabb3d asked = at != nullptr ? Aabb3d{at->point, at->point} : std::get<InBoxd>(command).box;
    std::vector<Index> expected;
    for (Index i = 0; i < there.size(); ++i) {
      if (!there[i]) continue;
      if (meet(*there[i], asked)) expected.push_back(i);
      const auto alone = oracle::broad_phase({*there[i]}, Commands{command});
      if (!least || *alone.margin < *least) least = alone.margin;
    }
    CHECK(std::get<BodiesReply>(truth.answer[query++]).bodies == expected);
  }
  CHECK(query == truth.answer.size());
  CHECK(truth.margin == least);
}

TEST_CASE("queries by a tree: the margin of boxes that are all apart, which prunes nodes, is that of the nearest") {
  Boxes boxes;
  for (int i = 0; i < 200; ++i) boxes.push_back({{10.0 * i, 0, 0}, {10.0 * i + 1, 1, 1}});
  // The 120th ends at 1191; the point is 2 beyond, and the ray passes it at a distance of 0.5.
  CHECK(oracle::broad_phase(boxes, Commands{AtPointd{{1193, 0.5, 0.5}}}).margin == Rational(4));
  const auto along = oracle::broad_phase(boxes, Commands{AlongRayd{{{1190.5, 1.5, 5}, {0, 0, -1}}}});
  CHECK(along.margin == Rational(1, 4));
  CHECK(std::get<RayReply>(along.answer[0]).in_order.empty());
}

TEST_CASE("queries by a tree: both checkers accept the certificate, while bodies move, go and come") {
  for (const std::uint64_t seed : {2, 3, 4}) {
    // Few bodies and many commands: trees are made anew.
    const json claim = claim_of(program(seed, 40, 300, true));
    CHECK(verdict(claim) == "accepted");
    CHECK(python_says(claim, "accepted"));
    CHECK(claim["certificate"]["trees"].size() > 1);
  }
}

TEST_CASE("queries by a tree: robust finds the same along rays") {
  const auto [boxes, commands] = program(5, 300, 200, true);
  CHECK(oracle::broad_phase(boxes, commands).answer == robust::broad_phase(boxes, commands));
}

TEST_CASE("queries by a tree: a certificate has far fewer proofs than pairs of a body and a query") {
  DrawStream draws = DrawStream::seeded(6);
  Program many;
  for (int i = 0; i < 4000; ++i) many.boxes.push_back(box(draws, 64));
  for (int i = 0; i < 200; ++i) many.commands.emplace_back(AtPointd{point(draws, 64)});
  // Of 4,000 bodies in leaves of 16 at most, a point that is in few boxes opens some ways through 8 levels.
  CHECK(size_of(oracle::broad_phase(many.boxes, many.commands).certificate()) < 200 * 200);
}

TEST_CASE("queries by a tree: what is tampered with is refused, by both checkers in the same words") {
  const json genuine = claim_of({program(7, 40, 0, false).boxes, {AtPointd{{4, 4, 4}}}});
  REQUIRE(verdict(genuine) == "accepted");
  const auto refused = [&genuine](const std::string& words, const auto& tamper) {
    json claim = genuine;
    json& certificate = claim["certificate"];
    tamper(claim, certificate["trees"][0], certificate["replies"][0]["each"]);
    CHECK(verdict(claim) == words);
    CHECK(python_says(claim, words));
  };
  refused("certificate: the order has a place twice",
          [](json&, json& tree, json&) { tree["order"][3] = tree["order"][5]; });
  refused("certificate: not an index", [](json&, json& tree, json&) { tree["order"][3] = "40"; });
  refused("certificate: a node without bodies", [](json&, json& tree, json&) { tree["cuts"][0] = "40"; });
  refused("certificate: the tree has too few nodes",
          [](json&, json& tree, json&) { tree["cuts"].erase(tree["cuts"].size() - 1); });
  refused("certificate: the tree has too many nodes", [](json&, json& tree, json&) { tree["cuts"].push_back("0"); });
  refused("certificate: a proof for each body", [](json&, json&, json& each) { each.erase(each.size() - 1); });
  refused("certificate: a proof for each body", [](json&, json&, json& each) { each.push_back(each.back()); });
  refused("certificate: a node is not apart", [](json& claim, json&, json& each) {
    each[0] = {{"kind", "common_point"}, {"point", {"4", "4", "4"}}};
    claim["truth"]["replies"][0]["bodies"] = json::array();
  });
  refused("certificate: a body is not apart", [](json&, json&, json& each) {
    each[0] = {{"kind", "gap"}, {"axis", {"0"}}};
  });
  refused("certificate: not an index",
          [](json& claim, json&, json&) { claim["certificate"]["replies"][0]["tree"] = {"1"}; });
  refused("certificate: a tree of no query", [](json& claim, json& tree, json&) {
    const json other = tree;
    claim["certificate"]["trees"].push_back(other);
  });
  // A body that is in no leaf needs a proof of its own; `open` is none.
  refused("certificate: no such kind for this truth", [](json&, json& tree, json&) {
    tree["order"] = json::array();
    tree["cuts"] = json::array();
  });
}

TEST_CASE("queries by a tree: one that is too deep is refused") {
  constexpr int bodies = 4200;
  json claim{{"op", "broad_phase"}, {"truth", {{"replies", {{{"bodies", json::array()}}}}}}};
  claim["input"] = {{"boxes", json::array()}, {"commands", {{{"at_point", {5, 0, 0}}}}}};
  json tree{{"kind", "tree"}, {"order", json::array()}, {"cuts", json::array()}};
  for (int i = 0; i < bodies; ++i) {
    claim["input"]["boxes"].push_back(written(Aabb3d{{0, 0, 0}, {1, 1, 1}}));
    tree["order"].push_back(std::to_string(i));
    // Each node's first child has one body, and its second all others.
    if (i + 1 < bodies) tree["cuts"].push_back("1");
    tree["cuts"].push_back("0");
  }
  const json gap{{"kind", "gap"}, {"axis", {"0"}}};
  claim["certificate"] = {
      {"kind", "replies"}, {"replies", {{{"kind", "by_tree"}, {"tree", {"0"}}, {"each", {gap}}}}}, {"trees", {tree}}};
  CHECK(verdict(claim) == "certificate: the tree is too deep");
  CHECK(python_says(claim, "certificate: the tree is too deep"));
}

}  // namespace touchstone::proptests::body_trees_tests
