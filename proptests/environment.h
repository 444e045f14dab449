// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <string>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "audit/catalogue/catalogue.h"
#include "audit/codec/walk.h"

/// The floating-point environments that a host application can set, and what robust answers in them.
namespace touchstone::proptests {

/// Four rounding modes; results flushed to zero or not; subnormal operands read as zero or not. Number 0 is what a program starts with.
inline constexpr std::size_t environment_count = 16;

inline std::string environment_name(std::size_t number) {
  static constexpr std::array<const char*, 4> modes{"to nearest", "downwards", "upwards", "towards zero"};
  return std::string(modes[number & 3]) + (number & 4 ? ", FTZ" : "") + (number & 8 ? ", DAZ" : "");
}

/// That environment while in scope; then what was before.
class Environment {
 public:
#if defined(__SSE2__)
  explicit Environment(std::size_t number) : before_(_mm_getcsr()) {
    const auto n = static_cast<unsigned>(number);
    _mm_setcsr((before_ & ~0xe040u) | (n & 3) << 13 | (n >> 2 & 1) << 15 | (n >> 3 & 1) << 6);
  }
  ~Environment() { _mm_setcsr(before_); }
#else
  explicit Environment(std::size_t number) : before_(std::fegetround()) {
    static constexpr std::array<int, 4> modes{FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
    std::fesetround(modes[number & 3]);
  }
  ~Environment() { std::fesetround(before_); }
#endif
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
#if defined(__SSE2__)
  unsigned before_;
#else
  int before_;
#endif
};

/// An answer as words: enumerators, presence of optional parts, numbers bit by bit. Never compares doubles.
struct AnswerBits {
  std::vector<std::uint64_t> words;
  std::string refused;
  friend bool operator==(const AnswerBits&, const AnswerBits&) = default;
};

template <class T>
void append_bits(const T& value, std::vector<std::uint64_t>& words) {
  if constexpr (audit::Enumeration<T>) {
    words.push_back(static_cast<std::uint64_t>(value));
  } else if constexpr (audit::Composite<T>) {
    audit::for_each_member<T>([&](const auto& member) { append_bits(value.*member.pointer, words); });
  } else if constexpr (audit::is_optional<T>) {
    words.push_back(value.has_value());
    if (value) append_bits(*value, words);
  } else {
    words.push_back(std::bit_cast<std::uint64_t>(value));
  }
}

/// The question with its types.
template <class Row>
typename Row::Question typed(const audit::Question& question) {
  typename Row::Question asked{};
  std::size_t i = 0;
  audit::for_each_number(asked, [&](double& number) { number = i < question.numbers.size() ? question.numbers[i] : 0, ++i; });
  return asked;
}

/// What robust answers in an environment.
template <class Row>
AnswerBits robust_bits(const audit::Question& question, std::size_t environment) {
  const auto asked = typed<Row>(question);
  AnswerBits bits;
  try {
    const auto answer = [&] {
      const Environment set(environment);
      return audit::ask_robust<Row>(asked);
    }();
    append_bits(answer, bits.words);
  } catch (const InvalidInput& refused) {
    bits.refused = refused.what();
  }
  return bits;
}

/// The same for an operation of the catalogue.
inline AnswerBits robust_bits(const audit::Operation& operation, const audit::Question& question, std::size_t environment) {
  AnswerBits bits;
  audit::for_each_row([&]<class Row>() {
    if (&Row::card() == &operation.card()) bits = robust_bits<Row>(question, environment);
  });
  return bits;
}

}  // namespace touchstone::proptests
