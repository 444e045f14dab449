// SPDX-License-Identifier: Apache-2.0
#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"
#include "robust/kernel/filters/control_word.h"

namespace touchstone::proptests::environments_tests {
namespace {

std::string complaint(const Operation& operation, const Question& question) {
  const AnswerBits expected = robust_bits(operation, question, 0);
  for (std::size_t environment = 1; environment < environment_count; ++environment) {
    if (robust_bits(operation, question, environment) != expected) {
      return "robust answers differently with this environment: " + environment_name(environment);
    }
  }
  return "";
}

}  // namespace

EACH_OPERATION("every rounding mode, flush to zero and denormals as zero give the same bits") {
  never(
      operation, "the same bits in sixteen environments",
      [&](const Question& question) { return complaint(operation, question); }, 4);
}

TEST_CASE("environments: the test really sets them") {
  const auto reciprocal = [](std::size_t number, double x) {
    return in_environment(number, x, [](double y) { return 1 / y; });
  };
  const auto halved = [](std::size_t number, double x) {
    const double half = in_environment(number, x, [](double y) { return y * 0.5; });
    return std::bit_cast<std::uint64_t>(half);
  };
  CHECK(reciprocal(1, 3) < reciprocal(2, 3));
  CHECK(reciprocal(3, 3) == reciprocal(1, 3));
  CHECK(reciprocal(3, -3) == reciprocal(2, -3));
  CHECK(halved(0, 0x1p-1022) == std::uint64_t{1} << 51);
  CHECK(halved(0, 0x1p-1073) == 1);
  if (robust::kernel::processor::can_flush) {
    CHECK(halved(4, 0x1p-1022) == 0);  // FTZ: the result
    CHECK(halved(8, 0x1p-1073) == 0);  // DAZ: the operand
  }
}

TEST_CASE("environments: what the host had set is there again after robust has answered") {
  using namespace robust::kernel::processor;
  const auto settings = [] { return with_flags(control(), 0); };
  for (std::size_t number = 0; number < environment_count; ++number) {
    const Environment set(number);
    const Control before = settings();
    for (const Operation* operation : catalogue::all_operations()) {
      for (const double size : {1.0, 0x1p-1074, 0x1p1000}) {
        Question question = operation->zeros();
        for (std::size_t i = 0; i < question.numbers.size(); ++i)
          question.numbers[i] = static_cast<double>(1 + i * i % 5) * size;
        robust_bits(*operation, question, number);
        CHECK((settings() == before));
      }
    }
  }
}

TEST_CASE(
    "environments: the last stage's guard sets IEEE arithmetic, and then what was there, exception flags included") {
  using namespace robust::kernel::processor;
  int wrong_inside = 0, wrong_after = 0;
  for (std::size_t number = 0; number < environment_count; ++number) {
    for (const unsigned flags : {0u, 1u, all_flags}) {
      const Environment set(number);
      set_control(with_flags(control(), flags));
      const Control before = control();
      {
        const robust::kernel::ControlWord guard;
        wrong_inside += !is_ieee(control());
        volatile double third = 3;
        third = 1 / third;  // inexact
      }
      wrong_after += !(control() == before);
    }
  }
  CHECK(wrong_inside == 0);
  CHECK(wrong_after == 0);
}

}  // namespace touchstone::proptests::environments_tests
