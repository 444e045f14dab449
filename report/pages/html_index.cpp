// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "audit/engines/protocol.h"
#include "report/pages/contract.h"
#include "report/pages/html.h"
#include "report/pages/html_compare.h"
#include "report/pages/html_footer.h"
#include "report/pages/html_map.h"
#include "report/pages/html_nearness.h"
#include "report/parts/html_parts.h"

namespace touchstone::report {
namespace {

/// "2^-100", or the number.
std::string limit_in_words(double limit) {
  int exponent = 0;
  return std::frexp(limit, &exponent) == 0.5 ? fmt::format("2^{}", exponent - 1) : fmt::format("{}", limit);
}

std::string speaker_in_words(const Tally& tally) {
  const std::string type = tally.declaration.binary32 ? " in float" : " in double";
  return speaker_of(tally.declaration) == Speaker::reference ? "The textbook formulas" + type
                                                             : tally.declaration.engine + type;
}

/// The result in one line.
std::string headline(const Tally& tally, const Cell& sum) {
  const std::string questions =
      tally.grid.size > 0 ? counted(sum.answered(), "configuration")
                          : counted(sum.answered(), tally.repeat.recorded ? "recorded call" : "hard question");
  if (sum.answered() == 0) return speaker_in_words(tally) + ": nothing answered";
  return speaker_in_words(tally) + ": " + (sum.wrong() == 0 ? "none" : share(sum.wrong(), sum.answered())) + " of " +
         questions + " wrong";
}

std::string causes(const Cell& sum) {
  std::string text;
  const auto name = [&](std::uint64_t n, const std::string& words) {
    if (n > 0) text += (text.empty() ? "" : ", ") + grouped(n) + " " + words;
  };
  name(both(sum.cancellation()), "by cancellation");
  name(both(sum.out_of_range()), "by over- or underflow");
  name(sum.count(Verdict::algorithm), "by the algorithm itself");
  name(sum.count(Verdict::invalid), "no valid answer");
  return text;
}

std::string lead(const Tally& tally, const Cell& sum) {
  const std::uint64_t ordinary = sum.answered(Range::ordinary), wrong = sum.wrong(Range::ordinary);
  std::string text;
  if (ordinary > 0) {
    text = "At ordinary size (every number 0 or between " + limit_in_words(tally.limits.least) + " and " +
           limit_in_words(tally.limits.most) + "): " + grouped(wrong) + " of " + grouped(ordinary) + " wrong (" +
           share(wrong, ordinary) + ").";
  }
  if (sum.wrong() > 0) text += " Of all " + counted(sum.wrong(), "wrong answer") + ": " + causes(sum) + ".";
  if (sum.count(Verdict::inexact) > 0) {
    text += " " + grouped(sum.count(Verdict::inexact)) +
            " more are right but for a number that is further off than the stated bound.";
  }
  if (!tally.robust.empty()) {
    const Cell robust = sum_of(tally.robust);
    const std::uint64_t not_right = robust.cases() - robust.count(Verdict::agree);
    text +=
        " Robust, asked the same questions: " + (not_right == 0 ? "none wrong." : grouped(not_right) + " not right.");
  }
  return text;
}

std::string conditions(const Tally& tally, const Cell& sum) {
  const Declaration& declared = tally.declaration;
  std::string text = counted(tally.operations.size(), "operation");
  text += tally.grid.size > 0
              ? fmt::format(", every configuration on the {0} \u00d7 {0} grid ({1} of {2})", tally.grid.size,
                            tally.grid.done.size(), counted(tally.grid.shards, "shard"))
              : ", " + asked_in_words(tally);
  if (sum.left_out > 0) text += ", ordinary size only";
  text += ". Boundary convention: " + boundary_word(declared.boundary) + ".";
  if (declared.tolerance > 0) text += fmt::format(" Declared tolerance: {}.", declared.tolerance);
  if (tally.grid.size == 0 && !tally.repeat.recorded) {
    text +=
        " Most families are degenerate on purpose or a few units in the last place away from it, so the shares say "
        "where an implementation fails, not how often everyday input would meet it.";
  }
  constexpr std::size_t most_named = 6;
  if (tally.undeclared.size() > most_named) {
    text +=
        fmt::format(" {} other operations are not declared by the engine and were not asked.", tally.undeclared.size());
  } else if (!tally.undeclared.empty()) {
    text += fmt::format(" Not declared by the engine, so not asked: {}.", fmt::join(tally.undeclared, ", "));
  }
  if (tally.interrupted) text += " The run was interrupted; this is what had been counted.";
  return text;
}

std::string tile(const std::string& style, std::uint64_t n, const std::string& words) {
  return "<div class=\"tile " + style + "\"><b>" + grouped(n) + "</b><span>" + escaped(words) + "</span></div>";
}

/// Causes add up to the wrong answers; those and the rest to all judged answers.
std::string tiles(const Cell& sum) {
  std::string text = tile("", sum.answered(), "answers judged") + tile("agree", sum.count(Verdict::agree), "right") +
                     tile("", sum.wrong(), "wrong");
  std::size_t count = 3;
  const auto add = [&](const char* style, std::uint64_t n, const char* words) {
    if (n > 0) text += tile(style, n, words), ++count;
  };
  add("rounding", both(sum.cancellation()), "wrong by cancellation");
  add("range", both(sum.out_of_range()), "wrong by over- or underflow");
  add("algorithm", sum.count(Verdict::algorithm), "wrong by algorithm");
  add("invalid", sum.count(Verdict::invalid), "invalid");
  add("inexact", sum.count(Verdict::inexact), "inexact");
  add("convention", sum.count(Verdict::convention), "by another convention");
  add("tolerance", sum.count(Verdict::tolerance), "within the tolerance");
  add("unsupported", sum.count(Verdict::unsupported), "not supported");
  add("", sum.not_asked, "not asked");
  // Equally many in each row, except the last.
  const auto columns = [&](std::size_t most) {
    const std::size_t rows = (count + most - 1) / most;
    return (count + rows - 1) / rows;
  };
  return fmt::format("<div class=\"tiles\" style=\"--columns:{};--fewer:{}\">{}</div>", columns(6), columns(4), text);
}

std::string wrong_in_words(std::uint64_t wrong, std::uint64_t answered) {
  return answered == 0 ? "\u2013" : grouped(wrong) + " <small>" + share(wrong, answered) + "</small>";
}

/// The key by which the page's script (sort.js) sorts a column.
std::string sort_key(double key) { return fmt::format(" data-sort=\"{}\"", key); }

double part_of(std::uint64_t n, std::uint64_t of) {
  return of == 0 ? -1 : static_cast<double>(n) / static_cast<double>(of);
}

std::string operation_row(const Cell& total, const std::string& name, const std::string& deck, const char* style) {
  const std::uint64_t ordinary = total.wrong(Range::ordinary), of_ordinary = total.answered(Range::ordinary);
  return fmt::format(
      "<tr{}>{}{}<td class=\"bar-cell wide\"{}>{}</td><td data-label=\"wrong at ordinary size\"{}>{}</td><td "
      "data-label=\"wrong\"{}>{}</td><td data-label=\"inexact\" class=\"{}\"{}>{}</td></tr>",
      style, name, deck, sort_key(static_cast<double>(total.answered())), verdict_bar(total, false),
      sort_key(part_of(ordinary, of_ordinary)), wrong_in_words(ordinary, of_ordinary),
      sort_key(part_of(total.wrong(), total.answered())), wrong_in_words(total.wrong(), total.answered()),
      total.count(Verdict::inexact) == 0 ? "none" : "", sort_key(static_cast<double>(total.count(Verdict::inexact))),
      grouped(total.count(Verdict::inexact)));
}

/// The position of an operation in the catalogue, which follows the deck.
std::size_t place_in_deck(const Operation* operation) {
  const auto& all = all_operations();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), operation) - all.begin());
}

