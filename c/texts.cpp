// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "audit/text/geometries.h"
#include "audit/text/regression_test.h"
#include "c/made.h"
#include "c/touchstone.h"

namespace touchstone::c {
namespace {

/// A line of JSON with its numbers as they were typed (catalogue/codec/json.h), not marked.
std::string line_as_typed(const Json& input) {
  const std::string mark = R"("\u0001)";
  std::string line = one_line(input);
  for (std::size_t at; (at = line.find(mark)) != std::string::npos;) {
    line.erase(at, mark.size());
    line.erase(line.find('"', at), 1);
  }
  return line;
}

}  // namespace
}  // namespace touchstone::c

using namespace touchstone;
using namespace touchstone::catalogue;

int touchstone_read(const char* operation, const char* text, char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const Operation& asked = c::operation_named(operation);
    const std::string given = c::text_of(text, "text"), option = audit::option_for(given);
    const Json input = audit::input_in(given, option == "--wkt", option == "--geojson", asked, Json::object());
    asked.parse(input);
    return c::line_as_typed(input);
  });
}

int touchstone_regression_test(const char* operation, const char* question, const char* framework, char** result,
                               touchstone_error* error) {
  return c::made(result, error, [&] {
    const Operation& asked = c::operation_named(operation);
    const std::string name = c::text_of(framework, "framework");
    const auto& known = audit::test_frameworks;
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string names;
      for (const char* one : known) names += (names.empty() ? "one of " : ", ") + std::string(one);
      throw InvalidInput("framework", names);
    }
    return audit::RegressionTests(name).next(*asked.examine(c::question_of(asked, question)), nullptr);
  });
}
