// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "audit/counting/audit_run.h"
#include "audit/counting/tally_json.h"
#include "catalogue/numbers/ulps.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/figures/svg.h"
#include "report/maps/palette.h"
#include "report/pages/html.h"
#include "report/words/wording.h"

/// The report's pages as text: what a browser needs so that nothing is missing on the screen or on paper.
namespace touchstone::proptests::reports_tests {
namespace {

using Pages = std::map<std::string, std::string>;  ///< by file name

/// The pages of a small audit of the slides, one operation of each kind of figure.
const Pages& report() {
  static const Pages pages = [] {
    AuditOptions options;
    for (const char* name : {"orientation", "segment_segment", "triangulate_polygon", "point_ground_plane"}) {
      options.operations.push_back(find_operation(name));
    }
    options.cases = 300;
    options.seed = 1;
    const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
    Pages written;
    written["index.html"] = index_page(tally, {});
    for (std::size_t i = 0; i < tally.operations.size(); ++i) {
      written[tally.operations[i].operation + ".html"] = operation_page(tally, i, {});
    }
    return written;
  }();
  return pages;
}

/// The start and end tags of a page in order, as in "<a href=...>" and "</a>".
std::vector<std::string> tags_of(const std::string& page) {
  std::vector<std::string> tags;
  for (std::size_t at = 0; (at = page.find('<', at)) != std::string::npos;) {
    const std::size_t end = page.find('>', at);
    REQUIRE(end != std::string::npos);
    tags.push_back(page.substr(at, end + 1 - at));
    at = end + 1;
  }
  return tags;
}

std::string name_of_tag(const std::string& tag) {
  const std::size_t begin = tag[1] == '/' ? 2 : 1;
  return tag.substr(begin, tag.find_first_of(" >/", begin) - begin);
}

std::set<std::string> values_of(const std::string& page, const std::string& attribute) {
  std::set<std::string> values;
  const std::string key = " " + attribute + "=\"";
  for (std::size_t at = 0; (at = page.find(key, at)) != std::string::npos;) {
    at += key.size();
    values.insert(page.substr(at, page.find('"', at) - at));
  }
  return values;
}

/// What stands between the braces of an at-rule of the style sheet.
std::string block_of(const std::string& page, const std::string& rule) {
  const std::size_t at = page.find(rule + "{");
  REQUIRE(at != std::string::npos);
  std::size_t i = at + rule.size();
  int depth = 0;
  do {
    depth += page[i] == '{' ? 1 : page[i] == '}' ? -1 : 0;
    ++i;
  } while (depth > 0 && i < page.size());
  REQUIRE(depth == 0);
  return page.substr(at, i - at);
}

/// Scripts hold "<" that open no tag.
std::string without_scripts(std::string page) {
  const std::string open = "<script>", close = "</script>";
  for (std::size_t from = page.find(open); from != std::string::npos; from = page.find(open, from))
    page.erase(from, page.find(close, from) + close.size() - from);
  return page;
}

}  // namespace

TEST_CASE("reports: every tag is closed, and in order") {
  const std::set<std::string> empty{"!DOCTYPE", "meta", "img", "wbr", "br", "link", "input"};
  for (const auto& [file, page] : report()) {
    std::vector<std::string> open;
    for (const std::string& tag : tags_of(without_scripts(page))) {
      INFO(file << ": " << tag);
      const std::string name = name_of_tag(tag);
      if (empty.count(name) > 0 || tag[tag.size() - 2] == '/') continue;
      if (tag[1] != '/') {
        open.push_back(name);
        continue;
      }
      REQUIRE_FALSE(open.empty());
      REQUIRE(open.back() == name);
      open.pop_back();
    }
    INFO(file);
    REQUIRE(open.empty());
  }
}

TEST_CASE("reports: every link leads to a page of the report, and to a place that it has") {
  for (const auto& [file, page] : report()) {
    for (const std::string& link : values_of(page, "href")) {
      INFO(file << ": " << link);
      const std::size_t hash = link.find('#');
      const std::string to = hash == 0 ? file : link.substr(0, hash);
      REQUIRE(report().count(to) == 1);
      if (hash != std::string::npos) REQUIRE(values_of(report().at(to), "id").count(link.substr(hash + 1)) == 1);
    }
  }
}

TEST_CASE("reports: a page needs nothing from elsewhere") {
  for (const auto& [file, page] : report()) {
    INFO(file);
    CHECK(page.find("<script ") == std::string::npos);  // with nothing but what stands in it
    CHECK(page.find("fetch(") == std::string::npos);
    CHECK(page.find("import(") == std::string::npos);
    CHECK(page.find("<link") == std::string::npos);
    CHECK(page.find("@import") == std::string::npos);
    CHECK(page.find("url(") == std::string::npos);
    for (const std::string& source : values_of(page, "src")) CHECK_THAT(source, StartsWith("data:"));
  }
}

TEST_CASE("reports: on paper the colours are the light ones, and what is folded up is seen") {
  for (const auto& [file, page] : report()) {
    INFO(file);
    const std::string style = page.substr(0, page.find("</style>"));
    const std::string paper = block_of(style, "@media print");
    CHECK(paper.find("details::details-content{content-visibility:visible") != std::string::npos);
    CHECK(paper.find("print-color-adjust:exact") != std::string::npos);  // bars and swatches are backgrounds
    CHECK(paper.find("nav") != std::string::npos);
    CHECK(paper.find("break-inside:avoid") != std::string::npos);
    // Colours of the dark scheme are for screens alone.
    for (std::size_t at = 0; (at = style.find("prefers-color-scheme:dark", at)) != std::string::npos; ++at) {
      const std::string rule = style.substr(style.rfind('@', at), at - style.rfind('@', at));
      CHECK(rule == "@media screen and (");
    }
  }
}

TEST_CASE("reports: a distance beyond what is counted is cut off at one number, and said so") {
  constexpr double most = 0x1p990;
  const mpq_class least(1, mpz_class(mpz_class(1) << 1074));
  CHECK(distance_in_ulps(0x1p-84, mpq_class(0)) == most);  // 2^990 units of 2^-1074, exactly
  CHECK(distance_in_ulps(std::nextafter(0x1p-84, 0), mpq_class(0)) == std::nextafter(most, 0));
  CHECK(distance_in_ulps(std::nextafter(0x1p-84, 1), mpq_class(0)) == most);
  CHECK(distance_in_ulps(1e308, least) == most);
  CHECK(distance_in_ulps(-1e308, least) == most);

  CHECK(ulps_in_words(most) == "more than 1e298 ulps");
  CHECK(ulps_in_words(std::nextafter(most, 0)) == "1.05e+298 ulps");
  CHECK(ulps_in_words(1) == "1 ulp");
  CHECK(ulps_in_words(0.5) == "0.5 ulps");
  CHECK(ulps_in_words(1234567) == "1.23e+06 ulps");
}

TEST_CASE("reports: a number is said to be ulps off, or beside the exact one where that says nothing") {
  const auto judged = [](double ulps, double exact, double answered) {
    Judgement judgement{Verdict::inexact, ulps};
    judgement.number = OffNumber{exact, answered};
    return judgement;
  };
  CHECK(off_in_words(judged(12, 0.3, 0.30000000000000066)) == "12 ulps off");
  CHECK(off_in_words(judged(1e6, 1, 1.0000000002)) == "1e+06 ulps off");
  CHECK(off_in_words(judged(1.1e6, 1, 1.5)) == "expected 1, got 1.5");
  CHECK(off_in_words(judged(3.46e19, 0, -1.92)) == "expected 0, got -1.92");
  CHECK(off_in_words({Verdict::inexact, 12}) == "12 ulps off");
}

TEST_CASE("reports: that a decision is right is said only where something is decided") {
  const auto said = [](const char* operation, const char* question, Verdict verdict) {
    const Operation& asked = *find_operation(operation);
    Finding finding{asked.parse(parse_line(question)), {verdict, 1e20}, nullptr};
    finding.judgement.number = OffNumber{0, -1.92};
    return why(finding, &asked, Speaker::foreign, false);
  };
  const char* const bodies = R"({"bodies":[]})";
  CHECK_THAT(said("momentum", bodies, Verdict::inexact),
             StartsWith("A number is inexact: expected 0, got -1.92. Stated bound: 16 ulps."));
  CHECK_THAT(said("momentum", bodies, Verdict::algorithm),
             StartsWith("A number is wrong: expected 0, got -1.92. Running error analysis"));
  CHECK_THAT(said("point_plane", R"({"plane":{"normal":[0,1,0],"offset":0},"point":[0,0,0]})", Verdict::algorithm),
             StartsWith("The decision is right, but a number is wrong: expected 0, got -1.92. "));
}

TEST_CASE("reports: why rounding is presumed is said of the branch that applies") {
  const Operation& orientation = *find_operation("orientation");
  const auto said = [&](const char* question, bool out_of_range, const Operation* asked) {
    Finding finding{orientation.parse(parse_line(question)), {Verdict::rounding}, nullptr};
    finding.judgement.out_of_range = out_of_range;
    return why(finding, asked, Speaker::foreign, false);
  };
  const char *const right = R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})",
                    *const underflow = R"({"p0":[0,0],"p1":[1e-200,0],"p":[0,1e-200]})";
  CHECK_THAT(said(underflow, true, &orientation), ContainsSubstring("rounds and is wrong on this input too: "));
  CHECK_THAT(said(right, false, &orientation), ContainsSubstring("is right here, but the input is beside a touch"));
  CHECK_THAT(said(right, true, &orientation), ContainsSubstring("is right here, but numbers leave the range"));
  CHECK_THAT(said(right, false, nullptr), ContainsSubstring("too, or the input is beside a touch"));
}

