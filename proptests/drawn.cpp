// SPDX-License-Identifier: Apache-2.0
#include "proptests/drawn.h"

#include <rapidcheck.h>

#include <algorithm>
#include <ostream>
#include <vector>

namespace touchstone::proptests {

Drawn replayed(const Operation& operation, std::size_t family, std::vector<std::uint8_t> bytes) {
  Choices choices = Choices::replayed(bytes);
  Question question = operation.draw(choices, family);
  return {&operation, family, std::move(bytes), std::move(question)};
}

Drawn recorded(const Operation& operation, std::size_t family, std::uint64_t seed) {
  Choices choices = Choices::seeded(seed, true);
  Question question = operation.draw(choices, family);
  return {&operation, family, choices.recorded(), std::move(question)};
}

/// Found by RapidCheck: the question in decimal and in hexadecimal, and the command that asks it again.
static void showValue(const Drawn& drawn, std::ostream& os) {
  const std::string name = drawn.operation->name();
  const std::string exact = audit::one_line(drawn.operation->print_hexadecimal(drawn.question));
  os << name << ", family " << drawn.operation->families()[drawn.family] << '\n'
     << audit::one_line(drawn.operation->print(drawn.question)) << '\n'
     << exact << '\n'
     << "echo '" << exact << "' | touchstone ask " << name << " -";
}

namespace {

constexpr std::uint64_t least_cases = 8;

/// Shorter streams first, then those of smaller bytes.
std::vector<std::vector<std::uint8_t>> simpler(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::vector<std::uint8_t>> found;
  for (std::size_t length = bytes.size(); length > 0; length /= 2) {
    for (std::size_t at = 0; at + length <= bytes.size(); at += length) {
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 last = first + static_cast<std::ptrdiff_t>(length);
      std::vector<std::uint8_t> cut(bytes.begin(), first);
      cut.insert(cut.end(), last, bytes.end());
      found.push_back(std::move(cut));
      if (std::all_of(first, last, [](std::uint8_t byte) { return byte == 0; })) continue;
      std::vector<std::uint8_t> zeroed = bytes;
      std::fill_n(zeroed.begin() + static_cast<std::ptrdiff_t>(at), length, std::uint8_t{0});
      found.push_back(std::move(zeroed));
    }
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int lessened : {bytes[at] / 2, bytes[at] - 2, bytes[at] - 1}) {
      if (lessened <= 0 || lessened >= bytes[at]) continue;
      found.push_back(bytes);
      found.back()[at] = static_cast<std::uint8_t>(lessened);
    }
  }
  return found;
}

rc::Shrinkable<Drawn> shrinkable(Drawn drawn) {
  return rc::shrinkable::shrinkRecur(std::move(drawn), [](const Drawn& parent) {
    std::vector<Drawn> smaller;
    for (auto& bytes : simpler(parent.choices))
      smaller.push_back(replayed(*parent.operation, parent.family, std::move(bytes)));
    return rc::seq::fromContainer(std::move(smaller));
  });
}

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
    return shrinkable(recorded(operation, family, audit::seed_of(seed, "", at)));
  };
}

}  // namespace

void never(const Operation& operation, const std::string& sentence, const Complaint& complaint, int usual,
           std::uint64_t size) {
  // A dear question is asked less often.
  const auto cases = std::max<std::uint64_t>(
      least_cases, static_cast<std::uint64_t>(usual) * size / static_cast<std::uint64_t>(operation.card().price));
  size = std::min(size, cases);
  usual = static_cast<int>(cases / size);
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    property(
        operation.name() + ", " + operation.families()[family] + ": " + sentence,
        [&] {
          const Drawn drawn = *questions(operation, family, complaint, size);
          const std::string said = complaint(drawn.question);
          if (!said.empty()) RC_FAIL(said);
        },
        usual);
  }
}

}  // namespace touchstone::proptests
