// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <array>
#include <limits>
#include <map>
#include <set>

#include "audit/counting/audit_run.h"
#include "audit/vectors/flags.h"
#include "audit/vectors/likeness.h"
#include "audit/vectors/named_files.h"
#include "audit/vectors/schemas.h"
#include "audit/vectors/sha256.h"
#include "catalogue/judge/environment.h"
#include "catalogue/operation/probes/array_mismatch.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/operation/probes/not_finite.h"
#include "oracle/certificates/check.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_of_a_family = 24, most_alike = 6;

Json without_marks(const Json& truth) { return Json::parse(truth.dump()); }

/// A question of an operation, examined on first use.
struct Examined {
  const Operation& operation;
  Question question;
  Once<std::unique_ptr<const Examination>> once{};
  /// Throws InvalidInput if the oracle refuses.
  const Examination& operator*() const {
    return *once.value([&] { return operation.examine(question); });
  }
};

/// "orientation/1f0a9b3c5d", of the input as a line writes it: whatever else changes, an id names the same question.
std::string id_of(const Operation& operation, const Json& input) {
  return operation.name() + "/" + sha256(one_line(input)).substr(0, digits_of_id);
}

/// Without what takes long, certificate and flags, if the line is longer than `most` characters before them.
Json vector_line(const std::string& family, const Examined& examined, std::size_t most = std::string::npos) {
  const auto& [operation, question, once] = examined;
  const Json input = operation.print(question), named = with_names(input);
  Json line = Json::object();
  line["touchstone"] = vector_version;
  line["id"] = id_of(operation, named);
  line["op"] = operation.name();
  line["family"] = family;
  line["input"] = named;
  try {
    const Examination& examination = *examined;
    line["truth"] = examination.truth();
    line["rounded"] = examination.rounded_truth();
    if (one_line(line).size() > most) return line;
    if (examination.margin()) line["margin"] = written(*examination.margin());
    line["certificate"] = certificate_json(examination.certificate());
    line["flags"] = flags_of(operation, question, examination);
    const Json as_typed = truth_of_decimals(operation, input);
    if (!as_typed.is_null() && as_typed != line["truth"] && family.starts_with("typed")) line["as_typed"] = as_typed;
  } catch (const InvalidInput& refused) {
    line["refused"]["field"] = refused.field();
    line["refused"]["rule"] = refused.rule();
    line["flags"] = {"refused"};
  }
  return line;
}

