// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "catalogue/explained.h"
#include "catalogue/row.h"
#include "catalogue/families/families.h"
#include "catalogue/judge/compare.h"
#include "catalogue/judge/environment.h"
#include "fuzz/driver/target.h"

namespace touchstone::fuzz {

/// How near the deciding quantity came to a change of answer is news to libFuzzer, as a branch that was not taken before would be.
void report_margin(const mpq_class& margin, int degree, std::span<const double> numbers, std::size_t outcome);

/// FNV-1a: what else is done with an input is decided by its bytes alone.
inline std::uint64_t scattered(Bytes data) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t byte : data) hash = (hash ^ byte) * 0x100000001b3u;
  return hash ^ hash >> 29;
}

template <class Row>
class TargetOf final : public Target {
 public:
  using Asked = typename Row::Question;

  /// Where decisions can be had without numbers, only every 16th input is examined in full. JSON is slower than all the rest together,
  /// so that there only every 256th of those, elsewhere every 16th, has its certificate checked.
  std::string complaint(Bytes data) const override {
    const Asked asked = decoded(data);
    const std::uint64_t hash = scattered(data);
    const std::size_t environment = hash % 2 == 0 ? 0 : hash / 2 % audit::environment_count;
    try {
      if constexpr (decides_quickly) {
        const auto truth = Row::decision::oracle(asked);
        const auto answer =
            audit::in_environment(environment, asked, [](const Asked& q) { return Row::decision::robust(q); });
        if (answer != truth)
          return "robust and oracle decide differently (" + audit::environment_name(environment) + ")";
        if (hash / 32 % 16 != 0) return "";
      }
      const auto truth = audit::ask_oracle<Row>(asked);
      const auto answer =
          audit::in_environment(environment, asked, [](const Asked& q) { return audit::ask_robust<Row>(q); });
      if (differ(asked, truth.answer, answer))
        return "robust and oracle differ (" + audit::environment_name(environment) + ")";
      if constexpr (audit::decides_alone<Row> && !decides_quickly) {
        const auto word =
            audit::in_environment(environment, asked, [](const Asked& q) { return audit::decision_alone<Row>(q); });
        if (audit::word_in<std::remove_const_t<decltype(word)>>(truth.answer) != word) {
          return "the decision alone differs from the oracle's (" + audit::environment_name(environment) + ")";
        }
      }
      feed_back(truth, asked);
    } catch (const InvalidInput&) {
      return operation_.refusal_mismatch(flat(asked));
    }
    if (hash / 512 % (decides_quickly ? 256 : 16) != 0) return "";
    const audit::Question question = flat(asked);
    const std::string broken = operation_.examine(question)->broken_promise();
    return broken.empty() ? audit::certificate_complaint(operation_, question) : broken;
  }

  std::string shown(Bytes data) const override {
    const audit::Question question = flat(decoded(data));
    const std::string name = operation_.name(), exact = audit::one_line(operation_.print_hexadecimal(question));
    return audit::one_line(operation_.print(question)) + "\n" + exact + "\necho '" + exact + "' | touchstone ask " +
           name + " -";
  }

  void decode(Bytes data, std::vector<double>& numbers) const override { audit::flatten(decoded(data), numbers); }

  const Layout& layout(const std::vector<double>& numbers) const override {
    static thread_local Layout found;
    static const bool always_the_same = !audit::holds_lists<Asked>();
    if (always_the_same && !found.coordinates.empty()) return found;
    found = {};
    std::size_t place = 0;
    std::apply([&](const auto&... value) { (lay_out(value, place, found), ...); }, audit::unflattened<Asked>(numbers));
    return found;
  }

