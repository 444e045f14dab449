// SPDX-License-Identifier: Apache-2.0
#include "oracle/broad_phase/broad_phase.h"

#include <map>
#include <utility>

#include "geometry/validation_of_commands.h"
#include "geometry/validation_of_rays.h"
#include "oracle/broad_phase/all_pairs.h"
#include "oracle/exact/queries_of_boxes.h"
#include "oracle/exact/rational_validation.h"

namespace touchstone::oracle {
namespace {

/// The truth of one query.
struct Asked {
  QueryReply reply;
  std::optional<Rational> margin;
  std::function<Certificate()> certificate;
};

/// The bodies that are there, by their indices.
template <class Number>
struct World {
  std::map<Index, Aabb3<Number>> bodies{};
  Index next = 0;
  std::vector<Asked> asked{};

  void operator()(const Insert<Number>& command) { bodies.emplace(next++, command.box); }
  void operator()(const Move<Number>& command) { bodies.at(command.body) = command.box; }
  void operator()(const Remove& command) { bodies.erase(command.body); }
  void operator()(const Ask&) {
    std::vector<Aabb3<Number>> boxes;
    for (const auto& [name, box] : bodies) boxes.push_back(box);
    auto [pairs, margin, certificate] = all_pairs(boxes);
    const std::vector<Index> name = names();
    for (IndexPair& pair : pairs) pair = {name[pair.i], name[pair.j]};
    asked.push_back({PairsReply{std::move(pairs)}, std::move(margin), std::move(certificate)});
  }
  void operator()(const InBox<Number>& query) { each<BodiesReply>(exact(query.box)); }
  void operator()(const AtPoint<Number>& query) {
    each<BodiesReply>(Aabb3<Rational>{exact(query.point), exact(query.point)});
  }
  void operator()(const AlongRay<Number>& query) { each<RayReply>(exact(query.ray)); }

 private:
  std::vector<Index> names() const {
    std::vector<Index> names;
    for (const auto& [name, box] : bodies) names.push_back(name);
    return names;
  }
  template <class OneReply, class Query>
  void each(const Query& query) {
    std::vector<Aabb3<Rational>> boxes;
    for (const auto& [name, box] : bodies) boxes.push_back(exact(box));
    auto [met, margin, certificate] = met_by(query, boxes);
    const std::vector<Index> name = names();
    for (Index& body : met) body = name[body];
    asked.push_back({OneReply{std::move(met)}, std::move(margin), std::move(certificate)});
  }
};

template <class Number>
Truth<Replies> truth(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands) {
  validation::validate_program(
      boxes, commands, [](const std::string& field, const auto& shape) { validation::validate_numbers(field, shape); },
      [](const std::string& field, const auto& shape) { validation::validate(field, shape); });
  World<Number> world;
  for (const Aabb3<Number>& box : boxes) world(Insert<Number>{box});
  for (const Command<Number>& command : commands) std::visit([&](const auto& one) { world(one); }, command);
  Truth<Replies> found;
  std::vector<std::function<Certificate()>> proofs;
  for (auto& [reply, margin, certificate] : world.asked) {
    found.answer.push_back(std::move(reply));
    if (margin && (!found.margin || *margin < *found.margin)) found.margin = std::move(margin);
    proofs.push_back(std::move(certificate));
  }
  found.certificate = [proofs = std::move(proofs)] {
    std::vector<Certificate> each;
    for (const auto& proof : proofs) each.push_back(proof());
    return Certificate{"replies", {}, {{"replies", std::move(each)}}};
  };
  return found;
}

}  // namespace

Truth<Replies> broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Command<double>>& commands) {
  return truth(boxes, commands);
}
template <Exact Number>
Truth<Replies> broad_phase(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands) {
  return truth(boxes, commands);
}
template Truth<Replies> broad_phase(const std::vector<Aabb3<Rational>>&, const std::vector<Command<Rational>>&);

}  // namespace touchstone::oracle
