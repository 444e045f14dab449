// SPDX-License-Identifier: Apache-2.0
#include "report/pages/condition_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/counting/audit_run.h"
#include "catalogue/operation/probes/sensitivity.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

constexpr std::uint64_t seed = 1, questions_of_a_family = 16;
constexpr std::size_t most_numbers = 48;  // of a question: each is moved, and the oracle called again
constexpr double width = 560, height = 360, least_power = -4, greatest_power = 64;

/// The position on both axes: 0 for a number of a sixteenth or less, 1 for 2^64 or more.
double part(double number) {
  const double power = std::clamp(number > 0 ? std::log2(number) : least_power, least_power, greatest_power);
  return (power - least_power) / (greatest_power - least_power);
}

}  // namespace

std::string condition_section(const Operation& operation) {
  if (operation.metadata().kind != Kind::measure || !operation.words().empty()) return "";
  std::array<std::string, range_count> dots;  // small squares
  std::array<std::uint64_t, range_count> all{}, above{};
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    for (std::uint64_t index = 0; index < questions_of_a_family; ++index) {
      DrawStream draws = case_draws(operation, family, seed, index);
      const Question question = operation.draw(draws, family);
      if (question.numbers.size() > most_numbers) continue;
      try {
        for (const auto& [condition, ulps] : sensitivities(operation, question)) {
          const auto range = static_cast<std::size_t>(range_of(question));
          dots[range] +=
              fmt::format("M{:.1f} {:.1f}h3v3h-3z", part(condition) * width - 1.5, (1 - part(ulps)) * height - 1.5);
          ++all[range];
          if (ulps > condition && ulps > 1) ++above[range];
        }
      } catch (const InvalidInput&) {
      }
    }
  }
  if (all[0] + all[1] == 0) return "";
  std::string scales;
  for (int power = 0; power <= greatest_power; power += 8) {
    const double at = part(std::ldexp(1, power));
    const std::string label = power == 0 ? "1" : fmt::format("2<tspan dy=\"-4\" font-size=\"8\">{}</tspan>", power);
    scales += fmt::format(
        "<path class=\"tick\" d=\"M{0:.1f} {1}v5M0 {2:.1f}h-5\"/><text class=\"scale\" x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{5}</text><text class=\"scale\" x=\"-8\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
        at * width, height, (1 - at) * height, height + 18, (1 - at) * height + 4, label);
  }
  return fmt::format(
      "<h2 id=\"condition\">Error against condition</h2><div class=\"card\"><p class=\"quiet\">Each dot is a "
      "number "
      "that "
      "the textbook formula in double answers: how far it is from the exact value, in units in the last place, and how "
      "much more than the input that value changes, relatively. On the line the error is what a change of the input in "
      "its last place does as well; above it, the formula loses what the question does not: {0} where all numbers of "
      "the question are 0 or between 2<sup>-100</sup> and 2<sup>100</sup> in size (<span "
      "style=\"color:var(--q0)\">blue</span>), {1} elsewhere (<span style=\"color:var(--q1)\">brown</span>). Errors of "
      "a "
      "sixteenth of a unit and less, 0 among them, lie on the lower edge, what is beyond 2<sup>64</sup> on the "
      "others.</p><figure><div class=\"view\"><svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" role=\"img\" "
      "viewBox=\"-64 -10 640 418\" width=\"640\" height=\"418\"><title>Error of the formula against the condition of "
      "the "
      "question</title><rect class=\"frame\" width=\"{2}\" height=\"{3}\"/><path class=\"tick\" d=\"M0 {3}L{2} "
      "0\"/>{4}<path style=\"fill:var(--q1);fill-opacity:.5\" d=\"{5}\"/><path "
      "style=\"fill:var(--q0);fill-opacity:.5\" d=\"{6}\"/>"
      "<text class=\"caption\" x=\"280\" y=\"398\" text-anchor=\"middle\">condition of the question</text><text "
      "class=\"caption\" transform=\"translate(-44 180) rotate(-90)\" text-anchor=\"middle\">error, ulps</text></svg>"
      "</div></figure></div>",
      grouped(above[0]) + " of " + grouped(all[0]), grouped(above[1]) + " of " + grouped(all[1]), width, height, scales,
      dots[1], dots[0]);
}

}  // namespace touchstone::report
