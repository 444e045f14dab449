// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <set>
#include <string>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// The tests in rust are for cargo, with serde_json.
inline constexpr std::array<const char*, 5> test_frameworks{"catch2", "gtest", "pytest", "jest", "rust"};

/// The name of a file of tests: "test_catch2.cpp", "test_pytest.py".
std::string test_file(const std::string& framework);

/// Questions as regression tests, as the text of one file: each calls a function my_OPERATION, whose body is left to
/// the user, with the exact input, and expects the truth in nearest doubles.
class RegressionTests {
 public:
  /// One of test_frameworks.
  explicit RegressionTests(std::string framework) : framework_(std::move(framework)) {}

  /// The next test, with the declarations that it needs and no earlier test had. `engine`: an engine's answer to the
  /// question, as `ask` prints it, or null.
  std::string next(const Examination& examination, const Json& engine);

 private:
  std::string framework_;
  std::set<std::string> printed_;
  std::size_t count_ = 0;
};

/// A question and a right answer in C++.
struct InCpp {
  std::string declaration;  ///< "SegmentSegment<double> my_segment_segment(Segment2<double> a, Segment2<double> b)"
  std::string call;         ///< "my_segment_segment(Segment2<double>{...}, ...)"
  std::string expected;     ///< "SegmentSegment<double>{SegmentRelation::point, ...}"
};
InCpp in_cpp(const Operation& operation, const Question& question, const EncodedValue<double>& answer);

}  // namespace touchstone::audit
