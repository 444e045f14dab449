// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/not_finite.h"

#include <string>

namespace touchstone::catalogue {
namespace {

/// The member in which a field stands, "a.inertia[1][0]" -> "a.inertia", and the argument, "a".
std::string member_of(const std::string& field) {
  const std::size_t dot = field.rfind('.');
  return field.substr(0, field.find('[', dot == field.npos ? 0 : dot));
}
std::string argument_of(const std::string& field) { return field.substr(0, field.find_first_of(".[")); }

/// The field that is refused first; "" where the question is answered.
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

/// Whether a member before that of the number breaks a rule, or an argument, where it is of a member without numbers.
/// Numbers are refused before all rules, so that the name of each is had.
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

}  // namespace

Question with_not_finite(const Operation& operation, const Question& zeros, std::size_t place, double bad) {
  Question small = zeros;
  const std::vector<std::size_t> places = places_of_numbers(operation.question_shape(), zeros);
  for (std::size_t i = 0; i < places.size(); ++i) small.numbers[i] = static_cast<double>(1 + places[i] % 3);
  Question repaired = small;
  if (operation.row().repair != nullptr) operation.row().repair(repaired);
  for (const Question& base : {small, repaired, operation.map_centre()}) {
    if (place < base.numbers.size() && !broken_before(operation, base, place, bad)) return spoilt(base, place, bad);
  }
  return spoilt(small, place, bad);
}

}  // namespace touchstone::catalogue
