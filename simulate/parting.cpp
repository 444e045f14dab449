// SPDX-License-Identifier: Apache-2.0
#include "simulate/parting.h"

#include "catalogue/operation/operation.h"

namespace touchstone::simulate {
namespace {

/// The enumerator of an answer, which decides the course of a step.
std::string word_of(const Json& answer) {
  if (answer.is_string()) return answer.get<std::string>();
  if (answer.contains("option_2")) return word_of(answer["option_2"]);
  for (const auto& [name, part] : answer.items())
    if (part.is_string()) return part.get<std::string>();
  return "";
}

bool same_question(const Asked& a, const Asked& b) {
  return a.touch == b.touch && std::string(a.operation) == b.operation;
}

/// The answer in the catalogue's form.
Asked named(Asked asked) {
  if (!asked.answer.is_string()) return asked;
  Json answer = Json::object();
  answer[catalogue::find_operation(asked.operation)->metadata().answer] = asked.answer;
  asked.answer = std::move(answer);
  return asked;
}

bool about_time(const Asked& asked) {
  const Json& answer = asked.answer;
  return answer.is_object() &&
         (answer.contains("t") || (answer.contains("option_2") && answer["option_2"].contains("t")));
}

}  // namespace

std::optional<Parting> parting(std::uint64_t step, const Run& first, const State<double>& before_first,
                               const Run& second, const State<double>& before_second) {
  const Log a = first.log_from(before_first), b = second.log_from(before_second);
  std::size_t last_time = a.size();
  for (std::size_t i = 0; i < a.size() && i < b.size() && same_question(a[i], b[i]); ++i) {
    if (word_of(a[i].answer) != word_of(b[i].answer))
      return Parting{step, first.name(), second.name(), a[i].touch, named(a[i]), named(b[i])};
    if (about_time(a[i])) last_time = i;
  }
  if (last_time == a.size()) return std::nullopt;
  return Parting{step, first.name(), second.name(), a[last_time].touch, named(a[last_time]), named(b[last_time])};
}

std::string name_of(const Scene& scene, const Touch& touch) {
  const std::string& other = touch.wall ? scene.walls[touch.other].name : scene.bodies[touch.other].name;
  return scene.bodies[touch.body].name + " and " + other;
}

}  // namespace touchstone::simulate