TEST_CASE("reports: the worst distance is the same number in every shard and every file") {
  Cell near, far;
  near.worst_ulps = 3;
  far.worst_ulps = distance_in_ulps(1e308, mpq_class(0));
  near.merge(far);
  CHECK(near.worst_ulps == 0x1p990);
  Tally tally;
  near.outcomes[{Verdict::agree, "value", "value"}].cases = {1, 0};
  tally.operations.push_back({"line_point_at", {{"grid", near}}});
  const Tally again = read_tally(tally_json(tally));
  CHECK(again.operations.at(0).families.at(0).second.worst_ulps == 0x1p990);
}

TEST_CASE("reports: a failure map names the two numbers that it moves") {
  for (const Operation* operation : all_operations()) {
    if (operation->map_centre().numbers.empty()) continue;
    const MapGrid grid = map_grid(*operation);
    INFO(operation->name() << ": " << grid.fields.first << ", " << grid.fields.second);
    REQUIRE(grid.fields.first != grid.fields.second);
    for (const auto& [field, column, row] : {std::tuple(grid.fields.first, 200, MapGrid::side / 2 - 1),
                                             std::tuple(grid.fields.second, MapGrid::side / 2, 7)}) {
      // "a.b[0][1]" as the pointer /a/b/0/1
      std::string pointer = "/";
      for (const char c : field) pointer += c == '.' || c == '[' ? "/" : c == ']' ? "" : std::string(1, c);
      const Json::json_pointer place(pointer);
      Json centre = operation->print(grid.centre), moved = operation->print(grid.at(column, row));
      REQUIRE(centre.contains(place));
      REQUIRE(centre[place] != moved[place]);
      moved[place] = centre[place];
      REQUIRE(moved == centre);
    }
  }
}

