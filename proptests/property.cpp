// SPDX-License-Identifier: Apache-2.0
#include "proptests/property.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "catalogue/families/choices.h"

namespace touchstone::proptests {

int scaled(int usual) {
  const char* factor = std::getenv("TOUCHSTONE_CASES");
  const double wanted = factor == nullptr ? usual : usual * std::strtod(factor, nullptr);
  return static_cast<int>(std::clamp(wanted, 1.0, 1e9));
}

void property(const std::string& name, const std::function<void()>& testable, int usual) {
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
  const TestResult result = checkProperty(toProperty(testable), metadata, used.testParams, silent, used.reproduce);
  if (result.is<SuccessResult>()) {
    SUCCEED();
    return;
  }
  std::ostringstream message;
  message << name << '\n';
  printResultMessage(result, message);
  if (result.is<FailureResult>()) {
    const Configuration again{used.testParams, false, false, {{name, result.get<FailureResult>().reproduce}}};
    message << "\nRepeat it with\nRC_PARAMS=\"" << configToMinimalString(again) << "\"\n";
  }
  // Catch2 wraps what it prints at 80 columns; the line above has to stay whole.
  std::fprintf(stderr, "%s\n", message.str().c_str());
  FAIL(name);
}

}  // namespace touchstone::proptests
