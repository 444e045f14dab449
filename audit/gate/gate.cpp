// SPDX-License-Identifier: Apache-2.0
#include "audit/gate/gate.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "audit/counted.h"
#include "audit/counting/repeat.h"
#include "audit/gate/shown.h"
#include "catalogue/codec/did_you_mean.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_lines = 20;

std::uint64_t findings_of(const Cell& cell, Cause cause) {
  switch (cause) {
    case Cause::cancellation: return both(cell.cancellation());
    case Cause::out_of_range: return both(cell.out_of_range());
    case Cause::algorithm: return cell.count(Verdict::algorithm);
    case Cause::inexact: return cell.count(Verdict::inexact);
    case Cause::invalid: return cell.count(Verdict::invalid);
    case Cause::convention: return cell.count(Verdict::convention);
    case Cause::tolerance: return cell.count(Verdict::tolerance);
    case Cause::unsupported: return cell.count(Verdict::unsupported);
    case Cause::not_asked: return cell.not_asked;
    case Cause::inconsistent_convention:
    case Cause::surplus: break;  // of an operation
  }
  return 0;
}

bool same_place(const Found& a, const Found& b) {
  return a.operation == b.operation && a.family == b.family && a.cause == b.cause;
}

/// The number of cases of an operation, all families together.
std::uint64_t cases_of(const OperationTally& operation) {
  const Cell total = operation.total();
  return total.cases() + total.not_asked;
}

/// The shell command that repeats an entry's example, if it has one.
std::string repeated(const Tally& tally, const Found& found) {
  const Finding* example = example_of(tally, found);
  if (example == nullptr) return "";
  return "    " + repeat_command(*find_operation(found.operation), example->question, tally, false) + "\n";
}

}  // namespace

std::set<Cause> usual_causes() {
  return {Cause::cancellation,
          Cause::out_of_range,
          Cause::algorithm,
          Cause::inexact,
          Cause::invalid,
          Cause::not_asked,
          Cause::inconsistent_convention,
          Cause::surplus};
}

std::set<Cause> causes_named(const std::string& names) {
  std::set<Cause> causes;
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t to = std::min(names.find(',', from), names.size());
    const std::string name = names.substr(from, to - from);
    from = to + 1;
    if (name == "none") continue;
    if (name == "rounding") {
      causes.insert({Cause::cancellation, Cause::out_of_range});
      continue;
    }
    const auto known = std::find(cause_names.begin(), cause_names.end(), name);
    if (known == cause_names.end()) {
      std::vector<const char*> names_known{"none", "rounding"};
      names_known.insert(names_known.end(), cause_names.begin(), cause_names.end());
      std::string rule;
      for (const char* cause : names_known) rule += std::string(rule.empty() ? "one of " : ", ") + cause;
      throw InvalidInput("\"" + name + "\"", rule + did_you_mean(name, names_known));
    }
    causes.insert(static_cast<Cause>(known - cause_names.begin()));
  }
  return causes;
}

std::vector<Found> found_in(const Tally& tally, const std::set<Cause>& causes) {
  std::vector<Found> all;
  for (const OperationTally& operation : tally.operations) {
    for (const auto& [family, cell] : operation.families) {
      for (const Cause cause : causes) {
        const std::uint64_t findings = findings_of(cell, cause);
        if (findings > 0) all.push_back({operation.operation, family, cause, findings, cell.cases() + cell.not_asked});
      }
    }
    if (causes.count(Cause::inconsistent_convention) > 0 && operation.inconsistent_convention())
      all.push_back({operation.operation, "", Cause::inconsistent_convention, 1, cases_of(operation)});
    if (causes.count(Cause::surplus) > 0 && operation.too_much_surplus(tally.max_surplus))
      all.push_back({operation.operation, "", Cause::surplus, 1, cases_of(operation)});
  }
  return all;
}

Baseline baseline_of(const Tally& tally, const std::set<Cause>& causes) {
  return {tally.declaration.engine, tally.seed, found_in(tally, causes)};
}

