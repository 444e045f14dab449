// SPDX-License-Identifier: Apache-2.0
#include "report/words/hints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "report/words/wording.h"

namespace touchstone::report {
namespace {

using Findings = std::vector<const Finding*>;
using Change = std::function<void(Json&)>;

constexpr std::size_t fewest = 2;         ///< findings that support a hint
constexpr std::size_t shortest_list = 8;  ///< that is worth mentioning
constexpr double least_part = 0.25;       ///< of the answers is wrong if all questions are misread
constexpr double degree = 3.14159265358979323846 / 180, six_digits = 0x1p-20, double_digits = 0x1p-40,
                 least_float = 0x1p-126, most_float = 0x1p127;

Findings findings_of(const OperationTally& tally) {
  Findings found;
  for (const auto& [family, cell] : tally.families)
    for (const auto& [outcome, counted] : cell.outcomes)
      if (is_finding(outcome.verdict) && outcome.verdict != Verdict::rounding && counted.example &&
          counted.example->range == Range::ordinary)
        found.push_back(&*counted.example);
  return found;
}

template <class Holds>
bool of_all(const Findings& findings, const Holds& holds) {
  return findings.size() >= fewest &&
         std::all_of(findings.begin(), findings.end(), [&](const Finding* finding) { return holds(*finding); });
}

std::string about_touches(const Findings& findings) {
  const bool open = of_all(findings, [](const Finding& f) { return f.judgement.touch_reading < 0; });
  return open ? "But for rounding, every wrong answer of ordinary size is to a touch, and right for open sets: `<` "
                "where `<=` belongs? Else declare \"boundary\": \"open\"."
              : "";
}

std::string about_digits(const Findings& findings) {
  std::size_t numbers = 0, single = 0, others = 0;
  for (const Finding* finding : findings) {
    if (!finding->judgement.number) {
      others += finding->judgement.verdict == Verdict::invalid ? 0 : 1;  // infinite, beyond the range of floats
      continue;
    }
    const auto& [exact, answered] = *finding->judgement.number;
    if (!(std::abs(exact) >= least_float && std::abs(exact) <= most_float)) continue;
    const double off = std::abs(answered - exact) / std::abs(exact);
    ++numbers, single += off <= six_digits && off >= double_digits ? 1 : 0;
  }
  const bool most = single >= fewest && single * 4 >= numbers * 3 && numbers >= others;
  return most ? "The wrong numbers are right to six digits or seven: are they computed in single precision? Then "
                "declare "
                "\"number\": \"binary32\"."
              : "";
}

/// True if each answer is right for another question. An engine that failed has not misread its question.
bool right_for(const Operation& operation, const Findings& findings, const Declaration& declaration,
               const Change& change) {
  Findings answered;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(answered),
               [](const Finding* finding) { return !finding->answer.is_null(); });
  return of_all(answered, [&](const Finding& finding) {
    try {
      Json input = parse_own_line(one_line(operation.print(finding.question)));
      change(input);
      const auto other = operation.examine(operation.parse(parse_line(one_line(input))));
      const Verdict verdict = other->judge_engine(parse_line(one_line(finding.answer)), declaration).verdict;
      return verdict == Verdict::agree || verdict == Verdict::inexact;
    } catch (const InvalidInput&) {
      return false;
    }
  });
}

/// Applied to every point and vector, i.e. a list of two numbers or three.
void to_points(Json& value, const std::function<void(Json&)>& change) {
  const bool flat = std::none_of(value.begin(), value.end(), [](const Json& part) { return !part.is_number(); });
  if (value.is_array() && flat && (value.size() == 2 || value.size() == 3)) return change(value);
  if (!value.is_structured()) return;
  for (auto part = value.begin(); part != value.end(); ++part)
    if (!value.is_object() || part.key() != "faces") to_points(*part, change);
}

void negate(Json& number) { number = -number.get<double>(); }

/// Another reading of all questions: so many answers are wrong that no special case is to blame.
std::vector<std::string> about_readings(const Operation& operation, const Findings& findings,
                                        const Declaration& declaration) {
  std::vector<std::string> said;
  const auto add = [&](const Change& change, const std::string& words) {
    if (right_for(operation, findings, declaration, change))
      said.push_back("But for rounding, every wrong answer shown is right " + words);
  };
  const FieldNames& fields = operation.fields(0);
  std::string exchanged;
  for (std::size_t i = 0; i < fields.size(); ++i)
    for (std::size_t k = i + 1; k < fields.size(); ++k) {
      const std::string a = fields[i], b = fields[k];
      const Change exchange = [&](Json& input) {
        if (input.contains(a) && input.contains(b)) std::swap(input.at(a), input.at(b));
      };
      if (right_for(operation, findings, declaration, exchange))
        exchanged += (exchanged.empty() ? "`" : ", or `") + a + "` and `" + b + "`";
    }
  if (!exchanged.empty())
    said.push_back("But for rounding, every wrong answer shown is right if " + exchanged + " are exchanged.");
  add([](Json& input) { to_points(input, [](Json& p) { negate(p[p.size() - 1]); }); },
      "in the mirrored frame: is y down, or the frame left-handed?");
  const auto upright = [](Json& p) {
    if (p.size() == 3) std::swap(p[1], p[2]);
  };
  add([&](Json& input) { to_points(input, upright); }, "with y and z exchanged: is z up?");
  return said;
}

std::string about_angles(const Findings& findings) {
  Findings numbers;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(numbers), [](const Finding* finding) {
    return finding->judgement.number && finding->judgement.number->exact != 0;
  });
  const bool in_degrees = of_all(numbers, [](const Finding& finding) {
    const auto& [exact, answered] = *finding.judgement.number;
    return std::abs(answered * degree / exact - 1) <= six_digits;
  });
  return in_degrees ? "The wrong numbers are 180/pi times the right ones: are they in degrees? They are to be in "
                      "radians."
                    : "";
}