std::string deck_cell(const Operation* operation) {
  if (operation == nullptr) return "<td class=\"text deck\"></td>";
  const std::string pages = pages_in_words(*operation);
  const bool on_pages = pages.compare(0, 4, "deck") == 0;
  return fmt::format("<td class=\"text deck\" data-label=\"chapter\"{}>{}<small> {}</small></td>",
                     sort_key(static_cast<double>(place_in_deck(operation))), operation->metadata().chapter,
                     on_pages ? "p. " + std::string(operation->metadata().pages) : "no page");
}

std::string operations_table(const Tally& tally, const Cell& sum) {
  std::string text =
      "<div class=\"card scroll\"><table class=\"stack operations sortable\"><thead><tr><th "
      "scope=\"col\">operation, "
      "the worst first</th><th scope=\"col\" class=\"text\">chapter and page of the deck</th><th scope=\"col\" "
      "class=\"text most\">all answers</th><th scope=\"col\" class=\"most\">wrong at ordinary size</th><th "
      "scope=\"col\" class=\"most\">wrong</th><th scope=\"col\" class=\"most\">inexact</th></tr></thead><tbody>";
  for (const OperationTally* operation : worst_first(tally)) {
    const Operation* known = find_operation(operation->operation);
    text += operation_row(operation->total(),
                          fmt::format("<th scope=\"row\" data-sort=\"{0}\"><a href=\"{0}.html\">{1}</a><div "
                                      "class=\"small quiet question\">{2}</div></th>",
                                      escaped(operation->operation), breakable(operation->operation),
                                      escaped(known ? known->metadata().question : "")),
                          deck_cell(known), "");
  }
  return text + operation_row(sum, "<th scope=\"row\">all</th>", "<td></td>", " class=\"total\"") +
         "</tbody></table></div>";
}

