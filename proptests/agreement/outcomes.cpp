// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>

#include "audit/judge/compare.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"
#include "proptests/robust_bits.h"

namespace touchstone::proptests {
namespace {

constexpr std::uint64_t drawn_of_a_family = 1500;

/// The first enumeration of an answer's type: the operation's possible outcomes ("value" where it has none).
template <class T>
std::set<std::string> words_of() {
  std::set<std::string> words;
  if constexpr (audit::Enumeration<T>) {
    for (const char* word : audit::Words<T>::words) words.insert(word);
  } else if constexpr (audit::Composite<T>) {
    audit::for_each_member<T>([&](const auto& member) {
      using Part = std::remove_cvref_t<decltype(std::declval<T>().*member.pointer)>;
      if constexpr (audit::Enumeration<Part>) {
        if (words.empty()) words = words_of<Part>();
      }
    });
  }
  return words.empty() ? std::set<std::string>{"value"} : words;
}

std::set<std::string> possible_outcomes(const Operation& operation) {
  std::set<std::string> words;
  audit::for_each_row([&]<class Row>() {
    if (&Row::card() == &operation.card()) words = words_of<audit::answer_t<Row>>();
  });
  return words;
}

struct Reached {
  std::map<std::string, std::uint64_t> outcomes;
  std::set<std::string> refusals;
};

Reached reached_by(const Operation& operation, std::size_t family) {
  Reached reached;
  for (std::uint64_t i = 0; i < drawn_of_a_family; ++i) {
    Choices choices = Choices::seeded(audit::seed_of(1, operation.families()[family].c_str(), i));
    try {
      ++reached.outcomes[operation.examine(operation.draw(choices, family))->outcome()];
    } catch (const InvalidInput& refused) {
      reached.refusals.insert(refused.what());
    }
  }
  return reached;
}

bool is_hard_case(const Operation& operation, const std::string& family) {
  const auto& names = operation.families();
  return std::find(names.begin(), names.end(), family + "+ulp") != names.end();
}

}  // namespace

EACH_OPERATION("every outcome is reached, and every family asks what it is meant to ask") {
  std::set<std::string> missing = possible_outcomes(operation);
  const std::set<std::string> possible = missing;
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    const std::string& name = operation.families()[family];
    INFO(name);
    const Reached reached = reached_by(operation, family);
    for (const auto& [outcome, count] : reached.outcomes) {
      CHECK(possible.count(outcome) == 1);
      missing.erase(outcome);
    }
    for (const std::string& refusal : reached.refusals) CHECK(refusal.find("finite number") == std::string::npos);
    // A family without a legal question is one that breaks a rule of its shape on purpose: always the same one, and only there.
    if (reached.outcomes.empty()) {
      CHECK(reached.refusals.size() == 1);
      CHECK(is_hard_case(operation, name));
    }
  }
  INFO("outcomes that no family reaches: " << Catch::Detail::stringify(missing));
  CHECK(missing.empty());
}

}  // namespace touchstone::proptests
