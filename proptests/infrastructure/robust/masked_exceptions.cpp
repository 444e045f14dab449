// SPDX-License-Identifier: Apache-2.0
#include "robust/masked_exceptions.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"
#include "robust/lines/orientation.h"

namespace touchstone::proptests::masked_exceptions_tests {
namespace {

using namespace robust::kernel::processor;

/// A host that has unmasked every exception, inexact results too. What stands in its scope must not do arithmetic.
class Trapping {
 public:
  explicit Trapping(unsigned flags) : before_(control()) { set_control(unmasked(with_flags(before_, flags))); }
  ~Trapping() { set_control(before_); }
  Trapping(const Trapping&) = delete;
  Trapping& operator=(const Trapping&) = delete;

 private:
  Control before_;
};

/// Many processors of 64-bit Arm have no traps.
bool processor_traps() {
  const Control masks = control();
  const Trapping host(0);
  return !(control() == with_flags(masks, 0));
}

/// By which signal a copy of this process ends that asks as such a host; 0: by none, and ask() was true.
template <class Ask>
int signal_of(const Ask& ask) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGFPE, SIG_DFL);
    const Trapping host(0);
    _exit(ask() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status) == 0 ? 0 : -1;
}

}  // namespace

EACH_OPERATION("under the guard a host that has unmasked all exceptions gets the answer, and its control word stays") {
  never(
      operation, "unmasked exceptions",
      [&](const Question& question) -> std::string {
        const AnswerBits expected = robust_bits(operation, question, 0);
        for (const unsigned flags : {0u, all_flags}) {
          AnswerBits answer;
          Control before{}, after{};
          {
            const Trapping host(flags);
            before = control();
            answer = robust::with_exceptions_masked([&] { return robust_bits(operation, question, 0); });
            after = control();
          }
          if (answer != expected) return "another answer";
          if (!(after == before)) return "another control word";
        }
        return "";
      },
      4);
}

TEST_CASE(
    "masked exceptions: a predicate raises SIGFPE where a host has unmasked exceptions, under the guard it does not") {
  const Point2d p0{0, 0}, p1{0.1, 0.3};
  for (const Point2d& p : {Point2d{0.3, 0.1}, Point2d{0.2, 0.6}, Point2d{1e-300, 3e-300}}) {
    const auto side = [&] { return robust::orientation(p0, p1, p); };
    const Side right = side();
    CHECK(signal_of([&] { return side() == right; }) == (processor_traps() ? SIGFPE : 0));
    CHECK(signal_of([&] { return robust::with_exceptions_masked(side) == right; }) == 0);
  }
}

TEST_CASE("masked exceptions: rounding mode and flushing stay as they are in the scope, and all is back after it") {
  for (std::size_t number = 0; number < environment_count; ++number) {
    const Environment set(number);
    const Trapping host(all_flags);
    const Control before = control();
    Control inside{};
    {
      const robust::MaskedExceptions guard;
      inside = control();
    }
    const Control after = control();
    const bool right = inside == masked(before) && after == before;
    set_control(masked(before));  // for the assertion
    CHECK(right);
  }
}

}  // namespace touchstone::proptests::masked_exceptions_tests
