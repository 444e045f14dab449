// SPDX-License-Identifier: Apache-2.0
#include "report/html_parts.h"

#include <fmt/format.h>

#include <numeric>

#include "report/html_map.h"
#include "report/html_style.h"
#include "report/map_script.h"
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

}  // namespace

std::string page(const std::string& title, const std::string& body) {
  const std::string parts =
      std::string(has_space_svg(body) ? space_script : "") + (has_map_section(body) ? map_script : "");
  const std::string script = parts.empty() ? "" : "\n<script>" + parts + "</script>";
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

}  // namespace touchstone::audit
