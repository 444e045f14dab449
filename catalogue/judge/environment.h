// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cfenv>
#include <cstdint>
#include <string>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

/// The floating-point environments that a host application can set.
namespace touchstone::catalogue {

/// Four rounding modes; results flushed to zero or not; subnormal operands read as zero or not. Number 0 is the
/// environment in which a program starts.
inline constexpr std::size_t environment_count = 16;

inline std::string environment_name(std::size_t number) {
  static constexpr std::array<const char*, 4> modes{"to nearest", "downwards", "upwards", "towards zero"};
  return std::string(modes[number & 3]) + (number & 4 ? ", FTZ" : "") + (number & 8 ? ", DAZ" : "");
}

/// Sets that environment while in scope, then restores the previous one. A compiler may move floating-point operations
/// across both: use `in_environment`.
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

/// Returns ask(argument) in an environment. Compilers do not know that arithmetic depends on the control word, so
/// argument and answer pass through memory that is opaque to them, between setting the word and restoring it.
template <class Argument, class Ask>
auto in_environment(std::size_t number, Argument argument, const Ask& ask) {
  const Environment set(number);
  asm volatile("" : "+m"(argument) : : "memory");
  auto answer = ask(argument);
  asm volatile("" : "+m"(answer) : : "memory");
  return answer;
}

}  // namespace touchstone::catalogue
