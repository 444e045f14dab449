// SPDX-License-Identifier: Apache-2.0
#include "report/maps/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/parts/html_style.h"

/// Colours by the formulas of WCAG 2.1 (relative luminance, contrast ratio) and CIE 1976 (L*a*b*).
namespace touchstone::proptests::palette_tests {
namespace {

using Linear = std::array<double, 3>;

Linear linear(const Colour& colour) {
  const auto one = [](std::uint8_t c) {
    const double share = c / 255.0;
    return share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return {one(colour.red), one(colour.green), one(colour.blue)};
}

double luminance(const Colour& colour) {
  const Linear c = linear(colour);
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

double contrast(const Colour& a, const Colour& b) {
  const double l = luminance(a), m = luminance(b);
  return (std::max(l, m) + 0.05) / (std::min(l, m) + 0.05);
}

/// CIE76.
double difference(const Colour& a, const Colour& b) {
  const auto lab = [](const Colour& colour) {
    const Linear c = linear(colour);
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.95047),
                 y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]),
                 z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.08883);
    return Linear{116 * y - 16, 500 * (x - y), 200 * (y - z)};
  };
  const Linear p = lab(a), q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Colour parsed(const std::string& hex) {
  const std::string six = hex.size() == 4 ? std::string{hex[1], hex[1], hex[2], hex[2], hex[3], hex[3]} : hex.substr(1);
  const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(std::stoi(six.substr(i, 2), nullptr, 16)); };
  return {at(0), at(2), at(4)};
}

/// The variables of a scheme of the style sheet, dark ones over light ones.
std::map<std::string, Colour> variables(Scheme scheme) {
  const std::string& style = page_style();
  std::map<std::string, Colour> found;
  const auto read = [&](std::size_t begin) {
    const std::size_t end = style.find('}', begin);
    for (std::size_t at = begin; (at = style.find("--", at)) < end;) {
      const std::size_t colon = style.find(':', at), stop = style.find_first_of(";}", colon);
      found[style.substr(at + 2, colon - at - 2)] = parsed(style.substr(colon + 1, stop - colon - 1));
      at = stop;
    }
  };
  read(style.find(":root{"));
  if (scheme == Scheme::dark) read(style.find("prefers-color-scheme:dark"));
  return found;
}

constexpr Verdict findings[] = {Verdict::rounding, Verdict::algorithm, Verdict::inexact, Verdict::invalid};

}  // namespace

TEST_CASE("palette: the formula of contrast gives WCAG's own examples") {
  CHECK(contrast({0, 0, 0}, {255, 255, 255}) == Approx(21));
  CHECK(contrast({0x77, 0x77, 0x77}, {255, 255, 255}) == Approx(4.48).margin(0.005));
}

TEST_CASE("palette: every text has a contrast of 4.5 to 1 on everything that it stands on, light and dark") {
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    const auto colours = variables(scheme);
    for (const char* text : {"ink", "quiet", "link", "q0", "q1", "q2", "q3", "truth", "said"}) {
      for (const char* ground : {"paper", "ground", "code"}) {
        INFO(text << " on " << ground << ", scheme " << static_cast<int>(scheme));
        CHECK(contrast(colours.at(text), colours.at(ground)) >= 4.5);
      }
    }
  }
  // What is fainter than that is for lines alone: no text has such a colour.
  const std::string& style = page_style();
  for (const std::string& faint : {std::string("var(--faint"), std::string("var(--line"), std::string("var(--c)")}) {
    for (std::size_t at = 0; (at = style.find("color:" + faint, at)) != std::string::npos; ++at) {
      INFO(style.substr(at - 20, 60));
      CHECK(style[at - 1] == '-');  // background-color, border-color
    }
  }
}

TEST_CASE("palette: a finding stands out from every right answer, a right one from none") {
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    const Colour right = colour_of(Verdict::agree, scheme);
    for (const Verdict verdict : findings) {
      for (std::size_t place = 0; place < 6; ++place) {
        for (const bool rare : {false, true}) {
          INFO(name_of(verdict) << ", answer " << place << ", scheme " << static_cast<int>(scheme));
          const Look look = look_of(verdict, {place, rare}, scheme);
          CHECK(contrast(look.ground, right) >= 3);
          CHECK(contrast(look.mark, right) >= 3);
        }
      }
    }
    for (std::size_t level = 0; level < distance_levels; ++level) {
      const Colour lost = look_of_distance(level, Verdict::inexact, scheme).ground;
      CHECK(contrast(lost, right) >= 3);
      // A scale: each step stands out more than the one before.
      if (level > 0)
        CHECK(contrast(lost, right) >
              1.1 * contrast(look_of_distance(level - 1, Verdict::inexact, scheme).ground, right));
      const Look wrong = look_of_distance(level, Verdict::algorithm, scheme);
      CHECK(wrong.ground == lost);
      CHECK(wrong.mark == colour_of(Verdict::algorithm, scheme));
    }
    for (std::size_t place = 0; place < 6; ++place) {
      const Look look = look_of(Verdict::agree, {place, false}, scheme);
      CHECK(look.ground == right);
      CHECK(contrast(look.mark, right) < 3);
    }
  }
}

TEST_CASE("palette: any two verdicts are told apart by eye") {
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    std::vector<Colour> colours{range_colour(scheme)};
    for (std::size_t v = 0; v < verdict_count; ++v) colours.push_back(colour_of(static_cast<Verdict>(v), scheme));
    for (std::size_t i = 0; i < colours.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        INFO(hex_of(colours[i]) << " and " << hex_of(colours[k]));
        CHECK(difference(colours[i], colours[k]) >= 13);
      }
    }
    for (const Verdict a : findings) {
      for (const Verdict b : findings) {
        if (a != b) CHECK(difference(colour_of(a, scheme), colour_of(b, scheme)) >= 40);
      }
    }
  }
}

TEST_CASE("palette: the second right answer is a hatch on the ground of the first, a rare one is a line") {
  const Look first = look_of(Verdict::agree, {0, false}, Scheme::light),
             second = look_of(Verdict::agree, {1, false}, Scheme::light),
             line = look_of(Verdict::agree, {0, true}, Scheme::light);
  CHECK(first.pattern == Look::Pattern::plain);
  CHECK(second.pattern == Look::Pattern::hatch);
  CHECK(second.ground == first.ground);
  std::size_t marked = 0;
  for (std::size_t i = 0; i < 36; ++i) marked += second.marked(i % 6, i / 6) ? 1 : 0;
  CHECK(marked == 12);  // two of six
  CHECK(line.pattern == Look::Pattern::plain);
  CHECK(contrast(line.ground, first.ground) >= 2);
}

}  // namespace touchstone::proptests::palette_tests
