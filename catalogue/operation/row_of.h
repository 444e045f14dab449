// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/judge/environment.h"
#include "catalogue/operation/arrays_of.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/row.h"

/// Makes an operation from its row: the only place where its types are erased.
namespace touchstone::catalogue {

/// SplitMix64's output function, as in DrawStream.
inline std::uint64_t scattered(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Every number 0, every list of that length.
template <class Asked>
Asked zeros(std::size_t length) {
  Asked asked{};
  walk(
      asked, [](auto& number) { number = 0; }, [&](auto& list) { list.resize(length); });
  return asked;
}

/// True if a function of `Stages` takes the arguments of a question.
template <class Ask, class Asked>
inline constexpr bool takes = false;
template <class Ask, class... Ts>
inline constexpr bool takes<Ask, std::tuple<Ts...>> = requires(const Ts&... q) {
  Ask::ask(q...);
};
template <class Ask, class... Ts>
inline constexpr bool takes<Ask, std::variant<Ts...>> = (takes<Ask, Ts> && ...);

template <class Stages, robust::Stage stage>
struct AskStage {
  static auto ask(const auto&... q) -> decltype(robust::asked<Stages>(robust::At<stage>(), q...)) {
    return robust::asked<Stages>(robust::At<stage>(), q...);
  }
};

template <class Ask, class Asked>
auto asked_in(std::size_t environment, const Question& question) {
  return in_environment(environment, unpacked<Asked>(question), [](const Asked& q) {
    return applied([](const auto&... value) { return Ask::ask(value...); }, q);
  });
}

template <class Stages, class Asked, robust::Stage stage>
void add_stage(StageFunctions& found) {
  using Ask = AskStage<Stages, stage>;
  if constexpr (takes<Ask, Asked>) {
    found.each.push_back(
        {stage, [](const Question& question, std::size_t environment) -> std::optional<EncodedValue<double>> {
           const auto answer = asked_in<Ask, Asked>(environment, question);
           if constexpr (requires { *answer; }) {
             if (!answer) return std::nullopt;
             return packed(*answer);
           } else {
             return packed(answer);
           }
         }});
  }
}

template <class Stages, class Asked>
StageFunctions stage_functions() {
  StageFunctions found;
  [&]<std::size_t... i>(std::index_sequence<i...>) { (add_stage<Stages, Asked, robust::all_stages[i]>(found), ...); }
  (std::make_index_sequence<std::size(robust::all_stages)>());
  if constexpr (takes<Stages, Asked>) {
    found.decided_by = [](const Question& question, std::size_t environment) {
      return asked_in<Stages, Asked>(environment, question).stage;
    };
  }
  return found;
}

/// A number of a question in the type in which the question is asked.
inline constexpr auto in_exact = [](double number) { return Exact(exact_value(number)); };
inline constexpr auto in_integers = [](double number) { return static_cast<std::int64_t>(number); };
inline constexpr auto rational = [](const TrueNumber& number) { return number.rational_part(); };

template <class Row>
struct RowOf {
  using Asked = typename Row::Question;
  using Answer = answer_t<Row>;
  using Truth = truth_t<Row>;
  static constexpr bool decides = requires(const Asked& q) { Row::decision::robust(q); };
  static constexpr bool decides_quickly = requires(const Asked& q) { Row::decision::oracle(q); };

  static EncodedValue<double> reference(const Question& question) {
    return packed(ask_reference<Row>(unpacked<Asked>(question)));
  }
  static EncodedValue<Exact> reference_exactly(const Question& question) {
    return packed_as<Exact>(ask_reference<Row>(unpacked<rebound_t<Asked, Exact>>(question, in_exact)));
  }
  /// The textbook's formula, and others.
  struct Reference {
    auto operator()(const auto&... q) const { return Row::reference(q...); }
  };
  template <class Formula>
  static EncodedValue<Tracked> tracked(const Question& question, bool binary32) {
    const Tracked::Format format(binary32);
    const auto given = [](double number) { return Tracked(number); };
    return packed_as<Tracked>(applied(Formula(), unpacked<rebound_t<Asked, Tracked>>(question, given)));
  }
  struct AddStandard {
    std::vector<TrackedFormula>& all;
    template <class Formula>
    void operator()(const char* name, Formula) const {
      all.push_back({name, tracked<Formula>});
    }
  };

  static EncodedValue<double> robust(const Question& question, std::size_t environment) {
    return packed(
        in_environment(environment, unpacked<Asked>(question), [](const Asked& q) { return ask_robust<Row>(q); }));
  }
  static EncodedValue<double> prepared(const Question& question, std::size_t environment) {
    return packed(
        in_environment(environment, unpacked<Asked>(question), [](const Asked& q) { return ask_prepared<Row>(q); }));
  }
  static Solution solve(const Question& question) {
    auto truth = ask_oracle<Row>(unpacked<Asked>(question));
    return {packed_as<TrueNumber>(truth.answer), std::move(truth.margin), std::move(truth.certificate)};
  }
  static Solution solve_as_typed(const EncodedValue<mpq_class>& question) {
    using Typed = rebound_t<Asked, mpq_class>;
    auto truth = ask_oracle<Row>(unpacked<Typed>(question, as_it_is));
    return {packed_as<TrueNumber>(truth.answer), std::move(truth.margin)};
  }

  static Word decide(const Question& question, std::size_t environment) {
    return static_cast<Word>(in_environment(environment, unpacked<Asked>(question),
                                            [](const Asked& q) { return Row::decision::robust(q); }));
  }
  static Word decide_by_oracle(const Question& question) {
    return static_cast<Word>(Row::decision::oracle(unpacked<Asked>(question)));
  }
  static Word decide_by_integers(const Question& question) {
    using IntegerQuestion = rebound_t<Asked, std::int64_t>;
    return static_cast<Word>(Row::decision::oracle(unpacked<IntegerQuestion>(question, in_integers)));
  }
  static DecisionCount count_decisions(int size, std::uint64_t first, std::uint64_t last, std::size_t list_length);

  static const std::vector<HardCase<Asked>>& hard_cases() {
    static const std::vector<HardCase<Asked>> all = hard_cases_of<Row>();
    return all;
  }
  static Question draw_hard_case(std::size_t which, DrawStream& draws) {
    return packed(hard_cases()[which].draw(draws));
  }

  /// The hooks with their types erased.
  static constexpr auto hooks = [] { return Row::hooks(); };
  static Truth typed(const EncodedTruth& truth) {
    if constexpr (std::is_same_v<number_of_t<Truth>, TrueNumber>) return unpacked<Truth>(truth, as_it_is);
    else return unpacked<Truth>(truth, rational);
  }
  static std::optional<EncodedTruth> as_open_sets(const EncodedTruth& truth, const Question& question) {
    const auto open = hooks().as_open_sets(typed(truth), unpacked<Asked>(question));
    if (!open) return std::nullopt;
    return packed_as<TrueNumber>(*open);
  }
  static std::string defect(const Question& question, const EncodedValue<double>& answer) {
    return hooks().defect(unpacked<Asked>(question), unpacked<Answer>(answer));
  }
  static std::string exact_defect(const Question& question, const EncodedValue<mpq_class>& answer) {
    using ExactAnswer = rebound_t<Answer, mpq_class>;
    return hooks().exact_defect(unpacked<Asked>(question), unpacked<ExactAnswer>(answer, as_it_is));
  }
  static Excess excess(const Question& question, const EncodedValue<double>& answer,
                       const EncodedValue<double>& truth) {
    return hooks().excess(unpacked<Asked>(question), unpacked<Answer>(answer), unpacked<Answer>(truth));
  }
  static std::optional<EncodedTruth> as_near(const Question& question, const EncodedTruth& truth,
                                             const EncodedValue<double>& answer) {
    const auto other = hooks().as_near(unpacked<Asked>(question), typed(truth), unpacked<Answer>(answer));
    if (!other) return std::nullopt;
    return packed_as<TrueNumber>(*other);
  }
  static void repair(Question& question) {
    auto asked = unpacked<Asked>(question);
    hooks().repair(asked);
    question = packed(asked);
  }
  static void scale(Question& question, int exponent) {
    auto asked = unpacked<Asked>(question);
    hooks().scale(asked, exponent);
    question = packed(asked);
  }
  static std::vector<std::uint64_t> places(const Question& question) {
    return hooks().places(unpacked<Asked>(question));
  }
  static std::vector<mpq_class> residuals(const Question& question, const EncodedValue<double>& answer) {
    return hooks().residuals(unpacked<Asked>(question), unpacked<Answer>(answer));
  }
  static Question map_centre() { return packed(hooks().map_centre()); }
  static void draw(Drawing& drawing, const Question& question, const EncodedValue<double>& truth) {
    hooks().draw(drawing, unpacked<Asked>(question), unpacked<Answer>(truth));
  }
  static std::uint64_t domain_count(int size) { return hooks().domain_count(size); }
  static Question domain_at(int size, std::uint64_t index) { return packed(hooks().domain_at(size, index)); }

  static RowFunctions functions();
};

/// The inner loop of an exhaustive run of decisions, with numbers counting up like digits, or over the row's domain.
template <class Row>
DecisionCount RowOf<Row>::count_decisions(int size, std::uint64_t first, std::uint64_t last, std::size_t list_length) {
  auto asked = zeros<Asked>(list_length);
  auto integers = zeros<rebound_t<Asked, std::int64_t>>(list_length);
  std::vector<double*> numbers;
  std::vector<std::int64_t*> digits;
  for_each_number(asked, [&](double& number) { numbers.push_back(&number); });
  for_each_number(integers, [&](std::int64_t& number) { digits.push_back(&number); });
  const auto given = hooks();
  const auto take = [&](std::uint64_t index) {
    if (given.domain_at) asked = given.domain_at(size, index);
    for (std::size_t i = digits.size(); i-- > 0; index /= static_cast<std::uint64_t>(size)) {
      if (given.domain_at) *digits[i] = static_cast<std::int64_t>(*numbers[i]);
      else
        *numbers[i] =
            static_cast<double>(*digits[i] = static_cast<std::int64_t>(index % static_cast<std::uint64_t>(size)));
    }
  };
  const auto count_up = [&] {
    for (std::size_t i = digits.size(); i-- > 0;) {
      if (++*digits[i] < size) {
        *numbers[i] = static_cast<double>(*digits[i]);
        break;
      }
      *digits[i] = 0;
      *numbers[i] = 0;
    }
  };
  using Decision = decltype(Row::decision::robust(asked));
  // A question outside the contract, a ring that is closed over two vertices, has to be refused.
  const auto oracle_refuses = [](const Asked& q) {
    try {
      ask_oracle<Row>(q);
    } catch (const InvalidInput&) {
      return true;
    }
    return false;
  };
  const auto decides_so = [&](const Asked& q, Decision truth) {
    try {
      return Row::decision::robust(q) == truth;
    } catch (const InvalidInput&) {
      return oracle_refuses(q);
    }
  };
  std::array<std::uint64_t, Words<Decision>::words.size()> outcomes{}, of_grid{};
  DecisionCount count;
  if (first < last) take(first);
  for (std::uint64_t index = first; index < last;) {
    const Decision truth = Row::decision::oracle(integers);
    const auto word = static_cast<std::size_t>(truth);
    ++outcomes[word];
    if (given.domain_weight) of_grid[word] += given.domain_weight(size, index);
    count.hash += scattered(index * 4 + word);
    if (!decides_so(asked, truth) && count.wrong++ == 0) count.first_wrong = index;
    if (++index == last) break;
    if (given.domain_at) take(index);
    else count_up();
  }
  count.cases = last - first;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    count.outcomes[Words<Decision>::words[i]] = outcomes[i];
    if (given.domain_weight) count.of_grid[Words<Decision>::words[i]] = of_grid[i];
  }
  return count;
}

template <class Row>
RowFunctions RowOf<Row>::functions() {
  static_assert(std::is_same_v<Answer, typename Row::Answer>, "robust answers with the type that the signature names");
  RowFunctions f{};
  f.metadata = &Row::metadata;
  f.question = &shape_of<Asked>();
  f.answer = &shape_of<Answer>();
  f.reference = reference;
  f.reference_exactly = reference_exactly;
  f.reference_tracked = {"", tracked<Reference>};
  if constexpr (requires(const AddStandard& add) { Row::standard(add); }) Row::standard(AddStandard{f.standard});
  f.robust = robust;
  if constexpr (requires { Row::takes_prepared; }) f.prepared = prepared;
  f.solve = solve;
  if constexpr (oracle_takes<Row, rebound_t<Asked, mpq_class>>) f.solve_as_typed = solve_as_typed;
  if constexpr (decides) {
    f.decision = &shape_of<decltype(Row::decision::robust(std::declval<const Asked&>()))>();
    f.decide = decide;
  } else {
    static_assert(std::is_same_v<typename Row::decision, NoDecision>, "decision: robust(Question), or NoDecision");
  }
  if constexpr (decides_quickly) {
    f.decide_by_oracle = decide_by_oracle;
    f.decide_by_integers = decide_by_integers;
    f.count_decisions = count_decisions;
  }
  if constexpr (answers_arrays<Row, Asked>) f.batch = {ArraysOf<Row, Asked>::decide, ArraysOf<Row, Asked>::columns};
  if constexpr (requires { typename Row::stages; }) f.stages = stage_functions<typename Row::stages, Asked>();
  if constexpr (requires { typename Row::stages::decision; })
    f.decision_stages = stage_functions<typename Row::stages::decision, Asked>();
  for (const HardCase<Asked>& hard : hard_cases()) f.hard_cases.push_back({hard.name, hard.unscaled});
  f.draw_hard_case = draw_hard_case;
  const auto given = hooks();
  if (given.as_open_sets) f.as_open_sets = as_open_sets;
  if (given.defect) f.defect = defect;
  if (given.exact_defect) f.exact_defect = exact_defect;
  if (given.excess) f.excess = excess;
  if (given.as_near) f.as_near = as_near;
  if (given.repair) f.repair = repair;
  if (given.scale) f.scale = scale;
  if (given.places) f.places = places;
  if (given.residuals) f.residuals = residuals;
  if (given.map_centre) f.map_centre = map_centre;
  f.map_axes = given.map_axes;
  if (given.draw) f.draw = draw;
  f.laws = given.laws;
  if (given.domain_count) f.world = SmallDomain{domain_count, domain_at};
  return f;
}

template <class Row>
const Operation& operation_of_row() {
  static const Operation operation(RowOf<Row>::functions());
  return operation;
}

}  // namespace touchstone::catalogue
