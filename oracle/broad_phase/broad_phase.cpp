// SPDX-License-Identifier: Apache-2.0
#include "oracle/broad_phase/broad_phase.h"

#include <map>
#include <utility>

#include "geometry/validation_of_commands.h"
#include "oracle/broad_phase/all_pairs.h"
#include "oracle/exact/rational_validation.h"

namespace touchstone::oracle {
namespace {

/// The bodies that are there, by their indices.
template <class Number>
struct World {
  std::map<Index, Aabb3<Number>> bodies{};
  Index next = 0;
  std::vector<Truth<std::vector<IndexPair>>> asked{};

  void operator()(const Insert<Number>& command) { bodies.emplace(next++, command.box); }
  void operator()(const Move<Number>& command) { bodies.at(command.body) = command.box; }
  void operator()(const Remove& command) { bodies.erase(command.body); }
  void operator()(const Ask&) {
    std::vector<Aabb3<Number>> boxes;
    std::vector<Index> names;
    for (const auto& [name, box] : bodies) boxes.push_back(box), names.push_back(name);
    asked.push_back(all_pairs(boxes));
    for (IndexPair& pair : asked.back().answer) pair = {names[pair.i], names[pair.j]};
  }
};

template <class Number>
Truth<Replies> truth(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands) {
  using Box = Aabb3<Number>;
  validation::validate_program(
      boxes, commands, [](const std::string& field, const Box& box) { validation::validate_numbers(field, box); },
      [](const std::string& field, const Box& box) { validation::validate(field, box); });
  World<Number> world;
  for (const Aabb3<Number>& box : boxes) world(Insert<Number>{box});
  for (const Command<Number>& command : commands) std::visit([&](const auto& one) { world(one); }, command);
  Truth<Replies> found;
  for (auto& [pairs, margin, certificate] : world.asked) {
    found.answer.push_back({std::move(pairs)});
    if (margin && (!found.margin || *margin < *found.margin)) found.margin = std::move(margin);
  }
  found.certificate = [asked = std::move(world.asked)] {
    std::vector<Certificate> each;
    for (const auto& reply : asked) each.push_back(reply.certificate());
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