  std::size_t families() const override { return families_.names().size(); }

  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> seeds() const override {
    std::vector<std::pair<std::string, std::vector<std::uint8_t>>> made;
    const auto& names = families_.names();
    for (std::size_t family = 0; family < names.size(); ++family) {
      if (names[family].find('+') != std::string::npos) continue;  // the mutator moves by ulps itself
      audit::Choices choices = audit::Choices::seeded(audit::seed_of(1, names[family].c_str(), 0), true);
      families_.draw(choices, family);
      std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(family)};
      bytes.insert(bytes.end(), choices.recorded().begin(), choices.recorded().end());
      made.emplace_back(names[family], std::move(bytes));
    }
    return made;
  }

 private:
  Asked decoded(Bytes data) const {
    if (data.empty()) return Asked{};
    const Bytes rest = data.subspan(1);
    if (data[0] < families_.names().size()) {
      audit::Choices choices = audit::Choices::replayed(rest);
      return families_.draw(choices, data[0]);
    }
    static thread_local std::vector<double> numbers;
    numbers.assign((rest.size() + sizeof(double) - 1) / sizeof(double), 0);
    if (!rest.empty()) std::memcpy(numbers.data(), rest.data(), rest.size());
    if (data[0] == finite_numbers_follow) {
      for (double& number : numbers) number = std::isfinite(number) ? number : made_finite(number);
    }
    return audit::unflattened<Asked>(numbers);
  }

  /// With the exponent of 1.
  static double made_finite(double number) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) & ~(std::uint64_t{1} << 62));
  }

  /// Where many answers are right, the checker says whether robust's is one.
  template <class Exactly, class Answer>
  static bool differ(const Asked& asked, const Exactly& truth, const Answer& answer) {
    if constexpr (requires { Row::fault(asked, answer); }) {
      return !Row::fault(asked, answer).empty();
    } else {
      audit::Comparison found;
      audit::compare(truth, answer, true, false, found);
      return !found.decision || !found.finite || found.ulps > 0;
    }
  }

  static audit::Question flat(const Asked& asked) { return {audit::flattened(asked)}; }

  template <class Truth>
  static void feed_back(const Truth& truth, const Asked& asked) {
    std::array<double, 16> numbers;
    std::size_t count = 0;
    audit::for_each_number(asked, [&](const double& number) {
      if (count < numbers.size()) numbers[count++] = number;
    });
    report_margin(truth.margin, Row::card().margin_degree, {numbers.data(), count}, outcome_of(truth.answer));
  }

  /// The place of an answer's words among all that could be there; 0 where there are none.
  template <class T>
  static std::size_t outcome_of(const T& answer, std::size_t outcome = 0) {
    if constexpr (audit::Enumeration<T>) {
      return outcome * audit::Words<T>::words.size() + static_cast<std::size_t>(answer);
    } else if constexpr (audit::Composite<T>) {
      audit::for_each_member<T>([&](const auto& member) { outcome = outcome_of(answer.*member.pointer, outcome); });
    }
    return outcome;
  }

  template <class T>
  static void lay_out(const T& value, std::size_t& place, Layout& found) {
    if constexpr (requires {
                    value.x;
                    value.y;
                  }) {
      found.points.push_back({place, requires { value.z;
    }
    ? 3u : 2u
  });
} if constexpr (audit::Composite<T>) {
  audit::for_each_member<T>([&](const auto& member) { lay_out(value.*member.pointer, place, found); });
}
else if constexpr (audit::is_vector<T>) {
  typename T::value_type element{};
  std::size_t numbers = 0;
  audit::for_each_number(element, [&](auto&) { ++numbers; });
  found.lists.push_back({place++, numbers});
  for (const auto& one : value) lay_out(one, place, found);
}
else {
  found.coordinates.push_back(place++);
}
}  // namespace touchstone::fuzz

static constexpr bool decides_quickly = requires(const Asked& asked) { Row::decision::oracle(asked); };

const audit::Operation& operation_ = audit::operation_of_row<Row>();
audit::Families<Row> families_;
}
;

}  // namespace touchstone::fuzz

/// The whole of a fuzz target: TOUCHSTONE_FUZZ(orientation)
#define TOUCHSTONE_FUZZ(op)                                                        \
  const ::touchstone::fuzz::Target& ::touchstone::fuzz::target() {                 \
    static const ::touchstone::fuzz::TargetOf<::touchstone::audit::rows::op> made; \
    return made;                                                                   \
  }