std::uint64_t accepted(const Found& found, std::uint64_t seed, const Baseline& baseline) {
  const auto known = std::find_if(baseline.known.begin(), baseline.known.end(),
                                  [&](const Found& entry) { return same_place(entry, found); });
  if (known == baseline.known.end() || known->cases == 0) return 0;
  const bool of_operation = found.cause == Cause::inconsistent_convention || found.cause == Cause::surplus;
  if (of_operation || (seed == baseline.seed && found.cases == known->cases))
    return std::min(found.findings, known->findings);
  const double scale = static_cast<double>(found.cases) / static_cast<double>(known->cases);
  const double expected = static_cast<double>(known->findings) * scale;
  // The count then has a variance of about `expected`, and the count at that time, scaled, of `expected * scale`.
  const double most = std::floor(expected + 3 * std::sqrt(expected * (1 + scale)));
  return most >= static_cast<double>(found.findings) ? found.findings : static_cast<std::uint64_t>(most);
}

bool GateResult::passed() const {
  return robust == 0 && std::none_of(entries.begin(), entries.end(), [](const GateEntry& e) { return e.fails; });
}

GateResult held_against(const Tally& tally, const Gate& gate) {
  GateResult result;
  std::map<std::string, std::uint64_t> unknown;  // by operation
  for (const Found& found : found_in(tally, gate.causes)) {
    const std::uint64_t known = gate.baseline ? accepted(found, tally.seed, *gate.baseline) : 0;
    unknown[found.operation] += found.findings - known;
    result.entries.push_back({found, known, false});
  }
  std::map<std::string, bool> too_many;
  for (const OperationTally& operation : tally.operations) {
    const auto most = gate.max_rate * static_cast<double>(cases_of(operation));
    too_many[operation.operation] = static_cast<double>(unknown[operation.operation]) > most;
  }
  for (GateEntry& entry : result.entries)
    entry.fails = entry.found.findings > entry.known && too_many[entry.found.operation];
  for (const OperationTally& operation : tally.robust) result.robust += operation.total().findings();
  if (!gate.baseline) return result;
  for (const Found& known : gate.baseline->known) {
    const auto asked = [&](const OperationTally& operation) {
      return operation.operation == known.operation &&
             (known.family.empty() || std::any_of(operation.families.begin(), operation.families.end(),
                                                  [&](const auto& family) { return family.first == known.family; }));
    };
    const auto found = [&](const GateEntry& entry) { return same_place(entry.found, known); };
    if (gate.causes.count(known.cause) == 0) continue;
    if (std::any_of(tally.operations.begin(), tally.operations.end(), asked) &&
        std::none_of(result.entries.begin(), result.entries.end(), found))
      ++result.gone;
  }
  return result;
}

std::string gate_in_words(const Tally& tally, const GateResult& result) {
  std::uint64_t known = 0, failing = 0, tolerated = 0;
  std::string lines;
  std::size_t count = 0;
  for (const GateEntry& entry : result.entries) {
    const std::uint64_t fresh = entry.found.findings - entry.known;
    known += entry.known;
    (entry.fails ? failing : tolerated) += fresh;
    if (!entry.fails || ++count > most_lines) continue;
    lines += "  " + entry.found.operation + (entry.found.family.empty() ? "" : ", " + entry.found.family) + ": " +
             in_words(entry) + "\n" + repeated(tally, entry.found);
  }
  if (count > most_lines) lines += "  and " + std::to_string(count - most_lines) + " more\n";
  std::string text = result.passed() ? "gate: passed" : "gate: failed";
  if (failing > 0) text += ": " + counted(failing, "new finding");
  if (known > 0) text += "; known: " + grouped(known);
  if (tolerated > 0) text += "; within --max-rate: " + grouped(tolerated);
  if (result.robust > 0) text += "; robust is wrong in " + counted(result.robust, "case");
  if (result.gone > 0)
    text += "; " + (result.gone == 1 ? std::string("1 entry") : grouped(result.gone) + " entries") +
            " of the baseline no longer found (--write-baseline makes it anew)";
  return text + "\n" + lines;
}

}  // namespace touchstone::audit