TEST_CASE("reports: a map of answers of which many are right speaks of no ulps") {
  const auto maps = failure_maps(*find_operation("triangulate_polygon"), 2);
  REQUIRE(maps[0].counts[static_cast<std::size_t>(Verdict::rounding)] > 0);
  for (const FailureMap& map : maps) {
    for (const MapClass& entry : map.classes) {
      CHECK(entry.said.empty());
      if (entry.verdict == Verdict::rounding) CHECK(entry.look(Scheme::light).ground == colour_of(Verdict::rounding));
    }
  }
  const auto measured = failure_maps(*find_operation("line_point_at"), 2);
  CHECK(measured[1].classes.at(0).said == "correctly rounded");
}

TEST_CASE("reports: a point a hair beside an edge of a polygon is seen in a second frame") {
  Drawing drawing;
  drawing.figures.push_back({Figure::Kind::polygon, "polygon", {0, 0, 4, 0, 4, 4, 0, 4}});
  drawing.figures.push_back({Figure::Kind::point, "point", {1, 1}});
  CHECK(drawing_svg(drawing, "apart").find("gap") == std::string::npos);
  drawing.figures[1].numbers = {1, 0};
  CHECK(drawing_svg(drawing, "on").find("gap") == std::string::npos);
  drawing.figures[1].numbers = {1, 0x1p-30};
  CHECK(drawing_svg(drawing, "beside").find("around point, ") != std::string::npos);
  drawing.figures.pop_back();
  // A spike that nearly reaches the opposite edge.
  drawing.figures[0].numbers = {0, 0, 4, 0, 4, 4, 2, 0x1p-30, 0, 4};
  CHECK(drawing_svg(drawing, "spike").find("around polygon, ") != std::string::npos);
}

TEST_CASE("reports: long exact numbers are abbreviated, roots too, and other long words are not") {
  const std::string one = "1" + std::string(60, '0') + "1/1" + std::string(61, '0');
  const auto said = [](const std::string& text) { return readable(Json{{"distance", text}}, 48, 6)["distance"]; };
  CHECK(said(one) == "about 1");
  CHECK(said(one + "*sqrt(2)") == "about 1.41421");
  CHECK(said("3/2*sqrt(2)") == "3/2*sqrt(2)");
  const std::string word = "sqrt(" + std::string(60, 'x') + ")";
  CHECK(said(word) == word);
}

}  // namespace touchstone::proptests::reports_tests
