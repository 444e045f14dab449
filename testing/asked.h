// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stdexcept>
#include <tuple>
#include <variant>

#include "audit/counting/tally.h"
#include "catalogue/codec/did_you_mean.h"
#include "catalogue/operation/probes/shrink.h"
#include "catalogue/signatures/all.h"
#include "testing/drawn.h"

/// Questions of an operation as the shapes of geometry/, for users' own tests; no test framework is needed.
///
///   #include <touchstone/robust/lines/segment_segment.h>
///   using namespace touchstone;
///   using namespace touchstone::tests;
///   auto found = counterexample<operations::segment_segment>([](const Segment2d& a, const Segment2d& b) {
///     return my::segments_meet(a, b) == (robust::segment_segment(a, b).relation != SegmentRelation::disjoint);
///   });
///   if (found) std::cerr << shown(*found) << '\n';   // already shrunk
namespace touchstone::tests {

/// The operations, each a type of the same name: operations::orientation. docs/operations.md lists their arguments.
namespace operations = ::touchstone::catalogue::signatures;

/// The arguments of an operation: a tuple. If its question has alternatives (in the plane, in space), a variant of
/// tuples, or with `Ts` given the tuple of the one alternative that has these arguments.
template <class Op, class... Ts>
struct ArgumentsOf {
  using type = std::tuple<Ts...>;
};
template <class Op>
struct ArgumentsOf<Op> {
  using type = typename Op::Question;
};

/// A question of an operation and its origin: its arguments, for a structured binding, std::apply or, if they are a
/// variant, std::visit.
template <class Op, class... Ts>
struct Asked : ArgumentsOf<Op, Ts...>::type {
  using Arguments = typename ArgumentsOf<Op, Ts...>::type;
  Drawn drawn;

