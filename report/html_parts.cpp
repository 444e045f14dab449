// SPDX-License-Identifier: Apache-2.0
#include "report/html_parts.h"

#include <fmt/format.h>

#include <numeric>

#include "catalogue/codec/json.h"
#include "catalogue/judge/ulps.h"
#include "report/html_style.h"
#include "report/palette.h"
#include "report/space_script.h"
#include "report/space_svg.h"

namespace touchstone::audit {
namespace {

std::string bar_of(const std::array<std::uint64_t, verdict_count>& counts, bool thin) {
  const std::uint64_t whole = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  if (whole == 0) return "";
  std::string parts, spoken;
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const std::uint64_t n = counts[v];
    if (n == 0) continue;
    const std::string text = std::string(verdict_names[v]) + " " + grouped(n) + " (" + share(n, whole) + ")";
    parts += fmt::format("<i class=\"{} hatch\" style=\"width:{:.3f}%\" title=\"{}\"></i>", verdict_names[v],
                         100.0 * static_cast<double>(n) / static_cast<double>(whole), text);
    spoken += (spoken.empty() ? "" : ", ") + text;
  }
  return fmt::format("<div class=\"bar{}\" role=\"img\" aria-label=\"{}\">{}</div>", thin ? " thin" : "", spoken,
                     parts);
}

std::string said_in_words(const MapClass& entry, bool words_only) {
  if (entry.said.empty()) return entry.verdict == Verdict::agree ? "correct" : name_of(entry.verdict);
  if (!words_only)
    return entry.verdict == Verdict::agree ? entry.said : std::string(name_of(entry.verdict)) + ": " + entry.said;
  if (entry.verdict == Verdict::agree) return "correct: " + entry.said;
  if (entry.verdict == Verdict::inexact) return "inexact: " + entry.said + ", a number too far off";
  return std::string(name_of(entry.verdict)) + ": says " + entry.said;
}

std::string axis_in_words(const MapGrid& grid, std::size_t number, const std::string& field, double step) {
  return escaped(
      fmt::format("{} = {} + k \u00b7 {}", field, decimal(grid.centre.numbers[number]), about(exact_value(step))));
}

}  // namespace

std::string page(const std::string& title, const std::string& body) {
  const std::string script =
      has_space_svg(body) ? std::string("\n<script>") + space_script + "</script>" : std::string();
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + page_style() + "</style>\n</head>\n<body>\n" + body + script +
         "\n</body>\n</html>\n";
}

std::string code(const std::string& text) {
  // A line may break after a comma or a colon: JSON on one line has no spaces.
  std::string breakable;
  for (const char c : escaped(text)) (breakable += c) += c == ',' || c == ':' ? "<wbr>" : "";
  return "<code>" + breakable + "</code>";
}

std::string badge(Verdict verdict, Speaker speaker) {
  return fmt::format("<span class=\"badge {0}\" title=\"{1}\">{0}</span>", name_of(verdict),
                     escaped(meaning(verdict, speaker)));
}

std::string swatch(const std::string& colour) { return "<span class=\"swatch\" style=\"--c:" + colour + "\"></span>"; }

std::string verdict_bar(const Cell& cell, bool thin) { return bar_of(cell.counts(), thin); }

std::string cause_bar(const Cell& cell) {
  auto counts = cell.counts();
  for (std::size_t v = 0; v < verdict_count; ++v) counts[v] = is_finding(static_cast<Verdict>(v)) ? counts[v] : 0;
  return bar_of(counts, true);
}

std::string verdict_columns() {
  std::string text = "<th scope=\"col\">cases</th>";
  for (const char* name : verdict_names) text += std::string("<th scope=\"col\">") + name + "</th>";
  return text;
}

std::string verdict_numbers(const Cell& cell) {
  std::string text = "<td>" + grouped(cell.cases()) + "</td>";
  const auto counts = cell.counts();
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const bool found = is_finding(static_cast<Verdict>(v));
    text += counts[v] == 0 ? "<td class=\"none\">0</td>"
                           : fmt::format("<td{}>{}</td>", found ? " class=\"found\"" : "", grouped(counts[v]));
  }
  return text;
}

std::string map_section(const Operation& operation, bool binary32, const std::vector<FailureMap>& maps) {
  const MapGrid grid = map_grid(operation, binary32);
  std::string text = "<div class=\"maps\">";
  for (const FailureMap& map : maps) {
    const std::string summary = summary_of(Cell::of(map.counts));
    text += fmt::format("<div><h4>{0}</h4><img alt=\"{0}: {1}\" width=\"{2}\" height=\"{2}\" src=\"{3}\"><ul>",
                        escaped(map.subject), escaped(summary), 2 * MapGrid::side, data_uri(png(map.image)));
    for (const MapClass& entry : map.classes) {
      const bool words_only = entry.said.find(" ") == std::string::npos;
      text += fmt::format("<li><span>{}{}</span><b>{}</b></li>", swatch(hex_of(entry.colour)),
                          escaped(said_in_words(entry, words_only)), grouped(entry.count));
    }
    if (map.refused > 0)
      text +=
          fmt::format("<li><span>{}outside the contract</span><b>{}</b></li>", swatch("#ffffff"), grouped(map.refused));
    text += "</ul></div>";
  }
  text += fmt::format(
      "</div><p class=\"small quiet\" style=\"margin-top:14px\">Each pixel is one question. To the right {}, upwards "
      "{}, "
      "k = \u2212128 \u2026 127: the smallest steps that the number format allows at this size. The other numbers "
      "stay as in {}.</p>",
      axis_in_words(grid, grid.axes.first, grid.fields.first, grid.step.first),
      axis_in_words(grid, grid.axes.second, grid.fields.second, grid.step.second),
      code(one_line(operation.print(grid.centre))));
  return text;
}

}  // namespace touchstone::audit
