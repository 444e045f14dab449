// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/tally.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "geometry/invalid_input.h"

namespace touchstone::audit {
namespace {

/// The length of a list of numbers for a reader: the digits of the numbers written out without exponents, so that 0.1
/// is shorter than 5e-324 although both have one significant digit; then the powers of ten.
struct Length {
  std::uint64_t digits = 0, exponents = 0;
};

void add(double number, Length& sum) {
  if (number == 0) {
    sum.digits += std::signbit(number) ? 2 : 0;
    return;
  }
  char text[40];
  const char* end = std::to_chars(text, text + sizeof text, number, std::chars_format::scientific).ptr;
  const char* mark = std::find<const char*>(text, end, 'e');
  if (mark == end) return;
  const std::int64_t significant = std::count_if<const char*>(text, mark, [](char c) { return c >= '0' && c <= '9'; });
  const std::int64_t exponent = std::atoll(std::string(mark + 1, end).c_str());
  sum.digits += static_cast<std::uint64_t>(exponent < 0 ? significant - exponent : std::max(significant, exponent + 1));
  sum.exponents += static_cast<std::uint64_t>(std::abs(exponent));
}

Length length(const Question& question) {
  Length sum;
  for (const double number : question.numbers) add(number, sum);
  for (const Word word : question.words) add(word, sum);
  return sum;
}

void merge_operations(std::vector<OperationTally>& into, const std::vector<OperationTally>& from) {
  for (const OperationTally& other : from) {
    const auto same_name = [&](const OperationTally& t) { return t.operation == other.operation; };
    const auto found = std::find_if(into.begin(), into.end(), same_name);
    if (found == into.end()) {
      into.push_back(other);
      continue;
    }
    for (const auto& [family, cell] : other.families) {
      const auto same_family = [&, name = family](const auto& entry) { return entry.first == name; };
      const auto entry = std::find_if(found->families.begin(), found->families.end(), same_family);
      if (entry == found->families.end()) {
        found->families.emplace_back(family, cell);
      } else {
        entry->second.merge(cell);
      }
    }
  }
}

std::pair<std::ptrdiff_t, std::string> place(const std::vector<std::string>& names, const std::string& name) {
  return {std::find(names.begin(), names.end(), name) - names.begin(), name};
}

std::vector<std::string> names_of_operations() {
  std::vector<std::string> operations;
  for (const Operation* operation : all_operations()) operations.push_back(operation->name());
  return operations;
}

/// Removes duplicates and sorts in the catalogue's order.
void put_in_order(std::vector<std::string>& names) {
  const std::vector<std::string> operations = names_of_operations();
  std::sort(names.begin(), names.end(),
            [&](const std::string& a, const std::string& b) { return place(operations, a) < place(operations, b); });
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

/// Sorts in the catalogue's order, whatever was merged first; unknown operations and families come last, by name.
void put_in_order(std::vector<OperationTally>& tallies) {
  const std::vector<std::string> operations = names_of_operations();
  std::sort(tallies.begin(), tallies.end(), [&](const OperationTally& a, const OperationTally& b) {
    return place(operations, a.operation) < place(operations, b.operation);
  });
  for (OperationTally& tally : tallies) {
    const Operation* operation = find_operation(tally.operation);
    const std::vector<std::string> families = operation ? operation->families() : std::vector<std::string>();
    std::sort(tally.families.begin(), tally.families.end(),
              [&](const auto& a, const auto& b) { return place(families, a.first) < place(families, b.first); });
  }
}

bool share_a_family(const std::vector<OperationTally>& a, const std::vector<OperationTally>& b) {
  for (const OperationTally& left : a) {
    for (const OperationTally& right : b) {
      if (left.operation != right.operation) continue;
      for (const auto& [family, cell] : left.families) {
        for (const auto& [other_family, other] : right.families) {
          if (family == other_family && cell.cases() > 0 && other.cases() > 0) return true;
        }
      }
    }
  }
  return false;
}

void require_disjoint(const Tally& a, const Tally& b) {
  const auto engine = [](const Declaration& d) { return std::tie(d.engine, d.boundary, d.binary32, d.tolerance); };
  if (a.version != b.version) throw InvalidInput("version", "the same in every file");
  if (engine(a.declaration) != engine(b.declaration)) throw InvalidInput("engine", "the same in every file");
  if (!(a.limits == b.limits)) throw InvalidInput("limits", "the same in every file");
  if (a.grid.size != b.grid.size) throw InvalidInput("grid.size", "the same in every file");
  if (a.grid.shards != b.grid.shards) throw InvalidInput("grid.shards", "the same in every file");
  if (a.grid.size == 0 && a.grid.shards > 1) {
    if (a.seed != b.seed) throw InvalidInput("seed", "the same in shards of one run");
    if (a.cases != b.cases) throw InvalidInput("cases", "the same in shards of one run");
    if (a.by_cost != b.by_cost) throw InvalidInput("by_cost", "the same in shards of one run");
  } else if (!share_a_family(a.operations, b.operations)) {
    return;
  } else if (a.grid.size == 0) {
    if (a.seed == b.seed) throw InvalidInput("seed", "different in files that count the same family");
    return;
  }
  for (const std::uint64_t shard : a.grid.done) {
    if (std::binary_search(b.grid.done.begin(), b.grid.done.end(), shard)) {
      throw InvalidInput("grid.done", "duplicate shard " + std::to_string(shard));
    }
  }
}

}  // namespace

Range range_of(const Question& question, const Limits& limits) {
  const auto within = [&](double number) {
    const double size = std::fabs(number);
    return size == 0 || (size >= limits.least && size <= limits.most);
  };
  const bool ordinary = std::all_of(question.numbers.begin(), question.numbers.end(), within);
  return ordinary ? Range::ordinary : Range::extreme;
}

const Examination& Finding::examination(const Operation& operation) const {
  return *examined->value([&] { return operation.examine(question); });
}

const char* cause_of(const Judgement& judgement) {
  if (judgement.verdict != Verdict::rounding) return name_of(judgement.verdict);
  return judgement.out_of_range ? "out_of_range" : "cancellation";
}

bool shown_before(const Finding& a, const Finding& b) {
  if (a.range != b.range) return a.range < b.range;
  if (a.features != b.features) return a.features < b.features;
  if (smaller(a.question, b.question)) return true;
  return !smaller(b.question, a.question) && a.index < b.index;
}

void OutcomeCount::merge(const OutcomeCount& other) {
  for (std::size_t range = 0; range < range_count; ++range) {
    cases[range] += other.cases[range];
    out_of_range[range] += other.out_of_range[range];
  }
  if (other.example && (!example || shown_before(*other.example, *example))) example = other.example;
}

ByRange Cell::by_range() const {
  ByRange sum{};
  for (const auto& [outcome, counted] : outcomes) sum[0] += counted.cases[0], sum[1] += counted.cases[1];
  return sum;
}
ByRange Cell::by_range(Verdict verdict) const {
  ByRange sum{};
  for (const auto& [outcome, counted] : outcomes) {
    if (outcome.verdict == verdict) sum[0] += counted.cases[0], sum[1] += counted.cases[1];
  }
  return sum;
}

std::uint64_t Cell::cases() const { return both(by_range()); }
std::uint64_t Cell::cases(Range range) const { return by_range()[static_cast<std::size_t>(range)]; }
std::uint64_t Cell::count(Verdict verdict) const { return both(by_range(verdict)); }
std::uint64_t Cell::count(Verdict verdict, Range range) const {
  return by_range(verdict)[static_cast<std::size_t>(range)];
}

std::array<std::uint64_t, verdict_count> Cell::counts() const {
  std::array<std::uint64_t, verdict_count> sums{};
  for (const auto& [outcome, counted] : outcomes)
    sums[static_cast<std::size_t>(outcome.verdict)] += both(counted.cases);
  return sums;
}

std::uint64_t Cell::answered(Range range) const { return cases(range) - count(Verdict::unsupported, range); }
std::uint64_t Cell::answered() const { return cases() - count(Verdict::unsupported); }

std::uint64_t Cell::wrong(Range range) const { return findings(range) - count(Verdict::inexact, range); }
std::uint64_t Cell::wrong() const { return findings() - count(Verdict::inexact); }

std::uint64_t Cell::findings(Range range) const {
  std::uint64_t sum = 0;
  for (const auto& [outcome, counted] : outcomes)
    sum += is_finding(outcome.verdict) ? counted.cases[static_cast<std::size_t>(range)] : 0;
  return sum;
}
std::uint64_t Cell::findings() const { return findings(Range::ordinary) + findings(Range::extreme); }

ByRange Cell::out_of_range() const {
  ByRange sum{};
  for (const auto& [outcome, counted] : outcomes) sum[0] += counted.out_of_range[0], sum[1] += counted.out_of_range[1];
  return sum;
}
ByRange Cell::cancellation() const {
  const ByRange rounding = by_range(Verdict::rounding), out = out_of_range();
  return {rounding[0] - out[0], rounding[1] - out[1]};
}

std::map<std::string, std::uint64_t> Cell::truths() const {
  std::map<std::string, std::uint64_t> sums;
  for (const auto& [outcome, counted] : outcomes) sums[outcome.truth] += both(counted.cases);
  return sums;
}

std::map<std::pair<std::string, std::string>, ByRange> Cell::confusion() const {
  std::map<std::pair<std::string, std::string>, ByRange> sums;
  for (const auto& [outcome, counted] : outcomes) {
    ByRange& sum = sums[{outcome.truth, outcome.answer}];
    sum[0] += counted.cases[0], sum[1] += counted.cases[1];
  }
  return sums;
}

const Finding* Cell::example(Verdict verdict) const {
  const Finding* best = nullptr;
  for (const auto& [outcome, counted] : outcomes) {
    if (outcome.verdict != verdict || !counted.example) continue;
    if (best == nullptr || shown_before(*counted.example, *best)) best = &*counted.example;
  }
  return best;
}

bool Cell::nothing_right() const {
  constexpr std::uint64_t many = 20;
  return answered() >= many && wrong() == answered();
}

Cell Cell::of(const std::array<std::uint64_t, verdict_count>& counts) {
  Cell cell;
  for (std::size_t v = 0; v < verdict_count; ++v) {
    if (counts[v] > 0) cell.outcomes[{static_cast<Verdict>(v), "value", "value"}].cases[0] = counts[v];
  }
  return cell;
}

void Cell::refuse(const std::string& rule) {
  ++refused;
  ++rules[rule.substr(0, rule.find(':'))];
}

void Cell::merge(const Cell& other) {
  for (const auto& [outcome, counted] : other.outcomes) outcomes[outcome].merge(counted);
  worst_ulps = std::max(worst_ulps, other.worst_ulps);
  touches_closed += other.touches_closed;
  touches_open += other.touches_open;
  surplus += other.surplus;
  apart += other.apart;
  refused += other.refused;
  hash += other.hash;
  left_out += other.left_out;
  found_on_axis += other.found_on_axis;
  right_off_axis += other.right_off_axis;
  other_nearest += other.other_nearest;
  other_alternative += other.other_alternative;
  not_asked += other.not_asked;
  if (given_up.empty() || (!other.given_up.empty() && other.given_up < given_up)) given_up = other.given_up;
  for (const auto& [rule, n] : other.rules) rules[rule] += n;
  recorded.merge(other.recorded);
}

bool smaller(const Question& a, const Question& b) {
  const Length la = length(a), lb = length(b);
  if (la.digits != lb.digits) return la.digits < lb.digits;
  if (la.exponents != lb.exponents) return la.exponents < lb.exponents;
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  const auto below = [&](double x, double y) { return bits(x) < bits(y); };
  const auto before = [&](const Question& p, const Question& q) {
    return std::lexicographical_compare(p.numbers.begin(), p.numbers.end(), q.numbers.begin(), q.numbers.end(), below);
  };
  if (before(a, b) || before(b, a)) return before(a, b);
  return a.words < b.words;
}

Cell OperationTally::total() const {
  Cell sum;
  for (const auto& [family, cell] : families) sum.merge(cell);
  return sum;
}

bool OperationTally::inconsistent_convention() const {
  const Cell sum = total();
  return sum.touches_closed > 0 && sum.touches_open > 0;
}

bool Tally::ordinary_only() const {
  for (const OperationTally& operation : operations)
    for (const auto& [family, cell] : operation.families)
      if (cell.left_out > 0) return true;
  return false;
}

bool Tally::has_findings() const {
  const auto found = [this](const OperationTally& t) {
    const Cell total = t.total();
    return total.findings() > 0 || total.not_asked > 0 || t.inconsistent_convention() ||
           t.too_much_surplus(max_surplus);
  };
  return std::any_of(operations.begin(), operations.end(), found) || std::any_of(robust.begin(), robust.end(), found);
}

void Tally::merge(const Tally& other) {
  require_disjoint(*this, other);
  merge_operations(operations, other.operations);
  merge_operations(robust, other.robust);
  undeclared.insert(undeclared.end(), other.undeclared.begin(), other.undeclared.end());
  put_in_order(operations);
  put_in_order(robust);
  put_in_order(undeclared);
  std::vector<std::uint64_t> done;
  std::set_union(grid.done.begin(), grid.done.end(), other.grid.done.begin(), other.grid.done.end(),
                 std::back_inserter(done));
  grid.done = std::move(done);
  seed = std::min(seed, other.seed);
  for (const std::string& log : other.logs)
    if (std::find(logs.begin(), logs.end(), log) == logs.end()) logs.push_back(log);
  if (grid.size == 0 && grid.shards == 1) cases += other.cases;  // every shard names the full number
  interrupted = interrupted || other.interrupted;
}

}  // namespace touchstone::audit
