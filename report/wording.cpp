// SPDX-License-Identifier: Apache-2.0
#include "report/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "audit/repeat.h"
#include "catalogue/codec/plain.h"
#include "report/viewport.h"

namespace touchstone::report {
namespace {

bool is_exact_value(const std::string& text) {
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  const bool plausible = text.find_first_not_of("0123456789/", sign) == std::string::npos;
  return plausible && text.size() > sign && text.back() != '/' && text[sign] != '/' &&
         std::count(text.begin(), text.end(), '/') <= 1;
}

/// Long exact values made short.
Json abbreviated(const Json& answer, std::size_t most, std::size_t digits_kept) {
  if (answer.is_string()) {
    const std::string& text = answer.get_ref<const std::string&>();
    if (text.size() > most && is_exact_value(text)) return readable(mpq_class(text), most, digits_kept);
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

/// Whether the textbook formula in the engine's own number type decides rightly; empty where that cannot be asked.
std::optional<bool> formula_is_right(const Finding& finding, const Operation* operation, bool binary32) {
  if (!operation) return std::nullopt;
  try {
    const Verdict verdict = finding.examination(*operation).judge_reference(binary32).verdict;
    return verdict != Verdict::rounding && verdict != Verdict::algorithm && verdict != Verdict::invalid;
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

/// Whether a number of the answer is not 0 where the exact one is: a distance in ulps says nothing there.
bool misses_a_zero(const Json& answer, const Json& truth) {
  if (!truth.is_structured()) return truth == "0" && answer != 0;
  if (answer.type() != truth.type()) return false;
  if (truth.is_array()) {
    for (std::size_t i = 0; i < truth.size() && i < answer.size(); ++i) {
      if (misses_a_zero(answer[i], truth[i])) return true;
    }
    return false;
  }
  for (const auto& [key, value] : truth.items()) {
    if (answer.contains(key) && misses_a_zero(answer[key], value)) return true;
  }
  return false;
}

bool misses_a_zero(const Finding& finding, const Operation* operation) {
  if (!operation) return false;
  try {
    const Examination& examined = finding.examination(*operation);
    return misses_a_zero(finding.answer.is_null() ? examined.reference() : plain(finding.answer), examined.truth());
  } catch (const InvalidInput&) {
    return false;
  }
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
  const auto right = formula_is_right(finding, operation, binary32);
  return std::string("The textbook formula, evaluated in the engine's own number type, is ") +
         (right && *right ? "right here" : "certain of its decision here, although that is wrong too") +
         ": the method is the presumed cause. The engine's own formula was not seen.";
}

std::string why_rounding(Speaker speaker) {
  if (speaker == Speaker::reference) {
    return "The textbook formula is right here: so is its answer in exact arithmetic. Rounding its intermediate "
           "results "
           "changed the decision.";
  }
  return "The textbook formula, evaluated in the engine's own number type, rounds and is wrong on this input too, or "
         "the input is beside a touch by less than its last places: rounding is the presumed cause. The engine's own "
         "formula was not seen.";
}

/// What a checker says of the answer, as a sentence before others.
std::string fault_of(const Finding& finding) {
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
  if (ulps >= 0x1p990) return "more than 1e298 ulps";  // where the judge stops counting
  return fmt::format("{:.3g}", ulps) + (ulps == 1 ? " ulp" : " ulps");
}

std::string subject(const Declaration& declaration) {
  return (speaker_of(declaration) == Speaker::reference ? "textbook formulas" : declaration.engine) +
         (declaration.binary32 ? " (binary32)" : " (binary64)");
}

std::string meaning(Verdict verdict, Speaker speaker) {
  const bool foreign = speaker == Speaker::foreign;
  switch (verdict) {
    case Verdict::agree: return "right decision, every number within the stated bound";
    case Verdict::rounding:
      return foreign
                 ? "wrong decision where the textbook formula in the engine's number type rounds and is wrong too, or "
                   "beside a touch by less than the input's last places"
                 : "wrong decision; the same formula in exact arithmetic is right";
    case Verdict::algorithm:
      return foreign ? "wrong decision where the textbook formula in the engine's number type is right, or certain"
                     : "wrong decision, or undefined, even in exact arithmetic";
    case Verdict::inexact: return "right decision, a number further off than the stated bound";
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

std::string not_asked_in_words(const Cell& cell) {
  return counted(cell.not_asked, "question") + " not asked: the engine was " + cell.given_up;
}

std::string why(const Finding& finding, const Operation* operation, Speaker speaker, bool binary32) {
  switch (finding.judgement.verdict) {
    case Verdict::rounding: return fault_of(finding) + why_rounding(speaker);
    case Verdict::algorithm: return fault_of(finding) + why_algorithm(finding, operation, speaker, binary32);
    case Verdict::inexact: {
      const std::string off = ulps_in_words(finding.judgement.ulps);
      if (speaker == Speaker::robust)
        return "The decision is right, but a number is " + off + " from the correctly rounded one.";
      if (finding.judgement.ulps >= 0x1p52 && misses_a_zero(finding, operation)) {
        return "The decision is right, but a number is not 0 where the exact value is 0.";
      }
      if (finding.judgement.ulps >= 0x1p52) {
        return "The decision is right, but a number has no correct digit: it is " + off + " from the exact value.";
      }
      const std::string bound = operation ? " Stated bound: " + ulps_in_words(operation->card().ulps) + "." : "";
      return "The decision is right, but a number is " + off + " from the exact value." + bound;
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