/// Chapters with their pages, for reading along with the deck.
std::string in_order_of_deck(const Tally& tally) {
  std::vector<const Operation*> operations;
  for (const OperationTally& counted : tally.operations) {
    if (const Operation* known = find_operation(counted.operation)) operations.push_back(known);
  }
  std::stable_sort(operations.begin(), operations.end(),
                   [](const Operation* a, const Operation* b) { return place_in_deck(a) < place_in_deck(b); });
  std::string text, chapter;
  for (const Operation* operation : operations) {
    if (operation->metadata().chapter != chapter) {
      text += (chapter.empty() ? "<h3>" : "</ul><h3>") + breakable(operation->metadata().chapter) + "</h3><ul>";
      chapter = operation->metadata().chapter;
    }
    text += fmt::format("<li><a href=\"{}.html\">{}</a> <span class=\"quiet\">{}</span></li>", operation->name(),
                        breakable(operation->name()), escaped(pages_in_words(*operation)));
  }
  return text.empty()
             ? ""
             : "<details class=\"card by-deck\"><summary>In the order of the deck, chapter by chapter</summary>" +
                   text + "</ul></details>";
}

/// Shown above the numbers of a run in progress.
std::string going_on(const Tally& tally, const ReportNotes& notes) {
  if (notes.expected == 0) return "";
  return fmt::format(
      "<p class=\"going-on\">The audit goes on: {} of {} operations are counted so far. Reload this page to see "
      "more.</p>",
      tally.operations.size(), notes.expected);
}

/// The terms of the pages that a reader may not know.
std::string glossary(bool recorded) {
  const std::string families =
      recorded ? "."
               : ", and a family named +ulp holds the inputs of the family before it with one coordinate moved by a "
                 "few ulps.";
  return "<p class=\"small quiet\" style=\"margin:14px 0 0\">Deck p. is the page of the lecture deck that an "
         "operation's textbook formula stands on (<em>Collision handling: detection and response</em>, CSE 3541, M. "
         "Boggus); an ulp is one unit in the last place of a number" +
         families + "</p>";
}

std::string legend(Speaker speaker, bool recorded) {
  std::string text = "<div class=\"card\"><dl class=\"legend\">";
  const auto entry = [&](const char* style, const std::string& name, const std::string& words) {
    text +=
        fmt::format("<dt><span class=\"swatch {} hatch\" style=\"background-color:var(--c)\"></span>{}</dt><dd>{}</dd>",
                    style, name, escaped(words));
  };
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    entry(verdict_names[v], verdict_names[v], meaning(verdict, speaker));
    if (verdict != Verdict::rounding) continue;
    entry("rounding", "\u2003cancellation", "of these: digits were lost where nearly equal numbers were subtracted");
    entry("range", "\u2003over- or underflow", "of these: a number on the way left the range of the number type");
  }
  return text + "</dl>" + glossary(recorded) + "</div>";
}

