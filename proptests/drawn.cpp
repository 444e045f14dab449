// SPDX-License-Identifier: Apache-2.0
#include "proptests/drawn.h"

#include <algorithm>

#include "testing/rapidcheck.h"

namespace touchstone::proptests {

namespace {

/// A generator that asks for a complaint about a whole batch from one seed, and gives RapidCheck the first question
/// about which there is one (or the last question, at place 0): RapidCheck then judges that one question, and shrinks
/// it.
/// RapidCheck's own picks would be several times slower than the questions.
rc::Gen<Drawn> questions(const Operation& operation, std::size_t family, const ComplaintAt& complaint,
                         std::uint64_t size) {
  return [&operation, family, &complaint, size](const rc::Random& random, int) {
    const std::uint64_t seed = rc::Random(random).next();
    std::uint64_t at = 0;
    for (; at + 1 < size; ++at) {
      DrawStream draws = DrawStream::seeded(catalogue::seed_of(seed, "", at));
      if (!complaint(operation.draw(draws, family), at + 1).empty()) break;
    }
    return tests::shrinkable(recorded(operation, family, catalogue::seed_of(seed, "", at)));
  };
}

}  // namespace

std::uint64_t affordable(const Operation& operation, std::uint64_t questions, std::uint64_t least) {
  return std::max(least, questions / static_cast<std::uint64_t>(operation.metadata().cost));
}

void never_at(const Operation& operation, const std::string& sentence, const ComplaintAt& complaint, int usual,
              std::uint64_t size) {
  // A test's name begins with the operation, which is said of every family.
  std::string message = sentence;
  const std::string prefix = operation.name() + ": ";
  if (const auto at = message.find(prefix); at != std::string::npos) message.erase(at, prefix.size());
  const std::uint64_t cases = affordable(operation, static_cast<std::uint64_t>(usual) * size);
  size = std::min(size, cases);
  usual = static_cast<int>(cases / size);
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    property(
        operation.name() + ", " + operation.families()[family] + ": " + message,
        [&] {
          const Drawn drawn = *questions(operation, family, complaint, size);
          const std::string said = complaint(drawn.question, 0);
          if (!said.empty()) RC_FAIL(said);
        },
        usual);
  }
}

void never(const Operation& operation, const std::string& sentence, const Complaint& complaint, int usual,
           std::uint64_t size) {
  never_at(
      operation, sentence, [&](const Question& question, std::uint64_t) { return complaint(question); }, usual, size);
}

}  // namespace touchstone::proptests