  const Arguments& arguments() const { return *this; }
  std::string family() const { return drawn.operation->families()[drawn.family]; }
};

/// Prints operation and family, the question in decimal and in hexadecimal, and the command that asks it.
template <class Op, class... Ts>
std::string shown(const Asked<Op, Ts...>& asked) {
  return shown(asked.drawn);
}

template <class Op>
const Operation& operation_of() {
  return *catalogue::find_operation(Op::name);
}

/// Returns nullopt if the question is of another alternative.
template <class Op, class... Ts>
std::optional<Asked<Op, Ts...>> typed(Drawn drawn) {
  auto question = catalogue::unpacked<typename Op::Question>(drawn.question);
  using Arguments = typename ArgumentsOf<Op, Ts...>::type;
  if constexpr (std::is_same_v<Arguments, typename Op::Question>) {
    return Asked<Op, Ts...>{std::move(question), std::move(drawn)};
  } else {
    static_assert(catalogue::is_variant<typename Op::Question>, "these are not the arguments of the operation");
    if (!std::holds_alternative<Arguments>(question)) return std::nullopt;
    return Asked<Op, Ts...>{std::get<Arguments>(std::move(question)), std::move(drawn)};
  }
}

/// Returns the families of these names, or all if the list is empty. Throws InvalidInput if the operation has no such
/// family.
inline std::vector<std::size_t> families_named(const Operation& operation, const std::vector<std::string>& names) {
  const std::vector<std::string>& all = operation.families();
  std::vector<std::size_t> found;
  for (std::size_t family = 0; family < all.size(); ++family) {
    if (names.empty() || std::find(names.begin(), names.end(), all[family]) != names.end()) found.push_back(family);
  }
  for (const std::string& name : names) {
    if (std::find(all.begin(), all.end(), name) == all.end())
      throw InvalidInput("families", operation.name() + " has no family " + name + catalogue::did_you_mean(name, all));
  }
  return found;
}

/// Sizes of the numbers that a question may have.
enum class Sizes {
  any,       ///< the full range of doubles
  ordinary,  ///< every number is 0 or of magnitude 2^-100 to 2^100
};

/// Returns whether the question is within the contract and of these sizes.
inline bool is_wanted(const Drawn& drawn, Sizes sizes) {
  const bool right_size = sizes == Sizes::any || audit::range_of(drawn.question) == audit::Range::ordinary;
  return right_size && is_valid(drawn);
}

/// Draws a question of these families that is within the contract; the same seed draws the same question. Throws
/// std::runtime_error after a thousand invalid draws in a row.
template <class Op, class... Ts>
Asked<Op, Ts...> asked(const std::vector<std::size_t>& families, std::uint64_t seed, Sizes sizes = Sizes::any) {
  constexpr std::uint64_t most_refused = 1000;
  const Operation& operation = operation_of<Op>();
  for (std::uint64_t at = 0; at < most_refused; ++at) {
    const std::size_t family = families[catalogue::seed_of(seed, "family", at) % families.size()];
    Drawn drawn = recorded(operation, family, catalogue::seed_of(seed, "draws", at));
    if (!is_wanted(drawn, sizes)) continue;
    if (auto found = typed<Op, Ts...>(std::move(drawn))) return *std::move(found);
  }
  throw std::runtime_error(operation.name() +
                           ": none of 1000 questions of these families is within the contract and of these sizes");
}

struct Options {
  std::vector<std::string> families{};  ///< empty: all
  std::uint64_t cases = 1000, seed = 1;
  Sizes sizes = Sizes::any;
};

/// Calls a function with the arguments of a question.
template <class Call, class Arguments>
decltype(auto) called_with(const Call& call, const Arguments& arguments) {
  if constexpr (catalogue::is_variant<Arguments>) {
    return std::visit([&](const auto& alternative) { return std::apply(call, alternative); }, arguments);
  } else {
    return std::apply(call, arguments);
  }
}

/// True if a function takes the arguments of every alternative.
template <class Law, class Arguments>
inline constexpr bool takes = false;
template <class Law, class... Ts>
inline constexpr bool takes<Law, std::tuple<Ts...>> = std::is_invocable_v<const Law&, const Ts&...>;
template <class Law, class... Ts>
inline constexpr bool takes<Law, std::variant<Ts...>> = (takes<Law, Ts> && ...);

/// Returns the simplest question found for which a law - a function of the arguments, or else of Asked - does not
/// return true, or throws. Draws up to `cases` questions, stops at the first that fails, and shrinks it within its
/// family. The same options find the same question.
template <class Op, class... Ts, class Law>
std::optional<Asked<Op, Ts...>> counterexample(const Law& law, const Options& options = {}) {
  const auto fails = [&](const Asked<Op, Ts...>& question) {
    try {
      if constexpr (takes<Law, typename Asked<Op, Ts...>::Arguments>) return !called_with(law, question.arguments());
      else return !law(question);
    } catch (const std::exception&) {
      return true;
    }
  };
  const std::vector<std::size_t> families = families_named(operation_of<Op>(), options.families);
  for (std::uint64_t at = 0; at < options.cases; ++at) {
    const Asked<Op, Ts...> first =
        asked<Op, Ts...>(families, catalogue::seed_of(options.seed, "question", at), options.sizes);
    if (!fails(first)) continue;
    const auto of_draws = [&](const std::vector<std::uint8_t>& bytes) {
      return typed<Op, Ts...>(replayed(*first.drawn.operation, first.drawn.family, bytes));
    };
    return of_draws(catalogue::shrunk(first.drawn.draws, [&](const std::vector<std::uint8_t>& bytes) {
      const auto candidate = of_draws(bytes);
      return candidate && is_wanted(candidate->drawn, options.sizes) && fails(*candidate);
    }));
  }
  return std::nullopt;
}

}  // namespace touchstone::tests

/// Lets `const auto [a, b] = question` work.
template <class Op, class... Ts>
struct std::tuple_size<touchstone::tests::Asked<Op, Ts...>>
    : std::tuple_size<typename touchstone::tests::ArgumentsOf<Op, Ts...>::type> {};
template <std::size_t at, class Op, class... Ts>
struct std::tuple_element<at, touchstone::tests::Asked<Op, Ts...>>
    : std::tuple_element<at, typename touchstone::tests::ArgumentsOf<Op, Ts...>::type> {};
