// SPDX-License-Identifier: Apache-2.0
#include "report/pages/deck_page.h"

#include <embedded.h>  // made by the build
#include <fmt/format.h>

#include <algorithm>

#include "report/pages/contract.h"
#include "report/pages/html_finding.h"
#include "report/pages/html_footer.h"
#include "report/parts/html_parts.h"
#include "report/words/ways.h"

namespace touchstone::report {
namespace {

std::string anchor_of(const DeckSection& section) { return "p" + section.pages; }

std::string contents() {
  std::string text = "<nav class=\"deck-contents\"><ol>";
  for (const DeckSection& section : deck_sections())
    text += fmt::format("<li><a href=\"#{}\"><small>p. {}</small> {}</a></li>", anchor_of(section), section.pages,
                        escaped(section.title));
  return text + "<li><a href=\"#beside\">Beside the deck</a></li></ol></nav>";
}

/// The beginning of the contracts: the page, the formula and its sentence. After the first operation only formulas are
/// shown.
std::string formulas(const DeckSection& section) {
  std::string text;
  for (const std::string& operation : section.operations) {
    const std::vector<std::string> contract = contract_of(operation);
    if (contract.size() < 2) continue;
    const std::string said = paragraph(formula_and_rest(contract[1]).first);
    if (!text.empty() && said.find("class=\"formula\"") == std::string::npos) continue;
    text += "<h3>" + breakable(operation) + "</h3>" + said;
  }
  return text;
}

std::string figure(const DeckSection& section) {
  if (!section.drag.empty())
    return "<div class=\"drag-figure\" data-drag=\"" + escaped(one_line(Json(section.drag))) +
           "\"><noscript><p>The page draws a figure here by a script, which it carries in itself.</p></noscript></div>";
  for (const std::string& operation : section.operations) {
    const std::string right = right_case(*find_operation(operation));
    if (!right.empty()) return right;
  }
  return "";
}

/// The first of the section's operations that fails.
std::string failure(const DeckSection& section, const Tally& tally) {
  std::uint64_t asked = 0;
  for (const std::string& name : section.operations) {
    for (const OperationTally& counted : tally.operations) {
      if (counted.operation != name) continue;
      asked += counted.total().answered();
      for (const OperationOutcome& outcome : outcomes_of(counted)) {
        if (!is_finding(outcome.outcome.verdict)) continue;
        return "<details class=\"breaks\" open><summary>The case that breaks it: " + breakable(name) + "</summary>" +
               finding_card(*find_operation(name), outcome, tally.declaration, Speaker::reference, tally.repeat) +
               "</details>";
      }
    }
  }
  return asked == 0
             ? ""
             : "<p class=\"quiet\">None of " + counted(asked, "hard case") + " breaks the formulas of this page.</p>";
}

std::string played(const DeckSection& section, const std::map<std::string, PlayedScene>& scenes) {
  const auto found = scenes.find(section.scene);
  if (found == scenes.end()) return "";
  const PlayedScene& scene = found->second;
  return "<h3>In motion: " + escaped(scene.title) + "</h3><p>" + escaped(scene.about) + "</p>" + player_opening +
         escaped(one_line(scene.data)) +
         "\"><noscript><p>The page plays its runs by a script, which it carries in itself.</p></noscript></div>";
}

std::string beside_the_deck() {
  std::string text =
      "<section class=\"card\" id=\"beside\"><h2>Beside the deck</h2><p>No page of the deck asks these; "
      "what they are made of is taught there.</p><ul>";
  for (const Operation* operation : all_operations()) {
    if (pages_in_words(*operation).rfind("deck", 0) == 0) continue;
    text +=
        fmt::format("<li><b>{}</b>: {} <span class=\"quiet\">{}</span></li>", breakable(operation->name()),
                    escaped(operation->metadata().question), escaped("p. " + std::string(operation->metadata().pages)));
  }
  return text + "</ul></section>";
}

std::vector<DeckSection> read_sections() {
  std::vector<DeckSection> sections;
  for (const Json& json : Json::parse(deck_script)) {
    DeckSection section{json.at("pages"), json.at("title"), json.at("idea"), json.at("operations"), "", ""};
    section.drag = json.value("drag", "");
    section.scene = json.value("scene", "");
    sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace

const std::vector<DeckSection>& deck_sections() {
  static const std::vector<DeckSection> sections = read_sections();
  return sections;
}

std::string deck_page(const Tally& tally, const std::map<std::string, PlayedScene>& scenes) {
  std::string body =
      "<header><p class=\"kicker\">touchstone</p><h1>The deck, page by page</h1><p class=\"lead\">What the lecture "
      "deck "
      "<em>Collision handling: detection and response</em> (CSE 3541, M. Boggus) asks, in its order: the idea, the "
      "formula, a figure to drag or to turn, the case that breaks the formula, and a scene. Titles and sentences are "
      "touchstone's, not the deck's.</p></header><main>" +
      contents();
  for (const DeckSection& section : deck_sections()) {
    body += fmt::format(
        "<section class=\"card deck-page\" id=\"{}\"><p class=\"kicker\">p. {}</p><h2>{}</h2><p class=\"lead\">{}</p>",
        anchor_of(section), section.pages, escaped(section.title), escaped(section.idea));
    body += formulas(section) + figure(section) + failure(section, tally) + played(section, scenes) + "</section>";
  }
  return page("The deck, page by page", body + beside_the_deck() + "</main>" + page_footer());
}

}  // namespace touchstone::report
