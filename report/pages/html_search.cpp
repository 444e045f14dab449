// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "audit/counting/audit_run.h"
#include "geometry/invalid_input.h"
#include "report/figures/space_model.h"
#include "report/figures/svg.h"
#include "report/parts/html_parts.h"

namespace touchstone::report {
namespace {

constexpr const char* body_label = "body[";
constexpr std::size_t fewest_bodies = 5, most_bodies = 16;

/// A figure of either dimension, as far as it matters here.
struct Drawn {
  std::string label;
  bool answer, node;
};

std::vector<Drawn> drawn_of(const Drawing& drawing) {
  std::vector<Drawn> all;
  for (const Figure& figure : drawing.figures) all.push_back({figure.label, figure.answer, figure.node.has_value()});
  if (!all.empty()) return all;
  for (const SpaceFigure& figure : drawing.space) all.push_back({figure.label, figure.answer, figure.node.has_value()});
  return all;
}

bool is_body(const Drawn& figure) { return figure.label.rfind(body_label, 0) == 0; }

/// The label of the query, which is drawn before all bodies.
std::string query_of(const std::vector<Drawn>& all) {
  const auto query = std::find_if(all.begin(), all.end(), [](const Drawn& f) { return !f.label.empty(); });
  return query == all.end() || is_body(*query) ? "" : query->label;
}

std::string key(const char* strokes, const std::string& words) {
  return fmt::format(
      "<span class=\"key\"><svg class=\"fig space\" width=\"26\" height=\"12\" aria-hidden=\"true\">{}</svg>{}"
      "</span> ",
      strokes, escaped(words));
}

std::string legend(const std::vector<Drawn>& all) {
  const auto any = [&all](const auto& holds) { return std::any_of(all.begin(), all.end(), holds); };
  const std::string query = query_of(all);
  std::string text;
  if (!query.empty()) text += key("<path class=\"q0 stroke\" stroke-width=\"3\" d=\"M1 6h24\"/>", query);
  if (any(is_body)) text += key("<path class=\"q1 stroke\" stroke-width=\"2\" d=\"M1 6h24\"/>", "a body");
  if (any([](const Drawn& f) { return f.answer; }))
    text += key("<path class=\"truth stroke\" stroke-width=\"3\" d=\"M1 6h24\"/>", "which it meets, by the truth");
  if (any([](const Drawn& f) { return f.node; })) {
    text += key("<path class=\"node stroke\" d=\"M1 1.5h24v9h-24z\"/>", "a part of the structure, thinner the deeper");
    text +=
        key("<path class=\"node face\" d=\"M1 1.5h24v9h-24z\"/>"
            "<path class=\"node stroke\" d=\"M1 1.5h24v9h-24z\"/>",
            "entered by the search");
  }
  return text;
}

/// A score for a picture: its bodies, if there are neither too few nor too many to distinguish, and the ones met.
std::size_t detail_of(const std::vector<Drawn>& all) {
  const auto bodies = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), is_body));
  const auto met =
      static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Drawn& f) { return f.answer; }));
  if (bodies < fewest_bodies || bodies > most_bodies || met == 0 || 2 * met > bodies) return 0;
  return bodies;
}

}  // namespace

std::string search_caption(const Drawing& drawing) {
  if (drawing.search.empty()) return "";
  const std::string keys = legend(drawn_of(drawing));
  return "<br><span class=\"search\">" + escaped(drawing.search) + "</span>" +
         (keys.empty() ? "" : "<br><span class=\"small quiet\">" + keys + "</span>");
}

std::string search_section(const Operation& operation) {
  constexpr std::uint64_t asked = 16;  // per family; families that are moved by an ulp look the same
  struct Best {
    std::size_t detail = 0;
    Drawing drawing;
    std::string input;
  };
  std::map<std::string, Best> best;  // by the kind of query: the first word of its label
  const std::vector<std::string>& families = operation.families();
  for (std::uint64_t i = 0; i < asked * families.size(); ++i) {
    const std::size_t family = i % families.size();
    if (families[family].find('+') != std::string::npos) continue;
    DrawStream draws = case_draws(operation, family, 1, i / families.size());
    const Question question = operation.draw(draws, family);
    if (range_of(question) != Range::ordinary) continue;
    try {
      const Examination examination(operation, question);
      const Drawing& drawing = examination.drawing();
      if (drawing.search.empty()) return "";
      const std::vector<Drawn> all = drawn_of(drawing);
      const std::string query = query_of(all);
      Best& of_sort = best[query.substr(0, query.find(' '))];
      const std::size_t detail = detail_of(all);
      if (detail > of_sort.detail) of_sort = {detail, drawing, one_line(operation.print(question))};
    } catch (const InvalidInput&) {
    }
  }
  std::string text;
  for (const auto& [sort, of_sort] : best) {
    if (of_sort.detail == 0) continue;
    const std::string title = operation.name() + ": the input " + of_sort.input;
    const Drawing& drawing = of_sort.drawing;
    text += "<figure>" +
            (drawing.figures.empty() ? space_figure(drawing, title) : drawing_svg(drawing, title, std::nullopt)) +
            "<figcaption>" + search_caption(drawing).substr(std::string("<br>").size()) +
            "<details><summary>Its input</summary>" + code(of_sort.input) + "</details></figcaption></figure>";
  }
  if (text.empty()) return "";
  return "<h2>What a search looks at</h2><section class=\"card\"><div class=\"searches\">" + text + "</div></section>";
}

}  // namespace touchstone::report
