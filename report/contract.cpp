// SPDX-License-Identifier: Apache-2.0
#include "report/contract.h"

#include <contracts.h>  // made by the build

#include <algorithm>
#include <sstream>

#include "report/labels.h"

namespace touchstone::report {

std::vector<std::string> contract_of(const std::string& operation) {
  const auto* const found = std::find_if(std::begin(contracts), std::end(contracts),
                                         [&](const auto& entry) { return entry.operation == operation; });
  std::vector<std::string> paragraphs;
  if (found == std::end(contracts)) return paragraphs;
  std::istringstream lines(found->text);
  bool open = false;
  for (std::string line; std::getline(lines, line); open = !line.empty()) {
    if (line.empty()) continue;
    if (open) paragraphs.back() += "\n" + line;
    else paragraphs.push_back(line);
  }
  return paragraphs;
}

/// Words between backquotes are code.
static std::string words_in_html(const std::string& line) {
  std::string html;
  bool code = false;
  for (const char c : escaped(line)) {
    if (c == '`') html += (code = !code) ? "<code>" : "</code>";
    else html += c;
  }
  return html + (code ? "</code>" : "");
}

std::string paragraph(const std::string& text) {
  std::istringstream lines(text);
  std::string html;
  enum class In { nothing, words, formula } in = In::nothing;
  const auto end = [&] { html += in == In::words ? "</p>" : in == In::formula ? "</pre>" : ""; };
  for (std::string line; std::getline(lines, line);) {
    const In now = line.compare(0, 4, "    ") == 0 ? In::formula : In::words;
    if (now == in) {
      html += "\n";
    } else {
      end();
      html += now == In::words ? "<p>" : "<pre>";
      in = now;
    }
    html += now == In::formula ? escaped(line.substr(4)) : words_in_html(line);
  }
  end();
  return html;
}

std::string pages_in_words(const Operation& operation) {
  const std::vector<std::string> contract = contract_of(operation.name());
  const bool asked = std::any_of(contract.begin(), contract.end(),
                                 [](const std::string& text) { return text.find("Deck p. ") != std::string::npos; });
  const std::string pages = operation.metadata().pages;
  return asked ? "deck p. " + pages : "no page of the deck; what it is made of is taught there on p. " + pages;
}

std::string contract_section(const Operation& operation) {
  const std::vector<std::string> paragraphs = contract_of(operation.name());
  constexpr std::size_t open = 2;  // the question, then the formula
  std::string text, folded;
  for (std::size_t i = 0; i < paragraphs.size(); ++i) (i < open ? text : folded) += paragraph(paragraphs[i]);
  if (text.empty()) return "";
  if (!folded.empty())
    folded = "<details><summary>Degenerate input, what is refused, rounding</summary>" + folded + "</details>";
  return "<h2>Contract</h2><div class=\"card contract\">" + text + folded + "</div>";
}

}  // namespace touchstone::report
