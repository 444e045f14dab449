// SPDX-License-Identifier: Apache-2.0
#include "report/words/wording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "audit/counting/repeat.h"
#include "catalogue/codec/plain.h"
#include "catalogue/operation/blame.h"
#include "oracle/exact/numbers/surd.h"
#include "report/figures/viewport.h"

namespace touchstone::report {
namespace {

bool is_exact_value(const std::string& text) {
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  const bool plausible = text.find_first_not_of("0123456789/", sign) == std::string::npos;
  return plausible && text.size() > sign && text.back() != '/' && text[sign] != '/' &&
         std::count(text.begin(), text.end(), '/') <= 1;
}

/// The value of a text with a root, to enough digits for any reader; nullopt if it is not one.
std::optional<mpq_class> number_with_root(const std::string& text) {
  constexpr std::int64_t bits = 1074 + 200;
  if (text.find("sqrt(") == std::string::npos) return std::nullopt;
  try {
    return oracle::surd_of(text).enclosure(bits).low;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Shortens long exact values.
Json abbreviated(const Json& answer, std::size_t most, std::size_t digits_kept) {
  if (answer.is_string()) {
    const std::string& text = answer.get_ref<const std::string&>();
    if (text.size() <= most) return answer;
    if (is_exact_value(text)) return readable(mpq_class(text), most, digits_kept);
    if (const auto number = number_with_root(text)) return readable(*number, most, digits_kept);
    return answer;
  }
  if (!answer.is_structured()) return answer;
  Json result = answer;
  for (Json& part : result) part = abbreviated(part, most, digits_kept);
  return result;
}

bool mentions_nan(const Json& answer) {
  if (answer.is_string()) return answer.get_ref<const std::string&>() == "nan";
  return answer.is_structured() &&
         std::any_of(answer.begin(), answer.end(), [](const Json& part) { return mentions_nan(part); });
}

/// True if the textbook formula in the engine's own number type decides rightly; nullopt if it cannot be evaluated.
std::optional<bool> formula_is_right(const Finding& finding, const Operation* operation, bool binary32) {
  if (!operation) return std::nullopt;
  try {
    const Verdict verdict = finding.examination(*operation).judge_reference(binary32).verdict;
    return verdict != Verdict::rounding && verdict != Verdict::algorithm && verdict != Verdict::invalid;
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

/// "point[1]": the path of that number in the answer, and another one in the truth; empty if it is not found.
std::string place_of(double answered, const Json& truth, const Json& answer, const std::string& path) {
  if (answer.is_number()) return answer.get<double>() == answered && answer != truth ? path : "";
  if (answer.type() != truth.type() || !answer.is_structured()) return "";
  std::size_t i = 0;
  for (auto part = answer.begin(); part != answer.end(); ++part, ++i) {
    const bool member = answer.is_object();
    if (member ? !truth.contains(part.key()) : i >= truth.size()) continue;
    const std::string inner = !member        ? path + "[" + std::to_string(i) + "]"
                              : path.empty() ? part.key()
                                             : path + "." + part.key();
    std::string found = place_of(answered, member ? truth[part.key()] : truth[i], *part, inner);
    if (!found.empty()) return found;
  }
  return "";
}
std::string place_of_number(const Finding& finding, const Operation* operation) {
  if (!operation || !finding.answer.is_structured()) return "";
  try {
    const Json truth = parse_own_line(one_line(finding.examination(*operation).rounded_truth()));
    return place_of(finding.judgement.number->answered, truth, parse_own_line(one_line(finding.answer)), "");
  } catch (const InvalidInput&) {
    return "";
  }
}

/// "The decision is right, but number `distance` is inexact: 12 ulps off. "; if nothing is decided, without its first
/// part.
std::string about_number(const Finding& finding, const Operation* operation) {
  const bool decides = operation && !operation->words().empty();
  const std::string place = place_of_number(finding, operation);
  const std::string number =
      place.empty() ? (decides ? "a number" : "A number") : (decides ? "number `" : "Number `") + place + "`";
  return (decides ? "The decision is right, but " : "") + number +
         (finding.judgement.verdict == Verdict::inexact ? " is inexact: " : " is wrong: ") +
         off_in_words(finding.judgement) + ". ";
}

std::string why_algorithm(const Finding& finding, const Operation* operation, Speaker speaker, bool binary32) {
  switch (speaker) {
    case Speaker::reference:
      return std::string(
                 "The textbook formula itself fails here: even in exact arithmetic it is wrong, or undefined such as "
                 "0/0.") +
             (mentions_nan(finding.answer) ? " The NaN in the answer is what 0/0 leaves behind." : "");
    case Speaker::robust: return "robust promises the right answer for every finite input, so this is a bug of robust.";
    case Speaker::foreign: break;
  }
  if (finding.judgement.number) {
    return "Running error analysis of the textbook formula, evaluated in the engine's own number type, does not "
           "explain "
           "that: the method is the presumed cause. The engine's own formula was not seen.";
  }
  const auto right = formula_is_right(finding, operation, binary32);
  return std::string("The textbook formula, evaluated in the engine's own number type, is ") +
         (right && *right ? "right here" : "certain of its decision here, although that is wrong too") +
         ": the method is the presumed cause. The engine's own formula was not seen.";
}

std::string why_rounding(const Finding& finding, const Operation* operation, Speaker speaker, bool binary32) {
  if (finding.judgement.number) {
    return speaker == Speaker::reference
               ? "The textbook formula is right in exact arithmetic: rounding its intermediate results spoils the "
                 "number."
               : "The textbook formula, evaluated in the engine's own number type, is as far off on this input, or "
                 "running error analysis allows it to be: rounding is the presumed cause. The engine's own formula was "
                 "not seen.";
  }
  if (speaker == Speaker::reference) {
    return "The textbook formula is right here: so is its answer in exact arithmetic. Rounding its intermediate "
           "results "
           "changed the decision.";
  }
  std::string reason =
      "rounds and is wrong on this input too, or the input is beside a touch by less than its last places";
  if (const auto right = formula_is_right(finding, operation, binary32)) {
    const char* const other =
        *right ? standard_formula_that_rounds(finding.examination(*operation), binary32) : nullptr;
    reason = !*right ? "rounds and is wrong on this input too"
             : other != nullptr
                 ? "is right here, but another of its kind (" + std::string(other) + ") is in doubt of its decision"
             : finding.judgement.out_of_range
                 ? "is right here, but numbers leave the range of that type on the way"
                 : "is right here, but the input is beside a touch by less than its last places";
  }
  return std::string("The textbook formula, evaluated in the engine's own number type, ") + reason +
         ": rounding is the presumed cause. The engine's own formula was not seen.";
}

/// The defect of the answer, as a sentence before others: a number, or the checker's message.
std::string defect_of(const Finding& finding, const Operation* operation) {
  if (finding.judgement.number) return about_number(finding, operation);
  std::string text = finding.judgement.remark;
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ". ";
}

}  // namespace

std::string share(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0 || part == 0) return "0%";
  if (part == whole) return "100%";
  const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  if (percent < 0.01) return "<0.01%";
  if (percent > 99.99) return ">99.99%";
  return fmt::format("{:.{}f}%", percent, percent < 1 || percent > 99 ? 2 : 1);
}

std::string ulps_in_words(double ulps) {
  if (ulps >= 0x1p990) return "more than 1e298 ulps";  // the judge stops counting there
  return fmt::format("{:.3g}", ulps) + (ulps == 1 ? " ulp" : " ulps");
}

std::string off_in_words(const Judgement& judgement) {
  constexpr double most = 1e6;  // beyond this a distance is meaningless to a reader
  const auto& number = judgement.number;
  if (!number || (number->exact != 0 && judgement.ulps <= most)) return ulps_in_words(judgement.ulps) + " off";
  return fmt::format("expected {}, got {}", number->exact, number->answered);
}

std::string subject(const Declaration& declaration) {
  return (speaker_of(declaration) == Speaker::reference ? "textbook formulas" : declaration.engine) +
         (declaration.binary32 ? " (binary32)" : " (binary64)");
}

std::string meaning(Verdict verdict, Speaker speaker) {
  const bool foreign = speaker == Speaker::foreign;
  switch (verdict) {
    case Verdict::agree: return "right, every number within the stated bound";
    case Verdict::rounding:
      return foreign
                 ? "wrong where the textbook formula in the engine's number type rounds and is wrong too, or beside "
                   "a touch by less than the input's last places; a number without a correct digit, as rounding "
                   "explains"
                 : "wrong; the same formula in exact arithmetic is right";
    case Verdict::algorithm:
      return foreign
                 ? "wrong where the textbook formula in the engine's number type is right, or certain; a number off "
                   "by more than rounding explains"
                 : "wrong, or undefined, even in exact arithmetic";
    case Verdict::inexact:
      return "a number further off than the stated bound, as rounding explains; whatever is decided is right";
    case Verdict::convention: return "right for open sets, where the truth is a touch";
    case Verdict::tolerance: return "wrong decision, within the tolerance that the engine declares";
    case Verdict::invalid: return "NaN, infinity, exception, crash, no valid answer or none in time";
    case Verdict::unsupported: return "the engine does not answer this";
  }
  return "";
}

Speaker speaker_of(const Declaration& declaration) {
  return declaration.engine.empty() || declaration.engine == "reference" ? Speaker::reference : Speaker::foreign;
}

std::string nothing_right_in_words(const Cell& cell) {
  return "none of " + grouped(cell.answered()) +
         " answers is right: look at the connection first, with touchstone check-engine";
}

std::string other_nearest_in_words(const Cell& cell) {
  return counted(cell.other_nearest, "answer") + (cell.other_nearest == 1 ? " names" : " name") +
         " other points, as near as the contract's: right for \"nearest\":\"any\"";
}

std::string not_asked_in_words(const Cell& cell) {
  return counted(cell.not_asked, "question") + " not asked: the engine was " + cell.given_up;
}

std::string surplus_in_words(const Cell& cell, double most) {
  return counted(cell.surplus, "element") + " listed beyond the truth, " + share(cell.surplus, cell.apart) +
         " of what is apart" +
         (cell.surplus_rate() > most ? fmt::format("; more than --max-surplus {} allows", most) : "");
}

std::string why(const Finding& finding, const Operation* operation, Speaker speaker, bool binary32) {
  switch (finding.judgement.verdict) {
    case Verdict::rounding: return defect_of(finding, operation) + why_rounding(finding, operation, speaker, binary32);
    case Verdict::algorithm:
      return defect_of(finding, operation) + why_algorithm(finding, operation, speaker, binary32);
    case Verdict::inexact: {
      const double bound = operation && speaker != Speaker::robust ? operation->metadata().ulps : 0;
      return about_number(finding, operation) + (speaker == Speaker::robust
                                                     ? "robust promises the nearest number."
                                                     : "Stated bound: " + ulps_in_words(bound) + ".");
    }
    case Verdict::convention:
      return "The truth is a touch, and the answer is right for open sets; the engine does not promise closed ones.";
    case Verdict::tolerance: return "The margin is within the tolerance that the engine declares.";
    case Verdict::invalid: return finding.judgement.remark.empty() ? "No valid answer." : finding.judgement.remark;
    case Verdict::unsupported: return "The engine does not answer this input.";
    case Verdict::agree: break;
  }
  return "The answer is right.";
}

std::string readable(const mpq_class& exact, std::size_t most, std::size_t digits_kept) {
  std::string whole = exact.get_str();
  if (whole.size() <= most) return whole;
  std::string text = about(exact, digits_kept);
  const std::size_t power = text.find('e');
  if (power != std::string::npos && text[power + 1] != '-') text.insert(power + 1, "+");
  return "about " + text;
}

Json readable(const Json& answer, std::size_t most, std::size_t digits_kept) {
  return abbreviated(plain(answer), most, digits_kept);
}

std::string word_in(const Json& answer) {
  if (answer.is_boolean()) return answer.get<bool>() ? "true" : "false";
  if (!answer.is_object()) return "value";
  for (const auto& [key, value] : answer.items()) {
    if (!value.is_string() || is_typed_number(value)) continue;
    const std::string& text = value.get_ref<const std::string&>();
    if (text != "nan" && text != "inf" && text != "-inf" && !is_exact_value(text)) return text;
  }
  return "value";
}

std::string place_in_words(const std::string& family, const Finding& finding, const Repeat& repeat) {
  return fmt::format(fmt::runtime(repeat.recorded ? "{}, call {}" : "family {}, case {}"), family, finding.index);
}

std::string asked_in_words(const Tally& tally) {
  if (!tally.logs.empty())
    return counted(sum_of(tally.operations).cases(), tally.repeat.options.empty() ? "recorded call" : "question") +
           " of " +
           (tally.logs == std::vector<std::string>{"-"} ? "standard input"
                                                        : fmt::format("{}", fmt::join(tally.logs, ", ")));
  return (tally.by_cost ? "up to " : "") + counted(tally.cases, "case") + " per operation, seed " +
         std::to_string(tally.seed);
}

std::string repeat_command(const Operation& operation, const Question& question, Speaker speaker,
                           const Repeat& repeat) {
  return repeat_command(operation, question, repeat, speaker == Speaker::foreign);
}

Cell sum_of(const std::vector<OperationTally>& tallies) {
  Cell sum;
  for (const OperationTally& tally : tallies) sum.merge(tally.total());
  return sum;
}

std::string summary_of(const Cell& sum) {
  const std::uint64_t out_of_range = both(sum.out_of_range());
  std::string text = grouped(sum.wrong()) + " of " + grouped(sum.answered()) + " answers wrong";
  if (sum.cases(Range::extreme) > 0) {
    text += " (ordinary size: " + grouped(sum.wrong(Range::ordinary)) + " of " +
            grouped(sum.answered(Range::ordinary)) + ")";
  }
  std::string separator = ": ";
  const auto name = [&](std::uint64_t n, const std::string& words) {
    if (n == 0) return;
    text += separator + grouped(n) + " " + words;
    separator = ", ";
  };
  name(sum.count(Verdict::rounding), "by rounding");
  if (out_of_range > 0) {
    text += " (" + grouped(both(sum.cancellation())) + " cancellation, " + grouped(out_of_range) +
            " overflow or underflow)";
  }
  name(sum.count(Verdict::algorithm), "by algorithm");
  name(sum.count(Verdict::invalid), "invalid");
  separator = "; ";
  name(sum.count(Verdict::inexact), "inexact");
  name(sum.count(Verdict::convention), "by another convention");
  name(sum.count(Verdict::tolerance), "within tolerance");
  name(sum.count(Verdict::unsupported), "not supported");
  name(sum.not_asked, "not asked");
  return text;
}

std::string closing_sentence(const Tally& tally) {
  const Cell robust = sum_of(tally.robust);
  return subject(tally.declaration) + ": " + summary_of(sum_of(tally.operations)) +
         (tally.robust.empty() ? "" : "; robust: " + grouped(robust.cases() - robust.count(Verdict::agree))) + "\n";
}

}  // namespace touchstone::report
