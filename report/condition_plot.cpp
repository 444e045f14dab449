// SPDX-License-Identifier: Apache-2.0
#include "report/condition_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/audit_run.h"
#include "catalogue/judge/sensitivity.h"
#include "report/labels.h"
#include "report/wording.h"

namespace touchstone::audit {
namespace {

constexpr std::uint64_t seed = 1, questions_of_a_family = 16;
constexpr std::size_t most_numbers = 48;  // of a question: each is moved, and the oracle asked again
constexpr double width = 560, height = 360, left_room = 64, bottom_room = 48, top_room = 10, right_room = 16;
constexpr double least_power = -4, greatest_power = 64, power_between_ticks = 8;

double clamped_power(double number) {
  return std::clamp(number > 0 ? std::log2(number) : least_power, least_power, greatest_power);
}
double across(double power) { return (power - least_power) / (greatest_power - least_power) * width; }
double down(double power) { return height - (power - least_power) / (greatest_power - least_power) * height; }

bool of_ordinary_size(const Question& question) {
  return std::all_of(question.numbers.begin(), question.numbers.end(),
                     [](double x) { return x == 0 || (std::fabs(x) >= 0x1p-100 && std::fabs(x) <= 0x1p100); });
}

struct Drawn {
  std::vector<Sensitivity> ordinary, others;
};

Drawn drawn(const Operation& operation) {
  Drawn found;
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    for (std::uint64_t index = 0; index < questions_of_a_family; ++index) {
      Choices choices = case_choices(operation, family, seed, index);
      const Question question = operation.draw(choices, family);
      if (question.numbers.size() > most_numbers) continue;
      try {
        const std::vector<Sensitivity> of_one = sensitivities(operation, question);
        auto& kept = of_ordinary_size(question) ? found.ordinary : found.others;
        kept.insert(kept.end(), of_one.begin(), of_one.end());
      } catch (const InvalidInput&) {
      }
    }
  }
  return found;
}

std::string scales() {
  std::string svg;
  for (double power = 0; power <= greatest_power; power += power_between_ticks) {
    const std::string label = power == 0 ? "1" : fmt::format("2<tspan dy=\"-4\" font-size=\"8\">{}</tspan>", power);
    svg += fmt::format(
        "<path class=\"tick\" d=\"M{0:.1f} {1}v5\"/><text class=\"scale\" x=\"{0:.1f}\" y=\"{2}\" "
        "text-anchor=\"middle\">{3}</text>",
        across(power), height, height + 18, label);
    svg += fmt::format(
        "<path class=\"tick\" d=\"M0 {0:.1f}h-5\"/><text class=\"scale\" x=\"-8\" y=\"{1:.1f}\" "
        "text-anchor=\"end\">{2}</text>",
        down(power), down(power) + 4, label);
  }
  return svg;
}

/// Small squares in one path.
std::string dots(const std::vector<Sensitivity>& all, const char* colour) {
  std::string path;
  for (const Sensitivity& one : all) {
    path += fmt::format("M{:.1f} {:.1f}h3v3h-3z", across(clamped_power(one.condition)) - 1.5,
                        down(clamped_power(one.ulps)) - 1.5);
  }
  return fmt::format("<path style=\"fill:var(--{});fill-opacity:.5\" d=\"{}\"/>", colour, path);
}

std::string above_line(const std::vector<Sensitivity>& all) {
  const auto count = std::count_if(all.begin(), all.end(),
                                   [](const Sensitivity& one) { return one.ulps > one.condition && one.ulps > 1; });
  return grouped(static_cast<std::uint64_t>(count)) + " of " + grouped(all.size());
}

}  // namespace

std::string condition_section(const Operation& operation) {
  if (operation.card().kind != Kind::measure || !operation.words().empty()) return "";
  const Drawn all = drawn(operation);
  if (all.ordinary.empty() && all.others.empty()) return "";
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig wide\" role=\"img\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\"><title>Error of the formula against the condition of the question</title><g "
      "transform=\"translate({2} {3})\"><rect class=\"frame\" width=\"{4}\" height=\"{5}\"/>",
      left_room + width + right_room, top_room + height + bottom_room, left_room, top_room, width, height);
  svg +=
      fmt::format("<path class=\"tick\" d=\"M{:.1f} {:.1f}L{} 0\"/>", across(least_power), down(least_power), width) +
      scales() + dots(all.others, "q1") + dots(all.ordinary, "q0");
  svg += fmt::format(
      "<text class=\"caption\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">condition of the question</text><text "
      "class=\"caption\" transform=\"translate(-44 {}) rotate(-90)\" text-anchor=\"middle\">error, "
      "ulps</text></g></svg>",
      width / 2, height + 38, height / 2);
  return fmt::format(
      "<h2 id=\"condition\">Error against condition</h2><div class=\"card\"><p class=\"quiet\">Each dot is a number "
      "that "
      "the textbook formula in double answers: how far it is from the exact value, in units in the last place, and how "
      "much "
      "more than the input that value changes, relatively. On the line the error is what a change of the input in its "
      "last "
      "place does as well; above it, the formula loses what the question does not: {} where all numbers of the "
      "question "
      "are 0 or between 2<sup>-100</sup> and 2<sup>100</sup> in size (<span style=\"color:var(--q0)\">blue</span>), {} "
      "elsewhere (<span style=\"color:var(--q1)\">brown</span>). Errors of a sixteenth of a unit and less, 0 among "
      "them, "
      "lie on the lower edge, what is beyond 2<sup>64</sup> on the others.</p><figure "
      "class=\"scroll\">{}</figure></div>",
      above_line(all.ordinary), above_line(all.others), svg);
}

}  // namespace touchstone::audit
