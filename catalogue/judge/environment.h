// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "robust/kernel/filters/processor.h"

/// The floating-point environments that a host application can set.
namespace touchstone::catalogue {

/// Four rounding modes; results flushed to zero or not; subnormal operands read as zero or not. Number 0 is the
/// environment in which a program starts. A processor that has one switch for results and operands flushes both where
/// one is asked for.
inline constexpr std::size_t environment_count = 16;

inline std::string environment_name(std::size_t number) {
  static constexpr std::array<const char*, 4> modes{"to nearest", "downwards", "upwards", "towards zero"};
  return std::string(modes[number & 3]) + (number & 4 ? ", FTZ" : "") + (number & 8 ? ", DAZ" : "");
}

/// Sets that environment while in scope, then restores the previous one. A compiler may move floating-point operations
/// across both: use `in_environment`.
class Environment {
 public:
  explicit Environment(std::size_t number) : before_(robust::kernel::processor::control()) {
    using namespace robust::kernel::processor;
    set_control(in_environment(before_, number & 3, (number & 4) != 0, (number & 8) != 0));
  }
  ~Environment() { robust::kernel::processor::set_control(before_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  robust::kernel::processor::Control before_;
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
