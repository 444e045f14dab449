// SPDX-License-Identifier: Apache-2.0
#include "proptests/drawn.h"

#include <algorithm>

#include "testing/rapidcheck.h"

namespace touchstone::proptests {

namespace {

constexpr std::uint64_t least_cases = 8;

/// A generator that asks for a complaint about a whole batch from one seed, and gives RapidCheck the first question
/// about which there is one (or the last question): RapidCheck then judges that one question, and shrinks it.
/// RapidCheck's own picks would be several times slower than the questions.
rc::Gen<Drawn> questions(const Operation& operation, std::size_t family, const Complaint& complaint,
                         std::uint64_t size) {
  return [&operation, family, &complaint, size](const rc::Random& random, int) {
    const std::uint64_t seed = rc::Random(random).next();
    std::uint64_t at = 0;
    for (; at + 1 < size; ++at) {
      Choices choices = Choices::seeded(audit::seed_of(seed, "", at));
      if (!complaint(operation.draw(choices, family)).empty()) break;
    }
    return tests::shrinkable(recorded(operation, family, audit::seed_of(seed, "", at)));
  };
}

}  // namespace

void never(const Operation& operation, const std::string& sentence, const Complaint& complaint, int usual,
           std::uint64_t size) {
  // A test's name begins with the operation, which is said of every family.
  std::string told = sentence;
  const std::string prefix = operation.name() + ": ";
  if (const auto at = told.find(prefix); at != std::string::npos) told.erase(at, prefix.size());
  // A dear question is asked less often.
  const auto cases = std::max<std::uint64_t>(
      least_cases, static_cast<std::uint64_t>(usual) * size / static_cast<std::uint64_t>(operation.card().price));
  size = std::min(size, cases);
  usual = static_cast<int>(cases / size);
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    property(
        operation.name() + ", " + operation.families()[family] + ": " + told,
        [&] {
          const Drawn drawn = *questions(operation, family, complaint, size);
          const std::string said = complaint(drawn.question);
          if (!said.empty()) RC_FAIL(said);
        },
        usual);
  }
}

}  // namespace touchstone::proptests