std::string likeness(const Examined& examined) {
  try {
    return audit::likeness(*examined);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

/// True if equal, whatever the order of the fields of objects.
bool same(const Json& a, const Json& b) { return nlohmann::json(a) == nlohmann::json(b); }

std::string in_words(std::size_t environment) {
  return environment == 0 ? "" : " (" + environment_name(environment) + ")";
}

/// For each number a question in which it is not finite; then those that break another rule are repeated without that.
std::vector<Question> not_finite_questions(const Operation& operation) {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::array<double, 3> bad{infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
  std::vector<Question> questions;
  for (const Question& zeros : operation.zeros_of_alternatives())
    for (std::size_t i = 0; i < zeros.numbers.size(); ++i)
      questions.push_back(with_not_finite(operation, zeros, i, bad[i % bad.size()]));
  for (const Question& zeros : operation.zeros_of_alternatives())
    for (std::size_t i = 0; i < zeros.numbers.size(); ++i)
      if (auto question = with_only_not_finite(operation, zeros, i, bad[i % bad.size()]))
        questions.push_back(std::move(*question));
  return questions;
}

/// The difference in robust's answers over arrays, with each instruction set, rounding to nearest: in other modes
/// arrays ask row by row.
std::string array_complaint(const Examined& examined) {
  using robust::batch::Instructions;
  const auto& [operation, question, once] = examined;
  const auto& row = operation.row();
  if (row.batch.decide == nullptr) return "";
  for (const auto set : {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
    const std::uint64_t choice = choice_of_every_path(set);
    std::string mismatch;
    try {
      const Examination& examination = *examined;
      const Word decision =
          row.decide != nullptr ? examination.robust_decision() : examination.robust_answer().words.at(0);
      mismatch = array_mismatch(operation, question, decision, 0, choice);
    } catch (const InvalidInput& refused) {
      mismatch = array_refusal_mismatch(operation, question, refused.what(), 0, choice);
    }
    if (!mismatch.empty()) return mismatch;
  }
  return "";
}

/// Robust is asked in every floating-point environment, and over arrays.
std::string robust_complaint(const Json& line, const Examined& examined) {
  const auto& [operation, question, once] = examined;
  if (line.contains("refused")) {
    for (std::size_t environment = 0; environment < environment_count; ++environment) {
      const std::string mismatch = operation.refusal_mismatch(question, environment);
      if (!mismatch.empty()) return mismatch + in_words(environment);
    }
    if (std::string mismatch = array_complaint(examined); !mismatch.empty()) return mismatch;
    try {
      *examined;
    } catch (const InvalidInput& refused) {
      return refused.field() == line["refused"]["field"].get<std::string>() &&
                     refused.rule() == line["refused"]["rule"].get<std::string>()
                 ? ""
                 : "refused otherwise";
    }
    return "not refused";
  }
  const Examination& examination = *examined;
  if (!same(without_marks(examination.truth()), line["truth"]))
    return "the oracle's truth is " + one_line(examination.truth());
  for (std::size_t environment = 0; environment < environment_count; ++environment) {
    if (examination.judge_robust(environment).verdict == Verdict::agree) continue;
    return environment == 0 ? "robust answers " + one_line(examination.robust())
                            : "robust answers wrongly" + in_words(environment);
  }
  return array_complaint(examined);
}

/// Compares the rest of the line with what would be written now. Another certificate may also be valid.
std::string other_complaint(const Json& line, const Examined& examined) {
  const std::string family = line.value("family", "");
  const auto& families = examined.operation.families();
  if (family != not_finite_family && family != recorded_family &&
      std::find(families.begin(), families.end(), family) == families.end())
    return "family: one of the operation's families";
  const Json written = vector_line(family, examined);
  for (const auto& [field, value] : line["input"].items()) {
    if (value.is_string() && value.get<std::string>().ends_with(".json") && value != written["input"][field])
      return field + ": " + value.get<std::string>() + " is not the mesh of that name";
  }
  for (const char* name : {"id", "rounded", "margin", "flags", "as_typed"}) {
    const Json right = written.value(name, Json());
    if (!same(line.value(name, Json()), right)) return std::string(name) + " is " + one_line(right);
  }
  return "";
}

}  // namespace

Vectors vectors_of(const Operation& operation, std::uint64_t seed) {
  Vectors vectors;
  std::set<Json> ids;  // a question that is drawn again is no vector more
  const std::size_t limit = operation.metadata().longest_vector, longest = limit == 0 ? std::string::npos : limit;
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    std::map<std::string, std::size_t> seen;
    std::size_t kept = 0;
    for (std::uint64_t i = 0; i < drawn_of_a_family && kept < most_of_a_family; ++i) {
      DrawStream draws = case_draws(operation, family, seed, i);
      const Examined examined{operation, operation.draw(draws, family)};
      if (seen[likeness(examined)]++ >= most_alike) continue;
      const Json vector = vector_line(operation.families()[family], examined, longest);
      if (!ids.insert(vector["id"]).second) continue;
      std::string line = one_line(vector);
      if (line.size() > longest) {
        ++vectors.left_out;
        continue;
      }
      ++kept;
      vectors.lines.push_back(std::move(line));
    }
  }
  for (Question& question : not_finite_questions(operation)) {
    const Json vector = vector_line(not_finite_family, {operation, std::move(question)});
    if (ids.insert(vector["id"]).second) vectors.lines.push_back(one_line(vector));
  }
  return vectors;
}

std::vector<std::string> vectors_of(const Operation& operation, const std::vector<Question>& questions) {
  std::vector<std::string> lines;
  for (const Question& question : questions)
    lines.push_back(one_line(vector_line(recorded_family, {operation, question})));
  return lines;
}

std::string likeness(const Examination& examination) {
  return examination.outcome() + (examination.touch() ? " touch " : " ") +
         name_of(verdict_on_decision(examination.judge_reference()));
}

std::string vector_complaint(const std::string& text, const std::string& folder) {
  Json line;
  try {
    line = parse_own_line(text);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  if (!line.is_object()) return "line: one JSON object";
  if (line.value("touchstone", 0) != vector_version) return "touchstone: version " + std::to_string(vector_version);
  const Operation* operation = line.contains("op") && line["op"].is_string() ? find_operation(line["op"]) : nullptr;
  if (operation == nullptr) return "op: an operation of the catalogue";
  if (!line.contains("refused")) {
    if (const auto reason = certify::refuse_text(text, folder)) return *reason;
  }
  try {
    const Examined examined{*operation, operation->parse_any(without_names(parse_line(text)["input"], folder))};
    std::string complaint = robust_complaint(line, examined);
    if (complaint.empty() && line.contains("refused")) complaint = certify::refuse_text(text, folder).value_or("");
    return complaint.empty() ? other_complaint(line, examined) : complaint;
  } catch (const std::exception& thrown) {
    return thrown.what();
  }
}

std::string robust_complaint(const std::string& text, const std::string& folder) {
  const Json line = parse_line(text);
  const Operation& operation = *find_operation(line["op"]);
  return robust_complaint(Json::parse(text), {operation, operation.parse_any(without_names(line["input"], folder))});
}

}  // namespace touchstone::audit