std::string about_degrees(const Operation& operation, const Findings& findings, const Declaration& declaration) {
  if (operation.name() != "parametric_circle") return "";
  const Change in_radians = [](Json& input) { input["u"] = input["u"].get<double>() * degree; };
  return right_for(operation, findings, declaration, in_radians)
             ? "But for rounding, every wrong answer shown is right if `u` is in degrees: it is in radians."
             : "";
}

std::string about_moves(const Operation& operation, const Findings& findings) {
  const bool moved = of_all(findings, [&](const Finding& finding) {
    const Json input = operation.print(finding.question);
    const auto commands = input.find("commands");
    return commands != input.end() && std::any_of(commands->begin(), commands->end(), [](const Json& command) {
             return command.is_object() && command.contains("move");
           });
  });
  return moved ? "But for rounding, no question without a `move` was kept as wrong: what was cached before it?" : "";
}

std::string about_axes(const Cell& total) {
  constexpr std::uint64_t enough = 20;  // right answers to others
  const auto ordinary = static_cast<std::size_t>(Range::ordinary);
  const std::uint64_t found = total.findings(Range::ordinary) - total.by_range(Verdict::rounding)[ordinary];
  const bool on_axis = found >= fewest && total.found_on_axis == found && total.right_off_axis >= enough;
  return on_axis ? "But for rounding, every wrong answer of ordinary size is to a direction of which a component is 0, "
                   "and " +
                       counted(total.right_off_axis, "other") + " are right: is that component divided by?"
                 : "";
}

/// The length of the longest list of bodies, points or similar.
std::size_t longest_list(const Json& value) {
  std::size_t longest = 0;
  if (!value.is_structured()) return longest;
  if (value.is_array() && !value.empty() && value[0].is_structured()) longest = value.size();
  for (const Json& part : value) longest = std::max(longest, longest_list(part));
  return longest;
}

std::string about_lengths(const Operation& operation, const Findings& findings) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const bool long_ones = of_all(findings, [&](const Finding& finding) {
    least = std::min(least, longest_list(operation.print(finding.question)));
    return least > shortest_list;
  });
  return long_ones ? "But for rounding, no question with a list shorter than " + std::to_string(least) +
                         " was kept as wrong: has something room for fewer?"
                   : "";
}

}  // namespace

std::vector<std::string> hints(const OperationTally& tally, const Declaration& declaration) {
  const Operation* operation = find_operation(tally.operation);
  if (operation == nullptr || speaker_of(declaration) != Speaker::foreign) return {};
  const Findings findings = findings_of(tally);
  std::vector<std::string> said;
  if (!declaration.binary32) said.push_back(about_digits(findings));
  said.push_back(about_angles(findings));
  const Cell total = tally.total();
  if (static_cast<double>(total.findings()) >= least_part * static_cast<double>(total.answered())) {
    for (std::string& reading : about_readings(*operation, findings, declaration)) said.push_back(std::move(reading));
    said.push_back(about_degrees(*operation, findings, declaration));
  }
  const std::string axes = about_axes(total);
  said.push_back(axes.empty() ? about_touches(findings) : axes);  // a direction along an axis touches in most cases
  said.push_back(about_moves(*operation, findings));
  said.push_back(about_lengths(*operation, findings));
  said.erase(std::remove(said.begin(), said.end(), std::string()), said.end());
  return said;
}

}  // namespace touchstone::report
