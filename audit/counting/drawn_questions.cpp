// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/drawn_questions.h"

#include <algorithm>

#include "audit/counting/judged.h"
#include "catalogue/codec/did_you_mean.h"

namespace touchstone::audit {
namespace {

using Visit = std::function<void(const std::string& family, std::uint64_t index, const Examination&)>;

/// After this many questions in a row that are outside the contract, or not of ordinary magnitude, a family is given
/// up.
constexpr std::uint64_t most_refused = 1000;

/// One family's questions within the contract, in the order in which an audit of the same seed asks them.
class Questions {
 public:
  Questions(const Operation& operation, std::size_t family, const DrawOptions& options)
      : operation_(&operation), family_(family), options_(&options) {}

  /// Returns whether there was one: false after a thousand unwanted ones in a row.
  bool visit_next(const Visit& visit) {
    for (std::uint64_t refused = 0; refused < most_refused; ++refused) {
      const std::uint64_t index = index_++;
      DrawStream draws = case_draws(*operation_, family_, options_->seed, index);
      Question question = operation_->draw(draws, family_);
      if (options_->binary32) question = operation_->in_binary32(question);
      if (options_->ordinary_only && range_of(question) != Range::ordinary) continue;
      if (const auto examination = within_the_contract(question)) {
        visit(operation_->families()[family_], index, *examination);
        return true;
      }
    }
    return false;
  }
  std::string refusal() const {
    return operation_->families()[family_] + ": none of " + std::to_string(most_refused) +
           " questions is within the contract of " + operation_->name() +
           (options_->ordinary_only ? " and of ordinary size" : "");
  }

 private:
  /// nullptr if the oracle refuses the question.
  std::unique_ptr<Examination> within_the_contract(const Question& question) const {
    try {
      return operation_->examine(question);
    } catch (const InvalidInput&) {
      return nullptr;
    }
  }

  const Operation* operation_;
  std::size_t family_;
  const DrawOptions* options_;
  std::uint64_t index_ = 0;
};

}  // namespace

void draw_questions(const Operation& operation, const DrawOptions& options, const Visit& visit) {
  const std::vector<std::string>&all = operation.families(), &chosen = options.families;
  std::vector<Questions> families;
  for (std::size_t family = 0; family < all.size(); ++family) {
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), all[family]) != chosen.end())
      families.emplace_back(operation, family, options);
  }
  for (const std::string& name : chosen) {
    if (std::find(all.begin(), all.end(), name) == all.end())
      throw InvalidInput("families", name + ": " + operation.name() + " has no such family" + did_you_mean(name, all) +
                                         "; touchstone ops --json lists them");
  }
  for (std::uint64_t at = 0; at < options.cases;) {
    const std::size_t turn = at % families.size();
    if (families[turn].visit_next(visit)) {
      ++at;
    } else if (!chosen.empty() || families.size() == 1) {
      throw InvalidInput("families", families[turn].refusal());
    } else {
      families.erase(families.begin() + static_cast<std::ptrdiff_t>(turn));  // it was not requested by name
    }
  }
}

}  // namespace touchstone::audit
