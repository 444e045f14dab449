// SPDX-License-Identifier: Apache-2.0
#include "proptests/property.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "catalogue/codec/nearest_double.h"
#include "catalogue/families/draw_stream.h"

namespace touchstone::proptests {

int scaled(int usual) {
  const char* factor = std::getenv("TOUCHSTONE_CASES");
  const double wanted = factor == nullptr ? usual : usual * catalogue::nearest_double(factor).value_or(0);
  return static_cast<int>(std::clamp(wanted, 1.0, 1e9));
}

/// What RapidCheck says of a property that fails; empty if it holds.
static std::string failure_of(const std::string& name, const std::function<void()>& testable, int usual) {
  using namespace rc::detail;
  Configuration defaults;
  defaults.testParams.seed = catalogue::seed_of(1, name.c_str(), 0);
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
  if (result.is<SuccessResult>()) return "";
  std::ostringstream message;
  printResultMessage(result, message);
  if (result.is<FailureResult>()) {
    const Configuration again{used.testParams, false, false, {{name, result.get<FailureResult>().reproduce}}};
    message << "\nRepeat it with\nRC_PARAMS=\"" << configToMinimalString(again) << "\"\n";
  }
  return message.str();
}

/// Weak, so that the program which asks mutants (proptests/mutation/by_properties.cpp) can put its own in its place.
[[gnu::weak]] void demand(const std::string& name, const std::function<std::string()>& complaint) {
  const std::string said = complaint();
  if (said.empty()) {
    SUCCEED();
    return;
  }
  // Catch2 wraps what it prints at 80 columns; the line that repeats a failure has to stay whole.
  std::fprintf(stderr, "%s\n%s\n", name.c_str(), said.c_str());
  FAIL(name);
}

void property(const std::string& name, const std::function<void()>& testable, int usual) {
  demand(name, [&] { return failure_of(name, testable, usual); });
}

}  // namespace touchstone::proptests
