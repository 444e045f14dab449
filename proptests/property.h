// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "audit/inputs/choices.h"

/// Properties: RapidCheck inside Catch2. Every run asks the same cases, because the seed follows from the property's name.
///
///   RC_PARAMS="..."       RapidCheck's own parameters: seed, max_success, noshrink, reproduce=...
///   TOUCHSTONE_CASES=F    F times as many cases everywhere (a decimal, 1 unless told)
namespace touchstone::proptests {

/// `usual` times TOUCHSTONE_CASES, at least 1.
inline int scaled(int usual) {
  const char* factor = std::getenv("TOUCHSTONE_CASES");
  const double wanted = factor == nullptr ? usual : usual * std::strtod(factor, nullptr);
  return static_cast<int>(std::clamp(wanted, 1.0, 1e9));
}

/// Checks `testable` (a callable as RapidCheck takes it) under a name that no other property of the program has. A failure prints the
/// shrunk case and the line that repeats it; RapidCheck's own rc::prop gives no name and therefore prints no such line.
template <class Testable>
void property(const std::string& name, Testable&& testable, int usual = 200) {
  using namespace rc::detail;
  Configuration defaults;
  defaults.testParams.seed = audit::seed_of(1, name.c_str(), 0);
  defaults.testParams.maxSuccess = scaled(usual);
  const char* given = std::getenv("RC_PARAMS");
  const Configuration used = given == nullptr ? defaults : configFromString(given, defaults);
  struct Silent : TestListener {
    void onTestCaseFinished(const CaseDescription&) override {}
    void onShrinkTried(const CaseDescription&, bool) override {}
    void onTestFinished(const TestMetadata&, const TestResult&) override {}
  } silent;
  const TestMetadata metadata{name, name};
  const TestResult result =
      checkProperty(toProperty(std::forward<Testable>(testable)), metadata, used.testParams, silent, used.reproduce);
  if (result.template is<SuccessResult>()) {
    SUCCEED();
    return;
  }
  std::ostringstream message;
  message << name << '\n';
  printResultMessage(result, message);
  if (result.template is<FailureResult>()) {
    const Configuration again{used.testParams, false, false, {{name, result.template get<FailureResult>().reproduce}}};
    message << "\nRepeat it with\nRC_PARAMS=\"" << configToMinimalString(again) << "\"\n";
  }
  // Catch2 wraps what it prints at 80 columns; the line above has to stay whole.
  std::fprintf(stderr, "%s\n", message.str().c_str());
  FAIL(name);
}

}  // namespace touchstone::proptests
