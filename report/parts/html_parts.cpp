// SPDX-License-Identifier: Apache-2.0
#include "report/parts/html_parts.h"

#include <embedded.h>  // made by the build
#include <fmt/format.h>

#include "report/figures/space_model.h"
#include "report/figures/svg.h"
#include "report/parts/html_style.h"

namespace touchstone::report {
namespace {

struct CountedPart {
  const char *style, *name;
  std::uint64_t n;
};

/// The counts, with rounding in its two kinds.
std::vector<CountedPart> parts_of(const Cell& cell) {
  std::vector<CountedPart> parts;
  const auto counts = cell.counts();
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    if (verdict == Verdict::rounding) {
      parts.push_back({"rounding", "rounding by cancellation", both(cell.cancellation())});
      parts.push_back({"range", "over- or underflow", both(cell.out_of_range())});
    } else {
      parts.push_back({verdict_names[v], verdict_names[v], counts[v]});
    }
  }
  return parts;
}

std::string bar_of(const std::vector<CountedPart>& parts, bool thin) {
  std::uint64_t whole = 0;
  for (const CountedPart& part : parts) whole += part.n;
  if (whole == 0) return "";
  std::string bars, spoken;
  for (const CountedPart& part : parts) {
    if (part.n == 0) continue;
    const std::string text = std::string(part.name) + " " + grouped(part.n) + " (" + share(part.n, whole) + ")";
    bars += fmt::format("<i class=\"{} hatch\" style=\"width:{:.3f}%\" title=\"{}\"></i>", part.style,
                        100.0 * static_cast<double>(part.n) / static_cast<double>(whole), text);
    spoken += (spoken.empty() ? "" : ", ") + text;
  }
  return fmt::format("<div class=\"bar{}\" role=\"img\" aria-label=\"{}\">{}</div>", thin ? " thin" : "", spoken, bars);
}

/// Text with line-break opportunities after each of these characters.
std::string with_breaks(const std::string& text, const std::string& after) {
  std::string broken;
  for (const char c : escaped(text)) (broken += c) += after.find(c) != std::string::npos ? "<wbr>" : "";
  return broken;
}

}  // namespace

std::string page(const std::string& title, const std::string& body) {
  const bool played = body.find(player_opening) != std::string::npos;
  const bool mapped = body.find(map_opening) != std::string::npos, viewed = played || has_space_figure(body);
  const bool drawn = has_space_figure(body) || body.find(view_opening) != std::string::npos;
  const bool dragged = body.find(" data-drag=\"") != std::string::npos;
  const std::string parts = std::string(viewed || mapped || dragged ? drawn_alone_script : "") +
                            (viewed ? viewer_script : "") + (played ? player_script : "") + (mapped ? map_script : "") +
                            (dragged ? std::string(drag_script) + drag_trees_script + drag_figures_script : "") +
                            (drawn || dragged ? save_figure_script : "") +
                            (body.find(" sortable\"") != std::string::npos ? sort_script : "");
  const std::string script = parts.empty() ? "" : "\n<script>" + parts + "</script>";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + page_style() + "</style>\n</head>\n<body>\n" + body + script +
         "\n</body>\n</html>\n";
}

std::string code(const std::string& text) {
  return "<code>" + with_breaks(text, ",:") + "</code>";  // JSON on one line has no spaces
}

std::string breakable(const std::string& name) { return with_breaks(name, "_"); }

std::string shell_line(const std::string& line) {
  return "<pre class=\"repeat\">" + with_breaks(line, ",:") + "</pre>";
}

std::string words_in_html(const std::string& text) {
  std::string html;
  bool in_code = false;
  for (const char c : escaped(text)) {
    if (c == '`') html += (in_code = !in_code) ? "<code>" : "</code>";
    else html += c;
  }
  return html + (in_code ? "</code>" : "");
}

std::string badge(Verdict verdict, Speaker speaker) {
  return fmt::format("<span class=\"badge {0}\" title=\"{1}\">{0}</span>", name_of(verdict),
                     escaped(meaning(verdict, speaker)));
}

std::string swatch(const std::string& colour) { return "<span class=\"swatch\" style=\"--c:" + colour + "\"></span>"; }

std::string verdict_bar(const Cell& cell, bool thin) { return bar_of(parts_of(cell), thin); }

std::vector<Column> columns_of(const Cell& total) {
  static const Column all[] = {
      {"cases", false, [](const Cell& c) { return c.cases(); }},
      {"wrong", true, [](const Cell& c) { return c.wrong(); }},
      {"of ordinary size", true, [](const Cell& c) { return c.wrong(Range::ordinary); }},
      {"by cancellation", true, [](const Cell& c) { return both(c.cancellation()); }},
      {"by over- or underflow", true, [](const Cell& c) { return both(c.out_of_range()); }},
      {"by algorithm", true, [](const Cell& c) { return c.count(Verdict::algorithm); }},
      {"invalid", true, [](const Cell& c) { return c.count(Verdict::invalid); }},
      {"inexact", true, [](const Cell& c) { return c.count(Verdict::inexact); }},
      {"convention", false, [](const Cell& c) { return c.count(Verdict::convention); }},
      {"tolerance", false, [](const Cell& c) { return c.count(Verdict::tolerance); }},
      {"unsupported", false, [](const Cell& c) { return c.count(Verdict::unsupported); }},
      {"agree", false, [](const Cell& c) { return c.count(Verdict::agree); }},
  };
  std::vector<Column> columns;
  for (const Column& column : all) {
    if (columns.size() < 2 || column.count(total) > 0) columns.push_back(column);
  }
  return columns;
}

std::string headings(const std::vector<Column>& columns) {
  std::string text;
  for (const Column& column : columns) text += std::string("<th scope=\"col\">") + column.name + "</th>";
  return text;
}

std::string numbers(const std::vector<Column>& columns, const Cell& cell) {
  std::string text;
  for (const Column& column : columns) {
    const std::uint64_t n = column.count(cell);
    text += fmt::format("<td data-label=\"{}\" class=\"{}\">{}</td>", column.name,
                        n == 0         ? "none"
                        : column.found ? "found"
                                       : "",
                        grouped(n));
  }
  return text;
}

}  // namespace touchstone::report
