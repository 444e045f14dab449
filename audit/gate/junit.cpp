// SPDX-License-Identifier: Apache-2.0
#include "audit/gate/junit.h"

#include "audit/counted.h"
#include "audit/gate/shown.h"
#include "catalogue/codec/excerpt.h"

namespace touchstone::audit {
namespace {

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xml_text(value) + "\"";
}
std::string attribute(const char* name, std::uint64_t value) { return attribute(name, std::to_string(value)); }

struct Suite {
  std::string text;
  std::uint64_t tests = 0, failures = 0, skipped = 0;

  /// failing, accepted: text with newlines; may be empty.
  void add(const std::string& operation, const std::string& name, const std::string& type, const std::string& message,
           const std::string& failing, const std::string& accepted) {
    ++tests;
    text += "    <testcase" + attribute("classname", "touchstone." + operation) + attribute("name", name);
    if (failing.empty() && accepted.empty()) {
      text += "/>\n";
      return;
    }
    text += ">\n";
    if (!failing.empty()) {
      ++failures;
      text += "      <failure" + attribute("type", type) + attribute("message", message) + ">" + xml_text(failing) +
              "</failure>\n";
    }
    if (!accepted.empty()) text += "      <system-out>" + xml_text(accepted) + "</system-out>\n";
    text += "    </testcase>\n";
  }
  void skip(const std::string& operation, const std::string& name, const std::string& why) {
    ++tests, ++skipped;
    text += "    <testcase" + attribute("classname", "touchstone." + operation) + attribute("name", name) +
            ">\n      <skipped" + attribute("message", why) + "/>\n    </testcase>\n";
  }
  std::string counts() const {
    return attribute("tests", tests) + attribute("failures", failures) + attribute("errors", 0) +
           attribute("skipped", skipped);
  }
};

/// Adds the gate's result for one family, or for the operation itself (family "").
void add_family(const Tally& tally, const GateResult& result, const std::string& operation, const std::string& family,
                const std::string& name, Suite& suite) {
  std::string type, message, failing, accepted;
  for (const GateEntry& entry : result.entries) {
    if (entry.found.operation != operation || entry.found.family != family) continue;
    const std::string words = in_words(entry);
    if (!entry.fails) {
      accepted += words + "\n";
      continue;
    }
    if (type.empty()) type = name_of(entry.found.cause);
    message += (message.empty() ? "" : "; ") + words;
    const Finding* example = example_of(tally, entry.found);
    failing += words + "\n" + (example ? described(tally, operation, *example) : "");
  }
  suite.add(operation, name, type, message, failing, accepted);
}

void add_robust(const Tally& tally, const std::string& operation, Suite& suite) {
  for (const OperationTally& robust : tally.robust) {
    if (robust.operation != operation || robust.total().findings() == 0) continue;
    std::string text;
    const Cell total = robust.total();
    for (std::size_t v = 0; v < verdict_count; ++v) {
      const Finding* example = total.example(static_cast<Verdict>(v));
      if (example != nullptr && is_finding(static_cast<Verdict>(v)))
        text += described(tally, operation, *example, true);
    }
    suite.add(operation, "robust", "robust", "robust is wrong in " + grouped(total.findings()) + " cases", text, "");
  }
}

Suite suite_of(const Tally& tally, const GateResult& result, const OperationTally& operation) {
  Suite suite;
  for (const auto& [family, cell] : operation.families) {
    if (cell.answered() == 0 && cell.not_asked == 0) {
      suite.skip(operation.operation, family, cell.cases() > 0 ? "the engine does not answer this" : "no cases");
    } else {
      add_family(tally, result, operation.operation, family, family, suite);
    }
  }
  const bool too_much = operation.too_much_surplus(tally.max_surplus);
  if (operation.inconsistent_convention() || too_much)
    add_family(tally, result, operation.operation, "", too_much ? "surplus" : "inconsistent convention", suite);
  add_robust(tally, operation.operation, suite);
  return suite;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string safe;
  std::size_t from = 0;
  // Control characters and bytes that are not UTF-8 become \xNN line by line; the line breaks between are kept.
  while (from <= text.size()) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    if (from > 0) safe += '\n';
    safe += excerpt(std::string_view(text).substr(from, to - from), text.size());
    from = to + 1;
  }
  std::string escaped;
  for (const char c : safe) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\'': escaped += "&apos;"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

std::string junit_xml(const Tally& tally, const GateResult& result) {
  Suite all;
  for (const OperationTally& operation : tally.operations) {
    const Suite suite = suite_of(tally, result, operation);
    all.tests += suite.tests, all.failures += suite.failures, all.skipped += suite.skipped;
    all.text += "  <testsuite" + attribute("name", operation.operation) + suite.counts() + ">\n" + suite.text +
                "  </testsuite>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
         attribute("name", "touchstone audit of " + tally.declaration.engine) + all.counts() + ">\n" + all.text +
         "</testsuites>\n";
}

}  // namespace touchstone::audit
