// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/not_finite.h"

#include <algorithm>
#include <array>
#include <string>

namespace touchstone::catalogue {
namespace {

/// The member that contains a field, "a.inertia[1][0]" -> "a.inertia", and the argument, "a".
std::string member_of(const std::string& field) {
  const std::size_t dot = field.rfind('.');
  return field.substr(0, field.find('[', dot == field.npos ? 0 : dot));
}
std::string argument_of(const std::string& field) { return field.substr(0, field.find_first_of(".[")); }

/// The field that is refused first; "" if the question is answered.
std::string refused_field(const Operation& operation, const Question& question) {
  try {
    operation.row().solve(question);
  } catch (const InvalidInput& refused) {
    return refused.field();
  }
  return "";
}

Question spoilt(Question question, std::size_t place, double bad) {
  question.numbers.at(place) = bad;
  return question;
}

/// True if a member before that of the number breaks a rule, or an argument, if the number's argument has no members.
/// Numbers are refused before all rules, which reveals the name of each.
bool broken_before(const Operation& operation, const Question& question, std::size_t place, double bad) {
  const std::string broken = refused_field(operation, question);
  if (broken.empty()) return false;
  const auto field_of = [&](std::size_t i) { return refused_field(operation, spoilt(question, i, bad)); };
  for (const auto part_of : {member_of, argument_of}) {
    for (std::size_t i = 0; i < place; ++i) {
      if (part_of(field_of(i)) == part_of(broken)) return part_of(field_of(place)) != part_of(broken);
    }
  }
  return false;
}

/// Small integers, these after repair, and the question of the failure map.
std::array<Question, 3> bases(const Operation& operation, const Question& zeros) {
  Question small = zeros;
  const std::vector<std::size_t> places = places_of_numbers(operation.question_shape(), zeros);
  for (std::size_t i = 0; i < places.size(); ++i) small.numbers[i] = static_cast<double>(1 + places[i] % 3);
  Question repaired = small;
  if (operation.row().repair != nullptr) operation.row().repair(repaired);
  return {small, repaired, operation.map_centre()};
}

/// The first base that breaks no rule that comes before the number.
const Question& first_base(const Operation& operation, const std::array<Question, 3>& all, std::size_t place,
                           double bad) {
  for (const Question& base : all)
    if (place < base.numbers.size() && !broken_before(operation, base, place, bad)) return base;
  return all[0];
}

}  // namespace

Question with_not_finite(const Operation& operation, const Question& zeros, std::size_t place, double bad) {
  return spoilt(first_base(operation, bases(operation, zeros), place, bad), place, bad);
}

std::optional<Question> with_only_not_finite(const Operation& operation, const Question& zeros, std::size_t place,
                                             double bad) {
  const std::array<Question, 3> all = bases(operation, zeros);
  const Question& asked = first_base(operation, all, place, bad);
  if (refused_field(operation, asked).empty()) return std::nullopt;
  const std::string field = refused_field(operation, spoilt(asked, place, bad));
  const auto& families = operation.families();
  const auto random =
      static_cast<std::size_t>(std::find(families.begin(), families.end(), "random") - families.begin());
  for (std::uint64_t i = 0; i < 64; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(1, "not_finite", i));
    const Question base = operation.draw(draws, random);
    if (place >= base.numbers.size() || !refused_field(operation, base).empty()) continue;
    Question question = spoilt(base, place, bad);
    if (refused_field(operation, question) == field) return question;
  }
  return std::nullopt;
}

}  // namespace touchstone::catalogue
