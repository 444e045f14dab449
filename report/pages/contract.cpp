// SPDX-License-Identifier: Apache-2.0
#include "report/pages/contract.h"

#include <contracts.h>  // made by the build

#include <algorithm>
#include <sstream>

#include "report/figures/labels.h"
#include "report/parts/html_parts.h"
#include "report/words/formula.h"

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

std::string paragraph(const std::string& text) {
  std::istringstream lines(text);
  std::string html;
  enum class In { nothing, words, formula, both } in = In::nothing;
  const auto end = [&] {
    html += in == In::words ? "</p>" : in == In::formula ? "</div>" : in == In::both ? "</pre>" : "";
  };
  for (std::string line; std::getline(lines, line);) {
    const bool indented = line.compare(0, 4, "    ") == 0;
    const auto formula = indented ? formula_in_mathml(line.substr(4)) : std::nullopt;
    // A line with words next to its formula stays separate; one of words alone continues a list's entry.
    const bool both = indented && !formula && line.find(" = ") != std::string::npos;
    const In now = formula ? In::formula : both ? In::both : In::words;
    if (now == in) {
      html += "\n";
    } else {
      end();
      html += now == In::words ? "<p>" : now == In::formula ? "<div class=\"formula\">" : "<pre>";
      in = now;
    }
    html += formula ? *formula : both ? escaped(line.substr(4)) : words_in_html(line);
  }
  end();
  return html;
}

/// The end of the sentence that continues at `from`: after its full stop, which excludes "p. 5", "(p. 5)" and
/// "N . (x - a)".
static std::size_t end_of_sentence(const std::string& text, std::size_t from) {
  for (std::size_t at = from; (at = text.find('.', at)) != std::string::npos; ++at) {
    const bool of_page =
        at > 0 && text[at - 1] == 'p' && (at < 2 || std::string(" \n(").find(text[at - 2]) != std::string::npos);
    const std::size_t next = text.find_first_not_of(" \n", at + 1);
    if (next == std::string::npos) return text.size();
    const bool of_product = at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\n');
    if (next > at + 1 && !of_page && !of_product && text.compare(at + 1, 5, "\n    ") != 0) return at + 1;
  }
  return text.size();
}

std::pair<std::string, std::string> formula_and_rest(const std::string& text) {
  std::size_t from = 0;  // end of the last formula shown
  for (std::size_t at = 0; (at = text.find("\n    ", at)) != std::string::npos;) {
    const std::size_t end = std::min(text.find('\n', at + 1), text.size());
    if (formula_in_mathml(text.substr(at + 5, end - at - 5))) from = end;
    at = end;
  }
  const std::string not_asked = "No page of the deck asks this.";
  if (from == 0 && text.rfind(not_asked, 0) == 0) from = not_asked.size();
  const bool ended = from > 0 && text[from - 1] == '.' && from != not_asked.size();
  const std::size_t end = ended ? from : end_of_sentence(text, from);
  const std::size_t rest = text.find_first_not_of(" \n", end);
  return {text.substr(0, end), rest == std::string::npos ? "" : text.substr(rest)};
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
  if (paragraphs.empty()) return "";
  std::string text = paragraph(paragraphs[0]), folded;
  if (paragraphs.size() > 1) {
    const auto [formula, rest] = formula_and_rest(paragraphs[1]);
    text += paragraph(formula), folded += paragraph(rest);
  }
  for (std::size_t i = 2; i < paragraphs.size(); ++i) folded += paragraph(paragraphs[i]);
  if (!folded.empty())
    folded = "<details><summary>Units, touching, degenerate input, what is refused, rounding</summary>" + folded +
             "</details>";
  return "<h2>Contract</h2><div class=\"card contract\">" + text + folded + "</div>";
}

}  // namespace touchstone::report