/// Maps with failures, the worst operation first.
std::vector<std::pair<std::string, const FailureMap*>> failing_maps(const Tally& tally, const OperationMaps& maps) {
  std::vector<std::pair<std::string, const FailureMap*>> failing;
  for (const OperationTally* operation : worst_first(tally)) {
    for (const auto& [name, shown] : maps) {
      if (name == operation->operation && !shown.empty() && subject_of(shown).findings() > 0)
        failing.emplace_back(name, &subject_of(shown));
    }
  }
  return failing;
}

/// Empty if nothing fails. If no foreign engine is available when the report is written, the maps are those of the
/// textbook formula.
std::string gallery(const Tally& tally, const OperationMaps& maps) {
  const auto failing = failing_maps(tally, maps);
  if (failing.empty()) return "";
  const bool own = speaker_of(tally.declaration) == Speaker::reference ||
                   std::any_of(maps.begin(), maps.end(), [](const auto& entry) { return entry.second.size() > 2; });
  std::string text =
      std::string("<h2>") + (own ? "Where it goes wrong" : "For comparison: where the textbook formula goes wrong") +
      "</h2><p class=\"quiet\">Every square is one question, at most 128 of the smallest steps away from the one in "
      "the "
      "middle. Strong colours are findings, as below; what is right is pale, and a pattern tells one right answer from "
      "another.</p><div class=\"gallery\">";
  for (const auto& [name, map] : failing) {
    text += fmt::format("<a href=\"{}.html#map\">{}<strong>{}</strong></a>", escaped(name),
                        map_picture(*map, map->subject + ": " + summary_of(Cell::of(map->counts))), breakable(name));
  }
  return text + "</div>";
}

std::string conventions(const Tally& tally) {
  std::string items;
  for (const OperationTally& operation : tally.operations) {
    if (!operation.inconsistent_convention()) continue;
    const Cell total = operation.total();
    items += fmt::format("<li><a href=\"{0}.html\">{0}</a>: as closed sets in {1}, as open sets in {2}</li>",
                         escaped(operation.operation), counted(total.touches_closed, "case"),
                         counted(total.touches_open, "case"));
  }
  if (items.empty()) return "";
  return "<h2>Inconsistent convention</h2><div class=\"card\"><p>Where shapes only touch, these operations answer "
         "now "
         "as closed "
         "sets do, now as open sets do:</p><ul>" +
         items + "</ul></div>";
}

}  // namespace

std::vector<const OperationTally*> worst_first(const Tally& tally) {
  std::vector<std::pair<std::array<double, 3>, const OperationTally*>> sorted;
  for (const OperationTally& operation : tally.operations) {
    const Cell total = operation.total();
    const auto part = [](std::uint64_t n, std::uint64_t of) {
      return of == 0 ? 0 : -static_cast<double>(n) / static_cast<double>(of);
    };
    sorted.push_back({{part(total.wrong(Range::ordinary), total.answered(Range::ordinary)),
                       part(total.wrong(), total.answered()), part(total.findings(), total.answered())},
                      &operation});
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const OperationTally*> operations;
  for (const auto& [key, operation] : sorted) operations.push_back(operation);
  return operations;
}

std::string index_page(const Tally& tally, const OperationMaps& maps, const ReportNotes& notes) {
  const Cell sum = sum_of(tally.operations);
  std::string body = "<header><p class=\"kicker\">" +
                     std::string(tally.repeat.recorded ? "touchstone judge" : "touchstone audit") + "</p><h1>" +
                     escaped(headline(tally, sum)) + "</h1><p class=\"lead\">" + escaped(lead(tally, sum)) +
                     "</p><p class=\"quiet\">" + escaped(conditions(tally, sum)) + "</p>" + going_on(tally, notes) +
                     "</header><main>" + tiles(sum);
  if (!notes.gate.empty()) body += "<h2>Gate</h2><div class=\"card\"><pre>" + escaped(notes.gate) + "</pre></div>";
  if (notes.before != nullptr) body += comparison(*notes.before, tally);
  body += "<h2>By operation</h2>" + operations_table(tally, sum) + in_order_of_deck(tally) + nearness_of_all(tally) +
          gallery(tally, maps);
  body += "<h2>What the verdicts mean</h2>" + legend(speaker_of(tally.declaration), tally.repeat.recorded) +
          conventions(tally);
  return page("touchstone: " + headline(tally, sum), body + "</main>" + page_footer(tally, notes));
}

}  // namespace touchstone::report
